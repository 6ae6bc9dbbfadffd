// Sections along the spine: their checks and the ways from one to the next.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/loft/contour.h"
#include "engine/loft/section.h"

namespace spineloft::loft {
namespace {

constexpr std::array kBlendNames = {
    BlendName{BlendKind::Linear, "linear", "Steady"},       BlendName{BlendKind::Ease, "ease", "Soft"},
    BlendName{BlendKind::Square, "square", "Late"},         BlendName{BlendKind::Root, "root", "Early"},
    BlendName{BlendKind::Overshoot, "overshoot", "Bouncy"}, BlendName{BlendKind::Custom, "custom", "Your own"},
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
  if (!shape.drawn()) return Done{};
  const Result<std::vector<SectionPiece>> pieces = readShape(shape);
  if (!pieces) return pieces.failure();
  return Done{};
}

namespace {

/// How many holes each outer curve has, in order of size: equal for shapes that can become each other.
std::vector<int> makeUp(const std::vector<SectionPiece>& pieces) {
  std::vector<int> holes(pieces.size(), 0), outers;
  for (const SectionPiece& piece : pieces) {
    if (piece.hole) ++holes[piece.outer];
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].hole) outers.push_back(holes[i]);
  }
  std::ranges::sort(outers);
  return outers;
}

bool joinsItsKeys(const Blend& blend) {
  if (blend.kind != BlendKind::Custom || blend.custom.empty()) return true;
  constexpr double kClose = 1e-6;
  return std::abs(geometry::valueAt(blend.custom, 0, 0)) < kClose &&
         std::abs(geometry::valueAt(blend.custom, 1, 1) - 1) < kClose;
}

}  // namespace

Status checkSectionKeys(std::span<const SectionKey> keys) {
  if (keys.empty() || keys.size() > kMostSectionKeys) return {Error::ValueOutOfRange, "slices"};
  double before = -1;
  std::vector<int> first;
  for (const SectionKey& key : keys) {
    if (!(key.at >= 0 && key.at <= 1)) return {Error::ValueOutOfRange, "place of a slice"};
    if (before >= 0 && key.at - before < geometry::kLeastStep) {
      return {Error::ValueOutOfRange, "slices too close"};
    }
    if (key.blend.kind >= BlendKind::kCount || !geometry::isValid(key.blend.custom, -1, 2) ||
        !joinsItsKeys(key.blend)) {
      return {Error::ValueOutOfRange, "blend"};
    }
    if (key.shape.preset >= SectionPreset::kCount) return {Error::ValueOutOfRange, "slice"};
    if (keys.size() == 1 && !key.shape.drawn()) break;  // nothing that it could disagree with
    std::vector<int> pieces = {0};
    if (key.shape.drawn()) {
      const Result<std::vector<SectionPiece>> read = readShape(key.shape);
      if (!read) return read.failure();
      pieces = makeUp(read.value());
    }
    if (before >= 0 && pieces != first) {
      return {Error::SectionInvalid, "all slices of one part need the same number of pieces and holes"};
    }
    if (before < 0) first = std::move(pieces);
    before = key.at;
  }
  return Done{};
}

}  // namespace spineloft::loft
