#include "web/tools/sheet_tool.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "web/commands/intents.h"
#include "web/edit/drawn_rail.h"
#include "web/edit/free_layers.h"
#include "web/edit/layer_settings.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
namespace {

constexpr double kSpacing = 1.5;     // CSS pixels between the points of a line
constexpr double kLeastUnit = 60.0;  // CSS pixels that a rail has at least, however it is seen

std::optional<app::ClientPoint> onCanvas(const ToolEnv& env, const pipeline::ToWorld& toWorld, ModelPoint p) {
  return app::pointOnCanvas(env.ui.camera, env.ui.layout.solid, toWorld(p));
}

/// The way on the canvas that the rail's length takes where the sheet is, or a free layer square to itself.
app::ClientPoint railOnCanvas(const ToolEnv& env, const app::Sheet& sheet, const pipeline::ToWorld& toWorld) {
  constexpr double kStep = 0.02;  // of the rail
  if (sheet.isFree()) {
    const double length = stack::lengthOf(sheet.recipe.rail);
    const auto a = onCanvas(env, toWorld, app::knobOf(sheet));
    const auto b = onCanvas(env, toWorld, app::knobOf(sheet) - sheet.stand.normal() * (kStep * length));
    const app::ClientPoint unit = a && b ? (*b - *a) / kStep : app::ClientPoint{};
    return norm(unit) < kLeastUnit ? app::ClientPoint{0, -kLeastUnit} : unit;
  }
  stack::Plane here;
  here.at = std::min(sheet.at, 1 - kStep);
  stack::Plane ahead = here;
  ahead.at += kStep;
  const auto from = stack::standOf(here, sheet.recipe.rail), to = stack::standOf(ahead, sheet.recipe.rail);
  if (!from || !to) return {0, -kLeastUnit};
  const ModelPoint knob = app::knobOf(sheet);
  const auto a = onCanvas(env, toWorld, knob);
  const auto b = onCanvas(env, toWorld, knob + to.value().origin - from.value().origin);
  if (!a || !b) return {0, -kLeastUnit};
  const app::ClientPoint unit = (*b - *a) / kStep;
  return norm(unit) < kLeastUnit ? app::ClientPoint{0, -kLeastUnit} : unit;
}

/// The way on the canvas that a knob goes while the sheet turns by a radian.
app::ClientPoint leanOnCanvas(const ToolEnv& env, const app::Sheet& sheet, const pipeline::ToWorld& toWorld) {
  const ModelPoint middle = sheet.stand.origin;
  const double reach = distance(app::knobOf(sheet), middle);
  const auto a = onCanvas(env, toWorld, middle), b = onCanvas(env, toWorld, middle - sheet.stand.normal() * reach);
  return a && b && distance(*a, *b) >= kLeastUnit ? *b - *a : app::ClientPoint{0, -kLeastUnit};
}

/// The way on the canvas from the one curve of a fork to the several.
app::ClientPoint wayOnCanvas(const ToolEnv& env, const app::LayerFork& fork, const pipeline::ToWorld& toWorld) {
  const auto a = onCanvas(env, toWorld, fork.stem), b = onCanvas(env, toWorld, fork.ahead);
  return a && b && distance(*a, *b) >= kLeastUnit ? *b - *a : app::ClientPoint{0, fork.up ? -kLeastUnit : kLeastUnit};
}

}  // namespace

