#include <algorithm>
#include <array>
#include <utility>

#include "engine/loft/section_track.h"
#include "engine/shape/levels.h"

namespace spineloft::shape {
namespace {

/// Round the two sides that `low` and `high` give of every level.
template <class Low, class High>
std::vector<PicturePoint> around(const Levels& levels, const Low& low, const High& high) {
  std::vector<PicturePoint> line;
  for (const Level& level : levels.all) line.push_back(low(level));
  for (auto level = levels.all.rbegin(); level != levels.all.rend(); ++level) line.push_back(high(*level));
  return line;
}

ModelPoint inModel(PicturePoint p, double z) { return {p.x, -p.y, z}; }

/// The section of the level that is widest.
Result<std::vector<PicturePoint>> sectionSeen(const Levels& levels, int sides, const geometry::View& view) {
  const std::array keys = {loft::SectionKey{0, levels.section, {}}};
  const Result<loft::SectionTrack> track = loft::SectionTrack::along(keys, sides, false);
  if (!track.ok()) return track.failure();
  std::vector<SectionPoint> ring;
  track.value().appendShape(0, ring);
  ring.resize(static_cast<std::size_t>(track.value().sizes().front()));
  const auto [left, right] = std::ranges::minmax(ring, {}, &SectionPoint::x);
  const auto [back, front] = std::ranges::minmax(ring, {}, &SectionPoint::y);
  const Level& widest = *std::ranges::max_element(levels.all, {}, &Level::halfWidth);
  std::vector<PicturePoint> line;
  for (const SectionPoint p : ring) {
    const double across = (p.x - left.x) / (right.x - left.x), deep = (p.y - back.y) / (front.y - back.y);
    const PicturePoint at = levels.frame.out({std::lerp(widest.low.x, widest.high.x, across), widest.place});
    line.push_back(geometry::inView(view, inModel(at, std::lerp(widest.back.x, widest.front.x, deep))));
  }
  return line;
}

}  // namespace

Result<std::vector<PicturePoint>> outlineSeen(const ShapeParams& params, std::span<const SeenOutline> outlines,
                                              const std::optional<geometry::View>& view) {
  if (!isValid(params)) return Error::ValueOutOfRange;
  const Result<Levels> known = levelsOf(params, outlines);
  if (!known.ok()) return known.failure();
  const Levels& levels = known.value();
  const AxisFrame& frame = levels.frame;
  const auto placed = [&](PicturePoint p, double z) { return view ? geometry::inView(*view, inModel(p, z)) : p; };
  switch (roleOf(params.axis, view)) {
    case Role::Section:
      return sectionSeen(levels, params.sides, *view);
    case Role::Depth: {
      const auto at = [&](const Level& level, SectionPoint own) {
        const double middle = (level.low.x + level.high.x) / 2;
        return placed(frame.out({middle, own.y}), own.x);
      };
      return around(
          levels, [&](const Level& level) { return at(level, level.back); },
          [&](const Level& level) { return at(level, level.front); });
    }
    case Role::Width:
      break;
  }
  return around(
      levels, [&](const Level& level) { return placed(frame.out(level.low), 0); },
      [&](const Level& level) { return placed(frame.out(level.high), 0); });
}

}  // namespace spineloft::shape
