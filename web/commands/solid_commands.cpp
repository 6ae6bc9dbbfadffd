// Commands about solids made of parts: stick together, cut, keep common, scoop out, break apart.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/printing/pieces.h"
#include "engine/publish/solid_plan.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/edit/solid_editing.h"
#include "web/model/colour_text.h"
#include "web/model/messages.h"
#include "web/model/solid_faults.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using document::OpeningSide;
using document::Operand;
using document::Step;
using document::StepKind;

StepId stepFrom(const Json& args, std::string_view key) { return {idFrom(args, key).value}; }

/// The solid that `args.step` (or `args.id`) names, else the chosen one; null when there is none.
const Step* stepOf(Env env, const Json& args) {
  StepId id = env.ui.solids.step;
  if (args.find("step") != nullptr) {
    id = stepFrom(args, "step");
  } else if (args.find("id") != nullptr) {
    id = stepFrom(args, "id");
  }
  return findStep(env.studio.document(), id);
}

Outcome noStep() { return refuse({Error::NoSuchStep, {}}); }

/// [{part: 1}, {step: 2}] or [1, 2] for parts; none when it is anything else.
std::optional<std::vector<Operand>> operandsOf(const Json& args, std::string_view key) {
  const Json* list = args.find(key);
  if (list == nullptr || list->array() == nullptr) return std::nullopt;
  std::vector<Operand> operands;
  for (const Json& each : *list->array()) {
    Operand operand{idFrom(each, "part"), stepFrom(each, "step")};
    if (each.number()) operand.part = idFrom(Json::Object{{"part", *each.number()}}, "part");
    operands.push_back(operand);
  }
  return operands;
}

/// What stands alone of all that was taken in hand, in the order in which it was.
std::vector<Operand> rootsInHand(Env env) {
  const document::Document& document = env.studio.document();
  std::vector<PartId> parts{env.ui.selection};
  parts.insert(parts.end(), env.ui.alsoSelected.begin(), env.ui.alsoSelected.end());
  std::vector<Operand> roots;
  for (const PartId id : parts) {
    if (document::findPart(document, id) == nullptr) continue;
    const Step* root = rootOf(document, {id, {}});
    const Operand operand = root ? Operand{{}, root->id} : Operand{id, {}};
    if (std::ranges::count(roots, operand) == 0) roots.push_back(operand);
  }
  return roots;
}

/// All that stand alone and are shown.
std::vector<Operand> shownRoots(const document::Document& document) {
  std::vector<Operand> roots = rootsOf(document);
  std::erase_if(roots, [&](const Operand& root) {
    const Step* step = document::findStep(document, root.step);
    return step ? !step->visible : !document::findPart(document, root.part)->visible;
  });
  return roots;
}

/// What the page means: what is ticked; else several that are in hand; else, of two things that stand alone, both, the
/// selected one last. Of more, all that are shown become one piece; what is cut has to be said.
std::optional<std::vector<Operand>> meant(Env env, const Json& args, StepKind kind) {
  if (auto named = operandsOf(args, "operands")) return named;
  if (auto named = operandsOf(args, "parts")) return named;
  if (env.ui.solids.picked.size() >= 2) return env.ui.solids.picked;
  if (std::vector<Operand> held = rootsInHand(env); held.size() >= 2) return held;
  std::vector<Operand> roots = rootsOf(env.studio.document());
  if (roots.size() > 2 && kind == StepKind::Join && env.ui.solids.picked.empty()) {
    roots = shownRoots(env.studio.document());
    return roots.size() >= 2 ? std::optional(std::move(roots)) : std::nullopt;
  }
  if (roots.size() != 2) return std::nullopt;
  const Step* root = rootOf(env.studio.document(), {env.ui.selection, {}});
  const bool first =
      roots[0] == Operand{env.ui.selection, {}} ||
      (roots[0].step && (roots[0].step == env.ui.solids.step || (root != nullptr && root->id == roots[0].step)));
  if (first) std::swap(roots[0], roots[1]);
  return roots;
}

bool severalRoots(Env env) { return hasSeveralRoots(env.studio.document()); }
bool hasSteps(Env env) { return !env.studio.document().steps.empty(); }
bool hasHollow(Env env) { return hasStep(env) && chosenStep(env)->kind == StepKind::Hollow; }
bool isPointing(Env env) { return env.ui.solids.pointing; }
bool hasTrouble(Env env) {
  return std::ranges::any_of(env.studio.derived().steps, [](const auto& step) { return step.failure.has_value(); });
}

