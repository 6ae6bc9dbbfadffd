// Commands about where parts stand, their copies, groups and order.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "engine/document/update.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/depth_order.h"
#include "web/edit/front_field.h"
#include "web/edit/gizmo.h"
#include "web/edit/placing.h"
#include "web/model/messages.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kNudgeMm = 1, kFarNudgeMm = 10;

const document::Document& documentOf(Env env) { return env.studio.document(); }

bool hasParts(Env env) { return !documentOf(env).parts.empty(); }
bool placing(Env env) { return env.ui.tool == ToolKind::Place; }
bool holdsParts(Env env) { return placing(env) && hasSelection(env); }
bool snaps(Env env) { return env.ui.place.snap; }
bool symmetric(Env env) {
  const document::Part* part = partOf(env, {});
  return part != nullptr && part->mirror.has_value();
}

/// Numbers under `key`; none unless there are as many as `N`, all finite.
template <std::size_t N>
std::optional<std::array<double, N>> numbersOf(const Json& args, std::string_view key) {
  const Json* list = args.find(key);
  if (list == nullptr || !list->array() || list->array()->size() != N) return std::nullopt;
  std::array<double, N> out{};
  for (std::size_t i = 0; i < N; ++i) {
    const std::optional<double> value = (*list->array())[i].number();
    if (!value || !std::isfinite(*value)) return std::nullopt;
    out[i] = *value;
  }
  return out;
}

Outcome act(Env env, const Parts& parts, const document::Motion& motion, std::string_view burst = {}) {
  const pipeline::Derived& derived = env.studio.derived();
  const document::Document& document = documentOf(env);
  const auto actions = placeActions(document, derived, movedParts(document, derived, parts, motion));
  return outcomeOf(env.studio.act(actions, burst));
}

WorldPoint middleOf(Env env, const Parts& parts) {
  return centreOf(documentOf(env), env.studio.derived(), env.ui, parts).value_or(WorldPoint{});
}

Outcome usePlace(Env env, const Json&) {
  env.ui.tool = ToolKind::Place;
  env.ui.focus = Focus::Solid;
  if (!hasSelection(env) && !documentOf(env).parts.empty()) {
    env.ui.selection = documentOf(env).parts.back()->id;
  }
  sendStatus(env.host, env.ui.touch ? "Drag a part, its arrows or its rings."
                                    : "Drag a part, its arrows or its rings. Arrow keys move it by a millimetre.");
  return {};
}

Outcome toggleSnap(Env env, const Json& args) {
  env.ui.place.snap = args.flag("snap").value_or(!env.ui.place.snap);
  sendStatus(env.host, env.ui.place.snap ? "A dragged part settles on the surface under the pointer."
                                         : "Parts are dragged freely.");
  return {};
}

Outcome movePartsRow(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  if (parts.empty()) return noPart();
  document::Motion motion;
  motion.centre = middleOf(env, parts);
  if (const auto centre = numbersOf<3>(args, "centre")) {
    motion.centre = {(*centre)[0], (*centre)[1], (*centre)[2]};
  }
  if (const auto move = numbersOf<3>(args, "move")) motion.move = {(*move)[0], (*move)[1], (*move)[2]};
  if (const auto mm = numbersOf<3>(args, "mm")) {
    const double scale = mmPerUnit(documentOf(env), env.studio.derived());
    if (scale > 0) motion.move = WorldPoint{(*mm)[0], (*mm)[1], (*mm)[2]} / scale;
  }
  if (const auto turn = numbersOf<4>(args, "turn")) {
    motion.turn = {(*turn)[0], (*turn)[1], (*turn)[2], (*turn)[3]};
  }
  if (const auto degrees = numbersOf<3>(args, "degrees")) {
    motion.turn = geometry::turnOf({(*degrees)[0] * kDegree, (*degrees)[1] * kDegree, (*degrees)[2] * kDegree});
  }
  motion.scale = args.number("scale").value_or(1);
  return moveParts(env, parts, motion);
}

