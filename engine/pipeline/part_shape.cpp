#include "engine/pipeline/part_shape.h"

#include <new>
#include <utility>

#include "engine/loft/loft.h"

namespace spineloft::pipeline {
namespace {

double nowMs(const Clock& clock) { return clock ? clock() : 0.0; }

std::size_t bytesOf(const ribs::RibSet& set) {
  return set.ribs.size() * sizeof(ribs::Rib) +
         (set.startFan.points.size() + set.endFan.points.size()) * sizeof(PicturePoint);
}

std::size_t bytesOf(const std::vector<std::vector<PicturePoint>>& contours) {
  std::size_t bytes = 0;
  for (const auto& contour : contours) {
    bytes += sizeof(contour) + contour.size() * sizeof(PicturePoint);
  }
  return bytes;
}

Result<PartShape> makeShape(const document::LoftRecipe& recipe, const TracedRibs& traced,
                            image::Size picture, const Clock& clock, loft::LoftWorkspace& memory) {
  const double started = nowMs(clock);
  PartShape shape;
  shape.spine = traced.spine;
  shape.generated = traced.generated;
  shape.exact = traced.exact;
  shape.ribs = ribs::applyEdits(shape.spine, shape.generated, recipe.edits);
  const Result<loft::PosedSpine> posed = loft::poseSpine(shape.spine, recipe.pose);
  if (!posed) return posed.failure();
  shape.shown = loft::poseRibs(posed.value(), shape.ribs);
  shape.centreLine = loft::centreLine(posed.value(), shape.spine.points.size());
  const double edited = nowMs(clock);
  const Status made = loft::loftRibs({shape.ribs, picture, recipe.loft}, posed.value(), memory, shape.mesh);
  if (!made.ok()) return made.failure();
  shape.ms.ribs = edited - started;
  shape.ms.loft = nowMs(clock) - edited;
  return shape;
}

}  // namespace

std::size_t bytesOf(const TracedRibs& traced) {
  return sizeof(traced) + traced.spine.points.size() * sizeof(PicturePoint) +
         bytesOf(traced.generated);
}

std::size_t bytesOf(const PartShape& shape) {
  const mesh::TriMesh& m = shape.mesh;
  const auto bytes = [](const auto& vector) { return vector.size() * sizeof(vector[0]); };
  return sizeof(shape) + bytes(shape.spine.points) + bytes(shape.centreLine) +
         bytesOf(shape.contours) + bytesOf(shape.generated) + bytesOf(shape.ribs) + bytesOf(shape.shown) +
         bytes(m.positions) + bytes(m.triangles) + bytes(m.uv) +
         (shape.texture ? bytes(shape.texture->pixels.pixels) : 0);
}

std::size_t bytesOf(const ribs::IgnoredEdges& ignored) {
  return sizeof(ignored) + ignored.mask.size() + ignored.proximity.size() * sizeof(float);
}

Result<ribs::IgnoredEdges> ignoredStage(const image::EdgeMap& edges,
                                        std::span<const ribs::IgnoreMark> ofPicture,
                                        std::span<const ribs::IgnoreMark> ofPart) {
  try {
    return ribs::ignoreEdges(edges, ofPicture, ofPart);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<TracedRibs> traceStage(const document::LoftRecipe& recipe,
                              const ribs::PictureEvidence& picture, const Progress& progress,
                              ribs::RibWorkspace& memory) {
  try {
    Result<ribs::Spine> spine = ribs::cleanSpine(recipe.stroke, picture.size, recipe.spine);
    if (!spine) return spine.failure();
    Result<ribs::RibSet> found =
        ribs::traceRibs(spine.value(), picture, recipe.ribs, progress, memory);
    if (!found) return found.failure();
    return TracedRibs{std::move(spine).value(), std::move(found).value()};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<TracedRibs> liveStage(const document::LoftRecipe& recipe,
                             const ribs::PictureEvidence& picture, ribs::LiveTrace& live) {
  try {
    Result<ribs::Spine> spine = ribs::cleanSpine(recipe.stroke, picture.size, recipe.spine);
    if (!spine) return spine.failure();
    Result<ribs::LiveTrace::Ribs> found = live.move(spine.value(), picture, recipe.ribs);
    if (!found) return found.failure();
    const bool exact = found.value().exact;
    return TracedRibs{std::move(spine).value(), std::move(found).value().set, exact};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<PartShape> shapeStage(const document::LoftRecipe& recipe, const TracedRibs& traced,
                             image::Size picture, loft::LoftWorkspace& memory, const Clock& clock) {
  try {
    return makeShape(recipe, traced, picture, clock, memory);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<PartShape> shapePart(const document::LoftRecipe& recipe, const image::EdgeMap& edges,
                            image::Size picture, const Progress& progress, const Clock& clock) {
  const double started = nowMs(clock);
  const Result<ribs::IgnoredEdges> ignored = ignoredStage(edges, {}, recipe.ignored);
  if (!ignored) return ignored.failure();
  ribs::RibWorkspace memory;
  Result<TracedRibs> traced =
      traceStage(recipe, {edges, picture, &ignored.value()}, progress, memory);
  if (!traced) return traced.failure();
  const double took = nowMs(clock) - started;
  loft::LoftWorkspace loftMemory;
  Result<PartShape> shape = shapeStage(recipe, traced.value(), picture, loftMemory, clock);
  if (shape) shape.value().ms.ribs += took;
  return shape;
}

}  // namespace spineloft::pipeline
