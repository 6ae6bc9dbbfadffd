// Commands about single points of the outline of what is made of a region, for keys.
#include <array>
#include <string>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/modes.h"
#include "web/edit/region_editing.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

const document::Part* shownRegion(Env env) {
  const document::Part* part = document::findPart(env.studio.document(), env.ui.selection);
  const bool shown =
      part != nullptr && document::regionOf(part->recipe) != nullptr && document::pictureOf(*part) == env.ui.picture;
  return shown ? part : nullptr;
}
bool byKeys(Env env) { return drawsRegions(env.ui.tool) && !env.ui.cut && shownRegion(env) != nullptr; }
bool pointByKeys(Env env) { return byKeys(env) && env.ui.chosen.outline && env.ui.focus == Focus::Picture; }

Outcome step(Env env, int by) {
  const document::Region& region = *document::regionOf(shownRegion(env)->recipe);
  takePoints(env.ui, *shownRegion(env));
  env.ui.chosen = {std::nullopt, -1, neighbourHandle(region, env.ui.chosen.outline, by)};
  if (!env.ui.chosen.outline) return {};
  const std::vector<OutlinePoint> handles = outlineHandles(region);
  std::size_t number = 1;
  while (number < handles.size() && !(handles[number - 1] == *env.ui.chosen.outline)) ++number;
  sendStatus(env.host,
             words::tr("Point {n} of {all} of the outline. Arrows move it.", {{"n", number}, {"all", handles.size()}}));
  env.ui.focus = Focus::Picture;
  return {};
}
Outcome next(Env env, const Json&) { return step(env, 1); }
Outcome previous(Env env, const Json&) { return step(env, -1); }

/// The region with this outline, if a solid can be made of it. Keys one after the other are one step.
Outcome change(Env env, document::Region region, const std::string& burst) {
  document::Recipe recipe = shownRegion(env)->recipe;
  *document::regionOf(recipe) = region;
  const auto outlines = outlinesFor(env, recipe);
  if (!outlines) return refuse(outlines.failure());
  const document::Action action = document::RedrawRegion{env.ui.selection, std::move(region)};
  return outcomeOf(env.studio.act({&action, 1}, burst));
}

Outcome nudge(Env env, const Json& args) {
  const document::Region& region = *document::regionOf(shownRegion(env)->recipe);
  const OutlinePoint at = *env.ui.chosen.outline;
  const std::optional<PicturePoint> by = nudgeOf(args);
  if (!by || !isFinite(*by)) return missing("how far: by [x, y] in picture pixels");
  return change(env, withMovedPoint(region, at, pointOf(region, at) + *by),
                "outline " + std::to_string(env.ui.selection.value) + " " + std::to_string(at.contour) + " " +
                    std::to_string(at.point));
}

Outcome add(Env env, const Json&) {
  const document::Region& region = *document::regionOf(shownRegion(env)->recipe);
  std::optional<AddedPoint> added = withAddedPoint(region, *env.ui.chosen.outline);
  if (!added) return refuse({Error::ValueOutOfRange, "point"});
  const OutlinePoint at = added->at;
  if (!(added->region == region)) {
    if (Outcome done = change(env, std::move(added->region), {}); !done) return done;
  }
  env.ui.chosen.outline = at;
  return {};
}

Outcome remove(Env env, const Json&) {
  const document::Region& region = *document::regionOf(shownRegion(env)->recipe);
  const OutlinePoint at = *env.ui.chosen.outline;
  std::optional<document::Region> left = withoutPoint(region, at);
  if (!left) {
    return Refusal{"NotNow", "An outline keeps at least three points, an open line two. Delete the part instead."};
  }
  const std::optional<OutlinePoint> before = neighbourHandle(region, at, -1);
  if (Outcome done = change(env, std::move(*left), {}); !done) return done;
  // What comes before the point keeps its number, unless the outline begins anew.
  env.ui.chosen.outline =
      before && before->contour == at.contour && before->point < at.point ? before : OutlinePoint{at.contour, 0};
  return {};
}

constexpr Argument kBy{"by"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "next-outline-point", .label = "Next outline point", .icon = "chevron-right", .shortcut = ".",
            .group = "part", .hint = "Choose the next point of the outline", .enabled = byKeys, .run = next,
            .mode = &kOutlineMode},
    Command{.id = "previous-outline-point", .label = "Outline point before", .icon = "chevron-left", .shortcut = ",",
            .group = "part", .hint = "Choose the point of the outline before", .enabled = byKeys, .run = previous,
            .mode = &kOutlineMode},
    Command{.id = "nudge-outline-point", .label = "Move the outline point", .icon = "move", .shortcut = kArrowKeys,
            .group = "part", .argument = kBy, .hint = "Arrow keys move the chosen point, with Shift by ten pixels",
            .enabled = pointByKeys, .run = nudge, .mode = &kOutlinePointMode},
    Command{.id = "add-outline-point", .label = "Add outline point", .icon = "circle-plus", .shortcut = "Insert, A",
            .group = "part", .hint = "One more point between the chosen one and the next", .enabled = pointByKeys,
            .run = add, .mode = &kOutlinePointMode},
    Command{.id = "delete-outline-point", .label = "Delete outline point", .icon = "circle-minus",
            .shortcut = "Delete, Backspace", .group = "part", .hint = "The outline goes straight past the chosen point",
            .enabled = pointByKeys, .run = remove, .mode = &kOutlinePointMode},
};
// clang-format on

}  // namespace

constinit const Mode kOutlineMode{"outline", byKeys};
constinit const Mode kOutlinePointMode{"outline-point", pointByKeys};

std::span<const Command> outlineCommands() { return kTable; }

}  // namespace spineloft::app
