// The walls between two rings of a loft, four quads at a time. Internal to loft/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/base/lanes.h"
#include "engine/mesh/laws.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::loft {

/// The vertices of one ring by coordinate. Every curve of the section is followed by its first point once more.
class RingPlanes {
 public:
  /// Takes the ring's vertices, as many as `sizes` say, from `positions`.
  void read(std::span<const std::array<float, 3>> positions, std::span<const std::size_t> sizes);
  const float* plane(std::size_t axis) const { return planes_[axis].data(); }
  std::size_t points() const { return points_; }  ///< without those that fill up the last four

 private:
  std::array<std::vector<float>, 3> planes_;
  std::size_t points_ = 0;
};

/// Measures that are summed while the walls of a mesh are made, in single precision: enough to prove nearly all
/// meshes sound.
class WallTally {
 public:
  /// `ground`: heights are measured from there.
  explicit WallTally(float ground) : ground_(all4(ground)) {}
  void addVertices(const RingPlanes& ring);
  /// Four triangles by two edges from their first corner, and the sums of their corners' heights over the ground and
  /// of the sizes of those. Lanes that are not `held` do not count.
  struct Four {
    Float4 ux, uy, uz, vx, vy, vz, height, heights;
  };
  void add(const Four& t, Int4 held);
  Float4 ground() const { return ground_; }

  mesh::Bounds bounds() const;
  /// Every triangle is certainly larger than `area`.
  bool surelyLarger(double area) const;
  /// Volume between walls and ground by the flux of (0, 0, z), and a bound of its rounding.
  double volume() const;
  double volumeError() const;

 private:
  Float4 ground_, least_ = all4(std::numeric_limits<float>::infinity());
  Float4 volume_ = all4(0), parts_ = all4(0);
  std::array<Float4, 3> low_{least_, least_, least_}, high_{-least_, -least_, -least_};
  Int4 thin_{};
};

/// The walls between two rings whose first vertices are `firstA` and `firstB`; the second follows the first along the
/// surface. Each quad is cut along its shorter diagonal; of two that differ by less than a hundred-thousandth always
/// along the same one. Writes two triangles a point to `out`.
struct Band {
  const RingPlanes &a, &b;
  std::uint32_t firstA, firstB;
};
void makeWalls(const Band& band, std::span<const std::size_t> sizes, std::array<std::uint32_t, 3>* out,
               WallTally& tally);

}  // namespace spineloft::loft
