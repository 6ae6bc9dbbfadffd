// Closed forms of the equation of a strip that resists bending and stretching, k_b d'''' − k_s d'' = 0
// (ode-character-modelling, equation 5), by which curves and surfaces go from one known value to the next.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace spineloft::geometry {

/// What is known at the two ends of an interval whose parameter t goes from 0 to 1: values and derivatives by t.
struct OdeEnds {
  double start = 0, end = 0, startSlope = 0, endSlope = 0;
};

/// Tightness λ = ℓ √(k_s / k_b) of an interval of length ℓ, 0…kMostTightness: 0 bends only, more goes straighter.
inline constexpr double kMostTightness = 1e4;
/// Below this the solution is the cubic of the same ends, from which it differs by 3·10⁻⁶ there.
inline constexpr double kLeastTightness = 0.02;

/// d(t) = c0 + c1 (t − ½) + c2 e^(−λt) + c3 e^(−λ(1−t)), the solution with these values and slopes (equations 8 and 9
/// with the ends in place of ghost nodes); for λ < kLeastTightness the Hermite cubic.
class OdeCurve {
 public:
  /// Every number finite, `tightness` in 0…kMostTightness.
  OdeCurve(const OdeEnds& ends, double tightness);
  /// At t in 0…1.
  double value(double t) const;
  double slope(double t) const;      ///< first derivative by t
  double curvature(double t) const;  ///< second derivative by t

 private:
  std::array<double, 4> c_{};
  double tightness_ = 0;
  bool cubic_ = false;
};

/// The functions w_k of a closed parameter u, of period 1, that solve the equation between neighbouring nodes, are 1 at
/// node k and 0 at the others, and have continuous second derivatives: d(u) = Σ w_k(u) d_k is the closed curve through
/// the values d_k. With λ = 0 the periodic cubic spline. Two nodes opposite each other: d = a + (b − a)(3t² − 2t³).
class RingCardinals {
 public:
  /// `nodes`: at least one, growing, in 0 ≤ u < 1. `tightness`: of the whole ring, 0…kMostTightness; an interval has
  /// its share. Cost: the cube of the number of nodes.
  RingCardinals(std::span<const double> nodes, double tightness);
  std::size_t size() const { return nodes_.size(); }
  /// w_k(u) for every k into `weights`, which is as long as there are nodes; any finite u. Their sum is 1.
  void at(double u, std::span<double> weights) const;

 private:
  double spanAfter(std::size_t node) const;

  std::vector<double> nodes_;
  double tightness_ = 0;
  std::vector<double> slopes_;  ///< of w_k at node i, by u: i × size + k
};

/// The closed curve round a centre through four values, those in the directions x, y, −x and −y, quarter by quarter by
/// the functions of two opposite nodes, a + (b − a)(3t² − 2t³) with t the share of the angle: level at each of the
/// four. In the direction (x, y), which is not 0.
double aroundFour(const std::array<double, 4>& values, double x, double y);

}  // namespace spineloft::geometry
