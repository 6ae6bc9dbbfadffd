#include "engine/pipeline/warm_up.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

#include "engine/image/image.h"
#include "engine/pipeline/part_shape.h"
#include "engine/vision/edges.h"

namespace spineloft::pipeline {
namespace {

constexpr int kWidth = 160, kHeight = 120;

/// A light tube with a bend on a darker ground with a pattern.
image::Picture tinyPicture() {
  image::Image image{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double away = std::abs(y - 60 - 12 * std::sin(0.03 * x));
      const bool inside = away < 16 && x > 15 && x < kWidth - 15;
      const int ground = 60 + (x * 7 + y * 13) % 11;
      const int value = inside ? 190 - static_cast<int>(3 * away) : ground;
      for (const int tint : {0, 10, 25}) {
        image.pixels.push_back(static_cast<std::uint8_t>(std::max(0, value - tint)));
      }
      image.pixels.push_back(255);
    }
  }
  return image::makePicture(std::move(image));
}

/// The same stroke as it grows.
Status underThePen(document::LoftRecipe recipe, const ribs::PictureEvidence& picture) {
  constexpr std::size_t kMoves = 8;
  recipe.spine.minSpacing = 1;
  LivePen pen;
  const std::vector<PicturePoint> stroke = std::move(recipe.stroke);
  for (std::size_t move = 0; move < kMoves; ++move) {
    const auto count = static_cast<std::ptrdiff_t>(stroke.size() - (move + 1 < kMoves ? 3 : 0));
    recipe.stroke.assign(stroke.begin(), stroke.begin() + (move == 0 ? count - 2 : count));
    if (Status made = liveStage(recipe, picture, pen); !made.ok()) return made;
  }
  return Done{};
}

Status everyStage(const image::Picture& picture) {
  const Result<image::EdgeMap> edges = vision::detectEdges(picture, {}, Progress());
  if (!edges) return edges.failure();
  document::LoftRecipe recipe;
  for (int x = 25; x <= kWidth - 25; x += 5) recipe.stroke.push_back({1.0 * x, 60 + 12 * std::sin(0.03 * x)});
  const ribs::PictureEvidence evidence{edges.value(), {picture.width, picture.height}};
  ribs::RibWorkspace memory;
  ShapeMemory shapeMemory;
  const Result<TracedRibs> traced = traceStage(recipe, evidence, Progress(), memory);
  if (!traced) return traced.failure();
  const Result<PartShape> shape = shapeStage(recipe, traced.value(), evidence.size, shapeMemory);
  if (!shape) return shape.failure();
  return underThePen(std::move(recipe), evidence);
}

}  // namespace

Status warmUp(int rounds) {
  try {
    const image::Picture picture = tinyPicture();
    for (int round = 0; round < std::clamp(rounds, 1, 100); ++round) {
      if (Status status = everyStage(picture); !status.ok()) return status;
    }
    return Done{};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::pipeline
