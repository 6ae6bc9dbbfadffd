// Cutting a thing out on the page: by tap and box, corrected by marks, used or left.
#include <doctest/doctest.h>

#include <numbers>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using spineloft::test::Rig;

namespace {

/// Square picture pixels inside the outlines that are shown.
double shownArea(const app::Json& contours) {
  double area = 0;
  for (const app::Json& contour : *contours.array()) {
    const auto& points = *contour.array();
    double twice = 0;
    for (std::size_t i = 0, j = points.size() - 1; i < points.size(); j = i++) {
      const auto x = [&](std::size_t k) { return *(*points[k].array())[0].number(); };
      const auto y = [&](std::size_t k) { return *(*points[k].array())[1].number(); };
      twice += x(j) * y(i) - x(i) * y(j);
    }
    area += twice / 2;
  }
  return std::abs(area);
}
double shownArea(Rig& rig) {
  const app::Json state = rig.state();
  const app::Json* cut = state.find("cut");
  REQUIRE_FALSE(cut->isNull());
  CHECK(cut->flag("searching") == false);
  return shownArea(*cut->find("contours"));
}

constexpr double kBar = 41.0 * 141;  // of the picture of the rig

void boxRound(Rig& rig) {
  rig.run("puff");
  rig.run("cut-by-box");
  rig.press(70, 20, 132, 182);
  rig.lift();
  rig.settle();
}

}  // namespace

TEST_CASE("a box round the thing cuts it out, with threads and without; used, it is one step" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    Rig rig({1200, 700, 1}, threads);
    rig.openBar();
    const double undo = *rig.state().number("undo");
    boxRound(rig);
    CHECK(rig.parts() == 0);
    CHECK(shownArea(rig) == doctest::Approx(kBar).epsilon(0.05));
    CHECK(rig.run("cut-use").flag("ok") == true);
    rig.settle();
    CHECK(rig.parts() == 1);
    CHECK(rig.state().number("undo") == undo + 1);
    CHECK(rig.state().find("cut")->isNull());
  }
}

TEST_CASE("a scribble over both colours of a thing cuts out both, a tap on one of them that one alone") {
  Rig rig;
  image::Picture two = test::barPicture();  // dark above, red below, on white
  for (int y = 100; y < 171; ++y) {
    for (int x = 80; x < 121; ++x) {
      std::uint8_t* rgba = &two.working.pixels[4 * static_cast<std::size_t>(y * 200 + x)];
      rgba[0] = 220;
      rgba[1] = 60;
    }
  }
  rig.app->addPicture(std::move(two), "two.png");
  rig.settle();
  rig.run("puff");
  const auto p = rig.at(100, 60);
  rig.click(p.x, p.y);
  const double tapped = shownArea(rig);
  rig.run("cut-cancel");
  CHECK(rig.run("cut-by-scribble").flag("ok") == true);
  CHECK(rig.state().flag("cutByScribble") == true);
  rig.press(100, 45, 102, 155);
  CHECK(rig.parts() == 0);
  rig.lift();
  rig.settle();
  const double scribbled = shownArea(rig);
  CHECK(scribbled == doctest::Approx(kBar).epsilon(0.05));
  CHECK(tapped < 0.7 * scribbled);
  CHECK(rig.run("cut-use").flag("ok") == true);
  rig.settle();
  CHECK(rig.parts() == 1);
  // The box takes the scribble's place, the scribble the box's, and a second tap on its button the line's.
  CHECK(rig.run("cut-by-box").flag("ok") == true);
  CHECK(rig.state().flag("cutByScribble") == false);
  rig.run("cut-by-scribble");
  CHECK(rig.state().flag("cutByBox") == false);
  rig.run("cut-by-scribble");
  CHECK(rig.state().flag("cutByScribble") == false);
}

