#include "engine/pipeline/slices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engine/geometry/polyline.h"
#include "engine/stack/centre_rail.h"
#include "engine/stack/stand.h"

namespace spineloft::pipeline {
namespace {

constexpr double kLeastHalf = 0.5;  // picture pixels: of a slice, however thin the part is there

/// What the ribs say at a place of the spine.
struct Breadth {
  double at = 0;      ///< share of the spine's length
  double half = 0;    ///< half the width, square to the spine, picture pixels
  double offset = 0;  ///< of its middle, to the right
};

/// Where on the line a point is nearest to it.
struct Nearest {
  double at = 0;  ///< share of its length
  std::size_t segment = 0;
};
Nearest nearestOn(const std::vector<PicturePoint>& line, const std::vector<double>& lengths, PicturePoint p) {
  Nearest best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const PicturePoint q = geometry::nearestOnSegment(p, line[i], line[i + 1]);
    if (distance(p, q) >= least) continue;
    least = distance(p, q);
    best = {(lengths[i] + distance(line[i], q)) / lengths.back(), i};
  }
  return best;
}

/// In order along the spine.
std::vector<Breadth> breadthsOf(const PartShape& shape) {
  const std::vector<PicturePoint>& spine = shape.spine.points;
  if (spine.size() < 2) return {};
  const std::vector<double> lengths = geometry::arcLengths(std::span<const PicturePoint>(spine));
  if (!(lengths.back() > 0)) return {};
  std::vector<Breadth> out;
  for (const ribs::Rib& rib : shape.ribs.ribs) {
    const Nearest near = nearestOn(spine, lengths, rib.center);
    const PicturePoint way = normalized(spine[near.segment + 1] - spine[near.segment]);
    const PicturePoint right{-way.y, way.x};  // on the screen, where y goes down
    const double from = dot(rib.left - rib.center, right), to = dot(rib.right - rib.center, right);
    out.push_back({near.at, std::max((to - from) / 2, kLeastHalf), (from + to) / 2});
  }
  std::ranges::sort(out, {}, &Breadth::at);
  return out;
}

Breadth at(const std::vector<Breadth>& all, double share) {
  const auto next = std::ranges::lower_bound(all, share, {}, &Breadth::at);
  if (next == all.begin()) return all.front();
  if (next == all.end()) return all.back();
  const Breadth &a = *(next - 1), &b = *next;
  const double t = b.at > a.at ? (share - a.at) / (b.at - a.at) : 1;
  return {share, std::lerp(a.half, b.half, t), std::lerp(a.offset, b.offset, t)};
}

/// What the curves along the spine make of a section.
struct Form {
  double front = 1, back = 1, twist = 0;
};
Form formAt(const loft::LoftParams& loft, double share) {
  const double squash = geometry::valueAt(loft.squash, share, 1), bulge = geometry::valueAt(loft.bulge, share, 0);
  return {squash * std::max(loft::kLeastSide, 1 + bulge), squash * std::max(loft::kLeastSide, 1 - bulge),
          geometry::valueAt(loft.twist, share, 0)};
}

/// Between which the form is nearly straight, and those of the sections.
std::vector<double> placesAlong(const loft::LoftParams& loft, const std::vector<Breadth>& all, double length) {
  const double widest = std::ranges::max_element(all, {}, &Breadth::half)->half;
  std::vector<ModelPoint> sides, depths, turns;
  for (const Breadth& b : all) {
    const Form form = formAt(loft, b.at);
    sides.push_back({b.at * length, b.offset - b.half, b.offset + b.half});
    depths.push_back({b.at * length, b.half * form.front, b.half * form.back});
    turns.push_back({b.at * length, widest * form.twist, 0});
  }
  const auto places = [&](double tolerance) {
    std::vector<double> out;
    for (const auto* line : {&sides, &depths, &turns}) {
      for (const std::size_t i : geometry::keptPoints(std::span<const ModelPoint>(*line), tolerance)) {
        out.push_back(all[i].at);
      }
    }
    if (loft.sections.size() > 1) {
      for (const loft::SectionKey& key : loft.sections)
        out.push_back(std::clamp(key.at, all.front().at, all.back().at));
    }
    std::ranges::sort(out);
    const auto [rest, end] = std::ranges::unique(out, [](double a, double b) { return b - a < geometry::kLeastStep; });
    out.erase(rest, end);
    return out;
  };
  double tolerance = kSliceTolerance * widest;
  std::vector<double> out = places(tolerance);
  while (out.size() > std::max(kMostCopied, loft.sections.size() + 2)) out = places(tolerance *= 1.5);
  return out;
}

stack::Curve curveOf(const sections::DrawnCurve& drawn, const Breadth& size, const Form& form) {
  const double c = std::cos(form.twist), s = std::sin(form.twist);
  stack::Curve curve;
  curve.corners.all = std::ranges::all_of(drawn.points, &sections::DrawnPoint::corner);
  for (const sections::DrawnPoint& point : drawn.points) {
    if (point.corner && !curve.corners.all) {
      curve.corners.at.push_back(static_cast<std::uint32_t>(curve.through.size()));
    }
    const SectionPoint p{point.at.x, point.at.y * (point.at.y > 0 ? form.front : form.back)};
    const SectionPoint turned{p.x * c - p.y * s, p.x * s + p.y * c};
    curve.through.push_back(turned * size.half + SectionPoint{size.offset, 0});
  }
  return curve;
}

/// The bone where it stands, through as few points as that takes.
stack::Rail railAlong(const std::vector<ModelPoint>& centreLine, bool closed) {
  constexpr double kClose = 0.002;  // of the length
  const std::span<const ModelPoint> line(centreLine);
  const double length = geometry::arcLengths(line).back();
  stack::Rail rail{geometry::simplifiedLine(line, kClose * length), closed};
  if (closed && rail.points.size() > 3) rail.points.pop_back();  // the first one again
  return rail;
}

/// All planes on one rail.
Status standOnRail(const document::StackRecipe& recipe, Slices& out) {
  const auto isOff = [](const stack::Plane& plane) { return plane.origin.has_value(); };
  stack::Rail rail = recipe.rail;
  if (rail.points.empty() || std::ranges::any_of(recipe.planes, isOff)) {
    auto on = stack::ontoCentres(recipe.planes, recipe.rail);
    if (!on) return on.failure();
    out.onRail = std::move(on.value().planes);
    rail = std::move(on.value().rail);
  } else {
    out.onRail = recipe.planes;
    out.patterns = recipe.stack.patterns;
  }
  out.rail = std::move(rail);
  return Done{};
}

}  // namespace

