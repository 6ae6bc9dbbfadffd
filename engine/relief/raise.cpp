#include "engine/relief/raise.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>
#include <utility>

#include "engine/mesh/cut_mesh.h"
#include "engine/mesh/kept_share.h"
#include "engine/mesh/shading.h"

namespace spineloft::relief {
namespace {

constexpr double kFlattest = 0.15,
                 kSteepest = 0.35;  // of facing: what faces less stays, what faces more goes all the way
constexpr double kWall = 0.4;       // of the thickness: the deepest groove
constexpr double kOff = 0.04;       // of the height: nearer to the heights need a mesh not be
constexpr double kBehind = 10;      // cells: what is so far behind the front, and does not face it, is not seen
constexpr double kNothing = 1e-4;   // of the height: rounding
constexpr double kShortest = 1.5;   // cells: shorter edges are not split

// How much heights bend, and the most of it near any place.
class Bends {
 public:
  Bends(const Grid& grid, const Values& heights) {
    levels_.push_back({grid.width, grid.height, Values(grid.size(), 0)});
    const auto at = [&](int x, int y) {
      return heights[grid.at(std::clamp(x, 0, grid.width - 1), std::clamp(y, 0, grid.height - 1))];
    };
    for (int y = 0; y < grid.height; ++y) {
      for (int x = 0; x < grid.width; ++x) {
        const float across = at(x - 1, y) - 2 * at(x, y) + at(x + 1, y),
                    down = at(x, y - 1) - 2 * at(x, y) + at(x, y + 1);
        const float aslant = (at(x + 1, y + 1) - at(x - 1, y + 1) - at(x + 1, y - 1) + at(x - 1, y - 1)) / 4;
        levels_[0].most[grid.at(x, y)] = std::sqrt(across * across + down * down + 2 * aslant * aslant);
      }
    }
    while (levels_.back().width > 1 || levels_.back().height > 1) halve();
  }

  // The most within a rectangle, or a little more, cells.
  double most(double left, double top, double right, double bottom) const {
    const double side = std::max({right - left, bottom - top, 1.0});
    const auto level = std::min(levels_.size() - 1, static_cast<std::size_t>(std::ceil(std::log2(side))));
    const auto& [width, height, values] = levels_[level];
    const double cell = std::exp2(static_cast<double>(level));
    const auto within = [&](double v, int count) {
      return std::clamp(static_cast<int>((v + 0.5) / cell), 0, count - 1);
    };
    float most = 0;
    for (int y = within(top, height); y <= within(bottom, height); ++y) {
      for (int x = within(left, width); x <= within(right, width); ++x) {
        most = std::max(most, values[static_cast<std::size_t>(y) * width + x]);
      }
    }
    return most;
  }

 private:
  struct Level {
    int width, height;
    Values most;
  };
  void halve() {
    const Level& fine = levels_.back();
    Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    coarse.most.resize(static_cast<std::size_t>(coarse.width) * coarse.height, 0);
    for (int y = 0; y < fine.height; ++y) {
      for (int x = 0; x < fine.width; ++x) {
        float& most = coarse.most[static_cast<std::size_t>(y / 2) * coarse.width + x / 2];
        most = std::max(most, fine.most[static_cast<std::size_t>(y) * fine.width + x]);
      }
    }
    levels_.push_back(std::move(coarse));
  }

  std::vector<Level> levels_;
};

class Raiser {
 public:
  Raiser(const Surface& surface, const Front& front, const Values& heights)
      : front_(front),
        heights_(heights),
        bends_(front.grid, heights),
        surface_(surface),
        drawn_(mesh::shade(surface.mesh)),
        origins_(surface.mesh.triangles.size()),
        cut_(surface.mesh),
        now_{cut_.mesh(), surface.picture, surface.scale} {
    std::iota(origins_.begin(), origins_.end(), 0u);
  }

  Raised make(std::size_t most) {
    refine(most);
    Raised raised{cut_.mesh(), {}, front_.size * front_.scale};
    move(raised);
    return raised;
  }

 private:
  void refine(std::size_t most);
  void move(Raised& raised) const;
  double off(std::uint32_t triangle) const;
  ModelPoint normalIn(std::uint32_t triangle, ModelPoint place) const;

