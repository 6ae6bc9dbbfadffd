// reachOf: line and rim are cut into the mesh, then the vertices between follow.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <queue>
#include <tuple>
#include <utility>

#include "engine/geometry/polyline.h"
#include "engine/pull/cut_mesh.h"
#include "engine/pull/displacement.h"
#include "engine/pull/pull.h"

namespace spineloft::pull {
namespace {

constexpr double kEdges = 12;             // across the radius
constexpr double kMostTriangles = 12e3;   // within the radius, where long lines would ask for more
constexpr std::size_t kMostCuts = 60000;  // triangles that are added in all
constexpr double kSnap = 0.3;             // of an edge: a vertex that is so near to a cut slides onto it,
constexpr double kTouch = 0.05;           // and one that is so near and cannot lies on it
constexpr double kDetour = 1.3;           // a way along edges that is that much longer leads to another side
constexpr double kLongest = 1.4;          // of the edges that are wanted: halving leaves them shorter than it asks
constexpr double kMostShare = 0.8;        // of the farthest vertex: a radius leaves something where it is
constexpr std::size_t kMostSamples = 400;
constexpr double kFar = std::numeric_limits<double>::infinity();
constexpr double kNoPlace = -1;

class Reacher {
 public:
  Reacher(const mesh::TriMesh& mesh, const Pull& pull) : pull_(pull), cut_(mesh), radius_(pull.radius) {}

  Reach make() {
    layLine();
    if (line_.empty()) return unmoved();
    limitRadius();
    measure();
    closeDetours();
    refine(kLongest * edge_);
    if (near_.empty()) return unmoved();
    findNormals();
    cutLine();
    cutRim();
    return follow();
  }

 private:
  struct Sample {
    ModelPoint at, face, normal;  // on the surface; unit: of the triangle there, and of what is around
    std::uint32_t triangle = 0;
  };

  void layLine();
  void limitRadius();
  void measure();
  void refine(double edge);
  void closeDetours();
  void findNormals();
  void cutLine();
  void cutRim();
  Reach follow();
  Reach unmoved() { return {cut_.take(), {}, {}, {}}; }

  double toLine(ModelPoint p) const;
  bool isNear(std::uint32_t triangle) const;
  std::uint32_t terminal(std::uint32_t triangle) const;
  void addDistances();
  void mark(std::uint32_t vertex, double place);
  void insertEnd(const Sample& sample, double place);
  void cutSegment(std::size_t i, std::vector<std::uint32_t>& near);
  void cutEdge(std::uint32_t half, std::size_t i, ModelPoint side, std::vector<std::uint32_t>& near);
  std::vector<double> waysFrom(const std::vector<std::uint32_t>& sources) const;
  ModelPoint moveAt(double place) const;

