#include "web/tools/depth_tool.h"

#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"

namespace spineloft::tools {
void DepthTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  handle_ = pickInSolid(env, event).depth;
  const app::Subject subject = app::subjectOf(env.document, env.derived, env.ui.selection);
  const document::PictureEntry* entry =
      subject ? document::findPicture(env.document, document::pictureOf(*subject.part)) : nullptr;
  if (handle_ < 0 || entry == nullptr) return;
  const pipeline::Copies copies = app::shownCopies(env.ui, *subject.part, entry->size);
  unit_ = nearerOnCanvas(env, *copies.begin(), app::depthHandles(subject)[static_cast<std::size_t>(handle_)]);
  env.ui.inHand.depth = handle_;
}

void DepthTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  const app::Subject subject = app::subjectOf(env.document, env.derived, env.ui.selection);
  const double unit2 = dot(unit_, unit_);
  if (!watch_.moved() || !subject || handle_ < 0 || !(unit2 > 0)) return;
  const double by = dot(event.at - watch_.start(), unit_) / unit2;
  depth_ = app::raiseDepth(document::loftIn(*subject.part).pose.depth, app::handlePlace(handle_), by,
                           env.ui.edit.spineReach);
  app::Preview& preview = app::previewPart(env.ui, *subject.part);
  preview.asLoft().pose.depth = depth_;
  preview.fresh = false;
}

void DepthTool::commit(const ToolEnv& env) {
  env.ui.inHand = {};
  if (!env.ui.preview) {
    if (handle_ >= 0) env.sink.run(app::chooseHandle, handle_);
    return;
  }
  const PartId part = env.ui.preview->part;
  env.ui.preview.reset();
  env.sink.run(app::setDepth, part, depth_);
}

void DepthTool::cancel(const ToolEnv& env) {
  env.ui.preview.reset();
  env.ui.inHand = {};
}

}  // namespace spineloft::tools
