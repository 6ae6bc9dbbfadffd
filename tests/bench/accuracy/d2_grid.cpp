#include "tests/bench/accuracy/d2_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>

#include "engine/base/lanes.h"
#include "engine/base/limits.h"

namespace spineloft::accuracy {
namespace {

constexpr int kLanes = 4;

// Chebyshev points a side, points a side of the smallest tile, segments of a leaf of the tree.
constexpr int kNodes = 4, kSmallest = 8, kLeaf = 4;
constexpr int kLargest = 64;
// How many of its half sides a tile must be away from a group, and how many of its half extents a
// group must be away from a tile, to be summed as far.
constexpr float kTileReach = 3.2f, kGroupReach = 3.5f;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Segment {
  float x, y, alongX, alongY, reach;
};

// A run of segments: centroid, length T, second moments M about it as 4 M − 1 tr M (xy twice), half extent, first
// child (the second follows) or −1.
struct Group {
  float x, y, mass, xx, xy, yy, extent;
  int child, first, count;
};

// atan(√w) / √w, interpolated at Chebyshev nodes; the fewer terms, the smaller the w they hold for. Relative
// error below 6e-6.
constexpr std::array<float, 2> kFarTerms{0.99999396f, -0.33023854f};                              // w ≤ 1/64
constexpr std::array<float, 4> kMidTerms{0.99999768f, -0.33303398f, 0.19380864f, -0.099772075f};  // w ≤ 1/4
constexpr std::array<float, 6> kAllTerms{0.99999483f,  -0.33295711f, 0.19534659f,
                                         -0.12044859f, 0.056589985f, -0.013130382f};  // w ≤ 1
template <std::size_t kTerms>
inline Float4 arctanOverArgument(const std::array<float, kTerms>& c, Float4 w) {
  Float4 sum = all4(c[kTerms - 1]);
  for (std::size_t i = kTerms - 1; i-- > 0;) sum = sum * w + all4(c[i]);
  return sum;
}

// ∫ 1/r² over a segment (d2.h) seen from four points.
Float4 segmentSum(const Segment& s, Float4 x, Float4 y) {
  const Float4 ax = s.x - x, ay = s.y - y;
  const Float4 u = ax * s.alongX + ay * s.alongY, v = ay * s.alongX - ax * s.alongY;
  const Float4 size = v < all4(0) ? -v : v;
  const Float4 along = u * (u + s.reach) + v * v, across = s.reach * size;
  const Float4 run = along < all4(0) ? -along : along;
  const auto steep = across > run;
  const Float4 longer = steep ? across : run, shorter = steep ? run : across;
  const Float4 z = shorter / longer, slope = arctanOverArgument(kAllTerms, z * z);
  Float4 angle = z * slope;
  angle = steep ? all4(std::numbers::pi_v<float> / 2) - angle : angle;
  angle = along < all4(0) ? all4(std::numbers::pi_v<float>) - angle : angle;
  const auto slim = across <= along;  // θ/|v| without dividing by a v that may be 0
  return (slim ? s.reach * slope : angle) / (slim ? longer : size);
}

// Sums at a row of points, four by four: on a grid, and on the smallest tile.
template <std::size_t kVectors>
using Row = std::array<Float4, kVectors>;
constexpr std::size_t kBlock = 16;

// A segment from far enough away that `terms` hold for the angle under which it is seen: one division, and no
// choice. u and v step from vector to vector.
template <std::size_t kTerms, std::size_t kVectors>
inline void addFarSegment(const std::array<float, kTerms>& terms, const Segment& s, Float4 ax, float ay, float step,
                          Row<kVectors>& sums) {
  Float4 u = ax * s.alongX + ay * s.alongY, v = ay * s.alongX - ax * s.alongY;
  const Float4 du = all4(kLanes * step * s.alongX), dv = all4(kLanes * step * s.alongY);
  for (Float4& sum : sums) {
    const Float4 v2 = v * v, seen = s.reach / (u * (u + s.reach) + v2);
    sum += seen * arctanOverArgument(terms, seen * seen * v2);
    u -= du;
    v += dv;
  }
}

// All segments' sums. At a distance r from where a segment of length T begins, tan θ ≤ T / (r − T).
template <std::size_t kVectors>
inline void addSegments(std::span<const Segment> segments, float firstX, float rowY, float step, Row<kVectors>& sums) {
  constexpr float kFar = 9, kMid = 3;  // distances in lengths of the segment: tan θ ≤ 1/8, 1/2
  constexpr float kHalf = 0.5f * (kVectors * kLanes - 1);
  const Float4 x = firstX + step * Float4{0, 1, 2, 3};
  const float half = kHalf * step, middle = firstX + half;
  for (const Segment& s : segments) {
    const Float4 ax = s.x - x;
    const float ay = s.y - rowY, off = s.x - middle, away = off * off + ay * ay;
    const float far = kFar * s.reach + half, mid = kMid * s.reach + half;
    if (away > far * far) {
      addFarSegment(kFarTerms, s, ax, ay, step, sums);
    } else if (away > mid * mid) {
      addFarSegment(kMidTerms, s, ax, ay, step, sums);
    } else {
      for (std::size_t i = 0; i < kVectors; ++i)
        sums[i] += segmentSum(s, x + step * static_cast<float>(i * kLanes), all4(rowY));
    }
  }
}

// A group at rows of points, to second order about its centroid: with d from there to the point and ρ = 1/|d|²,
// ρ T + ρ³ dᵀ(4 M − 1 tr M) d.
template <std::size_t kVectors, std::size_t kRows>
inline void addGroup(const Group& g, const Row<kVectors>& x, const std::array<float, kRows>& y,
                     std::array<Float4, kVectors * kRows>& sums) {
  Row<kVectors> dx, dx2, xx;
  for (std::size_t i = 0; i < kVectors; ++i) {
    dx[i] = x[i] - g.x;
    dx2[i] = dx[i] * dx[i];
    xx[i] = g.xx * dx2[i];
  }
  for (std::size_t r = 0; r < kRows; ++r) {
    const float dy = y[r] - g.y, dy2 = dy * dy, xy = g.xy * dy, yy = g.yy * dy2;
    for (std::size_t i = 0; i < kVectors; ++i) {
      const Float4 near = 1 / (dx2[i] + dy2);
      sums[r * kVectors + i] += near * (g.mass + near * near * (xx[i] + xy * dx[i] + yy));
    }
  }
}

std::vector<Segment> segmentsOf(std::span<const PicturePoint> polyline, const GridPlan& plan, double& length) {
  std::vector<Segment> segments;
  length = 0;
  PicturePoint from = polyline.front();
  for (const PicturePoint& p : polyline.subspan(1)) {
    const double reach = distance(from, p);
    if (!(reach > kSamePoint)) continue;
    const PicturePoint e = (p - from) / reach, start = from - plan.first;
    segments.push_back({static_cast<float>(start.x), static_cast<float>(start.y), static_cast<float>(e.x),
                        static_cast<float>(e.y), static_cast<float>(reach)});
    length += reach;
    from = p;
  }
  return segments;
}

Group groupOf(std::span<const Segment> segments, int first, int count) {
  double mass = 0, cx = 0, cy = 0, xx = 0, xy = 0, yy = 0, extent = 0;
  const auto of = segments.subspan(index(first), index(count));
  const auto middle = [](const Segment& s) {
    return PicturePoint{static_cast<double>(s.x + 0.5f * s.reach * s.alongX),
                        static_cast<double>(s.y + 0.5f * s.reach * s.alongY)};
  };
  for (const Segment& s : of) {
    const auto t = static_cast<double>(s.reach);
    mass += t;
    cx += t * middle(s).x;
    cy += t * middle(s).y;
  }
  cx /= mass;
  cy /= mass;
  for (const Segment& s : of) {
    const auto t = static_cast<double>(s.reach), own = t * t * t / 12;
    const auto ex = static_cast<double>(s.alongX), ey = static_cast<double>(s.alongY);
    const double mx = middle(s).x - cx, my = middle(s).y - cy;
    xx += t * mx * mx + own * ex * ex;
    xy += t * mx * my + own * ex * ey;
    yy += t * my * my + own * ey * ey;
    extent = std::max(extent, std::sqrt(mx * mx + my * my) + 0.5 * t);
  }
  const auto f = [](double v) { return static_cast<float>(v); };
  const double trace = xx + yy;
  return {f(cx), f(cy), f(mass), f(4 * xx - trace), f(8 * xy), f(4 * yy - trace), f(extent), -1, first, count};
}

// Parents before children, the two children of a group side by side.
std::vector<Group> treeOf(std::span<const Segment> segments) {
  std::vector<Group> tree{groupOf(segments, 0, static_cast<int>(segments.size()))};
  for (std::size_t i = 0; i < tree.size(); ++i) {
    if (tree[i].count <= kLeaf) continue;
    const int first = tree[i].first, half = tree[i].count / 2, rest = tree[i].count - half;
    tree[i].child = static_cast<int>(tree.size());
    tree.push_back(groupOf(segments, first, half));
    tree.push_back(groupOf(segments, first + half, rest));
  }
  return tree;
}

// A tile's field at its Chebyshev points: row after row.
using Nodes = std::array<Float4, kNodes>;

// Chebyshev points on [−1, 1], and the weights of their values at any place (Lagrange).
struct Chebyshev {
  std::array<double, kNodes> at;
  Chebyshev() {
    for (std::size_t i = 0; i < kNodes; ++i)
      at[i] = -std::cos(std::numbers::pi * (2.0 * static_cast<double>(i) + 1) / (2 * kNodes));
  }
  Float4 weights(double x) const {
    Float4 w = all4(1);
    for (std::size_t i = 0; i < kNodes; ++i) {
      double product = 1;
      for (std::size_t j = 0; j < kNodes; ++j) {
        if (j != i) product *= (x - at[j]) / (at[i] - at[j]);
      }
      w[i] = static_cast<float>(product);
    }
    return w;
  }
};

float dotOf(Float4 a, Float4 b) {
  const Float4 p = a * b;
  return (p[0] + p[1]) + (p[2] + p[3]);
}

// A square of grid points, `size` a side; it may stand out of the grid.
struct Tile {
  int column, row, size;
};

class QuickGrid {
 public:
  QuickGrid(std::span<const Segment> segments, const GridPlan& plan, std::vector<float>& sums)
      : segments_(segments), plan_(plan), tree_(treeOf(segments)), sums_(sums) {
    for (std::size_t half = 0; half < 2; ++half) {
      for (std::size_t i = 0; i < kNodes; ++i)
        quarter_[half][i] = chebyshev_.weights(0.5 * chebyshev_.at[i] + (half == 0 ? -0.5 : 0.5));
    }
    for (int size = kSmallest; size <= kLargest; size *= 2) {
      std::vector<Float4>& weights = pointWeights_[levelOf(size)];
      for (int i = 0; i < size; ++i) weights.push_back(chebyshev_.weights((2.0 * i + 1) / size - 1));
    }
  }

