#include "engine/geometry/spread.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polyline.h"

namespace spineloft::geometry {
namespace {

/// The lattice is this much finer than the spacing: what is too near is left out.
constexpr double kLattice = 0.8;
/// The cosine of half a turn counts as at least this.
constexpr double kLeastMitre = 0.4;
/// A point of a row is kept only where the rim is about as far as the row should be.
constexpr double kRowSlack = 0.9;

struct Place {
  SectionPoint at;
  double height;
};

/// Points by the cells of a grid, to find those near another.
class Neighbours {
 public:
  /// `cell`: no smaller than the distances asked for; within the bounds of `rim`.
  Neighbours(double cell, std::span<const SectionPoint> rim) {
    SectionPoint high = low_ = rim[0];
    for (const SectionPoint p : rim) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double width = high.x - low_.x, height = high.y - low_.y;
    cell_ = std::max(cell, std::sqrt(width * height / kMostCells) + (width + height) / kMostCells);
    nx_ = static_cast<int>(width / cell_) + 1;
    ny_ = static_cast<int>(height / cell_) + 1;
    last_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_), -1);
  }
  bool isFree(const Place& p, double least) const {
    const int cx = column(p.at.x), cy = row(p.at.y);
    for (int y = std::max(0, cy - 1); y <= std::min(ny_ - 1, cy + 1); ++y) {
      for (int x = std::max(0, cx - 1); x <= std::min(nx_ - 1, cx + 1); ++x) {
        for (int i = last_[cellAt(x, y)]; i >= 0; i = before_[static_cast<std::size_t>(i)]) {
          const Place& q = places_[static_cast<std::size_t>(i)];
          const SectionPoint step = p.at - q.at;
          const double up = p.height - q.height;
          if (dot(step, step) + up * up < least * least) return false;
        }
      }
    }
    return true;
  }
  void add(const Place& p) {
    int& last = last_[cellAt(column(p.at.x), row(p.at.y))];
    before_.push_back(last);
    last = static_cast<int>(places_.size());
    places_.push_back(p);
  }

 private:
  static constexpr double kMostCells = 1e6;
  int column(double x) const { return static_cast<int>(std::clamp((x - low_.x) / cell_, 0.0, nx_ - 1.0)); }
  int row(double y) const { return static_cast<int>(std::clamp((y - low_.y) / cell_, 0.0, ny_ - 1.0)); }
  std::size_t cellAt(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x);
  }
  SectionPoint low_{};
  double cell_ = 1;
  int nx_ = 1, ny_ = 1;
  std::vector<int> last_, before_;  ///< chains of places, by cell; −1 ends one
  std::vector<Place> places_;
};

/// The normal into the region at every corner of the rim, as long as takes it one unit away from both
/// edges.
std::vector<SectionPoint> inwardNormals(std::span<const SectionPoint> rim, std::span<const std::size_t> sizes) {
  std::vector<SectionPoint> normals;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    const auto polygon = rim.subspan(first, size);
    for (std::size_t i = 0; i < size; ++i) {
      const SectionPoint in = normalized(polygon[i] - polygon[(i + size - 1) % size]);
      const SectionPoint out = normalized(polygon[(i + 1) % size] - polygon[i]);
      const SectionPoint along = normalized(in + out);
      // At an outward corner a row's corner lies farther in than the row.
      const double mitre = cross(in, out) > 0 ? 1 / std::max(kLeastMitre, dot(in, along)) : 1;
      normals.push_back(SectionPoint{-along.y, along.x} * mitre);
    }
    first += size;
  }
  return normals;
}

/// Where a level line crosses the outlines, from left to right: between the first and the second it is
/// within, between the second and the third outside, and so on.
std::vector<double> crossingsAt(double y, std::span<const SectionPoint> rim, std::span<const std::size_t> sizes) {
  std::vector<double> cuts;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    const auto polygon = rim.subspan(first, size);
    for (std::size_t i = 0, j = size - 1; i < size; j = i++) {
      const SectionPoint a = polygon[j], b = polygon[i];
      if ((a.y > y) != (b.y > y)) cuts.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
    }
    first += size;
  }
  std::ranges::sort(cuts);
  return cuts;
}

}  // namespace

RimDistance::RimDistance(std::span<const SectionPoint> rim, std::span<const std::size_t> sizes) {
  SectionPoint high = low_ = rim[0];
  for (const SectionPoint p : rim) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double width = high.x - low_.x, height = high.y - low_.y;
  const double cells = 2 * static_cast<double>(rim.size()) + 16;
  cell_ = std::max(std::sqrt(width * height / cells), std::max(width, height) / cells);
  if (!(cell_ > 0)) cell_ = 1;
  nx_ = static_cast<int>(width / cell_) + 1;
  ny_ = static_cast<int>(height / cell_) + 1;
  first_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) + 1, 0);
  // Twice: how many edges each cell gets, then the edges.
  std::vector<std::uint32_t> at;
  for (const bool counting : {true, false}) {
    std::size_t begin = 0;
    for (const std::size_t size : sizes) {
      for (std::size_t i = 0, j = size - 1; i < size; j = i++) {
        const Edge edge{rim[begin + j], rim[begin + i], static_cast<std::uint32_t>(begin + j)};
        const Cell a = cellOf(edge.a), b = cellOf(edge.b);
        for (int y = std::min(a.y, b.y); y <= std::max(a.y, b.y); ++y) {
          for (int x = std::min(a.x, b.x); x <= std::max(a.x, b.x); ++x) {
            const std::size_t cell =
                static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_) + static_cast<std::size_t>(x);
            if (counting) {
              ++first_[cell + 1];
            } else {
              edges_[at[cell]++] = edge;
            }
          }
        }
      }
      begin += size;
    }
    if (!counting) break;
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    at.assign(first_.begin(), first_.end() - 1);
    edges_.resize(first_.back());
  }
}

