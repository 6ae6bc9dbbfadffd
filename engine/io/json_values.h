// The small JSON files of the command line: strokes in, ribs and reports out, cases of a data
// folder. The JSON library stays inside the .cpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/inflate/skeleton.h"
#include "engine/mesh/laws.h"
#include "engine/ribs/base/rib_set.h"
#include "engine/stack/stack.h"

namespace spineloft::io {

/// A stroke in picture pixels. `json` is a list of [x, y] (more numbers a point, such as a
/// pressure, are ignored), or an object whose `points` is such a list, or an object whose `spines`
/// maps names to such lists. `name` chooses among `spines`; empty takes the first in the file. A
/// name with a file that holds no `spines` is an error, so that a misspelt file is noticed. Errors:
/// JsonInvalid (with what is wrong), StrokeNotFinite (null or NaN for a number), StrokeTooShort (an
/// empty list), OutOfMemory.
Result<std::vector<PicturePoint>> readStroke(std::string_view json, std::string_view name);

/// {"ribs":[{"center":[x,y],"left":[x,y],"right":[x,y],"leftState","rightState"}]} in picture
/// pixels.
std::string writeRibs(const ribs::RibSet& ribs);

/// Names with numbers, in order: milliseconds of stages, counts, means.
using NamedNumbers = std::vector<std::pair<std::string, double>>;
/// The lines of a table, each with its name.
using NamedLines = std::vector<std::pair<std::string, NamedNumbers>>;

/// What one run of `spineloft loft` made.
struct LoftReport {
  image::Size picture;
  std::size_t ribs = 0, vertices = 0, triangles = 0;
  ribs::EnergyTerms energy;
  mesh::MeshReport mesh;                                ///< of the part in ModelSpace: volume in px³, area in px²
  bool crossesItself = false;                           ///< see mesh::selfCrossing
  std::optional<std::vector<inflate::Skeleton>> bones;  ///< of a puff, one a piece of its region
  int asleep = 0;                                       ///< edits of its bones, and slices, that find no place
  struct Profile {
    int slices = 0, middle = 0, offAxis = 0;  ///< slices; curves from axis to axis and beside it of each
    int thickened = 0;                        ///< rings that are drawn thicker, see inflate::thickenRings
  };
  std::optional<Profile> profile;   ///< of a puff with a slice
  std::optional<stack::Ways> ways;  ///< of a stack
  NamedNumbers milliseconds;        ///< by stage
};
/// {"picture":{"width","height"},"ribs":n,"energy":{"distance","neighbour","opposite","prior","total"},
/// "mesh":{"vertices","triangles","closed","lawful","shells","genus","crossesItself","volume","area"},"milliseconds":{…}};
/// of a puff also "bones":{"ends","forks","rings","length","branches":[[x,y,r,…],…],"asleep"} in picture pixels, r the
/// half width, and with a slice "profile":{"slices","middle","offAxis","thickened"}; of a stack
/// "links":[[plane,curve,plane,curve],…], "forks":[{"plane","curve","up","at"},…], all from 0.
std::string writeReport(const LoftReport& report);

/// A case of a data folder (case.json), as far as scoring needs it.
/// What makes a case hard, as its `difficulty` says; 0 for what that leaves out.
struct BenchDifficulty {
  double hiddenPct = 0;          ///< `occlusion_pct`: of the part's pixels
  double missingOutlinePct = 0;  ///< `missing_boundary_pct`: of the outline, erased on purpose
  double noise = 0;              ///< `noise_sigma`, grey levels
  double faintOutlinePct = 0;    ///< `no_edge_pct`: of the outline, without an edge near by
  double innerEdges = 0;         ///< `inner_edges_per_1000px`
};
struct BenchCase {
  std::string id, category, image, mask;    ///< image and mask are file names beside case.json
  double boundaryTolerance = 1;             ///< px
  std::vector<std::array<double, 3>> axis;  ///< true middle line: x, y, local width
  std::vector<std::pair<std::string, std::vector<PicturePoint>>> strokes;  ///< `spines`, in file order
  std::optional<BenchDifficulty> difficulty;                               ///< none where the file says nothing of it
};
/// Errors: JsonInvalid, StrokeNotFinite, OutOfMemory.
Result<BenchCase> readBenchCase(std::string_view json);

/// One case × stroke of a benchmark: who it is, and its numbers.
struct BenchRow {
  std::string name, category, stroke;
  NamedNumbers numbers;
  std::string failure;                  ///< empty when the part was made
  std::vector<std::string> difficulty;  ///< names of what makes the case hard
};
/// Group means and rows: {"summary":[{"name",…}],"cases":[{"name","category","stroke","difficulty",…}]}; further
/// tables stand beside them under their names, written as the summary is.
struct BenchReport {
  NamedLines summary;
  std::vector<BenchRow> rows;
  std::vector<std::pair<std::string, NamedLines>> tables;
};
std::string writeBench(const BenchReport& report);

/// An object of named numbers: {"name": number, …}; numbers that are not finite become null.
std::string writeNumbers(const NamedNumbers& numbers);

}  // namespace spineloft::io
