#include "web/edit/bridging.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "engine/geometry/turn.h"
#include "engine/mesh/laws.h"
#include "engine/mesh/ray_hit.h"
#include "engine/mesh/surface_places.h"
#include "engine/pipeline/world.h"

namespace spineloft::app {
namespace {

constexpr std::size_t kRimPoints = 16;
constexpr std::size_t kCompared = 900;  // corners of a part, about: where two parts are nearest
constexpr double kLeastRadius = 2;      // picture pixels

// A part with its shape, in its place. None: it is hidden, a bridge, or has no shape.
struct Host {
  const document::Part* part;
  const mesh::TriMesh* mesh;
  pipeline::ToWorld toWorld;
};
std::optional<Host> shownHost(const document::Document& document, const pipeline::Derived& derived, PartId id) {
  const document::Part* part = document::findPart(document, id);
  const auto made = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
  if (part == nullptr || document::bridgeOf(*part) || made == derived.parts.end() || !made->shape) return std::nullopt;
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
  if (entry == nullptr || !pipeline::isVisible(document, *part)) return std::nullopt;
  return Host{part, &smoothMesh(*made->shape), *pipeline::copiesInWorld(*part, entry->size).begin()};
}

std::vector<ModelPoint> circle(ModelPoint middle, ModelPoint normal, double radius) {
  const ModelPoint beside = std::abs(normal.y) < 0.9 ? ModelPoint{0, 1, 0} : ModelPoint{1, 0, 0};
  const ModelPoint right = normalized(cross(beside, normal)), up = cross(normal, right);
  std::vector<ModelPoint> points;
  for (std::size_t i = 0; i < kRimPoints; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i) / kRimPoints;
    points.push_back(middle + right * (radius * std::cos(angle)) + up * (radius * std::sin(angle)));
  }
  return points;
}

// The largest circle whose surface is turned away from that of its middle by 40 degrees at most, and off its plane no
// more than half a radius.
double roomAt(const mesh::SurfacePlaces& places, ModelPoint at, ModelPoint normal, double most) {
  constexpr double kLeastFacing = 0.75, kMostOff = 0.5, kStep = 0.8;
  constexpr int kSteps = 16;
  double radius = most;
  for (int i = 0; i < kSteps; ++i, radius *= kStep) {
    const std::vector<ModelPoint> ring = circle(at, normal, radius);
    const bool fits = std::ranges::all_of(ring, [&](ModelPoint p) {
      const auto place = places.nearest(p);
      return place && dot(place->face, normal) >= kLeastFacing && distance(place->at, p) <= kMostOff * radius;
    });
    if (fits) return radius;
  }
  return radius;
}

double sizeOf(const mesh::TriMesh& mesh) {
  const mesh::Bounds bounds = mesh::boundsOf(mesh);
  return std::hypot(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1], bounds.high[2] - bounds.low[2]);
}

BridgePlace placeOn(const Host& host, const mesh::SurfacePlaces& places, const mesh::SurfacePlace& near) {
  constexpr double kAround = 0.01, kMostRoom = 0.25;  // of the part
  const double size = sizeOf(*host.mesh);
  BridgePlace place;
  place.part = host.part->id;
  place.at = near.at;
  place.normal = places.meanNormal(near.at, kAround * size);
  if (norm(place.normal) == 0) place.normal = near.face;
  place.room = roomAt(places, place.at, place.normal, kMostRoom * size);
  place.scale = host.toWorld.scale;
  place.inWorld = host.toWorld(place.at);
  place.out = normalized(host.toWorld.along(place.normal));
  return place;
}

std::vector<WorldPoint> someCorners(const Host& host) {
  const std::size_t count = host.mesh->positions.size(), step = std::max<std::size_t>(1, count / kCompared);
  std::vector<WorldPoint> corners;
  for (std::size_t i = 0; i < count; i += step) corners.push_back(host.toWorld(host.mesh->positions[i]));
  return corners;
}

ModelPoint middleOf(const std::vector<ModelPoint>& rim) {
  ModelPoint sum;
  for (const ModelPoint p : rim) sum += p;
  return sum / static_cast<double>(rim.size());
}

}  // namespace

std::optional<BridgePlace> bridgePlaceOn(const document::Document& document, const pipeline::Derived& derived,
                                         PartId part, ModelPoint near) {
  const auto host = shownHost(document, derived, part);
  if (!host) return std::nullopt;
  const mesh::SurfacePlaces places(*host->mesh);
  const auto place = places.nearest(near);
  return place ? std::optional(placeOn(*host, places, *place)) : std::nullopt;
}

std::optional<BridgePlace> bridgePlaceUnder(const document::Document& document, const pipeline::Derived& derived,
                                            const UiState& ui, ClientPoint at) {
  const Ray ray{ui.camera.eye(), rayThrough(ui.camera, ui.layout.solid, at)};
  double nearest = std::numeric_limits<double>::infinity();
  PartId part;
  ModelPoint place;
  bool onTwin = false;
  for (const document::Part& one : document.parts) {
    const auto host = shownHost(document, derived, one.id);
    const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(one));
    if (!host || entry == nullptr) continue;
    const pipeline::Copies copies = pipeline::copiesInWorld(one, entry->size);
    for (const pipeline::ToWorld& copy : copies) {
      const ModelPoint eye = copy.toModel(ray.eye), way = copy.alongInModel(ray.direction);
      const double far = mesh::firstHit(*host->mesh, eye, way).far;
      if (!(far < nearest)) continue;
      nearest = far;
      part = one.id;
      place = eye + way * far;
      onTwin = &copy != copies.begin();
    }
  }
  return part && !onTwin ? bridgePlaceOn(document, derived, part, place) : std::nullopt;
}

