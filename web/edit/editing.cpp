#include "web/edit/editing.h"
#include "web/words/words.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/along.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/stroke_line.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/spine_gestures.h"

namespace spineloft::app {
namespace {

constexpr int kDepthPlaces = 9;         // where a depth that is dragged gets its points
constexpr double kPressureDepth = 0.5;  // depth at full pressure, share of the stroke's length
constexpr int kPressurePlaces = 16;
constexpr double kSteadyPressure = 0.05;  // a range below it is no drawing with pressure

std::string_view stateWords(ribs::RibState state) {
  switch (state) {
    case ribs::RibState::Edge:
      return "on an edge";
    case ribs::RibState::Bridged:
      return "bridged";
    case ribs::RibState::Guessed:
      return "guessed";
    case ribs::RibState::Edited:
      return words::text("moved by hand");
    case ribs::RibState::Locked:
      return "locked";
  }
  return "";
}

bool holds(const ribs::IgnoreMark& mark, PicturePoint p, double reach) {
  for (std::size_t i = 0; i < mark.stroke.size(); ++i) {
    const PicturePoint from = mark.stroke[i > 0 ? i - 1 : 0];
    if (geometry::distanceToSegment(p, from, mark.stroke[i]) <= mark.radius + reach) return true;
  }
  return false;
}

}  // namespace

Subject subjectOf(const document::Document& document, const pipeline::Derived& derived, PartId id) {
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (document.parts[i]->id != id || !derived.parts[i].shape) continue;
    if (document::loftOf(*document.parts[i]) == nullptr) continue;
    return {&*document.parts[i], derived.parts[i].shape.get()};
  }
  return {};
}

ribs::EditScene sceneOf(const Subject& subject) {
  return {subject.shape->spine, subject.shape->ribs, document::loftIn(*subject.part).edits};
}

PicturePoint endPoint(const ribs::Rib& rib, ribs::Side side) { return side == ribs::Side::Left ? rib.left : rib.right; }
ribs::RibState endState(const ribs::Rib& rib, ribs::Side side) {
  return side == ribs::Side::Left ? rib.leftState : rib.rightState;
}
const ribs::OtherPlaces& otherPlaces(const ribs::Rib& rib, ribs::Side side) {
  return side == ribs::Side::Left ? rib.leftOthers : rib.rightOthers;
}

std::string ribSentence(const ribs::RibSet& set, ribs::EndRef end) {
  if (end.rib >= set.ribs.size()) return {};
  const ribs::Rib& rib = set.ribs[end.rib];
  const long away = std::lround(distance(rib.center, endPoint(rib, end.side)));
  const bool left = end.side == ribs::Side::Left;
  return std::string(words::tr(left ? "Rib {n} of {all}, left end, {state}, {away} from the bone"
                                    : "Rib {n} of {all}, right end, {state}, {away} from the bone",
                               {{"n", end.rib + 1},
                                {"all", set.ribs.size()},
                                {"state", words::tr(stateWords(endState(rib, end.side)))},
                                {"away", away == 1 ? words::tr("1 pixel") : words::tr("{n} pixels", {{"n", away}})}}));
}

std::vector<PicturePoint> spineLine(const Subject& subject) {
  const std::vector<PicturePoint>& posed = document::loftIn(*subject.part).pose.stroke;
  return posed.empty() ? subject.shape->spine.points : posed;
}

void putSpine(document::LoftRecipe& recipe, std::vector<PicturePoint> line, bool keepRibs) {
  if (keepRibs) {
    recipe.pose.stroke = std::move(line);
  } else {
    recipe.stroke = std::move(line);
    recipe.pose.stroke.clear();
  }
}

std::vector<document::Action> spineActions(const document::Part& part, std::vector<PicturePoint> line, bool keepRibs) {
  const document::LoftRecipe& before = document::loftIn(part);
  document::LoftRecipe recipe = before;
  putSpine(recipe, std::move(line), keepRibs);
  std::vector<document::Action> actions;
  if (!keepRibs) actions.push_back(document::RedrawSpine{part.id, std::move(recipe.stroke)});
  if (recipe.pose != before.pose) {
    actions.push_back(document::PoseSpine{part.id, std::move(recipe.pose)});
  }
  return actions;
}

double handlePlace(int handle) { return static_cast<double>(handle) / (kSpineHandles - 1); }

