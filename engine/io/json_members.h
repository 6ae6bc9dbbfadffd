// The members of every struct of the document that is a JSON object, with their keys. Internal to io/.
//
// Each is taken apart by one structured binding that both directions share, so that a field added later does not
// compile until it is saved.
#pragma once

#include <concepts>
#include <type_traits>

#include "engine/document/document.h"

namespace spineloft::io {

/// `T` is `Plain` or `const Plain`.
template <class T, class Plain>
concept Is = std::same_as<std::remove_const_t<T>, Plain>;

template <class V, Is<ribs::SpineParams> T>
void members(V& v, T& value) {
  auto& [ribs, minSpacing, smoothness] = value;
  v("ribs", ribs);
  v("minSpacing", minSpacing);
  v("smoothness", smoothness);
}
template <class V, Is<ribs::EvidenceParams> T>
void members(V& v, T& value) {
  auto& [learnedWeight, proximityWeight, doubt, weight] = value;
  v("learnedWeight", learnedWeight);
  v("proximityWeight", proximityWeight);
  v("doubt", doubt);
  v("weight", weight);
  // What versions before 0.2 weighed; the network stands for it.
  for (const char* key : {"contrastWeight", "localContrastWeight", "beyondWeight", "insideWeight", "outsideWeight",
                          "rimWeight", "contrastReach", "knownShare"})
    v.retired(key);
}
template <class V, Is<ribs::FairingParams> T>
void members(V& v, T& value) {
  auto& [stiffness, leastTrust, corner, outlier] = value;
  v("stiffness", stiffness);
  v("leastTrust", leastTrust);
  v("corner", corner);
  v("outlier", outlier);
}
template <class V, Is<ribs::RibParams> T>
void members(V& v, T& value) {
  auto& [levels, maxLevelShare, neighbourWeight, neighbourFreedom, neighbourCap, oppositeWeight, medialOffsetCost,
         evidence, fairing] = value;
  v("levels", levels);
  v("maxLevelShare", maxLevelShare);
  v("neighbourWeight", neighbourWeight);
  v("neighbourFreedom", neighbourFreedom);
  v("neighbourCap", neighbourCap);
  v("oppositeWeight", oppositeWeight);
  v("leanCost", medialOffsetCost);
  v("evidence", evidence);
  v("fairing", fairing);
  v.retired("priorWeight");  // a pull to a middle level
}
template <class V, Is<ribs::RibEdits> T>
void members(V& v, T& value) {
  auto& [ends, added, removed, startFan, endFan] = value;
  v("ends", ends);
  v("added", added);
  v("removed", removed);
  v("startFan", startFan);
  v("endFan", endFan);
}
template <class V, Is<loft::Pose> T>
void members(V& v, T& value) {
  auto& [stroke, depth, coilTurns, coilRadius, closed] = value;
  v("stroke", stroke);
  v("depth", depth);
  v("coilTurns", coilTurns);
  v("coilRadius", coilRadius);
  v("closed", closed);
}
template <class V, Is<sections::SectionShape> T>
void members(V& v, T& value) {
  auto& [preset, contours] = value;
  v("preset", preset);
  v("contours", contours);
}
template <class V, Is<sections::Blend> T>
void members(V& v, T& value) {
  auto& [kind, custom] = value;
  v.always("kind", kind);  // what is usual depends on where it stands
  v("custom", custom);
}
template <class V, Is<loft::SectionKey> T>
void members(V& v, T& value) {
  auto& [at, shape, blend] = value;
  v("at", at);
  v("shape", shape);
  v("blend", blend);
}
template <class V, Is<loft::LoftParams> T>
void members(V& v, T& value) {
  auto& [sections, twist, squash, tilt, bulge, startCap, endCap, sectionPoints, capRings, centring] = value;
  v("sections", sections);
  v("twist", twist);
  v("squash", squash);
  v("tilt", tilt);
  v("bulge", bulge);
  v("startCap", startCap);
  v("endCap", endCap);
  v("sectionPoints", sectionPoints);
  v("capRings", capRings);
  v("centring", centring);
}
template <class V, Is<document::LoftRecipe> T>
void members(V& v, T& value) {
  auto& [picture, stroke, spine, ribs, edits, ignored, pose, loft, side] = value;
  v("picture", picture);
  v("stroke", stroke);
  v("spine", spine);
  v("ribs", ribs);
  v("edits", edits);
  v("ignored", ignored);
  v("pose", pose);
  v("loft", loft);
  v("side", side);
}
template <class V, Is<document::Region> T>
void members(V& v, T& value) {
  auto& [picture, contours, ribbon, open] = value;
  v("picture", picture);
  v("contours", contours);
  v("ribbon", ribbon);
  v("open", open);
}
template <class V, Is<inflate::InflateParams> T>
void members(V& v, T& value) {
  auto& [height, sides, points, profile, bones] = value;  // profile and bones stand beside them in the recipe
  v("height", height);
  v("sides", sides);
  v("points", points);
}
template <class V, Is<inflate::ProfileSlice> T>
void members(V& v, T& value) {
  auto& [shape, at] = value;
  v("shape", shape);
  v("at", at);
}
template <class V, Is<inflate::ProfileParams> T>
void members(V& v, T& value) {
  auto& [slices, follow, across, reach] = value;
  v("across", across);
  v("reach", reach);
  v("slices", slices);
  v("follow", follow);
}
template <class V, Is<inflate::BoneMove> T>
void members(V& v, T& value) {
  auto& [from, to] = value;
  v("from", from);
  v("to", to);
}
template <class V, Is<inflate::BoneHeight> T>
void members(V& v, T& value) {
  auto& [at, factor] = value;
  v("at", at);
  v("factor", factor);
}
template <class V, Is<inflate::BoneEdits> T>
void members(V& v, T& value) {
  auto& [detail, drop, add, move, heights] = value;
  v("detail", detail);
  v("drop", drop);
  v("add", add);
  v("move", move);
  v("heights", heights);
}
template <class V, Is<extrude::ExtrudeParams> T>
void members(V& v, T& value) {
  auto& [thickness, edge, edgeSize, depth] = value;
  v("thickness", thickness);
  v("edge", edge);
  v("edgeSize", edgeSize);
  v("depth", depth);
}
template <class V, Is<document::InflateRecipe> T>
void members(V& v, T& value) {
  auto& [region, inflate, side] = value;
  v("region", region);
  v("puff", inflate);
  v("profile", inflate.profile);
  v("bones", inflate.bones);
  v("side", side);
}
template <class V, Is<document::ExtrudeRecipe> T>
void members(V& v, T& value) {
  auto& [region, extrude] = value;
  v("region", region);
  v("sheet", extrude);
}
template <class V, Is<lathe::LatheParams> T>
void members(V& v, T& value) {
  auto& [axisFrom, axisTo, turn, sides, wall, squash] = value;
  v("axisFrom", axisFrom);
  v("axisTo", axisTo);
  v("turn", turn);
  v("sides", sides);
  v("wall", wall);
  v("squash", squash);
}
template <class V, Is<document::LatheRecipe> T>
void members(V& v, T& value) {
  auto& [region, lathe] = value;
  v("region", region);
  v("lathe", lathe);
}
template <class V, Is<stack::Curve> T>
void members(V& v, T& value) {
  auto& [through, corners, open, as, width, base, forkAt, joinAt] = value;
  v("through", through);
  v("corners", corners);
  v("open", open);
  v("as", as);
  v("width", width);
  v("base", base);
  v("forkAt", forkAt);
  v("joinAt", joinAt);
}
template <class V, Is<stack::CurveLink> T>
void members(V& v, T& value) {
  auto& [from, to, on] = value;
  v("from", from);
  v("to", to);
  v("on", on);
}
template <class V, Is<stack::Plane> T>
void members(V& v, T& value) {
  auto& [at, origin, turn, curves, blend, links] = value;
  v("at", at);
  v("origin", origin);
  v("turn", turn);
  v("curves", curves);
  v("blend", blend);
  v("links", links);
}
template <class V, Is<stack::Rail> T>
void members(V& v, T& value) {
  auto& [points, closed] = value;
  v("points", points);
  v("closed", closed);
}
template <class V, Is<stack::Pattern> T>
void members(V& v, T& value) {
  auto& [first, last, times, spacing] = value;
  v("first", first);
  v("last", last);
  v("times", times);
  v("spacing", spacing);
}
template <class V, Is<stack::Rough> T>
void members(V& v, T& value) {
  auto& [amount, size, seed, keepDrawn] = value;
  v("amount", amount);
  v("size", size);
  v("seed", seed);
  v("keepDrawn", keepDrawn);
}
template <class V, Is<stack::StackParams> T>
void members(V& v, T& value) {
  auto& [startCap, endCap, sides, capRings, patterns, rough, melt] = value;
  v("startCap", startCap);
  v("endCap", endCap);
  v("sides", sides);
  v("capRings", capRings);
  v("patterns", patterns);
  v("rough", rough);
  v("melt", melt);
}
template <class V, Is<document::StackRecipe> T>
void members(V& v, T& value) {
  auto& [picture, planes, rail, stack] = value;
  v("picture", picture);
  v("planes", planes);
  v("rail", rail);
  v("stack", stack);
}
template <class V, Is<shape::Depth> T>
void members(V& v, T& value) {
  auto& [mode, ratio] = value;
  v("mode", mode);
  v("ratio", ratio);
}
template <class V, Is<shape::Caps> T>
void members(V& v, T& value) {
  auto& [start, end] = value;
  v("start", start);
  v("end", end);
}
template <class V, Is<document::Outline> T>
void members(V& v, T& value) {
  auto& [picture, lines] = value;
  v("picture", picture);
  v("lines", lines);
}
template <class V, Is<document::ShapeRecipe> T>
void members(V& v, T& value) {
  auto& [picture, shape, outlines] = value;
  auto& [primitive, axis, width, depth, section, caps, levels, sides, capRings] = shape;
  v("picture", picture);
  v("primitive", primitive);
  v("axis", axis);
  v("width", width);
  v("depth", depth);
  v("section", section);
  v("caps", caps);
  v("levels", levels);
  v("sides", sides);
  v("capRings", capRings);
  v("outlines", outlines);
}
template <class V, Is<document::DrawnLine> T>
void members(V& v, T& value) {
  auto& [id, points, hidden, closed] = value;
  v("id", id);
  v("points", points);
  v("hidden", hidden);
  v("closed", closed);
}
template <class V, Is<document::LineRun> T>
void members(V& v, T& value) {
  auto& [line, from, to] = value;
  v("line", line);
  v("from", from);
  v("to", to);
}
template <class V, Is<document::LineOutline> T>
void members(V& v, T& value) {
  auto& [runs] = value;
  v("runs", runs);
}
template <class V, Is<document::DepthPin> T>
void members(V& v, T& value) {
  auto& [line, at, z] = value;
  v("line", line);
  v("at", at);
  v("z", z);
}
template <class V, Is<document::LineFold> T>
void members(V& v, T& value) {
  auto& [line, at] = value;
  v("line", line);
  v("at", at);
}
template <class V, Is<document::PieceOrder> T>
void members(V& v, T& value) {
  auto& [over, under, at] = value;
  v("over", over);
  v("under", under);
  v("at", at);
}
template <class V, Is<document::Drawing> T>
void members(V& v, T& value) {
  auto& [id, picture, lines, pins, folds, orders, seenFrom, lastLineId, extra] = value;
  v("id", id);
  v("picture", picture);
  v("lines", lines);
  v("pins", pins);
  v("folds", folds);
  v("orders", orders);
  v("seenFrom", seenFrom);
  v("lastLineId", lastLineId);
  v.beyond(extra);
}
template <class V, Is<document::ElementRecipe> T>
void members(V& v, T& value) {
  auto& [picture, drawing, kind, outlines, stiffness, front, back, thickness] = value;
  v("picture", picture);
  v("drawing", drawing);
  v("kind", kind);
  v("outlines", outlines);
  v("stiffness", stiffness);
  v("front", front);
  v("back", back);
  v("thickness", thickness);
}
template <class V, Is<document::BridgeEnd> T>
void members(V& v, T& value) {
  auto& [part, rim] = value;
  v("part", part);
  v("rim", rim);
}
template <class V, Is<document::BridgeRecipe> T>
void members(V& v, T& value) {
  auto& [picture, from, to, bridge] = value;
  auto& [waist, bow] = bridge;
  v("picture", picture);
  v("from", from);
  v("to", to);
  v("waist", waist);
  v("bow", bow);
}
template <class V, Is<document::PictureView> T>
void members(V& v, T& value) {
  auto& [of, view] = value;
  auto& [from, middle, scale, shift] = view;
  v("of", of);
  v("from", from);
  v("middle", middle);
  v("scale", scale);
  v("shift", shift);
}
template <class V, Is<document::Look> T>
void members(V& v, T& value) {
  auto& [textured, colour, paint, second, faceted, inked] = value;
  v("textured", textured);
  v("colour", colour);
  v("paint", paint);
  v("second", second);
  v("faceted", faceted);
  v("inked", inked);
}
template <class V, Is<document::Placement> T>
void members(V& v, T& value) {
  auto& [pivot, move, turn, scale, mirrored] = value;
  v("pivot", pivot);
  v("move", move);
  v("turn", turn);
  v("scale", scale);
  v("mirrored", mirrored);
}
template <class V, Is<document::Group> T>
void members(V& v, T& value) {
  auto& [id, name] = value;
  v("id", id);
  v.always("name", name);
}
template <class V, Is<pull::Pull> T>
void members(V& v, T& value) {
  auto& [line, height, to, radius, crease, ring, across, acrossTo] = value;
  v("line", line);
  v("height", height);
  v("to", to);
  v("radius", radius);
  v("crease", crease);
  v("ring", ring);
  v("across", across);
  v("acrossTo", acrossTo);
}
template <class V, Is<relief::Laid> T>
void members(V& v, T& value) {
  auto& [picture, at, width, turn] = value;
  v("picture", picture);
  v("at", at);
  v("width", width);
  v("turn", turn);
}
template <class V, Is<relief::Relief> T>
void members(V& v, T& value) {
  auto& [mode, height, smooth, region, laid] = value;
  v("mode", mode);
  v("height", height);
  v("smooth", smooth);
  v("region", region);
  v("laid", laid);
}
template <class V, Is<document::Part> T>
void members(V& v, T& value) {
  auto& [id, name, recipe, look, visible, placement, mirror, group, pulls, relief, extra] = value;
  v("id", id);
  v.always("name", name);
  v.recipe("kind", "recipe", recipe);
  v("look", look);
  v("visible", visible);
  v("placement", placement);
  v("mirror", mirror);
  v("group", group);
  v("pulls", pulls);
  v("relief", relief);
  v.beyond(extra);
}
template <class V, Is<document::Operand> T>
void members(V& v, T& value) {
  auto& [part, step] = value;
  v("part", part);
  v("step", step);
}
template <class V, Is<document::Opening> T>
void members(V& v, T& value) {
  auto& [side, depth] = value;
  v("side", side);
  v("depth", depth);
}
template <class V, Is<document::Step> T>
void members(V& v, T& value) {
  auto& [id, name, kind, operands, blend, wall, opening, ownLook, look, visible, extra] = value;
  v("id", id);
  v.always("name", name);
  v("kind", kind);
  v("operands", operands);
  v("blend", blend);
  v("wall", wall);
  v("opening", opening);
  v("ownLook", ownLook);
  v("look", look);
  v("visible", visible);
  v.beyond(extra);
}
template <class V, Is<document::PictureEntry> T>
void members(V& v, T& value) {
  auto& [id, name, size, picture, sketch, contentHash, ignored, view, extra] = value;
  v("id", id);
  v.always("name", name);
  v("size", size);
  v.photo("photo", picture, contentHash);
  v("sketch", sketch);
  v("ignored", ignored);
  v("view", view);
  v.beyond(extra);
}
template <class V, Is<document::Document> T>
void members(V& v, T& value) {
  auto& [name, pictures, drawings, parts, steps, groups, height, lastPictureId, lastPartId, lastStepId, lastGroupId,
         lastDrawingId, extra] = value;
  v.always("name", name);
  v.elements("pictures", pictures);
  v.elementsIfAny("drawings", drawings);
  v.elements("parts", parts);
  v.elementsIfAny("steps", steps);
  v("groups", groups);
  v("height", height);
  v("lastPictureId", lastPictureId);
  v("lastPartId", lastPartId);
  v("lastStepId", lastStepId);
  v("lastGroupId", lastGroupId);
  v("lastDrawingId", lastDrawingId);
  v.beyond(extra);
}

}  // namespace spineloft::io
