// Commands about the bones of a puff with a slice: left out, drawn, moved, thicker, and slices at places of them.
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <string>

#include "engine/geometry/line_distance.h"
#include "engine/inflate/thin_rings.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/puff_bones.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr double kNotch = 1.05, kFarNotch = 1.25;  // of a thickness
constexpr double kSliceStep = 0.2;                 // half widths: points of bones are not so far apart

BonedPuff puffFor(Env env, PartId part) { return bonedPuff(env.studio.document(), env.studio.derived(), part); }
BonedPuff puffFor(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  return part ? puffFor(env, part->id) : BonedPuff{};
}
BonedPuff inHand(Env env) { return bonesInHand(env.studio.document(), env.studio.derived(), env.ui); }
bool puffIsSelected(Env env) { return static_cast<bool>(puffFor(env, Json())); }
constexpr Condition hasBones{puffIsSelected, Condition::Part};
bool bonesByKeys(Env env) { return static_cast<bool>(inHand(env)); }
bool boneByKeys(Env env) {
  if (env.ui.chosen.bone < 0 || env.ui.focus != Focus::Picture) return false;
  return env.ui.chosen.bone < static_cast<int>(boneHandles(inHand(env)).size());
}
bool hasBoneEdits(Env env) {
  const BonedPuff puff = puffFor(env, Json());
  return puff && puff.params->bones != inflate::BoneEdits{};
}

Refusal noBones() {
  return {"NotARegion", "This needs a puff with a slice. A soft puff has no bones: choose another slice for it."};
}

const char* whyNot(std::vector<char> inflate::AwakeEdits::* kind) {
  if (kind == &inflate::AwakeEdits::drop) return "No bone that can be left out is there. A bone round a hole stays.";
  if (kind == &inflate::AwakeEdits::add)
    return "A new bone begins on a bone, crosses no other, and stays in the shape.";
  if (kind == &inflate::AwakeEdits::move) return "It cannot go there: bones stay in the shape and cross no other.";
  return "No bone is there.";
}

Outcome act(Env env, PartId part, const inflate::InflateParams& params, std::string_view burst = {}) {
  if (!inflate::isValid(params)) return refuse({Error::ValueOutOfRange, "bones"});
  const document::Action action = document::ShapeRegion{part, params};
  return outcomeOf(actOnPuffs(env, {part}, {&action, 1}, burst));
}

/// One more edit, if it finds its place.
Outcome change(Env env, const BonedPuff& puff, const BoneEdit& edit, std::string_view burst = {}) {
  if (!inflate::isValid(edit.params)) return refuse({Error::ValueOutOfRange, "bones"});
  if (!findsPlace(*puff.shape, edit)) return Refusal{"NotNow", whyNot(edit.kind)};
  return act(env, puff.part->id, edit.params, burst);
}

Outcome dropRow(Env env, const Json& args) {
  const BonedPuff puff = puffFor(env, args);
  if (!puff) return noBones();
  const std::optional<PicturePoint> at = pointOf(args, "at");
  if (!at) return missing("a place on a bone: at, [x, y] in picture pixels");
  return change(env, puff, dropBone(*puff.params, *at));
}

/// What was left out nearest to a place.
Outcome restoreRow(Env env, const Json& args) {
  const BonedPuff puff = puffFor(env, args);
  if (!puff) return noBones();
  const std::optional<PicturePoint> at = pointOf(args, "at");
  if (!at) return missing("a place where a bone was: at, [x, y] in picture pixels");
  inflate::InflateParams params = *puff.params;
  if (params.bones.drop.empty()) return Refusal{"NotNow", "No bone is left out."};
  std::size_t gone = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const BoneHandle& handle : boneHandles(puff)) {
    if (handle.hold != BoneHold::Gone) continue;
    const double off = geometry::distanceToLine(*at, std::span<const PicturePoint>(handle.line));
    if (off >= least) continue;
    least = off;
    gone = handle.edit;
  }
  params.bones.drop.erase(params.bones.drop.begin() + static_cast<std::ptrdiff_t>(gone));
  return act(env, puff.part->id, params);
}