/// The lead part's own numbers as far as `given` has them by their keys; the others of the selection go along with it.
template <class Given>
Outcome placeBy(Env env, const document::Part& lead, const Parts& parts, const Given& given) {
  if (document::bridgeOf(lead) != nullptr) return refuse({Error::BridgeFollows, {}});
  const pipeline::Derived& derived = env.studio.derived();
  const Parts own{lead.id};
  const double mm = mmPerUnit(documentOf(env), derived);
  const document::Placement from = movedParts(documentOf(env), derived, own, {}).front().placement;
  document::Placement to = from;
  const auto number = [&](std::string_view key, double unit, double& value) {
    const std::optional<double> wanted = given(key);
    if (wanted && unit != 0) value = *wanted * unit;
  };
  const double unit = mm > 0 ? 1 / mm : 0;
  number("x", unit, to.move.x);
  number("y", unit, to.move.y);
  number("z", unit, to.move.z);
  number("size", 0.01, to.scale);
  geometry::Angles angles = geometry::anglesOf(from.turn);
  const geometry::Angles before = angles;
  number("tip", kDegree, angles.tip);
  number("turn", kDegree, angles.turn);
  number("lean", kDegree, angles.roll);
  if (!(angles == before)) to.turn = geometry::turnOf(angles);
  if (!document::isValid(to)) return refuse({Error::ValueOutOfRange, "place"});
  return act(env, parts, document::between(from, to));
}

Outcome setPlace(Env env, const Json& args) {
  const document::Part* lead = partOf(env, args);
  if (lead == nullptr) return noPart();
  return placeBy(env, *lead, partsFrom(env, args), [&](std::string_view key) { return args.number(key); });
}

/// What was typed for one of the numbers; with a comma or a point.
Outcome placeTyped(Env env, std::string_view key, std::string typed) {
  std::ranges::replace(typed, ',', '.');
  const std::optional<double> value = numberFrom(typed);
  if (!value) return Refusal{"ValueOutOfRange", "That is no number. Type one such as 12.5."};
  const document::Part* lead = document::findPart(documentOf(env), env.ui.selection);
  if (lead == nullptr) return noPart();
  return placeBy(env, *lead, selectedParts(documentOf(env), env.ui),
                 [&](std::string_view each) { return each == key ? value : std::nullopt; });
}

struct Field {
  std::string_view key, title, text;
};
constexpr std::array kFields = {Field{"x", "Left and right", "Millimetres to the right of where it was drawn"},
                                Field{"y", "Up and down", "Millimetres above where it was drawn"},
                                Field{"z", "Front and back", "Millimetres in front of where it was drawn"},
                                Field{"tip", "Tip over", "Degrees, -90 to 90"},
                                Field{"turn", "Turn round", "Degrees, -180 to 180"},
                                Field{"lean", "Lean", "Degrees, -180 to 180"},
                                Field{"size", "Size", "Percent of the size it was drawn in"}};

/// Asks for one of the part's numbers.
Outcome askNumber(Env env, const document::Part& lead, const std::string& key) {
  const auto field = std::ranges::find(kFields, key, &Field::key);
  if (field == kFields.end()) return missing("which number: x, y, z, tip, turn, lean or size");
  char text[32];
  std::snprintf(text, sizeof text, "%.4g",
                placeNumber(lead, field->key, mmPerUnit(documentOf(env), env.studio.derived())));
  return ask(env, {"place:" + key, field->title, field->text, text},
             [key](Env later, const std::string& typed) { return placeTyped(later, key, typed); });
}
Outcome askPlaceRow(Env env, const Json& args) {
  const document::Part* lead = partOf(env, args);
  if (lead == nullptr) return noPart();
  const std::string* key = args.text("field");
  return askNumber(env, *lead, key ? *key : std::string());
}

