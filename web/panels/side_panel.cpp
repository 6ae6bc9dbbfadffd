// Parts, section, ends and look: a column beside the views, or a strip with tabs below them.
#include <imgui.h>

#include <algorithm>
#include <array>

#include "web/panels/short_list.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

struct Tab {
  app::PanelTab tab;
  const char* label;
};
constexpr std::array kTabs = {Tab{app::PanelTab::Parts, "Parts"}, Tab{app::PanelTab::Section, "Slice"},
                              Tab{app::PanelTab::Along, "Twist"}, Tab{app::PanelTab::Ends, "Ends"},
                              Tab{app::PanelTab::Look, "Look"},   Tab{app::PanelTab::Size, "Size"},
                              Tab{app::PanelTab::Place, "Place"}};

/// A heading that opens and folds what is below it. True while it is open.
bool section(const PanelEnv& env, app::PanelTab tab, const char* text) {
  const unsigned bit = 1u << static_cast<unsigned>(tab);
  unsigned& folded = env.ui().folded;
  ImGui::Dummy({0, 2});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = env.ui().touch ? 44.f : 28.f;
  if (ImGui::InvisibleButton(text, {width, height})) folded ^= bit;
  const bool open = (folded & bit) == 0;
  registerControl(env, app::Control::Kind::Section, text, true, open);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list.AddRectFilled({at.x - 6, at.y}, {at.x + width, at.y + height}, kHover, 8);
  list.AddLine({at.x, at.y - 3}, {at.x + width, at.y - 3}, kLine);
  const float size = env.fonts.bold->FontSize * ImGui::GetIO().FontGlobalScale;
  list.AddText(env.fonts.bold, size, {at.x, at.y + (height - size) / 2}, kInk, text);
  const ImVec2 c{at.x + width - 10, at.y + height / 2};  // the arrow
  if (open) {
    list.AddTriangleFilled({c.x - 4, c.y - 2}, {c.x + 4, c.y - 2}, {c.x, c.y + 3}, kMuted);
  } else {
    list.AddTriangleFilled({c.x + 2, c.y - 4}, {c.x + 2, c.y + 4}, {c.x - 3, c.y}, kMuted);
  }
  return open;
}

/// The selected part when it is a puff or a flat piece, else null.
const document::Part* selectedRegion(const PanelEnv& env) {
  const document::Part* part = env.selected();
  return part != nullptr && document::regionOf(part->recipe) != nullptr ? part : nullptr;
}

const char* titleOf(const document::Part& region) { return document::inflateOf(region) ? "Puff" : "Flat piece"; }

/// A part without a spine has nothing along it and no ends.
ShortList<Tab> tabsFor(const document::Part* region) {
  ShortList<Tab> shown;
  for (Tab tab : kTabs) {
    if (region && (tab.tab == app::PanelTab::Along || tab.tab == app::PanelTab::Ends)) continue;
    if (region && tab.tab == app::PanelTab::Section) tab.label = titleOf(*region);
    shown.push_back(tab);
  }
  return shown;
}

void column(const PanelEnv& env) {
  const float width = ImGui::GetContentRegionAvail().x;
  ImGui::AlignTextToFramePadding();
  label(env.fonts.bold, kInk, "Parts");
  const float side = env.ui().touch ? 44.f : 32.f;
  ImGui::SameLine(width - side + 8);
  commandButton(env, "new-part", side);
  partList(env);
  if (const document::Part* region = selectedRegion(env)) {
    if (section(env, app::PanelTab::Section, titleOf(*region))) regionPanel(env, *region, width);
  } else {
    if (section(env, app::PanelTab::Section, env.selected() ? "Slice" : "Slice of the next part")) {
      sectionChooser(env, width);
    }
    if (section(env, app::PanelTab::Along, "Twist and depth")) alongPanel(env, width);
    if (section(env, app::PanelTab::Ends, "Ends")) capChooser(env, width);
  }
  if (section(env, app::PanelTab::Look, "Look")) lookPanel(env, width);
  if (!env.document().parts.empty() && section(env, app::PanelTab::Size, "How tall?")) sizePanel(env, width);
  if (env.selected() && section(env, app::PanelTab::Place, "Place")) placePanel(env, width);
  ImGui::Dummy({0, 8});
}

