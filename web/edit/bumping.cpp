#include "web/edit/bumping.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/geometry/polyline.h"
#include "engine/mesh/ray_hit.h"

namespace spineloft::app {
namespace {

constexpr double kUsualHeight =
    0.75;                        // of the radius: with an edge steep enough to be seen as one (mesh::kCreaseAngle)
constexpr double kOpen = 0.2;    // of its length: a ring's ends are not farther apart
constexpr double kThin = 0.012;  // of its length squared: the area within; of a circle 0.08, of a star 0.02
constexpr std::size_t kRingPoints = 48;
constexpr int kCells = 24;       // of the search for the deepest place, along each side
constexpr double kWidest = 0.3;  // of the size of its part
constexpr double kDeep = 0.8;    // of the depth of the deepest place: as good as that
constexpr double kAbove = 0.05;  // of the radius: a top is looked for from so far on the other side
constexpr int kCirclePoints = 32, kNarrower = 8;

/// A ring as it is seen along its normal (Newell's).
class FlatRing {
 public:
  explicit FlatRing(const std::vector<ModelPoint>& ring) {
    for (const ModelPoint p : ring) centre_ += p / static_cast<double>(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const ModelPoint a = ring[i], b = ring[(i + 1) % ring.size()];
      length_ += distance(a, b);
      normal_ += cross(a - centre_, b - centre_);
    }
    area_ = norm(normal_) / 2;
    normal_ = normalized(normal_);
    const ModelPoint other = std::abs(normal_.x) < 0.6 ? ModelPoint{1, 0, 0} : ModelPoint{0, 1, 0};
    u_ = normalized(cross(normal_, other));
    v_ = cross(normal_, u_);
    for (const ModelPoint p : ring) corners_.push_back(flat(p));
  }

  double area() const { return area_; }
  double length() const { return length_; }
  double radius() const { return length_ > 0 ? 2 * area_ / length_ : 0; }
  ModelPoint normal() const { return normal_; }
  ModelPoint centre() const { return centre_; }

  bool isSimple() const { return geometry::isSimple(corners_); }

  /// The middle of the places within that are farthest from it, of a grid; where that is not well within, as of a
  /// crescent, one of them.
  ModelPoint deepest() const {
    SectionPoint low = corners_[0], high = low;
    for (const SectionPoint p : corners_) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    std::vector<std::pair<double, SectionPoint>> cells;
    for (int row = 0; row < kCells; ++row) {
      for (int column = 0; column < kCells; ++column) {
        const SectionPoint p{std::lerp(low.x, high.x, (column + 0.5) / kCells),
                             std::lerp(low.y, high.y, (row + 0.5) / kCells)};
        cells.emplace_back(depth(p), p);
      }
    }
    const auto [most, deep] = *std::ranges::max_element(cells, {}, &std::pair<double, SectionPoint>::first);
    SectionPoint sum;
    double count = 0;
    for (const auto& [depthThere, p] : cells) {
      if (depthThere < kDeep * most) continue;
      sum += p;
      ++count;
    }
    const SectionPoint middle = sum / count, best = depth(middle) > most / 2 ? middle : deep;
    return centre_ + u_ * best.x + v_ * best.y;
  }

 private:
  SectionPoint flat(ModelPoint p) const { return {dot(p - centre_, u_), dot(p - centre_, v_)}; }
  double depth(SectionPoint p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners_.size(); ++i)
      least = std::min(least, geometry::distanceToSegment(p, corners_[i], corners_[(i + 1) % corners_.size()]));
    return geometry::holds(std::span<const SectionPoint>(corners_), p) ? least : -least;
  }

  ModelPoint centre_, normal_, u_, v_;
  std::vector<SectionPoint> corners_;  // along u_ and v_ from the centre
  double area_ = 0, length_ = 0;
};

}  // namespace

