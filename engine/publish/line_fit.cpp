#include "engine/publish/line_fit.h"

#include <algorithm>
#include <span>

#include "engine/geometry/polyline.h"
#include "engine/geometry/stroke_line.h"

namespace spineloft::publish {
namespace {

using Points = std::vector<PicturePoint>;

/// So often the points are moved, and by so many rounds of conjugate gradients.
constexpr int kSteps = 3, kRounds = 20;
/// Squared gradients below this, square pixels, are none.
constexpr double kNoGradient = 1e-9;

/// The spine of a stroke that has nothing to mend.
class Cleaning {
 public:
  Cleaning(std::size_t ribs, double smoothness) : ribs_(ribs), smoothness_(smoothness) {}
  void operator()(const Points& stroke, Points& spine) {
    line_ = stroke;
    geometry::spreadEvenly(line_, geometry::kStrokePoints, memory_);
    geometry::smoothWobble(line_, smoothness_, memory_);
    geometry::resample(std::span<const PicturePoint>(line_), ribs_, memory_.lengths, spine);
  }

 private:
  std::size_t ribs_;
  double smoothness_;
  geometry::StrokeMemory memory_;
  Points line_;
};

double& coordinate(Points& points, std::size_t i) { return i % 2 == 0 ? points[i / 2].x : points[i / 2].y; }

void findOff(LineFit& fit, const Points& wanted, Cleaning& clean) {
  clean(fit.points, fit.off);
  for (std::size_t i = 0; i < wanted.size(); ++i) fit.off[i] = fit.off[i] - wanted[i];
}

/// `off` is known.
void findMoves(LineFit& fit, const Points& wanted, Cleaning& clean) {
  fit.moves.resize(2 * fit.points.size());
  Points points = fit.points;
  for (std::size_t k = 0; k < fit.moves.size(); ++k) {
    double& value = coordinate(points, k);
    const double before = value;
    value += 1;
    clean(points, fit.moves[k]);
    value = before;
    for (std::size_t i = 0; i < wanted.size(); ++i) fit.moves[k][i] = fit.moves[k][i] - wanted[i] - fit.off[i];
  }
}

double squared(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum;
}

/// Moves the points to where the spine is nearest, if it moves as `moves` says.
void moveNearest(LineFit& fit) {
  const std::size_t unknowns = fit.moves.size(), rows = fit.off.size();
  Points left = fit.off, change(rows);
  std::vector<double> gradient(unknowns);
  const auto findGradient = [&] {
    for (std::size_t k = 0; k < unknowns; ++k) {
      gradient[k] = 0;
      for (std::size_t i = 0; i < rows; ++i) gradient[k] -= dot(fit.moves[k][i], left[i]);
    }
  };
  findGradient();
  std::vector<double> direction = gradient;
  double size = squared(gradient);
  for (int round = 0; round < kRounds && size > kNoGradient; ++round) {
    std::ranges::fill(change, PicturePoint{});
    for (std::size_t k = 0; k < unknowns; ++k) {
      for (std::size_t i = 0; i < rows; ++i) change[i] += fit.moves[k][i] * direction[k];
    }
    double length = 0;
    for (const PicturePoint c : change) length += dot(c, c);
    if (!(length > 0)) return;
    const double step = size / length;
    for (std::size_t k = 0; k < unknowns; ++k) coordinate(fit.points, k) += step * direction[k];
    for (std::size_t i = 0; i < rows; ++i) left[i] += change[i] * step;
    findGradient();
    const double next = squared(gradient);
    for (std::size_t k = 0; k < unknowns; ++k) direction[k] = gradient[k] + direction[k] * (next / size);
    size = next;
  }
}

}  // namespace

double farthest(const Points& off) {
  double most = 0;
  for (const PicturePoint p : off) most = std::max(most, norm(p));
  return most;
}

LineFit fitLine(const ribs::Spine& wanted, std::size_t count, double smoothness) {
  Cleaning clean(wanted.points.size(), smoothness);
  LineFit fit;
  fit.points = geometry::resample(std::span(wanted.points), count);
  findOff(fit, wanted.points, clean);
  findMoves(fit, wanted.points, clean);
  for (int step = 0; step < kSteps; ++step) {
    LineFit moved = fit;
    moveNearest(moved);
    findOff(moved, wanted.points, clean);
    if (!(farthest(moved.off) < farthest(fit.off))) break;
    fit = std::move(moved);
  }
  return fit;
}

}  // namespace spineloft::publish