  GridWork run() {
    for (int row = 0; row < plan_.rows; row += kLargest) {
      for (int column = 0; column < plan_.columns; column += kLargest) fill({column, row, kLargest}, {0}, {});
    }
    return work_;
  }

 private:
  static std::size_t levelOf(int size) {
    std::size_t level = 0;
    for (; size > kSmallest; size /= 2) ++level;
    return level;
  }

  // Sums a tile: the groups `near`, of which some may be far from it, and `field`, what is already
  // known of the rest at its Chebyshev points.
  void fill(const Tile& tile, std::vector<int> near, Nodes field) {
    if (tile.column >= plan_.columns || tile.row >= plan_.rows) return;
    const auto step = static_cast<float>(plan_.step);
    const float half = 0.5f * step * static_cast<float>(tile.size);
    const float x = step * (static_cast<float>(tile.column) - 0.5f) + half;
    const float y = step * (static_cast<float>(tile.row) - 0.5f) + half;
    const bool smallest = tile.size == kSmallest;
    std::vector<int> rest;
    bool any = false;
    for (const Float4& f : field) any = any || f[0] > 0;
    while (!near.empty()) {
      const int at = near.back();
      const Group& g = tree_[index(at)];
      near.pop_back();
      const float away = std::max(std::abs(g.x - x), std::abs(g.y - y)) - half;
      const bool small = away > kGroupReach * g.extent;
      if (small && away + half > kTileReach * half + g.extent) {
        addFar(g, x, y, half, field);
        any = true;
      } else if (g.child >= 0 && (!small || g.extent > half)) {
        near.push_back(g.child);
        near.push_back(g.child + 1);
      } else {
        rest.push_back(at);
      }
    }
    if (rest.empty() || smallest) {
      if (any) interpolate(tile, field);
      if (!rest.empty()) addNear(tile, rest);
      return;
    }
    for (int q = 0; q < 4; ++q) {
      const int size = tile.size / 2;
      fill({tile.column + q % 2 * size, tile.row + q / 2 * size, size}, rest, any ? quarterOf(field, q) : Nodes{});
    }
  }

