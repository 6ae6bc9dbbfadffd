// The frame of the outermost rib of an end: what outlines of ends are told in, so that they follow the rib.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/ribs/edit/edits.h"

namespace spineloft::ribs {

/// The i-th of `count` points on half an ellipse from the left end of the rib to its right one, as far out as `tip`.
RibPoint onEllipse(std::size_t i, std::size_t count, double tip);

/// Of a rib from `left` to `right` at the start or the end of a part. Picture pixels.
class RibFrame {
 public:
  RibFrame(PicturePoint left, PicturePoint right, bool atStart);
  /// Half the width of the rib, picture pixels.
  double unit() const { return norm(left_); }
  PicturePoint toPicture(RibPoint p) const { return middle_ + left_ * p.y + out_ * p.x; }
  /// unit() > 0.
  RibPoint fromPicture(PicturePoint p) const;
  std::vector<PicturePoint> toPicture(const std::vector<RibPoint>& points) const;
  std::vector<RibPoint> fromPicture(const std::vector<PicturePoint>& points) const;

 private:
  PicturePoint middle_, left_, out_;
};

}  // namespace spineloft::ribs
