// Tables of the benchmark in Markdown.
#pragma once

#include <string>

#include "engine/io/json_values.h"

namespace spineloft::accuracy {

/// One line each, with the columns of the first; numbers named "… %" get one decimal, others three.
std::string markdownOf(const io::NamedLines& lines);

}  // namespace spineloft::accuracy
