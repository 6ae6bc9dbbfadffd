#include "web/app/command_groups.h"

namespace spineloft::app {

std::span<const Command> keepCommands() { return {}; }

}  // namespace spineloft::app
