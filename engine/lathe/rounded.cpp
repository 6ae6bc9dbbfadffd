#include "engine/lathe/rounded.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/polyline.h"

namespace spineloft::lathe {
namespace {

constexpr int kChords = 160, kFits = 4;
constexpr double kUpright = 3 * std::numbers::pi / 180;
constexpr double kTolerance = 1e-3;  // of the size, by which the profile may be simplified

struct Line {
  PicturePoint at, along;  ///< unit vector
  PicturePoint aside() const { return {-along.y, along.x}; }
};

/// What lies inside on a line square to the axis.
struct Chord {
  double h = 0, length = 0, middle = 0;
  double square = 0;  ///< ∫ of the squared way aside over what lies inside
};
Chord chordAt(const geometry::Contours& outlines, const Line& axis, double h) {
  std::vector<double> places;
  for (const auto& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PicturePoint a = outline[i] - axis.at, b = outline[(i + 1) % outline.size()] - axis.at;
      const double from = dot(a, axis.along) - h, to = dot(b, axis.along) - h;
      if ((from > 0) == (to > 0)) continue;
      places.push_back(dot(lerp(a, b, from / (from - to)), axis.aside()));
    }
  }
  std::ranges::sort(places);
  Chord chord{h};
  for (std::size_t i = 0; i + 1 < places.size(); i += 2) {
    const double length = places[i + 1] - places[i];
    chord.length += length;
    chord.middle += length * (places[i] + places[i + 1]) / 2;
    chord.square += (std::pow(places[i + 1], 3) - std::pow(places[i], 3)) / 3;
  }
  if (chord.length > 0) chord.middle /= chord.length;
  return chord;
}

/// Chords at even distances from end to end, the ends a hair within.
std::vector<Chord> chordsOf(const geometry::Contours& outlines, const Line& axis) {
  double low = INFINITY, high = -INFINITY;
  for (const auto& outline : outlines) {
    for (const PicturePoint p : outline) {
      low = std::min(low, dot(p - axis.at, axis.along));
      high = std::max(high, dot(p - axis.at, axis.along));
    }
  }
  std::vector<Chord> chords;
  constexpr double kWithin = 1e-3;  // of the way between two chords
  for (int i = 0; i <= kChords; ++i) {
    const double at = std::clamp(static_cast<double>(i), kWithin, kChords - kWithin) / kChords;
    chords.push_back(chordAt(outlines, axis, low + (high - low) * at));
  }
  return chords;
}

/// The line through the middles of the chords; the same one where they say nothing.
Line fitted(const Line& axis, const std::vector<Chord>& chords) {
  double w = 0, wh = 0, wm = 0, whh = 0, whm = 0;
  for (const auto& [h, length, middle, square] : chords) {
    w += length;
    wh += length * h;
    wm += length * middle;
    whh += length * h * h;
    whm += length * h * middle;
  }
  const double spread = w * whh - wh * wh;
  if (!(spread > 0)) return axis;
  const double slope = (w * whm - wh * wm) / spread, shift = (wm - slope * wh) / w;
  return {axis.at + axis.aside() * shift, normalized(axis.along + axis.aside() * slope)};
}

/// The long principal direction of the area, from upright chords; nothing without an area.
Line principalLine(const geometry::Contours& outlines) {
  const Line upright{outlines.front().front(), {0, 1}};
  double area = 0, h = 0, m = 0, hh = 0, hm = 0, mm = 0;
  for (const Chord& chord : chordsOf(outlines, upright)) {
    area += chord.length;
    h += chord.length * chord.h;
    m += chord.length * chord.middle;
    hh += chord.length * chord.h * chord.h;
    hm += chord.length * chord.middle * chord.h;
    mm += chord.square;
  }
  if (!(area > 0)) return {upright.at, {0, 0}};
  h /= area;
  m /= area;
  const double angle = std::atan2(2 * (hm / area - h * m), (hh / area - h * h) - (mm / area - m * m)) / 2;
  return {upright.at + upright.along * h + upright.aside() * m,
          upright.along * std::cos(angle) + upright.aside() * std::sin(angle)};
}

PicturePoint straightened(PicturePoint along) {
  const double slack = std::sin(kUpright);
  if (std::abs(along.x) < slack) return {0, along.y < 0 ? -1.0 : 1.0};
  if (std::abs(along.y) < slack) return {along.x < 0 ? -1.0 : 1.0, 0};
  return along;
}

}  // namespace

Result<Rounded> rounded(const geometry::Contours& silhouette) {
  geometry::Contours outlines = silhouette;
  std::erase_if(outlines, [](const auto& outline) { return outline.size() < 3; });
  if (outlines.empty()) return Error::RegionEmpty;
  Line axis = principalLine(outlines);
  if (axis.along == PicturePoint{}) return Error::RegionEmpty;
  for (int i = 0; i < kFits; ++i) axis = fitted(axis, chordsOf(outlines, axis));
  if (const PicturePoint straight = straightened(axis.along); !(straight == axis.along)) {
    axis.along = straight;
    const Line shifted = fitted(axis, chordsOf(outlines, axis));
    axis.at = axis.at + axis.aside() * dot(shifted.at - axis.at, axis.aside());
  }
  std::vector<PicturePoint> profile;
  for (const auto& [h, length, middle, square] : chordsOf(outlines, axis)) {
    profile.push_back(axis.at + axis.along * h + axis.aside() * (length / 2));
  }
  const PicturePoint from = axis.at + axis.along * dot(profile.front() - axis.at, axis.along);
  const PicturePoint to = axis.at + axis.along * dot(profile.back() - axis.at, axis.along);
  const double tolerance = kTolerance * distance(from, to);
  return Rounded{from, to, geometry::simplifiedLine(std::span<const PicturePoint>(profile), tolerance)};
}

}  // namespace spineloft::lathe
