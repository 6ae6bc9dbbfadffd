// Rays towards the viewer through the pieces of a drawing, for tests.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/descriptive/model.h"
#include "engine/geometry/polygon.h"
#include "tests/unit/descriptive/drawings.h"

namespace spineloft::testing {

/// Where rays along z enter and leave a closed mesh.
class Rays {
 public:
  explicit Rays(const mesh::TriMesh& mesh) : mesh_(mesh), cells_(kAcross * kAcross) {
    for (const auto& p : mesh.positions) {
      low_ = {std::min<double>(low_.x, p[0]), std::min<double>(low_.y, p[1])};
      high_ = {std::max<double>(high_.x, p[0]), std::max<double>(high_.y, p[1])};
    }
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      SectionPoint low{1e30, 1e30}, high{-1e30, -1e30};
      for (const std::uint32_t v : mesh.triangles[t]) {
        low = {std::min<double>(low.x, at(v).x), std::min<double>(low.y, at(v).y)};
        high = {std::max<double>(high.x, at(v).x), std::max<double>(high.y, at(v).y)};
      }
      for (int y = row(low.y); y <= row(high.y); ++y) {
        for (int x = column(low.x); x <= column(high.x); ++x) cells_[y * kAcross + x].push_back(t);
      }
    }
  }
  struct Hit {
    double front = -1e30, back = 1e30;
  };
  std::optional<Hit> through(SectionPoint p) const {
    if (p.x < low_.x || p.x > high_.x || p.y < low_.y || p.y > high_.y) return std::nullopt;
    Hit hit;
    for (const std::uint32_t t : cells_[row(p.y) * kAcross + column(p.x)]) {
      const auto& [i, j, k] = mesh_.triangles[t];
      const SectionPoint a = at(i), b = at(j), c = at(k);
      const double whole = cross(b - a, c - a);
      if (whole == 0) continue;
      const double u = cross(b - p, c - p) / whole, v = cross(c - p, a - p) / whole, w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      const double z = u * mesh_.positions[i][2] + v * mesh_.positions[j][2] + w * mesh_.positions[k][2];
      hit.front = std::max(hit.front, z);
      hit.back = std::min(hit.back, z);
    }
    return hit.front >= hit.back ? std::optional(hit) : std::nullopt;
  }

 private:
  static constexpr int kAcross = 48;
  SectionPoint at(std::uint32_t v) const { return {mesh_.positions[v][0], mesh_.positions[v][1]}; }
  int column(double x) const {
    return std::clamp(static_cast<int>((x - low_.x) / (high_.x - low_.x) * kAcross), 0, kAcross - 1);
  }
  int row(double y) const {
    return std::clamp(static_cast<int>((y - low_.y) / (high_.y - low_.y) * kAcross), 0, kAcross - 1);
  }
  const mesh::TriMesh& mesh_;
  SectionPoint low_{1e30, 1e30}, high_{-1e30, -1e30};
  std::vector<std::vector<std::uint32_t>> cells_;
};

struct Samples {
  std::size_t all = 0, wrong = 0;
};

/// Rays on a grid of 60 × 60 over every overlap whose order is not named as a contradiction: the nearer piece's front
/// before the other's front, its back before the other's back.
inline Samples lookAtOrders(const descriptive::Drawing& drawing, const descriptive::Model& model) {
  const std::vector<descriptive::Sheet> sheets = sheetsOf(drawing);
  const auto covers = [&](std::uint32_t piece, PicturePoint p) {
    bool inside = false;
    for (const auto& contour : sheets[piece].region) {
      if (geometry::holds(std::span<const PicturePoint>(contour), p)) inside = !inside;
    }
    return inside;
  };
  std::vector<Rays> rays;
  for (const descriptive::ModelPiece& one : model.solids) rays.emplace_back(one.mesh);
  Samples samples;
  for (std::uint32_t k = 0; k < model.orders.orders.size(); ++k) {
    const descriptive::Order& order = model.orders.orders[k];
    if (std::ranges::find(model.conflicts, std::array{order.over, order.under}) != model.conflicts.end()) continue;
    const descriptive::Overlaps& overlaps = model.orders.overlaps;
    PicturePoint low{1e30, 1e30}, high{-1e30, -1e30};
    for (const std::uint32_t cell : overlaps.all()[k].cells) {
      const PicturePoint p = overlaps.middle(cell);
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double edge = overlaps.step() / 2;
    for (int i = 0; i < 60; ++i) {
      for (int j = 0; j < 60; ++j) {
        const PicturePoint p{low.x - edge + (high.x - low.x + 2 * edge) * (i + 0.5) / 60,
                             low.y - edge + (high.y - low.y + 2 * edge) * (j + 0.5) / 60};
        if (!covers(order.over, p) || !covers(order.under, p)) continue;
        if (overlaps.at(order.over, order.under, p, 1) != k) continue;
        const auto over = rays[order.over].through({p.x, -p.y}), under = rays[order.under].through({p.x, -p.y});
        if (!over || !under) continue;
        ++samples.all;
        if (!(over->front > under->front && over->back > under->back)) ++samples.wrong;
      }
    }
  }
  return samples;
}

}  // namespace spineloft::testing
