// Rounding a crease: the surface about it is made fair (Botsch and Kobbelt 2004), the less the farther away.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// The region of a vertex that stays.
inline constexpr std::uint32_t kFixed = 0xffffffffu;

/// Where a surface is to be rounded.
struct Crease {
  std::vector<std::uint32_t> vertices;  ///< the crease runs through them
  std::uint32_t region = 0;             ///< whose sharp edges it takes in; 0: none
  double reach = 0;                     ///< along the surface, the mesh's units, > 0: what is farther away stays
};

/// Rounds a closed mesh. Edges near a crease that are longer than 0.35 of its reach are split first, and once more
/// those of triangles near a crease that would still meet at more than 30°, so that new vertices and triangles may come
/// behind those that there are, with texture coordinates from between. `regions`, one a vertex, grows with the mesh:
/// kFixed, or any number. New vertices are in the region of both their neighbours, or of the one that is neither fixed
/// nor 0.
///
/// A crease takes in the sharp edges (15°) of its region. For one after the other, what is within reach and not fixed
/// minimises Σ |(L x)ᵢ|²/Mᵢ + Σ μⱼ |xⱼ − x⁰ⱼ|², L the cotangent Laplacian of the mesh as it was, M a third of the
/// triangles' areas, μ = 400 (d/ρ)⁴ M/ρ⁴, d the way to the crease along edges and ρ the reach; the sum leaves out
/// vertices on sharp edges (60°) between fixed ones, as of a flat end, over which nothing goes on smoothly. It does not
/// look whether the surface goes through itself then (self_crossing.h). Cost: sparse Cholesky factorisations, one or
/// two a crease.
void soften(TriMesh& mesh, std::vector<Crease> creases, std::vector<std::uint32_t>& regions);

}  // namespace spineloft::mesh
