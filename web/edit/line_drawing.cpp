#include "web/edit/line_drawing.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/descriptive/dashes.h"
#include "engine/descriptive/lines.h"
#include "engine/document/pieces.h"
#include "engine/geometry/line_distance.h"
#include "engine/geometry/polyline.h"
#include "engine/geometry/stroke_line.h"
#include "engine/pipeline/world.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

constexpr double kApart = 44;        // CSS pixels between crossings: a fingertip
constexpr int kRounds = 24;          // in which they move apart
constexpr double kThinning = 0.4;    // picture pixels that a line as kept is off the one as drawn
constexpr double kSamePlace = 1e-6;  // picture pixels
constexpr double kLongEnough = 3;    // times its gap: shorter lines do not close
constexpr double kUpright = 0.01;    // radians: what leans less stands
constexpr double kMostCut = 0.34;    // of a line: an end is neither cut nor led onto a line by more

/// Calls `each(drawing, derived drawing)` for those on a picture.
template <class Each>
void forDrawings(const document::Document& document, const pipeline::Derived& derived, PictureId picture,
                 const Each& each) {
  const std::size_t count = std::min(document.drawings.size(), derived.drawings.size());
  for (std::size_t i = 0; i < count; ++i) {
    const document::Drawing& drawing = document.drawings[i];
    if (drawing.picture == picture && derived.drawings[i].shape) each(drawing, derived.drawings[i]);
  }
}

/// Of a piece with edges its own, else that of right angles, else that of the first piece with edges.
std::optional<ModelPoint> upOf(const pipeline::DerivedDrawing& drawing, PartId piece) {
  const descriptive::Model& model = drawing.shape->model;
  std::optional<ModelPoint> first;
  for (const descriptive::ModelPiece& solid : model.solids) {
    if (drawing.pieces[solid.piece] == piece && solid.up) return solid.up;
    if (!first) first = solid.up;
  }
  return model.up ? model.up : first;
}

bool isShown(const document::Document& document, PartId id) {
  const document::Part* part = document::findPart(document, id);
  return part != nullptr && pipeline::isVisible(document, *part);
}

/// Where the way from a to b crosses a line, as a share of the way; the first.
std::optional<double> firstCrossing(PicturePoint a, PicturePoint b, const std::vector<PicturePoint>& line,
                                    bool closed) {
  std::optional<double> first;
  const std::size_t sides = closed ? line.size() : line.size() - 1;
  for (std::size_t i = 0; i < sides; ++i) {
    const PicturePoint c = line[i], d = line[(i + 1) % line.size()];
    const double whole = cross(b - a, d - c);
    if (whole == 0) continue;
    const double t = cross(c - a, d - c) / whole, u = cross(c - a, b - a) / whole;
    if (t < 0 || t > 1 || u < 0 || u > 1) continue;
    if (!first || t < *first) first = t;
  }
  return first;
}

PicturePoint nearestOnLine(const std::vector<PicturePoint>& line, bool closed, PicturePoint p) {
  PicturePoint best = line.front();
  const std::size_t sides = closed ? line.size() : line.size() - 1;
  for (std::size_t i = 0; i < sides; ++i) {
    const PicturePoint a = line[i], way = line[(i + 1) % line.size()] - a;
    const double squared = dot(way, way);
    const double t = squared > 0 ? std::clamp(dot(p - a, way) / squared, 0.0, 1.0) : 0.0;
    if (distance(a + way * t, p) < distance(best, p)) best = a + way * t;
  }
  return best;
}

bool isOnLine(const document::Drawing& drawing, PicturePoint p, double reach) {
  return std::ranges::any_of(drawing.lines, [&](const document::DrawnLine& line) {
    return geometry::distanceToLine(p, std::span<const PicturePoint>(line.points), line.closed) <= reach;
  });
}

/// Its points, and between them at least one in each `step`.
std::vector<PicturePoint> placesAlong(const std::vector<PicturePoint>& line, double step) {
  std::vector<PicturePoint> places{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double pieces = std::ceil(std::max(1.0, distance(line[i - 1], line[i]) / step));
    for (double k = 1; k <= pieces; ++k) places.push_back(lerp(line[i - 1], line[i], k / pieces));
  }
  return places;
}

