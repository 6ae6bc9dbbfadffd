// The rows of the command table that are about sections along a spine, curves along it, and the shelf.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/section_json.h"
#include "web/edit/section_editing.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;
using SectionKeys = std::vector<loft::SectionKey>;

const document::Part* selected(Env env) { return loftPartOf(env, Json()); }
bool hasSeveral(Env env) {
  const document::Part* part = selected(env);
  return part != nullptr && document::loftIn(*part).loft.sections.size() > 1;
}
bool hasShelf(Env env) { return !env.ui.sections.shelf.empty(); }
bool hasDrawn(Env env) { return pickedShape(env.ui, selected(env)).drawn(); }
bool placing(Env env) { return env.ui.sections.placing; }

/// The section of the part that `args.section` counts (from 0), else the picked one; none when there is
/// no such section.
std::optional<std::size_t> sectionKeyOf(Env env, const Json& args, const document::Part& part) {
  if (args.find("slice") == nullptr) return pickedSectionKey(env.ui, part);
  const std::optional<double> index = args.number("slice");
  const auto count = static_cast<double>(document::loftIn(part).loft.sections.size());
  if (!index || !(*index >= 0 && *index < count)) return std::nullopt;
  return static_cast<std::size_t>(*index);
}
Outcome noSection() { return refuse({Error::ValueOutOfRange, "slice"}); }

void pick(Env env, PartId part, std::size_t stop) {
  env.ui.sections.part = part;
  env.ui.sections.stop = stop;
}

/// Sections along one spine become each other: they need the same number of curves and holes.
Outcome setSectionKeys(Env env, PartId part, SectionKeys stops) {
  const Status status = env.studio.act(document::SetSections{part, std::move(stops)});
  return outcomeOf(status);
}

Outcome setSections(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const Json* list = args.find("slices");
  if (list == nullptr || list->array() == nullptr) return missing("a list of slices");
  SectionKeys stops;
  for (const Json& entry : *list->array()) {
    loft::SectionKey stop;
    Result<std::optional<loft::SectionShape>> shape = shapeFrom(entry, env.ui.sections);
    Result<loft::Blend> blend = blendFrom(entry, {});
    if (!shape) return refuse(shape.failure());
    if (!blend) return refuse(blend.failure());
    if (shape.value()) stop.shape = *shape.value();
    stop.blend = std::move(blend).value();
    stop.at = entry.number("at").value_or(stop.at);
    stops.push_back(std::move(stop));
  }
  return setSectionKeys(env, part->id, std::move(stops));
}

Outcome addSection(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<double> at = args.number("at");
  if (!at) {
    env.ui.sections.placing = !env.ui.sections.placing;
    if (env.ui.sections.placing) sendStatus(env.host, "Tap the bone where the slice shall be.");
    return {};
  }
  if (!(*at >= 0 && *at <= 1)) return refuse({Error::ValueOutOfRange, "at"});
  Result<std::optional<loft::SectionShape>> shape = shapeFrom(args, env.ui.sections);
  if (!shape) return refuse(shape.failure());
  const PartId id = part->id;
  std::size_t added = 0;
  SectionKeys stops = withSectionKey(document::loftIn(*part).loft.sections, *at,
                                     shape.value().value_or(pickedShape(env.ui, part)), added);
  env.ui.sections.placing = false;
  if (Outcome done = setSectionKeys(env, id, std::move(stops)); !done) return done;
  env.ui.selection = id;
  pick(env, id, added);
  return {};
}

Outcome moveSection(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> stop = sectionKeyOf(env, args, *part);
  const std::optional<double> to = args.number("to");
  if (!stop) return noSection();
  if (!to) return missing("a place from 0 to 1");
  if (!(*to >= 0 && *to <= 1)) return refuse({Error::ValueOutOfRange, "to"});
  const PartId id = part->id;
  Outcome outcome = setSectionKeys(env, id, withMovedSectionKey(document::loftIn(*part).loft.sections, *stop, *to));
  if (outcome) pick(env, id, *stop);
  return outcome;
}

Outcome nudge(Env env, double by) {
  const document::Part* part = selected(env);
  if (part == nullptr) return noSpine(env, {});
  const std::size_t stop = pickedSectionKey(env.ui, *part);
  const auto& stops = document::loftIn(*part).loft.sections;
  return setSectionKeys(env, part->id, withMovedSectionKey(stops, stop, stops[stop].at + by));
}
constexpr double kNudge = 0.02;
Outcome nudgeOn(Env env, const Json&) { return nudge(env, kNudge); }
Outcome nudgeBack(Env env, const Json&) { return nudge(env, -kNudge); }

