#include "engine/pipeline/slices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "engine/geometry/polyline.h"
#include "engine/loft/posed.h"
#include "engine/pipeline/part_shape.h"
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

/// In order along the spine.
std::vector<Breadth> breadthsOf(const PartShape& shape) {
  const Result<loft::PosedSpine> spine = loft::poseSpine(shape.spine, {});
  if (!spine) return {};
  const std::vector<geometry::Frame>& frames = spine.value().rest;
  std::vector<Breadth> out;
  for (const ribs::Rib& rib : shape.ribs.ribs) {
    const double share = loft::shareAt(spine.value(), rib.center);
    const auto nearest = static_cast<std::size_t>(std::lround(share * static_cast<double>(frames.size() - 1)));
    const PicturePoint right{frames[nearest].across.x, -frames[nearest].across.y};
    const double from = dot(rib.left - rib.center, right), to = dot(rib.right - rib.center, right);
    out.push_back({share, std::max((to - from) / 2, kLeastHalf), (from + to) / 2});
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

/// Where the sections along the bone stand, and places between two of them that tell of their blend.
std::vector<double> changesOf(const loft::LoftParams& loft) {
  std::vector<double> out;
  for (std::size_t i = 0; loft.sections.size() > 1 && i < loft.sections.size(); ++i) {
    const loft::SectionKey& key = loft.sections[i];
    out.push_back(key.at);
    if (i + 1 == loft.sections.size() || key.blend.kind == sections::BlendKind::Linear) continue;
    const double way = loft.sections[i + 1].at - key.at;
    if (key.blend.kind == sections::BlendKind::Hold) {
      out.push_back(key.at + way * sections::kHeld);
      continue;
    }
    for (const double t : {0.25, 0.5, 0.75}) out.push_back(key.at + way * t);
  }
  return out;
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
    for (const double share : changesOf(loft)) out.push_back(std::clamp(share, all.front().at, all.back().at));
    std::ranges::sort(out);
    const auto [rest, end] = std::ranges::unique(out, [](double a, double b) { return b - a < geometry::kLeastStep; });
    out.erase(rest, end);
    return out;
  };
  double tolerance = kSliceTolerance * widest;
  std::vector<double> out = places(tolerance);
  const std::size_t most = std::max(kMostCopied, changesOf(loft).size() + 2);
  while (out.size() > most) out = places(tolerance *= 1.5);
  return out;
}

/// From x = -1 to x = 1, as lofts take what is drawn in any units.
void fitWidth(sections::Drawing& drawing) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const sections::DrawnCurve& curve : drawing) {
    for (const SectionPoint p : sections::outlineOf(curve)) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
  }
  if (!(high > low)) return;
  for (sections::DrawnCurve& curve : drawing) {
    for (sections::DrawnPoint& point : curve.points) {
      point.at = {2 * (point.at.x - low) / (high - low) - 1, 2 * point.at.y / (high - low)};
    }
  }
}

stack::Curve curveOf(const sections::DrawnCurve& drawn, const Breadth& size, const Form& form) {
  const double c = std::cos(form.twist), s = std::sin(form.twist);
  stack::Curve curve = stack::curveThrough(drawn);
  for (SectionPoint& p : curve.through) {
    p.y *= p.y > 0 ? form.front : form.back;
    p = SectionPoint{p.x * c - p.y * s, p.x * s + p.y * c} * size.half + SectionPoint{size.offset, 0};
  }
  return curve;
}

/// The bone where it stands, through as few points as that takes.
stack::Rail railAlong(const std::vector<ModelPoint>& centreLine, bool closed, const std::vector<Breadth>& all) {
  constexpr double kOfLength = 0.002, kOfWidth = 0.02;
  const std::span<const ModelPoint> line(centreLine);
  const double length = geometry::arcLengths(line).back();
  const double widest = std::ranges::max_element(all, {}, &Breadth::half)->half;
  stack::Rail rail{geometry::simplifiedLine(line, std::min(kOfLength * length, kOfWidth * widest)), closed};
  if (closed && rail.points.size() > 3) rail.points.pop_back();  // the first one again
  return rail;
}

