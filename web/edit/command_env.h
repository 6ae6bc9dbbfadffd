// What a command may read and change.
#pragma once

#include "web/model/studio.h"
#include "web/platform/host.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// What a finger, pen or mouse holds.
struct Hand {
  virtual bool holds() const = 0;
  /// It goes back to where it came from, without a trace.
  virtual void drop() = 0;

 protected:
  ~Hand() = default;
};

struct CommandEnv {
  Studio& studio;
  UiState& ui;
  platform::Host& host;
  Hand* hand = nullptr;  ///< null: nothing is ever held
};

}  // namespace spineloft::app
