#include "engine/ribs/search/live_trace.h"

#include <algorithm>

#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

constexpr int kFewestLabels = 16;

}  // namespace

Result<LiveTrace::Ribs> LiveTrace::move(const Spine& spine, const PictureEvidence& picture, const RibParams& params) {
  Ribs found;
  const Result<bool> exact = move(spine, picture, params, found.set);
  if (!exact) return exact.failure();
  found.exact = exact.value();
  return found;
}

Result<bool> LiveTrace::move(const Spine& spine, const PictureEvidence& picture, const RibParams& params, RibSet& set) {
  const bool exact = picture.edges.empty();
  RibParams quick = params;
  if (!exact) quick.levels = std::max(std::min(params.levels, kFewestLabels), params.levels * 3 / 4);
  Search& s = memory_.search();
  const Status searched = searchLabels(spine, picture, quick, unwatched_, s);
  if (!searched.ok()) return searched.failure();
  readRibs(exact, s, set);
  return exact;
}

}  // namespace spineloft::ribs
