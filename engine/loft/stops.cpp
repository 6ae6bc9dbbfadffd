// Sections along the spine: their checks and the ways from one to the next.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/polygon.h"
#include "engine/loft/section.h"

namespace spineloft::loft {
namespace {

constexpr std::array kBlendNames = {
    BlendName{BlendKind::Linear, "linear", "Steady"},
    BlendName{BlendKind::Ease, "ease", "Soft"},
    BlendName{BlendKind::Square, "square", "Late"},
    BlendName{BlendKind::Root, "root", "Early"},
    BlendName{BlendKind::Overshoot, "overshoot", "Bouncy"},
    BlendName{BlendKind::Custom, "custom", "Your own"},
};
static_assert(kBlendNames.size() == static_cast<std::size_t>(BlendKind::kCount));

}  // namespace

std::span<const BlendName> blendNames() { return kBlendNames; }

std::optional<BlendKind> blendFromKey(std::string_view key) {
  const auto at = std::ranges::find(kBlendNames, key, &BlendName::key);
  if (at == kBlendNames.end()) return std::nullopt;
  return at->kind;
}

double blendAt(const Blend& blend, double t) {
  switch (blend.kind) {
    case BlendKind::Linear:
    case BlendKind::kCount:
      return t;
    case BlendKind::Ease:
      return t * t * (3 - 2 * t);
    case BlendKind::Square:
      return t * t;
    case BlendKind::Root:
      return std::sqrt(t);
    case BlendKind::Overshoot: {
      constexpr double kSpring = 1.7;  // goes about a tenth beyond before it settles
      const double u = t - 1;
      return 1 + u * u * ((kSpring + 1) * u + kSpring);
    }
    case BlendKind::Custom:
      return geometry::valueAt(blend.custom, t, t);
  }
  return t;
}

Status checkShape(const SectionShape& shape) {
  if (shape.preset >= SectionPreset::kCount) return {Error::ValueOutOfRange, "slice"};
  if (shape.contours.size() > kMostContours) return {Error::SectionInvalid, "too many curves"};
  for (const auto& contour : shape.contours) {
    if (contour.size() < 3 || contour.size() > kMostDrawnPoints) {
      return {Error::SectionInvalid, "a curve needs 3 to 5000 points"};
    }
    if (!std::ranges::all_of(contour, [](SectionPoint p) { return isFinite(p); })) {
      return {Error::SectionInvalid, "not finite"};
    }
    if (!geometry::isSimple(contour)) return {Error::SectionInvalid, "touches itself"};
  }
  return Done{};
}

Status checkStops(std::span<const SectionStop> stops) {
  if (stops.empty() || stops.size() > kMostStops) return {Error::ValueOutOfRange, "slices"};
  double before = -1;
  for (const SectionStop& stop : stops) {
    if (!(stop.at >= 0 && stop.at <= 1)) return {Error::ValueOutOfRange, "place of a slice"};
    if (before >= 0 && stop.at - before < geometry::kLeastStep) {
      return {Error::ValueOutOfRange, "slices too close"};
    }
    before = stop.at;
    if (stop.blend.kind >= BlendKind::kCount || !geometry::isValid(stop.blend.custom, -1, 2)) {
      return {Error::ValueOutOfRange, "blend"};
    }
    if (Status shape = checkShape(stop.shape); !shape) return shape;
  }
  return Done{};
}

}  // namespace spineloft::loft
