// The laws that every mesh of ours obeys, as predicates, and measures of a mesh.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// What is true of a mesh. Cost: O(triangles log triangles).
struct MeshReport {
  bool finite = false;          ///< every coordinate is a finite number
  bool indexed = false;         ///< every index names a vertex, and every vertex is used
  bool closed = false;          ///< every edge has exactly two triangles, in opposite directions
  bool manifold = false;        ///< and the triangles round each vertex form one fan
  bool outward = false;         ///< the signed volume is positive
  bool noDegenerate = false;    ///< no triangle with two equal corners or an area below `kDegenerateArea`
                                ///< of the bounding box's squared diagonal
  bool uvInRange = false;       ///< no UV, or one a vertex and all within [0, 1]
  int shells = 0;               ///< connected components
  int genus = 0;                ///< total over the shells, from the Euler number; meaningful when closed
  double volume = 0, area = 0;  ///< in the mesh's units
  bool valid() const { return finite && indexed && closed && manifold && outward && noDegenerate && uvInRange; }
};

/// Smallest triangle area, as a share of the squared diagonal of the bounding box.
inline constexpr double kDegenerateArea = 1e-14;

MeshReport inspect(const TriMesh& mesh);

/// In words, the first law that is broken; empty when lawful.
std::string brokenLaw(const MeshReport& report);

/// Angle-weighted unit normals, one a vertex. Vertices without area get +z.
std::vector<std::array<float, 3>> vertexNormals(const TriMesh& mesh);

/// Axis-aligned bounds; {0,0,0} twice for an empty mesh.
struct Bounds {
  std::array<double, 3> low{}, high{};
  bool operator==(const Bounds&) const = default;
};
Bounds boundsOf(const TriMesh& mesh);

}  // namespace spineloft::mesh
