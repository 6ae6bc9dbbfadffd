#include "web/panels/theme.h"

namespace spineloft::panels {

ImU32 toolColour(app::ToolKind tool) {
  switch (tool) {
    case app::ToolKind::Ribs:
      return rgb(0x0b7f6a);
    case app::ToolKind::Shape:
      return rgb(0xb01f72);
    case app::ToolKind::Spine:
      return kSpine;
    case app::ToolKind::Inflate:
    case app::ToolKind::Extrude:
    case app::ToolKind::Spin:
    case app::ToolKind::Layers:
    case app::ToolKind::Primitive:
    case app::ToolKind::Lines:
      return rgb(0x8a4bc9);
    case app::ToolKind::Ignore:
      return rgb(0x6d5a38);
    case app::ToolKind::Pull:
    case app::ToolKind::Bridge:
      return rgb(0xb01f72);
    case app::ToolKind::Place:
      return rgb(0x5b3fb5);
    default:
      return kAccent;
  }
}

void applyTheme(const platform::Palette& palette) {
  detail::inUse = palette;
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  ImGui::StyleColorsLight(&style);
  style.WindowRounding = kRadius;
  style.ChildRounding = style.FrameRounding = style.PopupRounding = kRadius;
  style.ScrollbarRounding = 4;
  style.GrabRounding = kRadius - 2;
  style.GrabMinSize = 16;
  style.ScrollbarSize = 10;
  style.WindowBorderSize = 0;
  style.ChildBorderSize = 0;
  style.PopupBorderSize = 1;
  style.FrameBorderSize = tellsByFrames() ? 1 : 0;
  style.WindowPadding = {12, 10};
  style.FramePadding = {10, 8};
  style.ItemSpacing = {6, 6};
  style.AntiAliasedLinesUseTex = true;
  style.CircleTessellationMaxError = 0.2f;
  const auto set = [&](ImGuiCol slot, ImU32 colour) { style.Colors[slot] = ImGui::ColorConvertU32ToFloat4(colour); };
  set(ImGuiCol_Text, kInk);
  set(ImGuiCol_TextDisabled, kMuted);
  set(ImGuiCol_WindowBg, kSurface);
  set(ImGuiCol_ChildBg, rgb(0xffffff, 0));
  set(ImGuiCol_PopupBg, kBubble);
  set(ImGuiCol_Border, kLine);
  set(ImGuiCol_ScrollbarBg, rgb(0xffffff, 0));
  set(ImGuiCol_ScrollbarGrab, faded(kHandle, 150));
  set(ImGuiCol_ScrollbarGrabHovered, kHandle);
  set(ImGuiCol_ScrollbarGrabActive, kMuted);
  set(ImGuiCol_PlotHistogram, kAccent);
  // Sliders: a quiet trough, and a grip light enough for the number that is written over it.
  set(ImGuiCol_FrameBg, kTrough);
  set(ImGuiCol_FrameBgHovered, kHover);
  set(ImGuiCol_FrameBgActive, kHover);
  set(ImGuiCol_SliderGrab, faded(kAccent, 105));
  set(ImGuiCol_SliderGrabActive, faded(kAccent, 150));
}

}  // namespace spineloft::panels
