#include "engine/pull/pull.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/mesh/kept_share.h"

namespace spineloft::pull {
namespace {

constexpr double kFarthest = 1e6;  // picture pixels: beyond it is no place that a hand means

bool isPlace(ModelPoint p) {
  return isFinite(p) && std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest && std::abs(p.z) <= kFarthest;
}

bool isLine(const std::vector<ModelPoint>& line) {
  return line.size() <= kMostLinePoints && std::ranges::all_of(line, isPlace);
}

double wholeWay(const Pull& pull) { return pull.to.empty() ? pull.height : 1; }

void moveBy(const Reach& reach, double way, mesh::TriMesh& out) {
  out = reach.mesh;
  for (const auto& [vertex, by] : reach.moved) {
    auto& p = out.positions[vertex];
    p = {static_cast<float>(p[0] + way * by.x), static_cast<float>(p[1] + way * by.y),
         static_cast<float>(p[2] + way * by.z)};
  }
}

}  // namespace

Status checkPulls(const std::vector<Pull>& pulls) {
  if (pulls.size() > kMostPulls) {
    return {Error::ValueOutOfRange, "a part has at most " + std::to_string(kMostPulls) + " pulls"};
  }
  for (const Pull& pull : pulls) {
    if (pull.line.empty() || !isLine(pull.line) || !isLine(pull.to) || !isLine(pull.across) || !isLine(pull.acrossTo)) {
      return {Error::ValueOutOfRange,
              "the line of a pull has 1 … " + std::to_string(kMostLinePoints) + " finite points x, y, z"};
    }
    if (pull.acrossTo.empty() != (pull.across.empty() || pull.to.empty())) {
      return {Error::ValueOutOfRange, "the line across is told where it goes if the first one is, and only then"};
    }
    if (!isLine(pull.ring) || pull.ring.size() == 1 || pull.ring.size() == 2) {
      return {Error::ValueOutOfRange,
              "the ring of a bump has 3 … " + std::to_string(kMostLinePoints) + " finite points x, y, z"};
    }
    // Written so that NaN fails too.
    if (!(pull.radius >= kLeastRadius && pull.radius <= kMostRadius)) {
      return {Error::ValueOutOfRange, "radius of a pull: 2 … 20000 pixels"};
    }
    if (!(std::abs(pull.height) <= kMostHeight)) {
      return {Error::ValueOutOfRange, "height of a pull: -20000 … 20000 pixels"};
    }
  }
  return Done{};
}

void moveMesh(const Reach& reach, const Pull& pull, mesh::TriMesh& out) { moveBy(reach, wholeWay(pull), out); }

double pullMesh(const Reach& reach, const Pull& pull, mesh::TriMesh& out) {
  if (wholeWay(pull) == 0 || reach.moved.empty()) {
    out = reach.mesh;
    return wholeWay(pull) == 0 ? 1 : 0;
  }
  const auto moveTo = [&](double share, mesh::TriMesh& to) { moveBy(reach, share * wholeWay(pull), to); };
  return mesh::keptShare(reach.mesh, moveTo, out);
}

}  // namespace spineloft::pull
