#include "engine/stack/cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <ranges>
#include <span>
#include <utility>

#include "engine/geometry/polygon.h"

namespace spineloft::stack {
namespace {

/// A branch as it is seen when cells are cut.
struct Branch {
  std::size_t index = 0;
  const Loop* loop = nullptr;
  ModelPoint centre;
  double size = 0;  ///< square root of its area
};

/// The angles under which a branch is seen from a point, from the way ahead towards some direction aside.
struct Interval {
  std::size_t branch = 0;  ///< in the list of the cell
  double low = std::numeric_limits<double>::infinity(), high = -low;
};

/// A point of a branch from where it is seen: along two directions in the plane, and ahead.
struct Seen {
  double x = 0, y = 0, ahead = 0;
};
std::vector<Seen> seenFrom(const Branch& branch, ModelPoint from, ModelPoint x, ModelPoint y, ModelPoint ahead) {
  std::vector<Seen> points;
  for (const ModelPoint& p : branch.loop->points) {
    points.push_back({dot(x, p - from), dot(y, p - from), dot(ahead, p - from)});
  }
  return points;
}

/// Towards x cos + y sin. Where all points lie ahead, an angle grows with its tangent, and only two are computed.
Interval intervalOf(std::span<const Seen> points, double cos, double sin) {
  Interval interval;
  const auto aside = [&](const Seen& p) { return p.x * cos + p.y * sin; };
  const auto take = [&](double angle) {
    interval.low = std::min(interval.low, angle);
    interval.high = std::max(interval.high, angle);
  };
  if (std::ranges::all_of(points, [](const Seen& p) { return p.ahead > 0; })) {
    const auto [least, most] =
        std::ranges::minmax(points | std::views::transform([&](const Seen& p) { return aside(p) / p.ahead; }));
    take(std::atan(least));
    take(std::atan(most));
  } else {
    for (const Seen& p : points) take(std::atan2(aside(p), p.ahead));
  }
  return interval;
}

/// Two groups of branches and the direction along which they lie beside each other.
struct Parting {
  ModelPoint aside;
  std::vector<std::size_t> first, second;  ///< in the list of the cell
};

/// The direction in the plane, and the place in the order along it, with the widest gap between angles.
Parting widestGap(const std::vector<Branch>& branches, ModelPoint centre, ModelPoint x, ModelPoint y) {
  constexpr int kDirections = 180;
  constexpr double kUneven = 0.1;
  double total = 0;
  std::vector<std::vector<Seen>> points;
  for (const Branch& branch : branches) {
    total += branch.size;
    points.push_back(seenFrom(branch, centre, x, y, cross(x, y)));
  }
  Parting best;
  double most = -std::numeric_limits<double>::infinity();
  for (int i = 0; i < kDirections; ++i) {
    const double angle = std::numbers::pi * i / kDirections;
    const double cos = std::cos(angle), sin = std::sin(angle);
    std::vector<Interval> order;
    for (std::size_t b = 0; b < branches.size(); ++b) {
      order.push_back(intervalOf(points[b], cos, sin));
      order.back().branch = b;
    }
    std::ranges::stable_sort(order, {}, [](const Interval& v) { return v.low + v.high; });
    double reached = -std::numeric_limits<double>::infinity(), size = 0;
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
      reached = std::max(reached, order[k].high);
      size += branches[order[k].branch].size;
      double next = std::numeric_limits<double>::infinity();
      for (std::size_t j = k + 1; j < order.size(); ++j) next = std::min(next, order[j].low);
      const double gap = next - reached, uneven = kUneven * std::abs(2 * size / total - 1);
      const double score = gap * (gap > 0 ? 1 - uneven : 1 + uneven);
      if (score <= most + 1e-12) continue;
      most = score;
      best = {x * cos + y * sin, {}, {}};
      for (std::size_t j = 0; j < order.size(); ++j) (j <= k ? best.first : best.second).push_back(order[j].branch);
    }
  }
  return best;
}

/// Where a loop is cut: two of its points.
struct Chord {
  std::size_t from = 0, to = 0;  ///< from < to
  bool firstInside = true;       ///< the stretch from → to is the side of the first group
};

/// The chord along `across` that leaves the share on the side of −aside, of those between points of the loop.
Chord chordOf(const std::vector<SectionPoint>& loop, double share) {
  // In coordinates (aside, along): the line x = d.
  const std::size_t n = loop.size();
  const double whole = std::abs(geometry::signedArea(std::span<const SectionPoint>(loop)));
  const auto areaFrom = [&](std::size_t i, std::size_t j) {  // of the stretch i → j and its chord
    double twice = 0;
    for (std::size_t k = i; k != j; k = (k + 1) % n) twice += cross(loop[k], loop[(k + 1) % n]);
    return (twice + cross(loop[j], loop[i])) / 2;
  };
  const auto [least, most] = std::ranges::minmax_element(loop, {}, &SectionPoint::x);
  double low = least->x, high = most->x;
  Chord best;
  for (int round = 0; round < 40; ++round) {
    const double d = (low + high) / 2;
    std::vector<std::pair<double, std::size_t>> crossings;  // place along the line, the nearer point of the edge
    for (std::size_t i = 0; i < n; ++i) {
      const SectionPoint a = loop[i], b = loop[(i + 1) % n];
      if ((a.x < d) == (b.x < d)) continue;
      const double t = (d - a.x) / (b.x - a.x);
      crossings.push_back({a.y + (b.y - a.y) * t, t < 0.5 ? i : (i + 1) % n});
    }
    std::ranges::sort(crossings);
    double nearest = std::numeric_limits<double>::infinity(), got = 0;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
      const std::size_t a = std::min(crossings[k].second, crossings[k + 1].second);
      const std::size_t b = std::max(crossings[k].second, crossings[k + 1].second);
      if (b - a < 2 || a + n - b < 2) continue;
      double meanX = 0;
      for (std::size_t i = a; i <= b; ++i) meanX += loop[i].x;
      const bool inside = meanX / static_cast<double>(b - a + 1) < d;
      const double area = std::abs(inside ? areaFrom(a, b) : areaFrom(b, a)) / whole;
      if (std::abs(area - share) >= nearest) continue;
      nearest = std::abs(area - share);
      got = area;
      best = {a, b, inside};
    }
    if (nearest == std::numeric_limits<double>::infinity()) {  // a tip too narrow to be cut
      (d < (least->x + most->x) / 2 ? low : high) = d;
      continue;
    }
    (got < share ? low : high) = d;
  }
  if (best.to - best.from < 2) best = {0, n / 2, true};
  return best;
}

