#include "engine/descriptive/depth_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/geometry/polyline.h"

namespace spineloft::descriptive {
namespace {

MeshPlace corner(std::uint32_t point) { return {{point, point, point}, {1, 0, 0}}; }

/// Whether the outline that passes nearest to p is hidden there.
bool isHiddenAt(const Sheet& sheet, PicturePoint p) {
  bool hidden = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (const OutlinePath& outline : sheet.outlines) {
    const std::size_t n = outline.points.size();
    for (std::size_t i = 0; i < n; ++i) {
      const double away = geometry::distanceToSegment(p, outline.points[i], outline.points[(i + 1) % n]);
      if (away >= nearest) continue;
      nearest = away;
      hidden = outline.hidden[i];
    }
  }
  return hidden;
}

/// An edge of a mesh.
struct MeshEdge {
  std::uint32_t a, b;
  bool isRim;
};
std::vector<MeshEdge> edgesOf(const geometry::PlaneMesh& mesh) {
  std::vector<MeshEdge> edges;
  for (std::uint32_t h = 0; h < 3 * mesh.triangles().size(); ++h) {
    const std::uint32_t twin = mesh.twin(h);
    if (twin != geometry::PlaneMesh::kNone && twin < h) continue;
    edges.push_back({mesh.triangles()[h / 3][h % 3], mesh.triangles()[h / 3][h % 3 == 2 ? 0 : h % 3 + 1],
                     twin == geometry::PlaneMesh::kNone});
  }
  return edges;
}

/// A box in the plane of the meshes.
struct Box2 {
  SectionPoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  void add(SectionPoint p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  bool meets(const Box2& other) const {
    return low.x <= other.high.x && other.low.x <= high.x && low.y <= other.high.y && other.low.y <= high.y;
  }
};
Box2 boxOf(const geometry::PlaneMesh& mesh, MeshEdge edge) {
  Box2 box;
  box.add(mesh.points()[edge.a]);
  box.add(mesh.points()[edge.b]);
  return box;
}

/// Calls `each(edge of one, share, edge of other, share)` where edges of two meshes cross within a box.
template <class Each>
void forCrossings(const geometry::PlaneMesh& one, const std::vector<MeshEdge>& ownEdges,
                  const geometry::PlaneMesh& other, const std::vector<MeshEdge>& otherEdges, const Box2& within,
                  const Each& each) {
  constexpr int kAcross = 32;
  const double width = std::max(within.high.x - within.low.x, within.high.y - within.low.y) / kAcross;
  const auto cell = [&](double value, double low) {
    return std::clamp(static_cast<int>((value - low) / width), 0, kAcross - 1);
  };
  const auto forCells = [&](const Box2& box, const auto& visit) {
    const int left = cell(box.low.x, within.low.x), right = cell(box.high.x, within.low.x);
    for (int y = cell(box.low.y, within.low.y); y <= cell(box.high.y, within.low.y); ++y) {
      for (int x = left; x <= right; ++x) visit(static_cast<std::size_t>(y * kAcross + x));
    }
  };
  // Edges of the other one by cell: those of cell c are from first[c] to first[c + 1].
  std::vector<std::uint32_t> first(kAcross * kAcross + 1, 0), edges;
  std::vector<std::pair<std::uint32_t, Box2>> near;
  for (std::uint32_t k = 0; k < otherEdges.size(); ++k) {
    const Box2 box = boxOf(other, otherEdges[k]);
    if (!box.meets(within)) continue;
    near.emplace_back(k, box);
    forCells(box, [&](std::size_t at) { ++first[at + 1]; });
  }
  std::partial_sum(first.begin(), first.end(), first.begin());
  edges.resize(first.back());
  std::vector<std::uint32_t> next(first.begin(), first.end() - 1);
  for (std::uint32_t n = 0; n < near.size(); ++n) {
    forCells(near[n].second, [&](std::size_t at) { edges[next[at]++] = n; });
  }
  std::vector<std::uint32_t> lastSeen(near.size(), 0xffffffffu);
  for (std::uint32_t i = 0; i < ownEdges.size(); ++i) {
    const Box2 box = boxOf(one, ownEdges[i]);
    if (!box.meets(within)) continue;
    const SectionPoint a = one.points()[ownEdges[i].a], r = one.points()[ownEdges[i].b] - a;
    forCells(box, [&](std::size_t at) {
      for (std::uint32_t e = first[at]; e < first[at + 1]; ++e) {
        const auto& [k, its] = near[edges[e]];
        if (!box.meets(its) || std::exchange(lastSeen[edges[e]], i) == i) continue;
        const SectionPoint c = other.points()[otherEdges[k].a], q = other.points()[otherEdges[k].b] - c;
        const double whole = cross(r, q);
        if (whole == 0) continue;
        const double t = cross(c - a, q) / whole, u = cross(c - a, r) / whole;
        if (t > 0 && t < 1 && u > 0 && u < 1) each(ownEdges[i], t, otherEdges[k], u, a + r * t);
      }
    });
  }
}

/// Cells at most a reach away from those of an overlap.
class Nearby {
 public:
  Nearby(const Overlaps& overlaps, const std::vector<std::uint32_t>& cells, int reach) : overlaps_(overlaps) {
    for (const std::uint32_t cell : cells) {
      const auto [x, y] = overlaps.placeOf(overlaps.middle(cell));
      low_ = {std::min(low_[0], x - reach), std::min(low_[1], y - reach)};
      high_ = {std::max(high_[0], x + reach), std::max(high_[1], y + reach)};
    }
    is_.resize(static_cast<std::size_t>(high_[0] - low_[0] + 1) * static_cast<std::size_t>(high_[1] - low_[1] + 1));
    for (const std::uint32_t cell : cells) {
      const auto [x, y] = overlaps.placeOf(overlaps.middle(cell));
      for (int row = y - reach; row <= y + reach; ++row) {
        std::fill_n(is_.begin() + static_cast<std::ptrdiff_t>(at(x - reach, row)), 2 * reach + 1, char{1});
      }
    }
  }
  bool has(PicturePoint p) const {
    const auto [x, y] = overlaps_.placeOf(p);
    return x >= low_[0] && y >= low_[1] && x <= high_[0] && y <= high_[1] && is_[at(x, y)] != 0;
  }

