// The sections along the spine of a part: a bar that shows and picks them, and how one becomes the
// next.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "web/commands/intents.h"
#include "web/edit/preview.h"
#include "web/edit/section_editing.h"
#include "web/panels/curve_graph.h"
#include "web/panels/point_control.h"
#include "web/panels/section_paint.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

using SectionKeys = std::vector<loft::SectionKey>;

/// The spine as a line with the sections on it; a press picks one.
void bar(const PanelEnv& env, const SectionKeys& keys, std::size_t picked, float width) {
  const float height = env.ui().touch ? 50.f : 42.f, r = height / 2 - 3;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float left = at.x + r + 2, right = at.x + width - r - 2, y = at.y + height / 2;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddLine({left, y}, {right, y}, kSpine, 3);
  list.AddCircleFilled({left, y}, 4, kSpine, 16);
  if (const auto& marked = env.ui().sections.marked) {
    const float x = left + (right - left) * static_cast<float>(*marked);
    list.AddLine({x, at.y}, {x, at.y + height}, kGlow, 3);
  }
  for (std::size_t pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if ((i == picked) != (pass == 1)) continue;  // the picked one lies on top
      const ImVec2 c{left + (right - left) * static_cast<float>(keys[i].at), y};
      ImGui::SetCursorScreenPos({c.x - r, c.y - r});
      ImGui::PushID(static_cast<int>(i));
      if (ImGui::InvisibleButton("key", {2 * r, 2 * r})) {
        env.sink.run(app::selectSection, env.ui().selection, i);
      }
      const words::Args number = {{"n", i + 1}};
      registerControl(env, app::Control::Kind::Button, words::tr("Slice {n}", number), true, i == picked);
      const double share = std::round(100 * keys[i].at);
      const auto to = pointSlider(env, {"place", words::tr("Slice {n}: place", number), c},
                                  {0, 100, 100 * keys[i].at, std::string(words::tr("{n} %", {{"n", share}}))});
      if (to) env.sink.run(app::moveSection, env.ui().selection, i, *to / 100);
      ImGui::PopID();
      const bool on = i == picked;
      list.AddCircleFilled(c, r, on ? kAccentSoft : kSurface, 32);
      list.AddCircle(c, r, on ? kAccent : kMuted, 32, on ? 2.f : 1.2f);
      paintSection(list, {c, r * 0.56f}, keys[i].shape, {on ? kAccent : kInk, 0, 1.5f});
    }
  }
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy({width, height});
}

void blends(const PanelEnv& env, const SectionKeys& keys, std::size_t picked, float width) {
  const bool strip = env.ui().layout.strip;
  const int columns = strip ? 6 : 3;
  const float gap = 6, side = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  int index = 0;
  for (const sections::BlendName& name : sections::blendNames()) {
    if (index++ % columns != 0) ImGui::SameLine(0, gap);
    const std::string id = "blend-" + std::string(name.key);
    const bool on = keys[picked].blend.kind == name.kind;
    const auto paint = [&](ImDrawList& list, ImVec2 c, float radius, ImU32 ink) {
      sections::Blend blend = keys[picked].blend;
      if (blend.kind != name.kind) blend = {name.kind, {{{0, 0}, {0.35, 0.7}, {0.65, 0.3}, {1, 1}}}};
      constexpr int kSteps = 20;
      for (int i = 0; i <= kSteps; ++i) {
        const double t = static_cast<double>(i) / kSteps;
        list.PathLineTo({c.x + radius * static_cast<float>(2 * t - 1),
                         c.y - radius * 0.8f * static_cast<float>(2 * sections::blendAt(blend, t) - 1)});
      }
      list.PathStroke(ink, 0, 1.8f);
    };
    if (tile(env,
             {id.c_str(),
              strip ? std::string_view() : name.label,
              name.label,
              {std::floor(side), strip ? 44.f : 50.f},
              on},
             paint)) {
      env.sink.run(app::setBlend, env.ui().selection, picked, app::blendOf(name.kind, keys[picked].blend));
    }
  }
}

}  // namespace

void slicesToCopy(const PanelEnv& env, float width) {
  constexpr float kApart = 6;
  const bool canPaste = env.ui().sections.copied.has_value();
  const float each = canPaste ? std::floor((width - kApart) / 2) : width;
  commandText(env, {"copy-slices", each});
  if (!canPaste) return;
  ImGui::SameLine(0, kApart);
  commandText(env, {"paste-slices", each});
}

void sectionKeyBar(const PanelEnv& env, float width) {
  const document::Part& part = *env.selected();
  const app::Preview* preview = app::previewOf(env.ui(), part.id);
  const SectionKeys& keys = preview ? preview->loft().loft.sections : document::loftIn(part).loft.sections;
  const std::size_t picked = std::min(app::pickedSectionKey(env.ui(), part), keys.size() - 1);
  const float side = buttonSide(env);
  ImGui::Dummy({0, 2});
  label(env.fonts.small, kMuted, keys.size() > 1 ? "Slices along the bone" : "One slice all along the bone");
  if (keys.size() > 1) bar(env, keys, picked, width);
  commandText(env, {"add-slice"});
  if (keys.size() > 1) {
    ImGui::SameLine(0, 4);
    commandButton(env, "remove-slice", side);
    ImGui::SameLine(0, 0);
    commandButton(env, "next-slice", side);
  }
  slicesToCopy(env, width);
  if (keys.size() < 2) return;
  if (picked + 1 >= keys.size()) return;
  label(env.fonts.small, kMuted, "Change to the next one");
  blends(env, keys, picked, width);
  const sections::Blend& blend = keys[picked].blend;
  if (blend.kind != sections::BlendKind::Custom) return;
  const geometry::AlongCurve& curve = env.ui().sections.graph ? *env.ui().sections.graph : blend.custom;
  CurveGraph graph{.kind = app::GraphArea::Kind::Blend, .low = -0.5, .high = 1.5};
  graph.size = {width, 96};
  graph.name = words::tr("Change to the next one");
  if (const auto asked = curveGraph(env, graph, curve)) {
    loft::LoftParams params = document::loftIn(part).loft;
    const sections::Blend bent{sections::BlendKind::Custom, *asked};
    params.sections[picked].blend = bent;
    if (!holdsBack(env, part, std::move(params))) env.sink.run(app::setBlend, part.id, picked, bent);
  }
}

}  // namespace spineloft::panels
