#include "web/app/command_groups.h"

namespace spineloft::app {

std::span<const Command> boneCommands() { return {}; }

}  // namespace spineloft::app
