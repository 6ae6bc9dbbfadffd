// Puffs and flat pieces: clean the region, make the solid.
#include <new>
#include <utility>

#include "engine/extrude/extrude.h"
#include "engine/geometry/region.h"
#include "engine/inflate/inflate.h"
#include "engine/pipeline/part_shape.h"

namespace spineloft::pipeline {
namespace {

double nowMs(const Clock& clock) { return clock ? clock() : 0.0; }

template <class Make>
Result<PartShape> regionShape(const document::Region& region, image::Size picture, const Clock& clock,
                              const Make& make) {
  const double started = nowMs(clock);
  try {
    Result<geometry::Contours> clean = geometry::cleanRegion(
        region.contours, region.ribbon, {static_cast<double>(picture.width), static_cast<double>(picture.height)});
    if (!clean) return clean.failure();
    Result<mesh::TriMesh> solid = make(clean.value());
    if (!solid) return solid.failure();
    PartShape shape;
    shape.contours = std::move(clean).value();
    shape.mesh = std::move(solid).value();
    shape.ms.loft = nowMs(clock) - started;
    return shape;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace

Result<PartShape> inflateStage(const document::InflateRecipe& recipe, image::Size picture, const Clock& clock) {
  return regionShape(recipe.region, picture, clock, [&](const geometry::Contours& contours) {
    return inflate::inflateRegion(contours, picture, recipe.inflate);
  });
}

Result<PartShape> extrudeStage(const document::ExtrudeRecipe& recipe, image::Size picture, const Clock& clock) {
  return regionShape(recipe.region, picture, clock, [&](const geometry::Contours& contours) {
    return extrude::extrudeRegion(contours, picture, recipe.extrude);
  });
}

}  // namespace spineloft::pipeline
