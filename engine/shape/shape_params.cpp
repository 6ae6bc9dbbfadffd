#include "engine/shape/shape_params.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::shape {

std::span<const PrimitiveName> primitiveNames() {
  static constexpr std::array kNames = {
      PrimitiveName{Primitive::Ball, "ball"},       PrimitiveName{Primitive::Egg, "egg"},
      PrimitiveName{Primitive::Box, "box"},         PrimitiveName{Primitive::Cylinder, "cylinder"},
      PrimitiveName{Primitive::Capsule, "capsule"}, PrimitiveName{Primitive::Cone, "cone"},
      PrimitiveName{Primitive::Pyramid, "pyramid"}, PrimitiveName{Primitive::HalfBall, "half-ball"},
  };
  static_assert(kNames.size() == static_cast<std::size_t>(Primitive::kCount));
  return kNames;
}

bool isValid(const ShapeParams& p) {
  // Written so that NaN fails too.
  const auto near = [](PicturePoint q) { return std::abs(q.x) <= kFarthest && std::abs(q.y) <= kFarthest; };
  return p.primitive < Primitive::kCount && near(p.axis.from) && near(p.axis.to) &&
         distance(p.axis.from, p.axis.to) >= kLeastAxis && p.width >= kLeastWidth && p.width <= kFarthest &&
         p.depth.mode < DepthMode::kCount && p.depth.ratio >= kLeastRatio && p.depth.ratio <= kMostRatio &&
         p.caps.start < sections::CapStyle::kCount && p.caps.end < sections::CapStyle::kCount &&
         p.levels >= kLeastLevels && p.levels <= kMostLevels && p.sides >= kLeastSides && p.sides <= kMostSides &&
         p.capRings >= 1 && p.capRings <= kMostCapRings && (!p.section || sections::checkShape(*p.section).ok());
}

sections::SectionPreset sectionOf(Primitive primitive) {
  const bool square = primitive == Primitive::Box || primitive == Primitive::Pyramid;
  return square ? sections::SectionPreset::Square : sections::SectionPreset::Circle;
}

double halfWidthOf(Primitive primitive, double share, double endShare) {
  const auto root = [](double square) { return std::sqrt(std::max(0.0, square)); };
  switch (primitive) {
    case Primitive::Ball:
      return 2 * root(share * (1 - share));
    case Primitive::Egg: {
      constexpr double kLean = 0.25;
      const double x = 2 * share - 1;
      return root((1 - x * x) / (1 + 2 * kLean * x + kLean * kLean));
    }
    case Primitive::Capsule: {
      const double beyond = std::max(0.0, 1 - std::min(share, 1 - share) / endShare);
      return root(1 - beyond * beyond);
    }
    case Primitive::Cone:
    case Primitive::Pyramid:
      return 1 - share;
    case Primitive::HalfBall:
      return root(1 - share * share);
    case Primitive::Box:
    case Primitive::Cylinder:
    case Primitive::kCount:
      break;
  }
  return 1;
}

}  // namespace spineloft::shape
