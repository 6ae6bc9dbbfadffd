// What packJson begins with from version 3 on, besides the example of version 1. Internal to packed_json.cpp.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

namespace spineloft::io {

/// Models of one part each as links hold them, drawn with a quick hand and then with a careful one: a mug, a tail, a
/// hook, a snake, a tap, a cup, a bottle. With `fans` (from version 5 on) the outlines of their ends, too. Texts that
/// were written with them are only read with them: they never change.
std::vector<nlohmann::json> tracedModels(bool fans);

}  // namespace spineloft::io
