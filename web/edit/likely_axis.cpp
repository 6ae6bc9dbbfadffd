#include <algorithm>
#include <cmath>
#include <vector>

#include "web/edit/front_field.h"
#include "web/edit/placing.h"

namespace spineloft::app {
namespace {

constexpr double kAlike = 0.82;  // of the outline of a thing that is alike left and right lies on its other side
constexpr double kApart = 0.5;   // of a part may lie on its own twin
constexpr double kBefore = 0.2;  // of its depth that a part stands before the middle of the rest

void join(Body& body, Body other) {
  for (mesh::TriMesh& mesh : other.meshes) body.add(std::move(mesh));
}

/// Share of the cells of either field that those of the other one, mirrored left to right, have as well.
double alike(const FrontField& field) {
  std::size_t both = 0, any = 0;
  for (std::size_t i = 0; i < field.size(); ++i) {
    const std::size_t column = i % kFieldCells;
    const bool here = field[i] != kNothing, there = field[i - column + (kFieldCells - 1 - column)] != kNothing;
    both += here && there ? 1 : 0;
    any += here || there ? 1 : 0;
  }
  return any > 0 ? static_cast<double>(both) / static_cast<double>(any) : 0;
}

}  // namespace

const MirrorAxis& likelyAxis(const document::Document& document, const pipeline::Derived& derived,
                             std::span<const PartId> parts) {
  const std::span<const MirrorAxis> axes = mirrorAxes();
  const MirrorAxis &sides = axes[0], &depth = axes[1];
  Body own, rest;
  for (const document::Part& part : document.parts) {
    const bool mine = std::ranges::count(parts, part.id) > 0;
    join(mine ? own : rest, bodyAlone(document, derived, part.id));
  }
  if (!own.bounds || !rest.bounds) return sides;
  const double middle = planeFor(document, derived, parts, sides).point.x;
  const pipeline::WorldBounds &a = *own.bounds, &b = *rest.bounds;
  const double reach = std::max({middle - a.low.x, a.high.x - middle, middle - b.low.x, b.high.x - middle});
  const pipeline::WorldBounds area{{middle - reach, std::min(a.low.y, b.low.y), 0},
                                   {middle + reach, std::max(a.high.y, b.high.y), 0}};
  const bool apart = alike(fieldOf(own, area, 1)) <= kApart;
  const bool symmetric = alike(fieldOf(rest, area, 1)) >= kAlike;
  if (apart && symmetric) return sides;
  const double off = std::abs(a.centre().z - planeFor(document, derived, parts, depth).point.z);
  return off >= kBefore * (a.high.z - a.low.z) ? depth : sides;
}

}  // namespace spineloft::app
