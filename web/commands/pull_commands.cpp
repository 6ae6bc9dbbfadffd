// Commands about pulls: their tool, lines on a part, and the pull that is chosen.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

#include "engine/geometry/polyline.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/bumping.h"
#include "web/edit/picker.h"
#include "web/edit/pulling.h"
#include "web/edit/redrawn_outline.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using Pulls = std::vector<pull::Pull>;

constexpr double kWider = 1.25;                  // of the radius, a step
constexpr double kStep = 0.1, kFineStep = 0.02;  // of the radius: of the height, a step
constexpr double kFinest = 0.03;                 // of the way that was asked for, where not all of it can be gone
constexpr double kLeastStep = 0.25;              // picture pixels

bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool pullTool(Env env) { return env.ui.tool == ToolKind::Pull; }
/// The part in hand has pulls. Asked in every frame: without memory.
const document::Part* pulledInHand(Env env) {
  const document::Part* part = pullTool(env) ? document::findPart(env.studio.document(), env.ui.selection) : nullptr;
  return part && !part->pulls.empty() ? part : nullptr;
}
bool hasPulls(Env env) { return pulledInHand(env) != nullptr; }
/// The chosen pull; −1: none.
int chosenPull(Env env) {
  const document::Part* part = pulledInHand(env);
  const int count = part ? static_cast<int>(part->pulls.size()) : 0;
  return env.ui.chosen.pull < count ? env.ui.chosen.pull : -1;
}
bool pullIsChosen(Env env) { return chosenPull(env) >= 0; }
/// Of the chosen pull, else of the next one.
bool isSharp(Env env) {
  const int number = chosenPull(env);
  return number >= 0 ? pulledInHand(env)->pulls[static_cast<std::size_t>(number)].crease : env.ui.edit.pullSharp;
}

Outcome usePull(Env env) {
  env.ui.tool = ToolKind::Pull;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.focus = Focus::Solid;
  const document::Document& document = env.studio.document();
  if (!document::findPart(document, env.ui.selection)) env.ui.selection = document.parts.back()->id;
  env.ui.alsoSelected.clear();
  sendStatus(env.host, "Tap the solid, or draw a line or a ring on it: it bulges there. Drag the knob out or in.");
  return {};
}

/// What the part with these pulls makes of the one that is new or another: all of its way, less because it would go
/// through itself, or nothing there follows. All as well while the part has no shape of its own yet: that is looked at
/// when it has.
enum class Way : std::uint8_t { All, Less, Nothing };
Way wayOf(Env env, const document::Part& part, const Pulls& pulls, std::size_t changed) {
  const auto& parts = env.studio.derived().parts;
  const auto now = std::ranges::find(parts, part.id, &pipeline::DerivedPart::id);
  pipeline::PartShape made;
  if (now == parts.end() || !now->shape || now->waiting || !env.studio.preview(part.recipe, {pulls}, made))
    return Way::All;
  if (changed >= made.pulled.size() || made.pulled[changed].share == 1) return Way::All;
  return made.pulled[changed].points.empty() ? Way::Nothing : Way::Less;
}
bool goesAllTheWay(Env env, const document::Part& part, const Pulls& pulls, std::size_t changed) {
  return wayOf(env, part, pulls, changed) == Way::All;
}

/// Where a new pull starts from.
pull::Pull unmoved(pull::Pull pull) {
  pull.height = 0;
  for (const auto& [line, to] : {std::pair(&pull.line, &pull.to), {&pull.across, &pull.acrossTo}}) {
    if (to->size() > 1 && line->size() > 1) *to = geometry::resample(std::span<const ModelPoint>(*line), to->size());
  }
  return pull;
}

Refusal noFurther() { return {"NotNow", std::string(words::tr("Any further, and it would go through itself"))}; }

/// `changed`: the one that is new or another, as far on from what it was as the part does not go through itself. Says
/// so, else `hint`.
Outcome keepPulls(Env env, const document::Part& part, Pulls pulls, std::size_t changed, std::string_view hint = {},
                  std::string_view burst = {}) {
  const bool isNew = changed >= part.pulls.size();
  const pull::Pull asked = pulls[changed], from = isNew ? unmoved(asked) : part.pulls[changed];
  const Way way = wayOf(env, part, pulls, changed);
  if (way == Way::Nothing) {
    return Refusal{"NotNow", asked.ring.empty() ? "There is nothing to pull."
                                                : "There is too little room within the ring. Draw a larger one."};
  }
  const bool whole = way == Way::All;
  if (!whole) {
    double low = 0, high = 1;
    while (high - low > kFinest) {
      const auto tried = between(from, asked, (low + high) / 2);
      if (!tried) return noFurther();
      pulls[changed] = *tried;
      (goesAllTheWay(env, part, pulls, changed) ? low : high) = (low + high) / 2;
    }
    if (low == 0) return noFurther();
    pulls[changed] = *between(from, asked, low);
  }
  const document::Action action = document::SetPulls{part.id, std::move(pulls)};
  const Outcome kept = outcomeOf(env.studio.act({&action, 1}, burst));
  if (!kept) return kept;
  if (!whole) {
    sendStatus(env.host, words::tr("Any further, and it would go through itself"));
  } else if (!hint.empty()) {
    sendStatus(env.host, hint);
  }
  return kept;
}

