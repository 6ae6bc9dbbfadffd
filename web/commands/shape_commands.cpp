// Commands about shapes, about pictures that are sides of others, and about the side outlines of lofts and puffs.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/document/checks.h"
#include "engine/document/update.h"
#include "engine/io/json_fields.h"
#include "engine/mesh/laws.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/edit/section_editing.h"
#include "web/edit/shaping.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using Lines = std::vector<std::vector<PicturePoint>>;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool shapeIsSelected(Env env) {
  const document::Part* part = partOf(env, {});
  return part != nullptr && document::shapeOf(*part) != nullptr;
}
constexpr Condition kHasShape{shapeIsSelected, Condition::Part, Error::NotAShape};

PictureId pictureFrom(const Json& args, std::string_view key, PictureId fallback) {
  return args.find(key) ? PictureId{idFrom(args, key).value} : fallback;
}

/// Two points under `key`.
std::optional<std::array<PicturePoint, 2>> twoPoints(const Json& args, std::string_view key) {
  const auto line = strokeOf(args, key);
  if (!line || line->size() != 2) return std::nullopt;
  return std::array{line->front(), line->back()};
}

/// `line`, a closed one, or `lines`, two open ones. Empty: neither is given. None: it is no line.
std::optional<Lines> linesFrom(const Json& args) {
  if (args.find("line") != nullptr) {
    auto line = strokeOf(args, "line");
    return line ? std::optional<Lines>({std::move(*line)}) : std::nullopt;
  }
  const Json* list = args.find("lines");
  if (list == nullptr) return Lines{};
  if (list->array() == nullptr) return std::nullopt;
  Lines lines;
  for (const Json& one : *list->array()) {
    auto line = strokeOf(Json::Object{{"stroke", one}});
    if (!line) return std::nullopt;
    lines.push_back(std::move(*line));
  }
  return lines;
}
Outcome missingLines() { return missing("a closed line: a list of [x, y] picture pixels (or lines: two open ones)"); }

Outcome drawShapeRow(Env env, const Json& args) {
  document::ShapeRecipe recipe;
  recipe.picture = pictureFrom(args, "picture", env.ui.picture);
  const std::string* kind = args.text("kind");
  if (kind == nullptr || !io::fromKey(*kind, recipe.shape.primitive)) {
    return missing("a kind: ball, egg, box, cylinder, capsule, cone, pyramid or half-ball");
  }
  if (const auto axis = twoPoints(args, "axis")) {
    recipe.shape.axis = {axis->front(), axis->back()};
    recipe.shape.width = args.number("width").value_or(distance(axis->front(), axis->back()));
  } else if (const auto box = twoPoints(args, "box")) {
    const auto [a, b] = *box;
    const double middle = (a.x + b.x) / 2;
    recipe.shape.axis = {{middle, std::max(a.y, b.y)}, {middle, std::min(a.y, b.y)}};
    recipe.shape.width = std::abs(b.x - a.x);
  } else {
    return missing("an axis or a box: [[x, y], [x, y]] in picture pixels");
  }
  recipe.shape.depth.ratio = args.number("ratio").value_or(recipe.shape.depth.ratio);
  if (const std::string* mode = args.text("depth")) {
    if (!io::fromKey(*mode, recipe.shape.depth.mode)) return refuse({Error::ValueOutOfRange, *mode});
  }
  auto lines = linesFrom(args);
  if (!lines) return missingLines();
  if (!lines->empty()) recipe.outlines.push_back({recipe.picture, std::move(*lines)});
  return drawShape(env, recipe, args.flag("lie").value_or(false));
}

Outcome shapeOutline(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  const document::ShapeRecipe* own = document::shapeOf(*part);
  if (own == nullptr) return refuse({Error::NotAShape, {}});
  auto lines = linesFrom(args);
  if (!lines) return missingLines();
  document::ShapeRecipe recipe = *own;
  const PictureId picture = pictureFrom(args, "picture", recipe.picture);
  std::erase_if(recipe.outlines, [&](const document::Outline& outline) { return outline.picture == picture; });
  if (!lines->empty()) recipe.outlines.push_back({picture, std::move(*lines)});
  return reshape(env, part->id, recipe);
}

Outcome setView(Env env, const Json& args) {
  const document::Document& document = env.studio.document();
  const PictureId picture = pictureFrom(args, "picture", env.ui.picture);
  if (args.find("of") == nullptr) return outcomeOf(env.studio.act(document::SetView{picture, std::nullopt}));
  const document::PictureEntry* side = document::findPicture(document, picture);
  const document::PictureEntry* front = document::findPicture(document, pictureFrom(args, "of", {}));
  if (side == nullptr || front == nullptr) return refuse({Error::NoSuchPicture, {}});
  geometry::ViewFrom from = geometry::ViewFrom::Right;
  const std::string* key = args.text("from");
  if (key == nullptr || !io::fromKey(*key, from)) return missing("from where it looks: right, left, back or top");
  geometry::View view = plainView(from, front->size, side->size);
  view.middle = args.number("middle").value_or(view.middle);
  view.scale = args.number("scale").value_or(view.scale);
  view.shift = args.number("shift").value_or(view.shift);
  return outcomeOf(env.studio.act(document::SetView{picture, document::PictureView{front->id, view}}));
}

