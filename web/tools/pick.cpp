#include "web/tools/pick.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/geometry/line_distance.h"
#include "web/commands/intents.h"
#include "web/edit/bridging.h"
#include "web/edit/depth_dots.h"
#include "web/edit/gizmo.h"
#include "web/edit/line_drawing.h"
#include "web/edit/outline.h"
#include "web/edit/picker.h"
#include "web/edit/placing.h"
#include "web/edit/puff_bones.h"
#include "web/edit/pulling.h"
#include "web/edit/region_editing.h"
#include "web/edit/section_editing.h"
#include "web/edit/shaping.h"
#include "web/edit/spinning.h"
#include "web/tools/sheet_tool.h"

namespace spineloft::tools {
namespace {

constexpr double kPointSpacing = 1.5;  // CSS pixels between the points of a stroke
constexpr double kLineReach = 8;       // CSS pixels round a spine that still count as it
constexpr double kOutlineReach = 1.3;  // of that round a point, round the outline of a shape

double reachOf(const ToolEvent& event) { return event.touch() ? kTouchReach : kMouseReach; }

/// The dot of another place of an end that is shown, if the pointer is on it.
bool pickOther(const app::Subject& subject, const app::UiState& ui, PicturePoint p, double reach, app::Hover& hover) {
  const auto& all = subject.shape->ribs.ribs;
  double nearest = reach;
  for (const auto& end : {ui.chosen.end, ui.hover.end}) {
    if (!end || end->rib >= all.size()) continue;
    const ribs::OtherPlaces& others = app::otherPlaces(all[end->rib], end->side);
    for (int i = 0; i < others.count; ++i) {
      const double away = distance(p, others.at[static_cast<std::size_t>(i)]);
      if (away >= nearest) continue;
      nearest = away;
      hover.end = end;
      hover.other = i;
    }
  }
  // The end itself wins when it is nearer.
  return hover.other >= 0 && !ribs::nearestEnd(subject.shape->ribs, p, nearest);
}

void pickRib(const app::Subject& subject, const app::UiState& ui, PicturePoint p, double reach, app::Hover& hover) {
  if (pickOther(subject, ui, p, reach, hover)) return;
  hover.other = -1;
  hover.end = ribs::nearestEnd(subject.shape->ribs, p, reach);
}

void pickSpine(const app::Subject& subject, PicturePoint p, double reach, double lineReach, app::Hover& hover) {
  const std::vector<PicturePoint> handles = app::spineHandles(subject);
  double nearest = reach;
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const double away = distance(p, handles[i]);
    if (away > nearest) continue;
    nearest = away;
    hover.handle = static_cast<int>(i);
  }
  const std::vector<PicturePoint> line = app::spineLine(subject);
  hover.spine = hover.handle < 0 && geometry::distanceToLine(p, std::span<const PicturePoint>(line)) <= lineReach;
}

/// Of the shape in hand: a handle, CSS pixels, or its outline, picture pixels.
struct ShapeReach {
  double handle = 0, outline = 0;
};
void pickShape(const ToolEnv& env, PicturePoint p, const ShapeReach& reach, app::Hover& hover) {
  const auto seen = app::shapeInHand(env.document, env.ui);
  if (!seen) return;
  const double zoom = env.ui.pictureView.zoom;
  const std::vector<app::ShapeHandle> handles = app::shapeHandles(*seen);
  const int held = app::shapeHandleAt(handles, p, zoom, reach.handle);
  // A finger reaches both: what is nearer counts.
  const double toOutline = geometry::distanceToLine(p, std::span<const PicturePoint>(seen->outline), true);
  const double off = held < 0 ? 0 : distance(app::heldAt(handles[static_cast<std::size_t>(held)], zoom), p);
  if (held >= 0 && off <= toOutline) hover.shape = held;
  hover.outlineOfShape = hover.shape < 0 && app::drawsOutline(*seen, p, reach.outline);
}

}  // namespace

app::Subject editedPart(const ToolEnv& env) {
  const app::Subject subject = app::subjectOf(env.document, env.derived, env.ui.selection);
  if (!subject || document::pictureOf(*subject.part) != env.ui.picture) return {};
  return subject;
}

void selectTapped(const ToolEnv& env, PartId part, bool add) {
  if (env.document.parts.empty()) return;  // nothing to take, nothing to let go of
  env.sink.run(app::selectPart, part, add);
}

PicturePoint toPicture(const ToolEnv& env, app::ClientPoint at) {
  return env.ui.pictureView.toPicture(at, env.ui.layout.picture);
}

