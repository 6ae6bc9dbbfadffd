#include "engine/ribs/edit/rib_frame.h"

#include <cmath>
#include <numbers>

namespace spineloft::ribs {

RibPoint onEllipse(std::size_t i, std::size_t count, double tip) {
  const double angle = std::numbers::pi * static_cast<double>(i + 1) / static_cast<double>(count + 1);
  return {tip * std::sin(angle), std::cos(angle)};
}

RibFrame::RibFrame(PicturePoint left, PicturePoint right, bool atStart)
    : middle_((left + right) / 2), left_(left - middle_), out_{-left_.y, left_.x} {
  if (atStart) out_ = -out_;
}

RibPoint RibFrame::fromPicture(PicturePoint p) const {
  const PicturePoint away = p - middle_;
  const double square = dot(left_, left_);
  return {dot(away, out_) / square, dot(away, left_) / square};
}

std::vector<PicturePoint> RibFrame::toPicture(const std::vector<RibPoint>& points) const {
  std::vector<PicturePoint> out;
  for (const RibPoint p : points) out.push_back(toPicture(p));
  return out;
}

std::vector<RibPoint> RibFrame::fromPicture(const std::vector<PicturePoint>& points) const {
  std::vector<RibPoint> out;
  for (const PicturePoint p : points) out.push_back(fromPicture(p));
  return out;
}

}  // namespace spineloft::ribs
