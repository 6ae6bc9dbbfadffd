// The shelf of slices: each preset drawn as it will be lofted.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/loft/section.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

constexpr int kOutlinePoints = 40;
constexpr std::size_t kPresets = static_cast<std::size_t>(loft::SectionPreset::kCount);

const std::vector<SectionPoint>& outlineOf(loft::SectionPreset preset) {
  static const auto outlines = [] {
    std::array<std::vector<SectionPoint>, kPresets> out;
    for (const loft::SectionName& name : loft::sectionNames()) {
      Result<loft::Section> section = loft::presetSection(name.preset, kOutlinePoints);
      if (section) out[static_cast<std::size_t>(name.preset)] = section.value().points;
    }
    return out;
  }();
  return outlines[static_cast<std::size_t>(preset)];
}

void paintSection(ImDrawList& list, loft::SectionPreset preset, ImVec2 centre, float radius,
                  ImU32 colour) {
  float low = 1, high = -1;
  for (const SectionPoint p : outlineOf(preset)) {
    low = std::min(low, static_cast<float>(p.y));
    high = std::max(high, static_cast<float>(p.y));
  }
  const float middle = (low + high) / 2;
  list.PathClear();
  for (const SectionPoint p : outlineOf(preset)) {
    list.PathLineTo({centre.x + static_cast<float>(p.x) * radius,
                     centre.y - (static_cast<float>(p.y) - middle) * radius});
  }
  list.PathStroke(colour, ImDrawFlags_Closed, 1.8f);
}

}  // namespace

void sectionChooser(const PanelEnv& env, float width) {
  const document::Part* part = env.selected();
  const loft::SectionShape& chosen =
      part ? part->recipe.loft.sections.front().shape : env.ui().section;
  const bool strip = env.ui().layout.strip;
  const float gap = 6;
  const int columns = strip ? (width < app::kFlatStripFrom - 20 ? 6 : 12) : 3;
  const float side = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  const float oneRow = std::clamp(ImGui::GetContentRegionAvail().y - 4, 44.f, 76.f);
  const ImVec2 size{std::floor(std::min(side, 92.f)),
                    strip ? (columns == 12 ? oneRow : 47.f) : 60.f};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  int index = 0;
  for (const loft::SectionName& name : loft::sectionNames()) {
    if (index++ % columns != 0) ImGui::SameLine();
    const std::string key(name.key);
    const auto paint = [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 colour) {
      paintSection(list, name.preset, centre, radius, colour);
    };
    const std::string_view text = size.y < 50 ? std::string_view() : name.label;
    if (tile(env, {key.c_str(), text, name.label, size, !chosen.drawn() && name.preset == chosen.preset}, paint)) {
      env.sink.run("set-section", app::Json::Object{{"section", name.key}});
    }
  }
  ImGui::PopStyleVar();
}

}  // namespace spineloft::panels
