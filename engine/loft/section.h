// Cross-sections: closed curves in [−1, 1]² (x across the rib, y towards the viewer).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace spineloft::loft {

/// The presets of the section shelf, in its order. Values are saved in files: only ever append.
enum class SectionPreset : std::uint8_t {
  Circle, Ellipse, Square, RoundedSquare, Triangle, Hexagon, Star, HalfRound, D, Heart, Plank, Gear,
  kCount
};

/// What a preset is called: `key` in files, on the command line and in the API ("rounded-square"),
/// `label` on the page ("Rounded square").
struct SectionName {
  SectionPreset preset;
  std::string_view key, label;
};
std::span<const SectionName> sectionNames();
std::optional<SectionPreset> sectionFromKey(std::string_view key);
std::string_view sectionKey(SectionPreset preset);

/// A simple closed polygon, counter-clockwise, last point not repeated, touching x = −1 and x = +1
/// so that the loft is exactly as wide as the rib.
struct Section {
  std::vector<SectionPoint> points;
  bool operator==(const Section&) const = default;
};

/// How many points a section may have.
inline constexpr int kMinSectionPoints = 12, kMaxSectionPoints = 512;

/// The preset with its corners kept and about `count` points (12…512) spread evenly in between.
/// Error: ValueOutOfRange.
Result<Section> presetSection(SectionPreset preset, int count);

}  // namespace spineloft::loft
