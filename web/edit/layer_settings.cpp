#include "web/edit/layer_settings.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/stack/centre_rail.h"
#include "engine/stack/run.h"

namespace spineloft::app {

double reachOf(const document::StackRecipe& recipe) {
  double reach = 1;
  for (const stack::Plane& plane : recipe.planes) {
    for (const stack::Curve& curve : plane.curves) {
      for (const SectionPoint p : curve.through) reach = std::max(reach, norm(p));
    }
  }
  return reach;
}

namespace {

using document::StackRecipe;

constexpr int kRingPoints = 12, kSpringRounds = 3;
constexpr double kLeastBend = 1.6, kPitch = 2.6;  // radius of a bend and way from round to round, times the farthest
                                                  // that a curve is from the rail
constexpr double kLeastGround = 0.15;             // below the lowest line, times the same

struct Box {
  ModelPoint low{1e300, 1e300, 1e300}, high{-1e300, -1e300, -1e300};
  ModelPoint middle() const { return (low + high) / 2; }
  double side() const { return std::max({high.x - low.x, high.y - low.y, high.z - low.z}); }
};
Box boxOf(const stack::Rail& rail) {
  Box box;
  for (const ModelPoint p : rail.points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
  }
  return box;
}

/// Layers, as often as they stand there, as far apart as there is room.
StackRecipe spread(StackRecipe recipe) {
  if (!stack::canRepeat(recipe.planes, recipe.rail, recipe.stack.patterns)) return recipe;
  const std::uint32_t times = stack::timesOf(recipe.planes, recipe.stack.patterns);
  stack::repeatAll({recipe.planes, recipe.rail, recipe.stack.patterns}, times);
  return recipe;
}

}  // namespace

std::optional<RailShape> railShapeOf(const stack::Rail& rail) {
  const std::size_t count = rail.points.size();
  if (rail.closed) return RailShape::Ring;
  if (count == kSpringRounds * kRingPoints + 1) return RailShape::Spring;
  if (count != 2) return std::nullopt;
  const ModelPoint way = rail.points[1] - rail.points[0];
  if (way.x == 0 && way.z == 0) return RailShape::Up;
  if (way.y == 0 && way.z == 0) return RailShape::Across;
  return way.x == 0 && way.y == 0 ? std::optional(RailShape::Deep) : std::nullopt;
}

StackRecipe withRail(const StackRecipe& recipe, const stack::Rail& rail) {
  StackRecipe out = recipe;
  out.rail = rail;
  for (stack::Plane& plane : out.planes) {
    if (!rail.closed || !plane.origin) continue;
    plane.origin.reset();  // on a closed rail all layers stand on it
    plane.turn = {};
  }
  if (!rail.closed && !out.planes.empty()) out.planes.back().links.clear();  // nothing follows it
  return rail.closed || !out.stack.patterns.empty() ? spread(std::move(out)) : out;
}

StackRecipe withRail(const StackRecipe& recipe, RailShape shape) {
  if (recipe.rail.points.empty()) return recipe;
  const Box box = boxOf(recipe.rail);
  const ModelPoint middle = box.middle();
  const double half = box.side() / 2, bend = kLeastBend * reachOf(recipe);
  stack::Rail rail;
  const auto add = [&](double x, double y, double z) { rail.points.push_back(middle + ModelPoint{x, y, z}); };
  const auto angleOf = [](int i) { return 2 * std::numbers::pi * i / kRingPoints; };
  switch (shape) {
    case RailShape::Up:
      add(0, -half, 0);
      add(0, half, 0);
      break;
    case RailShape::Across:
      add(-half, 0, 0);
      add(half, 0, 0);
      break;
    case RailShape::Deep:
      add(0, 0, half);  // up is y on its sheets then
      add(0, 0, -half);
      break;
    case RailShape::Ring: {
      const double radius = std::max(half, bend);
      rail.closed = true;
      for (int i = 0; i < kRingPoints; ++i) add(radius * std::sin(angleOf(i)), -radius * std::cos(angleOf(i)), 0);
      break;
    }
    case RailShape::Spring: {
      const double pitch = kPitch * reachOf(recipe) / kRingPoints;
      constexpr int kSteps = kSpringRounds * kRingPoints;
      for (int i = 0; i <= kSteps; ++i) {
        add(bend * std::sin(angleOf(i)), pitch * (i - kSteps / 2.0), bend * std::cos(angleOf(i)));
      }
      break;
    }
  }
  return spread(withRail(recipe, rail));
}

StackRecipe withDrawnRail(const StackRecipe& recipe, const stack::Rail& rail) {
  StackRecipe out = recipe;
  SectionPoint sum;
  int count = 0;
  for (const stack::Plane& plane : recipe.planes) {
    if (plane.origin) continue;
    const auto centre = stack::centreOf(plane);
    sum = sum + centre.value_or(SectionPoint{});
    count += centre.has_value();
  }
  for (stack::Plane& plane : out.planes) {
    if (!plane.origin) stack::moveCurves(plane, sum * (-1.0 / std::max(count, 1)));
  }
  return withRail(out, rail);
}

Result<StackRecipe> withRailThroughMiddles(const StackRecipe& recipe) {
  if (!recipe.stack.patterns.empty()) {
    return {Error::StackInvalid, kRepeated};
  }
  auto on = stack::ontoCentres(recipe.planes, recipe.rail);
  if (!on) return on.failure();
  StackRecipe out = recipe;
  out.planes = std::move(on.value().planes);
  out.rail = std::move(on.value().rail);
  return out;
}

std::optional<std::uint32_t> repeatsOf(const StackRecipe& recipe) {
  if (!stack::canRepeat(recipe.planes, recipe.rail, recipe.stack.patterns)) return std::nullopt;
  return stack::timesOf(recipe.planes, recipe.stack.patterns);
}

StackRecipe withRepeats(const StackRecipe& recipe, std::uint32_t times) {
  StackRecipe out = recipe;
  stack::repeatAll({out.planes, out.rail, out.stack.patterns}, times);
  return out;
}

std::optional<sections::BlendKind> blendOf(const StackRecipe& recipe) {
  if (recipe.planes.empty()) return std::nullopt;
  const sections::BlendKind first = recipe.planes.front().blend.kind;
  const bool all = std::ranges::all_of(recipe.planes, [&](const auto& plane) { return plane.blend.kind == first; });
  return all ? std::optional(first) : std::nullopt;
}

StackRecipe withBlend(const StackRecipe& recipe, sections::BlendKind blend) {
  StackRecipe out = recipe;
  for (stack::Plane& plane : out.planes) plane.blend = {blend, {}};
  return out;
}

StackRecipe withBumps(const StackRecipe& recipe, const stack::Rough& rough) {
  StackRecipe out = recipe;
  out.stack.rough = rough;
  return out;
}

std::optional<stack::CurveUse> openLinesOf(const StackRecipe& recipe) {
  for (const stack::Plane& plane : recipe.planes) {
    const auto open = std::ranges::find(plane.curves, true, &stack::Curve::open);
    if (open != plane.curves.end()) return open->as;
  }
  return std::nullopt;
}

StackRecipe withOpenLines(const StackRecipe& recipe, stack::CurveUse use, double wall) {
  StackRecipe out = recipe;
  double low = 1e300, high = -1e300, base = 1e300;
  const auto each = [&](const auto& visit) {
    for (stack::Plane& plane : out.planes) {
      for (stack::Curve& curve : plane.curves) {
        if (curve.open) visit(curve);
      }
    }
  };
  each([&](const stack::Curve& curve) {
    if (curve.as == stack::CurveUse::Ground) base = std::min(base, curve.base);
    for (const SectionPoint p : curve.through) {
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
  });
  if (base >= low) base = low - std::max(kLeastGround * reachOf(recipe), high - low);
  each([&](stack::Curve& curve) {
    if (curve.as == use) return;
    if (use == stack::CurveUse::Ground) curve.base = base;
    if (use == stack::CurveUse::Ribbon) curve.width = wall;
    curve.as = use;
  });
  return out;
}

std::optional<double> wallOf(const StackRecipe& recipe) {
  for (const stack::Plane& plane : recipe.planes) {
    const auto wall = std::ranges::find(plane.curves, stack::CurveUse::Ribbon, &stack::Curve::as);
    if (wall != plane.curves.end()) return wall->width;
  }
  return std::nullopt;
}

StackRecipe withWalls(const StackRecipe& recipe, double width) {
  StackRecipe out = recipe;
  for (stack::Plane& plane : out.planes) {
    for (stack::Curve& curve : plane.curves) {
      if (curve.as == stack::CurveUse::Ribbon) curve.width = width;
    }
  }
  return out;
}

}  // namespace spineloft::app
