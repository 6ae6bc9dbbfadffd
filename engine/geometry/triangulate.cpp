#include "engine/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

#include "engine/geometry/polygon.h"

namespace spineloft::geometry {
namespace {

/// Corners whose ear would be flatter than this (twice its area over its longest side squared)
/// count as straight: they are rounding, not shape.
constexpr double kStraight = 1e-10;

using Triangle = std::array<std::uint32_t, 3>;
using Ring = std::vector<std::uint32_t>;  ///< points by their index

double side(SectionPoint a, SectionPoint b, SectionPoint c) { return cross(b - a, c - a); }

/// Whether a line from the corner `at` towards `target` begins inside a counter-clockwise polygon
/// that comes from `before` and goes on to `after`.
bool inCone(SectionPoint before, SectionPoint at, SectionPoint after, SectionPoint target) {
  const bool leftOfFirst = side(before, at, target) > 0, leftOfSecond = side(at, after, target) > 0;
  return side(before, at, after) > 0 ? leftOfFirst && leftOfSecond : leftOfFirst || leftOfSecond;
}

/// A ring of the corners that are left, and a queue of candidates, best-shaped first. Where a bridge
/// to a hole was, two corners of the ring are the same point.
class EarClipper {
 public:
  EarClipper(std::span<const SectionPoint> points, const Ring& ring)
      : name_(ring), next_(ring.size()), last_(ring.size()), age_(ring.size(), 0) {
    points_.reserve(ring.size());
    for (const std::uint32_t name : ring) points_.push_back(points[name]);
    markTwins();
    const std::uint32_t n = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      last_[i] = (i + n - 1) % n;
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      if (shape(i) <= kStraight) obstacles_.push_back(i);
      offer(i);
    }
  }

  std::vector<Triangle> run() {
    std::vector<Triangle> triangles;
    std::size_t left = points_.size();
    while (left > 3 && !queue_.empty()) {
      const Candidate best = queue_.top();
      queue_.pop();
      const std::uint32_t i = best.corner;
      if (best.age != age_[i]) continue;
      if (!isEar(i)) {
        blocked_.push_back(best);
        continue;
      }
      triangles.push_back(triangle(i));
      clip(i);
      --left;
    }
    if (left != 3) return {};
    const std::uint32_t i = last_[lastClipped_];
    if (shape(i) <= 0) return {};
    triangles.push_back(triangle(i));
    return triangles;
  }

 private:
  struct Candidate {
    double shape;
    std::uint32_t corner, age;
    bool operator<(const Candidate& other) const { return shape < other.shape; }
  };

  Triangle triangle(std::uint32_t i) const { return {name_[last_[i]], name_[i], name_[next_[i]]}; }

  void markTwins() {
    Ring sorted = name_;
    std::ranges::sort(sorted);
    twin_.resize(name_.size());
    for (std::size_t i = 0; i < name_.size(); ++i) {
      const auto [first, last] = std::ranges::equal_range(sorted, name_[i]);
      twin_[i] = last - first > 1;
    }
  }

  /// Twice the ear's signed area over its longest side squared.
  double shape(std::uint32_t i) const {
    const SectionPoint a = points_[last_[i]], b = points_[i], c = points_[next_[i]];
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    return longest > 0 ? cross(b - a, c - b) / longest : 0;
  }

  void offer(std::uint32_t i) {
    const double quality = shape(i);
    if (quality > kStraight) queue_.push({quality, i, age_[i]});
  }

  /// No other corner in or on the ear. Only reflex and straight corners can be in the way.
  bool isEar(std::uint32_t i) const {
    const std::uint32_t before = last_[i], after = next_[i];
    const SectionPoint a = points_[before], b = points_[i], c = points_[after];
    if (twin_[before] && !inCone(points_[last_[before]], a, b, c)) return false;
    if (twin_[after] && !inCone(b, c, points_[next_[after]], a)) return false;
    const double slack = -kStraight * std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    return std::none_of(obstacles_.begin(), obstacles_.end(), [&](std::uint32_t k) {
      if (age_[k] == kGone || name_[k] == name_[before] || name_[k] == name_[i] || name_[k] == name_[after]) {
        return false;
      }
      const SectionPoint p = points_[k];
      return cross(b - a, p - a) >= slack && cross(c - b, p - b) >= slack && cross(a - c, p - c) >= slack;
    });
  }

  void clip(std::uint32_t i) {
    const std::uint32_t before = last_[i], after = next_[i];
    next_[before] = after;
    last_[after] = before;
    age_[i] = kGone;
    lastClipped_ = i;
    for (const std::uint32_t k : {before, after}) {
      ++age_[k];
      offer(k);
    }
    // Whatever blocked an ear may have been the corner that went.
    for (const Candidate& candidate : blocked_) {
      if (candidate.age == age_[candidate.corner]) queue_.push(candidate);
    }
    blocked_.clear();
  }

