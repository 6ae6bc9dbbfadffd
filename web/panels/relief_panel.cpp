// The relief of the part in hand: what of the picture it comes from, how high and how smooth it is, and where a picture
// lies that is laid on the part.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "web/commands/intents.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/panels/number_text.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

using relief::Relief;

/// Its height counts into the part, that of the others out of it.
bool isInk(const Relief& relief) { return relief.mode == relief::Mode::Ink; }

/// `change` on the reliefs of all parts in hand.
template <class Change>
void changeAll(const PanelEnv& env, const Change& change) {
  std::vector<app::ReliefOf> all;
  for (const PartId id : app::selectedParts(env.document(), env.ui())) {
    const document::Part* part = document::findPart(env.document(), id);
    if (part != nullptr) all.push_back({id, change(*part)});
  }
  env.sink.run(app::setReliefs, all);
}

void modes(const PanelEnv& env, const document::Part& part, float width) {
  std::array<Choice, 1 + static_cast<std::size_t>(relief::Mode::kCount)> choices;
  choices[0] = {"relief-none", "None", !part.relief};
  for (std::size_t i = 1; i < choices.size(); ++i) {
    const auto mode = static_cast<relief::Mode>(i - 1);
    choices[i] = {relief::modeKey(mode).data(), app::labelOf(mode), part.relief && part.relief->mode == mode};
  }
  const auto pressed = pill(env, choices, width);
  if (!pressed) return;
  changeAll(env, [&](const document::Part& each) -> std::optional<Relief> {
    if (*pressed == 0) return std::nullopt;
    Relief changed = each.relief.value_or(Relief{});
    changed.mode = static_cast<relief::Mode>(*pressed - 1);
    return changed;
  });
}

/// A number of a relief: how it is shown, times a factor, and where it is.
struct Number {
  const char* id;
  const char* label;
  const char* words;         ///< what a screen reader says
  const char *text, *below;  ///< of values below 0, which are shown without their sign; null: as the others
  double factor, low, high;
  double& (*of)(Relief& relief);
  bool ofLaid = false;  ///< of the picture on this part, and of no other one in hand
};

/// A slider that shows what it would do and does it when it is let go.
void slider(const PanelEnv& env, const document::Part& part, const Number& number, float width) {
  const app::Preview* preview = app::previewOf(env.ui(), part.id);
  // What a preview shows may be of another time.
  const bool isOfNow = preview && preview->relief && preview->relief->laid.has_value() == part.relief->laid.has_value();
  Relief relief = isOfNow ? *preview->relief : *part.relief;
  auto value = static_cast<float>(number.of(relief) * number.factor);
  label(env.fonts.small, kMuted, number.label);
  ImGui::SetNextItemWidth(width);
  const bool isBelow = number.below != nullptr && value < 0;
  const auto size = static_cast<double>(isBelow ? -value : value);
  const std::string shown = numberText(isBelow ? number.below : number.text, size, 1);
  const auto [low, high] = std::minmax({number.low * number.factor, number.high * number.factor});
  const SliderTurn turn = panels::slider(
      env, {number.id, number.words, static_cast<float>(low), static_cast<float>(high), shown.c_str()}, value);
  const double now = std::clamp(static_cast<double>(value) / number.factor, number.low, number.high);
  if (turn.changed) {
    app::Preview& changed = app::previewPart(env.ui(), part);
    number.of(relief) = now;
    changed.relief = relief;
    changed.fresh = false;
  }
  if (!turn.done) return;
  env.ui().preview.reset();
  changeAll(env, [&](const document::Part& each) -> std::optional<Relief> {
    std::optional<Relief> changed = each.relief;
    if (!changed || (number.ofLaid && each.id != part.id)) return changed;
    const bool turnsAbout = number.below != nullptr && isInk(*changed) != isInk(*part.relief);
    number.of(*changed) = turnsAbout ? -now : now;
    return changed;
  });
}

/// The picture that gives the relief: the part's own, or one that is laid on it.
void pictures(const PanelEnv& env, const document::Part& part, float width) {
  const PictureId own = document::pictureOf(part);
  const PictureId now = part.relief->laid ? part.relief->laid->picture : own;
  label(env.fonts.small, kMuted, "Picture");
  for (const auto& entry : env.document().pictures) {
    const bool on = entry->id == now;
    const std::string id = "from-" + std::to_string(entry->id.value);
    const std::string_view said = words::tr("Relief from {name}", {{"name", words::nameOf(entry->name)}});
    const Choice choice{id.c_str(), asIs(words::nameOf(entry->name)), on, said};
    if (!pill(env, {&choice, 1}, width)) continue;
    changeAll(env, [&](const document::Part& each) -> std::optional<Relief> {
      std::optional<Relief> changed = each.relief;
      if (!changed) return changed;
      changed->laid.reset();
      if (entry->id != document::pictureOf(each)) changed->laid = app::usualLaid(env.env, each, entry->id);
      return changed;
    });
  }
}

/// Where the picture lies that is laid on it.
void place(const PanelEnv& env, const document::Part& part, image::Size size, float width) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  const double wide = size.width, high = size.height;
  const std::array laid{
      Number{"##across", "Left to right", "Picture on the part: left to right", "{n} %", nullptr, 100 / wide, 0, wide,
             [](Relief& relief) -> double& { return relief.laid->at.x; }, true},
      Number{"##down", "Top to bottom", "Picture on the part: top to bottom", "{n} %", nullptr, 100 / high, 0, high,
             [](Relief& relief) -> double& { return relief.laid->at.y; }, true},
      Number{"##size", "Size", "Picture on the part: size", "{n} %", nullptr, 100 / wide, relief::kLeastWidth, wide,
             [](Relief& relief) -> double& { return relief.laid->width; }, true},
      Number{"##turn", "Turn", "Picture on the part: turn", "{n}°", nullptr, kDegrees, -relief::kMostTurn,
             relief::kMostTurn, [](Relief& relief) -> double& { return relief.laid->turn; }, true},
  };
  for (const Number& number : laid) slider(env, part, number, width);
}

/// What a relief has besides.
void numbers(const PanelEnv& env, const document::Part& part, float width) {
  const document::PictureEntry* entry = document::findPicture(env.document(), document::pictureOf(part));
  // To the right is out of the part, whatever becomes of what.
  const bool ink = isInk(*part.relief);
  const std::array whole{
      Number{"##height", "Height", "Height of the relief", "{n} % out", "{n} % in", ink ? -100.0 : 100.0,
             -relief::kMostHeight, relief::kMostHeight, [](Relief& relief) -> double& { return relief.height; }},
      Number{"##smooth", "Smoothness", "Smoothness of the relief", "{n} %", nullptr, 100, 0, 1,
             [](Relief& relief) -> double& { return relief.smooth; }},
  };
  for (const Number& number : whole) slider(env, part, number, width);
  if (env.document().pictures.size() > 1) pictures(env, part, width);
  if (part.relief->laid && entry != nullptr) place(env, part, entry->size, width);
  const auto made = std::ranges::find(env.derived.parts, part.id, &pipeline::DerivedPart::id);
  if (made != env.derived.parts.end() && made->wantedRelief) {
    label(env.fonts.small, kMuted, "The relief is being made");
  }
}

}  // namespace

void reliefPanel(const PanelEnv& env, float width) {
  const document::Part& part = *env.selected();
  ImGui::PushID("relief");
  modes(env, part, width);
  if (part.relief) numbers(env, part, width);
  ImGui::PopID();
}

}  // namespace spineloft::panels
