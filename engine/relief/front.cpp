#include "engine/relief/front.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "engine/mesh/surface_places.h"

namespace spineloft::relief {
namespace {

constexpr float kFar = 1e30F;

PicturePoint inPicture(const Surface& surface, std::uint32_t vertex) {
  const auto& [u, v] = surface.mesh.uv[vertex];
  return {u * surface.picture.width - 0.5, v * surface.picture.height - 0.5};
}

// Twice the area in the picture, > 0 as seen from the front.
double turned(PicturePoint a, PicturePoint b, PicturePoint c) { return -cross(b - a, c - a); }

struct Extent {
  PicturePoint low{std::numeric_limits<double>::max(), std::numeric_limits<double>::max()};
  PicturePoint high{std::numeric_limits<double>::lowest(), std::numeric_limits<double>::lowest()};
  void add(PicturePoint p) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  double side() const { return std::max(high.x - low.x, high.y - low.y); }
};

using Corners = std::array<PicturePoint, 3>;
Corners cornersOf(const Surface& surface, std::uint32_t triangle) {
  const auto& [a, b, c] = surface.mesh.triangles[triangle];
  return {inPicture(surface, a), inPicture(surface, b), inPicture(surface, c)};
}

Extent extentOf(const Surface& surface) {
  Extent extent;
  for (std::uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const Corners corners = cornersOf(surface, t);
    if (!(turned(corners[0], corners[1], corners[2]) > 0)) continue;
    for (const PicturePoint p : corners) extent.add(p);
  }
  return extent;
}

Grid gridOver(const Extent& extent) {
  Grid grid;
  // A cell more on each side, so that the border of the part lies within.
  grid.cell = std::max(1.0, extent.side() / (kMostCells - 4));
  grid.width = static_cast<int>(std::ceil((extent.high.x - extent.low.x) / grid.cell)) + 3;
  grid.height = static_cast<int>(std::ceil((extent.high.y - extent.low.y) / grid.cell)) + 3;
  grid.corner = extent.low - grid.cell * PicturePoint{1, 1};
  return grid;
}

// Calls f(cell, shares of the corners) for the middles of cells in a triangle.
template <class F>
void eachCell(const Grid& grid, const Corners& corners, const F& f) {
  constexpr double kRounding = 1e-9;  // no middle falls between two triangles
  Corners p;
  std::ranges::transform(corners, p.begin(), [&](PicturePoint at) { return (at - grid.corner) / grid.cell; });
  const double area = turned(p[0], p[1], p[2]);
  if (area == 0) return;
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  const int x0 = std::max(0, static_cast<int>(std::ceil(left))), y0 = std::max(0, static_cast<int>(std::ceil(top)));
  const int x1 = std::min(grid.width - 1, static_cast<int>(std::floor(right)));
  const int y1 = std::min(grid.height - 1, static_cast<int>(std::floor(bottom)));
  for (int y = y0; y <= y1; ++y) {
    for (int x = x0; x <= x1; ++x) {
      const PicturePoint at{double(x), double(y)};
      const double a = turned(at, p[1], p[2]) / area, b = turned(p[0], at, p[2]) / area, c = 1 - a - b;
      if (std::min({a, b, c}) >= -kRounding) f(grid.at(x, y), std::array{a, b, c});
    }
  }
}

ModelPoint placeIn(const mesh::TriMesh& mesh, std::uint32_t triangle, const std::array<double, 3>& shares) {
  ModelPoint place;
  for (std::size_t k = 0; k < 3; ++k) place += shares[k] * mesh::modelPoint(mesh, mesh.triangles[triangle][k]);
  return place;
}

// 1 within closed lines, by even-odd.
Cells withinLines(const Grid& grid, const std::vector<std::vector<PicturePoint>>& lines) {
  Cells within(grid.size(), 0);
  std::vector<double> crossings;
  for (int y = 0; y < grid.height; ++y) {
    crossings.clear();
    const double level = grid.middle(0, y).y;
    for (const std::vector<PicturePoint>& line : lines) {
      for (std::size_t i = 0; i < line.size(); ++i) {
        const PicturePoint a = line[i], b = line[(i + 1) % line.size()];
        if ((a.y <= level) != (b.y <= level)) crossings.push_back(a.x + (b.x - a.x) * (level - a.y) / (b.y - a.y));
      }
    }
    std::ranges::sort(crossings);
    std::size_t passed = 0;
    for (int x = 0; x < grid.width; ++x) {
      while (passed < crossings.size() && crossings[passed] <= grid.middle(x, y).x) ++passed;
      within[grid.at(x, y)] = passed % 2;
    }
  }
  return within;
}

// From the part's picture to the working pixels of the one that gives the relief.
class Way {
 public:
  Way(const Relief& relief, const image::Picture& pixels)
      : width_(pixels.width),
        height_(pixels.height),
        across_(pixels.working.width / width_),
        down_(pixels.working.height / height_) {
    if (!relief.laid) return;
    const Laid& laid = *relief.laid;
    scale_ = width_ / laid.width;
    at_ = laid.at;
    cos_ = std::cos(laid.turn);
    sin_ = std::sin(laid.turn);
    to_ = PicturePoint{(width_ - 1) / 2, (height_ - 1) / 2};
  }
  PicturePoint operator()(PicturePoint p) const {
    const PicturePoint from = scale_ * (p - at_);
    const PicturePoint there = to_ + PicturePoint{cos_ * from.x + sin_ * from.y, cos_ * from.y - sin_ * from.x};
    return {(there.x + 0.5) * across_ - 0.5, (there.y + 0.5) * down_ - 0.5};
  }
  // Working pixels that a pixel of the part's picture is wide.
  double scale() const { return scale_ * across_; }

