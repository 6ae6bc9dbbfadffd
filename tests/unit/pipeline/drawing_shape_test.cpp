// Line drawings as derived: all pieces of a drawing are solved together.
#include "engine/pipeline/drawing_shape.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/document/pieces.h"
#include "engine/document/update.h"
#include "engine/pipeline/derive.h"
#include "tests/support/after.h"
#include "tests/support/line_creature.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::pipeline;
using namespace spineloft::testing;

namespace {

constexpr DrawingId kDrawing{1};

Document drawnCreature() {
  return after({}, [] {
    std::vector<Action> actions{AddSketch{"paper", {1000, 800}}};
    for (const Action& action : creature(PictureId{1})) actions.push_back(action);
    return actions;
  }());
}

const mesh::TriMesh& meshOf(const Derived& derived, std::size_t part) {
  REQUIRE(derived.parts.at(part).shape != nullptr);
  return derived.parts[part].shape->mesh;
}
/// How near the nearest and the farthest point at a place are.
std::pair<float, float> depthAt(const mesh::TriMesh& mesh, PicturePoint p) {
  float front = -1e9f, back = 1e9f;
  for (const auto& [x, y, z] : mesh.positions) {
    if (std::hypot(x - p.x, -y - p.y) > 12) continue;
    front = std::max(front, z);
    back = std::min(back, z);
  }
  return {front, back};
}

}  // namespace

TEST_CASE("every piece of a drawing is a lawful solid, and legs whose hips are hidden are behind the body") {
  const Document document = drawnCreature();
  Cache cache;
  const Derived derived = derive(document, cache);
  REQUIRE(derived.parts.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) requireLawful(meshOf(derived, i));
  REQUIRE(derived.drawings.size() == 1);
  const DrawingShape& shape = *derived.drawings[0].shape;
  CHECK(shape.openEnds.empty());
  // The tail is drawn over the body, and all of both is seen.
  REQUIRE(shape.model.orders.contradictions.size() == 1);
  CHECK(shape.model.orders.contradictions[0].pieces == std::vector<std::uint32_t>{0, 3});
  for (const std::size_t leg : {1u, 2u}) {
    // Within the overlap: nothing of the leg is before the front of the body, nor behind it all the way.
    const PicturePoint at = onBelly(leg == 1 ? 395 : 595) - PicturePoint{0, 25};
    const auto [bodyFront, bodyBack] = depthAt(meshOf(derived, 0), at);
    const auto [legFront, legBack] = depthAt(meshOf(derived, leg), at);
    CHECK(bodyFront > legFront);
    CHECK(bodyBack > legBack);
  }
}

TEST_CASE("a drawing is solved once for all its pieces, and a place in the world leaves it as it is") {
  const Document document = drawnCreature();
  Cache cache;
  const Derived derived = derive(document, cache);
  const Derived again = derive(document, cache);
  CHECK(again.drawings[0].shape == derived.drawings[0].shape);
  CHECK(again.parts[2].shape == derived.parts[2].shape);
  Placement moved;
  moved.move = {1, 2, 3};
  const Document other = after(document, {PlaceParts{{{PartId{2}, moved, {}}}}, MoveInList{{PartId{1}}, {}},
                                          SetLook{PartId{3}, {false, {1, 2, 3}}}, RenamePart{PartId{1}, "Body"}});
  const Derived placed = derive(other, cache);
  CHECK(placed.drawings[0].shape == derived.drawings[0].shape);
  CHECK(placed.parts.back().shape == derived.parts[0].shape);
}

