// Points spread over a region, for surfaces above it: near the rim as dense as the surface is steep.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/geometry/refine.h"

namespace spineloft::geometry {

/// How a surface stands over a plane region.
struct SurfaceOver {
  /// Distances from the rim at which rows of points follow it, for each corner of the rim; growing.
  std::function<std::vector<double>(std::size_t corner)> rows;
  std::function<double(SectionPoint)> height;  ///< over a point
  std::vector<SectionPoint> features = {};     ///< points that it needs before all others (ridge.h)
};

/// How far points lie from each other on the surface, about.
struct Spacing {
  double rows = 1;     ///< those of the rows
  double lattice = 1;  ///< and all others; not less
};

/// Adds points to a mesh of a region that has only its rim: its features, rows along it, then a triangular
/// lattice, each only where it is the spacing · kNearest away from all others, measured on the surface. Ends with
/// splitChords. `sizes`: corners of each outline, as the mesh was made of.
void spreadPoints(PlaneMesh& mesh, std::span<const std::size_t> sizes, Spacing spacing, const SurfaceOver& surface);

inline constexpr double kNearest = 0.62;

/// Distances to outlines, from a grid of their edges.
class RimDistance {
 public:
  /// The outlines must outlive it; ≥ 1 point.
  RimDistance(std::span<const SectionPoint> rim, std::span<const std::size_t> sizes);
  /// From any point; exact.
  double to(SectionPoint p) const { return nearest(p).distance; }
  /// The nearest edge to any point, by its first corner, and its distance. An outline of two corners is a segment, one
  /// of one corner a point.
  struct Nearest {
    double distance;
    std::uint32_t edge;
  };
  Nearest nearest(SectionPoint p) const;

 private:
  struct Edge {
    SectionPoint a, b;
    std::uint32_t from;
  };
  struct Cell {
    int x, y;
  };
  Cell cellOf(SectionPoint p) const;
  void lookAround(Cell at, int reach, SectionPoint p, Nearest& best) const;
  SectionPoint low_{};
  double cell_ = 1;
  int nx_ = 1, ny_ = 1;
  std::vector<std::uint32_t> first_;  ///< by cell: where its edges begin in `edges_`
  std::vector<Edge> edges_;
};

}  // namespace spineloft::geometry
