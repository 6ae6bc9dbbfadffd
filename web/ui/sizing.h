// How tall a model is, in words, and beside things whose size everybody knows.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "engine/pipeline/world.h"
#include "web/model/spoken_length.h"
#include "web/ui/views.h"

namespace spineloft::app {

/// Across and up, in shares of a thing's height: it stands on y = 0, its middle at x = 0.
struct ThingSpace;
using ThingPoint = Vec2<ThingSpace>;

/// Things whose size everybody knows.
struct Thing {
  std::string_view key, label;
  std::string_view tall, beside;  ///< sentences about its {length}
  double mm;                      ///< how tall it stands
  double width;                   ///< share of that
};
std::span<const Thing> things();
/// Its place in things(); none for another key.
std::optional<std::size_t> findThing(std::string_view key);
/// A drawing of it: lines, each from point to point.
std::vector<std::vector<ThingPoint>> thingLines(std::size_t thing);

/// What people type: "4", "4.5 cm", "40 mm", "1,2 m"; centimetres without a unit. None for anything
/// else.
std::optional<double> millimetresFrom(std::string_view text);

/// A thing in the world beside a model of these bounds, as large as it is when the model is
/// `heightMm` tall, on the same ground. It faces the camera, at the left side of the model as seen.
struct ThingPlace {
  WorldPoint foot;   ///< of its middle
  WorldPoint right;  ///< unit, level
  double scale = 1;  ///< its height in the world
  WorldPoint at(ThingPoint p) const { return foot + right * (p.x * scale) + WorldPoint{0, p.y * scale, 0}; }
};
ThingPlace placeBeside(const Thing& thing, const pipeline::WorldBounds& bounds, double heightMm, const Camera& camera);

}  // namespace spineloft::app
