// reachOf: line and rim, the ring or what is as far as the radius, are cut into the mesh, then the vertices between
// follow.
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <new>
#include <numbers>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "engine/geometry/polyline.h"
#include "engine/mesh/cut_mesh.h"
#include "engine/pull/displacement.h"
#include "engine/pull/pull.h"
#include "engine/pull/ring.h"

namespace spineloft::pull {
namespace {

constexpr double kEdges = 12;             // across the radius
constexpr double kMostTriangles = 12e3;   // within the radius, where long lines would ask for more
constexpr std::size_t kMostCuts = 60000;  // triangles that are added in all
constexpr double kSnap = 0.3;             // of an edge: a vertex that is so near to a cut slides onto it,
constexpr double kTouch = 0.05;           // and one that is so near and cannot lies on it
constexpr double kDetour = 1.3;           // a way along edges that is that much longer leads to another side
constexpr double kFinest = 1.0 / 6.0;     // of the edges: those at a smooth ring, where the surface begins to bend
constexpr double kLongest = 1.4;          // of the edges that are wanted: halving leaves them shorter than it asks
constexpr double kMostShare = 0.8;        // of the farthest vertex: a radius leaves something where it is
constexpr double kLeastRing = kLeastRadius / 4;
constexpr double kThinnest = 0.005;  // of its length: a ring that is narrower has nothing within it
constexpr double kMostSamples = 400, kRingSamples = 128;
constexpr double kRimEdges = 1000;  // about as many has a smooth ring at most, however narrow it is
constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kNoPlace = -1;

class Reacher {
 public:
  Reacher(const mesh::TriMesh& mesh, const Pull& pull) : pull_(pull), cut_(mesh), radius_(pull.radius) {}

  Reach make() {
    const mesh::SurfacePlaces places(cut_.mesh());
    if (!pull_.ring.empty() && !layRing(places)) return unmoved();
    if (!layLines(places)) return unmoved();
    if (ring_) {
      ring_->turnTo(line_.front().at);
      addDepths();
    } else {
      limitRadius();
      measure();
      closeDetours();
    }
    refine(kLongest * edge_);
    if (near_.empty()) return unmoved();
    findNormals();
    cutLine(0, across_);
    if (across_ < line_.size()) cutLine(across_, line_.size());
    cutRim();
    return follow();
  }

 private:
  bool layLines(const mesh::SurfacePlaces& places);
  bool layRing(const mesh::SurfacePlaces& places);
  void limitRadius();
  void measure();
  void refine(double edge);
  void closeDetours();
  void findNormals();
  void cutLine(std::size_t first, std::size_t end);
  void cutRim();
  Reach follow();
  Reach unmoved() { return {cut_.take(), {}, {}, {}, {}}; }

  double toLine(ModelPoint p) const;
  bool isNear(std::uint32_t triangle) const;
  double fineness(std::uint32_t triangle) const;
  double depthAt(ModelPoint p) const { return ring_ ? ring_->depth(p) : radius_ - toLine(p); }
  void addDepths();
  void mark(std::uint32_t vertex, double place);
  void insertEnd(const mesh::SurfacePlace& sample, double place);
  void cutSegment(std::size_t i, std::vector<std::uint32_t>& near);
  void cutEdge(std::uint32_t half, std::size_t i, ModelPoint side, std::vector<std::uint32_t>& near);
  std::vector<double> waysFrom(const std::vector<std::uint32_t>& sources) const;
  ModelPoint moveAt(double place) const;

