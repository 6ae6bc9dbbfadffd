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
  std::vector<PicturePoint> points;                ///< 1…kMostSketchPoints, finite
  std::vector<float> pressure;                     ///< empty, or one a point, 0…1: thins the line
  double radius = 2;                               ///< at full pressure, 0.5…100
  bool erase = false;                              ///< paper again
  std::array<std::uint8_t, 3> colour{31, 36, 48};  ///< sRGB
  bool operator==(const SketchStroke&) const = default;
};
inline constexpr std::size_t kMostSketchPoints = 20000, kMostSketchStrokes = 5000;
inline constexpr int kLeastSketchSide = 64, kMostSketchSide = 2048;

/// Finite and in range.
bool isValid(const SketchStroke& stroke);

/// Where the pen's tip goes, and how wide it is there: the stroke's points, smoothed, except that
/// the line stays sharp where it turns by more than 60°. Between two of these points the line runs
/// straight and its radius changes evenly. Whole numbers, in 1/kInkUnit of a picture pixel, so that
/// every platform finds the same.
struct InkPoint {
  std::int32_t x = 0, y = 0, radius = 0;
  bool operator==(const InkPoint&) const = default;
};
inline constexpr int kInkUnit = 256;
/// The line of a valid stroke, at least one point; empty for any other. It begins and ends where the
/// stroke does. Coordinates beyond ±16384 pixels are taken for ±16384.
std::vector<InkPoint> inkLine(const SketchStroke& stroke);

/// White paper of this size with the strokes on it, in order, smoothly edged. Equal strokes, equal
/// pixels on every platform. Error: ValueOutOfRange (size or strokes), OutOfMemory.
Result<Picture> drawSketch(Size size, std::span<const Box<SketchStroke>> strokes);

/// The same on a sketch that has strokes already: costs only what the new strokes cover. What
/// drawSketch makes of the first strokes, given to this with the others, is what drawSketch makes of
/// all. Errors: as drawSketch.
Result<Picture> drawMore(Picture sketch, std::span<const Box<SketchStroke>> strokes);

}  // namespace spineloft::image