bool takesSide(Env env) {
  const document::Part* part = partOf(env, {});
  return part != nullptr && document::sideOf(part->recipe) != nullptr;
}
bool hasSide(Env env) { return takesSide(env) && document::sideOf(partOf(env, {})->recipe)->has_value(); }
constexpr Condition kTakesSide{takesSide, Condition::Part | Condition::Parts, Error::TakesNoSide};
constexpr Condition kHasSide{hasSide, Condition::Part | Condition::Parts, Error::TakesNoSide};

/// The picture that shows a part from the side: the one in view, else the first one.
PictureId sidePictureOf(Env env, const document::Part& part) {
  const document::Document& document = env.studio.document();
  if (isSeenAside(document, part, env.ui.picture)) return env.ui.picture;
  const auto at = std::ranges::find_if(
      document.pictures, [&](const document::PictureEntry& entry) { return isSeenAside(document, part, entry.id); });
  return at == document.pictures.end() ? PictureId{} : (*at)->id;
}

/// Every outline that stands in a picture but those of `but`: of what was cut out or drawn on it, and of what is seen
/// there from a side.
std::vector<Lines> outlinesIn(const document::Document& document, PictureId picture, PartId but) {
  std::vector<Lines> all;
  for (const document::Part& part : document.parts) {
    if (part.id == but) continue;
    const document::Region* region = document::regionOf(part.recipe);
    if (region != nullptr && region->picture == picture && !region->isOfLines()) {
      for (const auto& contour : region->contours) all.push_back({contour});
    }
    for (const document::Outline* outline : document::outlinesOf(part.recipe)) {
      if (outline->picture == picture) all.push_back(outline->lines);
    }
  }
  return all;
}

/// The one whose rows are nearest to those of the part, seen in the view. None: there is no outline.
std::optional<Lines> nearestOutline(const std::vector<Lines>& all, const pipeline::PartShape& shape,
                                    const geometry::View& view) {
  const mesh::Bounds bounds = mesh::boundsOf(shape.mesh);
  const auto off = [&](const Lines& lines) {
    std::vector<double> rows;
    for (const auto& line : lines) {
      for (const PicturePoint p : line) rows.push_back(geometry::inModel(view, p).y);
    }
    const auto [low, high] = std::ranges::minmax(rows);
    return std::abs(low - bounds.low[1]) + std::abs(high - bounds.high[1]);
  };
  const auto nearest = std::ranges::min_element(all, {}, off);
  return nearest == all.end() ? std::nullopt : std::optional(*nearest);
}

/// Adds what gives a part of `next` this side outline, and does it there. Errors: as of sideStage, and Cancelled where
/// the part has no solid.
Status addSide(Env env, PartId id, document::Outline drawn, document::Document& next,
               std::vector<document::Action>& actions) {
  const document::Part& part = *document::findPart(next, id);
  if (document::sideOf(part.recipe) == nullptr) return Error::TakesNoSide;
  if (!isSeenAside(next, part, drawn.picture)) return Error::ViewInvalid;
  const pipeline::PartShape* shape = shapeOf(env.studio.document(), env.studio.derived(), id);
  if (shape == nullptr) return Error::Cancelled;
  DrawnSide side = withSide(next, part, *shape, std::move(drawn));
  std::vector<document::Action> own;
  if (side.view) {
    own.push_back(document::SetView{side.side.picture, document::PictureView{document::pictureOf(part), *side.view}});
  }
  own.push_back(document::SetSide{id, std::move(side.side)});
  for (const document::Action& action : own) {
    Result<document::Document> changed = document::update(next, action);
    if (!changed) return changed.failure();
    next = std::move(changed).value();
    actions.push_back(action);
  }
  pipeline::PartShape made = *shape;
  return pipeline::sideStage(document::findPart(next, id)->recipe, next, made);
}

Outcome refuseSide(const Failure& failure) {
  if (failure.error == Error::Cancelled)
    return Refusal{"NotNow", "This part has no solid now. Give it back its own depth."};
  return refuse(failure);
}