 private:
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y - low_[1]) * static_cast<std::size_t>(high_[0] - low_[0] + 1) +
           static_cast<std::size_t>(x - low_[0]);
  }
  const Overlaps& overlaps_;
  std::array<int, 2> low_{1 << 30, 1 << 30}, high_{-(1 << 30), -(1 << 30)};
  std::vector<char> is_;
};

class Rows {
 public:
  explicit Rows(const DepthInput& input) : input_(input) {
    for (const Patch& patch : input.patches) edges_.push_back(edgesOf(patch.mesh()));
  }

  std::vector<OrderRow> all() {
    const auto& overlaps = input_.orders.overlaps.all();
    for (std::uint32_t k = 0; k < overlaps.size(); ++k) {
      const Order& order = input_.orders.orders[k];
      const double reach = (kReach + 1) * input_.orders.overlaps.step();
      const Nearby nearby(input_.orders.overlaps, overlaps[k].cells, kReach);
      nearby_ = &nearby;
      isAlone_ = std::ranges::count_if(overlaps, [&](const Overlap& one) {
                   return one.a == overlaps[k].a && one.b == overlaps[k].b;
                 }) == 1;
      Box2 box;
      for (const std::uint32_t cell : overlaps[k].cells) {
        const PicturePoint p = input_.orders.overlaps.middle(cell);
        box.add({p.x - reach, -p.y - reach});
        box.add({p.x + reach, -p.y + reach});
      }
      const bool isInside = order.kind == OrderKind::Inside;
      if (!isInside) addPoints(k, order.over, order.under, order, box);
      addPoints(k, order.under, order.over, order, box);
      if (!isInside) addCrossings(k, order, box);
    }
    return std::move(rows_);
  }

 private:
  /// Points so many cells away from the middles of an overlap's cells still belong to it.
  static constexpr int kReach = 4;

