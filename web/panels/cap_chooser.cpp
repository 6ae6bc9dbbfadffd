// How the two ends of a part are finished.
#include <imgui.h>

#include <cmath>
#include <string>

#include "engine/sections/ends.h"
#include "web/commands/intents.h"
#include "web/edit/editing.h"
#include "web/edit/placing.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

/// A part cut lengthwise, with its end on the left (`direction` −1) or on the right (+1).
void paintCap(ImDrawList& list, sections::CapStyle style, ImVec2 c, float r, float direction, ImU32 colour) {
  const float tail = c.x - direction * r, h = r * 0.62f;
  const float neck = c.x + direction * r * 0.25f, tip = c.x + direction * r;
  list.PathClear();
  list.PathLineTo({tail, c.y - h});
  switch (style) {
    case sections::CapStyle::Flat:
    case sections::CapStyle::Open:
      list.PathLineTo({tip - direction * 2, c.y - h});
      list.PathLineTo({tip - direction * 2, c.y + h});
      break;
    case sections::CapStyle::Round: {
      list.PathLineTo({neck, c.y - h});
      const float sweep = r * 0.75f;
      for (int i = 1; i < 12; ++i) {
        const float a = 3.14159265f * static_cast<float>(i) / 12;
        list.PathLineTo({neck + direction * sweep * std::sin(a), c.y - h * std::cos(a)});
      }
      list.PathLineTo({neck, c.y + h});
      break;
    }
    case sections::CapStyle::Pointed:
      list.PathLineTo({neck - direction * 3, c.y - h});
      list.PathLineTo({tip, c.y});
      list.PathLineTo({neck - direction * 3, c.y + h});
      break;
    case sections::CapStyle::kCount:
      break;
  }
  list.PathLineTo({tail, c.y + h});
  list.PathStroke(colour, ImDrawFlags_None, 1.8f);
  if (style == sections::CapStyle::Open) {
    list.AddEllipse({tip - direction * 2, c.y}, r * 0.3f, h, colour, 0, 20, 1.8f);
  }
}

void row(const PanelEnv& env, bool atStart, sections::CapStyle chosen, float width) {
  const float direction = atStart ? -1.f : 1.f;
  const float gap = 6;
  const ImVec2 size{std::floor(std::min((width - 3 * gap) / 4, 84.f)), env.ui().layout.strip ? 44.f : 52.f};
  ImGui::PushID(atStart ? "start" : "end");
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {gap, gap});
  bool first = true;
  for (const sections::CapName& name : sections::capNames()) {
    if (!first) ImGui::SameLine();
    first = false;
    const std::string key(name.key);
    const auto paint = [&](ImDrawList& list, ImVec2 centre, float radius, ImU32 colour) {
      paintCap(list, name.style, centre, radius, direction, colour);
    };
    const Text text = size.y < 50 ? Text("") : Text(name.label);
    const char* where = atStart ? words::text("where you began") : words::text("where you stopped");
    const std::string control = std::string(name.label) + ", " + where;
    if (tile(env, {key.c_str(), text, name.label, size, name.style == chosen, control}, paint)) {
      const std::optional<sections::CapStyle> cap = name.style, same;
      env.sink.run(app::setCaps, app::selectedParts(env.document(), env.ui()), atStart ? cap : same,
                   atStart ? same : cap);
    }
  }
  ImGui::PopStyleVar();
  ImGui::PopID();
}

}  // namespace

void capChooser(const PanelEnv& env, float width) {
  const document::Part* part = env.selected();
  const auto own = part ? app::capsOf(*part) : std::nullopt;
  const auto [start, end] = own.value_or(app::EndCaps{env.ui().startCap, env.ui().endCap});
  if (env.ui().layout.strip) {
    const float half = (width - 24) / 2;
    if (half < 240) {
      row(env, true, start, width);
      row(env, false, end, width);
    } else {
      ImGui::BeginGroup();
      label(env.fonts.small, kMuted, "Where you began");
      row(env, true, start, half);
      ImGui::EndGroup();
      ImGui::SameLine(0, 24);
      ImGui::BeginGroup();
      label(env.fonts.small, kMuted, "Where you stopped");
      row(env, false, end, half);
      ImGui::EndGroup();
    }
    return;
  }
  label(env.fonts.small, kMuted, "Where you began");
  row(env, true, start, width);
  label(env.fonts.small, kMuted, "Where you stopped");
  row(env, false, end, width);
}

}  // namespace spineloft::panels
