#include "engine/loft/section_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/geometry/hermite.h"
#include "engine/geometry/polygon.h"
#include "engine/sections/common_points.h"

namespace spineloft::loft {
namespace {

constexpr int kPointsAt = 96;  // of a section that is asked for

using Curve = std::vector<SectionPoint>;
using Pieces = std::vector<sections::SectionPiece>;

/// The pieces of `next` in the order of those of `last`: holes go with their outer curve, and of what
/// may go together the nearest does.
std::vector<std::size_t> matched(const Pieces& last, const Pieces& next) {
  std::vector<std::size_t> match(last.size(), last.size());
  std::vector<bool> taken(next.size(), false);
  const auto holes = [](const Pieces& pieces, std::size_t outer) {
    return std::ranges::count_if(pieces, [&](const sections::SectionPiece& p) { return p.hole && p.outer == outer; });
  };
  for (const bool hole : {false, true}) {
    for (std::size_t i = 0; i < last.size(); ++i) {
      if (last[i].hole != hole) continue;
      const SectionPoint centre = geometry::centroid(last[i].contour.points);
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t j = 0; j < next.size(); ++j) {
        if (taken[j] || next[j].hole != hole) continue;
        if (hole ? next[j].outer != match[last[i].outer] : holes(last, i) != holes(next, j)) continue;
        const double away = distance(centre, geometry::centroid(next[j].contour.points));
        if (away < least) {
          least = away;
          match[i] = j;
        }
      }
      if (match[i] < next.size()) taken[match[i]] = true;
    }
  }
  return match;
}

void touchBothEnds(std::span<SectionPoint> points) {
  const auto [low, high] = std::ranges::minmax_element(points, {}, &SectionPoint::x);
  const double from = low->x, width = high->x - from;
  if (!(width > 1e-6) || (from == -1 && high->x == 1)) return;
  const auto first = low - points.begin(), last = high - points.begin();
  for (SectionPoint& p : points) p.x = std::clamp(-1 + 2 * (p.x - from) / width, -1.0, 1.0);
  points[static_cast<std::size_t>(first)].x = -1;
  points[static_cast<std::size_t>(last)].x = 1;
}

bool simpleCurves(std::span<const SectionPoint> points, std::span<const std::size_t> sizes) {
  return geometry::areSimple(points, sizes);
}

}  // namespace

SectionTrack SectionTrack::fixed(Curve points) {
  SectionTrack track;
  track.sizes_ = {points.size()};
  track.keys_.push_back({0, {}, std::move(points), false});
  track.finish();
  return track;
}

Result<SectionTrack> SectionTrack::along(std::span<const SectionKey> keys, int points, bool closed) {
  if (keys.size() == 1 && !keys.front().shape.drawn()) {
    Result<sections::Section> section = sections::presetSection(keys.front().shape.preset, points);
    if (!section) return section.failure();
    return fixed(std::move(section).value().points);
  }
  std::vector<Pieces> shapes;
  for (const SectionKey& key : keys) {
    Result<Pieces> pieces = sections::readShape(key.shape);
    if (!pieces) return pieces.failure();
    if (!shapes.empty()) {
      const std::vector<std::size_t> match = matched(shapes.back(), pieces.value());
      Pieces sorted;
      for (const std::size_t j : match) {
        if (j >= pieces.value().size()) {
          return {Error::SectionInvalid, "slices next to each other need equally many pieces, with equally many holes"};
        }
        sorted.push_back(pieces.value()[j]);
      }
      for (std::size_t i = 0; i < sorted.size(); ++i) sorted[i].outer = shapes.back()[i].outer;
      pieces = std::move(sorted);
    }
    shapes.push_back(std::move(pieces).value());
  }
  // Coarse points may make a fine shape cross itself: then there are more.
  for (int wanted = points; wanted <= 8 * sections::kMaxSectionPoints; wanted *= 2) {
    SectionTrack track;
    track.closed_ = closed;
    for (const SectionKey& key : keys) track.keys_.push_back({key.at, key.blend, {}, false});
    for (std::size_t piece = 0; piece < shapes.front().size(); ++piece) {
      std::vector<sections::Contour> row;
      for (const Pieces& shape : shapes) row.push_back(shape[piece].contour);
      std::vector<Curve> curves = sections::onCommonPoints(row, wanted);
      for (std::size_t k = 0; k < curves.size(); ++k) {
        if (shapes[k][piece].hole) std::ranges::reverse(curves[k]);
        Curve& all = track.keys_[k].points;
        all.insert(all.end(), curves[k].begin(), curves[k].end());
      }
      track.sizes_.push_back(curves.front().size());
    }
    track.finish();
    if (std::ranges::all_of(track.keys_, [&](const Key& key) { return simpleCurves(key.points, track.sizes_); })) {
      return track;
    }
  }
  return {Error::SectionInvalid, "it has too much fine detail"};
}

