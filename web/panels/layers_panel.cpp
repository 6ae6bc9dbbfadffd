// What is set for a whole part made of layers, in the place of the section.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "web/commands/intents.h"
#include "web/edit/drawn_rail.h"
#include "web/edit/free_layers.h"
#include "web/edit/layer_joints.h"
#include "web/edit/layer_settings.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/panels/number_text.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

using document::StackRecipe;

struct Setting {
  const char* id = "";
  Text words;
  double low = 0, high = 1;
  double factor = 1;  ///< times what is shown
  const char* shown = "{n}";
  int digits = 0;
};

class Settings {
 public:
  Settings(const PanelEnv& env, const document::Part& part, float width)
      : env_(env), part_(part), layers_(*document::stackOf(part)), width_(width) {
    const document::PictureEntry* entry = document::findPicture(env.document(), layers_.picture);
    if (entry != nullptr) side_ = std::max(entry->size.width, entry->size.height);
    mm_ = app::mmPerUnit(env.document(), env.derived) / side_;
  }

  void way() {
    if (layers_.rail.points.empty() && layers_.planes.size() < 2) return;
    label(env_.fonts.small, kMuted, "Line of the layers");
    WordButtons buttons(env_, width_);
    const auto now = app::railShapeOf(layers_.rail);
    const bool hasRail = !layers_.rail.points.empty(), drawn = app::drawsRail(env_.document(), env_.ui());
    for (const app::RailShapeName& name : app::kRailShapes) {
      const bool on = now == name.shape && !drawn;
      if (hasRail && buttons.button(name.label.data(), name.label, on) && !on) {
        keep(app::withRail(layers_, name.shape));
      }
    }
    if (layers_.planes.size() > 1 && buttons.button("middles", "Through the middles", false)) {
      env_.sink.run(app::followMiddles, part_.id);
    }
    if (hasRail && buttons.button("draw-rail", "Draw it", drawn || !now)) env_.sink.run(app::drawRail, part_.id);
  }

  /// What becomes of lines that stay open.
  void openLines() {
    using stack::CurveUse;
    const auto now = app::openLinesOf(layers_);
    const auto sheet = now ? app::sheetFor(env_.document(), part_.id, {}, std::nullopt) : std::nullopt;
    if (!sheet) return;
    label(env_.fonts.small, kMuted, "Open lines");
    WordButtons buttons(env_, width_);
    for (const auto& [use, text] : {std::pair{CurveUse::Ribbon, "Walls"}, {CurveUse::Ground, "Ground"}}) {
      if (buttons.button(text, text, now == use) && now != use) {
        keep(app::withOpenLines(layers_, use, app::newWallOf(*sheet)));
      }
    }
  }

  /// Of the sheet that is seen: as its knobs do it.
  void leaning() {
    const auto sheet = app::shownSheet(env_.document(), env_.ui());
    if (!sheet || sheet->part != part_.id || !sheet->onRail()) return;
    const app::Lean lean = app::leanOf(*sheet);
    struct Way {
      double app::Lean::* of;
      const char *id, *words;
    };
    for (const auto& [way, id, words] : {Way{&app::Lean::front, "##lean-front", "Sheet leans to the front"},
                                         {&app::Lean::side, "##lean-side", "Sheet leans to the side"}}) {
      const auto turn = [&, way](double degrees) {
        app::Lean changed = lean;
        changed.*way = degrees;
        return app::turnFor(*sheet, changed);
      };
      const double most = app::mostLean(*sheet, way);
      const Setting what{id, words, -most, most, 1, "{n}°", 0};
      app::Sheet seen = *sheet;
      if (sheet->layer) seen.turn = app::turnOf(*sheet, shown().planes[*sheet->layer]);
      double chosen = 0;
      const SliderTurn moved = slide(what, app::leanOf(seen).*way, chosen);
      if (moved.changed && sheet->layer) preview(app::withTurn(*sheet, turn(chosen)));
      if (moved.changed && !sheet->layer) env_.ui().layers.turn = turn(chosen);
      if (!moved.done || !sheet->layer) continue;
      env_.ui().preview.reset();
      env_.sink.run(app::leanSheet, turn(chosen));
    }
  }

  /// Whether the layer on the sheet stands on the line, and where it is off it.
  void place() {
    const auto sheet = app::shownSheet(env_.document(), env_.ui());
    if (!sheet || sheet->part != part_.id || !sheet->onRail() || !sheet->layer) return;
    commandText(env_, {"layer-free", width_});
    if (!sheet->isFree() || !(mm_ > 0)) return;
    const app::Offset now = app::offsetOf(*sheet, shown().planes[*sheet->layer]);
    struct Way {
      double app::Offset::* of;
      const char *id, *words;
    };
    for (const auto& [way, id, words] : {Way{&app::Offset::side, "##off-side", "Layer to the side"},
                                         {&app::Offset::front, "##off-front", "Layer to the front"},
                                         {&app::Offset::ahead, "##off-ahead", "Layer along the line"}}) {
      const double most = std::max(side_, std::abs(app::offsetOf(*sheet, layers_.planes[*sheet->layer]).*way));
      number({id, words, -most, most, mm_, "{n} mm", 1}, now.*way, [&, way](double value) {
        app::Offset moved = app::offsetOf(*sheet, layers_.planes[*sheet->layer]);
        moved.*way = value;
        return app::withOffset(*sheet, moved);
      });
    }
  }

