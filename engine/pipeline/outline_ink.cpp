#include "engine/pipeline/outline_ink.h"

#include <algorithm>

#include "engine/geometry/line_distance.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"

namespace spineloft::pipeline {
namespace {

constexpr double kBeside = 0.012;  // of the longer side of the paper that an outline may lie beside its ink
constexpr double kSoft = 1.5;      // pixels that the rim of a line reaches beyond its radius

using Line = std::vector<PicturePoint>;

/// Closed: the rib ends of one side, round the end, those of the other side back, round the start.
Line outlineOf(const ribs::RibSet& set) {
  Line out;
  for (const ribs::Rib& rib : set.ribs) out.push_back(rib.left);
  out.insert(out.end(), set.endFan.points.begin(), set.endFan.points.end());
  for (auto rib = set.ribs.rbegin(); rib != set.ribs.rend(); ++rib) out.push_back(rib->right);
  out.insert(out.end(), set.startFan.points.rbegin(), set.startFan.points.rend());
  return out;
}

std::vector<Line> outlinesOf(const PartShape& shape) {
  if (!shape.contours.empty()) return shape.contours;
  return {outlineOf(shape.ribs)};
}

/// Whether the point is within `reach` of one of the closed lines.
bool liesAlong(const std::vector<Line>& outlines, PicturePoint p, double reach) {
  return std::ranges::any_of(
      outlines, [&](const Line& line) { return geometry::distanceToLine(p, std::span(line), true) <= reach; });
}

/// The stretches of the stroke along the outlines.
void addStretches(const image::SketchStroke& stroke, const std::vector<Line>& outlines, double beside,
                  std::vector<ribs::IgnoreMark>& out) {
  ribs::IgnoreMark mark{{}, stroke.radius + kSoft, true};
  const auto finish = [&] {
    if (!mark.stroke.empty()) out.push_back(mark);
    mark.stroke.clear();
  };
  for (const PicturePoint p : stroke.points) {
    if (liesAlong(outlines, p, stroke.radius + beside)) {
      mark.stroke.push_back(p);
    } else {
      finish();
    }
  }
  finish();
}

/// Whether more than half of the points are within the outlines, by even-odd.
bool runsWithin(std::span<const PicturePoint> line, const std::vector<Line>& outlines) {
  const auto within = [&](PicturePoint p) {
    return std::ranges::count_if(outlines, [&](const Line& o) { return geometry::holds(std::span(o), p); }) % 2 == 1;
  };
  return 2 * std::ranges::count_if(line, within) > std::ssize(line);
}

/// Upright, in picture pixels.
struct Extent {
  PicturePoint least, most;
  bool reaches(PicturePoint p, double radius) const {
    return p.x >= least.x - radius && p.x <= most.x + radius && p.y >= least.y - radius && p.y <= most.y + radius;
  }
};

Extent shownOf(const mesh::TriMesh& mesh, image::Size picture) {
  float left = 1, top = 1, right = 0, bottom = 0;
  for (const auto& [u, v] : mesh.uv) {
    left = std::min(left, u);
    right = std::max(right, u);
    top = std::min(top, v);
    bottom = std::max(bottom, v);
  }
  const auto at = [&](float u, float v) {
    return PicturePoint{static_cast<double>(u) * picture.width, static_cast<double>(v) * picture.height};
  };
  return {at(left, top), at(right, bottom)};
}

}  // namespace

std::vector<ribs::IgnoreMark> outlineInk(const PartShape& shape, const document::PictureEntry& entry) {
  std::vector<ribs::IgnoreMark> out;
  if (!entry.isSketch()) return out;
  const std::vector<Line> outlines = outlinesOf(shape);
  const double beside = kBeside * std::max(entry.size.width, entry.size.height);
  for (const auto& stroke : entry.sketch) {
    const image::SketchStroke& ink = stroke;
    if (!ink.erase) addStretches(ink, outlines, beside, out);
  }
  return out;
}

std::vector<ribs::IgnoreMark> inkOfOthers(const document::Document& document, const Derived& derived, PictureId picture,
                                          std::span<const PicturePoint> line) {
  constexpr double kOff = 0.25;  // of the radius: how far a simpler line may lie off the ink
  std::vector<ribs::IgnoreMark> out;
  for (std::size_t i = 0; i < derived.parts.size(); ++i) {
    const PartShape* shape = derived.parts[i].shape.get();
    if (shape == nullptr || shape->outlineInk.empty() || document::pictureOf(*document.parts[i]) != picture) continue;
    if (runsWithin(line, outlinesOf(*shape))) continue;
    for (const ribs::IgnoreMark& ink : shape->outlineInk) {
      if (out.size() == ribs::kMostIgnoreMarks) return out;
      out.push_back({geometry::simplifiedLine(std::span(ink.stroke), kOff * ink.radius), ink.radius, false});
    }
  }
  return out;
}

void addInkUpon(const PartShape& shape, image::Size picture, std::span<const ribs::IgnoreMark> ink,
                std::vector<ribs::IgnoreMark>& out) {
  if (ink.empty()) return;
  const Extent shown = shownOf(shape.mesh, picture);
  for (const ribs::IgnoreMark& mark : ink) {
    const auto reaches = [&](PicturePoint p) { return shown.reaches(p, mark.radius); };
    if (std::ranges::any_of(mark.stroke, reaches)) out.push_back(mark);
  }
}

}  // namespace spineloft::pipeline
