#include "engine/sections/symmetry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/geometry/polyline.h"

namespace spineloft::sections {
namespace {

constexpr double kPi = std::numbers::pi;
/// The end of a line this near a mirror is meant to be on it, section units.
constexpr double kReach = 0.12;
/// A line whose ends are nearer than this share of its length closes by itself.
constexpr double kOwnGap = 0.25;
/// A line that goes this share of the way to its next image is joined to it.
constexpr double kTurnShare = 0.6;

/// Cosine and sine whose zeros and ones are exact, so that mirrors and quarter turns are.
SectionPoint direction(double angle) {
  const auto exact = [](double v) {
    constexpr double kRounding = 1e-15;
    if (std::abs(v) < kRounding) return 0.0;
    return std::abs(std::abs(v) - 1) < kRounding ? std::copysign(1.0, v) : v;
  };
  return {exact(std::cos(angle)), exact(std::sin(angle))};
}

using Line = std::vector<SectionPoint>;

double lengthOf(const Line& line) { return geometry::arcLengths(std::span<const SectionPoint>(line)).back(); }

/// Goes on from the last point to `to` in steps of about `spacing`, `to` included.
void extend(Line& line, SectionPoint to, double spacing) {
  const SectionPoint from = line.back();
  const double way = distance(from, to);
  if (way < spacing * 1e-3) {
    line.back() = to;
    return;
  }
  const int steps = std::max(1, static_cast<int>(std::ceil(way / spacing)));
  for (int i = 1; i < steps; ++i) line.push_back(lerp(from, to, static_cast<double>(i) / steps));
  line.push_back(to);
}

/// The stretch of a line between two mirrors, moved into the first wedge.
struct Stretch {
  Line points;
  bool cutBefore = false, cutAfter = false;  ///< its ends cross a mirror
};

class Mirrors {
 public:
  Mirrors(const SymmetryGroup& group, double spacing) : group_(group), spacing_(spacing) {
    rays_[0] = direction(group.axis);
    rays_[1] = direction(group.axis + group.wedge());
  }

  Repeated repeat(const Line& line, bool closed) const {
    Stretch stretch = longestStretch(line, closed);
    Line& run = stretch.points;
    const bool whole = closed && !stretch.cutBefore;
    std::array<int, 2> ray{};
    std::array<bool, 2> on{};
    for (std::size_t end = 0; end < 2; ++end) {
      const SectionPoint p = end == 0 ? run.front() : run.back();
      ray[end] = nearestRay(p);
      on[end] =
          (end == 0 ? stretch.cutBefore : stretch.cutAfter) || (!closed && distance(p, onto(ray[end], p)) < kReach);
    }
    const bool selfClosed = distance(run.front(), run.back()) < kOwnGap * lengthOf(run);
    if (whole || run.size() < 3 || (!on[0] && !on[1] && selfClosed)) {
      const std::size_t length = run.size();
      return {{Chain{std::move(run), length, false}}, group_.motions()};
    }
    bringToMirror(run, ray[1], stretch.cutAfter);
    std::ranges::reverse(run);
    bringToMirror(run, ray[0], stretch.cutBefore);
    if (group_.order == 1) return {{joined(run, group_.motion(0, true))}, {Motion{}}};
    if (ray[0] == ray[1]) {
      Repeated out{{joined(run, group_.motion(ray[0] == 0 ? 0 : -1, true))}, {}};
      for (int k = 0; k < group_.order; ++k) out.copies.push_back(group_.motion(k, false));
      return out;
    }
    if (ray[0] == 0) std::ranges::reverse(run);  // it runs from the end to the start now
    return {{ring(run)}, {Motion{}}};
  }

 private:
  int wedgeOf(SectionPoint p) const {
    const double angle = std::atan2(p.y, p.x) - group_.axis;
    const int count = 2 * group_.order;
    const int wedge = static_cast<int>(std::floor(angle / group_.wedge()));
    return ((wedge % count) + count) % count;
  }
  /// The map that brings a wedge to the first place.
  Motion toFirst(int wedge) const {
    const int k = wedge / 2;
    return wedge % 2 == 0 ? group_.motion(-k, false) : group_.motion(-(k + 1), true);
  }
  /// The nearest point of a bounding ray of the first wedge (of the whole line with one mirror).
  SectionPoint onto(int ray, SectionPoint p) const {
    const SectionPoint d = rays_[static_cast<std::size_t>(ray)];
    const double along = dot(p, d);
    return d * (group_.order == 1 ? along : std::max(0.0, along));
  }
  int nearestRay(SectionPoint p) const {
    if (group_.order == 1) return 0;
    return distance(p, onto(1, p)) < distance(p, onto(0, p)) ? 1 : 0;
  }
  void bringToMirror(Line& run, int ray, bool cut) const {
    const SectionPoint to = onto(ray, run.back());
    if (cut) {
      run.back() = to;  // it was a sample away from it
    } else {
      extend(run, to, spacing_);
    }
  }
  /// The run and its mirror image, which share their ends.
  static Chain joined(const Line& run, const Motion& mirror) {
    Chain chain{Line(run.begin(), run.end() - 1), run.size() - 1, true};
    for (std::size_t i = run.size() - 1; i > 0; --i) chain.points.push_back(mirror(run[i]));
    return chain;
  }
  /// All images of a run from the first mirror to the second.
  Chain ring(const Line& run) const {
    Chain chain{{}, run.size() - 1, true};
    for (int k = 0; k < group_.order; ++k) {
      const Motion turn = group_.motion(k, false), mirror = group_.motion(-(k + 1), true);
      for (std::size_t i = 0; i + 1 < run.size(); ++i) chain.points.push_back(turn(run[i]));
      for (std::size_t i = run.size() - 1; i > 0; --i) chain.points.push_back(mirror(run[i]));
    }
    return chain;
  }

