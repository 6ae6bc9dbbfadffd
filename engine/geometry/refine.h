// Triangulations that take one point after the other and stay well shaped: Lawson's edge flips within
// fixed outlines.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// The constrained Delaunay triangulation of a plane region: outer polygons counter-clockwise, holes
/// clockwise (see triangulate). Its edges are never cut; points come in between. Triangles are
/// counter-clockwise. All coordinates finite, in any unit; x right, y up.
class PlaneMesh {
 public:
  using Triangle = std::array<std::uint32_t, 3>;

  /// `sizes`: corners of each polygon, one after the other in `points`. Empty (no triangles) when the
  /// polygons are not simple.
  PlaneMesh(std::span<const SectionPoint> points, std::span<const std::size_t> sizes);

  const std::vector<SectionPoint>& points() const { return points_; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  /// The first so many points are the corners given at the start.
  std::size_t rim() const { return rim_; }
  bool empty() const { return triangles_.empty(); }

  /// A new point; its index, or none when it lies outside, on the rim, or on another point. Cost: a
  /// walk from the last points near by, and a few flips.
  std::optional<std::uint32_t> insert(SectionPoint p);
  /// A point in the middle of every edge that joins two corners of the rim across the region, so that
  /// every triangle has a corner inside.
  void splitChords();

  /// The triangle that holds p; none outside. `near`: a triangle from where p is not far, looked from first.
  std::optional<std::uint32_t> find(SectionPoint p, std::uint32_t near = kNone) const;

  /// Flips every edge for which `better(a, b, c, d)` says that the edge c–d would be better than a–b;
  /// a and b are its ends, c lies to the left of a → b, d to the right. Only where both new triangles
  /// keep their way round. At most `rounds` times over all edges.
  template <class Better>
  void flipWhere(const Better& better, int rounds) {
    for (int round = 0; round < rounds; ++round) {
      bool any = false;
      for (std::uint32_t h = 0; h < twins_.size(); ++h) {
        if (twins_[h] == kNone || twins_[h] < h || !canFlip(h)) continue;
        const Quad q = quadOf(h);
        if (!better(q.a, q.b, q.c, q.d)) continue;
        flip(h);
        any = true;
      }
      if (!any) return;
    }
  }
  /// Moves a point that is no corner of the rim as far towards `to` as all its triangles keep their
  /// way round; `around` are its triangles (fanOf).
  void move(std::uint32_t point, SectionPoint to, std::span<const std::uint32_t> around);
  /// The triangles round every point, in no order: `first[p]` … `first[p + 1]` of `of`.
  struct Fans {
    std::vector<std::uint32_t> first, of;
    std::span<const std::uint32_t> at(std::uint32_t p) const {
      return std::span(of).subspan(first[p], first[p + 1] - first[p]);
    }
  };
  Fans fans() const;

  /// No half-edge. Half-edge 3 · triangle + corner runs from that corner to the triangle's next one.
  static constexpr std::uint32_t kNone = 0xffffffffu;
  /// The half-edge that runs the other way along the same edge; kNone on the rim.
  std::uint32_t twin(std::uint32_t halfEdge) const { return twins_[halfEdge]; }

 private:
  struct Quad {
    std::uint32_t a, b, c, d;  ///< edge a → b, c left of it, d right
  };
  static std::uint32_t next(std::uint32_t h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static std::uint32_t last(std::uint32_t h) { return h % 3 == 0 ? h + 2 : h - 1; }
  std::uint32_t from(std::uint32_t h) const { return triangles_[h / 3][h % 3]; }
  Quad quadOf(std::uint32_t h) const;
  bool canFlip(std::uint32_t h) const;
  bool wantsFlip(std::uint32_t h) const;
  void flip(std::uint32_t h);
  void legalise();
  void link(std::uint32_t h, std::uint32_t twin);
  void splitTriangle(std::uint32_t t, std::uint32_t p);
  void splitEdge(std::uint32_t h, std::uint32_t p);
  std::uint32_t walk(SectionPoint p, std::uint32_t start) const;
  std::size_t bucketOf(SectionPoint p) const;
  void pairUp();

  std::vector<SectionPoint> points_;
  std::vector<Triangle> triangles_;
  std::vector<std::uint32_t> twins_;     ///< by half-edge 3 · triangle + corner; kNone on the rim
  std::vector<std::uint32_t> doubtful_;  ///< half-edges that a flip might improve
  std::size_t rim_ = 0;
  SectionPoint low_{};
  double cell_ = 1;
  std::size_t across_ = 1;
  std::vector<std::uint32_t> hints_;  ///< by cell of a grid: a triangle that was near it
};

}  // namespace spineloft::geometry
