#include "engine/document/update_drawings.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "engine/descriptive/dashes.h"
#include "engine/descriptive/wireframe.h"
#include "engine/document/checks.h"
#include "engine/document/pieces.h"
#include "engine/document/update_parts.h"

namespace spineloft::document {
namespace {

/// Changes the drawing with this id: `change` gets a copy and says whether it may replace the original. Error:
/// NoSuchLine.
template <class Change>
Status editDrawing(Document& document, DrawingId id, const Change& change) {
  const auto at = std::ranges::find_if(document.drawings, [&](const Drawing& drawing) { return drawing.id == id; });
  if (at == document.drawings.end()) return Error::NoSuchLine;
  Drawing copy = *at;
  if (Status status = change(copy); !status) return status;
  *at = std::move(copy);
  return Done{};
}

/// The same for one of its lines.
template <class Change>
Status editLine(Document& document, DrawingId id, LineId line, const Change& change) {
  return editDrawing(document, id, [&](Drawing& drawing) -> Status {
    const auto at = std::ranges::find(drawing.lines, line, &DrawnLine::id);
    if (at == drawing.lines.end()) return Error::NoSuchLine;
    change(*at);
    return checkLines(document, drawing);
  });
}

/// Changes every piece of a drawing; one without outlines goes.
template <class Change>
void editPieces(Document& document, DrawingId drawing, const Change& change) {
  std::vector<PartId> gone;
  for (Box<Part>& box : document.parts) {
    const ElementRecipe* element = elementOf(*box);
    if (element == nullptr || element->drawing != drawing) continue;
    Part part = box;
    if (!change(part.id, *elementOf(part))) continue;
    if (elementOf(part)->outlines.empty()) gone.push_back(part.id);
    box = std::move(part);
  }
  for (const PartId id : gone) erasePart(document, id);
}

/// Outlines whose lines count by their place in the list, as the document has them.
std::vector<LineOutline> outlinesOf(const Drawing& drawing, const std::vector<descriptive::Outline>& outlines) {
  std::vector<LineOutline> out;
  for (const descriptive::Outline& runs : outlines) {
    LineOutline& outline = out.emplace_back();
    for (const auto& [line, from, to] : runs) outline.runs.push_back({drawing.lines[line].id, from, to});
  }
  return out;
}

/// Makes pieces of what the lines of a drawing enclose.
class Encloser {
 public:
  Encloser(Document& document, DrawingId id) : document_(document), drawing_(*findDrawing(document, id)) {}

  /// Outlines that have the changed line, or only lines of no piece, become pieces. One that has a line of a piece
  /// already becomes the outline of that piece; of several pieces the oldest stays. So do the faces of a solid whose
  /// edges are drawn; hidden ones that are missing are drawn.
  Status enclose(LineId changed, const Look& look) {
    Result<Measured> measured = measure();
    if (!measured) return measured.failure();
    const std::vector<descriptive::Line> missing =
        descriptive::missingEdges(measured.value().drawn, measured.value().lines, measured.value().nodes);
    if (!missing.empty()) {
      if (Status status = addLines(missing); !status) return status;
      measured = measure();
      if (!measured) return measured.failure();
    }
    const std::vector<LineId> free = freeLines(document_, drawing_);
    const auto isFree = [&](const LineRun& run) { return std::ranges::find(free, run.line) != free.end(); };
    const auto& [drawn, lines, nodes, size] = measured.value();
    for (const descriptive::Piece& piece : descriptive::proposePieces(lines, nodes, size)) {
      const std::vector<LineOutline> outlines = outlinesOf(drawing_, piece.outlines);
      const bool isSolid = piece.kind == descriptive::PieceKind::Solid;
      const auto mayBe = [&](const LineOutline& outline) {
        const bool isNew = std::ranges::all_of(
            outline.runs, [&](const LineRun& run) { return (!isSolid && !isWhole(run)) || isFree(run); });
        return isNew || (isSolid ? has(outline, changed) : owns(outline, changed));
      };
      if (!std::ranges::any_of(outlines, mayBe)) continue;
      if (Status status = isSolid ? takeSolid(outlines, look) : take(outlines[0], look); !status) return status;
    }
    return Done{};
  }
  /// The same for solids whose edges are drawn alone.
  Status encloseSolids(LineId changed, const Look& look) {
    const Result<Measured> measured = measure();
    if (!measured) return measured.failure();
    const auto& [drawn, lines, nodes, size] = measured.value();
    for (const std::vector<descriptive::Outline>& faces : descriptive::proposeWireframes(lines, nodes, size)) {
      const std::vector<LineOutline> outlines = outlinesOf(drawing_, faces);
      if (!std::ranges::any_of(outlines, [&](const LineOutline& one) { return has(one, changed); })) continue;
      if (Status status = takeSolid(outlines, look); !status) return status;
    }
    return Done{};
  }

