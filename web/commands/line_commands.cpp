// Commands about line drawings: their tool with its two pens, lines, who is in front, depths, and what pieces are.
#include <algorithm>
#include <array>

#include "engine/document/checks.h"
#include "engine/document/pieces.h"
#include "engine/document/update.h"
#include "engine/io/json_fields.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/line_drawing.h"
#include "web/edit/placing.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool linesTool(Env env) { return env.ui.tool == ToolKind::Lines; }
bool seenPenOn(Env env) { return linesTool(env) && !env.ui.edit.hiddenPen; }
bool hiddenPenOn(Env env) { return linesTool(env) && env.ui.edit.hiddenPen; }
bool hasDrawing(Env env) { return !env.studio.document().drawings.empty(); }
bool pieceIsSelected(Env env) {
  const document::Part* part = partOf(env, {});
  return part != nullptr && document::elementOf(*part) != nullptr;
}
constexpr Condition kHasPiece{pieceIsSelected, Condition::Part | Condition::Parts, Error::NotAPiece};

std::vector<Crossing> crossings(Env env) {
  return crossingsOn(env.studio.document(), env.studio.derived(), env.ui.picture);
}
bool hasCrossings(Env env) { return linesTool(env) && hasDrawing(env) && !crossings(env).empty(); }
bool crossingIsChosen(Env env) {
  return env.ui.chosen.crossing >= 0 && linesTool(env) &&
         env.ui.chosen.crossing < static_cast<int>(crossings(env).size());
}

Outcome useLines(Env env, const Json&) {
  env.ui.tool = ToolKind::Lines;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.focus = Focus::Picture;
  sendStatus(env.host,
             "Draw a closed line: it becomes a piece. A line that begins and ends on its edge goes on behind it.");
  return {};
}
Outcome takePen(Env env, bool hidden) {
  if (Outcome used = useLines(env, {}); !used) return used;
  env.ui.edit.hiddenPen = hidden;
  sendStatus(env.host, hidden ? "Lines are behind something now." : "Lines are in front now.");
  return {};
}
Outcome seenPen(Env env, const Json&) { return takePen(env, false); }
/// Its key goes back and forth.
Outcome hiddenPen(Env env, const Json& args) { return takePen(env, args.flag("on").value_or(!hiddenPenOn(env))); }

// ---- what programs say ------------------------------------------------------------------------------------------

/// true: all of it; [[from, to], …]: shares of the line's length. None: it is neither.
std::optional<std::vector<descriptive::Stretch>> hiddenFrom(const Json& args) {
  if (args.find("hidden") == nullptr) return std::vector<descriptive::Stretch>{};
  if (const auto all = args.flag("hidden")) {
    return *all ? std::vector<descriptive::Stretch>{{0, 1}} : std::vector<descriptive::Stretch>{};
  }
  const auto pairs = strokeOf(args, "hidden");
  if (!pairs) return std::nullopt;
  std::vector<descriptive::Stretch> stretches;
  for (const PicturePoint pair : *pairs) stretches.push_back({pair.x, pair.y});
  return stretches;
}
Outcome missingHidden() { return missing("hidden: true, false or a list of [from, to], shares from 0 to 1"); }

DrawingId drawingFrom(Env env, const Json& args) {
  if (args.find("drawing") != nullptr) return DrawingId{idFrom(args, "drawing").value};
  const document::Drawing* drawing = document::drawingOn(env.studio.document(), env.ui.picture);
  return drawing ? drawing->id : DrawingId{};
}
LineId lineFrom(const Json& args) { return LineId{idFrom(args, "line").value}; }