Outcome removeSection(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> stop = sectionKeyOf(env, args, *part);
  if (!stop) return noSection();
  if (document::loftIn(*part).loft.sections.size() < 2) {
    return Refusal{"NotNow", "This is the part's only slice. Choose another one instead."};
  }
  const PartId id = part->id;
  Outcome outcome = setSectionKeys(env, id, withoutSectionKey(document::loftIn(*part).loft.sections, *stop));
  if (outcome) pick(env, id, *stop > 0 ? *stop - 1 : 0);
  return outcome;
}

Outcome selectSection(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> stop = sectionKeyOf(env, args, *part);
  if (!stop) return noSection();
  env.ui.selection = part->id;
  pick(env, part->id, *stop);
  return {};
}

Outcome nextSection(Env env, const Json&) {
  const document::Part* part = selected(env);
  if (part == nullptr) return noSpine(env, {});
  pick(env, part->id, (pickedSectionKey(env.ui, *part) + 1) % document::loftIn(*part).loft.sections.size());
  sendStatus(env.host, "Slice " + std::to_string(env.ui.sections.stop + 1) + " of " +
                           std::to_string(document::loftIn(*part).loft.sections.size()) + ".");
  return {};
}

Outcome setBlend(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> stop = sectionKeyOf(env, args, *part);
  if (!stop) return noSection();
  if (args.text("blend") == nullptr) return missing("a blend");
  SectionKeys stops = document::loftIn(*part).loft.sections;
  Result<loft::Blend> blend = blendFrom(args, stops[*stop].blend);
  if (!blend) return refuse(blend.failure());
  stops[*stop].blend = std::move(blend).value();
  return setSectionKeys(env, part->id, std::move(stops));
}

void blendChoices(Env env, JsonWriter& json) {
  const document::Part* part = selected(env);
  for (const loft::BlendName& name : loft::blendNames()) {
    const bool on =
        part && document::loftIn(*part).loft.sections[pickedSectionKey(env.ui, *part)].blend.kind == name.kind;
    json.beginObject().key("value").text(name.key).key("label").text(name.label);
    json.key("toggled").flag(on).endObject();
  }
}

// ---- Curves along the spine
// ------------------------------------------------------------------------

Outcome setAlongCurve(Env env, PartId part, document::AlongKind kind, geometry::AlongCurve curve) {
  return outcomeOf(env.studio.act(document::SetAlong{part, kind, std::move(curve)}));
}

Outcome setAlong(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::string* key = args.text("kind");
  const AlongInfo* info = key ? findAlong(*key) : nullptr;
  if (info == nullptr) return missing("a kind: twist, squash, tilt or bulge");
  const std::optional<geometry::AlongCurve> curve = curveFrom(args.find("points"), info->unit);
  if (!curve) return missing("points: a list of [place, value]");
  env.ui.sections.along = info->kind;
  return setAlongCurve(env, part->id, info->kind, *curve);
}

Outcome alongShape(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::string* name = args.text("shape");
  if (name == nullptr) return missing("a shape such as twist/turn");
  const std::size_t slash = name->find('/');
  const AlongInfo* info = findAlong(std::string_view(*name).substr(0, slash));
  if (info == nullptr || slash == std::string::npos) return refuse({Error::ValueOutOfRange, *name});
  const std::string_view rest = std::string_view(*name).substr(slash + 1);
  geometry::AlongCurve curve;
  if (rest != "none") {
    const auto shapes = alongShapes();
    const auto at = std::ranges::find_if(
        shapes, [&](const AlongShape& shape) { return shape.kind == info->kind && shape.key == rest; });
    if (at == shapes.end()) return refuse({Error::ValueOutOfRange, *name});
    curve.points = at->points;
    for (geometry::AlongPoint& p : curve.points) p.value *= info->unit;
  }
  env.ui.sections.along = info->kind;
  return setAlongCurve(env, part->id, info->kind, std::move(curve));
}