 private:
  static bool has(const LineOutline& outline, LineId line) {
    return std::ranges::find(outline.runs, line, &LineRun::line) != outline.runs.end();
  }
  struct Measured {
    std::vector<descriptive::Line> drawn;
    std::vector<descriptive::MeasuredLine> lines;
    std::vector<descriptive::Node> nodes;
    double size = 0;
  };
  Result<Measured> measure() const {
    Measured out{plainLines(drawing_), {}, {}, 0};
    Result<std::vector<descriptive::MeasuredLine>> lines = descriptive::meetingLines(out.drawn);
    if (!lines) return lines.failure();
    out.lines = std::move(lines).value();
    out.size = descriptive::sizeOf(out.drawn);
    out.nodes = descriptive::nodesOf(out.lines, out.size);
    return out;
  }
  Status addLines(const std::vector<descriptive::Line>& lines) {
    Status added = editDrawing(document_, drawing_.id, [&](Drawing& drawing) {
      for (const descriptive::Line& line : lines) {
        drawing.lines.push_back({LineId{++drawing.lastLineId}, line.points, line.hidden, line.closed});
      }
      return checkLines(document_, drawing);
    });
    if (added) drawing_ = *findDrawing(document_, drawing_.id);
    return added;
  }
  /// The oldest piece that has one of these lines becomes the solid; others that have one go.
  Status takeSolid(const std::vector<LineOutline>& faces, const Look& look) {
    const auto shares = [&](const LineOutline& old) {
      return std::ranges::any_of(faces, [&](const LineOutline& face) {
        return std::ranges::any_of(face.runs, [&](const LineRun& run) { return has(old, run.line); });
      });
    };
    PartId owner;
    for (const Part* part : piecesOf(document_, drawing_.id)) {
      if (!owner && std::ranges::any_of(elementOf(*part)->outlines, shares)) owner = part->id;
    }
    if (!owner) return addPiece(faces, descriptive::PieceKind::Solid, look);
    editPieces(document_, drawing_.id, [&](PartId id, ElementRecipe& element) {
      if (!std::ranges::any_of(element.outlines, shares)) return false;
      element.outlines = id == owner ? faces : std::vector<LineOutline>{};
      if (id == owner) element.kind = descriptive::PieceKind::Solid;
      return true;
    });
    return Done{};
  }
  Status addPiece(std::vector<LineOutline> outlines, descriptive::PieceKind kind, const Look& look) {
    if (Status room = roomForPart(document_); !room) return room;
    if (piecesOf(document_, drawing_.id).size() >= descriptive::kMostPieces) {
      return {Error::ValueOutOfRange, "too many pieces"};
    }
    ElementRecipe recipe;
    recipe.picture = drawing_.picture;
    recipe.drawing = drawing_.id;
    recipe.kind = kind;
    recipe.outlines = std::move(outlines);
    addPart(document_, std::move(recipe), look);
    return Done{};
  }
  Status take(const LineOutline& outline, const Look& look) {
    const auto isReplaced = [&](const LineOutline& old) {
      return std::ranges::any_of(old.runs, [&](const LineRun& run) { return isWhole(run) && owns(outline, run.line); });
    };
    PartId owner;
    for (const Part* part : piecesOf(document_, drawing_.id)) {
      if (!owner && std::ranges::any_of(elementOf(*part)->outlines, isReplaced)) owner = part->id;
    }
    if (!owner) return addPiece({outline}, descriptive::PieceKind::Round, look);
    editPieces(document_, drawing_.id, [&](PartId id, ElementRecipe& element) {
      const auto first = std::ranges::find_if(element.outlines, isReplaced);
      if (first == element.outlines.end()) return false;
      if (id == owner) *first = outline;
      element.outlines.erase(std::remove_if(id == owner ? first + 1 : first, element.outlines.end(), isReplaced),
                             element.outlines.end());
      return true;
    });
    return Done{};
  }

