// Ids from 1 on.
#pragma once

#include "engine/document/document.h"

namespace spineloft::document {

/// Gives pictures, parts, steps and groups the ids 1, 2, … in the order of their lists, and whatever names one of them
/// its new id; what names none of them names nothing afterwards. The last ids are as many as there are.
void renumber(Document& document);

}  // namespace spineloft::document
