// What a command may read and change.
#pragma once

#include "web/model/studio.h"
#include "web/platform/host.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

struct CommandEnv {
  Studio& studio;
  UiState& ui;
  platform::Host& host;
};

}  // namespace spineloft::app
