// Filling closed polygons with triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// Triangles (indices of corners, counter-clockwise) that fill a simple counter-clockwise polygon
/// of n corners using every corner and no other point: n − 2 of them, none without area, also where
/// corners lie on straight stretches. Empty when the polygon is not simple or has no area.
/// Ear clipping that prefers well-shaped ears (Meisters 1975: a simple polygon always has two
/// ears). Cost: O(n log n) when convex; every corner clipped looks at the reflex corners.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const SectionPoint> polygon);

/// The same for several polygons, some with holes: outer polygons counter-clockwise, holes clockwise
/// and in the smallest outer one round them, all together simple (areSimple). `sizes`: corners of each, one
/// after the other in `points`. Holes are joined to their outer polygon by a bridge, seen from the
/// rightmost corner (Eberly 2002); per outer polygon with h holes: corners + 2 h − 2 triangles.
std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const SectionPoint> points,
                                                      std::span<const std::size_t> sizes);

}  // namespace spineloft::geometry
