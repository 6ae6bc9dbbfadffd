// Commands about parts drawn layer by layer, and the sheet that layers are drawn on.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/io/recipe_file.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/commands/section_json.h"
#include "web/edit/drawn_rail.h"
#include "web/edit/free_layers.h"
#include "web/edit/layer_joints.h"
#include "web/edit/layer_settings.h"
#include "web/edit/layers.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr double kStep = 0.1, kFineStep = 0.02;  // of the rail
constexpr double kFlat = 0.5;                    // sine of the angle from which a sheet is seen well enough to draw

std::optional<Sheet> sheetOf(Env env) { return shownSheet(env.studio.document(), env.ui); }
bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
std::optional<Sheet> placeOf(Env env) { return shownPlace(env.studio.document(), env.ui); }
bool sheetIsShown(Env env) { return placeOf(env).has_value(); }
bool onLayer(Env env) {
  const auto sheet = placeOf(env);
  return sheet && sheet->layer;
}
bool canCopy(Env env) {
  const auto sheet = placeOf(env);
  return sheet && traceOf(*sheet) != nullptr;
}
const document::StackRecipe* layersOf(const document::Part* part) {
  return part != nullptr ? document::stackOf(*part) : nullptr;
}
bool onRail(Env env) {
  const auto sheet = placeOf(env);
  return sheet && sheet->onRail();
}
bool isFree(Env env) {
  const auto sheet = placeOf(env);
  return sheet && sheet->isFree();
}
bool canBeFree(Env env) {
  const auto sheet = placeOf(env);
  if (!sheet || !sheet->layer || !sheet->onRail()) return false;
  return sheet->isFree() || (!sheet->recipe.rail.closed && sheet->recipe.stack.patterns.empty());
}
bool railIsDrawn(Env env) { return drawsRail(env.studio.document(), env.ui); }
bool layerTool(Env env) { return env.ui.tool == ToolKind::Layers; }

/// All of the bounds, within what no bar covers of the view.
Camera framedInRoom(Env env, const Camera& from, const publish::WorldBounds& bounds) {
  const Rect& view = env.ui.layout.solid;
  const Rect& free = env.ui.solidRoom;
  const Rect& room = free.width > 0 && free.height > 0 ? free : view;
  Camera to = framed(from, bounds, view);
  to.distance *= std::max(view.width / room.width, view.height / room.height);
  panCamera(to, view, room.centre() - view.centre());
  return to;
}

/// The sheet, with the part that it is of.
std::optional<publish::WorldBounds> boundsWith(Env env, const Sheet& sheet, bool part) {
  const pipeline::ToWorld toWorld = sheetInWorld(env.studio.document(), env.studio.derived(), env.ui, sheet);
  std::optional<publish::WorldBounds> bounds;
  if (part && sheet.part) {
    bounds = pipeline::boundsOf(env.studio.document(), env.studio.derived(), std::array{sheet.part});
  }
  for (const ModelPoint corner : cornersOf(sheet)) pipeline::include(bounds, toWorld(corner));
  return bounds;
}

WorldPoint normalOf(Env env, const Sheet& sheet) {
  const pipeline::ToWorld toWorld = sheetInWorld(env.studio.document(), env.studio.derived(), env.ui, sheet);
  return normalized(toWorld.along(sheet.stand.normal()));
}

/// Looks square at the sheet, from the side that is seen.
void face(Env env, const Sheet& sheet) {
  WorldPoint normal = normalOf(env, sheet);
  if (dot(normal, env.ui.camera.back()) < 0) normal = normal * -1;
  Camera to = env.ui.camera;
  to.pitch = std::clamp(std::asin(std::clamp(normal.y, -1.0, 1.0)), -kMaxPitch, kMaxPitch);
  if (std::hypot(normal.x, normal.z) > 1e-3) to.yaw = std::atan2(normal.x, normal.z);
  env.ui.cameraTouched = true;
  fly(env, framedInRoom(env, to, *boundsWith(env, sheet, false)));
}

Outcome useLayers(Env env, const Json&) {
  env.ui.tool = ToolKind::Layers;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.focus = Focus::Solid;
  env.ui.layers = {};
  sendStatus(env.host, "Draw a closed line on the sheet. Then lift the sheet and draw the next layer.");
  return {};
}

