#include "engine/ribs/base/rib_params.h"

#include <initializer_list>

namespace spineloft::ribs {

bool inRange(const RibParams& p) {
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  const EvidenceParams& e = p.evidence;
  for (double weight : {e.learnedWeight, e.proximityWeight, e.weight, p.medialOffsetCost, p.neighbourFreedom}) {
    if (!within(weight, 0, 10)) return false;
  }
  const FairingParams& f = p.fairing;
  if (!within(f.stiffness, 0, 1000) || !within(f.leastTrust, 1e-4, 1) || !within(f.corner, 1e-3, 10) ||
      !within(f.outlier, 1e-3, 10)) {
    return false;
  }
  return within(p.levels, 16, 512) && within(p.maxLevelShare, 0.01, 1) && within(p.neighbourWeight, 0, 100) &&
         within(p.neighbourCap, 0.01, 1000) && within(p.oppositeWeight, 0, 100) && within(e.doubt, 0.001, 10);
}

}  // namespace spineloft::ribs
