#include "engine/publish/short_stroke.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/geometry/polyline.h"
#include "engine/io/share_text.h"

namespace spineloft::publish {
namespace {

/// Numbers of points that are tried, fewest first.
constexpr std::array<std::size_t, 19> kCounts = {2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14, 16, 19, 22, 26, 31, 37, 44, 53};
/// Grids that are tried, in steps of the text's own.
constexpr std::array<double, 4> kGrids = {8, 4, 2, 1};
/// What stands besides is not asked for where even so many tenths of the best one so far would be too much.
constexpr std::size_t kSparedBesides = 8;
/// One pixel of a picture of 1024 pixels, in steps of the text's grid.
constexpr double kMostOff = 4;
/// Cleaning rounds bends; so often the points are moved against it.
constexpr int kRounds = 4;

/// The largest distance between points of the same number; none where the numbers differ.
std::optional<double> apart(const ribs::Spine& a, const ribs::Spine& b) {
  if (a.points.size() != b.points.size()) return std::nullopt;
  double most = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) most = std::max(most, distance(a.points[i], b.points[i]));
  return most;
}

/// `points` moved by how far the spine that they give is from `wanted` beside each.
void moveAgainst(std::vector<PicturePoint>& points, const ribs::Spine& wanted, const ribs::Spine& got) {
  const double last = static_cast<double>(wanted.points.size() - 1);
  for (std::size_t j = 0; j < points.size(); ++j) {
    const double at = last * static_cast<double>(j) / static_cast<double>(points.size() - 1);
    const auto i = static_cast<std::size_t>(std::lround(at));
    points[j] += wanted.points[i] - got.points[i];
  }
}

/// `count` points on a grid of `step` that give the wanted spine; none where they do not.
std::optional<StrokeAndSpine> strokeOn(double step, std::size_t count, const ribs::Spine& wanted, image::Size picture,
                                       const ribs::SpineParams& params) {
  std::vector<PicturePoint> points = geometry::resample(std::span(wanted.points), count);
  for (int round = 0; round < kRounds; ++round) {
    std::vector<PicturePoint> stroke = points;
    for (PicturePoint& p : stroke) p = {std::round(p.x / step) * step, std::round(p.y / step) * step};
    stroke = io::keptLine(stroke, picture);
    Result<ribs::Spine> got = ribs::cleanSpine(stroke, picture, params);
    const std::optional<double> off = got ? apart(wanted, got.value()) : std::nullopt;
    if (!off) break;
    if (*off <= kMostOff * io::shareStep(picture)) return StrokeAndSpine{std::move(stroke), std::move(got).value()};
    moveAgainst(points, wanted, got.value());
  }
  return std::nullopt;
}

}  // namespace

StrokeAndSpine shortStroke(const StrokeAndSpine& given, image::Size picture, const ribs::SpineParams& params,
                           const CostBesides& besides) {
  const ribs::Spine& wanted = given.spine;
  std::vector<PicturePoint> whole = io::keptLine(given.stroke, picture);
  std::optional<StrokeAndSpine> best;
  std::size_t least = 0, leastBesides = 0;
  for (const std::size_t count : kCounts) {
    if (wanted.points.size() < 2) break;
    for (const double steps : kGrids) {
      auto found = strokeOn(steps * io::shareStep(picture), count, wanted, picture, params);
      if (!found) continue;
      const std::size_t line = io::lineCost(found->stroke, picture);
      if (best && line + leastBesides * kSparedBesides / 10 >= least) continue;
      const std::size_t other = besides(*found);
      if (best && line + other >= least) continue;
      best = std::move(found);
      least = line + other;
      leastBesides = other;
    }
  }
  if (best) return *std::move(best);
  Result<ribs::Spine> got = ribs::cleanSpine(whole, picture, params);
  if (got && apart(wanted, got.value())) return {std::move(whole), std::move(got).value()};
  return given;
}

}  // namespace spineloft::publish
