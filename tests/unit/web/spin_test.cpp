// Spun parts on the page: drawn beside the axis, changed by hand and by command.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "tests/unit/web/rig.h"
#include "web/edit/spinning.h"

using namespace spineloft;
using test::Rig;

namespace {

using Line = std::vector<PicturePoint>;

app::Json lastPart(Rig& rig) { return rig.state().find("parts")->array()->back(); }

PicturePoint pointIn(const app::Json& line, std::size_t index) {
  const app::Json& point = (*line.array())[index];
  return {*(*point.array())[0].number(), *(*point.array())[1].number()};
}
PicturePoint axisEnd(Rig& rig, std::size_t end) { return pointIn(*rig.state().find("axis"), end); }

/// Down at the first point, a few moves to each further one.
void drag(Rig& rig, const Line& line, platform::Device device = {}, bool lift = true) {
  auto at = rig.at(line[0].x, line[0].y);
  rig.pointer(platform::PointerKind::Down, at.x, at.y, device);
  for (std::size_t i = 1; i < line.size(); ++i) {
    for (int k = 1; k <= 6; ++k) {
      const PicturePoint p = lerp(line[i - 1], line[i], k / 6.0);
      at = rig.at(p.x, p.y);
      rig.pointer(platform::PointerKind::Move, at.x, at.y, device);
    }
  }
  rig.lastX = at.x;
  rig.lastY = at.y;
  if (lift) rig.lift(device);
  rig.settle();
}

/// A vessel right of the middle of the picture, from its foot to its rim.
const Line kVessel{{99.5, 160}, {130, 160}, {130, 150}, {104, 140}, {104, 90}, {135, 60}, {140, 30}};

double turnOf(Rig& rig) { return *lastPart(rig).find("parameters")->number("turn"); }

}  // namespace

TEST_CASE("one line beside the dashed one becomes a spun part, by mouse, finger and pen, in one step") {
  for (const platform::Device device : {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen}) {
    Rig rig;
    rig.openBar();
    CHECK(rig.state().find("axis")->isNull());
    REQUIRE(rig.run("spin").flag("ok") == true);
    // The axis stands in the middle of the picture, within it.
    CHECK(axisEnd(rig, 0).x == 99.5);
    CHECK(axisEnd(rig, 1).x == 99.5);
    const double undo = *rig.state().number("undo");
    drag(rig, kVessel, device, false);
    CHECK(*rig.state().find("preview")->number("triangles") > 100);
    rig.lift(device);
    rig.settle();
    const app::Json part = lastPart(rig);
    CHECK(*part.text("kind") == "lathe");
    CHECK(part.flag("open") == true);
    CHECK(part.find("failure")->isNull());
    // The profile and its mirror image.
    CHECK(part.number("outlines") == 2);
    CHECK(*part.number("triangles") > 1000);
    // A few points of a line that a hand drew.
    CHECK((*part.find("contours")->array())[0].array()->size() < 12);
    CHECK(rig.state().number("undo") == undo + 1);
    CHECK(rig.state().number("selection") == part.number("id"));
    rig.run("undo");
    CHECK(rig.parts() == 0);
    rig.run("redo");
    CHECK(rig.parts() == 1);
  }
}

TEST_CASE("Escape takes a line in hand back, and an axis in hand to where it was") {
  Rig rig;
  rig.openBar();
  rig.run("spin");
  drag(rig, kVessel, {}, false);
  rig.key("Escape", "Escape");
  rig.lift();
  CHECK(rig.parts() == 0);
  drag(rig, kVessel);
  drag(rig, {axisEnd(rig, 0), {60, 60}}, {}, false);
  CHECK(axisEnd(rig, 0) != PicturePoint{99.5, 12});
  rig.key("Escape", "Escape");
  rig.lift();
  CHECK(axisEnd(rig, 0) == PicturePoint{99.5, 12});
}

