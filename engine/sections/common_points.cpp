#include "engine/sections/common_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/polygon.h"

namespace spineloft::sections {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;

/// A contour with a coordinate that grows by 1 in one round: points of two contours with the same
/// coordinate belong together.
struct Parted {
  std::vector<SectionPoint> points;
  std::vector<bool> knot;
  std::vector<double> arc;    ///< share of the length at every point, and 1
  std::vector<double> place;  ///< the coordinate at every point, and after one round
  bool byAngle = false;
  std::vector<double> angle;  ///< turns about the hub at every point and after one round; empty where none sees all

  /// The coordinate where `of` (arc or place itself) has a value within one round of its first.
  static double convert(const std::vector<double>& from, const std::vector<double>& to, double value) {
    const double rounds = std::floor(value - from.front());
    value -= rounds;
    auto next = std::ranges::upper_bound(from, value);
    if (next == from.begin()) ++next;
    if (next == from.end()) --next;
    const std::size_t j = static_cast<std::size_t>(next - from.begin()), i = j - 1;
    const double step = from[j] - from[i];
    const double t = step > 0 ? std::clamp((value - from[i]) / step, 0.0, 1.0) : 0;
    return to[i] + (to[j] - to[i]) * t + rounds;
  }
  SectionPoint at(const std::vector<double>& of, double value) const {
    value -= std::floor(value - of.front());
    auto next = std::ranges::upper_bound(of, value);
    if (next == of.begin()) ++next;
    if (next == of.end()) --next;
    const std::size_t j = static_cast<std::size_t>(next - of.begin()), i = j - 1;
    const double step = of[j] - of[i];
    const double t = step > 0 ? std::clamp((value - of[i]) / step, 0.0, 1.0) : 0;
    return lerp(points[i], points[j % points.size()], t);
  }
};

/// Long edges cut, so that in between too the same direction means the same place.
Contour cut(const Contour& contour) {
  double length = 0;
  const std::size_t n = contour.points.size();
  for (std::size_t i = 0; i < n; ++i) {
    length += distance(contour.points[i], contour.points[(i + 1) % n]);
  }
  Contour out;
  for (std::size_t i = 0; i < n; ++i) {
    const SectionPoint a = contour.points[i], b = contour.points[(i + 1) % n];
    const int steps = std::max(1, static_cast<int>(std::ceil(distance(a, b) / length * 192)));
    for (int k = 0; k < steps; ++k) {
      out.points.push_back(lerp(a, b, static_cast<double>(k) / steps));
      out.knot.push_back(k == 0 && contour.knot[i]);
    }
  }
  return out;
}

Parted partedByArc(const Contour& contour) {
  Parted parted;
  parted.points = contour.points;
  parted.knot = contour.knot;
  const std::size_t n = contour.points.size();
  parted.arc.assign(n + 1, 0.0);
  for (std::size_t i = 0; i < n; ++i) {
    parted.arc[i + 1] = parted.arc[i] + distance(contour.points[i], contour.points[(i + 1) % n]);
  }
  for (double& s : parted.arc) s /= parted.arc.back();
  parted.arc.back() = 1;
  parted.place = parted.arc;
  return parted;
}

/// Coordinates by direction from the hub; empty when there is none.
std::vector<double> directions(const Parted& parted) {
  const auto hub = hubOf(parted.points);
  if (!hub) return {};
  std::vector<double> place;
  for (const SectionPoint& p : parted.points) {
    double angle = std::atan2(p.y - hub->y, p.x - hub->x) / kTurn;
    if (!place.empty()) {
      angle += std::floor(place.back() - angle) + (angle < place.back() ? 1 : 0);
      while (angle > place.back() + 1) angle -= 1;
      while (angle <= place.back()) angle += 1;
      if (angle > place.back() + 0.5) return {};
    }
    place.push_back(angle);
  }
  place.push_back(place.front() + 1);
  if (place[place.size() - 2] >= place.back()) return {};
  return place;
}

/// How much later on b the point lies that belongs to the same share of a's length: the cyclic shift
/// with the least sum of distances; of equal ones the least turn.
double bestShift(const Parted& a, const Parted& b) {
  constexpr int kShifts = 256, kProbes = 128;
  constexpr double kTie = 1 - 1e-9;
  const double start = std::atan2(a.points[0].y, a.points[0].x);
  double bestSum = std::numeric_limits<double>::infinity(), bestTurn = 0, best = 0;
  for (int k = 0; k < kShifts; ++k) {
    const double shift = static_cast<double>(k) / kShifts;
    double sum = 0;
    for (int i = 0; i < kProbes && sum < bestSum; ++i) {
      const double s = static_cast<double>(i) / kProbes;
      sum += distance(a.at(a.arc, s), b.at(b.arc, s + shift));
    }
    const SectionPoint q = b.at(b.arc, shift);
    const double turn = std::abs(std::remainder(std::atan2(q.y, q.x) - start, kTurn));
    if (sum < bestSum * kTie || (sum <= bestSum && turn < bestTurn)) {
      bestSum = sum;
      bestTurn = turn;
      best = shift;
    }
  }
  return best;
}

/// Coordinates for every contour of the row.
std::vector<Parted> part(std::span<const Contour> row) {
  std::vector<Parted> all;
  for (const Contour& contour : row) {
    Parted next = partedByArc(row.size() > 1 ? cut(contour) : contour);
    if (row.size() > 1) {
      if (std::vector<double> place = directions(next); !place.empty()) {
        next.place = std::move(place);
        next.byAngle = true;
      }
    }
    if (!all.empty() && !(all.back().byAngle && next.byAngle)) {
      const Parted& last = all.back();
      const double shift = bestShift(last, next);
      for (std::size_t i = 0; i < next.place.size(); ++i) {
        next.place[i] = Parted::convert(last.arc, last.place, next.arc[i] - shift);
      }
      next.byAngle = false;
    }
    all.push_back(std::move(next));
  }
  return all;
}

/// A curve at even places of the coordinate.
struct Probe {
  double place = 0;
  SectionPoint at;
};
std::vector<Probe> probesOf(const Parted& parted) {
  constexpr int kProbes = 96;
  std::vector<Probe> probes;
  for (int i = 0; i < kProbes; ++i) {
    const double place = parted.place.front() + static_cast<double>(i) / kProbes;
    probes.push_back({place, parted.at(parted.place, place)});
  }
  return probes;
}

/// How badly b fits on the probes of a where places belong together: Σ|a − R(−θ)b|² with what turning costs.
double misfit(std::span<const Probe> a, const Parted& b, const std::vector<double>& placesOfB) {
  constexpr double kQuarter = std::numbers::pi / 2, kAlike = 1e-3;  // of equal fits the one that turns less
  double along = 0, about = 0, size = 0;
  for (const auto& [place, p] : a) {
    const SectionPoint q = b.at(placesOfB, place);
    along += dot(p, q);
    about += cross(p, q);
    size += dot(p, p) + dot(q, q);
  }
  const double turned = std::atan2(about, along) / kQuarter;
  const double off = std::max(0.0, size - 2 * std::hypot(along, about));
  return off * (1 + turned * turned) + kAlike * size * turned * turned;
}

/// Shares of the length at the corners.
std::vector<double> cornersOf(const Parted& parted) {
  std::vector<double> out;
  for (std::size_t i = 0; i < parted.points.size(); ++i) {
    if (parted.knot[i]) out.push_back(parted.arc[i]);
  }
  return out;
}

/// Places for `next` that fit `last` best (Matching::LeastTurn).
std::vector<double> leastTurnPlaces(const Parted& last, const Parted& next) {
  constexpr std::size_t kShifts = 96, kMostCorners = 24;
  std::vector<double> best, places(next.arc.size());
  double least = std::numeric_limits<double>::infinity();
  const std::vector<Probe> probes = probesOf(last);
  const auto consider = [&] {
    constexpr double kBetter = 1 - 1e-9;
    const double cost = misfit(probes, next, places);
    if (cost >= least * kBetter) return;
    least = cost;
    best = places;
  };
  if (!last.angle.empty() && !next.angle.empty()) {
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = Parted::convert(last.angle, last.place, next.angle[i]);
    consider();
  }
  const auto shifted = [&](double shift) {
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i] = Parted::convert(last.arc, last.place, next.arc[i] - shift);
    }
    consider();
  };
  for (std::size_t k = 0; k < kShifts; ++k) shifted(static_cast<double>(k) / static_cast<double>(kShifts));
  const std::vector<double> a = cornersOf(last), b = cornersOf(next);
  if (a.empty() || b.empty() || std::max(a.size(), b.size()) > kMostCorners) return best;
  if (a.size() != b.size()) {
    for (const double from : a) {
      for (const double to : b) shifted(to - from);
    }
    return best;
  }
  for (std::size_t shift = 0; shift < a.size(); ++shift) {  // every corner on a corner, evenly in between
    std::vector<double> from, to;
    for (std::size_t k = 0; k <= a.size(); ++k) {
      const std::size_t j = k + shift;
      from.push_back(b[j % b.size()] + static_cast<double>(j / b.size()));
      to.push_back(k < a.size() ? a[k] : a[0] + 1);
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
      places[i] = Parted::convert(last.arc, last.place, Parted::convert(from, to, next.arc[i]));
    }
    consider();
  }
  return best;
}

