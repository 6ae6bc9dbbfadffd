// Commands of the tool Shapes: which primitive, handles by keys, lines at outlines, and pictures that are sides.
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>

#include "engine/geometry/bounds.h"
#include "engine/geometry/polygon.h"
#include "engine/io/json_fields.h"
#include "engine/shape/reshape.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/shaping.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasPictures(Env env) { return env.studio.document().pictures.size() > 1; }
bool shapesTool(Env env) { return env.ui.tool == ToolKind::Primitive; }
std::optional<SeenShape> inHand(Env env) { return shapeInHand(env.studio.document(), env.ui); }
/// The selected shape while the tool is in hand and the picture in view shows it; null else. Asked in every frame: no
/// outline is made for it.
const document::ShapeRecipe* inView(Env env) {
  const document::Document& document = env.studio.document();
  const document::Part* part = shapesTool(env) ? document::findPart(document, env.ui.selection) : nullptr;
  const document::ShapeRecipe* recipe = part ? document::shapeOf(*part) : nullptr;
  return recipe && document::viewOn(document, env.ui.picture, recipe->picture).ok() ? recipe : nullptr;
}
bool shapeByKeys(Env env) { return inView(env) != nullptr; }
bool handleByKeys(Env env) {
  if (env.ui.chosen.shape < 0 || env.ui.focus != Focus::Picture || inView(env) == nullptr) return false;
  const auto seen = inHand(env);
  return seen && env.ui.chosen.shape < static_cast<int>(shapeHandles(*seen).size());
}
bool outlineIsDrawn(Env env) {
  const document::ShapeRecipe* recipe = inView(env);
  return recipe && std::ranges::count(recipe->outlines, env.ui.picture, &document::Outline::picture) > 0;
}

Refusal noShapeOfLine() {
  return {"ShapeInvalid",
          "No shape comes of this line: it crosses itself, turns back, or is much longer than the shape. Draw it "
          "again."};
}

Outcome useShapes(Env env, const Json&) {
  env.ui.tool = ToolKind::Primitive;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.focus = Focus::Picture;
  const document::Part* part = document::findPart(env.studio.document(), env.ui.selection);
  const bool shape = part != nullptr && document::shapeOf(*part) != nullptr;
  sendStatus(env.host, shape ? "Drag its points, or draw along its outline. A line elsewhere makes a new shape."
                             : "Drag the shape from one end to the other, or tap a thing: it is fitted to it.");
  return {};
}

Outcome kindRow(Env env, const Json& args) {
  const std::string* key = args.text("kind");
  shape::Primitive primitive{};
  if (key == nullptr || !io::fromKey(*key, primitive)) {
    return missing("a kind: ball, egg, box, cylinder, capsule, cone, pyramid or half-ball");
  }
  if (namesPart(args) || args.find("parts") != nullptr) {
    const std::vector<PartId> parts = partsFrom(env, args);
    return parts.empty() ? noPart() : setPrimitive(env, parts, primitive);
  }
  return choosePrimitive(env, primitive);
}
void kindChoices(Env env, JsonWriter& json) {
  for (const shape::ReadyShape& name : shape::readyShapes()) {
    writeChoice(json, io::keyOf(name.primitive), name.label, name.primitive == env.ui.primitive);
  }
}

Outcome step(Env env, int by) {
  const auto seen = inHand(env);
  const int count = seen ? static_cast<int>(shapeHandles(*seen).size()) : 0;
  if (count == 0) return {};
  const int before = env.ui.chosen.shape < 0 ? (by > 0 ? -1 : 0) : env.ui.chosen.shape;
  return chooseShapeHandle(env, (before + by + count) % count);
}
Outcome next(Env env, const Json&) { return step(env, 1); }
Outcome previous(Env env, const Json&) { return step(env, -1); }

