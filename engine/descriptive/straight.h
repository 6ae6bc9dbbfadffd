// Where lines turn, and whether they are straight in between.
#pragma once

#include <span>
#include <vector>

#include "engine/descriptive/lines.h"

namespace spineloft::descriptive {

/// Shares of a line at which it turns by more than `turn` radians, growing; of an open one 0 and 1 too. What a hand
/// trembles, kTremor of the size, is no corner. `size`: sizeOf.
std::vector<double> cornersOf(const MeasuredLine& line, double size, double turn);

/// Whether it is straight from one share to the next, of a closed one from the last to the first as well. `shares`:
/// growing, 0…1; with fewer than two it is not.
bool isStraightBetween(const MeasuredLine& line, std::span<const double> shares, double size);

/// Whether it is off its chord by at most kEdgeBend of that and kTremor of the size. `to` may pass 1 on a closed line.
bool isStraight(const MeasuredLine& line, double from, double to, double size);

/// How far it is off its chord to one side, the mean, as a share of the chord: trembling to both sides is none. `to` as
/// above.
double bowOf(const MeasuredLine& line, double from, double to);

inline constexpr double kEdgeCorner = 0.6;  ///< between the edges of a solid, radians
inline constexpr double kEdgeBend = 0.05;
inline constexpr double kTremor = 0.01;  ///< a share of the size

}  // namespace spineloft::descriptive