/// All planes on one rail.
Status standOnRail(const document::StackRecipe& recipe, Slices& out) {
  const auto isOff = [](const stack::Plane& plane) { return plane.origin.has_value(); };
  stack::Rail rail = recipe.rail;
  if (rail.points.empty() || std::ranges::any_of(recipe.planes, isOff)) {
    if (!recipe.stack.patterns.empty()) {
      return {Error::StackInvalid, "its layers are repeated along their line: set Times to 1 first"};
    }
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

/// What is drawn on planes as sections along a bone.
Result<std::vector<loft::SectionKey>> keysOf(const std::vector<stack::Plane>& planes) {
  std::vector<loft::SectionKey> keys;
  const std::size_t count = planes.size(), most = std::min(count, loft::kMostSectionKeys);
  for (std::size_t i = 0; i < most; ++i) {
    const stack::Plane& plane = planes[most > 1 ? i * (count - 1) / (most - 1) : 0];
    if (plane.curves.empty() || (!keys.empty() && plane.at - keys.back().at < geometry::kLeastStep)) continue;
    std::vector<std::vector<SectionPoint>> outlines;
    for (const stack::Curve& curve : plane.curves) outlines.push_back(stack::outlineOf(curve));
    Result<sections::SectionShape> shape = sections::sectionOfOutlines(std::move(outlines));
    if (!shape) return shape.failure();
    keys.push_back({plane.at, std::move(shape).value(), plane.blend});
  }
  if (const Status status = loft::checkSectionKeys(keys); !status) return status.failure();
  return keys;
}

}  // namespace

Result<Slices> slicesOf(const document::LoftRecipe& recipe, const PartShape& shape) {
  const loft::LoftParams& loft = recipe.loft;
  const std::vector<Breadth> all = breadthsOf(shape);
  if (all.size() < 2) return Error::TooFewRibs;
  Slices out{loft.sections, {}, {}, {}};
  out.rail = railAlong(shape.centreLine, recipe.pose.closed, all);
  // The centre line has its points at even shares of the bone as it was drawn, which are none of its length in space.
  const std::vector<double> lengths = geometry::arcLengths(std::span<const ModelPoint>(shape.centreLine));
  const auto onRail = [&](double share) {
    const double place = share * static_cast<double>(lengths.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), lengths.size() - 2);
    return std::clamp(std::lerp(lengths[i], lengths[i + 1], place - static_cast<double>(i)) / lengths.back(), 0.0, 1.0);
  };
  for (const double share : placesAlong(loft, all, stack::lengthOf(out.rail))) {
    if (out.rail.closed && share > 1 - geometry::kLeastStep) continue;  // it is where the first one is
    const auto key = std::ranges::find_if(loft.sections,
                                          [&](const auto& k) { return std::abs(k.at - share) < geometry::kLeastStep; });
    const bool isDrawn = loft.sections.size() == 1 || key != loft.sections.end();
    const Result<sections::SectionShape> there =
        isDrawn ? Result(key != loft.sections.end() ? key->shape : loft.sections.front().shape)
                : loft::sectionAt(loft.sections, share);
    if (!there) return there.failure();
    Result<sections::Drawing> drawing = sections::drawingOf(there.value());
    if (!drawing) return drawing.failure();
    fitWidth(drawing.value());
    Breadth size = at(all, share);
    size.half *= shape.scale;
    size.offset *= shape.scale;
    stack::Plane plane;
    plane.at = onRail(share);
    plane.blend.kind = sections::BlendKind::Linear;
    for (const sections::DrawnCurve& drawn : drawing.value()) {
      plane.curves.push_back(curveOf(drawn, size, formAt(loft, share)));
    }
    out.onRail.push_back(std::move(plane));
  }
  return out;
}

Result<Slices> slicesOf(const document::StackRecipe& recipe) {
  Slices out{std::vector<loft::SectionKey>(), {}, {}, {}};
  if (const Status status = standOnRail(recipe, out); !status) return status.failure();
  out.onBone = keysOf(out.onRail);
  return out;
}

}  // namespace spineloft::pipeline
