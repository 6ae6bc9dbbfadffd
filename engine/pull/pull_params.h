// What a pull is.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace spineloft::pull {

/// A line on a part, and where it goes. All in ModelSpace, picture pixels. Where the part is another one than when the
/// line was drawn, the line lies at the places of its surface that are nearest.
struct Pull {
  std::vector<ModelPoint> line;    ///< 1 … kMostLinePoints; one point: a place
  double height = 0;               ///< along the surface's normals, < 0: inwards
  std::vector<ModelPoint> to;      ///< where the line goes instead, by shares of both lengths; none: `height` counts
  double radius = 40;              ///< kLeastRadius … kMostRadius; what is farther from the line stays
  bool crease = false;             ///< an edge along the line, or along the ring; else smooth
  std::vector<ModelPoint> ring{};  ///< a closed line on the part, 3 … kMostLinePoints: what is within it follows, and
                                   ///< the radius does not count; none: what is within the radius
  std::vector<ModelPoint> across{}, acrossTo{};  ///< a second line, and where it goes, as the first; none: one line
  bool operator==(const Pull&) const = default;
};

/// Calls `f` with every place that a pull has.
template <class F>
void eachPlace(Pull& pull, const F& f) {
  for (auto* line : {&pull.line, &pull.to, &pull.ring, &pull.across, &pull.acrossTo}) {
    for (ModelPoint& p : *line) f(p);
  }
}

inline constexpr std::size_t kMostPulls = 40, kMostLinePoints = 200;  ///< of a part; of a line
inline constexpr double kLeastRadius = 2, kMostRadius = 20000, kMostHeight = 20000;

/// Error: ValueOutOfRange, with what.
Status checkPulls(const std::vector<Pull>& pulls);

}  // namespace spineloft::pull
