#include "web/tools/line_tool.h"

#include <algorithm>
#include <utility>

#include "engine/document/pieces.h"
#include "web/commands/intents.h"
#include "web/edit/line_drawing.h"
#include "web/edit/outline.h"

namespace spineloft::tools {
namespace {

constexpr double kCloses = 14, kTouchCloses = 18;  // CSS pixels between ends that are meant to meet

}  // namespace

void LineTool::begin(const ToolEnv& env, const ToolEvent& event) {
  watch_.begin(event);
  env.ui.hover = under_ = pickInPicture(env, event);
  line_ = {toPicture(env, event.at)};
  const bool shift = (event.modifiers & platform::kShift) != 0;
  hidden_ = event.barrel || env.ui.edit.hiddenPen != shift;
  reach_ = (event.touch() ? kTouchCloses : kCloses) / env.ui.pictureView.zoom;
}

void LineTool::move(const ToolEnv& env, const ToolEvent& event) {
  watch_.move(event);
  extend(env, line_, event.at);  // also what is still a tap: a line begins with it
  if (!watch_.moved()) return;
  env.ui.inHand.stroke = line_;
  env.ui.inHand.hidden = hidden_;
}

void LineTool::tap(const ToolEnv& env) const {
  if (under_.crossing >= 0) {
    env.sink.run(app::swapCrossing, under_.crossing);
  } else if (under_.looseEnd >= 0) {
    const auto ends = app::looseEndsOn(env.document, env.derived, env.ui.picture);
    const auto at = static_cast<std::size_t>(under_.looseEnd);
    if (at < ends.size()) env.sink.run(app::closeLine, ends[at].drawing, ends[at].line, ends[at].at);
  } else {
    selectTapped(env, app::partAt(env.document, env.derived, env.ui.picture, line_.front(), 0));
  }
}

void LineTool::commit(const ToolEnv& env) {
  env.ui.inHand = {};
  if (!watch_.moved()) return tap(env);
  const document::Drawing* drawing = document::drawingOn(env.document, env.ui.picture);
  app::DrawLineIntent intent{env.ui.picture, {}, {}, false, {}};
  if (hidden_) intent.hidden = {{0, 1}};
  document::Drawing left;
  if (drawing != nullptr) {
    intent.replaces = app::drawnOver(env.document, *drawing, {{}, line_, intent.hidden, false}, reach_);
    left = *drawing;
    std::erase_if(left.lines, [&](const auto& line) { return std::ranges::count(intent.replaces, line.id) > 0; });
  }
  app::MeantLine meant = app::meantLine(drawing != nullptr ? &left : nullptr, line_, reach_);
  intent.points = std::move(meant.points);
  intent.closed = meant.closed;
  env.sink.run(app::drawLine, intent);
}

void LineTool::cancel(const ToolEnv& env) { env.ui.inHand = {}; }

}  // namespace spineloft::tools
