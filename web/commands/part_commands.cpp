// Commands about parts.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/intents.h"
#include "web/edit/editing.h"
#include "web/edit/placing.h"
#include "web/edit/region_editing.h"
#include "web/model/colour_text.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

/// Selects a part; the next part is made like it, as the panels show.
void select(Env env, const document::Part& part) {
  env.ui.selection = part.id;
  env.ui.alsoSelected.clear();
  takePoints(env.ui, part);
  featureAt(env.ui, document::pictureOf(part));
  env.ui.redraw = {};
  if (const document::LoftRecipe* loft = document::loftOf(part)) {
    env.ui.section = loft->loft.sections.front().shape;
    env.ui.startCap = loft->loft.startCap;
    env.ui.endCap = loft->loft.endCap;
  }
  env.ui.look = part.look;
}

/// A cap named by `key`, `fallback` when it is not named; none for a name that is no cap's.
std::optional<loft::CapStyle> capOf(const Json& args, std::string_view key, loft::CapStyle fallback) {
  const std::string* name = args.text(key);
  if (name == nullptr) return fallback;
  return loft::capFromKey(*name);
}

}  // namespace

std::vector<document::Action> standingActions(Env env, document::Action draw, const document::Recipe& recipe) {
  std::vector<document::Action> actions{std::move(draw)};
  const document::Document& document = env.studio.document();
  if (document.parts.empty()) return actions;
  pipeline::PartShape shape;
  if (!env.studio.preview(recipe, shape)) return actions;  // the drawing itself says why
  const document::Placement placement =
      pipeline::standBeside(document, env.studio.derived(), document::pictureOf(recipe), shape.mesh);
  if (placement.isRest()) return actions;
  const PartId next{document.lastPartId + 1};
  actions.push_back(document::PlaceParts{{{next, placement, {}}}});
  return actions;
}

const document::Part* partOf(const CommandEnv& env, const Json& args) {
  PartId id = env.ui.selection;
  if (args.find("part") != nullptr) {
    id = idFrom(args, "part");
  } else if (args.find("id") != nullptr) {
    id = idFrom(args, "id");
  }
  return document::findPart(env.studio.document(), id);
}

const document::Part* loftPartOf(const CommandEnv& env, const Json& args) {
  const document::Part* part = partOf(env, args);
  return part != nullptr && document::loftOf(*part) != nullptr ? part : nullptr;
}

std::optional<PartId> meantPart(const CommandEnv& env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr && namesPart(args)) return std::nullopt;
  return part ? part->id : PartId{};
}

Outcome setLook(const CommandEnv& env, PartId part, const document::Look& look) {
  env.ui.look = look;
  if (!part) return {};
  return outcomeOf(env.studio.act(document::SetLook{part, look}));
}

document::Look lookOf(const CommandEnv& env, PartId id) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  return part ? part->look : env.ui.look;
}

document::Look currentLook(const CommandEnv& env) { return lookOf(env, env.ui.selection); }

namespace {

constexpr std::string_view kCutSentence =
    "Your line went past the end, so it stops where the thing does. Pull the end of the bone to go on.";

constexpr std::string_view kNothingFound =
    "Nothing was found beside your line, so its width is a guess. Draw through a thing, or pull the ends of the ribs.";

/// Whether every rib of the newest part is a guess although its picture has been looked at.
bool foundNothing(Env env) {
  const pipeline::DerivedPart& newest = env.studio.derived().parts.back();
  if (!newest.shape) return false;
  return std::ranges::all_of(newest.shape->generated.ribs, [](const ribs::Rib& rib) {
    return rib.leftState == ribs::RibState::Guessed && rib.rightState == ribs::RibState::Guessed;
  });
}

}  // namespace

Outcome drawSpine(Env env, const DrawSpineIntent& intent) {
  document::DrawSpine draw{env.ui.picture,
                           intent.stroke,
                           intent.section.value_or(env.ui.section),
                           intent.startCap.value_or(env.ui.startCap),
                           intent.endCap.value_or(env.ui.endCap),
                           env.ui.look,
                           intent.depth};
  document::LoftRecipe recipe;
  recipe.picture = draw.picture;
  recipe.stroke = draw.stroke;
  // Depths belong to the places of the whole line; and where there are parts, a line may well be meant to reach into
  // one.
  const bool cut = intent.cut && draw.depth.empty() && env.studio.document().parts.empty();
  if (cut) draw.stroke = env.studio.strokeOnThing(recipe);
  const bool shorter = draw.stroke != recipe.stroke;
  recipe.stroke = draw.stroke;
  recipe.loft.sections.front().shape = draw.section;
  recipe.pose.depth = draw.depth;
  const Status status = env.studio.act(standingActions(env, std::move(draw), recipe));
  if (!status) return refuse(status.failure());
  if (shorter) {
    sendHint(env.host, kCutSentence);
  } else if (foundNothing(env)) {
    sendHint(env.host, kNothingFound);
  }
  env.ui.selection = env.studio.document().parts.back()->id;
  env.ui.alsoSelected.clear();
  env.ui.redraw = {};
  env.ui.framePending = true;
  sendStatus(env.host, {});  // what it asked for is done
  return {};
}