/// What the chosen pull is changed to, as one step with those like it.
template <class Change>
Outcome changeChosen(Env env, std::string_view what, const Change& change) {
  const document::Part& part = *pulledInHand(env);
  const int number = chosenPull(env);
  Pulls pulls = part.pulls;
  change(pulls[static_cast<std::size_t>(number)]);
  const std::string burst = std::string(what) + " " + std::to_string(part.id.value) + " " + std::to_string(number);
  return keepPulls(env, part, std::move(pulls), static_cast<std::size_t>(number), {}, burst);
}

Outcome raise(Env env, const Json& args, double way) {
  const PulledPart shown = pulledPart(env.studio.document(), env.studio.derived(), env.ui);
  const auto number = static_cast<std::size_t>(chosenPull(env));
  if (!shown || number >= shown.pulls.size()) return noPart();
  const double share = args.flag("far").value_or(false) ? kFineStep : kStep;
  const double by = way * std::max(kLeastStep, share * shown.pulls[number].radius);
  const pipeline::PulledLine line = shown.shape->pulled[number];
  return changeChosen(env, "raise", [&](pull::Pull& pull) { pull = raised(pull, line, by); });
}
Outcome out(Env env, const Json& args) { return raise(env, args, 1); }
Outcome in(Env env, const Json& args) { return raise(env, args, -1); }

/// The width of the chosen pull, or that of the next one.
Outcome widen(Env env, double factor) {
  double& next = env.ui.edit.pullReach;
  if (!pullIsChosen(env)) {
    next = std::clamp(next * factor, kLeastPullReach, kMostPullReach);
    sendStatus(env.host, words::tr("The next pull reaches {n} % of the part.", {{"n", std::round(100 * next)}}));
    return {};
  }
  const PulledPart shown = pulledPart(env.studio.document(), env.studio.derived(), env.ui);
  const double size = shown ? sizeOf(*shown.shape) : 0;
  return changeChosen(env, "widen", [&](pull::Pull& pull) {
    if (!pull.ring.empty()) return widenBump(pull, factor, size);
    pull.radius = std::clamp(pull.radius * factor, pull::kLeastRadius, pull::kMostRadius);
  });
}
Outcome wider(Env env, const Json&) { return widen(env, kWider); }
Outcome narrower(Env env, const Json&) { return widen(env, 1 / kWider); }

Outcome sharp(Env env, const Json& args) {
  const bool on = args.flag("on").value_or(!isSharp(env));
  if (!pullIsChosen(env)) {
    env.ui.edit.pullSharp = on;
    return {};
  }
  return changeChosen(env, "sharp", [&](pull::Pull& pull) { pull.crease = on; });
}

Outcome step(Env env, int by) {
  const int count = static_cast<int>(pulledInHand(env)->pulls.size());
  const int before = chosenPull(env) < 0 ? (by > 0 ? -1 : 0) : chosenPull(env);
  env.ui.chosen = {};
  env.ui.chosen.pull = (before + by + count) % count;
  sendStatus(env.host, words::tr("Pull {n} of {all}", {{"n", env.ui.chosen.pull + 1}, {"all", count}}));
  return {};
}
Outcome next(Env env, const Json&) { return step(env, 1); }
Outcome previous(Env env, const Json&) { return step(env, -1); }

/// The one before is chosen then.
Outcome remove(Env env, const Json&) {
  const document::Part& part = *pulledInHand(env);
  const int number = chosenPull(env);
  Pulls pulls = part.pulls;
  pulls.erase(pulls.begin() + number);
  env.ui.chosen.pull = std::min(std::max(0, number - 1), static_cast<int>(pulls.size()) - 1);
  return outcomeOf(env.studio.act(document::SetPulls{part.id, std::move(pulls)}));
}

Refusal notInTheMiddle() { return {"NotNow", "The part is not in the middle of the view: turn or move it there."}; }

