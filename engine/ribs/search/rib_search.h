// The stages of the search for ribs, used by traceRibs and by a stroke under the pen (live_trace.h). Internal to
// ribs/.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "engine/base/result.h"
#include "engine/ribs/ends/end_fan.h"
#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/field/curves.h"
#include "engine/ribs/labels/fairing.h"
#include "engine/ribs/labels/medial_offset.h"
#include "engine/ribs/labels/rib_lengths.h"
#include "engine/ribs/labels/runner_up.h"
#include "engine/ribs/learned/likelihood.h"
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
  Boundary boundary;
  std::vector<float> prior;  // of every level: what is likely without a picture
  std::vector<float> costs;  // of every curve and level: those of `boundary`, weighed
  LengthProblem problem;
  LengthWorkspace workspace;
  WidthHypotheses parts;
  LengthLabels labels, trial;
  EndOutline ends[2];
  std::vector<float> marginals;
  std::vector<RunnerUp> runnersUp;
  SideLengths lengths;
  FairingMemory fairing;
  std::vector<RibState> states;
  const image::EdgeMap* edges = nullptr;  // of the picture; null where nothing is known of it
};

using Search = RibWorkspace::Search;

/// Field, levels and curves.
/// Errors: those of traceRibs.
Status beginSearch(const Spine& spine, const PictureEvidence& picture, const RibParams& params, Search& s);
/// After the unwrapped image was sampled: what the network says of every label, and its costs. As far as the likely
/// ends are on no edge of the picture, a usual width for the length of the stroke counts instead.
void findEvidence(Search& s);
/// Fills the chain to be solved from `s.costs`.
void fillProblem(Search& s);
/// Finds the width hypotheses that fit the evidence best, into `s.parts`.
void fitWidthHypotheses(Search& s);
/// Sets the opposite costs of `s.problem` to the medial offset and the widths of a hypothesis.
void assumeWidth(const WidthHypothesis& even, Search& s);
/// The labels of least energy over all width hypotheses, into `s.labels`; the best hypothesis is assumed in the end.
void bestLabels(Search& s);
/// Weight of the energy of one rib: 100 over the number of ribs.
double shareOfRib(const Search& s);
/// Reads the ribs of `s.labels` and the ends of the part into `set`. `withRivals`: also confidence and other places.
void readRibs(bool withRivals, Search& s, RibSet& set);
/// The whole search but reading the ribs: fills `s.labels`.
Status searchLabels(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                    const Progress& progress, Search& s);
/// The whole search: traceRibs.
Status searchRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params, const Progress& progress,
                  Search& s, RibSet& set);

}  // namespace spineloft::ribs
