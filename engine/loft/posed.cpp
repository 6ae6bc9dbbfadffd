#include "engine/loft/posed.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/limits.h"

namespace spineloft::loft {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
/// Points of a line before it is refined.
constexpr std::size_t kLeastPoints = 64;
/// As ribs::SpineParams::smoothness.
constexpr double kSmoothness = 0.1;
constexpr double kFarOut = 1e6;  ///< picture pixels: beyond it floats are too coarse

using Plane = std::vector<PicturePoint>;
using Line = std::vector<ModelPoint>;

using geometry::lengthOf;

/// A stroke made even and smooth, as cleanSpine does it but for hooks and the picture's frame.
Status cleaned(const Plane& stroke, std::size_t count, geometry::StrokeMemory& memory, Plane& points) {
  points.clear();
  for (const PicturePoint& p : stroke) {
    if (!isFinite(p)) return Error::StrokeNotFinite;
    points.push_back({std::clamp(p.x, -kFarOut, kFarOut), std::clamp(p.y, -kFarOut, kFarOut)});
  }
  const bool backwards = !geometry::readsForwards(points);
  if (backwards) std::ranges::reverse(points);
  geometry::dropRepeats(points, kSamePoint);
  if (points.size() < 2) return Error::StrokeTooShort;
  // Even twice: the first time cuts corners between points that were far apart.
  for (int i = 0; i < 2; ++i) geometry::spreadEvenly(points, geometry::kStrokePoints, memory);
  geometry::smoothWobble(points, kSmoothness, memory);
  if (!(lengthOf(points) > kSamePoint)) return Error::StrokeTooShort;
  geometry::spreadEvenly(points, count, memory);
  if (backwards) std::ranges::reverse(points);
  return Done{};
}

/// Bends an even line until its ends meet: its turning becomes that of a ring, spread evenly, and what
/// is then left open is taken back evenly.
Plane closed(const Plane& line) {
  const std::size_t steps = line.size() - 1;
  const double count = static_cast<double>(steps), length = lengthOf(line);
  std::vector<double> heading(steps);
  for (std::size_t i = 0; i < steps; ++i) {
    const PicturePoint step = line[i + 1] - line[i];
    const double angle = std::atan2(step.y, step.x);
    heading[i] = i == 0 ? angle : heading[i - 1] + std::remainder(angle - heading[i - 1], kTurn);
  }
  const double turning = heading.back() - heading.front();
  double rounds = std::round(turning / kTurn);
  constexpr double kNearlyMet = 0.2;  // share of the length: an eight is not made a circle
  if (rounds == 0 && distance(line.front(), line.back()) > kNearlyMet * length) {
    rounds = turning < 0 ? -1 : 1;
  }
  const double missing = kTurn * rounds * (count - 1) / count - turning;
  Plane ring = {line.front()};
  PicturePoint before, after;
  for (std::size_t i = 0; i < steps; ++i) {
    const double angle = heading[i] + missing * static_cast<double>(i) / (count - 1);
    ring.push_back(ring.back() + PicturePoint{std::cos(angle), std::sin(angle)} * (length / count));
  }
  const PicturePoint gap = ring.back() - ring.front();
  for (std::size_t i = 0; i <= steps; ++i) {
    ring[i] = ring[i] - gap * (static_cast<double>(i) / count);
    before += line[i] / (count + 1);
    after += ring[i] / (count + 1);
  }
  for (PicturePoint& p : ring) p += before - after;
  ring.back() = ring.front();
  return ring;
}

/// `pieces` points from each point to the next on a smooth curve (Catmull and Rom 1974), in ModelSpace.
void refine(const Plane& points, std::size_t pieces, bool ring, Line& line) {
  const std::size_t n = points.size();
  const auto at = [&](std::ptrdiff_t i) {
    const auto last = static_cast<std::ptrdiff_t>(n) - 1;
    if (ring) return points[static_cast<std::size_t>((i + last) % last)];
    if (i < 0) return points[0] * 2.0 - points[1];
    if (i > last) return points[n - 1] * 2.0 - points[n - 2];
    return points[static_cast<std::size_t>(i)];
  };
  line.clear();
  line.reserve((n - 1) * pieces + 1);
  for (std::ptrdiff_t i = 0; i + 1 < static_cast<std::ptrdiff_t>(n); ++i) {
    const PicturePoint a = at(i), b = at(i + 1);
    const PicturePoint ma = (b - at(i - 1)) / 2, mb = (at(i + 2) - a) / 2;
    for (std::size_t k = 0; k < pieces; ++k) {
      const double t = static_cast<double>(k) / static_cast<double>(pieces), u = 1 - t;
      const PicturePoint p =
          a * (u * u * (1 + 2 * t)) + ma * (t * u * u) + b * (t * t * (3 - 2 * t)) - mb * (t * t * u);
      line.push_back({p.x, -p.y, 0});
    }
  }
  line.push_back(ring ? line.front() : ModelPoint{points.back().x, -points.back().y, 0});
}

/// The direction of ribs in the picture's plane: to the right of travel.
ModelPoint ribDirection(const Line& line) {
  const ModelPoint travel = line[1] - line[0];
  const ModelPoint right{travel.y, -travel.x, 0};
  return norm(right) > 0 ? right : ModelPoint{0, -1, 0};
}

double smoothStep(double t) {
  t = std::clamp(t, 0.0, 1.0);
  return t * t * t * (10 + t * (6 * t - 15));
}

void wind(Line& line, const Pose& pose, ModelPoint across) {
  double turns = pose.coilTurns;
  if (pose.closed) turns = turns < 0 ? std::min(-1.0, std::round(turns)) : std::max(1.0, std::round(turns));
  const double many = std::abs(turns);
  // Shares of the length over which the radius grows: half a turn, less when a whole one would not be
  // left, and never a jump.
  const double ease = std::max(std::clamp((many - 1) / 2, 0.0, 0.5) / many, std::min(0.15, 0.15 / many));
  const std::vector<geometry::Frame> frames = geometry::minimalFrames(line, across, pose.closed);
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(line.size() - 1);
    const double grown = pose.closed ? 1 : smoothStep(t / ease) * smoothStep((1 - t) / ease);
    const double angle = kTurn * turns * t, radius = pose.coilRadius * grown;
    line[i] += frames[i].across * (radius * std::cos(angle)) + frames[i].depth * (radius * std::sin(angle));
  }
  if (pose.closed) line.back() = line.front();
}

