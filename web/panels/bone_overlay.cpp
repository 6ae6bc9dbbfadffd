// The bones of a puff over the picture: lines, ends, knobs for its thickness, places of slices, and what is left out.
#include <imgui.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/geometry/polyline.h"
#include "web/edit/placing.h"
#include "web/edit/puff_bones.h"
#include "web/panels/draw_lines.h"
#include "web/panels/number_text.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

ImVec2 toVec(app::ClientPoint p) { return {static_cast<float>(p.x), static_cast<float>(p.y)}; }

void drawBone(ImDrawList& list, const app::UiState& ui, const app::BoneHandle& bone, bool hot) {
  const bool gone = bone.hold == app::BoneHold::Gone;
  if (gone) {
    picturePolyline(list, ui, bone.line, {faded(kHalo, hot ? 255 : 190), 5.f});
    picturePolyline(list, ui, bone.line, {hot ? kSpine : kMuted, 2.4f, LineStyle::Dotted});
    return;
  }
  picturePolyline(list, ui, bone.line, {hot ? kGlow : faded(kHalo, 235), hot ? 9.f : 6.5f});
  picturePolyline(list, ui, bone.line, {kSpine, 3.2f});
}

void drawNode(ImDrawList& list, ImVec2 at, bool hot, bool chosen) {
  const ImU32 colour = chosen ? kDark : kSpine;
  list.AddCircleFilled(at, hot ? 9.f : 7.5f, kHalo, 24);
  list.AddCircleFilled(at, hot ? 7.f : 5.5f, colour, 24);
  list.AddCircleFilled(at, 2.2f, kHalo, 12);
}

/// A pin that stands on its bone, with arrows and its thickness while it is in reach.
void drawKnob(ImDrawList& list, const PanelEnv& env, const app::BoneHandle& knob, bool hot, bool chosen) {
  const ImVec2 foot = onCanvas(env.ui(), knob.at), head = toVec(app::holdOnCanvas(knob, env.ui()));
  const ImU32 colour = chosen ? kDark : kEditedRib;
  list.AddLine(foot, head, faded(kHalo, 235), 5.f);
  list.AddLine(foot, head, colour, 2.f);
  const float r = hot ? 7.5f : 6.f;
  for (const auto& [more, ink] : {std::pair{2.f, kHalo}, {0.f, colour}}) {
    list.AddNgonFilled(head, r + more, ink, 4);
  }
  if (!hot && !chosen) return;
  for (const float way : {-1.f, 1.f}) {
    const ImVec2 tip{head.x, head.y + way * 20};
    list.AddTriangleFilled(tip, {tip.x - 5, tip.y - way * 6}, {tip.x + 5, tip.y - way * 6}, colour);
  }
  const std::string text = numberText("{n} %", 100 * knob.factor, 0);
  const ImVec2 size = extentOf(env.fonts.small, text), at{head.x + 14, head.y - size.y / 2};
  list.AddRectFilled({at.x - 5, at.y - 2}, {at.x + size.x + 5, at.y + size.y + 2}, faded(kHalo, 235), 6);
  drawLine(list, {env.fonts.small, at, kDark}, text);
}

void drawSquare(ImDrawList& list, ImVec2 at, ImU32 colour, bool hot) {
  const float r = hot ? 8.f : 6.5f;
  list.AddRectFilled({at.x - r - 2, at.y - r - 2}, {at.x + r + 2, at.y + r + 2}, kHalo, 4);
  list.AddRectFilled({at.x - r, at.y - r}, {at.x + r, at.y + r}, colour, 3);
}

/// A thin line across the puff, held at its end.
void drawSlice(ImDrawList& list, const app::UiState& ui, const app::BoneHandle& slice, bool hot, bool chosen) {
  const ImVec2 head = toVec(app::holdOnCanvas(slice, ui));
  const ImVec2 other = onCanvas(ui, slice.at - slice.across * slice.half);
  const ImU32 colour = chosen ? kDark : kGuessedRib;
  styledLine(list, other, head, {faded(kHalo, 235), 5.f, LineStyle::Solid});
  styledLine(list, other, head, {colour, 2.f, LineStyle::Solid});
  drawSquare(list, head, colour, hot);
}

