#include "engine/geometry/axis_clip.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

#include "engine/base/limits.h"
#include "engine/geometry/polyline.h"

namespace spineloft::geometry {
namespace {

using Line = std::vector<SectionPoint>;
using Lines = std::vector<Line>;

/// Where outlines cross the axis, in the order along it.
struct AxisCrossing {
  double h = 0;
  std::size_t chain = 0;
  bool begins = false;  ///< the chain begins here, else it ends
};

/// Neighbours along the axis belong together, one end and one beginning: at equal places the other of two is taken.
void pairUp(std::vector<AxisCrossing>& crossings) {
  std::ranges::sort(crossings, {}, [](const AxisCrossing& c) { return std::tuple(c.h, c.chain, c.begins); });
  for (std::size_t i = 0; i + 2 < crossings.size(); i += 2) {
    if (crossings[i].begins == crossings[i + 1].begins && crossings[i + 1].h == crossings[i + 2].h) {
      std::swap(crossings[i + 1], crossings[i + 2]);
    }
  }
}

/// The stretches of a closed outline at x > 0, each with its two points on the axis; or all of it.
void addChains(const Line& outline, Lines& whole, Lines& chains) {
  const std::size_t n = outline.size();
  std::size_t start = 0;
  while (start < n && outline[start].x > 0) ++start;
  if (start == n) {
    whole.push_back(outline);
    return;
  }
  Line chain;
  for (std::size_t k = 0; k < n; ++k) {
    const SectionPoint p = outline[(start + k) % n], q = outline[(start + k + 1) % n];
    if (p.x <= 0 && q.x > 0) chain = {p.x < 0 ? onAxis(p, q) : p};
    if (q.x > 0) chain.push_back(q);
    if (p.x > 0 && q.x <= 0) {
      chain.push_back(q.x < 0 ? onAxis(p, q) : q);
      chains.push_back(std::move(chain));
      chain.clear();
    }
  }
}

}  // namespace

Lines clippedAtAxis(const Lines& outlines) {
  Lines out, chains;
  for (const Line& outline : outlines) addChains(outline, out, chains);
  std::vector<AxisCrossing> crossings;
  for (std::size_t i = 0; i < chains.size(); ++i) {
    crossings.push_back({chains[i].front().y, i, true});
    crossings.push_back({chains[i].back().y, i, false});
  }
  pairUp(crossings);
  std::vector<std::size_t> next(chains.size(), chains.size());
  for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
    const auto [end, begin] =
        crossings[i].begins ? std::pair{crossings[i + 1], crossings[i]} : std::pair{crossings[i], crossings[i + 1]};
    if (!end.begins && begin.begins) next[end.chain] = begin.chain;
  }
  std::vector<bool> done(chains.size(), false);
  for (std::size_t i = 0; i < chains.size(); ++i) {
    Line outline;
    std::size_t at = i;
    while (at < chains.size() && !done[at]) {
      done[at] = true;
      outline.insert(outline.end(), chains[at].begin(), chains[at].end());
      at = next[at];
    }
    if (at == i) out.push_back(std::move(outline));
  }
  for (Line& outline : out) {
    dropRepeats(outline, kSamePoint);
    while (outline.size() > 1 && distance(outline.front(), outline.back()) <= kSamePoint) outline.pop_back();
  }
  std::erase_if(out, [](const Line& outline) { return outline.size() < 3; });
  return out;
}

}  // namespace spineloft::geometry
