// The planes of a stack with its patterns written out. Internal to stack/.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/stack/stack_params.h"

namespace spineloft::stack {

/// One of the planes, or a copy of it.
struct Standing {
  std::size_t number = 0;  ///< which of the planes
  std::size_t copy = 0;    ///< which time of its pattern, from 0; 0: as drawn
  double at = 0;           ///< share of the rail
};

/// All planes in the order in which they stand. Patterns are valid (checkPatterns).
std::vector<Standing> writtenOut(const std::vector<Plane>& planes, const std::vector<Pattern>& patterns);

/// As a person counts: "sheet 2", "sheet 2 in repeat 3".
std::string nameOf(const Standing& plane);

}  // namespace spineloft::stack
