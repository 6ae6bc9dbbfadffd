// A drawing of lines, seen and hidden, as a person made it: what solids are derived from.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"

namespace spineloft::descriptive {

/// A stretch of a line, from < to, as shares of its arc length in 0…1.
struct Stretch {
  double from = 0, to = 1;
  bool operator==(const Stretch&) const = default;
};

/// A line of the drawing.
struct Line {
  std::vector<PicturePoint> points;  ///< ≥ 2; of a closed one the first is not repeated
  std::vector<Stretch> hidden;       ///< where something is in front of it; growing, apart
  bool closed = false;
  bool operator==(const Line&) const = default;
};

/// A place on a line: the share of its arc length, 0…1.
struct Place {
  std::uint32_t line = 0;
  double share = 0;
  bool operator==(const Place&) const = default;
};

/// A way along a line, against its direction where from > to.
struct Run {
  std::uint32_t line = 0;
  double from = 0, to = 1;
  bool operator==(const Run&) const = default;
};
/// A closed outline: each run begins where the one before it ends, the first where the last ends; gaps are closed
/// (pathOf of outlines.h).
using Outline = std::vector<Run>;

enum class PieceKind : std::uint8_t {
  Round,  ///< swollen over its outline: a circle becomes a ball
  Flat,   ///< a plane with a thickness
  Solid,  ///< between plane faces: its outlines are those of its faces, counter-clockwise seen from outside (y up)
  kCount
};

/// From where things with right angles are seen (right_angles.h); what is drawn looks the same from both.
enum class SeenFrom : std::uint8_t {
  Above,
  Below,
  Unknown,  ///< right angles say nothing
  kCount
};

/// One solid of the drawing: what its outlines enclose by even-odd; of kind Solid the faces round it.
struct Piece {
  std::string name;
  PieceKind kind = PieceKind::Round;
  std::vector<Outline> outlines;
  double stiffness = 1;        ///< α of the planarity energy (paper, eq. 7); kLeastStiffness … kMostStiffness
  double front = 1, back = 1;  ///< round: its thickness to the viewer and away is multiplied by it
  double thickness = 0;        ///< flat: picture pixels, 0: kThickness of the drawing's size
  bool operator==(const Piece&) const = default;
};

/// The depth of a place is given: z in picture pixels, larger is nearer to the viewer.
struct Pin {
  Place at;
  double z = 0;
  bool operator==(const Pin&) const = default;
};

/// Of two pieces that overlap at a place, who is in front there: indices of pieces. Of several the last one counts.
struct GivenOrder {
  std::uint32_t over = 0, under = 0;
  PicturePoint at;
  bool operator==(const GivenOrder&) const = default;
};

/// Everything that was drawn. Picture pixels, x right, y down.
struct Drawing {
  image::Size size;  ///< of the board; what is outside is cut off
  std::vector<Line> lines;
  std::vector<Piece> pieces;  ///< empty: as proposeOutlines proposes them, all round
  std::vector<Pin> pins;
  std::vector<Place> folds;  ///< where a line may turn off its plane (paper, 5.2.1)
  std::vector<GivenOrder> orders;
  SeenFrom seenFrom = SeenFrom::Above;
  bool operator==(const Drawing&) const = default;
};

inline constexpr double kLeastStiffness = 0.1, kMostStiffness = 1000;
inline constexpr double kLeastFront = -2, kMostFront = 4;
inline constexpr double kThickness = 0.02;  ///< of a flat piece, as a share of the drawing's size
inline constexpr std::size_t kMostLines = 500, kMostPieces = 200, kMostLinePoints = 100000;

/// How the unknowns and lengths of a drawing are scaled: depths and places are shares of its size, y up.
struct DepthScale {
  PicturePoint middle;  ///< pixels
  double size = 1;      ///< pixels
  SectionPoint of(PicturePoint p) const { return {(p.x - middle.x) / size, -(p.y - middle.y) / size}; }
};

}  // namespace spineloft::descriptive
