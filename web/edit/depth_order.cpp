#include "web/edit/depth_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "web/edit/front_field.h"

namespace spineloft::app {
namespace {

using document::Operand;
using pipeline::WorldBounds;

constexpr double kReach = 0.04;  // into what is touched, of the thinner one's depth
constexpr double kLevel = 1e-6;  // world units: as good as there, in the meshes' numbers

/// Where each thing that is none of `parts` comes first in the list, and whether that is below them.
struct Neighbour {
  Operand root;
  bool below;
};
std::vector<Neighbour> neighboursOf(const document::Document& document, std::span<const PartId> parts) {
  std::vector<Neighbour> out;
  bool passed = false;
  for (const document::Part& part : document.parts) {
    if (std::ranges::count(parts, part.id) > 0) {
      passed = true;
      continue;
    }
    const Operand root = rootWith(document, part.id);
    if (std::ranges::find(out, root, &Neighbour::root) == out.end()) out.push_back({root, passed});
  }
  return out;
}

/// How far `own` goes along `sign` · z until it is past `other` but for a little. None where they have no place of
/// the picture plane in common.
std::optional<double> wayPast(const Body& own, const Body& other, double sign) {
  if (!own.bounds || !other.bounds) return std::nullopt;
  const WorldBounds &a = *own.bounds, &b = *other.bounds;
  const WorldBounds area{{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), 0},
                         {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), 0}};
  if (!(area.low.x < area.high.x) || !(area.low.y < area.high.y)) return std::nullopt;
  // The far side of what is passed against the near side of what passes it.
  const FrontField far = fieldOf(other, area, sign), near = fieldOf(own, area, -sign);
  double way = kNothing;
  for (std::size_t i = 0; i < far.size(); ++i) {
    if (far[i] != kNothing && near[i] != kNothing) way = std::max(way, far[i] + near[i]);
  }
  if (way == kNothing) return std::nullopt;
  return way - kReach * std::min(a.high.z - a.low.z, b.high.z - b.low.z);
}

std::string nameOf(const document::Document& document, Operand root) {
  if (const document::Step* step = document::findStep(document, root.step)) return step->name;
  const document::Part* part = document::findPart(document, root.part);
  return part ? part->name : std::string();
}

/// All that a solid is made of, or nothing of it.
bool wholeSolids(const document::Document& document, std::span<const PartId> parts) {
  return std::ranges::all_of(parts, [&](PartId id) {
    return std::ranges::all_of(partsIn(document, rootWith(document, id)),
                               [&](PartId other) { return std::ranges::count(parts, other) > 0; });
  });
}

}  // namespace

std::optional<DepthMove> depthMove(const document::Document& before, const document::Document& after,
                                   const pipeline::Derived& derived, std::span<const PartId> parts) {
  if (!wholeSolids(before, parts)) return std::nullopt;
  const Body own = bodyOf(before, derived, parts);
  const std::vector<Neighbour> was = neighboursOf(before, parts), is = neighboursOf(after, parts);
  std::optional<DepthMove> best;
  for (const Neighbour& one : is) {
    const auto old = std::ranges::find(was, one.root, &Neighbour::root);
    if (old == was.end() || old->below == one.below) continue;
    const double sign = one.below ? 1 : -1;
    const std::optional<double> way = wayPast(own, bodyOf(before, derived, one.root), sign);
    if (!way || *way <= kLevel || (best && *way <= std::abs(best->by))) continue;
    best = DepthMove{sign * *way, nameOf(before, one.root)};
  }
  return best;
}

Lying lyingOf(const document::Document& document, const pipeline::Derived& derived, const Body& own, PartId without) {
  Lying out;
  if (!own.bounds) return out;
  const FrontField front = fieldOf(own, *own.bounds, 1);
  std::vector<bool> hidden(front.size());
  std::vector<Operand> seen;
  for (const document::Part& part : document.parts) {
    const Operand root = rootWith(document, part.id);
    if (part.id == without || std::ranges::count(seen, root) > 0) continue;
    seen.push_back(root);
    if (without && root == rootWith(document, without)) continue;
    const Body other = bodyOf(document, derived, root);
    const std::optional<double> over = wayPast(own, other, 1), under = wayPast(own, other, -1);
    if (!over || !under) continue;
    out.front = std::max(out.front.value_or(*over), *over);
    out.behind = std::min(out.behind.value_or(-*under), -*under);
    const FrontField theirs = fieldOf(other, *own.bounds, 1);
    for (std::size_t i = 0; i < front.size(); ++i) hidden[i] = hidden[i] || theirs[i] > front[i];
  }
  std::size_t all = 0, under = 0;
  for (std::size_t i = 0; i < front.size(); ++i) {
    if (front[i] == kNothing) continue;
    ++all;
    under += hidden[i] ? 1 : 0;
  }
  if (all > 0) out.hidden = static_cast<double>(under) / static_cast<double>(all);
  return out;
}

}  // namespace spineloft::app
