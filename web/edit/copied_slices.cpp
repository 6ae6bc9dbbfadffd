#include "web/edit/copied_slices.h"

#include <algorithm>

#include "web/edit/layer_settings.h"
#include "web/edit/section_editing.h"

namespace spineloft::app {
namespace {

constexpr double kBeside = 1.2;  // of its width, from what was copied

}  // namespace

Result<pipeline::Slices> slicesOf(const document::Document& document, const pipeline::Derived& derived, PartId id) {
  const document::Part* part = document::findPart(document, id);
  if (part == nullptr) return Error::NoSuchPart;
  if (const auto* layers = document::stackOf(*part)) return pipeline::slicesOf(*layers);
  const pipeline::PartShape* shape = shapeOf(document, derived, id);
  const auto* loft = document::loftOf(*part);
  if (loft == nullptr || shape == nullptr) return Error::NotAStack;
  return pipeline::slicesOf(*loft, *shape);
}

Result<document::StackRecipe> withSlices(const document::StackRecipe& recipe, const pipeline::Slices& slices) {
  if (recipe.rail.points.empty()) {
    return {Error::StackInvalid, "its layers stand on no rail: draw a part of layers, and paste the slices there"};
  }
  document::StackRecipe made = recipe;
  made.planes = slices.onRail;
  made.stack.patterns = slices.patterns;
  if (recipe.rail.closed) return withRail(made, recipe.rail);
  made.planes.back().links.clear();  // of a ring: nothing follows it here
  return made;
}

document::StackRecipe newWithSlices(const Sheet& sheet, const pipeline::Slices& slices) {
  document::StackRecipe recipe = sheet.recipe;
  recipe.planes = slices.onRail;
  recipe.stack.patterns = slices.patterns;
  recipe.rail = slices.rail;
  const auto [left, right] = std::ranges::minmax(recipe.rail.points, {}, &ModelPoint::x);
  for (ModelPoint& p : recipe.rail.points) p.x += kBeside * (right.x - left.x + 2 * reachOf(recipe));
  return recipe;
}

}  // namespace spineloft::app
