#include "web/model/spoken_length.h"

#include <string>

namespace spineloft::app {
namespace {

/// Without zeros at its end.
std::string plainNumber(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  std::string out = text;
  if (out.find('.') == std::string::npos) return out;
  while (out.back() == '0') out.pop_back();
  if (out.back() == '.') out.pop_back();
  return out;
}

}  // namespace

std::string spokenLength(double mm) {
  if (mm >= 1000) return plainNumber(mm / 1000, 4) + " m";
  if (mm >= 10) return plainNumber(mm / 10, 3) + " cm";
  return plainNumber(mm, 2) + " mm";
}

}  // namespace spineloft::app
