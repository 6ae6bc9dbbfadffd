#include "engine/publish/line_fit.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "engine/geometry/polyline.h"
#include "engine/geometry/stroke_line.h"

namespace spineloft::publish {
namespace {

using Points = std::vector<PicturePoint>;

/// So often the points are moved.
constexpr int kSteps = 6;
/// What begins, length and headings count that change, beside the squares of what the spine is off.
constexpr double kDamping = 0.003;
/// It is divided and multiplied by these where a step leads nearer or not (Levenberg and Marquardt).
constexpr double kLess = 2, kMore = 8;
constexpr double kLeastPivot = 1e-12;

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

/// A line of even steps: where it begins, how long each step is, where each leads to.
struct EvenSteps {
  PicturePoint begin;
  double length = 0;
  std::vector<double> headings;
  explicit EvenSteps(const Points& points) : begin(points.front()) {
    for (std::size_t i = 1; i < points.size(); ++i) {
      const PicturePoint step = points[i] - points[i - 1];
      length += norm(step) / static_cast<double>(points.size() - 1);
      headings.push_back(std::atan2(step.y, step.x));
    }
  }
  PicturePoint ahead(std::size_t step) const { return {std::cos(headings[step]), std::sin(headings[step])}; }
  Points points() const {
    Points out{begin};
    for (std::size_t i = 0; i < headings.size(); ++i) out.push_back(out.back() + ahead(i) * length);
    return out;
  }
};

/// How the spine moves while the line begins elsewhere (x, y), while all its steps get longer together by a pixel, and
/// while each leads a pixel more to its side.
std::vector<Points> movesOf(const EvenSteps& line, const LineFit& fit) {
  const std::size_t rows = fit.off.size();
  std::vector<Points> out(3 + line.headings.size(), Points(rows));
  const auto add = [&](Points& to, const Points& moves, double share) {
    for (std::size_t i = 0; i < rows; ++i) to[i] += moves[i] * share;
  };
  Points ofX(rows), ofY(rows);  // of all points from one on
  const double share = 1 / static_cast<double>(line.headings.size());
  for (std::size_t j = fit.points.size(); j-- > 0;) {
    add(ofX, fit.moves[2 * j], 1);
    add(ofY, fit.moves[2 * j + 1], 1);
    if (j == 0) continue;
    const PicturePoint ahead = line.ahead(j - 1);
    add(out[2 + j], ofX, -ahead.y);
    add(out[2 + j], ofY, ahead.x);
    add(out[2], ofX, ahead.x * share);
    add(out[2], ofY, ahead.y * share);
  }
  out[0] = std::move(ofX);
  out[1] = std::move(ofY);
  return out;
}

/// Solves a symmetric positive definite system in place (Cholesky).
void solve(std::vector<std::vector<double>>& a, std::vector<double>& b) {
  const std::size_t n = b.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = a[i][j];
      for (std::size_t k = 0; k < j; ++k) sum -= a[i][k] * a[j][k];
      a[i][j] = i == j ? std::sqrt(std::max(sum, kLeastPivot)) : sum / a[j][j];
    }
    for (std::size_t k = 0; k < i; ++k) b[i] -= a[i][k] * b[k];
    b[i] /= a[i][i];
  }
  for (std::size_t i = n; i-- > 0;) {
    for (std::size_t k = i + 1; k < n; ++k) b[i] -= a[k][i] * b[k];
    b[i] /= a[i][i];
  }
}

/// Moves the points to where the spine is nearest, if it moves as `moves` says and headings change little.
void moveNearest(LineFit& fit, double damping) {
  EvenSteps line(fit.points);
  const std::vector<Points> moves = movesOf(line, fit);
  const std::size_t unknowns = moves.size();
  std::vector<std::vector<double>> squares(unknowns, std::vector<double>(unknowns));
  std::vector<double> change(unknowns);
  const auto product = [](const Points& p, const Points& q) {
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) sum += dot(p[i], q[i]);
    return sum;
  };
  for (std::size_t i = 0; i < unknowns; ++i) {
    for (std::size_t j = 0; j <= i; ++j) squares[i][j] = product(moves[i], moves[j]);
    squares[i][i] += damping;
    change[i] = -product(moves[i], fit.off);
  }
  solve(squares, change);
  line.begin += {change[0], change[1]};
  for (std::size_t k = 0; k < line.headings.size(); ++k) line.headings[k] += change[3 + k] / line.length;
  line.length += change[2] / static_cast<double>(line.headings.size());
  fit.points = line.points();
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
  fit.points = EvenSteps(geometry::resample(std::span(wanted.points), count)).points();
  findOff(fit, wanted.points, clean);
  findMoves(fit, wanted.points, clean);
  double damping = kDamping;
  for (int step = 0; step < kSteps; ++step) {
    LineFit moved = fit;
    moveNearest(moved, damping);
    findOff(moved, wanted.points, clean);
    if (farthest(moved.off) < farthest(fit.off)) {
      fit = std::move(moved);
      if (step + 1 < kSteps) findMoves(fit, wanted.points, clean);
      damping /= kLess;
    } else {
      damping *= kMore;
    }
  }
  return fit;
}

}  // namespace spineloft::publish
