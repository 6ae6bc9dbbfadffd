#include "web/tools/shape_tool.h"

#include "web/commands/intents.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
namespace {

constexpr double kLineReach = 60;  // CSS pixels: how far an end may go to meet the line

}  // namespace

void ShapeTool::begin(const ToolEnv&, const ToolEvent& event) { watch_.begin(event); }

void ShapeTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const app::Subject subject = editedPart(env);
  if (!watch_.moved() || !subject) return;
  app::InHand& hand = env.ui.inHand;
  if (hand.stroke.empty()) hand.stroke.push_back(toPicture(env, watch_.start()));
  extend(env, hand.stroke, event.at);
  ribs::StrokeDeform deform = ribs::deformByStroke(app::sceneOf(subject), hand.stroke,
                                                   kLineReach / env.ui.pictureView.zoom, env.ui.edit.bothSides);
  hand.touched = std::move(deform.touched);
  app::Preview& preview = app::previewPart(env.ui, *subject.part);
  preview.asLoft().edits = std::move(deform.edits);
  preview.fresh = false;
}

void ShapeTool::commit(const ToolEnv& env) {
  const app::InHand hand = std::exchange(env.ui.inHand, {});
  if (!env.ui.preview) {
    const PicturePoint p = toPicture(env, watch_.start());
    const PartId part = app::partAt(env.document, env.derived, env.ui.picture, p, 0);
    selectTapped(env, part);
    return;
  }
  const PartId part = env.ui.preview->part;
  env.ui.preview.reset();
  env.sink.run(app::shapeRibs,
               app::ShapeRibsIntent{part, hand.stroke, kLineReach / env.ui.pictureView.zoom, env.ui.edit.bothSides});
}

void ShapeTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
