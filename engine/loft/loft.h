// From ribs to a solid (method: "Loft"; SpineLoft 3.4).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/geometry/along.h"
#include "engine/image/image.h"
#include "engine/loft/posed.h"
#include "engine/loft/section_key.h"
#include "engine/loft/workspace.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/sections/ends.h"

namespace spineloft::loft {

/// Rib ends farther out are brought back to here, picture pixels: beyond it floats are too coarse.
inline constexpr double kFarthest = 1e6;

inline constexpr double kMostTwist = 64, kMostTilt = 1.2;  ///< radians
inline constexpr double kLeastSquash = 0.05, kMostSquash = 8;

/// The thinner side of a bulged section keeps at least this share of its depth.
inline constexpr double kLeastSide = 0.04;

/// Everything a loft depends on besides its ribs and its pose.
struct LoftParams {
  std::vector<SectionKey> sections{SectionKey{}};  ///< at least one, in order
  /// How the section changes along the spine, places in shares of its length.
  geometry::AlongCurve twist;   ///< turns about the spine, radians, ±kMostTwist; without points 0
  geometry::AlongCurve squash;  ///< depth over width, kLeastSquash…kMostSquash; without points 1
  geometry::AlongCurve tilt;    ///< shear along the spine: angle about the rib, radians, ±kMostTilt; without points 0
  geometry::AlongCurve bulge;   ///< front over back, −1 (flat front) … 1 (flat back); without points 0
  sections::CapStyle startCap = sections::CapStyle::Round, endCap = sections::CapStyle::Round;
  int sectionPoints = 48;  ///< vertices around, 12…512
  int capRings = 6;        ///< rings of a round cap, 1…64
  double centring = 1.0;   ///< smoothing of centre line and depth in ribs, 0…10; the silhouette never moves
  bool operator==(const LoftParams&) const = default;
};

/// Sections, curves and numbers in range. Errors: SectionInvalid, ValueOutOfRange.
Status checkParams(const LoftParams& params);

/// A closed, 2-manifold, outward mesh in ModelSpace (picture pixels, y up, z to the viewer, spine in the plane z =
/// 0), for any ribs: crossing, zero-width or coincident ribs are repaired locally. Seen from the front the outline
/// passes through every rib end, except those beyond a flat or open end. UV are picture coordinates ((x + ½) / width,
/// (y + ½) / height), clamped. Beside the outline the back uses UV of a place up to a tenth of the half width farther
/// in. The colours there are the concern of surface/part_texture.h, which keeps the background off the rim.
///
/// Depth: a section reaches as far to the viewer as half the part's true width, measured square to
/// its smoothed centre line, so a slanted rib across a round bar gives the slanted cut of a round bar.
/// Ribs at an end without width become a tip, whatever the cap. Round caps without a fan are domes
/// `kDomeHeight` of the half width high, those whose fan does not lie beyond the last rib are flat; open ones leave a
/// wall of `kWall` of the half width and reach `kMouthDepth` of the way to the other end (both ends open: right
/// through, genus 1). Ribs with a coordinate that is not finite are left out; coordinates are clamped to ±kFarthest.
/// Errors: TooFewRibs (fewer than 2 ribs, or all in one point), ValueOutOfRange, SectionInvalid.
///
/// Along the spine: sections go from key to key (section.h) and always touch both rib ends; squash
/// scales depth, bulge the front by 1 + b and the back by 1 − b (never below kLeastSide), twist then
/// turns the section (ribs give its size; only where it is 0 the outline passes through the rib ends),
/// tilt shears it along the spine so that a round bar stays a round bar. Sections of several pieces or
/// with holes end flat whatever the caps, and so do open ends of sections that no point sees whole.
Result<mesh::TriMesh> loftRibs(const ribs::RibSet& ribs, image::Size picture, const LoftParams& params);

/// The same in a pose: ribs are repaired where they were traced; then every section is carried by the frames of the
/// spine and keeps the UV of the place where it was traced. A closed spine makes a ring without caps: sizes and
/// curves meet halfway near the seam, and twist is rounded to full turns.
Result<mesh::TriMesh> loftRibs(const ribs::RibSet& ribs, image::Size picture, const LoftParams& params,
                               const PosedSpine& spine);

/// The same for repeated calls: replaces what `mesh` held. Allocates nothing once `memory` and `mesh` have seen parts
/// as large, where one section stands along the spine at rest and no end is open. After a failure `mesh` is of no
/// use.
struct Source {
  const ribs::RibSet& ribs;
  image::Size picture;
  const LoftParams& params;
};
Status loftRibs(const Source& source, const PosedSpine& spine, LoftWorkspace& memory, mesh::TriMesh& mesh);

/// The same with a section of one's own instead of the preset (`section` and `sectionPoints` of the
/// params are not read). It must be simple and counter-clockwise, lie in [−1, 1]² and touch x = ±1 (to
/// 1e-6), else SectionInvalid.
Result<mesh::TriMesh> loftSection(const ribs::RibSet& ribs, image::Size picture, const LoftParams& params,
                                  const sections::Section& section);

}  // namespace spineloft::loft