SheetGrip gripAt(const ToolEnv& env, const ToolEvent& event) {
  const auto sheet = app::shownSheet(env.document, env.ui);
  if (!sheet || env.ui.fliesAlong()) return {};
  if (app::drawsRail(env.document, env.ui)) return {SheetHold::Rail};
  const pipeline::ToWorld toWorld = app::sheetInWorld(env.document, env.derived, env.ui, *sheet);
  const auto knob = onCanvas(env, toWorld, app::knobOf(*sheet));
  const auto at = app::onSheet(*sheet, toWorld, env.ui, event.at);
  const bool inside = at && app::isOnSheet(*sheet, *at);
  // A line may begin near the knob.
  const double reach = inside ? kMouseReach : event.touch() ? kTouchReach : 1.6 * kMouseReach;
  if (knob && sheet->onRail() && distance(*knob, event.at) <= reach) return {SheetHold::Knob};
  for (int i = 0; sheet->onRail() && i < static_cast<int>(app::kLeans.size()); ++i) {
    const auto tip = onCanvas(env, toWorld, app::leanKnobOf(*sheet, app::kLeans[static_cast<std::size_t>(i)]));
    if (tip && distance(*tip, event.at) <= reach) return {SheetHold::Lean, i};
  }
  const app::LayerJoints joints = app::jointsOf(env.document, env.derived, env.ui, *sheet);
  double nearest = event.touch() ? kTouchReach : kMouseReach;  // a line may begin on a mark, too: move()
  SheetGrip grip{inside ? SheetHold::Sheet : SheetHold::Nothing};
  const auto offer = [&](ModelPoint mark, SheetGrip offered) {
    const auto on = onCanvas(env, toWorld, mark);
    if (!on || distance(*on, event.at) > nearest) return;
    nearest = distance(*on, event.at);
    grip = offered;
  };
  for (std::size_t i = 0; i < joints.links.size(); ++i) {
    offer(joints.links[i].mark, {SheetHold::Link, static_cast<int>(i)});
  }
  nearest = std::min(nearest, reach);
  for (std::size_t i = 0; i < joints.forks.size(); ++i) {
    offer(joints.forks[i].knob(), {SheetHold::Fork, static_cast<int>(i)});
  }
  return grip;
}

bool wheelSheet(const ToolEnv& env, app::ClientPoint at, double by) {
  const SheetHold under = gripAt(env, {at}).hold;
  if (under == SheetHold::Nothing || under == SheetHold::Rail) return false;
  constexpr double kPerPixel = 0.0004;  // of the rail: a notch of a wheel is 0.04 of it
  const auto sheet = app::shownSheet(env.document, env.ui);
  const double way = sheet->onRail() ? -by * kPerPixel : by < 0 ? 1 : -1;
  app::placeSheet(env.ui, *sheet, sheet->at + way);
  return true;
}

void SheetTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  const auto sheet = app::shownSheet(env.document, env.ui);
  if (!sheet) return;
  grip_ = gripAt(env, event);
  sheet_ = *sheet;
  joints_ = app::jointsOf(env.document, env.derived, env.ui, sheet_);
  toWorld_ = app::sheetInWorld(env.document, env.derived, env.ui, sheet_);
  before_ = sheet_.at;
  unit_ = grip_.hold == SheetHold::Fork   ? wayOnCanvas(env, fork(), toWorld_)
          : grip_.hold == SheetHold::Lean ? leanOnCanvas(env, sheet_, toWorld_)
                                          : railOnCanvas(env, sheet_, toWorld_);
  turn_ = sheet_.turn;
  app::placeSheet(env.ui, sheet_, before_);
  const bool knob = grip_.hold == SheetHold::Knob || grip_.hold == SheetHold::Lean;
  env.ui.layers.held = knob ? grip_.hold : SheetHold::Nothing;
}

void SheetTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved()) return;
  if (grip_.hold == SheetHold::Link) {  // a line may begin on a mark
    const auto start = app::onSheet(sheet_, toWorld_, env.ui, watch_.start());
    if (start && app::isOnSheet(sheet_, *start)) grip_.hold = SheetHold::Sheet;
  }
  if (grip_.hold == SheetHold::Knob) lift(env, event);
  if (grip_.hold == SheetHold::Sheet) draw(env, event);
  if (grip_.hold == SheetHold::Fork) raise(env, event);
  if (grip_.hold == SheetHold::Lean) lean(env, event);
  if (grip_.hold == SheetHold::Rail) drawRail(env, event);
}

void SheetTool::show(const ToolEnv& env, const document::StackRecipe& recipe) const {
  const document::Part* part = document::findPart(env.document, sheet_.part);
  if (part == nullptr) return;
  app::Preview& preview = app::previewPart(env.ui, *part);
  preview.recipe = recipe;
  preview.fresh = false;
}

void SheetTool::lean(const ToolEnv& env, const ToolEvent& event) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  double app::Lean::* const way = app::kLeans[static_cast<std::size_t>(grip_.joint)];
  const double by = kDegrees * dot(event.at - watch_.start(), unit_) / dot(unit_, unit_);
  app::Lean lean = app::leanOf(sheet_);
  lean.*way += way == &app::Lean::side ? -by : by;  // its knob is at the left edge
  turn_ = app::turnFor(sheet_, lean);
  if (sheet_.layer) {
    show(env, app::withTurn(sheet_, turn_));
  } else {
    env.ui.layers.turn = turn_;
  }
}

