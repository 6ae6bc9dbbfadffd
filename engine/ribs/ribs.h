// Ribs: what one stroke finds in a picture.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/image/edge_map.h"
#include "engine/ribs/fairing.h"
#include "engine/ribs/spine.h"
#include "engine/ribs/workspace.h"

namespace spineloft::ribs {

/// How sure a rib end is of its place.
enum class RibState : std::uint8_t {
  Edge,     ///< it stands on an edge of the picture
  Bridged,  ///< no edge here, but its neighbours on both sides found one
  Guessed,  ///< no edge nearby: taken from the other side, or from a default width
  Edited,   ///< put there by hand (edits.h)
  Locked,   ///< put there by hand, and later edits near by leave it
};

/// The state in files and in the API: "edge", "bridged", "guessed", "edited" or "locked".
std::string_view ribStateKey(RibState state);

/// Other places where an end might stand: the next-best labels of the optimiser, best first, apart
/// from each other and from the chosen one. Picture pixels.
struct OtherPlaces {
  std::array<PicturePoint, 3> at{};
  int count = 0;
  bool operator==(const OtherPlaces&) const = default;
};

/// One rib: two end points on opposite sides of the spine. Picture pixels. `left` is the side to
/// the left of the drawing direction as seen on the screen. The polyline from `center` to an end
/// along the gradient curve is not kept: seen from the front only the ends matter.
struct Rib {
  PicturePoint center;  ///< on the spine
  PicturePoint left, right;
  RibState leftState = RibState::Guessed, rightState = RibState::Guessed;
  double leftLevel = 0, rightLevel = 0;  ///< d2 at the ends, picture pixels
  /// Margin to the next-best place, 0 (a toss-up) … 1 (no rival).
  double leftConfidence = 0, rightConfidence = 0;
  OtherPlaces leftOthers = {}, rightOthers = {};
  bool operator==(const Rib&) const = default;
};

/// A scribble over edges that are not to count. Picture pixels.
struct IgnoreMark {
  std::vector<PicturePoint> stroke;  ///< ≥ 1 point
  double radius = 8;                 ///< 0.5…500
  bool covers = false;               ///< what is under it is another thing, whose colours no part wears
  bool operator==(const IgnoreMark&) const = default;
};
inline constexpr std::size_t kMostIgnoreMarks = 500;

/// The ends of the fan of gradient curves around one end of the spine, from the left rib's side
/// round to the right's: the outline of a round cap. Empty when the fan was not traced. Picture
/// pixels.
struct EndFan {
  std::vector<PicturePoint> points;
  bool operator==(const EndFan&) const = default;
};

/// The energy of SpineLoft 3.3.2 by term, summed over all ribs (dimensionless).
struct EnergyTerms {
  double distance = 0, neighbour = 0, opposite = 0, prior = 0;
  double total() const { return distance + neighbour + opposite + prior; }
  bool operator==(const EnergyTerms&) const = default;
};

/// Ribs in order along the spine, and the fans around its first and last point.
struct RibSet {
  std::vector<Rib> ribs;
  EndFan startFan, endFan;
  EnergyTerms energy;
  bool operator==(const RibSet&) const = default;
};

/// Which evidence counts how much; a weight of 0 switches a term off. The terms are those of
/// evidence.h; the weights are the maximum-likelihood ones of a softmax over the labels of single
/// curves against true outlines, checked by leaving one category of pictures out.
struct EvidenceParams {
  double proximityWeight = 2.2;  ///< nearness to a Canny edge (the paper's only evidence), 0…10
  double contrastWeight = 3.2;   ///< contrast across the contour, coherent along it, 0…10
  double localContrastWeight = 1.2;  ///< the same, against the contrasts near by, 0…10
  double beyondWeight = 0.55;        ///< against edges further out, 0…10
  double insideWeight = 0.75;        ///< against colours foreign to the spine inside, 0…10
  double outsideWeight = 1.4;        ///< for colours foreign to the spine outside, 0…10
  /// For colours that change here, once those around the object are known; 0…10, 0: no third look.
  double rimWeight = 0.3;
  double contrastReach = 2;  ///< half-length over which contrast is taken, map pixels, 0.5…20
  /// Share of the best even part's half width whose colours count as the object's in a second look;
  /// 0 (no second look) … 0.9.
  double knownShare = 0.5;
  double doubt = 0.3;   ///< chance given to a curve being misled, 0.001…10
  double weight = 0.3;  ///< of all evidence against the shape terms, 0…10
  bool operator==(const EvidenceParams&) const = default;
};

/// Everything the search can be told; a RibSet depends on nothing else. Weights are as for 100 ribs:
/// with more of them each counts for less, so that the part does not depend on their number. The defaults are the ones
/// the benchmark measures.
struct RibParams {
  int levels = 128;            ///< K: labels of the dynamic programme, 16…512
  double maxLevelShare = 0.5;  ///< largest d2 level as a share of the picture's diagonal, 0.01…1
  double neighbourWeight = 0.7;  ///< SpineLoft 3.3.2: 3 (on d2; ours compares arc lengths), 0…100
  double neighbourFreedom =
      0.1;  ///< free slope between neighbours, SpineLoft 3.3.2: ¼ (on d2), 0…10
  double neighbourCap = 8.0;  ///< most that one jump between neighbours costs, 0.01…1000
  /// Against unequal opposite ribs, once the lean of the stroke is known (lean.h). SpineLoft 3.3.2:
  /// 0.25, without a lean. 0…100
  double oppositeWeight = 1.0;
  double leanCost = 0.1;  ///< of a stroke being off the middle, per rib, 0…10
  double priorWeight =
      0.02;  ///< pull of flat energy to a middle level (method: measurements), 0…10
  EvidenceParams evidence = {};
  FairingParams fairing = {};
  bool operator==(const RibParams&) const = default;
};

/// Every value finite and in its range.
bool inRange(const RibParams& params);

struct IgnoredEdges;

/// What a picture shows. References must outlive the call.
struct PictureEvidence {
  const image::EdgeMap& edges;  ///< may be empty: no picture, or nothing known of it yet
  image::Size size;             ///< of the picture, pixels
  const IgnoredEdges* ignored = nullptr;  ///< edges scribbled away (ignored.h), of the same map
};

/// Gradient curves from the hull of the spine, the evidence along them, and the exact optimum of
/// the energy by dynamic programming (method: "Gradient curves", "Rib lengths"). Without
/// edges every end is Guessed at a default width; under ignored ones the picture says nothing. Output coordinates are picture
/// pixels, at most half a pixel outside the picture; ribs of one side never cross each other.
/// Errors: StrokeTooShort (fewer than 2 points), ValueOutOfRange (params), Cancelled.
Result<RibSet> traceRibs(const Spine& spine, const PictureEvidence& picture,
                         const RibParams& params, const Progress& progress);
/// The same with memory that is reused from call to call: for the pen.
Result<RibSet> traceRibs(const Spine& spine, const PictureEvidence& picture,
                         const RibParams& params, const Progress& progress, RibWorkspace& memory);
/// The same with nothing ignored.
inline Result<RibSet> traceRibs(const Spine& spine, const image::EdgeMap& edges,
                                image::Size picture, const RibParams& params,
                                const Progress& progress) {
  return traceRibs(spine, PictureEvidence{edges, picture}, params, progress);
}

}  // namespace spineloft::ribs