  const Front& front_;
  const Values& heights_;
  Bends bends_;
  const Surface& surface_;
  mesh::ShadedMesh drawn_;
  std::vector<std::uint32_t> origins_;  // of each triangle the one of the surface that it is cut from
  mesh::CutMesh cut_;
  Surface now_;  // as it is cut so far
};

// How far a triangle is off from the heights at most: L²/8 of what they bend; 0: it is to stay as it is.
double Raiser::off(std::uint32_t triangle) const {
  if (facing(now_, triangle) < kFlattest) return 0;
  const auto& [a, b, c] = cut_.mesh().triangles[triangle];
  const std::array<PicturePoint, 3> p{cellOf(now_, front_.grid, a), cellOf(now_, front_.grid, b),
                                      cellOf(now_, front_.grid, c)};
  const double longest = std::max({distance(p[0], p[1]), distance(p[1], p[2]), distance(p[2], p[0])});
  if (longest <= kShortest) return 0;
  const auto [left, right] = std::minmax({p[0].x, p[1].x, p[2].x});
  const auto [top, bottom] = std::minmax({p[0].y, p[1].y, p[2].y});
  // Heights are within ±1, so that nothing is farther off than 2.
  return std::min(2.0, longest * longest / 8 * bends_.most(left, top, right, bottom));
}

void Raiser::refine(std::size_t most) {
  using Wanted = std::pair<double, std::uint32_t>;
  std::priority_queue<Wanted> work;
  const auto add = [&](std::uint32_t triangle) {
    const double much = off(triangle);
    if (much > kOff) work.emplace(much, triangle);
  };
  for (std::uint32_t t = 0; t < cut_.triangles(); ++t) add(t);
  while (!work.empty() && cut_.triangles() < most) {
    const auto [much, triangle] = work.top();
    work.pop();
    if (off(triangle) != much) continue;  // it was split since, and stands here anew
    const std::uint32_t half = cut_.terminal(triangle), across = cut_.twin(half);
    const auto first = static_cast<std::uint32_t>(cut_.triangles());
    if (cut_.split(half, 0.5) == mesh::kNone) continue;
    origins_.push_back(origins_[half / 3]);
    origins_.push_back(origins_[across / 3]);
    for (const std::uint32_t other : {half / 3, across / 3, first, first + 1}) add(other);
    if (half / 3 != triangle && across / 3 != triangle) add(triangle);
  }
}

// Of the surface as it is drawn, so that its facets do not show in the way that a vertex takes: between the corners of
// the triangle that it is cut from.
ModelPoint Raiser::normalIn(std::uint32_t triangle, ModelPoint place) const {
  const auto& corners = surface_.mesh.triangles[origins_[triangle]];
  const ModelPoint a = mesh::modelPoint(surface_.mesh, corners[0]), b = mesh::modelPoint(surface_.mesh, corners[1]),
                   c = mesh::modelPoint(surface_.mesh, corners[2]), area = cross(b - a, c - a);
  const double all = dot(area, area);
  if (!(all > 0)) return {};
  const double shareB = dot(cross(place - a, c - a), area) / all, shareC = dot(cross(b - a, place - a), area) / all;
  const std::array<double, 3> shares{1 - shareB - shareC, shareB, shareC};
  ModelPoint normal;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [x, y, z] = drawn_.normals[drawn_.triangles[origins_[triangle]][k]];
    normal += shares[k] * ModelPoint{x, y, z};
  }
  return normalized(normal);
}

void Raiser::move(Raised& raised) const {
  const mesh::TriMesh& mesh = raised.mesh;
  std::vector<std::uint32_t> triangles(mesh.positions.size());  // any that it is a corner of
  std::vector<double> faces(mesh.positions.size(), 1);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const double facing = relief::facing(now_, t);
    for (const std::uint32_t vertex : mesh.triangles[t]) {
      triangles[vertex] = t;
      faces[vertex] = std::min(faces[vertex], facing);
    }
  }
  for (std::uint32_t vertex = 0; vertex < triangles.size(); ++vertex) {
    const double share = std::clamp((faces[vertex] - kFlattest) / (kSteepest - kFlattest), 0.0, 1.0);
    if (share == 0) continue;
    const PicturePoint at = cellOf(now_, front_.grid, vertex);
    const ModelPoint place = mesh::modelPoint(mesh, vertex);
    const double rise = share * sample(front_.grid, heights_, at.x, at.y);
    const double behind = sample(front_.grid, front_.z, at.x, at.y) - place.z / (front_.grid.cell * front_.scale);
    if (std::abs(rise) < kNothing || behind > kBehind) continue;
    const double deepest = kWall * thicknessAt(front_, at.x, at.y, place);
    raised.moved.push_back({vertex, normalIn(triangles[vertex], place), rise, deepest});
  }
}

}  // namespace

Raised raisedBy(const Surface& surface, const Front& front, const Values& heights, std::size_t most) {
  return Raiser(surface, front, heights).make(most);
}

void moveMesh(const Raised& raised, double height, mesh::TriMesh& out) {
  out = raised.mesh;
  for (const auto& [vertex, normal, rise, deepest] : raised.moved) {
    const double way = std::max(-deepest, height * raised.size * rise);
    auto& p = out.positions[vertex];
    p = {static_cast<float>(p[0] + way * normal.x), static_cast<float>(p[1] + way * normal.y),
         static_cast<float>(p[2] + way * normal.z)};
  }
}

double raiseMesh(const Raised& raised, double height, mesh::TriMesh& out) {
  const auto moveTo = [&](double share, mesh::TriMesh& to) { moveMesh(raised, share * height, to); };
  return mesh::keptShare(raised.mesh, moveTo, out);
}

std::size_t bytesOf(const Raised& raised) {
  const mesh::TriMesh& mesh = raised.mesh;
  return sizeof(raised) + raised.moved.size() * sizeof(Raised::Moved) +
         mesh.positions.size() * sizeof(mesh.positions[0]) + mesh.uv.size() * sizeof(mesh.uv[0]) +
         mesh.triangles.size() * sizeof(mesh.triangles[0]);
}

}  // namespace spineloft::relief
