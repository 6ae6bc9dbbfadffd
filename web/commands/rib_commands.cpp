// Commands about ribs, and about edges that do not count.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/document/params.h"
#include "engine/ribs/edit/places.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/editing.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr double kDensityStep = 1.3;
constexpr double kBrushStep = 1.35, kLeastBrush = 3, kMostBrush = 80;  // CSS pixels
constexpr double kDefaultWithin = 0.12;  // of the picture's longer side, for a line by numbers
constexpr double kDefaultRadius = 8;     // picture pixels, of a scribble by numbers
constexpr std::array kReaches = {0.0, 0.03, 0.06, 0.1, 0.16, 0.25, 0.35, kMostReach};

Subject subjectFor(Env env, PartId part) { return subjectOf(env.studio.document(), env.studio.derived(), part); }
Subject subjectFor(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  return part ? subjectFor(env, part->id) : Subject{};
}

bool ribsTool(Env env) { return env.ui.tool == ToolKind::Ribs; }
bool shapeTool(Env env) { return env.ui.tool == ToolKind::Shape; }
bool ignoreTool(Env env) { return env.ui.tool == ToolKind::Ignore; }
bool usesBrush(Env env) { return ignoreTool(env) || env.ui.cut.has_value(); }
bool bothSides(Env env) { return env.ui.edit.bothSides; }
bool wholePicture(Env env) { return env.ui.edit.wholePicture; }
bool paintsOver(Env env) { return env.ui.edit.paintOver; }
bool softens(Env env) { return ribsTool(env) || env.ui.tool == ToolKind::Spine; }
bool ribsByKeys(Env env) { return ribsTool(env) && hasChosenRib(env); }
bool pointsByKeys(Env env) { return softens(env) && hasSpine(env); }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasMarks(Env env) { return marksOf(env.studio.document(), env.ui.picture, env.ui.selection).count() > 0; }

bool locked(Env env) {
  const Subject subject = subjectFor(env, env.ui.selection);
  if (!subject || !env.ui.chosen.end) return false;
  const auto& ribs = subject.shape->ribs.ribs;
  const std::size_t rib = env.ui.chosen.end->rib;
  return rib < ribs.size() && ribs[rib].leftState == ribs::RibState::Locked &&
         ribs[rib].rightState == ribs::RibState::Locked;
}

/// The rib end that the arguments name, else the chosen one; none when there is no such rib.
std::optional<ribs::EndRef> endFor(Env env, const Json& args, const Subject& subject) {
  std::optional<ribs::EndRef> end = args.find("rib") ? endOf(args) : env.ui.chosen.end;
  if (!end && args.find("rib") && args.find("side") == nullptr) {
    Json::Object sided = *args.object();
    sided.emplace_back("side", "left");
    end = endOf(sided);
  }
  if (!end || end->rib >= subject.shape->ribs.ribs.size()) return std::nullopt;
  return end;
}

Outcome noRib() { return Refusal{"NoSuchRib", "Choose a rib first: tap one of its ends with the Ribs tool."}; }

Outcome edit(Env env, const Subject& subject, ribs::RibEdits edits) {
  return outcomeOf(env.studio.act(document::EditRibs{subject.part->id, std::move(edits)}));
}

/// Runs `change(scene, end)` on a rib end.
template <class Change>
Outcome editEnd(Env env, PartId part, ribs::EndRef end, const Change& change) {
  const Subject subject = subjectFor(env, part);
  if (!subject) return noSpine(document::findPart(env.studio.document(), part));
  if (end.rib >= subject.shape->ribs.ribs.size()) return noRib();
  return edit(env, subject, change(sceneOf(subject), end));
}
/// The same on the one that is meant.
template <class Change>
Outcome editEnd(Env env, const Json& args, const Change& change) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const std::optional<ribs::EndRef> end = endFor(env, args, subject);
  if (!end) return noRib();
  return edit(env, subject, change(sceneOf(subject), *end));
}