  const Pull& pull_;
  mesh::CutMesh cut_;
  double radius_, edge_ = 0;
  std::vector<mesh::SurfacePlace> line_, ringLine_;  // of the line and, behind it, of the one across
  std::size_t across_ = 0;                           // the first one of that
  std::optional<Ring> ring_;
  std::vector<double> places_;       // arc length of every sample; both lines make one scale
  std::vector<double> depths_;       // of every vertex: how far within the rim it is; < 0: outside
  std::vector<double> linePlace_;    // of vertices on a line, else kNoPlace
  std::vector<bool> open_;           // of triangles: refine may enter them
  std::vector<bool> rim_;            // of vertices: on the rim or outside
  std::vector<std::uint32_t> near_;  // triangles within the rim
};

// Evenly spaced points of a line; a single one where it has no length.
std::vector<ModelPoint> spaced(std::span<const ModelPoint> line, double step) {
  const double length = geometry::arcLengths(line).back();
  const double count = std::clamp(std::ceil(length / step) + 1, 2.0, kMostSamples);
  return length > 0 ? geometry::resample(line, static_cast<std::size_t>(count)) : std::vector<ModelPoint>{line.front()};
}

// The points of a closed line, with more between them.
std::vector<ModelPoint> finer(const std::vector<ModelPoint>& ring, double step) {
  std::vector<ModelPoint> points;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const ModelPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const double count = std::max(1.0, std::ceil(distance(a, b) / step));
    for (double k = 0; k < count; ++k) points.push_back(lerp(a, b, k / count));
  }
  return points;
}

// Whether there is a surface to lay them on.
bool Reacher::layLines(const mesh::SurfacePlaces& places) {
  const double step = ring_ ? edge_ : radius_ / kEdges, apart = 1e-3 * step;
  line_ = places.lay(spaced(pull_.line, step), apart);
  across_ = line_.size();
  if (!pull_.across.empty())
    std::ranges::copy(places.lay(spaced(pull_.across, step), apart), std::back_inserter(line_));
  places_.assign(line_.size(), 0.0);
  for (std::size_t i = 1; i < line_.size(); ++i)
    places_[i] = places_[i - 1] + (i == across_ ? 1 : distance(line_[i - 1].at, line_[i].at));
  return across_ > 0;
}

// Whether there is room within the ring.
bool Reacher::layRing(const mesh::SurfacePlaces& places) {
  std::vector<ModelPoint> closed = pull_.ring;
  closed.push_back(closed.front());
  const double step = geometry::arcLengths(std::span<const ModelPoint>(closed)).back() / kRingSamples;
  if (!(step > 0)) return false;
  ringLine_ = places.lay(finer(pull_.ring, step), 1e-3 * step);
  if (ringLine_.size() < 3) return false;
  std::vector<Ring::Corner> corners;
  for (const mesh::SurfacePlace& sample : ringLine_)
    corners.push_back({sample.at, places.meanNormal(sample.at, 1e-3 * step)});
  ring_.emplace(corners);
  radius_ = 2 * ring_->area() / ring_->length();  // of a circle its own
  if (!(radius_ > kThinnest * ring_->length() && radius_ > kLeastRing)) return false;
  edge_ = std::max(radius_ / kEdges, std::sqrt(ring_->area() / (0.43 * kMostTriangles)));
  return true;
}

double Reacher::toLine(ModelPoint p) const {
  double least = distance(p, line_.front().at);
  for (std::size_t i = 1; i < line_.size(); ++i) {
    const ModelPoint from = line_[i == across_ ? i : i - 1].at;
    least = std::min(least, geometry::distanceToSegment(p, from, line_[i].at));
  }
  return least;
}

void Reacher::limitRadius() {
  double farthest = 0;
  for (std::uint32_t v = 0; v < cut_.mesh().positions.size() && farthest * kMostShare < radius_; ++v)
    farthest = std::max(farthest, toLine(cut_.at(v)));
  radius_ = std::min(radius_, kMostShare * farthest);
  const double area = (2 * places_.back() + std::numbers::pi * radius_) * radius_;
  edge_ = std::max(radius_ / kEdges, std::sqrt(area / (0.43 * kMostTriangles)));  // 0.43 of the square: even triangles
}

void Reacher::addDepths() {
  while (depths_.size() < cut_.mesh().positions.size())
    depths_.push_back(depthAt(cut_.at(static_cast<std::uint32_t>(depths_.size()))));
}

void Reacher::measure() {
  ModelPoint low = line_.front().at, high = low;
  for (const mesh::SurfacePlace& sample : line_) {
    low = {std::min(low.x, sample.at.x), std::min(low.y, sample.at.y), std::min(low.z, sample.at.z)};
    high = {std::max(high.x, sample.at.x), std::max(high.y, sample.at.y), std::max(high.z, sample.at.z)};
  }
  const double reach = radius_ + 2 * edge_;
  for (std::uint32_t v = 0; v < cut_.mesh().positions.size(); ++v) {
    const ModelPoint p = cut_.at(v);
    const bool maybe = p.x > low.x - reach && p.y > low.y - reach && p.z > low.z - reach && p.x < high.x + reach &&
                       p.y < high.y + reach && p.z < high.z + reach;
    depths_.push_back(maybe ? depthAt(p) : -kFar);
  }
}

// Whether some place of a triangle is within the rim, or close to it; of a small one its corners tell.
bool Reacher::isNear(std::uint32_t triangle) const {
  const std::uint32_t h = 3 * triangle;
  for (std::uint32_t i = h; i < h + 3; ++i) {
    if (depths_[cut_.from(i)] > -edge_) return true;
  }
  if (cut_.length(cut_.longest(triangle)) < 3 * edge_) return false;
  const double reach = ring_ ? edge_ : radius_;
  const auto isClose = [&](const mesh::SurfacePlace& sample) {
    return distance(cut_.nearestOn(triangle, sample.at), sample.at) < reach;
  };
  return std::ranges::any_of(line_, isClose) || std::ranges::any_of(ringLine_, isClose);
}

// How long edges are, in shares of what is wanted: shorter towards a smooth ring.
double Reacher::fineness(std::uint32_t triangle) const {
  if (!ring_ || pull_.crease) return 1;
  double least = kFar;
  for (const std::uint32_t v : cut_.mesh().triangles[triangle]) least = std::min(least, std::abs(depths_[v]));
  const double finest = std::clamp(ring_->length() / kRimEdges / edge_, kFinest, 1.0);
  return std::clamp(least / (radius_ / 8), finest, 1.0);
}

// Splits triangles near the line until their edges are as short as asked; near_ are those within the rim that the
// surface leads to from the line over triangles that `open_` lets in.
void Reacher::refine(double edge) {
  const std::size_t most = cut_.triangles() + kMostCuts;
  near_.clear();
  std::vector<std::uint32_t> work;
  std::vector<bool> seen(cut_.triangles(), false);
  const auto add = [&](std::uint32_t triangle) {
    seen.resize(std::max(seen.size(), cut_.triangles()), false);
    if (!seen[triangle] && open_[triangle]) work.push_back(triangle);
    seen[triangle] = true;
  };
  open_.resize(cut_.triangles(), true);
  for (const mesh::SurfacePlace& sample : line_) add(sample.triangle);
  while (!work.empty()) {
    const std::uint32_t t = work.back();
    const bool isClose = isNear(t);
    if (isClose && cut_.triangles() < most && cut_.length(cut_.longest(t)) > edge * fineness(t)) {
      const std::uint32_t half = cut_.terminal(t), across = cut_.twin(half);
      const auto first = static_cast<std::uint32_t>(cut_.triangles());
      if (cut_.split(half, 0.5) != mesh::kNone) {
        addDepths();
        open_.push_back(open_[half / 3]);
        open_.push_back(open_[across / 3]);
        for (const std::uint32_t other : {half / 3, across / 3, first, first + 1}) add(other);
        continue;
      }
    }
    work.pop_back();
    if (!isClose) continue;
    near_.push_back(t);
    for (std::uint32_t half = 3 * t; half < 3 * t + 3; ++half) {
      if (cut_.twin(half) != mesh::kNone) add(cut_.twin(half) / 3);
    }
  }
  std::ranges::sort(near_);
  const auto again = std::ranges::unique(near_);
  near_.erase(again.begin(), again.end());
}

// Of what lies within the radius, what the surface leads to on a way that is not much longer: the other side of a thin
// piece is left out.
void Reacher::closeDetours() {
  const double coarse = std::max(radius_ / 3, kLongest * edge_);
  refine(coarse);
  std::vector<std::uint32_t> sources;
  for (const std::uint32_t t : near_) {
    for (std::uint32_t half = 3 * t; half < 3 * t + 3; ++half) {
      const std::uint32_t v = cut_.from(half);
      const bool faces = std::ranges::any_of(line_, [&](const mesh::SurfacePlace& sample) {
        return distance(sample.at, cut_.at(v)) < coarse && dot(cut_.areaNormal(t), sample.face) > 0;
      });
      if (faces) sources.push_back(v);
    }
  }
  const std::vector<double> ways = waysFrom(sources);
  for (const std::uint32_t t : near_) {
    const auto& corners = cut_.mesh().triangles[t];
    const double way = std::min({ways[corners[0]], ways[corners[1]], ways[corners[2]]});
    open_[t] = way <= kDetour * radius_ + coarse;
  }
  for (mesh::SurfacePlace& sample : line_) {  // the triangle that it lies in now
    double least = kFar;
    for (const std::uint32_t t : near_) {
      const double away = distance(cut_.nearestOn(t, sample.at), sample.at);
      if (away < least && dot(cut_.areaNormal(t), sample.face) > 0)
        std::tie(sample.triangle, least) = std::pair(t, away);
    }
  }
}

void Reacher::findNormals() {
  const double reach = radius_ / 2;
  for (mesh::SurfacePlace& sample : line_) {
    ModelPoint sum = sample.face * (1e-9 * reach * reach);
    for (const std::uint32_t t : near_) {
      const std::uint32_t h = 3 * t;
      const double away =
          distance((cut_.at(cut_.from(h)) + cut_.at(cut_.from(h + 1)) + cut_.at(cut_.from(h + 2))) / 3, sample.at);
      const ModelPoint normal = cut_.areaNormal(t);
      const double facing = dot(normalized(normal), sample.face);
      if (away < reach && facing > 0) sum += normal * (facing * (1 - away / reach));
    }
    sample.normal = normalized(sum);
  }
}

void Reacher::mark(std::uint32_t vertex, double place) {
  addDepths();
  linePlace_.resize(depths_.size(), kNoPlace);
  if (linePlace_[vertex] == kNoPlace) linePlace_[vertex] = place;
  depths_[vertex] = depthAt(cut_.at(vertex));
}

void Reacher::insertEnd(const mesh::SurfacePlace& sample, double place) {
  std::uint32_t best = near_.front();
  double least = kFar;
  for (const std::uint32_t t : near_) {
    const double away = distance(cut_.nearestOn(t, sample.at), sample.at);
    if (away < least && dot(cut_.areaNormal(t), sample.face) > 0) std::tie(best, least) = std::pair(t, away);
  }
  const std::array<std::uint32_t, 3> halves{3 * best, 3 * best + 1, 3 * best + 2};
  const auto away = [&](std::uint32_t half) { return distance(cut_.at(cut_.from(half)), sample.at); };
  const std::uint32_t nearest = *std::ranges::min_element(halves, {}, away);
  // Where triangles could not be made fine enough a corner stands for the place.
  if (away(nearest) < kTouch * edge_ || least > edge_) return mark(cut_.from(nearest), place);
  const auto first = static_cast<std::uint32_t>(cut_.triangles());
  for (const std::uint32_t half : halves) {
    const ModelPoint a = cut_.at(cut_.from(half)), b = cut_.at(cut_.to(half));
    const double share = dot(sample.at - a, b - a) / dot(b - a, b - a);
    if (distance(lerp(a, b, share), sample.at) > kTouch * edge_) continue;
    const std::uint32_t middle = cut_.split(half, std::clamp(share, kTouch, 1 - kTouch));
    if (middle == mesh::kNone) return mark(cut_.from(nearest), place);
    near_.insert(near_.end(), {first, first + 1});
    return mark(middle, place);
  }
  near_.insert(near_.end(), {first, first + 1});
  mark(cut_.splitTriangle(best, sample.at), place);
}

// An edge that the line crosses between two samples gets a vertex there.
void Reacher::cutEdge(std::uint32_t half, std::size_t i, ModelPoint side, std::vector<std::uint32_t>& near) {
  const std::uint32_t from = cut_.from(half), to = cut_.to(half);
  linePlace_.resize(cut_.mesh().positions.size(), kNoPlace);
  if (from > to || linePlace_[from] != kNoPlace || linePlace_[to] != kNoPlace) return;
  const ModelPoint start = line_[i].at, way = line_[i + 1].at - start, a = cut_.at(from), b = cut_.at(to);
  const double sideA = dot(a - start, side), sideB = dot(b - start, side);
  if ((sideA < 0) == (sideB < 0) || sideA == sideB) return;
  const double share = sideA / (sideA - sideB);
  const ModelPoint on = lerp(a, b, share);
  const double along = dot(on - start, way) / dot(way, way);
  if (along < 0 || along > 1 || distance(on, start + way * along) > edge_ / 2) return;
  const double place = places_[i] + along * (places_[i + 1] - places_[i]);
  if (share < kTouch || (share < kSnap && cut_.slide(half, share))) return mark(from, place);
  const std::uint32_t across = cut_.twin(half);
  if (across == mesh::kNone) return;
  if (share > 1 - kTouch || (share > 1 - kSnap && cut_.slide(across, 1 - share))) return mark(to, place);
  const auto first = static_cast<std::uint32_t>(cut_.triangles());
  const std::uint32_t middle = cut_.split(half, share);
  near.insert(near.end(), {first, first + 1});
  near_.insert(near_.end(), {first, first + 1});
  mark(middle, place);
}

void Reacher::cutSegment(std::size_t i, std::vector<std::uint32_t>& near) {
  const ModelPoint facing = line_[i].face + line_[i + 1].face;
  const ModelPoint side = normalized(cross(line_[i + 1].at - line_[i].at, facing));
  for (std::size_t k = 0; k < near.size(); ++k) {
    const std::uint32_t t = near[k];
    if (dot(cut_.areaNormal(t), facing) <= 0) continue;
    for (std::uint32_t half = 3 * t; half < 3 * t + 3; ++half) cutEdge(half, i, side, near);
  }
}

void Reacher::cutLine(std::size_t first, std::size_t end) {
  insertEnd(line_[first], places_[first]);
  if (end - first == 1) return;
  insertEnd(line_[end - 1], places_[end - 1]);
  std::vector<std::uint32_t> near;
  for (const std::uint32_t t : near_) {
    const auto isClose = [&](std::uint32_t v) { return toLine(cut_.at(v)) < 2 * edge_; };
    if (std::ranges::any_of(cut_.mesh().triangles[t], isClose)) near.push_back(t);
  }
  for (std::size_t i = first; i + 1 < end; ++i) cutSegment(i, near);
}

// Shortest ways along edges from some vertices, within the rim.
std::vector<double> Reacher::waysFrom(const std::vector<std::uint32_t>& sources) const {
  std::vector<double> ways(depths_.size(), kFar);
  std::vector<std::vector<std::uint32_t>> next(depths_.size());
  for (const std::uint32_t t : near_) {
    for (std::uint32_t half = 3 * t; half < 3 * t + 3; ++half) next[cut_.from(half)].push_back(cut_.to(half));
  }
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::uint32_t v : sources) queue.emplace(ways[v] = 0, v);
  while (!queue.empty()) {
    const auto [way, v] = queue.top();
    queue.pop();
    if (way > ways[v] || depths_[v] <= 0) continue;
    for (const std::uint32_t other : next[v]) {
      const double longer = way + distance(cut_.at(v), cut_.at(other));
      if (longer < ways[other]) queue.emplace(ways[other] = longer, other);
    }
  }
  return ways;
}

