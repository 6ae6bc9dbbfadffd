// The rows of the command table that are about sections along a spine, curves along it, and the shelf.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/section_json.h"
#include "web/edit/section_editing.h"
#include "web/model/messages.h"
#include "web/words/words.h"

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

/// The sections along a part's spine; null when there is none of this number.
const SectionKeys* sectionsOf(Env env, PartId id, std::size_t key) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  const document::LoftRecipe* loft = part ? document::loftOf(*part) : nullptr;
  return loft && key < loft->loft.sections.size() ? &loft->loft.sections : nullptr;
}

void pick(Env env, PartId part, std::size_t key) {
  env.ui.sections.part = part;
  env.ui.sections.key = key;
}

/// Sections along one spine become each other: they need the same number of curves and holes.
Outcome setSectionKeys(Env env, PartId part, SectionKeys keys) {
  const Status status = env.studio.act(document::SetSections{part, std::move(keys)});
  return outcomeOf(status);
}

Outcome setSections(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const Json* list = args.find("slices");
  if (list == nullptr || list->array() == nullptr) return missing("a list of slices");
  SectionKeys keys;
  for (const Json& entry : *list->array()) {
    loft::SectionKey key;
    Result<std::optional<sections::SectionShape>> shape = shapeFrom(entry, env.ui.sections);
    Result<sections::Blend> blend = blendFrom(entry, {});
    if (!shape) return refuse(shape.failure());
    if (!blend) return refuse(blend.failure());
    if (shape.value()) key.shape = *shape.value();
    key.blend = std::move(blend).value();
    key.at = entry.number("at").value_or(key.at);
    keys.push_back(std::move(key));
  }
  return setSectionKeys(env, part->id, std::move(keys));
}

Outcome addSectionRow(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<double> at = args.number("at");
  if (!at) {
    env.ui.sections.placing = !env.ui.sections.placing;
    if (env.ui.sections.placing) sendStatus(env.host, "Tap the bone where the slice shall be.");
    return {};
  }
  const Result<std::optional<sections::SectionShape>> shape = shapeFrom(args, env.ui.sections);
  if (!shape) return refuse(shape.failure());
  return addSection(env, part->id, *at, shape.value());
}

Outcome moveSectionRow(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> key = sectionKeyOf(env, args, *part);
  const std::optional<double> to = args.number("to");
  if (!key) return noSection();
  return to ? moveSection(env, part->id, *key, *to) : missing("a place from 0 to 1");
}

Outcome nudge(Env env, double by) {
  const document::Part* part = selected(env);
  if (part == nullptr) return noSpine(env, {});
  const std::size_t key = pickedSectionKey(env.ui, *part);
  const auto& keys = document::loftIn(*part).loft.sections;
  return setSectionKeys(env, part->id, withMovedSectionKey(keys, key, keys[key].at + by));
}
constexpr double kNudge = 0.02;
Outcome nudgeOn(Env env, const Json&) { return nudge(env, kNudge); }
Outcome nudgeBack(Env env, const Json&) { return nudge(env, -kNudge); }

Outcome removeSectionRow(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> key = sectionKeyOf(env, args, *part);
  return key ? removeSection(env, part->id, *key) : noSection();
}

Outcome selectSectionRow(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> key = sectionKeyOf(env, args, *part);
  return key ? selectSection(env, part->id, *key) : noSection();
}

Outcome nextSection(Env env, const Json&) {
  const document::Part* part = selected(env);
  if (part == nullptr) return noSpine(env, {});
  pick(env, part->id, (pickedSectionKey(env.ui, *part) + 1) % document::loftIn(*part).loft.sections.size());
  sendStatus(env.host, words::tr("Slice {n} of {all}.", {{"n", env.ui.sections.key + 1},
                                                         {"all", document::loftIn(*part).loft.sections.size()}}));
  return {};
}

Outcome setBlendRow(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::optional<std::size_t> key = sectionKeyOf(env, args, *part);
  if (!key) return noSection();
  if (args.text("blend") == nullptr) return missing("a blend");
  const Result<sections::Blend> blend = blendFrom(args, document::loftIn(*part).loft.sections[*key].blend);
  return blend ? setBlend(env, part->id, *key, blend.value()) : refuse(blend.failure());
}

void blendChoices(Env env, JsonWriter& json) {
  const document::Part* part = selected(env);
  for (const sections::BlendName& name : sections::blendNames()) {
    const bool on =
        part && document::loftIn(*part).loft.sections[pickedSectionKey(env.ui, *part)].blend.kind == name.kind;
    json.beginObject().key("value").text(name.key).key("label").text(name.label);
    json.key("toggled").flag(on).endObject();
  }
}

