// Pulls as the API tells them.
#pragma once

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/edit/command_env.h"
#include "web/model/json.h"

namespace spineloft::app {

/// Of a part: members of an object. `share`: of the way that the part could go without going through itself.
void writePulls(JsonWriter& json, const document::Part& part, const pipeline::DerivedPart& derived);
/// Those of the part in hand, CSS pixels of the canvas.
void writePullKnobs(JsonWriter& json, const CommandEnv& env);

}  // namespace spineloft::app