  void addFar(const Group& g, float x, float y, float half, Nodes& field) {
    Row<1> nodesX{all4(x)};
    std::array<float, kNodes> nodesY;
    for (std::size_t i = 0; i < kNodes; ++i) {
      const float off = half * static_cast<float>(chebyshev_.at[i]);
      nodesX[0][i] += off;
      nodesY[i] = y + off;
    }
    addGroup(g, nodesX, nodesY, field);
    work_.groups += kNodes * kNodes;
  }

  Nodes quarterOf(const Nodes& field, int q) const {
    const auto &columns = quarter_[index(q % 2)], &rows = quarter_[index(q / 2)];
    Nodes out;
    for (std::size_t i = 0; i < kNodes; ++i) {
      Float4 row = all4(0);
      for (std::size_t j = 0; j < kNodes; ++j) row += rows[i][j] * field[j];
      for (std::size_t j = 0; j < kNodes; ++j) out[i][j] = dotOf(row, columns[j]);
    }
    return out;
  }

  void interpolate(const Tile& tile, const Nodes& field) {
    const std::vector<Float4>& weights = pointWeights_[levelOf(tile.size)];
    const int columns = std::min(tile.size, plan_.columns - tile.column);
    const int rows = std::min(tile.size, plan_.rows - tile.row);
    // Along x first: one value for each Chebyshev row and column of points.
    std::array<std::array<float, kLargest>, kNodes> lines;
    for (std::size_t j = 0; j < kNodes; ++j) {
      for (int c = 0; c < tile.size; ++c) lines[j][index(c)] = dotOf(field[j], weights[index(c)]);
    }
    for (int r = 0; r < rows; ++r) {
      float* out = rowOf(tile, r);
      const Float4 w = weights[index(r)];
      for (int c = 0; c < columns; ++c) {
        out[c] += w[0] * lines[0][index(c)] + w[1] * lines[1][index(c)] + w[2] * lines[2][index(c)] +
                  w[3] * lines[3][index(c)];
      }
    }
  }

