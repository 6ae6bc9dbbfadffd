// Cross-sections: closed curves in [−1, 1]² (x across the rib, y towards the viewer).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/geometry/along.h"

namespace spineloft::loft {

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

/// How one section becomes the next: f(t) of the share t of the way, f(0) = 0, f(1) = 1
/// (cross-sections-hughes 4.2). Values are saved in files: only ever append.
enum class BlendKind : std::uint8_t { Linear, Ease, Square, Root, Overshoot, Custom, kCount };
struct BlendName {
  BlendKind kind;
  std::string_view key, label;
};
std::span<const BlendName> blendNames();
std::optional<BlendKind> blendFromKey(std::string_view key);
struct Blend {
  BlendKind kind = BlendKind::Ease;
  geometry::AlongCurve custom;  ///< of Custom: values −1…2, through (0, 0) and (1, 1)
  bool operator==(const Blend&) const = default;
};
/// f(t), t in 0…1.
double blendAt(const Blend& blend, double t);

/// A section somewhere along the spine. Before the first and after the last key the section stays
/// as it is; one key alone is the section of the whole part.
struct SectionKey {
  double at = 0.5;  ///< share of the spine's length, 0…1
  SectionShape shape;
  Blend blend;  ///< from here to the next key
  bool operator==(const SectionKey&) const = default;
};
inline constexpr std::size_t kMostSectionKeys = 32;

/// Known preset or sound contours; Error: SectionInvalid with what is wrong.
Status checkShape(const SectionShape& shape);
/// 1…kMostSectionKeys keys in order, at least geometry::kLeastStep apart, all with the same number of
/// outer curves and holes. Errors: SectionInvalid, ValueOutOfRange.
Status checkSectionKeys(std::span<const SectionKey> keys);

/// How many points a section may have.
inline constexpr int kMinSectionPoints = 12, kMaxSectionPoints = 512;

/// The preset with its corners kept and about `count` points (12…512) spread evenly in between.
/// Error: ValueOutOfRange.
Result<Section> presetSection(SectionPreset preset, int count);

}  // namespace spineloft::loft
