// Which points of several sections belong together.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/sections/contour.h"

namespace spineloft::sections {

/// Contours that belong together, one a key, on common points: as many on each, corners of all kept.
/// Counter-clockwise. Between star-shaped ones straight lines between points are free of crossings.
std::vector<std::vector<SectionPoint>> onCommonPoints(std::span<const Contour> row, int points);

/// The point from which a curve's points are sorted by direction: its centroid when that sees every
/// edge well, else the centre of its kernel; none when no point sees it all.
std::optional<SectionPoint> hubOf(std::span<const SectionPoint> points);

}  // namespace spineloft::sections
