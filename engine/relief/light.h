// The colours and the light of a picture of a known shape. Internal to relief/.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace spineloft::relief {

/// A surface z(x, y): its slopes in a cell.
struct Slope {
  double p = 0, q = 0;  ///< ∂z/∂x, ∂z/∂y
};

/// Brightness of a white surface as a function of its normal: c·Y(n), Y the real spherical harmonics up to the second
/// degree without their factors.
class Light {
 public:
  static constexpr std::size_t kCount = 9;
  using Terms = std::array<double, kCount>;

  Light() = default;
  explicit Light(const Terms& c) : c_(c) {}
  static Terms terms(Slope slope);
  double operator()(Slope slope) const;
  /// Its derivatives with respect to p and q.
  Slope derivative(Slope slope) const;

 private:
  Terms c_{};
};

/// A channel as it is reckoned with: whatever was given, not below 0, and finite.
inline double usable(float channel) { return std::min(std::max(0.0, static_cast<double>(channel)), 1e6); }

constexpr std::size_t kMostColours = 4;

/// Up to four colours by chroma, and which a cell shows.
struct Colours {
  std::size_t count = 0;
  /// Of every cell how much it is of each; the sum is 1. In between where a colour passes into another.
  std::vector<std::array<float, kMostColours>> shares;
  /// 0 where two colours are mixed at an edge, and where of several it is too dark to tell which.
  std::vector<std::uint8_t> sure;
};

Colours coloursOf(int width, int height, std::span<const std::array<float, 3>> colour,
                  std::span<const std::uint8_t> inside);

/// Finds the light and the albedo of every colour.
class LightFit {
 public:
  /// `use`: the cells that count.
  LightFit(std::vector<double> brightness, Colours colours, std::vector<std::uint32_t> use,
           const std::vector<Slope>& slopes);
  /// One more round; false: all are done.
  bool round();

  const Light& light() const { return light_; }
  /// Brightness by albedo of a cell; 0 where that is black.
  double shading(std::uint32_t cell) const;
  /// Share of the variance of that in the cells that count that the light explains, 0 … 1.
  double explained() const;

 private:
  std::vector<double> brightness_;
  Colours colours_;
  std::vector<std::uint32_t> use_;
  std::vector<Light::Terms> terms_;  // of the cells in use, as are the next
  std::vector<double> weights_, lit_;
  std::array<double, kMostColours> albedo_{};
  Light light_;
  int rounds_ = 0;
};

/// 1.4826 times the median size: the standard deviation where the distribution is normal. 0 of nothing.
double robustSigma(std::vector<double> residuals);

}  // namespace spineloft::relief