void fieldChoices(Env, JsonWriter& json) {
  for (const Field& field : kFields) writeChoice(json, field.key, field.title, false);
}

/// Straight ahead on the ground as the camera looks: one of the four directions of x and z.
WorldPoint squareOn(double x, double z) {
  if (std::abs(x) >= std::abs(z)) return {x < 0 ? -1.0 : 1.0, 0, 0};
  return {0, 0, z < 0 ? -1.0 : 1.0};
}

Outcome nudgePart(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  const std::string* key = args.text("key");
  const double mm = mmPerUnit(documentOf(env), env.studio.derived());
  if (parts.empty() || !(mm > 0)) return noPart();
  if (key == nullptr) return missing("a key such as ArrowLeft");
  const double step = (args.flag("far").value_or(false) ? kFarNudgeMm : kNudgeMm) / mm;
  const WorldPoint right = squareOn(env.ui.camera.right().x, env.ui.camera.right().z);
  const WorldPoint nearer = squareOn(std::sin(env.ui.camera.yaw), std::cos(env.ui.camera.yaw));
  document::Motion motion;
  if (*key == "ArrowLeft") motion.move = right * -step;
  if (*key == "ArrowRight") motion.move = right * step;
  if (*key == "ArrowUp") motion.move = {0, step, 0};
  if (*key == "ArrowDown") motion.move = {0, -step, 0};
  if (*key == "PageUp") motion.move = nearer * -step;
  if (*key == "PageDown") motion.move = nearer * step;
  return act(env, parts, motion, "nudge part " + std::to_string(parts.front().value));
}

Outcome faceFront(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  const document::Part* lead = document::findPart(documentOf(env), parts.empty() ? PartId{} : parts.front());
  if (lead == nullptr) return noPart();
  if (lead->placement.turn.isRest()) {
    return Refusal{"NotNow", "It faces the front already."};
  }
  document::Motion motion;
  motion.centre = middleOf(env, parts);
  motion.turn = geometry::normalized(geometry::inverse(lead->placement.turn));
  const pipeline::Derived& derived = env.studio.derived();
  auto ones = movedParts(documentOf(env), derived, parts, motion);
  for (document::PlaceParts::One& one : ones) {
    // As it was drawn, not all but: what is left of rounding would be a turn of its own.
    if (document::findPart(documentOf(env), one.part)->placement.turn == lead->placement.turn) one.placement.turn = {};
  }
  return outcomeOf(env.studio.act(placeActions(documentOf(env), derived, std::move(ones))));
}

Outcome resetPlace(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  if (parts.empty()) return noPart();
  const pipeline::Derived& derived = env.studio.derived();
  auto ones = movedParts(documentOf(env), derived, parts, {});
  for (document::PlaceParts::One& one : ones) {
    one.placement = {one.placement.pivot, one.placement.move, {}, 1, false};
  }
  return outcomeOf(env.studio.act(placeActions(documentOf(env), derived, std::move(ones))));
}

Outcome dropOnFloor(Env env, const Json& args) {
  const Parts parts = withHosts(documentOf(env), partsFrom(env, args));
  const pipeline::Derived& derived = env.studio.derived();
  const auto own = pipeline::boundsOf(documentOf(env), derived, parts);
  const auto others = pipeline::boundsWithout(documentOf(env), derived, parts);
  if (!own) return noPart();
  const double down = others ? others->low.y - own->low.y : 0;
  if (down == 0) return Refusal{"NotNow", "It stands on the floor already."};
  document::Motion motion;
  motion.move = {0, down, 0};
  return act(env, parts, motion);
}

/// The axis of a mirror of these parts: the likely one when none is named; null for another name.
const MirrorAxis* axisFor(Env env, const Parts& parts, const Json& args) {
  const auto axes = mirrorAxes();
  const std::string* name = args.text("axis");
  if (name == nullptr) return &likelyAxis(documentOf(env), env.studio.derived(), parts);
  const auto at = std::ranges::find(axes, *name, &MirrorAxis::key);
  return at == axes.end() ? nullptr : &*at;
}

