// Pictures of one thing from several sides: where a pixel of one stands in the ModelSpace of another.
#pragma once

#include <cmath>
#include <cstdint>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// From where a picture looks at the thing that the other picture shows from the front. Right is where x of the other
/// picture grows. Values are saved in files: only ever append.
enum class ViewFrom : std::uint8_t { Right, Left, Back, Top, kCount };

/// An orthographic view with the same up (from the top: the viewer of the front stands at its foot). Of the two
/// coordinates that a pixel (x, y) has in the ModelSpace of the front picture, the one that both pictures show is
/// measured from `shift`, the other one from `middle`:
///   right  Y = shift − scale · y,  Z = scale · (middle − x)      back  X = shift − scale · x,  Y = scale · (middle −
///   y) left   Y = shift − scale · y,  Z = scale · (x − middle)      top   X = shift + scale · x,  Z = scale · (y −
///   middle)
struct View {
  ViewFrom from = ViewFrom::Right;
  double middle = 0;  ///< pixels of this picture, ±kFarthestView
  double scale = 1;   ///< pixels of the front picture a pixel of this one, kLeastViewScale…kMostViewScale
  double shift = 0;   ///< pixels of the front picture, ±kFarthestView
  bool operator==(const View&) const = default;
};

inline constexpr double kFarthestView = 1e6, kLeastViewScale = 1e-3, kMostViewScale = 1e3;

inline bool isValid(const View& view) {
  return view.from < ViewFrom::kCount && std::abs(view.middle) <= kFarthestView &&
         std::abs(view.shift) <= kFarthestView && view.scale >= kLeastViewScale && view.scale <= kMostViewScale;
}

/// The place of a pixel; the coordinate that the view does not show is 0.
inline ModelPoint inModel(const View& view, PicturePoint p) {
  const double s = view.scale;
  switch (view.from) {
    case ViewFrom::Right:
      return {0, view.shift - s * p.y, s * (view.middle - p.x)};
    case ViewFrom::Left:
      return {0, view.shift - s * p.y, s * (p.x - view.middle)};
    case ViewFrom::Back:
      return {view.shift - s * p.x, s * (view.middle - p.y), 0};
    case ViewFrom::Top:
    case ViewFrom::kCount:
      break;
  }
  return {view.shift + s * p.x, 0, s * (p.y - view.middle)};
}

/// The pixel that shows a place: what inModel undoes.
inline PicturePoint inView(const View& view, ModelPoint p) {
  const double s = view.scale;
  switch (view.from) {
    case ViewFrom::Right:
      return {view.middle - p.z / s, (view.shift - p.y) / s};
    case ViewFrom::Left:
      return {view.middle + p.z / s, (view.shift - p.y) / s};
    case ViewFrom::Back:
      return {(view.shift - p.x) / s, view.middle - p.y / s};
    case ViewFrom::Top:
    case ViewFrom::kCount:
      break;
  }
  return {(p.x - view.shift) / s, view.middle + p.z / s};
}

}  // namespace spineloft::geometry
