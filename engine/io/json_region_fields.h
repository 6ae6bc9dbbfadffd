// The members of what is made of regions, as JSON. Internal to json_fields.h, which it is a part of.
#pragma once

#include "engine/document/document.h"

namespace spineloft::io {

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
  auto& [height, sides, points, profile] = value;  // the profile stands beside them in the recipe
  v("height", height);
  v("sides", sides);
  v("points", points);
}
template <class V, Is<inflate::ProfileSlice> T>
void members(V& v, T& value) {
  auto& [shape] = value;
  v("shape", shape);
}
template <class V, Is<inflate::ProfileParams> T>
void members(V& v, T& value) {
  auto& [slices, follow] = value;
  v("slices", slices);
  v("follow", follow);
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
  auto& [region, inflate] = value;
  v("region", region);
  v("puff", inflate);
  v("profile", inflate.profile);
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

}  // namespace spineloft::io
