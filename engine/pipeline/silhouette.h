// What a part covers of its picture, seen along the view axis.
#pragma once

#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::pipeline {

/// 255 where the mesh (ModelSpace) covers the centre of a pixel seen along the view axis, else 0:
/// the centre of pixel (x, y) is the model's (x, −y). Triangles that share an edge leave no gap and
/// a centre on an edge belongs to the triangle on its right or below (top-left rule), so the mask
/// does not depend on how the surface is cut into triangles. What lies outside the picture is cut
/// off. Empty for a picture without pixels. Cost: triangles × rows they span, and pixels.
image::Mask rasteriseSilhouette(const mesh::TriMesh& modelSpace, image::Size picture);

}  // namespace spineloft::pipeline
