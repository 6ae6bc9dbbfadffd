#include "engine/bridge/bridge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <optional>
#include <utility>

#include "engine/bridge/tube.h"
#include "engine/geometry/hermite.h"
#include "engine/geometry/polyline.h"
#include "engine/mesh/ray_hit.h"
#include "engine/mesh/self_crossing.h"
#include "engine/mesh/surface_places.h"

namespace spineloft::bridge {
namespace {

constexpr std::size_t kSides = 64;
// What is tried until a tube does not go through itself: how much thinner its middle is, as a share of what is asked
// for, and how far it goes out, times what is asked for or (`arc`) the arc of a circle.
struct Try {
  double flare, bow;
  bool arc;
};
constexpr Try kTries[] = {{1, 1, false}, {0.5, 1, false}, {0.25, 1, false}, {1, 1, true}, {0.5, 1, true}, {1, 3, true}};

std::vector<ModelPoint> evenly(std::vector<ModelPoint> ring) {
  ring.push_back(ring.front());
  std::vector<ModelPoint> even = geometry::resample(std::span<const ModelPoint>(ring), kSides + 1);
  even.pop_back();
  return even;
}

// A closed line through the same places that is smooth there: cubics with the slopes of parabolas.
std::vector<ModelPoint> smoothThrough(std::span<const ModelPoint> line) {
  constexpr std::size_t kEach = 8;
  std::vector<ModelPoint> places(line.begin(), line.end());
  geometry::dropRepeats(places, 0);
  const std::size_t n = places.size();
  const auto at = [&](std::size_t i) { return places[i % n]; };
  std::vector<ModelPoint> smooth;
  for (std::size_t i = 0; n > 2 && i < n; ++i) {
    const ModelPoint a = at(i + n - 1), b = at(i), c = at(i + 1), d = at(i + 2);
    const double before = distance(a, b), length = distance(b, c), after = distance(c, d);
    if (!(before > 0 && length > 0 && after > 0)) continue;
    const ModelPoint from = geometry::parabolaSlope(a, b, c, before, length) * length;
    const ModelPoint to = geometry::parabolaSlope(b, c, d, length, after) * length;
    for (std::size_t k = 0; k < kEach; ++k) {
      smooth.push_back(geometry::hermite(b, c, from, to, static_cast<double>(k) / kEach));
    }
  }
  return smooth;
}

// The nearest places of a closed line, evenly spaced on the surface. None: it has no length there.
std::optional<std::vector<ModelPoint>> layRim(const mesh::SurfacePlaces& places, std::span<const ModelPoint> line) {
  std::vector<ModelPoint> ring = smoothThrough(line);
  if (ring.empty()) return std::nullopt;
  for (int pass = 0; pass < 2; ++pass) {
    ring = evenly(std::move(ring));
    std::optional<mesh::SurfacePlace> place;
    for (ModelPoint& p : ring) {
      place = places.nearest(p, place);
      if (!place) return std::nullopt;
      p = place->at;
    }
  }
  return ring;
}

// Newell's normal of a closed line; its length is the area within.
ModelPoint newellNormal(std::span<const ModelPoint> ring) {
  ModelPoint sum;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    sum += cross(ring[i] - ring[0], ring[(i + 1) % ring.size()] - ring[0]) / 2;
  }
  return sum;
}

ModelPoint meanOf(std::span<const ModelPoint> points) {
  ModelPoint sum;
  for (const ModelPoint p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

// A rim as it lies on its host.
struct Laid {
  std::vector<ModelPoint> points, normals;
  ModelPoint centre, area;  // of Newell
  double radius = 0;        // of the points, in the mean
};

// Along a closed line, so that a tube does not show the facets of its host as ridges: over about two points.
void smooth(std::vector<ModelPoint>& normals) {
  constexpr int kPasses = 8;
  std::vector<ModelPoint> before;
  for (int pass = 0; pass < kPasses; ++pass) {
    before = normals;
    for (std::size_t i = 0; i < kSides; ++i) {
      normals[i] = normalized(before[(i + kSides - 1) % kSides] + before[i] * 2 + before[(i + 1) % kSides]);
    }
  }
}

Result<Laid> lay(const Host& host) {
  const mesh::SurfacePlaces places(host.mesh);
  auto points = layRim(places, host.rim);
  if (!points) return {Error::BridgeInvalid, "a rim is no line on a surface"};
  Laid laid;
  laid.points = std::move(*points);
  laid.centre = meanOf(laid.points);
  laid.area = newellNormal(laid.points);
  double length = 0;
  for (std::size_t i = 0; i < kSides; ++i) {
    laid.radius += distance(laid.points[i], laid.centre) / kSides;
    length += distance(laid.points[i], laid.points[(i + 1) % kSides]);
  }
  // A circle has 1/4π of its squared length.
  constexpr double kLeastArea = 0.003;
  if (!(norm(laid.area) > kLeastArea * length * length)) return {Error::BridgeInvalid, "a rim has no inside"};
  for (const ModelPoint p : laid.points) laid.normals.push_back(places.meanNormal(p, length / kSides / 2));
  smooth(laid.normals);
  return laid;
}

// The unit direction in which a tube leaves a rim: off the surface; of a rim round an arm, towards `other`.
ModelPoint outOf(const Laid& rim, ModelPoint other) {
  const ModelPoint across = normalized(rim.area), normal = meanOf(rim.normals);
  constexpr double kPatch = 0.3;
  const double off = dot(normal, across);
  const double side = std::abs(off) >= kPatch ? off : dot(other - rim.centre, across);
  return side < 0 ? -across : across;
}

void reverse(Laid& rim) {
  std::ranges::reverse(rim.points);
  std::ranges::reverse(rim.normals);
  rim.area = -rim.area;
}

// Unit vectors on the surface, square to the rim, to the side on which the tube lies: within the rim and ahead.
std::vector<ModelPoint> coNormals(const Laid& rim, ModelPoint out) {
  std::vector<ModelPoint> inward(kSides);
  double side = 0;
  for (std::size_t i = 0; i < kSides; ++i) {
    const ModelPoint along = rim.points[(i + 1) % kSides] - rim.points[(i + kSides - 1) % kSides];
    inward[i] = normalized(cross(rim.normals[i], along));
    side += dot(inward[i], normalized(rim.centre - rim.points[i]) + out);
  }
  if (side < 0) {
    for (ModelPoint& v : inward) v = -v;
  }
  return inward;
}

// How far a chord of the rim lies above the surface, at most: 0 where that is convex.
double sagOf(const Laid& rim) {
  double sag = 0;
  for (std::size_t i = 0; i < kSides; ++i) {
    const std::size_t next = (i + 1) % kSides;
    sag = std::max(sag, -dot(rim.normals[next] - rim.normals[i], rim.points[next] - rim.points[i]) / 8);
  }
  return sag;
}

// How far below the middle of a rim the middle of the host's wall is. On a hollow surface the middle of a rim lies
// above it: the wall then begins where the way down enters it.
double middleOfWall(const mesh::TriMesh& mesh, ModelPoint centre, ModelPoint out, double radius) {
  constexpr double kBegin = 0.01;  // of the radius: below the surface that it begins on
  double passed = kBegin * radius;
  mesh::RayHit hit = mesh::firstHit(mesh, centre - out * passed, -out);
  if (std::isfinite(hit.far) && dot(mesh::areaNormal(mesh, static_cast<std::uint32_t>(hit.triangle)), out) > 0) {
    passed += hit.far + kBegin * radius;
    hit = mesh::firstHit(mesh, centre - out * passed, -out);
  }
  return passed + hit.far / 2;
}

// The end of a tube, a little below the surface: it then leaves it without a ledge, whatever the facets are.
TubeEnd endOf(const mesh::TriMesh& mesh, const Laid& rim, ModelPoint out) {
  constexpr double kSags = 2, kLeast = 3e-4;  // of the radius
  const double below = kSags * sagOf(rim) + kLeast * rim.radius;
  TubeEnd end{{}, coNormals(rim, out), out, rim.radius, {}, {}};
  for (std::size_t i = 0; i < kSides; ++i) end.ring.push_back(rim.points[i] - rim.normals[i] * below);
  end.centre = meanOf(end.ring);
  // The lid is steeper than the tube, which on a hollow surface begins downwards.
  constexpr double kDepth = 0.2, kLeastInward = 0.3;
  double steepest = 0;
  for (std::size_t i = 0; i < kSides; ++i) {
    const double inward = dot(end.leave[i], normalized(end.centre - end.ring[i]));
    steepest = std::max(steepest, -dot(end.leave[i], out) / std::max(inward, kLeastInward));
  }
  const double depth = std::min((kDepth + steepest) * rim.radius, middleOfWall(mesh, end.centre, out, rim.radius));
  end.lid = end.centre - out * depth;
  return end;
}

}  // namespace

Result<Bridge> makeBridge(const Host& from, const Host& to, const BridgeParams& params, mesh::PictureSize picture) {
  if (!isValid(params)) return {Error::BridgeInvalid, "its measures are out of range"};
  try {
    std::array<Laid, 2> laid;
    for (std::size_t i = 0; i < 2; ++i) {
      Result<Laid> rim = lay(i == 0 ? from : to);
      if (!rim) return rim.failure();
      laid[i] = std::move(rim).value();
    }
    constexpr double kLeastGap = 0.02;  // of the radii
    if (distance(laid[0].centre, laid[1].centre) < kLeastGap * (laid[0].radius + laid[1].radius)) {
      return {Error::BridgeInvalid, "its rims are at one place"};
    }
    const std::array<ModelPoint, 2> out{outOf(laid[0], laid[1].centre), outOf(laid[1], laid[0].centre)};
    // Counter-clockwise about the way, which enters the other host.
    if (dot(laid[0].area, out[0]) < 0) reverse(laid[0]);
    if (dot(laid[1].area, out[1]) > 0) reverse(laid[1]);
    const TubeEnd start = endOf(from.mesh, laid[0], out[0]), end = endOf(to.mesh, laid[1], out[1]);
    Bridge bridge;
    for (std::size_t i = 0; i < 2; ++i) bridge.rims[i] = {laid[i].points, laid[i].centre, out[i]};
    for (const auto& [flare, bow, arc] : kTries) {
      BridgeParams tried = params;
      tried.bow = arc ? bow : bow * params.bow;
      bridge.mesh = tubeBetween(start, end, tried, flare, picture);
      if (!mesh::selfCrossing(bridge.mesh)) return bridge;
    }
    return {Error::BridgeInvalid, "it would go through itself"};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::bridge
