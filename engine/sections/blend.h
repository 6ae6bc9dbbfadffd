// The ways from one section to the next.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/geometry/along.h"

namespace spineloft::sections {

/// How one section becomes the next: f(t) of the share t of the way, f(0) = 0, f(1) = 1
/// (cross-sections-hughes 4.2). Flow: every point goes on a cubic through all sections, whose slope at each is that of
/// the parabola through it and its neighbours, so that nothing is left of the places where sections stand; f(t) = t.
/// Hold: it stays until kHeld and changes on the rest of the way, evenly.
/// Values are saved in files: only ever append.
enum class BlendKind : std::uint8_t { Linear, Ease, Square, Root, Overshoot, Custom, Flow, Hold, kCount };
inline constexpr double kHeld = 0.999;  ///< share of the way
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
/// A known kind, and a curve of its own that goes from 0 to 1.
bool isValid(const Blend& blend);
/// f(t), t in 0…1.
double blendAt(const Blend& blend, double t);

}  // namespace spineloft::sections