void Reacher::cutRim() {
  addDepths();
  linePlace_.resize(depths_.size(), kNoPlace);
  std::vector<std::uint32_t> sources;
  for (std::uint32_t v = 0; v < linePlace_.size(); ++v) {
    if (linePlace_[v] != kNoPlace) sources.push_back(v);
  }
  const std::vector<double> ways = waysFrom(sources);
  const double longest = ring_ ? std::numeric_limits<double>::max() : kDetour * radius_ + 2 * edge_;
  rim_.assign(depths_.size(), true);
  const double onRim = ring_ ? 1e-9 * ring_->length() : 0;
  for (std::size_t v = 0; v < ways.size(); ++v) rim_[v] = depths_[v] <= onRim || ways[v] > longest;
  // What is left out keeps its corners.
  std::vector<bool> isNear(cut_.triangles(), false);
  for (const std::uint32_t t : near_) isNear[t] = true;
  for (std::uint32_t t = 0; t < cut_.triangles(); ++t) {
    for (const std::uint32_t v : cut_.mesh().triangles[t])
      rim_[v] = rim_[v] || (!isNear[t] && linePlace_[v] == kNoPlace);
  }
  for (std::size_t k = 0; k < near_.size(); ++k) {
    for (std::uint32_t half = 3 * near_[k]; half < 3 * near_[k] + 3; ++half) {
      const std::uint32_t in = cut_.from(half), out = cut_.to(half);
      if (rim_[in] || !rim_[out] || depths_[out] >= 0) continue;
      if (!std::isfinite(depths_[out])) depths_[out] = depthAt(cut_.at(out));
      double share = depths_[in] / (depths_[in] - depths_[out]);
      for (int round = 0; round < 3; ++round) {
        const double slope = (depths_[in] - depthAt(lerp(cut_.at(in), cut_.at(out), share))) / share;
        if (slope > 0) share = std::clamp(depths_[in] / slope, kTouch / 2, 1.0);
      }
      const std::uint32_t across = cut_.twin(half);
      if (across == mesh::kNone || share > 1 - kTouch) continue;
      if (share > 1 - kSnap && cut_.slide(across, 1 - share)) {
        depths_[out] = 0;
        continue;
      }
      if (linePlace_[in] == kNoPlace && (share < kTouch || (share < kSnap && cut_.slide(half, share)))) {
        depths_[in] = 0;
        rim_[in] = true;
        continue;
      }
      const auto first = static_cast<std::uint32_t>(cut_.triangles());
      cut_.split(half, share);
      near_.insert(near_.end(), {first, first + 1});
      depths_.push_back(0);
      linePlace_.push_back(kNoPlace);
      rim_.push_back(true);
    }
  }
}

