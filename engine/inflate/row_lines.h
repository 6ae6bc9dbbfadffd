// Rows of a profile in the plane: lines of equal s with points as far apart as the place allows. Internal to inflate/.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "engine/geometry/refine.h"
#include "engine/inflate/fields.h"
#include "engine/inflate/profile.h"

namespace spineloft::inflate {

/// A closed line; the skeleton is on its right, the outline on its left.
using Row = std::vector<LevelPoint>;

/// The rows of one piece: for each outline the line of a level, once for each level, which every slice has its own of.
class RowTable {
 public:
  /// How far points lie apart, and whether outlines are those of the piece or of the fields' mesh, whose chords no row
  /// crosses.
  struct Way {
    double spacing;
    double fineness;  ///< see finenessFor
    bool chords;
  };
  RowTable(const Fields& fields, const geometry::Contours& piece, const Way& way)
      : fields_(fields), piece_(piece), way_(way) {}

  /// One row an outline; empty where the level has not one line an outline.
  const std::vector<Row>& at(const ProfileRow& row);
  /// Whether some of those asked for so far cross in the plane, as seen from the front.
  bool cross() const;

 private:
  std::vector<Row> traced(std::span<const double> levels) const;
  /// The outlines themselves; H is that of the nearest place on the rim of the fields.
  std::vector<Row> outlines() const;
  /// Those of the fields' mesh.
  std::vector<Row> chords() const;

  const Fields& fields_;
  const geometry::Contours& piece_;
  const Way way_;
  std::map<std::vector<double>, std::vector<Row>> rows_;
};

/// Whether row a of two rows round the same outline is the lower one.
bool runsInside(std::span<const LevelPoint> a, std::span<const LevelPoint> b);

/// The triangulation of what lies between a row and a higher one, whose rim they are: the higher one backwards.
struct Band {
  geometry::PlaneMesh mesh;
  bool lowFirst;  ///< of the rim
};
/// None where they cross.
std::optional<Band> bandBetween(std::span<const LevelPoint> low, std::span<const LevelPoint> high);

}  // namespace spineloft::inflate
