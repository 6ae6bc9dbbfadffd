// What the commands do, by group; the table (commands.cpp) names them.
#pragma once

#include <functional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/geometry/region.h"
#include "web/commands/commands.h"

namespace spineloft::app {

/// Rows whose functions are not beside them.
namespace rows {
// Board and files.
Outcome openPicture(const CommandEnv& env, const Json& args);
Outcome clearBoard(const CommandEnv& env, const Json& args);
Outcome saveGlb(const CommandEnv& env, const Json& args);
Outcome saveStl(const CommandEnv& env, const Json& args);

// Parts.
Outcome drawSpine(const CommandEnv& env, const Json& args);
Outcome redrawSpine(const CommandEnv& env, const Json& args);
Outcome newPart(const CommandEnv& env, const Json& args);
Outcome redrawMode(const CommandEnv& env, const Json& args);
Outcome deletePart(const CommandEnv& env, const Json& args);
Outcome selectPart(const CommandEnv& env, const Json& args);
Outcome nextPart(const CommandEnv& env, const Json& args);
Outcome renamePart(const CommandEnv& env, const Json& args);
Outcome showPart(const CommandEnv& env, const Json& args);
Outcome setSection(const CommandEnv& env, const Json& args);
Outcome setCaps(const CommandEnv& env, const Json& args);
Outcome toggleTexture(const CommandEnv& env, const Json& args);
Outcome setColour(const CommandEnv& env, const Json& args);
Outcome setParameter(const CommandEnv& env, const Json& args);

// Views.
Outcome homeView(const CommandEnv& env, const Json& args);
Outcome fitView(const CommandEnv& env, const Json& args);
Outcome zoomIn(const CommandEnv& env, const Json& args);
Outcome zoomOut(const CommandEnv& env, const Json& args);
Outcome turnLeft(const CommandEnv& env, const Json& args);
Outcome turnRight(const CommandEnv& env, const Json& args);
Outcome turnUp(const CommandEnv& env, const Json& args);
Outcome turnDown(const CommandEnv& env, const Json& args);
Outcome focusPicture(const CommandEnv& env, const Json& args);
Outcome focusSolid(const CommandEnv& env, const Json& args);
}  // namespace rows

// Printing.
/// Checks the model as it is, and says what it found; when the solver had to be waited for.
Outcome reportPrint(const CommandEnv& env);

// Cutting out.
/// Leaves the thing that is being cut out; nothing without one.
void closeCut(const CommandEnv& env);
/// The same once its picture or its part is gone. With another tool, picture or board in hand what is shown becomes the
/// part, as by "Use this", when it is found; a part that was selected meanwhile stays selected. Waits while a gesture
/// is in hand.
void settleCut(const CommandEnv& env);

// Puffs.
/// Studio::act, and a hint where a ring of one of these parts becomes too thin to show.
Status actOnPuffs(const CommandEnv& env, const std::vector<PartId>& parts, std::span<const document::Action> actions,
                  std::string_view burst = {});

// Sections.
/// Closes the board when its part is gone. With another tool or part in hand what is drawn on it is used, as by "Done",
/// or left where it is no slice yet; a part that was selected meanwhile stays selected. Waits while a gesture is in
/// hand.
void settleBoard(const CommandEnv& env);
/// Puts a section on the shelf, unless it is there, and tells the browser. Refused when it is full.
Outcome keepOnShelf(const CommandEnv& env, const sections::SectionShape& shape, const std::string* name);
/// Hands the shelf to the shell, which keeps it.
void sendShelf(const CommandEnv& env);

// Layers.
/// The part has this recipe now, with the sheet at this place; without a part it is a new one.
Outcome keepLayers(const CommandEnv& env, PartId part, const document::StackRecipe& recipe, double at);

// Solids.
/// Makes a solid, chooses it and says what came of it.
Outcome makeSolid(const CommandEnv& env, const document::CombineParts& action);
/// `wall`, `opening` and `depth` as args say, over what is there. Why not, when they cannot be read.
Outcome readHollow(const CommandEnv& env, const Json& args, double& wall, document::Opening& opening);
/// The part or solid that stands alone and is, or holds, what `args.part` or `args.step` names. None: none is named.
std::optional<document::Operand> namedRoot(const CommandEnv& env, const Json& args);
/// The sides at which a hollow solid can be open, as choices of a menu.
void writeOpenings(JsonWriter& json, std::optional<document::OpeningSide> chosen);

// Shapes.
/// Why a recipe makes no shape, so that it is refused before it is kept.
Status checkMade(const CommandEnv& env, const document::ShapeRecipe& recipe);
/// Other measures, and outlines that go with them. Changes with the same `burst` one after the other are one step.
Outcome reshape(const CommandEnv& env, PartId part, const document::ShapeRecipe& recipe, std::string_view burst);
/// Lines in a side picture become the side outline of a loft or a puff; refused before it is kept where that is none.
Outcome setSide(const CommandEnv& env, PartId part, document::Outline drawn);
/// The thing with these outlines becomes a new shape, or the outline of `part`, in the picture in view.
Outcome shapeOfThing(const CommandEnv& env, PartId part, const geometry::Contours& contours);

/// The outlines in the picture of what is made of a region; so that what cannot be shown is refused before it is kept.
Result<geometry::Contours> outlinesFor(const CommandEnv& env, const document::Recipe& recipe);

/// How a new part comes to stand.
struct Standing {
  std::vector<document::Action> actions;  ///< one step
  PartId next;                            ///< the part
  std::optional<Lie> lie;                 ///< with what it was drawn over; none: nothing
};
/// `draw`, which makes one part of this recipe, and what lets it stand where it belongs: with the other parts of its
/// picture, or beside what is there (pipeline::standBeside). With `lie`, what others would hide comes to lie on them.
Standing standingActions(const CommandEnv& env, document::Action draw, const document::Recipe& recipe, bool lie);
/// The newest part is taken in hand and into view: says that it is made, and how many of its ends are guesses. It
/// stands so; for as long as it is new it can be told otherwise.
void takeMade(const CommandEnv& env, const Standing& standing);
/// The selected part is new, and was drawn over others.
bool partIsNew(const CommandEnv& env);
/// The parts of `args.parts`, the one of `args.part`, or all in hand with their groups. Empty when there is none, or
/// one is not there.
std::vector<PartId> partsFrom(const CommandEnv& env, const Json& args);
/// One action for each of `parts` that `action` gives one, as one step, and a sentence on how many where they are
/// several. Nothing to do is no step.
Outcome setOnAll(const CommandEnv& env, const std::vector<PartId>& parts,
                 const std::function<std::optional<document::Action>(const document::Part&)>& action);
/// The part that `args.part` (or `args.id`) names, else the selected one; null when there is none.
const document::Part* partOf(const CommandEnv& env, const Json& args);
/// The lofted part that `args` name, else the selected one; null when there is none.
const document::Part* loftPartOf(const CommandEnv& env, const Json& args);

// What commands need. A part is selected; it is a loft (has a spine, ribs and sections); one of its ribs is chosen; it
// stands in a pose; it is made of a region; it is in a group. More than one part is in hand. A solid is chosen;
// there is something to scoop out.
bool partIsSelected(const CommandEnv& env);
bool spineIsSelected(const CommandEnv& env);
bool ribIsChosen(const CommandEnv& env);
bool poseIsSelected(const CommandEnv& env);
bool regionIsSelected(const CommandEnv& env);
bool groupIsSelected(const CommandEnv& env);
bool severalInHand(const CommandEnv& env);
bool stepIsChosen(const CommandEnv& env);
bool somethingToHollow(const CommandEnv& env);
inline constexpr Condition hasSelection{partIsSelected, Condition::Part};
inline constexpr Condition hasSpine{spineIsSelected, Condition::Part, Error::NotABone};
inline constexpr Condition hasChosenRib{ribIsChosen, Condition::Part};
inline constexpr Condition isPosed{poseIsSelected, Condition::Part};
inline constexpr Condition hasRegion{regionIsSelected, Condition::Part};
inline constexpr Condition groupSelected{groupIsSelected, Condition::Part | Condition::Group};
inline constexpr Condition severalSelected{severalInHand, Condition::Parts};
inline constexpr Condition hasStep{stepIsChosen, Condition::Step};
inline constexpr Condition canHollow{somethingToHollow, Condition::Part | Condition::Step};

/// Saves the model in this form, as a download.
Outcome saveAs(const CommandEnv& env, publish::Format format);
/// Changes the looks of the parts, and that of the next part: none means only that one.
Outcome changeLooks(const CommandEnv& env, const std::vector<PartId>& parts,
                    const std::function<void(document::Look&)>& change);
/// The look of the part, or of the next part.
document::Look lookOf(const CommandEnv& env, PartId part);
/// As partsFrom, for a setting: empty without a selection, which means the next part. None: one that is named is not
/// there.
std::optional<std::vector<PartId>> meantParts(const CommandEnv& env, const Json& args);
/// The look of the selected one of `parts`, else of the first; of the next part without one.
document::Look lookMeant(const CommandEnv& env, const std::vector<PartId>& parts);
/// The look of the selected part, or of the next part when none is selected.
document::Look currentLook(const CommandEnv& env);
/// The camera goes there, at once where the visitor wants less motion.
void fly(const CommandEnv& env, const Camera& to);
/// Turns the camera so that it sees every part, from home or from where it looks.
void flyTo(const CommandEnv& env, bool home);

/// Says so where the solid of parts that were stuck together is there and in several pieces.
void tellLoosePieces(const CommandEnv& env, StepId step);

}  // namespace spineloft::app
