#include "web/tools/primitive_tool.h"

#include <utility>

#include "web/commands/intents.h"
#include "web/edit/outline.h"
#include "web/edit/preview.h"

namespace spineloft::tools {

void PrimitiveTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  const app::Hover under = pickInPicture(env, event);
  env.ui.hover = under;
  seen_ = app::shapeInHand(env.document, env.ui);
  if (!seen_) return;
  outline_ = under.outlineOfShape;
  held_ = under.shape;
  const auto handles = app::shapeHandles(*seen_);
  if (held_ >= 0 && held_ < static_cast<int>(handles.size())) handle_ = handles[static_cast<std::size_t>(held_)];
}

/// The preview of the part in hand, or of a new one.
void PrimitiveTool::show(const ToolEnv& env, const document::ShapeRecipe& recipe) const {
  const bool own = handle_ || outline_;
  if (own) {
    app::previewPart(env.ui, *seen_->part);
  } else if (!env.ui.preview) {
    app::beginPreview(env.ui).look = env.ui.look;
  }
  env.ui.preview->recipe = recipe;
  env.ui.preview->fresh = false;
}

void PrimitiveTool::drag(const ToolEnv& env, app::ClientPoint at) {
  env.ui.chosen.shape = held_;
  const PicturePoint by = toPicture(env, at) - toPicture(env, watch_.start());
  auto made = app::draggedShape(env.document, *seen_, *handle_, handle_->at + by);
  if (!made) return;
  made_ = std::move(made);
  show(env, *made_);
}

void PrimitiveTool::draw(const ToolEnv& env, app::ClientPoint at) {
  std::vector<PicturePoint>& stroke = env.ui.inHand.stroke;
  if (stroke.empty()) stroke.push_back(toPicture(env, watch_.start()));
  if (!extend(env, stroke, at)) return;
  const document::ShapeRecipe recipe = app::previewOfLine(env.document, *seen_, stroke);
  if (pipeline::outlineIn(recipe, env.document, recipe.picture).ok()) show(env, recipe);
}

void PrimitiveTool::lay(const ToolEnv& env, app::ClientPoint at) {
  document::ShapeRecipe recipe = app::nextShape(env.ui, toPicture(env, watch_.start()), toPicture(env, at));
  if (!shape::isValid(recipe.shape)) return;
  made_ = std::move(recipe);
  show(env, *made_);
}

void PrimitiveTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved()) return;
  if (handle_) {
    drag(env, event.at);
  } else if (outline_) {
    draw(env, event.at);
  } else {
    lay(env, event.at);
  }
}

void PrimitiveTool::tap(const ToolEnv& env) const {
  const PicturePoint p = toPicture(env, watch_.start());
  const PartId under = app::partAt(env.document, env.derived, env.ui.picture, p, 0);
  if (handle_) {
    env.sink.run(app::chooseShapeHandle, held_);
  } else if (under) {
    env.sink.run(app::selectPart, under, false);
  } else {
    env.sink.run(app::fitShape, p, seen_ && seen_->view ? env.ui.selection : PartId{});
  }
}

void PrimitiveTool::commit(const ToolEnv& env) {
  const app::InHand hand = std::exchange(env.ui.inHand, {});
  const PartId part = env.ui.selection;
  env.ui.preview.reset();
  if (!watch_.moved()) {
    tap(env);
  } else if (handle_) {
    if (made_) env.sink.run(app::reshape, part, *made_);
  } else if (outline_) {
    env.sink.run(app::drawShapeLine, part, hand.stroke);
  } else if (made_) {
    env.sink.run(app::drawShape, *made_, true);
  }
}

void PrimitiveTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
