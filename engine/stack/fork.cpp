#include "engine/stack/fork.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/geometry/polygon.h"
#include "engine/sections/common_points.h"
#include "engine/stack/cells.h"
#include "engine/stack/network.h"

namespace spineloft::stack {
namespace {

/// A closed curve in space seen along a normal: about its centre, of the area of a circle of radius 1.
sections::Contour flattened(const std::vector<ModelPoint>& points, ModelPoint x, ModelPoint y) {
  sections::Contour contour;
  for (const ModelPoint& p : points) contour.points.push_back({dot(p, x), dot(p, y)});
  const SectionPoint centre = geometry::centroid(contour.points);
  const double area = std::abs(geometry::signedArea(std::span<const SectionPoint>(contour.points)));
  const double radius = std::sqrt(std::max(area, 1e-12) / std::numbers::pi);
  for (SectionPoint& p : contour.points) p = (p - centre) / radius;
  contour.knot.assign(points.size(), false);
  return contour;
}

/// Where a cell leaves for each point of its branch.
struct Leave {
  ModelPoint at, way;
};

/// The places of the cell that belong to the points of the branch; `first`: the cell's point nearest to the first one.
std::vector<Leave> leavesOf(const Cell& cell, const Loop& branch, ModelPoint stemNormal, std::size_t& first) {
  const ModelPoint some = std::abs(stemNormal.x) < 0.7 ? ModelPoint{1, 0, 0} : ModelPoint{0, 1, 0};
  const ModelPoint x = normalized(some - stemNormal * dot(some, stemNormal)), y = cross(stemNormal, x);
  const ModelPoint carried = leastTurned(x, stemNormal, branch.normal);
  const sections::Contour from = flattened(cell.points, x, y);
  const sections::Contour to = flattened(branch.points, carried, cross(branch.normal, carried));
  const std::vector<double> places = sections::placesOn(from, to);
  const std::size_t n = from.points.size();
  std::vector<double> arc(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) arc[i + 1] = arc[i] + distance(from.points[i], from.points[(i + 1) % n]);
  std::vector<Leave> leaves;
  for (const double place : places) {
    const double wanted = (place - std::floor(place)) * arc.back();
    const auto next = std::ranges::upper_bound(arc, wanted);
    const auto j = std::clamp<std::size_t>(static_cast<std::size_t>(next - arc.begin()), 1, n), i = j - 1;
    const double step = arc[j] - arc[i], t = step > 0 ? std::clamp((wanted - arc[i]) / step, 0.0, 1.0) : 0;
    if (leaves.empty()) first = t < 0.5 ? i : j % n;
    leaves.push_back({lerp(cell.points[i], cell.points[j % n], t), lerp(cell.ways[i], cell.ways[j % n], t)});
  }
  return leaves;
}

/// The point brought into all half-spaces, as far as some rounds of projections do that.
ModelPoint held(ModelPoint p, const std::vector<HalfSpace>& within) {
  constexpr int kRounds = 6;
  for (int round = 0; round < kRounds; ++round) {
    bool inside = true;
    for (const HalfSpace& half : within) {
      const double beyond = dot(half.normal, p - half.origin);
      if (beyond <= 0) continue;
      p = p - half.normal * beyond;
      inside = false;
    }
    if (inside) break;
  }
  return p;
}

/// The surface from a cell of a stem to its branch.
void addBranch(const Cell& cell, ModelPoint stemNormal, const Loop& branch, bool inwards, const JointShape& shape,
               Skin& skin) {
  std::size_t first = 0;
  const std::vector<Leave> leaves = leavesOf(cell, branch, stemNormal, first);
  std::vector<std::array<ModelPoint, 4>> arcs;
  for (std::size_t k = 0; k < leaves.size(); ++k) {
    const ModelPoint a = leaves[k].at, d = branch.points[k];
    const double reach = shape.fullness * distance(a, d);
    arcs.push_back({a, held(a + leaves[k].way * reach, cell.within), held(d - branch.normal * reach, cell.within), d});
  }
  RingVertices last;
  for (int row = 1; row <= shape.rows; ++row) {
    RingVertices next;
    const double t = static_cast<double>(row) / shape.rows, u = 1 - t;
    for (const auto& [a, b, c, d] : arcs) {
      if (row == shape.rows) break;
      next.push_back(skin.vertex(a * (u * u * u) + b * (3 * u * u * t) + c * (3 * u * t * t) + d * (t * t * t)));
    }
    if (row == shape.rows) next = branch.vertices;
    if (row == 1) {
      RingVertices loop = cell.vertices;
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
      skin.zip(loop, next, inwards);
    } else {
      skin.strip(last, next, inwards);
    }
    last = std::move(next);
  }
}

/// The same curve looking back.
Loop turnedOver(const Loop& loop) {
  return {{loop.points.rbegin(), loop.points.rend()},
          {loop.vertices.rbegin(), loop.vertices.rend()},
          -loop.normal,
          loop.rise};
}

/// A joint as it is seen from one of its sides: what becomes what.
struct Ahead {
  std::vector<Loop> stems, branches;
  std::vector<std::vector<std::size_t>> of;  ///< branches of each stem

