// What a solver of steps is asked: the meshes of parts in their places in the world, and what to make of them.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "engine/document/document.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/pipeline/derive.h"

namespace spineloft::publish {

struct SolidPlan {
  /// A part's mesh; it lives as long as the Derived that it comes from.
  struct Mesh {
    ShapeKey key;  ///< equal keys, equal meshes
    const mesh::TriMesh* mesh = nullptr;
  };
  /// A part in its place, or another node.
  struct Operand {
    std::optional<std::size_t> node;
    std::size_t mesh = 0;
    PartId part;
    std::array<double, 16> toWorld{};  ///< 4 × 4, column by column
  };
  struct Node {
    SolidKey key;  ///< of everything that the solid depends on
    StepId step;
    document::StepKind kind = document::StepKind::Join;
    std::vector<Operand> operands;
    double blend = 0, wall = 0;                    ///< WorldSpace
    std::optional<std::array<double, 3>> opening;  ///< unit direction
    double cut = 0;
  };
  std::vector<Mesh> meshes;        ///< each once
  std::vector<Node> nodes;         ///< operands before what is made of them
  std::vector<std::size_t> roots;  ///< nodes of outermost steps
};

/// A mesh that stands for a part's own: while it is being edited.
struct Substitute {
  PartId part;
  ShapeKey key;
  const mesh::TriMesh* mesh = nullptr;
};

/// Everything the document's steps ask for, as far as the parts in them have shapes: an outermost step with a part
/// that waits or failed is left out.
SolidPlan planSolids(const document::Document& document, const pipeline::Derived& derived,
                     const Substitute* instead = nullptr);

/// Of a part in no step: a node that unites it with itself, in its own space (ModelSpace). Adds it to the plan; its key
/// is that of `aloneKey`.
SolidKey aloneKey(PartId part, const pipeline::PartShape& shape);
void planAlone(SolidPlan& plan, PartId part, const pipeline::PartShape& shape);

/// The side of a hollow step that faces a direction most (WorldSpace, any length): an end of its spine before a side of
/// the world that faces it hardly more. Up for a direction without length.
document::OpeningSide sideFacing(const document::Document& document, const pipeline::Derived& derived,
                                 const document::Step& step, const WorldPoint& direction);

}  // namespace spineloft::publish
