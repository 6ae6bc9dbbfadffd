// The rows of the command table that are about drawing a section on the board.
#include <algorithm>
#include <array>
#include <string>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/commands/section_json.h"
#include "web/edit/layer_board.h"
#include "web/edit/puff_bones.h"
#include "web/edit/section_editing.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using sections::Drawing;

SectionBoard* boardOf(Env env) { return env.ui.sections.board ? &*env.ui.sections.board : nullptr; }
bool isOpen(Env env) { return boardOf(env) != nullptr; }
Outcome notOpen() { return Refusal{"NotNow", "No slice is being drawn."}; }
bool canUndo(Env env) {
  const SectionBoard* board = boardOf(env);
  return board && (!board->past.empty() || !board->corners.empty());
}
bool canRedo(Env env) { return isOpen(env) && !boardOf(env)->future.empty(); }
bool hasCurves(Env env) { return isOpen(env) && !boardOf(env)->drawing.empty(); }
bool hasPoint(Env env) { return isOpen(env) && boardOf(env)->point.has_value(); }
bool canEdit(Env env) {
  if (env.studio.document().pictures.empty()) return false;
  const auto sheet = shownPlace(env.studio.document(), env.ui);
  return !sheet || !hasOpenCurves(*sheet);
}
bool leftRight(Env env) { return isOpen(env) && boardOf(env)->symmetry.leftRight; }
bool isFree(Env env) { return isOpen(env) && !boardOf(env)->profile; }
bool frontBack(Env env) { return isOpen(env) && boardOf(env)->symmetry.frontBack; }
bool traces(Env env) { return isOpen(env) && boardOf(env)->traces; }
bool cornered(Env env) {
  if (!hasPoint(env)) return false;
  const SectionBoard& board = *boardOf(env);
  const auto [curve, point] = *board.point;
  return curve < board.drawing.size() && point < board.drawing[curve].points.size() &&
         board.drawing[curve].points[point].corner;
}

/// The board shows `next`; the part follows.
Outcome change(Env env, Drawing next) {
  changeDrawing(*boardOf(env), std::move(next));
  previewBoard(env.ui, env.studio.document());
  if (const auto problem = sections::problemOf(boardOf(env)->drawing)) {
    sendStatus(env.host, sections::sentenceOf(problem->fault));
  }
  return {};
}

/// The part that is meant, or in hand, when it is a puff: its one slice is drawn.
const document::Part* puffOf(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  return part && document::inflateOf(*part) ? part : nullptr;
}

Outcome editProfile(Env env, const document::Part& part, const Json& args) {
  const inflate::ProfileParams& profile = document::inflateOf(part)->inflate.profile;
  const std::size_t key = pickedSlice(bonedPuff(env.studio.document(), env.studio.derived(), part.id), env.ui);
  const sections::SectionShape shape = profile.isSoft() ? sections::SectionShape() : profile.slices[key].shape;
  env.ui.selection = part.id;
  openBoard(env.ui, {&part, key, args.flag("empty").value_or(!shape.drawn()), true}, shape);
  sendStatus(env.host, "Draw one half of the slice, from the middle of the puff to its rim. Enter when it is done.");
  return {};
}

/// The sheet of the layers that are meant, or in hand; none for another part.
std::optional<Sheet> sheetMeant(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return namesPart(args) ? std::nullopt : shownSheet(env.studio.document(), env.ui);
  const document::StackRecipe* layers = document::stackOf(*part);
  if (layers == nullptr) return std::nullopt;
  const bool placed = env.ui.layers.part == part->id && env.ui.layers.at;
  std::optional<double> at = placed ? env.ui.layers.at : std::nullopt;
  if (const std::optional<double> index = args.number("slice")) {
    if (!(*index >= 0 && *index < static_cast<double>(layers->planes.size()))) return std::nullopt;
    at = layers->rail.points.empty() ? *index : layers->planes[static_cast<std::size_t>(*index)].at;
  }
  return sheetFor(env.studio.document(), part->id, {}, at, placed ? env.ui.layers.turn : geometry::Turn{});
}

