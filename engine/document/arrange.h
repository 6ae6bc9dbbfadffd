// How parts stand to one another: places, copies, groups and the order of the list. Parts of `update`.
#pragma once

#include "engine/base/result.h"
#include "engine/document/action.h"
#include "engine/document/document.h"

namespace spineloft::document {

/// Each changes the document as its action says, or leaves it in any state and says why it cannot.
/// Errors: NoSuchPart (also a list without parts), ValueOutOfRange (a placement, a plane, a part named
/// twice, a group that is not there, too many parts).
Status arrange(Document& document, const PlaceParts& action);
Status arrange(Document& document, const DuplicateParts& action);
Status arrange(Document& document, const GroupParts& action);
Status arrange(Document& document, const Ungroup& action);
Status arrange(Document& document, const RenameGroup& action);
Status arrange(Document& document, const MoveInList& action);

/// Groups whose last part is gone go as well; what `update` does after every action.
void dropEmptyGroups(Document& document);

}  // namespace spineloft::document