/// How far a cut rises at least and at most.
constexpr double kLowest = 0.05, kHighest = 0.95;

class Cutter {
 public:
  Cutter(const Loop& stem, Skin& skin) : stem_(stem), skin_(skin) {}

  Cells cells;

  void cut(Cell cell, std::vector<Branch> branches) {
    if (branches.size() == 1) {
      cell.branch = branches.front().index;
      cells.all.push_back(std::move(cell));
      return;
    }
    const ModelPoint w = stem_.normal;
    const ModelPoint some = std::abs(w.x) < 0.7 ? ModelPoint{1, 0, 0} : ModelPoint{0, 1, 0};
    const ModelPoint x = normalized(some - w * dot(some, w)), y = cross(w, x);
    const ModelPoint centre = middleOf(cell.points);
    const Parting parting = widestGap(branches, centre, x, y);
    double first = 0, all = 0;
    for (const Branch& branch : branches) all += branch.size;
    for (const std::size_t b : parting.first) first += branches[b].size;
    const ModelPoint along = cross(w, parting.aside);
    std::vector<SectionPoint> flat;
    for (const ModelPoint& p : cell.points) flat.push_back({dot(p - centre, parting.aside), dot(p - centre, along)});
    constexpr double kLeastShare = 0.12;
    split(std::move(cell), branches, parting, chordOf(flat, std::clamp(first / all, kLeastShare, 1 - kLeastShare)));
  }

