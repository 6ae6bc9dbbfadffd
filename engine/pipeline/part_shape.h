// One part as derived, stage by stage: traced ribs, then the shape made from them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/cache_key.h"
#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/bridge/bridge.h"
#include "engine/document/document.h"
#include "engine/image/edge_map.h"
#include "engine/inflate/bone_edits.h"
#include "engine/loft/posed.h"
#include "engine/loft/workspace.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/evidence/ignored.h"
#include "engine/ribs/search/live_trace.h"
#include "engine/ribs/search/ribs.h"
#include "engine/stack/stack.h"
#include "engine/surface/part_texture.h"

namespace spineloft::inflate {
struct Interior;
}

namespace spineloft::pipeline {

/// Milliseconds now, from any start; handed in because the engine has no clock of its own. May be
/// empty: then every time is 0.
using Clock = std::function<double()>;

struct StageMs {
  double edges = 0, ribs = 0, loft = 0;
  bool operator==(const StageMs&) const = default;
};

/// Where ribs come from: a live trace under the pen (live_trace.h), or the whole one, which is final.
enum class TraceQuality : std::uint8_t { Live, Final };

/// What a stroke finds in its picture, before anything is done to it by hand.
struct TracedRibs {
  ribs::Spine spine;
  ribs::RibSet generated;
  TraceQuality quality = TraceQuality::Final;
};

/// Where a pull left its line.
struct PulledLine {
  std::vector<ModelPoint> points;  ///< on the surface as the pull left it, from one end to the other
  std::vector<ModelPoint> ring;    ///< on the surface, where it stays
  ModelPoint out;                  ///< unit: out of the surface in the middle of the line, before it was pulled
  double share = 1;                ///< of the way that was asked for: less where the part would go through itself
};

/// What a relief found in its picture.
struct ReliefFound {
  relief::Mode mode = relief::Mode::Ink;  ///< ink where light and shadow were asked for and show nothing
  bool seen = false;                      ///< of the part enough is seen for one
  bool raises = false;                    ///< there is something in the picture that became one
  double explained = 0;                   ///< of light and shadow: see relief::Heights
  double share = 1;                       ///< of the height: less where the part would go through itself
};

/// One part as derived from its recipe. Spine, ribs and centre line are of lofts only, contours only of
/// what is made of a region, bones only of puffs with a slice; for others they are empty.
struct PartShape {
  ribs::Spine spine;                                ///< as traced
  ribs::RibSet generated;                           ///< what the search found
  ribs::RibSet ribs;                                ///< with the edits laid over
  ribs::RibSet shown;                               ///< in the pose, seen from the front; equal to `ribs` at rest
  std::vector<ModelPoint> centreLine;               ///< the spine in the pose, ≥ 2 points, one a generated rib
  std::vector<std::vector<PicturePoint>> contours;  ///< of the region as cleaned or turned, closed
  std::vector<inflate::EditedSkeleton> bones;       ///< one a piece of the region
  stack::Ways ways;                                 ///< of curves on planes: which becomes which
  std::vector<PulledLine> pulled;                   ///< one a pull of the part
  std::vector<bridge::Rim> rims;                    ///< of a bridge: where it leaves its parts
  std::optional<ReliefFound> relief;                ///< of a part that has one, once it is known
  HeightsKey wantedHeights;                         ///< of a relief that is not known yet: `mesh` is without
  RaisedKey wantedRaised;
  mesh::TriMesh mesh;                           ///< ModelSpace
  std::shared_ptr<const mesh::TriMesh> smooth;  ///< `mesh` before its relief; null of one without
  double scale = 1;                             ///< of the mesh to the picture: that of a pose across its spine
  /// What the picture shows of it (part_texture.h); null where nothing is seen, and in previews.
  std::shared_ptr<const surface::PartTexture> texture;
  TextureKey textureKey;                       ///< of `texture`; none before the first
  TextureKey wantedTexture;                    ///< of the one that it is to have; none in previews
  std::vector<ribs::IgnoreMark> outlineInk;    ///< the ink along its outline (outline_ink.h); none in previews
  TraceQuality quality = TraceQuality::Final;  ///< of its ribs; what has none is as final
  ShapeKey key;                                ///< shapeKey of what it was made from; equal keys, equal shapes
  StageMs ms;                                  ///< times of its ribs and loft stages; what was known already took none
};

/// Its mesh before its relief: what pulls and bridges are on.
inline const mesh::TriMesh& smoothMesh(const PartShape& shape) { return shape.smooth ? *shape.smooth : shape.mesh; }

/// Whether its texture, or that there is none, is known. Until it is, `texture` is an earlier one or null.
inline bool isTextureKnown(const PartShape& shape) {
  return shape.wantedTexture && shape.textureKey == shape.wantedTexture;
}

/// Memory that they take, about.
std::size_t bytesOf(const TracedRibs& traced);
std::size_t bytesOf(const PartShape& shape);
std::size_t bytesOf(const ribs::IgnoredEdges& ignored);
std::size_t bytesOf(const std::vector<ribs::IgnoreMark>& marks);

/// Before the ribs: what the marks of picture and part leave of the edges. Errors: OutOfMemory.
Result<ribs::IgnoredEdges> ignoredStage(const image::EdgeMap& edges, std::span<const ribs::IgnoreMark> ofPicture,
                                        std::span<const ribs::IgnoreMark> ofPart);

/// First stage: cleanSpine → traceRibs, for everything in a recipe that traceKey covers. The edges may
/// be empty (no evidence yet: guessed ribs); those to ignore are part of
/// the evidence, the marks in the recipe are not looked at. `memory` is reused and never shows in the
/// result. Errors: those of the two, OutOfMemory.
Result<TracedRibs> traceStage(const document::LoftRecipe& recipe, const ribs::PictureEvidence& picture,
                              const Progress& progress, ribs::RibWorkspace& memory);

/// What a stroke under the pen is traced in, from move to move.
struct LivePen {
  ribs::SpineMemory spine;
  ribs::LiveTrace trace;
  TracedRibs traced;
};

/// The same for a stroke under the pen, whose moves `pen` follows, into `pen.traced`. A stroke like an earlier one
/// asks for no memory. After a failure `pen.traced` is of no use.
Status liveStage(const document::LoftRecipe& recipe, const ribs::PictureEvidence& picture, LivePen& pen);

/// What shapes are made in, from frame to frame.
struct ShapeMemory {
  loft::PoseMemory pose;
  loft::PosedSpine posed;
  loft::LoftWorkspace loft;
  ribs::RibSet edited;
  mesh::TriMesh mesh;
};

/// The rest: applyEdits → pose → loftRibs. Pure but for the clock. `key` of the result is 0. Errors:
/// those of the stages, OutOfMemory. `memory` is reused and never shows in the result.
Result<PartShape> shapeStage(const document::LoftRecipe& recipe, const TracedRibs& traced, image::Size picture,
                             ShapeMemory& memory, const Clock& clock = {});
/// The same in place of what `shape` held, which a failure leaves as it was. Asks for no memory once `memory` and
/// `shape` have seen parts as large, without edits, where loftRibs and poseSpine ask for none.
Status shapeStage(const document::LoftRecipe& recipe, const TracedRibs& traced, image::Size picture,
                  ShapeMemory& memory, PartShape& shape, const Clock& clock = {});

/// Of a region: clean → inflate, clean → give thickness, or turn about the axis. `key` of the result is 0; the times
/// stand in `ms.loft`. `interior`: of a puff with a slice, by interiorKey; where it is null it is made, and then there.
/// Errors: NotARegion (others), those of inflateRegion, extrudeRegion and spinRegion, OutOfMemory.
using KnownInterior = std::shared_ptr<const inflate::Interior>;
Result<PartShape> regionStage(const document::Recipe& recipe, image::Size picture, KnownInterior& interior,
                              const Clock& clock = {});
Result<PartShape> regionStage(const document::Recipe& recipe, image::Size picture, const Clock& clock = {});

/// Slice by slice. `key` of the result is 0; the time stands in `ms.loft`. Errors: those of stackPlanes, OutOfMemory.
Result<PartShape> stackStage(const document::StackRecipe& recipe, image::Size picture, const Clock& clock = {});

/// A shape from its outlines, whose pictures are in the document. `key` of the result is 0; the time stands in
/// `ms.loft`. Errors: ViewInvalid, those of shape::makeShape, OutOfMemory.
Result<PartShape> outlineStage(const document::ShapeRecipe& recipe, const document::Document& document,
                               image::Size picture, const Clock& clock = {});

/// The side outline of a loft or a puff, where it has one, says how deep every row of its shape is (shape::fitToSide);
/// the centre line goes along. A failure leaves the shape as it was. Errors: ViewInvalid, those of shape::fitToSide,
/// OutOfMemory.
Status sideStage(const document::Recipe& recipe, const document::Document& document, PartShape& shape);

class Cache;
/// Pulls the mesh, one after the other. `before`: unpulledKey of the shape, by which `cache` knows what a pull reaches;
/// none: it is not looked there. Live: whether it goes through itself is not looked at. A failure leaves the shape as
/// it was. Errors: those of pull::reachOf, OutOfMemory.
Status pullStage(std::span<const pull::Pull> pulls, ShapeKey before, TraceQuality quality, Cache& cache,
                 PartShape& shape);

/// Both in one go, for a picture without marks of its own.
Result<PartShape> shapePart(const document::LoftRecipe& recipe, const image::EdgeMap& edges, image::Size picture,
                            const Progress& progress, const Clock& clock = {});

}  // namespace spineloft::pipeline
