#include "engine/surface/edge_padding.h"

#include <algorithm>
#include <array>
#include <bit>
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

/// Distances from one row to the next in sweeping order: `near` is done, `here` not yet.
void relaxFrom(const std::uint16_t* near, std::uint16_t* here, std::size_t width) {
  const auto least = [](int a, int b) { return static_cast<std::uint16_t>(std::min(a, b)); };
  for (std::size_t x = 0; x < width; ++x) here[x] = least(here[x], near[x] + kUnit);
  for (std::size_t x = 1; x < width; ++x) here[x] = least(here[x], near[x - 1] + kSlanted);
  for (std::size_t x = 1; x < width; ++x) here[x - 1] = least(here[x - 1], near[x] + kSlanted);
}

/// To the nearest pixel outside, at most kFarthest.
Distances inwardDistances(const image::Mask& mask) {
  Distances d(mask.pixels.size());
  if (d.empty()) return d;
  std::ranges::transform(mask.pixels, d.begin(),
                         [](std::uint8_t inside) { return static_cast<std::uint16_t>(inside != 0 ? kFarthest : 0); });
  const auto width = static_cast<std::size_t>(mask.width), height = static_cast<std::size_t>(mask.height);
  for (std::size_t y = 0; y < height; ++y) {
    std::uint16_t* row = d.data() + y * width;
    if (y > 0) relaxFrom(row - width, row, width);
    for (std::size_t x = 1; x < width; ++x) {
      row[x] = static_cast<std::uint16_t>(std::min<int>(row[x], row[x - 1] + kUnit));
    }
  }
  for (std::size_t y = height; y-- > 0;) {
    std::uint16_t* row = d.data() + y * width;
    if (y + 1 < height) relaxFrom(row + width, row, width);
    for (std::size_t x = width - 1; x-- > 0;) {
      row[x] = static_cast<std::uint16_t>(std::min<int>(row[x], row[x + 1] + kUnit));
    }
  }
  return d;
}

int unitsOf(double margin) { return static_cast<int>(std::lround(std::clamp(margin, 0.0, 64.0) * kUnit)); }

/// The larger of each and the one `by` (> 0) further on, and of each and the one as far before it.
void takeLarger(const std::uint16_t* from, std::uint16_t* to, std::size_t count, std::size_t by) {
  if (by >= count) return;
  for (std::size_t i = 0; i + by < count; ++i) to[i] = std::max(to[i], from[i + by]);
  for (std::size_t i = by; i < count; ++i) to[i] = std::max(to[i], from[i - by]);
}

/// Largest value within `radius` columns and rows of each entry.
Distances widened(const Distances& d, std::size_t width, std::size_t radius) {
  Distances across = d;
  for (std::size_t row = 0; row < d.size(); row += width) {
    for (std::size_t k = 1; k <= radius; ++k) takeLarger(&d[row], &across[row], width, k);
  }
  Distances out = across;
  for (std::size_t k = 1; k <= radius; ++k) {
    takeLarger(across.data(), out.data(), d.size(), k * width);
  }
  return out;
}

/// Entries of `a` where `b` has some too.
void keepIntersection(std::uint8_t* a, const std::uint8_t* b, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) a[i] = static_cast<std::uint8_t>(a[i] & b[i]);
}

/// Without the pixels beside one outside in their row.
image::Mask narrowed(const image::Mask& mask) {
  image::Mask out = mask;
  const auto width = static_cast<std::size_t>(mask.width);
  for (std::size_t row = 0; row < mask.pixels.size(); row += width) {
    keepIntersection(&out.pixels[row] + 1, &mask.pixels[row], width - 1);
    keepIntersection(&out.pixels[row], &mask.pixels[row] + 1, width - 1);
  }
  return out;
}