void SectionTrack::finish() {
  count_ = std::accumulate(sizes_.begin(), sizes_.end(), std::size_t{0});
  shortestEdge_ = std::numeric_limits<double>::infinity();
  hollow_ = sizes_.size() == 1;
  for (Key& key : keys_) {
    touchBothEnds(key.points);
    std::size_t first = 0;
    for (const std::size_t size : sizes_) {
      for (std::size_t i = 0; i < size; ++i) {
        shortestEdge_ = std::min(shortestEdge_, distance(key.points[first + i], key.points[first + (i + 1) % size]));
      }
      first += size;
    }
    key.starShaped = sizes_.size() == 1 && sections::hubOf(key.points).has_value();
    hollow_ = hollow_ && key.starShaped;
  }
  findSlopes();
}

SectionTrack::Place SectionTrack::placeAt(double share) const {
  const std::size_t last = keys_.size() - 1;
  const auto next = std::ranges::upper_bound(keys_, share, {}, &Key::at);
  const std::size_t to = static_cast<std::size_t>(next - keys_.begin());
  if (last == 0) return {};
  if (to > 0 && to <= last) {
    const Key& a = keys_[to - 1];
    const double f = sections::blendAt(a.blend, (share - a.at) / (keys_[to].at - a.at));
    return {to - 1, to, f};
  }
  if (!closed_) return to == 0 ? Place{0, 1, 0} : Place{last - 1, last, 1};
  const double gap = keys_[0].at + 1 - keys_[last].at;
  const double gone = share - keys_[last].at + (to == 0 ? 1 : 0);
  if (!(gap > geometry::kLeastStep)) return {last, 0, 0.5};
  return {last, 0, sections::blendAt(keys_[last].blend, std::clamp(gone / gap, 0.0, 1.0))};
}

/// Share of the spine from a key to the next one; of a closed one's last to the first.
double SectionTrack::spanAfter(std::size_t key) const {
  const double to = key + 1 < keys_.size() ? keys_[key + 1].at : keys_.front().at + 1;
  return std::max(to - keys_[key].at, geometry::kLeastStep);
}

void SectionTrack::findSlopes() {
  const std::size_t n = keys_.size();
  const bool flows = std::ranges::any_of(keys_, [](const Key& k) { return k.blend.kind == sections::BlendKind::Flow; });
  if (!flows || n < 2) return;
  for (std::size_t k = 0; k < n; ++k) {
    const bool first = !closed_ && k == 0, last = !closed_ && k + 1 == n;
    const std::size_t before = (k + n - 1) % n, after = (k + 1) % n;
    keys_[k].slopes.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const auto at = [&](std::size_t key) { return keys_[key].points[i]; };
      SectionPoint& slope = keys_[k].slopes[i];
      if (n == 2 && !closed_) {
        slope = (at(1) - at(0)) / spanAfter(0);
      } else if (first) {
        slope = geometry::parabolaEndSlope(at(0), at(1), at(2), spanAfter(0), spanAfter(1));
      } else if (last) {
        slope = -geometry::parabolaEndSlope(at(k), at(k - 1), at(k - 2), spanAfter(k - 1), spanAfter(k - 2));
      } else {
        slope = geometry::parabolaSlope(at(before), at(k), at(after), spanAfter(before), spanAfter(k));
      }
    }
  }
  constexpr int kPulls = 4, kProbes = 24;
  for (std::size_t k = 0; k + (closed_ ? 0 : 1) < n; ++k) {
    if (keys_[k].blend.kind != sections::BlendKind::Flow) continue;
    const auto sound = [&] {
      for (int i = 1; i < kProbes; ++i) {
        if (!isSound({k, (k + 1) % n, static_cast<double>(i) / kProbes})) return false;
      }
      return true;
    };
    for (int i = 0; i < kPulls && !sound(); ++i) keys_[k].pull = i + 1 < kPulls ? keys_[k].pull / 2 : 0;
  }
}

