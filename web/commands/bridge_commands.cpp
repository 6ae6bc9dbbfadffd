// Commands about bridges: tubes that join places of parts.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/bridging.h"
#include "web/edit/placing.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using document::BridgeRecipe;
using document::Operand;

constexpr double kWider = 1.25;  // a step

bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool bridgeTool(Env env) { return env.ui.tool == ToolKind::Bridge; }
/// The selected bridge, or null. Asked in every frame: without memory.
const document::Part* chosenBridge(Env env) {
  const document::Part* part = document::findPart(env.studio.document(), env.ui.selection);
  return part && document::bridgeOf(*part) ? part : nullptr;
}

Outcome useBridge(Env env) {
  env.ui.tool = ToolKind::Bridge;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.focus = Focus::Solid;
  sendStatus(env.host, "Drag from one place of the solid to another: a bridge joins them. Drag its ends to move them.");
  return {};
}

/// What stands alone and is, or holds, each of the parts that a bridge joins; and the bridge, which is the next part.
document::CombineParts joinedWith(const document::Document& document, const BridgeRecipe& recipe) {
  document::CombineParts join;
  for (const PartId id : {recipe.from.part, recipe.to.part}) {
    const document::Step* root = document::rootOf(document, {id, {}});
    const Operand operand = root ? Operand{{}, root->id} : Operand{id, {}};
    if (std::ranges::count(join.operands, operand) == 0) join.operands.push_back(operand);
  }
  join.operands.push_back({PartId{document.lastPartId + 1}, {}});
  return join;
}

/// Why a recipe makes no bridge, so that it is refused before it is kept.
Status checkMade(Env env, const BridgeRecipe& recipe) {
  pipeline::PartShape shape;
  return env.studio.preview(recipe, {}, shape);
}

Outcome setEnds(Env env, PartId id, const BridgeRecipe& recipe, std::string_view burst) {
  if (const Status made = checkMade(env, recipe); !made) return refuse(made.failure());
  const document::Action action = document::SetBridgeEnds{id, recipe.from, recipe.to};
  return outcomeOf(env.studio.act({&action, 1}, burst));
}

Outcome widen(Env env, double factor) {
  const document::Part* part = chosenBridge(env);
  if (part == nullptr) {
    double& next = env.ui.edit.bridgeWidth;
    next = std::clamp(next * factor, kLeastBridgeWidth, kMostBridgeWidth);
    sendStatus(env.host, words::tr("The next bridge is {n} % as wide as usual.", {{"n", std::round(100 * next)}}));
    return {};
  }
  BridgeRecipe recipe = *document::bridgeOf(*part);
  widenBridge(recipe, factor);
  return setEnds(env, part->id, recipe, "widen bridge " + std::to_string(part->id.value));
}
Outcome wider(Env env, const Json&) { return widen(env, kWider); }
Outcome narrower(Env env, const Json&) { return widen(env, 1 / kWider); }

Refusal touching() { return {"NotNow", "These parts touch already. Press Stick to make one solid of them."}; }

/// Between the two parts in hand, where they are nearest.
Outcome bridgeBetween(Env env, PartId from, PartId to) {
  constexpr double kTouch = 0.005;
  const auto facing = facingPlaces(env.studio.document(), env.studio.derived(), from, to);
  if (!facing) return Refusal{"NotNow", "A bridge joins two parts that are shown and are no bridges themselves."};
  if (facing->gap < kTouch) return touching();
  return drawBridge(env, usualBridge(env.studio.document(), facing->from, facing->to, env.ui.edit.bridgeWidth));
}

/// {part, at} under `key`.
std::optional<BridgePlace> placeFrom(Env env, const Json& args, std::string_view key) {
  const Json* told = args.find(key);
  const Json* at = told ? told->find("at") : nullptr;
  const document::Part* part = told ? document::findPart(env.studio.document(), idFrom(*told, "part")) : nullptr;
  const auto& parts = env.studio.derived().parts;
  const auto made = std::ranges::find(parts, part ? part->id : PartId{}, &pipeline::DerivedPart::id);
  if (at == nullptr || part == nullptr || made == parts.end() || !made->shape) return std::nullopt;
  const auto place = placeOf(made->shape->mesh, *at, told->flag("back").value_or(false));
  return place ? bridgePlaceOn(env.studio.document(), env.studio.derived(), part->id, *place) : std::nullopt;
}

