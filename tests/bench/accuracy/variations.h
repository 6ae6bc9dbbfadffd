// The ways of finding ribs that the benchmark's ablation compares.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "engine/ribs/base/rib_params.h"
#include "tests/bench/accuracy/trace_variant.h"

namespace spineloft::accuracy {

struct Variation {
  std::string_view key;    ///< on the command line: --variation KEY
  std::string_view title;  ///< what is different, for people
  ribs::RibParams params;
  TraceVariant variant;
};

/// All of them; the first is the product as it is.
std::span<const Variation> variations();
/// nullptr when there is none of that name.
const Variation* variationFromKey(std::string_view key);

/// Sets one number of the method: "learnedWeight=1". False where there is no such number.
bool setNumber(std::string_view keyAndValue, Variation& variation);

}  // namespace spineloft::accuracy
