#include "engine/stack/rail_line.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/base/limits.h"
#include "engine/geometry/circle_cubic.h"
#include "engine/geometry/polyline.h"

namespace spineloft::stack {
namespace {

using Points = std::vector<ModelPoint>;

/// Tangents at the points: of the circle through each and its neighbours; at an end of the circle's other side.
Points tangentsOf(const Points& p, bool closed) {
  const std::size_t n = p.size();
  Points tangents(n);
  for (std::size_t i = 0; i < n; ++i) {
    if (closed || (i > 0 && i + 1 < n)) {
      tangents[i] = geometry::circleTangent(p[(i + n - 1) % n], p[i], p[(i + 1) % n]);
    }
  }
  if (closed) return tangents;
  const auto mirrored = [](ModelPoint tangent, ModelPoint chord) {
    const ModelPoint along = normalized(chord);
    return along * (2 * dot(along, tangent)) - tangent;
  };
  if (n == 2) {
    tangents[0] = tangents[1] = normalized(p[1] - p[0]);
  } else {
    tangents[0] = mirrored(tangents[1], p[1] - p[0]);
    tangents[n - 1] = mirrored(tangents[n - 2], p[n - 1] - p[n - 2]);
  }
  return tangents;
}

/// Samples from one of n points to the next.
std::size_t stepsOf(std::size_t n, bool closed) { return std::clamp<std::size_t>(1536 / (closed ? n : n - 1), 8, 192); }

/// The line densely; a closed one ends with its first point.
Points sampled(const Points& p, bool closed) {
  const std::size_t n = p.size(), arcs = closed ? n : n - 1, steps = stepsOf(n, closed);
  const Points tangents = tangentsOf(p, closed);
  Points line{p.front()};
  for (std::size_t i = 0; i < arcs; ++i) {
    const ModelPoint a = p[i], d = p[(i + 1) % n], chord = d - a;
    const ModelPoint b = a + geometry::circleHandle(chord, tangents[i]);
    const ModelPoint c = d - geometry::circleHandle(chord, tangents[(i + 1) % n]);
    for (std::size_t k = 1; k <= steps; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(steps), u = 1 - t;
      line.push_back(a * (u * u * u) + b * (3 * u * u * t) + c * (3 * u * t * t) + d * (t * t * t));
    }
  }
  if (closed) line.back() = line.front();
  return line;
}

}  // namespace

Result<RailLine> RailLine::of(const Rail& rail) {
  Points points = rail.points;
  geometry::dropRepeats(points, kSamePoint);
  if (rail.closed) {
    while (points.size() > 1 && distance(points.front(), points.back()) <= kSamePoint) points.pop_back();
  }
  if (points.size() < (rail.closed ? 3u : 2u)) {
    return {Error::StackInvalid, rail.closed ? "a closed rail needs three different points" : "the rail has no length"};
  }
  const Points line = sampled(points, rail.closed);
  RailLine out;
  out.closed_ = rail.closed;
  out.steps_ = stepsOf(points.size(), rail.closed);
  const ModelPoint way = normalized(line[1] - line[0]);
  constexpr double kAtViewer = 1e-6;
  const ModelPoint right = std::hypot(way.x, way.y) > kAtViewer ? ModelPoint{way.y, -way.x, 0} : ModelPoint{1, 0, 0};
  out.frames_ = geometry::minimalFrames(line, right, rail.closed);
  geometry::arcLengths(std::span<const ModelPoint>(line), out.lengths_);
  return out;
}

geometry::Frame RailLine::at(double share) const {
  share = closed_ ? share - std::floor(share) : std::clamp(share, 0.0, 1.0);
  const double wanted = share * length();
  const auto next = std::ranges::upper_bound(lengths_, wanted);
  const std::size_t j =
      std::clamp<std::size_t>(static_cast<std::size_t>(next - lengths_.begin()), 1, lengths_.size() - 1);
  const double step = lengths_[j] - lengths_[j - 1], t = step > 0 ? (wanted - lengths_[j - 1]) / step : 0;
  if (t <= 0) return frames_[j - 1];
  return t >= 1 ? frames_[j] : geometry::between(frames_[j - 1], frames_[j], t);
}

ModelPoint RailLine::bend(double share) const {
  constexpr double kReach = 0.01;
  const double from = closed_ ? share - kReach : std::max(0.0, share - kReach);
  const double to = closed_ ? share + kReach : std::min(1.0, share + kReach);
  return (at(to).tangent - at(from).tangent) / ((to - from) * length());
}

}  // namespace spineloft::stack
