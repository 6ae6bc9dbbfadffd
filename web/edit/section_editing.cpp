#include "web/edit/section_editing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/geometry/polyline.h"
#include "web/edit/preview.h"

namespace spineloft::app {
namespace {

using document::AlongKind;
using SectionKeys = std::vector<loft::SectionKey>;
constexpr double kTurn = 2 * std::numbers::pi, kDegree = std::numbers::pi / 180;

constexpr std::array kAlong = {
    AlongInfo{AlongKind::Twist, "twist", "Twist", "Turn the slice round the bone", -loft::kMostTwist / kTurn,
              loft::kMostTwist / kTurn, 0, kTurn, 1},
    AlongInfo{AlongKind::Squash, "squash", "Flat or deep", "How deep the part is for its width", loft::kLeastSquash,
              loft::kMostSquash, 1, 1, 1},
    AlongInfo{AlongKind::Tilt, "tilt", "Lean", "Lean the slice to the front or back", -loft::kMostTilt / kDegree,
              loft::kMostTilt / kDegree, 0, kDegree, 60},
    AlongInfo{AlongKind::Bulge, "bulge", "Front or back", "Rounder on the front or on the back", -1, 1, 0, 1, 1},
};
static_assert(kAlong.size() == static_cast<std::size_t>(AlongKind::kCount));

double share(int i, int count) { return static_cast<double>(i) / count; }

/// Points of f at count + 1 even places.
template <class F>
std::vector<geometry::AlongPoint> sampled(int count, const F& f) {
  std::vector<geometry::AlongPoint> points;
  for (int i = 0; i <= count; ++i) points.push_back({share(i, count), f(share(i, count))});
  return points;
}

std::vector<AlongShape> makeShapes() {
  const auto wave = [](double middle, double by, double waves) {
    return sampled(static_cast<int>(waves * 4),
                   [=](double t) { return middle + by * std::round(std::sin(kTurn * waves * t)); });
  };
  return {
      {AlongKind::Twist, "turn", "One turn", {{0, 0}, {1, 1}}},
      {AlongKind::Twist, "half-turn", "Half a turn", {{0, 0}, {1, 0.5}}},
      {AlongKind::Twist, "pasta", "Pasta", {{0, 0}, {1, 4}}},
      {AlongKind::Twist, "there-and-back", "There and back", {{0, 0}, {0.5, 1}, {1, 0}}},
      {AlongKind::Squash, "flat-end", "Flat end", {{0, 1}, {1, 0.12}}},
      {AlongKind::Squash, "flat", "Flat", {{0, 0.3}, {1, 0.3}}},
      {AlongKind::Squash, "deep", "Deep", {{0, 1.8}, {1, 1.8}}},
      {AlongKind::Squash, "fish", "Fish", {{0, 0.9}, {0.3, 0.75}, {0.8, 0.25}, {1, 0.1}}},
      {AlongKind::Squash, "wave", "Wave", wave(1, 0.4, 3)},
      {AlongKind::Tilt, "forward", "Forward", {{0, 30}, {1, 30}}},
      {AlongKind::Tilt, "back", "Back", {{0, -30}, {1, -30}}},
      {AlongKind::Tilt, "wave", "Wave", wave(0, 30, 2)},
      {AlongKind::Bulge, "flat-front", "Flat front", {{0, -1}, {1, -1}}},
      {AlongKind::Bulge, "flat-back", "Flat back", {{0, 1}, {1, 1}}},
      {AlongKind::Bulge, "belly", "Belly", {{0, 0}, {0.45, 0.8}, {1, 0}}},
  };
}

/// Kept within the room that the neighbours leave.
double between(std::span<const loft::SectionKey> keys, std::size_t index, double at) {
  const double low = index > 0 ? keys[index - 1].at + kSectionKeyGap : 0;
  const double high = index + 1 < keys.size() ? keys[index + 1].at - kSectionKeyGap : 1;
  return low <= high ? std::clamp(at, low, high) : keys[index].at;
}

}  // namespace

void previewLoft(UiState& ui, const document::Part& part, loft::LoftParams params) {
  Preview& preview = previewPart(ui, part);
  if (preview.loft().loft == params) return;
  preview.asLoft().loft = std::move(params);
  preview.fresh = false;
}

std::size_t pickedSectionKey(const UiState& ui, const document::Part& part) {
  if (ui.sections.part != part.id) return 0;
  return std::min(ui.sections.key, document::loftIn(part).loft.sections.size() - 1);
}

const sections::SectionShape& pickedShape(const UiState& ui, const document::Part* part) {
  if (part == nullptr) return ui.section;
  return document::loftIn(*part).loft.sections[pickedSectionKey(ui, *part)].shape;
}

SectionKeys withSectionKey(std::span<const loft::SectionKey> keys, double at, const sections::SectionShape& shape,
                           std::size_t& added) {
  SectionKeys out(keys.begin(), keys.end());
  at = std::clamp(at, 0.0, 1.0);
  if (out.size() == 1) {
    loft::SectionKey first = out.front(), last = out.front();
    first.at = 0;
    last.at = 1;
    out.clear();
    if (at > kNearEnd) out.push_back(first);
    if (at < 1 - kNearEnd) out.push_back(last);
    if (at <= kNearEnd) at = 0;
    if (at >= 1 - kNearEnd) at = 1;
  }
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (std::abs(out[i].at - at) >= kSectionKeyGap) continue;
    out[i].shape = shape;
    added = i;
    return out;
  }
  const auto next = std::ranges::upper_bound(out, at, {}, &loft::SectionKey::at);
  added = static_cast<std::size_t>(next - out.begin());
  loft::SectionKey key;
  key.at = at;
  key.shape = shape;
  if (added > 0) key.blend = out[added - 1].blend;
  out.insert(next, std::move(key));
  return out;
}

