// What *Scoop out* would open: the rim and the way out of it, over the solid.
#include <imgui.h>

#include <cmath>
#include <optional>

#include "web/panels/panels.h"
#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

constexpr float kArrow = 54;  // CSS pixels

/// A thick arrow from `from` in a direction of the screen.
void arrow(ImDrawList& list, ImVec2 from, ImVec2 way) {
  const ImVec2 tip{from.x + way.x * kArrow, from.y + way.y * kArrow}, side{-way.y, way.x};
  const ImVec2 neck{tip.x - way.x * 16, tip.y - way.y * 16};
  for (const auto& [colour, width] : {std::pair{faded(kHalo, 235), 9.f}, {kAccent, 5.f}}) {
    list.AddLine(from, neck, colour, width);
    const float half = width + 5;
    list.AddTriangleFilled({tip.x + way.x * (width - 5), tip.y + way.y * (width - 5)},
                           {neck.x + side.x * half, neck.y + side.y * half},
                           {neck.x - side.x * half, neck.y - side.y * half}, colour);
  }
}

}  // namespace

void drawHollowOverlay(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  if (!ui.solids.hollow) return;
  const std::optional<app::Mouth>& mouth = env.mouth.of(env.document(), env.derived, *ui.solids.hollow);
  if (!mouth) return;
  const app::Rect& view = ui.layout.solid;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const auto at = [&](const WorldPoint& p) { return app::pointOnCanvas(ui.camera, view, p); };
  const auto vec = [](app::ClientPoint p) { return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y)); };
  for (const auto& [colour, width] : {std::pair{faded(kHalo, 235), 7.f}, {kAccent, 3.5f}}) {
    for (const auto& [a, b] : mouth->rim) {
      const auto from = at(a), to = at(b);
      if (from && to) list.AddLine(vec(*from), vec(*to), colour, width);
    }
  }
  const auto middle = at(mouth->at), beyond = at(mouth->at + mouth->out * 0.05);
  if (middle && beyond) {
    const app::ClientPoint way = *beyond - *middle;
    const double length = norm(way);
    // Towards the eye there is no way on the screen: a ring says so.
    if (length > 2) {
      arrow(list, vec(*middle), vec(way * (1 / length)));
    } else {
      list.AddCircle(vec(*middle), 12, faded(kHalo, 235), 32, 9);
      list.AddCircle(vec(*middle), 12, kAccent, 32, 5);
    }
  }
  list.PopClipRect();
}

}  // namespace spineloft::panels
