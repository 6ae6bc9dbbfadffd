#include "web/tools/bone_tool.h"

#include <algorithm>
#include <utility>

#include "web/commands/intents.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
namespace {

/// The puff as an edit makes it, with as many points as can follow a pen.
document::InflateRecipe recipeOf(const document::Part& part, const app::BoneEdit& edit) {
  document::InflateRecipe recipe = *document::inflateOf(part);
  recipe.inflate = edit.params;
  recipe.inflate.points = std::min(recipe.inflate.points, app::kPreviewPoints);
  return recipe;
}

bool isLine(app::BoneHold hold) { return hold == app::BoneHold::Bone || hold == app::BoneHold::Gone; }

}  // namespace

void BoneTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  const app::Hover under = view_ == app::Focus::Picture ? pickInPicture(env, event) : pickInSolid(env, event);
  env.ui.hover = under;
  under_ = under.part;
  const auto handles = app::boneHandles(app::bonesInHand(env.document, env.derived, env.ui));
  held_ = under.bone;
  if (held_ >= 0 && held_ < static_cast<int>(handles.size())) handle_ = handles[static_cast<std::size_t>(held_)];
}

/// What the drag makes of the puff, were it let go here; none where there is nothing new.
std::optional<app::BoneEdit> BoneTool::changed(const ToolEnv& env, const app::BonedPuff& puff, app::ClientPoint at) {
  if (handle_ && !isLine(handle_->hold)) {
    env.ui.chosen.bone = held_;
    if (view_ == app::Focus::Picture) {
      const PicturePoint from = toPicture(env, watch_.start()), to = toPicture(env, at);
      return app::dragged(puff, *handle_, from, to, env.ui.pictureView.zoom);
    }
    const auto hold = app::holdInSolid(puff, *handle_, env.ui);
    const auto place = hold ? app::onBonesInSolid(puff, env.ui, at) : std::nullopt;
    return place ? std::optional(app::moveSlice(*puff.params, handle_->edit, *place)) : std::nullopt;
  }
  std::vector<PicturePoint>& stroke = env.ui.inHand.stroke;
  if (stroke.empty()) stroke.push_back(toPicture(env, watch_.start()));
  return extend(env, stroke, at) ? std::optional(app::addBone(*puff.params, stroke)) : std::nullopt;
}

void BoneTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const app::BonedPuff puff = app::bonesInHand(env.document, env.derived, env.ui);
  if (!watch_.moved() || !puff) return;
  std::optional<app::BoneEdit> edit = changed(env, puff, event.at);
  if (!edit || !inflate::isValid(edit->params) || !app::findsPlace(*puff.shape, *edit)) return;
  edit_ = std::move(edit);
  app::Preview& preview = app::previewPart(env.ui, *puff.part);
  preview.recipe = recipeOf(*puff.part, *edit_);
  preview.fresh = false;
}

void BoneTool::tap(const ToolEnv& env) const {
  if (!handle_) {
    selectTapped(env, under_);
  } else if (isLine(handle_->hold)) {
    env.sink.run(app::toggleBone, env.ui.selection, held_);
  } else {
    env.sink.run(app::chooseBone, held_);
  }
}

void BoneTool::commit(const ToolEnv& env) {
  env.ui.inHand = {};
  const PartId part = env.ui.selection;
  env.ui.preview.reset();
  if (!watch_.moved()) return tap(env);
  if (edit_) {
    env.sink.run(app::setBones, part, edit_->params);
  } else {
    env.sink.run(app::refuseBone, handle_ && !isLine(handle_->hold));
  }
}

void BoneTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
