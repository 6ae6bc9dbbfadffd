// Line drawings in the document: what lines close becomes pieces, and what goes with what.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <limits>

#include "engine/document/checks.h"
#include "engine/document/pieces.h"
#include "engine/document/renumber.h"
#include "engine/document/update.h"
#include "tests/support/after.h"
#include "tests/support/line_creature.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::testing;

namespace {

constexpr PictureId kPaper{1};
constexpr DrawingId kDrawing{1};

Document paper() { return after({}, {AddSketch{"paper", {1000, 800}}}); }
Document drawnCreature() { return after(paper(), creature(kPaper)); }

/// The lines that a piece has whole.
std::vector<std::uint32_t> ownLines(const Document& document, std::size_t part) {
  std::vector<std::uint32_t> lines;
  const ElementRecipe* piece = elementOf(*document.parts.at(part));
  REQUIRE(piece != nullptr);
  for (const LineOutline& outline : piece->outlines) {
    for (const LineRun& run : outline.runs) {
      if (isWhole(run)) lines.push_back(run.line.value);
    }
  }
  std::ranges::sort(lines);
  return lines;
}
using Lines = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("what lines close becomes a piece, and a line that completes an outline keeps the piece") {
  const std::vector<Action> gestures = creature(kPaper);
  Document document = after(paper(), {gestures[0]});
  REQUIRE(document.parts.size() == 1);
  CHECK(ownLines(document, 0) == Lines{1});
  // What is seen of a leg ends on the body, and goes on behind it.
  document = after(document, {gestures[1]});
  REQUIRE(document.parts.size() == 2);
  CHECK(ownLines(document, 1) == Lines{2});
  CHECK(elementOf(*document.parts[1])->outlines[0].runs.size() == 1);
  const PartId leg = document.parts[1]->id;
  document = after(document, {RenamePart{leg, "Leg"}, gestures[2]});
  REQUIRE(document.parts.size() == 2);
  CHECK(document.parts[1]->id == leg);
  CHECK(document.parts[1]->name == "Leg");
  CHECK(ownLines(document, 1) == Lines{2, 3});
  document = after(document, {gestures[3], gestures[4], gestures[5]});
  CHECK(document.parts.size() == 4);
  CHECK(document.drawings.size() == 1);
  CHECK(freeLines(document, *document.drawings[0]).empty());
  for (const Part& part : document.parts) CHECK(checkElement(document, *elementOf(part)).ok());
  CHECK(checkDrawing(document, *document.drawings[0]).ok());
}

TEST_CASE("a line that closes nothing waits, and one more that meets both its ends makes the piece") {
  const std::vector<PicturePoint> left{{300, 300}, {200, 400}, {300, 500}}, right{{300, 500}, {400, 400}, {300, 300}};
  Document document = after(paper(), {DrawLine{kPaper, left}});
  CHECK(document.parts.empty());
  CHECK(freeLines(document, *document.drawings[0]) == std::vector<LineId>{LineId{1}});
  const Document both = after(document, {DrawLine{kPaper, right}});
  REQUIRE(both.parts.size() == 1);
  CHECK(ownLines(both, 0) == Lines{1, 2});
  const Document closed = after(document, {CloseLine{kDrawing, LineId{1}}});
  REQUIRE(closed.parts.size() == 1);
  CHECK(closed.drawings[0]->lines[0].closed);
}

TEST_CASE("dashes between the ends of a line become its hidden part; such as lead nowhere or are hidden do not") {
  Document document = after(paper(), {DrawLine{kPaper, bodyLine(), {}, true}, DrawLine{kPaper, legLine(360, 120)}});
  const Document leg = document;
  const auto dashes = dashesOf(hipLine(360, 120));
  for (std::size_t k = 0; k < dashes.size(); ++k) {
    document = after(document, {DrawLine{kPaper, dashes[k]}});
    const std::size_t expected = k + 1 < dashes.size() ? 3 + k : 3;
    CHECK(document.drawings[0]->lines.size() == expected);
  }
  const DrawnLine& hidden = document.drawings[0]->lines.back();
  CHECK(hidden.hidden == std::vector<descriptive::Stretch>{{0, 1}});
  CHECK(hidden.points.front() == legLine(360, 120).back());
  CHECK(hidden.points.back() == legLine(360, 120).front());
  REQUIRE(document.parts.size() == 2);
  CHECK(ownLines(document, 1) == Lines{2, hidden.id.value});
  CHECK(checkDrawing(document, *document.drawings[0]).ok());
  Document nowhere = after(paper(), {DrawLine{kPaper, bodyLine(), {}, true}}), behind = leg;
  for (const auto& dash : dashes) {
    nowhere = after(nowhere, {DrawLine{kPaper, dash}});
    behind = after(behind, {DrawLine{kPaper, dash, {{0, 1}}}});
  }
  CHECK(nowhere.drawings[0]->lines.size() == 1 + dashes.size());
  CHECK(behind.drawings[0]->lines.size() == 2 + dashes.size());
}

TEST_CASE("lines go with their pieces, outlines close straight where a line goes, and an empty drawing is none") {
  const Document document = drawnCreature();
  // The body has its line only; the legs have none of it left.
  const Document bodiless = after(document, {DeletePart{PartId{1}}});
  CHECK(bodiless.parts.size() == 3);
  CHECK(findLine(*bodiless.drawings[0], LineId{1}) == nullptr);
  CHECK(bodiless.drawings[0]->lines.size() == 5);
  for (const Part& part : bodiless.parts) CHECK(checkElement(bodiless, *elementOf(part)).ok());
  // A leg without its hip closes straight; without a line of its own it is gone.
  const Document hipless = after(document, {DeleteLine{kDrawing, LineId{3}}});
  REQUIRE(hipless.parts.size() == 4);
  CHECK(ownLines(hipless, 1) == Lines{2});
  CHECK(after(hipless, {DeleteLine{kDrawing, LineId{2}}}).parts.size() == 3);
  Document none = document;
  for (const std::uint32_t part : {1u, 2u, 3u, 4u}) none = after(none, {DeletePart{PartId{part}}});
  CHECK(none.drawings.empty());
  CHECK(none.parts.empty());
  const Document gone = after(document, {RemovePicture{kPaper}});
  CHECK(gone.drawings.empty());
  CHECK(gone.parts.empty());
  // What becomes another kind of part is no piece any more.
  const Region square{kPaper, {{{100, 100}, {200, 100}, {200, 200}, {100, 200}}}, 0};
  const Document other = after(document, {RemakePart{PartId{4}, square, inflate::InflateParams{}}});
  CHECK(findLine(*other.drawings[0], LineId{6}) == nullptr);
}

TEST_CASE("orders are of two pieces of one drawing, the last one at a place counts, and they go with their pieces") {
  Document document = drawnCreature();
  const PicturePoint at{395, 530};
  document = after(document, {OrderPieces{PartId{2}, PartId{1}, at}, OrderPieces{PartId{1}, PartId{4}, {700, 400}}});
  CHECK(document.drawings[0]->orders.size() == 2);
  document = after(document, {OrderPieces{PartId{1}, PartId{2}, at}});
  REQUIRE(document.drawings[0]->orders.size() == 2);
  CHECK(document.drawings[0]->orders.back() == PieceOrder{PartId{1}, PartId{2}, at});
  CHECK(errorOf(document, OrderPieces{PartId{1}, PartId{1}, at}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, OrderPieces{PartId{1}, PartId{9}, at}) == Error::NoSuchPart);
  const Document more = after(document, {DrawSpine{kPaper, {{100, 100}, {300, 100}}}});
  CHECK(errorOf(more, OrderPieces{PartId{1}, more.parts.back()->id, at}) == Error::NotAPiece);
  CHECK(after(document, {DeletePart{PartId{2}}}).drawings[0]->orders.size() == 1);
}

TEST_CASE("copies are pieces of a drawing of their own, with their lines and the orders among them") {
  const Document document =
      after(drawnCreature(), {OrderPieces{PartId{2}, PartId{1}, {395, 530}}, PinDepth{kDrawing, LineId{2}, 0.5, 12.0}});
  const Document both = after(document, {DuplicateParts{{PartId{1}, PartId{2}}, {1, 0, 0}, {}}});
  REQUIRE(both.drawings.size() == 2);
  REQUIRE(both.parts.size() == 6);
  const Drawing& copy = both.drawings[1];
  CHECK(copy.lines.size() == 3);
  CHECK(copy.pins == std::vector<DepthPin>{{LineId{2}, 0.5, 12}});
  REQUIRE(copy.orders.size() == 1);
  for (const PartId part : {copy.orders[0].over, copy.orders[0].under}) {
    CHECK(elementOf(*findPart(both, part))->drawing == copy.id);
  }
  CHECK(both.drawings[0] == document.drawings[0]);
  const Document alone = after(document, {DuplicateParts{{PartId{2}}, {1, 0, 0}, {}}});
  CHECK(alone.drawings[1]->orders.empty());
  CHECK(checkDrawing(alone, *alone.drawings[1]).ok());
}

TEST_CASE("lines that cannot be are refused with their reason, and nothing changes") {
  const Document document = drawnCreature();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<PicturePoint> fine{{100, 100}, {200, 150}};
  CHECK(errorOf(document, DrawLine{PictureId{7}, fine}) == Error::NoSuchPicture);
  CHECK(errorOf(document, DrawLine{kPaper, {}}) == Error::StrokeTooShort);
  CHECK(errorOf(document, DrawLine{kPaper, {{100, 100}}}) == Error::StrokeTooShort);
  CHECK(errorOf(document, DrawLine{kPaper, {{100, 100}, {100.2, 100}}}) == Error::StrokeTooShort);
  CHECK(errorOf(document, DrawLine{kPaper, {{100, 100}, {200, 100}, {100, 100}}, {}, true}) == Error::StrokeTooShort);
  CHECK(errorOf(document, DrawLine{kPaper, {{100, 100}, {nan, 150}}}) == Error::StrokeNotFinite);
  CHECK(errorOf(document, DrawLine{kPaper, {{-300, -300}, {-200, -200}}}) == Error::StrokeOutsidePicture);
  CHECK(errorOf(document, DrawLine{kPaper, fine, {{0.5, 0.2}}}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, DrawLine{kPaper, fine, {{0, 0.5}, {0.4, 0.6}}}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, HideLine{kDrawing, LineId{99}, {}}) == Error::NoSuchLine);
  CHECK(errorOf(document, HideLine{DrawingId{5}, LineId{1}, {}}) == Error::NoSuchLine);
  CHECK(errorOf(document, DeleteLine{kDrawing, LineId{99}}) == Error::NoSuchLine);
  CHECK(errorOf(document, CloseLine{kDrawing, LineId{99}}) == Error::NoSuchLine);
  CHECK(errorOf(document, PinDepth{kDrawing, LineId{99}, 0.5, 1.0}) == Error::NoSuchLine);
  CHECK(errorOf(document, PinDepth{kDrawing, LineId{1}, 1.5, 1.0}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, PinDepth{kDrawing, LineId{1}, 0.5, nan}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, ShapePiece{PartId{9}, descriptive::PieceKind::Flat}) == Error::NoSuchPart);
  std::vector<PicturePoint> endless;
  for (int i = 0; i < 100001; ++i) endless.push_back({10 + i % 900 * 1.0, 10 + i % 7 * 100.0});
  CHECK(errorOf(document, DrawLine{kPaper, endless}) == Error::ValueOutOfRange);
  Document many = paper();
  Drawing full;
  full.id = kDrawing;
  full.picture = kPaper;
  for (std::size_t i = 0; i < descriptive::kMostLines; ++i) {
    const double x = 10 + 40.0 * static_cast<double>(i % 24), y = 10 + 35.0 * static_cast<double>(i / 24);
    full.lines.push_back({LineId{++full.lastLineId}, {{x, y}, {x + 10, y + 5}}, {}, false});
  }
  many.drawings = {full};
  many.lastDrawingId = 1;
  CHECK(errorOf(many, DrawLine{kPaper, fine}) == Error::ValueOutOfRange);
}

TEST_CASE("numbers of a piece are in the table, and new ids keep who is who") {
  Document document = after(
      drawnCreature(), {ShapePiece{PartId{4}, descriptive::PieceKind::Flat}, SetParameter{PartId{4}, "thickness", 0.05},
                        SetParameter{PartId{1}, "front", 1.5}, OrderPieces{PartId{4}, PartId{1}, {705, 385}}});
  CHECK(elementOf(*document.parts[3])->kind == descriptive::PieceKind::Flat);
  CHECK(elementOf(*document.parts[3])->thickness == doctest::Approx(0.05).epsilon(0.02));
  CHECK(elementOf(*document.parts[0])->front == doctest::Approx(1.5));
  CHECK(errorOf(document, SetParameter{PartId{1}, "front", 5}) == Error::ValueOutOfRange);
  document = after(document, {AddSketch{"other", {100, 100}}, RemovePicture{PictureId{2}}});
  Document next = document;
  for (Box<Part>& box : next.parts) {
    Part part = box;
    part.id.value += 10;
    box = part;
  }
  Drawing drawing = next.drawings[0];
  drawing.id.value = 7;
  for (PieceOrder& order : drawing.orders) order = {{order.over.value + 10}, {order.under.value + 10}, order.at};
  next.drawings = {drawing};
  for (Box<Part>& box : next.parts) {
    Part part = box;
    elementOf(part)->drawing.value = 7;
    box = part;
  }
  renumber(next);
  CHECK(next.drawings == document.drawings);
  CHECK(next.parts == document.parts);
  CHECK(next.lastDrawingId == 1);
}

namespace {

/// A box seen from its corner: nine seen lines, the edges of one face last.
std::vector<Action> seenBox(PictureId paper) {
  const std::vector<PicturePoint> p{{300, 200}, {600, 260}, {780, 180}, {480, 130}, {300, 520}, {600, 600}, {780, 500}};
  const std::vector<std::array<std::size_t, 2>> edges{{0, 1}, {1, 2}, {2, 3}, {3, 0}, {0, 4},
                                                      {1, 5}, {2, 6}, {4, 5}, {5, 6}};
  std::vector<Action> out;
  for (const auto& [a, b] : edges) out.push_back(DrawLine{paper, {p[a], p[b]}});
  return out;
}

}  // namespace

TEST_CASE("nine seen lines of a box become one solid piece, with its hidden edges as lines of the drawing") {
  std::vector<Action> lines = seenBox(kPaper);
  const Action last = lines.back();
  lines.pop_back();
  const Document before = after(paper(), lines);
  // The top is an outline of its own before the box is closed.
  CHECK(before.parts.size() == 1);
  const Document document = after(before, {last});
  REQUIRE(document.parts.size() == 1);
  const ElementRecipe& box = *elementOf(*document.parts[0]);
  CHECK(document.parts[0]->id == before.parts[0]->id);
  CHECK(box.kind == descriptive::PieceKind::Solid);
  CHECK(box.outlines.size() == 6);
  CHECK(document.drawings[0]->lines.size() == 12);
  CHECK(linesOf(box).size() == 12);
  CHECK(freeLines(document, *document.drawings[0]).empty());
  CHECK(checkElement(document, box).ok());
  const DrawingId drawing = document.drawings[0]->id;

  SUBCASE("as a round piece it is what its silhouette encloses, and a solid again afterwards") {
    const Document round = after(document, {ShapePiece{document.parts[0]->id, descriptive::PieceKind::Round}});
    CHECK(elementOf(*round.parts[0])->outlines.size() == 1);
    const Document solid = after(round, {ShapePiece{document.parts[0]->id, descriptive::PieceKind::Solid}});
    CHECK(*elementOf(*solid.parts[0]) == box);
  }
  SUBCASE("a line that is deleted leaves the faces, which close straight") {
    const Document without = after(document, {DeleteLine{drawing, LineId{5}}});
    REQUIRE(without.parts.size() == 1);
    CHECK(elementOf(*without.parts[0])->outlines.size() == 6);
  }
  SUBCASE("with the piece go all its lines") {
    const Document gone = after(document, {DeletePart{document.parts[0]->id}});
    CHECK(gone.parts.empty());
    CHECK(gone.drawings.empty());
  }
  SUBCASE("another line beside it changes nothing of it") {
    const Document more =
        after(document, {DrawLine{kPaper, {{850, 300}, {950, 300}, {950, 400}, {850, 400}}, {}, true}});
    CHECK(more.parts.size() == 2);
    CHECK(*elementOf(*more.parts[0]) == box);
  }
}

TEST_CASE("a box whose edges are all drawn as seen becomes a solid when the hidden ones are hidden") {
  std::vector<Action> lines = seenBox(kPaper);
  const std::vector<PicturePoint> ends{{480, 130}, {300, 520}, {780, 500}};
  // Hidden edges first, as seen ones: nothing is missing then.
  std::vector<Action> all;
  for (const PicturePoint end : ends) all.push_back(DrawLine{kPaper, {{480, 430}, end}});
  all.insert(all.end(), lines.begin(), lines.end());
  Document document = after(paper(), all);
  CHECK(std::ranges::none_of(document.parts,
                             [](const Part& part) { return elementOf(part)->kind == descriptive::PieceKind::Solid; }));
  for (std::uint32_t line = 1; line <= 3; ++line)
    document = after(document, {HideLine{kDrawing, LineId{line}, {{0, 1}}}});
  REQUIRE(document.parts.size() == 1);
  CHECK(elementOf(*document.parts[0])->kind == descriptive::PieceKind::Solid);
}

TEST_CASE("a piece whose lines are no edges cannot be a solid") {
  const Document document = drawnCreature();
  CHECK(errorOf(document, ShapePiece{document.parts[0]->id, descriptive::PieceKind::Solid}) == Error::ShapeInvalid);
}
