// Drawings of the edges of solids that are known, for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <vector>

#include "engine/base/rng.h"
#include "engine/descriptive/drawing.h"

namespace spineloft::testing {

/// Corners, and faces counter-clockwise seen from outside.
struct KnownSolid {
  std::vector<ModelPoint> corners;
  std::vector<std::vector<std::uint32_t>> faces;
};

inline KnownSolid boxSolid(double x, double y, double z) {
  KnownSolid out;
  for (int i = 0; i < 8; ++i) out.corners.push_back({(i & 1) ? x : 0, (i & 2) ? y : 0, (i & 4) ? z : 0});
  out.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  return out;
}

/// A box with a gabled roof: 10 corners, 15 edges, 7 faces.
inline KnownSolid houseSolid(double x, double y, double z, double roof) {
  KnownSolid out = boxSolid(x, y, z);
  out.corners.push_back({x / 2, y + roof, 0});
  out.corners.push_back({x / 2, y + roof, z});
  out.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {0, 2, 8, 3, 1}, {4, 5, 7, 9, 6}, {2, 6, 9, 8}, {3, 8, 9, 7}};
  return out;
}

inline ModelPoint normalOfFace(const KnownSolid& solid, const std::vector<std::uint32_t>& face) {
  ModelPoint normal{};
  for (std::size_t i = 0; i < face.size(); ++i) {
    normal += cross(solid.corners[face[i]], solid.corners[face[(i + 1) % face.size()]]);
  }
  return normalized(normal);
}

inline std::vector<std::array<std::uint32_t, 2>> edgesOf(const KnownSolid& solid) {
  std::set<std::array<std::uint32_t, 2>> all;
  for (const auto& face : solid.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      const std::uint32_t a = face[i], b = face[(i + 1) % face.size()];
      all.insert({std::min(a, b), std::max(a, b)});
    }
  }
  return {all.begin(), all.end()};
}

/// Turned any way round from which every face keeps a fifth of its area and edges of different directions are 12°
/// apart: what a person would draw.
inline KnownSolid seenFromSomewhere(const KnownSolid& solid, Rng& rng) {
  for (;;) {
    std::array<double, 4> q{};
    double sum = 0;
    for (double& value : q) {
      value = rng.uniform(-1, 1);
      sum += value * value;
    }
    if (sum > 1 || sum < 0.01) continue;
    for (double& value : q) value /= std::sqrt(sum);
    const auto [w, x, y, z] = q;
    KnownSolid turned = solid;
    for (ModelPoint& p : turned.corners) {
      p = {(1 - 2 * (y * y + z * z)) * p.x + 2 * (x * y - w * z) * p.y + 2 * (x * z + w * y) * p.z,
           2 * (x * y + w * z) * p.x + (1 - 2 * (x * x + z * z)) * p.y + 2 * (y * z - w * x) * p.z,
           2 * (x * z - w * y) * p.x + 2 * (y * z + w * x) * p.y + (1 - 2 * (x * x + y * y)) * p.z};
    }
    bool clear = true;
    for (const auto& face : turned.faces) clear = clear && std::abs(normalOfFace(turned, face).z) > 0.2;
    const auto edges = edgesOf(turned);
    for (const auto& [a, b] : edges) {
      for (const auto& [c, d] : edges) {
        const ModelPoint one = turned.corners[b] - turned.corners[a], other = turned.corners[d] - turned.corners[c];
        if (norm(cross(normalized(one), normalized(other))) < 1e-6) continue;
        const double turn = std::abs(std::atan2(one.x * other.y - one.y * other.x, one.x * other.x + one.y * other.y));
        clear = clear && std::min(turn, std::numbers::pi - turn) > 12 * std::numbers::pi / 180;
      }
    }
    if (clear) return turned;
  }
}

/// A line for every edge, hidden where both its faces are seen from inside; 700 pixels at the longer side. Corners are
/// off by up to `jitter` of that.
inline descriptive::Drawing edgeDrawing(const KnownSolid& solid, double jitter, Rng& rng) {
  ModelPoint low = solid.corners[0], high = low;
  for (const ModelPoint p : solid.corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), 0};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), 0};
  }
  const double scale = 700 / std::max(high.x - low.x, high.y - low.y);
  std::vector<PicturePoint> at;
  for (const ModelPoint p : solid.corners) {
    const double angle = rng.uniform(0, 2 * std::numbers::pi), off = 700 * jitter * std::sqrt(rng.uniform(0, 1));
    at.push_back(
        {150 + (p.x - low.x) * scale + off * std::cos(angle), 850 - (p.y - low.y) * scale + off * std::sin(angle)});
  }
  descriptive::Drawing drawing;
  drawing.size = {1000, 1000};
  for (const auto& [a, b] : edgesOf(solid)) {
    bool hidden = true;
    for (const auto& face : solid.faces) {
      const bool has = std::ranges::find(face, a) != face.end() && std::ranges::find(face, b) != face.end();
      if (has && normalOfFace(solid, face).z > 0) hidden = false;
    }
    descriptive::Line line{{at[a], at[b]}, {}, false};
    if (hidden) line.hidden.push_back({0, 1});
    drawing.lines.push_back(std::move(line));
  }
  return drawing;
}

}  // namespace spineloft::testing
