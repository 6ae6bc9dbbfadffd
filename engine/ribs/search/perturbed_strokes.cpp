#include "engine/ribs/search/perturbed_strokes.h"

#include <algorithm>

#include "engine/geometry/polyline.h"

namespace spineloft::ribs {
namespace {

// Ribs wider than this multiple of the median count as that wide.
constexpr double kWidest = 2;
// A shortened stroke keeps at least this share of its length at either end.
constexpr double kMostCut = 0.15;
// Over this share of the ribs on either side is the width averaged, and the direction in which a stroke ends.
constexpr double kAround = 0.1;

int countOf(const RibSet& part) { return static_cast<int>(part.ribs.size()); }
std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Means over up to `reach` values on either side.
std::vector<double> runningMean(const std::vector<double>& values, int reach) {
  const int count = static_cast<int>(values.size());
  std::vector<double> sums{0}, means;
  for (double value : values) sums.push_back(sums.back() + value);
  for (int i = 0; i < count; ++i) {
    const int from = std::max(0, i - reach), to = std::min(count, i + reach + 1);
    means.push_back((sums[index(to)] - sums[index(from)]) / (to - from));
  }
  return means;
}

double usualWidth(std::vector<double> widths) {
  const auto middle = widths.begin() + static_cast<std::ptrdiff_t>(widths.size() / 2);
  std::nth_element(widths.begin(), middle, widths.end());
  return *middle;
}

std::vector<PicturePoint> longerBy(double more, std::vector<PicturePoint> stroke) {
  const auto reach = std::max<std::size_t>(1, static_cast<std::size_t>(kAround * static_cast<double>(stroke.size())));
  const std::size_t last = stroke.size() - 1;
  const PicturePoint before = stroke.front() + normalized(stroke.front() - stroke[reach]) * more;
  const PicturePoint behind = stroke.back() + normalized(stroke.back() - stroke[last - reach]) * more;
  stroke.insert(stroke.begin(), before);
  stroke.push_back(behind);
  return stroke;
}

std::vector<PicturePoint> shorterBy(double less, const std::vector<PicturePoint>& stroke) {
  const std::span<const PicturePoint> points = stroke;
  const std::vector<double> s = geometry::arcLengths(points);
  const double cut = std::min(less, kMostCut * s.back());
  std::vector<PicturePoint> kept{geometry::pointAt(points, std::span<const double>(s), cut)};
  for (std::size_t i = 0; i < stroke.size(); ++i)
    if (s[i] > cut && s[i] < s.back() - cut) kept.push_back(stroke[i]);
  kept.push_back(geometry::pointAt(points, std::span<const double>(s), s.back() - cut));
  return kept;
}

}  // namespace

std::vector<PicturePoint> strokeOf(const PerturbedStroke& hand, const RibSet& part) {
  const int count = countOf(part), around = std::max(1, static_cast<int>(kAround * count));
  std::vector<double> widths;
  for (const Rib& rib : part.ribs) widths.push_back(distance(rib.left, rib.right));
  const double usual = usualWidth(widths);
  for (double& width : widths) width = std::min(width, kWidest * usual);
  // Twice, for a line without kinks.
  widths = runningMean(runningMean(widths, around), around);
  std::vector<PicturePoint> stroke;
  for (int i = 0; i < count; ++i) {
    const PicturePoint along =
        normalized(part.ribs[index(std::min(count - 1, i + 2))].center - part.ribs[index(std::max(0, i - 2))].center);
    const PicturePoint left{along.y, -along.x};
    stroke.push_back(part.ribs[index(i)].center + left * (hand.aside * widths[index(i)]));
  }
  if (hand.longer > 0) return longerBy(hand.longer * usual, std::move(stroke));
  if (hand.longer < 0) return shorterBy(-hand.longer * usual, stroke);
  return stroke;
}

}  // namespace spineloft::ribs
