// The tool Bridge: from a place of the solid to another, its ends moved by every pointer, keys and words.
#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <string>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using test::Rig;
using Place = Vec2<platform::CanvasSpace>;

namespace {

constexpr std::array kDevices = {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen};

/// Two balls beside each other, seen from the front in the solid view, with the tool in hand.
struct Bridges : Rig {
  explicit Bridges(platform::CanvasSize size = {1200, 700, 1}) : Rig(size) {
    CHECK(works("new-sketch", R"({"width": 1000, "height": 600})"));
    CHECK(works("draw-shape", R"({"kind": "ball", "axis": [[250, 420], [250, 180]]})"));
    CHECK(works("draw-shape", R"({"kind": "ball", "axis": [[750, 400], [750, 200]]})"));
    CHECK(works("home-view"));
    CHECK(works("select-part", R"({"id": 1})"));
    CHECK(works("bridge"));
    CHECK(*state().text("tool") == "bridge");
  }
  /// Near to where a place of the picture is on the fronts of the balls.
  Place onCanvas(double x, double y) {
    const WorldPoint p{(x - 500) / 1000, (300 - y) / 1000, 0.1};
    const auto at = app::pointOnCanvas(app->ui().camera, app->ui().layout.solid, p);
    REQUIRE(at);
    return {at->x, at->y};
  }
  void drag(Place from, Place to, platform::Device device = {}) {
    pointer(platform::PointerKind::Down, from.x, from.y, device);
    for (int i = 1; i <= 10; ++i) {
      const Place p = lerp(from, to, i / 10.0);
      pointer(platform::PointerKind::Move, p.x, p.y, device);
      settle(2);
    }
    pointer(platform::PointerKind::Up, to.x, to.y, device);
    settle(60);  // a solid waits for its solver
  }
  std::size_t parts() { return state().find("parts")->array()->size(); }
  app::Json part(std::size_t i) { return state().find("parts")->array()->at(i); }
  Place knob(std::size_t end) {
    const app::Json now = state();
    const auto& at = *now.find("bridgeKnobs")->array()->at(end).array();
    return {*at[0].number(), *at[1].number()};
  }
};

}  // namespace

TEST_CASE("a drag from one ball to the other makes a bridge in one solid with them, one step: mouse, finger, pen") {
  for (const platform::Device device : kDevices) {
    CAPTURE(static_cast<int>(device));
    Bridges page;
    const double steps = page.undoSteps();
    page.drag(page.onCanvas(330, 300), page.onCanvas(740, 300), device);
    REQUIRE(page.parts() == 3);
    CHECK(page.undoSteps() == steps + 1);
    const app::Json bridge = page.part(2);
    CHECK(*bridge.text("kind") == "bridge");
    CHECK(*bridge.find("bridge")->find("from")->number("part") == 1);
    CHECK(*bridge.find("bridge")->find("to")->number("part") == 2);
    CHECK(bridge.find("failure")->isNull());
    CHECK(*page.state().number("selection") == 3);
    CHECK(page.state().find("steps")->array()->size() == 1);
    CHECK(page.state().find("bridgeKnobs")->array()->size() == 2);
    CHECK(page.works("undo"));
    CHECK(page.parts() == 2);
    CHECK(page.state().find("steps")->array()->empty());
  }
}

TEST_CASE("a drag within one part makes a handle, and one that ends beside the solid says what to do") {
  Bridges page;
  page.drag(page.onCanvas(250, 210), page.onCanvas(330, 330));
  REQUIRE(page.parts() == 3);
  CHECK(*page.part(2).find("bridge")->find("to")->number("part") == 1);
  CHECK(page.works("undo"));
  page.host.sent.clear();
  page.drag(page.onCanvas(330, 300), page.onCanvas(500, 80));
  CHECK(page.parts() == 2);
  CHECK(page.host.said("A bridge ends on the solid"));
}

TEST_CASE(
    "the ends of a bridge are dragged to other places, each one step, and a gesture that is given up leaves nothing") {
  for (const platform::Device device : kDevices) {
    CAPTURE(static_cast<int>(device));
    Bridges page;
    page.drag(page.onCanvas(330, 300), page.onCanvas(740, 300), device);
    const double steps = page.undoSteps();
    const auto heightOf = [&](std::string_view end) {
      return *page.part(2).find("bridge")->find(end)->find("at")->array()->at(1).number();
    };
    const double from = heightOf("from"), to = heightOf("to");
    const Place at = page.knob(0);
    page.drag(at, {at.x - 10, at.y - 40}, device);
    CHECK(page.undoSteps() == steps + 1);
    CHECK(heightOf("from") > from + 10);
    CHECK(heightOf("to") == doctest::Approx(to).epsilon(1e-3));
    const Place moved = page.knob(1);
    page.pointer(platform::PointerKind::Down, moved.x, moved.y, device);
    page.pointer(platform::PointerKind::Move, moved.x + 20, moved.y + 30, device);
    page.key("Escape", "Escape");
    page.pointer(platform::PointerKind::Up, moved.x + 20, moved.y + 30, device);
    page.settle(60);
    CHECK(page.undoSteps() == steps + 1);
    CHECK(heightOf("to") == doctest::Approx(to).epsilon(1e-3));
  }
}

