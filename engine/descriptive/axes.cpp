#include "engine/descriptive/axes.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>
#include <utility>

namespace spineloft::descriptive {
namespace {

constexpr double kPi = std::numbers::pi;

double turnBetween(const Direction& one, const Direction& other) {
  const double turn = std::abs(one.angle - other.angle);
  return std::min(turn, kPi - turn);
}

/// The mean by length, round the circle of lines without a sense.
double meanAngle(const Direction& one, const Direction& other) {
  double x = 0, y = 0;
  for (const Direction* d : {&one, &other}) {
    x += d->length * std::cos(2 * d->angle);
    y += d->length * std::sin(2 * d->angle);
  }
  const double angle = std::atan2(y, x) / 2;
  return angle < 0 ? angle + kPi : angle;
}

/// The angles between neighbours of three directions, of growing angle; the last is that from the third on to the
/// first.
std::array<double, 3> gapsOf(const std::array<double, 3>& a) { return {a[1] - a[0], a[2] - a[1], kPi + a[0] - a[2]}; }

/// The gap between the two that are the front of an oblique projection.
std::optional<std::size_t> frontOf(const std::array<double, 3>& angles) {
  const auto gaps = gapsOf(angles);
  const auto widest = std::ranges::max_element(gaps);
  if (*widest < kPi / 2 - kFrontal) return std::nullopt;
  return static_cast<std::size_t>(widest - gaps.begin());
}

/// Turns three directions, of growing angle, so that they are those of a right-angled corner (see Axes). The unknowns
/// are the turns of the first two; the third turns the other way, since turning all alike changes no slope.
class Turning {
 public:
  using Three = std::array<double, 3>;

  explicit Turning(const std::array<const Direction*, 3>& directions) {
    for (std::size_t k = 0; k < 3; ++k) {
      angles_[k] = directions[k]->angle;
      drawn_[k] = directions[k]->logLengths / directions[k]->edges;
    }
    const auto widest = frontOf(angles_);
    if (!widest) return;
    expected_ = drawn_;
    const double front = (drawn_[*widest] + drawn_[(*widest + 1) % 3]) / 2;
    double& deep = expected_[(*widest + 2) % 3];
    deep = std::clamp(front, deep, deep + std::numbers::ln2);
    uneven_ = kUnevenOblique;
  }
  /// The least of the sum, by steps of Gauss and Newton that are damped until they make it less; infinite where it is
  /// nowhere defined near what is drawn.
  double solve() {
    start();
    State now = at(turn_);
    double damping = 1e-3;
    for (int round = 0; round < kMostRounds && std::isfinite(now.sum); ++round) {
      double aa = 0, ab = 0, bb = 0, ar = 0, br = 0;
      for (std::size_t i = 0; i < 6; ++i) {
        aa += now.by[i][0] * now.by[i][0];
        ab += now.by[i][0] * now.by[i][1];
        bb += now.by[i][1] * now.by[i][1];
        ar += now.by[i][0] * now.off[i];
        br += now.by[i][1] * now.off[i];
      }
      aa *= 1 + damping;
      bb *= 1 + damping;
      const double det = aa * bb - ab * ab;
      const double one = -(bb * ar - ab * br) / det, other = -(aa * br - ab * ar) / det;
      const Three turn{turn_[0] + one, turn_[1] + other, turn_[2] - one - other};
      const State next = at(turn);
      if (next.sum < now.sum) {
        const bool isDone = now.sum - next.sum < 1e-9 * now.sum;
        turn_ = turn;
        now = next;
        damping *= 0.2;
        if (isDone) break;
      } else {
        damping *= 8;
        if (damping > 1e9) break;
      }
    }
    return now.sum;
  }
  double angle(std::size_t k) const { return angles_[k] + turn_[k]; }
  double mostTurned() const {
    return std::ranges::max(turn_, {}, [](double t) { return std::abs(t); });
  }

 private:
  static constexpr int kMostRounds = 60;
  struct State {
    double sum = std::numeric_limits<double>::infinity();
    std::array<double, 6> off{};                ///< turns, then lengths
    std::array<std::array<double, 2>, 6> by{};  ///< and by either unknown
  };

  Three gaps(const Three& turn) const {
    return gapsOf({angles_[0] + turn[0], angles_[1] + turn[1], angles_[2] + turn[2]});
  }
  /// A gap of 90° or more is made a little less by both its sides.
  void start() {
    constexpr double kWidest = kPi / 2 - 0.02;
    const Three gap = gaps(turn_);
    for (std::size_t g = 0; g < 3; ++g) {
      const double over = gap[g] - kWidest;
      if (over <= 0) continue;
      turn_[g] += over / 2;
      turn_[(g + 1) % 3] -= over / 2;
    }
  }
  State at(const Three& turn) const {
    // By turn 0 and turn 1 while turn 2 is minus both: how gaps and turns change.
    constexpr std::array<std::array<double, 2>, 3> kGapBy{{{-1, 1}, {-1, -2}, {2, 1}}},
        kTurnBy{{{1, 0}, {0, 1}, {-1, -1}}};
    State out;
    const Three gap = gaps(turn);
    if (std::ranges::any_of(gap, [](double g) { return !(g > 0 && g < kPi / 2); })) return out;
    Three lengths{};
    std::array<std::array<double, 2>, 3> lengthBy{};
    for (std::size_t k = 0; k < 3; ++k) {
      // Axis k is between the gaps k − 1 and k; the third gap is between the two others.
      const std::size_t before = (k + 2) % 3, across = (k + 1) % 3;
      const double squared = std::cos(gap[before]) * std::cos(gap[k]) / std::cos(gap[across]);
      lengths[k] = drawn_[k] - expected_[k] + std::log1p(squared) / 2;
      const double share = squared / (1 + squared) / 2;
      for (std::size_t u = 0; u < 2; ++u) {
        lengthBy[k][u] = share * (std::tan(gap[across]) * kGapBy[across][u] -
                                  std::tan(gap[before]) * kGapBy[before][u] - std::tan(gap[k]) * kGapBy[k][u]);
      }
    }
    const double mean = (lengths[0] + lengths[1] + lengths[2]) / 3;
    out.sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      out.off[k] = turn[k] / kTurned;
      out.off[k + 3] = (lengths[k] - mean) / uneven_;
      out.sum += out.off[k] * out.off[k] + out.off[k + 3] * out.off[k + 3];
      for (std::size_t u = 0; u < 2; ++u) {
        out.by[k][u] = kTurnBy[k][u] / kTurned;
        const double meanBy = (lengthBy[0][u] + lengthBy[1][u] + lengthBy[2][u]) / 3;
        out.by[k + 3][u] = (lengthBy[k][u] - meanBy) / uneven_;
      }
    }
    return out;
  }