void tabs(const PanelEnv& env, float width) {
  const float height = env.ui().touch ? 44.f : 38.f;
  const ShortList<Tab> shown = tabsFor(selectedRegion(env));
  const float each = std::min(width / static_cast<float>(shown.size()), 140.f);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    if (ImGui::InvisibleButton(shown[i].label, {each, height})) env.ui().tab = shown[i].tab;
    const bool on = env.ui().tab == shown[i].tab;
    registerControl(env, app::Control::Kind::Tab, shown[i].label, true, on);
    ImFont* font = on ? env.fonts.bold : env.fonts.text;
    ImGui::PushFont(font);
    const ImVec2 extent = ImGui::CalcTextSize(shown[i].label);
    list.AddText({at.x + (each - extent.x) / 2, at.y + (height - extent.y) / 2 - 1},
                 on                       ? kAccent
                 : ImGui::IsItemHovered() ? kInk
                                          : kMuted,
                 shown[i].label);
    ImGui::PopFont();
    if (on) {
      list.AddRectFilled({at.x + each * 0.2f, at.y + height - 4}, {at.x + each * 0.8f, at.y + height - 1}, kAccent, 2);
    }
  }
  ImGui::PopStyleVar();
}

void strip(const PanelEnv& env, const app::Rect& at) {
  const float width = static_cast<float>(at.width) - 20;
  ImGui::SetCursorPos({10, 0});
  ImGui::BeginGroup();
  tabs(env, width);
  ImGui::EndGroup();
  ImGui::SetCursorPos({10, env.ui().touch ? 47.f : 43.f});
  ImGui::BeginChild("content", {width, 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NoNav);
  const float inside = ImGui::GetContentRegionAvail().x;  // a scroll bar takes some
  const document::Part* region = selectedRegion(env);
  const bool boneOnly = env.ui().tab == app::PanelTab::Along || env.ui().tab == app::PanelTab::Ends;
  switch (region && boneOnly ? app::PanelTab::Section : env.ui().tab) {
    case app::PanelTab::Parts:
      partList(env);
      break;
    case app::PanelTab::Section:
      region ? regionPanel(env, *region, inside) : sectionChooser(env, inside);
      break;
    case app::PanelTab::Along:
      alongPanel(env, inside);
      break;
    case app::PanelTab::Ends:
      capChooser(env, inside);
      break;
    case app::PanelTab::Place:
      placePanel(env, inside);
      break;
    case app::PanelTab::Look:
      lookPanel(env, inside);
      break;
    case app::PanelTab::Size:
      sizePanel(env, inside);
      break;
  }
  if (!env.ui().listDrag) dragScroll();
  ImGui::EndChild();
}

}  // namespace

void drawSidePanel(const PanelEnv& env) {
  const app::Layout& layout = env.ui().layout;
  if (layout.panel.width < 1) return;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, layout.strip ? ImVec2(0, 0) : ImVec2(14, 8));
  const ImGuiWindowFlags scroll = layout.strip ? ImGuiWindowFlags_NoScrollWithMouse : 0;
  ImGui::SetNextWindowPos({static_cast<float>(layout.panel.x), static_cast<float>(layout.panel.y)});
  ImGui::SetNextWindowSize({static_cast<float>(layout.panel.width), static_cast<float>(layout.panel.height)});
  ImGui::Begin("panel", nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                   ImGuiWindowFlags_NoFocusOnAppearing | scroll);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 corner = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  list.AddLine(corner, layout.strip ? ImVec2(corner.x + size.x, corner.y) : ImVec2(corner.x, corner.y + size.y), kLine,
               1.5f);
  if (layout.strip) {
    strip(env, layout.panel);
  } else {
    column(env);
    if (!env.ui().listDrag) dragScroll();
  }
  ImGui::End();
  ImGui::PopStyleVar(2);
}

}  // namespace spineloft::panels