Outcome redrawSpine(Env env, PartId id, const std::vector<PicturePoint>& stroke) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr || document::loftOf(*part) == nullptr) return noSpine(part);
  const Status status = env.studio.act(spineActions(*part, stroke, false));
  if (!status) return refuse(status.failure());
  env.ui.selection = id;
  env.ui.redraw = {};
  env.ui.framePending = true;
  sendStatus(env.host, {});
  return {};
}

namespace rows {

Outcome drawSpine(Env env, const Json& args) {
  DrawSpineIntent intent;
  std::optional<std::vector<PicturePoint>> stroke = strokeOf(args);
  if (!stroke) return missing("a stroke: a list of [x, y] picture pixels");
  intent.stroke = std::move(*stroke);
  if (args.find("depth") != nullptr) {
    std::optional<geometry::AlongCurve> depth = curveOf(args, "depth");
    if (!depth) return missing("a depth: a list of [place, pixels], places from 0 to 1 in order");
    intent.depth = std::move(*depth);
  }
  if (const std::string* key = args.text("section")) {
    const auto section = loft::sectionFromKey(*key);
    if (!section) return refuse({Error::ValueOutOfRange, *key});
    intent.section = *section;
  }
  intent.startCap = capOf(args, "start", env.ui.startCap);
  intent.endCap = capOf(args, "end", env.ui.endCap);
  if (!intent.startCap || !intent.endCap) return refuse({Error::ValueOutOfRange, "start or end"});
  intent.cut = args.flag("cut").value_or(false);
  return app::drawSpine(env, intent);
}

Outcome redrawSpine(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::vector<PicturePoint>> stroke = strokeOf(args);
  if (!stroke) return missing("a stroke: a list of [x, y] picture pixels");
  return app::redrawSpine(env, part->id, *stroke);
}

Outcome newPart(Env env, const Json&) {
  env.ui.tool = ToolKind::Draw;
  env.ui.selection = {};
  env.ui.redraw = {};
  sendStatus(env.host, "Draw a line along the middle of the next part.");
  return {};
}

Outcome redrawMode(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  env.ui.redraw = env.ui.redraw ? PartId{} : part->id;
  env.ui.pointsOf = {};
  if (!env.ui.redraw) return {};
  env.ui.tool = document::inflateOf(*part)   ? ToolKind::Inflate
                : document::extrudeOf(*part) ? ToolKind::Extrude
                                             : ToolKind::Draw;
  featureAt(env.ui, document::pictureOf(*part));
  sendStatus(env.host, "Draw the new line of " + part->name + ".");
  return {};
}

}  // namespace rows

namespace {

/// What becomes of the solids that the deleted parts were in: nothing, where all of a solid was deleted.
void reportSolidSaving(Env env, const document::Document& before) {
  const document::Document& now = env.studio.document();
  const auto gone = [&](PartId id) { return findPart(now, id) == nullptr; };
  std::string text;
  for (const document::Step& step : before.steps) {
    if (holderOf(before, {{}, step.id}) != nullptr) continue;
    const std::vector<PartId> parts = partsIn(before, {{}, step.id});
    if (std::ranges::none_of(parts, gone) || std::ranges::all_of(parts, gone)) continue;
    const bool still = findStep(now, step.id) != nullptr;
    text += (text.empty() ? "" : " ") + step.name +
            (still ? " is made of the rest now." : " needed it: what is left of it stands by itself.");
  }
  if (!text.empty()) sendInfo(env.host, text + " Undo brings it back.");
}

Outcome deleteParts(Env env, const std::vector<PartId>& parts) {
  std::vector<document::Action> actions;
  for (const PartId id : parts) actions.push_back(document::DeletePart{id});
  const document::Document before = env.studio.document();
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  reportSolidSaving(env, before);
  return {};
}

}  // namespace

Outcome deletePart(Env env, PartId part) { return deleteParts(env, {part}); }

Outcome selectPart(Env env, PartId id, bool add) {
  if (!id) {
    if (add) return {};  // beside the parts: what is in hand stays there
    env.ui.selection = {};
    env.ui.alsoSelected.clear();
    return {};
  }
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr) return noPart();
  if (add && env.ui.selection) {
    addToSelection(env.studio.document(), env.ui, part->id);
    return {};
  }
  select(env, *part);
  return {};
}

