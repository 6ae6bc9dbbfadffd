// Where something may come in over a part: stretches of its outline at which its ribs do not tell it from what
// stands before it.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/surface/part_texture.h"

namespace spineloft::pipeline {

/// UV of the picture.
inline PicturePoint toUv(PicturePoint p, image::Size picture) {
  return {(p.x + 0.5) / picture.width, (p.y + 0.5) / picture.height};
}

/// Whether a rib end stands on an outline, or where a hand put it.
inline bool isSeen(ribs::RibState state) {
  return state != ribs::RibState::Bridged && state != ribs::RibState::Guessed;
}

/// So many ribs at each end of a part may reach beyond it: nothing tells an outline from any edge further on.
inline std::size_t doubtfulEnds(std::size_t ribs) {
  constexpr double kShare = 0.08;
  return static_cast<std::size_t>(kShare * static_cast<double>(ribs)) + 1;
}

/// Ribs beside one that is not seen which are not believed either: what hides an outline begins a little before it.
inline constexpr std::size_t kBeside = 4;

/// One flag a rib.
struct PassedEnds {
  std::vector<bool> left, right;
};

/// The rib ends on an edge where the picture just within has colours that go on outside near by, but are hardly
/// anywhere on the part far from there, and less common outside: something passes over the outline there, and the
/// edge may be its own. Samples of at most 64 ribs are compared with each other.
PassedEnds passedEnds(const ribs::RibSet& set, const image::Picture& picture);

/// The longest stretches of ribs in a row, but for a few between them, that stand on no outline on one side, or that
/// something passes over there; not at the ends of the part. At most two. Whether it comes in is for
/// surface::intruder to say.
std::vector<surface::OccludedOutline> occludedStretches(const ribs::RibSet& set, const image::Picture& picture);

}  // namespace spineloft::pipeline