Outcome addRow(Env env, const Json& args) {
  const BonedPuff puff = puffFor(env, args);
  if (!puff) return noBones();
  const std::optional<std::vector<PicturePoint>> line = strokeOf(args, "line");
  if (!line || line->size() < 2)
    return missing("a line from a bone to where it should reach: a list of [x, y] picture pixels");
  return change(env, puff, addBone(*puff.params, *line));
}

Outcome moveRow(Env env, const Json& args) {
  const BonedPuff puff = puffFor(env, args);
  if (!puff) return noBones();
  const std::optional<PicturePoint> from = pointOf(args, "from"), to = pointOf(args, "to");
  if (!from || !to) return missing("an end or fork and where it goes: from and to, [x, y] in picture pixels");
  return change(env, puff, moveBone(*puff.params, *from, *to));
}

Outcome raiseRow(Env env, const Json& args) {
  const BonedPuff puff = puffFor(env, args);
  if (!puff) return noBones();
  const std::optional<PicturePoint> at = pointOf(args, "at");
  const std::optional<double> factor = args.number("factor");
  if (!at || !factor) return missing("a place on a bone and how many times as thick: at and factor");
  return change(env, puff, raiseBone(*puff.params, *at, *factor));
}

Outcome resetRow(Env env, const Json& args) {
  const BonedPuff puff = puffFor(env, args);
  if (!puff) return noBones();
  inflate::InflateParams params = *puff.params;
  params.bones = {};
  env.ui.chosen.bone = -1;
  return act(env, puff.part->id, params);
}

Outcome step(Env env, int by) {
  const std::vector<BoneHandle> handles = boneHandles(inHand(env));
  const int count = static_cast<int>(handles.size());
  if (count == 0) return {};
  const int before = env.ui.chosen.bone < 0 ? (by > 0 ? -1 : 0) : env.ui.chosen.bone;
  return chooseBone(env, (before + by + count) % count);
}
Outcome next(Env env, const Json&) { return step(env, 1); }
Outcome previous(Env env, const Json&) { return step(env, -1); }

/// Arrows on the chosen point; one after the other they are one step.
Outcome nudge(Env env, const Json& args) {
  const BonedPuff puff = inHand(env);
  const BoneHandle handle = boneHandles(puff)[static_cast<std::size_t>(env.ui.chosen.bone)];
  const std::optional<PicturePoint> by = nudgeOf(args);
  const bool far = args.flag("far").value_or(false);
  if (!by || !isFinite(*by)) return missing("how far: by [x, y] in picture pixels");
  std::optional<BoneEdit> edit;
  if (handle.hold == BoneHold::Knob) {
    const double notch = far ? kFarNotch : kNotch;
    const double factor = by->x - by->y > 0 ? handle.factor * notch : handle.factor / notch;
    edit = raiseBone(*puff.params, handle.named, std::clamp(factor, inflate::kLeastFactor, inflate::kMostFactor));
  } else {
    const double least = handle.hold == BoneHold::Slice ? std::max(1.0, kSliceStep * handle.half) : 1;
    edit = dragged(puff, handle, handle.at, handle.at + *by * least, 1);
  }
  if (!edit) return Refusal{"NotNow", "A bone is not moved, but its ends are. Delete leaves it out."};
  return change(env, puff, *edit,
                "bones " + std::to_string(puff.part->id.value) + " " + std::to_string(env.ui.chosen.bone));
}

Outcome toggleRow(Env env, const Json&) { return toggleBone(env, env.ui.selection, env.ui.chosen.bone); }

/// The middle of the longest bone; where the only one is a point, there.
PicturePoint middleOf(const std::vector<BoneHandle>& handles) {
  const BoneHandle* best = &handles.front();
  for (const BoneHandle& handle : handles) {
    if (handle.hold == BoneHold::Bone && handle.line.size() > best->line.size()) best = &handle;
  }
  return best->at;
}