void axisChoices(Env, JsonWriter& json) {
  for (const MirrorAxis& axis : mirrorAxes()) writeChoice(json, axis.key, axis.words, false, axis.icon);
}
void symmetryChoices(Env env, JsonWriter& json) {
  const document::Part* part = partOf(env, {});
  writeChoice(json, "off", "None", part != nullptr && !part->mirror, "ban");
  for (const MirrorAxis& axis : mirrorAxes()) {
    const bool on = part != nullptr && part->mirror && isAcross(*part->mirror, axis);
    writeChoice(json, axis.key, axis.words, on, axis.icon);
  }
}

/// The copies, which are the parts with ids above `last`, are in hand now.
void selectNew(Env env, std::uint32_t last) {
  env.ui.alsoSelected.clear();
  env.ui.selection = {};
  for (const document::Part& part : documentOf(env).parts) {
    if (part.id.value <= last) continue;
    if (env.ui.selection) {
      env.ui.alsoSelected.push_back(part.id);
    } else {
      env.ui.selection = part.id;
    }
  }
  // Of a whole solid they are a solid.
  const document::Step* root = rootOf(documentOf(env), {env.ui.selection, {}});
  if (root != nullptr) env.ui.solids.step = root->id;
}

bool inSight(Env env, const pipeline::WorldBounds& bounds) {
  return isInSight(env.ui.camera, env.ui.layout.solid, bounds);
}

pipeline::WorldBounds shifted(const pipeline::WorldBounds& bounds, WorldPoint by) {
  return {bounds.low + by, bounds.high + by};
}

/// The copies are in hand, and in sight: what is made and not seen would be made once more.
void takeCopies(Env env, std::uint32_t last) {
  selectNew(env, last);
  const auto bounds = pipeline::boundsOf(documentOf(env), env.studio.derived(), partsFrom(env, {}));
  if (bounds && !inSight(env, *bounds)) flyTo(env, false);
}

/// Beside the original: to the right as it is seen, or to the left where only there it is in sight.
WorldPoint besideOf(Env env, const std::optional<pipeline::WorldBounds>& own) {
  constexpr double kLeast = 0.04, kShare = 0.3;  // world units; of the width
  const WorldPoint right = env.ui.camera.right();
  const bool alongX = std::abs(right.x) >= std::abs(right.z);
  const double width = !own ? 0 : alongX ? own->high.x - own->low.x : own->high.z - own->low.z;
  const double by = std::copysign(std::max(kLeast, kShare * width), alongX ? right.x : right.z);
  const WorldPoint there = alongX ? WorldPoint{by, 0, 0} : WorldPoint{0, 0, by};
  const bool left = own && !inSight(env, shifted(*own, there)) && inSight(env, shifted(*own, there * -1.0));
  return left ? there * -1.0 : there;
}

Outcome duplicate(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  const auto own = pipeline::boundsOf(documentOf(env), env.studio.derived(), parts);
  if (parts.empty()) return noPart();
  const std::uint32_t last = documentOf(env).lastPartId;
  const Status status = env.studio.act(document::DuplicateParts{parts, besideOf(env, own), {}});
  if (status) takeCopies(env, last);
  return outcomeOf(status);
}

Outcome mirrorCopy(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  const MirrorAxis* axis = axisFor(env, parts, args);
  if (parts.empty()) return noPart();
  if (axis == nullptr) return missing("an axis: x, y or z");
  const std::uint32_t last = documentOf(env).lastPartId;
  const document::MirrorPlane plane = planeFor(documentOf(env), env.studio.derived(), parts, *axis);
  const Status status = env.studio.act(document::DuplicateParts{parts, {}, plane});
  if (status) takeCopies(env, last);
  return outcomeOf(status);
}

