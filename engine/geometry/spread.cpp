#include "engine/geometry/spread.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

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
  explicit Neighbours(double cell) : cell_(cell) {}
  bool isFree(const Place& p, double least) const {
    const auto [x, y] = cellOf(p.at);
    for (int dy = -1; dy <= 1; ++dy) {
      for (int dx = -1; dx <= 1; ++dx) {
        const auto found = cells_.find(key(x + dx, y + dy));
        if (found == cells_.end()) continue;
        for (const Place& q : found->second) {
          const SectionPoint step = p.at - q.at;
          const double up = p.height - q.height;
          if (dot(step, step) + up * up < least * least) return false;
        }
      }
    }
    return true;
  }
  void add(const Place& p) {
    const auto [x, y] = cellOf(p.at);
    cells_[key(x, y)].push_back(p);
  }

 private:
  struct Cell {
    int x, y;
  };
  Cell cellOf(SectionPoint p) const {
    const auto step = [&](double v) {
      return static_cast<int>(std::floor(std::clamp(v / cell_, -1e8, 1e8)));
    };
    return {step(p.x), step(p.y)};
  }
  static std::uint64_t key(int x, int y) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(x)) << 32) |
           static_cast<std::uint32_t>(y);
  }
  double cell_;
  std::unordered_map<std::uint64_t, std::vector<Place>> cells_;
};

/// The normal into the region at every corner of the rim, as long as takes it one unit away from both
/// edges.
std::vector<SectionPoint> inwardNormals(std::span<const SectionPoint> rim,
                                        std::span<const std::size_t> sizes) {
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

double toSegment(SectionPoint p, SectionPoint a, SectionPoint b) {
  const SectionPoint along = b - a;
  const double length2 = dot(along, along);
  const double t = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
  return distance(p, a + along * t);
}

}  // namespace

double distanceToRim(std::span<const SectionPoint> rim, std::span<const std::size_t> sizes,
                     SectionPoint p) {
  double nearest = INFINITY;
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    for (std::size_t i = 0, j = size - 1; i < size; j = i++) {
      nearest = std::min(nearest, toSegment(p, rim[first + j], rim[first + i]));
    }
    first += size;
  }
  return nearest;
}

void spreadPoints(PlaneMesh& mesh, std::span<const std::size_t> sizes, Spacing spacing,
                  const SurfaceOver& surface) {
  const std::vector<SectionPoint> rim(mesh.points().begin(),
                                      mesh.points().begin() +
                                          static_cast<std::ptrdiff_t>(mesh.rim()));
  const std::vector<SectionPoint> normals = inwardNormals(rim, sizes);
  Neighbours neighbours(kNearest * spacing.lattice);
  for (const SectionPoint p : rim) neighbours.add({p, surface.height(p)});
  const auto offer = [&](SectionPoint p, double least) {
    if (!mesh.find(p)) return;
    const Place place{p, surface.height(p)};
    if (!neighbours.isFree(place, kNearest * least)) return;
    if (mesh.insert(p)) neighbours.add(place);
  };
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
      if (distanceToRim(rim, sizes, p) >= kRowSlack * away) offer(p, spacing.rows);
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
    for (double x = low.x + step * (odd ? 0.25 : 0.75); x < high.x; x += step) {
      offer({x, y}, spacing.lattice);
    }
  }
  mesh.splitChords();
}

}  // namespace spineloft::geometry
