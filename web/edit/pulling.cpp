#include "web/edit/pulling.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/geometry/polyline.h"
#include "engine/mesh/laws.h"
#include "engine/mesh/ray_hit.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"

namespace spineloft::app {
namespace {

constexpr double kEndOn = 0.15;       // of the same length seen square on: shorter is no way to drag along
constexpr double kShort = 0.3;        // of the radius
constexpr double kUsualHeight = 0.5;  // of the radius
constexpr std::size_t kLinePoints = 24;

ModelPoint middleOfLine(const std::vector<ModelPoint>& line) {
  const std::span<const ModelPoint> points(line);
  const std::vector<double> lengths = geometry::arcLengths(points);
  return geometry::pointAt(points, std::span<const double>(lengths), lengths.back() / 2);
}

}  // namespace

PulledPart pulledPartOf(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                        PartId id) {
  const document::Part* part = document::findPart(document, id);
  const auto made = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
  if (part == nullptr || made == derived.parts.end() || !made->shape || !pipeline::isVisible(document, *part))
    return {};
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
  if (entry == nullptr) return {};
  PulledPart pulled{part, made->shape.get(), part->pulls, shownCopies(ui, *part, entry->size)};
  if (const Preview* preview = previewOf(ui, id)) {
    pulled.shape = &*preview->shape;
    pulled.pulls = preview->pulls;
  }
  // A shape that is being made shows as many as it has.
  pulled.pulls = pulled.pulls.first(std::min(pulled.pulls.size(), pulled.shape->pulled.size()));
  return pulled;
}

PulledPart pulledPart(const document::Document& document, const pipeline::Derived& derived, const UiState& ui) {
  if (ui.tool != ToolKind::Pull || !ui.selection) return {};
  return pulledPartOf(document, derived, ui, ui.selection);
}

std::optional<PullKnob> pullKnob(const PulledPart& part, const UiState& ui, std::size_t number) {
  const pipeline::PulledLine& line = part.shape->pulled[number];
  if (line.points.empty()) return std::nullopt;
  const ModelPoint middle = line.points[line.points.size() / 2];
  const WorldPoint here = part.toWorld()(middle), out = part.toWorld().along(line.out);
  const Rect& view = ui.layout.solid;
  const auto at = pointOnCanvas(ui.camera, view, here), further = pointOnCanvas(ui.camera, view, here + out);
  const auto above = pointOnCanvas(ui.camera, view, here + ui.camera.up() * part.toWorld().scale);
  if (!at || !further || !above) return std::nullopt;
  const double square = distance(*at, *above);
  const ClientPoint unit = *further - *at;
  if (!(square > 0)) return std::nullopt;
  const bool endOn = norm(unit) < kEndOn * square;
  return PullKnob{*at, endOn ? ClientPoint{0, -square} : unit, dot(out, ui.camera.eye() - here) > 0};
}

int pullKnobAt(const PulledPart& part, const UiState& ui, ClientPoint at, double reach) {
  int found = -1;
  for (std::size_t i = 0; part && i < part.pulls.size(); ++i) {
    const auto knob = pullKnob(part, ui, i);
    const int number = static_cast<int>(i);
    if (!knob || !(knob->facing || ui.chosen.pull == number)) continue;
    const double away = distance(knob->at, at);
    if (away > reach) continue;
    reach = away;
    found = number;
  }
  return found;
}

std::optional<SurfacePlace> surfaceUnder(const PulledPart& part, const Ray& ray) {
  double nearest = std::numeric_limits<double>::infinity();
  SurfacePlace place;
  std::size_t copy = 0;
  for (const pipeline::ToWorld& toWorld : part.copies) {
    ++copy;
    const ModelPoint eye = toWorld.toModel(ray.eye), way = toWorld.alongInModel(ray.direction);
    const double far = mesh::firstHit(part.shape->mesh, eye, way).far;
    if (!(far < nearest)) continue;
    nearest = far;
    place = {eye + way * far, copy - 1};
  }
  return std::isfinite(nearest) ? std::optional(place) : std::nullopt;
}

double sizeOf(const pipeline::PartShape& shape) {
  const mesh::Bounds bounds = mesh::boundsOf(shape.mesh);
  return std::hypot(bounds.high[0] - bounds.low[0], bounds.high[1] - bounds.low[1], bounds.high[2] - bounds.low[2]);
}

pull::Pull usualPull(const PulledPart& part, const EditOptions& options, const std::vector<ModelPoint>& line) {
  pull::Pull made;
  made.radius = std::clamp(options.pullReach * sizeOf(*part.shape), pull::kLeastRadius, pull::kMostRadius);
  made.height = kUsualHeight * made.radius;
  made.crease = options.pullSharp;
  const double length = geometry::arcLengths(std::span(line)).back();
  if (length < kShort * made.radius) {
    made.line = {line[line.size() / 2]};
  } else {
    made.line = geometry::resample(std::span(line), std::min(line.size() + 1, kLinePoints));
  }
  return made;
}

double heightOf(const pull::Pull& pull, const pipeline::PulledLine& shown) {
  if (pull.to.empty()) return pull.height;
  return dot(middleOfLine(pull.to) - middleOfLine(pull.line), shown.out);
}

pull::Pull raised(const pull::Pull& pull, const pipeline::PulledLine& shown, double by) {
  pull::Pull moved = pull;
  if (pull.to.empty()) {
    moved.height = std::clamp(pull.height + by, -pull::kMostHeight, pull::kMostHeight);
    return moved;
  }
  for (auto* to : {&moved.to, &moved.acrossTo}) {
    const double last = std::max(1.0, static_cast<double>(to->size()) - 1);
    for (std::size_t i = 0; i < to->size(); ++i) {
      const double s = static_cast<double>(i) / last;
      // The ends of a profile are on its ring, which stays.
      (*to)[i] += shown.out * (pull.ring.empty() || to->size() == 1 ? by : 4 * s * (1 - s) * by);
    }
  }
  return moved;
}

std::optional<pull::Pull> between(const pull::Pull& from, const pull::Pull& to, double share) {
  pull::Pull out = to;
  out.height = from.height;
  out.to = from.to;
  out.acrossTo = from.acrossTo;
  if (!(out == from) || from.to.size() != to.to.size() || from.acrossTo.size() != to.acrossTo.size())
    return std::nullopt;
  out.height = std::lerp(from.height, to.height, share);
  for (std::size_t i = 0; i < out.to.size(); ++i) out.to[i] = lerp(from.to[i], to.to[i], share);
  for (std::size_t i = 0; i < out.acrossTo.size(); ++i) out.acrossTo[i] = lerp(from.acrossTo[i], to.acrossTo[i], share);
  return out;
}

}  // namespace spineloft::app
