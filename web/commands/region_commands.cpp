// Commands about parts made of regions: drawing them anew, and puffs and flat pieces.
#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "engine/document/checks.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/region.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/io/json_fields.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/section_json.h"
#include "web/edit/preview.h"
#include "web/edit/puff_bones.h"
#include "web/edit/region_editing.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool inflateTool(Env env) { return env.ui.tool == ToolKind::Inflate; }
bool extrudeTool(Env env) { return env.ui.tool == ToolKind::Extrude; }

/// The part made of a region that is meant, or null.
const document::Part* regionPart(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  return part != nullptr && document::regionOf(part->recipe) != nullptr ? part : nullptr;
}

Outcome noRegion(Env env, const Json& args) {
  return refuse({partOf(env, args) ? Error::NotARegion : Error::NoSuchPart, {}});
}

Outcome use(Env env, ToolKind tool, std::string_view hint) {
  env.ui.tool = tool;
  env.ui.redraw = env.ui.pointsOf = {};
  env.ui.cutBy = CutBy::Outline;
  env.ui.focus = Focus::Picture;
  sendStatus(env.host, hint);
  return {};
}
Outcome useInflate(Env env, const Json&) {
  return use(env, ToolKind::Inflate, "Draw a line round a thing, or tap it: it swells.");
}
Outcome useExtrude(Env env, const Json&) {
  return use(env, ToolKind::Extrude, "Draw a line round a thing, or tap it: it becomes a flat piece.");
}

/// What the arguments say about a region: `line` as a hand draws it, `contours` as they are, or `lines`
/// with the pen's `width`. None when they say nothing.
std::optional<document::Region> regionFrom(Env env, const Json& args, PictureId picture) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), picture);
  if (entry == nullptr) return std::nullopt;
  if (auto line = strokeOf(args, "line")) return regionOfLine(picture, std::move(*line), entry->size);
  const bool open = args.find("contours") == nullptr;
  auto lines = linesOf(args, open ? "lines" : "contours");
  if (!lines) return std::nullopt;
  document::Region region{picture, std::move(*lines), 0};
  if (open) {
    const int side = std::max(entry->size.width, entry->size.height);
    region.ribbon = args.number("width").value_or(0.03 * side);
  }
  return region;
}
Outcome missingRegion() {
  return missing("a line: a list of [x, y] picture pixels round the thing (or contours, or lines)");
}

/// Whether a line went round something twice, or round two things. Where it crosses itself pieces may still hang
/// together by a thread, and a hole may be open by one, so that areas tell: those of a line that goes round once
/// agree, but for the small loop where a hand closes it.
bool crossesItself(const document::Region& region, const geometry::Contours& made) {
  constexpr double kLoop = 0.05;        // of the area
  if (region.ribbon > 0) return false;  // open lines may cross; they are one ribbon there
  if (made.size() > region.contours.size()) return true;
  if (region.contours.size() != 1) return false;
  const double round = std::abs(geometry::signedArea(std::span<const PicturePoint>(region.contours.front())));
  const double left = std::abs(geometry::areaOf(made));
  return std::abs(round - left) > kLoop * left;
}

/// The same of a profile: what crosses the axis is cut off there, and what a line goes round twice is left hollow.
void reportProfile(Env env, const document::Region& region, const lathe::LatheParams& params) {
  constexpr double kSlip = 0.02;  // of the axis: less is a hand on it
  const PicturePoint along = params.axisTo - params.axisFrom;
  double least = 0, most = 0;
  for (const auto& contour : region.contours) {
    for (const PicturePoint p : contour) {
      const double aside = cross(along, p - params.axisFrom) / dot(along, along);
      least = std::min(least, aside);
      most = std::max(most, aside);
    }
  }
  const bool crosses =
      std::ranges::any_of(region.contours, [](const auto& line) { return geometry::findCrossing(line).has_value(); });
  if (crosses) {
    sendHint(env.host,
             "Your line crosses itself: what it goes round twice is hollow. Undo, and draw it without a loop.");
  } else if (least < -kSlip && most > kSlip) {
    sendStatus(env.host, "What lies beyond the dashed line is cut off.");
  }
}

