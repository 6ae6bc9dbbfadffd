#include "web/app/command_groups.h"

namespace spineloft::app {

std::span<const Command> sliceCommands() { return {}; }

}  // namespace spineloft::app
