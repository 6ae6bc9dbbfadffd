// All planes of a stack as one run that stands several times along the rail (cross-sections-hughes 6.1).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/stack/stack_params.h"

namespace spineloft::stack {

/// How often all planes stand there: the times of the one pattern that repeats them all, 1 without a pattern, 0 where
/// patterns repeat only some.
std::uint32_t timesOf(const std::vector<Plane>& planes, const std::vector<Pattern>& patterns);

/// Whether they can stand there several times: at least two planes, all on the rail at rising places, and no pattern of
/// only some.
bool canRepeat(const std::vector<Plane>& planes, const Rail& rail, const std::vector<Pattern>& patterns);

/// What a run changes.
struct Run {
  std::vector<Plane>& planes;
  Rail& rail;
  std::vector<Pattern>& patterns;
};

/// Lets all planes stand `times` times (1…kMostTimes), as far from one run to the next as, on average, from plane to
/// plane. A straight rail ends with the last plane then and planes stay where they are; on other rails the runs fill
/// the rail from the first plane on, a closed one all round. Expects canRepeat.
void repeatAll(const Run& run, std::uint32_t times);

}  // namespace spineloft::stack