/// Says so when a part of what was drawn is cut off, or when a line went round more than it seems: `made` is what is
/// left of it.
void reportChanges(Env env, const document::Recipe& recipe, const geometry::Contours& made) {
  const document::Region& region = *document::regionOf(recipe);
  if (const auto* spun = std::get_if<document::LatheRecipe>(&recipe)) {
    reportProfile(env, region, spun->lathe);
    return;
  }
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), region.picture);
  if (entry == nullptr) return;
  const double room = 1;  // pixels: less is a hand at the edge
  for (const auto& contour : region.contours) {
    for (const PicturePoint p : contour) {
      if (p.x >= -room && p.y >= -room && p.x <= entry->size.width - 1 + room && p.y <= entry->size.height - 1 + room) {
        continue;
      }
      sendStatus(env.host, "What lies outside the picture is cut off.");
      return;
    }
  }
  if (!crossesItself(region, made)) return;
  sendHint(env.host,
           "Your line crosses itself: that makes more than one piece, or a hole. Undo, and go round once for one.");
}

Result<inflate::InflateParams> inflateFrom(const Json& args, inflate::InflateParams params) {
  params.height = args.number("height").value_or(params.height);
  if (const std::string* sides = args.text("sides")) {
    if (!io::fromKey(*sides, params.sides)) return {Error::ValueOutOfRange, *sides};
  }
  return params;
}
Result<extrude::ExtrudeParams> extrudeFrom(const Json& args, extrude::ExtrudeParams params) {
  params.thickness = args.number("thickness").value_or(params.thickness);
  params.edgeSize = args.number("edgeSize").value_or(params.edgeSize);
  params.depth = args.number("depth").value_or(params.depth);
  if (const std::string* edge = args.text("edge")) {
    if (!io::fromKey(*edge, params.edge)) return {Error::ValueOutOfRange, *edge};
  }
  return params;
}

Outcome drawInflated(Env env, const Json& args) {
  auto region = regionFrom(env, args, env.ui.picture);
  if (!region) return missingRegion();
  const Result<inflate::InflateParams> params = inflateFrom(args, env.ui.inflate);
  if (!params) return refuse(params.failure());
  return drawRegion(env, *region, params.value(), args.flag("lie").value_or(false));
}
Outcome drawExtruded(Env env, const Json& args) {
  auto region = regionFrom(env, args, env.ui.picture);
  if (!region) return missingRegion();
  const Result<extrude::ExtrudeParams> params = extrudeFrom(args, env.ui.extrude);
  if (!params) return refuse(params.failure());
  return drawRegion(env, *region, params.value(), args.flag("lie").value_or(false));
}

Outcome redrawRegionRow(Env env, const Json& args) {
  const document::Part* part = regionPart(env, args);
  if (part == nullptr) return noRegion(env, args);
  const auto region = regionFrom(env, args, document::pictureOf(*part));
  return region ? redrawRegion(env, part->id, *region) : missingRegion();
}

Outcome movePointRow(Env env, const Json& args) {
  const document::Part* part = regionPart(env, args);
  if (part == nullptr) return noRegion(env, args);
  const std::optional<PicturePoint> to = pointOf(args, "to");
  const double contour = args.number("contour").value_or(0), point = args.number("point").value_or(-1);
  if (!to || !isFinite(*to)) return missing("where to: [x, y] in picture pixels");
  if (!(contour >= 0 && contour < 1e6 && point >= 0 && point < 1e6)) return refuse({Error::ValueOutOfRange, "point"});
  return moveOutlinePoint(env, part->id, {static_cast<std::size_t>(contour), static_cast<std::size_t>(point)}, *to);
}