// ---- Curves along the spine
// ------------------------------------------------------------------------

/// The lofts that `args` name, else those in hand.
Parts loftsFrom(Env env, const Json& args) {
  Parts parts = partsFrom(env, args);
  std::erase_if(parts,
                [&](PartId id) { return document::loftOf(*document::findPart(env.studio.document(), id)) == nullptr; });
  return parts;
}

Outcome setAlongRow(Env env, const Json& args) {
  const document::Part* part = loftPartOf(env, args);
  if (part == nullptr) return noSpine(env, args);
  const std::string* key = args.text("kind");
  const AlongInfo* info = key ? findAlong(*key) : nullptr;
  if (info == nullptr) return missing("a kind: twist, squash, tilt or bulge");
  const std::optional<geometry::AlongCurve> curve = curveFrom(args.find("points"));
  if (!curve) return missing("points: a list of [place, value]");
  return setAlong(env, loftsFrom(env, args), info->kind, *curve);
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
  }
  return setAlong(env, loftsFrom(env, args), info->kind, curve);
}

void alongChoices(Env, JsonWriter& json) {
  const auto put = [&](const AlongInfo& info, std::string_view key, std::string_view label) {
    json.beginObject().key("value").text(std::string(info.key) + "/" + std::string(key));
    json.key("label").text(std::string(info.label) + ": " + std::string(label)).endObject();
  };
  for (const AlongInfo& info : alongTable()) {
    put(info, "none", "None");
    for (const AlongShape& shape : alongShapes()) {
      if (shape.kind == info.kind) put(info, shape.key, shape.label);
    }
  }
}

Outcome openAlong(Env env, bool open) {
  env.ui.sections.alongOpen = open;
  const unsigned section = 1u << static_cast<unsigned>(PanelTab::Along);
  if (open) {
    env.ui.tab = PanelTab::Along;
    env.ui.folded &= ~section;
    env.ui.sections.revealGraph = true;
  } else {
    env.ui.folded |= section;
  }
  return {};
}

Outcome showAlongRow(Env env, const Json& args) {
  const std::string* key = args.text("kind");
  if (key == nullptr) return openAlong(env, !env.ui.sections.alongOpen);
  const AlongInfo* info = findAlong(*key);
  return info ? showAlong(env, info->kind) : refuse({Error::ValueOutOfRange, *key});
}
bool alongShown(Env env) { return env.ui.sections.alongOpen; }

// ---- The shelf
// ------------------------------------------------------------------------------------

/// Null when there is no such section on the shelf.
ShelfSection* onShelf(Env env, std::optional<double> id) {
  auto& shelf = env.ui.sections.shelf;
  const auto at = std::ranges::find_if(shelf, [&](const ShelfSection& s) { return id && s.id == *id; });
  return at == shelf.end() ? nullptr : &*at;
}
Outcome notOnShelf() { return Refusal{"NoSuchSlice", "There is no such slice on your shelf."}; }

Outcome keepSection(Env env, const Json& args) {
  Result<std::optional<sections::SectionShape>> shape = shapeFrom(args, env.ui.sections);
  if (!shape) return refuse(shape.failure());
  const sections::SectionShape kept = shape.value().value_or(pickedShape(env.ui, selected(env)));
  if (!kept.drawn()) return Refusal{"NotNow", "Only slices of your own go on the shelf."};
  return keepOnShelf(env, kept, args.text("name"));
}

Outcome renameTo(Env env, std::uint32_t id, const std::string& name) {
  ShelfSection* section = onShelf(env, id);
  if (section == nullptr) return notOnShelf();
  if (name.empty() || name.size() > document::kMaxNameBytes) {
    return refuse({Error::ValueOutOfRange, "name"});
  }
  section->name = name;
  sendShelf(env);
  return {};
}

Outcome renameSection(Env env, const Json& args) {
  const ShelfSection* section = onShelf(env, args.number("id"));
  if (section == nullptr) return notOnShelf();
  const std::string* name = args.text("name");
  return name ? renameTo(env, section->id, *name) : askSectionName(env, section->id);
}

Outcome deleteSectionRow(Env env, const Json& args) {
  const ShelfSection* section = onShelf(env, args.number("id"));
  return section ? deleteSection(env, section->id) : notOnShelf();
}