/// No axis: the parts have no other side.
Outcome mirrorAcross(Env env, const Parts& parts, const MirrorAxis* axis) {
  if (parts.empty()) return noPart();
  const pipeline::Derived& derived = env.studio.derived();
  auto ones = movedParts(documentOf(env), derived, parts, {});
  std::optional<document::MirrorPlane> plane;
  if (axis != nullptr) plane = planeFor(documentOf(env), derived, parts, *axis);
  for (document::PlaceParts::One& one : ones) one.mirror = plane;
  return outcomeOf(env.studio.act(placeActions(documentOf(env), derived, std::move(ones))));
}

Outcome symmetry(Env env, const Json& args) {
  const std::string* name = args.text("axis");
  const bool off = name != nullptr ? *name == "off" : symmetric(env);
  const Parts parts = partsFrom(env, args);
  const MirrorAxis* axis = off ? nullptr : axisFor(env, parts, args);
  if (!parts.empty() && !off && axis == nullptr) return missing("an axis: x, y, z or off");
  Outcome done = mirrorAcross(env, parts, axis);
  if (done && !off && name == nullptr) {
    sendStatus(env.host, words::tr("{sides} are alike now. Other sides can be chosen beside it.",
                                   {{"sides", words::tr(axis->words)}}));
  }
  return done;
}

Outcome group(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  if (parts.size() < 2) return Refusal{"NotNow", "Choose two parts at least: hold Shift and click them."};
  const std::string* name = args.text("name");
  return outcomeOf(env.studio.act(document::GroupParts{parts, name ? *name : std::string()}));
}

Outcome ungroupRow(Env env, const Json& args) {
  std::vector<GroupId> groups;
  for (const PartId id : partsFrom(env, args)) {
    const GroupId of = document::findPart(documentOf(env), id)->group;
    if (of && std::ranges::count(groups, of) == 0) groups.push_back(of);
  }
  if (groups.empty()) return Refusal{"NotNow", "These parts are in no group."};
  std::vector<document::Action> actions;
  for (const GroupId id : groups) actions.push_back(document::Ungroup{id});
  return outcomeOf(env.studio.act(actions));
}

Outcome noGroup() { return Refusal{"NotNow", "This part is in no group."}; }

Outcome renameGroup(Env env, const Json& args) {
  GroupId id{idFrom(args, "group").value};
  const document::Part* part = partOf(env, {});
  if (!id && part != nullptr) id = part->group;
  if (document::findGroup(documentOf(env), id) == nullptr) return noGroup();
  const std::string* name = args.text("name");
  return name ? outcomeOf(env.studio.act(document::RenameGroup{id, *name})) : askGroupName(env, id);
}

Outcome selectAll(Env env, const Json&) {
  env.ui.alsoSelected.clear();
  for (const document::Part& part : documentOf(env).parts) {
    if (!env.ui.selection) env.ui.selection = part.id;
    if (part.id != env.ui.selection) env.ui.alsoSelected.push_back(part.id);
  }
  return {};
}

/// The part before, within or behind what it overlaps.
template <Lie kLie>
Outcome lieSo(Env env, const Json& args) {
  const document::Part* part = partOf(env, args);
  const document::PictureEntry* entry = part ? findPicture(documentOf(env), document::pictureOf(*part)) : nullptr;
  if (entry == nullptr) return noPart();
  const PartId id = part->id;
  const pipeline::Derived& derived = env.studio.derived();
  const auto shown = std::ranges::find(derived.parts, id, &pipeline::DerivedPart::id);
  if (shown == derived.parts.end() || !shown->shape) return Refusal{"NotNow", "This part has no shape."};
  double by = 0;
  if (kLie == Lie::Inside) {
    const auto drawn = pipeline::standBeside(documentOf(env), derived, entry->id, shown->shape->mesh);
    by = drawn.move.z - part->placement.move.z;
  } else {
    const Lying lying = lyingOf(documentOf(env), derived, bodyAlone(documentOf(env), derived, id), id);
    const std::optional<double> way = kLie == Lie::InFront ? lying.front : lying.behind;
    if (!way) return Refusal{"NotNow", "It overlaps no other part in the picture."};
    by = *way;
  }
  const bool fresh = partIsNew(env);
  document::Motion motion;
  motion.move = {0, 0, by};
  if (by != 0) {
    if (Outcome done = act(env, {id}, motion); !done) return done;
  }
  if (fresh) env.ui.newPart = NewPart{id, kLie, env.studio.undoSteps()};
  return {};
}
template <Lie kLie>
bool liesSo(Env env) {
  return partIsNew(env) && env.ui.newPart->lie == kLie;
}

