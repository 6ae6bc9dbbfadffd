#include "engine/stack/skin.h"

#include <algorithm>

#include "engine/geometry/triangulate.h"
#include "engine/mesh/front_uv.h"

namespace spineloft::stack {

std::uint32_t Skin::vertex(ModelPoint p) {
  mesh_.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
  mesh_.uv.push_back(uvOf(p, picture_));
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

std::array<float, 2> Skin::uvOf(ModelPoint p, image::Size picture) {
  return mesh::frontUv(p.x, p.y, {static_cast<double>(picture.width), static_cast<double>(picture.height)});
}

ModelPoint Skin::at(std::uint32_t v) const {
  const auto& p = mesh_.positions[v];
  return {p[0], p[1], p[2]};
}

void Skin::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool turned) {
  if (turned) std::swap(b, c);
  mesh_.triangles.push_back({a, b, c});
}

void Skin::strip(const RingVertices& a, const RingVertices& b, bool inwards) {
  constexpr double kAlike = 1 - 1e-5;  // of two diagonals about as long always the same one
  for (std::size_t k = 0; k < a.size(); ++k) {
    const std::size_t l = k + 1 < a.size() ? k + 1 : 0;
    if (distance(at(a[l]), at(b[k])) < distance(at(a[k]), at(b[l])) * kAlike) {
      triangle(a[k], a[l], b[k], inwards);
      triangle(a[l], b[l], b[k], inwards);
    } else {
      triangle(a[k], a[l], b[l], inwards);
      triangle(a[k], b[l], b[k], inwards);
    }
  }
}

void Skin::zip(const RingVertices& a, const RingVertices& b, bool inwards) {
  const std::size_t rows = a.size() + 1, columns = b.size() + 1;
  const auto edge = [&](std::size_t i, std::size_t j) { return distance(at(a[i % a.size()]), at(b[j % b.size()])); };
  std::vector<double> least(rows * columns, 0.0);
  std::vector<bool> alongA(rows * columns, false);  // the last step to here
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      if (i + j == 0) continue;
      const std::size_t here = i * columns + j;
      alongA[here] = j == 0 || (i > 0 && least[here - columns] < least[here - 1]);
      least[here] = least[alongA[here] ? here - columns : here - 1] + edge(i, j);
    }
  }
  std::size_t i = a.size(), j = b.size();
  while (i + j > 0) {
    const std::uint32_t p = a[i % a.size()], q = b[j % b.size()];
    if (alongA[i * columns + j]) {
      triangle(a[--i], p, q, inwards);
    } else {
      triangle(p, q, b[--j], inwards);
    }
  }
}

void Skin::cone(const RingVertices& ring, std::uint32_t tip, bool before) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    triangle(ring[k], ring[k + 1 < ring.size() ? k + 1 : 0], tip, before);
  }
}

bool Skin::lid(const Rim& outer, const std::vector<Rim>& holes, bool before) {
  std::vector<SectionPoint> points(outer.points.begin(), outer.points.end());
  RingVertices vertices = outer.ring;
  std::vector<std::size_t> sizes{points.size()};
  for (const Rim& hole : holes) {
    points.insert(points.end(), hole.points.rbegin(), hole.points.rend());
    vertices.insert(vertices.end(), hole.ring.rbegin(), hole.ring.rend());
    sizes.push_back(hole.points.size());
  }
  const auto triangles = geometry::triangulate(points, sizes);
  for (const auto& [a, b, c] : triangles) triangle(vertices[a], vertices[b], vertices[c], before);
  return !triangles.empty();
}

}  // namespace spineloft::stack
