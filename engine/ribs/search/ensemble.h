// An ensemble of searches. A single search may follow an accident of the stroke; the results of slightly perturbed
// strokes through the same object show which ends are stable.
#pragma once

#include <memory>

#include "engine/ribs/search/ribs.h"

namespace spineloft::ribs {

/// traceRibs for the stroke and for six perturbed strokes: beside it by an eighth and a quarter of the width, and
/// with both ends farther in or out. The length of every curve, fans included, is the weighted median of the seven
/// results; the weight of a result is the third power of its mean agreement (ratio of lengths) with the others. Of
/// the lengths of a fan the medians of five neighbours are taken. Confidence is that of the stroke's own search.
/// Takes as long as seven searches of at most 100 ribs. Without edges, and for fewer than four ribs, it equals
/// traceRibs. Has the laws and errors of traceRibs.
Result<RibSet> ensembleRibs(const Spine& spine, const PictureEvidence& picture, const RibParams& params,
                            const Progress& progress, RibWorkspace& memory);

/// ensembleRibs in steps of one search each, so that a page is drawn in between. Any thread may take the next step.
class EnsembleTrace {
 public:
  EnsembleTrace(Spine spine, const RibParams& params);
  ~EnsembleTrace();
  EnsembleTrace(EnsembleTrace&&) noexcept;
  EnsembleTrace& operator=(EnsembleTrace&&) noexcept;

  /// Takes the next step. Every step needs the same picture and the same memory, which nothing else may use in
  /// between. False: it was the last. Errors: those of traceRibs, of the first step only.
  Result<bool> step(const PictureEvidence& picture, RibWorkspace& memory);
  /// Share of the steps taken, 0…1.
  double progress() const;
  /// After the last step: the result of ensembleRibs. After the first: the ribs of the stroke alone, without
  /// confidence.
  const RibSet& ribs() const;

 private:
  struct State;
  Status begin(const PictureEvidence& picture, RibWorkspace& memory);
  void ask(const PictureEvidence& picture, RibWorkspace& memory);
  std::unique_ptr<State> state_;
};

}  // namespace spineloft::ribs