/// Chooses a solid. What it is made of is in hand with it: what is moved, copied or deleted next is the whole.
void choose(Env env, const Step& step) {
  env.ui.solids.step = step.id;
  env.ui.alsoSelected = document::partsIn(env.studio.document(), {{}, step.id});
  if (std::erase(env.ui.alsoSelected, env.ui.selection) > 0 || env.ui.alsoSelected.empty()) return;
  env.ui.selection = env.ui.alsoSelected.front();
  env.ui.alsoSelected.erase(env.ui.alsoSelected.begin());
}

std::string nameOf(Env env, const Operand& operand) {
  const document::Document& document = env.studio.document();
  if (const Step* step = document::findStep(document, operand.step)) return std::string(words::nameOf(step->name));
  const document::Part* part = document::findPart(document, operand.part);
  return std::string(part ? words::nameOf(part->name) : std::string_view());
}

/// What came of putting together, in a sentence.
std::string saidOf(Env env, const Step& step) {
  const std::string first = nameOf(env, step.operands.front());
  const std::size_t others = step.operands.size() - 1;
  const std::string rest(others == 1 ? nameOf(env, step.operands.back()) : words::tr("{n} others", {{"n", others}}));
  const std::string_view solid = words::nameOf(step.name);
  const auto said = [&](std::string_view sentence) {
    return std::string(words::tr(sentence, {{"first", first}, {"rest", rest}, {"solid", solid}}));
  };
  switch (step.kind) {
    case StepKind::Join:
      return said("{first} and {rest} are together now: {solid}.");
    case StepKind::Cut:
      return said("{first} is without {rest} now: {solid}.");
    case StepKind::Intersection:
      return said("What {first} and {rest} share is left: {solid}.");
    case StepKind::Hollow:
    case StepKind::kCount:
      break;
  }
  return said("{first} is hollow now: {solid}. Where it is open can be chosen below the list.");
}

/// Selects what was just made, and says it.
Outcome choose(Env env, const Status& status) {
  if (!status) return refuse(status.failure());
  const auto& steps = env.studio.document().steps;
  env.ui.solids.picked.clear();
  if (steps.empty()) return {};
  choose(env, *steps.back());
  env.ui.solids.flash = Flash{steps.back()->id};
  sendStatus(env.host, saidOf(env, *steps.back()));
  return {};
}

Outcome combine(Env env, const Json& args, StepKind kind) {
  auto operands = meant(env, args, kind);
  if (!operands) {
    return Refusal{"ArgumentMissing",
                   "Tick the parts that this is about in the list first, the main one before the others."};
  }
  document::CombineParts action;
  action.kind = kind;
  action.operands = std::move(*operands);
  return makeSolid(env, action);
}

Outcome stickTogether(Env env, const Json& args) { return combine(env, args, StepKind::Join); }
Outcome cut(Env env, const Json& args) { return combine(env, args, StepKind::Cut); }
Outcome keepIntersection(Env env, const Json& args) { return combine(env, args, StepKind::Intersection); }

/// A length in the world from `key` (units of the world) or `key`Mm (of the finished model).
std::optional<double> lengthOf(Env env, const Json& args, std::string_view key) {
  if (const auto value = args.number(key)) return value;
  const auto mm = args.number(std::string(key) + "Mm");
  const double scale = millimetresPerUnit(env);
  if (!mm || scale <= 0) return std::nullopt;
  return *mm / scale;
}

/// None: no side has this name.
std::optional<OpeningSide> sideFrom(const std::string& name) {
  for (int i = 0; i < static_cast<int>(OpeningSide::kCount); ++i) {
    if (document::openingKey(static_cast<OpeningSide>(i)) == name) return static_cast<OpeningSide>(i);
  }
  return std::nullopt;
}

Outcome checkWall(Env env, double wall) {
  const double scale = millimetresPerUnit(env);
  if (scale > 0 && !(wall >= document::kLeastWall && wall <= document::kMostWall)) {
    return Refusal{"ValueOutOfRange", std::string(words::tr("A wall can be {least} to {most} thick at this size.",
                                                            {{"least", spokenWall(document::kLeastWall * scale + 0.01)},
                                                             {"most", spokenWall(document::kMostWall * scale)}}))};
  }
  return {};
}

/// [x, y, z] under `towards`.
std::optional<WorldPoint> directionOf(const Json& args) {
  const Json* list = args.find("towards");
  if (list == nullptr || list->array() == nullptr || list->array()->size() != 3) return std::nullopt;
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < 3; ++i) values[i] = (*list->array())[i].number().value_or(0);
  return WorldPoint{values[0], values[1], values[2]};
}

