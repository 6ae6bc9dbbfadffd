// Who is next to whom in a triangle mesh. Half-edge h = 3 · triangle + corner runs from that corner
// to the triangle's next one.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// No half-edge.
inline constexpr std::uint32_t kNone = 0xffffffffu;

inline std::uint32_t nextHalfEdge(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
inline std::uint32_t lastHalfEdge(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
inline std::uint32_t cornerVertex(const TriMesh& mesh, std::uint32_t h) { return mesh.triangles[h / 3][h % 3]; }

/// For every half-edge the one half-edge that runs the other way along the same edge; kNone where
/// there is none, or where the edge does not have exactly two triangles in opposite directions. All
/// indices must name vertices. Cost: linear for bounded valence.
struct Twins {
  std::vector<std::uint32_t> of;
  std::size_t edges = 0;  ///< distinct undirected edges
  bool closed = false;    ///< every half-edge has its twin
};
Twins findTwins(const TriMesh& mesh);

}  // namespace spineloft::mesh
