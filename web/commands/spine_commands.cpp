// Commands about spines: moved, bent, posed, coiled, out of the picture's plane.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/along.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/spine_gestures.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/editing.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr double kPi = 3.14159265358979323846;
constexpr double kFirstCoil = 3;  // turns

Subject subjectFor(Env env, PartId part) { return subjectOf(env.studio.document(), env.studio.derived(), part); }
Subject subjectFor(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  return part ? subjectFor(env, part->id) : Subject{};
}
Outcome noSpineIn(Env env, PartId part) { return noSpine(document::findPart(env.studio.document(), part)); }

bool spineTool(Env env) { return env.ui.tool == ToolKind::Spine; }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool keepsRibs(Env env) { return env.ui.edit.keepRibs; }
bool findsEdges(Env env) { return !env.ui.edit.keepRibs; }
bool byPressure(Env env) { return env.ui.edit.depthByPressure; }
bool penSeen(Env env) { return env.ui.penSeen; }
bool isJoined(Env env) {
  const document::Part* part = loftPartOf(env, {});
  return part != nullptr && document::loftIn(*part).pose.closed;
}
bool isCoiled(Env env) {
  const document::Part* part = loftPartOf(env, {});
  return part != nullptr && document::loftIn(*part).pose.coilTurns != 0;
}
bool pointChosen(Env env) {
  if (!hasSpine(env)) return false;
  if (env.ui.tool == ToolKind::Ribs) return env.ui.chosen.end.has_value();
  return spineTool(env) && env.ui.chosen.handle >= 0;
}

Outcome useSpineTool(Env env, const Json&) {
  env.ui.tool = ToolKind::Spine;
  env.ui.redraw = {};
  if (hasSpine(env)) return {};
  const document::Part* puff = partOf(env, Json());
  if (puff != nullptr && document::inflateOf(*puff) != nullptr) {
    env.ui.focus = Focus::Picture;
    sendStatus(env.host, document::inflateOf(*puff)->inflate.profile.isSoft()
                             ? "A soft puff has no bones. Choose another slice for it."
                             : "Tap a bone: it goes. Drag an end. Draw from a bone. Pull a knob: thicker or thinner.");
    return {};
  }
  for (const document::Part& part : env.studio.document().parts) {
    const bool fits = document::pictureOf(part) == env.ui.picture && document::loftOf(part) != nullptr;
    if (fits && pipeline::isVisible(env.studio.document(), part)) env.ui.selection = part.id;
  }
  return {};
}

/// The part on another line; `burst` as Studio::act has it.
Outcome putLine(Env env, const Subject& subject, std::vector<PicturePoint> line, bool keepRibs,
                std::string_view burst = {}) {
  const auto actions = spineActions(*subject.part, std::move(line), keepRibs);
  return outcomeOf(env.studio.act(actions, burst));
}

bool keepFor(Env env, const Json& args) { return args.flag("keep").value_or(env.ui.edit.keepRibs); }

Outcome bendSpineRow(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const std::optional<PicturePoint> to = pointOf(args, "to");
  if (!to || !isFinite(*to)) return missing("where to: [x, y] in picture pixels");
  const double reach = std::clamp(args.number("reach").value_or(env.ui.edit.spineReach), 0.0, 1.0);
  if (const std::optional<double> handle = args.number("handle")) {
    if (!(*handle >= 0) || *handle >= kSpineHandles) return refuse({Error::ValueOutOfRange, "handle"});
    return bendSpine(env, {subject.part->id, static_cast<int>(*handle), *to, reach, keepFor(env, args)});
  }
  const double at = args.number("at").value_or(0.5);
  if (!(at >= 0 && at <= 1)) return refuse({Error::ValueOutOfRange, "at"});
  return putLine(env, subject, ribs::bendStroke(spineLine(subject), at, *to, reach), keepFor(env, args));
}

Outcome moveSpineRow(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const std::optional<PicturePoint> by = pointOf(args, "by");
  if (!by || !isFinite(*by)) return missing("how far: [x, y] in picture pixels");
  return moveSpine(env, subject.part->id, *by, keepFor(env, args));
}

