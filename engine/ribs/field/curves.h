// Gradient curves of d2 from the hull of a spine (SpineLoft 3.3.1; method: "Gradient curves").
#pragma once

#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/field/d2.h"

namespace spineloft::ribs {

/// The level sets of d2 that all curves are cut at: label k stands for the level set
/// ρ(d2) = radius[k], where ρ is the radius that a straight spine of the same length has at that d2
/// (see d2OfRadius). radius[0] = 0 is the spine itself.
struct Levels {
  std::vector<double> radius;  ///< ρ, picture pixels, increasing
  std::vector<double> d2;      ///< d2, picture pixels, increasing
  std::size_t size() const { return radius.size(); }
};

/// `count` ≥ 2 levels up to ρ = `farthest`: `step` apart near the spine, widening to an even ratio
/// so that the last one is `farthest`: ρ_k = step/r · sinh(r k). Evenly spaced where `step` ·
/// (count − 1) already reaches that far (the step then shrinks). All in picture pixels, > 0.
Levels makeLevels(int count, double step, double farthest, double length);
/// The same into `levels`, reusing memory.
void makeLevels(int count, double step, double farthest, double length, Levels& levels);

/// Where the curves are and how they end. Curves run once around the hull without a gap: the left
/// side along the spine, the fan around the last point, the right side back, the fan around the
/// first.
struct CurveLayout {
  int ribs = 0;  ///< spine points
  int fan = 0;   ///< curves strictly between the outermost left and right one at each end
  int total() const { return 2 * (ribs + fan); }
  int left(int rib) const { return rib; }
  int right(int rib) const { return 2 * ribs + fan - 1 - rib; }
  int sideOf(int rib, bool leftSide) const { return leftSide ? left(rib) : right(rib); }
  int endFan(int i) const { return ribs + i; }           ///< from the left to the right
  int startFan(int i) const { return total() - 1 - i; }  ///< from the left to the right
};

/// Points of every curve at every level, curve after curve. `x`, `y` have total() × levels entries,
/// picture pixels; those of curve c at label k are at c · levels + k. Entries from `reached[c]` on
/// are not set: the curve has left the picture or run into a saddle of d2.
struct GradientCurves {
  CurveLayout layout;
  int levels = 0;
  std::vector<float> x, y;
  std::vector<float> along;                        ///< arc length from the spine, picture pixels, same shape
  std::vector<std::array<PicturePoint, 2>> seeds;  ///< on the spine, and on the hull
  std::vector<int> reached;                        ///< labels that exist on a curve, ≥ 1 (label 0 is the spine point)
  std::size_t steps = 0;                           ///< of the integrator, over all curves, rejected ones included
  std::size_t at(int curve, int level) const {
    return static_cast<std::size_t>(curve) * static_cast<std::size_t>(levels) + static_cast<std::size_t>(level);
  }
  PicturePoint point(int curve, int level) const {
    return {static_cast<double>(x[at(curve, level)]), static_cast<double>(y[at(curve, level)])};
  }
  /// The point at an arc length, held to where the curve is.
  PicturePoint pointAlong(int curve, double length) const;
  /// The same, looked for from label `from` ≥ 0 on, which is not beyond it and moves there.
  PicturePoint pointAlong(int curve, double length, int& from) const;
};

inline PicturePoint GradientCurves::pointAlong(int curve, double length, int& k) const {
  const int last = reached[static_cast<std::size_t>(curve)] - 1;
  if (last < 1) return point(curve, 0);
  const float *arcs = &along[at(curve, 0)], sought = static_cast<float>(length);
  while (k + 1 < last && arcs[k + 1] <= sought) ++k;
  const double from = arcs[k], run = std::max(1e-9, static_cast<double>(arcs[k + 1]) - from);
  return lerp(point(curve, k), point(curve, k + 1), std::clamp((length - from) / run, 0.0, 1.0));
}

/// Follows x' = ∇d2 / |∇d2|² (in the parameter ρ) from the hull: the spine's points offset by
/// ε = half the smallest spacing along the normals, and `fan` seeds spread over the half circle
/// around each end. Dormand–Prince 5(4) with dense output at the levels and a bounded number of
/// steps; every step ends exactly on its level set. Curves stop at the picture's frame, half a
/// pixel outside it. `spine` ≥ 2 distinct points, `field` made from them. The result replaces
/// `curves`, reusing memory.
void traceCurves(const Spine& spine, const D2Field& field, const Levels& levels, int fan, image::Size picture,
                 GradientCurves& curves);

}  // namespace spineloft::ribs