/// The way of the parts that are meant, or of the next one, with a change. The selected one becomes this kind if it is
/// another; others keep theirs and do not change.
template <class Recipe, class Params, class Change>
Outcome shapeAll(Env env, const Json& args, Params& next, Params Recipe::* member, const Change& change) {
  const document::Part* lead = regionPart(env, args);
  const Recipe* recipe = lead ? std::get_if<Recipe>(&lead->recipe) : nullptr;
  if (recipe) next = recipe->*member;
  change(next);
  if (lead == nullptr) return {};
  return setOnAll(env, partsFrom(env, args), [&](const document::Part& part) -> std::optional<document::Action> {
    const Recipe* own = std::get_if<Recipe>(&part.recipe);
    if (own == nullptr && part.id != lead->id) return std::nullopt;
    Params params = own ? own->*member : next;
    if (own) change(params);
    return document::ShapeRegion{part.id, params};
  });
}
template <class Change>
Outcome shapeInflate(Env env, const Json& args, const Change& change) {
  return shapeAll(env, args, env.ui.inflate, &document::InflateRecipe::inflate, change);
}
template <class Change>
Outcome shapeExtrude(Env env, const Json& args, const Change& change) {
  return shapeAll(env, args, env.ui.extrude, &document::ExtrudeRecipe::extrude, change);
}

template <inflate::InflateSides kSides>
Outcome setSides(Env env, const Json& args) {
  return shapeInflate(env, args, [](inflate::InflateParams& params) { params.sides = kSides; });
}
template <inflate::InflateSides kSides>
bool hasSides(Env env) {
  const document::Part* part = regionPart(env, {});
  if (part != nullptr) return document::inflateOf(*part) && document::inflateOf(*part)->inflate.sides == kSides;
  return env.ui.inflate.sides == kSides;
}
template <inflate::Across kAcross>
Outcome setAcross(Env env, const Json& args) {
  const document::Part* part = regionPart(env, args);
  if (part == nullptr || document::inflateOf(*part) == nullptr) return noRegion(env, args);
  return shapeInflate(env, args, [&](inflate::InflateParams& params) {
    params.profile.across = kAcross;
    params.profile.reach = args.number("reach").value_or(params.profile.reach);
  });
}
template <inflate::Across kAcross>
bool hasAcross(Env env) {
  const document::Part* part = regionPart(env, {});
  return part && document::inflateOf(*part) && document::inflateOf(*part)->inflate.profile.across == kAcross;
}
template <extrude::EdgeKind kEdge>
Outcome setEdge(Env env, const Json& args) {
  return shapeExtrude(env, args, [](extrude::ExtrudeParams& params) { params.edge = kEdge; });
}
template <extrude::EdgeKind kEdge>
bool hasEdge(Env env) {
  const document::Part* part = regionPart(env, {});
  if (part != nullptr) return document::extrudeOf(*part) && document::extrudeOf(*part)->extrude.edge == kEdge;
  return env.ui.extrude.edge == kEdge;
}

/// {slice: "roof"}, or a slice as shapeFrom reads it; with `at` of one place.
Outcome setProfileRow(Env env, const Json& args) {
  inflate::ProfileParams profile;
  if (const std::string* key = args.text("slice")) {
    const std::optional<inflate::ProfileParams> ready = inflate::readyProfile(*key);
    if (!ready) return refuse({Error::ValueOutOfRange, *key});
    profile = *ready;
  } else {
    const Result<std::optional<sections::SectionShape>> shape = shapeFrom(args, env.ui.sections);
    if (!shape) return refuse(shape.failure());
    if (!shape.value()) return missing("a slice: soft, round, roof, block, step, bowl, ring or two-rings");
    profile.slices = {{*shape.value()}};
    profile.follow = args.number("follow").value_or(profile.follow);
  }
  if (args.find("at") == nullptr) return setProfile(env, partsFrom(env, args), profile);
  const document::Part* part = regionPart(env, args);
  const std::optional<PicturePoint> at = pointOf(args, "at");
  if (!at) return missing("a place on a bone: at, [x, y] in picture pixels");
  if (profile.isSoft()) return refuse({Error::ValueOutOfRange, "soft"});
  return part ? setSliceAt(env, part->id, *at, profile.slices.front().shape) : noRegion(env, args);
}
void profileChoices(Env env, JsonWriter& json) {
  const document::Part* part = regionPart(env, {});
  const document::InflateRecipe* puff = part ? document::inflateOf(*part) : nullptr;
  const std::string_view now = inflate::profileKey((puff ? puff->inflate : env.ui.inflate).profile);
  for (const auto& [key, label] : inflate::readyProfiles()) writeChoice(json, key, label, key == now);
}