TEST_CASE(
    "a line begins anywhere on the axis, its ends included, while there is no part about it, or its line is drawn "
    "again") {
  struct Screen {
    platform::CanvasSize size;
    platform::Device device;
  };
  for (const Screen screen :
       {Screen{{1200, 700, 1}, platform::Device::Mouse}, Screen{{390, 844, 2}, platform::Device::Touch},
        Screen{{390, 844, 2}, platform::Device::Pen}}) {
    CAPTURE(screen.size.width);
    Rig rig(screen.size);
    rig.openBar();
    rig.run("spin");
    const PicturePoint from = axisEnd(rig, 0), to = axisEnd(rig, 1);
    for (const double way : {0.0, 0.02, 0.5, 0.98, 1.0}) {
      CAPTURE(way);
      const PicturePoint on = lerp(from, to, way);
      const Line line{on, {150, on.y}, {150, 100}, {130, 90}};
      drag(rig, line, screen.device);
      REQUIRE(rig.parts() == 1);
      REQUIRE(rig.run("redraw").flag("ok") == true);
      drag(rig, {on, {140, on.y}, {140, on.y + (way < 0.5 ? 60 : -60)}}, screen.device);
      CHECK(rig.parts() == 1);
      CHECK(pointIn((*lastPart(rig).find("contours")->array())[0], 1).x == doctest::Approx(140).epsilon(0.02));
      CHECK(axisEnd(rig, 0) == from);
      CHECK(axisEnd(rig, 1) == to);
      rig.run("undo");
      rig.run("undo");
      rig.settle();
    }
  }
}

TEST_CASE("the axis of the next part goes where the picture is tapped, and the part is turned about it") {
  Rig rig;
  rig.openBar();
  rig.run("spin");
  const double undo = *rig.state().number("undo");
  drag(rig, {{60, 150}});
  // Moved aside, and nothing of the model has changed.
  CHECK(distance(axisEnd(rig, 0), {60, 12}) < 1e-6);
  CHECK(axisEnd(rig, 1).x == axisEnd(rig, 0).x);
  CHECK(rig.state().number("undo") == undo);
  drag(rig, {{100, 60}, {100, 140}});
  CHECK(distance(pointIn(*lastPart(rig).find("axis"), 0), {60, 12}) < 1e-6);
  // A straight line makes a cylinder: two rings of 128, and a lid at either end.
  CHECK(*lastPart(rig).number("triangles") == 4 * 128);
}

TEST_CASE("the axis of the part in hand is moved in one step, and the next part is turned about the same one") {
  Rig rig;
  rig.openBar();
  rig.run("spin");
  drag(rig, kVessel);
  const double undo = *rig.state().number("undo");
  drag(rig, {axisEnd(rig, 0), {90, 12}});
  CHECK(rig.state().number("undo") == undo + 1);
  CHECK(pointIn(*lastPart(rig).find("axis"), 0).x == doctest::Approx(90).epsilon(0.01));
  CHECK(lastPart(rig).find("failure")->isNull());
  const PicturePoint moved = axisEnd(rig, 0);
  drag(rig, {{150, 60}, {150, 90}});
  REQUIRE(rig.parts() == 2);
  CHECK(distance(pointIn(*lastPart(rig).find("axis"), 0), moved) < 1e-6);
  rig.run("undo");
  rig.run("undo");
  rig.settle();
  CHECK(pointIn(*lastPart(rig).find("axis"), 0).x == 99.5);
}

TEST_CASE("points of a profile are dragged, and moved by keys") {
  Rig rig;
  rig.openBar();
  rig.run("spin");
  drag(rig, kVessel);
  rig.run("select-part", R"({"id":1})");
  const app::Json part = lastPart(rig);
  const app::Json& contours = *part.find("contours");
  const std::size_t last = contours.array()->front().array()->size() - 1;
  const PicturePoint rim = pointIn(contours.array()->front(), last);
  drag(rig, {rim, {160, 20}});
  const app::Json after = lastPart(rig);
  const PicturePoint moved = pointIn(after.find("contours")->array()->front(), last);
  CHECK(distance(moved, {160, 20}) < 1);
  CHECK(after.flag("open") == true);
  CHECK(rig.key("Comma", ","));
  CHECK(rig.key("ArrowLeft", "ArrowLeft"));
  CHECK(pointIn(lastPart(rig).find("contours")->array()->front(), last).x == doctest::Approx(moved.x - 1));
}

TEST_CASE("how far round, how many faces, a wall and a depth are parameters of the part") {
  Rig rig;
  rig.openBar();
  REQUIRE(rig.run("draw-lathe", R"({"lines":[[[99,160],[140,160],[140,60]]],"axis":[[99,160],[99,20]]})").flag("ok") ==
          true);
  rig.settle();
  const double round = *lastPart(rig).number("triangles");
  REQUIRE(rig.run("set-parameter", R"({"key":"sides","value":6})").flag("ok") == true);
  rig.settle();
  CHECK(*lastPart(rig).number("triangles") == round * 6 / 128);
  REQUIRE(rig.run("set-parameter", R"({"key":"turn","value":180})").flag("ok") == true);
  CHECK(turnOf(rig) == 180);
  REQUIRE(rig.run("set-parameter", R"({"key":"wall","value":0.05})").flag("ok") == true);
  REQUIRE(rig.run("set-parameter", R"({"key":"squash","value":0.5})").flag("ok") == true);
  rig.settle();
  CHECK(lastPart(rig).find("failure")->isNull());
  CHECK(*rig.run("set-parameter", R"({"key":"sides","value":2})").text("error") == "ValueOutOfRange");
  // The other ways of making a part of a region keep it.
  REQUIRE(rig.run("make-puff").flag("ok") == true);
  CHECK(*lastPart(rig).text("kind") == "puff");
  rig.run("undo");
  CHECK(*lastPart(rig).text("kind") == "lathe");
}

