#include "tests/bench/accuracy/live_score.h"

#include <algorithm>

#include "engine/ribs/search/live_trace.h"

namespace spineloft::accuracy {
namespace {

constexpr int kMoments = 10;
constexpr double kSeenPct = 5, kLeastWidth = 4;

double apartPct(const ribs::RibSet& whole, const ribs::RibSet& live) {
  double sum = 0;
  for (std::size_t i = 0; i < whole.ribs.size(); ++i) {
    const ribs::Rib &a = whole.ribs[i], &b = live.ribs[i];
    const double width = std::max(kLeastWidth, distance(a.left, a.right));
    sum += 50 * (distance(a.left, b.left) + distance(a.right, b.right)) / width;
  }
  return sum / static_cast<double>(whole.ribs.size());
}

}  // namespace

LiveScore scoreLive(std::span<const PicturePoint> stroke, const image::EdgeMap& edges, image::Size size,
                    const ribs::RibParams& params, int moves) {
  ribs::LiveTrace live;
  ribs::RibWorkspace memory;
  LiveScore score;
  double looked = 0, made = 0;
  for (int move = 1; move <= moves; ++move) {
    const std::size_t count = stroke.size() * static_cast<std::size_t>(move) / static_cast<std::size_t>(moves);
    const auto spine = ribs::cleanSpine(stroke.first(count), size, {});
    if (!spine) continue;
    const auto found = live.move(spine.value(), {edges, size}, params);
    if (!found) continue;
    ++made;
    score.followed += found.value().exact ? 0 : 1;
    if (move * kMoments / moves == (move - 1) * kMoments / moves) continue;
    const auto whole = ribs::traceRibs(spine.value(), {edges, size}, params, Progress(), memory);
    if (!whole) continue;
    ++looked;
    score.upPct = apartPct(whole.value(), found.value().set);
    score.meanPct += score.upPct;
    score.jumps += score.upPct > kSeenPct ? 1 : 0;
  }
  score.followed /= std::max(1.0, made);
  score.meanPct /= std::max(1.0, looked);
  score.jumps /= std::max(1.0, looked);
  return score;
}

}  // namespace spineloft::accuracy
