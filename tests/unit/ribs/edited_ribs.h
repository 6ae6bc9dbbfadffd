// Ribs without a picture, and seeded edits of them, that the tests of edits and gestures share.
#pragma once

#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "engine/geometry/polyline.h"
#include "engine/ribs/edit/edit_gestures.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/rib_frame.h"

namespace spineloft::fixtures {

/// A wavy band: `count` ribs square to the line y = 300 + bend · sin, 20 to 60 px to either side.
struct Band {
  ribs::Spine spine;
  ribs::RibSet ribs;
  ribs::RibSet edited(const ribs::RibEdits& edits) const { return ribs::applyEdits(spine, ribs, edits); }
  ribs::EditScene scene(const ribs::RibSet& seen, const ribs::RibEdits& edits) const { return {spine, seen, edits}; }
};

inline Band bandOf(int count, double bend = 40, double mirrorX = 0) {
  std::vector<PicturePoint> line;
  for (int i = 0; i <= 4000; ++i) {
    const double x = 100 + 0.15 * i;
    line.push_back({mirrorX > 0 ? mirrorX - x : x, 300 + bend * std::sin((x - 100) / 90)});
  }
  Band band;
  band.spine.points = geometry::resample(std::span<const PicturePoint>(line), static_cast<std::size_t>(count));
  const std::vector<PicturePoint> ahead = band.spine.points;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    const PicturePoint c = ahead[static_cast<std::size_t>(i)];
    const double x = mirrorX > 0 ? mirrorX - c.x : c.x;
    const double slope = bend / 90 * std::cos((x - 100) / 90);
    const PicturePoint along = normalized(PicturePoint{mirrorX > 0 ? -1.0 : 1.0, slope});
    const PicturePoint left{along.y, -along.x};
    ribs::Rib rib;
    rib.center = c;
    const double l = 40 + 20 * std::sin(9 * t), r = 35 + 15 * std::cos(7 * t);
    // In a mirror left and right change places.
    rib.left = c + left * (mirrorX > 0 ? r : l);
    rib.right = c - left * (mirrorX > 0 ? l : r);
    rib.leftState = rib.rightState = ribs::RibState::Edge;
    rib.leftLevel = rib.rightLevel = 30;
    band.ribs.ribs.push_back(rib);
  }
  for (int i = 1; i < 8; ++i) {
    const double angle = 3.14159265 * i / 8;
    band.ribs.startFan.points.push_back(ahead.front() + PicturePoint{-30 * std::sin(angle), -30 * std::cos(angle)});
    band.ribs.endFan.points.push_back(ahead.back() + PicturePoint{30 * std::sin(angle), -30 * std::cos(angle)});
  }
  return band;
}

/// Any valid edits: tame and wild, soft and alone, some locked, ribs added and left out.
inline ribs::RibEdits randomEdits(Rng& rng, double wildness = 1) {
  ribs::RibEdits edits;
  for (std::uint32_t i = rng.below(30); i-- > 0;) {
    ribs::EndEdit edit;
    edit.at = rng.below(8) == 0 ? rng.below(2) : rng.uniform();
    edit.side = rng.below(2) ? ribs::Side::Left : ribs::Side::Right;
    const double size = rng.below(10) == 0 ? 1e6 * wildness : 80;
    edit.along = std::clamp(rng.uniform(-size, size) * 0.2, -1e6, 1e6);
    edit.out = std::clamp(rng.uniform(-0.3 * size, size), -1e6, 1e6);
    edit.reach = rng.below(3) == 0 ? 0 : rng.uniform(0, rng.below(4) == 0 ? 1 : 0.2);
    edit.locked = rng.below(6) == 0;
    edits.ends.push_back(edit);
  }
  for (std::uint32_t i = rng.below(6); i-- > 0;) edits.added.push_back(rng.uniform());
  for (std::uint32_t i = rng.below(6); i-- > 0;) edits.removed.push_back(rng.uniform());
  for (auto* fan : {&edits.startFan, &edits.endFan}) {
    if (rng.below(4) > 0) continue;
    for (std::uint32_t i = rng.below(14); i > 0; --i) {
      fan->push_back({wildness * rng.uniform(-1, 3), wildness * rng.uniform(-2, 2)});
    }
  }
  return edits;
}

inline PicturePoint endOf(const ribs::Rib& rib, ribs::Side side) {
  return side == ribs::Side::Left ? rib.left : rib.right;
}
inline ribs::RibState stateOf(const ribs::Rib& rib, ribs::Side side) {
  return side == ribs::Side::Left ? rib.leftState : rib.rightState;
}

/// The place of the i-th point of a band's spine.
inline double placeOfRib(const Band& band, std::size_t i) { return ribs::Ruler(band.spine.points).placeOfPoint(i); }

/// Where the line through the ends of a side of generated ribs passes a place.
inline PicturePoint sideAt(const Band& band, const ribs::RibSet& set, ribs::Side side, double at) {
  std::size_t i = 0;
  while (i + 2 < set.ribs.size() && placeOfRib(band, i + 1) <= at) ++i;
  const double from = placeOfRib(band, i), to = placeOfRib(band, i + 1);
  return lerp(endOf(set.ribs[i], side), endOf(set.ribs[i + 1], side), (at - from) / (to - from));
}

}  // namespace spineloft::fixtures
