// The actions about line drawings. Internal to document/.
#pragma once

#include "engine/base/result.h"
#include "engine/document/action.h"

namespace spineloft::document {

/// Each applies its action to the document, which may be left half changed when it fails. Errors: NoSuchPicture,
/// NoSuchLine, NoSuchPart, NotAPiece, ValueOutOfRange, those of checkLine.
Status applyDrawing(Document& document, const DrawLine& action);
Status applyDrawing(Document& document, const CloseLine& action);
Status applyDrawing(Document& document, const HideLine& action);
Status applyDrawing(Document& document, const DeleteLine& action);
Status applyDrawing(Document& document, const OrderPieces& action);
Status applyDrawing(Document& document, const SeeDrawing& action);
Status applyDrawing(Document& document, const PinDepth& action);
Status applyDrawing(Document& document, const ShapePiece& action);

/// What `update` does after every action: lines that belonged to pieces that are none any more go with them, and so do
/// orders of such pieces, and drawings without a line.
void settleDrawings(const Document& before, Document& document);

/// The pieces among `copies`, which are new parts, become pieces of new drawings: those that were of one drawing are of
/// one again, with their lines and what is known of them. `originals`: the part that each is a copy of.
/// Error: ValueOutOfRange.
Status copyDrawings(Document& document, const std::vector<std::pair<PartId, PartId>>& originals);

}  // namespace spineloft::document