 private:
  /// Cuts a cell along a chord into two.
  void split(Cell cell, const std::vector<Branch>& branches, const Parting& parting, const Chord& chord) {
    const ModelPoint a = cell.points[chord.from], b = cell.points[chord.to], middle = (a + b) / 2;
    const ModelPoint e = normalized(b - a);
    const ModelPoint up = normalized(stem_.normal - e * dot(stem_.normal, e));
    ModelPoint n = cross(e, up);
    if (dot(n, parting.aside) < 0) n = -n;
    double reached = -std::numeric_limits<double>::infinity(), next = -reached, top = reached, above = next;
    double reach = next, drift = 0;
    std::vector<Branch> groups[2];
    for (const bool second : {false, true}) {
      for (const std::size_t index : second ? parting.second : parting.first) {
        const Branch& branch = branches[index];
        groups[second].push_back(branch);
        const Interval interval = intervalOf(seenFrom(branch, middle, n, n, up), 1, 0);
        for (const ModelPoint& p : branch.loop->points) {
          const double aside = dot(n, p - middle);
          if (second) above = std::min(above, aside);
          if (!second) top = std::max(top, aside);
        }
        if (second) next = std::min(next, interval.low);
        if (!second) reached = std::max(reached, interval.high);
        drift += dot(e, branch.centre - middle) / static_cast<double>(branches.size());
      }
    }
    constexpr double kSteepest = 1.2;  // radians
    const double psi = std::clamp((reached + next) / 2, -kSteepest, kSteepest);
    const ModelPoint normal = n * std::cos(psi) - up * std::sin(psi), rise = n * std::sin(psi) + up * std::cos(psi);
    for (const Branch& branch : branches) reach = std::min(reach, dot(rise, branch.centre - middle));
    double wide = 0, narrow = 0;
    for (const ModelPoint& p : cell.points) {
      wide = std::max(wide, dot(n, p - middle));
      narrow = std::min(narrow, dot(n, p - middle));
    }
    const double width = wide - narrow;
    const double chosen = std::clamp(1.05 * width / (width + std::max(0.0, above - top)), 0.3, 0.7);
    const double h = std::clamp(stem_.rise.value_or(chosen), kLowest, kHighest);
    if (cells.rise == 0) cells.rise = h;
    const ModelPoint bow = (rise * std::max(0.0, reach) + e * (drift / 2)) * h;

    const ModelPoint toFirst = chord.firstInside ? -normal : normal;
    const auto [left, right] = saddlesOf(cell, {a, b, bow, rise, toFirst});
    Cell parts[2];
    for (std::size_t i = chord.from; i <= chord.to; ++i) append(parts[0], cell, i);
    for (std::size_t i = left.points.size(); i-- > 0;) append(parts[0], left, i);
    for (std::size_t i = chord.to; i <= chord.from + cell.points.size(); ++i)
      append(parts[1], cell, i % cell.points.size());
    for (std::size_t i = 0; i < right.points.size(); ++i) append(parts[1], right, i);
    if (!chord.firstInside) std::swap(parts[0], parts[1]);
    for (const bool second : {false, true}) {
      parts[second].within = cell.within;
      parts[second].within.push_back({middle, second ? -normal : normal});
      cut(std::move(parts[second]), std::move(groups[second]));
    }
  }
  /// The line that both sides of a cut share, from end to end without them.
  struct Saddle {
    ModelPoint from, to, bow, rise;
    ModelPoint aside;  ///< from it to the first side
  };
  /// As the first side sees it, and the second. Each leaves it upwards and to its own side, so that there is a valley
  /// between them and no slit; at its ends both go on as the stem does.
  std::array<Cell, 2> saddlesOf(const Cell& cell, const Saddle& line) {
    constexpr double kAlong = 0.6, kAside = 0.3;
    double edge = 0;
    for (std::size_t i = 0; i < cell.points.size(); ++i) {
      edge += distance(cell.points[i], cell.points[(i + 1) % cell.points.size()]);
    }
    edge /= static_cast<double>(cell.points.size());
    const double arc = distance(line.from, line.to) + 2 * norm(line.bow);
    const auto steps = static_cast<std::size_t>(std::clamp(std::round(arc / edge), 4.0, 256.0));
    std::array<Cell, 2> seen;
    for (std::size_t k = 1; k < steps; ++k) {
      const double s = static_cast<double>(k) / static_cast<double>(steps), inner = 4 * s * (1 - s);
      const ModelPoint p = lerp(line.from, line.to, s) + line.bow * inner;
      cells.crease.push_back(skin_.vertex(p));
      for (const std::size_t side : {0u, 1u}) {
        const ModelPoint way = line.rise * kAlong + line.aside * (side == 0 ? kAside : -kAside);
        seen[side].points.push_back(p);
        seen[side].vertices.push_back(cells.crease.back());
        seen[side].ways.push_back(lerp(stem_.normal, way, inner));
      }
    }
    return seen;
  }
  static void append(Cell& to, const Cell& from, std::size_t i) {
    to.points.push_back(from.points[i]);
    to.vertices.push_back(from.vertices[i]);
    to.ways.push_back(from.ways[i]);
  }

  const Loop& stem_;
  Skin& skin_;
};

}  // namespace

ModelPoint middleOf(const std::vector<ModelPoint>& points) {
  ModelPoint sum;
  for (const ModelPoint& p : points) sum += p;
  return sum / static_cast<double>(points.size());
}

double areaOf(const std::vector<ModelPoint>& points) {
  ModelPoint sum;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) sum += cross(points[i] - points[0], points[i + 1] - points[0]);
  return norm(sum) / 2;
}

Cell wholeOf(const Loop& stem) {
  Cell whole{0, stem.points, stem.vertices, {}, {}};
  whole.ways.assign(stem.points.size(), stem.normal);
  return whole;
}

Cells cellsOf(const Loop& stem, const std::vector<const Loop*>& branches, Skin& skin) {
  Cutter cutter(stem, skin);
  std::vector<Branch> seen;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    seen.push_back({i, branches[i], middleOf(branches[i]->points), std::sqrt(areaOf(branches[i]->points))});
  }
  cutter.cut(wholeOf(stem), std::move(seen));
  return std::move(cutter.cells);
}

}  // namespace spineloft::stack