  Three angles_{}, turn_{};
  Three drawn_{}, expected_{};  ///< ln length
  double uneven_ = kUneven;
};

/// Turns the directions of axes and gives them slopes; the sum, infinite where they are none.
double turn(Axes& axes, std::span<const Direction> directions) {
  std::ranges::sort(axes.direction, {}, [&](std::size_t d) { return directions[d].angle; });
  std::array<const Direction*, 3> of{};
  for (std::size_t k = 0; k < 3; ++k) of[k] = &directions[axes.direction[k]];
  Turning turning(of);
  const double sum = turning.solve();
  if (turning.mostTurned() >= kOneDirection) return std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 3; ++k) axes.unit[k] = {std::cos(turning.angle(k)), std::sin(turning.angle(k))};
  const auto a = [&](std::size_t m, std::size_t n) { return -dot(axes.unit[m], axes.unit[n]); };
  axes.slope[0] = std::sqrt(a(0, 1) * a(0, 2) / a(1, 2));
  axes.slope[1] = a(0, 1) / axes.slope[0];
  axes.slope[2] = a(0, 2) / axes.slope[0];
  return sum;
}

}  // namespace

Directions directionsOf(std::span<const SectionPoint> ways, const std::function<bool(std::size_t, std::size_t)>& meet) {
  Directions out;
  std::vector<Direction>& all = out.all;
  std::vector<std::vector<std::size_t>> members;
  std::vector<double> angles;
  for (const SectionPoint way : ways) {
    const double angle = std::atan2(way.y, way.x);
    angles.push_back(angle < 0 ? angle + kPi : angle);
  }
  std::vector<std::size_t> order(ways.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t e) { return angles[e]; });
  for (const std::size_t e : order) {
    const double length = norm(ways[e]);
    all.push_back({{}, angles[e], length, std::log(std::max(length, 1e-12)), 1});
    members.push_back({e});
  }
  const auto anyMeet = [&](const std::vector<std::size_t>& some, const std::vector<std::size_t>& others) {
    return std::ranges::any_of(
        some, [&](std::size_t e) { return std::ranges::any_of(others, [&](std::size_t f) { return meet(e, f); }); });
  };
  for (;;) {
    std::size_t one = 0, other = 0;
    double least = kOneDirection;
    for (std::size_t i = 0; i < all.size(); ++i) {
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        const double between = turnBetween(all[i], all[k]);
        if (between < least && !anyMeet(members[i], members[k]))
          std::tie(one, other, least) = std::tuple(i, k, between);
      }
    }
    if (one == other) break;
    all[one].angle = meanAngle(all[one], all[other]);
    all[one].length += all[other].length;
    all[one].logLengths += all[other].logLengths;
    all[one].edges += all[other].edges;
    members[one].insert(members[one].end(), members[other].begin(), members[other].end());
    all.erase(all.begin() + static_cast<std::ptrdiff_t>(other));
    members.erase(members.begin() + static_cast<std::ptrdiff_t>(other));
  }
  out.of.resize(ways.size());
  for (std::size_t d = 0; d < all.size(); ++d) {
    all[d].unit = {std::cos(all[d].angle), std::sin(all[d].angle)};
    for (const std::size_t e : members[d]) out.of[e] = d;
  }
  return out;
}

std::optional<std::size_t> goingBack(const Axes& axes, std::span<const Direction> directions) {
  std::array<std::size_t, 3> order{0, 1, 2};
  std::ranges::sort(order, {}, [&](std::size_t k) { return directions[axes.direction[k]].angle; });
  std::array<double, 3> angles{};
  for (std::size_t k = 0; k < 3; ++k) angles[k] = directions[axes.direction[order[k]]].angle;
  const auto front = frontOf(angles);
  return front ? std::optional(order[(*front + 2) % 3]) : std::nullopt;
}

std::optional<Axes> bestAxes(std::span<const Direction> directions, const std::function<double(const Axes&)>& score) {
  std::optional<Axes> best;
  std::pair most{0.0, 0.0};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = i + 1; j < directions.size(); ++j) {
      for (std::size_t k = j + 1; k < directions.size(); ++k) {
        Axes axes{{i, j, k}, {}, {}};
        const double points = score(axes);
        if (points <= 0 || points < most.first) continue;
        const double sum = turn(axes, directions);
        const std::pair now{points, -sum};
        if (!std::isfinite(sum) || (best && now <= most)) continue;
        best = axes;
        most = now;
      }
    }
  }
  return best;
}

}  // namespace spineloft::descriptive
