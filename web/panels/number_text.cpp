#include "web/panels/number_text.h"

#include <cmath>

#include "web/words/words.h"

namespace spineloft::panels {

std::string numberText(std::string_view text, double value, int digits) {
  const double scale = std::pow(10, digits);
  const std::string_view shown = words::drawn(words::tr(text, {{"n", std::round(value * scale) / scale + 0.0}}));
  std::string out;
  for (const char c : shown) out.append(c == '%' ? 2 : 1, c);
  return out;
}

}  // namespace spineloft::panels
