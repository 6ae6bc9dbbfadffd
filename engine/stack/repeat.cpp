#include "engine/stack/repeat.h"

#include <algorithm>
#include <cstdint>

namespace spineloft::stack {
namespace {

/// How far beyond the end of the rail the last copy may stand: share texts round to 7 digits.
constexpr double kRounding = 1e-6;

Failure wrong(std::size_t pattern, const std::string& what) {
  return {Error::StackInvalid, "pattern " + std::to_string(pattern + 1) + " " + what};
}
std::string sheet(std::uint64_t number) { return "sheet " + std::to_string(number + 1); }

/// Of one pattern alone.
Status checkPattern(const std::vector<Plane>& planes, const Pattern& pattern, std::size_t number) {
  const auto& [first, last, times, spacing] = pattern;
  if (first > last) {
    return wrong(number,
                 "goes from " + sheet(first) + " back to " + sheet(last) + ": let it end where it begins or later");
  }
  if (last >= planes.size()) {
    return wrong(number, "ends with " + sheet(last) + ", but there are " + std::to_string(planes.size()) +
                             ": let it end earlier, or draw more");
  }
  for (std::size_t i = first; i <= last; ++i) {
    if (planes[i].origin) {
      return wrong(number, "repeats " + sheet(i) + ", which stands beside the rail: take its origin away");
    }
  }
  if (times < 1 || times > kMostTimes) {
    return wrong(number, "is repeated " + std::to_string(times) + " times: choose 1 to " + std::to_string(kMostTimes));
  }
  if (times == 1) return Done{};
  if (first == last && !(spacing > 0)) return wrong(number, "has no spacing: give it one above 0");
  if (!(spacing > planes[last].at - planes[first].at)) {
    return wrong(number, "stands in its own way: make its spacing larger than the way from " + sheet(first) + " to " +
                             sheet(last));
  }
  if (planes[last].at + (times - 1) * spacing > 1 + kRounding) {
    return wrong(number, "goes beyond the end of the rail: repeat it fewer times, or closer together");
  }
  return Done{};
}

}  // namespace

Status checkPatterns(const std::vector<Plane>& planes, const std::vector<Pattern>& patterns) {
  std::vector<std::size_t> times(planes.size(), 1), by(planes.size(), patterns.size());
  for (std::size_t p = 0; p < patterns.size(); ++p) {
    if (Status one = checkPattern(planes, patterns[p], p); !one) return one;
    for (std::size_t i = patterns[p].first; i <= patterns[p].last; ++i) {
      if (by[i] < patterns.size()) {
        return wrong(p, "repeats " + sheet(i) + ", as pattern " + std::to_string(by[i] + 1) +
                            " does: let each repeat sheets of its own");
      }
      by[i] = p;
      times[i] = patterns[p].times;
    }
  }
  std::size_t curves = 0, points = 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    curves += times[i] * planes[i].curves.size();
    for (const Curve& curve : planes[i].curves) points += times[i] * curve.through.size();
  }
  if (!patterns.empty() && (curves > kMostStanding || points > kMostPoints)) {
    return {Error::StackInvalid, "the patterns make " + std::to_string(curves) + " curves of " +
                                     std::to_string(points) +
                                     " points; 256 of 50,000 points are the most: repeat "
                                     "fewer times"};
  }
  return Done{};
}

std::vector<Standing> writtenOut(const std::vector<Plane>& planes, const std::vector<Pattern>& patterns) {
  std::vector<Standing> out;
  for (std::size_t i = 0; i < planes.size();) {
    const auto pattern = std::ranges::find(patterns, i, [](const Pattern& p) -> std::size_t { return p.first; });
    const Pattern run =
        pattern != patterns.end() ? *pattern : Pattern{static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i)};
    for (std::size_t copy = 0; copy < run.times; ++copy) {
      for (std::size_t k = run.first; k <= run.last; ++k) {
        const double at = planes[k].at + static_cast<double>(copy) * run.spacing;
        out.push_back({k, copy, copy == 0 ? planes[k].at : std::min(at, 1.0)});
      }
    }
    i = run.last + std::size_t{1};
  }
  return out;
}

std::string nameOf(const Standing& plane) {
  return sheet(plane.number) + (plane.copy > 0 ? " in repeat " + std::to_string(plane.copy + 1) : "");
}

}  // namespace spineloft::stack
