#include "web/tools/spine_tool.h"

#include "engine/ribs/edit/spine_gestures.h"
#include "web/commands/intents.h"
#include "web/edit/preview.h"

namespace spineloft::tools {

void SpineTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  under_ = pickInPicture(env, event);
  env.ui.hover = under_;
  from_ = toPicture(env, event.at);
}

std::vector<PicturePoint> SpineTool::line(const ToolEnv& env, const app::Subject& subject, const ToolEvent& event) {
  to_ = toPicture(env, event.at);
  if (under_.handle >= 0) {
    const PicturePoint at = app::spineHandles(subject)[static_cast<std::size_t>(under_.handle)];
    to_ = at + (to_ - from_);
    return app::moveHandle(app::spineLine(subject), under_.handle, to_, env.ui.edit.spineReach);
  }
  if (under_.spine) return ribs::shiftStroke(app::spineLine(subject), to_ - from_);
  std::vector<PicturePoint>& stroke = env.ui.inHand.stroke;
  if (stroke.empty()) stroke.push_back(from_);
  extend(env, stroke, event.at);
  return stroke;
}

void SpineTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const app::Subject subject = editedPart(env);
  if (!watch_.moved() || !subject) return;
  std::vector<PicturePoint> changed = line(env, subject, event);
  if (changed.size() < 2) return;
  app::Preview& preview = app::previewPart(env.ui, *subject.part);
  preview.recipe = subject.part->recipe;
  app::putSpine(preview.asLoft(), std::move(changed), env.ui.edit.keepRibs);
  preview.fresh = false;
}

void SpineTool::tap(const ToolEnv& env) const {
  if (under_.handle >= 0) {
    env.sink.run(app::chooseHandle, under_.handle);
  } else if (!under_.spine) {
    selectTapped(env, under_.part);
  }
}

void SpineTool::commit(const ToolEnv& env) {
  const app::InHand hand = std::exchange(env.ui.inHand, {});
  if (!watch_.moved()) return tap(env);
  if (!env.ui.preview) return;
  const PartId part = env.ui.preview->part;
  const bool keep = env.ui.edit.keepRibs;
  env.ui.preview.reset();
  if (under_.handle >= 0) {
    env.sink.run(app::bendSpine, app::BendSpineIntent{part, under_.handle, to_, env.ui.edit.spineReach, keep});
  } else if (under_.spine) {
    env.sink.run(app::moveSpine, part, to_ - from_, keep);
  } else if (keep) {
    env.sink.run(app::poseAlong, part, hand.stroke);
  } else {
    env.sink.run(app::redrawSpine, part, hand.stroke);
  }
}

void SpineTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