Outcome bridgeRow(Env env, const Json& args) {
  if (args.find("from") != nullptr || args.find("to") != nullptr) {
    const auto from = placeFrom(env, args, "from"), to = placeFrom(env, args, "to");
    if (!from || !to) return missing("two places (from, to): {part, at: [x, y] of the picture, or [x, y, z]}");
    BridgeRecipe recipe =
        usualBridge(env.studio.document(), *from, *to, args.number("width").value_or(env.ui.edit.bridgeWidth));
    recipe.bridge.waist = args.number("waist").value_or(recipe.bridge.waist);
    recipe.bridge.bow = args.number("bow").value_or(recipe.bridge.bow);
    return drawBridge(env, recipe);
  }
  auto meant = meantParts(env, args);
  if (!meant) return noPart();
  if (const auto& ticked = env.ui.solids.picked; ticked.size() == 2 && args.find("parts") == nullptr) {
    meant = {{ticked[0].part, ticked[1].part}};
  }
  const auto isHost = [&](PartId id) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    return part != nullptr && document::bridgeOf(*part) == nullptr;
  };
  const bool named = args.find("parts") != nullptr;
  if (meant->size() == 2 && (named || std::ranges::all_of(*meant, isHost))) {
    return bridgeBetween(env, (*meant)[0], (*meant)[1]);
  }
  return useBridge(env);
}

constexpr Argument kFrom{"from"};
constexpr Condition kHasParts{hasParts}, kTool{bridgeTool};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "bridge", .label = "Bridge", .icon = "cable", .shortcut = "Shift+J", .group = "tool", .argument = kFrom,
            .hint = "A tube from one place of the solid to another; of two parts in hand, where they are nearest",
            .enabled = kHasParts, .toggled = bridgeTool, .run = bridgeRow},
    Command{.id = "bridge-narrower", .label = "Narrower", .icon = "fold-vertical", .shortcut = "[", .group = "part",
            .hint = "The bridge is narrower, or the next one", .enabled = kTool, .run = narrower,
            .mode = &kBridgeToolMode},
    Command{.id = "bridge-wider", .label = "Wider", .icon = "unfold-vertical", .shortcut = "]", .group = "part",
            .hint = "The bridge is wider, or the next one", .enabled = kTool, .run = wider, .mode = &kBridgeToolMode},
};
// clang-format on

}  // namespace

Outcome drawBridge(Env env, const BridgeRecipe& asked) {
  // Where there is no room for one of the usual width, a narrower one may fit.
  constexpr int kNarrower = 4;
  BridgeRecipe recipe = asked;
  Status made = checkMade(env, recipe);
  for (int i = 0; i < kNarrower && !made.ok() && made.error() == Error::BridgeInvalid; ++i) {
    widenBridge(recipe, 1 / kWider);
    made = checkMade(env, recipe);
  }
  if (!made.ok()) return refuse(made.failure());
  const document::Document& document = env.studio.document();
  const document::Look look = bridgeLook(document, env.studio.derived(), recipe.from.part);
  const std::vector<document::Action> actions{document::DrawBridge{recipe.from, recipe.to, recipe.bridge, look},
                                              joinedWith(document, recipe)};
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  env.ui.tool = ToolKind::Bridge;
  env.ui.focus = Focus::Solid;
  env.ui.selection = env.studio.document().parts.back()->id;
  env.ui.alsoSelected.clear();
  env.ui.solids.picked.clear();
  env.ui.redraw = {};
  sendStatus(env.host, "The bridge joins them in one solid. Drag its ends to move them.");
  return {};
}

Outcome refuseBridge(Env env, PartId from) {
  const document::Part* part = document::findPart(env.studio.document(), from);
  if (part != nullptr && document::bridgeOf(*part) != nullptr) return refuse({Error::HostIsBridge, {}});
  return Refusal{"NotNow", "A bridge ends on the solid. Drag from one place of it to another."};
}

Outcome moveBridgeEnd(Env env, PartId id, int end, const document::BridgeEnd& to) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr) return noPart();
  if (document::bridgeOf(*part) == nullptr) return refuse({Error::NotABridge, {}});
  BridgeRecipe recipe = *document::bridgeOf(*part);
  (end == 0 ? recipe.from : recipe.to) = to;
  return setEnds(env, id, recipe, {});
}

std::span<const Command> bridgeCommands() { return kTable; }

constinit const Mode kBridgeToolMode{"bridge-tool", bridgeTool};

}  // namespace spineloft::app
