// Which gradient is an edge? Chosen from the picture, so that a faint vase, a noisy photo and a pen
// drawing all give their outlines.
#pragma once

#include <span>

namespace spineloft::vision {

/// Canny's hysteresis thresholds and the noise they were chosen for, in Lab units per map pixel.
struct Thresholds {
  double low = 0, high = 0;
  double noise = 0;  ///< scale of the gradients that noise alone makes
  bool operator==(const Thresholds&) const = default;
};

/// The rule, on the gradient sizes m of all pixels:
///  1. Noise: on plain ground the size of a smoothed noise gradient is Rayleigh distributed, and
///  the
///     quietest third of a picture is plain ground; so the scale s of the noise is the 30th
///     percentile of m divided by that of the unit Rayleigh distribution, 0.845. Pixels without any
///     change are left out (digital white says nothing about noise); where they are the most, s is
///     0.
///  2. Clutter: the 90th percentile of m, since outlines are the strongest few percent.
///  3. high = clutter, but at least kFaintest (below it 8-bit steps show) and at most kStrongest,
///  so
///     that strong texture or a strong foreign object never hides a plain edge, and then at least
///     kNoiseFactor · s. low = kLowShare · high.
/// Both planes have one entry a pixel; an empty picture gives kFaintest.
Thresholds chooseThresholds(std::span<const float> gradientX, std::span<const float> gradientY);

/// Whether a contour of `count` pixels with gradient sizes that add up to `sum` is more than noise:
/// the thresholds let single noise pixels pass, but a contour of n of them is as strong on average
/// as one pixel in √n times the doubt. Demands (sum/count/s − kNoiseLevel) · √count ≥ kDoubt and at
/// least kShortestContour pixels.
bool isContour(double sum, int count, double noise);

inline constexpr double kNoiseFactor = 2.5;
inline constexpr double kFaintest = 0.35;  ///< Lab units a pixel
inline constexpr double kStrongest = 4.0;  ///< Lab units a pixel
inline constexpr double kLowShare = 0.5;
/// Gradient, in s, that the mean along a contour must exceed.
inline constexpr double kNoiseLevel = 2.2;
inline constexpr double kDoubt = 2.5;
/// Fewer map pixels than this are a speck, not an outline.
inline constexpr int kShortestContour = 8;

}  // namespace spineloft::vision
