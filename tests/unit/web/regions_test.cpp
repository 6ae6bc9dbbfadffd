// Puffs and flat pieces on the page: drawn, tapped, changed, by hand and by command.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using test::Rig;

namespace {

app::Json lastPart(Rig& rig) { return rig.state().find("parts")->array()->back(); }

/// A loop round the bar, drawn with the pointer.
void drawLoop(Rig& rig, bool lift = true) {
  const int steps = 40;
  for (int i = 0; i <= steps; ++i) {
    const double a = 2 * std::numbers::pi * i / steps;
    const auto p = rig.at(100 + 25 * std::cos(a), 100 + 75 * std::sin(a));
    rig.pointer(i == 0 ? platform::PointerKind::Down : platform::PointerKind::Move, p.x, p.y);
    rig.lastX = p.x;
    rig.lastY = p.y;
  }
  if (lift) rig.lift();
  rig.settle();
}

constexpr std::string_view kSquare = R"({"contours":[[[60,60],[140,60],[140,140],[60,140]]]})";

}  // namespace

TEST_CASE("a line drawn round a thing becomes a puff, or a flat piece with that tool") {
  Rig rig;
  rig.openBar();
  for (const std::string_view tool : {"puff", "sheet"}) {
    CHECK(rig.run(tool).flag("ok") == true);
    CHECK(*rig.state().text("tool") == tool);
    drawLoop(rig);
    const app::Json part = lastPart(rig);
    CHECK(*part.text("kind") == tool);
    CHECK(part.number("outlines") == 1);
    CHECK(*part.number("triangles") > 300);
    CHECK(part.find("failure")->isNull());
    CHECK(rig.state().number("selection") == part.number("id"));
  }
  CHECK(rig.parts() == 2);
  rig.run("undo");
  CHECK(rig.parts() == 1);
}

TEST_CASE("the puff grows under the pen, and taking the gesture back leaves nothing") {
  Rig rig;
  rig.openBar();
  rig.run("puff");
  drawLoop(rig, false);
  const app::Json state = rig.state();
  const app::Json* preview = state.find("preview");
  REQUIRE(!preview->isNull());
  CHECK(*preview->number("triangles") > 100);
  rig.key("Escape", "Escape");
  CHECK(rig.state().find("preview")->isNull());
  CHECK(rig.parts() == 0);
  CHECK(rig.state().number("undo") == 1);
}

TEST_CASE("an open line becomes a ribbon") {
  Rig rig;
  rig.openBar();
  rig.run("sheet");
  rig.press(40, 40, 160, 150);
  rig.lift();
  rig.settle();
  CHECK(*lastPart(rig).number("ribbon") > 0);
}

TEST_CASE("a tap cuts the thing out and shows it before it is used; a tap on a part selects it") {
  Rig rig;
  rig.openBar();
  rig.run("puff");
  auto p = rig.at(100, 60);
  rig.click(p.x, p.y);
  CHECK(rig.parts() == 0);
  CHECK_FALSE(rig.state().find("cut")->isNull());
  CHECK(rig.run("cut-use").flag("ok") == true);
  CHECK(rig.state().find("cut")->isNull());
  REQUIRE(rig.parts() == 1);
  const app::Json contours = *lastPart(rig).find("contours");
  REQUIRE(contours.array()->size() == 1);
  for (const app::Json& point : *contours.array()->front().array()) {
    const double x = *(*point.array())[0].number(), y = *(*point.array())[1].number();
    CHECK((x > 76 && x < 124 && y > 26 && y < 174));
  }
  rig.run("select-part", R"({"id":null})");
  p = rig.at(100, 100);
  rig.click(p.x, p.y);
  CHECK(rig.parts() == 1);
  CHECK(rig.state().number("selection") == lastPart(rig).number("id"));
}