Outcome loadShelf(Env env, const Json& args) {
  const Json* list = args.find("slices");
  if (list == nullptr) return missing("slices");
  readShelf(env.ui.sections, *list);
  return {};
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "add-slice", .label = "Add a slice", .icon = "circle-plus", .group = "slice",
            .hint = "Tap the bone where another slice shall be", .enabled = hasSpine, .toggled = placing,
            .run = addSectionRow},
    Command{.id = "next-slice", .label = "Next slice", .icon = "arrow-right", .group = "slice",
            .hint = "Choose the next slice along the bone", .enabled = hasSeveral, .run = nextSection},
    Command{.id = "slice-on", .label = "Slice on", .icon = "move-horizontal", .group = "slice",
            .hint = "Move the chosen slice towards the end", .enabled = hasSeveral, .run = nudgeOn},
    Command{.id = "slice-back", .label = "Slice back", .icon = "move-horizontal", .group = "slice",
            .hint = "Move the chosen slice towards the beginning", .enabled = hasSeveral, .run = nudgeBack},
    Command{.id = "remove-slice", .label = "Remove slice", .icon = "trash-2", .group = "slice",
            .hint = "Take the chosen slice off the bone", .enabled = hasSeveral, .run = removeSectionRow},
    Command{.id = "set-blend", .label = "Change between slices", .icon = "chart-spline", .group = "slice",
            .argument = {"blend", blendChoices}, .hint = "How one slice becomes the next", .enabled = hasSeveral,
            .run = setBlendRow},
    Command{.id = "along-shape", .label = "Along the bone", .icon = "tornado", .group = "slice",
            .argument = {"shape", alongChoices}, .hint = "Twist, flatten or lean the part along its bone",
            .enabled = hasSpine, .run = alongShape},
    Command{.id = "show-along", .label = "Graphs along the bone", .icon = "chart-line", .group = "slice",
            .hint = "Show the curves of twist, depth and lean", .enabled = hasSpine, .toggled = alongShown,
            .run = showAlongRow},
    Command{.id = "keep-slice", .label = "Keep slice", .icon = "bookmark-plus", .group = "slice",
            .hint = "Put the chosen slice on your shelf", .enabled = hasDrawn, .run = keepSection},
    Command{.id = "set-slices", .label = "Slices by numbers", .icon = "layers", .group = "slice",
            .argument = {"slices"}, .hint = "All slices along the bone", .enabled = hasSpine, .run = setSections},
    Command{.id = "move-slice", .label = "Slide a slice", .icon = "move-horizontal", .group = "slice",
            .argument = {"to"}, .hint = "Move a slice along the bone", .enabled = hasSpine, .run = moveSectionRow},
    Command{.id = "select-slice", .label = "Choose a slice", .icon = "circle-dot", .group = "slice",
            .argument = {"slice"}, .hint = "Choose one of the slices along the bone", .enabled = hasSpine,
            .run = selectSectionRow},
    Command{.id = "set-along", .label = "Curve by numbers", .icon = "chart-spline", .group = "slice",
            .argument = {"points"}, .hint = "Twist, depth, lean or front along the bone", .enabled = hasSpine,
            .run = setAlongRow},
    Command{.id = "rename-slice", .label = "Rename a slice", .icon = "pencil-line", .group = "slice",
            .argument = {"id"}, .hint = "A name for a slice on your shelf", .enabled = hasShelf, .run = renameSection},
    Command{.id = "delete-slice", .label = "Delete a slice", .icon = "trash-2", .group = "slice", .argument = {"id"},
            .hint = "Take a slice off your shelf", .enabled = hasShelf, .run = deleteSectionRow},
    Command{.id = "load-shelf", .label = "Fill the shelf", .icon = "bookmark", .group = "slice", .argument = {"slices"},
            .hint = "The slices that this browser keeps", .run = loadShelf},
};
// clang-format on

}  // namespace

void sendShelf(const CommandEnv& env) {
  JsonWriter json;
  json.beginObject().key("type").text("shelf").key("slices");
  json.value(shelfJson(env.ui.sections));
  json.endObject();
  env.host.send(json.json());
}

Outcome keepOnShelf(const CommandEnv& env, const sections::SectionShape& shape, const std::string* name) {
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

Outcome setSection(Env env, const Parts& parts, std::optional<std::size_t> key, const sections::SectionShape& shape) {
  const auto loftIn = [&](PartId id) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    return part ? document::loftOf(*part) : nullptr;
  };
  if (!parts.empty() && std::ranges::none_of(parts, loftIn)) {
    return noSpine(document::findPart(env.studio.document(), parts.front()));
  }
  env.ui.section = shape;
  if (key && parts.size() == 1) {
    SectionKeys keys = loftIn(parts.front())->loft.sections;
    if (*key >= keys.size()) return noSection();
    keys[*key].shape = shape;
    return setSectionKeys(env, parts.front(), std::move(keys));
  }
  return setOnAll(env, parts, [&](const document::Part& part) -> std::optional<document::Action> {
    if (document::loftOf(part) == nullptr) return std::nullopt;
    return document::SetSection{part.id, shape};
  });
}

