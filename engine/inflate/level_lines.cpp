// Lines of equal s in a mesh of fields.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "engine/inflate/fields.h"

namespace spineloft::inflate {
namespace {

using geometry::PlaneMesh;
constexpr std::uint32_t kNone = PlaneMesh::kNone;

/// Values along an edge from 0 to 1: the cubic with these values and slopes at its ends, kept monotone (Fritsch and
/// Carlson 1980), so that lines of several levels keep their order.
class Cubic {
 public:
  Cubic(double from, double to, double slopeFrom, double slopeTo) : from_(from), rise_(to - from) {
    const auto kept = [&](double slope) {
      constexpr double kMost = 3;
      return rise_ > 0 ? std::clamp(slope, 0.0, kMost * rise_) : std::clamp(slope, kMost * rise_, 0.0);
    };
    a_ = kept(slopeFrom);
    b_ = kept(slopeTo);
  }
  double operator()(double t) const {
    return from_ + t * (a_ + t * (3 * rise_ - 2 * a_ - b_ + t * (a_ + b_ - 2 * rise_)));
  }

 private:
  double from_, rise_, a_ = 0, b_ = 0;
};

/// Where a growing function is 0 between 0 and 1: false position, Illinois.
template <class Function>
double rootOf(const Function& f) {
  constexpr double kNear = 1e-9;
  constexpr int kMostSteps = 40;
  double low = 0, high = 1, atLow = f(low), atHigh = f(high);
  for (int step = 0, last = 0; step < kMostSteps && high - low > kNear; ++step) {
    const double t = atHigh > atLow ? (low * atHigh - high * atLow) / (atHigh - atLow) : (low + high) / 2;
    const double there = f(t);
    if (std::abs(there) < kNear) return t;
    if (there < 0) {
      low = t;
      atLow = there;
      if (last < 0) atHigh /= 2;
    } else {
      high = t;
      atHigh = there;
      if (last > 0) atLow /= 2;
    }
    last = there < 0 ? -1 : 1;
  }
  return (low + high) / 2;
}

/// How far s is over the sum of the slices' levels, at each point of a mesh; where that is on its edges.
class Above {
 public:
  Above(const Fields& fields, std::span<const double> levels) : fields_(fields) {
    constexpr double kMostLevel = 1 - 1e-9;  // the outline is above all lines
    above_.reserve(fields.s.size());
    for (std::size_t p = 0; p < fields.s.size(); ++p) {
      double level = 0;
      for (std::size_t k = 0; k < levels.size(); ++k) level += fields.over[p].share[k] * levels[k];
      above_.push_back(fields.s[p] - std::min(level, kMostLevel));
    }
  }
  bool isHigh(std::uint32_t p) const { return above_[p] >= 0; }
  /// Where the line passes an edge from a point below it to one above: s and H are cubic along it, or s linear.
  LevelPoint between(std::uint32_t low, std::uint32_t up) const {
    const LevelPoint one = levelPointOf(fields_, low), other = levelPointOf(fields_, up);
    if (fields_.rise.empty()) return lerp(one, other, above_[low] / (above_[low] - above_[up]));
    const double first = fields_.s[low] - above_[low], last = fields_.s[up] - above_[up];
    const Cubic s = along(low, up);
    const double share = rootOf([&](double t) { return s(t) - std::lerp(first, last, t); });
    LevelPoint out = lerp(one, other, share);
    const SectionPoint way = other.at - one.at;
    out.half = Cubic(one.half, other.half, dot(fields_.widening[low], way), dot(fields_.widening[up], way))(share);
    return out;
  }

 private:
  /// At the rim and the skeleton, where s has a crease, it is a parabola.
  Cubic along(std::uint32_t low, std::uint32_t up) const {
    const SectionPoint way = fields_.mesh.points()[up] - fields_.mesh.points()[low];
    const double climb = fields_.s[up] - fields_.s[low];
    const auto isCrease = [&](std::uint32_t p) { return p < fields_.mesh.rim() || fields_.onBone[p]; };
    const bool lowFree = isCrease(low), upFree = isCrease(up);
    double atLow = lowFree ? climb : dot(fields_.rise[low], way), atUp = upFree ? climb : dot(fields_.rise[up], way);
    if (upFree && !lowFree) atUp = 2 * climb - atLow;
    if (lowFree && !upFree) atLow = 2 * climb - atUp;
    return {fields_.s[low], fields_.s[up], atLow, atUp};
  }

  const Fields& fields_;
  std::vector<double> above_;
};

}  // namespace

LevelPoint lerp(const LevelPoint& a, const LevelPoint& b, double t) {
  return {lerp(a.at, b.at, t), std::lerp(a.half, b.half, t), lerp(a.over, b.over, t), std::lerp(a.away, b.away, t)};
}

LevelPoint levelPointOf(const Fields& fields, std::uint32_t p) {
  return {fields.mesh.points()[p], fields.half[p], fields.over[p], fields.away[p]};
}

std::vector<LevelLine> levelLines(const Fields& fields, std::span<const double> levels) {
  const PlaneMesh& mesh = fields.mesh;
  const auto triangles = static_cast<std::uint32_t>(mesh.triangles().size());
  const Above above(fields, levels);
  // The line leaves a triangle where an edge rises, with what is higher on its left.
  const auto wayOut = [&](std::uint32_t t) {
    for (std::uint32_t h = 3 * t; h < 3 * t + 3; ++h) {
      if (!above.isHigh(mesh.triangles()[t][h % 3]) && above.isHigh(mesh.triangles()[t][(h + 1) % 3])) return h;
    }
    return kNone;
  };
  std::vector<char> passed(triangles, 0);
  std::vector<LevelLine> lines;
  for (std::uint32_t start = 0; start < triangles; ++start) {
    if (passed[start] || wayOut(start) == kNone) continue;
    LevelLine& line = lines.emplace_back();
    line.side = fields.side[start];
    std::uint32_t t = start;
    while (t != kNone && !passed[t]) {
      passed[t] = 1;
      const std::uint32_t out = wayOut(t);
      line.points.push_back(above.between(mesh.triangles()[t][out % 3], mesh.triangles()[t][(out + 1) % 3]));
      t = mesh.twin(out) == kNone ? kNone : mesh.twin(out) / 3;
    }
  }
  return lines;
}

}  // namespace spineloft::inflate