/// Why planes make no solid, so that they are refused before they are kept.
Status checkMade(Env env, document::StackRecipe recipe) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), recipe.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  recipe.stack.melt = 0;  // what is made can be rounded
  const auto made = pipeline::stackStage(recipe, entry->size);
  return made ? Status(Done{}) : Status(made.failure());
}

/// What makes `to` of the part. Patterns are of planes by number: they wait until those are there.
std::vector<document::Action> actionsTo(const document::Part& part, const document::StackRecipe& to) {
  const document::StackRecipe& from = *document::stackOf(part);
  std::vector<document::Action> actions;
  stack::StackParams single = to.stack;
  single.patterns.clear();
  if (from.stack != single) actions.push_back(document::ShapeStack{part.id, single});
  // On a rail that was closed the last layer may have links; layers that come onto a rail need one.
  const bool railFirst = from.rail.points.empty();
  if (railFirst && from.rail != to.rail) actions.push_back(document::SetRail{part.id, to.rail});
  if (from.planes != to.planes) actions.push_back(document::SetPlanes{part.id, to.planes});
  if (!railFirst && from.rail != to.rail) actions.push_back(document::SetRail{part.id, to.rail});
  if (single != to.stack) actions.push_back(document::ShapeStack{part.id, to.stack});
  return actions;
}

/// The camera moves where the sheet is seen too flat to draw on, or where it, or with `whole` its part as well, is not
/// within what no bar covers of the view.
void bringInSight(Env env, const Sheet& sheet, bool whole) {
  const double lean = std::abs(dot(normalOf(env, sheet), env.ui.camera.back()));
  const Rect& view = env.ui.layout.solid;
  const Rect& room = env.ui.solidRoom.width > 0 ? env.ui.solidRoom : view;
  const auto isSeen = [&](WorldPoint p) {
    const auto at = pointOnCanvas(env.ui.camera, view, p);
    return at && room.contains(*at);
  };
  const pipeline::ToWorld toWorld = sheetInWorld(env.studio.document(), env.studio.derived(), env.ui, sheet);
  const auto bounds = boundsWith(env, sheet, true);
  bool seen = std::ranges::all_of(cornersOf(sheet), [&](ModelPoint p) { return isSeen(toWorld(p)); });
  for (int i = 0; i < 8 && whole && seen; ++i) {
    seen = isSeen({(i & 1) != 0 ? bounds->high.x : bounds->low.x, (i & 2) != 0 ? bounds->high.y : bounds->low.y,
                   (i & 4) != 0 ? bounds->high.z : bounds->low.z});
  }
  if (seen && lean >= kFlat) return;
  Camera to = env.ui.camera;
  constexpr double kHigh = 0.75;  // radians
  if (lean < kFlat) to.pitch = kHigh;
  env.ui.cameraTouched = true;
  fly(env, framedInRoom(env, to, *bounds));
}

/// The sheet of a part there, as the one that is seen would be.
std::optional<Sheet> sheetAt(Env env, PartId part, std::optional<double> at) {
  const bool placed = env.ui.layers.part == part && env.ui.layers.at;
  const geometry::Turn turn = placed ? env.ui.layers.turn : geometry::Turn{};
  return sheetFor(env.studio.document(), part, env.ui.picture, at, turn);
}

Outcome noSheet() { return refuse({Error::NotAStack, {}}); }

Outcome put(Env env, stack::Curve (*curveOn)(const Sheet&)) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  return drawLayer(env, {sheet->part, sheet->at, {curveOn(*sheet)}});
}
Outcome circle(Env env, const Json&) { return put(env, circleOn); }
Outcome square(Env env, const Json&) { return put(env, squareOn); }

Outcome copy(Env env, const Json&) {
  const auto sheet = sheetOf(env);
  const stack::Plane* trace = sheet ? traceOf(*sheet) : nullptr;
  if (trace == nullptr) return noSheet();
  return drawLayer(env, {sheet->part, sheet->at, trace->curves});
}

