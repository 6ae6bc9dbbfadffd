#include "web/model/spoken_length.h"

#include <algorithm>
#include <cstdio>
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

std::string lengthWith(double mm, int digits) {
  if (mm >= 1000) return plainNumber(mm / 1000, digits + 2) + " m";
  if (mm >= 10) return plainNumber(mm / 10, digits + 1) + " cm";
  return plainNumber(mm, std::max(1, digits)) + " mm";
}

}  // namespace

std::string spokenLength(double mm) { return lengthWith(mm, 2); }
std::string roundLength(double mm) { return lengthWith(mm, 0); }

}  // namespace spineloft::app