bool isInflated(Env env) {
  const document::Part* part = regionPart(env, {});
  return part != nullptr && document::inflateOf(*part) != nullptr;
}
bool isExtruded(Env env) {
  const document::Part* part = regionPart(env, {});
  return part != nullptr && document::extrudeOf(*part) != nullptr;
}
Outcome makeInflated(Env env, const Json& args) {
  if (regionPart(env, args) == nullptr) return noRegion(env, args);
  return shapeInflate(env, args, [](inflate::InflateParams&) {});
}
Outcome makeExtruded(Env env, const Json& args) {
  if (regionPart(env, args) == nullptr) return noRegion(env, args);
  return shapeExtrude(env, args, [](extrude::ExtrudeParams&) {});
}

/// More or less of what makes the part high: one notch.
Outcome notch(Env env, const Json& args, double factor) {
  const document::Part* part = regionPart(env, args);
  if (part == nullptr) return noRegion(env, args);
  if (document::inflateOf(*part)) {
    return shapeInflate(env, args, [&](inflate::InflateParams& params) {
      params.height = std::clamp(params.height * factor, inflate::kLeastHeight, inflate::kMostHeight);
    });
  }
  if (document::extrudeOf(*part) == nullptr) return refuse({Error::NotARegion, {}});
  return shapeExtrude(env, args, [&](extrude::ExtrudeParams& params) {
    params.thickness = std::clamp(params.thickness * factor, extrude::kLeastThickness, extrude::kMostThickness);
  });
}
constexpr double kNotch = 1.25;
Outcome thicker(Env env, const Json& args) { return notch(env, args, kNotch); }
Outcome thinner(Env env, const Json& args) { return notch(env, args, 1 / kNotch); }

bool sliceIsSelected(Env env) {
  const document::Part* part = regionPart(env, {});
  return part && document::inflateOf(*part) && !document::inflateOf(*part)->inflate.profile.isSoft();
}
constexpr Condition hasSlice{sliceIsSelected, Condition::Part};

constexpr Argument kLine{"line"}, kPoint{"to"};
using inflate::InflateSides, extrude::EdgeKind;

