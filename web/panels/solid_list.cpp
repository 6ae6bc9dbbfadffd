#include "web/panels/solid_list.h"
#include "web/commands/intents.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "web/edit/section_editing.h"
#include "web/edit/solid_editing.h"
#include "web/model/solid_faults.h"
#include "web/panels/number_text.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

using document::StepKind;

std::string_view iconOf(StepKind kind) {
  switch (kind) {
    case StepKind::Join:
      return "squares-unite";
    case StepKind::Cut:
      return "squares-subtract";
    case StepKind::Intersection:
      return "squares-intersect";
    case StepKind::Hollow:
    case StepKind::kCount:
      break;
  }
  return "cup-soda";
}

/// `length`: the wall or the blend of a solid.
void slider(const PanelEnv& env, const document::Step& step, double document::SetStep::* length, const char* text) {
  document::SetStep action{step.id, step.kind, step.blend, step.wall, step.opening};
  const bool wall = length == &document::SetStep::wall;
  const double scale = app::millimetresPerUnit(env.env);
  const double unit = scale > 0 ? scale : 100;
  float value = static_cast<float>(action.*length * unit);
  const float low = wall ? static_cast<float>(document::kLeastWall * unit) : 0.f;
  const float high = static_cast<float>((wall ? 0.15 : document::kMostBlend) * unit);
  label(env.fonts.small, kMuted, text);
  ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
  const char* id = wall ? "##wall" : "##blend";
  // In hand it shows where it is; what it asks for is done once, when it is let go.
  ImGuiStorage& held = *ImGui::GetStateStorage();
  const ImGuiID here = ImGui::GetID(id);
  if (ImGui::GetActiveID() == here) value = held.GetFloat(here, value);
  const std::string shown = numberText("{n} mm", static_cast<double>(value), 1);
  const SliderTurn turn = panels::slider(env, {id, text, low, high, shown.c_str()}, value);
  held.SetFloat(here, value);
  if (!turn.done) return;
  action.*length = static_cast<double>(value) / unit;
  env.sink.run(app::setStep, action);
}

/// Whether the first part of a solid goes along a line, at whose ends it can be open.
bool goesAlongLine(const PanelEnv& env, const document::Operand& what) {
  const std::vector<PartId> parts = document::partsIn(env.document(), what);
  const pipeline::PartShape* shape = parts.empty() ? nullptr : app::shapeOf(env.document(), env.derived, parts.front());
  return shape != nullptr && shape->centreLine.size() > 1;
}

/// The sides at which this can be open once it is hollow, `on` pressed; `choose(side)` is told another one.
template <class Choose>
void openingChooser(const PanelEnv& env, const document::Operand& what, document::OpeningSide on, float width,
                    const Choose& choose) {
  using document::OpeningSide;
  constexpr std::array<std::pair<OpeningSide, const char*>, 9> kChoices = {{{OpeningSide::Up, "Top"},
                                                                            {OpeningSide::Down, "Bottom"},
                                                                            {OpeningSide::Start, "Line's start"},
                                                                            {OpeningSide::End, "Line's end"},
                                                                            {OpeningSide::Front, "Front"},
                                                                            {OpeningSide::Back, "Back"},
                                                                            {OpeningSide::Left, "Left"},
                                                                            {OpeningSide::Right, "Right"},
                                                                            {OpeningSide::None, "Closed"}}};
  label(env.fonts.small, kMuted, "Open at");
  WordButtons row(env, width);
  const bool hasEnds = goesAlongLine(env, what);
  for (const auto& [side, text] : kChoices) {
    const bool isEnd = side == OpeningSide::Start || side == OpeningSide::End;
    if (isEnd && !hasEnds && side != on) continue;
    if (row.button(text, text, on == side)) choose(side);
  }
}

/// What *Scoop out* shows, in place of what else can be made; the bar of the solid view does it.
void shownHollow(const PanelEnv& env, const document::CombineParts& draft, float width) {
  const document::Operand what = draft.operands.front();
  const document::Step* step = findStep(env.document(), what.step);
  const document::Part* part = findPart(env.document(), what.part);
  const std::string_view name = words::nameOf(step ? step->name : part ? part->name : std::string_view());
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
  label(env.fonts.bold, kInk, asIs(words::tr("{name} becomes hollow", {{"name", name}})));
  ImGui::PopTextWrapPos();
  openingChooser(env, what, draft.opening.side, width,
                 [&](document::OpeningSide side) { env.sink.run(app::openHollow, side); });
}

