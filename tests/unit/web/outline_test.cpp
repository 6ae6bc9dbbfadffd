// Points of an outline by keys.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/outlines.h"
#include "tests/unit/web/rig.h"
#include "web/edit/region_editing.h"

using namespace spineloft;
using spineloft::test::Rig;

namespace {

constexpr std::string_view kSquare = R"({"contours":[[[60,60],[140,60],[140,140],[60,140]]]})";

app::Json contour(Rig& rig) {
  const app::Json state = rig.state();
  return state.find("parts")->array()->back().find("contours")->array()->front();
}
PicturePoint corner(Rig& rig, std::size_t i) {
  const app::Json points = contour(rig);
  const auto& pair = *(*points.array())[i].array();
  return {*pair[0].number(), *pair[1].number()};
}
std::size_t points(Rig& rig) { return contour(rig).array()->size(); }

}  // namespace

TEST_CASE("the points of an outline are chosen, moved, added and deleted by keys") {
  Rig rig;
  rig.openBar();
  rig.run("draw-sheet", kSquare);
  rig.run("sheet");
  const double undo = *rig.state().number("undo");
  CHECK(rig.key("Period", "."));
  CHECK(rig.key("ArrowRight", "ArrowRight"));
  CHECK(rig.key("ArrowDown", "ArrowDown", platform::kShift));
  CHECK(corner(rig, 0).x == doctest::Approx(61));
  CHECK(corner(rig, 0).y == doctest::Approx(70));
  CHECK(corner(rig, 1).x == doctest::Approx(140));
  CHECK(rig.state().number("undo") == undo + 1);  // one after the other they are one step
  CHECK(rig.key("Insert", "Insert"));
  CHECK(points(rig) == 5);
  CHECK(corner(rig, 1).x == doctest::Approx(100.5));
  CHECK(rig.key("ArrowUp", "ArrowUp", platform::kShift));
  CHECK(corner(rig, 1).y == doctest::Approx(55));
  CHECK(rig.key("Delete", "Delete"));
  CHECK(points(rig) == 4);
  CHECK(rig.parts() == 1);  // the point, not the part
  CHECK(rig.key("Comma", ","));
  CHECK(rig.key("Delete", "Delete"));
  CHECK(points(rig) == 3);
  CHECK(*rig.run("delete-outline-point").text("error") == "NotNow");
  CHECK(points(rig) == 3);
  rig.run("select-part", R"({"id":null})");
  CHECK(*rig.run("nudge-outline-point", R"({"by":[1,1]})").text("error") == "NotNow");
}

TEST_CASE("undo that takes the chosen point away leaves none chosen") {
  Rig rig;
  rig.openBar();
  rig.run("draw-sheet", kSquare);
  rig.run("sheet");
  for (int i = 0; i < 4; ++i) rig.key("Period", ".");
  rig.key("Insert", "Insert");
  CHECK_FALSE(rig.state().find("chosen")->find("outline")->isNull());
  rig.run("undo");
  rig.settle();
  CHECK(rig.state().find("chosen")->find("outline")->isNull());
}

TEST_CASE("what only lofts have is refused on a puff, with a sentence, and nothing changes") {
  Rig rig;
  rig.openBar();
  rig.run("draw-puff", kSquare);
  const std::string before = rig.app->state();
  for (const auto& [id, args] : {std::pair{"set-section", R"({"section":"star"})"},
                                 {"set-caps", R"({"both":"flat"})"},
                                 {"set-section", R"({"section":"star","part":1})"},
                                 {"set-caps", R"({"start":"flat","part":1})"},
                                 {"set-slices", R"({"slices":[{"at":0,"section":"star"}]})"},
                                 {"set-along", R"({"kind":"twist","points":[[0,1]]})"}}) {
    CHECK_MESSAGE(*rig.run(id, args).text("error") == "NotABone", id << args);
  }
  CHECK(rig.app->state() == before);
}

TEST_CASE("a point taken away leaves a straight line, one added changes no outline of many points") {
  Rng rng(5);
  for (const int count : {6, 14, 15, 40, 300}) {
    for (const bool open : {false, true}) {
      document::Region region{PictureId{1},
                              {testing::blob(rng, {250, 200}, 110, count), testing::ellipse({250, 200}, 20, 20, 9)},
                              open ? 4.0 : 0.0};
      const std::vector<app::OutlinePoint> handles = app::outlineHandles(region);
      // Forth through all of them and back.
      std::optional<app::OutlinePoint> at;
      for (const app::OutlinePoint handle : handles) CHECK((at = app::neighbourHandle(region, at, 1)) == handle);
      CHECK(app::neighbourHandle(region, at, 1) == handles.front());
      CHECK(app::neighbourHandle(region, handles.front(), -1) == handles.back());
      for (const app::OutlinePoint handle : handles) {
        const auto added = app::withAddedPoint(region, handle);
        REQUIRE(added);
        const std::size_t size = region.contours[handle.contour].size();
        CHECK(added->region.contours[handle.contour].size() == (size <= 14 ? size + 1 : size));
        const auto left = app::withoutPoint(region, handle);
        REQUIRE(left);
        const auto& contour = left->contours[handle.contour];
        CHECK(contour.size() < size);
        CHECK(std::ranges::count(contour, app::pointOf(region, handle)) == 0);
        for (const PicturePoint p : contour) CHECK(std::ranges::count(region.contours[handle.contour], p) > 0);
      }
      CHECK_FALSE(app::withoutPoint(region, {7, 0}));
      CHECK_FALSE(app::withAddedPoint(region, {0, 100000}));
    }
  }
}