/// Arrows on the chosen handle; one after the other they are one step.
Outcome nudge(Env env, const Json& args) {
  const SeenShape seen = *inHand(env);
  const ShapeHandle handle = shapeHandles(seen)[static_cast<std::size_t>(env.ui.chosen.shape)];
  const std::optional<PicturePoint> by = nudgeOf(args);
  if (!by || !isFinite(*by)) return missing("how far: by [x, y] in picture pixels");
  const auto moved = draggedShape(env.studio.document(), seen, handle, handle.at + *by);
  if (!moved) return Refusal{"NotNow", "The shape cannot become smaller there."};
  return reshape(env, seen.part->id, *moved,
                 "shape " + std::to_string(seen.part->id.value) + " " + std::to_string(env.ui.chosen.shape));
}

/// The shape has its own outline again in the picture in view.
Outcome plainOutline(Env env, const Json&) {
  document::ShapeRecipe recipe = *inView(env);
  std::erase_if(recipe.outlines, [&](const document::Outline& outline) { return outline.picture == env.ui.picture; });
  return reshape(env, env.ui.selection, recipe);
}

/// From where the picture in view looks at another one; none: it is no side.
std::optional<geometry::ViewFrom> sideNow(Env env, PictureId id) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), id);
  return entry && entry->view ? std::optional(entry->view->view.from) : std::nullopt;
}
bool isSide(Env env) { return sideNow(env, env.ui.picture).has_value(); }

Outcome sideRow(Env env, const Json& args) {
  const PictureId picture = args.find("picture") ? PictureId{idFrom(args, "picture").value} : env.ui.picture;
  const std::string* key = args.text("from");
  geometry::ViewFrom from = geometry::ViewFrom::Right;
  if (key != nullptr && *key == "none") return setSidePicture(env, picture, std::nullopt);
  if (key != nullptr && !io::fromKey(*key, from)) return missing("from where it looks: right, left, back, top or none");
  if (key == nullptr && sideNow(env, picture)) return setSidePicture(env, picture, std::nullopt);
  return setSidePicture(env, picture, from);
}
void sideChoices(Env env, JsonWriter& json) {
  const auto now = sideNow(env, env.ui.picture);
  for (const SideName& name : sideNames()) writeChoice(json, io::keyOf(name.from), name.label, now == name.from);
  writeChoice(json, "none", "No side", !now);
}

/// What is drawn in a picture says something else once the picture looks from elsewhere.
void dropOutlines(const document::Document& document, PictureId picture, std::vector<document::Action>& actions) {
  for (const document::Part& part : document.parts) {
    const document::ShapeRecipe* shape = document::shapeOf(part);
    const std::optional<document::Outline>* side = document::sideOf(part.recipe);
    if (side != nullptr && *side && (*side)->picture == picture) {
      actions.push_back(document::SetSide{part.id, std::nullopt});
    }
    if (shape == nullptr || shape->picture == picture) continue;
    std::vector<document::Outline> kept = shape->outlines;
    if (std::erase_if(kept, [&](const document::Outline& outline) { return outline.picture == picture; }) == 0)
      continue;
    actions.push_back(document::SetOutlines{part.id, std::move(kept)});
  }
}

/// The side outline of a loft or a puff after a line was drawn at it, as of a shape; before there is one the line
/// itself.
std::vector<PicturePoint> sideOfLine(Env env, const document::Part& part, const std::vector<PicturePoint>& line) {
  const std::optional<document::Outline>& side = *document::sideOf(part.recipe);
  if (side && side->picture == env.ui.picture && side->lines.size() == 1) {
    return shape::redrawn(side->lines.front(), line);
  }
  const geometry::Bounds<PicturePoint> box = geometry::boundsOf(std::span<const PicturePoint>(line));
  const std::vector<PicturePoint> round{
      box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}};  // as large as the outline will be
  return shape::isWhole(round, line) ? shape::redrawn(round, line) : line;
}