Outcome drawLineRow(Env env, const Json& args) {
  const auto points = strokeOf(args, "points");
  if (!points) return missing("points: a list of [x, y] picture pixels");
  auto hidden = hiddenFrom(args);
  if (!hidden) return missingHidden();
  const PictureId picture = args.find("picture") ? PictureId{idFrom(args, "picture").value} : env.ui.picture;
  return drawLine(env, {picture, *points, std::move(*hidden), args.flag("closed").value_or(false)});
}
Outcome closeLineRow(Env env, const Json& args) {
  return closeLine(env, drawingFrom(env, args), lineFrom(args), std::nullopt);
}
Outcome hideLine(Env env, const Json& args) {
  auto hidden = hiddenFrom(args);
  if (!hidden || args.find("hidden") == nullptr) return missingHidden();
  return outcomeOf(env.studio.act(document::HideLine{drawingFrom(env, args), lineFrom(args), std::move(*hidden)}));
}
Outcome deleteLine(Env env, const Json& args) {
  return outcomeOf(env.studio.act(document::DeleteLine{drawingFrom(env, args), lineFrom(args)}));
}
Outcome orderPieces(Env env, const Json& args) {
  const auto at = pointOf(args, "at");
  if (!at) return missing("at: a place [x, y] where they overlap, picture pixels");
  return outcomeOf(env.studio.act(document::OrderPieces{idFrom(args, "over"), idFrom(args, "under"), *at}));
}
Outcome pinDepthRow(Env env, const Json& args) {
  const auto at = args.number("at");
  if (!at) return missing("at: a share of the line's length, from 0 to 1");
  const bool given = args.number("z").has_value();
  const document::PinDepth pin{drawingFrom(env, args), lineFrom(args), *at, args.number("z")};
  const document::Drawing* drawing = document::findDrawing(env.studio.document(), pin.drawing);
  if (drawing == nullptr || document::findLine(*drawing, pin.line) == nullptr) return refuse({Error::NoSuchLine, {}});
  if (!given && args.find("z") != nullptr) return missing("z: a number of picture pixels");
  return pinDepth(env, pin);
}

Outcome shapePieceRow(Env env, const Json& args) {
  const std::string* key = args.text("kind");
  descriptive::PieceKind kind{};
  if (key == nullptr || !io::fromKey(*key, kind)) return missing("a kind: round, flat or solid");
  const std::vector<PartId> parts = partsFrom(env, args);
  return parts.empty() ? noPart() : shapePieces(env, parts, kind);
}
void pieceChoices(Env env, JsonWriter& json) {
  const document::Part* part = partOf(env, {});
  const document::ElementRecipe* own = part ? document::elementOf(*part) : nullptr;
  for (const auto& [kind, label] :
       {std::pair{descriptive::PieceKind::Round, "Round"}, std::pair{descriptive::PieceKind::Flat, "Flat"},
        std::pair{descriptive::PieceKind::Solid, "With edges"}}) {
    writeChoice(json, io::keyOf(kind), label, own != nullptr && own->kind == kind);
  }
}

Outcome seeFromRow(Env env, const Json& args) {
  const std::string* key = args.text("from");
  descriptive::SeenFrom from{};
  if (key == nullptr || !io::fromKey(*key, from)) return missing("from: above, below or unknown");
  const std::vector<PartId> parts = partsFrom(env, args);
  return parts.empty() ? noPart() : seeFrom(env, parts, from);
}
void seenChoices(Env env, JsonWriter& json) {
  const document::Part* part = partOf(env, {});
  const document::ElementRecipe* own = part ? document::elementOf(*part) : nullptr;
  const document::Drawing* drawing = own ? document::findDrawing(env.studio.document(), own->drawing) : nullptr;
  for (const auto& [from, label] : kSeenWords) {
    writeChoice(json, io::keyOf(from), label, drawing != nullptr && drawing->seenFrom == from);
  }
}

/// All pieces of the drawing go along, with what is grouped with them.
Outcome standUpright(Env env, const Json& args) {
  const document::Document& document = env.studio.document();
  const pipeline::Derived& derived = env.studio.derived();
  const document::Part* lead = partOf(env, args);
  if (lead == nullptr) return noPart();
  const document::ElementRecipe* own = document::elementOf(*lead);
  if (own == nullptr) return refuse({Error::NotAPiece, {}});
  const std::optional<geometry::Turn> turn = turnUpright(document, derived, lead->id);
  if (!turn) return Refusal{"NotNow", "It stands upright already, or no right angles say where up is."};
  std::vector<PartId> parts;
  for (const document::Part* piece : document::piecesOf(document, own->drawing)) {
    for (const PartId id : withGroup(document, piece->id)) {
      if (std::ranges::count(parts, id) == 0) parts.push_back(id);
    }
  }
  document::Motion motion;
  motion.centre = centreOf(document, derived, env.ui, parts).value_or(WorldPoint{});
  motion.turn = *turn;
  // It stands on the floor of the others, or where it touched its own.
  const document::PlaceParts turned{movedParts(document, derived, parts, motion)};
  auto floor = pipeline::boundsWithout(document, derived, parts);
  if (!floor) floor = pipeline::boundsOf(document, derived, parts);
  if (const auto next = document::update(document, turned); next && floor) {
    if (const auto after = pipeline::boundsOf(next.value(), derived, parts)) {
      motion.move.y = floor->low.y - after->low.y;
    }
  }
  const auto actions = placeActions(document, derived, movedParts(document, derived, parts, motion));
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  env.ui.framePending = true;
  sendStatus(env.host, "It stands upright.");
  return {};
}

