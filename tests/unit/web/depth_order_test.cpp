// The order of the list is an order in depth: what is dragged past others comes before or behind them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/document/update.h"
#include "engine/pipeline/world.h"
#include "tests/unit/web/rig.h"
#include "tests/unit/web/two_bars.h"
#include "web/edit/depth_order.h"
#include "web/edit/placing.h"

using namespace spineloft;
using namespace spineloft::app;
using spineloft::test::Rig;

namespace {

/// Flat pieces with sharp edges, so that their depths are plain numbers: two that overlap, one away from both, and
/// one that reaches over all.
struct Pieces {
  document::Document document;
  pipeline::Cache cache;
  pipeline::Derived derived;
  static constexpr PartId kThin{1}, kThick{2}, kAway{3}, kWide{4};

  Pieces() {
    document =
        document::update({}, document::AddPicture{"bar", std::make_shared<image::Picture>(test::barPicture())}).value();
    add({{20, 20}, {80, 20}, {80, 80}, {20, 80}}, 0.04);
    add({{60, 60}, {120, 60}, {120, 120}, {60, 120}}, 0.2);
    add({{150, 150}, {190, 150}, {190, 190}, {150, 190}}, 0.1);
    add({{10, 10}, {195, 10}, {195, 195}, {10, 195}}, 0.08);
    derive();
  }
  void add(std::vector<PicturePoint> outline, double thickness) {
    extrude::ExtrudeParams extrude;
    extrude.thickness = thickness;
    extrude.edge = extrude::EdgeKind::Sharp;
    document::Region region;
    region.picture = PictureId{1};
    region.contours = {std::move(outline)};
    document = document::update(document, document::DrawRegion{region, extrude}).value();
  }
  void derive() { derived = pipeline::deriveWithEdges(document, cache, {}).value(); }
  /// Moves in the list and in depth, as the page does.
  std::optional<DepthMove> drag(std::vector<PartId> parts, PartId before) {
    const document::Document was = document;
    document = document::update(was, document::MoveInList{parts, before}).value();
    const auto move = depthMove(was, document, derived, parts);
    if (!move) return move;
    document::Motion motion;
    motion.move = {0, 0, move->by};
    document = document::update(document, document::PlaceParts{movedParts(document, derived, parts, motion)}).value();
    derive();
    return move;
  }
  pipeline::WorldBounds bounds(PartId part) const { return *pipeline::boundsOf(document, derived, std::vector{part}); }
  double depth(PartId part) const { return bounds(part).high.z - bounds(part).low.z; }
};

/// `front` stands before `back` and reaches into it by a hair of the thinner one.
void checkTouch(const Pieces& pieces, PartId front, PartId back) {
  const double into = pieces.bounds(back).high.z - pieces.bounds(front).low.z;
  const double thinner = std::min(pieces.depth(front), pieces.depth(back));
  CHECK(into > 0.01 * thinner);
  CHECK(into < 0.1 * thinner);
}

}  // namespace

TEST_CASE(
    "what goes up past another stands just before it, what goes down just behind it, and reaches into it by a hair") {
  Pieces pieces;
  const auto still = pieces.bounds(Pieces::kThin);
  const auto up = pieces.drag({Pieces::kThick}, Pieces::kThin);
  REQUIRE(up);
  CHECK(up->by > 0);
  CHECK(up->beyond == document::findPart(pieces.document, Pieces::kThin)->name);
  checkTouch(pieces, Pieces::kThick, Pieces::kThin);
  CHECK(pieces.bounds(Pieces::kThin) == still);
  // Down again: behind what it was before, and only it moves.
  const auto down = pieces.drag({Pieces::kThick}, Pieces::kAway);
  REQUIRE(down);
  CHECK(down->by < 0);
  checkTouch(pieces, Pieces::kThin, Pieces::kThick);
  CHECK(pieces.bounds(Pieces::kThin) == still);
  // Once there it stays there, however often it passes.
  REQUIRE(pieces.drag({Pieces::kThick}, Pieces::kThin));
  pieces.document = document::update(pieces.document, document::MoveInList{{Pieces::kThick}, Pieces::kAway}).value();
  CHECK_FALSE(pieces.drag({Pieces::kThick}, Pieces::kThin));
}

