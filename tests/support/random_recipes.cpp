#include "tests/support/random_recipes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/random_documents.h"

namespace spineloft::testing {

using namespace document;

PartId anyPart(Rng& rng, const Document& document) {
  if (document.parts.empty() || rng.below(20) == 0) return PartId{rng.below(9)};
  return document.parts[rng.below(static_cast<std::uint32_t>(document.parts.size()))]->id;
}

PictureId anyPicture(Rng& rng, const Document& document) {
  if (document.pictures.empty() || rng.below(20) == 0) return PictureId{rng.below(9)};
  return document.pictures[rng.below(static_cast<std::uint32_t>(document.pictures.size()))]->id;
}

std::vector<SectionPoint> anyContour(Rng& rng) {
  std::vector<SectionPoint> contour;
  const std::uint32_t count = 2 + rng.below(40);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count, radius = rng.uniform(0.4, 1);
    contour.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  if (contour.size() > 2) {
    contour[0] = {1, 0};
    contour[contour.size() / 2] = {-1, 0};
  }
  return contour;
}

sections::SectionShape anySection(Rng& rng) {
  sections::SectionShape shape;
  shape.preset =
      static_cast<sections::SectionPreset>(rng.below(static_cast<std::uint32_t>(sections::SectionPreset::kCount) + 1));
  if (rng.below(4) == 0) shape.contours.push_back(anyContour(rng));
  return shape;
}

geometry::AlongCurve anyCurve(Rng& rng, double low, double high) {
  geometry::AlongCurve curve;
  const std::uint32_t count = rng.below(6);
  for (std::uint32_t i = 0; i < count; ++i) {
    curve.points.push_back({(i + rng.uniform(0, 0.9)) / count, rng.uniform(low, high)});
  }
  return curve;
}

std::vector<ribs::IgnoreMark> anyMarks(Rng& rng) {
  std::vector<ribs::IgnoreMark> marks(rng.below(4));
  for (ribs::IgnoreMark& mark : marks) {
    mark.stroke = randomStroke(rng, kWidth, kHeight);
    mark.radius = rng.uniform(0, 20);
    mark.covers = rng.below(3) == 0;
  }
  return marks;
}

sections::CapStyle anyCap(Rng& rng) {
  return static_cast<sections::CapStyle>(rng.below(static_cast<std::uint32_t>(sections::CapStyle::kCount) + 1));
}

std::vector<PicturePoint> anyStroke(Rng& rng) {
  std::vector<PicturePoint> stroke = randomStroke(rng, kWidth, kHeight);
  if (rng.below(15) == 0) stroke.resize(1);
  if (rng.below(15) == 0) stroke.back().x = std::numeric_limits<double>::quiet_NaN();
  return stroke;
}

Region anyRegion(Rng& rng, const Document& d) {
  Region region{anyPicture(rng, d), {}, 0};
  for (std::uint32_t i = 1 + rng.below(3); i > 0; --i) {
    const PicturePoint middle{rng.uniform(0.2, 0.8) * kWidth, rng.uniform(0.2, 0.8) * kHeight};
    auto& contour = region.contours.emplace_back();
    for (const SectionPoint p : anyContour(rng)) {
      contour.push_back(middle + PicturePoint{p.x, p.y} * rng.uniform(3, 30));
    }
  }
  if (rng.below(4) == 0) region.ribbon = rng.uniform(0, 12);
  region.open = rng.below(4) == 0;
  if (rng.below(15) == 0) region.contours[0].clear();
  if (rng.below(15) == 0) region.contours.clear();
  return region;
}

namespace {
inflate::BoneEdits anyBones(Rng& rng) {
  const auto place = [&] { return PicturePoint{rng.uniform(0, kWidth), rng.uniform(0, kHeight)}; };
  inflate::BoneEdits edits;
  edits.detail = rng.uniform(-0.02, 1.02);
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.drop.push_back(place());
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.add.push_back(anyStroke(rng));
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.move.push_back({place(), place()});
  for (std::uint32_t i = rng.below(3); i > 0; --i) edits.heights.push_back({place(), rng.uniform(0.05, 4)});
  return edits;
}
}  // namespace

RegionSolid anySolid(Rng& rng) {
  if (rng.below(3) == 0) {
    const auto place = [&] { return PicturePoint{rng.uniform(0, kWidth), rng.uniform(0, kHeight)}; };
    return lathe::LatheParams{place(),
                              place(),
                              rng.uniform(5, 370),
                              static_cast<int>(rng.below(140)),
                              rng.below(2) == 0 ? 0 : rng.uniform(-0.02, 0.25),
                              rng.uniform(0.05, 4.2)};
  }
  if (rng.below(2) == 0) {
    inflate::InflateParams puff{
        rng.uniform(0, 3), static_cast<inflate::InflateSides>(rng.below(4)), static_cast<int>(rng.below(900)), {}};
    if (rng.below(3) == 0) {
      puff.profile = {{{anySection(rng)}}, rng.uniform(-0.1, 1.1)};
      while (rng.below(3) == 0) {
        const PicturePoint at{rng.uniform(0, kWidth), rng.uniform(0, kHeight)};
        puff.profile.slices.push_back({rng.below(2) == 0 ? puff.profile.slices[0].shape : anySection(rng), at});
      }
    }
    if (rng.below(3) == 0) puff.bones = anyBones(rng);
    return puff;
  }
  return extrude::ExtrudeParams{rng.uniform(0, 0.4), static_cast<extrude::EdgeKind>(rng.below(4)),
                                rng.uniform(-0.05, 1.05), rng.uniform(-0.5, 0.5)};
}

namespace {
stack::Curve anyDrawnCurve(Rng& rng) {
  stack::Curve curve;
  const std::uint32_t count = 3 + rng.below(8);
  const double x = rng.uniform(-20, 20), y = rng.uniform(-20, 20), size = rng.uniform(4, 30);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * i / count, radius = size * rng.uniform(0.7, 1.1);
    curve.through.push_back({x + radius * std::cos(angle), y + radius * std::sin(angle)});
  }
  curve.corners.all = rng.below(4) == 0;
  if (!curve.corners.all && rng.below(3) == 0) curve.corners.at = {rng.below(count + (rng.below(9) == 0 ? 2 : 0))};
  if (rng.below(6) == 0) {
    curve.open = rng.below(9) > 0;
    curve.as = rng.below(2) == 0 ? stack::CurveUse::Ribbon : stack::CurveUse::Ground;
    curve.width = rng.uniform(rng.below(20) == 0 ? -5 : 1, 5);
    curve.base = rng.uniform(-60, -20);
  }
  return curve;
}
}  // namespace
std::vector<stack::Plane> anyPlanes(Rng& rng) {
  std::vector<stack::Plane> planes(rng.below(8) == 0 ? rng.below(2) : 2 + rng.below(3));
  const bool free = rng.below(3) == 0;
  for (std::size_t i = 0; i < planes.size(); ++i) {
    stack::Plane& plane = planes[i];
    plane.at = static_cast<double>(i) / 4;
    if (free) plane.origin = ModelPoint{rng.uniform(0, 40), rng.uniform(-40, 0), 60.0 * static_cast<double>(i)};
    if (rng.below(3) == 0) {
      plane.turn = geometry::turnAbout(ModelPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), 0.2}, rng.uniform(-0.4, 0.4));
    }
    for (std::uint32_t k = rng.below(3) == 0 ? 2 : 1; k > 0; --k) plane.curves.push_back(anyDrawnCurve(rng));
    plane.blend.kind =
        static_cast<sections::BlendKind>(rng.below(static_cast<std::uint32_t>(sections::BlendKind::kCount)));
    if (rng.below(40) == 0) plane.at = rng.uniform(-1, 2);
    if (rng.below(4) == 0 && (i + 1 < planes.size() || rng.below(40) == 0)) {
      const auto count = static_cast<std::uint32_t>(plane.curves.size());
      plane.links.push_back({rng.below(count), rng.below(40) == 0 ? 1u : 0u, rng.below(2) == 0});
    }
    if (rng.below(4) == 0) plane.curves[0].forkAt = rng.uniform(rng.below(40) == 0 ? -1 : 0, 1);
    if (rng.below(4) == 0) plane.curves[0].joinAt = rng.uniform(0, 1);
  }
  return planes;
}
stack::Rail anyRail(Rng& rng) {
  stack::Rail rail;
  rail.closed = rng.below(3) == 0;
  for (std::uint32_t i = 0, count = rng.below(6); i < count; ++i) {
    const double angle = 6.283185307179586 * i / count, reach = rng.uniform(60, 90);
    rail.points.push_back({reach * std::cos(angle), reach * std::sin(angle), rng.uniform(-10, 10)});
  }
  return rail;
}
stack::StackParams anyStackParams(Rng& rng) {
  stack::StackParams params{static_cast<sections::CapStyle>(rng.below(5)),
                            static_cast<sections::CapStyle>(rng.below(4)),
                            8 + static_cast<int>(rng.below(40)),
                            static_cast<int>(rng.below(8)),
                            {},
                            {}};
  if (rng.below(4) == 0) params.patterns.push_back({0, 0, 1 + rng.below(3), rng.uniform(0.01, 0.1)});
  if (rng.below(40) == 0) params.patterns.push_back({rng.below(4), rng.below(4), rng.below(3), rng.uniform(0, 1)});
  if (rng.below(4) == 0) {
    params.rough = {rng.uniform(rng.below(20) == 0 ? -5 : 0, 5), rng.uniform(1, 60), rng.below(100), rng.below(2) == 0};
  }
  if (rng.below(3) == 0) params.melt = rng.uniform(rng.below(20) == 0 ? -1 : 0, 1);
  return params;
}
std::vector<Outline> anyOutlines(Rng& rng, const Document& d) {
  std::vector<Outline> outlines(rng.below(3));
  for (Outline& outline : outlines) {
    outline.picture = anyPicture(rng, d);
    const double x = rng.uniform(30, 60), y = rng.uniform(30, 40), size = rng.uniform(5, 25);
    for (std::uint32_t line = 1 + rng.below(2); line > 0; --line) {
      std::vector<PicturePoint>& points = outline.lines.emplace_back();
      for (const SectionPoint p : anyContour(rng)) points.push_back({x + size * p.x, y - size * p.y});
    }
    if (rng.below(30) == 0) outline.lines.back().front().x = std::numeric_limits<double>::quiet_NaN();
  }
  return outlines;
}
shape::ShapeParams anyShape(Rng& rng) {
  shape::ShapeParams params;
  params.primitive = static_cast<shape::Primitive>(rng.below(static_cast<std::uint32_t>(shape::Primitive::kCount)));
  params.axis = {{rng.uniform(0, kWidth), rng.uniform(0, kHeight)}, {rng.uniform(0, kWidth), rng.uniform(0, kHeight)}};
  params.width = rng.uniform(0, 60);
  params.depth = {static_cast<shape::DepthMode>(rng.below(2)), rng.uniform(0.02, 3)};
  if (rng.below(3) == 0) params.section = anySection(rng);
  params.caps = {anyCap(rng), anyCap(rng)};
  params.levels = 8 + static_cast<int>(rng.below(30));
  params.sides = 12 + static_cast<int>(rng.below(40));
  params.capRings = static_cast<int>(rng.below(8));
  return params;
}

std::vector<descriptive::Stretch> anyStretches(Rng& rng) {
  std::vector<descriptive::Stretch> stretches;
  const std::uint32_t count = rng.below(3);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double from = (i + rng.uniform(-0.05, 0.4)) / count;
    stretches.push_back({from, from + rng.uniform(0, 0.5) / count});
  }
  return stretches;
}

std::optional<relief::Relief> anyRelief(Rng& rng, const Document& d) {
  if (rng.below(5) == 0) return std::nullopt;
  relief::Relief relief{static_cast<relief::Mode>(rng.below(3)), rng.uniform(-0.11, 0.1), rng.uniform(0, 1), {}, {}};
  const auto place = [&] { return PicturePoint{rng.uniform(0, kWidth), rng.uniform(0, kHeight)}; };
  if (rng.below(3) == 0) relief.region.push_back({place(), place(), place(), place()});
  if (rng.below(3) == 0) {
    const double turn = rng.below(3) == 0 ? relief::kMostTurn : rng.uniform(-3, 3);
    relief.laid = relief::Laid{anyPicture(rng, d), place(), rng.uniform(3, 80), turn};
  }
  return relief;
}

}  // namespace spineloft::testing