/// In the middle of the solid view, for those who use no pointer.
Outcome here(Env env, const Json&) {
  const PulledPart part = pulledPart(env.studio.document(), env.studio.derived(), env.ui);
  const Rect& view = env.ui.layout.solid;
  const Ray ray{env.ui.camera.eye(), rayThrough(env.ui.camera, view, view.centre())};
  const auto place = part ? surfaceUnder(part, ray) : std::nullopt;
  return place ? drawPull(env, env.ui.selection, {place->at}) : notInTheMiddle();
}
Outcome bumpHere(Env env, const Json&) {
  const PulledPart part = pulledPart(env.studio.document(), env.studio.derived(), env.ui);
  const std::vector<ModelPoint> ring = part ? circleInView(part, env.ui) : std::vector<ModelPoint>{};
  return ring.empty() ? notInTheMiddle() : drawBump(env, env.ui.selection, ring);
}

// ---- what programs say ------------------------------------------------------------------------------------------

/// Places as placeOf reads them. None: it is no list of them, or a place is beside the part.
std::optional<std::vector<ModelPoint>> placesFrom(const PulledPart& part, const Json& list, bool back) {
  if (list.array() == nullptr || list.array()->empty()) return std::nullopt;
  std::vector<ModelPoint> places;
  for (const Json& place : *list.array()) {
    const auto at = placeOf(part.shape->mesh, place, back);
    if (!at) return std::nullopt;
    places.push_back(*at);
  }
  return places;
}

Outcome missingLine(std::string_view what) {
  return missing(std::string(what) + ": places [x, y] of the picture on the part, or [x, y, z]");
}

/// The numbers of a pull that `args` name.
void takeNumbers(const Json& args, pull::Pull& pull) {
  pull.height = args.number("height").value_or(pull.height);
  pull.radius = args.number("radius").value_or(pull.radius);
  pull.crease = args.flag("crease").value_or(pull.crease);
}

Outcome pullRow(Env env, const Json& args) {
  const Json *line = args.find("line"), *ring = args.find("ring");
  if (line == nullptr && ring == nullptr) return usePull(env);
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  const PulledPart shown = pulledPartOf(env.studio.document(), env.studio.derived(), env.ui, part->id);
  if (!shown) return Refusal{"NotNow", "The part has no shape yet: wait, or show it."};
  const bool back = args.flag("back").value_or(false);
  pull::Pull made;
  if (ring != nullptr) {
    const auto round = placesFrom(shown, *ring, back);
    if (!round) return missingLine("a ring");
    if (round->size() < 3) return missingLine("a ring of three places or more");
    made = usualBump(env.ui.edit, *round, topOf(shown.shape->mesh, *round).value_or(round->front()));
  }
  if (line != nullptr) {
    const auto places = placesFrom(shown, *line, back);
    if (!places) return missingLine("a line");
    if (ring == nullptr) made = usualPull(shown, env.ui.edit, *places);
    made.line = *places;
  }
  const std::tuple<const char*, const char*, std::vector<ModelPoint>*> others[] = {
      {"to", "where it goes (to)", &made.to},
      {"across", "a line across", &made.across},
      {"acrossTo", "where that goes (acrossTo)", &made.acrossTo}};
  for (const auto& [name, what, list] : others) {
    const Json* told = args.find(name);
    if (told == nullptr) continue;
    const auto ends = placesFrom(shown, *told, back);
    if (!ends) return missingLine(what);
    *list = *ends;
  }
  takeNumbers(args, made);
  Pulls pulls = part->pulls;
  pulls.push_back(std::move(made));
  return keepPulls(env, *part, std::move(pulls), part->pulls.size());
}

Outcome setRow(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  const double number = args.number("pull").value_or(-1);
  if (!(number >= 0 && number < static_cast<double>(part->pulls.size()) && number == std::floor(number))) {
    return missing("a pull: the number of one of the part's, from 0");
  }
  Pulls pulls = part->pulls;
  const auto which = static_cast<std::size_t>(number);
  if (args.flag("remove").value_or(false)) {
    pulls.erase(pulls.begin() + static_cast<std::ptrdiff_t>(which));
    return outcomeOf(env.studio.act(document::SetPulls{part->id, std::move(pulls)}));
  }
  takeNumbers(args, pulls[which]);
  return keepPulls(env, *part, std::move(pulls), which);
}

/// One more pull, which is chosen.
Outcome addPull(Env env, const document::Part& part, pull::Pull made) {
  Pulls pulls = part.pulls;
  pulls.push_back(std::move(made));
  const std::size_t number = part.pulls.size();
  Outcome kept = keepPulls(env, part, std::move(pulls), number, words::tr("Drag the knob out or in."));
  if (!kept) return kept;
  env.ui.chosen = {};
  env.ui.chosen.pull = static_cast<int>(number);
  return kept;
}

