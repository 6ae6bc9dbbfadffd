#include "engine/publish/short_stroke.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "engine/io/foretold.h"
#include "engine/io/share_text.h"
#include "engine/publish/line_fit.h"
#include "engine/publish/line_on_grid.h"

namespace spineloft::publish {
namespace {

/// Numbers of points that are tried, fewest first.
constexpr std::array<std::size_t, 24> kCounts = {2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13,
                                                 14, 15, 16, 18, 20, 22, 24, 27, 30, 34, 39, 45};
/// Grids that are tried, in steps of the text's own.
constexpr std::array<double, 4> kGrids = {8, 4, 2, 1};
/// One pixel of a picture of 1024 pixels, in steps of the text's grid.
constexpr double kMostOff = 4;
/// Lines are looked for within this share of it: their spines are foretold, and found a bit elsewhere.
constexpr double kAimed = 0.95;
/// Rib ends are multiples of this, in steps of the text's grid.
constexpr double kEndSteps = 2;
/// So many of the cheapest lines are cleaned, and told with what stands besides.
constexpr std::size_t kTold = 10;
/// More points are tried while the cheapest line takes at most so many times what the cheapest of all takes.
constexpr double kWorthMore = 1.3;

/// The largest distance between points of the same number; none where the numbers differ.
std::optional<double> apart(const ribs::Spine& a, const ribs::Spine& b) {
  if (a.points.size() != b.points.size()) return std::nullopt;
  double most = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) most = std::max(most, distance(a.points[i], b.points[i]));
  return most;
}

/// Lines whose spines are to be within kMostOff of the wanted one, the cheapest first.
std::vector<GridLine> linesNear(const ribs::Spine& wanted, double smoothness, double step) {
  std::vector<GridLine> lines;
  double least = 0;
  const auto near = [&](std::size_t count) { return fitLine(wanted, count, smoothness); };
  const auto isFar = [&](std::size_t count) { return farthest(near(count).off) > kMostOff * step; };
  for (auto count = std::ranges::partition_point(kCounts, isFar); count != kCounts.end(); ++count) {
    const LineFit fit = near(*count);
    if (farthest(fit.off) > kMostOff * step) continue;
    double cheapest = 0;
    for (const double grid : kGrids) {
      for (const std::size_t mode : io::kLineModes) {
        auto line = lineOnGrid(fit, {grid * step, kAimed * kMostOff * step, kEndSteps * step}, io::kModes[mode]);
        if (!line) continue;
        if (cheapest == 0 || line->cost < cheapest) cheapest = line->cost;
        lines.push_back(*std::move(line));
      }
    }
    if (cheapest == 0) continue;
    if (least == 0 || cheapest < least) least = cheapest;
    if (cheapest > kWorthMore * least) break;
  }
  std::ranges::sort(lines, {}, &GridLine::cost);
  return lines;
}

}  // namespace

StrokeAndSpine shortStroke(const StrokeAndSpine& given, image::Size picture, const ribs::SpineParams& params,
                           const CostBesides& besides) {
  const ribs::Spine& wanted = given.spine;
  const double step = io::shareStep(picture);
  std::optional<StrokeAndSpine> best;
  std::size_t least = 0, told = 0;
  if (wanted.points.size() >= 2) {
    for (const GridLine& line : linesNear(wanted, params.smoothness, step)) {
      if (told == kTold) break;
      std::vector<PicturePoint> stroke = io::keptLine(line.points, picture);
      Result<ribs::Spine> got = ribs::cleanSpine(stroke, picture, params);
      const std::optional<double> off = got ? apart(wanted, got.value()) : std::nullopt;
      if (!off || *off > kMostOff * step) continue;
      StrokeAndSpine found{std::move(stroke), std::move(got).value()};
      const std::size_t cost = io::lineCost(found.stroke, picture) + besides(found);
      ++told;
      if (best && cost >= least) continue;
      best = std::move(found);
      least = cost;
    }
  }
  if (best) return *std::move(best);
  std::vector<PicturePoint> whole = io::keptLine(given.stroke, picture);
  Result<ribs::Spine> got = ribs::cleanSpine(whole, picture, params);
  if (got && apart(wanted, got.value())) return {std::move(whole), std::move(got).value()};
  return given;
}

}  // namespace spineloft::publish