void alongChoices(Env, JsonWriter& json) {
  const auto put = [&](const AlongInfo& info, std::string_view key, std::string_view label) {
    json.beginObject().key("value").text(std::string(info.key) + "/" + std::string(key));
    json.key("label").text(std::string(info.label) + ": " + std::string(label)).endObject();
  };
  for (const AlongInfo& info : alongTable()) {
    put(info, "none", "none");
    for (const AlongShape& shape : alongShapes()) {
      if (shape.kind == info.kind) put(info, shape.key, shape.label);
    }
  }
}

Outcome showAlong(Env env, const Json& args) {
  if (const std::string* key = args.text("kind")) {
    const AlongInfo* info = findAlong(*key);
    if (info == nullptr) return refuse({Error::ValueOutOfRange, *key});
    env.ui.sections.along = info->kind;
    env.ui.sections.alongOpen = true;
  } else {
    env.ui.sections.alongOpen = !env.ui.sections.alongOpen;
  }
  const unsigned section = 1u << static_cast<unsigned>(PanelTab::Along);
  if (env.ui.sections.alongOpen) {
    env.ui.tab = PanelTab::Along;
    env.ui.folded &= ~section;
    env.ui.sections.revealGraph = true;
  } else {
    env.ui.folded |= section;
  }
  return {};
}
bool alongShown(Env env) { return env.ui.sections.alongOpen; }

// ---- The shelf
// ------------------------------------------------------------------------------------

/// The shelf, or null when there is no such section on it.
ShelfSection* onShelf(Env env, const Json& args) {
  auto& shelf = env.ui.sections.shelf;
  const std::optional<double> id = args.number("id");
  const auto at = std::ranges::find_if(shelf, [&](const ShelfSection& s) { return id && s.id == *id; });
  return at == shelf.end() ? nullptr : &*at;
}
Outcome notOnShelf() { return Refusal{"NoSuchSlice", "There is no such slice on your shelf."}; }

Outcome keepSection(Env env, const Json& args) {
  Result<std::optional<loft::SectionShape>> shape = shapeFrom(args, env.ui.sections);
  if (!shape) return refuse(shape.failure());
  const loft::SectionShape kept = shape.value().value_or(pickedShape(env.ui, selected(env)));
  if (!kept.drawn()) return Refusal{"NotNow", "Only slices of your own go on the shelf."};
  return keepOnShelf(env, kept, args.text("name"));
}

Outcome renameSection(Env env, const Json& args) {
  ShelfSection* section = onShelf(env, args);
  if (section == nullptr) return notOnShelf();
  const std::string* name = args.text("name");
  if (name == nullptr) {
    const std::string id = "rename-slice:" + std::to_string(section->id);
    sendQuestion(env.host, {id, "Rename", "A name for this slice", section->name});
    return {};
  }
  if (name->empty() || name->size() > document::kMaxNameBytes) {
    return refuse({Error::ValueOutOfRange, "name"});
  }
  section->name = *name;
  sendShelf(env);
  return {};
}

Outcome deleteSection(Env env, const Json& args) {
  const ShelfSection* section = onShelf(env, args);
  if (section == nullptr) return notOnShelf();
  std::erase_if(env.ui.sections.shelf, [id = section->id](const ShelfSection& s) { return s.id == id; });
  sendShelf(env);
  return {};
}

Outcome loadShelf(Env env, const Json& args) {
  const Json* list = args.find("slices");
  if (list == nullptr) return missing("slices");
  readShelf(env.ui.sections, *list);
  return {};
}