Outcome editLayer(Env env, const Sheet& sheet) {
  if (hasOpenCurves(sheet)) {
    return Refusal{"StackInvalid", "Lines that end are drawn again on the sheet: the board takes closed ones."};
  }
  if (sheet.part) env.ui.selection = sheet.part;
  placeSheet(env.ui, sheet, sheet.at);
  openLayerBoard(env.ui, sheet);
  sendStatus(env.host, "Draw the slice as a closed curve. Enter when it is done, Escape to leave.");
  return {};
}

/// What is on the board becomes the layer.
Outcome keepLayer(Env env) {
  const auto sheet = sheetOfBoard(env.studio.document(), env.ui);
  if (!sheet) return refuse({Error::NotAStack, {}});
  const double at = sheet->onRail() ? std::min(sheet->at, 1.0) : sheet->at;
  return keepLayers(env, sheet->part, withBoard(*sheet, *boardOf(env)), at);
}

/// What is drawn becomes the slice, and the board is closed. Refused: it is no slice, or its part is another one.
Outcome use(Env env) {
  const SectionBoard& board = *boardOf(env);
  if (board.past.empty()) {  // nothing changed
    closeBoard(env.ui);
    return {};
  }
  Result<sections::SectionShape> made = shapeOnBoard(board);
  if (!made) return Refusal{std::string(errorName(made.error())), made.failure().detail};
  const sections::SectionShape shape = std::move(made).value();
  const document::Part* part = document::findPart(env.studio.document(), board.part);
  const bool isLayer = board.sheet.has_value();
  const bool isSame = part == nullptr ? !board.part
                      : isLayer       ? document::stackOf(*part) != nullptr
                      : board.profile ? document::inflateOf(*part) != nullptr
                                      : document::loftOf(*part) != nullptr;
  if (!isSame) return noPart();
  if (isLayer) {
    if (const Outcome kept = keepLayer(env); !kept) return kept;
  } else if (part && board.profile) {
    inflate::InflateParams params = document::inflateOf(*part)->inflate;
    auto& slices = params.profile.slices;
    if (slices.empty()) slices.resize(1);
    slices[std::min(board.key, slices.size() - 1)].shape = shape;
    const Status status = env.studio.act(document::ShapeRegion{part->id, params});
    if (!status) return refuse(status.failure());
  } else if (part) {
    std::vector<loft::SectionKey> keys = document::loftIn(*part).loft.sections;
    keys[std::min(board.key, keys.size() - 1)].shape = shape;
    const Status status = env.studio.act(document::SetSections{part->id, std::move(keys)});
    if (!status) return refuse(status.failure());
  }
  if (!board.profile && !isLayer) env.ui.section = shape;
  closeBoard(env.ui);
  sendStatus(env.host, "The slice is done, and on your shelf.");
  if (const Outcome kept = keepOnShelf(env, shape, nullptr); !kept) sendHint(env.host, kept.refusal().sentence);
  return {};
}

/// For who goes on with other work: what is no slice can be traced.
void useOrLeave(Env env) {
  const Outcome used = use(env);
  if (used) return;
  for (const sections::DrawnCurve& curve : boardOf(env)->drawing) {
    keepTrace(env.ui.sections, sections::outlineOf(curve));
  }
  sendHint(env.host, used.refusal().sentence);
  closeBoard(env.ui);
}

