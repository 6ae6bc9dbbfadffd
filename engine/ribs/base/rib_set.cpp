#include "engine/ribs/base/rib_set.h"

namespace spineloft::ribs {

std::string_view ribStateKey(RibState state) {
  switch (state) {
    case RibState::Edge:
      return "edge";
    case RibState::Bridged:
      return "bridged";
    case RibState::Guessed:
      return "guessed";
    case RibState::Edited:
      return "edited";
    case RibState::Locked:
      return "locked";
  }
  return {};
}

}  // namespace spineloft::ribs
