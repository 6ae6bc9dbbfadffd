// How parts come and go. Internal to document/.
#pragma once

#include "engine/document/document.h"

namespace spineloft::document {

/// A new part at the end of the list, with the next id and a name of its own.
void addPart(Document& document, Recipe recipe, const Look& look);
/// A part goes, out of every step too, and with it the bridges that stand on it.
void erasePart(Document& document, PartId id);
/// What lies on parts that were moved as a whole in their picture goes along: pulls, and the rims of bridges.
void carryLines(const Document& before, Document& after);
/// Error: ValueOutOfRange.
Status roomForPart(const Document& document);

}  // namespace spineloft::document
