#include "engine/mesh/shading.h"

#include <cmath>

#include "engine/base/groups.h"
#include "engine/base/vec.h"
#include "engine/mesh/angles.h"
#include "engine/mesh/topology.h"

namespace spineloft::mesh {
namespace {

/// What a triangle gives to the normals of its corners.
struct Facet {
  Point normal;
  std::array<double, 3> angles{};
};

std::vector<Facet> facetsOf(const TriMesh& mesh) {
  std::vector<Facet> facets(mesh.triangles.size());
  for (std::size_t t = 0; t < facets.size(); ++t) {
    const Point a = pointAt(mesh, mesh.triangles[t][0]), b = pointAt(mesh, mesh.triangles[t][1]),
                c = pointAt(mesh, mesh.triangles[t][2]);
    const Point normal = cross(b - a, c - a);
    const double twice = norm(normal);
    if (twice > 0) facets[t] = {normal / twice, triangleAngles(a, b, c, twice)};
  }
  return facets;
}

}  // namespace

ShadedMesh shade(const TriMesh& mesh, double creaseAngle) {
  const Twins twins = findTwins(mesh);
  const std::vector<Facet> facets = facetsOf(mesh);
  const double cosine = std::cos(creaseAngle);
  const std::uint32_t corners = static_cast<std::uint32_t>(twins.of.size());
  Groups patches(corners);  // corners (half-edge origins) that share one vertex of the result
  for (std::uint32_t h = 0; h < corners; ++h) {
    const std::uint32_t twin = twins.of[h];
    if (twin == kNone || twin < h) continue;
    if (dot(facets[h / 3].normal, facets[twin / 3].normal) < cosine) continue;
    patches.unite(h, nextHalfEdge(twin));
    patches.unite(nextHalfEdge(h), twin);
  }
  ShadedMesh shaded;
  shaded.triangles.resize(mesh.triangles.size());
  std::vector<std::uint32_t> vertexOf(corners, kNone);
  std::vector<Point> sums;
  // Smooth parts keep their vertices; sharp ones a few times as many.
  for (auto* points : {&shaded.positions, &shaded.normals}) points->reserve(2 * mesh.positions.size());
  if (!mesh.uv.empty()) shaded.uv.reserve(2 * mesh.positions.size());
  sums.reserve(2 * mesh.positions.size());
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const std::uint32_t root = patches.of(corner);
    if (vertexOf[root] == kNone) {
      const std::uint32_t v = cornerVertex(mesh, corner);
      vertexOf[root] = static_cast<std::uint32_t>(shaded.positions.size());
      shaded.positions.push_back(mesh.positions[v]);
      if (!mesh.uv.empty()) shaded.uv.push_back(mesh.uv[v]);
      sums.emplace_back();
    }
    shaded.triangles[corner / 3][corner % 3] = vertexOf[root];
    const Facet& facet = facets[corner / 3];
    sums[vertexOf[root]] += facet.normal * facet.angles[corner % 3];
  }
  shaded.normals.reserve(sums.size());
  for (const Point& sum : sums) {
    const Point n = normalized(sum);
    const bool none = n == Point{} || !isFinite(n);
    shaded.normals.push_back({none ? 0.0f : static_cast<float>(n.x), none ? 0.0f : static_cast<float>(n.y),
                              none ? 1.0f : static_cast<float>(n.z)});
  }
  return shaded;
}

}  // namespace spineloft::mesh
