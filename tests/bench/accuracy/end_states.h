// How far what is shown of rib ends, on an edge, bridged or guessed, and their probabilities are true.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "engine/base/result.h"
#include "engine/io/json_values.h"
#include "engine/ribs/base/rib_params.h"

namespace spineloft::accuracy {

/// Of all ends of all strokes whose place is known (true_exit.h): by tenths of their support, the share of the ends,
/// the mean support, and the share that is right to within two and a half labels; by state, the share of the ends and
/// the share that is right to a tenth of the true length and 1.5 px; and the expected calibration error of the support.
/// Into the report, and as a table in Markdown into `markdown`.
Status scoreEndStates(std::span<const std::filesystem::path> folders, int jobs, const ribs::RibParams& params,
                      const std::string& markdown, io::BenchReport& report);

}  // namespace spineloft::accuracy