constexpr Argument kBy{"by"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "shapes", .label = "Shapes", .icon = "cone", .shortcut = "0", .group = "tool",
            .hint = "Drag a ball, a block or another shape onto the picture", .enabled = hasPicture,
            .toggled = shapesTool, .run = useShapes},
    Command{.id = "shape-kind", .label = "Which shape", .icon = "cone", .group = "part",
            .argument = {"kind", kindChoices}, .hint = "A ball, an egg, a block or another shape",
            .enabled = hasPicture, .run = kindRow},
    Command{.id = "side-picture", .label = "Side picture", .icon = "columns-2", .group = "part",
            .argument = {"from", sideChoices}, .hint = "This picture shows the thing from a side",
            .enabled = hasPictures, .toggled = isSide, .run = sideRow},
    Command{.id = "plain-outline", .label = "Outline as it was", .icon = "rotate-ccw", .group = "part",
            .hint = "The shape has its own outline again in this picture", .enabled = outlineIsDrawn,
            .run = plainOutline},
    Command{.id = "next-shape-point", .label = "Next point of the shape", .icon = "chevron-right", .shortcut = ".",
            .group = "part", .hint = "Choose the next end of the shape, its middle or its width",
            .enabled = shapeByKeys, .run = next, .mode = &kShapeMode},
    Command{.id = "previous-shape-point", .label = "Point of the shape before", .icon = "chevron-left",
            .shortcut = ",", .group = "part", .hint = "Choose the end of the shape, its middle or its width before",
            .enabled = shapeByKeys, .run = previous, .mode = &kShapeMode},
    Command{.id = "nudge-shape-point", .label = "Move the point of the shape", .icon = "move", .shortcut = kArrowKeys,
            .group = "part", .argument = kBy, .hint = "Arrow keys move the chosen point, with Shift by ten pixels",
            .enabled = handleByKeys, .run = nudge, .mode = &kShapePointMode},
};
// clang-format on

}  // namespace

Outcome drawShapeLine(Env env, PartId id, const std::vector<PicturePoint>& line) {
  const document::Document& document = env.studio.document();
  const document::Part* part = document::findPart(document, id);
  if (part != nullptr && document::sideOf(part->recipe) != nullptr) {
    return setSide(env, id, {env.ui.picture, {sideOfLine(env, *part, line)}});
  }
  const auto seen = seenShape(document, id, env.ui.picture);
  if (!seen) return refuse({Error::NotAShape, {}});
  const Status made = checkMade(env, previewOfLine(document, *seen, line));
  if (!made && (made.failure().error == Error::ShapeInvalid || made.failure().error == Error::RegionEmpty)) {
    return noShapeOfLine();
  }
  if (!made) return refuse(made.failure());
  const DrawnShape drawn = withLine(document, *seen, line);
  std::vector<document::Action> actions;
  if (drawn.view)
    actions.push_back(document::SetView{seen->picture, document::PictureView{seen->recipe.picture, *drawn.view}});
  if (!(seen->recipe.shape == drawn.recipe.shape)) actions.push_back(document::SetShape{id, drawn.recipe.shape});
  actions.push_back(document::SetOutlines{id, drawn.recipe.outlines});
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  sendStatus(env.host, "The shape has this outline now.");
  return {};
}

Outcome dragShape(Env env, PartId id, ShapeHold hold, PicturePoint to) {
  const auto seen = seenShape(env.studio.document(), id, env.ui.picture);
  if (!seen) return refuse({Error::NotAShape, {}});
  const auto handles = shapeHandles(*seen);
  const auto at = std::ranges::find(handles, hold, &ShapeHandle::hold);
  if (at == handles.end()) return refuse({Error::ValueOutOfRange, std::string(holdKey(hold))});
  const auto moved = draggedShape(env.studio.document(), *seen, *at, to);
  if (!moved) return Refusal{"NotNow", "The shape cannot become smaller there."};
  return reshape(env, id, *moved);
}

Outcome chooseShapeHandle(Env env, int handle) {
  env.ui.chosen = {};
  env.ui.focus = Focus::Picture;
  const auto seen = inHand(env);
  const auto handles = seen ? shapeHandles(*seen) : std::vector<ShapeHandle>{};
  if (handle < 0 || handle >= static_cast<int>(handles.size())) return {};
  env.ui.chosen.shape = handle;
  sendStatus(env.host, shapeSentence(handles[static_cast<std::size_t>(handle)].hold));
  return {};
}