// ---- crossings by keys --------------------------------------------------------------------------------------------

Outcome step(Env env, int by) {
  const int count = static_cast<int>(crossings(env).size());
  if (count == 0) return {};
  const int before = env.ui.chosen.crossing < 0 ? (by > 0 ? -1 : 0) : env.ui.chosen.crossing;
  return chooseCrossing(env, (before + by + count) % count);
}
Outcome next(Env env, const Json&) { return step(env, 1); }
Outcome previous(Env env, const Json&) { return step(env, -1); }
Outcome swap(Env env, const Json&) { return swapCrossing(env, env.ui.chosen.crossing); }

constexpr Argument kPoints{"points"}, kLine{"line"}, kOver{"over"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "lines", .label = "Lines", .icon = "signature", .shortcut = "Shift+L", .group = "tool",
            .hint = "Draw lines, seen and hidden: what they close becomes a piece", .enabled = hasPicture,
            .toggled = linesTool, .run = useLines},
    Command{.id = "seen-pen", .label = "Seen", .icon = "pencil-line", .group = "tool",
            .hint = "The next lines are seen: nothing is in front of them", .enabled = hasPicture,
            .toggled = seenPenOn, .run = seenPen},
    Command{.id = "hidden-pen", .label = "Hidden", .icon = "square-dashed", .shortcut = "D", .group = "tool",
            .hint = "The next lines are behind something (or hold Shift, or the button of a pen)",
            .enabled = hasPicture, .toggled = hiddenPenOn, .run = hiddenPen, .mode = &kLinesMode},
    Command{.id = "draw-line", .label = "Line by numbers", .icon = "line-squiggle", .group = "part",
            .argument = kPoints, .hint = "A line of a line drawing in picture pixels", .enabled = hasPicture,
            .run = drawLineRow},
    Command{.id = "close-line", .label = "Close a line", .icon = "circle-dot", .group = "part", .argument = kLine,
            .hint = "The end of a line is joined to the nearest end, its own beginning or another line's",
            .enabled = hasDrawing, .run = closeLineRow},
    Command{.id = "hide-line", .label = "Hide a line by numbers", .icon = "eye-off", .group = "part",
            .argument = kLine, .hint = "Where a line has something in front of it", .enabled = hasDrawing,
            .run = hideLine},
    Command{.id = "delete-line", .label = "Delete a line", .icon = "trash-2", .group = "part", .argument = kLine,
            .hint = "A line of a line drawing goes", .enabled = hasDrawing, .run = deleteLine},
    Command{.id = "order-pieces", .label = "In front by numbers", .icon = "layers", .group = "part",
            .argument = kOver, .hint = "Which of two pieces is in front at a place", .enabled = hasDrawing,
            .run = orderPieces},
    Command{.id = "pin-depth", .label = "Depth of a place by numbers", .icon = "anchor", .group = "part",
            .argument = kLine, .hint = "How near a place of a line is", .enabled = hasDrawing, .run = pinDepthRow},
    Command{.id = "shape-piece", .label = "Round or flat", .icon = "circle", .group = "part",
            .argument = {"kind", pieceChoices}, .hint = "What a piece of a line drawing is", .enabled = kHasPiece,
            .run = shapePieceRow},
    Command{.id = "seen-from", .label = "Right angles", .icon = "box", .group = "part",
            .argument = {"from", seenChoices}, .hint = "From where right angles of a line drawing are seen",
            .enabled = kHasPiece, .run = seeFromRow},
    Command{.id = "stand-upright", .label = "Stand upright", .icon = "armchair", .group = "part",
            .hint = "What was drawn from above stands on its feet: its right angles say where up is",
            .enabled = kHasPiece, .run = standUpright},
    Command{.id = "next-bridge", .label = "Next crossing", .icon = "chevron-right", .shortcut = ".", .group = "part",
            .hint = "Choose the next place where two pieces overlap", .enabled = hasCrossings, .run = next,
            .mode = &kLinesMode},
    Command{.id = "previous-bridge", .label = "Crossing before", .icon = "chevron-left", .shortcut = ",",
            .group = "part", .hint = "Choose the place before where two pieces overlap", .enabled = hasCrossings,
            .run = previous, .mode = &kLinesMode},
    Command{.id = "swap-bridge", .label = "Swap front and back here", .icon = "arrow-left-right",
            .shortcut = "Enter", .group = "part", .hint = "The piece that is behind comes to the front at this place",
            .enabled = crossingIsChosen, .run = swap, .mode = &kCrossingMode},
};
// clang-format on

