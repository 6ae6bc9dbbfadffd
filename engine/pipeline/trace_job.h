// The ensemble of a part, computed in steps while the page shows the ribs of the stroke alone.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/document/document.h"
#include "engine/image/edge_map.h"
#include "engine/pipeline/part_shape.h"
#include "engine/ribs/evidence/ignored.h"
#include "engine/ribs/search/ensemble.h"

namespace spineloft::pipeline {

/// traceStage in steps of one search each (ribs::EnsembleTrace), on any thread: it holds what it works with.
class TraceJob {
 public:
  /// `edges` not null; `ignored` may be; `picture`: the size of it; `key`: traceKey.
  TraceJob(std::uint64_t key, const document::LoftRecipe& recipe, std::shared_ptr<const image::EdgeMap> edges,
           std::shared_ptr<const ribs::IgnoredEdges> ignored, image::Size picture);
  /// The next step. False: it was the last.
  bool step();
  /// After the last. Null where tracing failed or there was no memory.
  std::shared_ptr<const TracedRibs> traced() const { return made_; }
  std::uint64_t key() const { return key_; }

 private:
  bool takeStep();

  std::uint64_t key_;
  document::LoftRecipe recipe_;
  std::shared_ptr<const image::EdgeMap> edges_;
  std::shared_ptr<const ribs::IgnoredEdges> ignored_;
  image::Size picture_;
  ribs::Spine spine_;
  std::unique_ptr<ribs::EnsembleTrace> agreement_;
  ribs::RibWorkspace memory_;
  std::shared_ptr<const TracedRibs> made_;
};

}  // namespace spineloft::pipeline
