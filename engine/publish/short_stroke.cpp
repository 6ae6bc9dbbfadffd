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
constexpr std::array<std::size_t, 26> kCounts = {2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14,
                                                 15, 16, 18, 20, 22, 24, 27, 30, 34, 37, 41, 45, 50};
/// Grids that are tried, in steps of the text's own.
constexpr std::array<double, 4> kGrids = {8, 4, 2, 1};
/// A quarter of a pixel of a picture of 1024 pixels, in steps of the text's grid.
constexpr double kMostOff = 1;
/// Lines are looked for within this share of it: their spines are foretold, and found a bit elsewhere.
constexpr double kAimed = 0.95;
/// What LineGrid::rough is, in steps of the text's grid: which is best depends on how far the ribs reach.
constexpr std::array<double, 3> kRough = {0.15, 0.2, 0.3};
/// So many of the cheapest lines of each are cleaned and told.
constexpr std::size_t kTold = 8;
/// More points are tried while the cheapest line takes at most so many times what the cheapest of all takes.
constexpr double kWorthMore = 1.4;

/// The largest distance between points of the same number; none where the numbers differ.
std::optional<double> apart(const ribs::Spine& a, const ribs::Spine& b) {
  if (a.points.size() != b.points.size()) return std::nullopt;
  double most = 0;
  for (std::size_t i = 0; i < a.points.size(); ++i) most = std::max(most, distance(a.points[i], b.points[i]));
  return most;
}

/// Lines whose spines are to be within kMostOff of the wanted one, for each of kRough the cheapest first.
class Lines {
 public:
  Lines(const ribs::Spine& wanted, double smoothness, double step);
  const std::vector<GridLine>& of(std::size_t rough) const { return lines_[rough]; }

 private:
  /// The cost of the cheapest one; none where there is none.
  std::optional<double> add(const LineFit& fit, double step);
  std::array<std::vector<GridLine>, kRough.size()> lines_;
};

std::optional<double> Lines::add(const LineFit& fit, double step) {
  std::optional<double> cheapest;
  for (std::size_t rough = 0; rough < kRough.size(); ++rough) {
    for (const double grid : kGrids) {
      for (const std::size_t mode : io::kLineModes) {
        const LineGrid on{grid * step, kAimed * kMostOff * step, kRough[rough] * step};
        auto line = lineOnGrid(fit, on, io::kModes[mode].bend);
        if (!line) continue;
        if (rough == 0) cheapest = std::min(line->cost, cheapest.value_or(line->cost));
        lines_[rough].push_back(*std::move(line));
      }
    }
  }
  return cheapest;
}

Lines::Lines(const ribs::Spine& wanted, double smoothness, double step) {
  std::optional<double> least;
  const double most = kMostOff * step;
  const auto isFar = [&](std::size_t count) { return farthest(fitLine(wanted, count, smoothness).off) > most; };
  for (auto count = std::ranges::partition_point(kCounts, isFar); count != kCounts.end(); ++count) {
    const LineFit fit = fitLine(wanted, *count, smoothness);
    if (farthest(fit.off) > most) continue;
    const std::optional<double> cheapest = add(fit, step);
    if (!cheapest) continue;
    least = std::min(*cheapest, least.value_or(*cheapest));
    if (*cheapest > kWorthMore * *least) break;
  }
  for (std::vector<GridLine>& lines : lines_) std::ranges::sort(lines, {}, &GridLine::cost);
}

}  // namespace

StrokeAndSpine shortStroke(const StrokeAndSpine& given, image::Size picture, const ribs::SpineParams& params,
                           const TextLength& lengthOf) {
  const ribs::Spine& wanted = given.spine;
  const double step = io::shareStep(picture);
  std::optional<StrokeAndSpine> best;
  std::size_t least = 0;
  const auto tell = [&](const GridLine& line) {
    std::vector<PicturePoint> stroke = io::keptLine(line.points, picture);
    Result<ribs::Spine> got = ribs::cleanSpine(stroke, picture, params);
    const std::optional<double> off = got ? apart(wanted, got.value()) : std::nullopt;
    if (!off || *off > kMostOff * step) return false;
    StrokeAndSpine found{std::move(stroke), std::move(got).value()};
    const std::size_t length = lengthOf(found);
    if (best && length >= least) return true;
    best = std::move(found);
    least = length;
    return true;
  };
  if (wanted.points.size() >= 2) {
    const Lines lines(wanted, params.smoothness, step);
    for (std::size_t rough = 0; rough < kRough.size(); ++rough) {
      std::size_t told = 0;
      for (auto line = lines.of(rough).begin(); line != lines.of(rough).end() && told < kTold; ++line)
        told += tell(*line) ? 1 : 0;
    }
  }
  if (best) return *std::move(best);
  std::vector<PicturePoint> whole = io::keptLine(given.stroke, picture);
  Result<ribs::Spine> got = ribs::cleanSpine(whole, picture, params);
  if (got && apart(wanted, got.value())) return {std::move(whole), std::move(got).value()};
  return given;
}

}  // namespace spineloft::publish
