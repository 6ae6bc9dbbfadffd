#pragma once
#include <cstdlib>
namespace spineloft::ribs {
inline double tune(const char* name, double value) {
  const char* text = std::getenv(name);
  return text ? std::atof(text) : value;
}
}
#define TUNE(n, v) ([]() { static const auto t = static_cast<decltype(v)>(::spineloft::ribs::tune(n, v)); return t; }())
