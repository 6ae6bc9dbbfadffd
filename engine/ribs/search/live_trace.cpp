#include "engine/ribs/search/live_trace.h"

#include <algorithm>
#include <cmath>

#include "engine/ribs/search/rib_search.h"

namespace spineloft::ribs {
namespace {

// Ribs that are searched, about as many as the network has rows along them; the others lie between them.
constexpr std::size_t kMostRibs = 51;

// `count` ≤ its own points of an even line, evenly.
void thinOut(const Spine& spine, std::size_t count, Spine& out) {
  const std::vector<PicturePoint>& all = spine.points;
  out.points.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t at = i * (all.size() - 1), segment = at / (count - 1), rest = at % (count - 1);
    out.points[i] =
        rest == 0 ? all[segment]
                  : lerp(all[segment], all[segment + 1], static_cast<double>(rest) / static_cast<double>(count - 1));
  }
}

PicturePoint inFrame(PicturePoint p, image::Size picture) {
  return {std::clamp(p.x, -0.5, picture.width - 0.5), std::clamp(p.y, -0.5, picture.height - 0.5)};
}

// The ribs of all of the spine's points: what they are in between goes evenly from one of `few` to the next.
void fillIn(const RibSet& few, const Spine& spine, image::Size picture, RibSet& all) {
  const std::size_t last = spine.points.size() - 1, steps = few.ribs.size() - 1;
  all.ribs.assign(spine.points.size(), Rib{});
  for (std::size_t i = 0; i <= last; ++i) {
    const std::size_t segment = std::min(i * steps / last, steps - 1);
    const double share = static_cast<double>(i * steps - segment * last) / static_cast<double>(last);
    const Rib &a = few.ribs[segment], &b = few.ribs[segment + 1];
    Rib& rib = all.ribs[i];
    rib.center = spine.points[i];
    const auto end = [&](PicturePoint Rib::* side) {
      return inFrame(rib.center + lerp(a.*side - a.center, b.*side - b.center, share), picture);
    };
    rib.left = end(&Rib::left);
    rib.right = end(&Rib::right);
    rib.leftLevel = std::lerp(a.leftLevel, b.leftLevel, share);
    rib.rightLevel = std::lerp(a.rightLevel, b.rightLevel, share);
    rib.leftState = share < 0.5 ? a.leftState : b.leftState;
    rib.rightState = share < 0.5 ? a.rightState : b.rightState;
  }
  all.startFan.points = few.startFan.points;
  all.endFan.points = few.endFan.points;
  all.energy = few.energy;
}

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
  Search& s = memory_.search();
  const std::size_t count = spine.points.size();
  if (exact || count <= kMostRibs) {
    const Status searched = searchLabels(spine, picture, params, unwatched_, s);
    if (!searched.ok()) return searched.failure();
    readRibs(exact, s, set);
    return exact;
  }
  RibParams quick = params;
  // Second differences of half as many lengths are four times as large.
  const double thinned = (kMostRibs - 1.0) / (static_cast<double>(count) - 1);
  quick.fairing.stiffness *= std::pow(thinned, 4);
  thinOut(spine, kMostRibs, few_);
  const Status searched = searchLabels(few_, picture, quick, unwatched_, s);
  if (!searched.ok()) return searched.failure();
  readRibs(false, s, fewRibs_);
  fillIn(fewRibs_, spine, picture.size, set);
  return false;
}

}  // namespace spineloft::ribs