Outcome scoopOut(Env env, const Json& args) {
  document::CombineParts action;
  action.kind = StepKind::Hollow;
  const Step* step = args.find("part") == nullptr ? stepOf(env, args) : nullptr;
  const document::Part* part = step == nullptr ? partOf(env, args) : nullptr;
  if (step == nullptr && part == nullptr) return noPart();
  action.operands = {step ? Operand{{}, step->id} : Operand{part->id, {}}};
  if (Outcome read = readHollow(env, args, action.wall, action.opening); !read) return read;
  return makeSolid(env, action);
}

Outcome release(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  if (step == nullptr) return noStep();
  return outcomeOf(env.studio.act(document::ReleaseStep{step->id}));
}

Outcome setStepRow(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  if (step == nullptr) return noStep();
  document::SetStep action{step->id, step->kind, step->blend, step->wall, step->opening};
  action.blend = lengthOf(env, args, "blend").value_or(action.blend);
  if (Outcome read = readHollow(env, args, action.wall, action.opening); !read) return read;
  if (const std::string* name = args.text("kind")) {
    action.kind = StepKind::kCount;
    for (int i = 0; i < static_cast<int>(StepKind::kCount); ++i) {
      if (document::stepKindKey(static_cast<StepKind>(i)) == *name) action.kind = static_cast<StepKind>(i);
    }
  }
  if (const auto towards = directionOf(args)) {
    // What was tapped looks this way.
    action.opening.side = publish::sideFacing(env.studio.document(), env.studio.derived(), *step, *towards);
    env.ui.solids.pointing = false;
  }
  return setStep(env, action);
}

Outcome orderOperands(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  if (step == nullptr) return noStep();
  auto operands = operandsOf(args, "operands");
  if (!operands) {  // the menu's way: the next one comes first
    operands = step->operands;
    std::ranges::rotate(*operands, operands->begin() + 1);
  }
  return outcomeOf(env.studio.act(document::OrderOperands{step->id, std::move(*operands)}));
}

Outcome showStepRow(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  if (step == nullptr) return noStep();
  return showStep(env, step->id, args.flag("visible").value_or(!step->visible));
}

Outcome renameStep(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  if (step == nullptr) return noStep();
  const std::string* name = args.text("name");
  return name ? outcomeOf(env.studio.act(document::RenameStep{step->id, *name})) : askStepName(env, step->id);
}

Outcome deleteStep(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  if (step == nullptr) return noStep();
  return outcomeOf(env.studio.act(document::DeleteStep{step->id}));
}

Outcome stepColour(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  if (step == nullptr) return noStep();
  document::SetStepLook action{step->id, step->ownLook, step->look};
  if (const std::string* text = args.text("colour")) {
    const auto colour = colourFrom(*text);
    if (!colour) return refuse({Error::ValueOutOfRange, *text});
    action.own = true;
    action.look = {};
    action.look.textured = false;
    action.look.colour = *colour;
  }
  action.own = args.flag("own").value_or(action.own);
  return outcomeOf(env.studio.act(action));
}

Outcome selectStepRow(Env env, const Json& args) {
  const Json* id = args.find("id");
  if (id != nullptr && (id->isNull() || id->number() == 0)) {
    env.ui.solids.step = {};
    env.ui.solids.pointing = false;
    return {};
  }
  const Step* step = stepOf(env, args);
  return step ? selectStep(env, step->id) : noStep();
}

Outcome pointOpening(Env env, const Json& args) {
  env.ui.solids.pointing = args.flag("on").value_or(!env.ui.solids.pointing);
  return {};
}

/// Ticks or unticks a part or solid for the next command.
Outcome pickRow(Env env, const Json& args) {
  const Operand operand{idFrom(args, "part"), stepFrom(args, "step")};
  return pick(env, operand, args.flag("on").value_or(!isPicked(env.ui, operand)));
}

Outcome foldStepRow(Env env, const Json& args) {
  const Step* step = stepOf(env, args);
  return step ? foldStep(env, step->id) : noStep();
}

Outcome tryAgain(Env env, const Json&) {
  env.studio.solveAgain();
  return {};
}

Outcome showFailureRow(Env env, const Json& args) {
  return showFailure(env, args.find("step") != nullptr ? stepFrom(args, "step") : StepId{});
}