Outcome askPartName(Env env, PartId id) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr) return noPart();
  const std::string question = "rename-part:" + std::to_string(id.value);
  return ask(env, {question, "Rename", "A name for this part", part->name}, [id](Env later, const std::string& name) {
    return outcomeOf(later.studio.act(document::RenamePart{id, name}));
  });
}

Outcome showPart(Env env, PartId id, bool visible) {
  const document::Document& document = env.studio.document();
  const document::Part* part = document::findPart(document, id);
  if (part == nullptr) return noPart();
  if (visible == pipeline::isVisible(document, *part)) return {};  // nothing that could be seen or undone
  if (const document::Step* whole = rootOf(document, {id, {}})) {
    return outcomeOf(env.studio.act(document::ShowStep{whole->id, visible}));
  }
  return outcomeOf(env.studio.act(document::ShowPart{id, visible}));
}

Outcome setCaps(Env env, PartId id, std::optional<loft::CapStyle> start, std::optional<loft::CapStyle> end) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (id && (part == nullptr || document::loftOf(*part) == nullptr)) return noSpine(part);
  env.ui.startCap = start.value_or(part ? document::loftIn(*part).loft.startCap : env.ui.startCap);
  env.ui.endCap = end.value_or(part ? document::loftIn(*part).loft.endCap : env.ui.endCap);
  if (part == nullptr) return {};
  return outcomeOf(env.studio.act(document::SetCaps{id, env.ui.startCap, env.ui.endCap}));
}

Outcome setTextured(Env env, PartId part, bool textured) {
  document::Look look = lookOf(env, part);
  look.textured = textured;
  return setLook(env, part, look);
}

Outcome setColour(Env env, PartId part, const Colour& colour) {
  document::Look look = lookOf(env, part);
  look.textured = false;
  look.colour = colour;
  return setLook(env, part, look);
}

Outcome setParameter(Env env, PartId part, const std::string& key, double value) {
  return outcomeOf(env.studio.act(document::SetParameter{part, key, value}));
}

namespace rows {

Outcome deletePart(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  if (namesPart(args)) return app::deletePart(env, part->id);
  return deleteParts(env, selectedParts(env.studio.document(), env.ui));
}

Outcome selectPart(Env env, const Json& args) {
  const Json* id = args.find("id");
  const bool add = args.flag("add").value_or(false);
  if (id != nullptr && (id->isNull() || id->number() == 0)) return app::selectPart(env, {}, add);
  const document::Part* part = namesPart(args) ? partOf(env, args) : nullptr;
  return part ? app::selectPart(env, part->id, add) : noPart();
}

Outcome nextPart(Env env, const Json&) {
  const auto& parts = env.studio.document().parts;
  if (parts.empty()) return noPart();
  auto at = std::ranges::find_if(parts, [&](const document::Part& part) { return part.id == env.ui.selection; });
  if (at == parts.end() || ++at == parts.end()) at = parts.begin();
  select(env, *at);
  return {};
}

Outcome renamePart(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  const std::string* name = args.text("name");
  return name ? outcomeOf(env.studio.act(document::RenamePart{part->id, *name})) : askPartName(env, part->id);
}

Outcome showPart(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  const bool visible = args.flag("visible").value_or(!pipeline::isVisible(env.studio.document(), *part));
  return app::showPart(env, part->id, visible);
}

Outcome setCaps(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr && (namesPart(args) || partOf(env, args))) return noSpine(env, args);
  auto start = capOf(args, "start", part ? document::loftIn(*part).loft.startCap : env.ui.startCap);
  auto end = capOf(args, "end", part ? document::loftIn(*part).loft.endCap : env.ui.endCap);
  if (args.text("both") != nullptr) start = end = capOf(args, "both", {});
  if (!start || !end) return refuse({Error::ValueOutOfRange, "start or end"});
  return app::setCaps(env, part ? part->id : PartId{}, start, end);
}

Outcome toggleTexture(Env env, const Json& args) {
  const std::optional<PartId> part = meantPart(env, args);
  if (!part) return noPart();
  return setTextured(env, *part, args.flag("textured").value_or(!lookOf(env, *part).textured));
}

Outcome setColour(Env env, const Json& args) {
  const std::string* text = args.text("colour");
  if (text == nullptr) return missing("a colour such as #ec9e5c");
  const auto colour = colourFrom(*text);
  if (!colour) return refuse({Error::ValueOutOfRange, *text});
  const std::optional<PartId> part = meantPart(env, args);
  return part ? app::setColour(env, *part, *colour) : noPart();
}

Outcome setParameter(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  const std::string* key = args.text("key");
  const std::optional<double> value = args.number("value");
  if (part == nullptr) return noPart();
  if (key == nullptr || !value) return missing("a key and a value");
  return app::setParameter(env, part->id, *key, *value);
}

}  // namespace rows

}  // namespace spineloft::app
