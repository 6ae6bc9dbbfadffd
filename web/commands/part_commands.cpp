// Commands about parts.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/document/params.h"
#include "engine/pipeline/outline_ink.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/intents.h"
#include "web/edit/depth_order.h"
#include "web/edit/editing.h"
#include "web/edit/placing.h"
#include "web/edit/region_editing.h"
#include "web/model/colour_text.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

/// Selects a part; the next part is made like it, as the panels show.
void select(Env env, const document::Part& part) {
  env.ui.selection = env.ui.chosenPart = part.id;
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
std::optional<sections::CapStyle> capOf(const Json& args, std::string_view key, sections::CapStyle fallback) {
  const std::string* name = args.text(key);
  if (name == nullptr) return fallback;
  return sections::capFromKey(*name);
}

/// Ends of ribs of the newest part, and how many of them are guesses.
struct Ends {
  std::size_t all = 0, guessed = 0;
  double share() const { return all > 0 ? static_cast<double>(guessed) / static_cast<double>(all) : 0; }
  /// So many that the line may have missed the thing.
  bool areMany() const { return share() >= 0.25; }
};
/// A line where the paper is blank means a part of the usual width: that is no guess.
Ends endsOfNewest(Env env) {
  const pipeline::DerivedPart& newest = env.studio.derived().parts.back();
  Ends out;
  if (!newest.shape) return out;
  for (const ribs::Rib& rib : newest.shape->generated.ribs) {
    for (const ribs::RibState state : {rib.leftState, rib.rightState}) {
      ++out.all;
      out.guessed += state == ribs::RibState::Guessed;
    }
  }
  const document::Document& document = env.studio.document();
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*document.parts.back()));
  if (out.guessed == out.all && entry != nullptr && entry->isSketch()) out.guessed = 0;
  return out;
}

}  // namespace

Standing standingActions(Env env, document::Action draw, const document::Recipe& recipe, bool lie) {
  constexpr double kHidden = 0.5;  // of a part: it would not be seen where it was drawn
  const document::Document& document = env.studio.document();
  Standing out{{std::move(draw)}, PartId{document.lastPartId + 1}, {}};
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(recipe));
  if (document.parts.empty() || entry == nullptr) return out;
  pipeline::PartShape shape;
  if (!env.studio.preview(recipe, {}, shape)) return out;  // the drawing itself says why
  const pipeline::Derived& derived = env.studio.derived();
  document::Placement placement = pipeline::standBeside(document, derived, entry->id, shape.mesh);
  if (lie) {
    Body body;
    body.add(pipeline::worldMesh(shape.mesh, *pipeline::copiesInWorld(placement, {}, entry->size).begin()));
    const Lying lying = lyingOf(document, derived, body, {});
    if (lying.front) out.lie = Lie::Inside;
    if (lying.front && *lying.front > 0 && lying.hidden >= kHidden) {
      if (placement.isRest()) placement.pivot = body.bounds->centre();
      placement.move.z += *lying.front;
      out.lie = Lie::InFront;
    }
  }
  if (placement.isRest()) return out;
  out.actions.push_back(document::PlaceParts{{{out.next, placement, {}}}});
  return out;
}

void takeMade(Env env, const Standing& standing) {
  const document::Part& part = *env.studio.document().parts.back();
  env.ui.selection = part.id;
  env.ui.alsoSelected.clear();
  env.ui.redraw = {};
  env.ui.framePending = true;
  const Ends ends = endsOfNewest(env);
  const std::size_t guesses = ends.areMany() ? 0 : ends.guessed;  // of many an offer says more
  const std::string_view sentence = guesses == 0   ? "{name} is made."
                                    : guesses == 1 ? "{name} is made. One end is a guess."
                                                   : "{name} is made. {n} ends are guesses.";
  sendStatus(env.host, words::tr(sentence, {{"name", words::nameOf(part.name)}, {"n", guesses}}));
  env.ui.newPart.reset();
  if (!standing.lie) return;
  env.ui.newPart = NewPart{part.id, *standing.lie, env.studio.undoSteps()};
  if (*standing.lie == Lie::InFront) sendStatus(env.host, "It lies on what it was drawn over.");
}

