#include "engine/pipeline/trace_job.h"

#include <new>
#include <utility>

#include "engine/ribs/base/spine.h"

namespace spineloft::pipeline {

TraceJob::TraceJob(std::uint64_t key, const document::LoftRecipe& recipe, std::shared_ptr<const image::EdgeMap> edges,
                   std::shared_ptr<const ribs::IgnoredEdges> ignored, image::Size picture)
    : key_(key), recipe_(recipe), edges_(std::move(edges)), ignored_(std::move(ignored)), picture_(picture) {}

bool TraceJob::takeStep() {
  if (!agreement_) {
    Result<ribs::Spine> spine = ribs::cleanSpine(recipe_.stroke, picture_, recipe_.spine);
    if (!spine) return false;
    spine_ = std::move(spine).value();
    agreement_ = std::make_unique<ribs::EnsembleTrace>(spine_, recipe_.ribs);
  }
  const Result<bool> more = agreement_->step({*edges_, picture_, ignored_.get()}, memory_);
  if (!more) return false;
  if (!more.value()) {
    made_ = std::make_shared<const TracedRibs>(TracedRibs{std::move(spine_), agreement_->ribs()});
  }
  return more.value();
}

bool TraceJob::step() {
  try {
    return takeStep();
  } catch (const std::bad_alloc&) {
    return false;
  }
}

}  // namespace spineloft::pipeline
