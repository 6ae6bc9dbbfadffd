#include "engine/mesh/shading.h"

#include <cmath>
#include <numeric>

#include "engine/base/vec.h"
#include "engine/mesh/topology.h"

namespace spineloft::mesh {
namespace {

using Point = Vec3<struct MeshSpace>;

Point pointAt(const TriMesh& mesh, std::uint32_t v) {
  const std::array<float, 3>& p = mesh.positions[v];
  return {p[0], p[1], p[2]};
}

std::vector<Point> triangleNormals(const TriMesh& mesh) {
  std::vector<Point> normals(mesh.triangles.size());
  for (std::size_t t = 0; t < normals.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point origin = pointAt(mesh, a);
    normals[t] = normalized(cross(pointAt(mesh, b) - origin, pointAt(mesh, c) - origin));
  }
  return normals;
}

/// Corners (half-edge origins) that share one vertex of the result, as a union-find forest.
class Patches {
 public:
  explicit Patches(std::size_t corners) : parent_(corners) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t root(std::uint32_t corner) {
    while (parent_[corner] != corner) corner = parent_[corner] = parent_[parent_[corner]];
    return corner;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t ra = root(a), rb = root(b);
    if (ra < rb) {
      parent_[rb] = ra;
    } else {
      parent_[ra] = rb;
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Interior angle of a triangle at a corner, radians.
double angleAt(const TriMesh& mesh, std::uint32_t corner) {
  const Point p = pointAt(mesh, cornerVertex(mesh, corner));
  const Point a = pointAt(mesh, cornerVertex(mesh, nextHalfEdge(corner))) - p;
  const Point b = pointAt(mesh, cornerVertex(mesh, lastHalfEdge(corner))) - p;
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

}  // namespace

ShadedMesh shade(const TriMesh& mesh, double creaseAngle) {
  const Twins twins = findTwins(mesh);
  const std::vector<Point> normals = triangleNormals(mesh);
  const double cosine = std::cos(creaseAngle);
  const std::uint32_t corners = static_cast<std::uint32_t>(twins.of.size());
  Patches patches(corners);
  for (std::uint32_t h = 0; h < corners; ++h) {
    const std::uint32_t twin = twins.of[h];
    if (twin == kNone || twin < h || dot(normals[h / 3], normals[twin / 3]) < cosine) continue;
    patches.join(h, nextHalfEdge(twin));
    patches.join(nextHalfEdge(h), twin);
  }
  ShadedMesh shaded;
  shaded.triangles.resize(mesh.triangles.size());
  std::vector<std::uint32_t> vertexOf(corners, kNone);
  std::vector<Point> sums;
  for (std::uint32_t corner = 0; corner < corners; ++corner) {
    const std::uint32_t root = patches.root(corner);
    if (vertexOf[root] == kNone) {
      const std::uint32_t v = cornerVertex(mesh, corner);
      vertexOf[root] = static_cast<std::uint32_t>(shaded.positions.size());
      shaded.positions.push_back(mesh.positions[v]);
      if (!mesh.uv.empty()) shaded.uv.push_back(mesh.uv[v]);
      sums.emplace_back();
    }
    shaded.triangles[corner / 3][corner % 3] = vertexOf[root];
    sums[vertexOf[root]] += normals[corner / 3] * angleAt(mesh, corner);
  }
  shaded.normals.reserve(sums.size());
  for (const Point& sum : sums) {
    const Point n = normalized(sum);
    const bool none = n == Point{} || !isFinite(n);
    shaded.normals.push_back({none ? 0.0f : static_cast<float>(n.x),
                              none ? 0.0f : static_cast<float>(n.y),
                              none ? 1.0f : static_cast<float>(n.z)});
  }
  return shaded;
}

}  // namespace spineloft::mesh
