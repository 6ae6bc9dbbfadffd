// The middle surface of a piece: few unknowns, and its depth everywhere as a linear function of them.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/overlaps.h"
#include "engine/geometry/qp.h"
#include "engine/geometry/refine.h"

namespace spineloft::descriptive {

struct FacedSolid;

/// A place of a mesh as three of its points with weights that sum to 1.
struct MeshPlace {
  std::array<std::uint32_t, 3> points{};
  std::array<double, 3> weights{};
  bool operator==(const MeshPlace&) const = default;
  template <class Values>
  auto of(const Values& values) const {
    return values[points[0]] * weights[0] + values[points[1]] * weights[1] + values[points[2]] * weights[2];
  }
};

/// The mesh is in pixels with y up. z = plane + bend. The plane has three unknowns: z at the middle of the piece, and
/// how much it grows to the right and up over the piece's radius; a flat piece has no others. One with plane faces
/// does not turn: z is the same everywhere, + its rise, half way between its faces. The bend of a round one is given at
/// about kControls control points of its outlines, linear between them along the rim; inside it is Σ w · bend with
/// harmonic coordinates, w = −L_II⁻¹ L_IB on the cotangent stiffness of the mesh. So planes are exact.
class Patch {
 public:
  /// Places of the outlines that are corners of the rim, pixels.
  struct Kept {
    std::vector<PicturePoint> folds;  ///< no window of planarity crosses them
    std::vector<PicturePoint> others;
  };
  /// About `points` points on both sides of a round one. Error: RegionTooFine.
  static Result<Patch> make(const Sheet& sheet, const Piece& piece, const Kept& kept, const DepthScale& scale,
                            int points);
  /// The same between plane faces. Error: ShapeInvalid where what is seen of them is no simple outline.
  static Result<Patch> make(const FacedSolid& solid, const DepthScale& scale);
  Patch(Patch&&) noexcept;
  Patch& operator=(Patch&&) noexcept;
  ~Patch();

  const geometry::PlaneMesh& mesh() const;
  const std::vector<std::size_t>& rims() const;  ///< corners of each outline
  const std::vector<double>& poisson() const;    ///< u at every point, square pixels; empty for a flat piece
  /// What it was made of; null but between plane faces.
  const FacedSolid* faced() const;
  /// Half its thickness along z at every point; empty but between plane faces. A share of the size.
  const std::vector<double>& halfThick() const;
  /// What a depth has beside the terms of its unknowns: 0 but between plane faces.
  double riseAt(const MeshPlace& place) const;
  std::size_t unknowns() const;
  /// Its planarity (planarity.h), and the gauges below.
  const std::vector<geometry::QpEntry>& energy() const;

  /// The depth without rise at a place (or the mean over several, by weights) as terms in the unknowns, the first being
  /// `offset`.
  std::vector<geometry::QpTerm> depthOf(std::span<const MeshPlace> places, std::span<const double> weights,
                                        std::uint32_t offset) const;
  /// The depth of its plane, without bend, at any p (pixels, y up), in the same way.
  std::vector<geometry::QpTerm> planeDepthOf(SectionPoint p, std::uint32_t offset) const;
  /// The depth at every point of the mesh.
  std::vector<double> depthsOf(std::span<const double> unknowns) const;
  /// The size of the gradient of the depth at every point of the mesh: a mean of the triangles round it.
  std::vector<double> slopesOf(std::span<const double> depths) const;

  /// Where p (pixels, y up) is; none outside.
  std::optional<MeshPlace> find(SectionPoint p) const;
  /// The place of the rim that is nearest to p (pixels, y up).
  MeshPlace onRim(SectionPoint p) const;

 private:
  struct Parts;
  explicit Patch(std::unique_ptr<Parts> parts);
  std::unique_ptr<Parts> parts_;
};

inline constexpr std::size_t kControls = 48;
/// So much of the square of an unknown is added, so that there is one optimum: where nothing else says it, a piece lies
/// at depth 0 and, which counts more, faces the viewer, and what a plane can do is no bend.
inline constexpr double kDepthGauge = 1e-8, kTurnGauge = 1e-5, kControlGauge = 1e-5;

}  // namespace spineloft::descriptive
