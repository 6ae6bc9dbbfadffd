// The surface of a stack, ring by ring. Internal to stack/.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::stack {

/// The vertices of a closed curve, counter-clockwise about the way through the stack.
using RingVertices = std::vector<std::uint32_t>;

class Skin {
 public:
  explicit Skin(image::Size picture) : picture_(picture) {}

  std::uint32_t vertex(ModelPoint p);
  /// Quadrilaterals between two rings of equally many points, of which `b` follows `a`; each is cut along its shorter
  /// diagonal. `inwards`: the wall of a hole.
  void strip(const RingVertices& a, const RingVertices& b, bool inwards);
  /// The same between rings of any numbers of points, whose first points belong together: the strip of least total
  /// length of its edges (Fuchs, Kedem and Uselton 1977). Cost: the product of the numbers.
  void zip(const RingVertices& a, const RingVertices& b, bool inwards);
  /// From a ring to a point; `before`: the point comes first.
  void cone(const RingVertices& ring, std::uint32_t tip, bool before);
  /// A flat lid: an outer ring and holes in it, with their points in the plane. False when it cannot be filled.
  struct Rim {
    const RingVertices& ring;
    std::span<const SectionPoint> points;
  };
  bool lid(const Rim& outer, const std::vector<Rim>& holes, bool before);

  /// Where the picture is at a place of the surface, as seen from the front.
  static std::array<float, 2> uvOf(ModelPoint p, image::Size picture);

  std::size_t vertices() const { return mesh_.positions.size(); }
  mesh::TriMesh take() { return std::move(mesh_); }

 private:
  ModelPoint at(std::uint32_t v) const;
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned);

  image::Size picture_;
  mesh::TriMesh mesh_;
};

}  // namespace spineloft::stack
