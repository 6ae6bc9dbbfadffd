// Commands about what is set for a whole part made of layers.
#include <algorithm>
#include <array>
#include <cmath>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/edit/layer_settings.h"
#include "web/edit/layers.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

const document::StackRecipe* chosen(Env env) { return layersInHand(env.studio.document(), env.ui); }
bool hasLayers(Env env) { return chosen(env) != nullptr; }
bool canRepeat(Env env) { return hasLayers(env) && repeatsOf(*chosen(env)); }
bool hasWalls(Env env) { return hasLayers(env) && wallOf(*chosen(env)); }
bool hasOpenLines(Env env) { return hasLayers(env) && openLinesOf(*chosen(env)); }

/// Of the part that is meant.
template <class Change>
Outcome setLayers(Env env, const Json& args, const Change& change) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  const document::StackRecipe* layers = document::stackOf(*part);
  if (layers == nullptr) return refuse({Error::NotAStack, {}});
  const Result<document::StackRecipe> changed = change(*layers);
  return changed ? remakeLayers(env, part->id, changed.value()) : refuse(changed.failure());
}
using Changed = Result<document::StackRecipe>;

/// `points`: [x, y, z] in picture pixels from the picture's corner, y up, z to the viewer.
Outcome railThrough(Env env, const Json& args, const Json& points) {
  stack::Rail rail{{}, args.flag("closed").value_or(false)};
  const Json::Array* list = points.array();
  for (const Json& point : list ? *list : Json::Array()) {
    const Json::Array* p = point.array();
    if (p == nullptr || p->size() != 3 || !(*p)[0].number() || !(*p)[1].number() || !(*p)[2].number()) {
      return missing("points: a list of [x, y, z] in picture pixels");
    }
    rail.points.push_back({*(*p)[0].number(), *(*p)[1].number(), *(*p)[2].number()});
  }
  if (rail.points.size() < 2) return missing("points: two or more [x, y, z] in picture pixels");
  if (!stack::isValid(rail)) return refuse({Error::ValueOutOfRange, "points"});
  return setLayers(env, args, [&](const document::StackRecipe& layers) -> Changed {
    if (layers.rail.points.empty()) return {Error::StackInvalid, kNoRail};
    return withRail(layers, rail);
  });
}

Outcome railRow(Env env, const Json& args) {
  if (const Json* points = args.find("points")) return railThrough(env, args, *points);
  const std::string* key = args.text("rail");
  if (key == nullptr)
    return missing("a rail: \"up\", \"across\", \"deep\", \"ring\", \"spring\", \"middles\" or \"draw\"");
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  if (*key == "draw") return drawRail(env, part->id);
  if (*key == "middles") return followMiddles(env, part->id);
  const auto name = std::ranges::find(kRailShapes, *key, &RailShapeName::key);
  if (name == kRailShapes.end()) return refuse({Error::ValueOutOfRange, *key});
  return setLayers(env, args, [&](const document::StackRecipe& layers) -> Changed {
    if (layers.rail.points.empty()) return {Error::StackInvalid, kNoRail};
    return withRail(layers, name->shape);
  });
}

Outcome repeatRow(Env env, const Json& args) {
  const double times = args.number("times").value_or(0);
  if (!(times >= 1 && times <= stack::kMostTimes && times == std::floor(times))) {
    return missing("how often: a whole number from 1 on (times)");
  }
  return setLayers(env, args, [&](const document::StackRecipe& layers) -> Changed {
    if (!repeatsOf(layers))
      return {Error::StackInvalid, "two layers or more on a rail can be repeated: draw another one"};
    return withRepeats(layers, static_cast<std::uint32_t>(times));
  });
}

Outcome blendRow(Env env, const Json& args) {
  const std::string* key = args.text("blend");
  if (key == nullptr) return missing("a blend: \"flow\", \"linear\" or \"hold\"");
  const auto kind = sections::blendFromKey(*key);
  if (!kind || *kind == sections::BlendKind::Custom) return refuse({Error::ValueOutOfRange, *key});
  return setLayers(env, args, [&](const document::StackRecipe& layers) -> Changed { return withBlend(layers, *kind); });
}