constexpr std::array kTable = {
    Command{"add-slice",
            "Add a slice",
            "circle-plus",
            "",
            "slice",
            {},
            "Tap the bone where another slice shall be",
            hasSpine,
            placing,
            addSection},
    Command{"next-slice",
            "Next slice",
            "arrow-right",
            "",
            "slice",
            {},
            "Choose the next slice along the bone",
            hasSeveral,
            nullptr,
            nextSection},
    Command{"slice-on",
            "Slice on",
            "move-horizontal",
            "",
            "slice",
            {},
            "Move the chosen slice towards the end",
            hasSeveral,
            nullptr,
            nudgeOn},
    Command{"slice-back",
            "Slice back",
            "move-horizontal",
            "",
            "slice",
            {},
            "Move the chosen slice towards the beginning",
            hasSeveral,
            nullptr,
            nudgeBack},
    Command{"remove-slice",
            "Remove slice",
            "trash-2",
            "",
            "slice",
            {},
            "Take the chosen slice off the bone",
            hasSeveral,
            nullptr,
            removeSection},
    Command{"set-blend",
            "Change between slices",
            "chart-spline",
            "",
            "slice",
            {"blend", blendChoices},
            "How one slice becomes the next",
            hasSeveral,
            nullptr,
            setBlend},
    Command{"along-shape",
            "Along the bone",
            "tornado",
            "",
            "slice",
            {"shape", alongChoices},
            "Twist, flatten or lean the part along its bone",
            hasSpine,
            nullptr,
            alongShape},
    Command{"show-along",
            "Graphs along the bone",
            "chart-line",
            "",
            "slice",
            {},
            "Show the curves of twist, depth and lean",
            hasSpine,
            alongShown,
            showAlong},
    Command{"keep-slice",
            "Keep slice",
            "bookmark-plus",
            "",
            "slice",
            {},
            "Put the chosen slice on your shelf",
            hasDrawn,
            nullptr,
            keepSection},
    Command{"set-slices",
            "Slices by numbers",
            "layers",
            "",
            "slice",
            {"slices"},
            "All slices along the bone",
            hasSpine,
            nullptr,
            setSections},
    Command{"move-slice",
            "Slide a slice",
            "move-horizontal",
            "",
            "slice",
            {"to"},
            "Move a slice along the bone",
            hasSpine,
            nullptr,
            moveSection},
    Command{"select-slice",
            "Choose a slice",
            "circle-dot",
            "",
            "slice",
            {"slice"},
            "Choose one of the slices along the bone",
            hasSpine,
            nullptr,
            selectSection},
    Command{"set-along",
            "Curve by numbers",
            "chart-spline",
            "",
            "slice",
            {"points"},
            "Twist, depth, lean or front along the bone",
            hasSpine,
            nullptr,
            setAlong},
    Command{"rename-slice",
            "Rename a slice",
            "pencil-line",
            "",
            "slice",
            {"id"},
            "A name for a slice on your shelf",
            hasShelf,
            nullptr,
            renameSection},
    Command{"delete-slice",
            "Delete a slice",
            "trash-2",
            "",
            "slice",
            {"id"},
            "Take a slice off your shelf",
            hasShelf,
            nullptr,
            deleteSection},
    Command{"load-shelf",
            "Fill the shelf",
            "bookmark",
            "",
            "slice",
            {"slices"},
            "The slices that this browser keeps",
            nullptr,
            nullptr,
            loadShelf},
};

}  // namespace

void sendShelf(const CommandEnv& env) {
  JsonWriter json;
  json.beginObject().key("type").text("shelf").key("slices");
  json.value(shelfJson(env.ui.sections));
  json.endObject();
  env.host.send(json.json());
}

Outcome keepOnShelf(const CommandEnv& env, const loft::SectionShape& shape, const std::string* name) {
  SectionUi& sections = env.ui.sections;
  const auto same = [&](const ShelfSection& section) { return section.shape == shape; };
  if (std::ranges::any_of(sections.shelf, same)) return {};
  if (sections.shelf.size() >= kMostShelfSections) {
    return Refusal{"ShelfFull", "Your shelf is full. Delete a slice to keep this one."};
  }
  const std::uint32_t id = ++sections.lastShelfId;
  const bool named = name && !name->empty() && name->size() <= document::kMaxNameBytes;
  sections.shelf.push_back({id, named ? *name : "My slice " + std::to_string(id), shape});
  sendShelf(env);
  return {};
}

Outcome setSection(const CommandEnv& env, const Json& args) {
  Result<std::optional<loft::SectionShape>> read = shapeFrom(args, env.ui.sections);
  if (!read) return refuse(read.failure());
  if (!read.value()) return missing("the name of a slice, or its contours");
  const loft::SectionShape shape = *std::move(read).value();
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr && (namesPart(args) || partOf(env, args))) return noSpine(env, args);
  env.ui.section = shape;
  if (part == nullptr) return {};
  if (args.find("slice") == nullptr) {
    return outcomeOf(env.studio.act(document::SetSection{part->id, shape}));
  }
  const std::optional<std::size_t> stop = sectionKeyOf(env, args, *part);
  if (!stop) return noSection();
  SectionKeys stops = document::loftIn(*part).loft.sections;
  stops[*stop].shape = shape;
  return setSectionKeys(env, part->id, std::move(stops));
}

std::span<const Command> sectionCommands() { return kTable; }

}  // namespace spineloft::app