/// One more slice, first as the others, at the chosen place; it is chosen.
Outcome sliceHere(Env env, const Json& args) {
  const BonedPuff puff = puffFor(env, args);
  if (!puff) return noBones();
  const std::vector<BoneHandle> handles = boneHandles(puff);
  const bool chosen = env.ui.chosen.bone >= 0 && env.ui.chosen.bone < static_cast<int>(handles.size());
  const PicturePoint there = chosen ? handles[static_cast<std::size_t>(env.ui.chosen.bone)].at : middleOf(handles);
  const PicturePoint at = pointOf(args, "at").value_or(there);
  const sections::SectionShape shape = puff.params->profile.slices[pickedSlice(puff, env.ui)].shape;
  const Outcome done = setSliceAt(env, puff.part->id, at, shape);
  if (!done) return done;
  env.ui.tool = ToolKind::Spine;
  const std::vector<BoneHandle> now = boneHandles(puffFor(env, puff.part->id));
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i].hold == BoneHold::Slice) env.ui.chosen.bone = static_cast<int>(i);  // the last one is the newest
  }
  sendStatus(env.host, "Drag the slice along the bones, and choose what it looks like under Slice.");
  return done;
}

constexpr Argument kLine{"line"}, kPoint{"to"}, kAt{"at"}, kBy{"by"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "slice-here", .label = "Slice here", .icon = "slice", .group = "part", .argument = kAt,
            .hint = "Another slice at a place of the puff", .enabled = hasBones, .run = sliceHere},
    Command{.id = "reset-bones", .label = "Bones as found", .icon = "rotate-ccw", .group = "part",
            .hint = "The bones of the puff are again those that were found", .enabled = hasBoneEdits,
            .run = resetRow},
    Command{.id = "next-bone", .label = "Next bone point", .icon = "chevron-right", .shortcut = ".", .group = "part",
            .hint = "Choose the next end, knob, slice or bone of the puff", .enabled = bonesByKeys, .run = next,
            .mode = &kBonesMode},
    Command{.id = "previous-bone", .label = "Bone point before", .icon = "chevron-left", .shortcut = ",",
            .group = "part", .hint = "Choose the end, knob, slice or bone of the puff before", .enabled = bonesByKeys,
            .run = previous, .mode = &kBonesMode},
    Command{.id = "nudge-bone", .label = "Move the bone point", .icon = "move", .shortcut = kArrowKeys, .group = "part",
            .argument = kBy, .hint = "Arrow keys move the chosen end, and make a knob thicker or thinner",
            .enabled = boneByKeys, .run = nudge, .mode = &kBoneMode},
    Command{.id = "toggle-bone", .label = "Leave the bone out", .icon = "circle-minus",
            .shortcut = "Delete, Backspace, Enter", .group = "part",
            .hint = "The chosen bone is left out, or taken back; a chosen slice goes", .enabled = boneByKeys,
            .run = toggleRow, .mode = &kBoneMode},
    Command{.id = "drop-bone", .label = "Leave a bone out by numbers", .icon = "slice", .group = "part",
            .argument = kAt, .hint = "The bone at a place goes, and what hangs on it", .enabled = hasBones,
            .run = dropRow},
    Command{.id = "restore-bone", .label = "Take a bone back by numbers", .icon = "slice", .group = "part",
            .argument = kAt, .hint = "The bone that was left out at a place", .enabled = hasBones, .run = restoreRow},
    Command{.id = "add-bone", .label = "Add a bone by numbers", .icon = "slice", .group = "part", .argument = kLine,
            .hint = "A line from a bone to where it should reach", .enabled = hasBones, .run = addRow},
    Command{.id = "move-bone", .label = "Move a bone by numbers", .icon = "move", .group = "part", .argument = kPoint,
            .hint = "An end of a bone and where it goes", .enabled = hasBones, .run = moveRow},
    Command{.id = "bone-height", .label = "Thicker at a bone by numbers", .icon = "plus", .group = "part",
            .argument = kAt, .hint = "A place on a bone and how many times as thick", .enabled = hasBones,
            .run = raiseRow},
};
// clang-format on

}  // namespace

