#include "web/tools/rib_tool.h"

#include "web/commands/intents.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
void RibTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  under_ = pickInPicture(env, event);
  const app::Subject subject = editedPart(env);
  if (!under_.end || under_.other >= 0 || !subject) return;
  const ribs::Rib& rib = subject.shape->ribs.ribs[under_.end->rib];
  offset_ = app::endPoint(rib, under_.end->side) - toPicture(env, event.at);
  env.ui.hover = under_;
  env.ui.inHand.end = under_.end;
}

void RibTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const app::Subject subject = editedPart(env);
  if (!watch_.moved() || !under_.end || under_.other >= 0 || !subject) return;
  to_ = toPicture(env, event.at) + offset_;
  app::Preview& preview = app::previewPart(env.ui, *subject.part);
  preview.asLoft().edits = ribs::dragEnd(app::sceneOf(subject), *under_.end, to_, env.ui.edit.ribReach);
  preview.fresh = false;
}

void RibTool::tap(const ToolEnv& env) const {
  const PartId part = env.ui.selection;
  if (under_.end && under_.other >= 0) {
    env.sink.run(app::takePlace, part, *under_.end, under_.other);
  } else if (under_.end) {
    env.sink.run(app::chooseRib, part, *under_.end);
  } else {
    const app::Subject subject = editedPart(env);
    const PicturePoint p = toPicture(env, watch_.start());
    const double reach = kMouseReach / env.ui.pictureView.zoom;
    if (const auto rib = subject ? ribs::nearestRib(subject.shape->ribs, p, reach) : std::nullopt) {
      const ribs::Rib& seen = subject.shape->ribs.ribs[*rib];
      const bool left = distance(p, seen.left) <= distance(p, seen.right);
      env.sink.run(app::chooseRib, part, ribs::EndRef{*rib, left ? ribs::Side::Left : ribs::Side::Right});
    } else {
      selectTapped(env, under_.part);
    }
  }
}

void RibTool::commit(const ToolEnv& env) {
  env.ui.inHand = {};
  if (!watch_.moved()) return tap(env);
  if (!env.ui.preview || !under_.end) return;
  env.sink.run(app::moveRibEnd, env.ui.preview->part, *under_.end, to_, env.ui.edit.ribReach);
  env.ui.preview.reset();
}

void RibTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