Outcome remove(Env env, const Json&) {
  const auto sheet = sheetOf(env);
  if (!sheet || !sheet->layer) return noSheet();
  if (sheet->recipe.planes.size() == 1) return deletePart(env, sheet->part);
  return keepLayers(env, sheet->part, withoutLayer(*sheet), sheet->at);
}

/// By a step along the rail; with `far` as keys say it by a small one. Without a rail to the next layer.
Outcome lift(Env env, const Json& args, double way) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  const double step = !sheet->onRail() ? 1 : args.flag("far").value_or(false) ? kFineStep : kStep;
  const Outcome moved = moveSheet(env, sheet->at + way * step);
  return moved ? seeSheet(env) : moved;
}
Outcome up(Env env, const Json& args) { return lift(env, args, 1); }
Outcome down(Env env, const Json& args) { return lift(env, args, -1); }

Outcome faceRow(Env env, const Json&) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  face(env, *sheet);
  return {};
}

Outcome sheetRow(Env env, const Json& args) {
  const auto at = args.number("at");
  return at && std::isfinite(*at) ? moveSheet(env, *at) : missing("a place: a share of the rail");
}
Outcome moveRow(Env env, const Json& args) {
  const auto to = args.number("to");
  return to && std::isfinite(*to) ? moveLayer(env, *to) : missing("where to: a share of the rail");
}

/// `line` as a hand draws it, or `through` with `corners`: an exact curve.
Outcome drawRow(Env env, const Json& args) {
  const document::Part* part = namesPart(args) ? partOf(env, args) : nullptr;
  if (namesPart(args) && part == nullptr) return noPart();
  const auto shown = sheetOf(env);
  const PartId id = part ? part->id : shown ? shown->part : PartId{};
  std::optional<double> at = args.number("at");
  if (!at && shown && shown->part == id) at = shown->at;
  const auto sheet = sheetAt(env, id, at);
  if (!sheet) return noSheet();
  if (const auto through = pointsFrom(args.find("through"))) {
    const stack::Curve curve{*through, {args.flag("corners").value_or(false), {}}};
    if (!stack::isValid(curve)) return refuse({Error::ValueOutOfRange, "through"});
    return drawLayer(env, {id, sheet->at, {curve}});
  }
  if (const auto line = pointsFrom(args.find("line"))) return drawOnSheet(env, id, sheet->at, *line);
  return missing("a line: a list of [x, y] on the sheet, in picture pixels (or through: points of a curve)");
}

/// A new part as its recipe says, for what is made by a program.
Outcome drawStack(Env env, const Json& args) {
  const Json* stated = args.find("recipe");
  if (stated == nullptr || stated->object() == nullptr) return missing("a recipe of a part of layers: an object");
  JsonWriter text;
  text.value(*stated);
  const auto read = io::readRecipe(text.json(), {});
  if (!read) return refuse(read.failure());
  const bool isOne = read.value().parts.size() == 1;
  const document::StackRecipe* layers = isOne ? layersOf(&*read.value().parts.front()) : nullptr;
  if (layers == nullptr || layers->planes.empty()) return refuse({Error::NotAStack, {}});
  document::StackRecipe recipe = *layers;
  recipe.picture = env.ui.picture;
  return keepLayers(env, {}, recipe, recipe.rail.points.empty() ? 0 : recipe.planes.back().at);
}

Outcome leanRow(Env env, const Json& args) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  if (!sheet->onRail()) return refuse({Error::StackInvalid, kNoRail});
  Lean lean = leanOf(*sheet);
  for (const auto& [key, way] : {std::pair{"front", &Lean::front}, {"side", &Lean::side}}) {
    const auto degrees = args.number(key);
    if (degrees && !(std::abs(*degrees) <= mostLean(*sheet, way))) return refuse({Error::ValueOutOfRange, key});
    lean.*way = degrees.value_or(lean.*way);
  }
  return leanSheet(env, turnFor(*sheet, lean));
}