SectionKeys withMovedSectionKey(std::span<const loft::SectionKey> keys, std::size_t index, double at) {
  SectionKeys out(keys.begin(), keys.end());
  if (index < out.size()) out[index].at = between(keys, index, at);
  return out;
}

sections::Blend blendOf(sections::BlendKind kind, const sections::Blend& before) {
  sections::Blend blend;
  blend.kind = kind;
  if (kind != sections::BlendKind::Custom) return blend;
  blend.custom = before.custom;
  if (blend.custom.empty()) blend.custom.points = {{0, 0}, {0.5, 0.5}, {1, 1}};
  return blend;
}

SectionKeys withoutSectionKey(std::span<const loft::SectionKey> keys, std::size_t index) {
  SectionKeys out(keys.begin(), keys.end());
  if (out.size() > 1 && index < out.size()) {
    out.erase(out.begin() + static_cast<std::ptrdiff_t>(index));
  }
  return out;
}

std::span<const AlongInfo> alongTable() { return kAlong; }

const AlongInfo& alongInfo(AlongKind kind) { return kAlong[static_cast<std::size_t>(kind)]; }

const AlongInfo* findAlong(std::string_view key) {
  const auto at = std::ranges::find(kAlong, key, &AlongInfo::key);
  return at == kAlong.end() ? nullptr : &*at;
}

std::span<const AlongShape> alongShapes() {
  static const std::vector<AlongShape> shapes = makeShapes();
  return shapes;
}

PicturePoint placeOnSpine(const pipeline::PartShape& shape, double at) {
  const std::span<const ModelPoint> line(shape.centreLine);
  const std::vector<double> s = geometry::arcLengths(line);
  const ModelPoint p = geometry::pointAt(line, std::span<const double>(s), at * s.back());
  return {p.x, -p.y};
}

SpinePlace nearestPlace(const pipeline::PartShape& shape, PicturePoint p) {
  const std::span<const ModelPoint> line(shape.centreLine);
  const std::vector<double> s = geometry::arcLengths(line);
  SpinePlace best{0, std::numeric_limits<double>::infinity()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PicturePoint a{line[i - 1].x, -line[i - 1].y}, along{line[i].x - a.x, -line[i].y - a.y};
    const double length2 = dot(along, along);
    const double t = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0.0;
    const double off = distance(p, a + along * t);
    if (off >= best.distance) continue;
    best = {s.back() > 0 ? (s[i - 1] + (s[i] - s[i - 1]) * t) / s.back() : 0, off};
  }
  return best;
}

const pipeline::PartShape* shapeOf(const document::Document& document, const pipeline::Derived& derived, PartId part) {
  const std::size_t count = std::min(document.parts.size(), derived.parts.size());
  for (std::size_t i = 0; i < count; ++i) {
    if (document.parts[i]->id == part) return derived.parts[i].shape.get();
  }
  return nullptr;
}

}  // namespace spineloft::app
