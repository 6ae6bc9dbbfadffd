#include "engine/surface/bleed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace spineloft::surface {
namespace {

/// Distances in thirds of a pixel (the 3-4 chamfer: straight steps 3, slanted ones 4).
constexpr int kUnit = 3, kSlanted = 4;
constexpr int kFarthest = 64 * 2 * kUnit + kSlanted;
using Distances = std::vector<std::uint16_t>;

std::size_t countOf(int width, int height) {
  return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
}

/// To the nearest pixel outside, at most kFarthest.
Distances inwardDistances(const image::Mask& mask) {
  const int width = mask.width, height = mask.height;
  Distances d(mask.pixels.size());
  std::ranges::transform(mask.pixels, d.begin(), [](std::uint8_t inside) {
    return static_cast<std::uint16_t>(inside != 0 ? kFarthest : 0);
  });
  const auto at = [&](int x, int y) -> std::uint16_t& {
    return d[countOf(width, y) + static_cast<std::size_t>(x)];
  };
  const auto relax = [&](int x, int y, int fromX, int fromY, int step) {
    if (fromX < 0 || fromY < 0 || fromX >= width || fromY >= height) return;
    std::uint16_t& here = at(x, y);
    here = static_cast<std::uint16_t>(std::min<int>(here, at(fromX, fromY) + step));
  };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      relax(x, y, x - 1, y, kUnit);
      relax(x, y, x, y - 1, kUnit);
      relax(x, y, x - 1, y - 1, kSlanted);
      relax(x, y, x + 1, y - 1, kSlanted);
    }
  }
  for (int y = height - 1; y >= 0; --y) {
    for (int x = width - 1; x >= 0; --x) {
      relax(x, y, x + 1, y, kUnit);
      relax(x, y, x, y + 1, kUnit);
      relax(x, y, x + 1, y + 1, kSlanted);
      relax(x, y, x - 1, y + 1, kSlanted);
    }
  }
  return d;
}

int unitsOf(double margin) { return static_cast<int>(std::lround(std::clamp(margin, 0.0, 64.0) * kUnit)); }

/// Largest value within `radius` of each entry of a row or column of `count` entries, `step` apart.
void widen(std::uint16_t* first, int count, std::size_t step, int radius,
           std::vector<std::uint16_t>& line) {
  line.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) line[static_cast<std::size_t>(i)] = first[static_cast<std::size_t>(i) * step];
  for (int i = 0; i < count; ++i) {
    const auto from = line.begin() + std::max(0, i - radius);
    const auto to = line.begin() + std::min(count, i + radius + 1);
    first[static_cast<std::size_t>(i) * step] = *std::max_element(from, to);
  }
}

/// Colour and how much of it is known, in eighths of a level so that averages of averages stay true.
struct Sample {
  std::array<std::uint16_t, 3> colour{};
  std::uint16_t weight = 0;  ///< 0…kWhole
};
constexpr int kFine = 8, kWhole = 4096;

struct Level {
  int width = 0, height = 0;
  std::vector<Sample> samples;
  const Sample& at(int x, int y) const {
    return samples[countOf(width, std::clamp(y, 0, height - 1)) +
                   static_cast<std::size_t>(std::clamp(x, 0, width - 1))];
  }
};

/// Half the size: what is known of each four, and four times as sure of it.
Level pull(const Level& fine) {
  Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
  coarse.samples.resize(countOf(coarse.width, coarse.height));
  auto out = coarse.samples.begin();
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x, ++out) {
      std::uint32_t weight = 0;
      std::array<std::uint32_t, 3> sum{};
      for (int k = 0; k < 4; ++k) {
        const int fx = 2 * x + k % 2, fy = 2 * y + k / 2;
        if (fx >= fine.width || fy >= fine.height) continue;
        const Sample& s = fine.at(fx, fy);
        weight += s.weight;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += std::uint32_t{s.colour[c]} * s.weight;
      }
      if (weight == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        out->colour[c] = static_cast<std::uint16_t>((sum[c] + weight / 2) / weight);
      }
      out->weight = static_cast<std::uint16_t>(std::min<std::uint32_t>(weight, kWhole));
    }
  }
  return coarse;
}