/// The list is an order in depth: what goes past others goes before or behind them, in the same step.
Outcome moveTo(Env env, const Parts& parts, PartId before, bool inDepth = true) {
  const document::Document was = documentOf(env);
  std::vector<document::Action> actions{document::MoveInList{parts, before}};
  const Result<document::Document> is = document::update(was, actions.front());
  if (!is) return refuse(is.failure());
  const pipeline::Derived& derived = env.studio.derived();
  const auto depth = inDepth ? depthMove(was, is.value(), derived, parts) : std::nullopt;
  if (depth) {
    document::Motion motion;
    motion.move = {0, 0, depth->by};
    const auto places = placeActions(was, derived, movedParts(was, derived, parts, motion));
    actions.insert(actions.end(), places.begin(), places.end());
  }
  const Status status = env.studio.act(actions);
  if (status && depth) {
    sendStatus(env.host, words::tr(depth->by > 0 ? "In front of {name} now." : "Behind {name} now.",
                                   {{"name", words::nameOf(depth->beyond)}}));
  }
  return outcomeOf(status);
}

Outcome moveInListRow(Env env, const Json& args) {
  const Parts parts = partsFrom(env, args);
  if (parts.empty()) return noPart();
  return moveTo(env, parts, idFrom(args, "before"), args.flag("depth").value_or(true));
}

Outcome shiftInList(Env env, const Json& args, int by) {
  const Parts moving = namesPart(args) ? partsFrom(env, args) : Parts{env.ui.selection};
  const auto& parts = documentOf(env).parts;
  const auto at = std::ranges::find_if(
      parts, [&](const document::Part& part) { return !moving.empty() && part.id == moving.front(); });
  if (at == parts.end()) return noPart();
  const auto index = static_cast<std::size_t>(at - parts.begin());
  if (by < 0 && index == 0) return Refusal{"NotNow", "It is the first of the list already."};
  if (by > 0 && index + 1 == parts.size()) return Refusal{"NotNow", "It is the last of the list already."};
  const std::size_t before = by < 0 ? index - 1 : index + 2;
  const PartId next = before < parts.size() ? parts[before]->id : PartId{};
  return moveTo(env, {moving.front()}, next);
}
Outcome listUp(Env env, const Json& args) { return shiftInList(env, args, -1); }
Outcome listDown(Env env, const Json& args) { return shiftInList(env, args, 1); }

constexpr std::string_view kKeys =
    "ArrowLeft, ArrowRight, ArrowUp, ArrowDown, PageUp, PageDown, Shift+ArrowLeft, Shift+ArrowRight, "
    "Shift+ArrowUp, Shift+ArrowDown";
