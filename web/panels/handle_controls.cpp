// Handles that a pointer drags in the views, for those who use none: points of an outline, and the depth of a spine.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "web/commands/intents.h"
#include "web/edit/editing.h"
#include "web/edit/placing.h"
#include "web/edit/region_editing.h"
#include "web/panels/draw_lines.h"
#include "web/panels/number_text.h"
#include "web/panels/panels.h"
#include "web/panels/point_control.h"
#include "web/words/words.h"

namespace spineloft::panels {
namespace {

/// Where the points of the outline in hand are in the picture, in percent of its sides.
void outlinePoints(const PanelEnv& env) {
  const document::Part* part = app::partWithPoints(env.document(), env.ui());
  const document::Region* region = part ? document::regionOf(part->recipe) : nullptr;
  const document::PictureEntry* entry =
      region ? document::findPicture(env.document(), document::pictureOf(*part)) : nullptr;
  if (entry == nullptr || env.ui().preview) return;
  const std::vector<app::OutlinePoint> handles = app::outlineHandles(*region);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const PicturePoint p = app::pointOf(*region, handles[i]);
    const auto number = [&](bool across, const char* sentence) {
      const double side = across ? entry->size.width : entry->size.height;
      const double share = 100 * (across ? p.x : p.y) / side;
      const PointControl what{std::to_string(i) + (across ? "x" : "y"),
                              words::tr(sentence, {{"n", i + 1}, {"all", handles.size()}}), onCanvas(env.ui(), p)};
      const auto asked = pointSlider(env, what, {0, 100, share, numberText("{n} %", share, 1)});
      return asked ? std::optional(*asked * side / 100) : std::nullopt;
    };
    const auto x = number(true, "Point {n} of {all} of the outline: from the left");
    const auto y = number(false, "Point {n} of {all} of the outline: from above");
    if (x || y)
      env.sink.run(app::moveOutlinePoint, part->id, handles[i], PicturePoint{x.value_or(p.x), y.value_or(p.y)});
  }
}

/// The depth at the handles of the spine in hand, in millimetres of the model.
void depths(const PanelEnv& env) {
  const app::Subject subject = app::subjectOf(env.document(), env.derived, env.ui().selection);
  if (env.ui().tool != app::ToolKind::Spine || !subject || !subject.part->visible || env.ui().preview) return;
  const document::PictureEntry* entry = document::findPicture(env.document(), document::pictureOf(*subject.part));
  if (entry == nullptr) return;
  const double side = std::max(entry->size.width, entry->size.height);
  const double mm = app::mmPerUnit(env.document(), env.derived) / side;  // a pixel of the picture
  if (!(mm > 0)) return;
  const pipeline::ToWorld toWorld = *app::shownCopies(env.ui(), *subject.part, entry->size).begin();
  const std::vector<ModelPoint> handles = app::depthHandles(subject);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const auto at = app::pointOnCanvas(env.ui().camera, env.ui().layout.solid, toWorld(handles[i]));
    const geometry::AlongCurve& depth = document::loftIn(*subject.part).pose.depth;
    const double place = app::handlePlace(static_cast<int>(i)), now = geometry::valueAt(depth, place, 0);
    const PointControl what{"depth" + std::to_string(i),
                            words::tr("Depth of the bone, {n} of {all}", {{"n", i + 1}, {"all", handles.size()}}),
                            at ? ImVec2{static_cast<float>(at->x), static_cast<float>(at->y)} : ImVec2{}};
    const auto asked =
        pointSlider(env, what, {-side * mm / 2, side * mm / 2, now * mm, numberText("{n} mm", now * mm, 1)});
    if (!asked) continue;
    env.sink.run(app::setDepth, subject.part->id,
                 app::raiseDepth(depth, place, *asked / mm - now, env.ui().edit.spineReach));
  }
}

}  // namespace

void tellHandles(const PanelEnv& env) {
  ImGui::PushID("handles");
  outlinePoints(env);
  depths(env);
  ImGui::PopID();
}

}  // namespace spineloft::panels
