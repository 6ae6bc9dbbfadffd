// How many pieces come off a printer.
#pragma once

#include <cstddef>
#include <span>

#include "engine/mesh/tri_mesh.h"

namespace spineloft::printing {

/// What is nearer than this prints as one, millimetres: the line of a usual nozzle. Models longer than
/// 400 of these are looked at more coarsely, at 1/400 of their diagonal.
inline constexpr double kJoint = 0.4;

/// How many pieces of material closed, outward meshes are (millimetres; they may overlap): parts that
/// touch, or of which one is inside the other, are one piece. A shell that is inside out is the inside of
/// what is round it. 0 without material. Contact: points at half of kJoint over the surfaces that fall
/// into one cell of a grid of kJoint, or of the same grid half a cell further. Cost: linear in the surface
/// that is within the boxes of others.
std::size_t countPieces(std::span<const mesh::TriMesh> parts);

}  // namespace spineloft::printing