/// With numbers, a free layer so many picture pixels from its place on the rail.
Outcome freeRow(Env env, const Json& args) {
  const auto sheet = sheetOf(env);
  if (!sheet || !sheet->layer) return noSheet();
  const auto side = args.number("side"), front = args.number("front"), ahead = args.number("ahead");
  const bool moves = side || front || ahead;
  for (const auto& number : {side, front, ahead}) {
    if (number && !(std::abs(*number) <= stack::kFarOut)) return refuse({Error::ValueOutOfRange, "picture pixels"});
  }
  auto made = withFree(*sheet, args.flag("on").value_or(moves || !sheet->isFree()));
  if (!made) return refuse(made.failure());
  Sheet freed = *sheet;
  freed.recipe = std::move(made).value();
  if (moves && freed.isFree()) {
    const Offset now = offsetOf(freed, freed.recipe.planes[*freed.layer]);
    freed.recipe = withOffset(freed, {side.value_or(now.side), front.value_or(now.front), ahead.value_or(now.ahead)});
  }
  return remakeLayers(env, sheet->part, freed.recipe);
}

/// Links and forks between the layer on the sheet and its neighbours, as state() counts them.
Outcome linkRow(Env env, const Json& args) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  const auto number = args.number("link");
  const auto joints = jointsOf(env.studio.document(), env.studio.derived(), env.ui, *sheet);
  if (!number || !(*number >= 0) || *number >= static_cast<double>(joints.links.size())) {
    return missing("a link: the number of one of the sheet's, from 0");
  }
  const LayerLink& link = joints.links[static_cast<std::size_t>(*number)];
  return remakeLayers(env, sheet->part, withLink(sheet->recipe, link, args.flag("on").value_or(!link.on)));
}

/// Of one fork, or of all that are seen.
Outcome forkRow(Env env, const Json& args) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  const auto at = args.number("at"), number = args.number("fork");
  if (!at || !(*at >= 0 && *at <= 1)) return missing("a height (at): 0…1, from the one curve to the several");
  const auto joints = jointsOf(env.studio.document(), env.studio.derived(), env.ui, *sheet);
  document::StackRecipe recipe = sheet->recipe;
  for (std::size_t i = 0; i < joints.forks.size(); ++i) {
    if (!number || *number == static_cast<double>(i)) recipe = withFork(recipe, joints.forks[i], *at);
  }
  if (recipe == sheet->recipe && joints.forks.empty()) {
    return refuse({Error::StackInvalid, "no fork here can be moved: draw two curves above one"});
  }
  return remakeLayers(env, sheet->part, recipe);
}

