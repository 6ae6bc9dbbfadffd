// Commands about the size of the finished model, and about printing it.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/geometry/turn.h"
#include "engine/pipeline/solid.h"
#include "engine/pipeline/world.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/edit/solid_editing.h"
#include "web/model/messages.h"
#include "web/model/print_report.h"
#include "web/model/solid_faults.h"
#include "web/ui/sizing.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasParts(Env env) { return !env.studio.document().parts.empty(); }

Outcome setTyped(Env env, const std::string& typed) {
  const std::optional<double> mm = millimetresFrom(typed);
  return mm ? setHeight(env, *mm) : Refusal{"ValueOutOfRange", "Type a size such as 4 cm or 40 mm."};
}

Outcome setHeightRow(Env env, const Json& args) {
  if (const std::optional<double> mm = args.number("mm")) return setHeight(env, *mm);
  if (const std::string* typed = args.text("typed")) return setTyped(env, *typed);
  const std::string now = spokenLength(env.studio.document().height.value);
  return ask(env, {"set-height", "How tall?", "Such as 4 cm or 40 mm", now}, setTyped);
}

Outcome sizeLikeRow(Env env, const Json& args) {
  const std::string* key = args.text("thing");
  const std::optional<std::size_t> thing = key ? findThing(*key) : std::nullopt;
  return thing ? sizeLike(env, *thing) : missing("a thing: coin, cupcake or hand");
}

void likeChoices(Env env, JsonWriter& json) {
  for (const Thing& thing : things()) {
    writeChoice(json, thing.key, thing.label, env.studio.document().height.value == thing.mm);
  }
}

Outcome showBesideRow(Env env, const Json& args) {
  const std::string* key = args.text("thing");
  if (key == nullptr) return missing("a thing: coin, cupcake, hand, or none");
  const std::optional<std::size_t> thing = findThing(*key);
  if (!thing && *key != "none") return refuse({Error::ValueOutOfRange, *key});
  return showBeside(env, thing);
}

void besideChoices(Env env, JsonWriter& json) {
  for (std::size_t i = 0; i < things().size(); ++i) {
    writeChoice(json, things()[i].key, things()[i].label, env.ui.beside == i);
  }
  writeChoice(json, "none", "Nothing", !env.ui.beside);
}

bool isPutTogether(Env env) {
  return !std::ranges::any_of(env.studio.derived().steps, &pipeline::DerivedStep::waiting);
}

Outcome notYet() { return Refusal{"NotReady", "The parts are still being put together. Ask again in a moment."}; }

Outcome checkPrint(Env env, const Json&) {
  if (!isPutTogether(env)) return notYet();
  env.ui.printWaits = !env.studio.finishParts();
  if (env.ui.printWaits) return {};
  return reportPrint(env);
}

/// What was set too thin is set thicker; solids that are made anew are checked when they are there.
Outcome setThicker(Env env, const std::vector<Thickening>& thin) {
  std::vector<document::Action> actions;
  for (const Thickening& each : thin) actions.push_back(each.action);
  const std::string what = spokenList(thin);
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  sendInfo(env.host, words::tr("{length} thick now: {what}.", {{"length", spokenLength(kThickened)}, {"what", what}}));
  return {};
}

Outcome thicken(Env env, const Json&) {
  if (!isPutTogether(env) || !env.studio.finishParts()) return notYet();
  if (!env.ui.print || !(env.ui.print->of == env.studio.document())) {
    if (Outcome done = reportPrint(env); !done) return done;
  }
  const double thinnest = env.ui.print->check.thinnest;
  if (!(thinnest > 0)) return refuse({Error::NothingToExport, {}});
  if (env.ui.print->check.thick()) return {};
  if (const std::vector<Thickening> thin = env.ui.print->thin; !thin.empty()) return setThicker(env, thin);
  if (!env.ui.print->check.enlargingHelps) return Refusal{"NotNow", std::string(kThickenByHand)};
  const double mm = env.studio.document().height.value * printing::kMoreThanNeeded * printing::kLeastWall / thinnest;
  if (const Status status = env.studio.act(document::SetHeight{Millimetres{std::ceil(mm)}}); !status) {
    return refuse(status.failure());
  }
  return reportPrint(env);
}

