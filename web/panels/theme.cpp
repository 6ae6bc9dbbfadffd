#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

constexpr Palette kLight = {
    .ink = rgb(0x1f2430),
    .muted = rgb(0x5c6474),
    .paper = rgb(0xf7f5f0),
    .surface = rgb(0xffffff),
    .line = rgb(0xe3dfd6),
    .accent = rgb(0xc8431d),
    .accentSoft = rgb(0xfdeee8),
    .hover = rgb(0xf4f1ea),
    .tile = rgb(0xfaf9f6),
    .trough = rgb(0xf1eee7),
    .handle = rgb(0xb4ad9e),
    .warning = rgb(0xa8500a),
    .good = rgb(0x2f8f5b),
};

constexpr Palette kDarkPalette = {
    .ink = rgb(0xeceef3),
    .muted = rgb(0xaab1c0),
    .paper = rgb(0x17191e),
    .surface = rgb(0x22252c),
    .line = rgb(0x3b404b),
    .accent = rgb(0xf0744e),
    .accentSoft = rgb(0x47291f),
    .hover = rgb(0x2f333c),
    .tile = rgb(0x2a2e36),
    .trough = rgb(0x343944),
    .handle = rgb(0x7d8596),
    .warning = rgb(0xffb95e),
    .good = rgb(0x5fc78e),
};

}  // namespace

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
    case app::ToolKind::Place:
      return rgb(0x5b3fb5);
    default:
      return kAccent;
  }
}

void applyTheme(bool dark) {
  detail::inUse = dark ? kDarkPalette : kLight;
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
  set(ImGuiCol_PopupBg, kDark);
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
