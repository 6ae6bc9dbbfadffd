#include "web/app/commands.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "web/app/command_actions.h"
#include "web/app/swatches.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasPictures(Env env) { return env.studio.document().pictures.size() > 1; }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool hasSelection(Env env) { return partOf(env, Json()) != nullptr; }
bool hasAnything(Env env) { return hasPicture(env) || hasParts(env); }
bool canUndo(Env env) { return env.studio.undoSteps() > 0; }
bool canRedo(Env env) { return env.studio.redoSteps() > 0; }

bool drawing(Env env) { return env.ui.tool == ToolKind::Draw; }
bool hand(Env env) { return env.ui.tool == ToolKind::Hand; }
bool redrawing(Env env) { return static_cast<bool>(env.ui.redraw); }
bool textured(Env env) { return currentLook(env).textured; }
bool focusOnPicture(Env env) { return env.ui.focus == Focus::Picture; }
bool focusOnSolid(Env env) { return env.ui.focus == Focus::Solid; }

Outcome undo(Env env, const Json&) { return outcomeOf(env.studio.undo()); }
Outcome redo(Env env, const Json&) { return outcomeOf(env.studio.redo()); }
Outcome useDraw(Env env, const Json&) {
  env.ui.tool = ToolKind::Draw;
  return {};
}
Outcome useHand(Env env, const Json&) {
  env.ui.tool = ToolKind::Hand;
  env.ui.redraw = {};
  return {};
}
Outcome cancel(Env env, const Json&) {
  if (env.ui.preview) {
    env.ui.preview.reset();
  } else if (env.ui.redraw) {
    env.ui.redraw = {};
  } else if (env.studio.busy()) {
    env.studio.cancelWork();
  } else {
    env.ui.selection = {};
  }
  return {};
}

void writeChoice(JsonWriter& json, std::string_view value, std::string_view label, bool on) {
  json.beginObject().key("value").text(value).key("label").text(label);
  json.key("toggled").flag(on).endObject();
}

void partChoices(Env env, JsonWriter& json) {
  for (const document::Part& part : env.studio.document().parts) {
    json.beginObject().key("value").number(part.id.value).key("label").text(part.name);
    json.key("toggled").flag(part.id == env.ui.selection).endObject();
  }
}

void sectionChoices(Env env, JsonWriter& json) {
  const document::Part* part = partOf(env, Json());
  const loft::SectionPreset chosen = part ? part->recipe.loft.section : env.ui.section;
  for (const loft::SectionName& name : loft::sectionNames()) {
    writeChoice(json, name.key, name.label, name.preset == chosen);
  }
}

