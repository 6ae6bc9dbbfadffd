// The sheet of the tool Layers as the API tells it.
#pragma once

#include "web/commands/commands.h"

namespace spineloft::app {

/// Member `sheet` of the state; see State of web/shell/api.ts.
void writeSheet(JsonWriter& json, const CommandEnv& env);

}  // namespace spineloft::app
