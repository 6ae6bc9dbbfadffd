#include "web/tools/region_tool.h"

#include <utility>

#include "web/commands/intents.h"
#include "web/edit/outline.h"
#include "web/edit/preview.h"
#include "web/edit/region_editing.h"

namespace spineloft::tools {
namespace {

constexpr std::size_t kHintPoints = 48;  // of a scribble: each is looked round for its colour

/// As many points of a stroke, evenly, with both its ends.
std::vector<PicturePoint> thinned(const std::vector<PicturePoint>& stroke) {
  if (stroke.size() <= kHintPoints) return stroke;
  std::vector<PicturePoint> out;
  for (std::size_t i = 0; i < kHintPoints; ++i) out.push_back(stroke[i * (stroke.size() - 1) / (kHintPoints - 1)]);
  return out;
}

/// What a line becomes with the tool in use: of the part that is drawn again, or of a new one.
struct Drawn {
  document::Region region;
  document::RegionSolid solid;
};
Drawn drawnBy(const ToolEnv& env, const document::PictureEntry& entry, const std::vector<PicturePoint>& line) {
  const app::UiState& ui = env.ui;
  if (ui.tool == app::ToolKind::Spin) {
    return {app::profileOfLine(entry.id, line, entry.size), app::nextLathe(env.document, ui)};
  }
  const document::Region region = app::regionOfLine(entry.id, line, entry.size);
  if (ui.tool == app::ToolKind::Extrude) return {region, ui.extrude};
  return {region, ui.inflate};
}

}  // namespace

RegionTool::Way RegionTool::wayOf(const app::UiState& ui) {
  if (!app::cutsOut(ui.tool) || ui.cutBy == app::CutBy::Outline) return Way::Outline;
  return ui.cutBy == app::CutBy::Box ? Way::Box : Way::Scribble;
}

void RegionTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  const app::Hover under = pickInPicture(env, event);
  grabbed_ = under.outline;
  part_ = env.ui.selection;
  end_ = under.axis;
  axis_ = app::axisInHand(env.document, env.ui);
  way_ = env.ui.cut ? Way::Mark : grabbed_ ? Way::Point : axis_ && end_ >= 0 ? Way::Axis : wayOf(env.ui);
  if (way_ == Way::Mark) mark(env, event);
}

void RegionTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (way_ == Way::Mark) mark(env, event);
  if (!watch_.moved()) return;
  if (way_ == Way::Point) drag(env, event);
  if (way_ == Way::Axis) swing(env, event);
  if (way_ == Way::Box) span(env, event);
  if (way_ == Way::Scribble) scribble(env, event);
  if (way_ == Way::Outline) draw(env, event);
}

void RegionTool::mark(const ToolEnv& env, const ToolEvent& event) const {
  env.ui.inHand.radius = env.ui.edit.brush / env.ui.pictureView.zoom;
  extend(env, env.ui.inHand.stroke, event.at);
}

void RegionTool::scribble(const ToolEnv& env, const ToolEvent& event) const {
  std::vector<PicturePoint>& stroke = env.ui.inHand.stroke;
  if (stroke.empty()) stroke.push_back(toPicture(env, watch_.start()));
  mark(env, event);
}

void RegionTool::span(const ToolEnv& env, const ToolEvent& event) const {
  env.ui.inHand.box = true;
  env.ui.inHand.stroke = {toPicture(env, watch_.start()), toPicture(env, event.at)};
}

void RegionTool::drag(const ToolEnv& env, const ToolEvent& event) {
  const document::Part* part = document::findPart(env.document, part_);
  if (part == nullptr) return;
  to_ = toPicture(env, event.at);
  app::Preview& preview = app::previewPart(env.ui, *part);
  preview.recipe = part->recipe;
  document::Region* region = document::regionOf(preview.recipe);
  if (region == nullptr) return;
  *region = app::withMovedPoint(*region, *grabbed_, to_);
  preview.fresh = false;
}

/// An end of the axis follows the pointer, and the part with it.
void RegionTool::swing(const ToolEnv& env, const ToolEvent& event) {
  axis_ = app::withMovedEnd(*axis_, end_, toPicture(env, event.at));
  const document::Part* part = document::findPart(env.document, axis_->part);
  if (part == nullptr) return;
  app::Preview& preview = app::previewPart(env.ui, *part);
  auto* spun = std::get_if<document::LatheRecipe>(&preview.recipe);
  if (spun == nullptr) return;
  spun->lathe.axisFrom = axis_->from;
  spun->lathe.axisTo = axis_->to;
  preview.fresh = false;
}