/// Edits that find no place in this outline are kept, and shown pale.
void drawAsleep(ImDrawList& list, const app::UiState& ui, const app::BonedPuff& puff) {
  const auto sleeps = [&](auto kind, std::size_t i) { return !inflate::isAwake(puff.shape->bones, kind, i); };
  const auto dot = [&](PicturePoint at) { list.AddCircle(onCanvas(ui, at), 4.f, kMuted, 12, 1.4f); };
  const inflate::BoneEdits& edits = puff.params->bones;
  using inflate::AwakeEdits;
  for (std::size_t i = 0; i < edits.add.size(); ++i) {
    if (sleeps(&AwakeEdits::add, i)) picturePolyline(list, ui, edits.add[i], {kMuted, 1.6f, LineStyle::Dotted});
  }
  for (std::size_t i = 0; i < edits.drop.size(); ++i) {
    if (sleeps(&AwakeEdits::drop, i)) dot(edits.drop[i]);
  }
  for (std::size_t i = 0; i < edits.move.size(); ++i) {
    if (sleeps(&AwakeEdits::move, i)) dot(edits.move[i].to);
  }
  for (std::size_t i = 0; i < edits.heights.size(); ++i) {
    if (sleeps(&AwakeEdits::heights, i)) dot(edits.heights[i].at);
  }
}

}  // namespace

void drawBones(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const app::BonedPuff puff = app::bonesShown(app::bonesInHand(env.document(), env.derived, ui), ui);
  if (!puff) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const std::vector<app::BoneHandle> handles = app::boneHandles(puff);
  drawAsleep(list, ui, puff);
  const auto is = [](int at, std::size_t i) { return at == static_cast<int>(i); };
  for (std::size_t i = handles.size(); i-- > 0;) {  // points over lines
    const app::BoneHandle& handle = handles[i];
    const bool chosen = is(ui.chosen.bone, i), hot = is(ui.hover.bone, i) || chosen;
    switch (handle.hold) {
      case app::BoneHold::Gone:
      case app::BoneHold::Bone:
        drawBone(list, ui, handle, hot);
        break;
      case app::BoneHold::Node:
        drawNode(list, onCanvas(ui, handle.at), hot, chosen);
        break;
      case app::BoneHold::Knob:
        drawKnob(list, env, handle, hot, chosen);
        break;
      case app::BoneHold::Slice:
        drawSlice(list, ui, handle, hot, chosen);
        break;
    }
  }
}

void drawSlicesInSolid(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const app::BonedPuff puff = app::bonesShown(app::bonesInHand(env.document(), env.derived, ui), ui);
  if (!puff || !puff.part->visible) return;
  const app::Rect& view = ui.layout.solid;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const pipeline::ToWorld toWorld = *app::shownCopies(ui, *puff.part, puff.picture).begin();
  const std::vector<app::BoneHandle> handles = app::boneHandles(puff);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    if (handles[i].hold != app::BoneHold::Slice) continue;
    const int number = static_cast<int>(i);
    const bool chosen = number == ui.chosen.bone, hot = chosen || number == ui.hover.bone;
    const ImU32 colour = chosen ? kDark : kGuessedRib;
    for (const auto& line : app::sliceLines(puff, handles[i])) {
      for (const auto& [ink, width] : {std::pair{faded(kHalo, 200), 4.5f}, {colour, 1.8f}}) {
        list.PathClear();
        for (const ModelPoint& p : line) {
          if (const auto at = app::pointOnCanvas(ui.camera, view, toWorld(p))) list.PathLineTo(toVec(*at));
        }
        list.PathStroke(ink, 0, width);
      }
    }
    if (const auto hold = app::holdInSolid(puff, handles[i], ui)) drawSquare(list, toVec(*hold), colour, hot);
  }
  list.PopClipRect();
}

}  // namespace spineloft::panels
