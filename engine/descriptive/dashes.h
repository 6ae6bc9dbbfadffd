// Dashes drawn by hand: short strokes one after the other that stand for one hidden line.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/descriptive/drawing.h"

namespace spineloft::descriptive {

/// Whether a stroke is a dash after another: both open, seen, at most kLongestDash of the size from end to end, nearly
/// straight, and of lengths within kMostRatio of each other; kLeastGap … kMostGap of their mean length apart; neither
/// the way over the gap nor the stroke turns by more than kMostTurn. Either may have been drawn backwards. `size`:
/// sizeOf all lines.
bool isDashAfter(const Line& last, const Line& stroke, double size);

/// The hidden line that the lines from `first` to before `end` are: kLeastDashes or more, each a dash after the
/// one before, that lead from an open end of another line to an open end of another, or round to where they began. An
/// end counts within kWelding of the size, or 1.5 times the longest gap; the line goes there. None where they are none.
std::optional<Line> dashedLine(std::span<const Line> lines, std::size_t first, std::size_t end, double size);

/// Where the dashes begin of which the last line of the list is one; the last line where it is none.
std::size_t firstDash(std::span<const Line> lines, double size);

/// All lines, with dashes made one hidden line.
std::vector<Line> withoutDashes(std::span<const Line> lines);

inline constexpr double kLongestDash = 0.08;              ///< a share of the size
inline constexpr double kLeastGap = 0.2, kMostGap = 3.0;  ///< shares of the mean length of two dashes
inline constexpr double kMostRatio = 3;
inline constexpr double kMostTurn = 0.6;  ///< radians
inline constexpr std::size_t kLeastDashes = 3;

}  // namespace spineloft::descriptive