void chosenSolid(const PanelEnv& env, const document::Step& step, float width) {
  ImGui::PushID(static_cast<int>(step.id.value));
  const bool blends = step.kind == StepKind::Join || step.kind == StepKind::Cut;
  if (blends) slider(env, step, &document::SetStep::blend, "Round the seam");
  if (step.kind == StepKind::Hollow) {
    slider(env, step, &document::SetStep::wall, "Wall");
    openingChooser(env, {{}, step.id}, step.opening.side, width, [&](document::OpeningSide side) {
      document::SetStep action{step.id, step.kind, step.blend, step.wall, step.opening};
      action.opening.side = side;
      env.sink.run(app::setStep, action);
    });
    commandText(env, {"point-opening", width});
  }
  ImGui::PopID();
}

/// Where a wall is too thick: the one that fits.
void thinnerWall(const PanelEnv& env, const document::Step& step, float width) {
  const auto at = std::ranges::find(env.derived.steps, step.id, &pipeline::DerivedStep::id);
  const double scale = app::millimetresPerUnit(env.env);
  const bool fits = at != env.derived.steps.end() && at->thickest && *at->thickest >= document::kLeastWall;
  if (step.kind != StepKind::Hollow || !fits || !(scale > 0)) return;
  const std::string words(words::tr("Make the wall {length}", {{"length", app::spokenWall(*at->thickest * scale)}}));
  if (textButton(env, {"thinner", asIs(words), false, true, buttonSide(env), width})) {
    env.sink.run(app::setStep, document::SetStep{step.id, step.kind, step.blend, *at->thickest, step.opening});
  }
}

}  // namespace

bool grip(const PanelEnv& env, const app::ListRow& row, ImVec2 size, std::string_view name) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const bool pressed = ImGui::InvisibleButton("grip", size);
  registerControl(env, app::Control::Kind::Grip, name);
  std::optional<app::ListRow>& dragged = env.ui().listDrag;
  if (env.ui().touch) {
    if (!dragged && ImGui::IsItemActive() && longPress()) dragged = row;
    return pressed && !dragged;
  }
  if (ImGui::IsItemActivated()) dragged = row;
  if (!ImGui::IsItemHovered()) return false;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (const float dy : {-5.f, 0.f, 5.f}) list.AddCircleFilled({at.x + 3, at.y + size.y / 2 + dy}, 1.4f, kMuted, 8);
  return false;
}

void showRow(const PanelEnv& env, const app::ListRow& row, float left) {
  const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
  if (!ImGui::GetCurrentWindow()->ClipRect.Contains(ImVec2((low.x + high.x) / 2, (low.y + high.y) / 2))) return;
  // A name may be longer than the buttons at the end of its row leave it.
  const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
  env.ui().rows.push_back({row, {left, low.y, right - left, high.y - low.y}});
}

bool secondClick() { return ImGui::GetIO().MouseClickedLastCount[0] == 2; }

bool holdsWhole(const PanelEnv& env) {
  const document::Step* step = app::chosenStep(env.env);
  return step != nullptr && env.ui().selection &&
         partsIn(env.document(), {{}, step->id}).size() == env.ui().alsoSelected.size() + 1;
}

bool canTick(const PanelEnv& env, document::Operand operand) {
  return holderOf(env.document(), operand) == nullptr && app::hasSeveralRoots(env.document());
}

void tickButton(const PanelEnv& env, document::Operand operand, float size) {
  const bool on = app::isPicked(env.ui(), operand);
  const char* tip = on ? "Not this one" : "Tick it, to put it together with others";
  if (iconButton(env, {"tick", on ? "circle-check" : "circle", tip, on, true, size})) {
    env.sink.run(app::pick, operand, !on);
  }
}