Outcome setSliceAt(Env env, PartId part, PicturePoint at, const sections::SectionShape& shape) {
  const BonedPuff puff = puffFor(env, part);
  if (!puff) return noBones();
  const auto place = onBones(*puff.shape, at);
  if (!place) return noBones();
  inflate::InflateParams params = *puff.params;
  auto& slices = params.profile.slices;
  const auto same = std::ranges::find_if(slices, [&](const auto& s) { return s.at && distance(*s.at, *place) < 1; });
  const auto number = static_cast<std::size_t>(same - slices.begin());
  if (same == slices.end()) {
    slices.push_back({shape, place});
  } else {
    same->shape = shape;
  }
  if (slices.size() > inflate::kMostSlices) return Refusal{"NotNow", "A puff has at most eight slices."};
  return change(env, puff, {params, &inflate::AwakeEdits::slices, number});
}

Status actOnPuffs(Env env, const std::vector<PartId>& parts, std::span<const document::Action> actions,
                  std::string_view burst) {
  const auto thin = [&] {
    int count = 0;
    for (const PartId id : parts) {
      const BonedPuff puff = puffFor(env, id);
      if (puff) count += inflate::thinRings(puff.shape->bones, puff.picture, *puff.params);
    }
    return count;
  };
  const int before = thin();
  const Status status = env.studio.act(actions, burst);
  if (thin() > before) sendHint(env.host, "A ring of this slice is too thin to show, so it is drawn a little thicker.");
  return status;
}

Outcome setPuffSlice(Env env, PartId part, std::size_t slice, const sections::SectionShape& shape) {
  const BonedPuff puff = puffFor(env, part);
  if (!puff || slice >= puff.params->profile.slices.size()) return noBones();
  inflate::InflateParams params = *puff.params;
  params.profile.slices[slice].shape = shape;
  return act(env, part, params);
}

Outcome setBones(Env env, PartId part, const inflate::InflateParams& params) { return act(env, part, params); }

Outcome dragBone(Env env, PartId part, const BoneHandle& handle, PicturePoint to) {
  const BonedPuff puff = puffFor(env, part);
  if (!puff) return noBones();
  const std::optional<BoneEdit> edit = dragged(puff, handle, handle.at, to, 1);
  return edit ? change(env, puff, *edit) : noBones();
}

Outcome setThickness(Env env, PartId part, const BoneHandle& handle, double factor) {
  const BonedPuff puff = puffFor(env, part);
  return puff ? change(env, puff, raiseBone(*puff.params, handle.named, factor)) : noBones();
}

Outcome toggleBone(Env env, PartId part, int handle) {
  const BonedPuff puff = puffFor(env, part);
  const std::vector<BoneHandle> handles = boneHandles(puff);
  if (handle < 0 || handle >= static_cast<int>(handles.size())) return noBones();
  const BoneHandle& own = handles[static_cast<std::size_t>(handle)];
  inflate::InflateParams params = *puff.params;
  const auto forget = [](auto& list, std::size_t at) { list.erase(list.begin() + static_cast<std::ptrdiff_t>(at)); };
  env.ui.chosen.bone = -1;
  switch (own.hold) {
    case BoneHold::Node:
      return Refusal{"NotNow", "An end cannot be taken away. Tap its bone instead."};
    case BoneHold::Knob:
      std::erase_if(params.bones.heights, [&](const auto& height) { return height.at == own.named; });
      break;
    case BoneHold::Slice:
      if (params.profile.slices.size() < 2) return Refusal{"NotNow", "A puff keeps one slice."};
      forget(params.profile.slices, own.edit);
      break;
    case BoneHold::Gone:
      forget(params.bones.drop, own.edit);
      break;
    case BoneHold::Bone:
      if (!own.added) return change(env, puff, dropBone(params, own.at));
      forget(params.bones.add, *own.added);
      break;
  }
  return act(env, part, params);
}

Outcome chooseBone(Env env, int handle) {
  env.ui.chosen = {};
  env.ui.chosen.bone = handle;
  env.ui.focus = Focus::Picture;
  sendStatus(env.host, boneSentence(boneHandles(inHand(env)), handle));
  return {};
}

Outcome refuseBone(Env, bool point) {
  return Refusal{"NotNow", whyNot(point ? &inflate::AwakeEdits::move : &inflate::AwakeEdits::add)};
}

constinit const Mode kBonesMode{"bones", bonesByKeys};
constinit const Mode kBoneMode{"bone-point", boneByKeys};

std::span<const Command> puffBoneCommands() { return kTable; }

}  // namespace spineloft::app