constexpr Argument kLine{"line"}, kAt{"at"}, kTo{"to"}, kLink{"link"}, kFront{"front"}, kRecipe{"recipe"};
constexpr Condition kHasSheet{sheetIsShown}, kOnLayer{onLayer}, kCanCopy{canCopy}, kOnRail{onRail},
    kCanBeFree{canBeFree};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "layers", .label = "Layers", .icon = "layers", .shortcut = "Q", .group = "tool",
            .hint = "Draw a shape, lift the sheet, draw the next: layer by layer", .enabled = hasPicture,
            .toggled = layerTool, .run = useLayers},
    Command{.id = "layer-circle", .label = "Circle", .icon = "circle", .group = "part",
            .hint = "A circle on the sheet", .enabled = kHasSheet, .run = circle},
    Command{.id = "layer-square", .label = "Square", .icon = "square", .group = "part",
            .hint = "A square on the sheet", .enabled = kHasSheet, .run = square},
    Command{.id = "layer-copy", .label = "Same again", .icon = "copy", .group = "part",
            .hint = "Copies the layer before to the sheet", .enabled = kCanCopy, .run = copy},
    Command{.id = "layer-down", .label = "Sheet down", .icon = "chevron-down",
            .shortcut = "ArrowDown, Shift+ArrowDown", .group = "part",
            .hint = "The sheet goes back along its rail", .enabled = kHasSheet, .run = down, .mode = &kLayerMode},
    Command{.id = "layer-up", .label = "Sheet up", .icon = "chevron-up", .shortcut = "ArrowUp, Shift+ArrowUp",
            .group = "part", .hint = "The sheet goes on along its rail", .enabled = kHasSheet, .run = up,
            .mode = &kLayerMode},
    Command{.id = "layer-face", .label = "Look straight at it", .icon = "eye", .group = "part",
            .hint = "Turns the view square to the sheet", .enabled = kHasSheet, .run = faceRow},
    Command{.id = "layer-remove", .label = "Remove layer", .icon = "trash-2", .group = "part",
            .hint = "Takes the layer on the sheet away", .enabled = kOnLayer, .run = remove},
    Command{.id = "layer-sheet", .label = "Sheet by numbers", .icon = "move", .group = "part", .argument = kAt,
            .hint = "Where the sheet stands, a share of the rail", .enabled = kHasSheet, .run = sheetRow},
    Command{.id = "layer-move", .label = "Move layer by numbers", .icon = "move", .group = "part", .argument = kTo,
            .hint = "Another place for the layer on the sheet", .enabled = kOnLayer, .run = moveRow},
    Command{.id = "layer-lean", .label = "Lean the sheet", .icon = "move", .group = "part", .argument = kFront,
            .hint = "How far the sheet leans to the front and to the side, in degrees", .enabled = kOnRail,
            .run = leanRow},
    Command{.id = "layer-free", .label = "Off the line", .icon = "move-3d", .group = "part",
            .hint = "The layer on the sheet leaves the line of the layers and stands anywhere", .enabled = kCanBeFree,
            .toggled = isFree, .run = freeRow},
    Command{.id = "layer-link", .label = "Link by numbers", .icon = "waypoints", .group = "part", .argument = kLink,
            .hint = "Curves of two layers become each other, or no longer", .enabled = kOnLayer, .run = linkRow},
    Command{.id = "layer-fork", .label = "Fork by numbers", .icon = "waypoints", .group = "part", .argument = kAt,
            .hint = "How high a fork is", .enabled = kOnLayer, .run = forkRow},
    Command{.id = "draw-layer", .label = "Layer by numbers", .icon = "layers", .group = "part", .argument = kLine,
            .hint = "A line on a sheet, in picture pixels", .enabled = hasPicture, .run = drawRow},
    Command{.id = "draw-stack", .label = "Layers by a recipe", .icon = "layers", .group = "part", .argument = kRecipe,
            .hint = "A whole part of layers, as files have it", .enabled = hasPicture, .run = drawStack},
};
// clang-format on

}  // namespace

Outcome keepLayers(Env env, PartId part, const document::StackRecipe& recipe, double at) {
  if (const Status made = checkMade(env, recipe); !made) return refuse(made.failure());
  if (part) {
    const auto actions = actionsTo(*document::findPart(env.studio.document(), part), recipe);
    if (const Status status = actions.empty() ? Done{} : env.studio.act(actions); !status) {
      return refuse(status.failure());
    }
    env.ui.selection = part;
  } else {
    const document::DrawStack draw{recipe.picture, recipe.planes, recipe.rail, recipe.stack, layerLook(env.ui)};
    const Standing standing = standingActions(env, draw, recipe, false);
    if (const Status status = env.studio.act(standing.actions); !status) return refuse(status.failure());
    takeMade(env, standing);
    env.ui.framePending = false;  // the sheet stays as it is seen, where there is room
  }
  env.ui.layers = {env.ui.selection, at, env.ui.layers.part == part ? env.ui.layers.turn : geometry::Turn{}};
  if (const auto sheet = sheetOf(env); sheet && !part) bringInSight(env, *sheet, true);
  return {};
}

Outcome drawLayer(Env env, const DrawLayerIntent& intent) {
  const auto sheet = sheetAt(env, intent.part, intent.at);
  if (!sheet) return noSheet();
  const document::StackRecipe recipe = withCurves(*sheet, intent.curves);
  Outcome kept = keepLayers(env, intent.part, recipe, sheet->onRail() ? std::min(sheet->at, 1.0) : sheet->at);
  const bool forks =
      kept && recipe.planes.size() > 1 && sheet->layer && recipe.planes[*sheet->layer].curves.size() == 2;
  if (forks) sendStatus(env.host, "Full dots join shapes: tap one to part them. The knob moves the fork.");
  return kept;
}

