// The actions about steps. Internal to document/.
#pragma once

#include "engine/base/result.h"
#include "engine/document/action.h"

namespace spineloft::document {

/// Each applies its action to the document, which may be left half changed when it fails. Errors:
/// NoSuchStep, NoSuchPart, AlreadyUsed, ValueOutOfRange.
Status applyStep(Document& document, const CombineParts& action);
Status applyStep(Document& document, const SetStep& action);
Status applyStep(Document& document, const OrderOperands& action);
Status applyStep(Document& document, const ReleaseStep& action);
Status applyStep(Document& document, const DeleteStep& action);
Status applyStep(Document& document, const RenameStep& action);
Status applyStep(Document& document, const ShowStep& action);
Status applyStep(Document& document, const SetStepLook& action);

}  // namespace spineloft::document
