// Solids made from parts by a solver outside of the engine, as they are shown and exported.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/cache_key.h"
#include "engine/base/ids.h"
#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/document/document.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::pipeline {

struct Derived;

/// The faces of a solid that come from one part.
struct SolidPiece {
  PartId part;         ///< none: its part is gone
  mesh::TriMesh mesh;  ///< WorldSpace, open, with UV in the part's picture
};

struct Solid {
  SolidKey key;        ///< of what it was made from; equal keys, equal solids
  mesh::TriMesh mesh;  ///< WorldSpace, closed, without UV
  std::vector<SolidPiece> pieces;
  double volume = 0, area = 0;  ///< world units
  int genus = 0;
  double ms = 0;  ///< what the solver took
};

/// Memory that it takes, about.
std::size_t bytesOf(const Solid& solid);

/// A mesh as the solver hands it over: vertices may stand at one place with different UV.
struct SolidArrays {
  std::span<const float> positions;                   ///< 3 a vertex
  std::span<const float> uv;                          ///< 2 a vertex
  std::span<const std::uint32_t> corners;             ///< 3 a triangle
  std::span<const std::uint32_t> mergeFrom, mergeTo;  ///< vertices at one place
  struct Run {
    PartId part;
    std::size_t first = 0, count = 0;  ///< triangles
  };
  std::vector<Run> runs;
};
/// The solid of these arrays; its key, measures and time are left for the caller. Error: MeshInvalid (sizes or
/// numbers that do not fit).
Result<Solid> solidFrom(const SolidArrays& arrays);

/// A step of the document with what is known of its solid. Only outermost steps have one.
struct DerivedStep {
  StepId id;
  std::shared_ptr<const Solid> solid;  ///< the last good one; may be of an earlier state
  std::optional<Failure> failure;      ///< why there is none of the present state
  PartId faulty;                       ///< the part at fault, where one is
  std::optional<WorldPoint> at;        ///< where it shows
  std::optional<double> thickest;      ///< the thickest wall that fits, WorldSpace, where one was too thick; 0: none
  bool waiting = false;                ///< the solver is at it
};

/// The outermost step in whose solid a part shows; null: it shows itself.
const DerivedStep* solidOf(const document::Document& document, const Derived& derived, PartId part);
/// Whether a part is to be seen: in a solid it shows and hides as the whole does, whatever it was before.
bool isVisible(const document::Document& document, const document::Part& part);
/// Whether a part is to be drawn and exported on its own: visible, and in no solid.
bool showsItself(const document::Document& document, const Derived& derived, const document::Part& part);
/// The step as derived when its solid is to be drawn and exported: outermost, visible, with a solid. Else null.
const DerivedStep* shownSolid(const document::Document& document, const Derived& derived, const document::Step& step);

}  // namespace spineloft::pipeline
