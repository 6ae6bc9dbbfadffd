#include "engine/pipeline/keys.h"

#include <vector>

#include "engine/base/hash.h"

namespace spineloft::pipeline {
namespace {

/// Mixes the members of a parameter struct. Each is taken apart by a structured binding, so that a
/// member added later does not compile until it is part of the key.
template <class... Members>
void mixAll(Hasher& hasher, const Members&... members) {
  (hasher.number(members), ...);
}
void mix(Hasher& hasher, const ribs::SpineParams& params) {
  const auto& [ribs, minSpacing, smoothness] = params;
  mixAll(hasher, ribs, minSpacing, smoothness);
}
void mix(Hasher& hasher, const ribs::EvidenceParams& params) {
  const auto& [learnedWeight, proximityWeight, doubt, weight] = params;
  mixAll(hasher, learnedWeight, proximityWeight, doubt, weight);
}
void mix(Hasher& hasher, const ribs::FairingParams& params) {
  const auto& [stiffness, leastTrust, corner, outlier] = params;
  mixAll(hasher, stiffness, leastTrust, corner, outlier);
}
void mix(Hasher& hasher, const ribs::RibParams& params) {
  const auto& [levels, maxLevelShare, neighbourWeight, neighbourFreedom, neighbourCap, oppositeWeight, medialOffsetCost,
               evidence, fairing] = params;
  mixAll(hasher, levels, maxLevelShare, neighbourWeight, neighbourFreedom, neighbourCap, oppositeWeight,
         medialOffsetCost);
  mix(hasher, evidence);
  mix(hasher, fairing);
}
template <class Point>
void mix(Hasher& hasher, const std::vector<Point>& points) {
  hasher.number(points.size());
  for (const Point& p : points) hasher.number(p.x).number(p.y);
}
void mix(Hasher& hasher, const geometry::AlongCurve& curve) {
  hasher.number(curve.points.size());
  for (const auto& [at, value] : curve.points) mixAll(hasher, at, value);
}
void mix(Hasher& hasher, const sections::SectionShape& shape) {
  const auto& [preset, contours] = shape;
  hasher.number(preset).number(contours.size());
  for (const auto& contour : contours) mix(hasher, contour);
}
void mix(Hasher& hasher, const loft::SectionKey& key) {
  const auto& [at, shape, blend] = key;
  const auto& [kind, custom] = blend;
  mixAll(hasher, at, kind);
  mix(hasher, shape);
  mix(hasher, custom);
}
void mix(Hasher& hasher, const loft::LoftParams& params) {
  const auto& [sections, twist, squash, tilt, bulge, startCap, endCap, sectionPoints, capRings, centring] = params;
  hasher.number(sections.size());
  for (const loft::SectionKey& key : sections) mix(hasher, key);
  for (const auto* curve : {&twist, &squash, &tilt, &bulge}) mix(hasher, *curve);
  mixAll(hasher, startCap, endCap, sectionPoints, capRings, centring);
}
void mix(Hasher& hasher, const ribs::RibEdits& edits) {
  const auto& [ends, added, removed] = edits;
  hasher.number(ends.size()).number(added.size()).number(removed.size());
  for (const ribs::EndEdit& end : ends) {
    const auto& [at, side, along, out, reach, locked] = end;
    mixAll(hasher, at, side, along, out, reach, locked);
  }
  for (const double at : added) hasher.number(at);
  for (const double at : removed) hasher.number(at);
}
void mix(Hasher& hasher, const std::vector<ribs::IgnoreMark>& marks) {
  hasher.number(marks.size());
  for (const ribs::IgnoreMark& mark : marks) {
    const auto& [stroke, radius, covers] = mark;
    mix(hasher, stroke);
    hasher.number(radius).number(covers);
  }
}
void mix(Hasher& hasher, const loft::Pose& pose) {
  const auto& [stroke, depth, coilTurns, coilRadius, closed] = pose;
  mix(hasher, stroke);
  mix(hasher, depth);
  mixAll(hasher, coilTurns, coilRadius, closed);
}

void mix(Hasher& hasher, const inflate::ProfileParams& params) {
  const auto& [slices, follow] = params;
  hasher.number(slices.size());
  for (const auto& [shape] : slices) mix(hasher, shape);
  hasher.number(follow);
}

/// A region's solid takes only its size from the picture, its texture the pixels.
std::uint64_t regionKey(const document::Region& region, const document::PictureEntry& entry) {
  const auto& [picture, contours, ribbon, open] = region;
  Hasher hasher;
  hasher.number(entry.contentHash).number(entry.size.width).number(entry.size.height);
  hasher.number(contours.size());
  for (const auto& contour : contours) mix(hasher, contour);
  hasher.number(ribbon).number(open);
  for (const ribs::IgnoreMark& mark : entry.ignored) {
    if (mark.covers) mix(hasher, std::vector{mark});
  }
  return hasher.value();
}

}  // namespace

std::uint64_t ignoredKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry) {
  Hasher hasher;
  hasher.number(entry.contentHash);
  mix(hasher, entry.ignored);
  mix(hasher, recipe.ignored);
  return hasher.value();
}

std::uint64_t traceKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry) {
  // The picture's id is left out: equal content hashes, equal pixels.
  const auto& [picture, stroke, spine, ribs, edits, ignored, pose, loft] = recipe;
  Hasher hasher;
  hasher.number(ignoredKey(recipe, entry));
  mix(hasher, stroke);
  mix(hasher, spine);
  mix(hasher, ribs);
  return hasher.value();
}

std::uint64_t shapeKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [picture, stroke, spine, ribs, edits, ignored, pose, loft] = recipe;
  Hasher hasher;
  hasher.number(traceKey(recipe, entry));
  mix(hasher, edits);
  mix(hasher, pose);
  mix(hasher, loft);
  return hasher.value();
}

std::uint64_t shapeKey(const document::InflateRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [region, inflate] = recipe;
  const auto& [height, sides, points, profile] = inflate;
  Hasher hasher;
  hasher.text("puff").number(regionKey(region, entry));
  mixAll(hasher, height, sides, points);
  mix(hasher, profile);
  return hasher.value();
}

std::uint64_t shapeKey(const document::ExtrudeRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [region, params] = recipe;
  const auto& [thickness, edge, edgeSize, depth] = params;
  Hasher hasher;
  hasher.text("sheet").number(regionKey(region, entry));
  mixAll(hasher, thickness, edge, edgeSize, depth);
  return hasher.value();
}

std::uint64_t shapeKey(const document::LatheRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [region, params] = recipe;
  const auto& [axisFrom, axisTo, turn, sides, wall, squash] = params;
  Hasher hasher;
  hasher.text("lathe").number(regionKey(region, entry));
  mixAll(hasher, axisFrom.x, axisFrom.y, axisTo.x, axisTo.y, turn, sides, wall, squash);
  return hasher.value();
}

std::uint64_t shapeKey(const document::Recipe& recipe, const document::PictureEntry& entry) {
  return std::visit([&](const auto& one) { return shapeKey(one, entry); }, recipe);
}

std::uint64_t shapeKey(const document::Part& part, const document::PictureEntry& entry) {
  // How the texture is shown is no part of it.
  const auto& [textured, colour, paint, second, faceted, inked] = part.look;
  const std::uint64_t key = shapeKey(part.recipe, entry);
  return inked && entry.isSketch() ? Hasher().text("inked").number(key).value() : key;
}

}  // namespace spineloft::pipeline
