// *Scoop out* in two steps: what would become hollow and where it opens are shown and can be changed, then it is done.
#include <algorithm>
#include <array>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/hollowing.h"
#include "web/edit/solid_editing.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using document::CombineParts;
using document::Operand;

bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool isShown(Env env) { return env.ui.solids.hollow.has_value(); }
/// There is something else that could be.
bool hasOther(Env env) { return isShown(env) && hasSeveralRoots(env.studio.document()); }

Outcome nothingToHollow() {
  return Refusal{"NotNow", "There is nothing to scoop out: what is in sight is hollow already."};
}

void close(Env env) {
  env.ui.solids.hollow.reset();
  sendStatus(env.host, {});
}

Outcome show(Env env, Operand what) {
  env.ui.solids.hollow = hollowOf(env, what);
  env.ui.solids.pointing = false;
  env.ui.focus = Focus::Solid;
  env.ui.tab = PanelTab::Parts;
  sendStatus(env.host, "Tap the solid where it is to open, or tap another part. Then press Make it hollow.");
  return {};
}

/// What the arguments say of it; an opening without a depth is as deep as is usual there.
Outcome readDraft(Env env, const Json& args, CombineParts& draft) {
  Outcome read = readHollow(env, args, draft.wall, draft.opening);
  if (read && args.text("opening") && !args.number("depth")) draft.opening.depth = usualDepth(env, draft);
  return read;
}

Outcome showHollow(Env env, const Json& args) {
  const std::vector<Operand> all = hollowable(env);
  const Operand what = namedRoot(env, args).value_or(all.empty() ? Operand{} : all.front());
  if (std::ranges::find(all, what) == all.end()) return nothingToHollow();
  CombineParts draft = hollowOf(env, what);
  if (Outcome read = readDraft(env, args, draft); !read) return read;
  const Outcome shown = show(env, what);
  env.ui.solids.hollow = std::move(draft);
  return shown;
}

Outcome nextHollow(Env env, const Json&) {
  // In the order of the list: that of the likeliest changes with what is chosen.
  const std::vector<Operand> all = hollowable(env);
  std::vector<Operand> roots = rootsOf(env.studio.document());
  std::erase_if(roots, [&](Operand each) { return std::ranges::find(all, each) == all.end(); });
  if (roots.empty()) return nothingToHollow();
  auto at = std::ranges::find(roots, env.ui.solids.hollow->operands.front());
  if (at == roots.end() || ++at == roots.end()) at = roots.begin();
  return show(env, *at);
}

Outcome openHollowRow(Env env, const Json& args) {
  if (args.text("opening") == nullptr) return missing("an opening");
  CombineParts draft = *env.ui.solids.hollow;
  if (Outcome read = readDraft(env, args, draft); !read) return read;
  env.ui.solids.hollow = std::move(draft);
  return {};
}

Outcome useHollow(Env env, const Json&) {
  Outcome made = makeSolid(env, *env.ui.solids.hollow);
  if (made) env.ui.solids.hollow.reset();
  return made;
}

Outcome cancelHollow(Env env, const Json&) {
  close(env);
  return {};
}

void openings(Env env, JsonWriter& json) {
  const auto& draft = env.ui.solids.hollow;
  writeOpenings(json, draft ? std::optional(draft->opening.side) : std::nullopt);
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "hollow-show", .label = "Scoop out", .icon = "cup-soda", .group = "part",
            .hint = "Shows what becomes hollow and where it opens, before it is done", .menu = "Together",
            .enabled = hasParts, .toggled = isShown, .run = showHollow},
    Command{.id = "hollow-use", .label = "Make it hollow", .icon = "check", .shortcut = "Enter", .group = "part",
            .hint = "What is lit becomes hollow, open at the arrow", .enabled = isShown, .run = useHollow,
            .mode = &kHollowMode},
    Command{.id = "hollow-next", .label = "Another part", .icon = "arrow-right", .group = "part",
            .hint = "Something else becomes hollow", .enabled = hasOther, .run = nextHollow},
    Command{.id = "hollow-open", .label = "Opening of what is scooped out", .icon = "crosshair", .group = "part",
            .argument = {"opening", openings}, .hint = "Where it will open", .enabled = isShown, .run = openHollowRow},
    Command{.id = "hollow-cancel", .label = "Not this", .icon = "x", .group = "part",
            .hint = "Leaves everything as it was", .enabled = isShown, .run = cancelHollow},
};
// clang-format on

}  // namespace

Outcome tapHollow(Env env, PartId part, WorldPoint way) {
  if (!isShown(env)) return Refusal{"NotNow", "Nothing is being scooped out."};
  CombineParts& draft = *env.ui.solids.hollow;
  if (becomesHollow(env.studio.document(), env.ui, part)) {
    return openHollow(env, sideOf(env, draft, way));
  }
  const document::Step* root = rootOf(env.studio.document(), {part, {}});
  const Operand what = root != nullptr ? Operand{{}, root->id} : Operand{part, {}};
  const std::vector<Operand> all = hollowable(env);
  return std::ranges::find(all, what) == all.end() ? nothingToHollow() : show(env, what);
}

Outcome openHollow(Env env, document::OpeningSide side) {
  if (!isShown(env)) return {};
  CombineParts& draft = *env.ui.solids.hollow;
  draft.opening.side = side;
  draft.opening.depth = usualDepth(env, draft);
  return {};
}

constinit const Mode kHollowMode{"scoop-out", isShown, close};

std::span<const Command> hollowCommands() { return kTable; }

}  // namespace spineloft::app
