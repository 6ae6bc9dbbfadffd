#include "web/app/command_groups.h"

namespace spineloft::app {

std::span<const Command> sketchCommands() { return {}; }

}  // namespace spineloft::app