/// What a level does not know it takes from the next coarser one, between whose samples it lies.
void push(const Level& coarse, Level& fine) {
  auto out = fine.samples.begin();
  for (int y = 0; y < fine.height; ++y) {
    for (int x = 0; x < fine.width; ++x, ++out) {
      if (out->weight >= kWhole) continue;
      const int cx = x / 2, cy = y / 2, dx = x % 2 == 0 ? -1 : 1, dy = y % 2 == 0 ? -1 : 1;
      const Sample &a = coarse.at(cx, cy), &b = coarse.at(cx + dx, cy), &c = coarse.at(cx, cy + dy),
                   &d = coarse.at(cx + dx, cy + dy);
      const std::uint32_t known = out->weight, rest = kWhole - known;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t mixed =
            (9u * a.colour[i] + 3u * b.colour[i] + 3u * c.colour[i] + d.colour[i] + 8) / 16;
        out->colour[i] =
            static_cast<std::uint16_t>((out->colour[i] * known + mixed * rest + kWhole / 2) / kWhole);
      }
      out->weight = kWhole;
    }
  }
}

Level firstLevel(const image::Image& image, const image::Mask& known) {
  Level level{image.width, image.height, {}};
  level.samples.resize(known.pixels.size());
  for (std::size_t i = 0; i < level.samples.size(); ++i) {
    const std::uint8_t* p = image.pixels.data() + 4 * i;
    if (known.pixels[i] == 0 || p[3] < 128) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      level.samples[i].colour[c] = static_cast<std::uint16_t>(p[c] * kFine);
    }
    level.samples[i].weight = kWhole;
  }
  return level;
}

}  // namespace

double rimMargin(int longSide) { return std::clamp(longSide / 600.0, 2.0, 6.0); }

image::Mask inset(const image::Mask& mask, double margin) {
  image::Mask out = mask;
  const int wanted = unitsOf(margin);
  if (mask.width <= 0 || mask.height <= 0 || wanted == 0) return out;
  const Distances inward = inwardDistances(mask);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    if (inward[i] < wanted + kUnit / 2) out.pixels[i] = 0;
  }
  return out;
}

image::Mask trusted(const image::Mask& covered, double margin) {
  image::Mask out = covered;
  const int wanted = unitsOf(margin);
  if (covered.width <= 0 || covered.height <= 0 || wanted == 0) return out;
  const Distances inward = inwardDistances(covered);
  // How deep it gets near by, which is half its width there.
  Distances deepest = inward;
  std::vector<std::uint16_t> line;
  const int radius = (2 * wanted + kUnit - 1) / kUnit;
  const auto width = static_cast<std::size_t>(covered.width);
  for (int y = 0; y < covered.height; ++y) {
    widen(deepest.data() + countOf(covered.width, y), covered.width, 1, radius, line);
  }
  for (int x = 0; x < covered.width; ++x) {
    widen(deepest.data() + x, covered.height, width, radius, line);
  }
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    // An inner pixel next to an outer one is one pixel from it, but its outer side touches it.
    const int needed = std::min(wanted + kUnit / 2, deepest[i] / 2 + kUnit / 2);
    if (inward[i] < needed) out.pixels[i] = 0;
  }
  return out;
}

image::Image bleed(const image::Image& image, const image::Mask& known) {
  if (image.empty() || known.width != image.width || known.height != image.height) return {};
  std::vector<Level> levels;
  levels.push_back(firstLevel(image, known));
  while (levels.back().width > 1 || levels.back().height > 1) levels.push_back(pull(levels.back()));
  if (levels.back().samples.front().weight == 0) return {};
  levels.back().samples.front().weight = kWhole;
  for (std::size_t i = levels.size() - 1; i-- > 0;) push(levels[i + 1], levels[i]);
  image::Image out{image.width, image.height, {}};
  out.pixels.reserve(4 * known.pixels.size());
  for (const Sample& s : levels.front().samples) {
    for (const std::uint16_t c : s.colour) {
      out.pixels.push_back(static_cast<std::uint8_t>((c + kFine / 2) / kFine));
    }
    out.pixels.push_back(255);
  }
  return out;
}

}  // namespace spineloft::surface