bool solidRow(const PanelEnv& env, const document::Step& step, float indent, float width) {
  const bool selected = step.id == env.ui().solids.step;
  const bool root = holderOf(env.document(), {{}, step.id}) == nullptr;
  const bool ticks = root && canTick(env, {{}, step.id});
  const bool open = std::ranges::count(env.ui().solids.folded, step.id) == 0;
  const std::string trouble = app::stepFailureWords(env.env, step);
  const float height = buttonSide(env);
  const float buttons = height * (static_cast<float>(root) + static_cast<float>(ticks) + 1.f);
  ImGui::PushID("solid");
  ImGui::PushID(static_cast<int>(step.id.value));
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + indent);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float row = std::max(40.f, width - indent - buttons);
  const float grips = root ? 26 : 0;  // solids within solids stay where they are
  bool tapped = false;
  if (root) {
    tapped = grip(env, {{}, {}, step.id}, {grips, height}, step.name);
    ImGui::SameLine(0, 0);
  }
  const bool pressed = ImGui::InvisibleButton("row", {row - grips, height}) || tapped;
  registerControl(env, app::Control::Kind::Row, step.name, true, selected);
  showRow(env, {{}, {}, step.id}, at.x + 26);
  const std::optional<app::Flash>& flash = env.ui().solids.flash;
  if (flash && flash->step == step.id) {
    const ImU32 lit = faded(kAccent, static_cast<unsigned>(110 * flash->light));
    list.AddRectFilled(at, {at.x + width - indent, at.y + height}, lit, 8);
  }
  const ImVec2 end{at.x + width - indent, at.y + height};
  if (selected) markOn(list, at, end, kAccentSoft);
  if (!selected && ImGui::IsItemHovered()) list.AddRectFilled(at, end, kHover, 8);
  if (!trouble.empty()) tooltip(asIs(trouble));
  ImFont* icons = env.fonts.icons;
  const float iconSize = icons->FontSize * ImGui::GetIO().FontGlobalScale;
  list.AddText(icons, iconSize, {at.x + 5, at.y + (height - iconSize) / 2}, trouble.empty() ? kAccent : kFailure,
               iconText(iconOf(step.kind)));
  const std::string_view name = shortened(ImGui::GetFont(), asIs(words::nameOf(step.name)), row - 34);
  const ImU32 ink = !step.visible ? faded(kMuted, 150) : selected ? kAccent : kInk;
  drawLine(list, {ImGui::GetFont(), {at.x + 30, at.y + (height - ImGui::GetTextLineHeight()) / 2}, ink}, name);
  if (pressed) {
    const bool twice = selected && (secondClick() || wasLongPress());
    env.sink.run(twice ? app::askStepName : app::selectStep, step.id);
  }
  ImGui::SameLine(0, 0);
  const char* fold = open ? "Hide what it is made of" : "Show what it is made of";
  if (iconButton(env, {"fold", open ? "chevron-down" : "chevron-right", fold, false, true, height})) {
    env.sink.run(app::foldStep, step.id);
  }
  if (ticks) {
    ImGui::SameLine(0, 0);
    tickButton(env, {{}, step.id}, height);
  }
  if (root) {
    ImGui::SameLine(0, 0);
    const std::string_view eye = step.visible ? "eye" : "eye-off";
    const std::string_view tip = step.visible ? "Hide" : "Show";
    if (iconButton(env, {"eye", eye, tip, false, true, height})) env.sink.run(app::showStep, step.id, !step.visible);
  }
  ImGui::PopID();
  ImGui::PopID();
  return open;
}

bool hasSolidTiles(const PanelEnv& env) {
  if (env.ui().solids.hollow) return false;  // which says what it does in their place
  return app::hasSeveralRoots(env.document()) || app::chosenStep(env.env) != nullptr || env.selected() != nullptr;
}

void solidTiles(const PanelEnv& env, float width, int columns) {
  const document::Step* step = app::chosenStep(env.env);
  constexpr float kGap = 4;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap, kGap});
  const float each = std::min(74.f, (width - kGap * static_cast<float>(columns - 1)) / static_cast<float>(columns));
  int tiles = 0;
  const auto tile = [&](app::CommandId id) {
    if (tiles++ % columns != 0) ImGui::SameLine();
    commandTile(env, id, {each, 50});
  };
  if (app::hasSeveralRoots(env.document())) {
    for (const app::CommandId id : std::initializer_list<app::CommandId>{"stick-together", "cut", "keep-common"})
      tile(id);
  }
  if (step == nullptr || step->kind != StepKind::Hollow) tile("hollow-show");
  if (step != nullptr) tile("release");
  // A bin beside one of its parts would take that part alone.
  if (holdsWhole(env)) tile("delete-step");
  ImGui::PopStyleVar();
}

void solidPanel(const PanelEnv& env, float width, bool tiles) {
  const document::Step* step = app::chosenStep(env.env);
  if (!env.ui().solids.hollow && !hasSolidTiles(env)) return;
  ImGui::Dummy({0, 4});
  for (const document::Step& each : env.document().steps) {
    const std::string trouble = app::stepFailureWords(env.env, each);
    if (trouble.empty()) continue;
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    label(env.fonts.small, kFailure, asIs(std::string(words::nameOf(each.name)) + ": " + trouble));
    ImGui::PopTextWrapPos();
    ImGui::PushID(static_cast<int>(each.id.value));
    const float half = std::min((width - 4) / 2, 110.f);
    if (app::hasPlace(env.env, each) &&
        textButton(env, {"where", app::commandOf("show-trouble").label, false, true, buttonSide(env), half})) {
      env.sink.run(app::showFailure, each.id);
    }
    if (app::hasPlace(env.env, each)) ImGui::SameLine(0, 4);
    commandText(env, {"solve-again", half});
    thinnerWall(env, each, width);
    ImGui::PopID();
  }
  if (env.ui().solids.hollow) return shownHollow(env, *env.ui().solids.hollow, width);
  if (tiles) solidTiles(env, width, 4);
  if (step != nullptr) chosenSolid(env, *step, width);
}

}  // namespace spineloft::panels