  const Pull& pull_;
  CutMesh cut_;
  double radius_, edge_ = 0;
  std::vector<Sample> line_;
  std::vector<double> places_;       // arc length of every sample
  std::vector<double> distances_;    // of every vertex to the line
  std::vector<double> linePlace_;    // of vertices on the line, else kNoPlace
  std::vector<bool> open_;           // of triangles: refine may enter them
  std::vector<bool> rim_;            // of vertices: as far as the radius
  std::vector<std::uint32_t> near_;  // triangles within the radius
};

void Reacher::layLine() {
  std::vector<ModelPoint> centres;
  std::vector<double> sizes;
  for (std::uint32_t t = 0; t < cut_.triangles(); ++t) {
    const std::uint32_t h = 3 * t;
    const ModelPoint a = cut_.at(cut_.from(h)), b = cut_.at(cut_.from(h + 1)), c = cut_.at(cut_.from(h + 2));
    const ModelPoint centre = (a + b + c) / 3;
    centres.push_back(centre);
    sizes.push_back(std::max({distance(a, centre), distance(b, centre), distance(c, centre)}));
  }
  const std::span<const ModelPoint> drawn(pull_.line);
  const double length = geometry::arcLengths(drawn).back(), step = pull_.radius / kEdges;
  const std::size_t count =
      std::clamp(static_cast<std::size_t>(std::ceil(length / step)) + 1, std::size_t{2}, kMostSamples);
  const std::vector<ModelPoint> points =
      length > 0 ? geometry::resample(drawn, count) : std::vector<ModelPoint>{drawn.front()};
  for (const ModelPoint p : points) {
    Sample best;
    double least = kFar;
    for (std::uint32_t t = 0; t < cut_.triangles(); ++t) {
      if (distance(centres[t], p) - sizes[t] >= least) continue;
      const ModelPoint on = cut_.nearestOn(t, p);
      if (distance(on, p) >= least || dot(cut_.areaNormal(t), cut_.areaNormal(t)) <= 0) continue;
      least = distance(on, p);
      best = {on, normalized(cut_.areaNormal(t)), {}, t};
    }
    if (least < kFar && (line_.empty() || distance(line_.back().at, best.at) > 1e-3 * step)) line_.push_back(best);
  }
  places_.assign(line_.size(), 0.0);
  for (std::size_t i = 1; i < line_.size(); ++i) places_[i] = places_[i - 1] + distance(line_[i - 1].at, line_[i].at);
}

double Reacher::toLine(ModelPoint p) const {
  double least = distance(p, line_.front().at);
  for (std::size_t i = 1; i < line_.size(); ++i)
    least = std::min(least, geometry::distanceToSegment(p, line_[i - 1].at, line_[i].at));
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

void Reacher::addDistances() {
  while (distances_.size() < cut_.mesh().positions.size())
    distances_.push_back(toLine(cut_.at(static_cast<std::uint32_t>(distances_.size()))));
}

void Reacher::measure() {
  ModelPoint low = line_.front().at, high = low;
  for (const Sample& sample : line_) {
    low = {std::min(low.x, sample.at.x), std::min(low.y, sample.at.y), std::min(low.z, sample.at.z)};
    high = {std::max(high.x, sample.at.x), std::max(high.y, sample.at.y), std::max(high.z, sample.at.z)};
  }
  const double reach = radius_ + 2 * edge_;
  for (std::uint32_t v = 0; v < cut_.mesh().positions.size(); ++v) {
    const ModelPoint p = cut_.at(v);
    const bool maybe = p.x > low.x - reach && p.y > low.y - reach && p.z > low.z - reach && p.x < high.x + reach &&
                       p.y < high.y + reach && p.z < high.z + reach;
    distances_.push_back(maybe ? toLine(p) : kFar);
  }
}

// Whether the line comes within the radius of some place of a triangle; of a small one its corners tell.
bool Reacher::isNear(std::uint32_t triangle) const {
  const std::uint32_t h = 3 * triangle;
  for (std::uint32_t i = h; i < h + 3; ++i) {
    if (distances_[cut_.from(i)] < radius_ + edge_) return true;
  }
  if (cut_.length(cut_.longest(triangle)) < 3 * edge_) return false;
  return std::ranges::any_of(
      line_, [&](const Sample& sample) { return distance(cut_.nearestOn(triangle, sample.at), sample.at) < radius_; });
}

// The edge that is the longest one of both its triangles, on the way over longest edges (Rivara): to split it keeps
// triangles from getting thin.
std::uint32_t Reacher::terminal(std::uint32_t triangle) const {
  std::uint32_t half = cut_.longest(triangle);
  while (cut_.twin(half) != mesh::kNone) {
    const std::uint32_t next = cut_.longest(cut_.twin(half) / 3);
    if (next == cut_.twin(half)) break;
    half = next;
  }
  return half;
}

// Splits triangles near the line until their edges are as short as asked; near_ are those within the radius that the
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
  for (const Sample& sample : line_) add(sample.triangle);
  while (!work.empty()) {
    const std::uint32_t t = work.back();
    const bool isClose = isNear(t);
    if (isClose && cut_.triangles() < most && cut_.length(cut_.longest(t)) > edge) {
      const std::uint32_t half = terminal(t), across = cut_.twin(half);
      const auto first = static_cast<std::uint32_t>(cut_.triangles());
      if (cut_.split(half, 0.5) != mesh::kNone) {
        addDistances();
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
      const bool faces = std::ranges::any_of(line_, [&](const Sample& sample) {
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
  for (Sample& sample : line_) {  // the triangle that it lies in now
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
  for (Sample& sample : line_) {
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
  addDistances();
  linePlace_.resize(distances_.size(), kNoPlace);
  if (linePlace_[vertex] == kNoPlace) linePlace_[vertex] = place;
  distances_[vertex] = 0;
}

void Reacher::insertEnd(const Sample& sample, double place) {
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

void Reacher::cutLine() {
  insertEnd(line_.front(), 0);
  if (line_.size() == 1) return;
  insertEnd(line_.back(), places_.back());
  std::vector<std::uint32_t> near;
  for (const std::uint32_t t : near_) {
    const bool isClose = distances_[cut_.from(3 * t)] < 2 * edge_ || distances_[cut_.from(3 * t + 1)] < 2 * edge_ ||
                         distances_[cut_.from(3 * t + 2)] < 2 * edge_;
    if (isClose) near.push_back(t);
  }
  for (std::size_t i = 0; i + 1 < line_.size(); ++i) cutSegment(i, near);
}

// Shortest ways along edges from some vertices, within the radius.
std::vector<double> Reacher::waysFrom(const std::vector<std::uint32_t>& sources) const {
  std::vector<double> ways(distances_.size(), kFar);
  std::vector<std::vector<std::uint32_t>> next(distances_.size());
  for (const std::uint32_t t : near_) {
    for (std::uint32_t half = 3 * t; half < 3 * t + 3; ++half) next[cut_.from(half)].push_back(cut_.to(half));
  }
  using Entry = std::pair<double, std::uint32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (const std::uint32_t v : sources) queue.emplace(ways[v] = 0, v);
  while (!queue.empty()) {
    const auto [way, v] = queue.top();
    queue.pop();
    if (way > ways[v] || distances_[v] >= radius_) continue;
    for (const std::uint32_t other : next[v]) {
      const double longer = way + distance(cut_.at(v), cut_.at(other));
      if (longer < ways[other]) queue.emplace(ways[other] = longer, other);
    }
  }
  return ways;
}

void Reacher::cutRim() {
  addDistances();
  linePlace_.resize(distances_.size(), kNoPlace);
  std::vector<std::uint32_t> sources;
  for (std::uint32_t v = 0; v < linePlace_.size(); ++v) {
    if (linePlace_[v] != kNoPlace) sources.push_back(v);
  }
  const std::vector<double> ways = waysFrom(sources);
  rim_.assign(distances_.size(), true);
  for (std::size_t v = 0; v < ways.size(); ++v)
    rim_[v] = distances_[v] >= radius_ || ways[v] > kDetour * radius_ + 2 * edge_;
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
      if (rim_[in] || !rim_[out] || distances_[out] <= radius_) continue;
      if (!std::isfinite(distances_[out])) distances_[out] = toLine(cut_.at(out));
      double share = (radius_ - distances_[in]) / (distances_[out] - distances_[in]);
      for (int round = 0; round < 3; ++round) {
        const double there = toLine(lerp(cut_.at(in), cut_.at(out), share));
        const double slope = (there - distances_[in]) / share;
        if (slope > 0) share = std::clamp((radius_ - distances_[in]) / slope, kTouch / 2, 1.0);
      }
      const std::uint32_t across = cut_.twin(half);
      if (across == mesh::kNone || share > 1 - kTouch) continue;
      if (share > 1 - kSnap && cut_.slide(across, 1 - share)) {
        distances_[out] = radius_;
        continue;
      }
      if (linePlace_[in] == kNoPlace && (share < kTouch || (share < kSnap && cut_.slide(half, share)))) {
        distances_[in] = radius_;
        rim_[in] = true;
        continue;
      }
      const auto first = static_cast<std::uint32_t>(cut_.triangles());
      cut_.split(half, share);
      near_.insert(near_.end(), {first, first + 1});
      distances_.push_back(radius_);
      linePlace_.push_back(kNoPlace);
      rim_.push_back(true);
    }
  }
}

ModelPoint Reacher::moveAt(double place) const {
  std::size_t i = 0;
  while (i + 2 < line_.size() && places_[i + 1] < place) ++i;
  const Sample &a = line_[i], &b = line_[std::min(i + 1, line_.size() - 1)];
  const double step = distance(a.at, b.at), t = step > 0 ? (place - places_[i]) / step : 0;
  if (pull_.to.empty()) return normalized(lerp(a.normal, b.normal, t));
  const std::span<const ModelPoint> to(pull_.to);
  const std::vector<double> lengths = geometry::arcLengths(to);
  // To a single place the line goes as it is, with its middle there.
  if (lengths.back() <= 0) return to.front() - line_[line_.size() / 2].at;
  const double share = places_.back() > 0 ? place / places_.back() : 0;
  return geometry::pointAt(to, std::span<const double>(lengths), share * lengths.back()) - lerp(a.at, b.at, t);
}

Reach Reacher::follow() {
  Sheet sheet;
  std::vector<std::uint32_t> vertices;
  std::vector<std::uint32_t> local(cut_.mesh().positions.size(), mesh::kNone);
  const auto own = [&](std::uint32_t v) {
    if (local[v] != mesh::kNone) return local[v];
    const bool given = linePlace_[v] != kNoPlace;
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
  if (spread(sheet, pull_.crease)) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      if (sheet.roles[i] != Sheet::Role::Rim) reach.moved.push_back({vertices[i], sheet.moves[i]});
    }
  }
  for (std::uint32_t v = 0; v < linePlace_.size(); ++v) {
    if (linePlace_[v] != kNoPlace) reach.line.push_back(v);
  }
  std::ranges::sort(reach.line, {}, [&](std::uint32_t v) { return linePlace_[v]; });
  reach.out = line_[line_.size() / 2].normal;
  reach.mesh = cut_.take();
  return reach;
}

}  // namespace

Result<Reach> reachOf(const mesh::TriMesh& mesh, const Pull& pull) {
  if (Status checked = checkPulls({pull}); !checked.ok()) return checked.failure();
  if (mesh.triangles.empty()) return Reach{mesh, {}, {}, {}};
  try {
    return Reacher(mesh, pull).make();
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::pull
