#include "engine/mesh/thin_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::mesh {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

/// The triangles round each point, in the order in which they came, all in one list: a list a point would ask for
/// memory thousands of times.
class Fans {
 public:
  explicit Fans(const TriMesh& mesh) : places_(mesh.positions.size()) {
    for (const Triangle& t : mesh.triangles) {
      for (const std::uint32_t corner : t) ++places_[corner].room;
    }
    std::uint32_t first = 0;
    for (Place& place : places_) {
      place.first = first;
      place.room += kSpare;
      first += place.room;
    }
    all_.resize(first);
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t corner : mesh.triangles[t]) add(corner, t);
    }
  }

  /// Valid until something is added.
  std::span<const std::uint32_t> at(std::uint32_t point) const {
    const Place& place = places_[point];
    return {all_.data() + place.first, place.count};
  }
  void add(std::uint32_t point, std::uint32_t triangle) {
    Place& place = places_[point];
    if (place.count == place.room) {
      const auto moved = static_cast<std::uint32_t>(all_.size());
      place.room *= 2;
      all_.resize(moved + place.room);
      std::copy_n(all_.begin() + place.first, place.count, all_.begin() + moved);
      place.first = moved;
    }
    all_[place.first + place.count++] = triangle;
  }
  void leave(std::uint32_t point, std::uint32_t triangle) {
    Place& place = places_[point];
    const auto begin = all_.begin() + place.first, end = begin + place.count;
    place.count = static_cast<std::uint32_t>(std::remove(begin, end, triangle) - begin);
  }
  void clear(std::uint32_t point) { places_[point].count = 0; }

 private:
  static constexpr std::uint32_t kSpare = 2;
  struct Place {
    std::uint32_t first = 0, count = 0, room = 0;
  };
  std::vector<Place> places_;
  std::vector<std::uint32_t> all_;
};

double squared(const ModelPoint& v) { return dot(v, v); }

class Remover {
 public:
  Remover(TriMesh& mesh, const ThinLimits& limits)
      : mesh_(mesh),
        least_(std::pow(std::sin(limits.angle), 2)),
        mostBend_(std::cos(limits.bend)),
        off_(limits.off),
        fans_(mesh),
        gone_(mesh.triangles.size(), 0) {}

