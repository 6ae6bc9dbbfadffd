#include "engine/pipeline/world.h"

#include <algorithm>
#include <cmath>

namespace spineloft::pipeline {
namespace {

constexpr double kGap = 0.06;  // between parts of two pictures, world units: a picture's side is 1

/// The columns are what a map without a shift makes of the axes.
template <class Map>
std::array<double, 9> matrixOf(const Map& map) {
  const WorldPoint x = map(WorldPoint{1, 0, 0}), y = map(WorldPoint{0, 1, 0}), z = map(WorldPoint{0, 0, 1});
  return {x.x, y.x, z.x, x.y, y.y, z.y, x.z, y.z, z.z};
}

template <class Wanted>
std::optional<WorldBounds> boundsIf(const document::Document& document, const Derived& derived, const Wanted& wanted) {
  std::optional<WorldBounds> bounds;
  for (const DerivedPart& shown : derived.parts) {
    const document::Part* part = document::findPart(document, shown.id);
    if (part == nullptr || !shown.shape || !wanted(*part)) continue;
    const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
    if (entry == nullptr) continue;
    for (const ToWorld& toWorld : copiesInWorld(*part, entry->size)) {
      for (const auto& p : shown.shape->mesh.positions) include(bounds, toWorld(p));
    }
  }
  return bounds;
}

}  // namespace

WorldFrame worldFrame(image::Size picture) {
  // Pixel centres are at integers, so that the picture spans −½ … size − ½.
  const double width = std::max(1, picture.width), height = std::max(1, picture.height);
  return {1 / std::max(width, height), {(width - 1) / 2, -(height - 1) / 2, 0}};
}

WorldPoint ToWorld::operator()(ModelPoint p) const { return along(p - origin) + shift; }

bool ToWorld::isStraight() const {
  const auto& m = linear;
  return m[1] == 0 && m[2] == 0 && m[3] == 0 && m[5] == 0 && m[6] == 0 && m[7] == 0 && m[0] > 0 && m[4] > 0 && m[8] > 0;
}

WorldPoint ToWorld::along(ModelPoint v) const {
  const auto& m = linear;
  return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
          m[6] * v.x + m[7] * v.y + m[8] * v.z};
}

ModelPoint ToWorld::toModel(WorldPoint p) const { return alongInModel(p - shift) + origin; }

ModelPoint ToWorld::alongInModel(WorldPoint v) const {
  // The transposed matrix is the inverse, but for the square of the scale.
  const auto& m = linear;
  const double s = 1 / (scale * scale);
  return {(m[0] * v.x + m[3] * v.y + m[6] * v.z) * s, (m[1] * v.x + m[4] * v.y + m[7] * v.z) * s,
          (m[2] * v.x + m[5] * v.y + m[8] * v.z) * s};
}

Copies copiesInWorld(const document::Placement& placement, const std::optional<document::MirrorPlane>& mirror,
                     image::Size picture) {
  const WorldFrame frame = worldFrame(picture);
  Copies copies;
  ToWorld& own = copies.all[0];
  own.origin = frame.centre;
  own.scale = frame.scale * placement.scale;
  own.flips = placement.mirrored;
  own.shift = placement(WorldPoint{});
  own.linear = {frame.scale, 0, 0, 0, frame.scale, 0, 0, 0, frame.scale};
  const bool straight = placement.turn.isRest() && !placement.mirrored && placement.scale == 1;
  if (straight) {
    own.shift = placement.move;
  } else {
    own.linear = matrixOf([&](WorldPoint v) {
      const WorldPoint scaled = v * own.scale;
      return geometry::turned(placement.turn, placement.mirrored ? WorldPoint{-scaled.x, scaled.y, scaled.z} : scaled);
    });
  }
  if (!mirror) return copies;
  ToWorld& twin = copies.all[1];
  twin = own;
  twin.flips = !own.flips;
  twin.shift = (*mirror)(own.shift);
  const WorldPoint n = mirror->normal;
  twin.linear = matrixOf([&](WorldPoint v) {
    const WorldPoint w = own.along({v.x, v.y, v.z});
    return w - n * (2 * dot(n, w));
  });
  copies.count = 2;
  return copies;
}