std::optional<std::vector<ModelPoint>> ringOf(const std::vector<ModelPoint>& line) {
  if (line.size() < 4) return std::nullopt;
  const std::span<const ModelPoint> points(line);
  const std::vector<double> lengths = geometry::arcLengths(points);
  // Its second half comes nearest to its beginning there.
  const auto half = std::ranges::lower_bound(lengths, lengths.back() / 2) - lengths.begin();
  const auto end = std::ranges::min_element(points.subspan(static_cast<std::size_t>(half)), {},
                                            [&](ModelPoint p) { return distance(p, line.front()); });
  const auto last = static_cast<std::size_t>(half + (end - points.subspan(static_cast<std::size_t>(half)).begin()));
  if (distance(*end, line.front()) > kOpen * lengths[last]) return std::nullopt;
  std::vector<ModelPoint> closed(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(last) + 1);
  closed.push_back(line.front());
  std::vector<ModelPoint> ring = geometry::resample(std::span<const ModelPoint>(closed), kRingPoints + 1);
  ring.pop_back();
  const FlatRing flat(ring);
  if (flat.area() < kThin * flat.length() * flat.length() || !flat.isSimple()) return std::nullopt;
  return ring;
}

std::optional<ModelPoint> topOf(const mesh::TriMesh& mesh, const std::vector<ModelPoint>& ring) {
  const FlatRing flat(ring);
  const ModelPoint middle = flat.deepest();
  std::optional<ModelPoint> top;
  for (const double way : {1.0, -1.0}) {
    const ModelPoint out = flat.normal() * way, from = middle - out * (kAbove * flat.radius());
    const double far = mesh::firstHit(mesh, from, out).far;
    if (!std::isfinite(far)) continue;
    const ModelPoint hit = from + out * far;
    if (!top || distance(hit, middle) < distance(*top, middle)) top = hit;
  }
  return top;
}

pull::Pull usualBump(const EditOptions& options, const std::vector<ModelPoint>& ring, ModelPoint top) {
  const double radius = FlatRing(ring).radius();
  pull::Pull bump{{top}, kUsualHeight * radius, {}, 0, options.pullSharp, ring};
  bump.radius = std::clamp(radius, pull::kLeastRadius, pull::kMostRadius);
  return bump;
}

void widenBump(pull::Pull& bump, double factor, double size) {
  const double most = std::max(bump.radius, kWidest * size);
  const double radius = std::clamp(bump.radius * factor, pull::kLeastRadius, most);
  const double by = radius / bump.radius;
  const ModelPoint middle = FlatRing(bump.ring).centre();
  pull::eachPlace(bump, [&](ModelPoint& p) { p = middle + (p - middle) * by; });
  bump.radius = radius;
}

std::vector<ModelPoint> circleInView(const PulledPart& part, const UiState& ui) {
  const Rect& view = ui.layout.solid;
  const WorldPoint eye = ui.camera.eye();
  const auto middle = surfaceUnder(part, {eye, rayThrough(ui.camera, view, view.centre())});
  if (!middle) return {};
  const pipeline::ToWorld& toWorld = part.copies.all[middle->copy];
  const WorldPoint centre = toWorld(middle->at), up = ui.camera.up();
  const WorldPoint right = normalized(cross(centre - eye, up));
  double radius = ui.edit.pullReach * sizeOf(*part.shape) * toWorld.scale;
  for (int tries = 0; tries < kNarrower; ++tries, radius *= 0.7) {
    std::vector<ModelPoint> ring;
    for (int i = 0; i < kCirclePoints; ++i) {
      const double a = 2 * std::numbers::pi * i / kCirclePoints;
      const WorldPoint towards = centre + right * (radius * std::cos(a)) + up * (radius * std::sin(a));
      const auto place = surfaceUnder(part, {eye, towards - eye});
      if (place && place->copy == middle->copy) ring.push_back(place->at);
    }
    if (ring.size() == kCirclePoints) return ring;
  }
  return {};
}

}  // namespace spineloft::app