geometry::Frame frameAt(const std::vector<geometry::Frame>& frames, double share) {
  const double at = std::clamp(share, 0.0, 1.0) * static_cast<double>(frames.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), frames.size() - 2);
  const double t = at - static_cast<double>(i);
  return t == 0 ? frames[i] : t == 1 ? frames[i + 1] : geometry::between(frames[i], frames[i + 1], t);
}

ModelPoint inModel(PicturePoint p) { return {p.x, -p.y, 0}; }

}  // namespace

Result<PosedSpine> poseSpine(const ribs::Spine& rest, const Pose& pose) {
  PoseMemory memory;
  PosedSpine spine;
  const Status posed = poseSpine(rest, pose, memory, spine);
  if (!posed.ok()) return posed.failure();
  return spine;
}

Status poseSpine(const ribs::Spine& rest, const Pose& pose, PoseMemory& memory, PosedSpine& spine) {
  if (!isValid(pose)) return {Error::ValueOutOfRange, "pose"};
  if (rest.points.size() < 2) return Error::StrokeTooShort;
  const bool coil = pose.coilTurns != 0 && pose.coilRadius > 0;
  spine.scale = 1;
  spine.closed = pose.closed;
  spine.moved = !pose.stroke.empty() || !pose.depth.empty() || coil || pose.closed;
  Plane &traced = memory.traced, &line = memory.line;
  if (rest.points.size() < kLeastPoints) {
    geometry::resample(std::span<const PicturePoint>(rest.points), kLeastPoints, memory.stroke.lengths, traced);
  } else {
    traced = rest.points;
  }
  if (!pose.stroke.empty()) {
    const Status drawn = cleaned(pose.stroke, traced.size(), memory.stroke, line);
    if (!drawn.ok()) return drawn;
    spine.scale = lengthOf(line) / lengthOf(traced);
  } else {
    line = traced;
  }
  if (pose.closed) line = closed(line);
  constexpr double kPointsATurn = 96;
  const double wanted = std::max(256.0, kPointsATurn * (coil ? std::abs(pose.coilTurns) : 0));
  const auto pieces = static_cast<std::size_t>(std::ceil(wanted / static_cast<double>(line.size() - 1)));
  Line& refined = memory.refined;
  refine(traced, pieces, false, refined);
  geometry::minimalFrames(refined, ribDirection(refined), false, memory.tangents, spine.rest);
  if (!spine.moved) {
    spine.posed = spine.rest;
    return Done{};
  }
  refine(line, pieces, pose.closed, refined);
  const ModelPoint across = ribDirection(refined);
  const double first = geometry::valueAt(pose.depth, 0, 0), last = geometry::valueAt(pose.depth, 1, 0);
  for (std::size_t i = 0; i < refined.size(); ++i) {
    const double t = static_cast<double>(i) / static_cast<double>(refined.size() - 1);
    refined[i].z = geometry::valueAt(pose.depth, t, 0) - (pose.closed ? t * (last - first) : 0);
  }
  if (coil) wind(refined, pose, across);
  geometry::minimalFrames(refined, across, pose.closed, memory.tangents, spine.posed);
  return Done{};
}

