// Cross-sections: closed curves in [−1, 1]² (x across the rib, y towards the viewer).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace spineloft::sections {

/// The presets of the section shelf, in its order. Values are saved in files: only ever append.
enum class SectionPreset : std::uint8_t {
  Circle,
  Ellipse,
  Square,
  RoundedSquare,
  Triangle,
  Hexagon,
  Star,
  HalfRound,
  D,
  Heart,
  Plank,
  Gear,
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

/// A section as a person chose it: a preset, or closed curves of their own. Drawn: simple curves that
/// do not touch each other, in either direction; one inside another is a hole, one inside that a piece
/// again. At most kMostContours curves of 3…kMostDrawnPoints points. The loft scales them evenly and
/// moves them along x so that together they touch x = −1 and x = +1. Sections of several curves always
/// end flat.
struct SectionShape {
  SectionShape(SectionPreset chosen = SectionPreset::Circle) : preset(chosen) {}
  SectionPreset preset;                             ///< when nothing is drawn
  std::vector<std::vector<SectionPoint>> contours;  ///< drawn; empty: the preset
  bool operator==(const SectionShape&) const = default;
  bool drawn() const { return !contours.empty(); }
};
inline constexpr std::size_t kMostContours = 16, kMostDrawnPoints = 5000;

/// Known preset or sound contours; Error: SectionInvalid with what is wrong.
Status checkShape(const SectionShape& shape);
/// How many points a section may have.
inline constexpr int kMinSectionPoints = 12, kMaxSectionPoints = 512;

/// The preset with its corners kept and about `count` points (12…512) spread evenly in between.
/// Error: ValueOutOfRange.
Result<Section> presetSection(SectionPreset preset, int count);

}  // namespace spineloft::sections