bool partIsNew(Env env) {
  const std::optional<NewPart>& part = env.ui.newPart;
  return part && part->part == env.ui.selection && part->undo == env.studio.undoSteps();
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

std::vector<PartId> partsFrom(const CommandEnv& env, const Json& args) {
  const document::Document& document = env.studio.document();
  if (const Json* list = args.find("parts"); list != nullptr && list->array()) {
    std::vector<PartId> parts;
    for (const Json& one : *list->array()) {
      const PartId id = idFrom(Json::Object{{"id", one}}, "id");
      if (document::findPart(document, id) == nullptr) return {};
      if (std::ranges::count(parts, id) == 0) parts.push_back(id);
    }
    return parts;
  }
  if (namesPart(args)) {
    const document::Part* part = partOf(env, args);
    return part ? std::vector<PartId>{part->id} : std::vector<PartId>{};
  }
  return selectedParts(document, env.ui);
}

std::optional<std::vector<PartId>> meantParts(const CommandEnv& env, const Json& args) {
  std::vector<PartId> parts = partsFrom(env, args);
  const bool named = namesPart(args) || args.find("parts") != nullptr;
  if (named && parts.empty()) return std::nullopt;
  return parts;
}

Outcome setOnAll(const CommandEnv& env, const std::vector<PartId>& parts,
                 const std::function<std::optional<document::Action>(const document::Part&)>& action) {
  std::vector<document::Action> actions;
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    if (part == nullptr) return noPart();
    if (std::optional<document::Action> one = action(*part)) actions.push_back(*std::move(one));
  }
  if (actions.empty()) return {};
  const Status status = actOnPuffs(env, parts, actions);
  if (status && actions.size() > 1) sendStatus(env.host, words::tr("Set on {n} parts.", {{"n", actions.size()}}));
  return outcomeOf(status);
}

Outcome changeLooks(const CommandEnv& env, const std::vector<PartId>& parts,
                    const std::function<void(document::Look&)>& change) {
  env.ui.look = lookMeant(env, parts);
  change(env.ui.look);
  return setOnAll(env, parts, [&](const document::Part& part) -> std::optional<document::Action> {
    document::Look look = part.look;
    change(look);
    return document::SetLook{part.id, look};
  });
}

document::Look lookOf(const CommandEnv& env, PartId id) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  return part ? part->look : env.ui.look;
}

document::Look lookMeant(const CommandEnv& env, const std::vector<PartId>& parts) {
  const bool leads = std::ranges::count(parts, env.ui.selection) > 0;
  return lookOf(env, parts.empty() ? PartId{} : leads ? env.ui.selection : parts.front());
}

document::Look currentLook(const CommandEnv& env) { return lookOf(env, env.ui.selection); }