TEST_CASE("everything that is said of a drawing is part of its key") {
  const Document document = drawnCreature();
  const auto keyOf = [](const Document& d) { return drawingKey(plainDrawing(d, *d.drawings[0]).drawing); };
  const DrawingKey key = keyOf(document);
  const auto changes = [&](const Action& action) { return keyOf(after(document, {action})) != key; };
  CHECK(changes(HideLine{kDrawing, LineId{1}, {{0.2, 0.3}}}));
  CHECK(changes(DeleteLine{kDrawing, LineId{3}}));
  CHECK(changes(PinDepth{kDrawing, LineId{2}, 0.5, 1.0}));
  CHECK(changes(OrderPieces{PartId{2}, PartId{1}, {395, 530}}));
  CHECK(changes(ShapePiece{PartId{4}, descriptive::PieceKind::Flat}));
  CHECK(changes(SetParameter{PartId{1}, "front", 2}));
  CHECK(changes(SetParameter{PartId{1}, "back", 2}));
  CHECK(changes(SetParameter{PartId{1}, "stiffness", 5}));
  CHECK(changes(SetParameter{PartId{1}, "thickness", 0.1}));
  CHECK_FALSE(changes(RenamePart{PartId{1}, "Body"}));
  Drawing folded = document.drawings[0];
  folded.folds.push_back({LineId{2}, 0.5});
  Document other = document;
  other.drawings = {folded};
  CHECK(keyOf(other) != key);
}

TEST_CASE("a swap brings a leg to the front at its place only, and back again") {
  const Document document = drawnCreature();
  Cache cache;
  const Derived before = derive(document, cache);
  const descriptive::Model& model = before.drawings[0].shape->model;
  REQUIRE(model.orders.orders.size() == 3);
  std::size_t first = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    if (model.solids[model.orders.orders[k].under].piece == 1) first = k;
  }
  const PicturePoint at = model.orders.overlaps.all()[first].at;
  const Document swapped = after(document, {OrderPieces{PartId{2}, PartId{1}, at}});
  const Derived now = derive(swapped, cache);
  for (std::size_t i = 0; i < 4; ++i) requireLawful(meshOf(now, i));
  const auto& orders = now.drawings[0].shape->model.orders.orders;
  REQUIRE(orders.size() == 3);
  CHECK(orders[first].from == descriptive::OrderFrom::User);
  for (std::size_t k = 0; k < 3; ++k) CHECK((orders[k].over == model.orders.orders[k].over) == (k != first));
  CHECK(depthAt(meshOf(now, 1), at).first > depthAt(meshOf(now, 0), at).first);
  const Derived back = derive(after(swapped, {OrderPieces{PartId{1}, PartId{2}, at}}), cache);
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(back.drawings[0].shape->model.orders.orders[k].over == model.orders.orders[k].over);
  }
}

TEST_CASE("a preview of a piece is what the change makes of it") {
  const Document document = drawnCreature();
  Cache cache;
  ElementRecipe recipe = *elementOf(*document.parts[0]);
  recipe.front = 2;
  const auto shown = previewShape(document, recipe, cache);
  REQUIRE(shown.ok());
  requireLawful(shown.value().mesh);
  const Document changed = after(document, {SetParameter{PartId{1}, "front", 2}});
  CHECK(shown.value().mesh == meshOf(derive(changed, cache), 0));
}

TEST_CASE("lines that wait have open ends; a piece that is no solid says why and leaves the others") {
  const Document open =
      after({}, {AddSketch{"paper", {1000, 800}}, DrawLine{PictureId{1}, {{120, 100}, {60, 200}, {120, 300}}}});
  Cache cache;
  const Derived waiting = derive(open, cache);
  REQUIRE(waiting.drawings.size() == 1);
  CHECK(waiting.drawings[0].shape->openEnds.size() == 2);
  CHECK(waiting.parts.empty());
  Document document = after(open, {DrawLine{PictureId{1}, bodyLine(), {}, true}});
  // A piece of two straight lines on each other encloses nothing.
  Drawing drawing = document.drawings[0];
  const LineId flat{++drawing.lastLineId};
  drawing.lines.push_back({flat, {{100, 700}, {300, 700}}, {}, false});
  document.drawings = {drawing};
  Part part;
  part.id = PartId{++document.lastPartId};
  part.name = "Nothing";
  part.recipe = ElementRecipe{.picture = PictureId{1}, .drawing = kDrawing, .outlines = {{{{flat, 0, 1}}}}};
  document.parts.push_back(part);
  const Derived derived = derive(document, cache);
  REQUIRE(derived.parts.size() == 2);
  requireLawful(meshOf(derived, 0));
  CHECK(derived.parts[1].failure.has_value());
}