Outcome editSection(Env env, const Json& args) {
  if (isOpen(env)) useOrLeave(env);
  if (const document::Part* puff = puffOf(env, args)) return editProfile(env, *puff, args);
  if (const auto sheet = sheetMeant(env, args)) return editLayer(env, *sheet);
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr && args.find("part") != nullptr) return refuse({Error::NoSuchPart, {}});
  std::size_t key = part ? pickedSectionKey(env.ui, *part) : 0;
  if (const std::optional<double> index = args.number("slice"); index && part) {
    const auto count = static_cast<double>(document::loftIn(*part).loft.sections.size());
    if (!(*index >= 0 && *index < count)) return refuse({Error::ValueOutOfRange, "slice"});
    key = static_cast<std::size_t>(*index);
  }
  const sections::SectionShape shape = part ? document::loftIn(*part).loft.sections[key].shape : env.ui.section;
  if (part) {
    env.ui.selection = part->id;
    env.ui.sections.part = part->id;
    env.ui.sections.key = key;
  }
  openBoard(env.ui, {part, key, args.flag("empty").value_or(!shape.drawn())}, shape);
  sendStatus(env.host, "Draw the slice as a closed curve. Enter when it is done, Escape to leave.");
  return {};
}

Outcome done(Env env, const Json&) {
  Outcome used = use(env);
  return used && shownPlace(env.studio.document(), env.ui) ? seeSheet(env) : used;
}

void leave(Env env) {
  closeBoard(env.ui);
  sendStatus(env.host, "The slice is as it was.");
}
Outcome leaveRow(Env env, const Json&) {
  leave(env);
  return {};
}

Outcome takeBack(Env env, const Json&) {
  undoBoard(*boardOf(env));
  previewBoard(env.ui, env.studio.document());
  sendStatus(env.host, words::tr("Undone: {what}.", {{"what", words::tr("Slice")}}));
  return {};
}
Outcome onceMore(Env env, const Json&) {
  redoBoard(*boardOf(env));
  previewBoard(env.ui, env.studio.document());
  sendStatus(env.host, words::tr("Done again: {what}.", {{"what", words::tr("Slice")}}));
  return {};
}

Outcome clear(Env env, const Json&) {
  SectionBoard& board = *boardOf(env);
  for (const sections::DrawnCurve& curve : board.drawing) {
    keepTrace(env.ui.sections, sections::outlineOf(curve));
  }
  board.corners.clear();
  board.point.reset();
  return change(env, {});
}

struct StrokeKey {
  std::string_view key;
  BoardStroke::Kind kind;
  std::size_t least;  ///< points
};
constexpr std::array kStrokes = {
    StrokeKey{"stroke", BoardStroke::Kind::Freehand, 0}, StrokeKey{"outline", BoardStroke::Kind::Outline, 0},
    StrokeKey{"corners", BoardStroke::Kind::Corners, 3}, StrokeKey{"box", BoardStroke::Kind::Box, 2},
    StrokeKey{"ellipse", BoardStroke::Kind::Ellipse, 2}};

/// New curves on the board: {stroke}, {outline}, {corners}, {box: [a, b]} or {ellipse: [a, b]}.
Outcome draw(Env env, const Json& args) {
  for (const auto& [key, kind, least] : kStrokes) {
    auto points = pointsFrom(args.find(key));
    const bool corners = kind == BoardStroke::Kind::Box || kind == BoardStroke::Kind::Ellipse;
    if (!points || points->size() < least || (corners && points->size() > least)) continue;
    return drawOnBoard(env, {kind, std::move(*points)});
  }
  return missing("a stroke, an outline, corners, a box or an ellipse");
}

bool isThere(const SectionBoard& board, sections::PointRef ref) {
  return ref.curve < board.drawing.size() && ref.point < board.drawing[ref.curve].points.size();
}
/// As far off as the board lets a point go.
SectionPoint within(SectionPoint p) { return {std::clamp(p.x, -2.0, 2.0), std::clamp(p.y, -2.0, 2.0)}; }

/// What a stroke draws, by the symmetry of the board. Errors: as of sections::drawFreehand and drawOutline.
Result<Drawing> curvesOf(const BoardStroke& stroke, const sections::Symmetry& symmetry) {
  const auto shape = [&](const sections::DrawnCurve& curve) {
    if (symmetry.none()) return Result<Drawing>(Drawing{curve});
    return sections::drawOutline(sections::outlineOf(curve), symmetry);
  };
  const std::vector<SectionPoint>& points = stroke.points;
  switch (stroke.kind) {
    case BoardStroke::Kind::Freehand:
      return sections::drawFreehand(points, symmetry);
    case BoardStroke::Kind::Outline:
      return sections::drawOutline(points, symmetry);
    case BoardStroke::Kind::Corners:
      return shape(sections::polygonCurve(points));
    case BoardStroke::Kind::Box:
      return shape(sections::boxCurve(points.front(), points.back()));
    case BoardStroke::Kind::Ellipse:
      return shape(sections::ellipseCurve(points.front(), points.back()));
  }
  return Error::SectionInvalid;
}