Outcome shapeOfThing(Env env, PartId id, const geometry::Contours& contours) {
  if (contours.empty()) return refuse({Error::RegionEmpty, {}});
  const auto area = [](const std::vector<PicturePoint>& line) {
    return std::abs(geometry::signedArea(std::span<const PicturePoint>(line)));
  };
  const std::vector<PicturePoint>& outline = *std::ranges::max_element(contours, {}, area);
  if (id) return drawShapeLine(env, id, outline);
  document::ShapeRecipe recipe;
  recipe.picture = env.ui.picture;
  recipe.shape.primitive = env.ui.primitive;
  const auto fitted = fittedShape(env.studio.document(), recipe, outline);
  return fitted.ok() ? drawShape(env, fitted.value(), true) : refuse(fitted.failure());
}

Outcome choosePrimitive(Env env, shape::Primitive primitive) {
  env.ui.primitive = primitive;
  const document::Part* part = document::findPart(env.studio.document(), env.ui.selection);
  if (part != nullptr && document::shapeOf(*part) != nullptr) {
    env.ui.selection = {};
    env.ui.alsoSelected.clear();
  }
  return useShapes(env, {});
}

Outcome setPrimitive(Env env, const Parts& parts, shape::Primitive primitive) {
  env.ui.primitive = primitive;
  for (const PartId id : parts) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    const document::ShapeRecipe* own = part ? document::shapeOf(*part) : nullptr;
    if (own == nullptr) continue;
    document::ShapeRecipe recipe = *own;
    recipe.shape.primitive = primitive;
    if (const Status made = checkMade(env, recipe); !made) return refuse(made.failure());
  }
  return setOnAll(env, parts, [&](const document::Part& part) -> std::optional<document::Action> {
    const document::ShapeRecipe* own = document::shapeOf(part);
    if (own == nullptr || own->shape.primitive == primitive) return std::nullopt;
    shape::ShapeParams params = own->shape;
    params.primitive = primitive;
    return document::SetShape{part.id, params};
  });
}

Outcome setSidePicture(Env env, PictureId picture, std::optional<geometry::ViewFrom> from) {
  const document::Document& document = env.studio.document();
  const document::PictureEntry* side = document::findPicture(document, picture);
  if (side == nullptr) return refuse({Error::NoSuchPicture, {}});
  env.ui.pictureMenu = {};
  if (!from) return outcomeOf(env.studio.act(document::SetView{picture, std::nullopt}));
  const document::Part* part = document::findPart(document, env.ui.selection);
  const document::PictureEntry* front = part ? document::findPicture(document, document::pictureOf(*part)) : nullptr;
  if (front == nullptr || front->id == picture) {
    const auto other = std::ranges::find_if(
        document.pictures, [&](const document::PictureEntry& entry) { return entry.id != picture && !entry.view; });
    front = other == document.pictures.end() ? nullptr : &static_cast<const document::PictureEntry&>(*other);
  }
  if (front == nullptr) return refuse({Error::NoSuchPicture, {}});
  std::vector<document::Action> actions;
  geometry::View view = plainView(*from, front->size, side->size);
  const auto isAside = [](geometry::ViewFrom one) {
    return one == geometry::ViewFrom::Right || one == geometry::ViewFrom::Left;
  };
  const bool isSame = side->view && side->view->of == front->id && side->view->view.from == *from;
  if (isSame || (side->view && side->view->of == front->id && isAside(*from) && isAside(side->view->view.from))) {
    view = side->view->view;  // as it was, or only the other way round: what is drawn stays
    view.from = *from;
  } else {
    dropOutlines(document, picture, actions);
  }
  const bool dropsOutlines = !actions.empty();
  actions.push_back(document::SetView{picture, document::PictureView{front->id, view}});
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  env.ui.tool = ToolKind::Primitive;
  featureAt(env.ui, picture);
  env.ui.focus = Focus::Picture;
  if (dropsOutlines) {
    sendHint(env.host, "The outlines that were drawn here are gone. Undo brings them back.");
  }
  sendStatus(env.host, document::findPart(env.studio.document(), env.ui.selection)
                           ? "Draw here round the shape as it is seen from this side."
                           : "Choose a shape, then draw here what it looks like from this side.");
  return {};
}

constinit const Mode kShapeMode{"shape", shapeByKeys};
constinit const Mode kShapePointMode{"shape-point", handleByKeys};

std::span<const Command> shapeToolCommands() { return kTable; }

}  // namespace spineloft::app
