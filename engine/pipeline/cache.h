// Results of stages that are already known. Owned by one thread.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "engine/base/cache_key.h"
#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/image/edge_map.h"
#include "engine/pipeline/drawing_shape.h"
#include "engine/pipeline/part_shape.h"

namespace spineloft::pull {
struct Reach;
}
namespace spineloft::relief {
struct Heights;
struct Raised;
}  // namespace spineloft::relief

namespace spineloft::pipeline {

/// Values by key, each with its size; when they are more than `budget` bytes those used longest ago
/// go (least recently used). Finding one counts as using it.
template <class Key, class Value>
class LruCache {
 public:
  explicit LruCache(std::size_t budget) : budget_(budget) {}
  std::shared_ptr<const Value> find(Key key) {
    for (Slot& slot : slots_) {
      if (slot.key != key) continue;
      slot.used = ++clock_;
      return slot.value;
    }
    return nullptr;
  }
  void keep(Key key, std::shared_ptr<const Value> value, std::size_t bytes) {
    std::erase_if(slots_, [&](const Slot& slot) { return slot.key == key; });
    slots_.push_back({key, std::move(value), bytes, ++clock_});
    while (this->bytes() > budget_ && slots_.size() > 1) {
      slots_.erase(std::ranges::min_element(slots_, {}, &Slot::used));
    }
  }
  std::size_t bytes() const {
    std::size_t sum = 0;
    for (const Slot& slot : slots_) sum += slot.bytes;
    return sum;
  }

 private:
  struct Slot {
    Key key;
    std::shared_ptr<const Value> value;
    std::size_t bytes;
    std::uint64_t used;
  };
  std::vector<Slot> slots_;
  std::size_t budget_;
  std::uint64_t clock_ = 0;
};

class Cache {
 public:
  /// Null when not (or no longer) known.
  std::shared_ptr<const image::EdgeMap> edges(std::uint64_t contentHash) const;
  void keepEdges(std::uint64_t contentHash, std::shared_ptr<const image::EdgeMap> edges);
  /// By ignoredKey. Null when not (or no longer) known.
  std::shared_ptr<const ribs::IgnoredEdges> ignored(IgnoredKey key) { return ignored_.find(key); }
  void keepIgnored(IgnoredKey key, std::shared_ptr<const ribs::IgnoredEdges> ignored);
  /// By traceKey: final ribs. Null when not (or no longer) known. Those of previews are kept apart: a stroke being
  /// drawn must not evict the parts of the document.
  std::shared_ptr<const TracedRibs> traced(TraceKey key);
  void keepTraced(TraceKey key, std::shared_ptr<const TracedRibs> traced, bool isPreview);
  /// By interiorKey. Null when not (or no longer) known.
  KnownInterior interior(InteriorKey key) { return interiors_.find(key); }
  void keepInterior(InteriorKey key, KnownInterior interior);
  /// By drawingKey. Null when not (or no longer) known.
  std::shared_ptr<const DrawingShape> drawing(DrawingKey key) { return drawings_.find(key); }
  void keepDrawing(DrawingKey key, std::shared_ptr<const DrawingShape> drawing);
  /// By unpulledKey: shapes before their pulls and reliefs. Null when not (or no longer) known.
  std::shared_ptr<const PartShape> unpulled(ShapeKey key) { return unpulled_.find(key); }
  void keepUnpulled(ShapeKey key, std::shared_ptr<const PartShape> shape);
  /// By reachKey. Null when not (or no longer) known.
  std::shared_ptr<const pull::Reach> reach(ReachKey key) { return reaches_.find(key); }
  void keepReach(ReachKey key, std::shared_ptr<const pull::Reach> reach);
  /// By heightsKey and by raisedKey. Null when not (or no longer) known.
  std::shared_ptr<const relief::Heights> heights(HeightsKey key) { return heights_.find(key); }
  void keepHeights(HeightsKey key, std::shared_ptr<const relief::Heights> heights);
  std::shared_ptr<const relief::Raised> raised(RaisedKey key) { return raised_.find(key); }
  void keepRaised(RaisedKey key, std::shared_ptr<const relief::Raised> raised);
  /// By shapeKey. Null when not (or no longer) known; marks the shape as used in this round.
  std::shared_ptr<const PartShape> shape(ShapeKey key);
  void keepShape(std::shared_ptr<const PartShape> shape);
  /// The shape of that key, which is to have this texture. It keeps the one that it has until then. Null when the
  /// shape is not known any more.
  std::shared_ptr<const PartShape> wantTexture(ShapeKey key, TextureKey wanted);
  /// The shape that wants the texture of that key, with it (null: there is nothing to see of it). Null when none does
  /// any more.
  std::shared_ptr<const PartShape> assignTexture(TextureKey key, std::shared_ptr<const surface::PartTexture> texture);
  /// A round is one `derive`. Keeps the shapes of the last kKeptRounds rounds, so that undo and redo
  /// find theirs, as far as they fit into kShapeBytes, and the edges in `usedEdges`.
  void endRound(const std::vector<std::uint64_t>& usedEdges);
  /// The pixels of an entry: its own, or the sketch as drawn: kept while it is on the board, and
  /// earlier states of it as far as they fit into kSketchBytes; only strokes that are new are drawn.
  /// Errors: those of image::drawSketch.
  Result<std::shared_ptr<const image::Picture>> pixels(const document::PictureEntry& entry);
  /// For traceStage.
  ribs::RibWorkspace& ribMemory() { return ribMemory_; }
  /// For liveStage.
  LivePen& live() { return live_; }
  void clear() { *this = {}; }