std::vector<PicturePoint> spineHandles(const Subject& subject) {
  const std::vector<PicturePoint> line = spineLine(subject);
  if (line.size() < 2) return {};
  return geometry::resample(std::span<const PicturePoint>(line), kSpineHandles);
}

std::vector<PicturePoint> moveHandle(std::span<const PicturePoint> line, int handle, PicturePoint to, double reach) {
  if (handle == 0 || handle == kSpineHandles - 1) return ribs::extendStroke(line, handle == 0, to);
  return ribs::bendStroke(line, handlePlace(handle), to, reach);
}

geometry::AlongCurve raiseDepth(const geometry::AlongCurve& depth, double at, double by, double reach) {
  std::vector<double> places;
  for (const geometry::AlongPoint& point : depth.points) places.push_back(point.at);
  // A curve with many points of its own keeps them; a plain one gets some along the whole spine.
  const bool plain = places.size() + kDepthPlaces <= geometry::kMostAlongPoints;
  const double apart = 0.5 / (kDepthPlaces - 1);
  for (int i = 0; plain && i < kDepthPlaces; ++i) {
    const double place = static_cast<double>(i) / (kDepthPlaces - 1);
    const bool taken =
        std::ranges::any_of(depth.points, [&](const auto& point) { return std::abs(point.at - place) < apart; });
    if (!taken) places.push_back(place);
  }
  std::ranges::sort(places);
  geometry::AlongCurve raised;
  const double spread = std::max(reach, 2 * apart);
  for (const double place : places) {
    const double before = geometry::valueAt(depth, place, 0);
    raised.points.push_back({place, before + by * ribs::bell((place - at) / spread)});
  }
  return raised;
}

void depthOfPressure(std::span<const PicturePoint> stroke, std::span<const double> pressure,
                     geometry::AlongCurve& depth) {
  depth.points.clear();
  if (stroke.size() < 2 || pressure.size() != stroke.size()) return;
  const auto [low, high] = std::ranges::minmax(pressure);
  if (!(high - low >= kSteadyPressure)) return;
  const double length = geometry::lengthOf(stroke);
  if (!(length > 0)) return;
  // The hand trembles: each place takes the mean of what lies around it.
  const double window = 0.75 / (kPressurePlaces - 1);
  for (int i = 0; i < kPressurePlaces; ++i) {
    const double at = static_cast<double>(i) / (kPressurePlaces - 1);
    double sum = 0, weight = 1e-9, s = 0;
    for (std::size_t k = 0; k < stroke.size(); ++k) {
      if (k > 0) s += distance(stroke[k - 1], stroke[k]);
      const double w = 1e-6 + ribs::bell((s / length - at) / window);
      sum += w * pressure[k];
      weight += w;
    }
    depth.points.push_back({at, (sum / weight - 0.5) * 2 * kPressureDepth * length});
  }
}

std::vector<ModelPoint> depthHandles(const Subject& subject) {
  const std::vector<ModelPoint>& line = subject.shape->centreLine;
  std::vector<ModelPoint> handles;
  for (int i = 0; i < kSpineHandles && line.size() >= 2; ++i) {
    const double at = handlePlace(i) * static_cast<double>(line.size() - 1);
    handles.push_back(line[static_cast<std::size_t>(std::lround(at))]);
  }
  return handles;
}

Marks marksOf(const document::Document& document, PictureId picture, PartId part) {
  Marks marks;
  if (const document::PictureEntry* entry = document::findPicture(document, picture)) {
    marks.picture = entry->ignored;
  }
  const document::Part* owner = document::findPart(document, part);
  if (owner != nullptr && document::pictureOf(*owner) == picture) marks.part = document::loftIn(*owner).ignored;
  return marks;
}

int markAt(const Marks& marks, PicturePoint p, double reach) {
  for (int i = marks.count(); i-- > 0;) {
    if (holds(marks.at(i), p, reach)) return i;
  }
  return -1;
}

std::optional<EndCaps> capsOf(const document::Part& part) {
  if (const auto* loft = document::loftOf(part)) return EndCaps{loft->loft.startCap, loft->loft.endCap};
  const auto* layers = document::stackOf(part);
  if (layers == nullptr || layers->rail.closed) return std::nullopt;
  return EndCaps{layers->stack.startCap, layers->stack.endCap};
}

}  // namespace spineloft::app
