// A closed mesh that is cut finer without a change of its surface.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "engine/base/vec.h"
#include "engine/mesh/surface_places.h"
#include "engine/mesh/topology.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

class CutMesh {
 public:
  explicit CutMesh(const TriMesh& mesh);

  const TriMesh& mesh() const { return mesh_; }
  TriMesh take() { return std::move(mesh_); }
  std::size_t triangles() const { return mesh_.triangles.size(); }
  ModelPoint at(std::uint32_t vertex) const { return modelPoint(mesh_, vertex); }
  std::uint32_t from(std::uint32_t half) const { return cornerVertex(mesh_, half); }
  std::uint32_t to(std::uint32_t half) const { return from(nextHalfEdge(half)); }
  /// kNone beyond a boundary.
  std::uint32_t twin(std::uint32_t half) const { return twins_[half]; }
  double length(std::uint32_t half) const { return distance(at(from(half)), at(to(half))); }
  /// The longest edge of a triangle; of equally long ones always the same, whichever triangle asks.
  std::uint32_t longest(std::uint32_t triangle) const;
  /// The edge that is the longest one of both its triangles, on the way over longest edges (Rivara 1984): to split it
  /// keeps triangles from getting thin.
  std::uint32_t terminal(std::uint32_t triangle) const;
  /// Twice the area, along the normal.
  ModelPoint areaNormal(std::uint32_t triangle) const { return mesh::areaNormal(mesh_, triangle); }
  /// The place of a triangle nearest to p.
  ModelPoint nearestOn(std::uint32_t triangle, ModelPoint p) const { return mesh::nearestOn(mesh_, triangle, p); }

  /// A vertex on an edge, at `share` 0…1 of the way; both triangles become two. The first half of the edge keeps its
  /// half-edge. The new vertex; kNone where the edge has one triangle only.
  std::uint32_t split(std::uint32_t half, double share);
  /// Moves the vertex that a half-edge begins at by `share` of the way along it, if the surface is smooth there, so
  /// that it stays where it was but for a part of the sag of its facets, and no triangle turns. Whether it did.
  bool slide(std::uint32_t half, double share);
  /// A vertex in a triangle, which becomes three.
  std::uint32_t splitTriangle(std::uint32_t triangle, ModelPoint p);

 private:
  std::uint32_t addVertex(std::uint32_t a, std::uint32_t b, double share);
  void pair(std::uint32_t a, std::uint32_t b);
  /// Two triangles in place of the one of `half`, cut from `middle` of that edge to the corner beyond. The half-edge of
  /// the part behind `middle`.
  std::uint32_t halve(std::uint32_t half, std::uint32_t middle);

  TriMesh mesh_;
  std::vector<std::uint32_t> twins_;
};

}  // namespace spineloft::mesh