constexpr Argument kLine{"line"}, kPull{"pull"};
constexpr Condition kHasParts{hasParts}, kHasPulls{hasPulls}, kChosen{pullIsChosen}, kTool{pullTool};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "pull", .label = "Pull", .icon = "mountain", .shortcut = "Shift+P", .group = "tool", .argument = kLine,
            .hint = "Tap the solid, or draw a line or a ring on it, and pull it out or push it in", .enabled = kHasParts,
            .toggled = pullTool, .run = pullRow},
    Command{.id = "pull-out", .label = "Further out", .icon = "chevron-up", .shortcut = "ArrowUp, Shift+ArrowUp",
            .group = "part", .hint = "The chosen pull goes further out", .enabled = kChosen, .run = out,
            .mode = &kPullMode},
    Command{.id = "pull-in", .label = "Further in", .icon = "chevron-down", .shortcut = "ArrowDown, Shift+ArrowDown",
            .group = "part", .hint = "The chosen pull goes further in", .enabled = kChosen, .run = in,
            .mode = &kPullMode},
    Command{.id = "pull-narrower", .label = "Narrower", .icon = "fold-vertical", .shortcut = "[", .group = "part",
            .hint = "Less of the surface follows the pull", .enabled = kTool, .run = narrower, .mode = &kPullToolMode},
    Command{.id = "pull-wider", .label = "Wider", .icon = "unfold-vertical", .shortcut = "]", .group = "part",
            .hint = "More of the surface follows the pull", .enabled = kTool, .run = wider, .mode = &kPullToolMode},
    Command{.id = "pull-sharp", .label = "Sharp edge", .icon = "chart-line", .shortcut = "E", .group = "part",
            .hint = "An edge along the line or the ring, or a smooth bulge", .enabled = kTool, .toggled = isSharp, .run = sharp,
            .mode = &kPullToolMode},
    Command{.id = "pull-here", .label = "Pull in the middle", .icon = "mountain", .shortcut = "Enter", .group = "part",
            .hint = "A pull in the middle of the solid view", .enabled = kTool, .run = here, .mode = &kPullToolMode},
    Command{.id = "bump-here", .label = "Bump in the middle", .icon = "circle-dot", .shortcut = "Shift+Enter",
            .group = "part", .hint = "A round bump in the middle of the solid view", .enabled = kTool, .run = bumpHere,
            .mode = &kPullToolMode},
    Command{.id = "pull-next", .label = "Next pull", .icon = "chevron-right", .shortcut = ".", .group = "part",
            .hint = "Choose the next pull of the part", .enabled = kHasPulls, .run = next, .mode = &kPullToolMode},
    Command{.id = "pull-previous", .label = "Pull before", .icon = "chevron-left", .shortcut = ",", .group = "part",
            .hint = "Choose the pull before", .enabled = kHasPulls, .run = previous, .mode = &kPullToolMode},
    Command{.id = "pull-remove", .label = "Remove pull", .icon = "trash-2", .shortcut = "Delete, Backspace",
            .group = "part", .hint = "Takes the chosen pull away", .enabled = kChosen, .run = remove,
            .mode = &kPullMode},
    Command{.id = "set-pull", .label = "Pull by numbers", .icon = "mountain", .group = "part", .argument = kPull,
            .hint = "Height, radius and edge of a pull", .enabled = kHasParts, .run = setRow},
};
// clang-format on

}  // namespace

Outcome drawPull(Env env, PartId part, const std::vector<ModelPoint>& line) {
  const PulledPart shown = pulledPartOf(env.studio.document(), env.studio.derived(), env.ui, part);
  if (!shown || line.empty()) return noPart();
  return addPull(env, *shown.part, usualPull(shown, env.ui.edit, line));
}

Outcome drawBump(Env env, PartId part, const std::vector<ModelPoint>& ring) {
  const PulledPart shown = pulledPartOf(env.studio.document(), env.studio.derived(), env.ui, part);
  if (!shown || ring.empty()) return noPart();
  const auto top = topOf(shown.shape->mesh, ring);
  if (top) return addPull(env, *shown.part, usualBump(env.ui.edit, ring, *top));
  return Refusal{"NotNow", "The part is not within the ring. Draw the ring round a place of the solid."};
}

Outcome redrawSeenOutline(Env env, PartId part, const std::vector<ClientPoint>& stroke, double reach) {
  const PulledPart shown = pulledPartOf(env.studio.document(), env.studio.derived(), env.ui, part);
  if (!shown) return noPart();
  const auto made = redrawnOutline(shown, env.ui, stroke, reach);
  if (made) return addPull(env, *shown.part, *made);
  return Refusal{"NotNow", "A new outline begins and ends at the old one. To turn the solid, drag farther from it."};
}

Outcome setPull(Env env, PartId id, std::size_t number, const pull::Pull& pull) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr || number >= part->pulls.size()) return noPart();
  Pulls pulls = part->pulls;
  pulls[number] = pull;
  return keepPulls(env, *part, std::move(pulls), number);
}

std::span<const Command> pullCommands() { return kTable; }

constinit const Mode kPullMode{"pull", pullIsChosen};
constinit const Mode kPullToolMode{"pulls", pullTool};

}  // namespace spineloft::app
