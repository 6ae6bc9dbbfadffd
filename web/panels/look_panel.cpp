// The surface (picture or colour) and the size of the finished model.
#include <imgui.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "web/app/command_actions.h"
#include "web/app/swatches.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

unsigned hexOf(const std::array<std::uint8_t, 3>& colour) {
  return (unsigned{colour[0]} << 16) | (unsigned{colour[1]} << 8) | colour[2];
}

/// Two halves of one pill.
void pictureOrColour(const PanelEnv& env, bool textured, float width) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = env.ui().touch ? 44.f : 36.f;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + width, at.y + height}, rgb(0xf1eee7), kRadius);
  const struct {
    const char* id;
    const char* text;
    bool on;
  } halves[] = {{"picture", "Picture", textured}, {"colour", "Colour", !textured}};
  for (int i = 0; i < 2; ++i) {
    if (i > 0) ImGui::SameLine(0, 0);
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(halves[i].id, {width / 2, height});
    if (halves[i].on) {
      list.AddRectFilled({corner.x + 3, corner.y + 3},
                         {corner.x + width / 2 - 3, corner.y + height - 3}, kSurface, kRadius - 2);
      list.AddRect({corner.x + 3, corner.y + 3}, {corner.x + width / 2 - 3, corner.y + height - 3},
                   kLine, kRadius - 2);
    }
    ImGui::PushFont(halves[i].on ? env.fonts.bold : env.fonts.text);
    const ImVec2 extent = ImGui::CalcTextSize(halves[i].text);
    list.AddText({corner.x + (width / 2 - extent.x) / 2, corner.y + (height - extent.y) / 2},
                 halves[i].on ? kAccent : kMuted, halves[i].text);
    ImGui::PopFont();
    if (pressed && !halves[i].on) {
      env.sink.run("toggle-texture", app::Json::Object{{"textured", i == 0}});
    }
  }
}

void swatches(const PanelEnv& env, const document::Look& look, float width) {
  const int columns = env.ui().layout.strip ? 10 : 5;
  const float gap = 6;
  const float side = std::floor(std::min(
      (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns), 40.f));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  for (std::size_t i = 0; i < app::kSwatches.size(); ++i) {
    const app::Swatch& swatch = app::kSwatches[i];
    if (i % static_cast<std::size_t>(columns) != 0) ImGui::SameLine();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::InvisibleButton(swatch.value.data(), {side, side});
    const ImVec2 centre{at.x + side / 2, at.y + side / 2};
    const float radius = side / 2 - 3;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddCircleFilled(centre, radius, rgb(swatch.hex), 32);
    list.AddCircle(centre, radius, rgb(0x1f2430, 40), 32, 1);
    if (!look.textured && hexOf(look.colour) == swatch.hex) {
      list.AddCircle(centre, radius + 2.5f, kAccent, 36, 2);
    } else if (ImGui::IsItemHovered()) {
      list.AddCircle(centre, radius + 2.5f, kLine, 36, 2);
    }
    if (pressed) env.sink.run("set-colour", app::Json::Object{{"colour", swatch.value}});
  }
  ImGui::PopStyleVar();
}

/// Nearest of 1, 2, 5, 10, 20, 50 … above or below.
double nextHeight(double mm, int direction) {
  const double steps[] = {1, 2, 5, 10, 20, 30, 50, 80, 100, 120, 150, 200, 300, 500, 1000, 2000};
  if (direction > 0) {
    for (const double step : steps) {
      if (step > mm + 1e-9) return step;
    }
    return mm;
  }
  double best = mm;
  for (const double step : steps) {
    if (step < mm - 1e-9) best = step;
  }
  return best;
}

void howTall(const PanelEnv& env, float width) {
  const double mm = env.document().height.value;
  const bool can = !env.document().parts.empty();
  const float side = buttonSide(env);
  const auto step = [&](int direction) {
    env.sink.run("set-height", app::Json::Object{{"mm", nextHeight(mm, direction)}});
  };
  if (iconButton(env, {"lower", "minus", "Smaller", false, can, side})) step(-1);
  ImGui::SameLine(0, 4);
  char text[32];
  std::snprintf(text, sizeof text, "%g mm", mm);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float middle = std::max(60.f, width - 2 * side - 8);
  ImGui::BeginDisabled(!can);
  const bool asked = ImGui::InvisibleButton("type", {middle, side});
  ImGui::EndDisabled();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(at, {at.x + middle, at.y + side}, rgb(0xfaf9f6), 8);
  list.AddRect(at, {at.x + middle, at.y + side}, ImGui::IsItemHovered() ? kMuted : kLine, 8);
  const ImVec2 extent = ImGui::CalcTextSize(text);
  list.AddText({at.x + (middle - extent.x) / 2, at.y + (side - extent.y) / 2},
               can ? kInk : rgb(0x5c6474, 140), text);
  if (asked) env.sink.run("set-height");
  ImGui::SameLine(0, 4);
  if (iconButton(env, {"higher", "plus", "Taller", false, can, side})) step(+1);
}

}  // namespace

void lookPanel(const PanelEnv& env, float width) {
  const document::Look look = app::currentLook(env.env);
  if (env.ui().layout.strip && width >= 640) {
    ImGui::BeginGroup();
    pictureOrColour(env, look.textured, 220);
    ImGui::EndGroup();
    ImGui::SameLine(0, 24);
    ImGui::BeginGroup();
    label(env.fonts.small, kMuted, "How tall?");
    howTall(env, 220);
    ImGui::EndGroup();
    swatches(env, look, width);
    return;
  }
  if (env.ui().layout.strip) {
    pictureOrColour(env, look.textured, width * 0.48f);
    ImGui::SameLine(0, width * 0.04f);
    howTall(env, width * 0.48f);
    swatches(env, look, width);
    return;
  }
  pictureOrColour(env, look.textured, width);
  ImGui::Dummy({0, 2});
  swatches(env, look, width);
  heading(env, "How tall?");
  howTall(env, width);
}

}  // namespace spineloft::panels