Outcome drawOnSheet(Env env, PartId part, double at, const std::vector<SectionPoint>& line) {
  const auto sheet = sheetAt(env, part, at);
  if (!sheet) return noSheet();
  auto curves = curvesOf(*sheet, line);
  if (!curves) return refuse(curves.failure());
  const auto isWall = [](const stack::Curve& curve) { return curve.as == stack::CurveUse::Ribbon; };
  const bool walls = std::ranges::any_of(curves.value(), isWall);
  Outcome drawn = drawLayer(env, {part, at, std::move(curves).value()});
  if (drawn && walls) sendStatus(env.host, "The line stayed open: it is a wall. For a solid end it where it begins.");
  return drawn;
}

Outcome remakeLayers(Env env, PartId id, const document::StackRecipe& recipe) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (layersOf(part) == nullptr) return refuse({Error::NotAStack, {}});
  const bool placed = env.ui.layers.part == id;
  const auto sheet = sheetFor(env.studio.document(), id, {}, placed ? env.ui.layers.at : std::nullopt);
  if (!sheet) return noSheet();
  const double at = sheet->layer && !recipe.rail.points.empty() ? recipe.planes[*sheet->layer].at : sheet->at;
  return keepLayers(env, id, recipe, at);
}

Outcome seeSheet(Env env) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  placeSheet(env.ui, *sheet, sheet->at);
  bringInSight(env, *sheet, false);
  return {};
}

Outcome moveSheet(Env env, double at) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  placeSheet(env.ui, *sheet, at);
  return {};
}

Outcome leanSheet(Env env, const geometry::Turn& turn) {
  const auto sheet = sheetOf(env);
  if (!sheet) return noSheet();
  placeSheet(env.ui, *sheet, sheet->at);
  const Outcome kept = sheet->layer ? keepLayers(env, sheet->part, withTurn(*sheet, turn), sheet->at) : Outcome{};
  if (kept && !sheet->isFree()) env.ui.layers.turn = turn;  // which leans as sheets on the rail do not
  return kept;
}

Outcome drawRail(Env env, PartId id) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  const document::StackRecipe* layers = layersOf(part);
  if (layers == nullptr) return refuse({Error::NotAStack, {}});
  if (layers->rail.points.empty()) return refuse({Error::StackInvalid, kNoRail});
  if (!part->visible) return refuse({Error::StackInvalid, "it is hidden: show it first"});
  if (railIsDrawn(env) && env.ui.layers.part == id) {
    env.ui.layers.drawsRail = false;
    return {};
  }
  const auto shown = sheetOf(env);
  const auto at = shown && shown->part == id ? std::optional(shown->at) : std::nullopt;
  const auto sheet = sheetAt(env, id, at);
  if (!sheet) return noSheet();
  env.ui.selection = id;
  env.ui.tool = ToolKind::Layers;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.focus = Focus::Solid;
  placeSheet(env.ui, *sheet, sheet->at);
  env.ui.layers.drawsRail = true;
  sendStatus(env.host, "Draw the line that the layers follow. Over another part it lies on its surface.");
  return {};
}

Outcome followMiddles(Env env, PartId part) {
  const document::StackRecipe* layers = layersOf(document::findPart(env.studio.document(), part));
  if (layers == nullptr) return refuse({Error::NotAStack, {}});
  const Result<document::StackRecipe> changed = withRailThroughMiddles(*layers);
  return changed ? remakeLayers(env, part, changed.value()) : refuse(changed.failure());
}

Outcome followRail(Env env, PartId part, const Result<stack::Rail>& rail) {
  const document::StackRecipe* layers = layersOf(document::findPart(env.studio.document(), part));
  if (layers == nullptr) return refuse({Error::NotAStack, {}});
  return rail ? remakeLayers(env, part, withDrawnRail(*layers, rail.value())) : refuse(rail.failure());
}

Outcome moveLayer(Env env, double at) {
  const auto sheet = sheetOf(env);
  if (!sheet || !sheet->layer) return noSheet();
  const document::StackRecipe moved = withMovedLayer(*sheet, at);
  return keepLayers(env, sheet->part, moved, moved.planes[*sheet->layer].at);
}

std::span<const Command> layerCommands() { return kTable; }

constinit const Mode kLayerMode{"layers", sheetIsShown};
constinit const Mode kRailMode{"rail", railIsDrawn, [](Env env) { env.ui.layers.drawsRail = false; }};

}  // namespace spineloft::app