  Document& document_;
  Drawing drawing_;
};

/// A line goes from an outline, which closes without it; whether anything of its own is left. A face needs two edges.
bool leaves(LineOutline& outline, LineId line, bool isFace) {
  std::erase_if(outline.runs, [&](const LineRun& run) { return run.line == line; });
  return isFace ? outline.runs.size() > 1 : std::ranges::any_of(outline.runs, isWhole);
}

/// Lines go, out of the pieces and marks of the drawing too.
void eraseLines(Document& document, Drawing& drawing, const std::set<LineId>& gone) {
  const auto isGone = [&](const auto& mark) { return gone.contains(mark.line); };
  std::erase_if(drawing.lines, [&](const DrawnLine& line) { return gone.contains(line.id); });
  std::erase_if(drawing.pins, isGone);
  std::erase_if(drawing.folds, isGone);
  editPieces(document, drawing.id, [&](PartId, ElementRecipe& element) {
    bool changed = false;
    std::erase_if(element.outlines, [&](LineOutline& outline) {
      bool whole = true;
      for (const LineId line : gone) {
        if (std::ranges::find(outline.runs, line, &LineRun::line) == outline.runs.end()) continue;
        changed = true;
        whole = leaves(outline, line, element.kind == descriptive::PieceKind::Solid);
      }
      return !whole;
    });
    return changed;
  });
}

/// Gives a piece another kind; one that becomes or was a solid gets other outlines. Error: ShapeInvalid where its lines
/// are no edges of a solid.
Status shapeElement(const Document& document, ElementRecipe& element, descriptive::PieceKind kind) {
  using descriptive::PieceKind;
  if (element.kind == kind) return Done{};
  if (element.kind == PieceKind::Solid || kind == PieceKind::Solid) {
    const Drawing& drawing = *findDrawing(document, element.drawing);
    const PlainDrawing plain = plainDrawing(document, drawing);
    const auto lines = descriptive::meetingLines(plain.drawing.lines);
    if (!lines) return lines.failure();
    const double size = descriptive::sizeOf(plain.drawing.lines);
    std::vector<descriptive::Outline> outlines;
    if (kind == PieceKind::Solid) {
      const std::vector<LineId> own = linesOf(element);
      const auto isOwn = [&](const descriptive::Run& run) {
        return std::ranges::binary_search(own, drawing.lines[run.line].id);
      };
      const auto nodes = descriptive::nodesOf(lines.value(), size);
      for (auto& faces : descriptive::proposeWireframes(lines.value(), nodes, size)) {
        const bool isIt =
            std::ranges::any_of(faces, [&](const auto& face) { return std::ranges::any_of(face, isOwn); });
        if (isIt) outlines = std::move(faces);
      }
      if (outlines.empty()) return {Error::ShapeInvalid, "its lines are no edges of a solid"};
    } else {
      const descriptive::Piece piece = pieceOf(drawing, element, plain.drawing.size);
      Result<descriptive::Outline> silhouette = descriptive::silhouetteOf(lines.value(), piece.outlines, size);
      if (!silhouette) return silhouette.failure();
      outlines = {std::move(silhouette).value()};
    }
    element.outlines = outlinesOf(drawing, outlines);
  }
  element.kind = kind;
  return Done{};
}

/// Lines of no piece at the end of the list that are dashes become one hidden line.
void joinDashes(const Document& document, Drawing& drawing) {
  const std::vector<descriptive::Line> lines = plainLines(drawing);
  const double size = descriptive::sizeOf(lines);
  const std::size_t from = descriptive::firstDash(lines, size);
  std::optional<descriptive::Line> dashed = descriptive::dashedLine(lines, from, lines.size(), size);
  if (!dashed) return;
  const std::vector<LineId> free = freeLines(document, drawing);
  const auto first = drawing.lines.begin() + static_cast<std::ptrdiff_t>(from);
  const auto isMarked = [&](const auto& marks, LineId id) {
    return std::ranges::find(marks, id, &std::decay_t<decltype(marks[0])>::line) != marks.end();
  };
  const bool isFree = std::ranges::all_of(first, drawing.lines.end(), [&](const DrawnLine& line) {
    return std::ranges::find(free, line.id) != free.end() && !isMarked(drawing.pins, line.id) &&
           !isMarked(drawing.folds, line.id);
  });
  if (!isFree) return;
  drawing.lines.erase(first, drawing.lines.end());
  drawing.lines.push_back({LineId{++drawing.lastLineId}, std::move(dashed->points), dashed->hidden, dashed->closed});
}

}  // namespace

Status applyDrawing(Document& document, const DrawLine& a) {
  if (findPicture(document, a.picture) == nullptr) return Error::NoSuchPicture;
  const Drawing* there = drawingOn(document, a.picture);
  if (there == nullptr) {
    if (document.drawings.size() >= kMostDrawings) return {Error::ValueOutOfRange, "too many drawings"};
    Drawing drawing;
    drawing.id = DrawingId{++document.lastDrawingId};
    drawing.picture = a.picture;
    document.drawings.push_back(std::move(drawing));
    there = &document.drawings.back().get();
  }
  const DrawingId id = there->id;
  LineId line;
  const Status drawn = editDrawing(document, id, [&](Drawing& drawing) {
    line = LineId{++drawing.lastLineId};
    drawing.lines.push_back({line, a.points, a.hidden, a.closed});
    if (Status sound = checkLines(document, drawing); !sound) return sound;
    joinDashes(document, drawing);
    line = drawing.lines.back().id;
    return checkLines(document, drawing);
  });
  if (!drawn) return drawn;
  return Encloser(document, id).enclose(line, a.look);
}

Status applyDrawing(Document& document, const CloseLine& a) {
  const Status closed = editLine(document, a.drawing, a.line, [](DrawnLine& line) { line.closed = true; });
  if (!closed) return closed;
  return Encloser(document, a.drawing).enclose(a.line, a.look);
}

Status applyDrawing(Document& document, const HideLine& a) {
  const Status hidden = editLine(document, a.drawing, a.line, [&](DrawnLine& line) { line.hidden = a.hidden; });
  if (!hidden) return hidden;
  return Encloser(document, a.drawing).encloseSolids(a.line, {});
}

Status applyDrawing(Document& document, const DeleteLine& a) {
  const Drawing* there = findDrawing(document, a.drawing);
  if (there == nullptr || findLine(*there, a.line) == nullptr) return Error::NoSuchLine;
  Drawing drawing = *there;
  eraseLines(document, drawing, {a.line});
  return editDrawing(document, a.drawing, [&](Drawing& whole) -> Status {
    whole = std::move(drawing);
    return Done{};
  });
}

Status applyDrawing(Document& document, const OrderPieces& a) {
  const Part *over = findPart(document, a.over), *under = findPart(document, a.under);
  if (over == nullptr || under == nullptr) return Error::NoSuchPart;
  const ElementRecipe *front = elementOf(*over), *back = elementOf(*under);
  if (front == nullptr || back == nullptr) return Error::NotAPiece;
  if (a.over == a.under || front->drawing != back->drawing || !isFinite(a.at)) return {Error::ValueOutOfRange, "order"};
  return editDrawing(document, front->drawing, [&](Drawing& drawing) -> Status {
    std::erase_if(drawing.orders, [&](const PieceOrder& old) {
      const bool same = (old.over == a.over && old.under == a.under) || (old.over == a.under && old.under == a.over);
      return same && old.at == a.at;
    });
    drawing.orders.push_back({a.over, a.under, a.at});
    return checkDrawing(document, drawing);
  });
}

Status applyDrawing(Document& document, const PinDepth& a) {
  return editDrawing(document, a.drawing, [&](Drawing& drawing) -> Status {
    std::erase_if(drawing.pins, [&](const DepthPin& pin) { return pin.line == a.line && pin.at == a.at; });
    if (a.z) drawing.pins.push_back({a.line, a.at, *a.z});
    return checkDrawing(document, drawing);
  });
}

Status applyDrawing(Document& document, const SeeDrawing& a) {
  return editDrawing(document, a.drawing, [&](Drawing& drawing) -> Status {
    drawing.seenFrom = a.from;
    return checkDrawing(document, drawing);
  });
}

Status applyDrawing(Document& document, const ShapePiece& a) {
  const auto at = std::ranges::find_if(document.parts, [&](const Part& part) { return part.id == a.part; });
  if (at == document.parts.end()) return Error::NoSuchPart;
  Part part = *at;
  ElementRecipe* element = elementOf(part);
  if (element == nullptr) return Error::NotAPiece;
  if (Status shaped = shapeElement(document, *element, a.kind); !shaped) return shaped;
  if (Status sound = checkElement(document, *element); !sound) return sound;
  *at = std::move(part);
  return Done{};
}

void settleDrawings(const Document& before, Document& document) {
  if (before.drawings.empty() && document.drawings.empty()) return;
  std::map<DrawingId, std::set<LineId>> loose;
  for (const Box<Part>& old : before.parts) {
    const ElementRecipe* was = elementOf(*old);
    if (was == nullptr) continue;
    const Part* now = findPart(document, old->id);
    const ElementRecipe* is = now == nullptr ? nullptr : elementOf(*now);
    if (is != nullptr && is->drawing == was->drawing) continue;
    for (const LineId line : linesOf(*was)) loose[was->drawing].insert(line);
  }
  for (Box<Drawing>& box : document.drawings) {
    Drawing drawing = box;
    if (std::set<LineId>& lines = loose[drawing.id]; !lines.empty()) {
      for (const Part* part : piecesOf(document, drawing.id)) {
        std::erase_if(lines, [&](LineId line) { return owns(*elementOf(*part), line); });
      }
      eraseLines(document, drawing, lines);
    }
    const std::vector<const Part*> pieces = piecesOf(document, drawing.id);
    const auto isPiece = [&](PartId id) { return std::ranges::find(pieces, id, &Part::id) != pieces.end(); };
    std::erase_if(drawing.orders,
                  [&](const PieceOrder& order) { return !isPiece(order.over) || !isPiece(order.under); });
    if (!(*box == drawing)) box = std::move(drawing);
  }
  std::erase_if(document.drawings, [&](const Drawing& drawing) {
    return drawing.lines.empty() || findPicture(document, drawing.picture) == nullptr;
  });
}

Status copyDrawings(Document& document, const std::vector<std::pair<PartId, PartId>>& originals) {
  std::map<DrawingId, Drawing> copies;  // by the original
  std::map<PartId, PartId> copyOf;
  for (const auto& [original, copy] : originals) copyOf[original] = copy;
  for (Box<Part>& box : document.parts) {
    const bool isCopy = std::ranges::any_of(originals, [&](const auto& pair) { return pair.second == box->id; });
    if (!isCopy || elementOf(*box) == nullptr) continue;
    Part part = box;
    ElementRecipe& element = *elementOf(part);
    const auto [at, isNew] = copies.try_emplace(element.drawing);
    if (isNew) {
      at->second = *findDrawing(document, element.drawing);
      at->second.id = DrawingId{++document.lastDrawingId};
    }
    element.drawing = at->second.id;
    box = std::move(part);
  }
  if (document.drawings.size() + copies.size() > kMostDrawings) return {Error::ValueOutOfRange, "too many drawings"};
  for (auto& [original, drawing] : copies) {
    std::vector<PieceOrder> orders;
    for (PieceOrder order : drawing.orders) {
      if (!copyOf.contains(order.over) || !copyOf.contains(order.under)) continue;
      orders.push_back({copyOf[order.over], copyOf[order.under], order.at});
    }
    drawing.orders = std::move(orders);
    std::set<LineId> unused;
    for (const DrawnLine& line : drawing.lines) unused.insert(line.id);
    for (const Part* part : piecesOf(document, drawing.id)) {
      for (const LineOutline& outline : elementOf(*part)->outlines) {
        for (const LineRun& run : outline.runs) unused.erase(run.line);
      }
    }
    eraseLines(document, drawing, unused);
    document.drawings.push_back(std::move(drawing));
  }
  return Done{};
}

}  // namespace spineloft::document
