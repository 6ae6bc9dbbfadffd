// The rows of the command table that are about the board, parts and views. Other features bring their
// own rows (see command_groups.h).
#include <algorithm>
#include <array>

#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/modes.h"
#include "web/edit/editing.h"
#include "web/edit/section_editing.h"
#include "web/model/swatches.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool hasAnything(Env env) { return hasPicture(env) || hasParts(env); }
/// Some of what is selected has it, or nothing is selected: then the next part has. Asked in every frame: without
/// memory.
template <class Has>
bool orTheNextPart(Env env, const Has& has) {
  const auto hasIt = [&](PartId id) {
    const document::Part* part = document::findPart(env.studio.document(), id);
    return part != nullptr && has(*part);
  };
  return hasPicture(env) &&
         (!env.ui.selection || hasIt(env.ui.selection) || std::ranges::any_of(env.ui.alsoSelected, hasIt));
}
bool takesSlice(Env env) {
  return orTheNextPart(env, [](const document::Part& part) { return document::loftOf(part) != nullptr; });
}
bool takesEnds(Env env) {
  return orTheNextPart(env, [](const document::Part& part) { return capsOf(part).has_value(); });
}
constexpr Condition kTakesSlice{takesSlice, Condition::Part | Condition::Parts, Error::NotABone};
constexpr Condition kTakesEnds{takesEnds, Condition::Part | Condition::Parts, Error::NotABone};
bool canUndo(Env env) { return topMode(env, &Mode::undo).canUndo(env); }
bool canRedo(Env env) { return topMode(env, &Mode::redo).canRedo(env); }

bool drawing(Env env) { return env.ui.tool == ToolKind::Draw; }
bool hand(Env env) { return env.ui.tool == ToolKind::Hand; }
bool redrawing(Env env) { return static_cast<bool>(env.ui.redraw); }
bool textured(Env env) { return currentLook(env).textured; }
bool focusOnPicture(Env env) { return env.ui.focus == Focus::Picture; }
bool focusOnSolid(Env env) { return env.ui.focus == Focus::Solid; }

Outcome undo(Env env, const Json& args) { return topMode(env, &Mode::undo).undo(env, args); }
Outcome redo(Env env, const Json& args) { return topMode(env, &Mode::redo).redo(env, args); }
Outcome cancel(Env env, const Json&) {
  topMode(env, &Mode::cancel).cancel(env);
  return {};
}
Outcome useDraw(Env env, const Json&) {
  env.ui.tool = ToolKind::Draw;
  return {};
}
Outcome useHand(Env env, const Json&) {
  env.ui.tool = ToolKind::Hand;
  env.ui.redraw = {};
  return {};
}
bool allTools(Env env) { return env.ui.allTools; }
Outcome moreTools(Env env, const Json& args) {
  env.ui.allTools = args.flag("on").value_or(!env.ui.allTools);
  return {};
}
Outcome findCommandByWords(Env env, const Json&) {
  sendShow(env.host, "find-command");
  return {};
}
Outcome help(Env env, const Json&) {
  sendShow(env.host, "help");
  return {};
}

Outcome chooseLanguage(Env env, const Json& args) {
  const std::string* id = args.text("language");
  if (id == nullptr) return missing("a language: en, de, fr, es, ja or ar");
  if (std::ranges::find(words::known(), *id, &words::Known::id) == words::known().end()) {
    return refuse({Error::ValueOutOfRange, *id});
  }
  sendLanguage(env.host, *id);
  return {};
}

void languageChoices(Env, JsonWriter& json) {
  for (const words::Known& one : words::known()) writeChoice(json, one.id, one.name, one.id == words::language().id);
}

void partChoices(Env env, JsonWriter& json) {
  for (const document::Part& part : env.studio.document().parts) {
    json.beginObject().key("value").number(part.id.value).key("label").text(part.name);
    json.key("toggled").flag(part.id == env.ui.selection).endObject();
  }
}

void sectionChoices(Env env, JsonWriter& json) {
  const sections::SectionShape& chosen = pickedShape(env.ui, partOf(env, Json()));
  for (const sections::SectionName& name : sections::sectionNames()) {
    writeChoice(json, name.key, name.label, !chosen.drawn() && name.preset == chosen.preset);
  }
}

void capChoices(Env env, JsonWriter& json) {
  const document::Part* part = partOf(env, Json());
  const sections::CapStyle start = part ? document::loftIn(*part).loft.startCap : env.ui.startCap;
  const sections::CapStyle end = part ? document::loftIn(*part).loft.endCap : env.ui.endCap;
  for (const sections::CapName& name : sections::capNames()) {
    writeChoice(json, name.key, name.label, name.style == start && name.style == end);
  }
}

