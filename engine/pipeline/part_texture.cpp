#include "engine/pipeline/part_texture.h"

#include <algorithm>
#include <new>
#include <utility>
#include <vector>

namespace spineloft::pipeline {
namespace {

/// Share of the ribs at each end of a part that may reach beyond it.
constexpr double kEndShare = 0.08;

/// Ribs beside a bridged or guessed one that are not believed either: what hides an outline begins a
/// little before it.
constexpr std::size_t kBeside = 4;

bool isSure(ribs::RibState state) {
  return state != ribs::RibState::Bridged && state != ribs::RibState::Guessed;
}

/// One flag a rib.
std::vector<bool> sureEnds(const ribs::RibSet& set, ribs::RibState ribs::Rib::* state) {
  const std::size_t count = set.ribs.size();
  std::vector<bool> sure(count, true);
  for (std::size_t i = 0; i < count; ++i) {
    if (isSure(set.ribs[i].*state)) continue;
    for (std::size_t k = i - std::min(i, kBeside); k < std::min(count, i + kBeside + 1); ++k) sure[k] = false;
  }
  return sure;
}

/// The halves between neighbouring ribs that end on an outline, or where a hand put them; not the ends of
/// the part, where nothing tells an outline from any edge that lies further on.
std::vector<std::vector<PicturePoint>> sureParts(const ribs::RibSet& set, image::Size picture) {
  std::vector<std::vector<PicturePoint>> out;
  const auto toUv = [&](PicturePoint p) {
    return PicturePoint{(p.x + 0.5) / picture.width, (p.y + 0.5) / picture.height};
  };
  const std::size_t count = set.ribs.size();
  const std::vector<bool> left = sureEnds(set, &ribs::Rib::leftState);
  const std::vector<bool> right = sureEnds(set, &ribs::Rib::rightState);
  const auto ends = static_cast<std::size_t>(kEndShare * static_cast<double>(count)) + 1;
  for (std::size_t i = ends; i + ends < count; ++i) {
    const ribs::Rib &a = set.ribs[i - 1], &b = set.ribs[i];
    const bool leftSure = left[i - 1] && left[i], rightSure = right[i - 1] && right[i];
    // What hides one side may reach over the middle.
    const double inner = leftSure && rightSure ? 0 : 0.5;
    const auto half = [&](PicturePoint endA, PicturePoint endB) {
      out.push_back({toUv(a.center + (endA - a.center) * inner), toUv(endA), toUv(endB),
                     toUv(b.center + (endB - b.center) * inner)});
    };
    if (leftSure) half(a.left, b.left);
    if (rightSure) half(a.right, b.right);
  }
  return out;
}

}  // namespace

std::shared_ptr<const surface::PartTexture> textureStage(const PartShape& shape,
                                                         const image::Picture& pixels) {
  if (shape.mesh.uv.size() != shape.mesh.positions.size()) return nullptr;
  try {
    const auto sure = sureParts(shape.ribs, {pixels.width, pixels.height});
    std::optional<surface::PartTexture> made = surface::partTexture(
        pixels.working, {shape.mesh.uv, shape.mesh.triangles, sure});
    if (!made) return nullptr;
    return std::make_shared<const surface::PartTexture>(std::move(*made));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

}  // namespace spineloft::pipeline