  void between() {
    using sections::BlendKind;
    if (layers_.planes.size() < 2) return;
    label(env_.fonts.small, kMuted, "From layer to layer");
    WordButtons buttons(env_, width_);
    const auto now = app::blendOf(layers_);
    for (const auto& [kind, text] :
         {std::pair{BlendKind::Flow, "Smooth"}, {BlendKind::Linear, "Straight"}, {BlendKind::Hold, "In steps"}}) {
      if (buttons.button(text, text, now == kind) && now != kind) keep(app::withBlend(layers_, kind));
    }
  }

  /// Of the forks beside the sheet that is seen.
  void forks() {
    const auto sheet = app::shownSheet(env_.document(), env_.ui());
    if (!sheet || sheet->part != part_.id) return;
    const app::LayerJoints joints = app::jointsOf(env_.document(), env_.derived, env_.ui(), *sheet);
    if (joints.forks.empty()) return;
    number({"##fork", "Where it forks", 0, 1, 100, "{n} %", 0}, joints.forks.front().at, [&](double value) {
      StackRecipe changed = layers_;
      for (const app::LayerFork& fork : joints.forks) changed = app::withFork(changed, fork, value);
      return changed;
    });
  }

  void numbers() {
    if (const auto times = app::repeatsOf(layers_)) {
      const double most = std::max<double>(app::kMostRepeats, *times);
      number({"##times", "Times", 1, most, 1, "{n}", 0}, app::repeatsOf(shown()).value_or(*times),
             [&](double value) { return app::withRepeats(layers_, static_cast<std::uint32_t>(std::lround(value))); });
    }
    if (!(mm_ > 0)) return;  // nothing to measure by
    if (const auto wall = app::wallOf(layers_)) {
      number({"##wall", "Wall", std::min(1.0, *wall), std::max(0.2 * side_, *wall), mm_, "{n} mm", 1},
             app::wallOf(shown()).value_or(*wall), [&](double value) { return app::withWalls(layers_, value); });
    }
    const stack::Rough rough = layers_.stack.rough, now = shown().stack.rough;
    number({"##bumps", "Lumps", 0, std::max(0.1 * side_, rough.amount), mm_, "{n} mm", 1}, now.amount,
           [&](double value) {
             stack::Rough changed = rough;
             changed.amount = value;
             return app::withBumps(layers_, changed);
           });
    if (!(rough.amount > 0)) return;
    number({"##bump-size", "Size of lumps", std::min(0.01 * side_, rough.size), std::max(0.4 * side_, rough.size), mm_,
            "{n} mm", 1},
           now.size, [&](double value) {
             stack::Rough changed = rough;
             changed.size = value;
             return app::withBumps(layers_, changed);
           });
    if (textButton(env_, {"other-bumps", "Other lumps", false, true, buttonSide(env_), width_})) {
      stack::Rough changed = rough;
      ++changed.seed;
      keep(app::withBumps(layers_, changed));
    }
  }

 private:
  void keep(const StackRecipe& recipe) { env_.sink.run(app::remakeLayers, part_.id, recipe); }

  /// As a slider in hand makes it, else as it is.
  const StackRecipe& shown() const {
    const app::Preview* preview = app::previewOf(env_.ui(), part_.id);
    const auto* held = preview ? std::get_if<StackRecipe>(&preview->recipe) : nullptr;
    return held ? *held : layers_;
  }

  void preview(StackRecipe recipe) {
    app::Preview& changed = app::previewPart(env_.ui(), part_);
    changed.recipe = std::move(recipe);
    changed.fresh = false;
  }

  /// Shows what it would do and does it when it is let go.
  template <class Change>
  void number(const Setting& what, double now, const Change& change) {
    double chosen = now;
    const SliderTurn turn = slide(what, now, chosen);
    if (turn.changed) preview(change(chosen));
    if (!turn.done) return;
    env_.ui().preview.reset();
    keep(change(chosen));
  }

  SliderTurn slide(const Setting& what, double now, double& chosen) {
    auto value = static_cast<float>(now * what.factor);
    label(env_.fonts.small, kMuted, what.words);
    ImGui::SetNextItemWidth(width_);
    const std::string text = numberText(what.shown, static_cast<double>(value), what.digits);
    const auto low = static_cast<float>(what.low * what.factor), high = static_cast<float>(what.high * what.factor);
    const SliderTurn turn = slider(env_, {what.id, what.words.words, low, high, text.c_str(), false}, value);
    chosen = std::clamp(static_cast<double>(value) / what.factor, what.low, what.high);
    return turn;
  }

  const PanelEnv& env_;
  const document::Part& part_;
  const StackRecipe& layers_;
  float width_;
  double side_ = 1, mm_ = 0;  ///< of the picture, pixels; millimetres of one
};

}  // namespace

void layersPanel(const PanelEnv& env, const document::Part& part, float width) {
  Settings settings(env, part, width);
  settings.way();
  settings.leaning();
  settings.place();
  settings.openLines();
  settings.between();
  settings.forks();
  settings.numbers();
  slicesToCopy(env, width);
  commandText(env, {"fly-along", width});
}

}  // namespace spineloft::panels
