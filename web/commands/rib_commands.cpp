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
#include "web/edit/editing.h"
#include "web/model/messages.h"

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
  sendStatus(env.host, std::to_string(count) + " ribs.");
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
  sendStatus(env.host, reach > 0 ? "Neighbours follow within " + std::to_string(std::lround(reach * 100)) +
                                       " hundredths of the bone."
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
               "Point " + std::to_string(chosen.handle + 1) + " of " + std::to_string(kSpineHandles) + " of the bone.");
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

constexpr Argument kNone{}, kEnd{"rib"}, kLine{"stroke"}, kMark{"mark"};

constexpr std::array kTable = {
    Command{"ribs", "Ribs", "unfold-horizontal", "5, G", "tool", kNone, "Drag the ends of ribs, add and lock ribs",
            hasParts, ribsTool, useRibs},
    Command{"shape", "Shape by line", "line-squiggle", "6, S", "tool", kNone,
            "Draw where the outline should be: ribs near by go there", hasParts, shapeTool, useShape},
    Command{"ignore-edges", "Ignore edges", "ban", "8, I", "tool", kNone, "Scribble over edges that should not count",
            hasPicture, ignoreTool, useIgnore},
    Command{"reach-less", "Fewer follow", "fold-vertical", "[", "ribs", kNone, "Fewer neighbours follow what you drag",
            softens, nullptr, reachLess},
    Command{"reach-more", "More follow", "unfold-vertical", "]", "ribs", kNone, "More neighbours follow what you drag",
            softens, nullptr, reachMore},
    Command{"next-point", "Next rib or point", "chevron-right", ".", "ribs", kNone,
            "Choose the next rib, or the next point of the bone", pointsByKeys, nullptr, nextPoint},
    Command{"previous-point", "Rib or point before", "chevron-left", ",", "ribs", kNone,
            "Choose the rib before, or the point of the bone before", pointsByKeys, nullptr, previousPoint},
    Command{"other-end", "Other end", "arrow-left-right", "X", "ribs", kNone, "Choose the other end of the rib",
            pointsByKeys, nullptr, otherEnd},
    Command{"add-rib", "Add rib", "circle-plus", "A, Insert", "ribs", kNone, "One more rib beside the chosen one",
            hasSpine, nullptr, addRib},
    Command{"delete-rib", "Delete rib", "circle-minus", "Delete, Backspace", "ribs", kNone, "Leave the chosen rib out",
            hasChosenRib, nullptr, deleteRib, ribsByKeys},
    Command{"lock-rib", "Lock rib", "lock", "L", "ribs", kNone, "The chosen rib stays where it is", hasChosenRib,
            locked, lockRib},
    Command{"reset-rib", "Reset rib", "rotate-ccw", "Shift+R", "ribs", kNone, "Back to where the chosen rib was found",
            hasChosenRib, nullptr, resetRib},
    Command{"reset-ribs", "Reset all ribs", "refresh-cw", "", "ribs", kNone, "All ribs back to where they were found",
            hasSpine, nullptr, resetRibs},
    Command{"fewer-ribs", "Fewer ribs", "rows-2", "Shift+F", "ribs", kNone, "Fewer ribs for this part", hasSpine,
            nullptr, fewerRibs},
    Command{"more-ribs", "More ribs", "rows-4", "Shift+M", "ribs", kNone, "More ribs for this part", hasSpine, nullptr,
            moreRibs},
    Command{"both-sides", "Both sides", "flip-horizontal-2", "Shift+B", "ribs", kNone,
            "The line changes the other side as well", hasParts, bothSides, toggleBoth},
    Command{"ignore-whole-picture", "For the whole picture", "image", "", "ribs", kNone,
            "Scribbles count for all parts of the picture", hasPicture, wholePicture, toggleWhole},
    Command{"paint-over", "Paint over", "paint-roller", "", "ribs", kNone,
            "What you scribble over is not on the part: its own colours go over it", hasPicture, paintsOver,
            togglePaintOver},
    Command{"brush-smaller", "Smaller brush", "minus", "", "ribs", kNone, "A smaller brush", usesBrush, nullptr,
            smallerBrush},
    Command{"brush-larger", "Larger brush", "plus", "", "ribs", kNone, "A larger brush", usesBrush, nullptr,
            largerBrush},
    Command{"clear-ignored", "Remove scribbles", "trash-2", "", "ribs", kNone, "All edges count again", hasMarks,
            nullptr, clearIgnore},
    Command{"choose-rib", "Choose a rib by number", "crosshair", "", "ribs", kEnd, "A rib and a side", hasSpine,
            nullptr, chooseRibRow},
    Command{"move-rib-end", "Move a rib end by numbers", "move", "", "ribs", kEnd, "A rib end and where it goes",
            hasSpine, nullptr, moveRibEndRow},
    Command{"shape-ribs", "Shape by numbers", "line-squiggle", "", "ribs", kLine, "A stroke in picture pixels",
            hasSpine, nullptr, shapeRibsRow},
    Command{"take-place", "Take another edge", "crosshair", "", "ribs", kEnd, "One of the other places of a rib end",
            hasSpine, nullptr, takePlaceRow},
    Command{"ignore", "Ignore edges by numbers", "ban", "", "ribs", kLine, "A stroke in picture pixels", hasPicture,
            nullptr, ignore},
    Command{"remove-ignore", "Remove a scribble by number", "x", "", "ribs", kMark, "The number of a scribble",
            hasMarks, nullptr, removeIgnoreRow},
};

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

std::span<const Command> ribCommands() { return kTable; }

}  // namespace spineloft::app