/// A tool that needs a part takes the last one on the picture when none is selected.
void use(Env env, ToolKind tool) {
  env.ui.tool = tool;
  env.ui.redraw = {};
  env.ui.focus = Focus::Picture;
  if (hasSpine(env) || tool == ToolKind::Ignore) return;
  for (const document::Part& part : env.studio.document().parts) {
    const bool fits = document::pictureOf(part) == env.ui.picture && document::loftOf(part) != nullptr;
    if (fits && pipeline::isVisible(env.studio.document(), part)) env.ui.selection = part.id;
  }
}

Outcome useRibs(Env env, const Json&) {
  use(env, ToolKind::Ribs);
  return {};
}
Outcome useShape(Env env, const Json&) {
  use(env, ToolKind::Shape);
  return {};
}
Outcome useIgnore(Env env, const Json&) {
  use(env, ToolKind::Ignore);
  return {};
}

Outcome moveRibEndRow(Env env, const Json& args) {
  const std::optional<PicturePoint> to = pointOf(args, "to");
  if (!to) return missing("where to: [x, y] in picture pixels");
  if (!isFinite(*to)) return refuse({Error::ValueOutOfRange, "to"});
  const double reach = std::clamp(args.number("reach").value_or(0), 0.0, 1.0);
  return editEnd(env, args,
                 [&](const ribs::EditScene& scene, ribs::EndRef end) { return ribs::dragEnd(scene, end, *to, reach); });
}

Outcome shapeRibsRow(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const auto stroke = strokeOf(args);
  if (!stroke) return missing("a stroke: a list of [x, y] picture pixels");
  const document::PictureEntry* entry =
      document::findPicture(env.studio.document(), document::pictureOf(*subject.part));
  const int side = entry ? std::max(entry->size.width, entry->size.height) : 0;
  const double within = args.number("within").value_or(kDefaultWithin * side);
  const bool both = args.flag("both").value_or(env.ui.edit.bothSides);
  return shapeRibs(env, {subject.part->id, *stroke, within, both});
}

Outcome takePlaceRow(Env env, const Json& args) {
  const int place = static_cast<int>(std::clamp(args.number("place").value_or(0), -1.0, 9.0));
  const bool like = args.flag("like").value_or(true);
  return editEnd(env, args, [&](const ribs::EditScene& scene, ribs::EndRef end) {
    return ribs::takeOtherPlace(scene, end, place, like);
  });
}

Outcome addRib(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const auto& ribs = subject.shape->ribs.ribs;
  std::optional<PicturePoint> p = pointOf(args, "to");
  const std::optional<ribs::EndRef> end = endFor(env, args, subject);
  if (!p && args.number("at")) {
    p = ribs::Ruler(subject.shape->spine.points).pointAt(*args.number("at"));
  }
  if (!p) p = ribs[end ? end->rib : ribs.size() / 2].center;
  const std::vector<ribs::Rib> before = ribs;
  const PartId id = subject.part->id;
  if (Outcome done = edit(env, subject, ribs::addRib(sceneOf(subject), *p)); !done) return done;
  const Subject after = subjectOf(env.studio.document(), env.studio.derived(), id);
  if (!after || id != env.ui.selection) return {};
  // The new one is chosen, to be moved next.
  const auto& now = after.shape->ribs.ribs;
  std::size_t at = 0;
  while (at < before.size() && at < now.size() && before[at].center == now[at].center) ++at;
  if (now.size() > before.size()) {
    env.ui.chosen.end = ribs::EndRef{at, end ? end->side : ribs::Side::Left};
  }
  return {};
}

Outcome deleteRib(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  if (subject.shape->ribs.ribs.size() <= 2) {
    return Refusal{"NotNow", "A part keeps at least two ribs. Delete the part instead."};
  }
  return editEnd(env, args,
                 [](const ribs::EditScene& scene, ribs::EndRef end) { return ribs::removeRib(scene, end.rib); });
}

Outcome lockRib(Env env, const Json& args) {
  return editEnd(env, args, [&](const ribs::EditScene& scene, ribs::EndRef end) {
    const ribs::Rib& rib = scene.ribs.ribs[end.rib];
    const bool isLocked = rib.leftState == ribs::RibState::Locked && rib.rightState == ribs::RibState::Locked;
    return ribs::lockRib(scene, end.rib, args.flag("locked").value_or(!isLocked));
  });
}

