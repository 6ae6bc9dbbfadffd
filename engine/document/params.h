// The one parameter table of a loft recipe: it feeds sliders, files, validation and test generators.
#pragma once

#include <span>
#include <string_view>

#include "engine/document/document.h"

namespace spineloft::document {

struct ParamInfo {
  std::string_view key;    ///< in files and in the API
  std::string_view label;  ///< on the page
  std::string_view unit;   ///< "", "px", "ribs" …
  double low = 0, high = 0, step = 0;
  double (*get)(const LoftRecipe&) = nullptr;
  /// Expects a value within the range, on a whole step.
  void (*set)(LoftRecipe&, double) = nullptr;
};

/// In a fixed order; keys are unique; the default is `get(LoftRecipe{})`.
std::span<const ParamInfo> paramTable();
/// The entry with this key, or null.
const ParamInfo* findParam(std::string_view key);

}  // namespace spineloft::document
