#include "tests/support/plane_cut.h"

#include <array>

namespace spineloft::testing {

double PlaneCut::area() const {
  double twice = 0;
  for (const Segment& s : segments) twice += cross(s.a, s.b);
  return twice / 2;
}

bool PlaneCut::holds(SectionPoint p) const {
  bool inside = false;
  for (const auto& [a, b] : segments) {
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

PlaneCut cutBy(const mesh::TriMesh& mesh, const CutPlane& plane) {
  const ModelPoint normal = cross(plane.x, plane.y);
  struct Corner {
    SectionPoint at;
    double height;
  };
  PlaneCut cut;
  for (const auto& triangle : mesh.triangles) {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto& v = mesh.positions[triangle[k]];
      const ModelPoint off = ModelPoint{v[0], v[1], v[2]} - plane.origin;
      corners[k] = {{dot(off, plane.x), dot(off, plane.y)}, dot(off, normal)};
    }
    PlaneCut::Segment segment;
    int found = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner &p = corners[k], &q = corners[(k + 1) % 3];
      if ((p.height > 0) == (q.height > 0)) continue;
      // An edge that goes down is where the solid's outline, counter-clockwise, leaves the triangle.
      (p.height > 0 ? segment.b : segment.a) = lerp(p.at, q.at, p.height / (p.height - q.height));
      ++found;
    }
    if (found == 2) cut.segments.push_back(segment);
  }
  if (cut.area() < 0) {
    for (PlaneCut::Segment& s : cut.segments) std::swap(s.a, s.b);
  }
  return cut;
}

double overlapShare(const PlaneCut& cut, const std::function<bool(SectionPoint)>& drawn, SectionPoint low,
                    SectionPoint high) {
  constexpr int kGrid = 256;
  int both = 0, either = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const SectionPoint p{low.x + (high.x - low.x) * (i + 0.5) / kGrid, low.y + (high.y - low.y) * (j + 0.5) / kGrid};
      const bool a = cut.holds(p), b = drawn(p);
      both += a && b;
      either += a || b;
    }
  }
  return either == 0 ? 0 : static_cast<double>(both) / either;
}

}  // namespace spineloft::testing
