#include "tests/support/generators.h"

#include <algorithm>
#include <cmath>

namespace spineloft::testing {
namespace {

PicturePoint turned(double angle) { return {std::cos(angle), std::sin(angle)}; }

/// `across` points to the right of travel: on the screen, y down, that is travel turned by +90°.
PicturePoint rightOf(PicturePoint travel) { return {-travel.y, travel.x}; }

ribs::Rib ribAt(PicturePoint centre, PicturePoint across, double width) {
  ribs::Rib rib;
  rib.center = centre;
  rib.left = centre - across * (width / 2);
  rib.right = centre + across * (width / 2);
  rib.leftState = rib.rightState = ribs::RibState::Edge;
  return rib;
}

}  // namespace

ribs::RibSet straightRibs(PicturePoint from, PicturePoint to, int count, const std::function<double(double)>& width) {
  ribs::RibSet set;
  const PicturePoint across = rightOf(normalized(to - from));
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    set.ribs.push_back(ribAt(lerp(from, to, t), across, width(t)));
  }
  return set;
}

ribs::RibSet arcRibs(PicturePoint centre, double radius, double width, double fromAngle, double toAngle, int count) {
  ribs::RibSet set;
  for (int i = 0; i < count; ++i) {
    const double angle = fromAngle + (toAngle - fromAngle) * i / (count - 1);
    const PicturePoint out = turned(angle);
    // Growing angles run clockwise on the screen: the circle's centre is on the right.
    const double side = toAngle > fromAngle ? -1 : 1;
    set.ribs.push_back(ribAt(centre + out * radius, out * side, width));
  }
  return set;
}

ribs::RibSet randomRibs(Rng& rng) {
  const int count = 2 + static_cast<int>(rng.below(120));
  const double step = rng.uniform(1, 12), size = rng.uniform(2, 60);
  const double phase = rng.uniform(0, 6), waves = rng.uniform(0.5, 4);
  const double slant = rng.uniform() < 0.3 ? rng.uniform(-0.5, 0.5) : 0;
  PicturePoint at{rng.uniform(100, 900), rng.uniform(100, 900)};
  double heading = rng.uniform(0, 6.28), turn = 0;
  ribs::RibSet set;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / count;
    const double width = size * (1.2 + std::sin(phase + waves * 6.28 * t));
    turn = 0.8 * turn + rng.uniform(-0.02, 0.02);
    heading += std::clamp(turn, -0.8 * step / width, 0.8 * step / width);
    at += turned(heading) * step;
    set.ribs.push_back(ribAt(at, rightOf(turned(heading + slant)), width));
  }
  return set;
}

ribs::RibSet hostileRibs(Rng& rng) {
  const std::uint32_t kind = rng.below(8);
  ribs::RibSet set = randomRibs(rng);
  const auto anywhere = [&] {
    const double reach = kind == 7 ? 1e9 : 1000;
    return PicturePoint{rng.uniform(-reach, reach), rng.uniform(-reach, reach)};
  };
  for (ribs::Rib& rib : set.ribs) {
    if (kind == 0 || kind == 7 || (kind == 1 && rng.below(6) == 0)) {
      rib.left = anywhere();
      rib.right = anywhere();
    }
    if (kind == 2 && rng.below(3) == 0) std::swap(rib.left, rib.right);
    if (kind == 3 && rng.below(2) == 0) rib.left = rib.right = rib.center;
    if (kind == 4) rib.left = set.ribs[rng.below(static_cast<std::uint32_t>(set.ribs.size()))].left;
    if (kind == 5) rib.left = set.ribs.front().left;
    if (kind == 6) {  // all in one line
      rib.left.y = rib.right.y = set.ribs.front().left.y;
    }
  }
  if (kind == 2 && rng.below(2) == 0) {
    for (std::size_t i = 1; i < set.ribs.size(); i += 2) set.ribs[i] = set.ribs[i - 1];
  }
  for (ribs::EndFan* fan : {&set.startFan, &set.endFan}) {
    const std::uint32_t points = rng.below(12);
    const ribs::Rib& end = fan == &set.startFan ? set.ribs.front() : set.ribs.back();
    for (std::uint32_t i = 0; i < points; ++i) {
      fan->points.push_back(rng.below(4) == 0 ? anywhere() : lerp(end.left, end.right, rng.uniform(-0.5, 1.5)));
    }
  }
  return set;
}

std::vector<PicturePoint> randomStroke(Rng& rng, int count, double width, double height) {
  std::vector<PicturePoint> stroke;
  PicturePoint at{rng.uniform(0.2, 0.8) * width, rng.uniform(0.2, 0.8) * height};
  double heading = rng.uniform(0, 6.28);
  const double step = 0.5 * std::min(width, height) / count;
  for (int i = 0; i < count; ++i) {
    stroke.push_back(at);
    heading += rng.uniform(-0.1, 0.1);
    at += turned(heading) * step;
    at = {std::clamp(at.x, 0.0, width - 1), std::clamp(at.y, 0.0, height - 1)};
  }
  return stroke;
}

ribs::RibSet mirrored(const ribs::RibSet& set, double about) {
  ribs::RibSet out = set;
  const auto mirror = [&](PicturePoint p) { return PicturePoint{about - p.x, p.y}; };
  for (ribs::Rib& rib : out.ribs) {
    const ribs::Rib original = rib;
    rib.center = mirror(original.center);
    rib.left = mirror(original.right);
    rib.right = mirror(original.left);
    std::swap(rib.leftState, rib.rightState);
    std::swap(rib.leftLevel, rib.rightLevel);
    std::swap(rib.leftConfidence, rib.rightConfidence);
  }
  for (ribs::EndFan* fan : {&out.startFan, &out.endFan}) {
    for (PicturePoint& p : fan->points) p = mirror(p);
    std::reverse(fan->points.begin(), fan->points.end());
  }
  return out;
}

mesh::TriMesh box(float width, float height, float depth) {
  mesh::TriMesh mesh;
  for (int corner = 0; corner < 8; ++corner) {
    mesh.positions.push_back({corner & 1 ? width : 0, corner & 2 ? height : 0, corner & 4 ? depth : 0});
  }
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace spineloft::testing
