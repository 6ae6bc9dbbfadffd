#include "tests/bench/accuracy/erased_outline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/vision/blur.h"

namespace spineloft::accuracy {
namespace {

// Run of the outline and half breadth of what is faded, in mean local widths.
constexpr double kRun = 1, kReach = 0.15;
// The Gaussian's σ as a share of the reach.
constexpr double kSigma = 0.7;
// Of every so many boundary points, which lie a third of a pixel apart, one is enough.
constexpr std::size_t kEvery = 3;
// Inner share of the reach that is faded wholly.
constexpr double kWhole = 0.5;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The most frequent colour, to sixteen steps of each channel: the middle of its step.
std::array<std::uint8_t, 3> mostFrequent(const image::Image& image) {
  std::vector<int> counts(16 * 16 * 16, 0);
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    const auto* p = &image.pixels[i];
    ++counts[static_cast<std::size_t>(p[0] / 16 * 256 + p[1] / 16 * 16 + p[2] / 16)];
  }
  const auto best = static_cast<int>(std::ranges::max_element(counts) - counts.begin());
  std::array<double, 3> sum{};
  double count = 0;
  for (std::size_t i = 0; i + 3 < image.pixels.size(); i += 4) {
    const auto* p = &image.pixels[i];
    if (p[0] / 16 * 256 + p[1] / 16 * 16 + p[2] / 16 != best) continue;
    for (std::size_t k = 0; k < 3; ++k) sum[k] += p[k];
    count += 1;
  }
  std::array<std::uint8_t, 3> mean{};
  for (std::size_t k = 0; k < 3; ++k) mean[k] = static_cast<std::uint8_t>(std::lround(sum[k] / std::max(1.0, count)));
  return mean;
}

// How much of every pixel is faded, 0…1.
std::vector<float> fades(const cli::Truth& truth, double share, double width, image::Size size) {
  std::vector<float> fade(index(size.width) * index(size.height), 0.f);
  const double reach = std::max(3.0, kReach * width);
  const double scale = static_cast<double>(size.width) / truth.width();
  for (std::size_t i = 0; i < truth.boundary().size(); i += kEvery) {
    const PicturePoint at = truth.boundary()[i];
    const double runs = truth.arcAt(at) / (kRun * width) + (truth.isLeft(at) ? 0 : 0.5);
    if (runs - std::floor(runs) >= share) continue;
    const double far = reach * scale;
    const PicturePoint p = at * scale;
    const int top = std::max(0, static_cast<int>(p.y - far)), left = std::max(0, static_cast<int>(p.x - far));
    for (int y = top; y < size.height && y <= p.y + far; ++y) {
      for (int x = left; x < size.width && x <= p.x + far; ++x) {
        const double away = std::hypot(x - p.x, y - p.y) / far;
        const double here = std::clamp((1 - away) / (1 - kWhole), 0.0, 1.0);
        float& there = fade[index(y) * index(size.width) + index(x)];
        there = std::max(there, static_cast<float>(here));
      }
    }
  }
  return fade;
}

}  // namespace

Status eraseOutline(const cli::Truth& truth, double share, bool paper, image::Image& image) {
  if (!(share > 0) || image.pixels.empty()) return Done{};
  const double width = truth.meanWidth();
  const double scale = static_cast<double>(image.width) / truth.width();
  image::Image soft = image;
  if (paper) {
    const auto colour = mostFrequent(image);
    for (std::size_t i = 0; i < soft.pixels.size(); ++i) {
      if (i % 4 < 3) soft.pixels[i] = colour[i % 4];
    }
  } else {
    const double sigma = std::max(1.0, kSigma * kReach * width * scale);
    Result<image::Image> blurred = vision::blurred(image, sigma);
    if (!blurred) return blurred.failure();
    soft = std::move(blurred).value();
  }
  const std::vector<float> fade = fades(truth, share, width, {image.width, image.height});
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const double t = static_cast<double>(fade[i / 4]);
    const double mixed = (1 - t) * image.pixels[i] + t * soft.pixels[i];
    image.pixels[i] = static_cast<std::uint8_t>(std::lround(mixed));
  }
  return Done{};
}

}  // namespace spineloft::accuracy
