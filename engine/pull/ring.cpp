#include "engine/pull/ring.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spineloft::pull {
namespace {

constexpr double kFacing = 0.1;  // of 1: normals that face so little along the ring's own have no side

}  // namespace

Ring::Ring(std::span<const Corner> corners) {
  const std::size_t count = corners.size();
  ModelPoint centre, round, normals;
  for (const Corner& corner : corners) {
    centre += corner.at / static_cast<double>(count);
    normals += corner.normal;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const ModelPoint a = corners[i].at, b = corners[(i + 1) % count].at;
    round += cross(a - centre, b - centre);
    length_ += distance(a, b);
  }
  area_ = norm(round) / 2;
  const double facing = dot(normalized(round), normals) / static_cast<double>(count), turn = facing < 0 ? -1 : 1;
  turned_ = std::abs(facing) > kFacing;
  for (std::size_t i = 0; i < count; ++i) {
    const Corner &a = corners[i], &b = corners[(i + 1) % count];
    const ModelPoint along = b.at - a.at;
    sides_.push_back({a.at, along, normalized(cross(a.normal + b.normal, along)) * turn, {}});
  }
  for (std::size_t i = 0; i < count; ++i)
    sides_[i].withinAtCorner = sides_[i].within + sides_[(i + count - 1) % count].within;
}

void Ring::turnTo(ModelPoint p) {
  if (turned_ || depth(p) > 0) return;
  for (Side& side : sides_) {
    side.within = side.within * -1;
    side.withinAtCorner = side.withinAtCorner * -1;
  }
}

double Ring::depth(ModelPoint p) const {
  double least2 = std::numeric_limits<double>::infinity(), side = 0;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const Side& s = sides_[i];
    const ModelPoint way = p - s.from;
    const double length2 = dot(s.along, s.along), t = length2 > 0 ? dot(way, s.along) / length2 : 0;
    if (t > 1) continue;  // the next corner is nearer
    const ModelPoint off = t > 0 ? way - s.along * t : way;
    const double off2 = dot(off, off);
    if (off2 >= least2) continue;
    least2 = off2;
    side = dot(off, t > 0 ? s.within : s.withinAtCorner);
  }
  // What lies on the line between both is beyond: the side of a box, of a ring along its edge.
  const double away = std::sqrt(least2);
  return side > 1e-6 * away ? away : -away;
}

}  // namespace spineloft::pull