namespace {

constexpr std::string_view kCutSentence =
    "Your line went past the end, so it stops where the thing does. Pull the end of the bone to go on.";

constexpr std::string_view kNothingFound =
    "Nothing was found beside your line, so its width is a guess. Draw through a thing, or pull the ends of the ribs.";

/// A line that found little beside it may have missed the thing.
void tellGuesses(Env env) {
  const Ends ends = endsOfNewest(env);
  if (!ends.areMany()) return;
  const std::string_view some = words::tr(
      "{n} % of the ends are guesses: the dotted ones. Draw again along the middle of the thing, or pull them.",
      {{"n", std::lround(100 * ends.share())}});
  sendOffer(env.host, {ends.share() >= 1 ? kNothingFound : some, "Try again", "redraw", {}});
}

/// A line round a thing is no line through it: a puff can be made of it.
Outcome refusedLine(Env env, const DrawSpineIntent& intent, const Failure& failure) {
  if (!intent.lie || !closesOutline(intent.stroke)) return refuse(failure);
  Json::Array line;
  for (const PicturePoint& p : intent.stroke) line.push_back(Json::Array{p.x, p.y});
  sendOffer(env.host, {"That line goes round a thing. A puff swells from its outline; a part needs a line "
                       "through its middle.",
                       "Puff it up", "draw-puff", Json::Object{{"line", std::move(line)}}});
  return {};
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
  recipe.ignored = pipeline::inkOfOthers(env.studio.document(), env.studio.derived(), recipe.picture, recipe.stroke);
  Standing standing = standingActions(env, std::move(draw), recipe, intent.lie);
  if (!recipe.ignored.empty()) standing.actions.push_back(document::IgnoreForPart{standing.next, recipe.ignored});
  const Status status = env.studio.act(standing.actions);
  if (!status) return refusedLine(env, intent, status.failure());
  takeMade(env, standing);
  shorter ? sendHint(env.host, kCutSentence) : tellGuesses(env);
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
    const auto section = sections::sectionFromKey(*key);
    if (!section) return refuse({Error::ValueOutOfRange, *key});
    intent.section = *section;
  }
  intent.startCap = capOf(args, "start", env.ui.startCap);
  intent.endCap = capOf(args, "end", env.ui.endCap);
  if (!intent.startCap || !intent.endCap) return refuse({Error::ValueOutOfRange, "start or end"});
  intent.cut = args.flag("cut").value_or(false);
  intent.lie = args.flag("lie").value_or(false);
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

/// That draws parts of a kind.
ToolKind toolFor(document::PartKind kind) {
  switch (kind) {
    case document::PartKind::Inflate:
      return ToolKind::Inflate;
    case document::PartKind::Extrude:
      return ToolKind::Extrude;
    case document::PartKind::Lathe:
      return ToolKind::Spin;
    case document::PartKind::Loft:
    case document::PartKind::Stack:
    case document::PartKind::Shape:
    case document::PartKind::Element:
    case document::PartKind::Bridge:
    case document::PartKind::kCount:
      break;
  }
  return ToolKind::Draw;
}

Outcome redrawMode(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  if (document::stackOf(*part) || document::shapeOf(*part) || document::elementOf(*part) || document::bridgeOf(*part))
    return refuse({Error::NotABone, {}});
  env.ui.redraw = env.ui.redraw ? PartId{} : part->id;
  env.ui.pointsOf = {};
  if (!env.ui.redraw) return {};
  env.ui.tool = toolFor(document::kindOf(*part));
  featureAt(env.ui, document::pictureOf(*part));
  sendStatus(env.host, words::tr("Draw the new line of {name}.", {{"name", words::nameOf(part->name)}}));
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
    text += text.empty() ? "" : " ";
    text += words::tr(
        still ? "{solid} is made of the rest now." : "{solid} needed it: what is left of it stands by itself.",
        {{"solid", words::nameOf(step.name)}});
  }
  if (!text.empty()) sendInfo(env.host, text + " " + std::string(words::tr("Undo brings it back.")));
}

