#include "engine/shape/shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/loft/caps.h"
#include "engine/loft/section_track.h"
#include "engine/loft/sweep.h"
#include "engine/shape/levels.h"

namespace spineloft::shape {
namespace {

using sections::CapStyle;

/// Share of the size: what is no rise, and the least step of a cap.
constexpr double kNoRise = 1e-9, kCapStep = 1e-4;

/// The section's points between −1 and 1 both ways, and its hub.
std::vector<SectionPoint> inSquare(const loft::SectionTrack& track) {
  std::vector<SectionPoint> points;
  track.appendShape(0, points);
  const std::span<SectionPoint> ring = std::span(points).first(track.count());
  for (double SectionPoint::* axis : {&SectionPoint::x, &SectionPoint::y}) {
    const auto [low, high] = std::ranges::minmax(ring, {}, axis);
    const double from = low.*axis, size = high.*axis - from;
    for (SectionPoint& p : points) p.*axis = 2 * (p.*axis - from) / size - 1;
  }
  return points;
}

ModelPoint inModel(PicturePoint way) { return {way.x, -way.y, 0}; }

loft::Station stationOf(const Level& level, const Levels& levels) {
  const AxisFrame& frame = levels.frame;
  loft::Station station;
  station.middle = frame.out({(level.low.x + level.high.x) / 2, level.place});
  station.half = frame.aside * level.halfWidth();
  station.centre = inModel(station.middle) + ModelPoint{0, 0, (level.back.x + level.front.x) / 2};
  station.across = inModel(station.half);
  station.depth = {0, 0, level.halfDepth()};
  station.heights = {level.high.y, level.front.y, level.low.y, level.back.y};
  bool rises = false;
  for (double& height : station.heights) {
    height -= level.place;
    rises = rises || std::abs(height) > kNoRise * levels.size;
  }
  if (rises) station.rise = inModel(frame.along);
  return station;
}

loft::Chord chordOf(const Level& level, const AxisFrame& frame) {
  return {frame.out(level.low), frame.out(level.high), 0};
}

/// A tip in the picture's plane, moved to the middle of a level's depth.
loft::Tip tipAt(PicturePoint at, const Level& level) {
  return {inModel(at) + ModelPoint{0, 0, (level.back.x + level.front.x) / 2}, at};
}

/// What goes on beyond the first (`start`) or last level, which has a width: from there outwards.
struct End {
  std::vector<loft::Station> stations;
  std::optional<loft::Tip> tip;
};
End endOf(const Levels& levels, const ShapeParams& params, CapStyle style, bool start) {
  const std::size_t n = levels.all.size();
  const Level &last = levels.all[start ? 0 : n - 1], &before = levels.all[start ? 1 : n - 2];
  const auto chord = [&](const Level& level) {
    const loft::Chord own = chordOf(level, levels.frame);
    return start ? loft::flipped(own) : own;
  };
  const double step = kCapStep * levels.size;
  const PicturePoint travel = levels.frame.along * (start ? -1.0 : 1.0);
  loft::Cap cap;
  loft::CapMemory memory;
  loft::planCap({chord(last), chord(before), chord(before), travel, {}}, {style, params.capRings, {step, step}}, memory,
                cap);
  End end;
  for (const loft::Chord& own : cap.chords) {
    loft::Station station = stationOf(last, levels);
    station.rise = {};
    station.middle = own.middle();
    station.half = (start ? loft::flipped(own) : own).across() / 2;
    station.centre = inModel(station.middle) + ModelPoint{0, 0, station.centre.z};
    station.depth = station.depth * (own.width() / chord(last).width());
    station.across = inModel(station.half);
    end.stations.push_back(station);
  }
  if (cap.tip) end.tip = tipAt(*cap.tip, last);
  return end;
}

/// Everything but the triangles.
loft::Sweep sweepOf(const Levels& levels, const loft::SectionTrack& track, const ShapeParams& params) {
  loft::Sweep sweep;
  sweep.sizes.assign(track.sizes().begin(), track.sizes().end());
  sweep.shapes = inSquare(track);
  const bool many = sweep.sizes.size() > 1;
  const std::size_t n = levels.all.size(), first = levels.startTip && !many, last = n - (levels.endTip && !many);
  for (std::size_t i = first; i < last; ++i) sweep.stations.push_back(stationOf(levels.all[i], levels));
  const auto styleOf = [&](CapStyle style) {
    return many || (style == CapStyle::Open && !track.hollow()) ? CapStyle::Flat : style;
  };
  const auto tipOf = [&](const Level& level) {
    return tipAt(levels.frame.out({(level.low.x + level.high.x) / 2, level.place}), level);
  };
  if (first > 0) {
    sweep.startTip = tipOf(levels.all.front());
  } else {
    const CapStyle style = styleOf(params.caps.start);
    const End end = endOf(levels, params, style, true);
    sweep.stations.insert(sweep.stations.begin(), end.stations.rbegin(), end.stations.rend());
    sweep.startTip = end.tip;
    sweep.startOpen = style == CapStyle::Open;
  }
  if (last < n) {
    sweep.endTip = tipOf(levels.all.back());
  } else {
    const CapStyle style = styleOf(params.caps.end);
    const End end = endOf(levels, params, style, false);
    sweep.stations.insert(sweep.stations.end(), end.stations.begin(), end.stations.end());
    sweep.endTip = end.tip;
    sweep.endOpen = style == CapStyle::Open;
  }
  return sweep;
}

geometry::Contours silhouetteOf(const Levels& levels) {
  std::vector<PicturePoint> outline;
  for (const Level& level : levels.all) outline.push_back(levels.frame.out(level.low));
  for (auto level = levels.all.rbegin(); level != levels.all.rend(); ++level) {
    outline.push_back(levels.frame.out(level->high));
  }
  return {std::move(outline)};
}

}  // namespace

Result<Shaped> makeShape(const ShapeParams& params, std::span<const SeenOutline> outlines, image::Size picture) {
  if (!isValid(params) || picture.width < 1 || picture.height < 1) return Error::ValueOutOfRange;
  const Result<Levels> levels = levelsOf(params, outlines);
  if (!levels.ok()) return levels.failure();
  const std::array keys = {loft::SectionKey{0, levels.value().section, {}}};
  const Result<loft::SectionTrack> track = loft::SectionTrack::along(keys, params.sides, false);
  if (!track.ok()) return track.failure();
  loft::Sweep sweep = sweepOf(levels.value(), track.value(), params);
  loft::SweepMemory memory;
  Shaped shaped;
  if (!loft::sweepMesh(sweep, picture, memory, shaped.mesh)) {
    return Failure{Error::ShapeInvalid, "it is too thin for its size"};
  }
  shaped.silhouette = silhouetteOf(levels.value());
  return shaped;
}

}  // namespace spineloft::shape
