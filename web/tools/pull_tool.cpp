#include "web/tools/pull_tool.h"

#include <algorithm>
#include <optional>
#include <span>

#include "engine/geometry/polyline.h"
#include "web/commands/intents.h"
#include "web/edit/bumping.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
namespace {

// CSS pixels from its beginning: what is smaller is a tap.
constexpr double kLeastRing = 8, kLeastTouchRing = 16;
constexpr double kOutlineEnds = 2;  // of the reach of a press: ends of a line are that near to the outline

}  // namespace

void PullTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  leastRing_ = event.touch() ? kLeastTouchRing : kLeastRing;
  const app::Hover under = pickInSolid(env, event);
  const app::PulledPart part = app::pulledPart(env.document, env.derived, env.ui);
  if (under.pull < 0) {
    if (under.part && under.part != env.ui.selection) {  // the line goes on there
      before_ = {env.ui.selection, env.ui.alsoSelected};
      other_ = env.ui.selection = under.part;
      env.ui.alsoSelected.clear();
    }
    outline_ = !under.part;
    reach_ = kOutlineEnds * (event.touch() ? kTouchReach : kMouseReach);
    if (outline_) env.ui.inHand.besideSolid = {event.at};
    if (!outline_) addPlace(env, event.at);
    return;
  }
  const auto number = static_cast<std::size_t>(under.pull);
  const auto knob = app::pullKnob(part, env.ui, number);
  if (!knob) return;
  knob_ = under.pull;
  part_ = part.part->id;
  unit_ = knob->unit;
  held_ = part.pulls[number];
  line_ = part.shape->pulled[number];
  env.ui.chosen = {};
  env.ui.chosen.pull = knob_;
}

void PullTool::addPlace(const ToolEnv& env, app::ClientPoint at) {
  const app::PulledPart part = app::pulledPart(env.document, env.derived, env.ui);
  if (!part) return;
  const app::Ray ray{env.ui.camera.eye(), app::rayThrough(env.ui.camera, env.ui.layout.solid, at)};
  const auto place = app::surfaceUnder(part, ray);
  std::vector<ModelPoint>& line = env.ui.inHand.onSolid;
  farthest_ = std::max(farthest_, distance(at, watch_.start()));
  if (!place || (!line.empty() && (place->copy != copy_ || distance(line.back(), place->at) == 0))) return;
  copy_ = place->copy;
  line.push_back(place->at);
}

void PullTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved()) return;
  if (outline_) {
    env.ui.inHand.besideSolid.push_back(event.at);
    return;
  }
  if (knob_ < 0) return addPlace(env, event.at);
  const document::Part* part = document::findPart(env.document, part_);
  const auto number = static_cast<std::size_t>(knob_);
  const double unit2 = dot(unit_, unit_);
  if (part == nullptr || number >= part->pulls.size() || !(unit2 > 0)) return;
  app::Preview& preview = app::previewPart(env.ui, *part);
  preview.pulls = part->pulls;
  preview.pulls[number] = app::raised(held_, line_, dot(event.at - watch_.start(), unit_) / unit2);
  preview.fresh = false;
}

void PullTool::commit(const ToolEnv& env) {
  const std::vector<ModelPoint> line = std::move(env.ui.inHand.onSolid);
  const std::vector<app::ClientPoint> stroke = std::move(env.ui.inHand.besideSolid);
  env.ui.inHand = {};
  if (other_ && !watch_.moved()) {
    env.sink.run(app::selectPart, other_, false);
  } else if (outline_) {
    if (watch_.moved()) env.sink.run(app::redrawSeenOutline, env.ui.selection, stroke, reach_);
  } else if (knob_ >= 0 && env.ui.preview) {
    const PartId part = env.ui.preview->part;
    const pull::Pull changed = env.ui.preview->pulls[static_cast<std::size_t>(knob_)];
    env.ui.preview.reset();
    env.sink.run(app::setPull, part, static_cast<std::size_t>(knob_), changed);
  } else if (knob_ < 0 && !line.empty()) {
    const auto ring = farthest_ > leastRing_ ? app::ringOf(line) : std::nullopt;
    if (ring) {
      env.sink.run(app::drawBump, env.ui.selection, *ring);
    } else {
      env.sink.run(app::drawPull, env.ui.selection, line);
    }
  }
}

void PullTool::cancel(const ToolEnv& env) {
  if (other_ && env.ui.selection == other_) {
    env.ui.selection = before_.first;
    env.ui.alsoSelected = before_.second;
  }
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