Copies copiesInWorld(const document::Part& part, image::Size picture) {
  return copiesInWorld(part.placement, part.mirror, picture);
}

std::optional<WorldPoint> crossingInWorld(const document::Document& document, const DerivedPart& part) {
  const document::Part* of = document::findPart(document, part.id);
  const document::PictureEntry* entry = of ? document::findPicture(document, document::pictureOf(*of)) : nullptr;
  if (!part.crossesAt || entry == nullptr) return std::nullopt;
  return (*copiesInWorld(*of, entry->size).begin())(*part.crossesAt);
}

mesh::TriMesh worldMesh(const mesh::TriMesh& mesh, const ToWorld& toWorld) {
  mesh::TriMesh out = mesh;
  for (auto& p : out.positions) {
    const WorldPoint w = toWorld(p);
    p = {static_cast<float>(w.x), static_cast<float>(w.y), static_cast<float>(w.z)};
  }
  if (toWorld.flips) {
    for (auto& triangle : out.triangles) std::swap(triangle[1], triangle[2]);
  }
  return out;
}

void include(std::optional<WorldBounds>& bounds, WorldPoint p) {
  if (!bounds) bounds = WorldBounds{p, p};
  WorldPoint& low = bounds->low;
  WorldPoint& high = bounds->high;
  low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
  high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
}

std::optional<WorldBounds> worldBounds(const document::Document& document, const Derived& derived) {
  std::optional<WorldBounds> bounds =
      boundsIf(document, derived, [&](const document::Part& part) { return showsItself(document, derived, part); });
  for (const document::Step& step : document.steps) {
    const DerivedStep* shown = shownSolid(document, derived, step);
    if (shown == nullptr) continue;
    for (const auto& p : shown->solid->mesh.positions) include(bounds, {p[0], p[1], p[2]});
  }
  return bounds;
}

std::optional<WorldBounds> boundsOf(const document::Document& document, const Derived& derived,
                                    std::span<const PartId> parts) {
  return boundsIf(document, derived, [&](const document::Part& part) {
    return isVisible(document, part) && std::ranges::count(parts, part.id) > 0;
  });
}

std::optional<WorldBounds> boundsWithout(const document::Document& document, const Derived& derived,
                                         std::span<const PartId> parts) {
  return boundsIf(document, derived, [&](const document::Part& part) {
    return isVisible(document, part) && std::ranges::count(parts, part.id) == 0;
  });
}

WorldPoint middleOf(const mesh::TriMesh& shape, const WorldFrame& frame) {
  std::optional<WorldBounds> bounds;
  for (const auto& p : shape.positions) include(bounds, frame.toWorld({p[0], p[1], p[2]}));
  return bounds ? bounds->centre() : WorldPoint{};
}

document::Placement standBeside(const document::Document& document, const Derived& derived, PictureId picture,
                                const mesh::TriMesh& shape) {
  const document::PictureEntry* entry = document::findPicture(document, picture);
  if (entry == nullptr || shape.positions.empty()) return {};
  const WorldFrame frame = worldFrame(entry->size);
  const document::Part* first = nullptr;
  for (const document::Part& part : document.parts) {
    if (document::pictureOf(part) != picture) continue;
    if (first == nullptr || part.id < first->id) first = &part;
  }
  const WorldPoint middle = middleOf(shape, frame);
  if (first != nullptr) {
    return first->placement.isRest() ? document::Placement{} : document::about(first->placement, middle);
  }
  const std::optional<WorldBounds> there = worldBounds(document, derived);
  if (!there) return {};
  std::optional<WorldBounds> own;
  for (const auto& p : shape.positions) include(own, frame.toWorld({p[0], p[1], p[2]}));
  document::Placement placement;
  placement.pivot = middle;
  placement.move = {there->high.x + kGap - own->low.x, there->low.y - own->low.y, 0};
  return placement;
}

}  // namespace spineloft::pipeline
