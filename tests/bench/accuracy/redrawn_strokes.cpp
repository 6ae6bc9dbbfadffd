#include "tests/bench/accuracy/redrawn_strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/hash.h"
#include "engine/base/rng.h"
#include "engine/base/vec.h"

namespace spineloft::accuracy {
namespace {

constexpr int kPoints = 80;
constexpr double kCarefulWander = 0.03, kSloppyWander = 0.12, kTremor = 0.01;  // shares of the local width
constexpr double kAside = 0.22, kAsideWander = 0.05;
constexpr double kMostShort = 0.25, kMostShortOfLine = 0.08;  // of the mean width, and of the line

/// The true middle line by arc length.
class Axis {
 public:
  explicit Axis(std::span<const std::array<double, 3>> points) {
    for (const auto& [x, y, width] : points) {
      const PicturePoint at{x, y};
      if (!at_.empty() && distance(at_.back(), at) <= 0) continue;
      arc_.push_back(at_.empty() ? 0 : arc_.back() + distance(at_.back(), at));
      at_.push_back(at);
      width_.push_back(width);
    }
  }
  std::size_t size() const { return at_.size(); }
  double meanWidth() const {
    double sum = 0;
    for (const double width : width_) sum += width;
    return sum / static_cast<double>(width_.size());
  }
  /// Arc length of the point nearest to `p`.
  double arcNear(PicturePoint p) const {
    const auto nearer = [&](PicturePoint a, PicturePoint b) { return distance(a, p) < distance(b, p); };
    return arc_[static_cast<std::size_t>(std::ranges::min_element(at_, nearer) - at_.begin())];
  }
  /// The point `aside` local widths to the left at an arc length.
  PicturePoint beside(double arc, double aside) const {
    const std::size_t i = segmentAt(arc);
    const double t = (arc - arc_[i]) / (arc_[i + 1] - arc_[i]);
    const PicturePoint on = at_[i] + (at_[i + 1] - at_[i]) * t;
    // Over the local width, so that a bend of the middle line is no corner.
    const double width = width_[i] + (width_[i + 1] - width_[i]) * t;
    const PicturePoint way = normalized(at_[segmentAt(arc + width / 2) + 1] - at_[segmentAt(arc - width / 2)]);
    return on + PicturePoint{way.y, -way.x} * (aside * width);
  }

 private:
  std::size_t segmentAt(double arc) const {
    const auto after = std::ranges::upper_bound(arc_, arc);
    const auto i = static_cast<std::size_t>(after - arc_.begin());
    return std::clamp<std::size_t>(i, 1, at_.size() - 1) - 1;
  }
  std::vector<PicturePoint> at_;
  std::vector<double> arc_, width_;
};

/// A smooth line through lots of −1 … 1, over 0 … 1.
class Wander {
 public:
  Wander(int bends, Rng& rng) {
    for (int i = 0; i < bends + 3; ++i) lot_.push_back(rng.uniform(-1, 1));
  }
  double at(double share) const {
    const double x = share * static_cast<double>(lot_.size() - 3);
    const auto i = std::min(static_cast<std::size_t>(x), lot_.size() - 4);
    const double t = x - static_cast<double>(i), u = 1 - t;
    // The cubic B-spline's basis.
    return (u * u * u * lot_[i] + (3 * t * t * t - 6 * t * t + 4) * lot_[i + 1] +
            (3 * u * u * u - 6 * u * u + 4) * lot_[i + 2] + t * t * t * lot_[i + 3]) /
           6;
  }

 private:
  std::vector<double> lot_;
};

struct Hand {
  double aside = 0, wander = 0, tremor = 0;
};

std::vector<PicturePoint> drawn(const Axis& axis, double from, double to, const Hand& hand, Rng& rng) {
  const Wander wander(3 + static_cast<int>(rng.below(4)), rng);
  std::vector<PicturePoint> line;
  for (int i = 0; i < kPoints; ++i) {
    const double share = static_cast<double>(i) / (kPoints - 1);
    const double aside = hand.aside + hand.wander * wander.at(share) + hand.tremor * rng.uniform(-1, 1);
    line.push_back(axis.beside(from + (to - from) * share, aside));
  }
  return line;
}

}  // namespace

void redrawStrokes(io::BenchCase& one, std::uint64_t seed) {
  const auto strokeOf = [&](std::string_view name) {
    return std::ranges::find(one.strokes, name, [](const auto& stroke) -> const auto& { return stroke.first; });
  };
  const Axis axis(one.axis);
  const auto careful = strokeOf("careful");
  if (careful == one.strokes.end() || careful->second.empty() || axis.size() < 2) return;
  Hasher hasher;
  for (const char c : one.id) hasher.number(static_cast<unsigned char>(c));
  Rng rng(seed ^ hasher.value());
  const double first = axis.arcNear(careful->second.front()), last = axis.arcNear(careful->second.back());
  const double from = std::min(first, last), to = std::max(first, last);
  const double most = std::min(kMostShort * axis.meanWidth(), kMostShortOfLine * (to - from));
  const double side = rng.below(2) == 0 ? kAside : -kAside;
  const bool backwards = rng.below(2) == 0;
  const double startShort = rng.uniform(0, most), endShort = rng.uniform(0, most);
  const auto redraw = [&](std::string_view name, double start, double end, const Hand& hand) {
    const auto stroke = strokeOf(name);
    std::vector<PicturePoint> line = drawn(axis, start, end, hand, rng);
    if (stroke == one.strokes.end()) return;
    if (backwards) std::ranges::reverse(line);
    stroke->second = std::move(line);
  };
  redraw("careful", from, to, {0, kCarefulWander, 0});
  redraw("sloppy", from + startShort, to - endShort, {0, kSloppyWander, kTremor});
  redraw("offcentre", from, to, {side, kAsideWander, 0});
}

}  // namespace spineloft::accuracy
