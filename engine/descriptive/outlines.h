// Which lines are the closed outlines of pieces, and those outlines as polygons.
#pragma once

#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/lines.h"

namespace spineloft::descriptive {

/// Closed outlines that the lines make, each a piece, in the order of their first lines: a closed line is one. At nodes
/// where ends of lines meet they are paired so that the sum of the squared turns is least, and followed until they
/// close (good continuation). Ends that lie on another line and lead under a closed outline are paired behind it
/// (hiddenPairs), and outlines that close so are looked under in turn. A chain whose two ends lie on one closed line
/// and are not paired so is closed by the shorter way along it, which both outlines then share. What does not close is
/// no outline. `nodes`: nodesOf. Cost: ends squared; of more than kMostPaired ends at one node the first are paired.
std::vector<Outline> proposeOutlines(std::span<const MeasuredLine> lines, std::span<const Node> nodes);

inline constexpr std::size_t kMostPaired = 10;

/// An outline as a polygon.
struct OutlinePath {
  std::vector<PicturePoint> points;                  ///< pixels, the first not repeated
  std::vector<bool> hidden;                          ///< of the edge from each point to the next
  std::vector<std::vector<PicturePoint>> completed;  ///< ways along it that no line draws
};

/// With a point at every point of its lines and where hidden stretches begin and end. A gap between two ends that
/// go under other lines (goesUnder) is closed by the way hidden behind them (hiddenWay), every other gap straight.
/// Errors: ValueOutOfRange (a line that is not there, shares outside of 0…1), RegionEmpty (fewer than three points).
Result<OutlinePath> pathOf(std::span<const MeasuredLine> lines, const Outline& outline);

}  // namespace spineloft::descriptive
