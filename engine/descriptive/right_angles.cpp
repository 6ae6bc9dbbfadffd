#include "engine/descriptive/right_angles.h"

#include <algorithm>
#include <array>
#include <optional>

#include "engine/descriptive/axes.h"
#include "engine/descriptive/straight.h"
#include "engine/geometry/polyline.h"

namespace spineloft::descriptive {
namespace {

/// An outline has a corner where it turns by more, radians.
constexpr double kCorner = 0.2;
/// More is a curve (bowOf).
constexpr double kMostBow = 0.015;
/// Ends of stretches that are nearer are one corner, a share of the size.
constexpr double kOneCorner = 1e-6;

/// A straight stretch between two corners of an outline.
struct StraightStretch {
  std::uint32_t piece = 0, outline = 0;
  PicturePoint from, to;
  SectionPoint way() const { return {to.x - from.x, from.y - to.y}; }
};

std::vector<StraightStretch> stretchesOf(std::span<const Sheet> sheets, std::span<const Piece> pieces, double size) {
  std::vector<StraightStretch> out;
  std::uint32_t number = 0;
  for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
    if (pieces[piece].kind == PieceKind::Solid) continue;
    for (const OutlinePath& outline : sheets[piece].outlines) {
      MeasuredLine line{outline.points, {}, {}, true};
      line.points.push_back(line.points.front());
      geometry::arcLengths(std::span<const PicturePoint>(line.points), line.s);
      const std::vector<double> corners = cornersOf(line, size, kCorner);
      for (std::size_t i = 0; i < corners.size() && corners.size() > 1; ++i) {
        const double from = corners[i], to = i + 1 < corners.size() ? corners[i + 1] : corners[0] + 1;
        const StraightStretch one{piece, number, line.at(from), line.at(to > 1 ? to - 1 : to)};
        if (norm(one.way()) < kLeastStretch * size || bowOf(line, from, to) > kMostBow) continue;
        if (isStraight(line, from, to, size)) out.push_back(one);
      }
      ++number;
    }
  }
  return out;
}

/// Stretches of an outline along each of three axes, by outline.
std::vector<std::array<int, 3>> countsOf(const std::vector<StraightStretch>& all, const Directions& directions,
                                         const Axes& axes) {
  std::vector<std::array<int, 3>> counts(all.empty() ? 0 : all.back().outline + 1);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (const std::size_t axis = axes.of(directions.of[i]); axis != kNoAxis) ++counts[all[i].outline][axis];
  }
  return counts;
}

bool isParallelogram(const std::array<int, 3>& count) {
  return std::ranges::count(count, 0) == 1 && std::ranges::count_if(count, [](int n) { return n > 1; }) == 2;
}

bool hasAllAxes(const std::array<int, 3>& count) { return std::ranges::count(count, 0) == 0; }

/// Those of the longest stretches.
std::optional<Axes> axesOf(const std::vector<StraightStretch>& all, const Directions& directions) {
  return bestAxes(directions.all, [&](const Axes& axes) {
    const auto counts = countsOf(all, directions, axes);
    // What is drawn square is seen from the front, unless a parallelogram beside it goes back.
    const auto back = goingBack(axes, directions.all);
    const auto tells = [&](const auto& count) { return isParallelogram(count) && (!back || count[*back] > 0); };
    if (std::ranges::none_of(counts, tells)) return 0.0;
    double length = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
      const bool counted = axes.of(directions.of[i]) != kNoAxis && !hasAllAxes(counts[all[i].outline]);
      if (counted) length += norm(all[i].way());
    }
    return length;
  });
}

}  // namespace

RightAngles rightAnglesOf(std::span<const Sheet> sheets, std::span<const Piece> pieces, double size,
                          SeenFrom seenFrom) {
  if (seenFrom == SeenFrom::Unknown) return {};
  const std::vector<StraightStretch> all = stretchesOf(sheets, pieces, size);
  std::vector<SectionPoint> ways;
  for (const StraightStretch& one : all) ways.push_back(one.way());
  const Directions directions = directionsOf(ways, [&](std::size_t i, std::size_t k) {
    return all[i].outline == all[k].outline && (distance(all[i].to, all[k].from) < kOneCorner * size ||
                                                distance(all[k].to, all[i].from) < kOneCorner * size);
  });
  const std::optional<Axes> axes = axesOf(all, directions);
  RightAngles out;
  if (!axes) return out;
  const auto counts = countsOf(all, directions, *axes);
  const auto unitOf = [&](std::size_t axis) { return directions.all[axes->direction[axis]].unit; };
  std::size_t upright = 0;
  for (std::size_t axis = 1; axis < 3; ++axis) {
    if (unitOf(axis).y > unitOf(upright).y) upright = axis;
  }
  const double sign = (axes->slope[upright] < 0) == (seenFrom == SeenFrom::Above) ? -1 : 1;
  const SectionPoint up = axes->unit[upright];
  out.up = normalized(ModelPoint{up.x, up.y, sign * axes->slope[upright]});
  const StraightStretch* last = nullptr;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const StraightStretch& one = all[i];
    const std::size_t axis = axes->of(directions.of[i]);
    const auto& count = counts[one.outline];
    if (axis == kNoAxis || hasAllAxes(count)) continue;
    const auto add = [&](PicturePoint from, PicturePoint to) {
      const SectionPoint way{to.x - from.x, from.y - to.y};
      out.rises.push_back({one.piece, from, to, sign * axes->slope[axis] * dot(way, unitOf(axis))});
    };
    add(one.from, one.to);
    const bool isSameBar = last != nullptr && last->outline == one.outline && std::ranges::count(count, 0) == 2;
    if (isSameBar) add(lerp(last->from, last->to, 0.5), lerp(one.from, one.to, 0.5));
    last = &one;
  }
  return out;
}

}  // namespace spineloft::descriptive
