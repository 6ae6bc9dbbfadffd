// The page's state as the contract's `spl_state` gives it.
#pragma once

#include "web/commands/commands.h"
#include "web/model/json.h"

namespace spineloft::app {

/// `frames`: how many were drawn so far.
void writeState(const CommandEnv& env, std::uint64_t frames, JsonWriter& json);

/// Tells the shell what the panels show: {type: 'controls', controls}, as Control of web/shell/api.ts.
void sendControls(platform::Host& host, const std::vector<Control>& controls);

}  // namespace spineloft::app