  static constexpr std::uint32_t kGone = 0xffffffffu;
  std::vector<SectionPoint> points_;
  const Ring& name_;
  std::vector<bool> twin_;
  std::vector<std::uint32_t> next_, last_, age_, obstacles_;
  std::priority_queue<Candidate> queue_;
  std::vector<Candidate> blocked_;
  std::uint32_t lastClipped_ = 0;
};

/// Joins holes to an outer ring.
class Bridges {
 public:
  Bridges(std::span<const SectionPoint> points, Ring outer, std::vector<Ring> holes)
      : points_(points), ring_(std::move(outer)), holes_(std::move(holes)) {}

  /// One ring round outer polygon and holes; empty when a hole finds no way out.
  Ring run() {
    for (Ring& hole : holes_) std::ranges::rotate(hole, rightmost(hole));
    std::ranges::sort(holes_,
                      [&](const Ring& a, const Ring& b) { return points_[a.front()].x < points_[b.front()].x; });
    while (!holes_.empty()) {
      const std::size_t at = wayOut(holes_.back().front());
      if (at == ring_.size()) return {};
      Ring hole = std::move(holes_.back());
      holes_.pop_back();
      hole.push_back(hole.front());
      hole.push_back(ring_[at]);
      ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(at) + 1, hole.begin(), hole.end());
    }
    return std::move(ring_);
  }

 private:
  Ring::iterator rightmost(Ring& ring) const {
    return std::ranges::max_element(ring,
                                    [&](std::uint32_t a, std::uint32_t b) { return points_[a].x < points_[b].x; });
  }

  /// The nearest corner of the ring that `from` sees, as a place in the ring.
  std::size_t wayOut(std::uint32_t from) const {
    std::vector<std::size_t> order(ring_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t at) {
      const SectionPoint step = points_[ring_[at]] - points_[from];
      return dot(step, step);
    });
    const auto found = std::ranges::find_if(order, [&](std::size_t at) { return sees(from, at); });
    return found == order.end() ? ring_.size() : *found;
  }

  bool sees(std::uint32_t from, std::size_t at) const {
    const std::size_t n = ring_.size();
    const SectionPoint before = points_[ring_[(at + n - 1) % n]];
    const SectionPoint after = points_[ring_[(at + 1) % n]];
    if (!inCone(before, points_[ring_[at]], after, points_[from])) return false;
    const auto clear = [&](const Ring& ring) { return isClear(from, ring_[at], ring); };
    return clear(ring_) && std::ranges::all_of(holes_, clear);
  }

  /// No edge of the ring touches the bridge except in its ends.
  bool isClear(std::uint32_t from, std::uint32_t to, const Ring& ring) const {
    const SectionPoint a = points_[from], b = points_[to];
    const double straight = kStraight * dot(b - a, b - a);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::uint32_t p = ring[i], q = ring[(i + 1) % ring.size()];
      const SectionPoint c = points_[p], d = points_[q];
      const double atC = side(a, b, c), atD = side(a, b, d);
      const bool shared = p == from || p == to || q == from || q == to;
      if (!shared && atC * atD <= 0 && side(c, d, a) * side(c, d, b) <= 0) return false;
      if (p != from && p != to && std::abs(atC) <= straight && dot(c - a, c - b) < 0) return false;
    }
    return true;
  }

  std::span<const SectionPoint> points_;
  Ring ring_;
  std::vector<Ring> holes_;
};

}  // namespace

std::vector<Triangle> triangulate(std::span<const SectionPoint> polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return {};
  if (n == 3) {
    const double area = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    return area > 0 ? std::vector<Triangle>{{0, 1, 2}} : std::vector<Triangle>{};
  }
  Ring ring(n);
  std::iota(ring.begin(), ring.end(), 0u);
  return EarClipper(polygon, ring).run();
}

std::vector<Triangle> triangulate(std::span<const SectionPoint> points, std::span<const std::size_t> sizes) {
  if (sizes.size() == 1) return triangulate(points);
  std::vector<Ring> outers, holes;
  std::uint32_t first = 0;
  for (const std::size_t size : sizes) {
    Ring ring(size);
    std::iota(ring.begin(), ring.end(), first);
    (signedArea(points.subspan(first, size)) > 0 ? outers : holes).push_back(std::move(ring));
    first += static_cast<std::uint32_t>(size);
  }
  // A hole belongs to the smallest outer polygon round it: an island may lie in another hole.
  const auto polygonOf = [&](const Ring& ring) { return points.subspan(ring.front(), ring.size()); };
  std::ranges::sort(outers, {}, [&](const Ring& ring) { return signedArea(polygonOf(ring)); });
  std::vector<Triangle> all;
  for (const Ring& outer : outers) {
    const auto polygon = polygonOf(outer);
    std::vector<Ring> inside;
    std::erase_if(holes, [&](const Ring& hole) {
      if (!holds(polygon, points[hole.front()])) return false;
      inside.push_back(hole);
      return true;
    });
    std::vector<Triangle> part;
    if (inside.empty()) {
      part = triangulate(polygon);
      for (Triangle& t : part) {
        for (std::uint32_t& corner : t) corner += outer.front();
      }
    } else {
      const Ring ring = Bridges(points, outer, std::move(inside)).run();
      if (!ring.empty()) part = EarClipper(points, ring).run();
    }
    if (part.empty()) return {};
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

}  // namespace spineloft::geometry
