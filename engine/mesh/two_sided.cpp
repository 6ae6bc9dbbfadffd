#include "engine/mesh/two_sided.h"

#include <algorithm>

namespace spineloft::mesh {
namespace {

class Builder {
 public:
  explicit Builder(PictureSize picture) : picture_(picture) {}

  std::uint32_t add(SectionPoint p, double z) {
    mesh_.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(z)});
    mesh_.uv.push_back(frontUv(p.x, p.y, picture_));
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
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
  std::vector<std::uint32_t> before, behind;
  for (std::size_t i = 0; i < front.plane.points().size(); ++i) {
    before.push_back(builder.add(front.plane.points()[i], front.height[i]));
  }
  for (std::size_t i = 0; i < rim; ++i) {
    const bool isOne = front.height[i] == back.height[i];
    behind.push_back(isOne ? before[i] : builder.add(back.plane.points()[i], back.height[i]));
  }
  for (std::size_t i = rim; i < back.plane.points().size(); ++i) {
    behind.push_back(builder.add(back.plane.points()[i], back.height[i]));
  }
  builder.addTriangles(front, before, false);
  builder.addTriangles(back, behind, true);
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    for (std::size_t k = 0; k < size; ++k) {
      const std::size_t i = first + k, j = first + (k + 1) % size;
      if (before[i] != behind[i]) builder.addTriangle(before[j], before[i], behind[i]);
      if (before[j] != behind[j]) builder.addTriangle(before[j], behind[i], behind[j]);
    }
    first += size;
  }
  return builder.take();
}

}  // namespace spineloft::mesh