Outcome resetRib(Env env, const Json& args) {
  return editEnd(env, args,
                 [](const ribs::EditScene& scene, ribs::EndRef end) { return ribs::resetRib(scene, end.rib); });
}

Outcome resetRibs(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  return edit(env, subject, {});
}

Outcome thin(Env env, const Json& args, double factor) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const document::ParamInfo* info = document::findParam(document::PartKind::Loft, "ribs");
  const double now = info->get(subject.part->recipe);
  const double wanted = std::clamp(std::round(now * factor), info->low, info->high);
  const std::size_t before = subject.shape->ribs.ribs.size();
  const PartId id = subject.part->id;
  const Status status = env.studio.act(document::SetParameter{id, "ribs", wanted});
  if (!status) return refuse(status.failure());
  const Subject after = subjectOf(env.studio.document(), env.studio.derived(), id);
  if (!after) return {};
  const std::size_t count = after.shape->ribs.ribs.size();
  if (env.ui.chosen.end && before > 1) {
    env.ui.chosen.end->rib = env.ui.chosen.end->rib * (count - 1) / (before - 1);
  }
  sendStatus(env.host, words::tr("{n} ribs.", {{"n", count}}));
  return {};
}
Outcome moreRibs(Env env, const Json& args) { return thin(env, args, kDensityStep); }
Outcome fewerRibs(Env env, const Json& args) { return thin(env, args, 1 / kDensityStep); }

Outcome setReach(Env env, int by) {
  double& reach = ribsTool(env) ? env.ui.edit.ribReach : env.ui.edit.spineReach;
  std::size_t at = 0;
  while (at + 1 < kReaches.size() && kReaches[at] < reach - 1e-9) ++at;
  if (by > 0 && at + 1 < kReaches.size() && reach >= kReaches[at] - 1e-9) ++at;
  if (by < 0 && at > 0) --at;
  reach = kReaches[at];
  sendStatus(env.host, reach > 0 ? words::tr("Neighbours follow within {n} hundredths of the bone.",
                                             {{"n", std::lround(reach * 100)}})
                                 : "Neighbours stay where they are.");
  return {};
}
Outcome reachMore(Env env, const Json&) { return setReach(env, 1); }
Outcome reachLess(Env env, const Json&) { return setReach(env, -1); }

Outcome toggleBoth(Env env, const Json& args) {
  env.ui.edit.bothSides = args.flag("both").value_or(!env.ui.edit.bothSides);
  return {};
}

Outcome chooseRibRow(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const std::optional<ribs::EndRef> end = endFor(env, args, subject);
  return end ? chooseRib(env, subject.part->id, *end) : noRib();
}

/// The next rib end of the same side, or the next handle of the spine.
Outcome step(Env env, int by) {
  const Subject subject = subjectFor(env, env.ui.selection);
  if (!subject) return noSpine(env, {});
  Chosen& chosen = env.ui.chosen;
  if (env.ui.tool == ToolKind::Spine) {
    const int from = chosen.handle >= 0 ? chosen.handle : (by > 0 ? -1 : 0);
    chosen = {std::nullopt, (from + by + kSpineHandles) % kSpineHandles};
    sendStatus(env.host,
               words::tr("Point {n} of {all} of the bone.", {{"n", chosen.handle + 1}, {"all", kSpineHandles}}));
    return {};
  }
  const std::size_t count = subject.shape->ribs.ribs.size();
  ribs::EndRef end = chosen.end.value_or(ribs::EndRef{by > 0 ? count - 1 : 0, ribs::Side::Left});
  end.rib = (end.rib + (by > 0 ? 1 : count - 1)) % count;
  chosen = {end, -1};
  return {};
}
Outcome nextPoint(Env env, const Json&) { return step(env, 1); }
Outcome previousPoint(Env env, const Json&) { return step(env, -1); }

Outcome otherEnd(Env env, const Json&) {
  if (!env.ui.chosen.end) return step(env, 1);
  ribs::Side& side = env.ui.chosen.end->side;
  side = side == ribs::Side::Left ? ribs::Side::Right : ribs::Side::Left;
  return {};
}

