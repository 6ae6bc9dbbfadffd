#include "engine/pipeline/outline_match.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "engine/geometry/line_distance.h"
#include "engine/geometry/polyline.h"
#include "engine/pipeline/silhouette.h"

namespace spineloft::pipeline {
namespace {

constexpr int kCells = 2048, kMargin = 256;

using Ring = std::vector<PicturePoint>;

Ring closedLine(const geometry::Contours& outline) {
  if (outline.empty()) return {};
  Ring ring = outline.front();
  if (outline.size() < 2 || ring.empty() || outline[1].empty()) return ring;
  Ring other = outline[1];
  if (distance(ring.back(), other.front()) > distance(ring.back(), other.back())) std::ranges::reverse(other);
  ring.insert(ring.end(), other.begin(), other.end());
  return ring;
}

/// Cells whose centres the ring holds (even-odd).
image::Mask filled(const Ring& ring, image::Size size) {
  image::Mask mask{size.width, size.height, {}};
  mask.pixels.assign(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), 0);
  std::vector<double> crossings;
  for (int y = 0; y < size.height; ++y) {
    crossings.clear();
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const PicturePoint a = ring[i], b = ring[j];
      if ((a.y > y) != (b.y > y)) crossings.push_back((b.x - a.x) * (y - a.y) / (b.y - a.y) + a.x);
    }
    std::ranges::sort(crossings);
    for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) {
      const int from = std::max(0, static_cast<int>(std::ceil(crossings[i])));
      const int to = std::min(size.width - 1, static_cast<int>(std::floor(crossings[i + 1])));
      for (int x = from; x <= to; ++x) {
        mask.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) + static_cast<std::size_t>(x)] =
            255;
      }
    }
  }
  return mask;
}

/// Middles of the edges between cells that are in and cells that are out.
std::vector<PicturePoint> borderOf(const image::Mask& mask) {
  std::vector<PicturePoint> border;
  const auto in = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) return false;
    return mask.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(mask.width) +
                       static_cast<std::size_t>(x)] != 0;
  };
  for (int y = 0; y < mask.height; ++y) {
    for (int x = 0; x < mask.width; ++x) {
      if (!in(x, y)) continue;
      if (!in(x - 1, y)) border.push_back({x - 0.5, static_cast<double>(y)});
      if (!in(x + 1, y)) border.push_back({x + 0.5, static_cast<double>(y)});
      if (!in(x, y - 1)) border.push_back({static_cast<double>(x), y - 0.5});
      if (!in(x, y + 1)) border.push_back({static_cast<double>(x), y + 0.5});
    }
  }
  return border;
}

/// Distances of points of the ring, about every four cells, to the border.
void toBorder(const Ring& ring, std::span<const PicturePoint> border, std::vector<double>& distances) {
  Ring closed = ring;
  closed.push_back(ring.front());
  const double length = geometry::arcLengths(std::span<const PicturePoint>(closed)).back();
  const auto count = std::max<std::size_t>(2, static_cast<std::size_t>(length / 4));
  for (const PicturePoint p : geometry::resample(std::span<const PicturePoint>(closed), count)) {
    double least = INFINITY;
    for (const PicturePoint q : border) least = std::min(least, dot(p - q, p - q));
    distances.push_back(std::sqrt(least));
  }
}

}  // namespace

mesh::TriMesh seenIn(const mesh::TriMesh& modelSpace, const std::optional<geometry::View>& view) {
  mesh::TriMesh seen = modelSpace;
  if (!view) return seen;
  for (auto& p : seen.positions) {
    const PicturePoint at = geometry::inView(*view, {p[0], p[1], p[2]});
    p = {static_cast<float>(at.x), static_cast<float>(-at.y), 0};
  }
  return seen;
}

OutlineMatch matchOutline(const mesh::TriMesh& modelSpace, const std::optional<geometry::View>& view,
                          const geometry::Contours& outline) {
  Ring ring = closedLine(outline);
  if (ring.size() < 3) return {};
  const auto [left, right] = std::ranges::minmax(ring, {}, &PicturePoint::x);
  const auto [top, bottom] = std::ranges::minmax(ring, {}, &PicturePoint::y);
  const double size = std::max(right.x - left.x, bottom.y - top.y), cells = kCells / size;
  if (!(size > 0)) return {};
  const PicturePoint low{left.x, top.y};
  const auto toGrid = [&](PicturePoint p) { return (p - low) * cells + PicturePoint{kMargin, kMargin}; };
  for (PicturePoint& p : ring) p = toGrid(p);
  mesh::TriMesh seen = seenIn(modelSpace, view);
  for (auto& p : seen.positions) {
    const PicturePoint at = toGrid({p[0], -static_cast<double>(p[1])});
    p = {static_cast<float>(at.x), static_cast<float>(-at.y), 0};
  }
  const image::Size grid{static_cast<int>((right.x - left.x) * cells) + 2 * kMargin,
                         static_cast<int>((bottom.y - top.y) * cells) + 2 * kMargin};
  const image::Mask wanted = filled(ring, grid), found = rasteriseSilhouette(seen, grid);
  double both = 0, either = 0;
  for (std::size_t i = 0; i < wanted.pixels.size(); ++i) {
    both += wanted.pixels[i] != 0 && found.pixels[i] != 0;
    either += wanted.pixels[i] != 0 || found.pixels[i] != 0;
  }
  const std::vector<PicturePoint> border = borderOf(found);
  if (border.empty() || either == 0) return {};
  std::vector<double> distances;
  for (const PicturePoint p : border)
    distances.push_back(geometry::distanceToLine(p, std::span<const PicturePoint>(ring), true));
  toBorder(ring, border, distances);
  OutlineMatch match{both / either, *std::ranges::max_element(distances) / kCells, 0};
  for (const double away : distances) match.mean += away / kCells / static_cast<double>(distances.size());
  return match;
}

}  // namespace spineloft::pipeline
