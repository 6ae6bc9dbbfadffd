// What a plane cuts out of a closed mesh, straight from its triangles: an oracle for solids through given sections.
#pragma once

#include <functional>
#include <vector>

#include "engine/base/vec.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::testing {

/// A plane with two unit directions in it, square to each other.
struct CutPlane {
  ModelPoint origin, x, y;
};

/// The cut as segments in plane coordinates, with the solid on their left seen against x × y. No vertex lies in the
/// plane, where a test wants to be exact.
struct PlaneCut {
  struct Segment {
    SectionPoint a, b;
  };
  std::vector<Segment> segments;

  double area() const;
  bool holds(SectionPoint p) const;  ///< by even-odd
};
PlaneCut cutBy(const mesh::TriMesh& mesh, const CutPlane& plane);

/// Area in both over area in either, of the cut and of what `drawn` says, from a grid of 256² points over the box.
double overlapShare(const PlaneCut& cut, const std::function<bool(SectionPoint)>& drawn, SectionPoint low,
                    SectionPoint high);

}  // namespace spineloft::testing