bool extend(const ToolEnv& env, std::vector<PicturePoint>& stroke, app::ClientPoint at) {
  const PicturePoint p = toPicture(env, at);
  const bool near = !stroke.empty() && distance(p, stroke.back()) * env.ui.pictureView.zoom < kPointSpacing;
  if (near) return false;
  stroke.push_back(p);
  return true;
}

app::Hover pickInPicture(const ToolEnv& env, const ToolEvent& event) {
  using app::ToolKind;
  const app::UiState& ui = env.ui;
  const PicturePoint p = toPicture(env, event.at);
  const double scale = 1 / ui.pictureView.zoom, reach = reachOf(event) * scale;
  app::Hover hover;
  hover.part = app::partAt(env.document, env.derived, ui.picture, p, kLineReach * scale);
  const app::Subject subject = editedPart(env);
  if (const app::BonedPuff puff = app::bonesInHand(env.document, env.derived, ui)) {
    const double lineReach = std::max(kLineReach, reachOf(event) * 0.7);
    hover.bone = app::boneAt(app::boneHandles(puff), ui, event.at, reachOf(event), lineReach);
  } else if (ui.tool == ToolKind::Primitive) {
    pickShape(env, p, {reachOf(event), kOutlineReach * reach}, hover);
  } else if (ui.tool == ToolKind::Lines) {
    const app::LineMarks marks = app::lineMarks(env.document, env.derived, ui);
    hover.crossing = app::nearestOf(marks.crossings, event.at, reachOf(event));
    if (hover.crossing < 0) hover.looseEnd = app::nearestOf(marks.looseEnds, event.at, reachOf(event));
  } else if (ui.tool == ToolKind::Ignore) {
    hover.mark = app::markAt(app::marksOf(env.document, ui.picture, ui.selection), p, 0);
  } else if (app::drawsRegions(ui.tool)) {
    const document::Part* part = app::partWithPoints(env.document, ui);
    if (part != nullptr) hover.outline = app::handleAt(*document::regionOf(part->recipe), p, reach);
    const std::optional<app::ShownAxis> axis = app::axisInHand(env.document, ui);
    if (axis && !hover.outline) hover.axis = app::axisEndAt(*axis, p, reach);
  } else if (subject && (ui.tool == ToolKind::Ribs || ui.tool == ToolKind::Shape)) {
    pickRib(subject, ui, p, reach, hover);
  } else if (subject && ui.tool == ToolKind::Spine) {
    pickSpine(subject, p, reach, std::max(kLineReach, reachOf(event) * 0.7) * scale, hover);
  }
  if (ui.tool == ToolKind::Eraser || ui.tool == ToolKind::Ignore || ui.cut) {
    hover.brush = event.at;
  } else if (subject && subject.shape->centreLine.size() > 1 && ui.tool != ToolKind::Pen) {
    const app::SpinePlace place = app::nearestPlace(*subject.shape, p);
    if (place.distance <= kLineReach * scale) hover.along = place.at;
  }
  return hover;
}

app::ClientPoint nearerOnCanvas(const ToolEnv& env, const pipeline::ToWorld& toWorld, ModelPoint at) {
  constexpr double kLeast = 0.15;  // of the same length seen square on
  const app::Camera& camera = env.ui.camera;
  const app::Rect& view = env.ui.layout.solid;
  const WorldPoint here = toWorld(at), nearer = toWorld(at + ModelPoint{0, 0, 1});
  const auto a = app::pointOnCanvas(camera, view, here), b = app::pointOnCanvas(camera, view, nearer);
  const auto c = app::pointOnCanvas(camera, view, here + camera.up() * toWorld.scale);
  if (!a || !b || !c) return {};
  const double most = distance(*a, *c);
  const app::ClientPoint unit = *b - *a;
  return norm(unit) < kLeast * most ? app::ClientPoint{0, 1} * (kLeast * most) : unit;
}

