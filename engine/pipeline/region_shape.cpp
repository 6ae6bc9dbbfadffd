// What is made of a region (puffs, flat pieces, spun parts), what is drawn slice by slice, and shapes.
#include <new>
#include <utility>
#include <variant>

#include "engine/extrude/extrude.h"
#include "engine/geometry/region.h"
#include "engine/inflate/inflate.h"
#include "engine/inflate/interior.h"
#include "engine/lathe/lathe.h"
#include "engine/pipeline/part_shape.h"
#include "engine/pipeline/shape_outline.h"
#include "engine/shape/shape.h"
#include "engine/shape/side_fit.h"

namespace spineloft::pipeline {
namespace {

Result<PartShape> shapeOf(Result<geometry::Contours> contours, Result<mesh::TriMesh> mesh) {
  if (!mesh) return mesh.failure();
  PartShape shape;
  shape.contours = std::move(contours).value();
  shape.mesh = std::move(mesh).value();
  return shape;
}

/// Makes the shape of one kind of recipe.
struct Make {
  image::Size picture;
  KnownInterior& interior;

  Result<geometry::Contours> clean(const document::Region& region) const {
    return geometry::cleanRegion(region.contours, region.ribbon,
                                 {static_cast<double>(picture.width), static_cast<double>(picture.height)});
  }
  Result<PartShape> operator()(const document::LoftRecipe&) const { return Error::NotARegion; }
  Result<PartShape> operator()(const document::StackRecipe&) const { return Error::NotARegion; }
  Result<PartShape> operator()(const document::ShapeRecipe&) const { return Error::NotARegion; }
  Result<PartShape> operator()(const document::ElementRecipe&) const { return Error::NotARegion; }
  Result<PartShape> operator()(const document::BridgeRecipe&) const { return Error::NotARegion; }
  Result<PartShape> operator()(const document::InflateRecipe& recipe) const {
    Result<geometry::Contours> contours = clean(recipe.region);
    if (!contours) return contours.failure();
    const inflate::InflateParams& params = recipe.inflate;
    if (params.profile.isSoft()) {
      Result<mesh::TriMesh> mesh = inflate::inflateRegion(contours.value(), picture, params);
      return shapeOf(std::move(contours), std::move(mesh));
    }
    if (!inflate::isValid(params)) return Error::ValueOutOfRange;
    if (!interior) {
      Result<inflate::Interior> made =
          inflate::interiorOf(contours.value(), params.bones, params.profile.slices, params.points);
      if (!made) return made.failure();
      interior = std::make_shared<const inflate::Interior>(std::move(made).value());
    }
    Result<mesh::TriMesh> mesh = inflate::inflateAlong(*interior, picture, params);
    Result<PartShape> shape = shapeOf(std::move(contours), std::move(mesh));
    if (shape) shape.value().bones = interior->bones;
    return shape;
  }
  Result<PartShape> operator()(const document::ExtrudeRecipe& recipe) const {
    Result<geometry::Contours> contours = clean(recipe.region);
    if (!contours) return contours.failure();
    Result<mesh::TriMesh> mesh = extrude::extrudeRegion(contours.value(), picture, recipe.extrude);
    return shapeOf(std::move(contours), std::move(mesh));
  }
  Result<PartShape> operator()(const document::LatheRecipe& recipe) const {
    const document::Region& region = recipe.region;
    Result<lathe::Spun> spun = lathe::spinRegion({region.contours, region.ribbon, region.open}, picture, recipe.lathe);
    if (!spun) return spun.failure();
    return shapeOf(std::move(spun.value().silhouette), std::move(spun.value().mesh));
  }
};

/// What `make` makes, with its time.
template <class Make>
Result<PartShape> timed(const Clock& clock, const Make& make) {
  const double started = clock ? clock() : 0;
  try {
    Result<PartShape> shape = make();
    if (shape) shape.value().ms.loft = (clock ? clock() : 0) - started;
    return shape;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace

Result<PartShape> regionStage(const document::Recipe& recipe, image::Size picture, KnownInterior& interior,
                              const Clock& clock) {
  return timed(clock, [&] { return std::visit(Make{picture, interior}, recipe); });
}
Result<PartShape> regionStage(const document::Recipe& recipe, image::Size picture, const Clock& clock) {
  KnownInterior made;
  return regionStage(recipe, picture, made, clock);
}

Result<PartShape> stackStage(const document::StackRecipe& recipe, image::Size picture, const Clock& clock) {
  return timed(clock, [&] {
    Result<stack::Stacked> made = stack::stackPlanes({recipe.planes, recipe.rail, recipe.stack}, picture);
    if (!made) return Result<PartShape>(made.failure());
    PartShape shape;
    shape.mesh = std::move(made.value().mesh);
    shape.ways = std::move(made.value().ways);
    return Result<PartShape>(std::move(shape));
  });
}

namespace {

/// The outlines of a shape with the views of their pictures.
Result<std::vector<shape::SeenOutline>> seenOutlines(const document::ShapeRecipe& recipe,
                                                     const document::Document& document) {
  std::vector<shape::SeenOutline> outlines;
  for (const document::Outline& outline : recipe.outlines) {
    const auto view = viewOn(document, outline.picture, recipe.picture);
    if (!view) return view.failure();
    outlines.push_back({view.value(), outline.lines});
  }
  return outlines;
}

/// A puff of one side is flat at z = 0.
shape::FitSides fitSidesOf(const document::Recipe& recipe) {
  const auto* puff = std::get_if<document::InflateRecipe>(&recipe);
  if (puff == nullptr || puff->inflate.sides == inflate::InflateSides::Both) return shape::FitSides::Both;
  return puff->inflate.sides == inflate::InflateSides::Front ? shape::FitSides::Front : shape::FitSides::Back;
}

}  // namespace

Result<std::vector<PicturePoint>> outlineIn(const document::ShapeRecipe& recipe, const document::Document& document,
                                            PictureId picture) {
  const auto outlines = seenOutlines(recipe, document);
  if (!outlines) return outlines.failure();
  const auto view = viewOn(document, picture, recipe.picture);
  if (!view) return view.failure();
  return shape::outlineSeen(recipe.shape, outlines.value(), view.value());
}

Status sideStage(const document::Recipe& recipe, const document::Document& document, PartShape& shape) {
  const std::optional<document::Outline>* side = document::sideOf(recipe);
  if (side == nullptr || !*side) return Done{};
  const auto view = viewOn(document, (*side)->picture, document::pictureOf(recipe));
  if (!view) return view.failure();
  try {
    const shape::SeenOutline seen{view.value(), (*side)->lines};
    const auto fit = shape::fitToSide({shape.mesh, seen, fitSidesOf(recipe), shape.centreLine});
    if (!fit) return fit.failure();
    fit.value().apply(shape.mesh);
    for (ModelPoint& p : shape.centreLine) p.z = fit.value().depthOf(p.y, p.z);
    return Done{};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<PartShape> outlineStage(const document::ShapeRecipe& recipe, const document::Document& document,
                               image::Size picture, const Clock& clock) {
  return timed(clock, [&]() -> Result<PartShape> {
    const auto outlines = seenOutlines(recipe, document);
    if (!outlines) return outlines.failure();
    Result<shape::Shaped> made = shape::makeShape(recipe.shape, outlines.value(), picture);
    if (!made) return made.failure();
    return shapeOf(std::move(made.value().silhouette), std::move(made.value().mesh));
  });
}

}  // namespace spineloft::pipeline
