// The numbers of a puff or a flat piece, in the place of the section.
#include <imgui.h>

#include <algorithm>
#include <string>

#include "engine/document/params.h"
#include "web/commands/intents.h"
#include "web/edit/preview.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

/// A slider that shows what it would do and does it when it is let go.
void slider(const PanelEnv& env, const document::Part& part, const document::ParamInfo& info, float width) {
  const app::Preview* preview = app::previewOf(env.ui(), part.id);
  const bool mine = preview && document::kindOf(preview->recipe) == document::kindOf(part);
  auto value = static_cast<float>(info.get(mine ? preview->recipe : part.recipe));
  label(env.fonts.small, kMuted, info.label);
  ImGui::SetNextItemWidth(width);
  const std::string id = "##" + std::string(info.key);
  const bool whole = info.step >= 1;
  const bool changed =
      ImGui::SliderFloat(id.c_str(), &value, static_cast<float>(info.low), static_cast<float>(info.high),
                         whole ? "%.0f" : "%.2f", info.low > 0 ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None);
  registerControl(env, app::Control::Kind::Slider, info.label);
  if (changed) {
    app::Preview& shown = app::previewPart(env.ui(), part);
    shown.recipe = part.recipe;
    info.set(shown.recipe, std::clamp(static_cast<double>(value), info.low, info.high));
    shown.fresh = false;
  }
  if (!ImGui::IsItemDeactivatedAfterEdit()) return;
  const double chosen = std::clamp(static_cast<double>(value), info.low, info.high);
  env.ui().preview.reset();
  env.sink.run(app::setParameter, part.id, std::string(info.key), chosen);
}

}  // namespace

void regionPanel(const PanelEnv& env, const document::Part& part, float width) {
  const bool isInflated = document::inflateOf(part) != nullptr;
  constexpr float kGap = 6;
  const float each = (width - 2 * kGap) / 3, height = env.ui().layout.strip ? 44.f : 54.f;
  constexpr app::CommandId kSides[] = {"puff-both", "puff-front", "puff-back"},
                           kEdges[] = {"edge-sharp", "edge-bevel", "edge-round"};
  for (int i = 0; i < 3; ++i) {
    if (i > 0) ImGui::SameLine(0, kGap);
    commandTile(env, isInflated ? kSides[i] : kEdges[i], {each, height});
  }
  for (const document::ParamInfo& info : document::paramTable(document::kindOf(part))) {
    slider(env, part, info, width);
  }
  const app::CommandId other = isInflated ? app::CommandId("make-sheet") : app::CommandId("make-puff");
  wordButton(env, {other, width, buttonSide(env), kAccent});
}

}  // namespace spineloft::panels