std::optional<sections::PointRef> pointOf(Env env, const Json& args) {
  const SectionBoard& board = *boardOf(env);
  const std::optional<double> curve = args.number("curve"), point = args.number("point");
  sections::PointRef ref = board.point.value_or(sections::PointRef{board.drawing.size(), 0});
  if (curve && point) {
    if (!(*curve >= 0 && *point >= 0 && *curve < 1e6 && *point < 1e6)) return std::nullopt;
    ref = {static_cast<std::size_t>(*curve), static_cast<std::size_t>(*point)};
  }
  return isThere(board, ref) ? std::optional(ref) : std::nullopt;
}
Outcome noPoint() { return Refusal{"NoSuchPoint", "There is no such point. Tap one first."}; }

/// Where `args.to` (or another key) is; none when it is no point of the plane.
std::optional<SectionPoint> placeOf(const Json& args, std::string_view key = "to") {
  const Json::Array wrapped{args.find(key) ? *args.find(key) : Json()};
  const Json list(wrapped);
  const auto to = pointsFrom(&list);
  return to && !to->empty() && isFinite(to->front()) ? std::optional(to->front()) : std::nullopt;
}

Outcome movePoint(Env env, const Json& args) {
  const auto ref = pointOf(env, args);
  const auto to = placeOf(args);
  if (!ref) return noPoint();
  return to ? moveBoardPoint(env, *ref, *to) : missing("a place [x, y]");
}

Outcome addPoint(Env env, const Json& args) {
  const auto ref = pointOf(env, args);
  const auto to = placeOf(args);
  if (!ref) return noPoint();
  if (!to) return missing("a place [x, y]");
  if (args.find("from") == nullptr) return addBoardPoint(env, *ref, *to, std::nullopt);
  return addBoardPoint(env, *ref, placeOf(args, "from").value_or(*to), *to);
}

Outcome removePoint(Env env, const Json& args) {
  const auto ref = pointOf(env, args);
  return ref ? removeBoardPoint(env, *ref) : noPoint();
}

Outcome setCorner(Env env, const Json& args) {
  const auto ref = pointOf(env, args);
  if (!ref) return noPoint();
  SectionBoard& board = *boardOf(env);
  Drawing next = board.drawing;
  const bool corner = !next[ref->curve].points[ref->point].corner;
  sections::setCorner(next, *ref, args.flag("corner").value_or(corner), board.symmetry);
  return change(env, std::move(next));
}

Outcome useTool(Env env, const Json& args) {
  const std::string* key = args.text("tool");
  const std::optional<BoardTool> tool = key ? boardToolFromKey(*key) : std::nullopt;
  return tool ? useBoardTool(env, *tool) : missing("a tool: pen, line, box, ellipse or points");
}

void toolChoices(Env env, JsonWriter& json) {
  constexpr std::array<std::string_view, 5> kLabels = {"Pen", "Straight lines", "Box", "Ellipse", "Points"};
  for (std::size_t i = 0; i < kLabels.size(); ++i) {
    const auto tool = static_cast<BoardTool>(i);
    json.beginObject().key("value").text(boardToolKey(tool)).key("label").text(kLabels[i]);
    json.key("toggled").flag(isOpen(env) && boardOf(env)->tool == tool).endObject();
  }
}

constexpr std::array kFolds = {1, 3, 4, 5, 6, 7, 8};