void SectionTrack::blended(const Place& place, Curve& out) const {
  const Key& key = keys_[place.from];
  const Curve &a = key.points, &b = keys_[place.to].points;
  out.resize(count_);
  if (key.blend.kind == sections::BlendKind::Flow && place.f > 0 && place.f < 1) {
    const double reach = spanAfter(place.from) * key.pull;
    const Curve &m = key.slopes, &n = keys_[place.to].slopes;
    for (std::size_t i = 0; i < count_; ++i) {
      out[i] = geometry::hermite(a[i], b[i], m[i] * reach, n[i] * reach, place.f);
    }
    return;
  }
  for (std::size_t i = 0; i < count_; ++i) {
    out[i] = place.f == 0 ? a[i] : place.f == 1 ? b[i] : lerp(a[i], b[i], place.f);
  }
}

bool SectionTrack::isSound(const Place& place) const {
  if (place.f == 0 || place.f == 1) return true;
  Curve curve;
  blended(place, curve);
  const auto [low, high] = std::ranges::minmax_element(curve, {}, &SectionPoint::x);
  if (!(high->x - low->x > 0.2) || !simpleCurves(curve, sizes_)) return false;
  std::size_t first = 0;
  for (const std::size_t size : sizes_) {
    const auto area = [&](const Curve& of) {
      return geometry::signedArea(std::span<const SectionPoint>(of).subspan(first, size));
    };
    if (area(curve) * area(keys_[place.from].points) <= 0) return false;
    first += size;
  }
  return true;
}

double SectionTrack::soundBlend(Place place) const {
  const double wanted = place.f;
  if (isSound(place)) return wanted;
  constexpr int kSteps = 48;
  const double nearest = std::clamp(wanted, 0.0, 1.0);
  for (int k = 0; k <= kSteps; ++k) {
    const double step = static_cast<double>(k) / kSteps;
    const bool up = nearest >= 0.5;
    for (const double f : {up ? nearest + step : nearest - step, up ? nearest - step : nearest + step}) {
      if (f < 0 || f > 1) continue;
      place.f = f;
      if (isSound(place)) return f;
    }
  }
  return nearest < 0.5 ? 0 : 1;
}

void SectionTrack::appendShape(double share, Curve& out) const {
  const Place place = placeAt(share);
  Curve mixed;
  if (varies()) {
    blended({place.from, place.to, soundBlend(place)}, mixed);
    touchBothEnds(mixed);
  }
  const Curve& curve = varies() ? mixed : keys_.front().points;
  const SectionPoint middle = geometry::centroid(std::span(curve).first(sizes_.front()));
  const SectionPoint hub = sizes_.size() == 1 ? sections::hubOf(curve).value_or(middle) : middle;
  out.insert(out.end(), curve.begin(), curve.end());
  out.push_back(hub);
}

double SectionTrack::progress(double share) const {
  if (!varies()) return 0;
  constexpr double kSteps = 12;  // rings from one key to the next
  const Place place = placeAt(share);
  return kSteps * (static_cast<double>(place.from) + std::clamp(place.f, -1.0, 2.0));
}

Result<sections::SectionShape> sectionAt(std::span<const SectionKey> keys, double at) {
  const Result<SectionTrack> track = SectionTrack::along(keys, kPointsAt, false);
  if (!track) return track.failure();
  std::vector<SectionPoint> points;
  track.value().appendShape(at, points);
  sections::SectionShape shape;
  auto next = points.begin();
  for (const std::size_t size : track.value().sizes()) {
    const auto end = next + static_cast<std::ptrdiff_t>(size);
    shape.contours.emplace_back(next, end);
    next = end;
  }
  return shape;
}

}  // namespace spineloft::loft
