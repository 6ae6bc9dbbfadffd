#include "engine/descriptive/axes.h"

#include <cmath>
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

std::optional<std::array<double, 3>> slopesOf(const Direction& one, const Direction& other, const Direction& last) {
  const double a = -dot(one.unit, other.unit), b = -dot(one.unit, last.unit), c = -dot(other.unit, last.unit);
  if (!(a * b * c > 0)) return std::nullopt;
  const double first = std::sqrt(a * b / c);
  const std::array<double, 3> slopes{first, a / first, b / first};
  const bool inRange = std::ranges::all_of(slopes, [](double s) { return std::abs(s) <= kMostSlope; });
  return inRange ? std::optional(slopes) : std::nullopt;
}

}  // namespace

Directions directionsOf(std::span<const SectionPoint> ways) {
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
    all.push_back({{}, angles[e], norm(ways[e])});
    members.push_back({e});
  }
  for (;;) {
    // The two nearest are neighbours round the circle.
    std::size_t one = 0, other = 0;
    double least = kOneDirection;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const std::size_t k = (i + 1) % all.size();
      const double turn = turnBetween(all[i], all[k]);
      if (i != k && turn < least) std::tie(one, other, least) = std::tuple(i, k, turn);
    }
    if (one == other) break;
    all[one].angle = meanAngle(all[one], all[other]);
    all[one].length += all[other].length;
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

std::optional<Axes> bestAxes(std::span<const Direction> directions, const std::function<double(const Axes&)>& score) {
  std::optional<Axes> best;
  std::pair most{0.0, 0.0};
  for (std::size_t i = 0; i < directions.size(); ++i) {
    for (std::size_t j = i + 1; j < directions.size(); ++j) {
      for (std::size_t k = j + 1; k < directions.size(); ++k) {
        const auto slopes = slopesOf(directions[i], directions[j], directions[k]);
        if (!slopes) continue;
        const Axes axes{{i, j, k}, *slopes};
        const double apart =
            std::min({turnBetween(directions[i], directions[j]), turnBetween(directions[i], directions[k]),
                      turnBetween(directions[j], directions[k])});
        const std::pair now{score(axes), apart};
        if (now.first <= 0 || now <= most) continue;
        best = axes;
        most = now;
      }
    }
  }
  return best;
}

}  // namespace spineloft::descriptive
