// A layer on the board for slices: drawn and changed by its points there, kept on the shelf, and made of kept slices.
#include <algorithm>
#include <span>
#include <string>

#include "tests/unit/web/layer_paper.h"
#include "web/edit/layer_board.h"

using namespace spineloft;
using namespace spineloft::test;

namespace {

using Curves = std::vector<stack::Curve>;

app::Json boardOf(Rig& rig) { return *rig.state().find("sliceBoard"); }
std::size_t curvesOnBoard(Rig& rig) { return boardOf(rig).find("curves")->array()->size(); }

/// A trunk, and above it two branches, the first of which is a square.
struct Fork : Paper {
  Fork() {
    circle(0, 0, 0.5);
    REQUIRE(works("layer-sheet", R"({"at": 1})"));
    REQUIRE(works("draw-layer", R"({"at":1,"through":[[-60,-20],[-20,-20],[-20,20],[-60,20]],"corners":true})"));
    REQUIRE(works("draw-layer", R"({"at":1,"through":[[60,0],[40,20],[20,0],[40,-20]]})"));
    REQUIRE(works("layer-fork", R"({"curve": 0, "at": 0.4})"));
    settle();
    REQUIRE(layersOf(*this).planes.back().curves.size() == 2);
  }
  Curves top() { return layersOf(*this).planes.back().curves; }
};

}  // namespace

TEST_CASE("a layer is opened on the board with its curves; done without a change, nothing happened") {
  Fork page;
  const document::StackRecipe before = layersOf(page);
  const double undo = *page.state().number("undo");
  REQUIRE(page.works("edit-slice"));
  CHECK(curvesOnBoard(page) == 2);
  CHECK(*boardOf(page).text("tool") == "points");
  CHECK(page.sheet().isNull());
  REQUIRE(page.works("slice-done"));
  CHECK(boardOf(page).isNull());
  CHECK_FALSE(page.sheet().isNull());
  CHECK(layersOf(page) == before);
  CHECK(page.state().number("undo") == undo);
}

TEST_CASE("a point of a layer is moved, in one step; other curves stay to the last bit, forks and links stay") {
  Fork page;
  const document::StackRecipe before = layersOf(page);
  const double undo = *page.state().number("undo");
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-move-point", R"({"curve":0,"point":0,"to":[-1,-0.5]})"));
  page.settle();
  CHECK(layersOf(page) == before);  // nothing changes until it is done
  REQUIRE(page.works("slice-done"));
  page.settle();
  const document::StackRecipe after = layersOf(page);
  CHECK(page.state().number("undo") == undo + 1);
  REQUIRE(page.top().size() == 2);
  CHECK(page.top()[1] == before.planes.back().curves[1]);
  CHECK(page.top()[0].corners.all);
  // The board is 75 units wide to either side, from the middle of the layer.
  CHECK(page.top()[0].through[0].x == doctest::Approx(-75));
  CHECK(page.top()[0].through[0].y == doctest::Approx(-37.5));
  CHECK(page.top()[0].through[2].x == doctest::Approx(-20));
  CHECK(after.planes.front() == before.planes.front());
  CHECK(after.planes.front().curves[0].forkAt.has_value());
  REQUIRE(page.works("undo"));
  CHECK(layersOf(page) == before);
}

TEST_CASE("links go with their curve: one of two goes, and the other is changed") {
  Fork page;
  REQUIRE(page.works("layer-link", R"({"link": 0, "on": false})"));
  page.settle();
  const auto parted = [&](std::uint32_t curve) {
    const document::StackRecipe layers = layersOf(page);
    const auto& links = layers.planes.front().links;
    return std::ranges::any_of(links, [&](const stack::CurveLink& link) { return link.to == curve && !link.on; });
  };
  REQUIRE(parted(0));
  const Curves before = page.top();
  REQUIRE(page.works("edit-slice"));
  // Both are changed, the first one last in the list.
  REQUIRE(page.works("slice-move-point", R"({"curve":1,"point":1,"to":[0.5,0.5]})"));
  REQUIRE(page.works("slice-draw", R"({"box":[[-0.7,-0.4],[-0.3,0.2]]})"));
  CHECK(curvesOnBoard(page) == 2);
  REQUIRE(page.works("slice-done"));
  page.settle();
  CHECK(parted(0));
  CHECK_FALSE(parted(1));
  CHECK(page.top()[0].through[0].x < 0);
  CHECK(page.top()[1].through[0].x > 0);
}

TEST_CASE("a board that is open when another model comes, or its part goes, changes nothing") {
  Fork page;
  const document::StackRecipe before = layersOf(page);
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-move-point", R"({"curve":0,"point":0,"to":[-1,-0.5]})"));
  const double undo = *page.state().number("undo");
  REQUIRE(page.works("delete-part"));
  page.settle();
  CHECK(boardOf(page).isNull());
  CHECK(page.state().number("undo") == undo + 1);
  REQUIRE(page.works("undo"));
  CHECK(layersOf(page) == before);
  REQUIRE(page.works("edit-slice", R"({"part":1})"));
  REQUIRE(page.works("slice-move-point", R"({"curve":0,"point":0,"to":[-1,-0.5]})"));
  REQUIRE(page.works("clear"));
  page.settle();
  CHECK(boardOf(page).isNull());
  CHECK_FALSE(page.app->ui().section.drawn());
}

