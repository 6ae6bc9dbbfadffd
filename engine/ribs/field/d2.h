// The d2 distance to a polyline and its gradient in closed form (SpineLoft 3.3.1 and Appendix A;
// method: "d2").
//   d2(x) = sqrt(A) · (Σ_i I_i(x))^(−1/2),  I_i(x) = ∫ over segment i of |x − y|^(−2) dy,
// A the polyline's length. Far away d2 tends to the Euclidean distance; on the polyline it is 0.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::ribs {

struct D2Sample {
  double d2 = 0;          ///< picture pixels, ≥ 0
  PicturePoint gradient;  ///< dimensionless; {0, 0} where d2 is 0
};

/// Σ_i I_i and its gradient, from which every function of d2 follows. Single precision.
struct D2Integral {
  float value = 0;                     ///< 1 / picture pixels, > 0; infinite on the polyline
  float gradientX = 0, gradientY = 0;  ///< 1 / picture pixels²
};

/// The field of one polyline (≥ 2 distinct points; repeated points are skipped). Evaluation costs
/// one arctangent a segment. A value: copy and move freely.
class D2Field {
 public:
  D2Field() = default;  ///< of nothing, until assigned
  explicit D2Field(std::span<const PicturePoint> polyline);
  /// The same field of another polyline, in the memory of this one.
  void assign(std::span<const PicturePoint> polyline);
  /// d2 and ∇d2 at x, in the same pass.
  D2Sample sample(PicturePoint x) const;
  /// d2 alone.
  double distance(PicturePoint x) const;
  /// Σ I and ∇Σ I at x in single precision, four segments at a time: within 3e-5 of the double
  /// result for points farther than a pixel from the polyline.
  D2Integral integral(PicturePoint x) const;
  /// The same with far stretches of four segments replaced by their length and second moments, and on
  /// polylines of kGrouped segments or more those of four stretches: within 2e-3, several times faster on
  /// long polylines. The curves are traced with this one.
  D2Integral quickIntegral(PicturePoint x) const;
  /// A: the polyline's length in picture pixels.
  double length() const { return length_; }
  static constexpr std::size_t kGrouped = 180;

 private:
  std::vector<PicturePoint> points_;
  double length_ = 0;
  // The same segments for the vector kernel, relative to the first point so that single precision
  // is enough, padded to whole lanes with segments of no length: start, unit direction, length.
  using Lane4 = std::array<float, 4>;
  struct Segments {
    Lane4 startX, startY, alongX, alongY, reach;
  };
  std::vector<Segments> segments_;
  // Four runs of segments: centroid, length and twice it, second moments about the centroid (eightfold), their
  // trace and four times it, squared distance within which what they are made of is summed. Padded to whole
  // lanes with runs of no mass, far from everything.
  struct Runs {
    Lane4 middleX, middleY, mass, massTwice, momentXX, momentXY, momentYY, trace, traceFour, near;
  };
  std::vector<Runs> stretches_;  // of four segments
  std::vector<Runs> groups_;     // of four stretches each; none on short polylines
  void gather(std::size_t segments, std::vector<Runs>& runs) const;
  struct Kernel;
};

/// The radius at which the perpendicular bisector of a *straight* spine of length `length` has the
/// given d2, and back: d2² = A ρ / (2 atan(A / 2ρ)). Along a straight part ρ is the Euclidean
/// distance to the spine where d2 itself grows like its root, so evenly spaced ρ means evenly
/// spaced points. Level sets of ρ are level sets of d2. All in picture pixels, > 0.
double d2OfRadius(double radius, double length);
double radiusOfD2(double d2, double length);

}  // namespace spineloft::ribs
