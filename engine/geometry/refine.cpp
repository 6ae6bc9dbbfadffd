#include "engine/geometry/refine.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "engine/geometry/triangulate.h"

namespace spineloft::geometry {
namespace {

/// Triangles flatter than this (twice the area over the longest side squared) are never made.
constexpr double kFlat = 1e-9;
/// An edge is flipped when the opposite angles exceed 180° by this much; less is rounding.
constexpr double kClearlyWorse = 1e-10;
constexpr std::size_t kCells = 1024;

double area2(SectionPoint a, SectionPoint b, SectionPoint c) { return cross(b - a, c - a); }

double length2(SectionPoint v) { return dot(v, v); }

bool isSound(SectionPoint a, SectionPoint b, SectionPoint c) {
  const double longest = std::max({length2(b - a), length2(c - b), length2(a - c)});
  return area2(a, b, c) > kFlat * longest;
}

}  // namespace

PlaneMesh::PlaneMesh(std::span<const SectionPoint> points, std::span<const std::size_t> sizes)
    : points_(points.begin(), points.end()), rim_(points.size()) {
  if (points_.empty()) return;
  triangles_ = triangulate(points, sizes);
  if (triangles_.empty()) return;
  pairUp();
  SectionPoint high = low_ = points_[0];
  for (const SectionPoint p : points_) {
    low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double width = high.x - low_.x, height = high.y - low_.y;
  cell_ = std::max(std::sqrt(width * height / kCells), std::max(width, height) / kCells);
  if (!(cell_ > 0)) cell_ = 1;
  across_ = static_cast<std::size_t>(width / cell_) + 1;
  hints_.assign(across_ * (static_cast<std::size_t>(height / cell_) + 1), kNone);
  for (std::uint32_t h = 0; h < twins_.size(); ++h) doubtful_.push_back(h);
  legalise();
}

void PlaneMesh::pairUp() {
  twins_.assign(3 * triangles_.size(), kNone);
  std::unordered_map<std::uint64_t, std::uint32_t> open;
  const auto key = [](std::uint32_t a, std::uint32_t b) { return (static_cast<std::uint64_t>(a) << 32) | b; };
  for (std::uint32_t h = 0; h < twins_.size(); ++h) {
    const std::uint32_t a = from(h), b = from(next(h));
    const auto other = open.find(key(b, a));
    if (other == open.end()) {
      open.emplace(key(a, b), h);
    } else {
      link(h, other->second);
    }
  }
}

void PlaneMesh::link(std::uint32_t h, std::uint32_t twin) {
  twins_[h] = twin;
  if (twin != kNone) twins_[twin] = h;
}

PlaneMesh::Quad PlaneMesh::quadOf(std::uint32_t h) const {
  return {from(h), from(next(h)), from(last(h)), from(last(twins_[h]))};
}

bool PlaneMesh::canFlip(std::uint32_t h) const {
  const auto [a, b, c, d] = quadOf(h);
  return isSound(points_[c], points_[d], points_[b]) && isSound(points_[d], points_[c], points_[a]);
}

bool PlaneMesh::wantsFlip(std::uint32_t h) const {
  // Lawson: the angles opposite the edge sum to more than 180°.
  const auto [a, b, c, d] = quadOf(h);
  const SectionPoint ca = points_[a] - points_[c], cb = points_[b] - points_[c];
  const SectionPoint da = points_[a] - points_[d], db = points_[b] - points_[d];
  const double sineC = std::abs(cross(ca, cb)), sineD = std::abs(cross(da, db));
  const double cosineC = dot(ca, cb), cosineD = dot(da, db);
  const double scale = (sineC + std::abs(cosineC)) * (sineD + std::abs(cosineD));
  return sineC * cosineD + cosineC * sineD < -kClearlyWorse * scale;
}

// (a, b, c) and (b, a, d) become (d, c, a)… in place: triangle of h: c, d, b; of its twin: d, c, a.
void PlaneMesh::flip(std::uint32_t h) {
  const std::uint32_t twin = twins_[h];
  const auto [a, b, c, d] = quadOf(h);
  const std::uint32_t bc = twins_[next(h)], ca = twins_[last(h)];
  const std::uint32_t ad = twins_[next(twin)], db = twins_[last(twin)];
  const std::uint32_t t = h / 3, u = twin / 3;
  triangles_[t] = {c, d, b};
  triangles_[u] = {d, c, a};
  link(3 * t, 3 * u);
  link(3 * t + 1, db);
  link(3 * t + 2, bc);
  link(3 * u + 1, ca);
  link(3 * u + 2, ad);
}

void PlaneMesh::legalise() {
  // Each flip makes the triangulation better (Lawson 1977), so that it ends; the bound is for rounding.
  std::size_t left = 64 * triangles_.size() + 1024;
  while (!doubtful_.empty() && left > 0) {
    const std::uint32_t h = doubtful_.back();
    doubtful_.pop_back();
    if (twins_[h] == kNone || !wantsFlip(h) || !canFlip(h)) continue;
    const std::uint32_t t = h / 3, u = twins_[h] / 3;
    flip(h);
    --left;
    for (const std::uint32_t edge : {3 * t + 1, 3 * t + 2, 3 * u + 1, 3 * u + 2}) {
      doubtful_.push_back(edge);
    }
  }
  doubtful_.clear();
}

std::size_t PlaneMesh::bucketOf(SectionPoint p) const {
  const auto step = [&](double at) {
    return at > 0 ? static_cast<std::size_t>(std::min(at / cell_, 1e6)) : std::size_t{0};
  };
  const std::size_t x = std::min(step(p.x - low_.x), across_ - 1);
  const std::size_t rows = hints_.size() / across_;
  return std::min(step(p.y - low_.y), rows - 1) * across_ + x;
}

/// Towards p through the triangles; kNone when the rim is in the way.
std::uint32_t PlaneMesh::walk(SectionPoint p, std::uint32_t start) const {
  std::uint32_t t = start, came = kNone;
  for (std::size_t step = 0; step < triangles_.size(); ++step) {
    std::uint32_t out = kNone;
    for (std::uint32_t c = 0; c < 3; ++c) {
      // Begins at another corner every time, so that no walk goes in circles for ever.
      const std::uint32_t h = 3 * t + static_cast<std::uint32_t>((c + step) % 3);
      if (h == came || area2(points_[from(h)], points_[from(next(h))], p) >= 0) continue;
      out = h;
      break;
    }
    if (out == kNone) return t;
    came = twins_[out];
    if (came == kNone) return kNone;
    t = came / 3;
  }
  return kNone;
}

std::optional<std::uint32_t> PlaneMesh::find(SectionPoint p, std::uint32_t near) const {
  if (triangles_.empty() || !isFinite(p)) return std::nullopt;
  const std::uint32_t close = near == kNone ? kNone : walk(p, near);
  if (close != kNone) return close;
  // From the last triangle near by, then from others round it: the rim may stand between it and p.
  const auto bucket = static_cast<std::ptrdiff_t>(bucketOf(p));
  const auto across = static_cast<std::ptrdiff_t>(across_);
  for (const std::ptrdiff_t step : {std::ptrdiff_t{0}, std::ptrdiff_t{1}, std::ptrdiff_t{-1}, across, -across}) {
    const std::ptrdiff_t at = bucket + step;
    if (at < 0 || at >= static_cast<std::ptrdiff_t>(hints_.size())) continue;
    const std::uint32_t hint = hints_[static_cast<std::size_t>(at)];
    const std::uint32_t found = hint == kNone ? kNone : walk(p, hint);
    if (found != kNone) return found;
  }
  const std::uint32_t found = walk(p, 0);
  if (found != kNone) return found;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    const auto [a, b, c] = triangles_[t];
    const bool in = area2(points_[a], points_[b], p) >= 0 && area2(points_[b], points_[c], p) >= 0 &&
                    area2(points_[c], points_[a], p) >= 0;
    if (in) return t;
  }
  return std::nullopt;
}

void PlaneMesh::splitTriangle(std::uint32_t t, std::uint32_t p) {
  const auto [a, b, c] = triangles_[t];
  const std::uint32_t ab = twins_[3 * t], bc = twins_[3 * t + 1], ca = twins_[3 * t + 2];
  const auto u = static_cast<std::uint32_t>(triangles_.size()), v = u + 1;
  triangles_[t] = {a, b, p};
  triangles_.push_back({b, c, p});
  triangles_.push_back({c, a, p});
  twins_.resize(3 * triangles_.size(), kNone);
  link(3 * t, ab);
  link(3 * u, bc);
  link(3 * v, ca);
  link(3 * t + 1, 3 * u + 2);
  link(3 * u + 1, 3 * v + 2);
  link(3 * v + 1, 3 * t + 2);
  for (const std::uint32_t edge : {3 * t, 3 * u, 3 * v}) doubtful_.push_back(edge);
}

void PlaneMesh::splitEdge(std::uint32_t h, std::uint32_t p) {
  const std::uint32_t twin = twins_[h], t = h / 3, u = twin / 3;
  const auto [a, b, c, d] = quadOf(h);
  const std::uint32_t bc = twins_[next(h)], ca = twins_[last(h)];
  const std::uint32_t ad = twins_[next(twin)], db = twins_[last(twin)];
  const auto v = static_cast<std::uint32_t>(triangles_.size()), w = v + 1;
  triangles_[t] = {a, p, c};
  triangles_[u] = {p, a, d};
  triangles_.push_back({p, b, c});
  triangles_.push_back({b, p, d});
  twins_.resize(3 * triangles_.size(), kNone);
  link(3 * t, 3 * u);
  link(3 * t + 1, 3 * v + 2);
  link(3 * t + 2, ca);
  link(3 * u + 1, ad);
  link(3 * u + 2, 3 * w + 1);
  link(3 * v, 3 * w);
  link(3 * v + 1, bc);
  link(3 * w + 2, db);
  for (const std::uint32_t edge : {3 * t + 2, 3 * u + 1, 3 * v + 1, 3 * w + 2}) {
    doubtful_.push_back(edge);
  }
}

std::optional<std::uint32_t> PlaneMesh::insert(SectionPoint p) {
  const std::optional<std::uint32_t> t = find(p);
  if (!t) return std::nullopt;
  const auto index = static_cast<std::uint32_t>(points_.size());
  const auto sound = [&](std::uint32_t h) { return isSound(points_[from(h)], points_[from(next(h))], p); };
  std::uint32_t flat = kNone;
  for (std::uint32_t h = 3 * *t; h < 3 * *t + 3; ++h) {
    if (sound(h)) continue;
    if (flat != kNone) return std::nullopt;  // on a corner
    flat = h;
  }
  if (flat == kNone) {
    points_.push_back(p);
    splitTriangle(*t, index);
  } else {
    const std::uint32_t twin = twins_[flat];
    if (twin == kNone || !sound(next(twin)) || !sound(last(twin)) || !sound(next(flat)) || !sound(last(flat))) {
      return std::nullopt;
    }
    points_.push_back(p);
    splitEdge(flat, index);
  }
  hints_[bucketOf(p)] = *t;
  legalise();
  return index;
}

void PlaneMesh::splitChords() {
  // A flip may make a new chord: again until there is none; the bound is for rounding.
  for (int round = 0; round < 4; ++round) {
    std::vector<std::array<std::uint32_t, 2>> chords;
    for (std::uint32_t h = 0; h < twins_.size(); ++h) {
      const std::uint32_t a = from(h), b = from(next(h));
      if (a < b && twins_[h] != kNone && b < rim_) chords.push_back({a, b});
    }
    if (chords.empty()) return;
    for (const auto& [a, b] : chords) insert((points_[a] + points_[b]) / 2);
  }
  // What flips keep bringing back is split as it stands.
  for (std::uint32_t h = 0; h < twins_.size(); ++h) {
    const std::uint32_t a = from(h), b = from(next(h));
    if (twins_[h] == kNone || a >= rim_ || b >= rim_) continue;
    points_.push_back((points_[a] + points_[b]) / 2);
    splitEdge(h, static_cast<std::uint32_t>(points_.size() - 1));
  }
  doubtful_.clear();
}

PlaneMesh::Fans PlaneMesh::fans() const {
  Fans fans;
  fans.first.assign(points_.size() + 1, 0);
  for (const Triangle& t : triangles_) {
    for (const std::uint32_t p : t) ++fans.first[p + 1];
  }
  for (std::size_t p = 0; p < points_.size(); ++p) fans.first[p + 1] += fans.first[p];
  fans.of.resize(3 * triangles_.size());
  std::vector<std::uint32_t> at(fans.first.begin(), fans.first.end() - 1);
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    for (const std::uint32_t p : triangles_[t]) fans.of[at[p]++] = t;
  }
  return fans;
}

void PlaneMesh::move(std::uint32_t point, SectionPoint to, std::span<const std::uint32_t> around) {
  if (point < rim_) return;
  const SectionPoint was = points_[point];
  for (double share = 1; share > 0.2; share *= 0.5) {
    points_[point] = lerp(was, to, share);
    const bool sound = std::ranges::all_of(around, [&](std::uint32_t t) {
      const auto [a, b, c] = triangles_[t];
      return isSound(points_[a], points_[b], points_[c]);
    });
    if (sound) return;
  }
  points_[point] = was;
}

}  // namespace spineloft::geometry