TEST_CASE("a point of the outline is dragged, and the solid follows") {
  Rig rig;
  rig.openBar();
  rig.run("draw-sheet", kSquare);
  rig.run("sheet");
  rig.settle();
  const auto middle = rig.at(100, 100);
  rig.click(middle.x, middle.y);
  rig.press(60, 60, 40, 30);
  CHECK(!rig.state().find("preview")->isNull());
  rig.lift();
  rig.settle();
  const app::Json part = lastPart(rig);
  const app::Json& corner = part.find("contours")->array()->front().array()->front();
  CHECK(*(*corner.array())[0].number() == doctest::Approx(40).epsilon(0.05));
  CHECK(*(*corner.array())[1].number() == doctest::Approx(30).epsilon(0.05));
  CHECK(rig.parts() == 1);
}

TEST_CASE("a drawing tool draws, on an outline as anywhere, until a tap takes the part's points in hand") {
  for (const auto device : {platform::Device::Mouse, platform::Device::Touch}) {
    for (const std::string_view tool : {"puff", "sheet"}) {
      CAPTURE(tool);
      Rig rig;
      rig.openBar();
      rig.run("puff");
      rig.run("draw-puff", kSquare);
      rig.settle();
      const auto corner = [&] {
        const app::Json first = rig.state().find("parts")->array()->front();
        const app::Json point = first.find("contours")->array()->front().array()->front();
        return std::pair{*(*point.array())[0].number(), *(*point.array())[1].number()};
      };
      const auto kCorner = corner();
      const auto drag = [&] {
        rig.press(60, 60, 40, 30, device);
        rig.lift(device);
        rig.settle();
      };
      const auto tap = [&](double x, double y) {
        const auto p = rig.at(x, y);
        rig.pointer(platform::PointerKind::Down, p.x, p.y, device);
        rig.pointer(platform::PointerKind::Up, p.x, p.y, device);
        rig.settle();
      };
      // Just made, with its own tool still in hand; and with a tool that was taken after a tap.
      drag();
      CHECK(rig.parts() == 2);
      CHECK(corner() == kCorner);
      tap(120, 120);
      CHECK(rig.state().number("selection") == 1);
      rig.run(tool);
      drag();
      CHECK(rig.parts() == 3);
      CHECK(corner() == kCorner);
      CHECK(*lastPart(rig).text("kind") == tool);
      tap(120, 120);
      drag();
      CHECK(rig.parts() == 3);
      CHECK(corner().first == doctest::Approx(40).epsilon(0.05));
      CHECK(corner().second == doctest::Approx(30).epsilon(0.05));
      // Away from its points a line draws as before.
      rig.press(100, 90, 115, 110, device);
      rig.lift(device);
      rig.settle();
      CHECK(rig.parts() == 4);
      // A new line for the part may begin on a point of the old one.
      rig.run("select-part", R"({"id":1})");
      rig.run("redraw");
      rig.press(40, 30, 150, 150, device);
      rig.lift(device);
      rig.settle();
      CHECK(rig.parts() == 4);
      const app::Json first = rig.state().find("parts")->array()->front();
      CHECK(*first.number("ribbon") > 0);
    }
  }
}

TEST_CASE("commands change a region part, and turn one kind into the other and back") {
  Rig rig;
  rig.openBar();
  rig.run("draw-puff", kSquare);
  CHECK(*lastPart(rig).text("sides") == "both");
  rig.run("puff-front");
  CHECK(*lastPart(rig).text("sides") == "front");
  const double height = *lastPart(rig).find("parameters")->number("height");
  rig.run("thicker");
  CHECK(*lastPart(rig).find("parameters")->number("height") > height);
  rig.run("make-sheet");
  CHECK(*lastPart(rig).text("kind") == "sheet");
  rig.run("edge-bevel");
  CHECK(*lastPart(rig).text("edge") == "bevel");
  CHECK(rig.run("set-parameter", R"({"part":1,"key":"thickness","value":0.1})").flag("ok") == true);
  rig.run("make-puff");
  CHECK(*lastPart(rig).text("kind") == "puff");
  CHECK(rig.run("move-outline-point", R"({"point":0,"to":[50,50]})").flag("ok") == true);
  CHECK(rig.run("redraw-region", R"({"line":[[30,30],[90,30],[90,90],[30,90],[30,31]]})").flag("ok") == true);
  CHECK(rig.run("redraw").flag("ok") == true);
  CHECK(*rig.state().text("tool") == "puff");
}