/// Coordinates for every contour of the row by Matching::LeastTurn.
std::vector<Parted> partWithLeastTurn(std::span<const Contour> row) {
  std::vector<Parted> all;
  for (const Contour& contour : row) {
    Parted next = partedByArc(cut(contour));
    next.angle = directions(next);
    if (!all.empty()) next.place = leastTurnPlaces(all.back(), next);
    all.push_back(std::move(next));
  }
  return all;
}

/// Where a curve without corners begins: farthest from the origin in the direction of x.
double firstPlace(const Parted& parted) {
  double farthest = -std::numeric_limits<double>::infinity(), place = parted.place.front();
  for (std::size_t i = 0; i < parted.points.size(); ++i) {
    const SectionPoint a = parted.points[i], b = parted.points[(i + 1) % parted.points.size()];
    if ((a.y > 0) == (b.y > 0)) continue;
    const double t = a.y / (a.y - b.y), x = a.x + (b.x - a.x) * t;
    if (x <= farthest) continue;
    farthest = x;
    place = parted.place[i] + (parted.place[i + 1] - parted.place[i]) * t;
  }
  return place;
}

}  // namespace

std::optional<SectionPoint> hubOf(std::span<const SectionPoint> points) {
  constexpr double kWell = 0.02, kJust = 2e-3;  // section units from the line of every edge
  const SectionPoint centre = geometry::centroid(points);
  if (geometry::seesAllEdges(points, centre, kWell)) return centre;
  const auto kernel = geometry::kernelCentre(points);
  if (kernel && geometry::seesAllEdges(points, *kernel, kJust)) return kernel;
  return std::nullopt;
}

