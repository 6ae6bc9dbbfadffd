// Pieces with their depths as closed solids.
#pragma once

#include "engine/descriptive/depth.h"
#include "engine/image/image.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::descriptive {

/// ModelSpace, UV as seen from the front; closed, with a handle for every hole. A round piece lies between middle +
/// front and middle − back; a flat one is its plane, thick along its own normal; one of
/// kind Solid has the faces of its patch. `board`: the picture of the UV.
mesh::TriMesh solidOf(const Patch& patch, const Piece& piece, const PieceDepth& depth, const DepthScale& scale,
                      image::Size board);

}  // namespace spineloft::descriptive
