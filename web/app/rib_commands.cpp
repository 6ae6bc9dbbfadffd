#include "web/app/command_groups.h"

namespace spineloft::app {

std::span<const Command> ribCommands() { return {}; }

}  // namespace spineloft::app