TEST_CASE("what does not overlap in the picture, is hidden or was not passed moves nothing in depth") {
  Pieces pieces;
  const auto still = pieces.bounds(Pieces::kAway);
  CHECK_FALSE(pieces.drag({Pieces::kAway}, Pieces::kThin));
  CHECK(pieces.bounds(Pieces::kAway) == still);
  CHECK(pieces.document.parts.front()->id == Pieces::kAway);
  // Wide overlaps all, but is not passed.
  CHECK_FALSE(pieces.drag({Pieces::kAway}, Pieces::kWide));
  pieces.document = document::update(pieces.document, document::ShowPart{Pieces::kThin, false}).value();
  pieces.derive();
  CHECK_FALSE(pieces.drag({Pieces::kThin}, {}));
  CHECK_FALSE(pieces.drag({Pieces::kThick}, Pieces::kAway));
}

TEST_CASE("past several it stands before the foremost of them; a group goes as one") {
  Pieces pieces;
  REQUIRE(pieces.drag({Pieces::kThick}, Pieces::kThin));  // before the thin one
  REQUIRE(pieces.drag({Pieces::kWide}, Pieces::kThick));
  checkTouch(pieces, Pieces::kWide, Pieces::kThick);
  CHECK(pieces.bounds(Pieces::kWide).low.z > pieces.bounds(Pieces::kThin).high.z);
  Pieces grouped;
  const double between = grouped.bounds(Pieces::kThick).high.z - grouped.bounds(Pieces::kThin).high.z;
  REQUIRE(grouped.drag({Pieces::kThin, Pieces::kThick}, {}));
  CHECK(grouped.bounds(Pieces::kThick).high.z - grouped.bounds(Pieces::kThin).high.z == doctest::Approx(between));
  checkTouch(grouped, Pieces::kWide, Pieces::kThick);
}

TEST_CASE("a round thing on the slope of another settles on the slope, not before its foremost place") {
  Rig rig;
  rig.openBar();
  const auto circle = [](double x, double y, double r) {
    std::string points;
    for (int i = 0; i < 40; ++i) {
      const double a = i * 0.15707963;
      points +=
          (i ? ",[" : "[") + std::to_string(x + r * std::cos(a)) + "," + std::to_string(y + r * std::sin(a)) + "]";
    }
    return R"({"contours":[[)" + points + "]]}";
  };
  REQUIRE(rig.run("draw-puff", circle(100, 100, 80)).flag("ok") == true);
  REQUIRE(rig.run("draw-puff", circle(150, 100, 12)).flag("ok") == true);
  rig.settle();
  REQUIRE(rig.run("move-in-list", R"({"parts":[2],"before":1})").flag("ok") == true);
  rig.settle();
  const app::Json eye = (*rig.state().find("parts")->array())[0];
  REQUIRE(*eye.number("id") == 2);
  const double z = *(*eye.find("placement")->find("move")->array())[2].number() * 200;  // picture pixels
  // The ball is 80 high at its middle; the eye's own ball is lifted by less than that, and by about as much as it is
  // high where the eye is (√(80² − 50²) = 62.4, less where it slopes away).
  CHECK(z > 60);
  CHECK(z < 85);
}

TEST_CASE("one step of undo takes list and depth back at once, the place panel shows the depth, keys do the same") {
  test::TwoBars rig;
  const auto part = [&](std::size_t i) { return (*rig.state().find("parts")->array())[i]; };
  const auto z = [&](std::size_t i) { return *(*part(i).find("placement")->find("move")->array())[2].number(); };
  const double undo = *rig.state().number("undo");
  REQUIRE(rig.run("move-in-list", R"({"parts":[2],"before":1})").flag("ok") == true);
  rig.settle();
  CHECK(*part(0).number("id") == 2);
  const double before = z(0);
  CHECK(before > 0);
  CHECK(z(1) == 0);
  CHECK(*rig.state().number("undo") == undo + 1);
  CHECK(rig.host.said("In front of"));
  rig.run("undo");
  rig.settle();
  CHECK(*part(0).number("id") == 1);
  CHECK(z(0) == 0);
  CHECK(z(1) == 0);
  rig.run("select-part", R"({"id":2})");
  REQUIRE(rig.run("list-up").flag("ok") == true);
  rig.settle();
  CHECK(z(0) == doctest::Approx(before));
  CHECK(*rig.state().number("undo") == undo + 1);
  rig.run("undo");
  REQUIRE(rig.run("move-in-list", R"({"parts":[2],"before":1,"depth":false})").flag("ok") == true);
  CHECK(*part(0).number("id") == 2);
  CHECK(z(0) == 0);
}

