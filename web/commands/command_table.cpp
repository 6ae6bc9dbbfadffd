// The rows of the command table that are about the board, parts and views. Other features bring their
// own rows (see command_groups.h).
#include <array>

#include "web/commands/command_actions.h"
#include "web/commands/command_groups.h"
#include "web/edit/section_editing.h"
#include "web/model/swatches.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasParts(Env env) { return !env.studio.document().parts.empty(); }
bool hasAnything(Env env) { return hasPicture(env) || hasParts(env); }
bool canUndo(Env env) {
  if (env.ui.cut) return canUndoMark(env);
  return env.ui.sections.board ? canUndoOnBoard(env) : env.studio.undoSteps() > 0;
}
bool canRedo(Env env) {
  if (env.ui.cut) return canRedoMark(env);
  return env.ui.sections.board ? canRedoOnBoard(env) : env.studio.redoSteps() > 0;
}

bool drawing(Env env) { return env.ui.tool == ToolKind::Draw; }
bool hand(Env env) { return env.ui.tool == ToolKind::Hand; }
bool redrawing(Env env) { return static_cast<bool>(env.ui.redraw); }
bool textured(Env env) { return currentLook(env).textured; }
bool focusOnPicture(Env env) { return env.ui.focus == Focus::Picture; }
bool focusOnSolid(Env env) { return env.ui.focus == Focus::Solid; }

