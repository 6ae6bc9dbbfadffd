#include "web/edit/free_layers.h"

#include <algorithm>

#include "web/edit/layer_settings.h"

namespace spineloft::app {
namespace {

ModelPoint held(ModelPoint p) {
  const auto inRange = [](double v) { return std::clamp(v, -stack::kFarOut, stack::kFarOut); };
  return {inRange(p.x), inRange(p.y), inRange(p.z)};
}

document::StackRecipe withOrigin(const Sheet& sheet, ModelPoint origin) {
  document::StackRecipe recipe = sheet.recipe;
  recipe.planes[*sheet.layer].origin = held(origin);
  return recipe;
}

}  // namespace

// The normal of a sheet points back along the rail.
Offset offsetOf(const Sheet& sheet, const stack::Plane& plane) {
  if (!plane.origin) return {};
  const ModelPoint away = *plane.origin - sheet.home.origin;
  return {dot(away, sheet.home.x), dot(away, sheet.home.y), -dot(away, sheet.home.normal())};
}

Result<document::StackRecipe> withFree(const Sheet& sheet, bool free) {
  if (!sheet.layer) return {Error::StackInvalid, "the sheet lies on no layer: draw one first"};
  if (!sheet.onRail()) return {Error::StackInvalid, kNoRail};
  if (free && sheet.recipe.rail.closed) {
    return {Error::StackInvalid, "its line is closed, and layers stay on it: give it an open line first"};
  }
  if (free && !sheet.recipe.stack.patterns.empty()) {
    return {Error::StackInvalid, kRepeated};
  }
  document::StackRecipe recipe = sheet.recipe;
  stack::Plane& plane = recipe.planes[*sheet.layer];
  if (free == plane.origin.has_value()) return recipe;
  if (free) {
    plane.origin = sheet.stand.origin;
    plane.turn = stack::turnBetween({{}, {1, 0, 0}, {0, 1, 0}}, sheet.stand);
  } else {
    const Lean lean = leanOf(sheet);  // layers on the rail lean less
    plane.origin.reset();
    Sheet on = sheet;
    on.recipe = recipe;
    on.turn = geometry::turnOf({0, 0, geometry::anglesOf(sheet.turn).roll});
    plane.turn = turnFor(on, lean);
  }
  return recipe;
}

document::StackRecipe withOffset(const Sheet& sheet, const Offset& offset) {
  const stack::Stand& home = sheet.home;
  return withOrigin(sheet, home.origin + home.x * offset.side + home.y * offset.front - home.normal() * offset.ahead);
}

document::StackRecipe withShift(const Sheet& sheet, double ahead) {
  return withOrigin(sheet, *sheet.recipe.planes[*sheet.layer].origin - sheet.stand.normal() * ahead);
}

}  // namespace spineloft::app
