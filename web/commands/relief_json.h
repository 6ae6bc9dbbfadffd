// Reliefs as the API tells them.
#pragma once

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/model/json.h"

namespace spineloft::app {

/// Member `relief` of a part; see State of web/shell/api.ts.
void writeRelief(JsonWriter& json, const document::Part& part, const pipeline::DerivedPart& derived);

}  // namespace spineloft::app
