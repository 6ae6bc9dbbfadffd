// How deep every piece lies: one strictly convex program for the whole drawing.
#pragma once

#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/orders.h"
#include "engine/descriptive/patch.h"

namespace spineloft::descriptive {

/// A place of a piece.
struct PiecePlace {
  std::uint32_t piece = 0;
  MeshPlace at;
};
/// Two places of which one is by a known depth nearer than the other: shared lines and touches, and what goes along an
/// axis.
struct Tie {
  PiecePlace one, other;
  double weight = 1;  ///< ties of one shared run sum to 1
  double nearer = 0;  ///< z of one − z of the other, a share of the size
};
/// The depth of a place, as a share of the size.
struct DepthPin {
  PiecePlace at;
  double depth = 0;
};

/// What the program is made of; all outlive the call.
struct DepthInput {
  std::span<const Sheet> sheets;
  std::span<const Piece> pieces;
  std::span<const Patch> patches;
  const Orders& orders;
  std::span<const Tie> ties;
  std::span<const DepthPin> pins;
  DepthScale scale;
};

/// Shares of the drawing's size, at every point of the piece's mesh.
struct PieceDepth {
  std::vector<double> middle;  ///< z, larger is nearer
  std::vector<double> front,
      back;  ///< how far the surfaces are from it along z; 0 on the rim of a round piece (contacts.h)
};

struct DepthStats {
  std::size_t unknowns = 0, rows = 0, active = 0;
  int rounds = 0;
  double broken = 0;     ///< see geometry::QpSolution, shares of the size; more than rounding: the rounds ran out
  bool pinsHold = true;  ///< exactly; else they contradict each other and hold as well as they can
};

struct Depths {
  std::vector<PieceDepth> pieces;
  std::vector<std::uint32_t> conflict;  ///< overlaps whose order cannot hold together with the others and the pins
  DepthStats stats;
};

/// Minimises planarity (planarity.h) + kTieWeight · Σ weight (z_one − z_other − nearer)² over ties + kPull · Σ mean
/// (plane_i − plane_j − D)² over the overlap of i in front of j (kPassingPull where they only pass) + the gauges of
/// patch.h. D is the largest distance that a row of the overlap asks for: pieces come near, none turns without need,
/// and what pulls bends nothing. Subject to, for i over j in an overlap, f and b the distances of front and back from
/// the middle (paper, 9 to 12, with thickness and a gap g = kGap):
///   outline of i:  z_i − z_j ≥ f_j + g           outline of j:  z_i − z_j ≥ b_i + g
///   points of both meshes, and crossings of their edges:  z_i − z_j ≥ max(f_j − f_i, b_i − b_j) + g / 2
/// The surfaces are linear between these, so that what is drawn in front is in front everywhere in an overlap, seen
/// from both sides, while bulges sink into each other. Where i goes inside j, the outline of i is before the front of j
/// while seen, between its surfaces while hidden. Rows are made when they are broken. Pins hold exactly; orders that
/// contradict them or each other get a slack and are named. Thickness along z follows the slope of the middle: it is
/// solved twice. Errors: those of solveQp.
Result<Depths> solveDepths(const DepthInput& input);

inline constexpr double kGap = 0.0015, kPull = 1e-3, kPassingPull = 1e-6, kTieWeight = 1e3;
/// Of the tie along an axis: 10 in all, beside a planarity of 8.
inline constexpr double kAxisTie = 0.01;
/// Of the tie of a touch: 10⁻⁷ in all, far weaker than what holds pieces upright, since lines touch by chance too.
inline constexpr double kTouchWeight = 1e-10;
inline constexpr double kMostTilt = 3;        ///< thickness along z grows by no more
inline constexpr double kLeastThick = 0.002;  ///< front + back at inner points, as a share of the size

}  // namespace spineloft::descriptive