/// What stands on its own: a part, or an outermost solid.
struct Root {
  document::Operand operand;
  pipeline::WorldBounds bounds;
  document::Look look;
};

std::vector<Root> rootsOf(Env env) {
  const document::Document& document = env.studio.document();
  const pipeline::Derived& derived = env.studio.derived();
  std::vector<Root> roots;
  for (const document::Part& part : document.parts) {
    if (!pipeline::showsItself(document, derived, part)) continue;
    const std::array own = {part.id};
    if (const auto bounds = pipeline::boundsOf(document, derived, own)) {
      roots.push_back({{part.id, {}}, *bounds, part.look});
    }
  }
  for (const document::Step& step : document.steps) {
    const pipeline::DerivedStep* shown = pipeline::shownSolid(document, derived, step);
    if (shown == nullptr) continue;
    std::optional<pipeline::WorldBounds> bounds;
    for (const auto& p : shown->solid->mesh.positions) pipeline::include(bounds, {p[0], p[1], p[2]});
    const std::vector<PartId> parts = document::partsIn(document, {{}, step.id});
    const document::Part* first = parts.empty() ? nullptr : document::findPart(document, parts.front());
    if (bounds) roots.push_back({{{}, step.id}, *bounds, first && !step.ownLook ? first->look : step.look});
  }
  return roots;
}

/// A block on which the root would stand, its upper side level: as a drawn part and its placement.
struct Block {
  document::DrawRegion draw;
  document::Placement placement;
};
Block blockBelow(const document::PictureEntry& picture, const Root& root, double level) {
  const double right = picture.size.width - 1, low = picture.size.height - 1;
  const double longer = std::max(picture.size.width, picture.size.height);
  const WorldPoint size = root.bounds.high - root.bounds.low;
  const double foot = level - root.bounds.low.y;
  constexpr double kRoom = 1.5;  // the block is larger than what it cuts
  Block block;
  document::Placement& at = block.placement;
  at.scale = std::clamp(std::max(kRoom * std::max(size.x, size.z) * longer / std::min(right, low), 2 * kRoom * foot),
                        document::kLeastScale, document::kMostScale);
  extrude::ExtrudeParams plate;
  plate.edge = extrude::EdgeKind::Sharp;
  plate.thickness = std::clamp(kRoom * foot / at.scale, extrude::kLeastThickness, extrude::kMostThickness);
  at.turn = geometry::turnAbout(WorldPoint{1, 0, 0}, std::numbers::pi / 2);
  at.move = {root.bounds.centre().x, level - plate.thickness * at.scale / 2, root.bounds.centre().z};
  document::Look look = root.look;
  look.textured = false;
  block.draw = {{picture.id, {{{0, 0}, {right, 0}, {right, low}, {0, low}}}, 0}, plate, look};
  return block;
}

/// Cuts what is lower than `level` off everything that reaches there: a block each, live and in one step.
Outcome cutBelow(Env env, double level) {
  const document::Document& document = env.studio.document();
  std::vector<document::Action> actions;
  std::uint32_t part = document.lastPartId;
  for (const Root& root : rootsOf(env)) {
    if (!(root.bounds.low.y < level)) continue;
    Block block = blockBelow(document.pictures.front(), root, level);
    const PartId id{++part};
    actions.push_back(std::move(block.draw));
    actions.push_back(document::RenamePart{id, "Foot"});
    actions.push_back(document::PlaceParts{{{id, block.placement, {}}}});
    actions.push_back(
        document::CombineParts{document::StepKind::Cut, {root.operand, {id, {}}}, document::Step{}.wall, {}});
  }
  if (actions.empty()) return refuse({Error::NothingToExport, {}});
  const PartId selected = env.ui.selection;
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  env.ui.selection = selected;
  sendInfo(env.host,
           "It is cut flat below. \"Foot\" in the list is what is cut off: move it, or break the solid apart to take "
           "it back.");
  return {};
}