void capChoices(Env env, JsonWriter& json) {
  const document::Part* part = partOf(env, Json());
  const loft::CapStyle start = part ? part->recipe.loft.startCap : env.ui.startCap;
  const loft::CapStyle end = part ? part->recipe.loft.endCap : env.ui.endCap;
  for (const loft::CapName& name : loft::capNames()) {
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

constexpr std::array kTable = {
    Command{"open-picture",
            "Open picture",
            "image-plus",
            "Ctrl+O",
            "file",
            {},
            "Choose a photo or a drawing",
            nullptr,
            nullptr,
            openPicture},
    Command{"draw",
            "Draw",
            "pencil",
            "1, D",
            "tool",
            {},
            "Draw one line along the middle of the thing",
            hasPicture,
            drawing,
            useDraw},
    Command{"hand",
            "Move picture",
            "hand",
            "2",
            "tool",
            {},
            "Drag the picture about",
            hasPicture,
            hand,
            useHand},
    Command{"new-part",
            "New part",
            "plus",
            "N",
            "part",
            {},
            "The next line makes a new part",
            hasPicture,
            nullptr,
            newPart},
    Command{"redraw",
            "Draw again",
            "pencil-line",
            "R",
            "part",
            {},
            "The next line replaces the bone of this part",
            hasSelection,
            redrawing,
            redrawMode},
    Command{"undo",
            "Undo",
            "undo-2",
            "Ctrl+Z",
            "edit",
            {},
            "Take back the last step",
            canUndo,
            nullptr,
            undo},
    Command{"redo",
            "Redo",
            "redo-2",
            "Shift+Ctrl+Z, Ctrl+Y",
            "edit",
            {},
            "Do it again after all",
            canRedo,
            nullptr,
            redo},
    Command{"delete-part",
            "Delete part",
            "trash-2",
            "Delete, Backspace",
            "edit",
            {},
            "Delete this part",
            hasSelection,
            nullptr,
            deletePart},
    Command{"select-part",
            "Select part",
            "list",
            "",
            "part",
            {"id", partChoices},
            "Choose a part of the list",
            hasParts,
            nullptr,
            selectPart},
    Command{"next-part",
            "Next part",
            "chevron-right",
            "P",
            "part",
            {},
            "Choose the next part",
            hasParts,
            nullptr,
            nextPart},
    Command{"set-section",
            "Slice",
            "slice",
            "",
            "part",
            {"section", sectionChoices},
            "The shape of a cut across",
            hasPicture,
            nullptr,
            setSection},
    Command{"set-caps",
            "Ends",
            "cylinder",
            "",
            "part",
            {"both", capChoices},
            "How the ends are finished",
            hasPicture,
            nullptr,
            setCaps},
    Command{"toggle-texture",
            "Picture on it",
            "image",
            "T",
            "part",
            {},
            "The picture on the part, or a plain colour",
            hasPicture,
            textured,
            toggleTexture},
    Command{"set-colour",
            "Colour",
            "palette",
            "",
            "part",
            {"colour", colourChoices},
            "A plain colour",
            hasPicture,
            nullptr,
            setColour},
    Command{"rename-part",
            "Rename",
            "pencil-line",
            "F2",
            "part",
            {},
            "Give the part a name",
            hasSelection,
            nullptr,
            renamePart},
    Command{"show-part",
            "Show or hide",
            "eye",
            "",
            "part",
            {},
            "Show or hide the part",
            hasSelection,
            nullptr,
            showPart},
    Command{"set-height",
            "How tall?",
            "ruler",
            "",
            "file",
            {},
            "Height of the finished model",
            hasParts,
            nullptr,
            setHeight},
    Command{"set-parameter",
            "Detail",
            "sliders-horizontal",
            "",
            "part",
            {"value"},
            "A number of the recipe",
            hasParts,
            nullptr,
            setParameter},
    Command{"draw-spine",
            "Draw a line by numbers",
            "spline",
            "",
            "part",
            {"stroke"},
            "A stroke in picture pixels",
            hasPicture,
            nullptr,
            drawSpine},
    Command{"redraw-spine",
            "Replace a line by numbers",
            "spline",
            "",
            "part",
            {"stroke"},
            "A stroke in picture pixels",
            hasParts,
            nullptr,
            redrawSpine},
    Command{"home-view",
            "Home view",
            "house",
            "H",
            "view",
            {},
            "See the whole model from the front",
            nullptr,
            nullptr,
            homeView},
    Command{"fit",
            "Fit",
            "maximize",
            "F",
            "view",
            {},
            "Make everything fit the view",
            hasPicture,
            nullptr,
            fitView},
    Command{
        "zoom-in", "Zoom in", "zoom-in", "+, =", "view", {}, "Nearer", hasPicture, nullptr, zoomIn},
    Command{"zoom-out",
            "Zoom out",
            "zoom-out",
            "-, _",
            "view",
            {},
            "Farther",
            hasPicture,
            nullptr,
            zoomOut},
    Command{"turn-left",
            "Turn left",
            "box",
            "ArrowLeft",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            turnLeft},
    Command{"turn-right",
            "Turn right",
            "box",
            "ArrowRight",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            turnRight},
    Command{"turn-up",
            "Turn up",
            "box",
            "ArrowUp",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            turnUp},
    Command{"turn-down",
            "Turn down",
            "box",
            "ArrowDown",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            turnDown},
    Command{"focus-picture",
            "Picture view",
            "image",
            "3",
            "view",
            {},
            "Keys go to the picture",
            hasPicture,
            focusOnPicture,
            focusPicture},
    Command{"focus-solid",
            "Solid view",
            "box",
            "4",
            "view",
            {},
            "Keys go to the solid",
            hasPicture,
            focusOnSolid,
            focusSolid},
    Command{"next-picture",
            "Next picture",
            "layers",
            "",
            "file",
            {},
            "Show the next picture",
            hasPictures,
            nullptr,
            nextPicture},
    Command{"save-glb",
            "Save GLB",
            "download",
            "Ctrl+S",
            "file",
            {},
            "3D model with colours, for most programs",
            hasParts,
            nullptr,
            saveGlb},
    Command{"save-obj",
            "Save OBJ",
            "download",
            "",
            "file",
            {},
            "Plain 3D model, for editing",
            hasParts,
            nullptr,
            saveObj},
    Command{"save-stl",
            "Save STL",
            "download",
            "",
            "file",
            {},
            "For a 3D printer, in millimetres",
            hasParts,
            nullptr,
            saveStl},
    Command{"remove-picture",
            "Remove picture",
            "image-off",
            "",
            "file",
            {},
            "Takes the picture and its parts away",
            hasPicture,
            nullptr,
            removePicture},
    Command{"clear",
            "Start over",
            "refresh-cw",
            "",
            "file",
            {},
            "An empty board",
            hasAnything,
            nullptr,
            clearBoard},
    Command{"cancel",
            "Cancel",
            "x",
            "Escape",
            "edit",
            {},
            "Stop what is going on",
            nullptr,
            nullptr,
            cancel},
};

bool sameKey(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

bool matchesOne(std::string_view shortcut, const platform::KeyEvent& event) {
  bool control = false, shift = false;
  for (bool more = true; more;) {
    more = false;
    if (shortcut.starts_with("Ctrl+")) {
      control = more = true;
      shortcut.remove_prefix(5);
    } else if (shortcut.starts_with("Shift+")) {
      shift = more = true;
      shortcut.remove_prefix(6);
    }
  }
  const bool hasControl = (event.modifiers & (platform::kControl | platform::kMeta)) != 0;
  const bool hasShift = (event.modifiers & platform::kShift) != 0;
  if ((event.modifiers & platform::kAlt) != 0 || control != hasControl) return false;
  // A sign such as "+" may need the shift key on some keyboards and not on others.
  const bool sign = shortcut.size() == 1 && std::ispunct(static_cast<unsigned char>(shortcut[0]));
  return !shortcut.empty() && sameKey(shortcut, event.key) && (sign || shift == hasShift);
}

bool matches(std::string_view shortcuts, const platform::KeyEvent& event) {
  while (!shortcuts.empty()) {
    const std::size_t end = shortcuts.find(", ");
    if (matchesOne(shortcuts.substr(0, end), event)) return true;
    shortcuts.remove_prefix(end == std::string_view::npos ? shortcuts.size() : end + 2);
  }
  return false;
}

}  // namespace

std::span<const Command> commandTable() { return kTable; }

const Command* findCommand(std::string_view id) {
  const auto at = std::ranges::find(kTable, id, &Command::id);
  return at == kTable.end() ? nullptr : &*at;
}

bool enabled(const Command& command, const CommandEnv& env) {
  return command.enabled == nullptr || command.enabled(env);
}

Outcome runCommand(const CommandEnv& env, std::string_view id, const Json& args) {
  const Command* command = findCommand(id);
  if (command == nullptr) {
    return Refusal{"NoSuchCommand", "There is no command called " + std::string(id) + "."};
  }
  if (!enabled(*command, env)) {
    // Commands about a part may name one that is not selected.
    const bool namesPart = partOf(env, args) != nullptr;
    if (!namesPart || command->enabled != hasSelection) {
      return Refusal{"NotNow", std::string(command->label) + " is not possible right now."};
    }
  }
  return command->run(env, args);
}

const Command* commandForKey(const platform::KeyEvent& event) {
  for (const Command& command : kTable) {
    if (!command.shortcut.empty() && matches(command.shortcut, event)) return &command;
  }
  return nullptr;
}

namespace {

void writeArgument(const CommandEnv& env, const Argument& argument, JsonWriter& json) {
  json.key("argument").beginObject().key("key").text(argument.key);
  if (argument.choices == nullptr) {
    json.key("kind").text("api");
  } else {
    json.key("choices").beginArray();
    argument.choices(env, json);
    json.endArray();
  }
  json.endObject();
}

}  // namespace

void writeCommands(const CommandEnv& env, JsonWriter& json) {
  json.beginArray();
  for (const Command& command : kTable) {
    json.beginObject();
    json.key("id").text(command.id).key("label").text(command.label);
    json.key("icon").text(command.icon).key("shortcut").text(command.shortcut);
    json.key("enabled").flag(enabled(command, env)).key("group").text(command.group);
    json.key("toggled");
    command.toggled ? json.flag(command.toggled(env)) : json.null();
    if (!command.argument.key.empty()) writeArgument(env, command.argument, json);
    json.key("hint").text(command.hint).endObject();
  }
  json.endArray();
}

Outcome refuse(const Failure& failure) {
  return Refusal{std::string(errorName(failure.error)), failureSentence(failure)};
}

Outcome outcomeOf(const Status& status) {
  if (status) return {};
  return refuse(status.failure());
}

}  // namespace spineloft::app