// clang-format off
constexpr std::array kTable = {
    Command{.id = "puff", .label = "Puff", .icon = "cloud", .shortcut = "U", .group = "tool",
            .hint = "Draw round a thing or tap it: it swells", .enabled = hasPicture, .toggled = inflateTool,
            .run = useInflate},
    Command{.id = "sheet", .label = "Flat piece", .icon = "puzzle", .shortcut = "Y", .group = "tool",
            .hint = "Draw round a thing or tap it: it becomes a flat piece", .enabled = hasPicture,
            .toggled = extrudeTool, .run = useExtrude},
    Command{.id = "puff-both", .label = "Both sides", .icon = "unfold-vertical", .group = "part",
            .hint = "The puff swells to the front and to the back", .enabled = hasPicture,
            .toggled = hasSides<InflateSides::Both>, .run = setSides<InflateSides::Both>},
    Command{.id = "puff-front", .label = "Front only", .icon = "arrow-down-from-line", .group = "part",
            .hint = "The puff has a flat back", .enabled = hasPicture, .toggled = hasSides<InflateSides::Front>,
            .run = setSides<InflateSides::Front>},
    Command{.id = "puff-back", .label = "Back only", .icon = "arrow-up-from-line", .group = "part",
            .hint = "The puff has a flat front", .enabled = hasPicture, .toggled = hasSides<InflateSides::Back>,
            .run = setSides<InflateSides::Back>},
    Command{.id = "puff-slice", .label = "Slice of the puff", .icon = "slice", .group = "part",
            .argument = {"slice", profileChoices}, .hint = "What a cut through the puff looks like",
            .enabled = hasPicture, .run = setProfileRow},
    Command{.id = "slice-whole", .label = "Whole width", .icon = "unfold-vertical", .group = "part",
            .hint = "The slice of the puff goes from the bone to the outline", .enabled = hasSlice,
            .toggled = hasAcross<inflate::Across::Share>, .run = setAcross<inflate::Across::Share>},
    Command{.id = "slice-edge", .label = "Same edge", .icon = "circle-dot", .group = "part",
            .hint = "The slice of the puff is an edge of the same width all round, flat within", .enabled = hasSlice,
            .toggled = hasAcross<inflate::Across::Length>, .run = setAcross<inflate::Across::Length>},
    Command{.id = "edge-sharp", .label = "Sharp edge", .icon = "square", .group = "part",
            .hint = "The flat piece has a sharp edge", .enabled = hasPicture, .toggled = hasEdge<EdgeKind::Sharp>,
            .run = setEdge<EdgeKind::Sharp>},
    Command{.id = "edge-bevel", .label = "Cut edge", .icon = "diamond", .group = "part",
            .hint = "The edge of the flat piece is cut off slantwise", .enabled = hasPicture,
            .toggled = hasEdge<EdgeKind::Bevel>, .run = setEdge<EdgeKind::Bevel>},
    Command{.id = "edge-round", .label = "Round edge", .icon = "circle-dot", .group = "part",
            .hint = "The flat piece has a round edge", .enabled = hasPicture, .toggled = hasEdge<EdgeKind::Round>,
            .run = setEdge<EdgeKind::Round>},
    Command{.id = "make-puff", .label = "Make it a puff", .icon = "cloud", .group = "part",
            .hint = "The flat piece swells", .enabled = hasRegion, .toggled = isInflated, .run = makeInflated},
    Command{.id = "make-sheet", .label = "Make it flat", .icon = "puzzle", .group = "part",
            .hint = "The puff becomes a flat piece", .enabled = hasRegion, .toggled = isExtruded, .run = makeExtruded},
    Command{.id = "thicker", .label = "Thicker", .icon = "plus", .shortcut = "Shift+U", .group = "part",
            .hint = "A higher puff, a thicker piece", .enabled = hasRegion, .run = thicker},
    Command{.id = "thinner", .label = "Thinner", .icon = "minus", .shortcut = "Shift+Y", .group = "part",
            .hint = "A lower puff, a thinner piece", .enabled = hasRegion, .run = thinner},
    Command{.id = "draw-puff", .label = "Puff by numbers", .icon = "cloud", .group = "part", .argument = kLine,
            .hint = "A line in picture pixels", .enabled = hasPicture, .run = drawInflated},
    Command{.id = "draw-sheet", .label = "Flat piece by numbers", .icon = "puzzle", .group = "part", .argument = kLine,
            .hint = "A line in picture pixels", .enabled = hasPicture, .run = drawExtruded},
    Command{.id = "redraw-region", .label = "New outline by numbers", .icon = "lasso", .group = "part",
            .argument = kLine, .hint = "A line in picture pixels", .enabled = hasRegion, .run = redrawRegionRow},
    Command{.id = "move-outline-point", .label = "Move an outline point by numbers", .icon = "move", .group = "part",
            .argument = kPoint, .hint = "A point of the outline and where it goes", .enabled = hasRegion,
            .run = movePointRow},
};
// clang-format on

}  // namespace

