// The page's own space, and rectangles in it.
#pragma once

#include <algorithm>

#include "engine/base/vec.h"

namespace spineloft::app {

/// CSS pixels from the canvas' top left corner, y down. ImGui's units are the same.
struct ClientSpace;
using ClientPoint = Vec2<ClientSpace>;

struct Rect {
  double x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Rect&) const = default;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
  ClientPoint centre() const { return {x + width / 2, y + height / 2}; }
  bool contains(ClientPoint p) const { return p.x >= x && p.y >= y && p.x < right() && p.y < bottom(); }
  bool meets(const Rect& other) const {
    return x < other.right() && other.x < right() && y < other.bottom() && other.y < bottom();
  }
  Rect inset(double margin) const {
    return {x + margin, y + margin, std::max(0.0, width - 2 * margin), std::max(0.0, height - 2 * margin)};
  }
};

}  // namespace spineloft::app