Outcome flatFoot(Env env, const Json& args) {
  if (env.studio.document().pictures.empty()) return refuse({Error::NothingToExport, {}});
  const pipeline::Derived& derived = env.studio.derived();
  std::optional<double> mm = args.number("mm");
  if (!mm) {
    const Result<std::optional<double>> found = publish::flatFoot(env.studio.document(), derived);
    if (!found) return refuse(found.failure());
    if (!found.value()) {
      return Refusal{"NotNow",
                     "A flat foot does not make it stand. Print it lying down, or give it a foot of its own."};
    }
    mm = *found.value();
  }
  const std::optional<pipeline::WorldBounds> bounds = pipeline::worldBounds(env.studio.document(), derived);
  if (!bounds) return refuse({Error::NothingToExport, {}});
  const double height = env.studio.document().height.value;
  if (!(*mm > 0 && *mm < height / 2)) return refuse({Error::ValueOutOfRange, "mm"});
  return cutBelow(env, bounds->low.y + (bounds->high.y - bounds->low.y) * *mm / height);
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "set-height", .label = "How tall?", .icon = "ruler", .group = "file",
            .hint = "Height of the finished model", .enabled = hasParts, .run = setHeightRow},
    Command{.id = "size-like", .label = "As tall as", .icon = "ruler", .group = "file",
            .argument = {"thing", likeChoices}, .hint = "As tall as a coin, a cupcake or a hand", .enabled = hasParts,
            .run = sizeLikeRow},
    Command{.id = "show-beside", .label = "Show beside it", .icon = "ruler", .group = "view",
            .argument = {"thing", besideChoices},
            .hint = "A coin, a cupcake or a hand beside the solid, as large as it is", .enabled = hasParts,
            .run = showBesideRow},
    Command{.id = "check-print", .label = "Check for printing", .icon = "scan-search", .group = "file",
            .hint = "Closed, size, thinnest wall, and whether it stands", .menu = "Print", .enabled = hasParts, .run = checkPrint},
    Command{.id = "thicken", .label = "Make it thick enough", .icon = "maximize", .group = "file",
            .hint = "Thicker walls and flat pieces, or all of it larger, until its thinnest place can be printed",
            .enabled = hasParts, .run = thicken},
    Command{.id = "flat-foot", .label = "Flat foot", .icon = "footprints", .group = "file",
            .hint = "Cut flat below, as much as it needs to stand", .enabled = hasParts, .run = flatFoot},
};
// clang-format on

}  // namespace

Outcome reportPrint(const CommandEnv& env) {
  Result<printing::PrintCheck> check = publish::checkPrint(env.studio.document(), env.studio.derived());
  if (!check) return refuse(check.failure());
  const document::Document& document = env.studio.document();
  PrintReport report{check.value(), document, {}, faultsOf(document, env.studio.derived())};
  if (!check.value().thick()) report.thin = thickenings(document, millimetresPerUnit(env));
  for (const PartId id : env.studio.crossingParts()) {
    if (const document::Part* part = document::findPart(report.of, id)) report.crossing.push_back(part->name);
  }
  env.ui.print = std::move(report);
  const PrintMessage message = printMessage(*env.ui.print);
  if (message.good) {
    sendInfo(env.host, message.text);
  } else {
    sendWarning(env.host, message.text);
  }
  return {};
}

/// What stands beside the solid stays in sight.
Outcome setHeight(Env env, double mm) {
  const Status status = env.studio.act(document::SetHeight{Millimetres{mm}});
  if (!status && status.error() == Error::ValueOutOfRange) {
    return Refusal{"ValueOutOfRange", "A model can be from 1 mm to 10 m tall. Type a size such as 4 cm or 40 mm."};
  }
  if (!status) return refuse(status.failure());
  if (env.ui.beside) flyTo(env, false);
  return {};
}

Outcome sizeLike(Env env, std::size_t thing) {
  env.ui.beside = thing;
  return setHeight(env, things()[thing].mm);
}

Outcome showBeside(Env env, const std::optional<std::size_t>& thing) {
  env.ui.beside = thing;
  flyTo(env, false);
  return {};
}

std::span<const Command> sizeCommands() { return kTable; }

}  // namespace spineloft::app
