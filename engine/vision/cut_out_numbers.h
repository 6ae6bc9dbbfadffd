// Hints and outlines as flat lists of numbers: how they go to a search in another program, and back.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/vision/cut_out.h"

namespace spineloft::vision {

/// The numbers of hints: every double as it is.
std::vector<double> numbersOf(const CutHints& hints);
/// None for a list that `numbersOf` does not make.
std::optional<CutHints> hintsFrom(std::span<const double> numbers);

/// What a search found, or why it found nothing: 0 and the outlines, or the number of the error and one more, and the
/// characters of its detail. Both programs are of one build: errors have the same numbers.
std::vector<double> numbersOf(const Result<CutContours>& found);
/// None for a list that `numbersOf` does not make.
std::optional<Result<CutContours>> foundFrom(std::span<const double> numbers);

}  // namespace spineloft::vision