/// New parts beyond this one stand where the other parts of their picture stand.
std::vector<document::PlaceParts::One> placesOf(Env env, const document::Document& next, PictureId picture,
                                                PartId last) {
  const document::Document& document = env.studio.document();
  const auto first =
      std::ranges::find_if(document.parts, [&](const document::Part& part) { return pictureOf(part) == picture; });
  const bool rest = first == document.parts.end() ? document.parts.empty() : (*first)->placement.isRest();
  if (rest) return {};
  std::vector<document::PlaceParts::One> places;
  for (const document::Part& part : next.parts) {
    const document::ElementRecipe* element = document::elementOf(part);
    if (element == nullptr || part.id <= last) continue;
    const pipeline::PieceIn piece = pipeline::pieceIn(next, *element, part.id);
    pipeline::PartShape shape;
    if (!pipeline::elementStage(pipeline::drawingStage(piece.drawing), piece.number, shape)) continue;
    places.push_back({part.id, pipeline::standBeside(document, env.studio.derived(), picture, shape.mesh), {}});
  }
  return places;
}

/// What lines of the picture say and cannot be.
std::size_t contradictions(Env env, PictureId picture) {
  std::size_t count = 0;
  for (const pipeline::DerivedDrawing& one : env.studio.derived().drawings) {
    const document::Drawing* drawing = document::findDrawing(env.studio.document(), one.id);
    if (drawing != nullptr && drawing->picture == picture) count += one.shape->model.orders.contradictions.size();
  }
  return count;
}

/// Says so where the last line contradicts those that were there.
void tellContradiction(Env env, PictureId picture, std::size_t before) {
  if (contradictions(env, picture) <= before) return;
  sendHint(env.host, "Two pieces are both drawn as in front. Tap the crossing there to swap them.");
}

/// Whether a piece has plane faces now that had none, or was not there.
bool becomesEdged(const document::Document& before, const document::Document& after) {
  const auto isEdged = [](const document::Part* part) {
    const document::ElementRecipe* element = part ? document::elementOf(*part) : nullptr;
    return element != nullptr && element->kind == descriptive::PieceKind::Solid;
  };
  return std::ranges::any_of(after.parts, [&](const document::Part& part) {
    return isEdged(&part) && !isEdged(document::findPart(before, part.id));
  });
}

/// Carries out what is done with lines and takes the piece that comes of it in hand.
Outcome closing(Env env, std::vector<document::Action> actions, PictureId picture) {
  const document::Document& document = env.studio.document();
  const PartId last{document.lastPartId};
  Result<document::Document> next = document;
  for (const document::Action& action : actions) {
    next = document::update(next.value(), action);
    if (!next) return refuse(next.failure());
  }
  const std::size_t contradicted = contradictions(env, picture);
  const bool isEdged = becomesEdged(document, next.value());
  if (auto places = placesOf(env, next.value(), picture, last); !places.empty()) {
    actions.push_back(document::PlaceParts{std::move(places)});
  }
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  env.ui.newPart.reset();
  env.ui.redraw = {};
  tellContradiction(env, picture, contradicted);
  const document::Part* made = nullptr;
  for (const document::Part& part : env.studio.document().parts) {
    if (part.id > last) made = &part;
  }
  if (isEdged) {
    env.ui.framePending = true;
    sendStatus(env.host, "These edges make one piece with plane faces.");
    if (made == nullptr) return {};
  }
  if (made == nullptr) {
    const bool open = !looseEndsOn(env.studio.document(), env.studio.derived(), picture).empty();
    sendStatus(env.host, open ? "A line is not closed: draw on from its ring, or tap the ring to close it." : "");
    return {};
  }
  env.ui.selection = made->id;
  env.ui.alsoSelected.clear();
  env.ui.framePending = true;
  if (!isEdged) sendStatus(env.host, words::tr("{name} is made.", {{"name", words::nameOf(made->name)}, {"n", 0}}));
  return {};
}

}  // namespace

