#include "engine/ribs/edits.h"

#include <algorithm>
#include <cmath>

namespace spineloft::ribs {

bool isValid(const RibEdits& edits) {
  const auto share = [](double value) { return value >= 0 && value <= 1; };
  return edits.ends.size() <= kMostEndEdits && edits.added.size() <= kMostAddedRibs &&
         edits.removed.size() <= kMostAddedRibs && std::ranges::all_of(edits.added, share) &&
         std::ranges::all_of(edits.removed, share) &&
         std::ranges::all_of(edits.ends, [&](const EndEdit& end) {
           return share(end.at) && share(end.reach) && std::isfinite(end.along) &&
                  std::isfinite(end.out) && end.side <= Side::Right;
         });
}

RibSet applyEdits(const Spine&, const RibSet& generated, const RibEdits&) { return generated; }

}  // namespace spineloft::ribs
