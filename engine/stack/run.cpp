#include "engine/stack/run.h"

#include <algorithm>

namespace spineloft::stack {

std::uint32_t timesOf(const std::vector<Plane>& planes, const std::vector<Pattern>& patterns) {
  if (patterns.empty()) return 1;
  const Pattern& only = patterns.front();
  return patterns.size() == 1 && only.first == 0 && std::size_t{only.last} + 1 == planes.size() ? only.times : 0;
}

bool canRepeat(const std::vector<Plane>& planes, const Rail& rail, const std::vector<Pattern>& patterns) {
  if (planes.size() < 2 || rail.points.size() < 2 || timesOf(planes, patterns) == 0) return false;
  if (std::ranges::any_of(planes, [](const Plane& plane) { return plane.origin.has_value(); })) return false;
  return std::ranges::adjacent_find(planes, std::ranges::greater_equal{}, &Plane::at) == planes.end();
}

void repeatAll(const Run& run, std::uint32_t times) {
  auto& [planes, rail, patterns] = run;
  const double first = planes.front().at, span = planes.back().at - first;
  const auto count = static_cast<double>(planes.size());
  double period = span * count / (count - 1);
  const double whole = rail.closed ? times * period : span + (times - 1) * period;
  if (rail.points.size() == 2 && !rail.closed) {
    const double longer = first + whole;
    rail.points[1] = rail.points[0] + (rail.points[1] - rail.points[0]) * longer;
    for (Plane& plane : planes) plane.at /= longer;
    period /= longer;
  } else {
    const double start = rail.closed ? std::min(first, 1 / (times * count)) : first;
    const double closer = (rail.closed ? 1 : 1 - first) / whole;
    for (Plane& plane : planes) plane.at = start + (plane.at - first) * closer;
    period *= closer;
  }
  patterns.clear();
  if (times > 1) patterns.push_back({0, static_cast<std::uint32_t>(planes.size() - 1), times, period});
}

}  // namespace spineloft::stack