void RegionTool::draw(const ToolEnv& env, const ToolEvent& event) {
  app::InHand& hand = env.ui.inHand;
  if (hand.stroke.empty()) {
    hand.stroke.push_back(toPicture(env, watch_.start()));
    const document::Part* redraw = document::findPart(env.document, env.ui.redraw);
    if (redraw && document::regionOf(redraw->recipe)) {
      app::previewPart(env.ui, *redraw);
    } else {
      app::Preview& preview = app::beginPreview(env.ui);
      preview.look = env.ui.look;
    }
  }
  if (!extend(env, hand.stroke, event.at) || !env.ui.preview) return;
  const document::PictureEntry* entry = document::findPicture(env.document, env.ui.picture);
  if (entry == nullptr) return;
  Drawn drawn = drawnBy(env, *entry, hand.stroke);
  if (auto* inflate = std::get_if<inflate::InflateParams>(&drawn.solid)) {
    inflate->points = std::min(inflate->points, app::kPreviewPoints);
  }
  env.ui.preview->recipe = document::recipeOf(drawn.region, drawn.solid);
  env.ui.preview->fresh = false;
}

void RegionTool::tap(const ToolEnv& env) const {
  const PicturePoint p = toPicture(env, watch_.start());
  const PartId under = app::partAt(env.document, env.derived, env.ui.picture, p, 0);
  // A part of another kind that is selected already may lie on what is meant.
  const document::Part* selected = document::findPart(env.document, env.ui.selection);
  const bool isMeant = under && under == env.ui.selection && !document::regionOf(selected->recipe);
  if (under && !(isMeant && app::cutsOut(env.ui.tool))) {
    env.sink.run(app::selectPart, under, false);
  } else if (app::cutsOut(env.ui.tool)) {
    env.sink.run(app::startCutOut, vision::CutHints{{p}, {}, {}, {}}, PartId{});
  } else if (const auto axis = app::shownAxis(env.document, env.ui); axis && !axis->part) {
    const app::ShownAxis moved = app::axisThrough(*axis, p);
    env.sink.run(app::setAxis, PartId{}, moved.from, moved.to);
  }
}

void RegionTool::commit(const ToolEnv& env) {
  const app::InHand hand = std::exchange(env.ui.inHand, {});
  const PartId redraw = env.ui.redraw;
  const bool dragged = way_ == Way::Point && watch_.moved();
  env.ui.preview.reset();
  if (way_ == Way::Mark) {
    env.sink.run(app::markCutOut, hand.stroke, hand.radius);
  } else if (way_ == Way::Box && hand.box) {
    env.sink.run(app::startCutOut, vision::CutHints{{}, {}, {{hand.stroke.front(), hand.stroke.back()}}, {}}, redraw);
  } else if (way_ == Way::Scribble && !hand.stroke.empty()) {
    env.sink.run(app::startCutOut, vision::CutHints{thinned(hand.stroke), {}, {}, {}}, redraw);
  } else if (dragged) {
    env.sink.run(app::moveOutlinePoint, part_, *grabbed_, to_);
  } else if (way_ == Way::Axis) {
    if (watch_.moved()) env.sink.run(app::setAxis, axis_->part, axis_->from, axis_->to);
  } else if (hand.stroke.empty()) {
    if (!grabbed_) tap(env);
  } else {
    drawn(env, hand.stroke);
  }
}

/// The line went round something: a new part, or the outline of the one that is drawn again.
void RegionTool::drawn(const ToolEnv& env, const std::vector<PicturePoint>& line) const {
  const document::Part* redraw = document::findPart(env.document, env.ui.redraw);
  const document::PictureEntry* entry =
      document::findPicture(env.document, redraw ? document::pictureOf(*redraw) : env.ui.picture);
  if (entry == nullptr) return;
  const Drawn drawn = drawnBy(env, *entry, line);
  if (redraw != nullptr) {
    env.sink.run(app::redrawRegion, redraw->id, drawn.region);
  } else {
    env.sink.run(app::drawRegion, drawn.region, drawn.solid, true);
  }
}

void RegionTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
