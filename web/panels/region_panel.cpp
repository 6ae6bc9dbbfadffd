// The numbers of what is made of a region, in the place of the section.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "engine/document/params.h"
#include "engine/inflate/ready_profiles.h"
#include "web/commands/intents.h"
#include "web/edit/line_drawing.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/edit/puff_bones.h"
#include "web/panels/number_text.h"
#include "web/panels/section_paint.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

/// How a number of this measure is shown: times a factor, in a unit, with so many digits behind the point.
struct Shown {
  double factor = 1;
  const char* text = "{n}";
  int digits = 0;
};
Shown shownAs(const PanelEnv& env, const document::ParamInfo& info) {
  if (info.measure == document::Measure::Percent) return {100, "{n} %", 0};
  if (info.measure == document::Measure::Length) return {app::mmPerUnit(env.document(), env.derived), "{n} mm", 1};
  return {1, info.unit == "degrees" ? "{n}°" : "{n}", info.step >= 1 ? 0 : 2};
}

/// A slider that shows what it would do and does it when it is let go.
void slider(const PanelEnv& env, const document::Part& part, const document::ParamInfo& info, float width) {
  const app::Preview* preview = app::previewOf(env.ui(), part.id);
  const bool mine = preview && document::kindOf(preview->recipe) == document::kindOf(part);
  const Shown as = shownAs(env, info);
  if (!(as.factor > 0)) return;  // nothing to measure by
  auto value = static_cast<float>(info.get(mine ? preview->recipe : part.recipe) * as.factor);
  label(env.fonts.small, kMuted, info.label);
  ImGui::SetNextItemWidth(width);
  const std::string id = "##" + std::string(info.key);
  const std::string shown = numberText(as.text, static_cast<double>(value), as.digits);
  const SliderTurn turn = panels::slider(env,
                                         {id.c_str(), info.label, static_cast<float>(info.low * as.factor),
                                          static_cast<float>(info.high * as.factor), shown.c_str(), info.low > 0},
                                         value);
  if (turn.changed) {
    app::Preview& changed = app::previewPart(env.ui(), part);
    changed.recipe = part.recipe;
    info.set(changed.recipe, std::clamp(static_cast<double>(value) / as.factor, info.low, info.high));
    changed.fresh = false;
  }
  if (!turn.done) return;
  const double chosen = std::clamp(static_cast<double>(value) / as.factor, info.low, info.high);
  env.ui().preview.reset();
  env.sink.run(app::setParameter, app::selectedParts(env.document(), env.ui()), std::string(info.key), chosen);
}

/// Soft: no slice of the recipe, but this is what a cut through it looks like.
const sections::SectionShape& softSlice() {
  static const sections::SectionShape shape = [] {
    sections::SectionShape out;
    out.contours.emplace_back();
    for (int i = 0; i < 40; ++i) {
      const double angle = 2 * std::numbers::pi * i / 40, c = std::cos(angle), s = std::sin(angle);
      out.contours[0].push_back({std::copysign(std::sqrt(std::abs(c)), c), 0.62 * s});
    }
    return out;
  }();
  return shape;
}

/// Ready slices of a puff, and one of one's own.
void profileTiles(const PanelEnv& env, const document::InflateRecipe& puff, float width) {
  constexpr float kGap = 6;
  const int columns = env.ui().layout.strip && width > app::kFlatStripFrom ? 9 : 3;
  const float each = (width - kGap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  const ImVec2 size{each, env.ui().layout.strip ? 50.f : 58.f};
  const app::BonedPuff boned = app::bonedPuff(env.document(), env.derived, env.ui().selection);
  const std::size_t picked = app::pickedSlice(boned, env.ui());
  const bool local = boned && picked < puff.inflate.profile.slices.size() && puff.inflate.profile.slices[picked].at;
  inflate::ProfileParams shown = puff.inflate.profile;
  if (local) shown.slices = {shown.slices[picked]};
  const std::string_view now = inflate::profileKey(shown);
  label(env.fonts.small, kMuted, "Slice");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap, kGap});
  int count = 0;
  for (const auto& [key, name] : inflate::readyProfiles()) {
    if (count++ % columns != 0) ImGui::SameLine();
    const std::string id = "slice-" + std::string(key);
    const inflate::ProfileParams ready = *inflate::readyProfile(key);
    const sections::SectionShape& shape = ready.isSoft() ? softSlice() : ready.slices.front().shape;
    const bool pressed = tile(env, {id.c_str(), name, name, size, key == now},
                              [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 ink) {
                                paintSection(list, {centre, radius}, shape, {ink, 0, 2.f});
                              });
    if (pressed && local && !ready.isSoft()) {
      env.sink.run(app::setPuffSlice, boned.part->id, picked, shape);
    } else if (pressed) {
      env.sink.run(app::setProfile, app::selectedParts(env.document(), env.ui()), ready);
    }
  }
  if (count % columns != 0) ImGui::SameLine();
  commandTile(env, "edit-slice", size);
  if (!puff.inflate.profile.isSoft()) {
    const ImVec2 half{(width - kGap) / 2, size.y};
    commandTile(env, "slice-whole", half);
    ImGui::SameLine();
    commandTile(env, "slice-edge", half);
  }
  ImGui::PopStyleVar();
}

