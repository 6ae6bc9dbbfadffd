// From the document to what is seen: edges → ribs → meshes, each stage keyed by a hash of its inputs.
// The only place that joins vision, ribs, loft and document. Dropping the cache changes nothing that
// a person sees.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/pipeline/cache.h"
#include "engine/pipeline/drawing_shape.h"
#include "engine/pipeline/keys.h"
#include "engine/pipeline/part_shape.h"
#include "engine/pipeline/part_texture.h"
#include "engine/pipeline/relief_shape.h"
#include "engine/pipeline/solid.h"
#include "engine/vision/edges.h"

namespace spineloft::pipeline {

/// A part of the document with its shape.
struct DerivedPart {
  PartId id;
  std::shared_ptr<const PartShape> shape;  ///< null while `waiting` and after a failure
  std::optional<Failure> failure;
  /// The edges of its picture are not in the cache yet.
  bool waiting = false;
  /// Of a part in no step that crosses itself: its mesh without self-intersections (ModelSpace, with UV). Files get
  /// this mesh. The caller that has a solver fills it when a file is wanted.
  std::shared_ptr<const Solid> mended = nullptr;
  /// Where the part goes through itself, if that was looked for and could not be mended.
  std::optional<ModelPoint> crossesAt = std::nullopt;
  /// Its relief is not known yet: `shape` is without, unless the caller shows an earlier one.
  std::optional<WantedRelief> wantedRelief = std::nullopt;
};

/// A line drawing, solved.
struct DerivedDrawing {
  DrawingId id;
  std::vector<PartId> pieces;  ///< the part that each piece of `shape` is
  std::shared_ptr<const DrawingShape> shape;
};

struct Derived {
  std::vector<DerivedPart> parts;  ///< same order as Document::parts
  /// Pixels of every picture, same order as Document::pictures: a photo's own, a sketch's as drawn.
  /// Null where a sketch failed.
  std::vector<std::shared_ptr<const image::Picture>> pictures;
  std::vector<DerivedDrawing> drawings;  ///< same order as Document::drawings
  /// Pictures whose edges are not in the cache, each once: let a worker find them (detectEdges),
  /// keep them in the cache, derive again.
  std::vector<PictureId> wantedEdges;
  /// Parts whose texture is not made yet, one of each shape: let a worker make it (makeTexture), assign it to the
  /// shape in the cache, derive again.
  std::vector<PartId> wantedTextures;
  /// Parts whose relief is not known yet: let a worker look for it (makeRelief), keep it in the cache, derive again.
  std::vector<PartId> wantedReliefs;
  /// Steps with what is known of their solids, same order as Document::steps; filled by whoever has a
  /// solver. Empty: no step is solved, and parts show themselves.
  std::vector<DerivedStep> steps;
};

/// The pixels of a picture of the document; null when there is no such picture or no pixels.
const image::Picture* pixelsOf(const document::Document& document, const Derived& derived, PictureId id);

/// Whether textures and reliefs are computed at once, or left for workers while the page shows the parts without them.
enum class Finish : std::uint8_t { Now, Later };

/// Derives every part; a cached shape costs one hash of its recipe, and where only what comes after
/// the ribs changed, the ribs are not traced again. Never looks for edges itself.
Derived derive(const document::Document& document, Cache& cache, const Clock& clock = {}, Finish finish = Finish::Now);

/// The job of the texture of one of `wantedTextures`. Null when there is no such part with a shape, or no memory.
std::shared_ptr<TextureJob> makeTexture(const document::Document& document, const Derived& derived, PartId part);

/// The search for one of `wantedReliefs`. Null when there is no such part with a shape, no picture, or no memory.
std::shared_ptr<ReliefJob> makeRelief(const document::Document& document, const Derived& derived, PartId part);

/// What is done to the surface of a part.
struct Worked {
  std::span<const pull::Pull> pulls = {};
  const relief::Relief* relief = nullptr;  ///< in previews as Search::Live, where the recipe stays as it is
};

/// What a recipe would become with the edges known so far (guessed ribs where there are none yet),
/// for a part that is not in the document or differs from it. Traced
/// ribs are used again: while edits, sections, ends or pose change, only the later stages run. Errors: NoSuchPicture,
/// those of the stages.
Result<PartShape> previewShape(const document::Document& document, const document::Recipe& recipe, Cache& cache,
                               const Clock& clock = {}, Worked worked = {});
/// The same in place of what `shape` held, which a failure leaves as it was.
Status previewShape(const document::Document& document, const document::Recipe& recipe, Cache& cache, PartShape& shape,
                    const Clock& clock = {}, Worked worked = {});

/// The same for a stroke that is being drawn. Ribs that are not known yet come from a live trace and have
/// TraceQuality::Live. Call previewShape when the pen rests.
Result<PartShape> liveShape(const document::Document& document, const document::Recipe& recipe, Cache& cache,
                            const Clock& clock = {}, Worked worked = {});
/// The same in place of what `shape` held, which a failure leaves as it was. A stroke like an earlier one asks for
/// no memory, where shapeStage asks for none.
Status liveShape(const document::Document& document, const document::Recipe& recipe, Cache& cache, PartShape& shape,
                 const Clock& clock = {}, Worked worked = {});

/// The recipe's stroke as far as it lies on the object, by the edges known so far (ribs::strokeOnThing); the whole
/// stroke where none are known. Picture pixels.
std::vector<PicturePoint> strokeOnThing(const document::Document& document, const document::LoftRecipe& recipe,
                                        Cache& cache);

/// As `derive`, but finds missing edges on the calling thread first (command line, tests). `edgesMs`,
/// when given, receives the time they took.
/// Errors: those of detectEdges. Failures of single parts stay in their DerivedPart.
Result<Derived> deriveWithEdges(const document::Document& document, Cache& cache, const Progress& progress,
                                const Clock& clock = {}, double* edgesMs = nullptr);

}  // namespace spineloft::pipeline