  Stretch longestStretch(const Line& line, bool closed) const {
    const std::size_t n = line.size();
    std::vector<int> wedges(n);
    for (std::size_t i = 0; i < n; ++i) wedges[i] = wedgeOf(line[i]);
    std::size_t first = 0;  // a closed line is read from one of its changes on
    if (closed) {
      while (first < n && wedges[first] == wedges[(first + n - 1) % n]) ++first;
      if (first == n) return {inFirst(line, 0, n, wedges[0]), false, false};
    }
    Stretch best;
    double bestLength = -1;
    for (std::size_t begin = 0; begin < n;) {
      const int wedge = wedges[(first + begin) % n];
      std::size_t end = begin + 1;
      while (end < n && wedges[(first + end) % n] == wedge) ++end;
      Line run = inFirst(line, first + begin, first + end, wedge);
      if (const double length = lengthOf(run); length > bestLength) {
        bestLength = length;
        best = {std::move(run), closed || begin > 0, closed || end < n};
      }
      begin = end;
    }
    return best;
  }
  Line inFirst(const Line& line, std::size_t begin, std::size_t end, int wedge) const {
    const Motion motion = toFirst(wedge);
    Line out;
    for (std::size_t i = begin; i < end; ++i) out.push_back(motion(line[i % line.size()]));
    return out;
  }

  const SymmetryGroup& group_;
  double spacing_;
  std::array<SectionPoint, 2> rays_;
};

Repeated repeatInTurns(const SymmetryGroup& group, const Line& line, bool closed) {
  std::vector<double> swept(line.size(), 0.0);
  for (std::size_t i = 1; i < line.size(); ++i) {
    swept[i] = swept[i - 1] + std::atan2(cross(line[i - 1], line[i]), dot(line[i - 1], line[i]));
  }
  const double sector = 2 * kPi / group.order, all = swept.back();
  const bool goesRound = closed ? std::abs(all) > kPi : std::abs(all) > kTurnShare * sector;
  if (!goesRound) return {{Chain{line, line.size(), false}}, group.motions()};
  const auto reached = std::ranges::find_if(swept, [&](double angle) { return std::abs(angle) >= sector; });
  const auto last = std::min<std::ptrdiff_t>(reached - swept.begin(), std::ssize(line) - 1);
  Line run(line.begin(), line.begin() + last + 1);
  const int way = all > 0 ? 1 : -1;
  const std::vector<double> s = geometry::arcLengths(std::span<const SectionPoint>(run));
  const SectionPoint gap = group.motion(way, false)(run.front()) - run.back();
  Chain chain{{}, run.size() - 1, false};
  for (std::size_t i = 0; i < run.size(); ++i) run[i] += gap * (s[i] / s.back());
  for (int k = 0; k < group.order; ++k) {
    const Motion turn = group.motion(k * way, false);
    for (std::size_t i = 0; i + 1 < run.size(); ++i) chain.points.push_back(turn(run[i]));
  }
  return {{std::move(chain)}, {Motion{}}};
}

}  // namespace

Motion SymmetryGroup::motion(int k, bool mirror) const {
  const int turns = ((k % order) + order) % order;
  const SectionPoint d = direction(2 * kPi * turns / order);
  Motion out{d.x, d.y, 1, 1};
  if (mirror) (axis == 0 ? out.mirrorY : out.mirrorX) = -1;
  return out;
}

std::vector<Motion> SymmetryGroup::motions() const {
  std::vector<Motion> out;
  for (int k = 0; k < order; ++k) out.push_back(motion(k, false));
  for (int k = 0; mirrored && k < order; ++k) out.push_back(motion(k, true));
  return out;
}

double SymmetryGroup::wedge() const { return kPi / order; }

SymmetryGroup groupOf(const Symmetry& symmetry) {
  SymmetryGroup group;
  group.order = std::clamp(symmetry.fold, 1, kMostFold);
  group.mirrored = symmetry.leftRight || symmetry.frontBack;
  if (symmetry.leftRight && symmetry.frontBack && group.order % 2 != 0) group.order *= 2;
  group.axis = symmetry.leftRight ? kPi / 2 : 0;
  return group;
}

std::vector<std::size_t> Chain::imagesOf(std::size_t step) const {
  std::vector<std::size_t> out;
  const std::size_t total = points.size(), count = length > 0 ? total / length : 0;
  for (std::size_t copy = 0; copy < count; ++copy) {
    const bool back = alternating && copy % 2 == 1;
    out.push_back((copy * length + (back ? length - step : step)) % total);
  }
  std::ranges::sort(out);
  out.erase(std::ranges::unique(out).begin(), out.end());
  return out;
}

Repeated repeat(const std::vector<SectionPoint>& line, bool closed, double spacing, const Symmetry& symmetry) {
  const SymmetryGroup group = groupOf(symmetry);
  if (group.mirrored) return Mirrors(group, spacing).repeat(line, closed);
  if (group.order > 1) return repeatInTurns(group, line, closed);
  return {{Chain{line, line.size(), false}}, {Motion{}}};
}

}  // namespace spineloft::sections
