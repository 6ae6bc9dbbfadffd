// The mirrors and turns of a Symmetry as maps of the plane. Internal to sections/.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/sections/drawing.h"

namespace spineloft::sections {

/// One map of the group: a turn by `turns`/order of a circle, then the mirror if there is one.
struct Motion {
  double cosine = 1, sine = 0;
  double mirrorX = 1, mirrorY = 1;  ///< −1: that coordinate changes its sign after the turn
  SectionPoint operator()(SectionPoint p) const {
    return {mirrorX * (cosine * p.x - sine * p.y), mirrorY * (sine * p.x + cosine * p.y)};
  }
};

/// All maps of a symmetry. `order` turns; with `mirrored` as many reflections.
struct SymmetryGroup {
  int order = 1;
  bool mirrored = false;
  double axis = 0;  ///< direction of the first mirror, radians: 0 or π/2

  /// Turn by k/order of a circle (any k), then the first mirror if asked.
  Motion motion(int k, bool mirror) const;
  std::vector<Motion> motions() const;  ///< the identity first
  double wedge() const;                 ///< angle between neighbouring mirrors, radians
};
SymmetryGroup groupOf(const Symmetry& symmetry);

/// A closed polygon that consists of copies of one stretch of `length` steps: with `alternating`
/// every second copy runs backwards (as in a mirror). Or an `open` line: there is one copy.
struct Chain {
  std::vector<SectionPoint> points;
  std::size_t length = 0;
  bool alternating = false;
  bool open = false;  ///< it ends at its last point
  /// The places that are images of place `step` (0…length) of the first copy, without repeats.
  std::vector<std::size_t> imagesOf(std::size_t step) const;
};

/// The stretch of a line that a symmetry repeats, and what its images make together.
struct Repeated {
  std::vector<Chain> chains;   ///< the images that join to one curve; or one closed curve …
  std::vector<Motion> copies;  ///< … and the maps that give the whole: at least the identity
};

/// `line` evenly and densely spaced (by `spacing`), ≥ 3 points; `closed`: its last point joins the
/// first.
Repeated repeat(const std::vector<SectionPoint>& line, bool closed, double spacing, const Symmetry& symmetry);

}  // namespace spineloft::sections
