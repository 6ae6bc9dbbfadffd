#include "engine/pipeline/keys.h"

#include <optional>
#include <vector>

#include "engine/base/hash.h"
#include "engine/inflate/interior.h"
#include "engine/pipeline/bridge_shape.h"
#include "engine/pipeline/drawing_shape.h"
#include "engine/pipeline/relief_shape.h"

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
void mix(Hasher& hasher, const sections::Blend& blend) {
  const auto& [kind, custom] = blend;
  hasher.number(kind);
  mix(hasher, custom);
}
void mix(Hasher& hasher, const sections::SectionShape& shape) {
  const auto& [preset, contours] = shape;
  hasher.number(preset).number(contours.size());
  for (const auto& contour : contours) mix(hasher, contour);
}
void mix(Hasher& hasher, const loft::SectionKey& key) {
  const auto& [at, shape, blend] = key;
  hasher.number(at);
  mix(hasher, shape);
  mix(hasher, blend);
}
void mix(Hasher& hasher, const ModelPoint& p) { mixAll(hasher, p.x, p.y, p.z); }
void mix(Hasher& hasher, const std::vector<ModelPoint>& points) {
  hasher.number(points.size());
  for (const ModelPoint& p : points) mix(hasher, p);
}
void mix(Hasher& hasher, const stack::Curve& curve) {
  const auto& [through, corners, open, as, width, base, forkAt, joinAt] = curve;
  const auto& [all, at] = corners;
  mix(hasher, through);
  mixAll(hasher, open, as, width, base, forkAt.has_value(), forkAt.value_or(0), joinAt.has_value(), joinAt.value_or(0));
  mixAll(hasher, all, at.size());
  for (const std::uint32_t i : at) hasher.number(i);
}
void mix(Hasher& hasher, const stack::Plane& plane) {
  const auto& [at, origin, turn, curves, blend, links] = plane;
  mixAll(hasher, at, origin.has_value());
  if (origin) mix(hasher, *origin);
  mixAll(hasher, turn.w, turn.x, turn.y, turn.z, curves.size());
  for (const stack::Curve& curve : curves) mix(hasher, curve);
  mix(hasher, blend);
  hasher.number(links.size());
  for (const stack::CurveLink& link : links) mixAll(hasher, link.from, link.to, link.on);
}
void mix(Hasher& hasher, const stack::Rail& rail) {
  const auto& [points, closed] = rail;
  mixAll(hasher, points.size(), closed);
  for (const ModelPoint& p : points) mix(hasher, p);
}
void mix(Hasher& hasher, const loft::LoftParams& params) {
  const auto& [sections, twist, squash, tilt, bulge, startCap, endCap, sectionPoints, capRings, centring] = params;
  hasher.number(sections.size());
  for (const loft::SectionKey& key : sections) mix(hasher, key);
  for (const auto* curve : {&twist, &squash, &tilt, &bulge}) mix(hasher, *curve);
  mixAll(hasher, startCap, endCap, sectionPoints, capRings, centring);
}
void mix(Hasher& hasher, const ribs::RibEdits& edits) {
  const auto& [ends, added, removed, startFan, endFan] = edits;
  for (const std::size_t size : {ends.size(), added.size(), removed.size(), startFan.size(), endFan.size()})
    hasher.number(size);
  for (const ribs::EndEdit& end : ends) {
    const auto& [at, side, along, out, reach, locked] = end;
    mixAll(hasher, at, side, along, out, reach, locked);
  }
  for (const double at : added) hasher.number(at);
  for (const double at : removed) hasher.number(at);
  for (const auto* fan : {&startFan, &endFan}) {
    for (const ribs::RibPoint p : *fan) hasher.number(p.x).number(p.y);
  }
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

/// Scribbles under which another thing is: its colours are not on the part.
std::vector<ribs::IgnoreMark> coversOf(const document::PictureEntry& entry) {
  std::vector<ribs::IgnoreMark> covers;
  for (const ribs::IgnoreMark& mark : entry.ignored) {
    if (mark.covers) covers.push_back(mark);
  }
  return covers;
}

void mixPlace(Hasher& hasher, const std::optional<PicturePoint>& at) {
  hasher.number(at.has_value());
  if (at) mixAll(hasher, at->x, at->y);
}

void mix(Hasher& hasher, const inflate::ProfileParams& params) {
  const auto& [slices, follow, across, reach] = params;
  hasher.number(slices.size());
  for (const auto& [shape, at] : slices) {
    mix(hasher, shape);
    mixPlace(hasher, at);
  }
  hasher.number(follow).number(across);
  if (across == inflate::Across::Length) hasher.number(reach);
}

void mix(Hasher& hasher, const inflate::BoneEdits& edits) {
  const auto& [detail, drop, add, move, heights] = edits;
  hasher.number(detail);
  mix(hasher, drop);
  hasher.number(add.size());
  for (const auto& line : add) mix(hasher, line);
  hasher.number(move.size());
  for (const auto& [from, to] : move) mix(hasher, std::vector{from, to});
  hasher.number(heights.size());
  for (const auto& [at, factor] : heights) {
    mix(hasher, std::vector{at});
    hasher.number(factor);
  }
}

void mix(Hasher& hasher, const document::Region& region) {
  const auto& [picture, contours, ribbon, open] = region;
  hasher.number(contours.size());
  for (const auto& contour : contours) mix(hasher, contour);
  hasher.number(ribbon).number(open);
}

void mix(Hasher& hasher, const descriptive::Line& line) {
  const auto& [points, hidden, closed] = line;
  mix(hasher, points);
  hasher.number(hidden.size()).number(closed);
  for (const auto& [from, to] : hidden) mixAll(hasher, from, to);
}
void mix(Hasher& hasher, const descriptive::Piece& piece) {
  const auto& [name, kind, outlines, stiffness, front, back, thickness] = piece;
  mixAll(hasher, kind, stiffness, front, back, thickness, outlines.size());
  for (const descriptive::Outline& outline : outlines) {
    hasher.number(outline.size());
    for (const auto& [line, from, to] : outline) mixAll(hasher, line, from, to);
  }
}
void mix(Hasher& hasher, const descriptive::Place& place) {
  const auto& [line, share] = place;
  mixAll(hasher, line, share);
}

/// An outline and the view that its picture has of `front`.
void mix(Hasher& hasher, const document::Outline& outline, PictureId front, const document::Document& document) {
  const auto& [seenIn, lines] = outline;
  const auto view = viewOn(document, seenIn, front);
  mixAll(hasher, view.ok(), view.ok() && view.value(), lines.size());
  if (view.ok() && view.value()) {
    const auto& [from, middle, scale, shift] = *view.value();
    mixAll(hasher, from, middle, scale, shift);
  }
  for (const auto& line : lines) mix(hasher, line);
}

/// A region's solid takes only its size from the picture, its texture the pixels.
std::uint64_t regionKey(const document::Region& region, const document::PictureEntry& entry) {
  Hasher hasher;
  hasher.number(entry.contentHash).number(entry.size.width).number(entry.size.height);
  mix(hasher, region);
  for (const ribs::IgnoreMark& mark : entry.ignored) {
    if (mark.covers) mix(hasher, std::vector{mark});
  }
  return hasher.value();
}

}  // namespace

