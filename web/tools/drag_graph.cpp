#include "web/tools/drag_graph.h"

#include <algorithm>
#include <utility>

#include "web/commands/intents.h"
#include "web/edit/graph_points.h"
#include "web/edit/preview.h"
#include "web/edit/section_editing.h"
#include "web/tools/section_tools.h"

namespace spineloft::tools {
namespace {

constexpr double kDraggedOut = 40;  // CSS pixels above or below the graph
constexpr double kAtEnd = 0.06;     // a tap this near an end is about the end

using geometry::AlongPoint;

}  // namespace

bool DragGraph::isFixed(std::size_t point) const { return app::isFixedPoint(area_.kind, start_, point); }

/// The curve of the area in `params`, in the units that are shown.
geometry::AlongCurve DragGraph::shownCurve(const ToolEnv& env, const loft::LoftParams& params,
                                           const document::Part& part) const {
  if (isBlend()) return params.sections[app::pickedSectionKey(env.ui, part)].blend.custom;
  geometry::AlongCurve curve = document::alongOf(params, env.ui.sections.along);
  for (AlongPoint& p : curve.points) p.value /= app::alongInfo(env.ui.sections.along).unit;
  return curve;
}

geometry::AlongCurve DragGraph::current(const ToolEnv& env) const {
  const document::Part* part = document::findPart(env.document, env.ui.selection);
  return part ? shownCurve(env, document::loftIn(*part).loft, *part) : geometry::AlongCurve{};
}

app::ClientPoint DragGraph::toCanvas(const ToolEnv&, const AlongPoint& p) const {
  const double up = (p.value - area_.low) / (area_.high - area_.low);
  return {area_.at.x + p.at * area_.at.width, area_.at.bottom() - up * area_.at.height};
}

void DragGraph::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  doubled_ = isDoubleTap(env.ui.sections, event);
  start_ = current(env);
  double reach = reachOf(event);
  std::optional<std::size_t> hit;
  for (std::size_t i = 0; i < start_.points.size(); ++i) {
    const double off = distance(toCanvas(env, start_.points[i]), event.at);
    if (off > reach) continue;
    reach = off;
    hit = i;
  }
  if (hit) {
    point_ = *hit;
  } else if (start_.points.size() < geometry::kMostAlongPoints) {
    double at = std::clamp((event.at.x - area_.at.x) / area_.at.width, 0.0, 1.0);
    const double value = area_.low + (area_.at.bottom() - event.at.y) / area_.at.height * (area_.high - area_.low);
    const double rest = app::alongInfo(env.ui.sections.along).rest;
    if (at < kAtEnd) at = 0;
    if (at > 1 - kAtEnd) at = 1;
    start_ = app::withPointAt(std::move(start_), {at, value}, rest, point_);
    if (!isFixed(point_)) start_.points[point_].value = std::clamp(value, area_.low, area_.high);
    fresh_ = true;
  }
  env.ui.sections.graph = start_;
  env.ui.sections.graphPoint = point_;
  show(env);
}

void DragGraph::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved() || isFixed(point_) || point_ >= start_.points.size()) return;
  geometry::AlongCurve curve = start_;
  const app::Rect& at = area_.at;
  if (event.at.y < at.y - kDraggedOut || event.at.y > at.bottom() + kDraggedOut) {
    curve.points.erase(curve.points.begin() + static_cast<std::ptrdiff_t>(point_));
  } else {
    AlongPoint& p = curve.points[point_];
    const auto [low, high] = app::roomOfPoint(curve, point_);
    if (low <= high) p.at = std::clamp((event.at.x - at.x) / at.width, low, high);
    const double up = (at.bottom() - event.at.y) / at.height;
    p.value = std::clamp(area_.low + up * (area_.high - area_.low), area_.low, area_.high);
  }
  env.ui.sections.graph = std::move(curve);
  show(env);
}

/// The part with the curve as it is.
void DragGraph::show(const ToolEnv& env) {
  const document::Part* part = document::findPart(env.document, env.ui.selection);
  if (part == nullptr || !env.ui.sections.graph) return;
  geometry::AlongCurve curve = *env.ui.sections.graph;
  env.ui.sections.marked = point_ < curve.points.size() ? std::optional(curve.points[point_].at) : std::nullopt;
  loft::LoftParams params = document::loftIn(*part).loft;
  if (isBlend()) {
    params.sections[app::pickedSectionKey(env.ui, *part)].blend.custom = std::move(curve);
    env.ui.sections.marked.reset();
  } else {
    const app::AlongInfo& info = app::alongInfo(env.ui.sections.along);
    for (AlongPoint& p : curve.points) {
      p.value = std::clamp(p.value, info.low, info.high) * info.unit;
    }
    document::alongOf(params, info.kind) = std::move(curve);
  }
  if (!loft::checkParams(params)) return;
  app::previewLoft(env.ui, *part, std::move(params));
  app::guardPreview(env.ui, env.document, env.derived);
}

void DragGraph::commit(const ToolEnv& env) {
  if (!env.ui.sections.graph) return;
  geometry::AlongCurve curve = *env.ui.sections.graph;
  const bool remove = doubled_ && !watch_.moved() && !fresh_ && !isFixed(point_);
  if (remove && point_ < curve.points.size()) {
    curve.points.erase(curve.points.begin() + static_cast<std::ptrdiff_t>(point_));
  }
  const document::Part* part = document::findPart(env.document, env.ui.selection);
  if (const document::LoftRecipe* held = app::heldBack(env.ui); held && part)
    curve = shownCurve(env, held->loft, *part);
  cancel(env);
  if (part == nullptr || curve == current(env)) return;
  if (isBlend()) {
    env.sink.run(app::setBlend, part->id, app::pickedSectionKey(env.ui, *part),
                 sections::Blend{sections::BlendKind::Custom, curve});
  } else {
    const app::AlongInfo& info = app::alongInfo(env.ui.sections.along);
    for (AlongPoint& p : curve.points) p.value = std::clamp(p.value, info.low, info.high);
    env.sink.run(app::setAlong, app::Parts{part->id}, info.kind, curve);
  }
}

void DragGraph::cancel(const ToolEnv& env) {
  env.ui.sections.graph.reset();
  env.ui.sections.marked.reset();
  env.ui.preview.reset();
}

}  // namespace spineloft::tools
