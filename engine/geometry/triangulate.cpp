#include "engine/geometry/triangulate.h"

#include <algorithm>
#include <cmath>
#include <queue>

namespace spineloft::geometry {
namespace {

/// Corners whose ear would be flatter than this (twice its area over its longest side squared)
/// count as straight: they are rounding, not shape.
constexpr double kStraight = 1e-10;

/// A ring of the corners that are left, and a queue of candidates, best-shaped first.
class EarClipper {
 public:
  explicit EarClipper(std::span<const SectionPoint> polygon)
      : points_(polygon), next_(polygon.size()), last_(polygon.size()), age_(polygon.size(), 0) {
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

  std::vector<std::array<std::uint32_t, 3>> run() {
    std::vector<std::array<std::uint32_t, 3>> triangles;
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
      triangles.push_back({last_[i], i, next_[i]});
      clip(i);
      --left;
    }
    if (left != 3) return {};
    const std::uint32_t i = last_[lastClipped_];
    if (shape(i) <= 0) return {};
    triangles.push_back({last_[i], i, next_[i]});
    return triangles;
  }

 private:
  struct Candidate {
    double shape;
    std::uint32_t corner, age;
    bool operator<(const Candidate& other) const { return shape < other.shape; }
  };

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
    const double slack =
        -kStraight * std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    return std::none_of(obstacles_.begin(), obstacles_.end(), [&](std::uint32_t k) {
      if (age_[k] == kGone || k == before || k == i || k == after) return false;
      const SectionPoint p = points_[k];
      return cross(b - a, p - a) >= slack && cross(c - b, p - b) >= slack &&
             cross(a - c, p - c) >= slack;
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
  std::span<const SectionPoint> points_;
  std::vector<std::uint32_t> next_, last_, age_, obstacles_;
  std::priority_queue<Candidate> queue_;
  std::vector<Candidate> blocked_;
  std::uint32_t lastClipped_ = 0;
};

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(std::span<const SectionPoint> polygon) {
  const std::size_t n = polygon.size();
  if (n < 3) return {};
  if (n == 3) {
    const double area = cross(polygon[1] - polygon[0], polygon[2] - polygon[0]);
    return area > 0 ? std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}
                    : std::vector<std::array<std::uint32_t, 3>>{};
  }
  return EarClipper(polygon).run();
}

}  // namespace spineloft::geometry