/// Without the pixels that have one outside within so many units: row by row the common part of the mask moved
/// about. For few units this is many times faster than distances.
image::Mask pared(const image::Mask& mask, int units) {
  image::Mask out = mask, thin = mask;
  const auto width = static_cast<std::size_t>(mask.width), height = static_cast<std::size_t>(mask.height);
  const int radius = units / kUnit;
  const auto reach = [&](int dy) {  // columns that are as near in a row as far off
    int dx = 0;
    while (std::min(dx + 1, dy) * (kSlanted - kUnit) + std::max(dx + 1, dy) * kUnit <= units) ++dx;
    return dx;
  };
  for (int aside = 0; aside <= radius; ++aside) {
    if (aside > 0) thin = narrowed(thin);
    for (int dy = 0; dy <= radius; ++dy) {
      if (reach(dy) != aside) continue;
      const std::size_t off = static_cast<std::size_t>(dy) * width;
      if (static_cast<std::size_t>(dy) >= height) continue;
      keepIntersection(out.pixels.data() + off, thin.pixels.data(), thin.pixels.size() - off);
      keepIntersection(out.pixels.data(), thin.pixels.data() + off, thin.pixels.size() - off);
    }
  }
  return out;
}

/// Eighths of a level, so that averages of averages stay true.
constexpr unsigned kFine = 8;

}  // namespace

double rimMargin(int longSide) { return std::clamp(longSide / 600.0, 2.0, 6.0); }

image::Mask opposite(image::Mask mask) {
  for (std::uint8_t& p : mask.pixels) p = static_cast<std::uint8_t>(255 - p);
  return mask;
}

image::Mask inset(const image::Mask& mask, double margin) {
  const int wanted = unitsOf(margin);
  if (mask.width <= 0 || mask.height <= 0 || wanted == 0) return mask;
  constexpr int kFew = 6 * kUnit;
  if (wanted <= kFew) return pared(mask, wanted);
  image::Mask out = mask;
  const Distances inward = inwardDistances(mask);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    if (inward[i] <= wanted) out.pixels[i] = 0;
  }
  return out;
}

image::Mask trusted(const image::Mask& covered, double margin) {
  image::Mask out = covered;
  const int wanted = unitsOf(margin);
  if (covered.width <= 0 || covered.height <= 0 || wanted == 0) return out;
  const Distances inward = inwardDistances(covered);
  // How deep it gets near by, which is half its width there.
  const auto radius = static_cast<std::size_t>((2 * wanted + kUnit - 1) / kUnit);
  const Distances deepest = widened(inward, static_cast<std::size_t>(covered.width), radius);
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    // An inner pixel next to an outer one is one pixel from it, but its outer side touches it.
    const int needed = std::min(wanted + kUnit / 2, deepest[i] / 2 + kUnit / 2);
    if (inward[i] < needed) out.pixels[i] = 0;
  }
  return out;
}

double meanDepth(const image::Mask& mask) {
  double sum = 0;
  std::size_t count = 0;
  for (const std::uint16_t distance : inwardDistances(mask)) {
    sum += distance;
    count += distance > 0 ? 1 : 0;
  }
  return count > 0 ? sum / (kUnit * static_cast<double>(count)) : 0;
}

ColourPyramid::ColourPyramid(const image::Image& image, const image::Mask& known) : image_(image), known_(known) {
  if (image.empty() || known.width != image.width || known.height != image.height) return;
  levels_.push_back(average(image.width, image.height, [&](int x, int y) {
    const std::size_t i = countOf(image.width, y) + static_cast<std::size_t>(x);
    const std::uint8_t* p = image.pixels.data() + 4 * i;
    const auto fine = [](std::uint8_t c) { return static_cast<std::uint16_t>(c * kFine); };
    return isKnown(i) ? Sample{{fine(p[0]), fine(p[1]), fine(p[2])}, 1} : Sample{};
  }));
  while (levels_.back().width > 1 || levels_.back().height > 1) {
    const Level& last = levels_.back();
    levels_.push_back(average(last.width, last.height, [&](int x, int y) {
      return last.samples[countOf(last.width, y) + static_cast<std::size_t>(x)];
    }));
  }
  if (levels_.back().samples.front().known == 0) {
    levels_.clear();
    return;
  }
  for (std::size_t i = levels_.size() - 1; i-- > 0;) {
    Level& level = levels_[i];
    auto out = level.samples.begin();
    for (int y = 0; y < level.height; ++y) {
      const Rows rows(levels_[i + 1], y);
      for (int x = 0; x < level.width; ++x, ++out) {
        if (out->known == 0) *out = rows.between(x);
      }
    }
  }
}