TEST_CASE("strokes add and take away, undo takes them back one by one, then leaves the cut-out") {
  Rig rig;
  rig.openBar();
  boxRound(rig);
  const double whole = shownArea(rig);
  rig.press(100, 60, 160, 60);  // out of the bar, to the right
  rig.lift();
  rig.settle();
  const double more = shownArea(rig);
  CHECK(more > whole + 300);
  CHECK(rig.run("cut-remove").flag("ok") == true);
  rig.press(85, 150, 115, 150);
  rig.lift();
  rig.settle();
  CHECK(shownArea(rig) < more - 300);
  CHECK(rig.state().find("cut")->number("marks") == 2);
  CHECK(rig.run("undo").flag("ok") == true);
  rig.settle();
  CHECK(shownArea(rig) == doctest::Approx(more));
  CHECK(rig.run("undo").flag("ok") == true);
  rig.settle();
  CHECK(shownArea(rig) == doctest::Approx(whole));
  CHECK(rig.run("redo").flag("ok") == true);
  rig.settle();
  CHECK(shownArea(rig) == doctest::Approx(more));
  rig.run("undo");
  rig.run("undo");
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.state().number("undo") == 1);  // only the picture
  CHECK(rig.parts() == 0);
}

TEST_CASE("Escape and another model leave the cut-out; a gesture in hand goes first") {
  Rig rig;
  rig.openBar();
  boxRound(rig);
  rig.press(100, 60, 160, 60);
  rig.key("Escape", "Escape");
  rig.lift();
  CHECK(rig.state().find("cut")->number("marks") == 0);
  rig.key("Escape", "Escape");
  CHECK(rig.state().find("cut")->isNull());
  boxRound(rig);
  rig.run("clear");
  rig.settle();
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.parts() == 0);
}

TEST_CASE("another tool uses what is cut out, in one step; a part chosen meanwhile stays chosen") {
  Rig rig;
  rig.openBar();
  boxRound(rig);
  rig.run("sheet");
  rig.settle();
  CHECK_FALSE(rig.state().find("cut")->isNull());
  CHECK(rig.parts() == 0);
  const double undo = *rig.state().number("undo");
  rig.run("draw");
  rig.settle();
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.parts() == 1);
  CHECK(rig.state().number("undo") == undo + 1);
  CHECK(*rig.state().text("tool") == "draw");
  const double first = *rig.state().number("selection");
  rig.key("Escape", "Escape");
  CHECK(rig.state().find("selection")->isNull());
  boxRound(rig);
  rig.run("select-part", R"({"id":)" + std::to_string(static_cast<int>(first)) + "}");
  rig.run("hand");
  rig.settle();
  CHECK(rig.parts() == 2);
  CHECK(*rig.state().number("selection") == first);
}

TEST_CASE("a cut-out that is still searched for goes with its tool") {
  Rig rig;
  rig.openBar();
  rig.run("puff");
  rig.run("cut-start", R"({"box":[[70,20],[132,182]]})");
  rig.run("draw");
  rig.settle();
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.parts() == 0);
}

TEST_CASE("cancelled work leaves what was shown before") {
  Rig rig;
  rig.openBar();
  rig.run("puff");
  rig.run("cut-start", R"({"box":[[70,20],[132,182]]})");
  CHECK(rig.state().find("cut")->flag("searching") == true);
  rig.app->cancelWork();
  rig.settle();
  CHECK(rig.state().find("cut")->isNull());
  boxRound(rig);
  const double whole = shownArea(rig);
  rig.run("cut-mark", R"({"line":[[100,60],[160,60]],"radius":8})");
  rig.app->cancelWork();
  rig.settle();
  CHECK(shownArea(rig) == doctest::Approx(whole));
  CHECK(rig.state().find("cut")->number("marks") == 0);
}

TEST_CASE("by command a cut-out becomes a part at once, or the region of one; bad hints are refused") {
  Rig rig;
  rig.openBar();
  CHECK(rig.run("cut-out", R"({"at":[100,100],"as":"sheet"})").flag("ok") == true);
  rig.settle();
  REQUIRE(rig.parts() == 1);
  const auto part = [&] { return (*rig.state().find("parts")->array())[0]; };
  CHECK(*part().text("kind") == "sheet");
  rig.run("redraw-region", R"({"contours":[[[5,5],[40,5],[40,40]]],"part":1})");
  CHECK(shownArea(*part().find("contours")) < 1000);
  CHECK(rig.run("cut-out", R"({"box":[[70,20],[132,182]],"part":1})").flag("ok") == true);
  rig.settle();
  CHECK(rig.parts() == 1);
  CHECK(shownArea(*part().find("contours")) == doctest::Approx(kBar).epsilon(0.05));
  for (const char* bad : {R"({"at":[null,10]})", R"({"box":[[null,3],[4,4]]})"}) {
    CHECK_MESSAGE(*rig.run("cut-out", bad).text("error") == "ValueOutOfRange", bad);
  }
  // A hand that slips says no number.
  for (const char* slip : {R"({"at":[-40,10]})", R"({"box":[[300,300],[400,400]]})"}) {
    const app::Json beside = rig.run("cut-out", slip);
    CHECK(*beside.text("error") == "RegionOutside");
    CHECK(beside.text("sentence")->find("(") == std::string::npos);
  }
  CHECK(*rig.run("cut-out", R"({"box":[[20,50],[90,50]]})").text("error") == "RegionEmpty");
  CHECK(*rig.run("cut-mark", R"({"line":[[1,1]]})").text("error") == "NotNow");
  rig.run("select-part", R"({"id":null})");
  rig.run("cut-start", R"({"at":[100,100]})");
  rig.settle();
  CHECK(*rig.run("cut-mark", "{}").text("error") == "ArgumentMissing");
  CHECK(*rig.run("cut-mark", R"({"line":[[500,500]]})").text("error") == "RegionOutside");
  CHECK(*rig.run("cut-mark", R"({"line":[[50,50]],"radius":-3})").text("error") == "ValueOutOfRange");
}

