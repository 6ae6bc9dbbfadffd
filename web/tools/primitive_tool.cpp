#include "web/tools/primitive_tool.h"

#include <span>
#include <utility>

#include "engine/geometry/polygon.h"
#include "web/commands/intents.h"
#include "web/edit/outline.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
namespace {

constexpr double kRound = 2.5;  // times as long as the way from its beginning to its end: a line goes round something

/// `part`: whose preview it is; null: a new one's.
void show(const ToolEnv& env, const document::Part* part, const document::ShapeRecipe& recipe) {
  if (part != nullptr) {
    app::previewPart(env.ui, *part);
  } else if (!env.ui.preview || env.ui.preview->part) {
    app::beginPreview(env.ui).look = env.ui.look;
  }
  env.ui.preview->recipe = recipe;
  env.ui.preview->fresh = false;
}

}  // namespace

void PrimitiveTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  line_ = {toPicture(env, event.at)};  // the view may be another one when the pointer moves
  const app::Hover under = pickInPicture(env, event);
  env.ui.hover = under;
  seen_ = app::shapeInHand(env.document, env.ui);
  if (const document::Part* aside = app::partAside(env.document, env.ui); aside && !seen_) aside_ = aside->id;
  if (!seen_) return;
  outline_ = begunAtOutline_ = under.outlineOfShape;
  held_ = under.shape;
  const auto handles = app::shapeHandles(*seen_);
  if (held_ >= 0 && held_ < static_cast<int>(handles.size())) handle_ = handles[static_cast<std::size_t>(held_)];
}

void PrimitiveTool::drag(const ToolEnv& env, app::ClientPoint at) {
  env.ui.chosen.shape = held_;
  auto made = app::draggedShape(env.document, *seen_, *handle_, handle_->at + (toPicture(env, at) - line_.front()));
  if (!made) return;
  made_ = std::move(made);
  show(env, seen_->part, *made_);
}

void PrimitiveTool::draw(const ToolEnv& env) {
  env.ui.inHand.stroke = line_;
  const document::ShapeRecipe recipe = app::previewOfLine(env.document, *seen_, line_);
  if (pipeline::outlineIn(recipe, env.document, recipe.picture).ok()) {
    show(env, seen_->part, recipe);
  } else if (env.ui.preview && !env.ui.preview->part) {
    env.ui.preview.reset();
  }
}

void PrimitiveTool::lay(const ToolEnv& env, app::ClientPoint at) {
  env.ui.inHand.stroke.clear();
  document::ShapeRecipe recipe = app::nextShape(env.ui, line_.front(), toPicture(env, at));
  if (!shape::isValid(recipe.shape)) return;
  made_ = std::move(recipe);
  show(env, nullptr, *made_);
}

/// The line is bent back and has the middle of the shape in hand within it.
bool PrimitiveTool::goesRound() const {
  double length = 0;
  for (std::size_t i = 1; i < line_.size(); ++i) length += distance(line_[i - 1], line_[i]);
  const auto& [from, to] = seen_->recipe.shape.axis;
  return length > kRound * distance(line_.front(), line_.back()) &&
         geometry::holds(std::span<const PicturePoint>(line_), (from + to) / 2);
}

void PrimitiveTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const bool longer = !handle_ && extend(env, line_, event.at);  // also what is still a click: a line begins with it
  if (!watch_.moved()) return;
  if (handle_) return drag(env, event.at);
  if (!longer) return;
  if (aside_) {
    outline_ = true;
    env.ui.inHand.stroke = line_;
    return;
  }
  outline_ = begunAtOutline_ || (seen_ && goesRound());
  if (outline_) {
    draw(env);
  } else {
    lay(env, event.at);
  }
}

void PrimitiveTool::tap(const ToolEnv& env) const {
  const PicturePoint p = line_.front();
  const PartId under = app::partAt(env.document, env.derived, env.ui.picture, p, 0);
  if (handle_) {
    env.sink.run(app::chooseShapeHandle, held_);
  } else if (under) {
    env.sink.run(app::selectPart, under, false);
  } else {
    env.sink.run(app::fitShape, p, aside_ || (seen_ && seen_->view) ? env.ui.selection : PartId{});
  }
}

void PrimitiveTool::commit(const ToolEnv& env) {
  env.ui.inHand = {};
  const PartId part = env.ui.selection;
  env.ui.preview.reset();
  if (!watch_.moved()) {
    tap(env);
  } else if (handle_) {
    if (made_) env.sink.run(app::reshape, part, *made_);
  } else if (outline_) {
    env.sink.run(app::drawShapeLine, part, line_);
  } else if (made_) {
    env.sink.run(app::drawShape, *made_, true);
  }
}

void PrimitiveTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