  // Groups at the points of a smallest tile: at once where all of them are far, else four by four.
  void addNear(const Tile& tile, std::span<const int> groups) {
    constexpr std::size_t kVectors = kSmallest / kLanes;
    const auto step = static_cast<float>(plan_.step);
    const float left = step * static_cast<float>(tile.column), top = step * static_cast<float>(tile.row);
    Row<kVectors> x;
    std::array<float, kSmallest> y;
    for (std::size_t i = 0; i < kVectors; ++i)
      x[i] = left + step * (Float4{0, 1, 2, 3} + static_cast<float>(i * kLanes));
    for (std::size_t r = 0; r < kSmallest; ++r) y[r] = top + step * static_cast<float>(r);
    std::array<Float4, kVectors * kSmallest> sums{};
    const float half = 0.5f * step * (kSmallest - 1), middle = left + half;
    for (const int at : groups) {
      const Group& g = tree_[index(at)];
      const float reach = kGroupReach * g.extent;
      const float dx = std::max(0.f, std::abs(g.x - middle) - half);
      const float dy = std::max(0.f, std::abs(g.y - top - half) - half);
      if (dx * dx + dy * dy > reach * reach) {
        addGroup(g, x, y, sums);
        work_.groups += kSmallest * kSmallest;
        continue;
      }
      for (std::size_t i = 0; i < sums.size(); ++i) addNearest(g, x[i % kVectors], y[i / kVectors], sums[i]);
    }
    const int columns = std::min(kSmallest, plan_.columns - tile.column);
    const int rows = std::min(kSmallest, plan_.rows - tile.row);
    for (int r = 0; r < rows; ++r) {
      float* out = rowOf(tile, r);
      for (int c = 0; c < columns; ++c) out[c] += sums[index(r) * kVectors + index(c / kLanes)][c % kLanes];
    }
  }

