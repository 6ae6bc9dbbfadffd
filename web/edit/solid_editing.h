// Solids made of parts, as the page shows them: what is ticked, how thick a wall is in millimetres, what is the
// matter with one.
#pragma once

#include <string>
#include <vector>

#include "engine/document/document.h"
#include "web/edit/command_env.h"
#include "web/model/json.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// Lets go of what undo may have taken away.
void settleSolids(const document::Document& document, UiState& ui);
/// Parts and solids that stand for themselves, in the order of the list.
std::vector<document::Operand> rootsOf(const document::Document& document);
/// Whether there are at least two of them; asks for no memory.
bool hasSeveralRoots(const document::Document& document);
bool isPicked(const UiState& ui, document::Operand operand);
/// Millimetres of the finished model a unit of the world; 0 without anything to see.
double millimetresPerUnit(const CommandEnv& env);
/// "Waiting …", "The wall is too thick …", or empty when all is well.
std::string stepFailureWords(const CommandEnv& env, const document::Step& step);
/// Whether something can be shown of what is the matter: a place, or the part at fault.
bool hasPlace(const CommandEnv& env, const document::Step& step);
/// The chosen solid, or null.
const document::Step* chosenStep(const CommandEnv& env);
/// `steps` and what is ticked, for the state of the page.
void writeSolids(JsonWriter& json, const CommandEnv& env);

}  // namespace spineloft::app
