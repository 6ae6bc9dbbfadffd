#include "engine/bridge/tube.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <utility>

#include "engine/geometry/frames.h"
#include "engine/geometry/hermite.h"

namespace spineloft::bridge {
namespace {

using geometry::Frame;

constexpr double kLeastStep = 1e-4;  // of the radius, from ring to ring

// A vector in the directions of a frame, and back.
ModelPoint inFrame(const Frame& frame, ModelPoint v) {
  return {dot(v, frame.across), dot(v, frame.depth), dot(v, frame.tangent)};
}
ModelPoint outOfFrame(const Frame& frame, ModelPoint v) {
  return frame.across * v.x + frame.depth * v.y + frame.tangent * v.z;
}

// The line that the middles of the rings follow, C(u), u = 0…1, with frames.
class Way {
 public:
  Way(const TubeEnd& from, const TubeEnd& to, double bow) {
    const ModelPoint chord = to.centre - from.centre;
    const ModelPoint start = from.out * slopeOf(from.out, chord, bow);
    const ModelPoint end = to.out * -slopeOf(to.out, -chord, bow);
    std::vector<ModelPoint> line;
    for (std::size_t i = 0; i <= kSteps; ++i) {
      const double u = static_cast<double>(i) / kSteps;
      line.push_back(geometry::hermite(from.centre, to.centre, start, end, u));
    }
    for (std::size_t i = 0; i < kSteps; ++i) length_ += distance(line[i], line[i + 1]);
    frames_ = geometry::minimalFrames(line, from.ring.front() - from.centre, false);
  }
  Frame at(double u) const {
    const double place = std::clamp(u, 0.0, 1.0) * kSteps;
    const auto i = std::min(static_cast<std::size_t>(place), kSteps - 1);
    return geometry::between(frames_[i], frames_[i + 1], place - static_cast<double>(i));
  }
  // The place at u, turned as that at `turned`.
  Frame at(double u, double turned) const {
    Frame frame = at(turned);
    frame.at = at(u).at;
    return frame;
  }
  double length() const { return length_; }

 private:
  // The slope of the cubic that follows the arc of a circle over a chord, which it leaves at the angle α to it:
  // |chord| / cos²(α / 2); times `bow`, as far as it turns at all: 1 + (bow − 1) · (1 − cos α).
  static double slopeOf(ModelPoint out, ModelPoint chord, double bow) {
    constexpr double kLeast = 0.2;  // α = 127°
    const double ahead = dot(out, normalized(chord)), turns = std::clamp(1 - ahead, 0.0, 1.0);
    return norm(chord) * (1 + (bow - 1) * turns) / std::max(kLeast, (1 + ahead) / 2);
  }

  static constexpr std::size_t kSteps = 48;
  std::vector<Frame> frames_;
  double length_ = 0;
};

// An end in the frame of its end of the way, turned so that its points begin at `first`.
struct Ring {
  std::vector<ModelPoint> offset, leave;
  Ring(const TubeEnd& end, const Frame& frame, std::size_t first) {
    const std::size_t n = end.ring.size();
    for (std::size_t i = 0; i < n; ++i) {
      offset.push_back(inFrame(frame, end.ring[(i + first) % n] - end.centre));
      leave.push_back(inFrame(frame, end.leave[(i + first) % n]));
    }
  }
};

// The point of the second ring that belongs to the first one's first: the sum of the squared distances is least.
std::size_t firstOf(const Ring& from, const Ring& to) {
  const std::size_t n = from.offset.size();
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t first = 0; first < n; ++first) {
    double sum = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const ModelPoint d = from.offset[i] - to.offset[(i + first) % n];
      sum += dot(d, d);
    }
    if (sum < least) least = sum, best = first;
  }
  return best;
}

// How far the tube goes along the surface at a rim, while it gets as thin as the waist. What leads ahead of the rim
// takes at most a share of the way, so that rings stay in their order.
double reachOf(const TubeEnd& end, double waist, double length) {
  constexpr double kMostOfWay = 0.9;
  double reach = (1 - waist) * end.radius;
  for (const ModelPoint& leave : end.leave) {
    const double ahead = dot(leave, end.out);
    if (ahead * reach > kMostOfWay * length) reach = kMostOfWay * length / ahead;
  }
  return reach;
}

