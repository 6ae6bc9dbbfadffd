// Parts, section, ends and look: a column beside the views, or a strip with tabs below them.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "web/edit/editing.h"
#include "web/edit/placing.h"
#include "web/panels/short_list.h"
#include "web/panels/solid_list.h"
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
bool section(const PanelEnv& env, app::PanelTab tab, const char* id, Text words) {
  const unsigned bit = 1u << static_cast<unsigned>(tab);
  unsigned& folded = env.ui().folded;
  ImGui::Dummy({0, 2});
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = env.ui().touch ? 44.f : 28.f;
  if (ImGui::InvisibleButton(id, {width, height})) folded ^= bit;
  const bool open = (folded & bit) == 0;
  registerControl(env, app::Control::Kind::Section, words.words, true, open);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (ImGui::IsItemHovered()) list.AddRectFilled({at.x - 6, at.y}, {at.x + width, at.y + height}, kHover, 8);
  list.AddLine({at.x, at.y - 3}, {at.x + width, at.y - 3}, kLine);
  ImFont* bold = env.fonts.bold;
  const float size = bold->FontSize * ImGui::GetIO().FontGlobalScale, room = width - 24;
  const std::string_view text = shortened(bold, words, room);
  const bool fromRight = words::language().rightToLeft;
  const float left = fromRight ? at.x + width - extentOf(bold, text).x : at.x;
  drawLine(list, {bold, {left, at.y + (height - size) / 2}, kInk}, text);
  const ImVec2 c{fromRight ? at.x + 10 : at.x + width - 10, at.y + height / 2};  // the arrow
  if (open) {
    list.AddTriangleFilled({c.x - 4, c.y - 2}, {c.x + 4, c.y - 2}, {c.x, c.y + 3}, kMuted);
  } else {
    list.AddTriangleFilled({c.x + 2, c.y - 4}, {c.x + 2, c.y + 4}, {c.x - 3, c.y}, kMuted);
  }
  return open;
}

/// A heading that says how many parts its settings are for, where they are several.
Text forParts(const PanelEnv& env, const char* text) {
  const std::size_t count = app::selectedParts(env.document(), env.ui()).size();
  if (count < 2) return text;
  return asIs(words::tr("{what} of {n} parts", {{"what", words::tr(text)}, {"n", count}}));
}

/// The selected part when it has no bone: made of a region, or drawn slice by slice. Else null.
const document::Part* selectedRegion(const PanelEnv& env) {
  const document::Part* part = env.selected();
  return part != nullptr && document::loftOf(*part) == nullptr ? part : nullptr;
}

const char* titleOf(const document::Part& region) {
  if (document::latheOf(region)) return "Spin";
  if (document::stackOf(region)) return "Layers";
  if (document::shapeOf(region)) return "Shape";
  if (document::elementOf(region)) return "Piece";
  if (document::bridgeOf(region)) return "Bridge";
  return document::inflateOf(region) ? "Puff" : "Flat piece";
}

/// The tool in hand draws no lines along things: the next part has no slices and ends of its own to set.
bool drawsOther(app::ToolKind tool) {
  return app::drawsRegions(tool) || app::worksInSolid(tool) || tool == app::ToolKind::Primitive ||
         tool == app::ToolKind::Lines;
}

/// Few panels at first: before the first part there is nothing to set, and curves and numbers come with all tools.
bool isOffered(const PanelEnv& env, app::PanelTab tab) {
  const bool ofLines = tab == app::PanelTab::Section || tab == app::PanelTab::Along || tab == app::PanelTab::Ends;
  if (ofLines && env.selected() == nullptr && drawsOther(env.ui().tool)) return false;
  if (env.ui().allTools || tab == app::PanelTab::Parts) return true;
  return !env.document().parts.empty() && tab != app::PanelTab::Along && tab != app::PanelTab::Place;
}

/// A part without a spine has nothing along it, and mostly no ends.
ShortList<Tab> tabsFor(const PanelEnv& env, const document::Part* region) {
  ShortList<Tab> shown;
  for (Tab tab : kTabs) {
    if (!isOffered(env, tab.tab)) continue;
    if (region && tab.tab == app::PanelTab::Along) continue;
    if (region && tab.tab == app::PanelTab::Ends && !app::capsOf(*region)) continue;
    if (region && tab.tab == app::PanelTab::Section) tab.label = titleOf(*region);
    shown.push_back(tab);
  }
  return shown;
}