TEST_CASE("a bridge goes along while a part that it stands on is dragged, in a solid and beside one") {
  for (const bool inSolid : {true, false}) {
    CAPTURE(inSolid);
    Bridges page;
    page.drag(page.onCanvas(330, 300), page.onCanvas(740, 300));
    if (!inSolid) CHECK(page.works("release", R"({"step": 1})"));
    CHECK(page.works("move"));
    CHECK(page.works("select-part", R"({"id": 2})"));
    const auto end = [&] { return *page.part(2).find("bridge")->find("to")->find("at")->array()->at(1).number(); };
    const double before = end();
    const Place from = page.onCanvas(790, 300);
    page.pointer(platform::PointerKind::Down, from.x, from.y);
    for (int i = 1; i <= 8; ++i) {
      page.pointer(platform::PointerKind::Move, from.x, from.y - 6 * i);
      page.settle(2);
    }
    CHECK(end() > before + 20);
    page.key("Escape", "Escape");
    page.pointer(platform::PointerKind::Up, from.x, from.y - 48);
    page.settle(60);
    CHECK(end() == doctest::Approx(before).epsilon(1e-3));
  }
}

TEST_CASE("a bridge that is dragged with the tool that moves takes its parts along") {
  Bridges page;
  page.drag(page.onCanvas(330, 300), page.onCanvas(740, 300));
  CHECK(page.works("move-parts", R"({"parts": [3], "move": [0, 0.1, 0]})"));
  for (const std::size_t i : {0u, 1u}) {
    CHECK(*page.part(i).find("placement")->find("move")->array()->at(1).number() == doctest::Approx(0.1));
  }
  CHECK(page.fault("set-place", R"({"part": 3, "x": 10})") == "BridgeFollows");
}

TEST_CASE("two parts in hand are joined where they are nearest, by keys alone; it gets wider and thinner") {
  Bridges page;
  CHECK(page.works("draw"));
  CHECK(page.works("select-part", R"({"id": 1})"));
  CHECK(page.works("select-part", R"({"id": 2, "add": true})"));
  CHECK(page.key("KeyJ", "J", platform::kShift));
  page.settle(60);
  REQUIRE(page.parts() == 3);
  const auto from = [&] { return *page.part(2).find("bridge")->find("from")->find("at")->array(); };
  CHECK(*from()[0].number() > 340);  // of a ball whose middle is at 250
  CHECK(std::abs(*from()[1].number() + 300) < 12);
  const auto radius = [&] { return *page.part(2).find("bridge")->find("to")->number("radius"); };
  const double usual = radius(), steps = page.undoSteps();
  CHECK(page.works("bridge-wider"));
  CHECK(radius() > 1.15 * usual);  // on a ball less than 1.25 times
  CHECK(page.works("bridge-narrower"));
  CHECK(radius() == doctest::Approx(usual).epsilon(0.03));
  CHECK(page.undoSteps() == steps + 2);
  CHECK(page.works("set-parameter", R"({"part": 3, "key": "waist", "value": 0.3})"));
  CHECK(page.fault("set-parameter", R"({"part": 3, "key": "waist", "value": 3})") != "");
}

TEST_CASE("programs name places, and what makes no bridge is refused in a sentence") {
  Bridges page;
  CHECK(page.works("bridge", R"({"from": {"part": 1, "at": [340, 300]}, "to": {"part": 2, "at": [670, 300, 10]},
                                 "width": 0.5, "waist": 0.8, "bow": 1.2})"));
  CHECK(page.parts() == 3);
  CHECK(*page.part(2).find("parameters")->number("waist") == 0.8);
  CHECK(page.fault("bridge", R"({"from": {"part": 1, "at": [340, 300]}})") != "");
  CHECK(page.fault("bridge", R"({"from": {"part": 1, "at": [10, 10]}, "to": {"part": 2, "at": [670, 300]}})") != "");
  CHECK(page.fault("bridge", R"({"from": {"part": 3, "at": [500, 300]}, "to": {"part": 2, "at": [670, 300]}})") != "");
  CHECK(page.fault("bridge", R"({"from": {"part": 1, "at": [340, 300]}, "to": {"part": 1, "at": [340, 300]}})") != "");
  CHECK(page.fault("bridge", R"({"parts": [1, 3]})") != "");
  CHECK(page.parts() == 3);
  CHECK(page.works("select-all"));
  CHECK(page.works("delete-part"));
  CHECK(page.parts() == 0);
  CHECK(page.works("undo"));
  // A part that goes takes its bridge along; undo brings both back.
  CHECK(page.works("delete-part", R"({"part": 2})"));
  CHECK(page.parts() == 1);
  CHECK(page.works("undo"));
  CHECK(page.parts() == 3);
}
