#include "engine/mesh/self_crossing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace spineloft::mesh {
namespace {

using Triple = std::array<double, 3>;
using Triangle = std::array<Triple, 3>;

Triple minus(const Triple& a, const Triple& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Triple& a, const Triple& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Triple cross(const Triple& a, const Triple& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

struct Bounds {
  std::array<float, 3> low, high;
  Bounds() {
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
  }
  void include(const std::array<float, 3>& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  void include(const Bounds& other) {
    include(other.low);
    include(other.high);
  }
  /// Whether both reach further into one another than `touch`.
  bool meets(const Bounds& other, double touch) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const double over = double{other.high[k]} - low[k], under = double{high[k]} - other.low[k];
      if (!(over > touch && under > touch)) return false;
    }
    return true;
  }
};

/// The plane of a triangle; a normal of length 0 where it has none.
struct Plane {
  Triple normal{};
  double distance = 0;
};

class Search {
 public:
  explicit Search(const TriMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
    boxes_.reserve(order_.size());
    planes_.reserve(order_.size());
    for (std::size_t t = 0; t < order_.size(); ++t) {
      Bounds box;
      for (const std::uint32_t v : mesh.triangles[t]) box.include(mesh.positions[v]);
      boxes_.push_back(box);
      whole_.include(box);
      planes_.push_back(planeOf(cornersOf(t)));
    }
    double diagonal = 0;
    for (std::size_t k = 0; k < 3; ++k) diagonal = std::hypot(diagonal, double{whole_.high[k]} - whole_.low[k]);
    touch_ = kTouch * diagonal;
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    isInOrder_ = followOneAnother();
    nodes_.reserve(order_.size());
    build(0, order_.size());
  }

  std::optional<Triple> run() {
    std::vector<std::pair<std::size_t, std::size_t>> left{{0, 0}};
    while (!left.empty()) {
      const auto [a, b] = left.back();
      left.pop_back();
      const Node &one = nodes_[a], &other = nodes_[b];
      if (a != b && !one.box.meets(other.box, touch_)) continue;
      if (a == b && !one.isLeaf()) {
        left.insert(left.end(), {{one.first, one.first}, {one.second, one.second}, {one.first, one.second}});
      } else if (one.isLeaf() && other.isLeaf()) {
        if (const auto at = between(one, other, a == b)) return at;
      } else if (other.isLeaf() || (!one.isLeaf() && one.to - one.from >= other.to - other.from)) {
        left.insert(left.end(), {{one.first, b}, {one.second, b}});
      } else {
        left.insert(left.end(), {{a, other.first}, {a, other.second}});
      }
    }
    return std::nullopt;
  }

 private:
  /// Triangles order_[from … to) and their bounds; 0 as a child: it is a leaf.
  struct Node {
    Bounds box;
    std::size_t from = 0, to = 0, first = 0, second = 0;
    bool isLeaf() const { return first == 0; }
  };

  /// Whether triangles that follow one another are near, as those of a loft are, which run round its rings.
  bool followOneAnother() const {
    double way = 0, size = 0;
    for (std::size_t t = 1; t < boxes_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        way += std::abs(double{boxes_[t].low[k]} - boxes_[t - 1].low[k]);
        size += double{boxes_[t].high[k]} - boxes_[t].low[k];
      }
    }
    return way < 2 * size;
  }

  std::size_t build(std::size_t from, std::size_t to) {
    constexpr std::size_t kLeaf = 4;
    const std::size_t at = nodes_.size();
    nodes_.emplace_back();
    Bounds box;
    for (std::size_t i = from; i < to; ++i) box.include(boxes_[order_[i]]);
    std::size_t first = 0, second = 0;
    if (to - from > kLeaf) {
      std::size_t axis = 0;
      for (std::size_t k = 1; k < 3; ++k) {
        if (box.high[k] - box.low[k] > box.high[axis] - box.low[axis]) axis = k;
      }
      const std::size_t middle = from + (to - from) / 2;
      const auto place = [&](std::size_t i) { return order_.begin() + static_cast<std::ptrdiff_t>(i); };
      const auto isBefore = [&](std::size_t a, std::size_t b) {
        return boxes_[a].low[axis] + boxes_[a].high[axis] < boxes_[b].low[axis] + boxes_[b].high[axis];
      };
      if (!isInOrder_) std::nth_element(place(from), place(middle), place(to), isBefore);
      first = build(from, middle);
      second = build(middle, to);
    }
    nodes_[at] = {box, from, to, first, second};
    return at;
  }

  Triangle cornersOf(std::size_t t) const {
    Triangle out;
    for (std::size_t c = 0; c < 3; ++c) {
      const std::array<float, 3>& p = mesh_.positions[mesh_.triangles[t][c]];
      out[c] = {p[0], p[1], p[2]};
    }
    return out;
  }

  static Plane planeOf(const Triangle& t) {
    const Triple normal = cross(minus(t[1], t[0]), minus(t[2], t[0]));
    const double length = std::sqrt(dot(normal, normal));
    if (!(length > 0)) return {};
    const Triple unit{normal[0] / length, normal[1] / length, normal[2] / length};
    return {unit, dot(unit, t[0])};
  }

  std::optional<Triple> between(const Node& one, const Node& other, bool isSame) const {
    for (std::size_t i = one.from; i < one.to; ++i) {
      for (std::size_t j = isSame ? i + 1 : other.from; j < other.to; ++j) {
        const std::size_t s = order_[i], t = order_[j];
        if (!boxes_[s].meets(boxes_[t], touch_) || shared(s, t) > 1) continue;
        const Triangle a = cornersOf(s), b = cornersOf(t);
        if (isBeside(planes_[s], b) || isBeside(planes_[t], a) || !isDeep(a, b)) continue;
        Triple at{};
        for (std::size_t c = 0; c < 3; ++c) {
          for (std::size_t k = 0; k < 3; ++k) at[k] += (a[c][k] + b[c][k]) / 6;
        }
        return at;
      }
    }
    return std::nullopt;
  }

  /// How many corners both have.
  long shared(std::size_t s, std::size_t t) const {
    const auto& other = mesh_.triangles[t];
    return std::ranges::count_if(mesh_.triangles[s], [&](std::uint32_t v) { return std::ranges::count(other, v) > 0; });
  }

  /// Whether all of a triangle lies on one side of a plane. A triangle without a plane says nothing.
  bool isBeside(const Plane& plane, const Triangle& t) const {
    if (dot(plane.normal, plane.normal) == 0) return false;
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Triple& p : t) {
      const double from = dot(plane.normal, p) - plane.distance;
      least = std::min(least, from);
      most = std::max(most, from);
    }
    return most <= touch_ || least >= -touch_;
  }

