#include "web/tools/spine_tool.h"

#include "engine/ribs/edit/spine_gestures.h"
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
  app::putSpine(preview.loft(), std::move(changed), env.ui.edit.keepRibs);
  preview.fresh = false;
}

void SpineTool::tap(const ToolEnv& env) const {
  if (under_.handle >= 0) {
    env.sink.run("choose-handle", app::Json::Object{{"handle", under_.handle}});
  } else if (!under_.spine) {
    selectTapped(env, under_.part);
  }
}

void SpineTool::commit(const ToolEnv& env) {
  const app::InHand hand = std::exchange(env.ui.inHand, {});
  if (!watch_.moved()) return tap(env);
  if (!env.ui.preview) return;
  app::Json::Object args{{"part", env.ui.preview->part.value}, {"keep", env.ui.edit.keepRibs}};
  env.ui.preview.reset();
  if (under_.handle >= 0) {
    args.emplace_back("handle", under_.handle);
    args.emplace_back("to", pointJson(to_));
    args.emplace_back("reach", env.ui.edit.spineReach);
    env.sink.run("bend-spine", std::move(args));
  } else if (under_.spine) {
    args.emplace_back("by", pointJson(to_ - from_));
    env.sink.run("move-spine", std::move(args));
  } else {
    args.emplace_back("stroke", strokeJson(hand.stroke));
    env.sink.run(env.ui.edit.keepRibs ? "pose-spine" : "redraw-spine", std::move(args));
  }
}

void SpineTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
