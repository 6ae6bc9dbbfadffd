// A small document in which every field differs from its default: what the golden files hold.
#pragma once

#include "engine/document/document.h"

namespace spineloft::testing {

/// Two photos' worth of everything version 1 knows, 3 parts, unknown keys. Never changed: a golden file
/// is compared with it for ever.
document::Document completeDocument();

}  // namespace spineloft::testing