Outcome extendSpine(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  const std::optional<PicturePoint> to = pointOf(args, "to");
  if (!to || !isFinite(*to)) return missing("where to: [x, y] in picture pixels");
  const bool atStart = args.flag("start").value_or(false);
  return putLine(env, subject, ribs::extendStroke(spineLine(subject), atStart, *to), keepFor(env, args));
}

/// Changes the pose of the part that is meant.
template <class Change>
Outcome editPose(Env env, const document::Part* part, const Change& change) {
  if (part == nullptr || document::loftOf(*part) == nullptr) return noSpine(part);
  document::PoseSpine pose{part->id, document::loftIn(*part).pose};
  change(pose.pose);
  return outcomeOf(env.studio.act(pose));
}

Outcome poseSpineRow(Env env, const Json& args) {
  const auto stroke = strokeOf(args);
  const auto depth = curveOf(args, "depth");
  const Json* given = args.find("stroke");
  if (given && !stroke && !given->isNull()) {
    return missing("a stroke: a list of [x, y] picture pixels");
  }
  return editPose(env, partOf(env, args), [&](loft::Pose& pose) {
    if (given) pose.stroke = stroke.value_or(std::vector<PicturePoint>{});
    if (depth) pose.depth = *depth;
    pose.coilTurns = args.number("turns").value_or(pose.coilTurns);
    pose.coilRadius = args.number("radius").value_or(pose.coilRadius);
    pose.closed = args.flag("closed").value_or(pose.closed);
  });
}

Outcome resetPose(Env env, const Json& args) {
  return editPose(env, partOf(env, args), [](loft::Pose& pose) { pose = {}; });
}

Outcome setDepthRow(Env env, const Json& args) {
  const auto depth = curveOf(args, "points");
  if (!depth) return missing("points: a list of [place, depth], places from 0 to 1 in order");
  const document::Part* part = partOf(env, args);
  return part ? setDepth(env, part->id, *depth) : noPart();
}

Outcome joinEnds(Env env, const Json& args) {
  return editPose(env, partOf(env, args),
                  [&](loft::Pose& pose) { pose.closed = args.flag("closed").value_or(!pose.closed); });
}

/// Twice the mean length of its ribs: a coil whose turns do not touch.
double fittingRadius(const Subject& subject) {
  const auto& ribs = subject.shape->ribs.ribs;
  double sum = 0;
  for (const ribs::Rib& rib : ribs) sum += distance(rib.left, rib.right) / 2;
  return ribs.empty() ? 10 : std::round(2 * sum / static_cast<double>(ribs.size()));
}

Outcome coil(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  return editPose(env, partOf(env, args), [&](loft::Pose& pose) {
    const bool told = args.number("turns") || args.number("radius");
    if (!told && pose.coilTurns != 0) {
      pose.coilTurns = pose.coilRadius = 0;
      return;
    }
    pose.coilTurns = args.number("turns").value_or(pose.coilTurns != 0 ? pose.coilTurns : kFirstCoil);
    const double fitting = subject ? fittingRadius(subject) : 10;
    pose.coilRadius = args.number("radius").value_or(pose.coilRadius > 0 ? pose.coilRadius : fitting);
  });
}

Outcome setKeep(Env env, bool keep) {
  env.ui.edit.keepRibs = keep;
  return {};
}
Outcome keepRibs(Env env, const Json&) { return setKeep(env, true); }
Outcome findEdges(Env env, const Json&) { return setKeep(env, false); }
Outcome togglePressure(Env env, const Json&) {
  env.ui.edit.depthByPressure = !env.ui.edit.depthByPressure;
  return {};
}

Outcome chooseHandleRow(Env env, const Json& args) {
  const std::optional<double> handle = args.number("handle");
  if (!handle || !(*handle >= 0) || *handle >= kSpineHandles) return missing("a handle");
  return chooseHandle(env, static_cast<int>(*handle));
}