template <class At>
ColourPyramid::Level ColourPyramid::average(int width, int height, const At& at) {
  constexpr std::array<unsigned, 5> kTwelfths = {0, 12, 6, 4, 3};
  Level coarse{(width + 1) / 2, (height + 1) / 2, {}};
  coarse.samples.resize(countOf(coarse.width, coarse.height));
  auto out = coarse.samples.begin();
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x, ++out) {
      std::array<unsigned, 3> sum{};
      unsigned count = 0;
      for (int k = 0; k < 4; ++k) {
        const int fx = 2 * x + k % 2, fy = 2 * y + k / 2;
        if (fx >= width || fy >= height) continue;
        const Sample s = at(fx, fy);
        count += s.known;
        for (std::size_t c = 0; c < 3; ++c) sum[c] += s.known * s.colour[c];
      }
      if (count == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {  // twelfths: the compiler knows how to divide by a constant
        out->colour[c] = static_cast<std::uint16_t>((sum[c] * kTwelfths[count] + 6) / 12);
      }
      out->known = 1;
    }
  }
  return coarse;
}

ColourPyramid::Rows::Rows(const Level& coarse, int y) : last(coarse.width - 1) {
  const auto row = [&](int cy) { return &coarse.samples[countOf(coarse.width, std::clamp(cy, 0, coarse.height - 1))]; };
  near = row(y / 2);
  far = row(y / 2 + (y % 2 == 0 ? -1 : 1));
}

ColourPyramid::Sample ColourPyramid::Rows::between(int x) const {
  const auto own = static_cast<std::size_t>(std::min(x / 2, last));
  const auto next = static_cast<std::size_t>(std::clamp(x / 2 + (x % 2 == 0 ? -1 : 1), 0, last));
  // All four numbers of a sample in one word: sixteen times the largest colour still fits into its sixteen bits.
  static_assert(sizeof(Sample) == sizeof(std::uint64_t) && 16u * 255 * kFine + 8 < 1u << 16);
  constexpr std::uint64_t kEach = 0x0001000100010001;
  const auto all = [](const Sample& sample) { return std::bit_cast<std::uint64_t>(sample); };
  const std::uint64_t sum = 9 * all(near[own]) + 3 * (all(near[next]) + all(far[own])) + all(far[next]) + 8 * kEach;
  return std::bit_cast<Sample>(sum >> 4 & kEach * 0x0fff);
}

Colour ColourPyramid::colourOf(const Sample& sample) {
  const auto coarse = [](unsigned c) { return static_cast<std::uint8_t>((c + kFine / 2) / kFine); };
  return {coarse(sample.colour[0]), coarse(sample.colour[1]), coarse(sample.colour[2])};
}

bool ColourPyramid::isKnown(std::size_t i) const { return known_.pixels[i] != 0 && image_.pixels[4 * i + 3] >= 128; }

Colour ColourPyramid::at(std::size_t i) const {
  const std::uint8_t* p = image_.pixels.data() + 4 * i;
  if (isKnown(i)) return {p[0], p[1], p[2]};
  const auto width = static_cast<std::size_t>(image_.width);
  return colourOf(Rows(levels_.front(), static_cast<int>(i / width)).between(static_cast<int>(i % width)));
}

image::Image padEdges(const image::Image& image, const image::Mask& known) {
  const ColourPyramid carried(image, known);
  if (carried.empty()) return {};
  image::Image out = image;
  std::size_t i = 0;
  for (int y = 0; y < image.height; ++y) {
    const ColourPyramid::Rows rows(carried.levels_.front(), y);
    for (int x = 0; x < image.width; ++x, ++i) {
      std::uint8_t* to = &out.pixels[4 * i];
      to[3] = 255;
      if (!carried.isKnown(i)) std::ranges::copy(ColourPyramid::colourOf(rows.between(x)), to);
    }
  }
  return out;
}

}  // namespace spineloft::surface