bool regionIsSelected(const CommandEnv& env) { return regionPart(env, {}) != nullptr; }

Result<geometry::Contours> outlinesFor(Env env, const document::Recipe& recipe) {
  const document::Document& document = env.studio.document();
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(recipe));
  if (entry == nullptr) return Error::NoSuchPicture;
  if (Status drawn = document::checkDrawn(document, recipe); !drawn) return drawn.failure();
  if (std::holds_alternative<document::LatheRecipe>(recipe)) {
    Result<pipeline::PartShape> spun = pipeline::regionStage(recipe, entry->size);
    if (!spun) return spun.failure();
    return std::move(spun.value().contours);
  }
  const document::Region* region = document::regionOf(recipe);
  if (region == nullptr) return Error::NotARegion;
  return geometry::cleanRegion(region->contours, region->ribbon,
                               {static_cast<double>(entry->size.width), static_cast<double>(entry->size.height)});
}

Outcome drawRegion(Env env, const document::Region& region, const document::RegionSolid& solid, bool lie) {
  const document::Recipe recipe = document::recipeOf(region, solid);
  const Result<geometry::Contours> made = outlinesFor(env, recipe);
  if (!made) return refuse(made.failure());
  const Standing standing = standingActions(env, document::DrawRegion{region, solid, env.ui.look}, recipe, lie);
  const Status status = env.studio.act(standing.actions);
  if (!status) return refuse(status.failure());
  reportChanges(env, recipe, made.value());
  if (const auto* spun = std::get_if<lathe::LatheParams>(&solid)) {
    env.ui.lathe.axisFrom = spun->axisFrom;
    env.ui.lathe.axisTo = spun->axisTo;
    env.ui.axisOf = region.picture;
  }
  takeMade(env, standing);
  return {};
}

Outcome setProfile(Env env, const Parts& parts, const inflate::ProfileParams& profile) {
  inflate::InflateParams next = env.ui.inflate;
  next.profile = profile;
  if (const Status status = document::checkSolid(next); !status) return refuse(status.failure());
  env.ui.inflate = std::move(next);
  if (parts.empty()) return {};
  return setOnAll(env, parts, [&](const document::Part& part) -> std::optional<document::Action> {
    const document::InflateRecipe* own = document::inflateOf(part);
    if (own == nullptr) return std::nullopt;
    inflate::InflateParams params = own->inflate;
    params.profile = withBase(params.profile, profile);
    return document::ShapeRegion{part.id, params};
  });
}

Outcome redrawRegion(Env env, PartId id, const document::Region& region) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr) return noPart();
  document::Recipe recipe = part->recipe;
  document::Region* own = document::regionOf(recipe);
  if (own == nullptr) return refuse({Error::NotARegion, {}});
  *own = region;
  const Result<geometry::Contours> made = outlinesFor(env, recipe);
  if (!made) return refuse(made.failure());
  reportChanges(env, recipe, made.value());
  const Status status = env.studio.act(document::RedrawRegion{id, region});
  if (!status) return refuse(status.failure());
  env.ui.selection = id;
  env.ui.redraw = {};
  return {};
}

Outcome moveOutlinePoint(Env env, PartId id, OutlinePoint at, PicturePoint to) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  const document::Region* region = part ? document::regionOf(part->recipe) : nullptr;
  if (region == nullptr) return refuse({part ? Error::NotARegion : Error::NoSuchPart, {}});
  if (at.contour >= region->contours.size() || at.point >= region->contours[at.contour].size()) {
    return refuse({Error::ValueOutOfRange, "point"});
  }
  return redrawRegion(env, id, withMovedPoint(*region, at, to));
}

std::span<const Command> regionCommands() { return kTable; }

}  // namespace spineloft::app
