// The stages of the search for ribs, used by traceRibs and by a stroke under the pen (live_trace.h). Internal to
// ribs/.
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
  std::vector<float> costs;    // of every curve and level, from the evidence
  std::vector<float> held;     // the regularised costs of pass 3 (thirdEvidence), of the curves of ribs
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
  std::vector<float> say;  // weight of the evidence of every curve in pass 3
  FairingMemory fairing;
  std::vector<RibState> states;
  std::array<EndShape, 2> shapes{};       // of the start and the end
  const image::EdgeMap* edges = nullptr;  // of the picture; null where nothing is known of it
  double farthest = 0;                    // levels go no farther, picture pixels
  /// The competition between the width hypotheses.
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
/// Whether the search makes pass 2, which uses colours.
bool usesColours(const PictureEvidence& picture, const RibParams& params);
/// After the unwrapped image was sampled: computes all evidence but the colour terms, and which labels lie on edges.
void findContours(Search& s);
/// Pass 1, after findContours: the costs of all labels. Only the colours close to the spine count as the object.
void firstEvidence(Search& s);
/// Fills the chain to be solved from `s.costs`.
void fillProblem(Search& s);
/// Finds the width hypotheses that fit the evidence best, into `s.parts`.
void fitWidthHypotheses(Search& s);
/// Sets the opposite costs of `s.problem` to the medial offset and the widths of a hypothesis.
void assumeWidth(const WidthHypothesis& even, Search& s);
/// Assumes width hypothesis `i`, with its inner colours as the object's where colours count.
void adoptHypothesis(std::size_t i, bool withColours, Search& s);
/// Pass 2 for hypothesis `i`: solves the chain with its inner colours as the object's (where colours count: only then
/// are the energies of hypotheses comparable). Keeps the labels in `s.labels` if their energy is the least so far.
/// `s.contest` starts as {}.
void tryHypothesis(std::size_t i, bool withColours, Search& s);
/// The labels of least energy over all width hypotheses; the best hypothesis is assumed in the end.
void bestLabels(bool withColours, Search& s);
/// Call after tryHypothesis for all hypotheses, with the best one assumed. Searches the best part that is farther out
/// on both sides, then the next one beyond it. Takes the first whose colours as a whole differ clearly more from
/// those around it, at a bounded cost (outer_hypothesis.h).
void tryOuterHypothesis(Search& s);
/// Weight of the energy of one rib: 100 over the number of ribs.
double shareOfRib(const Search& s);
/// The start of pass 3: fits a stiff, robust line through the ends of each side, into `s.known.inside` (of every
/// curve of a rib). Dents and bulges of a few ribs have little influence on it, least where their edges are weaker
/// than those near by. The weights of the curves go into `s.say`.
void stiffLengths(Search& s);
/// Pass 3: the evidence with the colours inside the part found so far against those around it. Each end is held near
/// `s.known.inside`, because colours learned from a wrong part can lead to a worse one.
void thirdEvidence(Search& s);
/// Strength of the edges under the ends of one side, relative to those near by (edge_strength.h).
const std::vector<float>& strengthsOf(const std::vector<int>& labels, bool leftSide, Search& s);
/// Reads the ribs of `s.labels` into `set`, and the shapes of the ends into `s.shapes`. `withRivals`: also confidence
/// and other places.
void readRibs(bool withRivals, Search& s, RibSet& set);
/// Reads ribs whose ends stand at the given lengths (picture pixels, of every curve, fans included) instead of at
/// `s.labels`, which become the nearest labels. The ends have the given shapes. With confidence and other places.
void readRibsAt(const std::vector<float>& lengths, std::array<EndShape, 2> shapes, Search& s, RibSet& set);
/// The whole search but reading the ribs: fills `s.labels`.
Status searchLabels(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                    const Progress& progress, Search& s);
/// The whole search: traceRibs.
Status searchRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params, const Progress& progress,
                  Search& s, RibSet& set);

}  // namespace spineloft::ribs
