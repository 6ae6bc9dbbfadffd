#include "web/tools/bridge_tool.h"

#include "web/commands/intents.h"
#include "web/edit/preview.h"

namespace spineloft::tools {

void BridgeTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  const app::Hover under = pickInSolid(env, event);
  pressed_ = under.part;
  if (under.rim >= 0) {
    rim_ = under.rim;
    part_ = env.ui.selection;
  } else {
    from_ = app::bridgePlaceUnder(env.document, env.derived, env.ui, event.at);
  }
}

void BridgeTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  if (!watch_.moved() || (rim_ < 0 && !from_)) return;
  const auto to = app::bridgePlaceUnder(env.document, env.derived, env.ui, event.at);
  if (rim_ < 0) {
    env.ui.inHand.besideSolid = {watch_.start(), event.at};
    made_.reset();
    if (!to || !app::areApart(*from_, *to)) {
      env.ui.preview.reset();
      return;
    }
    if (!env.ui.preview || env.ui.preview->part) {
      app::beginPreview(env.ui).look = app::bridgeLook(env.document, env.derived, from_->part);
    }
    made_ = app::usualBridge(env.document, *from_, *to, env.ui.edit.bridgeWidth);
    env.ui.preview->recipe = *made_;
    env.ui.preview->fresh = false;
    return;
  }
  const document::Part* part = document::findPart(env.document, part_);
  const document::BridgeRecipe* own = part ? document::bridgeOf(*part) : nullptr;
  if (own == nullptr || !to) return;
  const auto end = app::carriedEnd(env.document, env.derived, rim_ == 0 ? own->from : own->to, *to);
  if (!end) return;
  made_ = *own;
  (rim_ == 0 ? made_->from : made_->to) = *end;
  app::previewPart(env.ui, *part).recipe = *made_;
  env.ui.preview->fresh = false;
}

void BridgeTool::commit(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
  if (!watch_.moved()) {
    if (pressed_) env.sink.run(app::selectPart, pressed_, false);
  } else if (rim_ >= 0) {
    if (made_) env.sink.run(app::moveBridgeEnd, part_, rim_, rim_ == 0 ? made_->from : made_->to);
  } else if (made_) {
    env.sink.run(app::drawBridge, *made_);
  } else {
    env.sink.run(app::refuseBridge, pressed_);
  }
}

void BridgeTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
