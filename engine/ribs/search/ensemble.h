// Ribs on which several hands agree. A hand wanders, and a search from one stroke may take an accident of it
// for the thing: what slightly different strokes through the same thing find tells which of the ends are the thing's.
#pragma once

#include <memory>

#include "engine/ribs/search/ribs.h"

namespace spineloft::ribs {

/// traceRibs, and again for six perturbed strokes: beside the stroke by an eighth and a quarter of the width, and from
/// further in or out at the ends. Every end, those of the fans too, comes to stand where half of the outlines have
/// been left on its gradient curve; each counts for as much as it agrees with the others (mean ratio of lengths, to
/// the third power); a fan's ends are medians of five neighbours. Confidence is that of the stroke's own search. As
/// long as seven searches of at most 100 ribs. Where nothing is known of the picture, and for fewer than four ribs, it
/// is traceRibs. Its laws and errors.
Result<RibSet> ensembleRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                            const Progress& progress, RibWorkspace& memory);

/// ensembleRibs in steps of one search each, so that a page is drawn in between. Any thread may take the next step.
class EnsembleTrace {
 public:
  EnsembleTrace(Spine spine, const RibParams& params);
  ~EnsembleTrace();
  EnsembleTrace(EnsembleTrace&&) noexcept;
  EnsembleTrace& operator=(EnsembleTrace&&) noexcept;

  /// The next one, with the same picture and memory every time, which is used for nothing else meanwhile. False:
  /// it was the last. Errors: those of traceRibs; the first step ends with them, later ones never fail.
  Result<bool> step(const PictureEvidence& picture, RibWorkspace& memory);
  /// Share of the steps taken, 0…1.
  double progress() const;
  /// What ensembleRibs gives, after the last step; after the first one what the stroke finds by itself, without
  /// confidence.
  const RibSet& ribs() const;

 private:
  struct State;
  Status begin(const PictureEvidence& picture, RibWorkspace& memory);
  void ask(const PictureEvidence& picture, RibWorkspace& memory);
  std::unique_ptr<State> state_;
};

}  // namespace spineloft::ribs