TEST_CASE("the line at the foot tells of the tool in use, and no longer of a cut-out that is over") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const auto status = [&] {
    std::string last;
    for (const std::string& json : rig.host.sent) {
      const app::Json message = *app::Json::parse(json);
      if (*message.text("type") == "status") last = *message.text("text");
    }
    return last;
  };
  const std::string_view tools[] = {"puff",         "draw", "ribs",  "hand", "shape",
                                    "ignore-edges", "bone", "sheet", "move", "draw"};
  std::string before;
  for (const std::string_view tool : tools) {
    REQUIRE(rig.run(tool).flag("ok") == true);
    CHECK_MESSAGE(status() != before, tool);
    CHECK(status().size() > 10);
    before = status();
  }
  for (const char* way : {"cut-use", "cut-cancel", "undo", "draw"}) {
    rig.run("select-part", R"({"id":null})");
    rig.run("cut-start", R"({"at":[100,100]})");
    rig.settle();
    REQUIRE(status().find("Use this") != std::string::npos);
    rig.run(way);
    rig.settle();
    CHECK_MESSAGE(status().find("Use this") == std::string::npos, way);
    if (way == std::string_view("cut-use")) CHECK_FALSE(status().empty());  // what was made
  }
}

TEST_CASE("where nothing can be cut out a sentence says so, and nothing else happens") {
  Rig rig;
  image::Picture blank = test::barPicture();
  for (std::uint8_t& v : blank.working.pixels) v = 255;
  rig.app->addPicture(std::move(blank), "blank.png");
  rig.settle();
  rig.run("puff");
  const auto p = rig.at(100, 100);
  rig.click(p.x, p.y);
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.parts() == 0);
  CHECK(rig.host.said(R"("level":"error")"));
}

TEST_CASE("a tap on a thing that a bone lies on selects the bone first, and then cuts the thing out") {
  Rig rig;
  rig.openBar();
  REQUIRE(rig.works("draw-spine", R"({"stroke":[[100,40],[100,90]]})"));
  rig.settle();
  const double bone = *rig.state().number("selection");
  REQUIRE(rig.works("puff"));
  rig.key("Escape", "Escape");
  REQUIRE(rig.works("select-part", R"({"id":null})"));
  REQUIRE(rig.works("puff"));
  const auto tap = [&] {
    rig.press(100, 65, 100, 65);
    rig.lift();
    rig.settle();
  };
  tap();
  CHECK(*rig.state().number("selection") == bone);
  CHECK(rig.state().find("cut")->isNull());
  tap();
  CHECK_FALSE(rig.state().find("cut")->isNull());
}

TEST_CASE("another tool while a mark is looked at waits for it; where that is cancelled, what was there is used") {
  for (const bool cancelled : {false, true}) {
    CAPTURE(cancelled);
    Rig rig;
    rig.openBar();
    boxRound(rig);
    rig.run("cut-mark", R"({"line":[[100,60],[160,60]],"radius":8})");
    rig.run("draw");
    CHECK_FALSE(rig.state().find("cut")->isNull());
    CHECK(rig.parts() == 0);
    if (cancelled) rig.app->cancelWork();
    rig.settle();
    CHECK(rig.state().find("cut")->isNull());
    CHECK(rig.parts() == 1);
  }
}