  /// Whether no shift as short as `touch` takes two triangles, which no plane of theirs parts, out of one another: the
  /// shortest one that does is square to an edge of each (the faces of their Minkowski difference).
  bool isDeep(const Triangle& one, const Triangle& other) const {
    int axes = 0;
    for (std::size_t a = 0; a < 3; ++a) {
      for (std::size_t b = 0; b < 3; ++b) {
        const Triple axis = cross(minus(one[(a + 1) % 3], one[a]), minus(other[(b + 1) % 3], other[b]));
        const double length = std::sqrt(dot(axis, axis));
        if (!(length > 0)) continue;
        if (overlap(one, other, axis) <= touch_ * length) return false;
        ++axes;
      }
    }
    // Without any, both are pieces of parallel lines.
    return axes > 0;
  }

  /// How far two triangles overlap as seen along an axis, in lengths of it.
  static double overlap(const Triangle& one, const Triangle& other, const Triple& axis) {
    const auto [low, high] = std::minmax({dot(axis, one[0]), dot(axis, one[1]), dot(axis, one[2])});
    const auto [from, to] = std::minmax({dot(axis, other[0]), dot(axis, other[1]), dot(axis, other[2])});
    return std::min(high - from, to - low);
  }

  const TriMesh& mesh_;
  std::vector<std::size_t> order_;
  std::vector<Bounds> boxes_;
  std::vector<Plane> planes_;
  std::vector<Node> nodes_;
  Bounds whole_;
  double touch_ = 0;
  bool isInOrder_ = false;
};

}  // namespace

std::optional<std::array<double, 3>> selfCrossing(const TriMesh& mesh) {
  if (mesh.triangles.size() < 2) return std::nullopt;
  return Search(mesh).run();
}

}  // namespace spineloft::mesh
