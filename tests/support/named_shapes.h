// Shapes with names and known skeletons, in a picture of 400 × 400 pixels.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/geometry/region.h"

namespace spineloft::testing {

struct NamedShape {
  std::string name;
  geometry::Contours contours;  ///< as cleanRegion gives them
  int ends = 0, rings = 0;      ///< of the skeleton that a person would draw
};

/// disc, square, ellipse, stadium, rectangle, lens, triangle, T, E, X, H, star, hand, leaf, ring, eight, A, G.
const std::vector<NamedShape>& namedShapes();
const NamedShape& namedShape(const std::string& name);

/// The outlines with a point every `spacing` pixels, each moved square to the outline by up to `most` pixels: a smooth
/// random line with a bend about every `wave` pixels.
geometry::Contours trembling(const geometry::Contours& contours, double most, double wave, std::uint64_t seed,
                             double spacing = 2);

/// Turned about (200, 200) by `angle` radians, then scaled about it.
geometry::Contours turnedAndScaled(const geometry::Contours& contours, double angle, double scale);

}  // namespace spineloft::testing