/// Brings the last point of a line to what is there.
void meet(const document::Drawing& drawing, double reach, std::vector<PicturePoint>& line) {
  const double length = geometry::lengthOf(line), most = std::min(reach, kMostCut * length);
  std::optional<PicturePoint> end;
  for (const document::DrawnLine& other : drawing.lines) {
    if (other.closed) continue;
    for (const PicturePoint p : {other.points.front(), other.points.back()}) {
      const double away = distance(p, line.back());
      if (away <= std::min(reach, length / 2) && (!end || away < distance(*end, line.back()))) end = p;
    }
  }
  if (end) {
    line.push_back(*end);
    return;
  }
  // What runs past a line shortly before the end is cut there.
  double past = 0;
  for (std::size_t i = line.size() - 1; i > 0 && past <= most; --i) {
    std::optional<double> first;
    for (const document::DrawnLine& other : drawing.lines) {
      const auto at = firstCrossing(line[i - 1], line[i], other.points, other.closed);
      if (at && (!first || *at < *first)) first = at;
    }
    const double side = distance(line[i - 1], line[i]);
    if (first && past + side * (1 - *first) <= most) {
      line[i] = lerp(line[i - 1], line[i], *first);
      line.resize(i + 1);
      return;
    }
    past += side;
  }
  std::optional<PicturePoint> on;
  for (const document::DrawnLine& other : drawing.lines) {
    const PicturePoint p = nearestOnLine(other.points, other.closed, line.back());
    const double away = distance(p, line.back());
    if (away <= most && (!on || away < distance(*on, line.back()))) on = p;
  }
  if (on) line.push_back(*on);
}

/// A stroke that is one more dash after the last line.
struct NextDash {
  double gap = 0;          ///< between the two
  bool backwards = false;  ///< its last point is the nearer one
};
std::optional<NextDash> nextDash(const document::Drawing* drawing, const std::vector<PicturePoint>& stroke) {
  if (drawing == nullptr || drawing->lines.empty()) return std::nullopt;
  std::vector<descriptive::Line> lines = document::plainLines(*drawing);
  lines.push_back({stroke, {}, false});
  const std::vector<PicturePoint>& last = lines[lines.size() - 2].points;
  if (!descriptive::isDashAfter(lines[lines.size() - 2], lines.back(), descriptive::sizeOf(lines))) return std::nullopt;
  const auto gapTo = [&](PicturePoint p) { return std::min(distance(last.front(), p), distance(last.back(), p)); };
  const double front = gapTo(stroke.front()), back = gapTo(stroke.back());
  return NextDash{std::min(front, back), back < front};
}

}  // namespace

std::vector<Crossing> crossingsOn(const document::Document& document, const pipeline::Derived& derived,
                                  PictureId picture) {
  std::vector<Crossing> crossings;
  forDrawings(document, derived, picture, [&](const document::Drawing&, const pipeline::DerivedDrawing& one) {
    const descriptive::Model& model = one.shape->model;
    const auto partOf = [&](std::uint32_t solid) { return one.pieces[model.solids[solid].piece]; };
    for (std::size_t k = 0; k < model.orders.orders.size(); ++k) {
      const descriptive::Order& order = model.orders.orders[k];
      const Crossing crossing{partOf(order.over), partOf(order.under), model.orders.overlaps.all()[k].at,
                              order.from == descriptive::OrderFrom::Guessed};
      if (isShown(document, crossing.over) && isShown(document, crossing.under)) crossings.push_back(crossing);
    }
  });
  return crossings;
}

std::string crossingSentence(const document::Document& document, const Crossing& crossing) {
  const document::Part* over = document::findPart(document, crossing.over);
  const document::Part* under = document::findPart(document, crossing.under);
  if (over == nullptr || under == nullptr) return {};
  return std::string(words::tr("{front} is in front of {back} here.",
                               {{"front", words::nameOf(over->name)}, {"back", words::nameOf(under->name)}}));
}

