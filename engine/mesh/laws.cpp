#include "engine/mesh/laws.h"

#include <algorithm>
#include <cmath>

#include "engine/base/groups.h"
#include "engine/mesh/angles.h"
#include "engine/mesh/topology.h"

namespace spineloft::mesh {
namespace {

bool allFinite(const TriMesh& mesh) {
  const auto finite = [](const auto& p) {
    return std::all_of(p.begin(), p.end(), [](float c) { return std::isfinite(c); });
  };
  return std::all_of(mesh.positions.begin(), mesh.positions.end(), finite) &&
         std::all_of(mesh.uv.begin(), mesh.uv.end(), finite);
}

bool indicesNameVertices(const TriMesh& mesh) {
  return std::all_of(mesh.triangles.begin(), mesh.triangles.end(), [&](const auto& t) {
    return std::all_of(t.begin(), t.end(), [&](std::uint32_t v) { return v < mesh.positions.size(); });
  });
}

bool allVerticesUsed(const TriMesh& mesh) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) used[v] = true;
  }
  return std::all_of(used.begin(), used.end(), [](bool u) { return u; });
}

/// The triangles round each vertex are one closed fan.
bool fansAreWhole(const TriMesh& mesh, const Twins& twins) {
  std::vector<std::uint32_t> valence(mesh.positions.size(), 0), first(mesh.positions.size(), kNone);
  const std::uint32_t count = static_cast<std::uint32_t>(twins.of.size());
  for (std::uint32_t h = 0; h < count; ++h) {
    const std::uint32_t v = cornerVertex(mesh, h);
    ++valence[v];
    first[v] = h;
  }
  for (std::size_t v = 0; v < first.size(); ++v) {
    if (first[v] == kNone) continue;
    std::uint32_t steps = 0, h = first[v];
    do {
      h = twins.of[lastHalfEdge(h)];
      ++steps;
    } while (h != first[v] && steps <= valence[v]);
    if (steps != valence[v]) return false;
  }
  return true;
}

int countShells(const TriMesh& mesh) {
  Groups groups(mesh.positions.size());
  std::vector<bool> used(mesh.positions.size(), false);
  for (const auto& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      used[v] = true;
      groups.unite(v, t[0]);
    }
  }
  int shells = 0;
  for (std::uint32_t v = 0; v < used.size(); ++v) shells += used[v] && groups.of(v) == v;
  return shells;
}

void measure(const TriMesh& mesh, MeshReport& report) {
  const Bounds bounds = boundsOf(mesh);
  const auto& low = bounds.low;
  const auto& high = bounds.high;
  const Point centre{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2};
  const Point diagonal{high[0] - low[0], high[1] - low[1], high[2] - low[2]};
  const double least = kDegenerateArea * dot(diagonal, diagonal);
  report.noDegenerate = true;
  for (const auto& t : mesh.triangles) {
    const Point a = pointAt(mesh, t[0]) - centre, b = pointAt(mesh, t[1]) - centre, c = pointAt(mesh, t[2]) - centre;
    const double area = norm(cross(b - a, c - a)) / 2;
    if (!(area >= least) || area == 0) report.noDegenerate = false;
    report.area += area;
    report.volume += dot(a, cross(b, c)) / 6;
  }
  report.outward = report.volume > 0;
}

}  // namespace

MeshReport inspect(const TriMesh& mesh) {
  MeshReport report;
  report.finite = allFinite(mesh);
  report.uvInRange = mesh.uv.empty() || (mesh.uv.size() == mesh.positions.size() &&
                                         std::all_of(mesh.uv.begin(), mesh.uv.end(), [](const auto& uv) {
                                           return uv[0] >= 0 && uv[0] <= 1 && uv[1] >= 0 && uv[1] <= 1;
                                         }));
  if (!indicesNameVertices(mesh) || mesh.triangles.empty()) return report;
  report.indexed = allVerticesUsed(mesh);
  const Twins twins = findTwins(mesh);
  report.closed = twins.closed;
  report.manifold = twins.closed && fansAreWhole(mesh, twins);
  report.shells = countShells(mesh);
  const auto euler = static_cast<long long>(mesh.positions.size()) - static_cast<long long>(twins.edges) +
                     static_cast<long long>(mesh.triangles.size());
  report.genus = static_cast<int>(report.shells - euler / 2);
  if (report.finite) measure(mesh, report);
  return report;
}

std::string brokenLaw(const MeshReport& report) {
  if (!report.finite) return "a coordinate is not a finite number";
  if (!report.indexed) return "an index names no vertex, or a vertex is not used";
  if (!report.closed) return "an edge does not have exactly two triangles in opposite directions";
  if (!report.manifold) return "the triangles round a vertex do not form one fan";
  if (!report.noDegenerate) return "a triangle has no area";
  if (!report.outward) return "the surface faces inwards";
  if (!report.uvInRange) return "a texture coordinate is missing or outside the picture";
  return {};
}

std::vector<std::array<float, 3>> vertexNormals(const TriMesh& mesh) {
  std::vector<Point> sums(mesh.positions.size());
  for (const auto& t : mesh.triangles) {
    const std::array<Point, 3> p = {pointAt(mesh, t[0]), pointAt(mesh, t[1]), pointAt(mesh, t[2])};
    const Point normal = cross(p[1] - p[0], p[2] - p[0]);
    const double twice = norm(normal);
    if (!(twice > 0)) continue;
    const std::array<double, 3> angles = triangleAngles(p[0], p[1], p[2], twice);
    for (std::size_t c = 0; c < 3; ++c) sums[t[c]] += normal * (angles[c] / twice);
  }
  std::vector<std::array<float, 3>> normals(sums.size());
  for (std::size_t v = 0; v < sums.size(); ++v) {
    const Point n = normalized(sums[v]);
    normals[v] = n == Point{} || !isFinite(n)
                     ? std::array<float, 3>{0, 0, 1}
                     : std::array<float, 3>{static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z)};
  }
  return normals;
}

Bounds boundsOf(const TriMesh& mesh) {
  Bounds bounds;
  if (mesh.positions.empty()) return bounds;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounds.low[axis] = bounds.high[axis] = mesh.positions[0][axis];
  }
  for (const auto& p : mesh.positions) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      bounds.low[axis] = std::min<double>(bounds.low[axis], p[axis]);
      bounds.high[axis] = std::max<double>(bounds.high[axis], p[axis]);
    }
  }
  return bounds;
}

}  // namespace spineloft::mesh