app::Hover pickInSolid(const ToolEnv& env, const ToolEvent& event) {
  const app::UiState& ui = env.ui;
  app::Hover hover;
  const app::Subject subject = app::subjectOf(env.document, env.derived, ui.selection);
  if (ui.tool == app::ToolKind::Spine && subject) {
    const document::PictureEntry* entry = document::findPicture(env.document, document::pictureOf(*subject.part));
    const std::vector<ModelPoint> handles = app::depthHandles(subject);
    double nearest = reachOf(event);
    const pipeline::Copies copies = app::shownCopies(ui, *subject.part, entry ? entry->size : image::Size{});
    for (std::size_t i = 0; entry != nullptr && i < handles.size(); ++i) {
      const auto at = app::pointOnCanvas(ui.camera, ui.layout.solid, (*copies.begin())(handles[i]));
      if (!at || distance(*at, event.at) > nearest) continue;
      nearest = distance(*at, event.at);
      hover.depth = static_cast<int>(i);
    }
  }
  if (ui.tool == app::ToolKind::Lines) {
    std::vector<app::ClientPoint> dots;
    for (const app::DepthDot& dot : app::depthDots(env.document, env.derived, ui)) dots.push_back(dot.seen);
    hover.depth = app::nearestOf(dots, event.at, reachOf(event));
  }
  if (const std::optional<app::Gizmo> gizmo = app::shownGizmo(env.document, env.derived, ui)) {
    hover.gizmo = app::handleAt(*gizmo, event.at, event.touch());
  }
  hover.pull = app::pullKnobAt(app::pulledPart(env.document, env.derived, ui), ui, event.at, reachOf(event));
  hover.rim = app::rimKnobAt(app::bridgeInHand(env.document, env.derived, ui), ui, event.at, reachOf(event));
  const SheetGrip grip = gripAt(env, event);
  hover.sheet = grip.hold;
  hover.joint = grip.joint;
  if (const app::BonedPuff puff = app::bonesInHand(env.document, env.derived, ui)) {
    hover.bone = app::sliceInSolid(puff, ui, event.at, reachOf(event));
  }
  const app::Ray ray{ui.camera.eye(), app::rayThrough(ui.camera, ui.layout.solid, event.at)};
  hover.part = env.picker->partUnderRay(env.document, env.derived, env.ui, ray);
  return hover;
}

bool isBesidePart(const ToolEnv& env, const ToolEvent& event) {
  constexpr int kRays = 12;
  const app::UiState& ui = env.ui;
  for (int i = 0; i < kRays; ++i) {
    const double angle = 2 * std::numbers::pi * i / kRays;
    const app::ClientPoint at = event.at + app::ClientPoint{std::cos(angle), std::sin(angle)} * reachOf(event);
    const app::Ray ray{ui.camera.eye(), app::rayThrough(ui.camera, ui.layout.solid, at)};
    if (ui.selection && env.picker->partUnderRay(env.document, env.derived, ui, ray) == ui.selection) return true;
  }
  return false;
}

const char* cursorFor(const app::UiState& ui, app::Focus view) {
  using app::ToolKind;
  const app::Hover& hover = ui.hover;
  if (view == app::Focus::Solid) {
    if (ui.solids.pointing || ui.solids.hollow) return hover.part ? "crosshair" : "grab";
    if (hover.sheet == app::SheetHold::Knob || hover.sheet == app::SheetHold::Fork) return "ns-resize";
    if (hover.sheet == app::SheetHold::Link) return "pointer";
    if (hover.sheet == app::SheetHold::Lean) return "grab";
    if (hover.sheet == app::SheetHold::Sheet || hover.sheet == app::SheetHold::Rail) return "crosshair";
    const bool body = ui.tool == ToolKind::Place && hover.part;
    if (hover.bone >= 0) return "grab";
    if (hover.depth >= 0) return "ns-resize";
    if (ui.tool == ToolKind::Bridge) return hover.rim >= 0 ? "grab" : hover.part ? "crosshair" : "grab";
    if (ui.tool == ToolKind::Pull) return hover.pull >= 0 ? "grab" : hover.part ? "crosshair" : "grab";
    return hover.gizmo != app::GizmoHandle::None ? "pointer" : body ? "move" : "grab";
  }
  switch (ui.tool) {
    case ToolKind::Hand:
      return "grab";
    case ToolKind::Ribs:
      if (hover.other >= 0) return "pointer";
      if (hover.end) return "grab";
      return hover.part ? "pointer" : "default";
    case ToolKind::Spine:
      if (hover.handle >= 0 || hover.bone >= 0) return "grab";
      return hover.spine ? "move" : "crosshair";
    case ToolKind::Inflate:
    case ToolKind::Extrude:
    case ToolKind::Spin:
      if (ui.cut) return "cell";
      return hover.outline || hover.axis >= 0 ? "grab" : "crosshair";
    case ToolKind::Primitive:
      return hover.shape >= 0 ? "grab" : "crosshair";
    case ToolKind::Lines:
      return hover.crossing >= 0 || hover.looseEnd >= 0 ? "pointer" : "crosshair";
    case ToolKind::Ignore:
      return hover.mark >= 0 ? "pointer" : "cell";
    default:
      return "crosshair";
  }
}

}  // namespace spineloft::tools