Outcome addSection(Env env, PartId id, double at, const std::optional<sections::SectionShape>& shape) {
  const document::Part* part = document::findPart(env.studio.document(), id);
  if (part == nullptr || document::loftOf(*part) == nullptr) return noSpine(part);
  if (!(at >= 0 && at <= 1)) return refuse({Error::ValueOutOfRange, "at"});
  std::size_t added = 0;
  SectionKeys keys =
      withSectionKey(document::loftIn(*part).loft.sections, at, shape.value_or(pickedShape(env.ui, part)), added);
  env.ui.sections.placing = false;
  if (Outcome done = setSectionKeys(env, id, std::move(keys)); !done) return done;
  env.ui.selection = id;
  pick(env, id, added);
  return {};
}

Outcome moveSection(Env env, PartId id, std::size_t key, double to) {
  const SectionKeys* keys = sectionsOf(env, id, key);
  if (keys == nullptr) return noSection();
  if (!(to >= 0 && to <= 1)) return refuse({Error::ValueOutOfRange, "to"});
  Outcome outcome = setSectionKeys(env, id, withMovedSectionKey(*keys, key, to));
  if (outcome) pick(env, id, key);
  return outcome;
}

Outcome removeSection(Env env, PartId id, std::size_t key) {
  const SectionKeys* keys = sectionsOf(env, id, key);
  if (keys == nullptr) return noSection();
  if (keys->size() < 2) return Refusal{"NotNow", "This is the part's only slice. Choose another one instead."};
  Outcome outcome = setSectionKeys(env, id, withoutSectionKey(*keys, key));
  if (outcome) pick(env, id, key > 0 ? key - 1 : 0);
  return outcome;
}

Outcome selectSection(Env env, PartId id, std::size_t key) {
  if (sectionsOf(env, id, key) == nullptr) return noSection();
  env.ui.selection = id;
  pick(env, id, key);
  return {};
}

Outcome setBlend(Env env, PartId id, std::size_t key, const sections::Blend& blend) {
  const SectionKeys* keys = sectionsOf(env, id, key);
  if (keys == nullptr) return noSection();
  SectionKeys changed = *keys;
  changed[key].blend = blend;
  return setSectionKeys(env, id, std::move(changed));
}

Outcome setAlong(Env env, const Parts& parts, document::AlongKind kind, const geometry::AlongCurve& shown) {
  geometry::AlongCurve curve = shown;
  for (geometry::AlongPoint& p : curve.points) p.value *= alongInfo(kind).unit;
  env.ui.sections.along = kind;
  const bool several = parts.size() > 1;
  return setOnAll(env, parts, [&](const document::Part& part) -> std::optional<document::Action> {
    if (several && document::loftOf(part) == nullptr) return std::nullopt;
    return document::SetAlong{part.id, kind, curve};
  });
}

Outcome showAlong(Env env, document::AlongKind kind) {
  env.ui.sections.along = kind;
  return openAlong(env, true);
}

Outcome askSectionName(Env env, std::uint32_t id) {
  const ShelfSection* section = onShelf(env, id);
  if (section == nullptr) return notOnShelf();
  const std::string question = "rename-slice:" + std::to_string(id);
  return ask(env, {question, "Rename", "A name for this slice", section->name},
             [id](Env later, const std::string& name) { return renameTo(later, id, name); });
}

Outcome deleteSection(Env env, std::uint32_t id) {
  if (std::erase_if(env.ui.sections.shelf, [&](const ShelfSection& s) { return s.id == id; }) == 0) return notOnShelf();
  sendShelf(env);
  return {};
}

Outcome rows::setSection(const CommandEnv& env, const Json& args) {
  const Result<std::optional<sections::SectionShape>> read = shapeFrom(args, env.ui.sections);
  if (!read) return refuse(read.failure());
  if (!read.value()) return missing("the name of a slice, or its contours");
  const std::optional<Parts> meant = meantParts(env, args);
  if (!meant) return noSpine(env, args);
  const Parts parts = loftsFrom(env, args);
  if (parts.empty() && !meant->empty()) return noSpine(env, args);
  std::optional<std::size_t> key;
  if (const document::Part* part = loftPartOf(env, args); part != nullptr && args.find("slice") != nullptr) {
    key = sectionKeyOf(env, args, *part);
    if (!key) return noSection();
    return app::setSection(env, {part->id}, key, *read.value());
  }
  return app::setSection(env, parts, key, *read.value());
}

std::span<const Command> sectionCommands() { return kTable; }

}  // namespace spineloft::app
