// Drawing with a pen on blank paper: strokes to pixels.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/box.h"
#include "engine/base/result.h"
#include "engine/image/image.h"

namespace spineloft::image {

/// One stroke of a pen or an eraser. Picture pixels.
struct SketchStroke {
  std::vector<PicturePoint> points;    ///< 1…kMostSketchPoints, finite
  std::vector<float> pressure;         ///< empty, or one a point, 0…1: thins the line
  double radius = 2;                   ///< at full pressure, 0.5…100
  bool erase = false;                  ///< paper again
  std::array<std::uint8_t, 3> colour{31, 36, 48};  ///< sRGB
  bool operator==(const SketchStroke&) const = default;
};
inline constexpr std::size_t kMostSketchPoints = 20000, kMostSketchStrokes = 5000;
inline constexpr int kLeastSketchSide = 64, kMostSketchSide = 2048;

/// Finite and in range.
bool isValid(const SketchStroke& stroke);

/// White paper of this size with the strokes on it, in order, smoothly edged. Equal strokes, equal
/// pixels on every platform. Error: ValueOutOfRange (size or strokes), OutOfMemory.
Result<Picture> drawSketch(Size size, std::span<const Box<SketchStroke>> strokes);

}  // namespace spineloft::image
