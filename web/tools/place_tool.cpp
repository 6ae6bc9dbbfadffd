#include "web/tools/place_tool.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/tools/pick.h"
#include "web/ui/press.h"

namespace spineloft::tools {
namespace {

constexpr double kLeastSpread = 12;  // CSS pixels; nearer fingers only shift

double angleOf(const FingerPair& pair) {
  const app::ClientPoint way = pair.b - pair.a;
  return std::atan2(way.y, way.x);
}

}  // namespace

void PlaceTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  touch_ = event.touch();
  beganMs_ = nowMs_ = event.timeMs;
  parts_ = app::selectedParts(env.document, env.ui);
  const std::optional<app::Gizmo> gizmo = app::shownGizmo(env.document, env.derived, env.ui);
  drag_.camera = env.ui.camera;
  drag_.view = env.ui.layout.solid;
  drag_.from = event.at;
  if (gizmo) drag_.handle = app::handleAt(*gizmo, event.at, touch_);
  if (gizmo) drag_.gizmo = *gizmo;
  if (drag_.handle == app::GizmoHandle::None) {
    const app::Ray ray{env.ui.camera.eye(), app::rayThrough(env.ui.camera, env.ui.layout.solid, event.at)};
    const app::RayHit hit = env.picker->firstHit(env.document, env.derived, env.ui, ray);
    pressed_ = hit.part;
    if (!app::isSelected(env.document, env.ui, pressed_)) {
      parts_ = app::withGroup(env.document, pressed_);
    }
    const auto centre = app::centreOf(env.document, env.derived, env.ui, parts_);
    drag_.handle = app::GizmoHandle::Plane;
    drag_.gizmo.centre = drag_.gizmo.pivot = centre.value_or(hit.at);
    // What is under the finger stays under it: pixels are measured at its depth.
    const double away = -dot(hit.at - env.ui.camera.eye(), env.ui.camera.back());
    drag_.gizmo.unit = 2 * app::kHalfHeight * away / std::max(1.0, drag_.view.height);
    drag_.gizmo.at = app::pointOnCanvas(drag_.camera, drag_.view, drag_.gizmo.centre).value_or(event.at);
  }
  parts_ = app::withHosts(env.document, parts_);
  env.ui.held = drag_.handle;
}

document::Motion PlaceTool::settled(const ToolEnv& env, const ToolEvent& event, const document::Motion& motion) const {
  const app::Ray ray{drag_.camera.eye(), app::rayThrough(drag_.camera, drag_.view, event.at)};
  const app::RayHit hit = env.picker->firstHit(env.document, env.derived, env.ui, ray, parts_);
  if (!hit) return motion;
  return app::settleOn(env.document, env.derived, parts_, hit.at, hit.normal).value_or(motion);
}

void PlaceTool::show(const ToolEnv& env, const document::Motion& motion) {
  motion_ = motion;
  moved_ = true;
  env.ui.placing = app::movedParts(env.document, env.derived, parts_, motion);
}

void PlaceTool::move(const ToolEnv& env, const ToolEvent& event) {
  nowMs_ = event.timeMs;
  watch_.move(event);
  if (!watch_.moved() || pairing_ || parts_.empty()) return;
  const bool steps = (event.modifiers & platform::kShift) != 0;
  document::Motion motion = app::motionOf(drag_, event.at, steps);
  if (env.ui.place.snap && drag_.handle == app::GizmoHandle::Plane) motion = settled(env, event, motion);
  show(env, motion);
}

void PlaceTool::followPair(const ToolEnv& env, const FingerPair& from, const FingerPair& to) {
  pairing_ = true;
  by_ = by_ + (to.middle() - from.middle());
  if (std::min(from.spread(), to.spread()) >= kLeastSpread) {
    angle_ += std::remainder(angleOf(to) - angleOf(from), 2 * std::numbers::pi);
    factor_ *= to.spread() / from.spread();
  }
  show(env, app::pairMotion(drag_, by_, angle_, factor_));
}

void PlaceTool::commit(const ToolEnv& env) {
  env.ui.placing.clear();
  env.ui.held = app::GizmoHandle::None;
  if (!moved_) {
    if (!pressed_) return;
    const bool more = touch_ && nowMs_ - beganMs_ >= app::kLongPressMs;
    env.sink.run(app::selectPart, pressed_, more);
    return;
  }
  if (pressed_ && !app::isSelected(env.document, env.ui, pressed_)) env.sink.run(app::selectPart, pressed_, false);
  env.sink.run(app::moveParts, parts_, motion_);
}

void PlaceTool::cancel(const ToolEnv& env) {
  env.ui.placing.clear();
  env.ui.held = app::GizmoHandle::None;
}

}  // namespace spineloft::tools
