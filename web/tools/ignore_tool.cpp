#include "web/tools/ignore_tool.h"

#include "web/commands/intents.h"
#include "web/edit/preview.h"

namespace spineloft::tools {

void IgnoreTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  under_ = pickInPicture(env, event);
}

void IgnoreTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved()) return;
  app::InHand& hand = env.ui.inHand;
  hand.radius = env.ui.edit.brush / env.ui.pictureView.zoom;
  if (hand.stroke.empty()) hand.stroke.push_back(toPicture(env, watch_.start()));
  const app::Subject subject = editedPart(env);
  if (!extend(env, hand.stroke, event.at) || !subject) return;
  app::Preview& preview = app::previewPart(env.ui, *subject.part);
  preview.asLoft().ignored = document::loftIn(*subject.part).ignored;
  preview.asLoft().ignored.push_back({hand.stroke, hand.radius, env.ui.edit.paintOver});
  preview.fresh = false;
}

void IgnoreTool::commit(const ToolEnv& env) {
  const app::InHand hand = std::exchange(env.ui.inHand, {});
  env.ui.preview.reset();
  if (!hand.stroke.empty()) {
    const ribs::IgnoreMark mark{hand.stroke, hand.radius, env.ui.edit.paintOver};
    const bool forPicture = env.ui.edit.wholePicture || !editedPart(env);
    if (forPicture) {
      env.sink.run(app::ignoreForPicture, env.ui.picture, mark);
    } else {
      env.sink.run(app::ignoreForPart, env.ui.selection, mark);
    }
  } else if (under_.mark >= 0) {
    env.sink.run(app::removeIgnored, static_cast<std::size_t>(under_.mark));
  } else {
    selectTapped(env, under_.part);
  }
}

void IgnoreTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
