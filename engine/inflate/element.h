// Linear finite elements on a plane triangulation. Internal to inflate/.
#pragma once

#include <array>

#include "engine/geometry/refine.h"

namespace spineloft::inflate {

/// Gradients of the three hat functions of a triangle times twice its area, and that.
struct Element {
  std::array<SectionPoint, 3> gradient;
  double area2 = 0;
  /// ∫ of the product of two gradients: an entry of the stiffness, from cotangents.
  double stiffness(std::size_t i, std::size_t k) const { return dot(gradient[i], gradient[k]) / (2 * area2); }
};
inline Element elementOf(const geometry::PlaneMesh& mesh, const geometry::PlaneMesh::Triangle& t) {
  const auto& points = mesh.points();
  const SectionPoint a = points[t[0]], b = points[t[1]], c = points[t[2]];
  const auto turned = [](SectionPoint v) { return SectionPoint{-v.y, v.x}; };
  return {{turned(c - b), turned(a - c), turned(b - a)}, cross(b - a, c - a)};
}

}  // namespace spineloft::inflate
