#include "engine/printing/pieces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <vector>

#include "engine/base/groups.h"
#include "engine/printing/triangle.h"

namespace spineloft::printing {
namespace {

struct Extent {
  Point low{kFar, kFar, kFar}, high{-kFar, -kFar, -kFar};

  void add(Point p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  bool meets(const Extent& other, double reach) const {
    return low.x <= other.high.x + reach && other.low.x <= high.x + reach && low.y <= other.high.y + reach &&
           other.low.y <= high.y + reach && low.z <= other.high.z + reach && other.low.z <= high.z + reach;
  }

 private:
  static constexpr double kFar = std::numeric_limits<double>::infinity();
};

/// A connected surface.
struct Shell {
  std::vector<Corners> triangles;
  Extent box;
  double volume = 0;  ///< below 0 when it is the inside of something
};

Extent extentOf(const Corners& corners) {
  Extent box;
  for (const Point p : corners) box.add(p);
  return box;
}

void addShells(const mesh::TriMesh& mesh, std::vector<Shell>& shells) {
  Groups groups(mesh.positions.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    groups.unite(a, b);
    groups.unite(b, c);
  }
  std::unordered_map<std::uint32_t, std::size_t> shellOf;
  for (const auto& t : mesh.triangles) {
    const auto [at, isNew] = shellOf.try_emplace(groups.of(t[0]), shells.size());
    if (isNew) shells.emplace_back();
    Shell& shell = shells[at->second];
    const Corners corners = cornersOf(mesh, t);
    for (const Point p : corners) shell.box.add(p);
    shell.volume += dot(corners[0], cross(corners[1], corners[2])) / 6;
    shell.triangles.push_back(corners);
  }
}

/// Which shell was first in a cell; who comes later is one with it.
class Grid {
 public:
  Grid(double cell, double shift, Groups& pieces) : cell_(cell), shift_(shift), pieces_(pieces) {}

  void add(Point p, std::uint32_t shell) {
    std::uint64_t key = 0;
    for (const double x : {p.x, p.y, p.z}) {
      const auto i = static_cast<std::int64_t>(std::floor(x / cell_ + shift_));
      key = key << 21 | (static_cast<std::uint64_t>(i) & 0x1fffff);
    }
    const auto [at, isNew] = first_.try_emplace(key, shell);
    if (!isNew && at->second != shell) pieces_.unite(shell, at->second);
  }

 private:
  double cell_, shift_;
  Groups& pieces_;
  std::unordered_map<std::uint64_t, std::uint32_t> first_;
};

void uniteTouching(const std::vector<Shell>& shells, double cell, Groups& pieces) {
  Grid grid(cell, 0, pieces), between(cell, 0.5, pieces);
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    for (const Corners& t : shells[s].triangles) {
      const Extent box = extentOf(t);
      const auto near = [&](const Shell& other) { return &other != &shells[s] && box.meets(other.box, cell); };
      if (std::ranges::none_of(shells, near)) continue;
      const double longest = std::max({norm(t[1] - t[0]), norm(t[2] - t[1]), norm(t[0] - t[2])});
      const int n = std::max(1, static_cast<int>(std::ceil(2 * longest / cell)));
      for (int i = 0; i <= n; ++i) {
        for (int j = 0; j <= n - i; ++j) {
          const Point p =
              t[0] + (t[1] - t[0]) * (static_cast<double>(i) / n) + (t[2] - t[0]) * (static_cast<double>(j) / n);
          grid.add(p, s);
          between.add(p, s);
        }
      }
    }
  }
}

/// How often a shell runs round a point: crossings of a ray along +x, by the side that they show.
int windingOf(const Shell& shell, Point p) {
  // No corner of a model lies on this line but by chance.
  p.y += 1.7e-7;
  p.z += 2.3e-7;
  const auto side = [&](Point a, Point b) { return (a.y - p.y) * (b.z - p.z) - (a.z - p.z) * (b.y - p.y); };
  int winding = 0;
  for (const auto& [a, b, c] : shell.triangles) {
    const double u = side(b, c), v = side(c, a), w = side(a, b);
    const bool front = u > 0 && v > 0 && w > 0, back = u < 0 && v < 0 && w < 0;
    if (!front && !back) continue;
    if ((a.x * u + b.x * v + c.x * w) / (u + v + w) > p.x) winding += front ? 1 : -1;
  }
  return winding;
}

/// A shell within the material of others is one with what is round it; so is an inside-out one.
void uniteNested(const std::vector<Shell>& shells, Groups& pieces) {
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    const Point p = shells[s].triangles[0][0];
    int winding = 0;
    std::uint32_t round = s;
    for (std::uint32_t other = 0; other < shells.size(); ++other) {
      if (other == s || !shells[s].box.meets(shells[other].box, 0)) continue;
      const int times = windingOf(shells[other], p);
      winding += times;
      const bool nearer = round == s || shells[other].volume < shells[round].volume;
      if (times > 0 && nearer) round = other;
    }
    if (winding > 0 && round != s) pieces.unite(s, round);
  }
}

}  // namespace

std::size_t countPieces(std::span<const mesh::TriMesh> parts) {
  std::vector<Shell> shells;
  for (const mesh::TriMesh& mesh : parts) addShells(mesh, shells);
  const auto isMaterial = [](const Shell& shell) { return shell.volume > 0; };
  const auto material = static_cast<std::size_t>(std::ranges::count_if(shells, isMaterial));
  if (material < 2) return material;
  Extent all;
  for (const Shell& shell : shells) {
    all.add(shell.box.low);
    all.add(shell.box.high);
  }
  const double cell = std::max(kJoint, norm(all.high - all.low) / 400);
  Groups pieces(shells.size());
  uniteTouching(shells, cell, pieces);
  uniteNested(shells, pieces);
  std::vector<std::uint32_t> roots;
  for (std::uint32_t s = 0; s < shells.size(); ++s) {
    if (isMaterial(shells[s])) roots.push_back(pieces.of(s));
  }
  std::ranges::sort(roots);
  return static_cast<std::size_t>(std::ranges::unique(roots).begin() - roots.begin());
}

}  // namespace spineloft::printing
