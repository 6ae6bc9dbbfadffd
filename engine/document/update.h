// The one door through which a document changes.
#pragma once

#include "engine/base/result.h"
#include "engine/document/action.h"
#include "engine/document/document.h"

namespace spineloft::document {

/// The document after `action`; the given one is untouched. Pure. Names longer than kMaxNameBytes are
/// cut between characters; empty names become "Part N" or "Model".
/// Errors: NoSuchPart, NoSuchPicture, PictureEmpty (AddPicture without pixels), ValueOutOfRange
/// (parameter, height, preset, cap), and those of ribs::cleanSpine for strokes and of checkRegion
/// for regions; NotABone, NotARegion and NotAStack for actions on parts of another kind.
Result<Document> update(const Document& document, const Action& action);

}  // namespace spineloft::document
