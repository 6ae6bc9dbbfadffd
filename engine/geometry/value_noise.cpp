#include "engine/geometry/value_noise.h"

#include <cmath>
#include <initializer_list>

namespace spineloft::geometry {
namespace {

/// splitmix64's mixing (Steele, Lea, Flood 2014).
std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return z ^ (z >> 31);
}

/// The value at a point with whole coordinates, −1…1.
double valueAt(std::int64_t x, std::int64_t y, std::int64_t z, std::uint32_t seed) {
  constexpr std::uint64_t kStep = 0x9e3779b97f4a7c15ull;
  std::uint64_t state = mixed(seed + kStep);
  for (const std::int64_t place : {x, y, z}) state = mixed((state ^ static_cast<std::uint64_t>(place)) + kStep);
  return static_cast<double>(state >> 11) * 0x1.0p-52 - 1;
}

double eased(double t) { return t * t * (3 - 2 * t); }

}  // namespace

double valueNoise(ModelPoint at, std::uint32_t seed) {
  const double lowX = std::floor(at.x), lowY = std::floor(at.y), lowZ = std::floor(at.z);
  const double u = eased(at.x - lowX), v = eased(at.y - lowY), w = eased(at.z - lowZ);
  const auto x = static_cast<std::int64_t>(lowX), y = static_cast<std::int64_t>(lowY);
  const auto z = static_cast<std::int64_t>(lowZ);
  const auto between = [](double a, double b, double t) { return a + (b - a) * t; };
  const auto alongX = [&](std::int64_t j, std::int64_t k) {
    return between(valueAt(x, j, k, seed), valueAt(x + 1, j, k, seed), u);
  };
  const auto alongY = [&](std::int64_t k) { return between(alongX(y, k), alongX(y + 1, k), v); };
  return between(alongY(z), alongY(z + 1), w);
}

}  // namespace spineloft::geometry