IgnoredKey ignoredKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry) {
  Hasher hasher;
  hasher.number(entry.contentHash);
  mix(hasher, entry.ignored);
  mix(hasher, recipe.ignored);
  return IgnoredKey{hasher.value()};
}

TraceKey traceKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry) {
  // The picture's id is left out: equal content hashes, equal pixels. The side is, too: see the key of any recipe.
  const auto& [picture, stroke, spine, ribs, edits, ignored, pose, loft, side] = recipe;
  Hasher hasher;
  hasher.number(ignoredKey(recipe, entry).hash);
  mix(hasher, stroke);
  mix(hasher, spine);
  mix(hasher, ribs);
  return TraceKey{hasher.value()};
}

TextureKey textureKey(ShapeKey shape, const std::vector<ribs::IgnoreMark>& ink) {
  Hasher hasher;
  hasher.text("texture").number(shape.hash);
  mix(hasher, ink);
  return TextureKey{hasher.value()};
}

ShapeKey shapeKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [picture, stroke, spine, ribs, edits, ignored, pose, loft, side] = recipe;
  Hasher hasher;
  hasher.number(traceKey(recipe, entry).hash);
  mix(hasher, edits);
  mix(hasher, pose);
  mix(hasher, loft);
  return ShapeKey{hasher.value()};
}

ShapeKey shapeKey(const document::InflateRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [region, inflate, side] = recipe;
  const auto& [height, sides, points, profile, bones] = inflate;
  Hasher hasher;
  hasher.text("puff").number(regionKey(region, entry));
  mixAll(hasher, height, sides, points);
  mix(hasher, profile);
  mix(hasher, bones);
  return ShapeKey{hasher.value()};
}