Outcome noScribble() { return Refusal{"ValueOutOfRange", "There is no such scribble."}; }

Outcome ignore(Env env, const Json& args) {
  const auto stroke = strokeOf(args);
  if (!stroke) return missing("a stroke: a list of [x, y] picture pixels");
  const ribs::IgnoreMark mark{*stroke, args.number("radius").value_or(kDefaultRadius),
                              args.flag("covers").value_or(env.ui.edit.paintOver)};
  const document::Part* part = partOf(env, args);
  if (args.flag("picture").value_or(env.ui.edit.wholePicture || part == nullptr)) {
    const PictureId picture = part && namesPart(args) ? document::pictureOf(*part) : env.ui.picture;
    return ignoreForPicture(env, picture, mark);
  }
  return part ? ignoreForPart(env, part->id, mark) : noPart();
}

Outcome removeIgnoreRow(Env env, const Json& args) {
  const std::optional<double> mark = args.number("mark");
  if (!mark || !(*mark >= 0) || *mark > 1e6) return noScribble();
  return removeIgnored(env, static_cast<std::size_t>(*mark));
}

Outcome clearIgnore(Env env, const Json&) {
  const Marks marks = marksOf(env.studio.document(), env.ui.picture, env.ui.selection);
  std::vector<document::Action> actions;
  if (!marks.part.empty()) actions.push_back(document::IgnoreForPart{env.ui.selection, {}});
  if (!marks.picture.empty()) actions.push_back(document::IgnoreForPicture{env.ui.picture, {}});
  return outcomeOf(env.studio.act(actions));
}

Outcome toggleWhole(Env env, const Json&) {
  env.ui.edit.wholePicture = !env.ui.edit.wholePicture;
  return {};
}
Outcome togglePaintOver(Env env, const Json&) {
  env.ui.edit.paintOver = !env.ui.edit.paintOver;
  return {};
}
Outcome largerBrush(Env env, const Json&) {
  env.ui.edit.brush = std::min(kMostBrush, env.ui.edit.brush * kBrushStep);
  return {};
}
Outcome smallerBrush(Env env, const Json&) {
  env.ui.edit.brush = std::max(kLeastBrush, env.ui.edit.brush / kBrushStep);
  return {};
}

