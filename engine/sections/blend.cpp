#include "engine/sections/blend.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::sections {
namespace {

constexpr std::array kBlendNames = {
    BlendName{BlendKind::Linear, "linear", "Steady"},       BlendName{BlendKind::Ease, "ease", "Soft"},
    BlendName{BlendKind::Square, "square", "Late"},         BlendName{BlendKind::Root, "root", "Early"},
    BlendName{BlendKind::Overshoot, "overshoot", "Bouncy"}, BlendName{BlendKind::Custom, "custom", "Your own"},
    BlendName{BlendKind::Flow, "flow", "Flowing"},          BlendName{BlendKind::Hold, "hold", "Stepped"},
};
static_assert(kBlendNames.size() == static_cast<std::size_t>(BlendKind::kCount));

}  // namespace

std::span<const BlendName> blendNames() { return kBlendNames; }

std::optional<BlendKind> blendFromKey(std::string_view key) {
  const auto at = std::ranges::find(kBlendNames, key, &BlendName::key);
  if (at == kBlendNames.end()) return std::nullopt;
  return at->kind;
}

bool isValid(const Blend& blend) {
  if (blend.kind >= BlendKind::kCount || !geometry::isValid(blend.custom, -1, 2)) return false;
  if (blend.kind != BlendKind::Custom || blend.custom.empty()) return true;
  constexpr double kClose = 1e-6;
  return std::abs(geometry::valueAt(blend.custom, 0, 0)) < kClose &&
         std::abs(geometry::valueAt(blend.custom, 1, 1) - 1) < kClose;
}

double blendAt(const Blend& blend, double t) {
  switch (blend.kind) {
    case BlendKind::Linear:
    case BlendKind::Flow:
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
    case BlendKind::Hold:
      return std::max(0.0, (t - kHeld) / (1 - kHeld));
  }
  return t;
}

}  // namespace spineloft::sections