/// Each press of the wheel takes the next number.
int foldAfter(int fold) {
  const auto now = std::ranges::find(kFolds, fold);
  const bool last = now == kFolds.end() || now + 1 == kFolds.end();
  return last ? kFolds.front() : *(now + 1);
}
bool likeAWheel(Env env) { return isOpen(env) && boardOf(env)->symmetry.fold > 1; }

Outcome setSymmetry(Env env, const sections::Symmetry& symmetry) {
  SectionBoard& board = *boardOf(env);
  board.symmetry = symmetry;
  board.point.reset();
  if (board.drawing.empty()) return {};
  return change(env, sections::symmetric(board.drawing, symmetry));
}
Outcome setSymmetryRow(Env env, const Json& args) {
  sections::Symmetry next = boardOf(env)->symmetry;
  if (isFree(env)) next.leftRight = args.flag("leftRight").value_or(next.leftRight);
  next.frontBack = args.flag("frontBack").value_or(next.frontBack);
  const auto stated = args.number("fold");
  const bool sides = args.flag("leftRight") || args.flag("frontBack");
  const double fold = stated ? *stated : sides ? next.fold : foldAfter(next.fold);
  if (!(fold >= 1 && fold <= sections::kMostFold)) return refuse({Error::ValueOutOfRange, "fold"});
  next.fold = static_cast<int>(fold);
  return setSymmetry(env, next);
}
Outcome toggleLeftRight(Env env, const Json&) {
  sections::Symmetry next = boardOf(env)->symmetry;
  next.leftRight = !next.leftRight;
  return setSymmetry(env, next);
}
Outcome toggleFrontBack(Env env, const Json&) {
  sections::Symmetry next = boardOf(env)->symmetry;
  next.frontBack = !next.frontBack;
  return setSymmetry(env, next);
}
void foldChoices(Env env, JsonWriter& json) {
  for (const int fold : kFolds) {
    json.beginObject().key("value").number(fold).key("label");
    json.text(fold == 1 ? "No wheel" : words::tr("Wheel of {n}", {{"n", fold}}));
    json.key("toggled").flag(isOpen(env) && boardOf(env)->symmetry.fold == fold).endObject();
  }
}

Outcome turn(Env env, sections::Turn how) { return change(env, sections::turned(boardOf(env)->drawing, how)); }
Outcome flipLeftRight(Env env, const Json&) { return turn(env, sections::Turn::FlipLeftRight); }
Outcome flipFrontBack(Env env, const Json&) { return turn(env, sections::Turn::FlipFrontBack); }
Outcome quarterTurn(Env env, const Json&) { return turn(env, sections::Turn::QuarterTurn); }

Outcome toggleTraces(Env env, const Json&) {
  boardOf(env)->traces = !boardOf(env)->traces;
  return {};
}

/// The board holds a preset, a section of the shelf or a trace from now on.
Outcome start(Env env, const Result<Drawing>& drawing) {
  if (!drawing) return refuse(drawing.failure());
  SectionBoard& board = *boardOf(env);
  board.corners.clear();
  board.point.reset();
  board.tool = BoardTool::Points;
  return change(env, sections::symmetric(drawing.value(), board.symmetry));
}

