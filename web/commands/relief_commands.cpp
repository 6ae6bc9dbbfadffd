// Commands about reliefs: detail that a picture gives to the front of a part.
#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using relief::Relief;

bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
/// Of the part in hand.
const std::optional<Relief>* reliefInHand(Env env) {
  const document::Part* part = document::findPart(env.studio.document(), env.ui.selection);
  return part ? &part->relief : nullptr;
}
bool hasRelief(Env env) {
  const std::optional<Relief>* relief = reliefInHand(env);
  return relief && *relief;
}

void modeChoices(Env env, JsonWriter& json) {
  const std::optional<Relief>* now = reliefInHand(env);
  writeChoice(json, "none", "None", now && !*now);
  for (int i = 0; i < static_cast<int>(relief::Mode::kCount); ++i) {
    const auto mode = static_cast<relief::Mode>(i);
    writeChoice(json, relief::modeKey(mode), labelOf(mode), now && *now && (*now)->mode == mode);
  }
}

/// What `args` say of the picture that is laid on a part; false: there is no such picture.
bool takeLaid(Env env, const Json& args, const document::Part& part, Relief& relief) {
  if (const Json* from = args.find("from")) {
    if (from->isNull()) {
      relief.laid.reset();
    } else {
      const PictureId id{idFrom(args, "from").value};
      if (document::findPicture(env.studio.document(), id) == nullptr) return false;
      if (id == document::pictureOf(part)) {
        relief.laid.reset();
      } else if (!relief.laid) {
        relief.laid = usualLaid(env, part, id);
      } else {
        relief.laid->picture = id;
      }
    }
  }
  if (!relief.laid) return true;
  relief.laid->at = pointOf(args, "at").value_or(relief.laid->at);
  relief.laid->width = args.number("width").value_or(relief.laid->width);
  relief.laid->turn = args.number("turn").value_or(relief.laid->turn);
  return true;
}

Outcome reliefRow(Env env, const Json& args) {
  const std::optional<Parts> parts = meantParts(env, args);
  if (!parts || parts->empty()) return noPart();
  const std::string* told = args.text("mode");
  const relief::Mode named = told ? relief::modeFromKey(*told) : relief::Mode::kCount;
  if (told && named == relief::Mode::kCount && *told != "none")
    return missing("what becomes a relief: none, ink, bright or shade");
  constexpr std::array kNumbers = {"height", "smooth", "region", "from", "at", "width", "turn"};
  const bool changes = std::ranges::any_of(kNumbers, [&](const char* key) { return args.find(key) != nullptr; });
  const bool some = std::ranges::any_of(*parts, [&](PartId id) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    return part != nullptr && part->relief;
  });
  const bool off = told ? *told == "none" : !changes && some;
  std::vector<ReliefOf> all;
  for (const PartId id : *parts) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    if (part == nullptr) return noPart();
    if (off) {
      all.push_back({id, std::nullopt});
      continue;
    }
    Relief relief = part->relief.value_or(Relief{});
    if (named != relief::Mode::kCount) relief.mode = named;
    relief.height = args.number("height").value_or(relief.height);
    relief.smooth = args.number("smooth").value_or(relief.smooth);
    if (args.find("region") != nullptr) {
      const auto region = linesOf(args, "region");
      if (!region) return missing("a region: closed lines of points [x, y] of the picture");
      relief.region = *region;
    }
    if (!takeLaid(env, args, *part, relief)) return refuse({Error::NoSuchPicture, {}});
    const bool places = args.find("at") || args.find("width") || args.find("turn");
    if (places && !relief.laid)
      return missing("a picture that is laid on the part (from): at, width and turn place it");
    all.push_back({id, std::move(relief)});
  }
  if (!off) {
    env.ui.folded &= ~(1u << static_cast<unsigned>(PanelTab::Relief));
    env.ui.tab = PanelTab::Look;
  }
  return setReliefs(env, all);
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "relief", .label = "Relief", .icon = "stamp", .group = "look", .argument = {"mode", modeChoices},
            .hint = "What the picture shows stands out of the part: its lines, its brightness or its shading",
            .enabled = hasParts, .toggled = hasRelief, .run = reliefRow},
};
// clang-format on

}  // namespace

std::string_view labelOf(relief::Mode mode) {
  switch (mode) {
    case relief::Mode::Ink:
      return "Strokes";
    case relief::Mode::Bright:
      return "Bright";
    case relief::Mode::Shade:
    case relief::Mode::kCount:
      break;
  }
  return "Shade";
}

relief::Laid usualLaid(Env env, const document::Part& part, PictureId picture) {
  const auto& parts = env.studio.derived().parts;
  const auto made = std::ranges::find(parts, part.id, &pipeline::DerivedPart::id);
  const document::PictureEntry* own = document::findPicture(env.studio.document(), document::pictureOf(part));
  const document::PictureEntry* laid = document::findPicture(env.studio.document(), picture);
  relief::Laid usual{picture, {}};
  if (made == parts.end() || !made->shape || own == nullptr || laid == nullptr) return usual;
  // As it is seen at rest.
  std::array<float, 2> low{1, 1}, high{0, 0};
  for (const auto& uv : made->shape->mesh.uv) {
    for (const std::size_t k : {0, 1}) {
      low[k] = std::min(low[k], uv[k]);
      high[k] = std::max(high[k], uv[k]);
    }
  }
  const double width = own->size.width, height = own->size.height;
  usual.at = {(low[0] + high[0]) / 2 * width - 0.5, (low[1] + high[1]) / 2 * height - 0.5};
  const double wide = (high[0] - low[0]) * width, tall = (high[1] - low[1]) * height;
  const double share = std::min(wide, tall * laid->size.width / laid->size.height) / 2;
  usual.width = std::clamp(share, relief::kLeastWidth, relief::kMostWidth);
  return usual;
}

Outcome setReliefs(Env env, const std::vector<ReliefOf>& reliefs) {
  std::vector<document::Action> actions;
  for (const auto& [part, relief] : reliefs) actions.push_back(document::SetRelief{part, relief});
  return outcomeOf(env.studio.act(actions));
}

std::span<const Command> reliefCommands() { return kTable; }

}  // namespace spineloft::app
