// Stretches of the outline of a part that may be hidden by an occluder: the ribs there do not separate the part from
// what stands before it.
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

/// Whether a rib end is on an outline, or was placed by the person.
inline bool isSeen(ribs::RibState state) {
  return state != ribs::RibState::Bridged && state != ribs::RibState::Guessed;
}

/// Ribs at each end of a part that may reach beyond it: there the outline cannot be told from another edge farther
/// out.
inline std::size_t doubtfulEnds(std::size_t ribs) {
  constexpr double kShare = 0.08;
  return static_cast<std::size_t>(kShare * static_cast<double>(ribs)) + 1;
}

/// Ribs beside a hidden one that are not trusted either: an occluder starts a little before the stretch that it
/// hides.
inline constexpr std::size_t kBeside = 4;

/// One flag a rib.
struct PassedEnds {
  std::vector<bool> left, right;
};

/// The rib ends on an edge where the picture just within has colours that go on outside near by, but are hardly
/// anywhere on the part far from there, and less common outside: something passes over the outline there, and the
/// edge may be its own. Samples of at most 64 ribs are compared with each other.
PassedEnds passedEnds(const ribs::RibSet& set, const image::Picture& picture);

/// The longest runs of ribs, with a few exceptions inside, that are on no outline on one side or are passed over by
/// something. Not at the ends of the part; at most two. surface::occluderMask decides whether an occluder is there.
std::vector<surface::OccludedOutline> occludedStretches(const ribs::RibSet& set, const image::Picture& picture);

}  // namespace spineloft::pipeline