 private:
  double width_, height_, across_, down_;
  double scale_ = 1, cos_ = 1, sin_ = 0;
  PicturePoint at_, to_;
};

}  // namespace

double facing(const Surface& surface, std::uint32_t triangle) {
  const Corners corners = cornersOf(surface, triangle);
  const double area = norm(mesh::areaNormal(surface.mesh, triangle));
  return area > 0 ? turned(corners[0], corners[1], corners[2]) * surface.scale * surface.scale / area : 0;
}

PicturePoint cellOf(const Surface& surface, const Grid& grid, std::uint32_t vertex) {
  return (inPicture(surface, vertex) - grid.corner) / grid.cell;
}

std::optional<Front> frontOf(const Surface& surface) {
  const Extent extent = extentOf(surface);
  if (!(extent.side() >= kLeastSide)) return std::nullopt;
  Front front;
  front.grid = gridOver(extent);
  front.scale = surface.scale;
  front.size = extent.side();
  const Grid& grid = front.grid;
  const double unit = grid.cell * surface.scale;
  Values top(grid.size(), -kFar);
  std::vector<std::pair<std::size_t, std::array<float, 3>>> away;
  for (std::uint32_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const Corners corners = cornersOf(surface, t);
    const bool faces = turned(corners[0], corners[1], corners[2]) > 0;
    eachCell(grid, corners, [&](std::size_t at, const std::array<double, 3>& shares) {
      const ModelPoint p = placeIn(surface.mesh, t, shares);
      if (faces) top[at] = std::max(top[at], static_cast<float>(p.z / unit));
      if (!faces) away.push_back({at, {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}});
    });
  }
  front.firstBack.assign(grid.size() + 1, 0);
  for (const auto& [at, place] : away) ++front.firstBack[at + 1];
  for (std::size_t i = 0; i < grid.size(); ++i) front.firstBack[i + 1] += front.firstBack[i];
  front.backs.resize(away.size());
  std::vector<std::uint32_t> next(front.firstBack.begin(), front.firstBack.end() - 1);
  for (const auto& [at, place] : away) front.backs[next[at]++] = place;
  front.seen.resize(grid.size());
  front.z.resize(grid.size());
  for (std::size_t i = 0; i < grid.size(); ++i) {
    front.seen[i] = top[i] > -kFar;
    front.z[i] = front.seen[i] ? top[i] : 0;
  }
  return front;
}

double thicknessAt(const Front& front, double x, double y, ModelPoint place) {
  // A wall that is seen aslant is nearest beside the place.
  constexpr std::array kReaches = {1, 2, 3, 4, 6, 8, 11, 15, 20, 27};  // cells
  double least = std::numeric_limits<double>::infinity();
  const auto look = [&](int dx, int dy) {
    const int column = static_cast<int>(std::lround(x)) + dx, row = static_cast<int>(std::lround(y)) + dy;
    if (column < 0 || row < 0 || column >= front.grid.width || row >= front.grid.height) return;
    const std::size_t at = front.grid.at(column, row);
    for (std::uint32_t i = front.firstBack[at]; i < front.firstBack[at + 1]; ++i) {
      const auto& [px, py, pz] = front.backs[i];
      least = std::min(least, distance(place, ModelPoint{px, py, pz}));
    }
  };
  look(0, 0);
  for (const int reach : kReaches) {
    for (const int dx : {-reach, 0, reach}) {
      for (const int dy : {-reach, 0, reach}) {
        if (dx != 0 || dy != 0) look(dx, dy);
      }
    }
  }
  return least;
}

Shown shownOn(const Front& front, const Relief& relief, const image::Picture& pixels) {
  constexpr double kMostSamples = 4;  // of a cell, across: a picture is seldom finer
  constexpr double kOpaque = 0.5;     // of a cell: less is nothing
  const Grid& grid = front.grid;
  Shown shown{front.seen, std::vector<std::array<float, 3>>(grid.size())};
  const image::Image& from = pixels.working;
  const Way way(relief, pixels);
  const int samples = static_cast<int>(std::clamp(std::ceil(grid.cell * way.scale()), 1.0, kMostSamples));
  const Cells within = relief.region.empty() ? Cells{} : withinLines(grid, relief.region);
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const std::size_t at = grid.at(x, y);
      if (!shown.counts[at]) continue;
      std::array<double, 4> sums{};
      for (int k = 0; k < samples * samples; ++k) {
        const PicturePoint part{(k % samples + 0.5) / samples - 0.5, (k / samples + 0.5) / samples - 0.5};
        const PicturePoint p = way(grid.middle(x, y) + grid.cell * part);
        const int px = static_cast<int>(std::lround(p.x)), py = static_cast<int>(std::lround(p.y));
        if (px < 0 || py < 0 || px >= from.width || py >= from.height) continue;
        const std::uint8_t* rgba = &from.pixels[4 * (static_cast<std::size_t>(py) * from.width + px)];
        for (int c = 0; c < 3; ++c) sums[c] += rgba[c] * rgba[3];
        sums[3] += rgba[3];
      }
      shown.counts[at] = sums[3] > kOpaque * 255 * samples * samples && (within.empty() || within[at]);
      for (int c = 0; c < 3 && sums[3] > 0; ++c) shown.colour[at][c] = static_cast<float>(sums[c] / sums[3] / 255);
    }
  }
  return shown;
}

}  // namespace spineloft::relief
