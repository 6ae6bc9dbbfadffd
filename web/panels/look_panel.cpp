// The surface: picture or colour, paint, facets.
#include <imgui.h>

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "engine/surface/finish.h"
#include "web/commands/command_actions.h"
#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/model/swatches.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

unsigned hexOf(const std::array<std::uint8_t, 3>& colour) {
  return (unsigned{colour[0]} << 16) | (unsigned{colour[1]} << 8) | colour[2];
}

void pictureOrColour(const PanelEnv& env, bool textured, float width) {
  const std::array choices = {Choice{"picture", "Picture", textured}, Choice{"colour", "Colour", !textured}};
  if (const auto pressed = pill(env, choices, width)) {
    env.sink.run(app::setTextured, app::selectedParts(env.document(), env.ui()), *pressed == 0);
  }
}

/// A ball as the paint shows it.
void ball(ImDrawList& list, ImVec2 centre, float radius, const document::Look& look) {
  const auto mixed = [&](float light) {
    const auto channel = [&](std::size_t i) {
      const float c = static_cast<float>(look.colour[i]);
      return static_cast<int>(light > 1 ? 255 - (255 - c) * (2 - light) : c * light);
    };
    return IM_COL32(channel(0), channel(1), channel(2), 255);
  };
  const auto spot = [&](float share, float light) {
    const float off = radius * (1 - share) * 0.45f;
    list.AddCircleFilled({centre.x - off, centre.y - off}, radius * share, mixed(light), 28);
  };
  switch (look.paint) {
    case surface::Paint::TwoTone: {
      list.AddCircleFilled(centre, radius, mixed(1), 28);
      const auto& s = look.second;
      list.PathArcTo(centre, radius, 0, 3.14159f, 20);
      list.PathFillConvex(IM_COL32(s[0], s[1], s[2], 255));
      break;
    }
    case surface::Paint::Clay:
      list.AddCircleFilled(centre, radius, mixed(0.72f), 28);
      spot(0.75f, 0.9f);
      spot(0.4f, 1.02f);
      break;
    case surface::Paint::Glaze:
      list.AddCircleFilled(centre, radius, mixed(0.8f), 28);
      spot(0.8f, 1);
      spot(0.22f, 1.85f);
      break;
    case surface::Paint::Metal:
      list.AddCircleFilled(centre, radius, mixed(0.45f), 28);
      spot(0.85f, 0.75f);
      spot(0.55f, 1.25f);
      spot(0.25f, 1.8f);
      break;
    case surface::Paint::Plain:
    case surface::Paint::kCount:
      list.AddCircleFilled(centre, radius, mixed(1), 28);
  }
  list.AddCircle(centre, radius, faded(kInk, 40), 28, 1);
}

/// A row of paints: what the colour is made of.
void paints(const PanelEnv& env, const document::Look& look, float width) {
  const auto finishes = surface::finishes();
  const auto count = static_cast<float>(finishes.size());
  const float gap = 6, wide = std::floor((width - gap * (count - 1)) / count);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t i = 0; i < finishes.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    document::Look shown = look;
    shown.paint = finishes[i].paint;
    const bool on = !look.textured && look.paint == finishes[i].paint;
    const bool pressed =
        tile(env, {finishes[i].key.data(), finishes[i].label, finishes[i].label, {wide, 58}, on},
             [&](ImDrawList& list, ImVec2 centre, float radius, ImU32) { ball(list, centre, radius * 0.95f, shown); });
    if (pressed) env.sink.run(app::setPaint, app::selectedParts(env.document(), env.ui()), finishes[i].paint);
  }
  ImGui::PopStyleVar();
}

/// Colours to pick from; of the second one when there are two and it is being chosen.
void swatches(const PanelEnv& env, const document::Look& look, float width) {
  const bool twoTone = !look.textured && look.paint == surface::Paint::TwoTone;
  bool& second = env.ui().secondColour;
  if (!twoTone) second = false;
  if (twoTone) {
    const std::array choices = {Choice{"above", "Above", !second}, Choice{"below", "Below", second}};
    if (const auto pressed = pill(env, choices, width)) second = *pressed == 1;
  }
  const std::array<std::uint8_t, 3>& chosen = second ? look.second : look.colour;
  // On a strip one row, or as many of one length as a finger needs.
  const float gap = 6, least = env.ui().touch ? 40.f : 28.f;
  const int count = static_cast<int>(app::kSwatches.size());
  const int fitting = std::max(1, static_cast<int>((width + gap) / (least + gap)));
  const int rows = (count + fitting - 1) / fitting;
  const int columns = env.ui().layout.strip ? (count + rows - 1) / rows : 5;
  const float most = env.ui().touch ? 44.f : 40.f;
  const float side =
      std::floor(std::min((width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns), most));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t i = 0; i < app::kSwatches.size(); ++i) {
    const app::Swatch& swatch = app::kSwatches[i];
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(swatch.value.data(), {side, side});
    registerControl(env, app::Control::Kind::Button, swatch.label, true, !look.textured && hexOf(chosen) == swatch.hex);
    const ImVec2 centre{at.x + side / 2, at.y + side / 2};
    const float radius = side / 2 - 3;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(centre, radius, rgb(swatch.hex), 32);
    list.AddCircle(centre, radius, faded(kInk, 40), 32, 1);
    if (!look.textured && hexOf(chosen) == swatch.hex) {
      list.AddCircle(centre, radius + 2.5f, kAccent, 36, 2);
    } else if (ImGui::IsItemHovered()) {
      list.AddCircle(centre, radius + 2.5f, kLine, 36, 2);
    }
    if (pressed) {
      env.sink.run(second ? app::setSecondColour : app::setColour, app::selectedParts(env.document(), env.ui()),
                   app::rgbOf(swatch));
    }
  }
  ImGui::PopStyleVar();
}

void smoothOrFaceted(const PanelEnv& env, bool faceted, float width) {
  const std::array choices = {Choice{"smooth", "Smooth", !faceted}, Choice{"faceted", "Facets", faceted}};
  if (const auto pressed = pill(env, choices, width)) {
    env.sink.run(app::setFaceted, app::selectedParts(env.document(), env.ui()), *pressed == 1);
  }
}

}  // namespace

void lookPanel(const PanelEnv& env, float width) {
  const document::Look look = app::currentLook(env.env);
  if (env.ui().layout.strip && width >= 640) {
    const float half = std::floor((width - 16) / 2);
    pictureOrColour(env, look.textured, half);
    ImGui::SameLine(0, 16);
    smoothOrFaceted(env, look.faceted, half);
    paints(env, look, std::min(width, 520.f));
    swatches(env, look, width);
    return;
  }
  if (env.ui().layout.strip) {
    pictureOrColour(env, look.textured, width * 0.48f);
    ImGui::SameLine(0, width * 0.04f);
    smoothOrFaceted(env, look.faceted, width * 0.48f);
    swatches(env, look, width);
    paints(env, look, width);
    return;
  }
  pictureOrColour(env, look.textured, width);
  if (app::enabled(app::commandOf("toggle-ink"), env.env)) wordButton(env, {"toggle-ink", width, 34, kAccent});
  ImGui::Dummy({0, 2});
  paints(env, look, width);
  swatches(env, look, width);
  ImGui::Dummy({0, 2});
  smoothOrFaceted(env, look.faceted, width);
}

}  // namespace spineloft::panels
