// Closed polygons in a plane: measures and validity. A polygon is a list of corners, the last one
// not repeated; its space is that of its points. Counter-clockwise means: with x right and y up.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::geometry {

/// Signed area in square units of the space: positive when counter-clockwise. 0 below 3 corners.
template <class V>
double signedArea(std::span<const V> polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return twice / 2;
}

/// Whether `p` lies within the polygon (even-odd rule; on an edge either answer may come).
template <class V>
bool holds(std::span<const V> polygon, V p) {
  bool inside = false;
  for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
    const V a = polygon[i], b = polygon[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

/// Centre of the area; the mean of the corners when the area is 0. ≥ 1 corner.
SectionPoint centroid(std::span<const SectionPoint> polygon);

/// Whether no two edges touch except neighbours in their common corner, and no edge has length 0.
/// All coordinates finite. Cost: near linear (a sweep along x).
bool isSimple(std::span<const SectionPoint> polygon);

/// The same of several polygons together: each simple, and none touches another. The way of holes is
/// not looked at. `sizes`: corners of each, one after the other in `points`.
bool areSimple(std::span<const SectionPoint> points, std::span<const std::size_t> sizes);

/// The polygon with as few of its corners as leave all others within `tolerance` of it (Douglas and Peucker 1973, from
/// the corners farthest left and right). It may touch itself where it was nearer to itself than that.
std::vector<SectionPoint> simplified(std::span<const SectionPoint> polygon, double tolerance);

/// A point that sees every edge of the counter-clockwise polygon from inside: the centre of all such
/// points (its kernel). None when there is no such point, or hardly one. Cost: corners × kernel's
/// corners.
std::optional<SectionPoint> kernelCentre(std::span<const SectionPoint> polygon);

/// Whether `p` sees every edge of the counter-clockwise polygon from inside, with at least `margin`
/// (units of the space) to the line of each edge: then a fan of triangles from `p` fills it.
bool seesAllEdges(std::span<const SectionPoint> polygon, SectionPoint p, double margin);

}  // namespace spineloft::geometry