/// From the side for an upright spine, from above for a lying one: where its depth is seen best.
Outcome sideView(Env env, const Json& args) {
  const Subject subject = subjectFor(env, args);
  if (!subject) return noSpine(env, args);
  UiState& ui = env.ui;
  const auto& line = subject.shape->centreLine;
  const auto [left, right] = std::ranges::minmax(line, {}, &ModelPoint::x);
  const auto [low, high] = std::ranges::minmax(line, {}, &ModelPoint::y);
  Camera to;
  if (high.y - low.y >= right.x - left.x) {
    to.yaw = kPi / 2;
  } else {
    to.pitch = kMaxPitch;
  }
  const auto bounds = publish::worldBounds(env.studio.document(), env.studio.derived());
  if (bounds) to = framed(to, *bounds, ui.layout.solid);
  ui.focus = Focus::Solid;
  ui.tool = ToolKind::Spine;
  ui.selection = subject.part->id;
  ui.cameraTouched = true;
  fly(env, to);
  return {};
}

/// Arrow keys on the chosen rib end or spine point; pressed one after the other they are one step.
Outcome nudge(Env env, const Json& args) {
  const std::optional<PicturePoint> by = nudgeOf(args);
  const Subject subject = subjectFor(env, env.ui.selection);
  if (!subject) return noSpine(env, args);
  if (!by || !isFinite(*by)) return missing("how far: by [x, y] in picture pixels");
  const Chosen& chosen = env.ui.chosen;
  const std::string part = std::to_string(subject.part->id.value);
  if (env.ui.tool == ToolKind::Ribs && chosen.end) {
    const auto& ribs = subject.shape->ribs.ribs;
    if (chosen.end->rib >= ribs.size()) return noPart();
    const PicturePoint to = endPoint(ribs[chosen.end->rib], chosen.end->side) + *by;
    const document::Action action =
        document::EditRibs{subject.part->id, ribs::dragEnd(sceneOf(subject), *chosen.end, to, env.ui.edit.ribReach)};
    return outcomeOf(env.studio.act({&action, 1}, "rib " + part + " " + std::to_string(chosen.end->rib)));
  }
  const std::string burst = "bone " + part + " " + std::to_string(chosen.handle);
  if (env.ui.focus == Focus::Solid) {
    loft::Pose pose = document::loftIn(*subject.part).pose;
    pose.depth = raiseDepth(pose.depth, handlePlace(chosen.handle), by->x - by->y, env.ui.edit.spineReach);
    const document::Action action = document::PoseSpine{subject.part->id, std::move(pose)};
    return outcomeOf(env.studio.act({&action, 1}, "depth of " + burst));
  }
  const PicturePoint at = spineHandles(subject)[static_cast<std::size_t>(chosen.handle)];
  return putLine(env, subject, moveHandle(spineLine(subject), chosen.handle, at + *by, env.ui.edit.spineReach),
                 env.ui.edit.keepRibs, burst);
}

