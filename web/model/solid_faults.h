// What is the matter with solids that could not be made, in words.
#pragma once

#include <string>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"

namespace spineloft::app {

/// Millimetres of the finished model a unit of the world; 0 without anything to see.
double millimetresPerUnit(const document::Document& document, const pipeline::Derived& derived);
/// A wall in words, rounded down to what still fits: "3.2 mm".
std::string spokenWall(double mm);
/// What the matter is with a solid that has a failure, with the part and the wall that would do.
std::string solidFailureSentence(const document::Document& document, const pipeline::Derived& derived,
                                 const pipeline::DerivedStep& step);
/// What a file of the model holds where solids could not be made as they should be, a sentence or two each; empty when
/// all is well.
std::string faultsOf(const document::Document& document, const pipeline::Derived& derived);
/// Why the step failed, or that it was stopped and what goes on with it. `step` has a failure.
std::string spokenFailure(const document::Document& document, const pipeline::Derived& derived,
                          const pipeline::DerivedStep& step);

}  // namespace spineloft::app
