// Solids made of parts, as the page shows them: what is ticked, how thick a wall is in millimetres, what is the
// matter with one.
#pragma once

#include <string>
#include <vector>

#include "engine/document/document.h"
#include "web/app/commands.h"
#include "web/app/json.h"
#include "web/app/ui_state.h"

namespace spineloft::app {

/// Lets go of what undo may have taken away.
void settleSolids(const document::Document& document, UiState& ui);
/// Parts and solids that stand for themselves, in the order of the list.
std::vector<document::Operand> rootsOf(const document::Document& document);
bool isPicked(const UiState& ui, document::Operand operand);
/// Millimetres of the finished model a unit of the world; 0 without anything to see.
double millimetresPerUnit(const CommandEnv& env);
/// A wall in words, rounded down to what still fits: "3.2 mm".
std::string spokenWall(double mm);
/// What the matter is with a solid that has a failure, with the part and the wall that would do.
std::string troubleSentence(const document::Document& document, const pipeline::Derived& derived,
                            const pipeline::DerivedStep& step);
/// What a file of the model holds where solids could not be made as they should be, a sentence or two each; empty when
/// all is well.
std::string faultsOf(const document::Document& document, const pipeline::Derived& derived);
/// "Waiting …", "The wall is too thick …", or empty when all is well.
std::string troubleOf(const CommandEnv& env, const document::Step& step);
/// Whether something can be shown of what is the matter: a place, or the part at fault.
bool hasPlace(const CommandEnv& env, const document::Step& step);
/// The chosen solid, or null.
const document::Step* chosenStep(const CommandEnv& env);
/// `steps` and what is ticked, for the state of the page.
void writeSolids(JsonWriter& json, const CommandEnv& env);

}  // namespace spineloft::app