Outcome bumpsRow(Env env, const Json& args) {
  return setLayers(env, args, [&](const document::StackRecipe& layers) -> Changed {
    stack::Rough rough = layers.stack.rough;
    rough.amount = args.number("amount").value_or(rough.amount);
    rough.size = args.number("size").value_or(rough.size);
    rough.keepDrawn = args.flag("keepDrawn").value_or(rough.keepDrawn);
    const double seed = args.number("seed").value_or(rough.seed);
    if (!(seed >= 0 && seed <= 0xffffffff && std::floor(seed) == seed)) return {Error::ValueOutOfRange, "seed"};
    rough.seed = static_cast<std::uint32_t>(seed);
    return withBumps(layers, rough);
  });
}

Outcome openLinesRow(Env env, const Json& args) {
  const std::string* key = args.text("as");
  if (key == nullptr) return missing("what open lines become: \"wall\" or \"ground\"");
  if (*key != "wall" && *key != "ground") return refuse({Error::ValueOutOfRange, *key});
  return setLayers(env, args, [&](const document::StackRecipe& layers) -> Changed {
    if (!openLinesOf(layers))
      return {Error::StackInvalid, "no line of its layers is open: draw one that does not close"};
    const auto sheet = sheetFor(env.studio.document(), partOf(env, args)->id, {}, std::nullopt);
    return withOpenLines(layers, *key == "wall" ? stack::CurveUse::Ribbon : stack::CurveUse::Ground,
                         sheet ? newWallOf(*sheet) : 1);
  });
}

Outcome wallRow(Env env, const Json& args) {
  const double width = args.number("width").value_or(0);
  if (!(width > 0)) return missing("a width in picture pixels, above 0");
  return setLayers(env, args, [&](const document::StackRecipe& layers) -> Changed {
    if (!wallOf(layers)) return {Error::StackInvalid, "it has no wall: draw a line that stays open"};
    return withWalls(layers, width);
  });
}

constexpr Argument kAs{"as"}, kRail{"rail"}, kTimes{"times"}, kBlend{"blend"}, kAmount{"amount"}, kWidth{"width"};
constexpr Condition kHasLayers{hasLayers, Condition::Part}, kCanRepeat{canRepeat, Condition::Part},
    kHasWalls{hasWalls, Condition::Part}, kHasOpenLines{hasOpenLines, Condition::Part};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "layer-rail", .label = "Line of the layers", .icon = "spline", .group = "part", .argument = kRail,
            .hint = "Layers stand up, side by side, round a ring, along a spring or a line of your own",
            .enabled = kHasLayers, .run = railRow},
    Command{.id = "layer-open-lines", .label = "Open lines", .icon = "spline", .group = "part", .argument = kAs,
            .hint = "Lines that stay open become walls or ground", .enabled = kHasOpenLines, .run = openLinesRow},
    Command{.id = "layer-repeat", .label = "Repeat layers", .icon = "copy", .group = "part", .argument = kTimes,
            .hint = "All layers once more, and once more", .enabled = kCanRepeat, .run = repeatRow},
    Command{.id = "layer-blend", .label = "From layer to layer", .icon = "spline", .group = "part", .argument = kBlend,
            .hint = "Layers become each other smoothly, straight or in steps", .enabled = kHasLayers, .run = blendRow},
    Command{.id = "layer-bumps", .label = "Lumps", .icon = "waypoints", .group = "part", .argument = kAmount,
            .hint = "An uneven surface, as of rock or bark", .enabled = kHasLayers, .run = bumpsRow},
    Command{.id = "layer-wall", .label = "Width of walls", .icon = "ruler", .group = "part", .argument = kWidth,
            .hint = "How wide open lines are", .enabled = kHasWalls, .run = wallRow},
};
// clang-format on

}  // namespace

std::span<const Command> layerSettingCommands() { return kTable; }

}  // namespace spineloft::app
