#include "web/tools/pin_tool.h"

#include "web/commands/intents.h"
#include "web/edit/placing.h"

namespace spineloft::tools {

void PinTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  const int under = pickInSolid(env, event).depth;
  const std::vector<app::DepthDot> dots = app::depthDots(env.document, env.derived, env.ui);
  const document::Part* part = document::findPart(env.document, env.ui.selection);
  const document::PictureEntry* entry =
      part ? document::findPicture(env.document, document::pictureOf(*part)) : nullptr;
  if (under < 0 || under >= static_cast<int>(dots.size()) || entry == nullptr) return;
  dot_ = dots[static_cast<std::size_t>(under)];
  const pipeline::Copies copies = app::shownCopies(env.ui, *part, entry->size);
  unit_ = nearerOnCanvas(env, *copies.begin(), dot_->where);
  env.ui.inHand.depth = under;
}

void PinTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const double unit2 = dot(unit_, unit_);
  if (!watch_.moved() || !dot_ || !(unit2 > 0)) return;
  const double by = dot(event.at - watch_.start(), unit_) / unit2;
  env.ui.inHand.pin = document::PinDepth{dot_->drawing, dot_->line, dot_->at, dot_->where.z + by};
  env.ui.inHand.pinShown = false;
}

void PinTool::commit(const ToolEnv& env) {
  const std::optional<document::PinDepth> pin = env.ui.inHand.pin;
  env.ui.inHand = {};
  if (pin) {
    env.sink.run(app::pinDepth, *pin);
  } else if (dot_ && dot_->pinned) {
    env.sink.run(app::pinDepth, document::PinDepth{dot_->drawing, dot_->line, dot_->at, {}});
  }
}

void PinTool::cancel(const ToolEnv& env) { env.ui.inHand = {}; }

}  // namespace spineloft::tools