std::optional<FacingPlaces> facingPlaces(const document::Document& document, const pipeline::Derived& derived,
                                         PartId from, PartId to) {
  const auto a = shownHost(document, derived, from), b = shownHost(document, derived, to);
  if (!a || !b || from == to) return std::nullopt;
  const std::vector<WorldPoint> first = someCorners(*a), second = someCorners(*b);
  double least = std::numeric_limits<double>::infinity();
  WorldPoint near;
  for (const WorldPoint p : first) {
    for (const WorldPoint q : second) {
      const WorldPoint d = p - q;
      if (dot(d, d) >= least) continue;
      least = dot(d, d);
      near = q;
    }
  }
  // From corner to surface and back.
  const auto start = bridgePlaceOn(document, derived, from, a->toWorld.toModel(near));
  if (!start) return std::nullopt;
  const auto end = bridgePlaceOn(document, derived, to, b->toWorld.toModel(start->inWorld));
  if (!end) return std::nullopt;
  const double size = std::min(sizeOf(*a->mesh) * a->toWorld.scale, sizeOf(*b->mesh) * b->toWorld.scale);
  return FacingPlaces{*start, *end, distance(start->inWorld, end->inWorld) / std::max(size, 1e-12)};
}

document::BridgeRecipe usualBridge(const document::Document& document, const BridgePlace& from, const BridgePlace& to,
                                   double width) {
  // Wide where two surfaces face each other, narrow where they lie side by side, as under the handle of a cup.
  constexpr double kFacing = 0.95, kBeside = 0.25, kOfRoom = 0.6, kNarrowGap = 0.35;
  const double length = distance(from.inWorld, to.inWorld), alike = (1 + dot(from.out, to.out)) / 2;
  const double fits = kOfRoom * std::min(from.room * from.scale, to.room * to.scale);
  // A narrow gap between two parts is filled; on one part rims would meet.
  const bool isHandle = from.part == to.part;
  const double most = std::lerp(isHandle ? kBeside : kFacing, kBeside, alike) * length;
  const double radius = width * std::clamp(most, isHandle ? 0 : kNarrowGap * fits, fits);
  const document::Part* host = document::findPart(document, from.part);
  document::BridgeRecipe recipe;
  recipe.picture = host ? document::pictureOf(*host) : PictureId{};
  for (const auto& [place, end] : {std::pair{&from, &recipe.from}, std::pair{&to, &recipe.to}}) {
    end->part = place->part;
    end->rim = circle(place->at, place->normal, std::max(kLeastRadius, radius / place->scale));
  }
  return recipe;
}

bool areApart(const BridgePlace& from, const BridgePlace& to) {
  constexpr double kLeast = 0.4;  // of the room
  return from.part != to.part || distance(from.inWorld, to.inWorld) >= kLeast * from.room * from.scale;
}

document::Look bridgeLook(const document::Document& document, const pipeline::Derived& derived, PartId from) {
  const document::Part* part = document::findPart(document, from);
  const auto made = std::ranges::find(derived.parts, from, &pipeline::DerivedPart::id);
  document::Look look = part ? part->look : document::Look{};
  if (!look.textured) return look;
  look.textured = false;
  look.inked = false;
  if (made == derived.parts.end() || !made->shape || !made->shape->texture) return look;
  const image::Image& pixels = made->shape->texture->pixels;
  constexpr std::size_t kBytes = 4, kSamples = 4096;
  const std::size_t count = pixels.pixels.size() / kBytes, step = std::max<std::size_t>(1, count / kSamples);
  std::array<double, 3> sum{};
  std::size_t taken = 0;
  for (std::size_t i = 0; i < count; i += step, ++taken) {
    for (std::size_t c = 0; c < 3; ++c) sum[c] += pixels.pixels[kBytes * i + c];
  }
  for (std::size_t c = 0; c < 3 && taken > 0; ++c) {
    look.colour[c] = static_cast<std::uint8_t>(std::lround(sum[c] / static_cast<double>(taken)));
  }
  return look;
}

void widenBridge(document::BridgeRecipe& recipe, double factor) {
  for (document::BridgeEnd* end : {&recipe.from, &recipe.to}) {
    const ModelPoint middle = middleOf(end->rim);
    double radius = 0;
    for (const ModelPoint p : end->rim) radius = std::max(radius, distance(p, middle));
    const double grown = std::max(factor, kLeastRadius / std::max(radius, 1e-12));
    for (ModelPoint& p : end->rim) p = middle + (p - middle) * grown;
  }
}

std::optional<document::BridgeEnd> carriedEnd(const document::Document& document, const pipeline::Derived& derived,
                                              const document::BridgeEnd& end, const BridgePlace& to) {
  const auto host = shownHost(document, derived, end.part);
  if (!host || end.rim.empty()) return std::nullopt;
  const auto from = bridgePlaceOn(document, derived, end.part, middleOf(end.rim));
  if (!from) return std::nullopt;
  const ModelPoint middle = middleOf(end.rim);
  const geometry::Turn turn = geometry::turnTo(from->normal, to.normal);
  document::BridgeEnd carried{to.part, {}};
  for (const ModelPoint p : end.rim) {
    carried.rim.push_back(to.at + geometry::turned(turn, p - middle) * (from->scale / to.scale));
  }
  return carried;
}

}  // namespace spineloft::app
