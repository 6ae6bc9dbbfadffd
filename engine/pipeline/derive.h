// From the document to what is seen: edges → ribs → meshes, each stage keyed by a hash of its inputs.
// The only place that joins vision, ribs, loft and document. Dropping the cache changes nothing that
// a person sees.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/image/edge_map.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/ribs/ribs.h"
#include "engine/vision/edges.h"

namespace spineloft::pipeline {

/// Milliseconds now, from any start; handed in because the engine has no clock of its own. May be
/// empty: then every time is 0.
using Clock = std::function<double()>;

struct StageMs {
  double edges = 0, ribs = 0, loft = 0;
  bool operator==(const StageMs&) const = default;
};

/// One part as derived from its recipe.
struct PartShape {
  ribs::Spine spine;       ///< as traced
  ribs::RibSet generated;  ///< what the search found
  ribs::RibSet ribs;       ///< with the edits laid over
  ribs::RibSet shown;      ///< in the pose, seen from the front; equal to `ribs` at rest
  std::vector<ModelPoint> centreLine;  ///< the spine in the pose, ≥ 2 points, one a generated rib
  mesh::TriMesh mesh;      ///< ModelSpace
  std::uint64_t key = 0;  ///< shapeKey of what it was made from; equal keys, equal shapes
  StageMs ms;             ///< times of its ribs and loft stages
};

/// Shape of one recipe: cleanSpine → traceRibs → applyEdits → pose → loftRibs. Pure but for the clock. `edges` may be
/// empty (no evidence yet: guessed ribs). Serves the finished part and the preview under the pen.
/// `key` of the result is 0. Errors: those of the three stages, OutOfMemory.
Result<PartShape> shapePart(const document::LoftRecipe& recipe, const image::EdgeMap& edges,
                            image::Size picture, const Progress& progress, const Clock& clock = {});

/// Hash of everything a shape depends on: the recipe, and the picture's content and ignored edges.
std::uint64_t shapeKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry);

/// Edges and shapes that are already known. Owned by one thread.
class Cache {
 public:
  /// Null when not (or no longer) known.
  std::shared_ptr<const image::EdgeMap> edges(std::uint64_t contentHash) const;
  void keepEdges(std::uint64_t contentHash, std::shared_ptr<const image::EdgeMap> edges);
  /// Null when not (or no longer) known; marks the shape as used in this round.
  std::shared_ptr<const PartShape> shape(std::uint64_t key);
  void keepShape(std::shared_ptr<const PartShape> shape);
  /// A round is one `derive`. Keeps the shapes of the last kKeptRounds rounds, so that undo and redo
  /// find theirs, and the edges in `usedEdges`.
  void endRound(const std::vector<std::uint64_t>& usedEdges);
  /// The pixels of an entry: its own, or the sketch as drawn (kept while it is on the board). Errors:
  /// those of image::drawSketch.
  Result<std::shared_ptr<const image::Picture>> pixels(const document::PictureEntry& entry);
  void clear() { *this = {}; }

  static constexpr std::uint64_t kKeptRounds = 32;

 private:
  struct EdgeSlot {
    std::uint64_t contentHash;
    std::shared_ptr<const image::EdgeMap> edges;
  };
  struct ShapeSlot {
    std::shared_ptr<const PartShape> shape;
    std::uint64_t lastRound;
  };
  std::vector<EdgeSlot> edges_;
  struct SketchSlot {
    std::uint64_t contentHash;
    std::shared_ptr<const image::Picture> picture;
  };
  std::vector<ShapeSlot> shapes_;
  std::vector<SketchSlot> sketches_;
  std::uint64_t round_ = 0;
};

/// A part of the document with its shape.
struct DerivedPart {
  PartId id;
  std::shared_ptr<const PartShape> shape;  ///< null while `waiting` and after a failure
  std::optional<Failure> failure;
  bool waiting = false;  ///< the edges of its picture are not in the cache yet
};

struct Derived {
  std::vector<DerivedPart> parts;  ///< same order as Document::parts
  /// Pixels of every picture, same order as Document::pictures: a photo's own, a sketch's as drawn.
  /// Null where a sketch failed.
  std::vector<std::shared_ptr<const image::Picture>> pictures;
  /// Pictures whose edges are not in the cache, each once: let a worker find them (detectEdges),
  /// keep them in the cache, derive again.
  std::vector<PictureId> wantedEdges;
};

/// The pixels of a picture of the document; null when there is no such picture or no pixels.
const image::Picture* pixelsOf(const document::Document& document, const Derived& derived,
                               PictureId id);

/// Derives every part; a cached shape costs one hash of its recipe. Never looks for edges itself.
Derived derive(const document::Document& document, Cache& cache, const Clock& clock = {});

/// As `derive`, but finds missing edges on the calling thread first (command line, tests). `edgesMs`,
/// when given, receives the time they took.
/// Errors: those of detectEdges. Failures of single parts stay in their DerivedPart.
Result<Derived> deriveWithEdges(const document::Document& document, Cache& cache,
                                const Progress& progress, const Clock& clock = {},
                                double* edgesMs = nullptr);

}  // namespace spineloft::pipeline
