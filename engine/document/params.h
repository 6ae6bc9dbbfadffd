// The parameter tables, one a kind of recipe: they feed sliders, files, validation and test generators. The curves of a
// loft by their kind.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "engine/document/action.h"
#include "engine/document/document.h"

namespace spineloft::document {

/// What a number is shown as.
enum class Measure : std::uint8_t {
  Plain,    ///< as it is
  Percent,  ///< a share: 1 is 100 %
  Length,   ///< a share of the longer side of a picture: a length of the model
};

struct ParamInfo {
  std::string_view key;    ///< in files and in the API
  std::string_view label;  ///< on the page
  std::string_view unit;   ///< "", "px", "ribs" …
  double low = 0, high = 0, step = 0;
  Measure measure = Measure::Plain;
  bool forFew = false;                       ///< it changes how finely a part is made, not what it is
  bool (*applies)(const Recipe&) = nullptr;  ///< whether it changes such a recipe; null: always
  /// Expect a recipe of the table's kind.
  double (*get)(const Recipe&) = nullptr;
  /// Expects a value within the range, on a whole step.
  void (*set)(Recipe&, double) = nullptr;
};

/// In a fixed order; keys are unique in a table; the default is `get(emptyRecipe(kind))`.
std::span<const ParamInfo> paramTable(PartKind kind);
/// The entry with this key, or null.
const ParamInfo* findParam(PartKind kind, std::string_view key);

/// A curve of the loft by its kind.
geometry::AlongCurve& alongOf(loft::LoftParams& params, AlongKind kind);
const geometry::AlongCurve& alongOf(const loft::LoftParams& params, AlongKind kind);

}  // namespace spineloft::document