/// The ways of a kind that are chosen by pictures: none, or three.
std::span<const app::CommandId> tilesFor(document::PartKind kind) {
  static constexpr app::CommandId kSides[] = {"puff-both", "puff-front", "puff-back"},
                                  kEdges[] = {"edge-sharp", "edge-bevel", "edge-round"};
  switch (kind) {
    case document::PartKind::Inflate:
      return kSides;
    case document::PartKind::Extrude:
      return kEdges;
    case document::PartKind::Lathe:
    case document::PartKind::Stack:
    case document::PartKind::Shape:
    case document::PartKind::Element:
    case document::PartKind::Bridge:
    case document::PartKind::Loft:
    case document::PartKind::kCount:
      break;
  }
  return {};
}

}  // namespace

void regionPanel(const PanelEnv& env, const document::Part& part, float width) {
  constexpr float kGap = 6, kWordTile = 50;
  const float each = (width - 2 * kGap) / 3, height = env.ui().layout.strip ? 50.f : 54.f;
  const std::span<const app::CommandId> tiles = tilesFor(document::kindOf(part));
  for (std::size_t i = 0; i < tiles.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, kGap);
    commandTile(env, tiles[i], {each, height});
  }
  if (const document::InflateRecipe* puff = document::inflateOf(part)) profileTiles(env, *puff, width);
  if (document::sideOf(part.recipe) && app::enabled(app::commandOf("plain-side"), env.env)) {
    wordButton(env, {"plain-side", width, buttonSide(env), kAccent});
  }
  if (const document::ShapeRecipe* shape = document::shapeOf(part)) {
    const int columns = env.ui().layout.strip ? 8 : 4;
    const float side = (width - kGap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {kGap, kGap});
    primitiveTiles(env, {columns, {side, height}, shape->shape.primitive, side >= kWordTile});
    ImGui::PopStyleVar();
    if (app::enabled(app::commandOf("plain-outline"), env.env)) {
      wordButton(env, {"plain-outline", width, buttonSide(env), kAccent});
    }
  }
  if (document::stackOf(part)) layersPanel(env, part, width);
  if (const document::ElementRecipe* piece = document::elementOf(part)) {
    WordButtons buttons(env, width);
    using descriptive::PieceKind;
    for (const auto& [kind, text] : {std::pair{PieceKind::Round, "Round"}, std::pair{PieceKind::Flat, "Flat"},
                                     std::pair{PieceKind::Solid, "With edges"}}) {
      if (buttons.button(text, text, piece->kind == kind) && piece->kind != kind) {
        env.sink.run(app::shapePieces, app::selectedParts(env.document(), env.ui()), kind);
      }
    }
    if (const auto seen = app::seenFrom(env.document(), env.derived, part.id)) {
      WordButtons ways(env, width);
      for (const auto& [from, text] : app::kSeenWords) {
        if (ways.button(text, text, *seen == from) && *seen != from) {
          env.sink.run(app::seeFrom, app::selectedParts(env.document(), env.ui()), from);
        }
      }
    }
    if (app::turnUpright(env.document(), env.derived, part.id)) {
      wordButton(env, {"stand-upright", width, buttonSide(env), kAccent});
    }
  }
  const auto table = document::paramTable(document::kindOf(part));
  for (const document::ParamInfo& info : table) {
    if (!info.forFew && (info.applies == nullptr || info.applies(part.recipe))) slider(env, part, info, width);
  }
  const bool ofRegion = document::regionOf(part.recipe) != nullptr;
  const app::CommandId other = document::inflateOf(part) ? app::CommandId("make-sheet") : app::CommandId("make-puff");
  if (ofRegion) wordButton(env, {other, width, buttonSide(env), kAccent});
  if (ofRegion && !document::latheOf(part)) wordButton(env, {"make-round", width, buttonSide(env), kAccent});
  if (std::ranges::none_of(table, &document::ParamInfo::forFew)) return;
  bool& more = env.ui().moreNumbers;
  const char* text = more ? "Less about this" : "More about this";
  if (textButton(env, {"more", text, false, true, buttonSide(env), width})) more = !more;
  for (const document::ParamInfo& info : table) {
    if (more && info.forFew) slider(env, part, info, width);
  }
}

}  // namespace spineloft::panels