constexpr Argument kEnd{"rib"}, kLine{"stroke"}, kMark{"mark"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "ribs", .label = "Ribs", .icon = "unfold-horizontal", .shortcut = "5, G", .group = "tool",
            .hint = "Drag the ends of ribs, add and lock ribs", .enabled = hasParts, .toggled = ribsTool,
            .run = useRibs},
    Command{.id = "shape", .label = "Shape by line", .icon = "line-squiggle", .shortcut = "6, S", .group = "tool",
            .hint = "Draw where the outline should be: ribs near by go there", .enabled = hasParts,
            .toggled = shapeTool, .run = useShape},
    Command{.id = "ignore-edges", .label = "Ignore edges", .icon = "ban", .shortcut = "8, I", .group = "tool",
            .hint = "Scribble over edges that should not count", .enabled = hasPicture, .toggled = ignoreTool,
            .run = useIgnore},
    Command{.id = "reach-less", .label = "Fewer follow", .icon = "fold-vertical", .shortcut = "[", .group = "ribs",
            .hint = "Fewer neighbours follow what you drag", .enabled = softens, .run = reachLess},
    Command{.id = "reach-more", .label = "More follow", .icon = "unfold-vertical", .shortcut = "]", .group = "ribs",
            .hint = "More neighbours follow what you drag", .enabled = softens, .run = reachMore},
    Command{.id = "next-point", .label = "Next rib or point", .icon = "chevron-right", .shortcut = ".", .group = "ribs",
            .hint = "Choose the next rib, or the next point of the bone", .enabled = pointsByKeys, .run = nextPoint},
    Command{.id = "previous-point", .label = "Rib or point before", .icon = "chevron-left", .shortcut = ",",
            .group = "ribs", .hint = "Choose the rib before, or the point of the bone before", .enabled = pointsByKeys,
            .run = previousPoint},
    Command{.id = "other-end", .label = "Other end", .icon = "arrow-left-right", .shortcut = "X", .group = "ribs",
            .hint = "Choose the other end of the rib", .enabled = pointsByKeys, .run = otherEnd},
    Command{.id = "add-rib", .label = "Add rib", .icon = "circle-plus", .shortcut = "A, Insert", .group = "ribs",
            .hint = "One more rib beside the chosen one", .enabled = hasSpine, .run = addRib},
    Command{.id = "delete-rib", .label = "Delete rib", .icon = "circle-minus", .shortcut = "Delete, Backspace",
            .group = "ribs", .hint = "Leave the chosen rib out", .enabled = hasChosenRib, .run = deleteRib,
            .mode = &kRibMode},
    Command{.id = "lock-rib", .label = "Lock rib", .icon = "lock", .shortcut = "L", .group = "ribs",
            .hint = "The chosen rib stays where it is", .enabled = hasChosenRib, .toggled = locked, .run = lockRib},
    Command{.id = "reset-rib", .label = "Reset rib", .icon = "rotate-ccw", .shortcut = "Shift+R", .group = "ribs",
            .hint = "Back to where the chosen rib was found", .enabled = hasChosenRib, .run = resetRib},
    Command{.id = "reset-ribs", .label = "Reset all ribs", .icon = "refresh-cw", .group = "ribs",
            .hint = "All ribs back to where they were found", .enabled = hasSpine, .run = resetRibs},
    Command{.id = "fewer-ribs", .label = "Fewer ribs", .icon = "rows-2", .shortcut = "Shift+F", .group = "ribs",
            .hint = "Fewer ribs for this part", .enabled = hasSpine, .run = fewerRibs},
    Command{.id = "more-ribs", .label = "More ribs", .icon = "rows-4", .shortcut = "Shift+M", .group = "ribs",
            .hint = "More ribs for this part", .enabled = hasSpine, .run = moreRibs},
    Command{.id = "both-sides", .label = "Both sides", .icon = "flip-horizontal-2", .shortcut = "Shift+B",
            .group = "ribs", .hint = "The line changes the other side as well", .enabled = hasParts,
            .toggled = bothSides, .run = toggleBoth},
    Command{.id = "ignore-whole-picture", .label = "All parts", .icon = "image", .group = "ribs",
            .hint = "Scribbles count for all parts of the picture", .enabled = hasPicture, .toggled = wholePicture,
            .run = toggleWhole},
    Command{.id = "paint-over", .label = "Paint over", .icon = "paint-roller", .group = "ribs",
            .hint = "What you scribble over is not on the part: its own colours go over it", .enabled = hasPicture,
            .toggled = paintsOver, .run = togglePaintOver},
    Command{.id = "brush-smaller", .label = "Smaller brush", .icon = "minus", .group = "ribs",
            .hint = "A smaller brush", .enabled = usesBrush, .run = smallerBrush},
    Command{.id = "brush-larger", .label = "Larger brush", .icon = "plus", .group = "ribs", .hint = "A larger brush",
            .enabled = usesBrush, .run = largerBrush},
    Command{.id = "clear-ignored", .label = "Remove scribbles", .icon = "trash-2", .group = "ribs",
            .hint = "All edges count again", .enabled = hasMarks, .run = clearIgnore},
    Command{.id = "choose-rib", .label = "Choose a rib by number", .icon = "crosshair", .group = "ribs",
            .argument = kEnd, .hint = "A rib and a side", .enabled = hasSpine, .run = chooseRibRow},
    Command{.id = "move-rib-end", .label = "Move a rib end by numbers", .icon = "move", .group = "ribs",
            .argument = kEnd, .hint = "A rib end and where it goes", .enabled = hasSpine, .run = moveRibEndRow},
    Command{.id = "shape-ribs", .label = "Shape by numbers", .icon = "line-squiggle", .group = "ribs",
            .argument = kLine, .hint = "A stroke in picture pixels", .enabled = hasSpine, .run = shapeRibsRow},
    Command{.id = "take-place", .label = "Take another edge", .icon = "crosshair", .group = "ribs", .argument = kEnd,
            .hint = "One of the other places of a rib end", .enabled = hasSpine, .run = takePlaceRow},
    Command{.id = "ignore", .label = "Ignore edges by numbers", .icon = "ban", .group = "ribs", .argument = kLine,
            .hint = "A stroke in picture pixels", .enabled = hasPicture, .run = ignore},
    Command{.id = "remove-ignore", .label = "Remove a scribble by number", .icon = "x", .group = "ribs",
            .argument = kMark, .hint = "The number of a scribble", .enabled = hasMarks, .run = removeIgnoreRow},
};
// clang-format on

}  // namespace

