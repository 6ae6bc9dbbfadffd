// A creature of lines: a body, half hidden legs and a tail, as a hand draws it.
#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "engine/document/action.h"
#include "engine/geometry/polyline.h"

namespace spineloft::testing {

/// Of a body on paper of 1000 × 800 pixels.
inline constexpr PicturePoint kBody{500, 400};
inline constexpr double kBodyWide = 250, kBodyHigh = 150;

/// On the lower side of the body at x.
inline PicturePoint onBelly(double x) {
  const double share = (x - kBody.x) / kBodyWide;
  return {x, kBody.y + kBodyHigh * std::sqrt(1 - share * share)};
}

inline std::vector<PicturePoint> bodyLine() {
  std::vector<PicturePoint> line;
  for (int i = 0; i < 72; ++i) {
    const double angle = 2 * std::numbers::pi * i / 72;
    line.push_back({kBody.x + kBodyWide * std::cos(angle), kBody.y + kBodyHigh * std::sin(angle)});
  }
  return line;
}

/// From the belly down, round the foot and back to the belly: what is seen of a leg.
inline std::vector<PicturePoint> legLine(double x, double width = 70, double foot = 720) {
  const PicturePoint from = onBelly(x), to = onBelly(x + width);
  std::vector<PicturePoint> line{from};
  for (int i = 1; i < 10; ++i) line.push_back(lerp(from, PicturePoint{x, foot}, i / 10.0));
  for (int i = 0; i <= 12; ++i) {
    const double angle = std::numbers::pi * (1 - i / 12.0);
    line.push_back({x + width / 2 + width / 2 * std::cos(angle), foot + width / 2 * std::sin(angle)});
  }
  for (int i = 1; i <= 10; ++i) line.push_back(lerp(PicturePoint{x + width, foot}, to, i / 10.0));
  return line;
}

/// What is not seen of it: from one end to the other behind the body.
inline std::vector<PicturePoint> hipLine(double x, double width = 70) {
  const PicturePoint from = onBelly(x + width), to = onBelly(x);
  std::vector<PicturePoint> line{from};
  for (int i = 1; i < 12; ++i) {
    const double angle = std::numbers::pi * i / 12;
    const PicturePoint on = lerp(from, to, i / 12.0);
    line.push_back({on.x, on.y - 70 * std::sin(angle)});
  }
  line.push_back(to);
  return line;
}

/// The same line as dashes by hand, the first and the last a little off its ends; `share` of it are dashes.
inline std::vector<std::vector<PicturePoint>> dashesOf(const std::vector<PicturePoint>& line, int count = 7,
                                                       double share = 0.6) {
  std::vector<double> s;
  geometry::arcLengths(std::span<const PicturePoint>(line), s);
  std::vector<std::vector<PicturePoint>> dashes;
  for (int k = 0; k < count; ++k) {
    std::vector<PicturePoint>& dash = dashes.emplace_back();
    for (int i = 0; i <= 6; ++i) {
      const double at = (k + (1 - share) / 2 + share * i / 6) / count;
      dash.push_back(geometry::pointAt(std::span<const PicturePoint>(line), std::span<const double>(s), at * s.back()));
    }
  }
  return dashes;
}

/// A closed line whose root lies over the body.
inline std::vector<PicturePoint> tailLine() {
  std::vector<PicturePoint> line;
  for (int i = 0; i < 48; ++i) {
    const double angle = 2 * std::numbers::pi * i / 48;
    line.push_back({790 + 90 * std::cos(angle), 380 + 35 * std::sin(angle)});
  }
  return line;
}

/// The gestures that draw all of it on a picture.
inline std::vector<document::Action> creature(PictureId picture) {
  using document::DrawLine;
  return {DrawLine{picture, bodyLine(), {}, true},   DrawLine{picture, legLine(360)},
          DrawLine{picture, hipLine(360), {{0, 1}}}, DrawLine{picture, legLine(560)},
          DrawLine{picture, hipLine(560), {{0, 1}}}, DrawLine{picture, tailLine(), {}, true}};
}

}  // namespace spineloft::testing
