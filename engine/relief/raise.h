// Moves the front of a mesh by heights.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/relief/front.h"

namespace spineloft::relief {

/// A mesh that is fine enough for heights, and where its vertices go.
struct Raised {
  mesh::TriMesh mesh;  ///< the surface as it was, with more triangles where the heights bend
  struct Moved {
    std::uint32_t vertex = 0;
    ModelPoint normal;   ///< unit
    double rise = 0;     ///< along it, −1 … 1 of the height
    double deepest = 0;  ///< ModelSpace: no farther inwards, so that a wall stays
  };
  std::vector<Moved> moved;
  double size = 0;  ///< ModelSpace: what the height is a share of
};

/// Of a mesh that is made finer: at most so many, as it is kept and under a hand that moves.
inline constexpr std::size_t kMostTriangles = 60000, kLiveTriangles = 12000;

/// `heights`: one a cell of the front of this surface, whose mesh is closed. Splits edges where heights bend, those
/// first that are farthest off, until they are 1.5 cells long or less than 4 % of the height off, or there are `most`
/// triangles. What lies behind another place of the front stays.
Raised raisedBy(const Surface& surface, const Front& front, const Values& heights, std::size_t most = kMostTriangles);

/// Moves it by `height` of its size, all of the way, whatever becomes of it. Cost: that of a copy.
void moveMesh(const Raised& raised, double height, mesh::TriMesh& out);
/// The same, less where it would go through itself, as a pull does. What was kept: 1 … 0. Cost: that of
/// mesh::selfCrossing.
double raiseMesh(const Raised& raised, double height, mesh::TriMesh& out);

std::size_t bytesOf(const Raised& raised);

}  // namespace spineloft::relief
