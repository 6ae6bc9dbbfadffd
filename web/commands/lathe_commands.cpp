// Commands about spun parts.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/lathe/rounded.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/edit/outline.h"
#include "web/edit/spinning.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool spinTool(Env env) { return env.ui.tool == ToolKind::Spin; }

Outcome useSpin(Env env, const Json&) {
  env.ui.tool = ToolKind::Spin;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.focus = Focus::Picture;
  sendStatus(env.host, "Draw one side of a thing, beside the dashed line: it is turned round.");
  return {};
}

/// [[x, y], [x, y]] under "axis".
std::optional<std::array<PicturePoint, 2>> axisFrom(const Json& args) {
  const auto line = strokeOf(args, "axis");
  if (!line || line->size() != 2) return std::nullopt;
  return std::array{line->front(), line->back()};
}

/// What the arguments say about a profile: `line` as a hand draws it, `contours` closed, or open `lines`.
std::optional<document::Region> profileFrom(Env env, const Json& args) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), env.ui.picture);
  if (entry == nullptr) return std::nullopt;
  if (const auto line = strokeOf(args, "line")) return profileOfLine(entry->id, *line, entry->size);
  const bool open = args.find("contours") == nullptr;
  auto lines = linesOf(args, open ? "lines" : "contours");
  if (!lines) return std::nullopt;
  document::Region region{entry->id, std::move(*lines), 0, open};
  return region;
}

Outcome drawLathe(Env env, const Json& args) {
  const auto region = profileFrom(env, args);
  if (!region) return missing("a line: a list of [x, y] picture pixels beside the axis (or contours, or lines)");
  lathe::LatheParams params = nextLathe(env.studio.document(), env.ui);
  if (args.find("axis") != nullptr) {
    const auto axis = axisFrom(args);
    if (!axis) return missing("an axis: [[x, y], [x, y]] in picture pixels");
    params.axisFrom = axis->front();
    params.axisTo = axis->back();
  }
  params.turn = args.number("turn").value_or(params.turn);
  params.wall = args.number("wall").value_or(params.wall);
  params.squash = args.number("squash").value_or(params.squash);
  const double sides = args.number("sides").value_or(params.sides);
  if (!(sides >= lathe::kLeastSides && sides <= lathe::kRoundSides)) return refuse({Error::ValueOutOfRange, "sides"});
  params.sides = static_cast<int>(std::lround(sides));
  return drawRegion(env, *region, params, args.flag("lie").value_or(false));
}

Outcome setAxisRow(Env env, const Json& args) {
  const auto axis = axisFrom(args);
  if (!axis) return missing("an axis: [[x, y], [x, y]] in picture pixels");
  const document::Part* part = partOf(env, args);
  if (namesPart(args) && (part == nullptr || document::latheOf(*part) == nullptr)) {
    return refuse({part ? Error::NotARegion : Error::NoSuchPart, {}});
  }
  const bool spun = part != nullptr && document::latheOf(*part) != nullptr;
  return setAxis(env, spun ? part->id : PartId{}, axis->front(), axis->back());
}

/// Where the part lies in its picture: closed outlines.
geometry::Contours silhouetteOf(const document::Part& part, const pipeline::PartShape& shape) {
  if (const document::LoftRecipe* loft = document::loftOf(part)) {
    std::vector<PicturePoint> outline;
    outlineOf(shape.shown, loft->loft, outline);
    return {outline};
  }
  return shape.contours;
}

Outcome makeRound(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  if (part == nullptr) return noPart();
  const PartId id = part->id;
  const auto& derived = env.studio.derived().parts;
  const auto at = std::ranges::find(derived, id, &pipeline::DerivedPart::id);
  if (at == derived.end() || !at->shape) return refuse({Error::RegionEmpty, part->name});
  const Result<lathe::Rounded> rounded = lathe::rounded(silhouetteOf(*part, *at->shape));
  if (!rounded) return refuse(rounded.failure());
  lathe::LatheParams params;
  params.axisFrom = rounded.value().axisFrom;
  params.axisTo = rounded.value().axisTo;
  const document::Region region{document::pictureOf(*part), {rounded.value().profile}, 0, true};
  if (const auto outlines = outlinesFor(env, document::recipeOf(region, params)); !outlines) {
    return refuse(outlines.failure());
  }
  const document::Action action = document::RemakePart{id, region, params};
  if (const Status status = env.studio.act({&action, 1}); !status) return refuse(status.failure());
  env.ui.selection = id;
  sendStatus(env.host, "It is round about the line through its middle. The tool Spin shows that.");
  return {};
}

constexpr Argument kLine{"line"}, kAxis{"axis"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "spin", .label = "Spin", .icon = "wine", .shortcut = "O", .group = "tool",
            .hint = "Draw one side of a thing beside a line: it is turned round", .enabled = hasPicture,
            .toggled = spinTool, .run = useSpin},
    Command{.id = "draw-lathe", .label = "Spin by numbers", .icon = "wine", .group = "part", .argument = kLine,
            .hint = "A line in picture pixels, and an axis", .enabled = hasPicture, .run = drawLathe},
    Command{.id = "make-round", .label = "Make it round", .icon = "wine", .group = "part",
            .hint = "The part becomes round about the line through its middle", .enabled = hasSelection,
            .run = makeRound},
    Command{.id = "set-axis", .label = "Axis by numbers", .icon = "move", .group = "part", .argument = kAxis,
            .hint = "Where the line lies about which a spun part is turned", .enabled = hasPicture, .run = setAxisRow},
};
// clang-format on

}  // namespace

Outcome setAxis(Env env, PartId id, PicturePoint from, PicturePoint to) {
  lathe::LatheParams params = env.ui.lathe;
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (id && part == nullptr) return noPart();
  const document::LatheRecipe* spun = part ? document::latheOf(*part) : nullptr;
  if (part != nullptr && spun == nullptr) return refuse({Error::NotARegion, {}});
  if (spun != nullptr) params = spun->lathe;
  const PictureId picture = part ? document::pictureOf(*part) : env.ui.picture;
  params.axisFrom = from;
  params.axisTo = to;
  if (!isValid(params)) return refuse({Error::ValueOutOfRange, "axis"});
  if (spun != nullptr) {
    const auto outlines = outlinesFor(env, document::recipeOf(spun->region, params));
    if (!outlines) return refuse(outlines.failure());
    if (const Status status = env.studio.act(document::ShapeRegion{id, params}); !status) {
      return refuse(status.failure());
    }
  }
  env.ui.lathe.axisFrom = from;
  env.ui.lathe.axisTo = to;
  env.ui.axisOf = picture;
  return {};
}

std::span<const Command> latheCommands() { return kTable; }

}  // namespace spineloft::app