void openings(Env env, JsonWriter& json) {
  const Step* step = chosenStep(env);
  const bool hollow = step != nullptr && step->kind == StepKind::Hollow;
  writeOpenings(json, hollow ? std::optional(step->opening.side) : std::nullopt);
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "stick-together", .label = "Stick together", .icon = "squares-unite", .group = "part",
            .hint = "Make one solid of the ticked parts, or of all", .menu = "Together", .enabled = severalRoots, .run = stickTogether},
    Command{.id = "cut", .label = "Cut out", .icon = "squares-subtract", .group = "part",
            .hint = "Cut the other ticked parts out of the first", .menu = "Together", .enabled = severalRoots, .run = cut},
    Command{.id = "keep-common", .label = "Overlap", .icon = "squares-intersect", .group = "part",
            .hint = "Keep only where the ticked parts overlap", .enabled = severalRoots, .run = keepIntersection},
    Command{.id = "scoop-out", .label = "Hollow out at once", .icon = "cup-soda", .group = "part",
            .argument = {"opening", openings}, .hint = "Make it hollow, with a wall and an opening",
            .enabled = canHollow, .run = scoopOut},
    Command{.id = "release", .label = "Break apart", .icon = "unlink", .group = "part",
            .hint = "Undo the solid; its parts stay", .menu = "Together", .enabled = hasStep, .run = release},
    Command{.id = "set-step", .label = "Opening", .icon = "cup-soda", .group = "part",
            .argument = {"opening", openings}, .hint = "Where the hollow solid is open", .enabled = hasStep,
            .run = setStepRow},
    Command{.id = "point-opening", .label = "Tap the opening", .icon = "crosshair", .group = "part",
            .hint = "Then tap the solid where it is to be open", .enabled = hasHollow, .toggled = isPointing,
            .run = pointOpening},
    Command{.id = "order-operands", .label = "Next part first", .icon = "rows-2", .group = "part",
            .hint = "Another part becomes the main one", .enabled = hasStep, .run = orderOperands},
    Command{.id = "show-step", .label = "Show or hide solid", .icon = "eye", .group = "part",
            .hint = "Hide the solid, or show it again", .enabled = hasStep, .run = showStepRow},
    Command{.id = "rename-step", .label = "Rename solid", .icon = "pencil-line", .group = "part",
            .hint = "Another name for the solid", .enabled = hasStep, .run = renameStep},
    Command{.id = "delete-step", .label = "Delete solid", .icon = "trash-2", .group = "part",
            .hint = "The solid goes, with all its parts", .enabled = hasStep, .run = deleteStep},
    Command{.id = "colour-step", .label = "Look of the solid", .icon = "palette", .group = "part",
            .argument = {"colour"}, .hint = "One colour for the whole solid", .enabled = hasStep, .run = stepColour},
    Command{.id = "select-step", .label = "Choose a solid", .icon = "box", .group = "part", .argument = {"id"},
            .hint = "Choose a solid to change it", .enabled = hasSteps, .run = selectStepRow},
    Command{.id = "pick", .label = "Tick a part", .icon = "check", .group = "part", .argument = {"part"},
            .hint = "Tick what is to be put together", .enabled = severalRoots, .run = pickRow},
    Command{.id = "fold-step", .label = "Fold solid", .icon = "chevron-down", .group = "part",
            .hint = "Hide or show what the solid is made of", .enabled = hasStep, .run = foldStepRow},
    Command{.id = "show-trouble", .label = "Show where", .icon = "crosshair", .group = "part", .argument = {"step"},
            .hint = "Show the place where the parts could not be put together", .enabled = hasTrouble,
            .run = showFailureRow},
    Command{.id = "solve-again", .label = "Try again", .icon = "refresh-cw", .group = "part",
            .hint = "Put the parts together once more", .enabled = hasTrouble, .run = tryAgain},
};
// clang-format on

}  // namespace

Outcome makeSolid(Env env, const document::CombineParts& action) { return choose(env, env.studio.act(action)); }

Outcome readHollow(const CommandEnv& env, const Json& args, double& wall, document::Opening& opening) {
  wall = lengthOf(env, args, "wall").value_or(wall);
  if (Outcome good = checkWall(env, wall); !good) return good;
  opening.depth = args.number("depth").value_or(opening.depth);
  if (const std::string* name = args.text("opening")) {
    const auto side = sideFrom(*name);
    if (!side) return refuse({Error::ValueOutOfRange, *name});
    opening.side = *side;
  }
  return {};
}

std::optional<Operand> namedRoot(const CommandEnv& env, const Json& args) {
  const Operand named{idFrom(args, "part"), stepFrom(args, "step")};
  if (!named.part && !named.step) return std::nullopt;
  const Step* root = rootOf(env.studio.document(), named);
  return root != nullptr ? Operand{{}, root->id} : named;
}

