// Numbers of sliders in the visitor's language.
#pragma once

#include <string>
#include <string_view>

namespace spineloft::panels {

/// A text such as "{n} mm" with `value` rounded to so many digits behind the point, in the place of a format of
/// Dear ImGui.
std::string numberText(std::string_view text, double value, int digits);

}  // namespace spineloft::panels
