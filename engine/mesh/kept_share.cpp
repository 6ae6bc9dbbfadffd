#include "engine/mesh/kept_share.h"

#include "engine/mesh/self_crossing.h"

namespace spineloft::mesh {

double keptShare(const TriMesh& before, const std::function<void(double share, TriMesh& out)>& moveTo, TriMesh& out) {
  constexpr int kHalvings = 4;
  moveTo(1, out);
  if (!selfCrossing(out) || selfCrossing(before)) return 1;
  double share = 1;
  for (int i = 0; i < kHalvings; ++i) {
    share /= 2;
    moveTo(share, out);
    if (!selfCrossing(out)) return share;
  }
  out = before;
  return 0;
}

}  // namespace spineloft::mesh
