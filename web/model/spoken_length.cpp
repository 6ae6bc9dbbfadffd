#include "web/model/spoken_length.h"
#include "web/words/words.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace spineloft::app {
namespace {

std::string spoken(std::string_view text, double value, int digits) {
  const double scale = std::pow(10, digits);
  return std::string(words::tr(text, {{"n", std::round(value * scale) / scale}}));
}

std::string lengthWith(double mm, int digits) {
  if (mm >= 1000) return spoken("{n} m", mm / 1000, digits + 2);
  if (mm >= 10) return spoken("{n} cm", mm / 10, digits + 1);
  return spoken("{n} mm", mm, std::max(1, digits));
}

}  // namespace

std::string spokenLength(double mm) { return lengthWith(mm, 2); }
std::string roundLength(double mm) { return lengthWith(mm, 0); }

}  // namespace spineloft::app
