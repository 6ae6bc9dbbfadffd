#include "engine/loft/bands.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spineloft::loft {
namespace {

constexpr std::size_t kLanes = 4;

struct Point4 {
  Float4 x, y, z;
};
Point4 pointsAt(const RingPlanes& ring, std::size_t at) {
  return {load4(ring.plane(0) + at), load4(ring.plane(1) + at), load4(ring.plane(2) + at)};
}
Point4 operator-(const Point4& a, const Point4& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
Float4 squared(const Point4& v) { return v.x * v.x + v.y * v.y + v.z * v.z; }
Point4 choose(Int4 mask, const Point4& a, const Point4& b) {
  return {mask ? a.x : b.x, mask ? a.y : b.y, mask ? a.z : b.z};
}

float leastLane(Float4 v) { return std::min(std::min(v[0], v[1]), std::min(v[2], v[3])); }

void addTriangles(const Point4& a, const Point4& b, const Point4& c, Int4 held, WallTally& tally) {
  const Point4 u = b - a, v = c - a;
  const Float4 g = tally.ground(), za = a.z - g, zb = b.z - g, zc = c.z - g;
  const auto size = [](Float4 z) { return magnitude4(z); };
  tally.add({u.x, u.y, u.z, v.x, v.y, v.z, za + zb + zc, size(za) + size(zb) + size(zc)}, held);
}

}  // namespace

void RingPlanes::read(std::span<const std::array<float, 3>> positions, std::span<const std::size_t> sizes) {
  points_ = positions.size() + sizes.size();
  // Quads are read four at a time, with the next point of each.
  for (auto& plane : planes_) plane.resize(points_ + 2 * kLanes);
  std::size_t from = 0, to = 0;
  for (const std::size_t size : sizes) {
    for (std::size_t i = 0; i <= size; ++i, ++to) {
      const std::array<float, 3>& p = positions[from + (i < size ? i : 0)];
      for (std::size_t axis = 0; axis < 3; ++axis) planes_[axis][to] = p[axis];
    }
    from += size;
  }
  for (auto& plane : planes_) {
    for (std::size_t i = points_; i < plane.size(); ++i) plane[i] = plane[0];
  }
}

void WallTally::addVertices(const RingPlanes& ring) {
  for (std::size_t i = 0; i < ring.points(); i += kLanes) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Float4 p = load4(ring.plane(axis) + i);
      low_[axis] = least4(p, low_[axis]);
      high_[axis] = most4(p, high_[axis]);
    }
  }
}

void WallTally::add(const Four& t, Int4 held) {
  const Float4 xy = t.ux * t.vy, yx = t.uy * t.vx;
  const Float4 nx = t.uy * t.vz - t.uz * t.vy, ny = t.uz * t.vx - t.ux * t.vz, nz = xy - yx;
  const Float4 size = nx * nx + ny * ny + nz * nz;
  const Float4 u2 = t.ux * t.ux + t.uy * t.uy + t.uz * t.uz, v2 = t.vx * t.vx + t.vy * t.vy + t.vz * t.vz;
  constexpr float kSine = 1e-8f;  // squared: rounding is felt below this angle between the edges
  thin_ |= held & (size <= kSine * u2 * v2);
  least_ = (held & (size < least_)) ? size : least_;
  volume_ += held ? nz * t.height : all4(0);
  parts_ += held ? (magnitude4(xy) + magnitude4(yx)) * t.heights : all4(0);
}

mesh::Bounds WallTally::bounds() const {
  mesh::Bounds bounds;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    bounds.low[axis] = static_cast<double>(leastLane(low_[axis]));
    bounds.high[axis] = -static_cast<double>(leastLane(-high_[axis]));
  }
  return bounds;
}

bool WallTally::surelyLarger(double area) const {
  constexpr double kInHand = 2, kSmallest = 1e-30;  // below that single precision has nothing to say
  const auto least = static_cast<double>(leastLane(least_));
  return !any4(thin_) && least > kInHand * 4 * area * area && least > kSmallest;
}

double WallTally::volume() const { return static_cast<double>(sum4(volume_)) / 6; }

double WallTally::volumeError() const {
  constexpr double kRounding = 1e-3;  // of some ten thousand sums of numbers of 24 bits, with plenty in hand
  return kRounding * static_cast<double>(sum4(parts_)) / 6;
}

void makeWalls(const Band& band, std::span<const std::size_t> sizes, std::array<std::uint32_t, 3>* out,
               WallTally& sum) {
  constexpr float kTie = 1 + 1e-5f;
  WallTally tally = sum;  // in registers: `out` might otherwise lie in it
  std::size_t at = 0;
  std::uint32_t first = 0;
  for (const std::size_t size : sizes) {
    const auto count = static_cast<std::uint32_t>(size);
    for (std::uint32_t k = 0; k < count; k += kLanes, at += kLanes) {
      const Point4 a0 = pointsAt(band.a, at), a1 = pointsAt(band.a, at + 1);
      const Point4 b0 = pointsAt(band.b, at), b1 = pointsAt(band.b, at + 1);
      const Int4 straight = squared(a0 - b1) <= squared(a1 - b0) * kTie;
      const std::uint32_t left = std::min<std::uint32_t>(kLanes, count - k);
      const Int4 held = Int4{0, 1, 2, 3} < static_cast<std::int32_t>(left);
      addTriangles(a0, b0, choose(straight, b1, a1), held, tally);
      addTriangles(choose(straight, a0, a1), choose(straight, b1, b0), choose(straight, a1, b1), held, tally);
      for (std::uint32_t lane = 0; lane < left; ++lane, out += 2) {
        const std::uint32_t from = first + k + lane, to = k + lane + 1 < count ? from + 1 : first;
        const std::uint32_t ia0 = band.firstA + from, ia1 = band.firstA + to;
        const std::uint32_t ib0 = band.firstB + from, ib1 = band.firstB + to;
        const auto mask = static_cast<std::uint32_t>(straight[lane]);
        const auto pick = [mask](std::uint32_t a, std::uint32_t b) { return b ^ ((a ^ b) & mask); };
        out[0] = {ia0, ib0, pick(ib1, ia1)};
        out[1] = {pick(ia0, ia1), pick(ib1, ib0), pick(ia1, ib1)};
      }
    }
    at = at - (count + kLanes - 1) / kLanes * kLanes + size + 1;
    first += count;
  }
  sum = tally;
}

}  // namespace spineloft::loft
