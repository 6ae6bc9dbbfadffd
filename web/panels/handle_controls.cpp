// Handles that a pointer drags in the views, for those who use none: points of an outline, the depth of a spine, the
// bones of a puff, a shape; crossings and rings of line drawings.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "web/commands/intents.h"
#include "web/edit/depth_dots.h"
#include "web/edit/editing.h"
#include "web/edit/line_drawing.h"
#include "web/edit/placing.h"
#include "web/edit/puff_bones.h"
#include "web/edit/pulling.h"
#include "web/edit/region_editing.h"
#include "web/edit/shaping.h"
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

/// The depth at the dots of a piece of a line drawing, in millimetres of the model.
void dots(const PanelEnv& env) {
  const document::Part* part = document::findPart(env.document(), env.ui().selection);
  const document::PictureEntry* entry =
      part ? document::findPicture(env.document(), document::pictureOf(*part)) : nullptr;
  if (entry == nullptr) return;
  const double side = std::max(entry->size.width, entry->size.height);
  const double mm = app::mmPerUnit(env.document(), env.derived) / side;  // a pixel of the picture
  const std::vector<app::DepthDot> all = app::depthDots(env.document(), env.derived, env.ui());
  for (std::size_t i = 0; i < all.size() && mm > 0; ++i) {
    const app::DepthDot& dot = all[i];
    const PointControl what{"dot" + std::to_string(i),
                            words::tr("Depth of {name}, {n} of {all}",
                                      {{"name", words::nameOf(part->name)}, {"n", i + 1}, {"all", all.size()}}),
                            ImVec2{static_cast<float>(dot.seen.x), static_cast<float>(dot.seen.y)}};
    const double now = dot.where.z * mm;
    const auto asked = pointSlider(env, what, {-side * mm, side * mm, now, numberText("{n} mm", now, 1)});
    if (asked) env.sink.run(app::pinDepth, document::PinDepth{dot.drawing, dot.line, dot.at, *asked / mm});
  }
}

/// The height of every pull of the part in hand, in millimetres of the model.
void pulls(const PanelEnv& env) {
  const app::PulledPart part = app::pulledPart(env.document(), env.derived, env.ui());
  const document::PictureEntry* entry =
      part ? document::findPicture(env.document(), document::pictureOf(*part.part)) : nullptr;
  if (entry == nullptr || env.ui().preview) return;
  const double side = std::max(entry->size.width, entry->size.height);
  const double mm = app::mmPerUnit(env.document(), env.derived) * part.toWorld().scale;  // a pixel of the picture
  for (std::size_t i = 0; i < part.pulls.size() && mm > 0; ++i) {
    const auto knob = app::pullKnob(part, env.ui(), i);
    const PointControl what{"pull" + std::to_string(i),
                            words::tr("Height of pull {n} of {all}", {{"n", i + 1}, {"all", part.pulls.size()}}),
                            knob ? ImVec2{static_cast<float>(knob->at.x), static_cast<float>(knob->at.y)} : ImVec2{}};
    const pipeline::PulledLine& line = part.shape->pulled[i];
    const double now = app::heightOf(part.pulls[i], line) * mm;
    const double most = std::max(side * mm / 2, std::abs(now));
    const auto asked = pointSlider(env, what, {-most, most, now, numberText("{n} mm", now, 1)});
    if (!asked) continue;
    const pull::Pull changed = app::raised(part.pulls[i], line, (*asked - now) / mm);
    env.sink.run(app::setPull, part.part->id, i, changed);
  }
}

/// A handle that goes to places of the picture, in percent of its sides.
void placeOfHandle(const PanelEnv& env, const app::BonedPuff& puff, const app::BoneHandle& handle,
                   const std::string& id, int number) {
  const document::PictureEntry* entry = document::findPicture(env.document(), document::pictureOf(*puff.part));
  if (entry == nullptr) return;
  const bool slice = handle.hold == app::BoneHold::Slice;
  for (const bool across : {true, false}) {
    const double side = across ? entry->size.width : entry->size.height;
    const double share = 100 * (across ? handle.at.x : handle.at.y) / side;
    const char* sentence = slice
                               ? (across ? "Slice {n} of the puff: from the left" : "Slice {n} of the puff: from above")
                               : (across ? "End {n} of the bones: from the left" : "End {n} of the bones: from above");
    const PointControl what{id + (across ? "x" : "y"), words::tr(sentence, {{"n", number}}),
                            onCanvas(env.ui(), handle.at)};
    const auto asked = pointSlider(env, what, {0, 100, share, numberText("{n} %", share, 1)});
    if (!asked) continue;
    PicturePoint to = handle.at;
    (across ? to.x : to.y) = *asked * side / 100;
    env.sink.run(app::dragBone, puff.part->id, handle, to);
  }
}

