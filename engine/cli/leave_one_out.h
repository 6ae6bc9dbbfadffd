// How far the weights depend on the cases that they were chosen on.
#pragma once

#include <filesystem>
#include <span>

#include "engine/base/result.h"
#include "engine/cli/arguments.h"
#include "engine/io/json_values.h"

namespace spineloft::cli {

/// For every category of the cases: chooses the main weights anew on the cases of all others, and
/// scores them on this one, which they have never seen. The search goes from weight to weight over
/// a coarse grid (shares of the defaults), twice round, from a start away from the defaults, and
/// takes what has the highest mean iou_body. Beside it: the defaults on the same cases, and weights
/// chosen in the same way on all cases. Into the report and as a table in Markdown to
/// `arguments.leaveOneOut`. Takes some hundred runs over all cases.
Status leaveOneOut(const BenchArguments& arguments, std::span<const std::filesystem::path> folders,
                   io::BenchReport& report);

}  // namespace spineloft::cli