void column(const PanelEnv& env) {
  const float width = ImGui::GetContentRegionAvail().x;
  const float side = env.ui().touch ? 44.f : 32.f, top = ImGui::GetCursorPosY();
  ImGui::SetCursorPosY(top + (side - ImGui::GetTextLineHeight()) / 2);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - side);
  label(env.fonts.bold, kInk, "Parts");
  ImGui::PopTextWrapPos();
  ImGui::SameLine(width - side + 8);
  ImGui::SetCursorPosY(top);
  commandButton(env, "new-part", side);
  partList(env, true);
  if (!isOffered(env, app::PanelTab::Look)) return;
  if (const document::Part* region = selectedRegion(env)) {
    if (section(env, app::PanelTab::Section, "slice", forParts(env, titleOf(*region))))
      regionPanel(env, *region, width);
    if (app::capsOf(*region) && section(env, app::PanelTab::Ends, "ends", forParts(env, "Ends"))) {
      capChooser(env, width);
    }
  } else if (isOffered(env, app::PanelTab::Section)) {
    const Text title = env.selected() ? forParts(env, "Slice") : "Slice of the next part";
    if (section(env, app::PanelTab::Section, "slice", title)) {
      sectionChooser(env, width);
    }
    if (isOffered(env, app::PanelTab::Along) && section(env, app::PanelTab::Along, "along", "Twist and depth")) {
      alongPanel(env, width);
    }
    if (section(env, app::PanelTab::Ends, "ends", forParts(env, "Ends"))) capChooser(env, width);
  }
  if (section(env, app::PanelTab::Look, "look", forParts(env, "Look"))) lookPanel(env, width);
  if (env.selected() && section(env, app::PanelTab::Relief, "relief", forParts(env, "Relief"))) reliefPanel(env, width);
  if (!env.document().parts.empty() && section(env, app::PanelTab::Size, "size", "How tall?")) sizePanel(env, width);
  const bool placed = env.selected() != nullptr && isOffered(env, app::PanelTab::Place);
  if (placed && section(env, app::PanelTab::Place, "place", "Place")) placePanel(env, width);
  ImGui::Dummy({0, 8});
}

void tabs(const PanelEnv& env, float width) {
  const float height = env.ui().touch ? 44.f : 38.f;
  const ShortList<Tab> shown = tabsFor(env, selectedRegion(env));
  const auto wordOf = [&](const Tab& tab) { return extentOf(env.fonts.bold, words::drawn(words::tr(tab.label))).x; };
  const auto count = static_cast<float>(shown.size());
  float beside = std::min(width, 140.f * count);  // what is left for each beside its word
  for (const Tab& tab : shown) beside -= wordOf(tab);
  beside /= count;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
  for (std::size_t i = 0; i < shown.size(); ++i) {
    if (i > 0) ImGui::SameLine();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float each = wordOf(shown[i]) + beside;
    if (ImGui::InvisibleButton(shown[i].label, {each, height})) env.ui().tab = shown[i].tab;
    const bool on = env.ui().tab == shown[i].tab || shown.size() == 1;
    registerControl(env, app::Control::Kind::Tab, shown[i].label, true, on);
    ImFont* font = on ? env.fonts.bold : env.fonts.text;
    const Fitted word = fitted(font, shown[i].label, each - 4);
    const ImVec2 extent = extentOf(font, word.text, word.share);
    const ImU32 colour = on ? kAccent : ImGui::IsItemHovered() ? kInk : kMuted;
    drawLine(list, {font, {at.x + (each - extent.x) / 2, at.y + (height - extent.y) / 2 - 1}, colour, word.share},
             word.text);
    if (on) {
      list.AddRectFilled({at.x + each * 0.2f, at.y + height - 4}, {at.x + each * 0.8f, at.y + height - 1}, kAccent, 2);
    }
  }
  ImGui::PopStyleVar();
}

/// A list in a strip is scrolled: what can be made of its parts stays in sight beside it.
void partsInStrip(const PanelEnv& env, float width) {
  constexpr float kCell = 64, kGap = 8;
  if (!hasSolidTiles(env)) return partList(env, false);
  const int columns = width < static_cast<float>(app::kFlatStripFrom) ? 2 : 4;
  const float tiles = static_cast<float>(columns) * (kCell + 4) - 4;
  const float room = tiles + ImGui::GetStyle().ScrollbarSize;
  ImGui::BeginChild("list", {width - room - kGap, 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NoNav);
  partList(env, false);
  if (!env.ui().listDrag) dragScroll();
  ImGui::EndChild();
  ImGui::SameLine(0, kGap);
  ImGui::BeginChild("tiles", {room, 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NoNav);
  solidTiles(env, tiles, columns);
  dragScroll();
  ImGui::EndChild();
}

void strip(const PanelEnv& env, const app::Rect& at) {
  const float width = static_cast<float>(at.width) - 20;
  ImGui::SetCursorPos({10, 0});
  ImGui::BeginGroup();
  // The bar of a small page has no room for it.
  const float side = env.ui().touch ? 44.f : 38.f;
  tabs(env, width - side);
  ImGui::SameLine(10 + width - side);
  commandButton(env, "new-part", side);
  ImGui::EndGroup();
  ImGui::SetCursorPos({10, env.ui().touch ? 47.f : 43.f});
  ImGui::BeginChild("content", {width, 0}, ImGuiChildFlags_None, ImGuiWindowFlags_NoNav);
  const float inside = ImGui::GetContentRegionAvail().x;  // a scroll bar takes some
  const document::Part* region = selectedRegion(env);
  const bool ends = env.ui().tab == app::PanelTab::Ends && (!region || app::capsOf(*region));
  const bool boneOnly = env.ui().tab == app::PanelTab::Along || (env.ui().tab == app::PanelTab::Ends && !ends);
  const app::PanelTab wanted = region && boneOnly ? app::PanelTab::Section : env.ui().tab;
  const bool there = isOffered(env, wanted);
  const app::PanelTab first = isOffered(env, app::PanelTab::Section) ? app::PanelTab::Section : app::PanelTab::Parts;
  switch (there ? wanted : first) {
    case app::PanelTab::Parts:
      partsInStrip(env, inside);
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
      if (env.selected() == nullptr) break;
      label(env.fonts.bold, kInk, "Relief");
      reliefPanel(env, inside);
      break;
    case app::PanelTab::Relief:  // no tab of its own
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
