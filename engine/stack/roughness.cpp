#include "engine/stack/roughness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/value_noise.h"

namespace spineloft::stack {
namespace {

using Points = std::vector<SectionPoint>;

double areaOf(std::span<const SectionPoint> curve) { return geometry::signedArea(curve); }

/// Outward directions at the points of a counter-clockwise closed curve, across the chord from `reach` before a point
/// to `reach` after it: so points that are close have nearly the same ones, corners too, and keep their order when
/// moved by as much.
Points outwardsOf(std::span<const SectionPoint> curve, double reach) {
  Points closed(curve.begin(), curve.end()), out;
  closed.push_back(closed.front());
  const std::vector<double> along = geometry::arcLengths(std::span<const SectionPoint>(closed));
  const double length = along.back();
  const auto at = [&](double s) {
    return geometry::pointAt(std::span<const SectionPoint>(closed), std::span<const double>(along),
                             s < 0        ? s + length
                             : s > length ? s - length
                                          : s);
  };
  for (std::size_t k = 0; k < curve.size(); ++k) {
    const SectionPoint chord = normalized(at(along[k] + reach) - at(along[k] - reach));
    out.push_back({chord.y, -chord.x});
  }
  return out;
}

/// Whether curves are still apart and about as large as they were.
bool isSound(const Points& moved, const Points& before, std::span<const std::size_t> sizes) {
  constexpr double kLeast = 0.25;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    const auto part = [&](const Points& of) { return std::span<const SectionPoint>(of).subspan(first, size); };
    if (!(areaOf(part(moved)) > kLeast * areaOf(part(before)))) return false;
    first += size;
  }
  return geometry::areSimple(moved, sizes);
}

}  // namespace

bool Roughness::move(Points& figure, std::span<const std::size_t> sizes, std::span<const ModelPoint> places,
                     double share) const {
  constexpr double kLeastReach = 0.02;  // of the radius: about half the way from point to point
  Points moved = figure;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    const auto curve = std::span<const SectionPoint>(figure).subspan(first, size);
    const double radius = std::sqrt(std::max(0.0, areaOf(curve)) / std::numbers::pi);
    const double most = std::min(rough_.amount * share, radius);
    const Points outwards = outwardsOf(curve, std::max(most, kLeastReach * radius));
    for (std::size_t k = 0; k < size; ++k) {
      const double noise = geometry::valueNoise(places[first + k] / rough_.size, rough_.seed);
      moved[first + k] += outwards[k] * (most * noise);
    }
    first += size;
  }
  if (!isSound(moved, figure, sizes)) return false;
  figure = std::move(moved);
  return true;
}

double Roughness::shareAt(double away) const {
  if (!rough_.keepDrawn) return 1;
  const double t = std::min(1.0, away / rough_.size);
  return t * t * (3 - 2 * t);
}

int Roughness::rowsOf(double length) const {
  constexpr double kRowsABump = 8, kMost = 1e5;
  return any() ? static_cast<int>(std::clamp(std::ceil(length * kRowsABump / rough_.size), 1.0, kMost)) : 1;
}

bool Roughness::moveRings(const Sheets& sheets, Network& network) const {
  if (!any() || rough_.keepDrawn) return true;
  std::vector<Drawn>& curves = network.curves;
  for (std::size_t from = 0, to = 0; from < curves.size(); from = to) {
    const std::size_t sheet = curves[from].sheet;
    Points figure;
    std::vector<std::size_t> sizes;
    std::vector<ModelPoint> places;
    for (; to < curves.size() && curves[to].sheet == sheet; ++to) {
      for (const SectionPoint p : curves[to].ring) {
        figure.push_back(p);
        places.push_back(sheets.all[sheet].stand.at(p));
      }
      sizes.push_back(curves[to].ring.size());
    }
    if (!move(figure, sizes, places)) return false;
    auto next = figure.begin();
    for (std::size_t i = from; i < to; ++i) {
      std::copy_n(next, curves[i].ring.size(), curves[i].ring.begin());
      next += static_cast<std::ptrdiff_t>(curves[i].ring.size());
    }
  }
  return true;
}

}  // namespace spineloft::stack