Outcome undo(Env env, const Json&) {
  if (env.ui.cut) return outcomeOf(undoMark(env));
  return outcomeOf(env.ui.sections.board ? undoOnBoard(env) : env.studio.undo());
}
Outcome redo(Env env, const Json&) {
  if (env.ui.cut) return outcomeOf(redoMark(env));
  return outcomeOf(env.ui.sections.board ? redoOnBoard(env) : env.studio.redo());
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
Outcome cancel(Env env, const Json&) {
  if (env.ui.sections.board) {
    closeBoard(env.ui);
  } else if (env.ui.cut) {
    closeCut(env);
  } else if (env.ui.sections.placing) {
    env.ui.sections.placing = false;
  } else if (env.ui.pictureMenu || env.ui.sketching.menu != PenMenu::None) {
    env.ui.pictureMenu = {};
    env.ui.sketching.menu = PenMenu::None;
  } else if (env.ui.solids.pointing) {
    env.ui.solids.pointing = false;
  } else if (env.ui.preview) {
    env.ui.preview.reset();
  } else if (env.ui.redraw) {
    env.ui.redraw = {};
  } else if (env.studio.activity()) {
    env.studio.cancelWork();
  } else if (env.ui.chosen != Chosen{}) {
    env.ui.chosen = {};
  } else if (env.ui.tool != ToolKind::Draw && env.ui.tool != ToolKind::Hand) {
    env.ui.tool = ToolKind::Draw;
  } else {
    env.ui.selection = {};
  }
  return {};
}

void partChoices(Env env, JsonWriter& json) {
  for (const document::Part& part : env.studio.document().parts) {
    json.beginObject().key("value").number(part.id.value).key("label").text(part.name);
    json.key("toggled").flag(part.id == env.ui.selection).endObject();
  }
}

void sectionChoices(Env env, JsonWriter& json) {
  const loft::SectionShape& chosen = pickedShape(env.ui, partOf(env, Json()));
  for (const loft::SectionName& name : loft::sectionNames()) {
    writeChoice(json, name.key, name.label, !chosen.drawn() && name.preset == chosen.preset);
  }
}

void capChoices(Env env, JsonWriter& json) {
  const document::Part* part = partOf(env, Json());
  const loft::CapStyle start = part ? document::loftIn(*part).loft.startCap : env.ui.startCap;
  const loft::CapStyle end = part ? document::loftIn(*part).loft.endCap : env.ui.endCap;
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
            rows::openPicture},
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
    Command{"hand", "Move picture", "hand", "2", "tool", {}, "Drag the picture about", hasPicture, hand, useHand},
    Command{"new-part",
            "New part",
            "plus",
            "N",
            "part",
            {},
            "The next line makes a new part",
            hasPicture,
            nullptr,
            rows::newPart},
    Command{"redraw",
            "Draw again",
            "pencil-line",
            "R",
            "part",
            {},
            "The next line replaces the one of this part",
            hasSelection,
            redrawing,
            rows::redrawMode},
    Command{"undo", "Undo", "undo-2", "Ctrl+Z", "edit", {}, "Take back the last step", canUndo, nullptr, undo},
    Command{
        "redo", "Redo", "redo-2", "Shift+Ctrl+Z, Ctrl+Y", "edit", {}, "Do it again after all", canRedo, nullptr, redo},
    Command{"delete-part",
            "Delete part",
            "trash-2",
            "Delete, Backspace",
            "edit",
            {},
            "Delete this part",
            hasSelection,
            nullptr,
            rows::deletePart},
    Command{"select-part",
            "Select part",
            "list",
            "",
            "part",
            {"id", partChoices},
            "Choose a part of the list",
            hasParts,
            nullptr,
            rows::selectPart},
    Command{"next-part",
            "Next part",
            "chevron-right",
            "P",
            "part",
            {},
            "Choose the next part",
            hasParts,
            nullptr,
            rows::nextPart},
    Command{"set-section",
            "Slice",
            "slice",
            "",
            "part",
            {"section", sectionChoices},
            "The shape of a cut across",
            hasPicture,
            nullptr,
            rows::setSection},
    Command{"set-caps",
            "Ends",
            "cylinder",
            "",
            "part",
            {"both", capChoices},
            "How the ends are finished",
            hasPicture,
            nullptr,
            rows::setCaps},
    Command{"toggle-texture",
            "Picture on it",
            "image",
            "T",
            "part",
            {},
            "The picture on the part, or a plain colour",
            hasPicture,
            textured,
            rows::toggleTexture},
    Command{"set-colour",
            "Colour",
            "palette",
            "",
            "part",
            {"colour", colourChoices},
            "A plain colour",
            hasPicture,
            nullptr,
            rows::setColour},
    Command{"rename-part",
            "Rename",
            "pencil-line",
            "F2",
            "part",
            {},
            "Give the part a name",
            hasSelection,
            nullptr,
            rows::renamePart},
    Command{"show-part",
            "Show or hide",
            "eye",
            "",
            "part",
            {},
            "Show or hide the part, or the solid that it is in",
            hasSelection,
            nullptr,
            rows::showPart},
    Command{"set-parameter",
            "Detail",
            "sliders-horizontal",
            "",
            "part",
            {"value"},
            "A number of the recipe",
            hasParts,
            nullptr,
            rows::setParameter},
    Command{"draw-spine",
            "Draw a line by numbers",
            "spline",
            "",
            "part",
            {"stroke"},
            "A stroke in picture pixels",
            hasPicture,
            nullptr,
            rows::drawSpine},
    Command{"redraw-spine",
            "Replace a line by numbers",
            "spline",
            "",
            "part",
            {"stroke"},
            "A stroke in picture pixels",
            hasParts,
            nullptr,
            rows::redrawSpine},
    Command{"home-view",
            "Home view",
            "house",
            "H",
            "view",
            {},
            "See the whole model from the front",
            nullptr,
            nullptr,
            rows::homeView},
    Command{
        "fit", "Fit", "maximize", "F", "view", {}, "Make everything fit the view", hasPicture, nullptr, rows::fitView},
    Command{"zoom-in", "Zoom in", "zoom-in", "+, =", "view", {}, "Nearer", hasPicture, nullptr, rows::zoomIn},
    Command{"zoom-out", "Zoom out", "zoom-out", "-, _", "view", {}, "Farther", hasPicture, nullptr, rows::zoomOut},
    Command{"turn-left",
            "Turn left",
            "box",
            "ArrowLeft",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            rows::turnLeft},
    Command{"turn-right",
            "Turn right",
            "box",
            "ArrowRight",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            rows::turnRight},
    Command{"turn-up",
            "Turn up",
            "box",
            "ArrowUp",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            rows::turnUp},
    Command{"turn-down",
            "Turn down",
            "box",
            "ArrowDown",
            "view",
            {},
            "Turn the solid, or move the picture when its view is chosen",
            hasPicture,
            nullptr,
            rows::turnDown},
    Command{"focus-picture",
            "Picture view",
            "image",
            "3",
            "view",
            {},
            "Keys go to the picture",
            hasPicture,
            focusOnPicture,
            rows::focusPicture},
    Command{"focus-solid",
            "Solid view",
            "box",
            "4",
            "view",
            {},
            "Keys go to the solid",
            hasPicture,
            focusOnSolid,
            rows::focusSolid},
    Command{"save-glb",
            "Save GLB",
            "download",
            "",
            "file",
            {},
            "3D model with colours, for most programs",
            hasParts,
            nullptr,
            rows::saveGlb},
    Command{"save-stl",
            "Save STL",
            "download",
            "",
            "file",
            {},
            "For a 3D printer, in millimetres",
            hasParts,
            nullptr,
            rows::saveStl},
    Command{
        "clear", "Start over", "refresh-cw", "", "file", {}, "An empty board", hasAnything, nullptr, rows::clearBoard},
    Command{"cancel", "Cancel", "x", "Escape", "edit", {}, "Stop what is going on", nullptr, nullptr, cancel},
};

}  // namespace

bool partIsSelected(const CommandEnv& env) { return partOf(env, Json()) != nullptr; }
bool spineIsSelected(const CommandEnv& env) { return loftPartOf(env, Json()) != nullptr; }

std::span<const Command> generalCommands() { return kTable; }

}  // namespace spineloft::app