InteriorKey interiorKey(const document::InflateRecipe& recipe, const document::PictureEntry& entry) {
  Hasher hasher;
  hasher.text("interior").number(entry.size.width).number(entry.size.height);
  const auto& [region, inflate, side] = recipe;
  const auto& [height, sides, points, profile, bones] = inflate;
  mix(hasher, region);
  mix(hasher, bones);
  hasher.number(inflate::finenessFor(points));
  for (const auto& [shape, at] : profile.slices) mixPlace(hasher, at);
  return InteriorKey{hasher.value()};
}

ShapeKey shapeKey(const document::ExtrudeRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [region, params] = recipe;
  const auto& [thickness, edge, edgeSize, depth] = params;
  Hasher hasher;
  hasher.text("sheet").number(regionKey(region, entry));
  mixAll(hasher, thickness, edge, edgeSize, depth);
  return ShapeKey{hasher.value()};
}

ShapeKey shapeKey(const document::LatheRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [region, params] = recipe;
  const auto& [axisFrom, axisTo, turn, sides, wall, squash] = params;
  Hasher hasher;
  hasher.text("lathe").number(regionKey(region, entry));
  mixAll(hasher, axisFrom.x, axisFrom.y, axisTo.x, axisTo.y, turn, sides, wall, squash);
  return ShapeKey{hasher.value()};
}

ShapeKey shapeKey(const document::StackRecipe& recipe, const document::PictureEntry& entry) {
  const auto& [picture, planes, rail, stack] = recipe;
  const auto& [startCap, endCap, sides, capRings, patterns, rough, melt] = stack;
  const auto& [amount, size, seed, keepDrawn] = rough;
  Hasher hasher;
  hasher.text("stack").number(entry.contentHash).number(entry.size.width).number(entry.size.height);
  mix(hasher, coversOf(entry));
  hasher.number(planes.size());
  for (const stack::Plane& plane : planes) mix(hasher, plane);
  mix(hasher, rail);
  mixAll(hasher, startCap, endCap, sides, capRings, amount, size, seed, keepDrawn, melt, patterns.size());
  for (const auto& [first, last, times, spacing] : patterns) mixAll(hasher, first, last, times, spacing);
  return ShapeKey{hasher.value()};
}

ShapeKey shapeKey(const document::ShapeRecipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document) {
  const auto& [picture, shape, outlines] = recipe;
  const auto& [primitive, axis, width, depth, section, caps, levels, sides, capRings] = shape;
  Hasher hasher;
  hasher.text("shape").number(entry.contentHash).number(entry.size.width).number(entry.size.height);
  mix(hasher, coversOf(entry));
  mixAll(hasher, primitive, axis.from.x, axis.from.y, axis.to.x, axis.to.y, width, depth.mode, depth.ratio);
  hasher.number(section.has_value());
  if (section) mix(hasher, *section);
  mixAll(hasher, caps.start, caps.end, levels, sides, capRings, outlines.size());
  for (const document::Outline& outline : outlines) mix(hasher, outline, picture, document);
  return ShapeKey{hasher.value()};
}

DrawingKey drawingKey(const descriptive::Drawing& drawing) {
  const auto& [size, lines, pieces, pins, folds, orders, seenFrom] = drawing;
  Hasher hasher;
  hasher.text("drawing").number(size.width).number(size.height);
  mixAll(hasher, lines.size(), pieces.size(), pins.size(), folds.size(), orders.size(), seenFrom);
  for (const descriptive::Line& line : lines) mix(hasher, line);
  for (const descriptive::Piece& piece : pieces) mix(hasher, piece);
  for (const auto& [at, z] : pins) {
    mix(hasher, at);
    hasher.number(z);
  }
  for (const descriptive::Place& fold : folds) mix(hasher, fold);
  for (const auto& [over, under, at] : orders) mixAll(hasher, over, under, at.x, at.y);
  return DrawingKey{hasher.value()};
}

ShapeKey shapeKey(const document::ElementRecipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document, PartId part) {
  const PieceIn piece = pieceIn(document, recipe, part);
  Hasher hasher;
  hasher.text("element").number(entry.contentHash).number(drawingKey(piece.drawing).hash).number(piece.number);
  mix(hasher, coversOf(entry));
  return ShapeKey{hasher.value()};
}

