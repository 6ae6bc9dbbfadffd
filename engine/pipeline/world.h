// From a part to the world: the one way that screen, picking, bounds, solids and files all take.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/document/document.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/pipeline/derive.h"

namespace spineloft::pipeline {

/// ModelSpace → WorldSpace for parts of a picture of this size, where they were traced: the picture's
/// centre goes to the origin and its longer side to length 1. `world = (model − centre) · scale`.
struct WorldFrame {
  double scale = 1;
  ModelPoint centre;
  WorldPoint toWorld(ModelPoint p) const {
    return {(p.x - centre.x) * scale, (p.y - centre.y) * scale, (p.z - centre.z) * scale};
  }
  ModelPoint toModel(WorldPoint p) const {
    return {p.x / scale + centre.x, p.y / scale + centre.y, p.z / scale + centre.z};
  }
};
WorldFrame worldFrame(image::Size picture);

/// ModelSpace → WorldSpace for one copy of a part: `world = linear · (model − origin) + shift`, where
/// `linear` is a turn or a mirror times a scale. Turned and mirrored parts keep their meshes; where
/// `flips`, the triangles' corners run the other way round in the world.
struct ToWorld {
  std::array<double, 9> linear{1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< row by row
  ModelPoint origin;
  WorldPoint shift;
  double scale = 1;  ///< WorldSpace units a ModelSpace unit, > 0
  bool flips = false;

  WorldPoint operator()(ModelPoint p) const;
  WorldPoint operator()(const std::array<float, 3>& p) const { return (*this)(ModelPoint{p[0], p[1], p[2]}); }
  /// Neither turned nor mirrored: only scaled and shifted.
  bool isStraight() const;
  /// A direction, scaled with everything else.
  WorldPoint along(ModelPoint v) const;
  /// The way back.
  ModelPoint toModel(WorldPoint p) const;
  ModelPoint alongInModel(WorldPoint v) const;
};

/// The copies of a part that are seen: itself, and its twin where it has live symmetry.
struct Copies {
  std::array<ToWorld, 2> all;
  std::size_t count = 1;
  const ToWorld* begin() const { return all.data(); }
  const ToWorld* end() const { return all.data() + count; }
};
/// `picture`: size of the picture on which the part was drawn.
Copies copiesInWorld(const document::Placement& placement, const std::optional<document::MirrorPlane>& mirror,
                     image::Size picture);
Copies copiesInWorld(const document::Part& part, image::Size picture);

/// Where a part goes through itself that could not be mended (DerivedPart::crossesAt), on its first copy.
std::optional<WorldPoint> crossingInWorld(const document::Document& document, const DerivedPart& part);

/// The mesh (ModelSpace) in WorldSpace, outward again where the copy flips.
mesh::TriMesh worldMesh(const mesh::TriMesh& mesh, const ToWorld& toWorld);

/// Bounds in WorldSpace.
struct WorldBounds {
  WorldPoint low, high;
  bool operator==(const WorldBounds&) const = default;
  WorldPoint centre() const { return (low + high) / 2; }
};
void include(std::optional<WorldBounds>& bounds, WorldPoint p);
/// Of all visible parts that have a shape; none without one.
std::optional<WorldBounds> worldBounds(const document::Document& document, const Derived& derived);
/// The same of those of `parts`, or of all but those.
std::optional<WorldBounds> boundsOf(const document::Document& document, const Derived& derived,
                                    std::span<const PartId> parts);
std::optional<WorldBounds> boundsWithout(const document::Document& document, const Derived& derived,
                                         std::span<const PartId> parts);

/// Where a part of this picture, traced with this shape, comes to stand: as the first part of its
/// picture stands, so that what was traced together stays together; the first one of a further picture
/// to the right of what is there, on the same ground. The pivot is the middle of the shape as traced.
/// The default for the first part of all, and for a picture that is not there.
document::Placement standBeside(const document::Document& document, const Derived& derived, PictureId picture,
                                const mesh::TriMesh& shape);

/// The middle of a shape as traced: what a part turns and grows about.
WorldPoint middleOf(const mesh::TriMesh& shape, const WorldFrame& frame);

}  // namespace spineloft::pipeline