Outcome startFrom(Env env, const Json& args) {
  if (const std::optional<double> trace = args.number("trace")) {
    if (!(*trace >= 0 && *trace < static_cast<double>(kMostTraces))) return refuse({Error::ValueOutOfRange, "trace"});
    return startBoardFromTrace(env, static_cast<std::size_t>(*trace));
  }
  const Result<std::optional<sections::SectionShape>> shape = shapeFrom(args, env.ui.sections);
  if (!shape) return refuse(shape.failure());
  return shape.value() ? startBoardFrom(env, *shape.value()) : missing("the name of a slice");
}
void startChoices(Env, JsonWriter& json) {
  for (const sections::SectionName& name : sections::sectionNames()) {
    json.beginObject().key("value").text(name.key).key("label").text(name.label).endObject();
  }
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "edit-slice", .label = "Own slice", .icon = "square-pen", .group = "slice",
            .hint = "Draw a slice of your own, or change the chosen one", .enabled = canEdit, .toggled = isOpen,
            .run = editSection},
    Command{.id = "slice-done", .label = "Done", .icon = "check", .shortcut = "Enter", .group = "board",
            .hint = "Use the drawn slice", .enabled = isOpen, .run = done, .mode = &kBoardMode},
    Command{.id = "slice-cancel", .label = "Cancel", .icon = "x", .group = "board",
            .hint = "Everything stays as it was (Escape)", .enabled = isOpen, .run = leaveRow},
    Command{.id = "slice-undo", .label = "Take back", .icon = "undo-2", .group = "board",
            .hint = "Take the last change of the drawing back (Ctrl+Z)", .enabled = canUndo, .run = takeBack},
    Command{.id = "slice-redo", .label = "Once more", .icon = "redo-2", .group = "board",
            .hint = "Do what was taken back again (Ctrl+Y)", .enabled = canRedo, .run = onceMore},
    Command{.id = "slice-tool", .label = "Drawing with", .icon = "pencil", .group = "board",
            .argument = {"tool", toolChoices}, .hint = "Pen, straight lines, box, ellipse or points", .enabled = isOpen,
            .run = useTool},
    Command{.id = "slice-left-right", .label = "Left like right", .icon = "flip-vertical-2", .group = "board",
            .hint = "Both sides are the same", .enabled = isFree, .toggled = leftRight, .run = toggleLeftRight},
    Command{.id = "slice-front-back", .label = "Front like back", .icon = "flip-horizontal-2", .group = "board",
            .hint = "Front and back are the same", .enabled = isOpen, .toggled = frontBack, .run = toggleFrontBack},
    Command{.id = "slice-symmetry", .label = "Like a wheel", .icon = "flower", .group = "board",
            .argument = {"fold", foldChoices}, .hint = "The drawing repeats itself round the middle", .enabled = isOpen,
            .toggled = likeAWheel, .run = setSymmetryRow},
    Command{.id = "slice-flip", .label = "Flip left and right", .icon = "move-horizontal", .group = "board",
            .hint = "Left becomes right", .enabled = hasCurves, .run = flipLeftRight},
    Command{.id = "slice-flip-front", .label = "Flip front and back", .icon = "refresh-cw", .group = "board",
            .hint = "Front becomes back", .enabled = hasCurves, .run = flipFrontBack},
    Command{.id = "slice-turn", .label = "Quarter turn", .icon = "rotate-ccw", .group = "board",
            .hint = "Turn the drawing by a quarter", .enabled = hasCurves, .run = quarterTurn},
    Command{.id = "slice-corner", .label = "Corner or round", .icon = "diamond", .group = "board",
            .hint = "The touched point becomes a corner, or round", .enabled = hasPoint, .toggled = cornered,
            .run = setCorner},
    Command{.id = "slice-remove-point", .label = "Remove point", .icon = "minus",
            .shortcut = "Delete, Backspace", .group = "board", .hint = "Take the touched point away",
            .enabled = hasPoint, .run = removePoint, .mode = &kBoardMode},
    Command{.id = "slice-clear", .label = "Empty the board", .icon = "eraser", .group = "board",
            .hint = "Start with nothing", .enabled = hasCurves, .run = clear},
    Command{.id = "slice-traces", .label = "Earlier lines", .icon = "history", .group = "board",
            .hint = "Show what was drawn before, to trace it", .enabled = isOpen, .toggled = traces,
            .run = toggleTraces},
    Command{.id = "slice-start-from", .label = "Start from", .icon = "shapes", .group = "board",
            .argument = {"section", startChoices}, .hint = "Begin with one of the slices", .enabled = isOpen,
            .run = startFrom},
    Command{.id = "slice-draw", .label = "Draw by numbers", .icon = "pencil", .group = "board", .argument = {"stroke"},
            .hint = "A line, box or ellipse on the board", .enabled = isOpen, .run = draw},
    Command{.id = "slice-move-point", .label = "Move a point", .icon = "mouse-pointer-2", .group = "board",
            .argument = {"to"}, .hint = "Move a point of the drawing", .enabled = hasCurves, .run = movePoint},
    Command{.id = "slice-add-point", .label = "Add a point", .icon = "plus", .group = "board", .argument = {"to"},
            .hint = "Add a point after another one", .enabled = hasCurves, .run = addPoint},
};
// clang-format on

}  // namespace

