// How tall the model is, in the panel and beside the solid, and whether it can be printed.
#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "engine/publish/publish.h"
#include "web/commands/intents.h"
#include "web/model/print_report.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"
#include "web/ui/sizing.h"

namespace spineloft::panels {
namespace {

/// The nearest round height above or below.
double nextHeight(double mm, int direction) {
  constexpr double kSteps[] = {1, 2, 5, 10, 20, 30, 40, 50, 60, 80, 100, 120, 150, 200, 300, 500, 1000, 2000};
  if (direction > 0) {
    const double* above = std::upper_bound(std::begin(kSteps), std::end(kSteps), mm + 1e-9);
    return above == std::end(kSteps) ? mm : *above;
  }
  const double* below = std::lower_bound(std::begin(kSteps), std::end(kSteps), mm - 1e-9);
  return below == std::begin(kSteps) ? mm : *(below - 1);
}

void howTall(const PanelEnv& env, float width) {
  const double mm = env.document().height.value;
  const bool can = app::enabled(app::commandOf("set-height"), env.env);
  const float side = buttonSide(env);
  const auto step = [&](int direction) { env.sink.run(app::setHeight, nextHeight(mm, direction)); };
  if (iconButton(env, {"lower", "minus", "Smaller", false, can, side})) step(-1);
  ImGui::SameLine(0, 4);
  const std::string text = app::roundLength(mm);
  commandText(env, {"set-height", std::max(60.f, width - 2 * side - 8), false, asIs(text)});
  ImGui::SameLine(0, 4);
  if (iconButton(env, {"higher", "plus", "Taller", false, can, side})) step(+1);
}

/// As tall as something that everybody knows; a second press takes it away from the solid again.
void likeThings(const PanelEnv& env, float width) {
  const auto known = app::things();
  const float gap = 6, wide = (width - gap * 2) / 3;
  const double mm = env.document().height.value;
  for (std::size_t i = 0; i < known.size(); ++i) {
    if (i > 0) ImGui::SameLine(0, gap);
    const app::Thing& thing = known[i];
    const std::string_view tip = words::tr(thing.tall, {{"length", app::spokenLength(thing.mm)}});
    const bool on = env.ui().beside == i;
    const auto paint = [i](ImDrawList& list, ImVec2 centre, float radius, ImU32 colour) {
      for (const auto& line : app::thingLines(i)) {
        list.PathClear();
        for (const app::ThingPoint p : line) {
          list.PathLineTo(
              {centre.x + 2 * radius * static_cast<float>(p.x), centre.y + radius * static_cast<float>(1 - 2 * p.y)});
        }
        list.PathStroke(colour, 0, 1.5f);
      }
    };
    const bool pressed = tile(env, {thing.key.data(), thing.label, asIs(tip), {wide, 60}, on}, paint);
    if (!pressed || env.document().parts.empty()) continue;
    if (on && mm == thing.mm) {
      env.sink.run(app::showBeside, std::nullopt);
    } else {
      env.sink.run(app::sizeLike, i);
    }
  }
}

/// A sentence over as many lines as it needs, behind a green tick, or as a warning: by mark and by colour.
void reportLine(const PanelEnv& env, const app::PrintLine& line, float width) {
  constexpr float kMark = 26;  // with the gap beside it
  const float left = ImGui::GetCursorPosX();
  label(env.fonts.icons, line.good ? kGood : kWarning, asIs(iconText(line.good ? "circle-check" : "triangle-alert")));
  ImGui::SameLine(0, 0);
  // Written from the right, the mark stands at the right.
  ImGui::SetCursorPosX(words::language().rightToLeft ? left : left + kMark);
  ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - kMark);
  label(env.fonts.small, line.good ? kInk : kWarning, asIs(line.text));
  ImGui::PopTextWrapPos();
  const app::Command* fix = line.fix.empty() ? nullptr : app::findCommand(line.fix);
  if (fix == nullptr) return;
  commandText(env, {fix->id, width, true});
}

void printing(const PanelEnv& env, float width) {
  const std::optional<app::PrintReport>& report = env.ui().print;
  const bool fresh = report && report->of == env.document();
  bool& seen = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("seen"));
  const bool news = !std::exchange(seen, fresh) && fresh;
  // It stays where it was pressed: nothing else comes under the pointer.
  commandText(env, {"check-print", width});
  if (!fresh) return;
  for (const app::PrintLine& line : app::printLines(*report)) reportLine(env, line, width);
  // What mends it stands below, where a panel often ends.
  if (news) ImGui::SetScrollHereY(1);
}

struct Words {
  ImVec2 at;  ///< middle of their upper edge
  std::string text;
};

void words(const PanelEnv& env, ImDrawList& list, const Words& what) {
  ImFont* font = env.fonts.small;
  const std::string_view text = shown(asIs(what.text));
  const ImVec2 extent = extentOf(font, text);
  const ImVec2 at{what.at.x - extent.x / 2, what.at.y};
  list.AddRectFilled({at.x - 8, at.y - 3}, {at.x + extent.x + 8, at.y + extent.y + 3}, faded(kSurface, 225), 12);
  drawLine(list, {font, at, kMuted}, text);
}

/// A thing beside the solid, both in true proportion.
void drawThing(const PanelEnv& env, ImDrawList& list, const pipeline::WorldBounds& bounds) {
  const app::UiState& ui = env.ui();
  const app::Thing& thing = app::things()[*ui.beside];
  const app::ThingPlace place = app::placeBeside(thing, bounds, env.document().height.value, ui.camera);
  const auto at = [&](app::ThingPoint p) -> std::optional<ImVec2> {
    const auto c = app::pointOnCanvas(ui.camera, ui.layout.solid, place.at(p));
    if (!c) return std::nullopt;
    return ImVec2{static_cast<float>(c->x), static_cast<float>(c->y)};
  };
  for (const auto& line : app::thingLines(*ui.beside)) {
    for (const auto& [colour, width] : {std::pair{faded(kSurface, 200), 5.f}, {kMuted, 2.f}}) {
      list.PathClear();
      for (const app::ThingPoint p : line) {
        if (const auto c = at(p)) list.PathLineTo(*c);
      }
      list.PathStroke(colour, 0, width);
    }
  }
  if (const auto foot = at({0, 0})) {
    const std::string_view text = words::tr(thing.beside, {{"length", app::spokenLength(thing.mm)}});
    words(env, list, {{foot->x, foot->y + 8}, std::string(text)});
  }
}

}  // namespace

void sizePanel(const PanelEnv& env, float width) {
  if (env.ui().layout.strip && width >= 640) {
    const float half = (width - 24) / 2;
    ImGui::BeginGroup();
    howTall(env, half);
    likeThings(env, half);
    ImGui::EndGroup();
    ImGui::SameLine(0, 24);
    ImGui::BeginGroup();
    printing(env, half);
    ImGui::EndGroup();
    return;
  }
  howTall(env, width);
  likeThings(env, width);
  ImGui::Dummy({0, 2});
  printing(env, width);
}

void drawScale(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const app::Rect& view = ui.layout.solid;
  if (!ui.beside || view.width < 60 || view.height < 60) return;
  const std::optional<pipeline::WorldBounds> bounds = publish::worldBounds(env.document(), env.derived);
  if (!bounds) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  drawThing(env, list, *bounds);
  list.PopClipRect();
}

}  // namespace spineloft::panels
