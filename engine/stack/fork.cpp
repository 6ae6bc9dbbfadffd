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

void addBranch(const Cell& cell, const Joint& joint, const JointShape& shape, Skin& skin) {
  const Loop& branch = joint.branches[cell.branch];
  std::size_t first = 0;
  const std::vector<Leave> leaves = leavesOf(cell, branch, joint.stem.normal, first);
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
      skin.zip(loop, next, joint.inwards);
    } else {
      skin.strip(last, next, joint.inwards);
    }
    last = std::move(next);
  }
}

}  // namespace

void addJoint(const Joint& joint, const JointShape& shape, Skin& skin) {
  for (const Cell& cell : cellsOf(joint, skin)) addBranch(cell, joint, shape, skin);
}

}  // namespace spineloft::stack
