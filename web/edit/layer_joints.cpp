#include "web/edit/layer_joints.h"

#include <algorithm>
#include <optional>

#include "engine/geometry/polygon.h"
#include "web/edit/preview.h"

namespace spineloft::app {
namespace {

using document::StackRecipe;

/// Of so many pairs between two layers all are shown; of more those that are linked, or were.
constexpr std::size_t kMostPairs = 6;

/// The layers with curves before and after a place of the sheet.
std::vector<std::size_t> firstsAround(const Sheet& sheet) {
  const std::vector<stack::Plane>& planes = sheet.recipe.planes;
  const auto place = [&](std::size_t i) { return sheet.onRail() ? planes[i].at : static_cast<double>(i); };
  std::vector<std::size_t> firsts;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    const auto next = stack::nextDrawn(planes, sheet.recipe.rail.closed, i);
    if (planes[i].curves.empty() || !next || *next == i) continue;
    const bool around = sheet.layer ? i == *sheet.layer || *next == *sheet.layer
                                    : *next > i && place(i) < sheet.at && sheet.at < place(*next);
    if (around) firsts.push_back(i);
  }
  return firsts;
}

std::vector<ModelPoint> middlesOf(const StackRecipe& recipe, std::size_t plane) {
  const Result<stack::Stand> stand = stack::standOf(recipe.planes[plane], recipe.rail);
  std::vector<ModelPoint> middles;
  if (!stand) return middles;
  for (const stack::Curve& curve : recipe.planes[plane].curves) {
    const std::vector<SectionPoint> outline = stack::outlineOf(curve);
    middles.push_back(stand.value().at(geometry::centroid(std::span<const SectionPoint>(outline))));
  }
  return middles;
}

const stack::Ways* waysOf(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                          PartId id) {
  if (const Preview* preview = previewOf(ui, id); preview != nullptr && preview->shape) return &preview->shape->ways;
  for (std::size_t i = 0; i < std::min(document.parts.size(), derived.parts.size()); ++i) {
    if (document.parts[i]->id == id && derived.parts[i].shape) return &derived.parts[i].shape->ways;
  }
  return nullptr;
}

/// The links and forks between a layer and the next one.
void addBetween(const StackRecipe& recipe, const stack::Ways& ways, std::size_t plane, std::size_t next,
                LayerJoints& joints) {
  const std::vector<ModelPoint> below = middlesOf(recipe, plane), above = middlesOf(recipe, next);
  if (below.size() * above.size() < 2) return;
  const std::vector<stack::CurveLink>& said = recipe.planes[plane].links;
  for (std::uint32_t i = 0; i < below.size(); ++i) {
    for (std::uint32_t j = 0; j < above.size(); ++j) {
      const bool on = std::ranges::find(ways.links, stack::Ways::Link{plane, i, next, j}) != ways.links.end();
      const bool known = std::ranges::any_of(said, [&](const auto& link) { return link.from == i && link.to == j; });
      if (!on && !known && below.size() * above.size() > kMostPairs) continue;
      // Nearer to where there are more: marks of links that cross each other, or part, lie apart.
      const double share = above.size() > below.size() ? 0.7 : 0.3;
      joints.links.push_back({plane, i, j, on, below[i], above[j], lerp(below[i], above[j], share)});
    }
  }
  const auto parts = [&](bool up) {
    return std::ranges::any_of(ways.forks, [&](const auto& f) { return f.up == up && f.plane == (up ? plane : next); });
  };
  if (parts(true) && parts(false)) return;
  for (const stack::Ways::Fork& fork : ways.forks) {
    if (fork.plane != (fork.up ? plane : next)) continue;
    const std::vector<ModelPoint>&own = fork.up ? below : above, &others = fork.up ? above : below;
    ModelPoint sum;
    int count = 0;
    for (const stack::Ways::Link& link : ways.links) {
      if (link.plane != plane || link.nextPlane != next) continue;
      const std::size_t mine = fork.up ? link.curve : link.nextCurve, other = fork.up ? link.nextCurve : link.curve;
      if (mine != fork.curve || other >= others.size()) continue;
      sum += others[other];
      ++count;
    }
    if (count == 0 || fork.curve >= own.size()) continue;
    joints.forks.push_back({fork.plane, static_cast<std::uint32_t>(fork.curve), fork.up, fork.at, own[fork.curve],
                            sum / static_cast<double>(count)});
  }
}

}  // namespace

LayerJoints jointsOf(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                     const Sheet& sheet) {
  LayerJoints joints;
  const stack::Ways* ways = waysOf(document, derived, ui, sheet.part);
  if (ways == nullptr) return joints;
  for (const std::size_t plane : firstsAround(sheet)) {
    const auto next = stack::nextDrawn(sheet.recipe.planes, sheet.recipe.rail.closed, plane);
    addBetween(sheet.recipe, *ways, plane, *next, joints);
  }
  return joints;
}

StackRecipe withLink(const StackRecipe& recipe, const LayerLink& link, bool on) {
  StackRecipe out = recipe;
  std::vector<stack::CurveLink>& links = out.planes[link.plane].links;
  std::erase_if(links, [&](const stack::CurveLink& old) { return old.from == link.from && old.to == link.to; });
  links.push_back({link.from, link.to, on});
  return out;
}

StackRecipe withFork(const StackRecipe& recipe, const LayerFork& fork, double at) {
  StackRecipe out = recipe;
  stack::Curve& curve = out.planes[fork.plane].curves[fork.curve];
  (fork.up ? curve.forkAt : curve.joinAt) = std::clamp(at, 0.0, 1.0);
  return out;
}

void dropCurve(StackRecipe& recipe, std::size_t plane, std::size_t curve) {
  std::vector<stack::Plane>& planes = recipe.planes;
  std::vector<std::size_t> before;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    if (stack::nextDrawn(planes, recipe.rail.closed, i) == plane) before.push_back(i);
  }
  planes[plane].curves.erase(planes[plane].curves.begin() + static_cast<std::ptrdiff_t>(curve));
  const auto drop = [&](std::vector<stack::CurveLink>& links, std::uint32_t stack::CurveLink::* end) {
    std::erase_if(links, [&](const stack::CurveLink& link) { return link.*end == curve; });
    for (stack::CurveLink& link : links) {
      if (link.*end > curve) --(link.*end);
    }
  };
  drop(planes[plane].links, &stack::CurveLink::from);
  for (const std::size_t i : before) drop(planes[i].links, &stack::CurveLink::to);
}

void dropLinksTo(StackRecipe& recipe, std::size_t plane) {
  for (std::size_t i = 0; i < recipe.planes.size(); ++i) {
    if (stack::nextDrawn(recipe.planes, recipe.rail.closed, i) == plane) recipe.planes[i].links.clear();
  }
}

}  // namespace spineloft::app
