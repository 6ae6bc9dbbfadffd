// What packJson begins with from version 6 on, besides words. Internal to packed_json.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace spineloft::io {

/// Models of one part each as links hold them, traced in made scenes (tests/training). Texts that were written with
/// them are only read with them: they never change.
std::vector<nlohmann::json> linkedModels();

}  // namespace spineloft::io
