// A length in words.
#pragma once

#include <string>

namespace spineloft::app {

/// As people say it: "8 mm" below a centimetre, "4 cm", "12.5 cm", "1.2 m" from a metre on.
std::string spokenLength(double mm);
/// The same with the digits that matter at a glance: "10.1 cm".
std::string roundLength(double mm);

}  // namespace spineloft::app