/// The bones of the puff in hand: places of their ends, thickness at the knobs, and what a tap does to a bone.
void bones(const PanelEnv& env) {
  const app::BonedPuff puff = app::bonesInHand(env.document(), env.derived, env.ui());
  if (!puff || env.ui().preview) return;
  const std::vector<app::BoneHandle> handles = app::boneHandles(puff);
  int numbers[5] = {};
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const app::BoneHandle& handle = handles[i];
    const std::string id = "bone" + std::to_string(i);
    const int number = ++numbers[static_cast<std::size_t>(handle.hold)];
    const app::ClientPoint at = app::holdOnCanvas(handle, env.ui());
    const ImVec2 where{static_cast<float>(at.x), static_cast<float>(at.y)};
    if (handle.hold == app::BoneHold::Knob) {
      const double now = 100 * handle.factor;
      const PointControl what{id, words::tr("Thickness at knob {n} of the bones", {{"n", number}}), where};
      const auto asked = pointSlider(
          env, what, {100 * inflate::kLeastFactor, 100 * inflate::kMostFactor, now, numberText("{n} %", now, 0)});
      if (asked) env.sink.run(app::setThickness, puff.part->id, handle, *asked / 100);
    } else if (handle.line.empty()) {
      placeOfHandle(env, puff, handle, id, number);
    } else {
      const bool gone = handle.hold == app::BoneHold::Gone;
      const PointControl what{id, words::tr(gone ? "Take bone {n} back" : "Leave bone {n} out", {{"n", number}}),
                              where};
      if (pointButton(env, what)) env.sink.run(app::toggleBone, puff.part->id, static_cast<int>(i));
    }
  }
}

/// What a number of a handle of a shape says.
const char* shapeWords(app::ShapeHold hold, bool across) {
  switch (hold) {
    case app::ShapeHold::From:
      return across ? "Begin of the shape: from the left" : "Begin of the shape: from above";
    case app::ShapeHold::To:
      return across ? "End of the shape: from the left" : "End of the shape: from above";
    case app::ShapeHold::Middle:
      return across ? "Middle of the shape: from the left" : "Middle of the shape: from above";
    case app::ShapeHold::Width:
      return across ? "Width of the shape: from the left" : "Width of the shape: from above";
    case app::ShapeHold::Depth:
      break;
  }
  return across ? "Depth of the shape: from the left" : "Depth of the shape: from above";
}

/// The shape in hand: where its handles are in the picture in view, in percent of its sides. Width and depth are
/// measured one way only.
void shapes(const PanelEnv& env) {
  const auto seen = app::shapeInHand(env.document(), env.ui());
  const document::PictureEntry* entry = seen ? document::findPicture(env.document(), seen->picture) : nullptr;
  if (entry == nullptr || env.ui().preview) return;
  const PicturePoint way = seen->recipe.shape.axis.to - seen->recipe.shape.axis.from;
  const bool upright = std::abs(way.y) >= std::abs(way.x);
  for (const app::ShapeHandle& handle : app::shapeHandles(*seen)) {
    for (const bool across : {true, false}) {
      const bool depth = handle.hold == app::ShapeHold::Depth;
      if ((depth || handle.hold == app::ShapeHold::Width) && across != upright) continue;
      const double side = across ? entry->size.width : entry->size.height;
      const double share = 100 * (across ? handle.at.x : handle.at.y) / side;
      const PointControl what{"shape" + std::string(app::holdKey(handle.hold)) + (across ? "x" : "y"),
                              words::tr(shapeWords(handle.hold, across)),
                              onCanvas(env.ui(), app::heldAt(handle, env.ui().pictureView.zoom))};
      const auto asked = pointSlider(env, what, {0, 100, share, numberText("{n} %", share, 1)});
      if (!asked) continue;
      PicturePoint to = handle.at;
      (across ? to.x : to.y) = *asked * side / 100;
      env.sink.run(app::dragShape, seen->part->id, handle.hold, to);
    }
  }
}

/// Crossings of line drawings and rings at lines that are not closed.
void lines(const PanelEnv& env) {
  const app::LineMarks marks = app::lineMarks(env.document(), env.derived, env.ui());
  const auto where = [](app::ClientPoint at) { return ImVec2{static_cast<float>(at.x), static_cast<float>(at.y)}; };
  if (!marks.crossings.empty()) {
    const std::vector<app::Crossing> crossings = app::crossingsOn(env.document(), env.derived, env.ui().picture);
    for (std::size_t i = 0; i < std::min(crossings.size(), marks.crossings.size()); ++i) {
      const std::string now = app::crossingSentence(env.document(), crossings[i]);
      const PointControl what{"bridge" + std::to_string(i), words::tr("{what} Swap them here.", {{"what", now}}),
                              where(marks.crossings[i])};
      if (pointButton(env, what)) env.sink.run(app::swapCrossing, static_cast<int>(i));
    }
  }
  if (marks.looseEnds.empty()) return;
  const std::vector<app::LooseEnd> ends = app::looseEndsOn(env.document(), env.derived, env.ui().picture);
  for (std::size_t i = 0; i < std::min(ends.size(), marks.looseEnds.size()); ++i) {
    const PointControl what{"end" + std::to_string(i), words::tr("A line is not closed here. Close it."),
                            where(marks.looseEnds[i])};
    if (pointButton(env, what)) env.sink.run(app::closeLine, ends[i].drawing, ends[i].line, ends[i].at);
  }
}

}  // namespace

void tellHandles(const PanelEnv& env) {
  ImGui::PushID("handles");
  outlinePoints(env);
  depths(env);
  bones(env);
  shapes(env);
  lines(env);
  dots(env);
  pulls(env);
  ImGui::PopID();
}

}  // namespace spineloft::panels