void SheetTool::drawRail(const ToolEnv& env, const ToolEvent& event) {
  std::vector<app::ClientPoint>& line = env.ui.layers.rail;
  if (line.empty()) line.push_back(watch_.start());
  if (distance(event.at, line.back()) < kSpacing || env.picker == nullptr) return;
  line.push_back(event.at);
  rail_ = app::railAlong(env.document, env.derived, env.ui, *env.picker, sheet_, line);
  if (*rail_) show(env, app::withDrawnRail(sheet_.recipe, rail_->value()));
}

void SheetTool::raise(const ToolEnv& env, const ToolEvent& event) {
  raised_ = std::clamp(fork().at + dot(event.at - watch_.start(), unit_) / dot(unit_, unit_), 0.0, 1.0);
  show(env, app::withFork(sheet_.recipe, fork(), raised_));
}

void SheetTool::lift(const ToolEnv& env, const ToolEvent& event) {
  const double by = dot(event.at - watch_.start(), unit_) / dot(unit_, unit_);
  if (sheet_.isFree()) {
    shifted_ = app::withShift(sheet_, by * stack::lengthOf(sheet_.recipe.rail));
    return show(env, *shifted_);
  }
  env.ui.layers.at = std::clamp(before_ + by, 0.0, app::mostAt(sheet_));
}

void SheetTool::draw(const ToolEnv& env, const ToolEvent& event) {
  std::vector<SectionPoint>& line = env.ui.layers.line;
  if (line.empty()) {
    if (const auto first = app::onSheet(sheet_, toWorld_, env.ui, watch_.start())) line.push_back(*first);
    last_ = watch_.start();
    const document::Part* part = document::findPart(env.document, sheet_.part);
    if (part != nullptr) {
      app::previewPart(env.ui, *part);
    } else {
      app::Preview& preview = app::beginPreview(env.ui);
      preview.look = app::layerLook(env.ui);
      preview.recipe = sheet_.recipe;
    }
  }
  const auto at = app::onSheet(sheet_, toWorld_, env.ui, event.at);
  if (!at || distance(event.at, last_) < kSpacing || !env.ui.preview) return;
  line.push_back(*at);
  last_ = event.at;
  auto curves = app::curvesOf(sheet_, line);
  if (!curves) return;
  env.ui.preview->recipe = app::withCurves(sheet_, std::move(curves).value());
  env.ui.preview->fresh = false;
}

void SheetTool::commit(const ToolEnv& env) {
  const std::vector<SectionPoint> line = std::exchange(env.ui.layers.line, {});
  env.ui.layers.held = SheetHold::Nothing;
  env.ui.layers.rail.clear();
  env.ui.preview.reset();
  if (line.size() > 1) {
    env.sink.run(app::drawOnSheet, sheet_.part, sheet_.at, line);
  } else if (grip_.hold == SheetHold::Knob && shifted_) {
    env.sink.run(app::remakeLayers, sheet_.part, *shifted_);
  } else if (grip_.hold == SheetHold::Knob) {
    env.sink.run(app::seeSheet);
  } else if (grip_.hold == SheetHold::Lean && watch_.moved()) {
    env.sink.run(app::leanSheet, turn_);
  } else if (grip_.hold == SheetHold::Rail && rail_) {
    env.sink.run(app::followRail, sheet_.part, *rail_);
  } else if (grip_.hold == SheetHold::Fork && watch_.moved()) {
    env.sink.run(app::remakeLayers, sheet_.part, app::withFork(sheet_.recipe, fork(), raised_));
  } else if (grip_.hold == SheetHold::Link && !watch_.moved()) {
    const app::LayerLink& link = joints_.links[static_cast<std::size_t>(grip_.joint)];
    env.sink.run(app::remakeLayers, sheet_.part, app::withLink(sheet_.recipe, link, !link.on));
  }
}

void SheetTool::cancel(const ToolEnv& env) {
  if (grip_.hold == SheetHold::Knob) env.ui.layers.at = before_;
  if (grip_.hold == SheetHold::Lean && !sheet_.layer) env.ui.layers.turn = sheet_.turn;
  env.ui.layers.line.clear();
  env.ui.layers.rail.clear();
  env.ui.layers.held = SheetHold::Nothing;
  env.ui.preview.reset();
}

}  // namespace spineloft::tools