RimDistance::Cell RimDistance::cellOf(SectionPoint p) const {
  const auto step = [&](double v, int count) { return static_cast<int>(std::clamp(v / cell_, 0.0, count - 1.0)); };
  return {step(p.x - low_.x, nx_), step(p.y - low_.y, ny_)};
}

/// The cells up to `reach` beside one, as far as they are not farther than the best place. The edges of cells side by
/// side follow each other.
void RimDistance::lookAround(Cell at, int reach, SectionPoint p, Nearest& best) const {
  double squared = best.distance * best.distance;
  const double slack = 1e-9 * cell_;  // of rounding, where an edge runs along cells
  for (int y = std::max(0, at.y - reach); y <= std::min(ny_ - 1, at.y + reach); ++y) {
    const double below = low_.y + y * cell_ - p.y, above = -below - cell_;
    const double off = std::max({0.0, below, above}) - slack, most = best.distance + slack;
    if (off > most) continue;
    int from = std::max(0, at.x - reach), to = std::min(nx_ - 1, at.x + reach);
    if (most < reach * cell_) {
      const double half = std::sqrt(std::max(0.0, most * most - off * off)) + slack;
      from = std::max(from, cellOf({p.x - half, p.y}).x);
      to = std::min(to, cellOf({p.x + half, p.y}).x);
    }
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(nx_);
    const std::uint32_t last = first_[row + static_cast<std::size_t>(to) + 1];
    for (std::uint32_t e = first_[row + static_cast<std::size_t>(from)]; e < last; ++e) {
      const SectionPoint gap = p - nearestOnSegment(p, edges_[e].a, edges_[e].b);
      if (dot(gap, gap) >= squared) continue;
      squared = dot(gap, gap);
      if (std::sqrt(squared) < best.distance) best = {std::sqrt(squared), edges_[e].from};
    }
  }
}

RimDistance::Nearest RimDistance::nearest(SectionPoint p) const {
  const Cell at = cellOf(p);
  Nearest best{INFINITY, 0};
  int reach = 0;
  for (; reach <= 2 * std::max(nx_, ny_); reach = 2 * reach + 1) {
    lookAround(at, reach, p, best);
    if (best.distance < INFINITY) break;
  }
  // What lies beyond the square is farther than its half.
  if (best.distance > reach * cell_) {
    lookAround(at, static_cast<int>(std::min<double>(std::ceil(best.distance / cell_), nx_ + ny_)), p, best);
  }
  return best;
}

void spreadPoints(PlaneMesh& mesh, std::span<const std::size_t> sizes, Spacing spacing, const SurfaceOver& surface) {
  const std::vector<SectionPoint> rim(mesh.points().begin(),
                                      mesh.points().begin() + static_cast<std::ptrdiff_t>(mesh.rim()));
  const std::vector<SectionPoint> normals = inwardNormals(rim, sizes);
  const RimDistance distances(rim, sizes);
  Neighbours neighbours(kNearest * spacing.lattice, rim);
  for (const SectionPoint p : rim) neighbours.add({p, surface.height(p)});
  const auto offer = [&](SectionPoint p, double least) {
    if (!mesh.find(p)) return;
    const Place place{p, surface.height(p)};
    if (!neighbours.isFree(place, kNearest * least)) return;
    if (mesh.insert(p)) neighbours.add(place);
  };
  for (const SectionPoint p : surface.features) offer(p, spacing.rows);
  std::vector<std::vector<double>> rows;
  std::size_t most = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    rows.push_back(surface.rows(i));
    most = std::max(most, rows.back().size());
  }
  for (std::size_t row = 0; row < most; ++row) {
    for (std::size_t i = 0; i < rim.size(); ++i) {
      if (row >= rows[i].size()) continue;
      const double away = rows[i][row];
      const SectionPoint p = rim[i] + normals[i] * away;
      if (distances.to(p) >= kRowSlack * away) offer(p, spacing.rows);
    }
  }
  SectionPoint low = rim[0], high = rim[0];
  for (const SectionPoint p : rim) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double step = kLattice * spacing.lattice, rise = step * std::sqrt(0.75);
  int odd = 0;
  for (double y = low.y + rise / 2; y < high.y; y += rise, odd ^= 1) {
    const std::vector<double> cuts = crossingsAt(y, rim, sizes);
    std::size_t passed = 0;
    for (double x = low.x + step * (odd ? 0.25 : 0.75); x < high.x; x += step) {
      while (passed < cuts.size() && cuts[passed] <= x) ++passed;
      if (passed % 2 == 1) offer({x, y}, spacing.lattice);
    }
  }
  mesh.splitChords();
}

}  // namespace spineloft::geometry
