// Edges that a person scribbled away: what is left of the evidence without them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/image/edge_map.h"
#include "engine/ribs/base/rib_set.h"

namespace spineloft::ribs {

/// A layer over an EdgeMap, of the same size. Without marks both planes are empty.
struct IgnoredEdges {
  std::vector<std::uint8_t> mask;  ///< 255 under a mark, else 0
  /// EdgeMap::nearness as it would be without the edges under the marks.
  std::vector<float> proximity;
  bool empty() const { return mask.empty(); }
  bool operator==(const IgnoredEdges&) const = default;
};

/// The layer of the marks of a picture and of a part together: under them are the map pixels whose
/// centres lie within a mark's radius of its stroke. Marks that are not finite or have no radius
/// count for nothing. Cost: the pixels marked, and (2 · reach)² per edge pixel near them.
IgnoredEdges ignoreEdges(const image::EdgeMap& edges, std::span<const IgnoreMark> ofPicture,
                         std::span<const IgnoreMark> ofPart);

}  // namespace spineloft::ribs