double shareAt(const PosedSpine& spine, PicturePoint p) {
  const ModelPoint point = inModel(p);
  double least = std::numeric_limits<double>::infinity(), best = 0;
  for (std::size_t i = 0; i + 1 < spine.rest.size(); ++i) {
    const ModelPoint a = spine.rest[i].at, along = spine.rest[i + 1].at - a;
    const double squared = dot(along, along);
    const double t = squared > 0 ? std::clamp(dot(point - a, along) / squared, 0.0, 1.0) : 0;
    const ModelPoint off = point - a - along * t;
    if (dot(off, off) < least) {
      least = dot(off, off);
      best = static_cast<double>(i) + t;
    }
  }
  return best / static_cast<double>(spine.rest.size() - 1);
}

ModelPoint carried(const PosedSpine& spine, double at, PicturePoint p, double height) {
  if (!spine.moved) return {p.x, -p.y, height};
  const geometry::Frame from = frameAt(spine.rest, at), to = frameAt(spine.posed, at);
  const ModelPoint off = inModel(p) - from.at;
  return to.at +
         (to.tangent * dot(off, from.tangent) + to.across * dot(off, from.across) + to.depth * height) * spine.scale;
}

std::optional<PicturePoint> atRest(const PosedSpine& spine, double at, PicturePoint seen) {
  if (!spine.moved) return seen;
  const geometry::Frame from = frameAt(spine.rest, at), to = frameAt(spine.posed, at);
  const double area = to.tangent.x * to.across.y - to.tangent.y * to.across.x;
  constexpr double kEdgeOn = 0.05;  // sine of the angle under which the frame's plane is seen
  if (std::abs(area) < kEdgeOn) return std::nullopt;
  const ModelPoint off = (inModel(seen) - to.at) / spine.scale;
  const double along = (off.x * to.across.y - off.y * to.across.x) / area;
  const double out = (to.tangent.x * off.y - to.tangent.y * off.x) / area;
  const ModelPoint p = from.at + from.tangent * along + from.across * out;
  return PicturePoint{p.x, -p.y};
}

ribs::RibSet poseRibs(const PosedSpine& spine, const ribs::RibSet& ribs) {
  ribs::RibSet out = ribs;
  carryRibs(spine, out);
  return out;
}

void carryRibs(const PosedSpine& spine, ribs::RibSet& out) {
  if (!spine.moved) return;
  const auto move = [&](double at, PicturePoint& p) {
    const ModelPoint q = carried(spine, at, p);
    p = {q.x, -q.y};
  };
  for (ribs::Rib& rib : out.ribs) {
    const double at = shareAt(spine, rib.center);
    for (PicturePoint* p : {&rib.center, &rib.left, &rib.right}) move(at, *p);
    for (ribs::OtherPlaces* others : {&rib.leftOthers, &rib.rightOthers}) {
      for (int i = 0; i < others->count; ++i) move(at, others->at[static_cast<std::size_t>(i)]);
    }
  }
  for (PicturePoint& p : out.startFan.points) move(0, p);
  for (PicturePoint& p : out.endFan.points) move(1, p);
}

std::vector<ModelPoint> centreLine(const PosedSpine& spine, std::size_t count) {
  std::vector<ModelPoint> line;
  centreLine(spine, count, line);
  return line;
}

void centreLine(const PosedSpine& spine, std::size_t count, std::vector<ModelPoint>& line) {
  line.clear();
  for (std::size_t i = 0; i < count; ++i) {
    line.push_back(frameAt(spine.posed, static_cast<double>(i) / static_cast<double>(count - 1)).at);
  }
}

}  // namespace spineloft::loft
