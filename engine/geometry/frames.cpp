#include "engine/geometry/frames.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::geometry {
namespace {

/// v mirrored in the plane square to `normal` (any length but 0).
ModelPoint mirrored(ModelPoint v, ModelPoint normal) {
  const double squared = dot(normal, normal);
  return squared > 0 ? v - normal * (2 * dot(normal, v) / squared) : v;
}

ModelPoint squareTo(ModelPoint tangent, ModelPoint direction) {
  const ModelPoint across = direction - tangent * dot(direction, tangent);
  if (norm(across) > 1e-6 * norm(direction)) return normalized(across);
  const ModelPoint other = std::abs(tangent.x) < 0.7 ? ModelPoint{1, 0, 0} : ModelPoint{0, 1, 0};
  return normalized(other - tangent * dot(other, tangent));
}

Frame frameOf(ModelPoint at, ModelPoint tangent, ModelPoint across) {
  return {at, tangent, across, cross(across, tangent)};
}

/// `direction` turned about the unit `axis`, to which it is square.
ModelPoint turned(ModelPoint direction, ModelPoint axis, double angle) {
  return direction * std::cos(angle) + cross(axis, direction) * std::sin(angle);
}

/// Derivative at b of the parabola through a, b, c over the distances between them.
ModelPoint slopeAt(ModelPoint a, ModelPoint b, ModelPoint c) {
  const double before = distance(a, b), after = distance(b, c);
  if (!(before > 0) || !(after > 0)) return c - a;
  return (b - a) * (after / before) + (c - b) * (before / after);
}

/// The same at the end a of the line a, b, c.
ModelPoint slopeAtEnd(ModelPoint a, ModelPoint b, ModelPoint c) {
  const ModelPoint first = normalized(b - a);
  const ModelPoint middle = normalized(slopeAt(a, b, c));
  return first * 2.0 - middle;  // the parabola's tangent at a is that of a→b mirrored
}

/// Takes back evenly what the frames have turned by after one round.
void spreadHolonomy(std::vector<Frame>& frames) {
  const Frame first = frames.front(), last = frames.back();
  const double angle = std::atan2(dot(cross(last.across, first.across), first.tangent), dot(last.across, first.across));
  std::vector<double> along(frames.size(), 0.0);
  for (std::size_t i = 1; i < frames.size(); ++i) {
    along[i] = along[i - 1] + distance(frames[i - 1].at, frames[i].at);
  }
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Frame& frame = frames[i];
    frame = frameOf(frame.at, frame.tangent, turned(frame.across, frame.tangent, angle * along[i] / along.back()));
  }
  frames.back() = frames.front();
}

}  // namespace

Frame between(const Frame& a, const Frame& b, double t) {
  const ModelPoint tangent = normalized(lerp(a.tangent, b.tangent, t));
  return frameOf(lerp(a.at, b.at, t), tangent, squareTo(tangent, lerp(a.across, b.across, t)));
}

void tangentsOf(std::span<const ModelPoint> line, bool closed, std::vector<ModelPoint>& tangents) {
  const std::size_t n = line.size();
  tangents.assign(n, {});
  for (std::size_t i = 1; i + 1 < n; ++i) {
    tangents[i] = normalized(slopeAt(line[i - 1], line[i], line[i + 1]));
  }
  if (n < 3) {
    tangents.front() = tangents.back() = normalized(line.back() - line.front());
  } else if (closed) {
    tangents.front() = tangents.back() = normalized(slopeAt(line[n - 2], line[0], line[1]));
  } else {
    tangents.front() = normalized(slopeAtEnd(line[0], line[1], line[2]));
    tangents.back() = normalized(-slopeAtEnd(line[n - 1], line[n - 2], line[n - 3]));
  }
  for (std::size_t i = 0; i < n; ++i) {  // a line that turns straight back has no parabola
    if (tangents[i] == ModelPoint{}) {
      tangents[i] = normalized(i + 1 < n ? line[i + 1] - line[i] : line[i] - line[i - 1]);
    }
  }
}

std::vector<Frame> minimalFrames(std::span<const ModelPoint> line, ModelPoint firstAcross, bool closed) {
  std::vector<ModelPoint> tangents;
  std::vector<Frame> frames;
  minimalFrames(line, firstAcross, closed, tangents, frames);
  return frames;
}

void minimalFrames(std::span<const ModelPoint> line, ModelPoint firstAcross, bool closed,
                   std::vector<ModelPoint>& tangents, std::vector<Frame>& frames) {
  tangentsOf(line, closed, tangents);
  frames.clear();
  frames.reserve(line.size());
  frames.push_back(frameOf(line[0], tangents[0], squareTo(tangents[0], firstAcross)));
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Frame& last = frames.back();
    // Wang et al. 2008, table I: a mirror that takes point i − 1 to point i, then one that takes the
    // mirrored tangent to the true one.
    const ModelPoint step = line[i] - line[i - 1];
    const ModelPoint across = mirrored(last.across, step), tangent = mirrored(last.tangent, step);
    const ModelPoint moved = mirrored(across, tangents[i] - tangent);
    frames.push_back(frameOf(line[i], tangents[i], squareTo(tangents[i], moved)));
  }
  if (closed) spreadHolonomy(frames);
}

}  // namespace spineloft::geometry