std::vector<double> placesOn(const Contour& a, const Contour& b) {
  Parted last = partedByArc(cut(a)), next = partedByArc(cut(b));
  last.angle = directions(last);
  next.angle = directions(next);
  const std::vector<double> places = leastTurnPlaces(last, next), shares = partedByArc(b).arc;
  std::vector<double> out;
  for (std::size_t i = 0; i < b.points.size(); ++i) out.push_back(Parted::convert(next.arc, places, shares[i]));
  return out;
}

std::vector<std::vector<SectionPoint>> onCommonPoints(std::span<const Contour> row, int points, Matching matching,
                                                      std::size_t mostKnots) {
  const bool leastTurn = matching == Matching::LeastTurn;
  const std::vector<Parted> parted = leastTurn ? partWithLeastTurn(row) : part(row);
  // All coordinates that matter: those of the knots, and in between evenly by the mean length.
  std::vector<double> knots, table;
  const auto wrapped = [](double place) { return place - std::floor(place); };
  for (const Parted& one : parted) {
    for (std::size_t i = 0; i < one.points.size(); ++i) {
      table.push_back(wrapped(one.place[i]));
      if (one.knot[i]) knots.push_back(table.back());
    }
  }
  constexpr double kSame = 1e-6;
  const auto tidy = [](std::vector<double>& values, double same) {
    std::ranges::sort(values);
    const auto [first, last] = std::ranges::unique(values, [&](double a, double b) { return b - a < same; });
    values.erase(first, last);
    if (values.size() > 1 && values.back() - values.front() > 1 - same) values.pop_back();
  };
  if (knots.empty()) knots.push_back(leastTurn ? wrapped(firstPlace(parted.front())) : table.front());
  tidy(knots, std::max(kSame, 1 / static_cast<double>(mostKnots)));
  tidy(table, kSame);
  table.insert(table.end(), knots.begin(), knots.end());
  std::ranges::sort(table);
  table.push_back(table.front() + 1);
  std::vector<double> mean;  // mean share of the lengths since the first coordinate
  for (const double place : table) {
    double sum = 0;
    for (const Parted& one : parted) {
      sum += Parted::convert(one.place, one.arc, place) - Parted::convert(one.place, one.arc, table.front());
    }
    mean.push_back(sum / static_cast<double>(parted.size()));
  }
  std::vector<double> places;
  for (std::size_t k = 0; k < knots.size(); ++k) {
    const double from = knots[k], to = k + 1 < knots.size() ? knots[k + 1] : knots[0] + 1;
    const double a = Parted::convert(table, mean, from);
    const double b = Parted::convert(table, mean, to);
    const int steps = std::max(1, static_cast<int>(std::lround((b - a) * points)));
    places.push_back(from);
    for (int i = 1; i < steps; ++i) {
      places.push_back(Parted::convert(mean, table, a + (b - a) * i / steps));
    }
  }
  std::vector<std::vector<SectionPoint>> out;
  for (const Parted& one : parted) {
    std::vector<SectionPoint> curve;
    for (const double place : places) curve.push_back(one.at(one.place, place));
    out.push_back(std::move(curve));
  }
  return out;
}

}  // namespace spineloft::sections
