// Which points of several sections belong together.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/sections/contour.h"

namespace spineloft::sections {

/// Which points of neighbours in a row belong together.
enum class Matching : std::uint8_t {
  /// Those in the same direction where both are star-shaped, else the shift of least sum of distances
  /// (cross-sections-hughes 4.1.1).
  Direction,
  /// Of those two, and of shifts that put corners on corners, the one of least Σ|a − R(−θ)b|² (1 + (θ/90°)²), θ the
  /// best
  /// rotation from a to b: a turned square turns, a square over a circle does not. Contours about their centroids and
  /// of equal areas, about as large as the square [−1, 1]².
  LeastTurn,
};

/// Contours that belong together, one a key, on common points: as many on each, corners of all kept.
/// Counter-clockwise. Between star-shaped ones straight lines between points are free of crossings.
/// `mostKnots` > 0: of corners, of whichever contour, that are closer than 1/mostKnots of the way round one is kept.
std::vector<std::vector<SectionPoint>> onCommonPoints(std::span<const Contour> row, int points,
                                                      Matching matching = Matching::Direction,
                                                      std::size_t mostKnots = 1000000);

/// Shares of the length of `a` to which the points of `b` belong by Matching::LeastTurn, growing, the last less than 1
/// after the first. Both as that wants them.
std::vector<double> placesOn(const Contour& a, const Contour& b);

/// The point from which a curve's points are sorted by direction: its centroid when that sees every
/// edge well, else the centre of its kernel; none when no point sees it all.
std::optional<SectionPoint> hubOf(std::span<const SectionPoint> points);

}  // namespace spineloft::sections
