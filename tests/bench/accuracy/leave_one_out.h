// How far the weights depend on the cases that they were chosen on.
#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "engine/base/result.h"
#include "engine/io/json_values.h"

namespace spineloft::accuracy {

/// For every category of the cases: chooses the main weights anew on the cases of all others, and
/// scores them on this one, which they have never seen. The search goes from weight to weight over
/// a coarse grid (shares of the defaults), twice round, from a start away from the defaults, and
/// takes what has the highest mean iou_body. Beside it: the defaults on the same cases, and weights
/// chosen in the same way on all cases. Into the report and as a table in Markdown into
/// `markdown`. Takes some hundred runs over all cases.
Status leaveOneOut(std::span<const std::filesystem::path> folders, int jobs, const std::string& markdown,
                   io::BenchReport& report);

}  // namespace spineloft::accuracy
