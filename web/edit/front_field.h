// What parts and solids show to the one who looks at the picture: their meshes in the world, and how far forward they
// reach over each place of the picture plane.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "engine/document/document.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/world.h"

namespace spineloft::app {

/// What a part or solid shows, as it stands in the world.
struct Body {
  std::vector<mesh::TriMesh> meshes;
  std::optional<pipeline::WorldBounds> bounds;

  void add(mesh::TriMesh mesh);
};

/// The outermost solid that a part is in, else the part.
document::Operand rootWith(const document::Document& document, PartId part);
/// A part, or what is seen of a solid: its own mesh where it is solved, else its parts. Hidden ones have none.
Body bodyOf(const document::Document& document, const pipeline::Derived& derived, document::Operand root);
/// Of parts that are moved together, each solid of them as a whole; twins that move against them are left out.
Body bodyOf(const document::Document& document, const pipeline::Derived& derived, std::span<const PartId> parts);
/// One part without its twin.
Body bodyAlone(const document::Document& document, const pipeline::Derived& derived, PartId part);

/// The greatest z of WorldSpace times a sign at the middles of kFieldCells × kFieldCells cells, row by row from the
/// lowest y; kNothing where nothing is.
using FrontField = std::vector<double>;
inline constexpr std::size_t kFieldCells = 96;
inline constexpr double kNothing = -std::numeric_limits<double>::infinity();
/// Over `area` (its x and y); `sign` 1: the front, −1: the back.
FrontField fieldOf(const Body& body, const pipeline::WorldBounds& area, double sign);

}  // namespace spineloft::app