constexpr Argument kLine{"stroke"}, kPoint{"to"}, kBy{"by"}, kPoints{"points"}, kHandle{"handle"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "bone", .label = "Bone", .icon = "bone", .shortcut = "7, M", .group = "tool",
            .hint = "Bend, move, lengthen or pose the bone; change the bones of a puff", .enabled = hasParts,
            .toggled = spineTool, .run = useSpineTool},
    Command{.id = "find-edges", .label = "Find edges again", .icon = "scan-search", .group = "bone",
            .hint = "A changed bone looks for its ribs in the picture again", .enabled = hasParts,
            .toggled = findsEdges, .run = findEdges},
    Command{.id = "keep-ribs", .label = "Keep the ribs", .icon = "anchor", .shortcut = "K", .group = "bone",
            .hint = "A changed bone takes its ribs along", .enabled = hasParts, .toggled = keepsRibs, .run = keepRibs},
    Command{.id = "reset-pose", .label = "Back to the picture", .icon = "image-down", .group = "bone",
            .hint = "The part stands where it was drawn again", .enabled = isPosed, .run = resetPose},
    Command{.id = "join-ends", .label = "Join ends", .icon = "link", .shortcut = "J", .group = "bone",
            .hint = "The two ends meet and make a ring", .enabled = hasSpine, .toggled = isJoined, .run = joinEnds},
    Command{.id = "coil", .label = "Coil", .icon = "shell", .shortcut = "C", .group = "bone",
            .hint = "The bone winds like a spring", .enabled = hasSpine, .toggled = isCoiled, .run = coil},
    Command{.id = "side-view", .label = "Side view", .icon = "rotate-3d", .shortcut = "V", .group = "bone",
            .hint = "See the part from the side, and drag its bone out of the picture", .enabled = hasSpine,
            .run = sideView},
    Command{.id = "depth-by-pressure", .label = "Depth by pressure", .icon = "signature", .group = "bone",
            .hint = "Pressing harder with the pen brings the bone nearer", .enabled = penSeen, .toggled = byPressure,
            .run = togglePressure},
    Command{.id = "nudge", .label = "Move the chosen point", .icon = "move", .shortcut = kArrowKeys, .group = "bone",
            .argument = kBy, .hint = "Arrows move it by one pixel, with Shift by ten", .enabled = pointChosen,
            .run = nudge, .mode = &kPointMode},
    Command{.id = "bend-spine", .label = "Bend a bone by numbers", .icon = "spline", .group = "bone",
            .argument = kPoint, .hint = "A place on the bone and where it goes", .enabled = hasSpine,
            .run = bendSpineRow},
    Command{.id = "move-spine", .label = "Move a bone by numbers", .icon = "move", .group = "bone", .argument = kBy,
            .hint = "How far, in picture pixels", .enabled = hasSpine, .run = moveSpineRow},
    Command{.id = "extend-spine", .label = "Lengthen a bone by numbers", .icon = "spline", .group = "bone",
            .argument = kPoint, .hint = "Where its end or start goes", .enabled = hasSpine, .run = extendSpine},
    Command{.id = "pose-spine", .label = "Pose a bone by numbers", .icon = "bone", .group = "bone", .argument = kLine,
            .hint = "Another line for the same ribs", .enabled = hasSpine, .run = poseSpineRow},
    Command{.id = "set-depth", .label = "Depth by numbers", .icon = "move-3d", .group = "bone", .argument = kPoints,
            .hint = "Places along the bone and their depth", .enabled = hasSpine, .run = setDepthRow},
    Command{.id = "choose-handle", .label = "Choose a bone point by number", .icon = "crosshair", .group = "bone",
            .argument = kHandle, .hint = "The number of a point of the bone", .enabled = hasSpine,
            .run = chooseHandleRow},
};
// clang-format on

}  // namespace

bool poseIsSelected(const CommandEnv& env) {
  const document::Part* part = loftPartOf(env, {});
  return part != nullptr && !document::loftIn(*part).pose.isRest();
}

Outcome bendSpine(Env env, const BendSpineIntent& intent) {
  const Subject subject = subjectFor(env, intent.part);
  if (!subject) return noSpineIn(env, intent.part);
  return putLine(env, subject, moveHandle(spineLine(subject), intent.handle, intent.to, intent.reach), intent.keep);
}

Outcome moveSpine(Env env, PartId part, PicturePoint by, bool keep) {
  const Subject subject = subjectFor(env, part);
  if (!subject) return noSpineIn(env, part);
  return putLine(env, subject, ribs::shiftStroke(spineLine(subject), by), keep);
}

Outcome poseAlong(Env env, PartId part, const std::vector<PicturePoint>& stroke) {
  return editPose(env, document::findPart(env.studio.document(), part),
                  [&](loft::Pose& pose) { pose.stroke = stroke; });
}

Outcome setDepth(Env env, PartId part, const geometry::AlongCurve& depth) {
  return editPose(env, document::findPart(env.studio.document(), part), [&](loft::Pose& pose) { pose.depth = depth; });
}

Outcome setCoil(Env env, PartId part, double turns, double radius) {
  return editPose(env, document::findPart(env.studio.document(), part), [&](loft::Pose& pose) {
    pose.coilTurns = turns;
    pose.coilRadius = radius;
  });
}

Outcome chooseHandle(Env env, int handle) {
  env.ui.chosen = {std::nullopt, handle};
  return {};
}

constinit const Mode kPointMode{"point", pointChosen};

std::span<const Command> spineCommands() { return kTable; }

}  // namespace spineloft::app