const pipeline::DerivedDrawing* drawingOf(const pipeline::Derived& derived, PartId piece) {
  const auto own = std::ranges::find_if(derived.drawings, [&](const pipeline::DerivedDrawing& one) {
    return one.shape && std::ranges::count(one.pieces, piece) > 0;
  });
  return own == derived.drawings.end() ? nullptr : &*own;
}

std::optional<geometry::Turn> turnUpright(const document::Document& document, const pipeline::Derived& derived,
                                          PartId piece) {
  const document::Part* part = document::findPart(document, piece);
  const document::PictureEntry* entry = part ? document::findPicture(document, document::pictureOf(*part)) : nullptr;
  const pipeline::DerivedDrawing* own = drawingOf(derived, piece);
  const std::optional<ModelPoint> up = own ? upOf(*own, piece) : std::nullopt;
  if (entry == nullptr || !up) return std::nullopt;
  const pipeline::Copies copies = pipeline::copiesInWorld(part->placement, {}, entry->size);
  const geometry::Turn turn = geometry::turnTo(copies.begin()->along(*up), WorldPoint{0, 1, 0});
  return turn.w < std::cos(kUpright / 2) ? std::optional(turn) : std::nullopt;
}

std::optional<descriptive::SeenFrom> seenFrom(const document::Document& document, const pipeline::Derived& derived,
                                              PartId piece) {
  const document::Part* part = document::findPart(document, piece);
  const document::ElementRecipe* own = part ? document::elementOf(*part) : nullptr;
  const document::Drawing* drawing = own ? document::findDrawing(document, own->drawing) : nullptr;
  if (drawing == nullptr) return std::nullopt;
  const pipeline::DerivedDrawing* made = drawingOf(derived, piece);
  const bool hasAngles = own->kind != descriptive::PieceKind::Solid && made != nullptr && made->shape->model.up;
  if (!hasAngles && drawing->seenFrom != descriptive::SeenFrom::Unknown) return std::nullopt;
  return drawing->seenFrom;
}

std::vector<LooseEnd> looseEndsOf(const document::Document& document, const pipeline::DerivedDrawing& drawing) {
  std::vector<LooseEnd> ends;
  const document::Drawing* own = document::findDrawing(document, drawing.id);
  for (const pipeline::OpenEnd& end : drawing.shape->openEnds) {
    if (own != nullptr && end.line < own->lines.size()) ends.push_back({own->id, own->lines[end.line].id, end.at});
  }
  return ends;
}

std::vector<LooseEnd> looseEndsOn(const document::Document& document, const pipeline::Derived& derived,
                                  PictureId picture) {
  std::vector<LooseEnd> ends;
  forDrawings(document, derived, picture, [&](const document::Drawing&, const pipeline::DerivedDrawing& one) {
    const std::vector<LooseEnd> more = looseEndsOf(document, one);
    ends.insert(ends.end(), more.begin(), more.end());
  });
  return ends;
}

std::optional<WayToClose> wayToClose(const document::Document& document, const pipeline::Derived& derived,
                                     const LooseEnd& loose, std::optional<PicturePoint> end) {
  const document::Drawing* drawing = document::findDrawing(document, loose.drawing);
  const document::DrawnLine* line = drawing ? document::findLine(*drawing, loose.line) : nullptr;
  if (line == nullptr || line->points.empty()) return std::nullopt;
  std::vector<LooseEnd> own = looseEndsOn(document, derived, drawing->picture);
  std::erase_if(own, [&](const LooseEnd& one) {
    return one.drawing != loose.drawing || one.line != loose.line || (end && distance(one.at, *end) > kSamePlace);
  });
  std::optional<WayToClose> best;
  double least = distance(line->points.front(), line->points.back());
  for (const LooseEnd& one : own) {
    const bool atFirst = distance(one.at, line->points.front()) < distance(one.at, line->points.back());
    const bool hidden = std::ranges::any_of(line->hidden, [&](const descriptive::Stretch& stretch) {
      return atFirst ? stretch.from <= 0 : stretch.to >= 1;
    });
    for (const document::DrawnLine& other : drawing->lines) {
      if (other.id == loose.line || other.closed || other.points.empty()) continue;
      for (const PicturePoint to : {other.points.front(), other.points.back()}) {
        const double far = distance(one.at, to);
        if (far >= least) continue;
        least = far;
        best = {one.at, to, hidden};
      }
    }
  }
  return best;
}