  /// What is kept apart from edges and pictures, in bytes.
  std::size_t bytes() const;

  /// For shapeStage, likewise from frame to frame.
  ShapeMemory& shapeMemory() { return shapeMemory_; }

  /// A step of undo has up to three rounds: its shapes, their ribs, their textures.
  static constexpr std::uint64_t kKeptRounds = 96;
  /// About 400 parts of 100 ribs; 25 previews; 60 parts of usual size with their textures besides those
  /// shown; the marks of 4 pictures; 20 puffs with a slice; 10 drawings of 8 pieces; 20 parts before their pulls and
  /// reliefs, and what 20 pulls reach; 8 reliefs, and what 8 of them raise.
  static constexpr std::size_t kTraceBytes = 16u << 20, kPreviewBytes = 1u << 20, kShapeBytes = 64u << 20,
                               kIgnoredBytes = 16u << 20, kInteriorBytes = 4u << 20, kDrawingBytes = 8u << 20,
                               kUnpulledBytes = 8u << 20, kReachBytes = 16u << 20, kHeightBytes = 16u << 20,
                               kRaisedBytes = 32u << 20;
  /// Five earlier states of a 1024 × 768 sketch.
  static constexpr std::size_t kSketchBytes = 16u << 20;

 private:
  struct EdgeSlot {
    std::uint64_t contentHash;
    std::shared_ptr<const image::EdgeMap> edges;
  };
  struct ShapeSlot {
    std::shared_ptr<const PartShape> shape;
    std::uint64_t lastRound;
    std::size_t bytes;
  };
  struct SketchSlot {
    std::uint64_t contentHash;
    std::vector<Box<image::SketchStroke>> strokes;
    std::shared_ptr<const image::Picture> picture;
  };
  std::vector<EdgeSlot> edges_;
  LruCache<IgnoredKey, ribs::IgnoredEdges> ignored_{kIgnoredBytes};
  LruCache<TraceKey, TracedRibs> traced_{kTraceBytes}, previews_{kPreviewBytes};
  LruCache<InteriorKey, inflate::Interior> interiors_{kInteriorBytes};
  LruCache<DrawingKey, DrawingShape> drawings_{kDrawingBytes};
  LruCache<ShapeKey, PartShape> unpulled_{kUnpulledBytes};
  LruCache<ReachKey, pull::Reach> reaches_{kReachBytes};
  LruCache<HeightsKey, relief::Heights> heights_{kHeightBytes};
  LruCache<RaisedKey, relief::Raised> raised_{kRaisedBytes};
  std::vector<ShapeSlot> shapes_;
  std::vector<SketchSlot> sketches_;
  ribs::RibWorkspace ribMemory_;
  LivePen live_;
  std::uint64_t round_ = 0;
  ShapeMemory shapeMemory_;
};

}  // namespace spineloft::pipeline