TEST_CASE("a bone and a puff of the same bar become the same cylinder, in one step, with name and look") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("draw-puff", R"({"contours":[[[80,30],[120,30],[120,170],[80,170]]]})");
  rig.settle();
  for (const double part : {1.0, 2.0}) {
    const double undo = *rig.state().number("undo");
    const app::Json done = rig.run("make-round", R"({"part":)" + std::to_string(static_cast<int>(part)) + "}");
    REQUIRE_MESSAGE(done.flag("ok") == true, (done.text("error") ? *done.text("error") : ""));
    rig.settle();
    const app::Json made = (*rig.state().find("parts")->array())[static_cast<std::size_t>(part) - 1];
    CHECK(*made.text("kind") == "lathe");
    CHECK(made.number("id") == part);
    CHECK(made.find("failure")->isNull());
    CHECK(rig.state().number("undo") == undo + 1);
    const PicturePoint from = pointIn(*made.find("axis"), 0), to = pointIn(*made.find("axis"), 1);
    CHECK(std::abs(from.x - 100) < 2);
    CHECK(from.x == doctest::Approx(to.x));
    CHECK(distance(from, to) == doctest::Approx(140).epsilon(0.2));
  }
  rig.run("undo");
  CHECK(*lastPart(rig).text("kind") == "puff");
}

TEST_CASE("what cannot be turned is refused with a sentence, and nothing changes") {
  Rig rig;
  rig.openBar();
  rig.run("spin");
  const std::string before = rig.app->state();
  const auto errorOf = [&](std::string_view args) { return *rig.run("draw-lathe", args).text("error"); };
  CHECK(errorOf(R"({"lines":[[[99.5,60],[99.5,140]]]})") == "ProfileOnAxis");
  CHECK(errorOf(R"({"lines":[[[null,60],[120,140]]]})") == "StrokeNotFinite");
  CHECK(errorOf(R"({"lines":[[[120,60],[120,140]]],"axis":[[99,20],[99,20]]})") == "ValueOutOfRange");
  CHECK(errorOf(R"({"lines":[[[120,60],[120,140]]],"sides":1})") == "ValueOutOfRange");
  CHECK(errorOf(R"({"lines":[[[120,60],[120,140]]],"wall":0.19})") == "WallTooThick");
  CHECK(errorOf("{}") == "ArgumentMissing");
  CHECK(*rig.run("set-axis", R"({"axis":[[9,9],[9,9]]})").text("error") == "ValueOutOfRange");
  CHECK(rig.app->state() == before);
  // A line on the axis by hand as well.
  drag(rig, {{99.5, 60}, {99.5, 140}});
  CHECK(rig.parts() == 0);
  CHECK(rig.host.said("lies on its axis"));
}

TEST_CASE("a line that crosses itself, and one that crosses the axis, are made and told about") {
  const auto said = [](std::string_view lines, std::string_view words) {
    Rig rig;
    rig.openBar();
    const std::string args = R"({"lines":[)" + std::string(lines) + R"(],"axis":[[99,180],[99,20]]})";
    REQUIRE(rig.run("draw-lathe", args).flag("ok") == true);
    rig.settle();
    CHECK(lastPart(rig).find("failure")->isNull());
    return rig.host.said(words);
  };
  const std::string_view plain = "[[99,160],[140,160],[140,60]]";
  const std::string_view loop = "[[99,160],[150,160],[110,100],[160,100],[130,160],[120,60],[99,60]]";
  const std::string_view over = "[[60,160],[140,160],[140,60],[80,60]]";
  CHECK_FALSE(said(plain, "Your line crosses itself"));
  CHECK_FALSE(said(plain, "beyond the dashed line"));
  CHECK(said(loop, "Your line crosses itself"));
  CHECK(said(over, "beyond the dashed line"));
}