namespace {

void mix(Hasher& hasher, const document::BridgeEnd& end, const document::Document& document) {
  const auto& [part, rim] = end;
  mix(hasher, rim);
  const document::Part* host = hostOf(document, end);
  hasher.number(host != nullptr);
  if (host == nullptr) return;
  const document::PictureEntry& entry = *findPicture(document, pictureOf(*host));
  const auto& [pivot, move, turn, scale, mirrored] = host->placement;
  hasher.number(smoothKey(*host, entry, document).hash).number(entry.size.width).number(entry.size.height);
  mixAll(hasher, pivot.x, pivot.y, pivot.z, move.x, move.y, move.z, turn.w, turn.x, turn.y, turn.z, scale, mirrored);
}

}  // namespace

ShapeKey shapeKey(const document::BridgeRecipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document) {
  const auto& [picture, from, to, bridge] = recipe;
  const auto& [waist, bow] = bridge;
  Hasher hasher;
  hasher.text("bridge").number(entry.contentHash).number(entry.size.width).number(entry.size.height);
  mix(hasher, coversOf(entry));
  mix(hasher, from, document);
  mix(hasher, to, document);
  mixAll(hasher, waist, bow);
  return ShapeKey{hasher.value()};
}

ShapeKey shapeKey(const document::Recipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document) {
  const ShapeKey plain = std::visit(
      [&](const auto& one) {
        if constexpr (requires { shapeKey(one, entry); }) {
          return shapeKey(one, entry);
        } else {
          return shapeKey(one, entry, document);
        }
      },
      recipe);
  const std::optional<document::Outline>* side = document::sideOf(recipe);
  if (side == nullptr || !*side) return plain;
  Hasher hasher;
  hasher.text("side").number(plain.hash);
  mix(hasher, **side, document::pictureOf(recipe), document);
  return ShapeKey{hasher.value()};
}

ShapeKey unpulledKey(const document::Recipe& recipe, const document::PictureEntry& entry,
                     const document::Document& document, PartId part) {
  const auto* element = std::get_if<document::ElementRecipe>(&recipe);
  return element ? shapeKey(*element, entry, document, part) : shapeKey(recipe, entry, document);
}

ReachKey reachKey(ShapeKey before, const pull::Pull& pull) {
  const auto& [line, height, to, radius, crease, ring, across, acrossTo] = pull;
  Hasher hasher;
  hasher.text("reach").number(before.hash);
  for (const auto* places : {&line, &to, &ring, &across, &acrossTo}) mix(hasher, *places);
  mixAll(hasher, radius, crease);
  return ReachKey{hasher.value()};
}

ShapeKey pulledKey(ShapeKey before, const pull::Pull& pull, double share) {
  const std::uint64_t whole = Hasher().text("pull").number(reachKey(before, pull).hash).number(pull.height).value();
  return ShapeKey{share == 1 ? whole : Hasher().text("share").number(whole).number(share).value()};
}

HeightsKey heightsKey(ShapeKey before, const relief::Relief& relief, const document::PictureEntry& entry) {
  // How smooth and how high it is comes after.
  const auto& [mode, height, smooth, region, laid] = relief;
  Hasher hasher;
  hasher.text("heights").number(before.hash).number(entry.contentHash).number(mode).number(region.size());
  for (const auto& line : region) mix(hasher, line);
  hasher.number(laid.has_value());
  if (laid) mixAll(hasher, laid->at.x, laid->at.y, laid->width, laid->turn);
  return HeightsKey{hasher.value()};
}

RaisedKey raisedKey(HeightsKey heights, const relief::Relief& relief) {
  return RaisedKey{Hasher().text("raised").number(heights.hash).number(relief.smooth).value()};
}

ShapeKey reliefKey(RaisedKey raised, const relief::Relief& relief) {
  return ShapeKey{Hasher().text("relief").number(raised.hash).number(relief.height).value()};
}

ShapeKey smoothKey(const document::Part& part, const document::PictureEntry& entry,
                   const document::Document& document) {
  // How the texture is shown is no part of it.
  const auto& [textured, colour, paint, second, faceted, inked] = part.look;
  ShapeKey key = unpulledKey(part.recipe, entry, document, part.id);
  for (const pull::Pull& pull : part.pulls) key = pulledKey(key, pull);
  return inked && entry.isSketch() ? ShapeKey{Hasher().text("inked").number(key.hash).value()} : key;
}

ShapeKey shapeKey(const document::Part& part, const document::PictureEntry& entry, const document::Document& document) {
  const ShapeKey smooth = smoothKey(part, entry, document);
  const document::PictureEntry* from = part.relief ? reliefPicture(document, *part.relief, entry) : nullptr;
  if (from == nullptr) return smooth;
  return reliefKey(raisedKey(heightsKey(smooth, *part.relief, *from), *part.relief), *part.relief);
}

}  // namespace spineloft::pipeline
