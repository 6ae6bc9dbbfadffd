#include "web/panels/point_control.h"

#include <imgui_internal.h>

#include <algorithm>
#include <utility>

namespace spineloft::panels {
namespace {

/// Tells it; what was asked of it, once.
std::optional<app::AskedControl> pointControl(const PanelEnv& env, const PointControl& what, app::Control control) {
  constexpr double kSide = 24;
  app::UiState& ui = env.ui();
  control.words = what.words;
  control.at = {what.at.x - kSide / 2, what.at.y - kSide / 2, kSide, kSide};
  control.inSight = false;
  control.id = ImGui::GetID(what.id.c_str());
  const std::uint32_t id = control.id;
  ui.controls.push_back(std::move(control));
  if (ui.wantedInSight == id) {
    ui.wantedInSight = 0;
    const ImGuiWindow& window = *ImGui::GetCurrentWindow();
    if (!window.ClipRect.Contains(what.at)) ImGui::SetScrollFromPosY(what.at.y - window.Pos.y);
  }
  if (!ui.asked || ui.asked->id != id) return std::nullopt;
  return std::exchange(ui.asked, std::nullopt);
}

}  // namespace

std::optional<double> pointSlider(const PanelEnv& env, const PointControl& what, const app::Control::Slide& slide) {
  app::Control control;
  control.kind = app::Control::Kind::Slider;
  control.slide = slide;
  const auto asked = pointControl(env, what, std::move(control));
  if (!asked || !asked->value) return std::nullopt;
  return std::clamp(*asked->value, slide.low, slide.high);
}

bool pointButton(const PanelEnv& env, const PointControl& what) {
  const auto asked = pointControl(env, what, {});
  return asked && !asked->value;
}

}  // namespace spineloft::panels
