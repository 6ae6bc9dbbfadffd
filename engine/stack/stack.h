// Slice by slice: solids through closed curves of true size that stand on planes in space (cross-sections-hughes 3 to
// 4).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/result.h"
#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/stack/stack_params.h"

namespace spineloft::stack {

/// What is stacked, as drawn.
struct Stack {
  const std::vector<Plane>& planes;
  const Rail& rail;
  const StackParams& params;
};

/// How the curves go on. Planes and curves are counted as they are given, from 0; copies of a pattern are as what they
/// copy.
struct Ways {
  /// A curve that becomes one of the plane that follows.
  struct Link {
    std::size_t plane = 0, curve = 0, nextPlane = 0, nextCurve = 0;
    bool operator==(const Link&) const = default;
  };
  /// A curve that parts into several (`up`), or that several of the plane before join into.
  struct Fork {
    std::size_t plane = 0, curve = 0;
    bool up = true;
    double at = 0;  ///< of the first cut: share of the way from the curve to the others, 0…1
    bool operator==(const Fork&) const = default;
  };
  std::vector<Link> links;
  std::vector<Fork> forks;
};

struct Stacked {
  mesh::TriMesh mesh;
  Ways ways;
};

/// The closed solid that goes through every curve where it was drawn. Curves of neighbouring planes become each other,
/// those first that overlap most, one to one, or one to several, or, where links say so, several to several; one
/// without a partner ends at its plane. Holes go with the curve that they are in; one without a partner is a pocket. A
/// closed rail makes a ring; a single plane on an open rail goes from its one end to the other. Which way round a curve
/// is drawn, where it begins, and to which side its plane looks changes nothing.
///
/// Between two curves their best rotation is taken out first and sizes go from one to the other by the blend of the
/// first plane, so that what turns does not shrink; the section in between stands on the rail, else on the cubic
/// through the centres (a straight line with `Linear`). Sections that would cross themselves are replaced by the
/// nearest sound one. Ends are finished as those of lofts; with holes they are flat.
///
/// The mesh is lawful (mesh/laws.h), in ModelSpace, with UV as seen from the front; every curve has about
/// params.sides points. Errors: ValueOutOfRange, StackInvalid with what is wrong, which names sheets and curves as a
/// person counts them. Cost: points × rows, and areSimple of every row.
Result<Stacked> stackPlanes(const Stack& stack, image::Size picture);

}  // namespace spineloft::stack
