// Bridges between parts as the API tells them.
#pragma once

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/edit/command_env.h"
#include "web/model/json.h"

namespace spineloft::app {

/// The parts that it joins, and where; null for what is no bridge.
void writeBridge(JsonWriter& json, const document::Part& part, const pipeline::DerivedPart& derived);
/// Where the ends of the bridge in hand are held.
void writeBridgeKnobs(JsonWriter& json, const CommandEnv& env);

}  // namespace spineloft::app
