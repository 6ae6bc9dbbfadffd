#include "engine/pipeline/part_texture.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <new>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "engine/pipeline/occluded_outline.h"

namespace spineloft::pipeline {
namespace {

/// One flag a rib.
std::vector<bool> sureEnds(const ribs::RibSet& set, ribs::RibState ribs::Rib::* state) {
  const std::size_t count = set.ribs.size();
  std::vector<bool> sure(count, true);
  for (std::size_t i = 0; i < count; ++i) {
    if (isSeen(set.ribs[i].*state)) continue;
    for (std::size_t k = i - std::min(i, kBeside); k < std::min(count, i + kBeside + 1); ++k) sure[k] = false;
  }
  return sure;
}

/// The halves between neighbouring ribs that end on an outline, or where a hand put them; not the ends of
/// the part, where nothing tells an outline from any edge that lies further on.
std::vector<std::vector<PicturePoint>> sureParts(const ribs::RibSet& set, image::Size picture) {
  std::vector<std::vector<PicturePoint>> out;
  const std::size_t count = set.ribs.size();
  const std::vector<bool> left = sureEnds(set, &ribs::Rib::leftState);
  const std::vector<bool> right = sureEnds(set, &ribs::Rib::rightState);
  const std::size_t ends = doubtfulEnds(count);
  for (std::size_t i = ends; i + ends < count; ++i) {
    const ribs::Rib &a = set.ribs[i - 1], &b = set.ribs[i];
    const bool leftSure = left[i - 1] && left[i], rightSure = right[i - 1] && right[i];
    // What hides one side may reach over the middle.
    const double inner = leftSure && rightSure ? 0 : 0.5;
    const auto half = [&](PicturePoint endA, PicturePoint endB) {
      out.push_back({toUv(a.center + (endA - a.center) * inner, picture), toUv(endA, picture), toUv(endB, picture),
                     toUv(b.center + (endB - b.center) * inner, picture)});
    };
    if (leftSure) half(a.left, b.left);
    if (rightSure) half(a.right, b.right);
  }
  return out;
}

/// A band with round ends and corners, as discs and what lies between them.
void addBand(const ribs::IgnoreMark& mark, image::Size picture, std::vector<std::vector<PicturePoint>>& out) {
  constexpr int kCorners = 16;
  for (std::size_t i = 0; i < mark.stroke.size(); ++i) {
    const PicturePoint at = mark.stroke[i];
    std::vector<PicturePoint> disc;
    for (int k = 0; k < kCorners; ++k) {
      const double angle = 2 * std::numbers::pi * k / kCorners;
      disc.push_back(toUv(at + PicturePoint{std::cos(angle), std::sin(angle)} * mark.radius, picture));
    }
    out.push_back(std::move(disc));
    if (i == 0) continue;
    const PicturePoint from = mark.stroke[i - 1], along = at - from;
    const double length = std::hypot(along.x, along.y);
    if (!(length > 0)) continue;
    const PicturePoint aside = PicturePoint{-along.y, along.x} * (mark.radius / length);
    out.push_back({toUv(from + aside, picture), toUv(at + aside, picture), toUv(at - aside, picture),
                   toUv(from - aside, picture)});
  }
}

std::vector<std::vector<PicturePoint>> hiddenParts(std::array<std::span<const ribs::IgnoreMark>, 2> marks,
                                                   image::Size picture) {
  std::vector<std::vector<PicturePoint>> hidden;
  for (const auto& some : marks) {
    for (const ribs::IgnoreMark& mark : some) {
      if (mark.covers) addBand(mark, picture, hidden);
    }
  }
  return hidden;
}

std::shared_ptr<const surface::PartTexture> shared(std::optional<surface::PartTexture> made) {
  return made ? std::make_shared<const surface::PartTexture>(std::move(*made)) : nullptr;
}

}  // namespace

std::shared_ptr<const surface::PartTexture> textureStage(const PartShape& shape, const image::Picture& pixels,
                                                         std::array<std::span<const ribs::IgnoreMark>, 2> marks) {
  if (shape.mesh.uv.size() != shape.mesh.positions.size()) return nullptr;
  try {
    const image::Size size{pixels.width, pixels.height};
    const auto sure = sureParts(shape.ribs, size), hidden = hiddenParts(marks, size);
    const auto unseen = occludedStretches(shape.ribs, pixels);
    return shared(surface::partTexture(pixels.working, {shape.mesh.uv, shape.mesh.triangles, sure, hidden, unseen}));
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}

TextureJob::TextureJob(std::shared_ptr<const PartShape> shape, std::shared_ptr<const image::Picture> pixels,
                       std::array<std::span<const ribs::IgnoreMark>, 2> marks)
    : shape_(std::move(shape)), pixels_(std::move(pixels)) {
  const image::Size size{pixels_->width, pixels_->height};
  const mesh::TriMesh& mesh = shape_->mesh;
  if (mesh.uv.size() != mesh.positions.size()) return;
  sure_ = sureParts(shape_->ribs, size);
  hidden_ = hiddenParts(marks, size);
  occludedStretches_ = occludedStretches(shape_->ribs, *pixels_);
  steps_.emplace(pixels_->working, surface::Wrapped{mesh.uv, mesh.triangles, sure_, hidden_, occludedStretches_});
}

bool TextureJob::step() {
  if (!steps_) return false;
  try {
    if (steps_->step()) return true;
    made_ = shared(steps_->take());
  } catch (const std::bad_alloc&) {
    made_ = nullptr;
  }
  steps_.reset();
  return false;
}

}  // namespace spineloft::pipeline
