#include "engine/pipeline/part_shape.h"

#include <new>
#include <utility>

#include "engine/inflate/interior.h"
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

std::size_t bytesOf(const std::vector<PulledLine>& lines) {
  std::size_t bytes = 0;
  for (const PulledLine& line : lines)
    bytes += sizeof(line) + (line.points.size() + line.ring.size()) * sizeof(ModelPoint);
  return bytes;
}

std::size_t bytesOf(const std::vector<bridge::Rim>& rims) {
  std::size_t bytes = 0;
  for (const bridge::Rim& rim : rims) bytes += sizeof(rim) + rim.points.size() * sizeof(ModelPoint);
  return bytes;
}

// What may fail comes first, so that a failure leaves the shape as it was.
Status makeShape(const document::LoftRecipe& recipe, const TracedRibs& traced, image::Size picture, const Clock& clock,
                 ShapeMemory& memory, PartShape& shape) {
  const double started = nowMs(clock);
  if (!recipe.edits.empty()) memory.edited = ribs::applyEdits(traced.spine, traced.generated, recipe.edits);
  const ribs::RibSet& edited = recipe.edits.empty() ? traced.generated : memory.edited;
  Status posed = loft::poseSpine(traced.spine, recipe.pose, memory.pose, memory.posed);
  if (!posed.ok()) return posed;
  const double ready = nowMs(clock);
  Status made = loft::loftRibs({edited, picture, recipe.loft}, memory.posed, memory.loft, memory.mesh);
  if (!made.ok()) return made;
  const double lofted = nowMs(clock);
  shape.spine = traced.spine;
  shape.generated = traced.generated;
  shape.ribs = edited;
  shape.shown = edited;
  loft::carryRibs(memory.posed, shape.shown);
  shape.scale = memory.posed.scale;
  loft::centreLine(memory.posed, traced.spine.points.size(), shape.centreLine);
  shape.contours.clear();
  shape.pulled.clear();
  shape.rims.clear();
  shape.relief.reset();
  shape.wantedHeights = {};
  shape.wantedRaised = {};
  shape.mesh = memory.mesh;
  shape.smooth.reset();
  shape.texture.reset();
  shape.textureKey = shape.wantedTexture = {};
  shape.outlineInk.clear();
  shape.key = {};
  shape.quality = traced.quality;
  shape.ms = {};
  shape.ms.loft = lofted - ready;
  shape.ms.ribs = nowMs(clock) - started - shape.ms.loft;
  return Done{};
}

}  // namespace

std::size_t bytesOf(const TracedRibs& traced) {
  return sizeof(traced) + traced.spine.points.size() * sizeof(PicturePoint) + bytesOf(traced.generated);
}

std::size_t bytesOf(const PartShape& shape) {
  const mesh::TriMesh& m = shape.mesh;
  const auto bytes = [](const auto& vector) { return vector.size() * sizeof(vector[0]); };
  return sizeof(shape) + bytes(shape.spine.points) + bytes(shape.centreLine) + bytesOf(shape.contours) +
         bytesOf(shape.generated) + inflate::bytesOf(shape.bones) + bytesOf(shape.ribs) + bytesOf(shape.shown) +
         bytes(m.positions) + bytes(m.triangles) + bytes(m.uv) + bytesOf(shape.outlineInk) + bytes(shape.ways.links) +
         (shape.smooth ? bytes(shape.smooth->positions) + bytes(shape.smooth->triangles) + bytes(shape.smooth->uv)
                       : 0) +
         bytesOf(shape.pulled) + bytesOf(shape.rims) + bytes(shape.ways.forks) +
         (shape.texture ? bytes(shape.texture->pixels.pixels) : 0);
}

std::size_t bytesOf(const std::vector<ribs::IgnoreMark>& marks) {
  std::size_t bytes = 0;
  for (const ribs::IgnoreMark& mark : marks) bytes += sizeof(mark) + mark.stroke.size() * sizeof(PicturePoint);
  return bytes;
}

std::size_t bytesOf(const ribs::IgnoredEdges& ignored) {
  return sizeof(ignored) + ignored.mask.size() + ignored.proximity.size() * sizeof(float);
}

Result<ribs::IgnoredEdges> ignoredStage(const image::EdgeMap& edges, std::span<const ribs::IgnoreMark> ofPicture,
                                        std::span<const ribs::IgnoreMark> ofPart) {
  try {
    return ribs::ignoreEdges(edges, ofPicture, ofPart);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<TracedRibs> traceStage(const document::LoftRecipe& recipe, const ribs::PictureEvidence& picture,
                              const Progress& progress, ribs::RibWorkspace& memory) {
  try {
    Result<ribs::Spine> spine = ribs::cleanSpine(recipe.stroke, picture.size, recipe.spine);
    if (!spine) return spine.failure();
    Result<ribs::RibSet> found = ribs::traceRibs(spine.value(), picture, recipe.ribs, progress, memory);
    if (!found) return found.failure();
    return TracedRibs{std::move(spine).value(), std::move(found).value()};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Status liveStage(const document::LoftRecipe& recipe, const ribs::PictureEvidence& picture, LivePen& pen) {
  try {
    TracedRibs& traced = pen.traced;
    Status cleaned = ribs::cleanSpine(recipe.stroke, picture.size, recipe.spine, pen.spine, traced.spine);
    if (!cleaned.ok()) return cleaned;
    const Result<bool> exact = pen.trace.move(traced.spine, picture, recipe.ribs, traced.generated);
    if (!exact) return exact.failure();
    traced.quality = exact.value() ? TraceQuality::Final : TraceQuality::Live;
    return Done{};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Status shapeStage(const document::LoftRecipe& recipe, const TracedRibs& traced, image::Size picture,
                  ShapeMemory& memory, PartShape& shape, const Clock& clock) {
  try {
    return makeShape(recipe, traced, picture, clock, memory, shape);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<PartShape> shapeStage(const document::LoftRecipe& recipe, const TracedRibs& traced, image::Size picture,
                             ShapeMemory& memory, const Clock& clock) {
  PartShape shape;
  const Status made = shapeStage(recipe, traced, picture, memory, shape, clock);
  if (!made.ok()) return made.failure();
  return shape;
}

Result<PartShape> shapePart(const document::LoftRecipe& recipe, const image::EdgeMap& edges, image::Size picture,
                            const Progress& progress, const Clock& clock) {
  const double started = nowMs(clock);
  const Result<ribs::IgnoredEdges> ignored = ignoredStage(edges, {}, recipe.ignored);
  if (!ignored) return ignored.failure();
  ribs::RibWorkspace memory;
  Result<TracedRibs> traced = traceStage(recipe, {edges, picture, &ignored.value()}, progress, memory);
  if (!traced) return traced.failure();
  const double took = nowMs(clock) - started;
  ShapeMemory shapeMemory;
  Result<PartShape> shape = shapeStage(recipe, traced.value(), picture, shapeMemory, clock);
  if (shape) shape.value().ms.ribs += took;
  return shape;
}

}  // namespace spineloft::pipeline
