// What a step of the history did, in words.
#pragma once

#include <string>

#include "engine/document/document.h"

namespace spineloft::app {

/// What differs between a document and the next one, with what it is about, in the visitor's language:
/// "Colour (Part 2)", "Place (3 parts)". What matters most where several things differ; empty: they are equal.
std::string whatChanged(const document::Document& before, const document::Document& after);

}  // namespace spineloft::app