TEST_CASE("what is about bones says so on a puff, and what is about regions on a loft") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  CHECK(*rig.run("thicker", R"({"part":1})").text("error") == "NotARegion");
  CHECK(*rig.run("redraw-region", R"({"part":1,"line":[[1,1]]})").text("error") == "NotARegion");
  rig.run("draw-puff", kSquare);
  for (const std::string_view id : {"reset-ribs", "more-ribs", "coil", "join-ends", "side-view"}) {
    const app::Json answer = rig.run(id);
    CHECK_MESSAGE(*answer.text("error") == "NotABone", id);
  }
}

TEST_CASE("bad regions are refused with a sentence, and nothing changes") {
  Rig rig;
  rig.openBar();
  const auto errorOf = [&](std::string_view args) { return *rig.run("draw-puff", args).text("error"); };
  CHECK(errorOf("{}") == "ArgumentMissing");
  CHECK(errorOf(R"({"contours":[]})") == "RegionEmpty");
  CHECK(errorOf(R"({"contours":[[[5,5],[6,5],[6,6],[5,6]]]})") == "RegionEmpty");
  CHECK(errorOf(R"({"contours":[[[900,900],[990,900],[990,990]]]})") == "RegionOutside");
  CHECK(errorOf(R"({"contours":[[[null,5],[80,5],[80,80]]]})") == "StrokeNotFinite");
  CHECK(errorOf(R"({"contours":[[[20,20],[80,20],[80,80]]],"height":99})") == "ValueOutOfRange");
  CHECK(*rig.run("cut-out", "{}").text("error") == "ArgumentMissing");
  CHECK(*rig.run("cut-out", R"({"at":[900,900]})").text("error") == "RegionOutside");
  CHECK(rig.parts() == 0);
  CHECK(rig.run("draw-puff", R"({"contours":[[[-90,-90],[290,-90],[290,290],[-90,290]]]})").flag("ok") == true);
  CHECK(rig.host.said("cut off"));
  // A region that crosses itself is untangled.
  CHECK(rig.run("draw-sheet", R"({"contours":[[[40,40],[120,120],[120,40],[40,120]]]})").flag("ok") == true);
  rig.settle();
  CHECK(rig.parts() == 2);
  CHECK(*lastPart(rig).number("triangles") > 100);
  CHECK(lastPart(rig).find("failure")->isNull());
}

TEST_CASE(
    "a hand that draws an eight or goes round twice is told so, one that closes its line with a small loop is not") {
  const auto said = [](auto&& at) {
    Rig rig;
    rig.openBar();
    std::string line = R"({"line":[)";
    for (int i = 0; i < 90; ++i) {
      const auto [x, y] = at(i / 89.0 * 2 * std::numbers::pi);
      line += (i > 0 ? ",[" : "[") + std::to_string(x) + "," + std::to_string(y) + "]";
    }
    REQUIRE(rig.run("draw-puff", line + "]}").flag("ok") == true);
    return rig.host.said(R"("level":"hint","text":"Your line crosses itself)");
  };
  using Place = std::pair<double, double>;
  const auto round = [](double r, double angle) { return Place{100 + r * std::cos(angle), 100 + r * std::sin(angle)}; };
  CHECK(said([](double t) { return Place{100 + 60 * std::sin(t), 100 + 40 * std::sin(2 * t)}; }));
  CHECK(said([&](double t) { return round(50 + 20 * std::cos(t), 2 * t); }));
  for (const double over : {0., 0.1, 0.3}) {
    // It ends past its beginning, a little within it, with the tremor of a hand.
    CHECK_FALSE(said([&](double t) { return round(60 - 2 * over * t + 0.5 * std::sin(40 * t), t * (1 + over / 6)); }));
  }
}

TEST_CASE("a line that crosses itself is told to make more than one piece, and one that goes round once is not") {
  const auto said = [](std::string_view args) {
    Rig rig;
    rig.openBar();
    REQUIRE(rig.run("draw-sheet", args).flag("ok") == true);
    return rig.host.said("crosses itself");
  };
  CHECK(said(R"({"contours":[[[40,40],[120,120],[120,40],[40,120]]]})"));
  CHECK_FALSE(said(R"({"contours":[[[40,40],[120,40],[120,120],[40,120]]]})"));
  CHECK_FALSE(said(R"({"contours":[[[40,40],[120,40],[120,120],[40,120]],[[60,60],[80,60],[80,80],[60,80]]]})"));
  CHECK_FALSE(said(R"({"lines":[[[40,40],[120,120]],[[120,40],[40,120]]],"width":8})"));
}

