// From sections standing in the picture to triangles. Internal to loft/.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/image/image.h"
#include "engine/loft/chords.h"
#include "engine/mesh/tri_mesh.h"

namespace spineloft::loft {

/// A section with what its use as a wall and as a lid needs.
struct SweepSection {
  std::vector<SectionPoint> points;
  SectionPoint centre;      ///< hub of the lid's triangles, and what an inner wall shrinks towards
  bool starShaped = false;  ///< the centre sees every edge; else `lid` fills the section
  std::vector<std::array<std::uint32_t, 3>> lid;
  double shortestEdge = 0;  ///< section units
};
SweepSection prepareSection(std::span<const SectionPoint> points);

/// One section in place: across its chord, `depth` picture pixels for section y = 1.
struct Station {
  Chord chord;
  double depth = 0;
};

/// Stations in order (≥ 1; with a single one at least one tip) and how the two ends are closed: by
/// a tip, by an inner wall, else by a lid. Openings of a single station are lids.
struct Sweep {
  std::vector<Station> stations;
  std::optional<PicturePoint> startTip, endTip;
  bool startOpen = false, endOpen = false;
};

/// The closed mesh in ModelSpace, with UV.
mesh::TriMesh sweepMesh(const Sweep& sweep, const SweepSection& section, image::Size picture);

/// No triangle that the law of area (mesh/laws.h) would refuse, with a factor 2 in hand.
bool hasSoundTriangles(const mesh::TriMesh& mesh);

}  // namespace spineloft::loft
