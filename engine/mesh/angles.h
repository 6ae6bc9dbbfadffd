// Corners of triangles and their interior angles, quickly: they only weigh normals. Internal to mesh/.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::mesh {

/// A vertex in whichever space the mesh is in.
using Point = Vec3<struct MeshSpace>;
inline Point pointAt(const TriMesh& mesh, std::uint32_t v) {
  const std::array<float, 3>& p = mesh.positions[v];
  return {p[0], p[1], p[2]};
}

/// Angle in 0…π of the vector (x, y), y ≥ 0, not both 0; within 1e-7 radians. The arctangent is the
/// polynomial of Abramowitz and Stegun, 4.4.49.
inline double quickAngle(double y, double x) {
  const double wide = std::abs(x);
  const double t = std::min(wide, y) / std::max(wide, y), s = t * t;
  double a = 0.0028662257;
  for (const double c :
       {-0.0161657367, 0.0429096138, -0.0752896400, 0.1065626393, -0.1420889944, 0.1999355085, -0.3333314528, 1.0}) {
    a = a * s + c;
  }
  a *= t;
  if (y > wide) a = std::numbers::pi / 2 - a;
  return x < 0 ? std::numbers::pi - a : a;
}

/// The angles at a, b and c, radians; `twiceArea` > 0 is the norm of (b − a) × (c − a).
template <class V>
std::array<double, 3> triangleAngles(V a, V b, V c, double twiceArea) {
  const double atA = quickAngle(twiceArea, dot(b - a, c - a));
  const double atB = quickAngle(twiceArea, dot(c - b, a - b));
  return {atA, atB, std::max(0.0, std::numbers::pi - atA - atB)};
}

}  // namespace spineloft::mesh
