// The relief of a part, the last stage of its shape.
#pragma once

#include <cstdint>
#include <memory>

#include "engine/base/cache_key.h"
#include "engine/document/document.h"
#include "engine/mesh/front_uv.h"
#include "engine/pipeline/part_shape.h"

namespace spineloft::relief {
class HeightSteps;
struct Heights;
struct Raised;
}  // namespace spineloft::relief

namespace spineloft::pipeline {

class Cache;

/// The picture that gives a relief: `own`, or the one laid on the part; null where that is not there.
const document::PictureEntry* reliefPicture(const document::Document& document, const relief::Relief& relief,
                                            const document::PictureEntry& own);

/// In pixels.
inline mesh::PictureSize sizeOf(const document::PictureEntry& entry) {
  return {static_cast<double>(entry.size.width), static_cast<double>(entry.size.height)};
}

/// What of a relief may be looked for.
enum class Search : std::uint8_t {
  All,    ///< all of it
  Known,  ///< nothing: what is not known is left to a worker
  Live,   ///< under a hand that moves: what is quick, with fewer triangles, and nothing of it is kept
};

/// Raises the front of `shape`, whose key is `smooth` (none: nothing is known of it), as `relief` says. What is not
/// known and not looked for is named (PartShape::wantedHeights), and the shape stays as it was. A picture without
/// pixels raises nothing. Live: whether it goes through itself is not looked at. A failure leaves the shape as it was.
/// Errors: NoSuchPicture, OutOfMemory.
Status reliefStage(const relief::Relief& relief, const document::PictureEntry& own, const document::Document& document,
                   ShapeKey smooth, Search search, Cache& cache, PartShape& shape);

/// A relief that is not known yet.
struct WantedRelief {
  HeightsKey heights;
  RaisedKey raised;
  std::shared_ptr<const PartShape> smooth;            ///< the shape without it
  std::shared_ptr<const relief::Heights> known = {};  ///< the heights, where those are known
};

/// The search for one in steps, on any thread: it holds what it is made from.
class ReliefJob {
 public:
  ReliefJob(WantedRelief wanted, mesh::PictureSize picture, const relief::Relief& relief,
            std::shared_ptr<const image::Picture> pixels);
  ~ReliefJob();
  ReliefJob(const ReliefJob&) = delete;
  ReliefJob& operator=(const ReliefJob&) = delete;
  /// The next step. False: it was the last.
  bool step();
  RaisedKey key() const { return wanted_.raised; }
  /// After the last: keeps what it found. False: there was no memory for it.
  bool keepIn(Cache& cache) const;

 private:
  bool search();

  WantedRelief wanted_;
  mesh::PictureSize picture_;
  relief::Relief relief_;
  std::unique_ptr<relief::HeightSteps> steps_;
  std::shared_ptr<const relief::Raised> raised_;
};

}  // namespace spineloft::pipeline
