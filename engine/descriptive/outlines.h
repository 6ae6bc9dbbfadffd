// Which lines are the closed outlines of pieces, and those outlines as polygons.
#pragma once

#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/lines.h"

namespace spineloft::descriptive {

/// Closed outlines that the lines make, each a piece, in the order of their first lines: a closed line is one. At nodes
/// where ends of lines meet they are paired so that the sum of the squared turns is least, and followed until they
/// close (good continuation). A chain whose two ends lie on one closed line is closed by the shorter way along it,
/// which both outlines then share. What does not close is no outline. `nodes`: nodesOf. Cost: ends squared; of more
/// than kMostPaired ends at one node the first are paired.
std::vector<Outline> proposeOutlines(std::span<const MeasuredLine> lines, std::span<const Node> nodes);

inline constexpr std::size_t kMostPaired = 10;

/// An outline as a polygon whose corners know where they are on the lines.
struct OutlinePath {
  std::vector<PicturePoint> points;  ///< pixels, the first not repeated
  std::vector<Place> places;         ///< of each point
  std::vector<bool> hidden;          ///< of the edge from each point to the next
};

/// With a point at every point of its lines and where hidden stretches begin and end. Errors: ValueOutOfRange (a line
/// that is not there, shares outside of 0…1), RegionEmpty (fewer than three points).
Result<OutlinePath> pathOf(std::span<const MeasuredLine> lines, const Outline& outline);

}  // namespace spineloft::descriptive
