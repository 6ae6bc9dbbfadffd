#include "engine/document/params.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::document {
namespace {

int whole(double value) { return static_cast<int>(std::lround(value)); }

constexpr std::array kTable = {
    ParamInfo{"ribs", "Ribs", "ribs", 2, 400, 1,
              [](const LoftRecipe& r) { return static_cast<double>(r.spine.ribs); },
              [](LoftRecipe& r, double v) { r.spine.ribs = whole(v); }},
    ParamInfo{"smoothness", "Smoothing of the bone", "", 0, 0.2, 0.005,
              [](const LoftRecipe& r) { return r.spine.smoothness; },
              [](LoftRecipe& r, double v) { r.spine.smoothness = v; }},
    ParamInfo{"sides", "Corners around", "", 12, 128, 4,
              [](const LoftRecipe& r) { return static_cast<double>(r.loft.sectionPoints); },
              [](LoftRecipe& r, double v) { r.loft.sectionPoints = whole(v); }},
    ParamInfo{"cap-rings", "Rings of round ends", "", 1, 32, 1,
              [](const LoftRecipe& r) { return static_cast<double>(r.loft.capRings); },
              [](LoftRecipe& r, double v) { r.loft.capRings = whole(v); }},
};

}  // namespace

std::span<const ParamInfo> paramTable() { return kTable; }

const ParamInfo* findParam(std::string_view key) {
  const auto at = std::ranges::find(kTable, key, &ParamInfo::key);
  return at == kTable.end() ? nullptr : &*at;
}

}  // namespace spineloft::document