void colourChoices(Env env, JsonWriter& json) {
  const document::Look look = currentLook(env);
  for (const Swatch& swatch : kSwatches) {
    const auto& c = look.colour;
    const unsigned hex = (unsigned{c[0]} << 16) | (unsigned{c[1]} << 8) | c[2];
    writeChoice(json, swatch.value, swatch.label, !look.textured && hex == swatch.hex);
  }
}

// clang-format off
constexpr std::array kTable = {
    Command{.id = "open-picture", .label = "Open picture", .icon = "image-plus", .shortcut = "Ctrl+O", .group = "file",
            .hint = "Choose a photo or a drawing", .menu = "Pictures", .run = rows::openPicture},
    Command{.id = "draw", .label = "Line", .icon = "spline", .shortcut = "1, D", .group = "tool",
            .hint = "Draw one line along the middle of the thing", .enabled = hasPicture, .toggled = drawing,
            .run = useDraw},
    Command{.id = "hand", .label = "Move picture", .icon = "hand", .shortcut = "2", .group = "tool",
            .hint = "Drag the picture about", .enabled = hasPicture, .toggled = hand, .run = useHand},
    Command{.id = "new-part", .label = "New part", .icon = "plus", .shortcut = "N", .group = "part",
            .hint = "The next line makes a new part", .menu = "Part", .enabled = hasPicture, .run = rows::newPart},
    Command{.id = "redraw", .label = "Draw again", .icon = "pencil-line", .shortcut = "R", .group = "part",
            .hint = "The next line replaces the one of this part", .enabled = hasSelection, .toggled = redrawing,
            .run = rows::redrawMode},
    Command{.id = "undo", .label = "Undo", .icon = "undo-2", .shortcut = "Ctrl+Z", .group = "edit",
            .hint = "Take back the last step", .enabled = canUndo, .run = undo},
    Command{.id = "redo", .label = "Redo", .icon = "redo-2", .shortcut = "Shift+Ctrl+Z, Ctrl+Y", .group = "edit",
            .hint = "Do it again after all", .menu = "Part", .enabled = canRedo, .run = redo},
    Command{.id = "delete-part", .label = "Delete part", .icon = "trash-2", .shortcut = "Delete, Backspace",
            .group = "edit", .hint = "Delete this part", .enabled = hasSelection, .run = rows::deletePart},
    Command{.id = "select-part", .label = "Select part", .icon = "list", .group = "part",
            .argument = {"id", partChoices}, .hint = "Choose a part of the list", .enabled = hasParts,
            .run = rows::selectPart},
    Command{.id = "next-part", .label = "Next part", .icon = "chevron-right", .shortcut = "P", .group = "part",
            .hint = "Choose the next part", .enabled = hasParts, .run = rows::nextPart},
    Command{.id = "set-section", .label = "Slice", .icon = "slice", .group = "part",
            .argument = {"section", sectionChoices}, .hint = "The shape of a cut across", .enabled = kTakesSlice,
            .run = rows::setSection},
    Command{.id = "set-caps", .label = "Ends", .icon = "cylinder", .group = "part", .argument = {"both", capChoices},
            .hint = "How the ends are finished", .enabled = kTakesEnds, .run = rows::setCaps},
    Command{.id = "toggle-texture", .label = "Picture on it", .icon = "image", .shortcut = "T", .group = "part",
            .hint = "The picture on the part, or a plain colour", .enabled = hasPicture, .toggled = textured,
            .run = rows::toggleTexture},
    Command{.id = "set-colour", .label = "Colour", .icon = "palette", .group = "part",
            .argument = {"colour", colourChoices}, .hint = "A plain colour", .enabled = hasPicture,
            .run = rows::setColour},
    Command{.id = "rename-part", .label = "Rename", .icon = "pencil-line", .shortcut = "F2", .group = "part",
            .hint = "Give the part a name", .enabled = hasSelection, .run = rows::renamePart},
    Command{.id = "show-part", .label = "Show or hide", .icon = "eye", .group = "part",
            .hint = "Show or hide the part, or the solid that it is in", .enabled = hasSelection,
            .run = rows::showPart},
    Command{.id = "set-parameter", .label = "Detail", .icon = "sliders-horizontal", .group = "part",
            .argument = {"value"}, .hint = "A number of the recipe", .enabled = hasParts, .run = rows::setParameter},
    Command{.id = "draw-spine", .label = "Draw a line by numbers", .icon = "spline", .group = "part",
            .argument = {"stroke"}, .hint = "A stroke in picture pixels", .enabled = hasPicture,
            .run = rows::drawSpine},
    Command{.id = "redraw-spine", .label = "Replace a line by numbers", .icon = "spline", .group = "part",
            .argument = {"stroke"}, .hint = "A stroke in picture pixels", .enabled = hasParts,
            .run = rows::redrawSpine},
    Command{.id = "home-view", .label = "Home view", .icon = "house", .shortcut = "H", .group = "view",
            .hint = "See the whole model from the front", .run = rows::homeView},
    Command{.id = "fit", .label = "Fit", .icon = "maximize", .shortcut = "F", .group = "view",
            .hint = "Make everything fit the view", .enabled = hasPicture, .run = rows::fitView},
    Command{.id = "zoom-in", .label = "Zoom in", .icon = "zoom-in", .shortcut = "+, =", .group = "view",
            .hint = "Nearer", .enabled = hasPicture, .run = rows::zoomIn},
    Command{.id = "zoom-out", .label = "Zoom out", .icon = "zoom-out", .shortcut = "-, _", .group = "view",
            .hint = "Farther", .enabled = hasPicture, .run = rows::zoomOut},
    Command{.id = "turn-left", .label = "Turn left", .icon = "box", .shortcut = "ArrowLeft", .group = "view",
            .hint = "Turn the solid, or move the picture when its view is chosen", .enabled = hasPicture,
            .run = rows::turnLeft},
    Command{.id = "turn-right", .label = "Turn right", .icon = "box", .shortcut = "ArrowRight", .group = "view",
            .hint = "Turn the solid, or move the picture when its view is chosen", .enabled = hasPicture,
            .run = rows::turnRight},
    Command{.id = "turn-up", .label = "Turn up", .icon = "box", .shortcut = "ArrowUp", .group = "view",
            .hint = "Turn the solid, or move the picture when its view is chosen", .enabled = hasPicture,
            .run = rows::turnUp},
    Command{.id = "turn-down", .label = "Turn down", .icon = "box", .shortcut = "ArrowDown", .group = "view",
            .hint = "Turn the solid, or move the picture when its view is chosen", .enabled = hasPicture,
            .run = rows::turnDown},
    Command{.id = "focus-picture", .label = "Picture view", .icon = "image", .shortcut = "3", .group = "view",
            .hint = "Keys go to the picture", .enabled = hasPicture, .toggled = focusOnPicture,
            .run = rows::focusPicture},
    Command{.id = "focus-solid", .label = "Solid view", .icon = "box", .shortcut = "4", .group = "view",
            .hint = "Keys go to the solid", .enabled = hasPicture, .toggled = focusOnSolid, .run = rows::focusSolid},
    Command{.id = "more-tools", .label = "More tools", .icon = "shapes", .group = "view",
            .hint = "Ribs, bone, shape and the others beside the first tools", .toggled = allTools,
            .run = moreTools},
    Command{.id = "save-glb", .label = "Save GLB", .icon = "download", .group = "file",
            .hint = "3D model with colours, for most programs", .enabled = hasParts, .run = rows::saveGlb},
    Command{.id = "save-stl", .label = "Save STL", .icon = "download", .group = "file",
            .hint = "For a 3D printer, in millimetres", .enabled = hasParts, .run = rows::saveStl},
    Command{.id = "clear", .label = "Start over", .icon = "refresh-cw", .group = "file", .hint = "An empty board",
            .enabled = hasAnything, .run = rows::clearBoard},
    Command{.id = "cancel", .label = "Cancel", .icon = "x", .shortcut = "Escape", .group = "edit",
            .hint = "Stop what is going on", .run = cancel},
    Command{.id = "language", .label = "Language", .icon = "languages", .group = "help",
            .argument = {"language", languageChoices}, .hint = "The words of this page in another language",
            .run = chooseLanguage},
    Command{.id = "find-command", .label = "Find a command", .icon = "search", .shortcut = "/", .group = "help",
            .hint = "All that can be done here, by its words", .menu = "Help", .run = findCommandByWords},
    Command{.id = "help", .label = "Help", .icon = "circle-question-mark", .shortcut = "?", .group = "help",
            .hint = "How it is done: things to make, gestures, keys", .menu = "Help", .run = help},
};
// clang-format on

}  // namespace

bool partIsSelected(const CommandEnv& env) { return partOf(env, Json()) != nullptr; }
bool spineIsSelected(const CommandEnv& env) { return loftPartOf(env, Json()) != nullptr; }

std::span<const Command> generalCommands() { return kTable; }

}  // namespace spineloft::app
