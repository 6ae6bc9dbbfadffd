// The height of an inflated region: the Poisson equation on its triangulation.
#pragma once

#include <vector>

#include "engine/geometry/refine.h"

namespace spineloft::inflate {

/// u at every point of the mesh with −Δu = 4 inside and u = 0 on the rim, by linear finite elements
/// (stiffness from cotangents) and a sparse Cholesky factorisation: √u of a circle is a half sphere.
/// Never negative. Square units of the mesh. Empty when the factorisation fails.
std::vector<double> poissonHeight(const geometry::PlaneMesh& mesh);

/// Of every corner of the rim: ρ with h = √u ≈ √(2 ρ d) at the distance d from it, the radius of the
/// swollen rim: half the slope of u there.
std::vector<double> rimRadii(const geometry::PlaneMesh& mesh, const std::vector<double>& u);

/// u between the points; 0 outside.
double valueAt(const geometry::PlaneMesh& mesh, const std::vector<double>& u, SectionPoint p);

}  // namespace spineloft::inflate