  // A group by its moments where all four points are far from it, else segment by segment.
  void addNearest(const Group& g, Float4 x, float y, Float4& sum) {
    const auto step = static_cast<float>(plan_.step);
    const float dx = std::max(0.f, std::abs(g.x - 0.5f * (x[0] + x[3])) - 1.5f * step);
    const float dy = g.y - y, reach = kGroupReach * g.extent;
    std::array<Float4, 1> four{sum};
    if (dx * dx + dy * dy > reach * reach) {
      addGroup<1, 1>(g, {x}, {y}, four);
      work_.groups += kLanes;
    } else {
      addSegments(segments_.subspan(index(g.first), index(g.count)), x[0], y, step, four);
      work_.segments += kLanes * static_cast<std::uint64_t>(g.count);
    }
    sum = four[0];
  }

  float* rowOf(const Tile& tile, int r) {
    return &sums_[index(tile.row + r) * index(plan_.columns) + index(tile.column)];
  }

  std::span<const Segment> segments_;
  const GridPlan& plan_;
  std::vector<Group> tree_;
  std::vector<float>& sums_;
  Chebyshev chebyshev_;
  std::array<std::array<Float4, kNodes>, 2> quarter_;
  std::array<std::vector<Float4>, 4> pointWeights_;
  GridWork work_;
};

// d2 = √(A / ΣI); 0 on the polyline, where ΣI is infinite or not a number.
void finish(double length, std::vector<float>& sums) {
  const auto a = static_cast<float>(length);
  for (float& sum : sums) {
    const float d2 = std::sqrt(a / sum);
    sum = d2 > 0 ? d2 : 0;
  }
}

}  // namespace

GridWork d2OnGrid(std::span<const PicturePoint> polyline, const GridPlan& plan, std::vector<float>& d2) {
  double length = 0;
  const std::vector<Segment> segments = segmentsOf(polyline, plan, length);
  d2.assign(index(plan.columns) * index(plan.rows), 0.f);
  const auto step = static_cast<float>(plan.step);
  for (int r = 0; r < plan.rows; ++r) {
    float* out = &d2[index(r) * index(plan.columns)];
    for (int c = 0; c < plan.columns; c += kBlock) {
      Row<kBlock / kLanes> sums{};
      addSegments(segments, step * static_cast<float>(c), step * static_cast<float>(r), step, sums);
      const int count = std::min<int>(kBlock, plan.columns - c);
      std::memcpy(out + c, sums.data(), index(count) * sizeof(float));
    }
  }
  finish(length, d2);
  return {segments.size() * d2.size(), 0};
}

GridWork quickD2OnGrid(std::span<const PicturePoint> polyline, const GridPlan& plan, std::vector<float>& d2) {
  double length = 0;
  const std::vector<Segment> segments = segmentsOf(polyline, plan, length);
  d2.assign(index(plan.columns) * index(plan.rows), 0.f);
  const GridWork work = QuickGrid(segments, plan, d2).run();
  finish(length, d2);
  return work;
}

}  // namespace spineloft::accuracy
