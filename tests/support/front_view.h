// A small renderer for tests: what a textured surface looks like seen along the view axis, unlit.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::testing {

/// Colour of the surface at a UV of the mesh.
using ColourAt = std::function<std::array<double, 3>(double u, double v)>;

/// Bilinear between pixel centres, clamped at the edges.
std::array<double, 3> sampled(const image::Image& image, double u, double v);

/// Orthographic, with a depth buffer: pixel (x, y) shows the nearest surface at the model's (x, −y),
/// none where there is nothing. Row by row.
std::vector<std::optional<std::array<double, 3>>> frontView(const mesh::TriMesh& modelSpace, image::Size size,
                                                            const ColourAt& colour);

/// Peak signal-to-noise ratio over the pixels that `seen` has, of 255, in decibels.
double psnr(const std::vector<std::optional<std::array<double, 3>>>& seen, const image::Image& truth);

}  // namespace spineloft::testing
