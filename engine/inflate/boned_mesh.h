// Triangulations that have the skeleton among their edges.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/geometry/refine.h"
#include "engine/geometry/region.h"
#include "engine/inflate/skeleton.h"

namespace spineloft::inflate {

/// The skeleton as points and edges, spaced as a mesh wants them.
struct Bones {
  std::vector<SkeletonPoint> points;
  std::vector<std::array<std::uint32_t, 2>> edges;
};

struct Boned {
  geometry::PlaneMesh mesh;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< of the skeleton, between points of the mesh
  struct Width {
    double radius = 0;
    Over over = {};
  };
  std::vector<Width> width;  ///< by point of the mesh; radius 0 off the skeleton
};

/// The triangulation of what `rim` bounds with the skeleton in it, whose edges are split where they are none of the
/// mesh. spacing > 0 (pixels): with points so far apart in between, and no edge that joins two corners of the rim
/// across the region; 0: with no others. None when the rim is not simple, or the skeleton not within it.
std::optional<Boned> bonedMesh(const geometry::PlaneRegion& rim, const Bones& bones, double spacing);

/// The same for both ways along an edge.
std::uint64_t edgeKey(std::uint32_t a, std::uint32_t b);

}  // namespace spineloft::inflate
