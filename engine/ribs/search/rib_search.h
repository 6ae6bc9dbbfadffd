// The steps of a search for ribs, for traceRibs and for a stroke under the pen (live_trace.h). Internal
// to ribs/.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/base/result.h"
#include "engine/ribs/ends/end_fan.h"
#include "engine/ribs/evidence/edge_strength.h"
#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/field/curves.h"
#include "engine/ribs/labels/fairing.h"
#include "engine/ribs/labels/medial_offset.h"
#include "engine/ribs/labels/rib_lengths.h"
#include "engine/ribs/labels/runner_up.h"
#include "engine/ribs/search/ribs.h"

namespace spineloft::ribs {

// Everything that one search passes from step to step.
struct RibWorkspace::Search {
  Spine spine;
  RibParams params;
  D2Field field;
  Levels levels;
  GradientCurves curves;
  UnwrappedImage strip;
  BoundaryTerms terms;
  KnownReach known;
  std::vector<float> costs;    // of every curve and level: what the evidence says
  std::vector<float> held;     // the same in the third look, with the ends held to what was found; of ribs
  std::vector<float> support;  // whether there is an edge, 0…1, of every curve and level
  LengthProblem problem;
  LengthWorkspace workspace;
  WidthHypotheses parts;
  LengthLabels labels, trial;
  LengthLabels nearer;                   // of tryOuterHypothesis
  std::vector<float> ownLeft, ownRight;  // costs of the problem, while tryOuterHypothesis has others in it
  EndOutline ends[2];
  std::vector<float> marginals;
  std::vector<RunnerUp> runnersUp;
  SideLengths lengths;
  EdgeStrengths strengths;
  std::vector<float> say;  // what the evidence of a curve counts for in the third look
  FairingMemory fairing;
  std::vector<RibState> states;
  std::array<EndShape, 2> shapes{};       // of the start and the end
  const image::EdgeMap* edges = nullptr;  // of the picture; null where nothing is known of it
  double farthest = 0;                    // levels go no farther, picture pixels
  /// Which even part explains the picture best: each is given its turn.
  struct HypothesisContest {
    double least = std::numeric_limits<double>::infinity();  // energy of `labels`, under `chosen`
    std::size_t chosen = 0, last = 0;                        // numbers of parts
  };
  HypothesisContest contest;
};

using Search = RibWorkspace::Search;

/// A rib end with at least this share of a full edge under it stands on one.
inline constexpr float kOnEdge = 0.5f;

/// Field, levels and curves, which end at `farthest` (picture pixels) at the latest.
/// Errors: those of traceRibs.
Status beginSearch(const Spine& spine, const PictureEvidence& picture, const RibParams& params, double farthest,
                   Search& s);
/// Whether colours are looked at a second time at all.
bool usesColours(const PictureEvidence& picture, const RibParams& params);
/// After the strip was sampled: all evidence but that of colours, and where ends stand on edges.
void findContours(Search& s);
/// After it: the costs of all labels, with the colours close to the spine as the object's.
void firstEvidence(Search& s);
/// From costs (`s.costs`, of every curve and level) to the chain that is to be solved.
void fillProblem(Search& s);
/// The even parts that explain it best: `s.parts`.
void fitWidthHypotheses(Search& s);
/// Holds the opposite ends of each rib to the lean of the part.
void assumeWidth(const WidthHypothesis& even, Search& s);
/// Supposes the `i`-th even part, with its inner colours as the object's where colours count.
void adoptHypothesis(std::size_t i, bool withColours, Search& s);
/// Gives one even part its turn in `s.contest`, which begins as {}: with its inner colours as the
/// object's where they count, for only then the energies of parts can be compared. `s.labels` are those
/// of the best so far.
void tryHypothesis(std::size_t i, bool withColours, Search& s);
/// The labels of least energy under the best of the even parts, which is supposed in the end.
void bestLabels(bool withColours, Search& s);
/// After all parts had their turn, with the chosen one supposed: looks for the best part that reaches farther out on
/// both sides, and for the one after it, and takes the first that, as a whole, differs clearly more in its colours from
/// what is around it, if no great cost speaks against it (farther_part.h).
void tryOuterHypothesis(Search& s);
/// What one rib's energy counts for: less the more ribs there are.
double shareOfRib(const Search& s);
/// Where the third look starts from, of every curve of a rib, into `s.known.inside`: a stiff, robust
/// line through the ends of a side, in which a dent or a bulge of a few ribs leaves little, least where they
/// stand on fainter edges than others near by; and into `s.say` what each curve may say in that look.
void stiffLengths(Search& s);
/// The evidence once more, with the colours inside the part that was found against those around it.
/// Ends are held near to `s.known.inside`, but for dents and bulges, for colours that were learned from
/// a wrong part can lead to a worse one.
void thirdEvidence(Search& s);
/// How strong the edges under the ends of one side are, against others near by (edge_strength.h).
const std::vector<float>& strengthsOf(const std::vector<int>& labels, bool leftSide, Search& s);
/// The ribs of `s.labels` in place of what `set` held, and `s.shapes`; `withRivals`: with confidence and other places.
void readRibs(bool withRivals, Search& s, RibSet& set);
/// The ribs whose ends, and those of the fans, stand at other lengths along their curves (picture pixels, of every
/// curve) than those of `s.labels`, which become the nearest ones; with ends of these shapes, confidence and other
/// places.
void readRibsAt(const std::vector<float>& lengths, std::array<EndShape, 2> shapes, Search& s, RibSet& set);
/// All of it but reading the ribs: `s.labels`.
Status searchLabels(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                    const Progress& progress, Search& s);
/// All of it, start to end: traceRibs.
Status searchRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params, const Progress& progress,
                  Search& s, RibSet& set);

}  // namespace spineloft::ribs