constexpr Argument kKey{"key"}, kMotion{"move"}, kParts{"parts"}, kGroup{"group"}, kPlace{"x"},
    kField{"field", fieldChoices}, kAxis{"axis", axisChoices}, kSymmetry{"axis", symmetryChoices};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "move", .label = "Move", .icon = "move-3d", .shortcut = "9, W", .group = "tool",
            .hint = "Move, turn and scale parts in the solid view", .enabled = hasParts, .toggled = placing,
            .run = usePlace},
    Command{.id = "snap-to-surface", .label = "Snap", .icon = "magnet", .shortcut = "Shift+S", .group = "place",
            .hint = "A dragged part settles on the surface under the pointer", .enabled = hasParts, .toggled = snaps,
            .run = toggleSnap},
    Command{.id = "drop-on-floor", .label = "On the floor", .icon = "arrow-down-to-line", .shortcut = "Shift+D",
            .group = "place", .hint = "Let it stand on the floor", .enabled = hasSelection, .run = dropOnFloor},
    Command{.id = "face-front", .label = "Face front", .icon = "scan-face", .shortcut = "Shift+H", .group = "place",
            .hint = "Turned as it was drawn in the picture", .enabled = hasSelection, .run = faceFront},
    Command{.id = "reset-place", .label = "Reset turn and size", .icon = "rotate-ccw", .group = "place",
            .hint = "As it was drawn, but it stays where it is", .enabled = hasSelection, .run = resetPlace},
    Command{.id = "duplicate", .label = "Duplicate", .icon = "copy", .shortcut = "Ctrl+D", .group = "place",
            .hint = "One more of the same", .menu = "Part", .enabled = hasSelection, .run = duplicate},
    Command{.id = "in-front", .label = "In front", .icon = "arrow-down-from-line", .group = "place",
            .hint = "It lies on what it overlaps in the picture", .enabled = hasSelection,
            .toggled = liesSo<Lie::InFront>, .run = lieSo<Lie::InFront>},
    Command{.id = "inside", .label = "Inside", .icon = "circle-dot", .group = "place",
            .hint = "As deep as everything else of its picture", .enabled = hasSelection,
            .toggled = liesSo<Lie::Inside>, .run = lieSo<Lie::Inside>},
    Command{.id = "behind", .label = "Behind", .icon = "arrow-up-from-line", .group = "place",
            .hint = "It lies behind what it overlaps in the picture", .enabled = hasSelection,
            .toggled = liesSo<Lie::Behind>, .run = lieSo<Lie::Behind>},
    Command{.id = "mirror-copy", .label = "Mirrored copy", .icon = "flip-horizontal-2", .group = "place",
            .argument = kAxis, .hint = "A copy on the other side", .enabled = hasSelection, .run = mirrorCopy},
    Command{.id = "symmetry", .label = "Symmetry", .icon = "flip-vertical-2", .group = "place", .argument = kSymmetry,
            .hint = "The other side always follows", .menu = "Part", .enabled = hasSelection, .toggled = symmetric, .run = symmetry},
    Command{.id = "group", .label = "Group", .icon = "group", .shortcut = "Ctrl+G", .group = "place",
            .hint = "Take these parts in hand together", .enabled = severalSelected, .run = group},
    Command{.id = "ungroup", .label = "Ungroup", .icon = "ungroup", .shortcut = "Shift+Ctrl+G", .group = "place",
            .hint = "Each part by itself again", .enabled = groupSelected, .run = ungroupRow},
    Command{.id = "rename-group", .label = "Rename group", .icon = "pencil-line", .group = "place", .argument = kGroup,
            .hint = "Give the group a name", .enabled = groupSelected, .run = renameGroup},
    Command{.id = "select-all", .label = "Select all parts", .icon = "square-stack", .shortcut = "Ctrl+A",
            .group = "part", .hint = "Take all parts in hand", .enabled = hasParts, .run = selectAll},
    Command{.id = "nudge-part", .label = "Move by keys", .icon = "move", .shortcut = kKeys, .group = "place",
            .argument = kKey, .hint = "Arrows move the part by a millimetre, with Shift by ten",
            .enabled = hasSelection, .run = nudgePart, .mode = &kPartsMode},
    Command{.id = "ask-place", .label = "Place by numbers", .icon = "ruler", .group = "place", .argument = kField,
            .hint = "Type a place in millimetres, a turn in degrees, a size in percent", .enabled = hasSelection,
            .run = askPlaceRow},
    Command{.id = "set-place", .label = "Set a place by numbers", .icon = "ruler", .group = "place", .argument = kPlace,
            .hint = "Millimetres, degrees and percent", .enabled = hasSelection, .run = setPlace},
    Command{.id = "move-parts", .label = "Move parts by numbers", .icon = "move", .group = "place", .argument = kMotion,
            .hint = "Millimetres, degrees and a factor", .enabled = hasParts, .run = movePartsRow},
    Command{.id = "list-up", .label = "Up in the list", .icon = "chevron-up", .shortcut = "Shift+PageUp",
            .group = "part", .hint = "Before the part above it, and in front of it", .enabled = hasSelection,
            .run = listUp},
    Command{.id = "list-down", .label = "Down in the list", .icon = "chevron-down", .shortcut = "Shift+PageDown",
            .group = "part", .hint = "After the part below it, and behind it", .enabled = hasSelection,
            .run = listDown},
    Command{.id = "move-in-list", .label = "Move in the list by number", .icon = "list", .group = "part",
            .argument = kParts, .hint = "Parts, and the one before which they go: in front of what they pass upwards",
            .enabled = hasParts, .run = moveInListRow},
};
// clang-format on

}  // namespace