Result<Slices> slicesOf(const document::LoftRecipe& recipe, const PartShape& shape) {
  const loft::LoftParams& loft = recipe.loft;
  const std::vector<Breadth> all = breadthsOf(shape);
  if (all.size() < 2) return Error::TooFewRibs;
  Slices out;
  out.onBone = loft.sections;
  out.rail = railAlong(shape.centreLine, recipe.pose.closed);
  for (const double share : placesAlong(loft, all, stack::lengthOf(out.rail))) {
    if (out.rail.closed && share > 1 - geometry::kLeastStep) continue;  // it is where the first one is
    const auto key = std::ranges::find_if(loft.sections,
                                          [&](const auto& k) { return std::abs(k.at - share) < geometry::kLeastStep; });
    const bool isDrawn = loft.sections.size() == 1 || key != loft.sections.end();
    const Result<sections::SectionShape> there =
        isDrawn ? Result(key != loft.sections.end() ? key->shape : loft.sections.front().shape)
                : loft::sectionAt(loft.sections, share);
    if (!there) return there.failure();
    const Result<sections::Drawing> drawing = sections::drawingOf(there.value());
    if (!drawing) return drawing.failure();
    Breadth size = at(all, share);
    size.half *= shape.scale;
    size.offset *= shape.scale;
    stack::Plane plane;
    plane.at = share;
    for (const sections::DrawnCurve& drawn : drawing.value()) {
      plane.curves.push_back(curveOf(drawn, size, formAt(loft, share)));
    }
    out.onRail.push_back(std::move(plane));
  }
  return out;
}

Result<Slices> slicesOf(const document::StackRecipe& recipe) {
  Slices out;
  if (const Status status = standOnRail(recipe, out); !status) return status.failure();
  const std::size_t count = out.onRail.size(), most = std::min(count, loft::kMostSectionKeys);
  for (std::size_t i = 0; i < most; ++i) {
    const stack::Plane& plane = out.onRail[most > 1 ? i * (count - 1) / (most - 1) : 0];
    if (plane.curves.empty()) continue;
    std::vector<std::vector<SectionPoint>> outlines;
    for (const stack::Curve& curve : plane.curves) outlines.push_back(stack::outlineOf(curve));
    Result<sections::SectionShape> shape = sections::sectionOfOutlines(std::move(outlines));
    if (!shape) return shape.failure();
    const bool isFirst = out.onBone.empty();
    if (!isFirst && plane.at - out.onBone.back().at < geometry::kLeastStep) continue;
    out.onBone.push_back({plane.at, std::move(shape).value(), plane.blend});
  }
  return out;
}

}  // namespace spineloft::pipeline