// 0 at both ends, with the slope 4·power there; 1 in the middle, and the flatter the greater the power is.
double flareAt(double s, double power) { return 1 - std::pow(std::abs(1 - 2 * s), 2 * power); }

// From 0 to 1, at an even speed but for the first and the last `ease` of u, 0…0.5.
double eased(double u, double ease) {
  const double speed = 1 / (1 - ease);
  if (u < ease) return speed * u * u / (2 * ease);
  if (u > 1 - ease) return 1 - speed * (1 - u) * (1 - u) / (2 * ease);
  return speed * (u - ease / 2);
}

class Tube {
 public:
  explicit Tube(mesh::PictureSize picture) : picture_(picture) {}

  void addRing(const std::vector<ModelPoint>& ring) {
    for (const ModelPoint p : ring) add(p);
    if (mesh_.positions.size() == ring.size()) return;
    const auto n = static_cast<std::uint32_t>(ring.size());
    const auto last = static_cast<std::uint32_t>(mesh_.positions.size()) - 2 * n;
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = last + i, b = last + (i + 1) % n;
      if (apart(a, b + n) <= apart(b, a + n)) {
        mesh_.triangles.push_back({a, b, b + n});
        mesh_.triangles.push_back({a, b + n, a + n});
      } else {
        mesh_.triangles.push_back({a, b, a + n});
        mesh_.triangles.push_back({b, b + n, a + n});
      }
    }
  }
  /// From the ring that begins with vertex `first` to a point. `ahead`: the point is beyond it.
  void close(std::uint32_t first, std::uint32_t n, ModelPoint tip, bool ahead) {
    const std::uint32_t point = add(tip);
    for (std::uint32_t i = 0; i < n; ++i) {
      std::array<std::uint32_t, 3> triangle{point, first + (i + 1) % n, first + i};
      if (ahead) std::swap(triangle[1], triangle[2]);
      mesh_.triangles.push_back(triangle);
    }
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(mesh_.positions.size()); }
  mesh::TriMesh take() { return std::move(mesh_); }

 private:
  std::uint32_t add(ModelPoint p) {
    mesh_.positions.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    mesh_.uv.push_back(mesh::frontUv(p.x, p.y, picture_));
    return count() - 1;
  }
  double apart(std::uint32_t a, std::uint32_t b) const {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double d = static_cast<double>(mesh_.positions[a][i]) - static_cast<double>(mesh_.positions[b][i]);
      sum += d * d;
    }
    return sum;
  }

  mesh::PictureSize picture_;
  mesh::TriMesh mesh_;
};

// The least way from a point of a ring to that of the next one. Infinite where there is no first ring.
double stepBetween(const std::vector<ModelPoint>& a, const std::vector<ModelPoint>& b) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) least = std::min(least, distance(a[i], b[i]));
  return least;
}

// The surface between two rims: P(s, i), s = 0…1 along it, i a point of the rims.
class Surface {
 public:
  Surface(const TubeEnd& from, const TubeEnd& to, const BridgeParams& params, double flare)
      : way_(from, to, params.bow),
        start_(from, way_.at(0), 0),
        end_(to, way_.at(1), firstOf(start_, Ring(to, way_.at(1), 0))),
        waist_(1 - (1 - params.waist) * flare),
        before_(reachOf(from, waist_, way_.length())),
        behind_(reachOf(to, waist_, way_.length())),
        // It flares out over about a radius at each end, and turns less there, where it is widest: a diameter long.
        power_(std::max(1.0, 0.5 * std::sqrt(6 * way_.length() / (from.radius + to.radius)))),
        ease_(std::min(0.5, (from.radius + to.radius) / way_.length())) {}

