#include "web/edit/depth_dots.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>

#include "engine/document/pieces.h"
#include "engine/geometry/polyline.h"
#include "web/edit/line_drawing.h"
#include "web/edit/placing.h"

namespace spineloft::app {
namespace {

/// Seen shorter than this share of its length, depth is not dragged.
constexpr double kLeastDepth = 0.15;
/// Of a line's length: a free place is not so near to a pin.
constexpr double kBesidePin = 0.05;
/// Of the size: corners of faces that are nearer are one.
constexpr double kOneCorner = 0.02;

/// What is derived of the piece; null without it.
const descriptive::ModelPiece* solidOf(const pipeline::Derived& derived, PartId piece) {
  const pipeline::DerivedDrawing* drawing = drawingOf(derived, piece);
  if (drawing == nullptr) return nullptr;
  const auto& solids = drawing->shape->model.solids;
  const auto solid = std::ranges::find_if(
      solids, [&](const descriptive::ModelPiece& one) { return drawing->pieces[one.piece] == piece; });
  return solid == solids.end() ? nullptr : &*solid;
}

/// A line that is measured to place dots on it.
struct Track {
  std::vector<PicturePoint> points;
  std::vector<double> s;
  explicit Track(const document::DrawnLine& line) : points(line.points) {
    if (line.closed) points.push_back(points.front());
    geometry::arcLengths(std::span<const PicturePoint>(points), s);
  }
  PicturePoint at(double share) const {
    return geometry::pointAt(std::span<const PicturePoint>(points), std::span<const double>(s), share * s.back());
  }
};

class Dots {
 public:
  /// `faced`: dots are at the corners of its faces, which may be beside where they were drawn.
  Dots(const document::Drawing& drawing, const descriptive::ModelPiece& solid, bool faced)
      : drawing_(drawing), solid_(solid), faced_(faced) {}

  void addPins(const document::ElementRecipe& piece) {
    for (const document::DepthPin& pin : drawing_.pins) {
      const bool isOwn = std::ranges::any_of(piece.outlines, [&](const document::LineOutline& outline) {
        return std::ranges::any_of(outline.runs, [&](const document::LineRun& run) {
          const auto [low, high] = std::minmax(run.from, run.to);
          return run.line == pin.line && pin.at >= low && pin.at <= high;
        });
      });
      if (isOwn) add(pin.line, pin.at, pin.z);
    }
  }
  void addFree(const document::LineOutline& outline) {
    double whole = 0;
    std::vector<double> lengths;
    for (const document::LineRun& run : outline.runs) {
      const document::DrawnLine* line = document::findLine(drawing_, run.line);
      lengths.push_back(line ? Track(*line).s.back() * std::abs(run.to - run.from) : 0);
      whole += lengths.back();
    }
    for (std::size_t i = 0; i < outline.runs.size() && whole > 0; ++i) {
      const document::LineRun& run = outline.runs[i];
      const double count = faced_ ? 1 : std::max(1.0, std::round(kDots * lengths[i] / whole));
      for (double k = 0; k < count; ++k) {
        const double way = faced_ ? 0 : (k + 0.5) / count, at = run.from + (run.to - run.from) * way;
        if (lengths[i] > 0 && !isTaken(run.line, at)) add(run.line, at, std::nullopt);
      }
    }
  }
  std::vector<DepthDot> take() { return std::move(dots_); }

 private:
  bool isTaken(LineId line, double at) const {
    const ModelPoint where = placeOf(Track(*document::findLine(drawing_, line)).at(at));
    return std::ranges::any_of(dots_, [&](const DepthDot& dot) {
      if (faced_ && std::hypot(dot.where.x - where.x, dot.where.y - where.y) < kOneCorner * span()) return true;
      return dot.line == line && std::abs(dot.at - at) < kBesidePin;
    });
  }
  double span() const {
    double low = INFINITY, high = -INFINITY;
    for (const ModelPoint& p : solid_.rim) {
      low = std::min({low, p.x, p.y});
      high = std::max({high, p.x, p.y});
    }
    return high - low;
  }
  /// `pinned`: the depth that is given; else that of the nearest place of the rim.
  void add(LineId id, double at, std::optional<double> pinned) {
    const document::DrawnLine* line = document::findLine(drawing_, id);
    if (line == nullptr) return;
    const PicturePoint p = Track(*line).at(at);
    ModelPoint where = placeOf(p);
    // A pin of a solid with edges may be between its corners.
    const bool isCorner = faced_ && std::hypot(where.x - p.x, where.y + p.y) < kOneCorner * span();
    if (pinned && !isCorner) where = {p.x, -p.y, *pinned};
    dots_.push_back({drawing_.id, id, at, where, {}, pinned.has_value()});
  }
  /// A drawn place at the depth of the rim nearest to it, or the corner of a face.
  ModelPoint placeOf(PicturePoint p) const {
    const auto away = [&](const ModelPoint& r) { return std::hypot(r.x - p.x, r.y + p.y); };
    const ModelPoint nearest = std::ranges::min(solid_.rim, {}, away);
    return faced_ ? nearest : ModelPoint{p.x, -p.y, nearest.z};
  }

  const document::Drawing& drawing_;
  const descriptive::ModelPiece& solid_;
  bool faced_ = false;
  std::vector<DepthDot> dots_;
};

}  // namespace

std::vector<DepthDot> dotsOfPiece(const document::Document& document, const pipeline::Derived& derived,
                                  const UiState& ui) {
  const document::Part* part = document::findPart(document, ui.selection);
  const document::ElementRecipe* piece = part ? document::elementOf(*part) : nullptr;
  if (piece == nullptr || !pipeline::isVisible(document, *part)) return {};
  const document::Drawing* drawing = document::findDrawing(document, piece->drawing);
  const document::PictureEntry* entry = document::findPicture(document, piece->picture);
  const descriptive::ModelPiece* solid = solidOf(derived, part->id);
  if (drawing == nullptr || entry == nullptr || solid == nullptr || solid->rim.empty()) return {};
  const pipeline::Copies copies = shownCopies(ui, *part, entry->size);
  const pipeline::ToWorld& toWorld = *copies.begin();
  const double facing = dot(normalized(toWorld.along({0, 0, 1})), ui.camera.back());
  if (std::sqrt(std::max(0.0, 1 - facing * facing)) < kLeastDepth) return {};
  Dots dots(*drawing, *solid, piece->kind == descriptive::PieceKind::Solid);
  dots.addPins(*piece);
  for (const document::LineOutline& outline : piece->outlines) {
    dots.addFree(outline);
  }
  std::vector<DepthDot> all = dots.take();
  std::erase_if(all, [&](DepthDot& dot) {
    const auto seen = pointOnCanvas(ui.camera, ui.layout.solid, toWorld(dot.where));
    dot.seen = seen.value_or(ClientPoint{});
    return !seen.has_value();
  });
  return all;
}

}  // namespace spineloft::app