Outcome drawLine(Env env, const DrawLineIntent& intent) {
  const document::DrawLine draw{intent.picture, intent.points, intent.hidden, intent.closed, env.ui.look};
  std::vector<document::Action> actions;
  for (const LineId line : intent.replaces) {
    const document::Drawing* drawing = document::drawingOn(env.studio.document(), intent.picture);
    if (drawing != nullptr) actions.push_back(document::DeleteLine{drawing->id, line});
  }
  actions.push_back(draw);
  return closing(env, std::move(actions), intent.picture);
}

Outcome closeLine(Env env, DrawingId id, LineId line, std::optional<PicturePoint> end) {
  const document::Drawing* drawing = document::findDrawing(env.studio.document(), id);
  if (drawing == nullptr) return refuse({Error::NoSuchLine, {}});
  if (const auto way = wayToClose(env.studio.document(), env.studio.derived(), {id, line, {}}, end)) {
    DrawLineIntent joint{drawing->picture, {way->from, way->to}, {}, false, {}};
    if (way->hidden) joint.hidden = {{0, 1}};
    return drawLine(env, joint);
  }
  return closing(env, {document::CloseLine{id, line, env.ui.look}}, drawing->picture);
}

Outcome swapCrossing(Env env, int number) {
  const std::vector<Crossing> all = crossings(env);
  if (number < 0 || number >= static_cast<int>(all.size())) return refuse({Error::ValueOutOfRange, "crossing"});
  const Crossing crossing = all[static_cast<std::size_t>(number)];
  const document::OrderPieces swap{crossing.under, crossing.over, crossing.at};
  if (const Status status = env.studio.act(swap); !status) return refuse(status.failure());
  sendStatus(env.host, crossingSentence(env.studio.document(), {crossing.under, crossing.over, crossing.at}));
  return {};
}

Outcome chooseCrossing(Env env, int number) {
  const std::vector<Crossing> all = crossings(env);
  env.ui.chosen = {};
  env.ui.focus = Focus::Picture;
  if (number < 0 || number >= static_cast<int>(all.size())) return {};
  env.ui.chosen.crossing = number;
  sendStatus(env.host, crossingSentence(env.studio.document(), all[static_cast<std::size_t>(number)]));
  return {};
}

Outcome seeFrom(Env env, const Parts& parts, descriptive::SeenFrom from) {
  std::vector<document::Action> actions;
  std::vector<DrawingId> seen;
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    const document::ElementRecipe* own = part ? document::elementOf(*part) : nullptr;
    if (own == nullptr || std::ranges::count(seen, own->drawing) > 0) continue;
    seen.push_back(own->drawing);
    actions.push_back(document::SeeDrawing{own->drawing, from});
  }
  if (actions.empty()) return refuse({Error::NotAPiece, {}});
  return outcomeOf(env.studio.act(actions));
}

Outcome pinDepth(Env env, const document::PinDepth& pin) { return outcomeOf(env.studio.act(pin)); }

Outcome shapePieces(Env env, const Parts& parts, descriptive::PieceKind kind) {
  const bool any = std::ranges::any_of(parts, [&](PartId id) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    return part != nullptr && document::elementOf(*part) != nullptr;
  });
  if (!any) return refuse({Error::NotAPiece, {}});
  Outcome done = setOnAll(env, parts, [&](const document::Part& part) -> std::optional<document::Action> {
    const document::ElementRecipe* own = document::elementOf(part);
    if (own == nullptr || own->kind == kind) return std::nullopt;
    return document::ShapePiece{part.id, kind};
  });
  const bool lacksEdges = !done && done.refusal().error == errorName(Error::ShapeInvalid);
  if (!lacksEdges || kind != descriptive::PieceKind::Solid) return done;
  return Refusal{done.refusal().error,
                 "An edge is missing, or one does not meet the others. Draw it, then choose it again."};
}

constinit const Mode kLinesMode{"lines", linesTool};
constinit const Mode kCrossingMode{"bridge", crossingIsChosen};

std::span<const Command> lineCommands() { return kTable; }

}  // namespace spineloft::app
