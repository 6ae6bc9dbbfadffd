// Commands about what goes along a part, bone or rail: its slices, and the view.
#include <array>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/edit/copied_slices.h"
#include "web/edit/fly_along.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr double kFlightMs = 6000;

const document::Part* chosen(Env env) { return document::findPart(env.studio.document(), env.ui.selection); }
bool canCopy(Env env) { return chosen(env) && hasSlices(*chosen(env)); }
/// The sheet of the next part is in hand.
bool beginsLayers(Env env) { return env.ui.tool == ToolKind::Layers && !layersInHand(env.studio.document(), env.ui); }
bool canPaste(Env env) {
  const document::Part* part = chosen(env);
  if (!env.ui.sections.copied) return false;
  return part && (document::stackOf(*part) || document::loftOf(*part)) ? true : beginsLayers(env);
}
bool canFly(Env env) { return chosen(env) && hasWay(*chosen(env)); }
bool isFlying(Env env) { return env.ui.fliesAlong(); }

Outcome noWay() { return Refusal{"NotNow", "This part has no bone and no line of layers."}; }

Outcome copySlices(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  if (!hasSlices(*part)) return noWay();
  auto slices = slicesOf(env.studio.document(), env.studio.derived(), part->id);
  if (!slices) return refuse(slices.failure());
  env.ui.sections.copied = std::move(slices).value();
  sendStatus(env.host, "Slices copied. Select another part and paste them, or start new layers from them.");
  return {};
}

Outcome pasteSlices(Env env, const Json& args) {
  if (!env.ui.sections.copied) return Refusal{"NotNow", "Nothing is copied yet: copy the slices of a part first."};
  const pipeline::Slices& slices = *env.ui.sections.copied;
  const document::Part* part = partOf(env, args);
  const auto* layers = part ? document::stackOf(*part) : nullptr;
  if (layers != nullptr) {
    const auto made = withSlices(*layers, slices);
    return made ? keepLayers(env, part->id, made.value(), made.value().planes.back().at) : refuse(made.failure());
  }
  if (!namesPart(args) && beginsLayers(env)) {
    const auto sheet = sheetFor(env.studio.document(), {}, env.ui.picture, std::nullopt);
    if (!sheet) return refuse({Error::NoSuchPicture, {}});
    const document::StackRecipe made = newWithSlices(*sheet, slices);
    return keepLayers(env, {}, made, made.planes.back().at);
  }
  if (part == nullptr) return noPart();
  if (document::loftOf(*part) == nullptr) return noWay();
  if (!slices.onBone) return refuse(slices.onBone.failure());
  return outcomeOf(env.studio.act(document::SetSections{part->id, slices.onBone.value()}));
}

Outcome flyAlong(Env env, const Json& args) {
  if (isFlying(env)) {
    env.ui.camera = env.ui.flight->to;
    env.ui.flight.reset();
    return {};
  }
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  if (!hasWay(*part)) return noWay();
  if (!part->visible) return refuse({Error::StackInvalid, "it is hidden: show it first"});
  if (env.host.reducedMotion()) {
    return Refusal{"NotNow", "This device asks for less motion, so the view stays where it is."};
  }
  auto by = camerasAlong(env.studio.document(), env.studio.derived(), env.ui, part->id);
  if (by.empty()) return noWay();
  env.ui.focus = Focus::Solid;
  env.ui.flight = CameraFlight{env.ui.camera, env.ui.camera, env.host.nowMs(), kFlightMs, std::move(by)};
  return {};
}

constexpr Condition kCanCopy{canCopy, Condition::Part}, kCanFly{canFly, Condition::Part},
    kCanPaste{canPaste, Condition::Part};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "copy-slices", .label = "Copy slices", .icon = "copy", .group = "slice",
            .hint = "Copies the slices of this part, to paste them on another one", .enabled = kCanCopy, .run = copySlices},
    Command{.id = "paste-slices", .label = "Paste slices", .icon = "clipboard-paste", .group = "slice",
            .hint = "Puts the copied slices on this part, or begins new layers with them", .enabled = kCanPaste,
            .run = pasteSlices},
    Command{.id = "fly-along", .label = "Fly along", .icon = "route", .group = "view",
            .hint = "The view travels along the bone, or along the line of the layers", .enabled = kCanFly,
            .toggled = isFlying, .run = flyAlong},
};
// clang-format on

}  // namespace

std::span<const Command> alongCommands() { return kTable; }

}  // namespace spineloft::app
