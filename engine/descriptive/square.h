// How deep the corners of a drawn solid lie, from right angles between its edges, or as a prism (prism.h).
#pragma once

#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/wireframe.h"

namespace spineloft::descriptive {

/// A solid between plane faces.
struct FacedSolid {
  std::vector<ModelPoint> corners;     ///< shares of the size, y up, in the order of Wireframe::corners; mean z is 0
  std::vector<Wireframe::Face> faces;  ///< those of the wireframe
  ModelPoint up;                       ///< of length 1: off the face that is its base, see squared()
  double moved = 0;                    ///< how far a corner is from where it was drawn, the most, a share of the size
  double offPlane = 0;                 ///< how far a corner is from the plane of a face, the most
};

/// Edges are clustered by their direction in the picture; those that meet at a corner are never of one. Of all three
/// directions that can be those of a right-angled corner (axes.h) those count that meet at most corners, then those
/// with most edges; where that is a third of the corners or less and the solid is a prism, see prism.h. Depths are
/// those of least squares with these slopes, with edges of one other direction parallel and faces plane; what is seen
/// is in front. Then corners move so that every face is exactly a plane and edges keep their axes: Σ(Δx² + Δy² +
/// Δz²/20) + 9 Σ|(I − a aᵀ)(X_b − X_a)|² is least, a the orthonormal axes, fitted anew in each of at most kMostRounds
/// steps of Gauss and Newton. Up is the axis that is most upright in the picture, and exactly off the face below where
/// one lies within 20° across it. Errors: ShapeInvalid where no three directions are right-angled and it is no prism,
/// or faces that cannot be planes.
Result<FacedSolid> squared(const Wireframe& wireframe, const DepthScale& scale);

/// Of length 1, outwards: of the plane that fits the face.
ModelPoint normalOf(const FacedSolid& solid, const Wireframe::Face& face);

/// The depth of the corner that was drawn at p, or else of the edge that is nearest to it, there; all in shares of the
/// size.
double depthOnEdge(const FacedSolid& solid, SectionPoint p);

/// Whether it is such a solid: no corner has to move by more than kMostMoved.
bool isSquare(const Wireframe& wireframe, double size);

inline constexpr double kMostMoved = 0.06;
inline constexpr int kMostRounds = 40;

}  // namespace spineloft::descriptive
