// What a person changed about generated ribs: places along the spine, laid over whatever the search
// finds, so that a new search never destroys an edit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/base/vec.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/ribs/base/spine.h"

namespace spineloft::ribs {

enum class Side : std::uint8_t { Left, Right };

/// One rib end put somewhere by hand. Its place is given in the frame of the spine at `at`: origin on
/// the spine, `along` in the drawing direction, `out` square to it towards the rib's own side. The
/// ends of its side within `reach` move with it, less the farther away they are (a smooth bell from 1
/// to 0), whatever the number of ribs. Where the reach is less than the spacing of the ribs the end
/// nearest to `at` takes what no closer edit gives it, so that no edit gets lost among few ribs.
/// Later edits act on what earlier ones left.
struct EndEdit {
  double at = 0;  ///< share of the spine's length, 0…1
  Side side = Side::Left;
  double along = 0, out = 0;  ///< picture pixels
  double reach = 0;           ///< share of the spine's length, 0…1; at least one rib moves
  bool locked = false;        ///< later edits near by leave this end where it is
  bool operator==(const EndEdit&) const = default;
};

/// The frame of the rib at an end of a part: its middle is the origin, half its width is 1; x leads out of the part
/// along the spine, y to the left end as seen in the drawing direction.
struct RibSpace;
using RibPoint = Vec2<RibSpace>;

/// All edits of one part's ribs.
struct RibEdits {
  std::vector<EndEdit> ends = {};    ///< in the order they were made, at most kMostEndEdits
  std::vector<double> added = {};    ///< places of ribs besides the generated ones, shares of the length
  std::vector<double> removed = {};  ///< the generated rib nearest to each place is left out
  /// The outlines of the ends beyond the first and the last rib, from the left round to the right, at most
  /// kMostFanPoints each; empty: as they were found.
  std::vector<RibPoint> startFan = {}, endFan = {};
  bool operator==(const RibEdits&) const = default;
  bool empty() const { return *this == RibEdits{}; }
};

inline constexpr std::size_t kMostEndEdits = 20000, kMostAddedRibs = 400, kMostFanPoints = 64;

/// The farthest that an edit may put an end from the spine, picture pixels.
inline constexpr double kFarthestEdit = 1e6;
/// The farthest that a point of a fan may be from the middle of its rib, in halves of the rib's width.
inline constexpr double kFarthestFan = 1e4;

/// Finite, in range, not too many.
bool isValid(const RibEdits& edits);

/// The generated ribs with the edits laid over them. Ends that an edit moved by more than half are
/// Edited (Locked where locked); added ribs lie between their neighbours, Bridged, until they are
/// moved (a place that has a rib gets no second one); at least 2 ribs stay. Ends that follow an edit
/// gather at the dragged one where its rib would run across theirs. Fans that were found follow the ribs of
/// their end by the same similarity; those of the edits stand on them. Ribs that no edit reaches come back unchanged.
/// Coordinates stay finite and within 2 kFarthestEdit of the spine's, whatever the edits. Cost: edits × the ribs and
/// edits within their reach.
RibSet applyEdits(const Spine& spine, const RibSet& generated, const RibEdits& edits);

}  // namespace spineloft::ribs