  /// The ring at s, of every `step`-th point.
  void ringAt(double s, std::size_t step, std::vector<ModelPoint>& ring) const {
    // Round a flat rim the two add up to 1 − (1 − waist) · g, with the slope of g at the rim.
    const double u = s * s * (3 - 2 * s), g = flareAt(s, power_), thin = 1 - (1 - waist_) * g * g;
    const Frame frame = way_.at(u, eased(u, ease_));
    ring.clear();
    for (std::size_t i = 0; i < start_.offset.size(); i += step) {
      const ModelPoint offset = lerp(start_.offset[i], end_.offset[i], u) * thin;
      const ModelPoint left = lerp(start_.leave[i] * before_, end_.leave[i] * behind_, u) * (g * (1 - g));
      ring.push_back(frame.at + outOfFrame(frame, offset + left));
    }
  }
  /// Where its rings are, so that it turns by the same angle from one to the next, and by less at its rims.
  std::vector<double> rows() const;

 private:
  Way way_;
  Ring start_, end_;
  double waist_, before_, behind_, power_, ease_;
};

std::vector<double> Surface::rows() const {
  constexpr std::size_t kFine = 240, kColumns = 4;
  constexpr double kTurn = 5 * std::numbers::pi / 180, kFewest = 12, kMost = 72;
  const std::size_t step = start_.offset.size() / kColumns;
  // How far it has turned at each of many places; a little for its length, so that a straight one has rows, too.
  std::vector<double> places, turned{0};
  std::vector<ModelPoint> last, before, here;
  for (std::size_t k = 0; k <= kFine; ++k) {
    const double t = static_cast<double>(k) / kFine;
    places.push_back((1 - std::cos(std::numbers::pi * t)) / 2);
    std::swap(last, before);
    std::swap(before, here);
    ringAt(places.back(), step, here);
    if (k == 0) continue;
    turned.push_back(turned.back() + kTurn * kFewest / kFine);
    if (k == 1) continue;
    double most = 0;
    for (std::size_t i = 0; i < kColumns; ++i) {
      const ModelPoint a = before[i] - last[i], b = here[i] - before[i];
      most = std::max(most, std::atan2(norm(cross(a, b)), dot(a, b)));
    }
    turned.back() += most;
  }
  const double count = std::min(kMost, std::ceil(turned.back() / kTurn));
  std::vector<double> rows;
  const auto add = [&](double share) {
    const auto above = std::ranges::lower_bound(turned, share * turned.back());
    const auto k = std::clamp<std::ptrdiff_t>(above - turned.begin(), 1, static_cast<std::ptrdiff_t>(kFine));
    const auto i = static_cast<std::size_t>(k);
    const double part = (share * turned.back() - turned[i - 1]) / (turned[i] - turned[i - 1]);
    rows.push_back(std::lerp(places[i - 1], places[i], std::clamp(part, 0.0, 1.0)));
  };
  add(0);
  for (const double fine : {0.25, 0.5}) add(fine / count);
  for (double row = 1; row < count; ++row) add(row / count);
  for (const double fine : {0.5, 0.25}) add(1 - fine / count);
  add(1);
  return rows;
}

}  // namespace

mesh::TriMesh tubeBetween(const TubeEnd& from, const TubeEnd& to, const BridgeParams& params, double flare,
                          mesh::PictureSize picture) {
  const Surface surface(from, to, params, flare);
  Tube tube(picture);
  // Where it turns almost at once, rings lie on each other: of those the last one at the second rim counts, else the
  // first one.
  const double least = kLeastStep * std::min(from.radius, to.radius);
  std::vector<ModelPoint> ring, last, end;
  surface.ringAt(1, 1, end);
  for (const double s : surface.rows()) {
    surface.ringAt(s, 1, ring);
    if (s > 0 && s < 1 && (stepBetween(last, ring) < least || stepBetween(ring, end) < least)) continue;
    tube.addRing(ring);
    std::swap(last, ring);
  }
  const auto n = static_cast<std::uint32_t>(from.ring.size());
  const std::uint32_t foot = tube.count() - n;
  tube.close(0, n, from.lid, false);
  tube.close(foot, n, to.lid, true);
  return tube.take();
}

}  // namespace spineloft::bridge