ModelPoint Reacher::moveAt(double place) const {
  const bool second = across_ < line_.size() && place >= places_[across_];
  const std::size_t first = second ? across_ : 0, last = (second ? line_.size() : across_) - 1;
  std::size_t i = first;
  while (i + 1 < last && places_[i + 1] < place) ++i;
  const mesh::SurfacePlace &a = line_[i], &b = line_[std::min(i + 1, last)];
  const double step = distance(a.at, b.at), t = step > 0 ? (place - places_[i]) / step : 0;
  const std::span<const ModelPoint> to(second ? pull_.acrossTo : pull_.to);
  if (to.empty()) return normalized(lerp(a.normal, b.normal, t));
  const std::vector<double> lengths = geometry::arcLengths(to);
  // To a single place the line goes as it is, with its middle there.
  if (lengths.back() <= 0) return to.front() - line_[first + (last + 1 - first) / 2].at;
  const double length = places_[last] - places_[first], share = length > 0 ? (place - places_[first]) / length : 0;
  return geometry::pointAt(to, std::span<const double>(lengths), share * lengths.back()) - lerp(a.at, b.at, t);
}

Reach Reacher::follow() {
  const bool dome = ring_ && line_.size() == 1 && pull_.to.empty();  // no more is said of its shape than its height
  const ModelPoint out = line_[across_ / 2].normal;
  Sheet sheet;
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> local(cut_.mesh().positions.size(), mesh::kNone);
  const auto own = [&](std::uint32_t v) {
    if (local[v] != mesh::kNone) return local[v];
    const bool given = linePlace_[v] != kNoPlace && !(ring_ && (rim_[v] || dome));
    vertices.push_back(v);
    sheet.points.push_back(cut_.at(v));
    sheet.roles.push_back(given ? Sheet::Role::Given : rim_[v] ? Sheet::Role::Rim : Sheet::Role::Free);
    sheet.moves.push_back(given ? moveAt(linePlace_[v]) : ModelPoint{});
    return local[v] = static_cast<std::uint32_t>(vertices.size() - 1);
  };
  for (const std::uint32_t t : near_) {
    const std::array<std::uint32_t, 3> corners = cut_.mesh().triangles[t];
    if (rim_[corners[0]] && rim_[corners[1]] && rim_[corners[2]]) continue;
    sheet.triangles.push_back({own(corners[0]), own(corners[1]), own(corners[2])});
  }
  Reach reach;
  const Stiffness sharp = ring_ ? Stiffness::FreeAtRim : Stiffness::AlongLines;
  const Stiffness stiffness = pull_.crease ? sharp : Stiffness::Smooth;
  if (dome ? swell(sheet, stiffness, out) : spread(sheet, stiffness)) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (sheet.roles[i] != Sheet::Role::Rim) reach.moved.push_back({vertices[i], sheet.moves[i]});
    }
  }
  const double end = places_[across_ - 1];
  for (std::uint32_t v = 0; v < linePlace_.size(); ++v) {
    if (linePlace_[v] != kNoPlace && linePlace_[v] <= end) reach.line.push_back(v);
  }
  std::ranges::sort(reach.line, {}, [&](std::uint32_t v) { return linePlace_[v]; });
  for (const mesh::SurfacePlace& sample : ringLine_) reach.ring.push_back(sample.at);
  reach.out = out;
  reach.mesh = cut_.take();
  return reach;
}

}  // namespace

Result<Reach> reachOf(const mesh::TriMesh& mesh, const Pull& pull) {
  if (Status checked = checkPulls({pull}); !checked.ok()) return checked.failure();
  if (mesh.triangles.empty()) return Reach{mesh, {}, {}, {}, {}};
  try {
    return Reacher(mesh, pull).make();
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::pull