  void run() {
    constexpr int kPasses = 8;
    for (int pass = 0; pass < kPasses; ++pass) {
      bool changed = false;
      for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        if (gone_[t] || sineSquared(mesh_.triangles[t]) >= least_) continue;
        changed = flip(t) || collapse(t) || changed;
      }
      if (!changed) break;
    }
    compact();
  }

 private:
  ModelPoint at(std::uint32_t vertex) const {
    const auto& p = mesh_.positions[vertex];
    return {p[0], p[1], p[2]};
  }
  ModelPoint normalOf(const Triangle& t) const { return cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])); }
  /// Of the smallest angle, which lies between the longer two sides.
  double sineSquared(const Triangle& t) const {
    const ModelPoint a = at(t[1]) - at(t[0]), b = at(t[2]) - at(t[0]), c = b - a;
    const double aa = squared(a), bb = squared(b), cc = squared(c);
    const double legs = std::max({aa * bb, aa * cc, bb * cc});
    return legs > 0 ? squared(cross(a, b)) / legs : 0;
  }
  /// Whether a triangle in place of another one lies nearly as that does.
  bool keepsWay(const Triangle& before, const Triangle& after) const {
    const ModelPoint a = normalOf(before), b = normalOf(after);
    return dot(a, b) > mostBend_ * std::sqrt(squared(a) * squared(b));
  }
  /// The corner of a triangle whose opposite edge is the longest, or the shortest.
  template <class Better>
  std::size_t cornerBy(const Triangle& t, const Better& better) const {
    std::size_t best = 0;
    const auto length = [&](std::size_t c) { return squared(at(t[(c + 1) % 3]) - at(t[(c + 2) % 3])); };
    for (std::size_t c = 1; c < 3; ++c) {
      if (better(length(c), length(best))) best = c;
    }
    return best;
  }
  /// The triangle on the other side of the edge from a to b, which is one of `t`.
  std::optional<std::uint32_t> across(std::uint32_t t, std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t other : fans_.at(a)) {
      if (other != t && std::ranges::count(mesh_.triangles[other], b) > 0) return other;
    }
    return std::nullopt;
  }
  bool areJoined(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::any_of(fans_.at(a),
                               [&](std::uint32_t t) { return std::ranges::count(mesh_.triangles[t], b) > 0; });
  }

  bool flip(std::uint32_t t) {
    const Triangle own = mesh_.triangles[t];
    const std::size_t tip = cornerBy(own, std::greater<>());
    const std::uint32_t c = own[tip], a = own[(tip + 1) % 3], b = own[(tip + 2) % 3];
    const auto other = across(t, a, b);
    if (!other) return false;
    const Triangle theirs = mesh_.triangles[*other];
    const std::uint32_t d = theirs[0] + theirs[1] + theirs[2] - a - b;
    if (areJoined(c, d)) return false;
    const Triangle one{c, a, d}, two{d, b, c};
    const bool flat = keepsWay(own, theirs) && keepsWay(own, one) && keepsWay(own, two) && keepsWay(theirs, one) &&
                      keepsWay(theirs, two);
    const double before = std::min(sineSquared(own), sineSquared(theirs)),
                 after = std::min(sineSquared(one), sineSquared(two));
    if (!flat || after <= before) return false;
    mesh_.triangles[t] = one;
    mesh_.triangles[*other] = two;
    fans_.leave(b, t);
    fans_.leave(a, *other);
    fans_.add(d, t);
    fans_.add(c, *other);
    return true;
  }

  bool collapse(std::uint32_t t) {
    const Triangle own = mesh_.triangles[t];
    const std::size_t tip = cornerBy(own, std::less<>());
    const std::uint32_t a = own[(tip + 1) % 3], b = own[(tip + 2) % 3];
    const double ab = worstWithout(a, b), ba = worstWithout(b, a);
    constexpr double kWorse = 0.75 * 0.75;  // what is round it may become so much thinner, if fewer triangles are thin
    if (std::max(ab, ba) < kWorse * sineSquared(own) || !hasOneSeam(a, b)) return false;
    if (ab >= ba) {
      join(a, b);
    } else {
      join(b, a);
    }
    return true;
  }

  /// The squared sine of the smallest angle round `goes` once it lies in `stays`; −1 where that changes the surface, or
  /// leaves as many thin triangles as there were.
  double worstWithout(std::uint32_t goes, std::uint32_t stays) const {
    double worst = 1;
    int thin = 0;
    const ModelPoint way = at(goes) - at(stays);
    for (const std::uint32_t t : fans_.at(goes)) {
      const Triangle before = mesh_.triangles[t];
      thin -= sineSquared(before) < least_;
      if (std::ranges::count(before, stays) > 0) continue;
      Triangle after = before;
      std::ranges::replace(after, goes, stays);
      if (!keepsWay(before, after)) return -1;
      const ModelPoint normal = normalOf(after);
      if (std::abs(dot(normal, way)) > off_ * norm(normal)) return -1;
      const double sine = sineSquared(after);
      thin += sine < least_;
      worst = std::min(worst, sine);
    }
    return thin < 0 ? worst : -1;
  }

  /// Whether a and b have no neighbours in common but the tips of the two triangles at their edge: else the surface
  /// would be pinched.
  bool hasOneSeam(std::uint32_t a, std::uint32_t b) const {
    std::vector<std::uint32_t> common;
    for (const std::uint32_t t : fans_.at(a)) {
      for (const std::uint32_t v : mesh_.triangles[t]) {
        if (v != a && v != b && areJoined(v, b) && std::ranges::count(common, v) == 0) common.push_back(v);
      }
    }
    constexpr std::size_t kLeastFan = 3;  // of a tip, which loses one
    return common.size() == 2 &&
           std::ranges::all_of(common, [&](std::uint32_t v) { return fans_.at(v).size() > kLeastFan; });
  }

  void join(std::uint32_t goes, std::uint32_t stays) {
    const auto fan = fans_.at(goes);
    moved_.assign(fan.begin(), fan.end());
    fans_.clear(goes);
    for (const std::uint32_t t : moved_) {
      Triangle& triangle = mesh_.triangles[t];
      if (std::ranges::count(triangle, stays) > 0) {
        gone_[t] = 1;
        for (const std::uint32_t v : triangle) {
          if (v != goes) fans_.leave(v, t);
        }
      } else {
        std::ranges::replace(triangle, goes, stays);
        fans_.add(stays, t);
      }
    }
  }

  void compact() {
    std::vector<std::uint32_t> index(mesh_.positions.size(), 0);
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < index.size(); ++v) {
      if (fans_.at(v).empty()) continue;
      mesh_.positions[count] = mesh_.positions[v];
      if (!mesh_.uv.empty()) mesh_.uv[count] = mesh_.uv[v];
      index[v] = count++;
    }
    mesh_.positions.resize(count);
    if (!mesh_.uv.empty()) mesh_.uv.resize(count);
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
      if (gone_[t]) continue;
      Triangle triangle = mesh_.triangles[t];
      for (std::uint32_t& v : triangle) v = index[v];
      mesh_.triangles[kept++] = triangle;
    }
    mesh_.triangles.resize(kept);
  }

  TriMesh& mesh_;
  double least_;  ///< sine squared
  double mostBend_, off_;
  Fans fans_;
  std::vector<char> gone_;            ///< by triangle
  std::vector<std::uint32_t> moved_;  ///< see join
};

}  // namespace

void removeThinTriangles(TriMesh& mesh, const ThinLimits& limits) { Remover(mesh, limits).run(); }

}  // namespace spineloft::mesh