  bool isIn(std::uint32_t overlap, const Order& order, PicturePoint p) const {
    if (!nearby_->has(p)) return false;
    return isAlone_ || input_.orders.overlaps.at(order.over, order.under, p, kReach) == overlap;
  }
  /// Points of the mesh of `own` that are in the overlap with `other`.
  void addPoints(std::uint32_t overlap, std::uint32_t own, std::uint32_t other, const Order& order, const Box2& box) {
    const geometry::PlaneMesh& mesh = input_.patches[own].mesh();
    for (std::uint32_t i = 0; i < mesh.points().size(); ++i) {
      const bool isRim = i < mesh.rim();
      if (order.kind == OrderKind::Inside && !isRim) return;
      const SectionPoint at = mesh.points()[i];
      if (!Box2{at, at}.meets(box)) continue;
      const PicturePoint p{at.x, -at.y};
      const auto there = input_.patches[other].find(at);
      if (!there || !isIn(overlap, order, p)) continue;
      const PiecePlace here{own, corner(i)}, opposite{other, *there};
      if (order.kind == OrderKind::Inside) {
        if (isHiddenAt(input_.sheets[own], p)) {
          rows_.push_back({overlap, OrderRow::Kind::BehindFront, opposite, here});
          rows_.push_back({overlap, OrderRow::Kind::BeforeBack, here, opposite});
        } else {
          rows_.push_back({overlap, OrderRow::Kind::Before, here, opposite});
        }
        continue;
      }
      const bool isOver = own == order.over;
      const PiecePlace &a = isOver ? here : opposite, &b = isOver ? opposite : here;
      rows_.push_back({overlap, OrderRow::Kind::Surface, a, b});
      if (isRim) rows_.push_back({overlap, isOver ? OrderRow::Kind::OuterRim : OrderRow::Kind::InnerRim, a, b});
    }
  }
  /// Where edges of both meshes cross: with the points of both, all corners of the difference of the surfaces.
  void addCrossings(std::uint32_t overlap, const Order& order, const Box2& box) {
    const geometry::PlaneMesh &over = input_.patches[order.over].mesh(), &under = input_.patches[order.under].mesh();
    forCrossings(over, edges_[order.over], under, edges_[order.under], box,
                 [&](MeshEdge a, double t, MeshEdge b, double u, SectionPoint at) {
                   if (!isIn(overlap, order, {at.x, -at.y})) return;
                   const PiecePlace nearer{order.over, {{a.a, a.b, a.b}, {1 - t, t, 0}}};
                   const PiecePlace farther{order.under, {{b.a, b.b, b.b}, {1 - u, u, 0}}};
                   rows_.push_back({overlap, OrderRow::Kind::Surface, nearer, farther});
                   if (a.isRim) rows_.push_back({overlap, OrderRow::Kind::OuterRim, nearer, farther});
                   if (b.isRim) rows_.push_back({overlap, OrderRow::Kind::InnerRim, nearer, farther});
                 });
  }

  const DepthInput& input_;
  std::vector<std::vector<MeshEdge>> edges_;  ///< by piece
  const Nearby* nearby_ = nullptr;            ///< of the overlap that is looked at
  bool isAlone_ = false;                      ///< its pieces overlap nowhere else
  std::vector<OrderRow> rows_;
};

}  // namespace

std::vector<OrderRow> orderRows(const DepthInput& input) { return Rows(input).all(); }

double leastOf(const OrderRow& row, std::span<const PieceDepth> depths) {
  const PieceDepth &a = depths[row.a.piece], &b = depths[row.b.piece];
  switch (row.kind) {
    case OrderRow::Kind::OuterRim:
      return row.b.at.of(b.front) + kGap;
    case OrderRow::Kind::InnerRim:
      return row.a.at.of(a.back) + kGap;
    case OrderRow::Kind::Surface:
      return std::max(row.b.at.of(b.front) - row.a.at.of(a.front), row.a.at.of(a.back) - row.b.at.of(b.back)) +
             kGap / 2;
    case OrderRow::Kind::Before:
      return row.b.at.of(b.front);
    case OrderRow::Kind::BehindFront:
      return -row.a.at.of(a.front);
    case OrderRow::Kind::BeforeBack:
      return -row.b.at.of(b.back);
    case OrderRow::Kind::kCount:
      break;
  }
  return 0;
}

}  // namespace spineloft::descriptive