  bool forks() const {
    return std::ranges::any_of(of, [](const auto& several) { return several.size() > 1; });
  }
  /// Of each stem that has several branches; `Cell::branch` counts all branches.
  std::vector<Cells> cells(Skin& skin) const {
    std::vector<Cells> out(stems.size());
    for (std::size_t i = 0; i < stems.size(); ++i) {
      if (of[i].size() < 2) continue;
      std::vector<const Loop*> own;
      for (const std::size_t branch : of[i]) own.push_back(&branches[branch]);
      out[i] = cellsOf(stems[i], own, skin);
      for (Cell& cell : out[i].all) cell.branch = of[i][cell.branch];
    }
    return out;
  }
};
Ahead aheadOf(const Joint& joint, bool down) {
  const auto seen = [&](const std::vector<Loop>& loops) {
    std::vector<Loop> out;
    for (const Loop& loop : loops) out.push_back(down ? turnedOver(loop) : loop);
    return out;
  };
  Ahead out{seen(down ? joint.above : joint.below), seen(down ? joint.below : joint.above), {}};
  out.of.resize(out.stems.size());
  for (const auto& link : joint.links) out.of[link[down ? 1 : 0]].push_back(link[down ? 0 : 1]);
  return out;
}

std::vector<std::optional<double>> risesOf(const std::vector<Cells>& cells) {
  std::vector<std::optional<double>> out;
  for (const Cells& one : cells) out.push_back(one.all.empty() ? std::nullopt : std::optional(one.rise));
  return out;
}

const Cell* cellFor(const Cells& cells, std::size_t branch) {
  const auto at = std::ranges::find(cells.all, branch, &Cell::branch);
  return at == cells.all.end() ? nullptr : &*at;
}

/// A circle for each link half way between its curves, as large as what both give it, and apart from the others.
std::vector<Loop> middlesOf(const Joint& joint, double waist, Skin& skin) {
  std::vector<ModelPoint> centres;
  for (const auto& [i, j] : joint.links) {
    centres.push_back((middleOf(joint.below[i].points) + middleOf(joint.above[j].points)) / 2);
  }
  std::vector<Loop> middles;
  for (std::size_t k = 0; k < joint.links.size(); ++k) {
    const auto [i, j] = joint.links[k];
    const Loop &from = joint.below[i], &to = joint.above[j];
    const auto shared = [&](const Loop& loop, std::size_t side, std::size_t number) {
      const auto links = std::ranges::count_if(joint.links, [&](const auto& link) { return link[side] == number; });
      return areaOf(loop.points) / static_cast<double>(links);
    };
    double radius = std::sqrt((shared(from, 0, i) + shared(to, 1, j)) / 2 / std::numbers::pi);
    for (std::size_t other = 0; other < centres.size(); ++other) {
      if (other != k) radius = std::min(radius, waist * distance(centres[k], centres[other]));
    }
    const ModelPoint normal = normalized(from.normal + to.normal);
    const ModelPoint first = from.points.front() - middleOf(from.points);
    const ModelPoint x = normalized(first - normal * dot(first, normal)), y = cross(normal, x);
    Loop& middle = middles.emplace_back();
    middle.normal = normal;
    const std::size_t count = to.points.size();
    for (std::size_t p = 0; p < count; ++p) {
      const double angle = 2 * std::numbers::pi * static_cast<double>(p) / static_cast<double>(count);
      middle.points.push_back(centres[k] + x * (radius * std::cos(angle)) + y * (radius * std::sin(angle)));
      middle.vertices.push_back(skin.vertex(middle.points.back()));
    }
  }
  return middles;
}

/// Several become several: each link goes through a curve of its own half way, so that each half parts to one side
/// only.
JointCuts addByMiddles(const Joint& joint, const JointShape& whole, Skin& skin) {
  const JointShape shape{whole.fullness, whole.rows};
  Joint low{joint.below, middlesOf(joint, whole.waist, skin), {}, joint.inwards},
      high{low.above, joint.above, {}, joint.inwards};
  for (std::size_t k = 0; k < joint.links.size(); ++k) {
    low.links.push_back({joint.links[k][0], k});
    high.links.push_back({k, joint.links[k][1]});
  }
  for (auto* loops : {&low.below, &high.above}) {
    for (Loop& loop : *loops) {
      if (loop.rise) *loop.rise *= 2;  // of half the way
    }
  }
  JointCuts cuts = addJoint(low, shape, skin);
  JointCuts upper = addJoint(high, shape, skin);
  cuts.above = std::move(upper.above);
  cuts.crease.insert(cuts.crease.end(), upper.crease.begin(), upper.crease.end());
  for (auto* side : {&cuts.below, &cuts.above}) {
    for (std::optional<double>& rise : *side) {
      if (rise) *rise /= 2;
    }
  }
  return cuts;
}

}  // namespace

JointCuts addJoint(const Joint& joint, const JointShape& shape, Skin& skin) {
  const Ahead up = aheadOf(joint, false), down = aheadOf(joint, true);
  if ((up.forks() && down.forks()) || (shape.halves && (up.forks() || down.forks()))) {
    return addByMiddles(joint, shape, skin);
  }
  const std::vector<Cells> upCells = up.cells(skin), downCells = down.cells(skin);
  for (const auto& [i, j] : joint.links) {
    const Loop &from = up.stems[i], &to = down.stems[j];
    if (const Cell* cell = cellFor(downCells[j], i)) {
      addBranch(*cell, to.normal, turnedOver(from), joint.inwards, shape, skin);
    } else {
      const Cell* part = cellFor(upCells[i], j);
      const Cell own = part ? *part : wholeOf(from);
      addBranch(own, from.normal, joint.above[j], joint.inwards, shape, skin);
    }
  }
  JointCuts cuts{risesOf(upCells), risesOf(downCells), {}};
  for (const auto* side : {&upCells, &downCells}) {
    for (const Cells& one : *side) cuts.crease.insert(cuts.crease.end(), one.crease.begin(), one.crease.end());
  }
  return cuts;
}

}  // namespace spineloft::stack
