// The d2 distance to a polyline and its gradient in closed form (SpineLoft 3.3.1 and Appendix A;
// method: "d2").
//   d2(x) = sqrt(A) · (Σ_i I_i(x))^(−1/2),  I_i(x) = ∫ over segment i of |x − y|^(−2) dy,
// A the polyline's length. Far away d2 tends to the Euclidean distance; on the polyline it is 0.
#pragma once

#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::ribs {

struct D2Sample {
  double d2 = 0;          ///< picture pixels, ≥ 0
  PicturePoint gradient;  ///< dimensionless; {0, 0} where d2 is 0
};

/// The field of one polyline (≥ 2 distinct points; repeated points are skipped). Evaluation costs one
/// arctangent a segment. A value: copy and move freely.
class D2Field {
 public:
  explicit D2Field(std::span<const PicturePoint> polyline);
  /// d2 and ∇d2 at x, in the same pass.
  D2Sample sample(PicturePoint x) const;
  /// d2 alone.
  double distance(PicturePoint x) const;
  /// A: the polyline's length in picture pixels.
  double length() const { return length_; }

 private:
  std::vector<PicturePoint> points_;
  double length_ = 0;
};

}  // namespace spineloft::ribs