Outcome fitSide(Env env, const Json& args) {
  const std::vector<PartId> parts = partsFrom(env, args);
  if (parts.empty()) return noPart();
  const auto given = linesFrom(args);
  if (!given) return missingLines();
  document::Document next = env.studio.document();
  std::vector<document::Action> actions;
  for (const PartId id : parts) {
    const document::Part& part = *document::findPart(next, id);
    if (document::sideOf(part.recipe) == nullptr) return refuse({Error::TakesNoSide, {}});
    const PictureId picture = pictureFrom(args, "picture", sidePictureOf(env, part));
    if (!picture) {
      return Refusal{"NotNow", "No picture shows this part from the side. Open one and say from where it looks."};
    }
    Lines lines = *given;
    const pipeline::PartShape* shape = shapeOf(env.studio.document(), env.studio.derived(), id);
    if (lines.empty() && shape != nullptr && isSeenAside(next, part, picture)) {
      const auto view = document::viewOn(next, picture, document::pictureOf(part));
      const auto drawn = nearestOutline(outlinesIn(next, picture, id), *shape, *view.value());
      if (!drawn) {
        return Refusal{"NotNow", "Nothing is drawn in the side picture. Draw round the thing there, or cut it out."};
      }
      lines = *drawn;
    }
    if (Status added = addSide(env, id, {picture, lines}, next, actions); !added) return refuseSide(added.failure());
  }
  return outcomeOf(env.studio.act(actions));
}

/// The depth of the parts is their own again.
Outcome plainSide(Env env, const Json& args) {
  const std::vector<PartId> parts = partsFrom(env, args);
  if (parts.empty()) return noPart();
  return setOnAll(env, parts, [](const document::Part& part) -> std::optional<document::Action> {
    const std::optional<document::Outline>* side = document::sideOf(part.recipe);
    if (side == nullptr || !*side) return std::nullopt;
    return document::SetSide{part.id, std::nullopt};
  });
}

constexpr Argument kKind{"kind"}, kLine{"line"}, kOf{"of"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "draw-shape", .label = "Shape by numbers", .icon = "wine", .group = "part", .argument = kKind,
            .hint = "A ball, a box or another shape in picture pixels", .enabled = hasPicture, .run = drawShapeRow},
    Command{.id = "shape-outline", .label = "Outline of a shape by numbers", .icon = "lasso", .group = "part",
            .argument = kLine, .hint = "A line in picture pixels", .enabled = kHasShape, .run = shapeOutline},
    Command{.id = "set-view", .label = "Side picture by numbers", .icon = "move", .group = "part", .argument = kOf,
            .hint = "Which picture shows another one from a side", .enabled = hasPicture, .run = setView},
    Command{.id = "fit-side", .label = "Fit to the side", .icon = "columns-2", .group = "part",
            .hint = "As deep as the outline in the side picture", .enabled = kTakesSide, .run = fitSide},
    Command{.id = "plain-side", .label = "Depth as it was", .icon = "rotate-ccw", .group = "part",
            .hint = "The outline from the side goes", .enabled = kHasSide, .run = plainSide},
};
// clang-format on

}  // namespace

Outcome setSide(Env env, PartId id, document::Outline drawn) {
  if (document::findPart(env.studio.document(), id) == nullptr) return noPart();
  document::Document next = env.studio.document();
  std::vector<document::Action> actions;
  if (Status added = addSide(env, id, std::move(drawn), next, actions); !added) return refuseSide(added.failure());
  if (const Status status = env.studio.act(actions); !status) return refuse(status.failure());
  sendStatus(env.host, "The part has this side now.");
  return {};
}

Status checkMade(Env env, const document::ShapeRecipe& recipe) {
  const document::Document& document = env.studio.document();
  if (Status drawn = document::checkShape(document, recipe); !drawn) return drawn;
  const image::Size size = document::findPicture(document, recipe.picture)->size;
  const auto made = pipeline::outlineStage(recipe, document, size);
  return made ? Status(Done{}) : Status(made.failure());
}

Outcome drawShape(Env env, const document::ShapeRecipe& recipe, bool lie) {
  if (const Status made = checkMade(env, recipe); !made) return refuse(made.failure());
  const document::DrawShape draw{recipe.picture, recipe.shape, recipe.outlines, env.ui.look};
  const Standing standing = standingActions(env, draw, recipe, lie);
  if (const Status status = env.studio.act(standing.actions); !status) return refuse(status.failure());
  takeMade(env, standing);
  return {};
}

Outcome reshape(Env env, PartId id, const document::ShapeRecipe& recipe) { return reshape(env, id, recipe, {}); }

Outcome reshape(Env env, PartId id, const document::ShapeRecipe& recipe, std::string_view burst) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr) return noPart();
  const document::ShapeRecipe* own = document::shapeOf(*part);
  if (own == nullptr) return refuse({Error::NotAShape, {}});
  if (const Status made = checkMade(env, recipe); !made) return refuse(made.failure());
  std::vector<document::Action> actions;
  if (!(own->shape == recipe.shape)) actions.push_back(document::SetShape{id, recipe.shape});
  if (!(own->outlines == recipe.outlines)) actions.push_back(document::SetOutlines{id, recipe.outlines});
  return actions.empty() ? Outcome() : outcomeOf(env.studio.act(actions, burst));
}

std::span<const Command> shapeCommands() { return kTable; }

}  // namespace spineloft::app
