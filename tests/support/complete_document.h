// Small documents in which every field differs from its default.
#pragma once

#include "engine/document/document.h"

namespace spineloft::testing {

/// Two photos' worth of everything version 1 knows, 3 parts, unknown keys. Never changed: a golden file
/// is compared with it for ever.
document::Document documentOfVersion1();

/// That, and every key that documents got since. When a version is released it is frozen into a golden
/// file and a function of its own.
document::Document completeDocument();

}  // namespace spineloft::testing