TEST_CASE(
    "a tap gives a puff a ready slice: one step, told by the state, taken back whole, and kept for the next puff") {
  Rig rig;
  rig.openBar();
  rig.run("draw-puff", kSquare);
  rig.settle();
  const double undo = *rig.state().number("undo");
  CHECK(*lastPart(rig).text("slice") == "soft");
  double before = *lastPart(rig).number("triangles");
  for (const std::string key : {"roof", "block", "ring", "two-rings"}) {
    CAPTURE(key);
    CHECK(rig.run("puff-slice", R"({"slice": ")" + key + R"("})").flag("ok") == true);
    rig.settle();
    const app::Json part = lastPart(rig);
    CHECK(*part.text("slice") == key);
    CHECK(part.find("failure")->isNull());
    CHECK(std::exchange(before, *part.number("triangles")) != before);
  }
  CHECK(rig.state().number("undo") == undo + 4);
  rig.run("draw-puff", R"({"contours":[[[20,20],[50,20],[50,50],[20,50]]]})");
  CHECK(*lastPart(rig).text("slice") == "two-rings");
  for (int i = 0; i < 5; ++i) rig.run("undo");
  rig.settle();
  CHECK(*lastPart(rig).text("slice") == "soft");
  CHECK_FALSE(rig.run("puff-slice", R"({"slice": "pyramid"})").flag("ok").value_or(true));
  const app::Json lopsided = rig.run("puff-slice", R"({"contours":[[[-1,0],[1,-1],[1,1]]]})");
  CHECK_FALSE(lopsided.flag("ok").value_or(true));
  CHECK(*lastPart(rig).text("slice") == "soft");
}

TEST_CASE("a slice of one's own: drawn on the board, always mirrored, the puff follows the pen, and Done is one step") {
  Rig rig;
  rig.openBar();
  rig.run("draw-puff", kSquare);
  rig.settle();
  const double undo = *rig.state().number("undo");
  REQUIRE(rig.run("edit-slice").flag("ok") == true);
  rig.settle();
  CHECK_FALSE(rig.run("slice-left-right").flag("ok").value_or(true));
  rig.run("slice-symmetry", R"({"leftRight": false})");
  // A box beside the middle: with its mirror image a ring round the outline.
  REQUIRE(rig.run("slice-draw", R"({"box": [[0.4, -0.2], [0.8, 0.2]]})").flag("ok") == true);
  rig.settle();
  REQUIRE_FALSE(rig.state().find("preview")->isNull());
  CHECK(*rig.state().find("preview")->number("triangles") > 100);
  REQUIRE(rig.run("slice-done").flag("ok") == true);
  rig.settle();
  const app::Json part = lastPart(rig);
  CHECK(*part.text("slice") == "own");
  CHECK(part.find("failure")->isNull());
  CHECK(rig.state().number("undo") == undo + 1);
  // It is taken as drawn, with its mirror image.
  rig.run("edit-slice");
  const app::Json board = *rig.state().find("sliceBoard");
  REQUIRE(board.find("curves")->array()->size() == 2);
  for (const app::Json& curve : *board.find("curves")->array()) {
    for (const app::Json& point : *curve.array()) {
      const double x = std::abs(*(*point.array())[0].number());
      CHECK((x > 0.39 && x < 0.81));
    }
  }
  // What is drawn beyond the outline ends there.
  rig.run("slice-clear");
  REQUIRE(rig.run("slice-draw", R"({"ellipse": [[-1.1, -0.5], [1.1, 0.5]]})").flag("ok") == true);
  REQUIRE(rig.run("slice-done").flag("ok") == true);
  rig.settle();
  CHECK(lastPart(rig).find("failure")->isNull());
  CHECK(rig.state().number("undo") == undo + 2);
}