void settleBoard(Env env) {
  if (!isOpen(env)) return;
  const SectionBoard& board = *boardOf(env);
  if (board.part && !document::findPart(env.studio.document(), board.part)) return closeBoard(env.ui);
  const PartId selected = env.ui.selection;
  const bool elsewhere = selected != board.selected0;
  const bool waits = env.hand != nullptr && env.hand->holds();
  if (waits || (!elsewhere && env.ui.tool == board.tool0)) return;
  useOrLeave(env);
  if (elsewhere) env.ui.selection = selected;
}

Outcome useBoardTool(Env env, BoardTool tool) {
  if (!isOpen(env)) return notOpen();
  SectionBoard& board = *boardOf(env);
  board.tool = tool;
  board.corners.clear();
  if (tool != BoardTool::Points) board.point.reset();
  return {};
}

Outcome drawOnBoard(Env env, const BoardStroke& stroke) {
  if (!isOpen(env)) return notOpen();
  SectionBoard& board = *boardOf(env);
  const Result<Drawing> curves = curvesOf(stroke, board.symmetry);
  if (!curves) {
    return Refusal{std::string(errorName(curves.error())),
                   curves.failure().detail.empty() ? spokenFailure(curves.failure()) : curves.failure().detail};
  }
  board.corners.clear();
  board.point.reset();
  if (!curves.value().empty()) keepTrace(env.ui.sections, sections::outlineOf(curves.value().front()));
  return change(env, withCurves(board.drawing, curves.value()));
}

Outcome startBoardFrom(Env env, const sections::SectionShape& shape) {
  return isOpen(env) ? start(env, sections::drawingOf(shape)) : notOpen();
}

Outcome startBoardFromTrace(Env env, std::size_t trace) {
  if (!isOpen(env)) return notOpen();
  const auto& lines = env.ui.sections.traces;
  if (trace >= lines.size()) return refuse({Error::ValueOutOfRange, "trace"});
  return start(env, sections::drawOutline(lines[trace], {}));
}

Outcome moveBoardPoint(Env env, sections::PointRef point, SectionPoint to) {
  if (!isOpen(env)) return notOpen();
  SectionBoard& board = *boardOf(env);
  if (!isThere(board, point)) return noPoint();
  Drawing next = board.drawing;
  sections::movePoint(next, point, within(to), board.symmetry);
  board.point = point;
  return change(env, std::move(next));
}

Outcome addBoardPoint(Env env, sections::PointRef after, SectionPoint at, std::optional<SectionPoint> to) {
  if (!isOpen(env)) return notOpen();
  SectionBoard& board = *boardOf(env);
  if (!isThere(board, after)) return noPoint();
  Drawing next = board.drawing;
  const sections::PointRef added = sections::addPoint(next, after, within(at), board.symmetry);
  if (to) sections::movePoint(next, added, within(*to), board.symmetry);
  Outcome outcome = change(env, std::move(next));
  board.point = added;
  return outcome;
}

Outcome removeBoardPoint(Env env, sections::PointRef point) {
  if (!isOpen(env)) return notOpen();
  SectionBoard& board = *boardOf(env);
  if (!isThere(board, point)) return noPoint();
  Drawing next = board.drawing;
  sections::removePoint(next, point, board.symmetry);
  board.point.reset();
  return change(env, std::move(next));
}

constinit const Mode kBoardMode{"slice-board", isOpen, leave, takeBack, onceMore, canUndo, canRedo};

std::span<const Command> sectionBoardCommands() { return kTable; }

}  // namespace spineloft::app
