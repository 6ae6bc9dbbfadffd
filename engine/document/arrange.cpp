#include "engine/document/arrange.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <tuple>
#include <utility>

#include "engine/document/checks.h"
#include "engine/document/update_drawings.h"

namespace spineloft::document {
namespace {

using Parts = std::vector<Box<Part>>;

Parts::iterator placeOf(Parts& parts, PartId id) {
  return std::ranges::find_if(parts, [&](const Part& part) { return part.id == id; });
}

template <class Change>
void edit(Box<Part>& box, const Change& change) {
  Part copy = box;
  change(copy);
  box = std::move(copy);
}

/// At least one part, each known and named once.
Status checkList(const Document& document, const std::vector<PartId>& ids) {
  if (ids.empty()) return Error::NoSuchPart;
  std::set<PartId> seen;
  for (const PartId id : ids) {
    if (findPart(document, id) == nullptr) return Error::NoSuchPart;
    if (!seen.insert(id).second) return {Error::ValueOutOfRange, "a part named twice"};
  }
  return Done{};
}

/// Takes the parts out of the list, in the order of `ids`.
Parts takeOut(Parts& parts, const std::vector<PartId>& ids) {
  Parts out;
  for (const PartId id : ids) {
    const auto at = placeOf(parts, id);
    out.push_back(*at);
    parts.erase(at);
  }
  return out;
}

GroupId addGroup(Document& document, const std::string& name) {
  Group group;
  group.id = GroupId{++document.lastGroupId};
  group.name = tidyName(name, fallbackName(group));
  document.groups.push_back(group);
  return group.id;
}

/// "Ear" → "Ear copy", kept within the bytes of a name.
std::string copyName(const std::string& name) {
  constexpr std::string_view kCopy = " copy";
  if (name.size() + kCopy.size() > kMaxNameBytes) return name;
  return name.ends_with(kCopy) ? name : name + std::string(kCopy);
}

Part copyOf(const Part& part, PartId id, const DuplicateParts& how) {
  Part copy = part;
  copy.id = id;
  copy.name = copyName(part.name);
  const Motion motion{{}, how.by, {}, 1};
  copy.placement = moved(part.placement, motion);
  if (copy.mirror) copy.mirror = moved(*copy.mirror, motion);
  if (how.over) {
    copy.placement = mirrored(copy.placement, *how.over);
    if (copy.mirror) {
      // The twin of the mirrored copy is the mirrored twin.
      const MirrorPlane& own = *copy.mirror;
      const WorldPoint tip = (*how.over)(own.point + own.normal), foot = (*how.over)(own.point);
      copy.mirror = MirrorPlane{foot, normalized(tip - foot)};
    }
  }
  return copy;
}

using Copies = std::map<PartId, PartId>;  // by original

/// A bridge is copied with the parts that it joins.
bool isCopied(const Part& part, const std::vector<PartId>& asked) {
  const auto isAsked = [&](PartId id) { return std::ranges::find(asked, id) != asked.end(); };
  const BridgeRecipe* bridge = bridgeOf(part);
  return isAsked(part.id) && (bridge == nullptr || (isAsked(bridge->from.part) && isAsked(bridge->to.part)));
}

/// Copies of bridges join the copies.
void copyHosts(Parts& parts, const Copies& copies) {
  for (const auto& [original, id] : copies) {
    edit(*placeOf(parts, id), [&](Part& part) {
      BridgeRecipe* bridge = bridgeOf(part);
      if (bridge == nullptr) return;
      part.placement = {};
      bridge->from.part = copies.at(bridge->from.part);
      bridge->to.part = copies.at(bridge->to.part);
    });
  }
}

/// The side that a plane across an axis of the world mirrors it to.
OpeningSide mirroredSide(OpeningSide side, const MirrorPlane& over) {
  using enum OpeningSide;
  constexpr double kAcross = 0.999;
  const std::array<std::tuple<double, OpeningSide, OpeningSide>, 3> axes = {
      {{over.normal.x, Left, Right}, {over.normal.y, Up, Down}, {over.normal.z, Front, Back}}};
  for (const auto& [share, one, other] : axes) {
    if (std::abs(share) < kAcross) continue;
    if (side == one) return other;
    if (side == other) return one;
  }
  return side;
}

/// The copies of all that a solid is made of are such a solid again.
Status copySteps(Document& document, const Copies& copies, const std::optional<MirrorPlane>& over) {
  std::map<StepId, StepId> ids;
  std::vector<Step> added;
  for (const Step& step : document.steps) {
    const bool whole =
        std::ranges::all_of(partsIn(document, {{}, step.id}), [&](PartId id) { return copies.contains(id); });
    if (!whole) continue;
    ids[step.id] = StepId{++document.lastStepId};
    added.push_back(step);
  }
  if (document.steps.size() + added.size() > kMostSteps) return {Error::ValueOutOfRange, "too many solids"};
  for (Step& copy : added) {
    copy.id = ids.at(copy.id);
    copy.name = copyName(copy.name);
    if (over) copy.opening.side = mirroredSide(copy.opening.side, *over);
    for (Operand& operand : copy.operands) {
      operand = operand.part ? Operand{copies.at(operand.part), {}} : Operand{{}, ids.at(operand.step)};
    }
    document.steps.push_back(std::move(copy));
  }
  return Done{};
}

/// A single part that was dropped: does it stand within a group, or away from its own?
void settleGroup(Document& document, PartId id) {
  const auto at = placeOf(document.parts, id);
  const GroupId own = (*at)->group;
  const GroupId above = at == document.parts.begin() ? GroupId{} : (*std::prev(at))->group;
  const GroupId below = std::next(at) == document.parts.end() ? GroupId{} : (*std::next(at))->group;
  GroupId group = own;
  if (above && above == below) {
    group = above;
  } else if (own && own != above && own != below && partsOfGroup(document, own).size() > 1) {
    group = {};
  }
  if (group == own) return;
  edit(*at, [&](Part& part) { part.group = group; });
}

}  // namespace

void dropEmptyGroups(Document& document) {
  std::erase_if(document.groups, [&](const Group& group) {
    return std::ranges::none_of(document.parts, [&](const Part& part) { return part.group == group.id; });
  });
}

Status arrange(Document& document, const PlaceParts& action) {
  std::vector<PartId> ids;
  for (const PlaceParts::One& one : action.parts) ids.push_back(one.part);
  if (Status list = checkList(document, ids); !list) return list;
  for (const PlaceParts::One& one : action.parts) {
    if (!isValid(one.placement)) return {Error::ValueOutOfRange, "place"};
    if (one.mirror && !isValid(*one.mirror)) return {Error::ValueOutOfRange, "mirror"};
    const auto at = placeOf(document.parts, one.part);
    if ((*at)->placement == one.placement && (*at)->mirror == one.mirror) continue;
    edit(*at, [&](Part& part) {
      if (bridgeOf(part) == nullptr) part.placement = one.placement;
      part.mirror = one.mirror;
    });
  }
  return Done{};
}

Status arrange(Document& document, const DuplicateParts& action) {
  if (Status list = checkList(document, action.parts); !list) return list;
  if (document.parts.size() + action.parts.size() > kMostParts) {
    return {Error::ValueOutOfRange, "too many parts"};
  }
  if (action.over && !isValid(*action.over)) return {Error::ValueOutOfRange, "mirror"};
  // Groups that are copied whole, and the copies of them.
  std::vector<std::pair<GroupId, GroupId>> groups;
  const std::vector<Group> before = document.groups;
  for (const Group& group : before) {
    const std::vector<PartId> members = partsOfGroup(document, group.id);
    const bool whole = std::ranges::all_of(
        members, [&](PartId id) { return std::ranges::find(action.parts, id) != action.parts.end(); });
    if (whole) groups.emplace_back(group.id, addGroup(document, copyName(group.name)));
  }
  Parts parts;
  Copies made;
  std::vector<std::pair<GroupId, Parts>> waiting;  // copies that follow when their group is through
  const auto flush = [&](GroupId current) {
    for (auto& [group, copies] : waiting) {
      if (group == current) continue;
      parts.insert(parts.end(), copies.begin(), copies.end());
      copies.clear();
    }
  };
  for (const Box<Part>& box : document.parts) {
    flush(box->group);
    parts.push_back(box);
    if (!isCopied(*box, action.parts)) continue;
    Part copy = copyOf(*box, PartId{++document.lastPartId}, action);
    made[box->id] = copy.id;
    if (!isValid(copy.placement) || (copy.mirror && !isValid(*copy.mirror))) {
      return {Error::ValueOutOfRange, "place"};
    }
    const auto grouped = std::ranges::find(groups, box->group, &std::pair<GroupId, GroupId>::first);
    if (!box->group || grouped == groups.end()) {
      parts.push_back(std::move(copy));
      continue;
    }
    copy.group = grouped->second;
    auto own = std::ranges::find(waiting, box->group, &std::pair<GroupId, Parts>::first);
    if (own == waiting.end()) own = waiting.insert(own, {box->group, {}});
    own->second.push_back(std::move(copy));
  }
  flush({});
  if (made.empty()) return Error::BridgeFollows;
  copyHosts(parts, made);
  std::vector<std::pair<PartId, PartId>> originals(made.begin(), made.end());
  // Solids are looked through before the copies stand between their parts.
  const Status solids = copySteps(document, made, action.over);
  document.parts = std::move(parts);
  return solids ? copyDrawings(document, originals) : solids;
}

Status arrange(Document& document, const GroupParts& action) {
  if (Status list = checkList(document, action.parts); !list) return list;
  std::vector<PartId> ids;  // in the order of the list
  for (const Part& part : document.parts) {
    if (std::ranges::find(action.parts, part.id) != action.parts.end()) ids.push_back(part.id);
  }
  const auto first = std::distance(document.parts.begin(), placeOf(document.parts, ids.front()));
  const GroupId group = addGroup(document, action.name);
  Parts members = takeOut(document.parts, ids);
  for (Box<Part>& box : members) edit(box, [&](Part& part) { part.group = group; });
  document.parts.insert(document.parts.begin() + first, members.begin(), members.end());
  return Done{};
}

Status arrange(Document& document, const Ungroup& action) {
  if (findGroup(document, action.group) == nullptr) return {Error::ValueOutOfRange, "no such group"};
  for (Box<Part>& box : document.parts) {
    if (box->group == action.group) edit(box, [](Part& part) { part.group = {}; });
  }
  return Done{};
}

Status arrange(Document& document, const RenameGroup& action) {
  const auto at = std::ranges::find(document.groups, action.group, &Group::id);
  if (at == document.groups.end()) return {Error::ValueOutOfRange, "no such group"};
  at->name = tidyName(action.name, fallbackName(*at));
  return Done{};
}

Status arrange(Document& document, const MoveInList& action) {
  if (Status list = checkList(document, action.parts); !list) return list;
  if (action.before && findPart(document, action.before) == nullptr) return Error::NoSuchPart;
  if (std::ranges::find(action.parts, action.before) != action.parts.end()) return Done{};
  const Parts moving = takeOut(document.parts, action.parts);
  const auto at = action.before ? placeOf(document.parts, action.before) : document.parts.end();
  document.parts.insert(at, moving.begin(), moving.end());
  if (action.parts.size() == 1) settleGroup(document, action.parts.front());
  return Done{};
}

}  // namespace spineloft::document
