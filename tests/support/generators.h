// Shapes for tests: exact ones whose measures are known, and seeded random ones, tame and hostile.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "engine/base/rng.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/ribs/base/rib_set.h"

namespace spineloft::testing {

/// Ribs square to a straight spine from `from` to `to`, `width(t)` wide for t = 0…1.
ribs::RibSet straightRibs(PicturePoint from, PicturePoint to, int count, const std::function<double(double)>& width);

/// Ribs of constant width round a circular arc; angles in radians, screen-clockwise when growing.
ribs::RibSet arcRibs(PicturePoint centre, double radius, double width, double fromAngle, double toAngle, int count);

/// A wandering spine without sharp bends, ribs square to it with a smooth random width, some
/// slanted.
ribs::RibSet randomRibs(Rng& rng);

/// Anything: crossing, swapped, zero-width, coincident, jumping, far away, with wild fans.
ribs::RibSet hostileRibs(Rng& rng);

/// A wandering stroke of `count` points inside a picture of the given size.
std::vector<PicturePoint> randomStroke(Rng& rng, int count, double width, double height);

/// The ribs seen in a mirror along the y axis: x becomes `about` − x and left and right change
/// places.
ribs::RibSet mirrored(const ribs::RibSet& set, double about);

/// An axis-parallel box with 8 vertices and 12 triangles.
mesh::TriMesh box(float width, float height, float depth);

}  // namespace spineloft::testing