bool ribIsChosen(const CommandEnv& env) { return hasSpine(env) && env.ui.chosen.end.has_value(); }

Outcome chooseRib(Env env, PartId part, ribs::EndRef end) {
  const Subject subject = subjectFor(env, part);
  if (!subject) return noSpine(document::findPart(env.studio.document(), part));
  if (end.rib >= subject.shape->ribs.ribs.size()) return noRib();
  env.ui.selection = part;
  featureAt(env.ui, document::pictureOf(*subject.part));
  env.ui.tool = ToolKind::Ribs;
  env.ui.chosen = {end, -1};
  return {};
}

Outcome moveRibEnd(Env env, PartId part, ribs::EndRef end, PicturePoint to, double reach) {
  return editEnd(env, part, end,
                 [&](const ribs::EditScene& scene, ribs::EndRef of) { return ribs::dragEnd(scene, of, to, reach); });
}

Outcome takePlace(Env env, PartId part, ribs::EndRef end, int place) {
  return editEnd(env, part, end, [&](const ribs::EditScene& scene, ribs::EndRef of) {
    return ribs::takeOtherPlace(scene, of, place, true);
  });
}

Outcome shapeRibs(Env env, const ShapeRibsIntent& intent) {
  const Subject subject = subjectFor(env, intent.part);
  if (!subject) return noSpine(document::findPart(env.studio.document(), intent.part));
  ribs::StrokeDeform deform = ribs::deformByStroke(sceneOf(subject), intent.stroke, intent.within, intent.both);
  if (deform.touched.empty()) {
    return Refusal{"NoRibThere", "That line crosses no ribs. Draw it across the ribs, where their ends should be."};
  }
  return edit(env, subject, std::move(deform.edits));
}

Outcome ignoreForPart(Env env, PartId id, const ribs::IgnoreMark& mark) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr) return noPart();
  std::vector<ribs::IgnoreMark> marks = document::loftIn(*part).ignored;
  marks.push_back(mark);
  return outcomeOf(env.studio.act(document::IgnoreForPart{id, std::move(marks)}));
}

Outcome ignoreForPicture(Env env, PictureId picture, const ribs::IgnoreMark& mark) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), picture);
  if (entry == nullptr) return refuse({Error::NoSuchPicture, {}});
  std::vector<ribs::IgnoreMark> marks = entry->ignored;
  marks.push_back(mark);
  return outcomeOf(env.studio.act(document::IgnoreForPicture{picture, std::move(marks)}));
}

Outcome removeIgnored(Env env, std::size_t mark) {
  const Marks marks = marksOf(env.studio.document(), env.ui.picture, env.ui.selection);
  const auto without = [](std::span<const ribs::IgnoreMark> all, std::size_t i) {
    std::vector<ribs::IgnoreMark> left(all.begin(), all.end());
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(i));
    return left;
  };
  if (mark < marks.part.size()) {
    return outcomeOf(env.studio.act(document::IgnoreForPart{env.ui.selection, without(marks.part, mark)}));
  }
  const std::size_t ofPicture = mark - marks.part.size();
  if (ofPicture >= marks.picture.size()) return noScribble();
  return outcomeOf(env.studio.act(document::IgnoreForPicture{env.ui.picture, without(marks.picture, ofPicture)}));
}

constinit const Mode kRibMode{"rib", ribsByKeys};

std::span<const Command> ribCommands() { return kTable; }

}  // namespace spineloft::app
