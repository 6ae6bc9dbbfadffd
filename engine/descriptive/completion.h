// Outlines whose hidden part is not drawn: lines go on smoothly behind what they end at.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/descriptive/lines.h"

namespace spineloft::descriptive {

/// An end of a line.
struct LineEnd {
  std::uint32_t line = 0;
  PicturePoint at;     ///< pixels
  PicturePoint along;  ///< of length 1, on from the line
  double bend = 0;     ///< curvature there, on from the line, radians a pixel; > 0: clockwise as the picture is seen
};
/// Direction and curvature are those of the parabola through the end that is nearest to the last kEndLook of the line.
LineEnd endOf(std::span<const MeasuredLine> lines, std::uint32_t line, bool last);

/// Whether the end lies on another line and, where that is closed, leads into it. `size`: sizeOf.
bool goesUnder(std::span<const MeasuredLine> lines, const LineEnd& end, double size);

/// The way from one end to another one, both included; pixels.
struct HiddenWay {
  std::vector<PicturePoint> points;
  double turn = 0;  ///< radians, to both sides
};
/// The cubic that goes on along both ends. Between ends of an arc of a circle it is the rest of the circle (within 2 %
/// of its radius up to half of it), and so it is of an ellipse where both ends are alike: the handles, of length
/// ⅔ c tan(θ/4) sin β / sin²(θ/2) with c the distance of the ends, θ the turn and β the angle at the other end, go
/// with the picture when it is stretched. A handle is then made longer or shorter, within bounds, so that the way bends
/// at its end as the line does, where that can be measured.
HiddenWay hiddenWay(const LineEnd& from, const LineEnd& to);

/// What can hide something.
struct Cover {
  std::vector<PicturePoint> outline;  ///< closed, the first point not repeated
  std::vector<std::uint32_t> lines;   ///< of which it consists
};

/// Pairs of ends that go on into each other behind something, by their place in `ends`: each lies on the edge of one of
/// the covers and leads into it, and the whole way between them is within covers and turns by at most kMostHiddenTurn;
/// a line hides none of its own ends. Of all such pairs those count first whose way bends as the lines do at their
/// ends: with the least Σ (Δ bend · c)² + kWayWeight · c / size, c their distance, > kContact · size; each end is in
/// one, and is tried in at most kMostTries. Cost: ends squared, and ends times the points of the covers.
std::vector<std::array<std::size_t, 2>> hiddenPairs(std::span<const LineEnd> ends, std::span<const Cover> covers,
                                                    double size);

inline constexpr double kEndLook = 0.1;
inline constexpr double kMostHiddenTurn = 4.2;  ///< 240°: sides of a leg may part
inline constexpr double kWayWeight = 8;
inline constexpr int kMostTries = 8;

}  // namespace spineloft::descriptive
