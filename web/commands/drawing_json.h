// Line drawings as the API tells them.
#pragma once

#include "web/commands/commands.h"

namespace spineloft::app {

/// Members `drawings`, `bridges`, `lineEnds` and `depthDots` of the state; see State of web/shell/api.ts.
void writeDrawings(JsonWriter& json, const CommandEnv& env);

}  // namespace spineloft::app