void writeOpenings(JsonWriter& json, std::optional<OpeningSide> chosen) {
  constexpr std::array<std::pair<OpeningSide, std::string_view>, 9> kChoices = {
      {{OpeningSide::Up, "At the top"},
       {OpeningSide::Down, "At the bottom"},
       {OpeningSide::Start, "Where the line begins"},
       {OpeningSide::End, "Where the line ends"},
       {OpeningSide::Front, "In front"},
       {OpeningSide::Back, "At the back"},
       {OpeningSide::Left, "On the left"},
       {OpeningSide::Right, "On the right"},
       {OpeningSide::None, "Closed"}}};
  for (const auto& [side, label] : kChoices) writeChoice(json, document::openingKey(side), label, chosen == side);
}

Outcome pick(Env env, const Operand& operand, bool on) {
  const document::Document& document = env.studio.document();
  if (operand.part && !findPart(document, operand.part)) return noPart();
  if (operand.step && !findStep(document, operand.step)) return noStep();
  if (!operand.part && !operand.step) return missing("a part or a solid");
  if (holderOf(document, operand) != nullptr) return refuse({Error::AlreadyUsed, {}});
  std::erase(env.ui.solids.picked, operand);
  if (on) env.ui.solids.picked.push_back(operand);
  return {};
}

Outcome selectStep(Env env, StepId id) {
  const Step* step = findStep(env.studio.document(), id);
  if (step == nullptr) return noStep();
  if (env.ui.solids.step != id) env.ui.solids.pointing = false;
  choose(env, *step);
  return {};
}

Outcome setStep(Env env, const document::SetStep& action) {
  if (Outcome good = checkWall(env, action.wall); !good) return good;
  const document::Action actions[] = {action};
  return outcomeOf(env.studio.act(actions, "set-step:" + std::to_string(action.step.value)));
}

Outcome openTowards(Env env, StepId id, WorldPoint way) {
  const Step* step = findStep(env.studio.document(), id);
  if (step == nullptr) return noStep();
  document::SetStep action{id, step->kind, step->blend, step->wall, step->opening};
  action.opening.side = publish::sideFacing(env.studio.document(), env.studio.derived(), *step, way);
  env.ui.solids.pointing = false;
  return setStep(env, action);
}

Outcome showStep(Env env, StepId step, bool visible) {
  return outcomeOf(env.studio.act(document::ShowStep{step, visible}));
}

Outcome foldStep(Env env, StepId step) {
  if (std::erase(env.ui.solids.folded, step) == 0) env.ui.solids.folded.push_back(step);
  return {};
}

Outcome askStepName(Env env, StepId id) {
  const Step* step = findStep(env.studio.document(), id);
  if (step == nullptr) return noStep();
  const std::string question = "rename-step:" + std::to_string(id.value);
  const auto at = rowAt(env.ui, {{}, {}, id});
  return ask(
      env, {question, "Rename", "A name for this solid", step->name, at},
      [id](Env later, const std::string& name) { return outcomeOf(later.studio.act(document::RenameStep{id, name})); });
}

Outcome showFailure(Env env, StepId id) {
  const auto& steps = env.studio.derived().steps;
  const auto at = std::ranges::find_if(steps, [&](const pipeline::DerivedStep& step) {
    return step.failure && (!id || step.id == id) && (step.at || step.faulty);
  });
  if (at == steps.end()) return noStep();
  if (at->faulty) {
    if (Outcome done = selectPart(env, at->faulty, false); !done) return done;
  }
  if (!at->at) return {};
  Camera to = env.ui.camera;
  to.target = *at->at;
  env.ui.cameraTouched = true;
  fly(env, to);
  return {};
}

void tellLoosePieces(Env env, StepId id) {
  const Step* step = findStep(env.studio.document(), id);
  const auto& steps = env.studio.derived().steps;
  const auto at = std::ranges::find(steps, id, &pipeline::DerivedStep::id);
  if (step == nullptr || step->kind != StepKind::Join || at == steps.end() || !at->solid) return;
  mesh::TriMesh mm{at->solid->mesh.positions, {}, at->solid->mesh.triangles};
  const auto scale = static_cast<float>(millimetresPerUnit(env));
  for (auto& place : mm.positions) {
    for (float& x : place) x *= scale;
  }
  const std::size_t pieces = printing::countPieces({&mm, 1});
  if (pieces < 2) return;
  sendHint(env.host, words::tr("{solid} is in {n} pieces that do not touch. Move them together.",
                               {{"solid", words::nameOf(step->name)}, {"n", pieces}}));
}

bool stepIsChosen(const CommandEnv& env) { return chosenStep(env) != nullptr; }
bool somethingToHollow(const CommandEnv& env) { return hasStep(env) || hasSelection(env); }

std::span<const Command> solidCommands() { return kTable; }

}  // namespace spineloft::app
