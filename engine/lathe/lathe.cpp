#include "engine/lathe/lathe.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/geometry/triangulate.h"
#include "engine/lathe/half_plane.h"
#include "engine/mesh/front_uv.h"

namespace spineloft::lathe {
namespace {

/// A turn nearer to a full one than this is one, degrees.
constexpr double kFull = 1e-9;

/// Rings of points about the axis, joined along the outlines.
class Turner {
 public:
  Turner(const HalfPlaneRegion& region, image::Size picture, const LatheParams& params)
      : region_(region), picture_(picture), full_(params.turn >= kMostTurn - kFull) {
    const double share = params.turn / kMostTurn;
    steps_ = full_ ? params.sides : std::max(1, static_cast<int>(std::ceil(params.sides * share - kFull)));
    for (int k = 0; k <= steps_; ++k) {
      const double angle = 2 * std::numbers::pi * share * k / steps_;
      around_.push_back({std::cos(angle), params.squash * std::sin(angle)});
    }
    // Picture y is down: r, h and the way to the viewer are right-handed where along × aside is positive.
    turned_ = cross(region.axis.along, region.axis.aside) < 0;
  }

  mesh::TriMesh run() {
    std::vector<SectionPoint> points;
    std::vector<std::size_t> sizes;
    for (const auto& outline : region_.outlines) {
      const std::vector<std::uint32_t> first = addPoints(outline);
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t k = (i + 1) % outline.size();
        sweep({outline[i], first[i]}, {outline[k], first[k]});
      }
      points.insert(points.end(), outline.begin(), outline.end());
      sizes.push_back(outline.size());
      first_.insert(first_.end(), first.begin(), first.end());
    }
    if (!full_) addLids(points, sizes);
    return std::move(mesh_);
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffu;
  struct Corner {
    SectionPoint at;
    std::uint32_t first;  ///< of its ring; on the axis its only point, in a full turn none
    bool onAxis() const { return at.x == 0; }
  };

  std::uint32_t add(SectionPoint p, int step) {
    const SectionPoint around = around_[static_cast<std::size_t>(step)];
    const PicturePoint q = region_.axis.inPicture({p.x * around.x, p.y});
    mesh_.positions.push_back({static_cast<float>(q.x), static_cast<float>(-q.y), static_cast<float>(p.x * around.y)});
    mesh_.uv.push_back(
        mesh::frontUv(q.x, -q.y, {static_cast<double>(picture_.width), static_cast<double>(picture_.height)}));
    return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
  }
  /// The ring of every corner. In a full turn the corners on the axis wait for the fans round them: each has its own
  /// point, so that two fans never meet in one.
  std::vector<std::uint32_t> addPoints(const std::vector<SectionPoint>& outline) {
    std::vector<std::uint32_t> first;
    for (const SectionPoint p : outline) {
      const bool onAxis = p.x == 0;
      if (onAxis && full_) {
        first.push_back(kNone);
        continue;
      }
      first.push_back(add(p, 0));
      const int more = onAxis ? 0 : full_ ? steps_ - 1 : steps_;
      for (int k = 1; k <= more; ++k) add(p, k);
    }
    return first;
  }
  std::uint32_t at(const Corner& corner, int step) const {
    if (corner.onAxis()) return corner.first;
    return corner.first + static_cast<std::uint32_t>(full_ ? step % steps_ : step);
  }
  void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (turned_) std::swap(b, c);
    mesh_.triangles.push_back({a, b, c});
  }
  /// The faces that an edge of the outline leaves; one on the axis leaves none.
  void sweep(Corner from, Corner to) {
    if (from.onAxis() && to.onAxis()) return;
    for (Corner* corner : {&from, &to}) {
      if (corner->first == kNone) corner->first = add(corner->at, 0);
    }
    for (int k = 0; k < steps_; ++k) {
      const std::uint32_t a = at(from, k), b = at(to, k), c = at(to, k + 1), d = at(from, k + 1);
      if (b != c) addTriangle(a, b, c);
      if (a != d) addTriangle(a, c, d);
    }
  }
  void addLids(const std::vector<SectionPoint>& points, const std::vector<std::size_t>& sizes) {
    for (const auto& [i, j, k] : geometry::triangulate(points, sizes)) {
      const Corner a{points[i], first_[i]}, b{points[j], first_[j]}, c{points[k], first_[k]};
      addTriangle(at(a, 0), at(c, 0), at(b, 0));
      addTriangle(at(a, steps_), at(b, steps_), at(c, steps_));
    }
  }

  const HalfPlaneRegion& region_;
  image::Size picture_;
  bool full_, turned_ = false;
  int steps_ = 1;
  std::vector<SectionPoint> around_;  ///< cosine, and sine with the squash
  std::vector<std::uint32_t> first_;
  mesh::TriMesh mesh_;
};

/// The region in the picture, and beyond the axis once the turn gets there.
geometry::Contours silhouetteOf(const HalfPlaneRegion& region, const LatheParams& params) {
  geometry::Contours out;
  for (const double side : {1.0, -1.0}) {
    if (side < 0 && params.turn < kMostTurn / 2) continue;
    for (const auto& outline : region.outlines) {
      auto& contour = out.emplace_back();
      for (const SectionPoint p : outline) contour.push_back(region.axis.inPicture({side * p.x, p.y}));
    }
  }
  return out;
}

}  // namespace

Result<Spun> spinRegion(const Profile& profile, image::Size picture, const LatheParams& params) {
  if (!isValid(params)) return Error::ValueOutOfRange;
  const double side = std::max({1, picture.width, picture.height});
  const Result<HalfPlaneRegion> region = halfPlaneRegion(profile, params, params.wall * side);
  if (!region) return region.failure();
  Spun spun{Turner(region.value(), picture, params).run(), silhouetteOf(region.value(), params)};
  if (spun.mesh.triangles.empty()) return Error::ProfileOnAxis;
  return spun;
}

}  // namespace spineloft::lathe
