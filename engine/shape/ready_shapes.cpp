#include "engine/shape/ready_shapes.h"

#include <algorithm>
#include <array>

namespace spineloft::shape {

std::span<const ReadyShape> readyShapes() {
  static constexpr std::array kReady = {
      ReadyShape{Primitive::Ball, "Ball", 1},         ReadyShape{Primitive::Egg, "Egg", 0.75},
      ReadyShape{Primitive::Box, "Block", 1},         ReadyShape{Primitive::Cylinder, "Cylinder", 0.6},
      ReadyShape{Primitive::Capsule, "Capsule", 0.4}, ReadyShape{Primitive::Cone, "Cone", 0.8},
      ReadyShape{Primitive::Pyramid, "Pyramid", 1},   ReadyShape{Primitive::HalfBall, "Half ball", 2},
  };
  static_assert(kReady.size() == static_cast<std::size_t>(Primitive::kCount));
  return kReady;
}

const ReadyShape& readyShape(Primitive primitive) {
  return *std::ranges::find(readyShapes(), primitive, &ReadyShape::primitive);
}

}  // namespace spineloft::shape
