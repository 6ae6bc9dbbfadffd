#include "engine/mesh/thin_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::mesh {
namespace {

using Triangle = std::array<std::uint32_t, 3>;

class Remover {
 public:
  Remover(TriMesh& mesh, const ThinLimits& limits)
      : mesh_(mesh),
        least_(std::sin(limits.angle)),
        mostBend_(std::cos(limits.bend)),
        off_(limits.off),
        fans_(mesh.positions.size()),
        gone_(mesh.triangles.size(), 0) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (const std::uint32_t corner : mesh.triangles[t]) fans_[corner].push_back(t);
    }
  }

  void run() {
    constexpr int kPasses = 8;
    for (int pass = 0; pass < kPasses; ++pass) {
      bool changed = false;
      for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
        if (gone_[t] || sineOf(mesh_.triangles[t]) >= least_) continue;
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
  /// Of the smallest angle.
  double sineOf(const Triangle& t) const {
    std::array<double, 3> sides{distance(at(t[0]), at(t[1])), distance(at(t[1]), at(t[2])),
                                distance(at(t[2]), at(t[0]))};
    std::ranges::sort(sides);
    const double legs = sides[1] * sides[2];
    return legs > 0 ? norm(normalOf(t)) / legs : 0;
  }
  /// Whether a triangle in place of another one lies nearly as that does.
  bool keepsWay(const Triangle& before, const Triangle& after) const {
    const ModelPoint a = normalOf(before), b = normalOf(after);
    return dot(a, b) > mostBend_ * norm(a) * norm(b);
  }
  /// The corner of a triangle whose opposite edge is the longest, or the shortest.
  template <class Better>
  std::size_t cornerBy(const Triangle& t, const Better& better) const {
    std::size_t best = 0;
    const auto length = [&](std::size_t c) { return distance(at(t[(c + 1) % 3]), at(t[(c + 2) % 3])); };
    for (std::size_t c = 1; c < 3; ++c) {
      if (better(length(c), length(best))) best = c;
    }
    return best;
  }
  /// The triangle on the other side of the edge from a to b, which is one of `t`.
  std::optional<std::uint32_t> across(std::uint32_t t, std::uint32_t a, std::uint32_t b) const {
    for (const std::uint32_t other : fans_[a]) {
      if (other != t && std::ranges::count(mesh_.triangles[other], b) > 0) return other;
    }
    return std::nullopt;
  }
  bool areJoined(std::uint32_t a, std::uint32_t b) const {
    return std::ranges::any_of(fans_[a],
                               [&](std::uint32_t t) { return std::ranges::count(mesh_.triangles[t], b) > 0; });
  }
  void leave(std::uint32_t vertex, std::uint32_t triangle) { std::erase(fans_[vertex], triangle); }

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
    const double before = std::min(sineOf(own), sineOf(theirs)), after = std::min(sineOf(one), sineOf(two));
    if (!flat || after <= before) return false;
    mesh_.triangles[t] = one;
    mesh_.triangles[*other] = two;
    leave(b, t);
    leave(a, *other);
    fans_[d].push_back(t);
    fans_[c].push_back(*other);
    return true;
  }

  bool collapse(std::uint32_t t) {
    const Triangle own = mesh_.triangles[t];
    const std::size_t tip = cornerBy(own, std::less<>());
    const std::uint32_t a = own[(tip + 1) % 3], b = own[(tip + 2) % 3];
    const double ab = worstWithout(a, b), ba = worstWithout(b, a);
    constexpr double kWorse = 0.75;  // what is round it may become so much thinner, if fewer triangles are thin
    if (std::max(ab, ba) < kWorse * sineOf(own) || !hasOneSeam(a, b)) return false;
    if (ab >= ba) {
      join(a, b);
    } else {
      join(b, a);
    }
    return true;
  }

  /// The sine of the smallest angle round `goes` once it lies in `stays`; −1 where that changes the surface, or leaves
  /// as many thin triangles as there were.
  double worstWithout(std::uint32_t goes, std::uint32_t stays) const {
    double worst = 1;
    int thin = 0;
    const ModelPoint way = at(goes) - at(stays);
    for (const std::uint32_t t : fans_[goes]) {
      const Triangle before = mesh_.triangles[t];
      thin -= sineOf(before) < least_;
      if (std::ranges::count(before, stays) > 0) continue;
      Triangle after = before;
      std::ranges::replace(after, goes, stays);
      if (!keepsWay(before, after)) return -1;
      const ModelPoint normal = normalOf(after);
      if (std::abs(dot(normal, way)) > off_ * norm(normal)) return -1;
      const double sine = sineOf(after);
      thin += sine < least_;
      worst = std::min(worst, sine);
    }
    return thin < 0 ? worst : -1;
  }

  /// Whether a and b have no neighbours in common but the tips of the two triangles at their edge: else the surface
  /// would be pinched.
  bool hasOneSeam(std::uint32_t a, std::uint32_t b) const {
    std::vector<std::uint32_t> common;
    for (const std::uint32_t t : fans_[a]) {
      for (const std::uint32_t v : mesh_.triangles[t]) {
        if (v != a && v != b && areJoined(v, b) && std::ranges::count(common, v) == 0) common.push_back(v);
      }
    }
    constexpr std::size_t kLeastFan = 3;  // of a tip, which loses one
    return common.size() == 2 &&
           std::ranges::all_of(common, [&](std::uint32_t v) { return fans_[v].size() > kLeastFan; });
  }

  void join(std::uint32_t goes, std::uint32_t stays) {
    for (const std::uint32_t t : std::exchange(fans_[goes], {})) {
      Triangle& triangle = mesh_.triangles[t];
      if (std::ranges::count(triangle, stays) > 0) {
        gone_[t] = 1;
        for (const std::uint32_t v : triangle) {
          if (v != goes) leave(v, t);
        }
      } else {
        std::ranges::replace(triangle, goes, stays);
        fans_[stays].push_back(t);
      }
    }
  }

  void compact() {
    std::vector<std::uint32_t> index(mesh_.positions.size(), 0);
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < index.size(); ++v) {
      if (fans_[v].empty()) continue;
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
  double least_, mostBend_, off_;
  std::vector<std::vector<std::uint32_t>> fans_;  ///< triangles round each point
  std::vector<char> gone_;                        ///< by triangle
};

}  // namespace

void removeThinTriangles(TriMesh& mesh, const ThinLimits& limits) { Remover(mesh, limits).run(); }

}  // namespace spineloft::mesh
