// Lines as drawn to lines that meet: closed, welded, and where they pass each other.
#pragma once

#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/descriptive/drawing.h"

namespace spineloft::descriptive {

/// A line with its arc lengths. Of a closed one the last point is the first.
struct MeasuredLine {
  std::vector<PicturePoint> points;
  std::vector<double> s;  ///< pixels, one a point
  std::vector<Stretch> hidden;
  bool closed = false;
  double length() const { return s.back(); }
  PicturePoint at(double share) const;
  bool isHidden(double share) const;
};

/// The longer side of the bounds of all lines, pixels; 0 without lines.
double sizeOf(std::span<const Line> lines);
double sizeOf(std::span<const MeasuredLine> lines);

/// What every length below is a share of the drawing's size of.
inline constexpr double kClosing = 0.04;    ///< ends of one line nearer than this close it
inline constexpr double kWelding = 0.02;    ///< ends nearer than this to each other, or to a line, are put there
inline constexpr double kContact = 0.0025;  ///< lines nearer than this are at each other
inline constexpr double kShared = 0.1;      ///< lines at each other for longer share a run
inline constexpr double kSnapping = 0.03;   ///< a change of type nearer than this to a crossing is meant to be there

/// The lines in their order, with repeated points dropped, open ends welded and overshoots cut: an end within kClosing
/// of the line's other end closes the line, but where both lie on other lines; ends of several lines within kWelding of
/// each other go to their mean; any other end within kWelding of another line is put on it, and what crosses that line
/// shortly before its end is cut there. Hidden stretches stay at their places. Cost: points squared over a grid;
/// `lines` of the limits of drawing.h. Errors: StrokeNotFinite, StrokeTooShort (fewer than two distinct points),
/// ValueOutOfRange (more than the limits allow, or stretches out of order).
Result<std::vector<MeasuredLine>> meetingLines(std::span<const Line> lines);

enum class NodeKind : std::uint8_t {
  Crossing,  ///< two lines pass each other (paper: T)
  Touch,     ///< they meet and stay on their sides (paper: X)
  Branch,    ///< a line ends on another, or a shared run begins or ends (paper: Y)
  Dip,       ///< a line changes its type away from all crossings (paper: cusp)
  Corner,    ///< ends of lines meet
  End,       ///< of one line alone
  kCount
};

struct Node {
  NodeKind kind = NodeKind::End;
  PicturePoint at;
  std::vector<Place> places;  ///< on every line that is there; the first of a branch is the line that ends
  bool operator==(const Node&) const = default;
};

/// All nodes, by kind, then in the order of lines. `size`: sizeOf. Where three lines pass through one point, each two
/// of them have a crossing. Touches and runs are found where two lines stay within kContact of each other: shorter than
/// kShared it is a crossing when the lines change sides, else a touch.
std::vector<Node> nodesOf(std::span<const MeasuredLine> lines, double size);

}  // namespace spineloft::descriptive
