#include "engine/mesh/two_sided.h"

#include <algorithm>

namespace spineloft::mesh {
namespace {

class Builder {
 public:
  explicit Builder(PictureSize picture) : picture_(picture) {}

  std::uint32_t add(SectionPoint p, double z) {
    mesh_.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(z)});
    const double u = (p.x + 0.5) / picture_.width, v = (0.5 - p.y) / picture_.height;
    mesh_.uv.push_back({static_cast<float>(std::clamp(u, 0.0, 1.0)), static_cast<float>(std::clamp(v, 0.0, 1.0))});
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  /// The points of a side from `first` on; their indices.
  std::vector<std::uint32_t> addPoints(const Side& side, std::size_t first) {
    std::vector<std::uint32_t> index;
    for (std::size_t i = first; i < side.plane.points().size(); ++i) {
      index.push_back(add(side.plane.points()[i], side.height[i]));
    }
    return index;
  }
  void addTriangles(const Side& side, const std::vector<std::uint32_t>& index, bool reversed) {
    for (const auto& [a, b, c] : side.plane.triangles()) {
      if (reversed) {
        mesh_.triangles.push_back({index[a], index[c], index[b]});
      } else {
        mesh_.triangles.push_back({index[a], index[b], index[c]});
      }
    }
  }
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) { mesh_.triangles.push_back({a, b, c}); }
  TriMesh take() { return std::move(mesh_); }

 private:
  PictureSize picture_;
  TriMesh mesh_;
};

}  // namespace

TriMesh solidBetween(const Side& front, const Side& back, std::span<const std::size_t> sizes, PictureSize picture) {
  Builder builder(picture);
  const std::size_t rim = front.plane.rim();
  bool wall = false;
  for (std::size_t i = 0; i < rim; ++i) wall = wall || front.height[i] != back.height[i];
  const std::vector<std::uint32_t> before = builder.addPoints(front, 0);
  std::vector<std::uint32_t> behind;
  if (wall) {
    behind = builder.addPoints(back, 0);
  } else {
    behind.assign(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(rim));
    const std::vector<std::uint32_t> inner = builder.addPoints(back, rim);
    behind.insert(behind.end(), inner.begin(), inner.end());
  }
  builder.addTriangles(front, before, false);
  builder.addTriangles(back, behind, true);
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    for (std::size_t k = 0; wall && k < size; ++k) {
      const std::size_t i = first + k, j = first + (k + 1) % size;
      builder.addTriangle(before[j], before[i], behind[i]);
      builder.addTriangle(before[j], behind[i], behind[j]);
    }
    first += size;
  }
  return builder.take();
}

}  // namespace spineloft::mesh
