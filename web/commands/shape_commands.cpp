// Commands about shapes and about pictures that are sides of others.
#include <algorithm>
#include <array>

#include "engine/document/checks.h"
#include "engine/io/json_fields.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
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

constexpr Argument kKind{"kind"}, kLine{"line"}, kOf{"of"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "draw-shape", .label = "Shape by numbers", .icon = "wine", .group = "part", .argument = kKind,
            .hint = "A ball, a box or another shape in picture pixels", .enabled = hasPicture, .run = drawShapeRow},
    Command{.id = "shape-outline", .label = "Outline of a shape by numbers", .icon = "lasso", .group = "part",
            .argument = kLine, .hint = "A line in picture pixels", .enabled = kHasShape, .run = shapeOutline},
    Command{.id = "set-view", .label = "Side picture by numbers", .icon = "move", .group = "part", .argument = kOf,
            .hint = "Which picture shows another one from a side", .enabled = hasPicture, .run = setView},
};
// clang-format on

}  // namespace

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
