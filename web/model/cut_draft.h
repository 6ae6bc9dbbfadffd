// A thing that is being cut out of the picture: shown and corrected before it becomes a part.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/vision/cut_out.h"

namespace spineloft::app {

/// What a search gave: outlines, and triangles that fill them.
struct CutShape {
  vision::CutContours contours;
  std::vector<std::array<PicturePoint, 3>> fill;
};
/// For outlines of a cut-out; without triangles when they cannot be filled.
CutShape filledShape(vision::CutContours contours, image::Size picture);

/// What a new part is that a cut-out becomes.
enum class CutInto : std::uint8_t { Puff, Sheet, Shape };

struct CutDraft {
  PictureId picture;
  vision::CutHints hints;               ///< where it began, and the marks since
  std::vector<vision::CutMark> undone;  ///< marks that were taken back, the last one first to come again
  std::size_t shownMarks = 0;           ///< that `shape` knows of
  CutShape shape;                       ///< empty until the first search has ended
  bool adding = true;                   ///< the brush in hand adds, else it takes away
  bool searching = false;
  bool atOnce = false;  ///< becomes a part without being asked, as soon as it is found
  PartId selected;      ///< when it began
  PartId part;          ///< whose region, or outline in this picture, it becomes; none: a new part
  CutInto into = CutInto::Puff;
};

}  // namespace spineloft::app