TEST_CASE("a board that is opened for another part uses what was drawn for the first") {
  Fork page;
  REQUIRE(page.works("draw-spine", R"({"stroke":[[60,60],[60,200]]})"));
  page.settle();
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-start-from", R"({"section":"star"})"));
  const double undo = *page.state().number("undo");
  REQUIRE(page.works("edit-slice", R"({"part":1})"));
  page.settle();
  CHECK(curvesOnBoard(page) == 2);
  CHECK(page.state().number("undo") == undo + 1);
}

TEST_CASE("the board's own steps, and Escape, leave the layer as it was") {
  Fork page;
  const document::StackRecipe before = layersOf(page);
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-draw", R"({"ellipse":[[-0.2,0.6],[0.2,0.9]]})"));
  CHECK(curvesOnBoard(page) == 3);
  page.run("undo");
  CHECK(curvesOnBoard(page) == 2);
  page.run("redo");
  CHECK(curvesOnBoard(page) == 3);
  page.key("Escape", "Escape");
  CHECK(boardOf(page).isNull());
  CHECK(layersOf(page) == before);
}

TEST_CASE("a curve drawn on the board is a branch; one that is crossed gives way, with its links alone") {
  Fork page;
  const Curves before = page.top();
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-draw", R"({"ellipse":[[-0.2,0.6],[0.2,0.9]]})"));
  REQUIRE(page.works("slice-done"));
  page.settle();
  const Curves after = page.top();
  REQUIRE(after.size() == 3);
  CHECK(std::ranges::equal(std::span(after).first(2), before));
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-draw", R"({"box":[[-0.5,-0.5],[0.9,0.2]]})"));  // over both branches, not over the third
  CHECK(curvesOnBoard(page) == 2);
  REQUIRE(page.works("slice-done"));
  page.settle();
  CHECK(page.top().size() == 2);
}

TEST_CASE("a drawing with a fault is not taken: the board stays, and says what to do") {
  Fork page;
  const document::StackRecipe before = layersOf(page);
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-clear"));
  const app::Json refused = page.run("slice-done");
  CHECK(refused.flag("ok") == false);
  CHECK_FALSE(boardOf(page).isNull());
  CHECK(layersOf(page) == before);
}

TEST_CASE("slices go from a bone to a layer and back over the shelf: a layer is as large as its neighbour") {
  Fork page;
  REQUIRE(page.works("edit-slice"));
  REQUIRE(page.works("slice-move-point", R"({"curve":0,"point":0,"to":[-1,-0.5]})"));
  REQUIRE(page.works("slice-done"));
  page.settle();
  const app::Json::Array shelf = *page.state().find("shelf")->array();
  REQUIRE(shelf.size() == 1);
  const std::string id = std::to_string(static_cast<int>(*shelf[0].number("id")));
  REQUIRE(page.works("layer-sheet", R"({"at": 1.5})"));
  REQUIRE(page.works("edit-slice"));
  CHECK(curvesOnBoard(page) == 0);  // a new layer, with the one below it pale under it
  REQUIRE(page.works("slice-start-from", R"({"shelf":)" + id + "}"));
  REQUIRE(page.works("slice-done"));
  page.settle();
  const document::StackRecipe layers = layersOf(page);
  REQUIRE(layers.planes.size() == 3);
  CHECK(layers.planes.back().at == doctest::Approx(1));
  CHECK(layers.planes.back().curves.size() == 2);
  REQUIRE(page.works("draw"));
  REQUIRE(page.works("draw-spine", R"({"stroke":[[60,60],[60,200]]})"));
  page.settle();
  REQUIRE(page.works("set-section", R"({"shelf":)" + id + "}"));
  const document::Document document = page.shared();
  const document::Part& bone = *document.parts.back();
  REQUIRE(document::loftOf(bone) != nullptr);
  CHECK(document::loftOf(bone)->loft.sections.front().shape.contours.size() == 2);
}

TEST_CASE("the first layer of a part can be drawn on the board") {
  Paper page;
  REQUIRE(page.works("edit-slice"));
  CHECK(curvesOnBoard(page) == 0);
  REQUIRE(page.works("slice-start-from", R"({"section":"star"})"));
  REQUIRE(page.works("slice-done"));
  page.settle();
  CHECK(page.parts() == 1);
  REQUIRE(layersOf(page).planes.size() == 1);
  const std::vector<SectionPoint> through = layersOf(page).planes[0].curves.at(0).through;
  const auto [least, most] = std::ranges::minmax(through, {}, &SectionPoint::x);
  const double wide = most.x - least.x;
  CHECK(wide > 40);
  CHECK(wide < 300);
}

TEST_CASE("lines that end stay on the sheet: the board says so") {
  Paper page;
  REQUIRE(page.works("draw-layer", R"({"at":0,"line":[[-60,0],[-30,10],[0,0],[30,10],[60,0]]})"));
  page.settle();
  const app::Json refused = page.run("edit-slice");
  CHECK(refused.flag("ok") == false);
  CHECK(boardOf(page).isNull());
}