Outcome deleteParts(Env env, const std::vector<PartId>& parts) {
  const document::Document before = env.studio.document();
  std::vector<document::Action> actions;
  for (const bool bridges : {true, false}) {  // which go with what they stand on
    for (const PartId id : parts) {
      const document::Part* part = document::findPart(before, id);
      if ((part != nullptr && document::bridgeOf(*part) != nullptr) == bridges) {
        actions.push_back(document::DeletePart{id});
      }
    }
  }
  const document::Part* first = parts.empty() ? nullptr : document::findPart(before, parts.front());
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  const std::size_t gone = before.parts.size() - env.studio.document().parts.size();
  if (first != nullptr && parts.size() == 1) {
    const std::string_view sentence = gone > 1 ? "{name} is deleted, with the bridges on it." : "{name} is deleted.";
    sendStatus(env.host, words::tr(sentence, {{"name", words::nameOf(first->name)}}));
  } else {
    sendStatus(env.host, words::tr("{n} parts are deleted.", {{"n", gone}}));
  }
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
  const auto at = rowAt(env.ui, {id, {}});
  return ask(
      env, {question, "Rename", "A name for this part", part->name, at},
      [id](Env later, const std::string& name) { return outcomeOf(later.studio.act(document::RenamePart{id, name})); });
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

Outcome setCaps(Env env, const Parts& parts, std::optional<sections::CapStyle> start,
                std::optional<sections::CapStyle> end) {
  const auto capsOfPart = [&](PartId id) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    return part ? capsOf(*part) : std::nullopt;
  };
  const auto lead = std::ranges::find_if(parts, [&](PartId id) { return capsOfPart(id).has_value(); });
  if (lead == parts.end() && !parts.empty()) return noSpine(document::findPart(env.studio.document(), parts.front()));
  const EndCaps now = lead == parts.end() ? EndCaps{env.ui.startCap, env.ui.endCap} : *capsOfPart(*lead);
  env.ui.startCap = start.value_or(now.start);
  env.ui.endCap = end.value_or(now.end);
  return setOnAll(env, parts, [&](const document::Part& each) -> std::optional<document::Action> {
    const std::optional<EndCaps> own = capsOf(each);
    if (!own) return std::nullopt;
    const EndCaps caps{start.value_or(own->start), end.value_or(own->end)};
    if (document::loftOf(each) != nullptr) return document::SetCaps{each.id, caps.start, caps.end};
    stack::StackParams params = document::stackOf(each)->stack;
    params.startCap = caps.start;
    params.endCap = caps.end;
    return document::ShapeStack{each.id, params};
  });
}

Outcome setTextured(Env env, const Parts& parts, bool textured) {
  return changeLooks(env, parts, [&](document::Look& look) { look.textured = textured; });
}

Outcome setColour(Env env, const Parts& parts, const Colour& colour) {
  return changeLooks(env, parts, [&](document::Look& look) {
    look.textured = false;
    look.colour = colour;
  });
}

Outcome setParameter(Env env, const Parts& parts, const std::string& key, double value) {
  const auto has = [&](PartId id) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    return part != nullptr && document::findParam(document::kindOf(*part), key) != nullptr;
  };
  // What none of them has is refused by name.
  const bool none = std::ranges::none_of(parts, has);
  return setOnAll(env, parts, [&](const document::Part& part) -> std::optional<document::Action> {
    if (!none && !has(part.id)) return std::nullopt;
    return document::SetParameter{part.id, key, value};
  });
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
  const std::optional<Parts> parts = meantParts(env, args);
  if (!parts) return noSpine(env, args);
  std::optional<sections::CapStyle> start, end;
  for (const auto& [key, caps] : {std::pair{"start", &start}, std::pair{"end", &end}}) {
    const std::string* name = args.text("both") ? args.text("both") : args.text(key);
    if (name == nullptr) continue;
    *caps = sections::capFromKey(*name);
    if (!*caps) return refuse({Error::ValueOutOfRange, "start or end"});
  }
  return app::setCaps(env, *parts, start, end);
}

Outcome toggleTexture(Env env, const Json& args) {
  const std::optional<Parts> parts = meantParts(env, args);
  if (!parts) return noPart();
  return setTextured(env, *parts, args.flag("textured").value_or(!lookMeant(env, *parts).textured));
}

Outcome setColour(Env env, const Json& args) {
  const std::string* text = args.text("colour");
  if (text == nullptr) return missing("a colour such as #ec9e5c");
  const auto colour = colourFrom(*text);
  if (!colour) return refuse({Error::ValueOutOfRange, *text});
  const std::optional<Parts> parts = meantParts(env, args);
  return parts ? app::setColour(env, *parts, *colour) : noPart();
}

Outcome setParameter(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  const std::string* key = args.text("key");
  const std::optional<double> value = args.number("value");
  if (parts.empty()) return noPart();
  if (key == nullptr || !value) return missing("a key and a value");
  return app::setParameter(env, parts, *key, *value);
}

}  // namespace rows

}  // namespace spineloft::app
