// What a person chooses about a shape: a primitive that outlines in one, two or three views reshape.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/base/vec.h"
#include "engine/sections/ends.h"
#include "engine/sections/section.h"

namespace spineloft::shape {

/// What a shape is before an outline says more. Values are saved in files: only ever append.
enum class Primitive : std::uint8_t { Ball, Egg, Box, Cylinder, Capsule, Cone, Pyramid, HalfBall, kCount };

/// What a primitive is called in files and on the command line.
struct PrimitiveName {
  Primitive primitive;
  std::string_view key;
};
std::span<const PrimitiveName> primitiveNames();

/// How deep a shape is where no outline in a second view says it. Values are saved in files: only ever append.
enum class DepthMode : std::uint8_t {
  Round,  ///< at every level `ratio` times as deep as it is wide there
  Kept,   ///< the primitive's own depth, `ratio` times its own width, whatever outline is drawn
  kCount
};
struct Depth {
  DepthMode mode = DepthMode::Round;
  double ratio = 1;  ///< kLeastRatio…kMostRatio
  bool operator==(const Depth&) const = default;
};

/// From where to where a shape stands, picture pixels.
struct Axis {
  PicturePoint from{0, 100}, to{0, 0};
  bool operator==(const Axis&) const = default;
};

/// How the two ends are finished where they have a width.
struct Caps {
  sections::CapStyle start = sections::CapStyle::Flat, end = sections::CapStyle::Flat;
  bool operator==(const Caps&) const = default;
};

struct ShapeParams {
  Primitive primitive = Primitive::Ball;
  Axis axis;
  double width = 100;  ///< of the primitive, picture pixels, kLeastWidth…kFarthest
  Depth depth;
  std::optional<sections::SectionShape> section;  ///< none: the primitive's own
  Caps caps;
  int levels = 64;    ///< sections from end to end, kLeastLevels…kMostLevels
  int sides = 64;     ///< points of a section, kLeastSides…kMostSides
  int capRings = 12;  ///< of round ends, 1…kMostCapRings
  bool operator==(const ShapeParams&) const = default;
};

inline constexpr double kLeastAxis = 1, kLeastWidth = 0.5, kFarthest = 1e6;  ///< picture pixels
inline constexpr double kLeastRatio = 0.05, kMostRatio = 8;
inline constexpr int kLeastLevels = 8, kMostLevels = 256, kLeastSides = 12, kMostSides = 256, kMostCapRings = 32;

/// Everything in range and finite; the section is one that sections::checkShape takes.
bool isValid(const ShapeParams& params);

/// The primitive's section and its half width at a share of the axis, 0…1, in half widths: ball 2√(s(1−s)), box and
/// cylinder 1, cone and pyramid 1 − s, half ball √(1−s²); egg √((1−x²)/(1+2dx+d²)), x = 2s − 1, d = 0.25
/// (Hügelschäffer); capsule with ends round over `endShare` of the axis (half the width over the length, at most ½).
sections::SectionPreset sectionOf(Primitive primitive);
double halfWidthOf(Primitive primitive, double share, double endShare);

}  // namespace spineloft::shape
