// The shelf of sections: the presets, the visitor's own, and those that the model uses.
#include <imgui.h>

#include <algorithm>
#include <string>
#include <vector>

#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/edit/section_editing.h"
#include "web/panels/section_paint.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

/// Chooses a section for the picked place of the part, or as the start of the one on the board.
void choose(const PanelEnv& env, const sections::SectionShape& shape) {
  if (env.ui().sections.board) {
    env.sink.run(app::startBoardFrom, shape);
    return;
  }
  const document::Part* part = env.selected();
  std::optional<std::size_t> key;
  if (part && document::loftIn(*part).loft.sections.size() > 1) key = app::pickedSectionKey(env.ui(), *part);
  const app::Parts inHand = app::selectedParts(env.document(), env.ui());
  env.sink.run(app::setSection, key ? app::Parts{part->id} : inHand, key, shape);
}

/// The tiles, in rows.
class Grid {
 public:
  Grid(const PanelEnv& env, float width) : env_(env) {
    const bool strip = env.ui().layout.strip;
    columns_ = strip ? (width < app::kFlatStripFrom - 20 ? 6 : 12) : 4;
    const float side = (width - kGap * static_cast<float>(columns_ - 1)) / static_cast<float>(columns_);
    const float oneRow = std::clamp(ImGui::GetContentRegionAvail().y - 4, 44.f, 76.f);
    size_ = {std::floor(std::min(side, 92.f)), strip ? (columns_ == 12 ? oneRow : 47.f) : 58.f};
  }
  ImVec2 size() const { return size_; }
  void place() {
    if (count_++ % columns_ != 0) ImGui::SameLine();
  }

  static constexpr float kGap = 6;

  /// A tile of a section; it can be pressed, or dragged to a part.
  bool section(const char* id, Text name, const sections::SectionShape& shape, bool on) {
    place();
    const Text text = size_.y < 50 ? Text("") : name;
    const bool pressed =
        tile(env_, {id, text, name, size_, on}, [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 ink) {
          paintSection(list, {centre, radius}, shape, {ink, 0, 2.f});
        });
    if (ImGui::IsItemActivated()) env_.ui().sections.pressed = shape;
    return pressed;
  }

 private:
  const PanelEnv& env_;
  int columns_ = 1, count_ = 0;
  ImVec2 size_;
};

/// Drawn sections of the model that are not on the shelf, each once.
std::vector<const sections::SectionShape*> recentOf(const PanelEnv& env) {
  std::vector<const sections::SectionShape*> out;
  const auto known = [&](const sections::SectionShape& shape) {
    return std::ranges::any_of(env.ui().sections.shelf, [&](const app::ShelfSection& s) { return s.shape == shape; }) ||
           std::ranges::any_of(out, [&](const auto* other) { return *other == shape; });
  };
  for (const document::Part& part : env.document().parts) {
    for (const loft::SectionKey& key : document::loftIn(part).loft.sections) {
      if (key.shape.drawn() && !known(key.shape)) out.push_back(&key.shape);
    }
  }
  return out;
}

/// What can be done with a chosen section of one's own.
void ownSection(const PanelEnv& env, const sections::SectionShape& chosen) {
  const float side = buttonSide(env);
  const auto& shelf = env.ui().sections.shelf;
  const auto kept = std::ranges::find_if(shelf, [&](const app::ShelfSection& s) { return s.shape == chosen; });
  commandText(env, {"edit-slice"});
  ImGui::SameLine(0, 4);
  if (kept == shelf.end()) {
    commandButton(env, "keep-slice", side);
    return;
  }
  if (namedButton(env, "rename-slice", side)) env.sink.run(app::askSectionName, kept->id);
  ImGui::SameLine(0, 0);
  if (namedButton(env, "delete-slice", side)) env.sink.run(app::deleteSection, kept->id);
}

}  // namespace

void sectionChooser(const PanelEnv& env, float width) {
  const document::Part* part = env.selected();
  const sections::SectionShape& chosen = app::pickedShape(env.ui(), part);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {Grid::kGap, Grid::kGap});
  Grid grid(env, width);
  if (env.ui().layout.strip) {  // first where little shows at once
    grid.place();
    commandTile(env, "edit-slice", grid.size());
  }
  for (const sections::SectionName& name : sections::sectionNames()) {
    const std::string key(name.key);
    const bool on = !chosen.drawn() && name.preset == chosen.preset;
    if (grid.section(key.c_str(), name.label, name.preset, on)) choose(env, name.preset);
  }
  for (const app::ShelfSection& section : env.ui().sections.shelf) {
    const std::string id = "shelf" + std::to_string(section.id);
    if (grid.section(id.c_str(), asIs(words::nameOf(section.name)), section.shape, section.shape == chosen)) {
      choose(env, section.shape);
    }
  }
  int recent = 0;
  for (const sections::SectionShape* shape : recentOf(env)) {
    const std::string id = "recent" + std::to_string(recent++);
    if (grid.section(id.c_str(), "In model", *shape, *shape == chosen)) {
      choose(env, *shape);
    }
  }
  if (!env.ui().layout.strip) {
    grid.place();
    commandTile(env, "edit-slice", grid.size());
  }
  ImGui::PopStyleVar();
  if (chosen.drawn() && !env.ui().sections.board) ownSection(env, chosen);
  if (part) sectionKeyBar(env, width);
}

}  // namespace spineloft::panels