TEST_CASE("a tap in the picture takes what was brought to the front, else what was drawn last") {
  test::TwoBars rig;
  const auto tapped = [&] {
    rig.run("select-part", R"({"id":null})");
    rig.run("hand");
    const auto p = rig.at(100, 100);
    rig.click(p.x, p.y);
    return rig.app->ui().selection;
  };
  CHECK(tapped() == PartId{2});
  rig.run("move-in-list", R"({"parts":[2],"before":1})");
  rig.settle();
  CHECK(tapped() == PartId{2});
  rig.run("move-in-list", R"({"parts":[1],"before":2})");
  rig.settle();
  CHECK(tapped() == PartId{1});
}

namespace {

/// The list under the pointer.
struct ListHand : test::TwoBars {
  using Kind = platform::PointerKind;
  /// A few frames: the solver, which nobody answers, never rests.
  void look() {
    for (int i = 0; i < 3; ++i) {
      host.clockMs += 16;
      app->frame();
    }
  }
  double x() const { return app->ui().layout.panel.x + 36; }  // on the grip, of rows within a solid as well
  /// Presses and lets go from the top on until the row is what is in hand; where that is.
  double rowOf(const ListRow& row) {
    for (double y = app->ui().layout.panel.y + 8; y < app->ui().layout.panel.bottom(); y += 6) {
      pointer(Kind::Move, x(), y);
      look();
      pointer(Kind::Down, x(), y);
      look();
      const bool there = app->ui().listDrag == row;
      pointer(Kind::Up, x(), y);
      look();
      if (there) return y + 6;
    }
    FAIL("no such row");
    return 0;
  }
  void drag(double from, double to) {
    pointer(Kind::Move, x(), from);
    look();
    pointer(Kind::Down, x(), from);
    look();
    for (int i = 1; i <= 6; ++i) {
      pointer(Kind::Move, x(), from + (to - from) * i / 6);
      look();
    }
    pointer(Kind::Up, x(), to);
    look();
  }
  std::vector<double> order() {
    std::vector<double> ids;
    const Json now = state();
    for (const Json& part : *now.find("parts")->array()) ids.push_back(*part.number("id"));
    return ids;
  }
  double z(std::size_t i) {
    const Json now = state();
    return *(*(*now.find("parts")->array())[i].find("placement")->find("move")->array())[2].number();
  }
};

}  // namespace

TEST_CASE("a row that the pointer drags above another goes before it in list and depth; a short way is a tap") {
  ListHand hand;
  const double first = hand.rowOf({PartId{1}, {}}), second = hand.rowOf({PartId{2}, {}});
  REQUIRE(second > first + 20);
  const double undo = *hand.state().number("undo");
  hand.drag(second, second - 3);
  CHECK(hand.order() == std::vector<double>{1, 2});
  CHECK(*hand.state().number("undo") == undo);
  CHECK(hand.app->ui().selection == PartId{2});
  hand.drag(second, first - 10);
  CHECK(hand.order() == std::vector<double>{2, 1});
  CHECK(hand.z(0) > 0);
  CHECK(hand.z(1) == 0);
  CHECK(*hand.state().number("undo") == undo + 1);
  hand.drag(first, second + 60);
  CHECK(hand.order() == std::vector<double>{1, 2});
  CHECK(hand.z(1) < 0);
  hand.run("undo");
  hand.run("undo");
  hand.look();
  CHECK(hand.order() == std::vector<double>{1, 2});
  CHECK(hand.z(0) == 0);
  CHECK(hand.z(1) == 0);
}

TEST_CASE("a solid is dragged by its row as a whole, its parts by no row, and a part is dragged past it") {
  ListHand hand;
  hand.run("draw-puff", R"({"contours":[[[85,80],[115,80],[115,120],[85,120]]]})");
  hand.look();
  hand.stick(R"({"parts": [1, 2]})");
  hand.answer(hand.lastAsked(), 0.2f);
  hand.look();
  const StepId solid{1};
  const double whole = hand.rowOf({{}, {}, solid}), inner = hand.rowOf({PartId{2}, {}}),
               free = hand.rowOf({PartId{3}, {}});
  REQUIRE(whole < inner);
  REQUIRE(inner < free);
  hand.drag(inner, free + 30);
  CHECK(hand.order() == std::vector<double>{1, 2, 3});
  hand.drag(free, whole - 12);
  CHECK(hand.order() == std::vector<double>{3, 1, 2});
  const double undo = *hand.state().number("undo");
  hand.drag(hand.rowOf({{}, {}, solid}), hand.app->ui().layout.panel.y + 20);
  CHECK(hand.order() == std::vector<double>{1, 2, 3});
  CHECK(hand.z(0) == hand.z(1));
  CHECK(*hand.state().number("undo") == undo + 1);
}
