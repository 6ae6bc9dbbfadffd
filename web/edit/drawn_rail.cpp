#include "web/edit/drawn_rail.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"

namespace spineloft::app {
namespace {

constexpr double kSpacing = 28, kLeastLength = 24;  // CSS pixels between the rail's points, and of the whole line
constexpr std::size_t kLeastPoints = 4, kMostPoints = 32;
constexpr std::size_t kFiner = 8;                   // points of the line to one of the rail: the hand's tremor goes
constexpr double kStraight = 0.992, kClosed = 0.1;  // chord to length; gap to length
constexpr double kLift = 0.8, kBend = 1.2, kRounder = 1.05;  // of the mean radius of the layers

/// The line without tremor, evenly spaced.
std::vector<ClientPoint> steadied(std::span<const ClientPoint> line, std::size_t count, bool closed) {
  const std::vector<ClientPoint> fine = geometry::resample(line, (count - 1) * kFiner + 1);
  std::vector<ClientPoint> out;
  const std::size_t last = fine.size() - 1;
  for (std::size_t i = 0; i + (closed ? kFiner : 0) <= last; i += kFiner) {
    const std::size_t reach = std::min({i, last - i, kFiner});
    ClientPoint sum = fine[i];
    for (std::size_t k = 1; k <= reach; ++k) sum = sum + fine[i - k] + fine[i + k];
    out.push_back(sum / static_cast<double>(2 * reach + 1));
  }
  return out;
}

/// Root of the mean area of the curves over pi, picture pixels.
double meanRadius(const document::StackRecipe& recipe) {
  double area = 0;
  int count = 0;
  for (const stack::Plane& plane : recipe.planes) {
    for (const stack::Curve& curve : plane.curves) {
      const std::vector<SectionPoint> outline = stack::outlineOf(curve);
      area += std::abs(geometry::signedArea(std::span<const SectionPoint>(outline)));
      ++count;
    }
  }
  return count > 0 ? std::sqrt(area / count / std::numbers::pi) : 0;
}

ModelPoint middleOf(const stack::Rail& rail) {
  ModelPoint sum;
  for (const ModelPoint p : rail.points) sum = sum + p;
  return sum / static_cast<double>(std::max<std::size_t>(rail.points.size(), 1));
}

/// How far its points are from their middle, on average.
double meanReach(const stack::Rail& rail) {
  const ModelPoint middle = middleOf(rail);
  double sum = 0;
  for (const ModelPoint p : rail.points) sum += distance(p, middle);
  return sum / static_cast<double>(rail.points.size());
}

/// Evens a line out until no bend of it is tighter than a radius, as far as that goes with its ends in place; a closed
/// one keeps its size, or has the least that such bends need.
void widenBends(stack::Rail& rail, double radius) {
  constexpr int kMostPasses = 60;
  std::vector<ModelPoint>& p = rail.points;
  const std::size_t n = p.size();
  const std::size_t first = rail.closed ? 0 : 1, last = rail.closed ? n : n - 1;
  const auto isTight = [&](std::size_t i) {
    const ModelPoint a = p[(i + n - 1) % n], b = p[i], c = p[(i + 1) % n];
    const double sides = distance(a, b) * distance(b, c) * distance(c, a);
    return 2 * norm(cross(b - a, c - b)) * radius > sides;  // of the circle through the three
  };
  double size = meanReach(rail);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    bool tight = false;
    for (std::size_t i = first; i < last; ++i) tight |= isTight(i);
    if (!tight) return;
    const std::vector<ModelPoint> was = p;
    for (std::size_t i = first; i < last; ++i) p[i] = (was[(i + n - 1) % n] + was[i] * 2 + was[(i + 1) % n]) / 4;
    if (!rail.closed) continue;
    size = std::max(size, kRounder * radius);
    const ModelPoint middle = middleOf(rail);
    const double larger = size / meanReach(rail);  // evened out it would shrink to a point
    for (ModelPoint& q : p) q = middle + (q - middle) * larger;
  }
}

/// Fills gaps with what lies between, or at the end nearest to, what there is.
void fillGaps(std::vector<std::optional<double>>& values) {
  std::optional<std::size_t> before;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!values[i]) continue;
    const double from = before ? *values[*before] : *values[i];
    const std::size_t start = before ? *before + 1 : 0;
    for (std::size_t k = start; k < i; ++k) {
      const double t = before ? static_cast<double>(k - *before) / static_cast<double>(i - *before) : 0;
      values[k] = from + (*values[i] - from) * t;
    }
    before = i;
  }
  for (std::size_t k = before ? *before + 1 : values.size(); k < values.size(); ++k) values[k] = values[*before];
}

}  // namespace

bool drawsRail(const document::Document& document, const UiState& ui) {
  if (!ui.layers.drawsRail) return false;
  const auto sheet = shownPlace(document, ui);
  return sheet && sheet->part && sheet->part == ui.layers.part && sheet->onRail();
}

Result<stack::Rail> railAlong(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                              Picker& picker, const Sheet& sheet, std::span<const ClientPoint> line) {
  const double length = line.empty() ? 0 : geometry::arcLengths(line).back();
  if (length < kLeastLength) {
    return {Error::StackInvalid, "the line of the layers is too short: draw it across the solid view"};
  }
  const double gap = distance(line.front(), line.back()) / length;
  const auto count = std::clamp(static_cast<std::size_t>(length / kSpacing) + 1, kLeastPoints, kMostPoints);
  stack::Rail rail{{}, gap < kClosed};
  const std::vector<ClientPoint> points = steadied(line, count, rail.closed);
  const pipeline::ToWorld toWorld = sheetInWorld(document, derived, ui, sheet);
  const WorldPoint eye = ui.camera.eye(), back = ui.camera.back();
  const double radius = meanRadius(sheet.recipe), lift = kLift * radius * toWorld.scale;

  std::vector<std::optional<double>> depths;  // before the eye, along the view
  std::vector<WorldPoint> lifted;
  for (const ClientPoint p : points) {
    const std::array without{sheet.part};
    const RayHit hit =
        picker.firstHit(document, derived, ui, {eye, rayThrough(ui.camera, ui.layout.solid, p)}, without);
    lifted.push_back(hit ? hit.at + hit.normal * lift : WorldPoint{});
    depths.push_back(hit ? std::optional(dot(eye - lifted.back(), back)) : std::nullopt);
  }
  const std::vector<std::optional<double>> met = depths;
  const bool meets = std::ranges::any_of(met, [](const auto& depth) { return depth.has_value(); });
  if (!meets) depths.front() = dot(eye - toWorld(middleOf(sheet.recipe.rail)), back);
  fillGaps(depths);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const WorldPoint way = rayThrough(ui.camera, ui.layout.solid, points[i]);
    const WorldPoint at = met[i] ? lifted[i] : eye + way * (*depths[i] / -dot(way, back));
    rail.points.push_back(toWorld.toModel(at));
  }
  widenBends(rail, kBend * radius);
  if (!meets && gap > kStraight) rail.points = {rail.points.front(), rail.points.back()};
  return rail;
}

}  // namespace spineloft::app