LineMarks lineMarks(const document::Document& document, const pipeline::Derived& derived, const UiState& ui) {
  LineMarks marks;
  if (ui.tool != ToolKind::Lines) return marks;
  const auto onCanvas = [&](PicturePoint p) { return ui.pictureView.toClient(p, ui.layout.picture); };
  for (const LooseEnd& end : looseEndsOn(document, derived, ui.picture)) marks.looseEnds.push_back(onCanvas(end.at));
  std::vector<ClientPoint>& at = marks.crossings;
  for (const Crossing& crossing : crossingsOn(document, derived, ui.picture)) at.push_back(onCanvas(crossing.at));
  bool moved = true;
  for (int round = 0; round < kRounds && moved; ++round) {
    moved = false;
    for (std::size_t i = 0; i < at.size(); ++i) {
      for (std::size_t k = i + 1; k < at.size(); ++k) {
        const ClientPoint way = at[k] - at[i];
        const double length = std::hypot(way.x, way.y);
        if (length >= kApart - 0.5) continue;
        // Two at one place go to the sides.
        const ClientPoint by = length > 0.01 ? way * ((kApart - length) / (2 * length)) : ClientPoint{kApart / 2, 0};
        at[i] = at[i] - by;
        at[k] = at[k] + by;
        moved = true;
      }
    }
  }
  return marks;
}

int nearestOf(std::span<const ClientPoint> points, ClientPoint at, double reach) {
  int nearest = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double away = distance(points[i], at);
    if (away > reach) continue;
    reach = away;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

MeantLine meantLine(const document::Drawing* drawing, const std::vector<PicturePoint>& line, double reach) {
  MeantLine meant{line, false};
  std::vector<PicturePoint>& points = meant.points;
  if (points.size() < 2) return meant;
  const double length = geometry::lengthOf(points), gap = distance(points.front(), points.back());
  // What begins and ends on a line at two places is closed by that line.
  const bool onLines = gap > reach / 2 && drawing != nullptr && isOnLine(*drawing, points.front(), reach) &&
                       isOnLine(*drawing, points.back(), reach);
  meant.closed = points.size() > 3 && gap <= reach && length > kLongEnough * std::max(gap, reach) && !onLines;
  const std::optional<NextDash> dash = nextDash(drawing, line);
  if (dash) meant.closed = false;
  if (!meant.closed && drawing != nullptr) {
    // The end of a dash towards the one before stays where it was drawn.
    const double most = dash ? std::min(reach, dash->gap) : reach;
    if (!dash || !dash->backwards) meet(*drawing, most, points);
    std::ranges::reverse(points);
    if (!dash || dash->backwards) meet(*drawing, most, points);
    std::ranges::reverse(points);
  }
  points = geometry::simplifiedLine(std::span<const PicturePoint>(points), kThinning);
  return meant;
}

std::vector<LineId> drawnOver(const document::Document& document, const document::Drawing& drawing,
                              const document::DrawnLine& fresh, double reach) {
  const std::span<const PicturePoint> over(fresh.points);
  const auto lies = [&](const document::DrawnLine& line) {
    const bool isHidden = !line.hidden.empty();
    return isHidden == !fresh.hidden.empty() && geometry::lengthOf(line.points) > kLongEnough * reach &&
           std::ranges::all_of(placesAlong(line.points, reach), [&](PicturePoint p) {
             return geometry::distanceToLine(p, over, fresh.closed) <= reach;
           });
  };
  std::vector<LineId> lines = document::freeLines(document, drawing);
  std::erase_if(lines, [&](LineId id) { return !lies(*document::findLine(drawing, id)); });
  return lines;
}

}  // namespace spineloft::app