Outcome moveParts(Env env, const std::vector<PartId>& parts, const document::Motion& motion) {
  const auto isThere = [&](PartId id) { return document::findPart(documentOf(env), id) != nullptr; };
  if (parts.empty() || !std::ranges::all_of(parts, isThere)) return noPart();
  if (!(motion.scale >= document::kLeastScale && motion.scale <= document::kMostScale)) {
    return refuse({Error::ValueOutOfRange, "scale"});
  }
  document::Motion sound = motion;
  sound.turn = geometry::normalized(motion.turn);
  return act(env, parts, sound);
}

Outcome askPlace(Env env, const std::string& field) {
  const document::Part* lead = document::findPart(documentOf(env), env.ui.selection);
  return lead ? askNumber(env, *lead, field) : noPart();
}

Outcome setSymmetry(Env env, const MirrorAxis* axis) {
  return mirrorAcross(env, selectedParts(documentOf(env), env.ui), axis);
}

Outcome askGroupName(Env env, GroupId id) {
  const document::Group* group = document::findGroup(documentOf(env), id);
  if (group == nullptr) return noGroup();
  const std::string question = "rename-group:" + std::to_string(id.value);
  const std::vector<PartId> members = document::partsOfGroup(documentOf(env), id);
  const auto at = rowAt(env.ui, {members.empty() ? PartId{} : members.front(), id});
  return ask(env, {question, "Rename", "A name for this group", group->name, at},
             [id](Env later, const std::string& name) {
               return outcomeOf(later.studio.act(document::RenameGroup{id, name}));
             });
}

Outcome ungroup(Env env, GroupId group) { return outcomeOf(env.studio.act(document::Ungroup{group})); }

Outcome moveInList(Env env, const std::vector<PartId>& parts, PartId before) { return moveTo(env, parts, before); }

bool severalInHand(const CommandEnv& env) {
  const document::Document& document = documentOf(env);
  std::size_t count = 0;
  return std::ranges::any_of(
      document.parts, [&](const document::Part& part) { return isSelected(document, env.ui, part.id) && ++count > 1; });
}
bool groupIsSelected(const CommandEnv& env) {
  const document::Document& document = documentOf(env);
  return std::ranges::any_of(
      document.parts, [&](const document::Part& part) { return part.group && isSelected(document, env.ui, part.id); });
}

constinit const Mode kPartsMode{"parts", holdsParts};

std::span<const Command> placeCommands() { return kTable; }

}  // namespace spineloft::app
