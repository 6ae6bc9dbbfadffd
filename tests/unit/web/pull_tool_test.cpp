// The tool Pull: lines on the solid, knobs by every pointer, keys and words.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "engine/document/update.h"
#include "tests/unit/web/rig.h"

using namespace spineloft;
using test::Rig;

namespace {

constexpr std::array kDevices = {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen};

/// A puff, seen from the front in the solid view, with the tool in hand.
struct Pulls : Rig {
  explicit Pulls(platform::CanvasSize size = {1200, 700, 1}) : Rig(size) {
    CHECK(works("new-sketch", R"({"width": 1000, "height": 800})"));
    CHECK(works("draw-puff", R"({"contours": [[[300, 250], [700, 250], [700, 550], [300, 550]]]})"));
    CHECK(works("home-view"));
    CHECK(works("pull"));
  }
  app::Json::Array pulls() { return *state().find("parts")->array()->front().find("pulls")->array(); }
  double chosen() { return *state().find("chosen")->number("pull"); }
  Vec2<platform::CanvasSpace> knob(std::size_t i) {
    const app::Json now = state();
    const auto& at = *(*now.find("pullKnobs")->array()).at(i).find("at")->array();
    return {*at[0].number(), *at[1].number()};
  }
  Vec2<platform::CanvasSpace> middle() {
    const auto centre = app->ui().layout.solid.centre();
    return {centre.x, centre.y};
  }
  void drag(Vec2<platform::CanvasSpace> from, Vec2<platform::CanvasSpace> to, platform::Device device = {}) {
    pointer(platform::PointerKind::Down, from.x, from.y, device);
    for (int i = 1; i <= 10; ++i) {
      const auto p = lerp(from, to, i / 10.0);
      pointer(platform::PointerKind::Move, p.x, p.y, device);
      settle(2);
    }
    pointer(platform::PointerKind::Up, to.x, to.y, device);
    settle();
  }
  void draw(const std::vector<Vec2<platform::CanvasSpace>>& line) {
    pointer(platform::PointerKind::Down, line.front().x, line.front().y);
    for (std::size_t i = 1; i < line.size(); ++i) {
      for (int k = 1; k <= 6; ++k) {
        const auto p = lerp(line[i - 1], line[i], k / 6.0);
        pointer(platform::PointerKind::Move, p.x, p.y);
      }
    }
    pointer(platform::PointerKind::Up, line.back().x, line.back().y);
    settle();
  }
  /// 40 steps go all the way round.
  void drawRing(Vec2<platform::CanvasSpace> centre, double radius, platform::Device device = {}, int steps = 39) {
    const auto place = [&](int i) {
      const double a = 2 * std::numbers::pi * i / 40;
      return Vec2<platform::CanvasSpace>{centre.x + radius * std::cos(a), centre.y + radius * std::sin(a)};
    };
    pointer(platform::PointerKind::Down, place(0).x, place(0).y, device);
    for (int i = 1; i <= steps; ++i) pointer(platform::PointerKind::Move, place(i).x, place(i).y, device);
    pointer(platform::PointerKind::Up, place(steps).x, place(steps).y, device);
    settle();
  }
  bool isOnSolid(double x, double y) {
    pointer(platform::PointerKind::Move, x + 1, y);
    pointer(platform::PointerKind::Move, x, y);
    settle(2);
    return !state().find("hover")->find("part")->isNull();
  }
  /// The highest place of the solid, so far beside the middle of its view.
  Vec2<platform::CanvasSpace> topOfSolid(double beside = 0) {
    const double x = middle().x + beside;
    double above = app->ui().layout.solid.y + 60, on = middle().y;
    REQUIRE(isOnSolid(x, on));
    while (on - above > 0.2) (isOnSolid(x, (above + on) / 2) ? on : above) = (above + on) / 2;
    return {x, on};
  }
  void tap(Vec2<platform::CanvasSpace> at, platform::Device device = {}) {
    pointer(platform::PointerKind::Down, at.x, at.y, device);
    pointer(platform::PointerKind::Up, at.x, at.y, device);
    settle();
  }
};

}  // namespace

TEST_CASE("a tap on the solid makes a bulge, its knob is dragged, each is one step: mouse, finger, pen") {
  for (const platform::Device device : kDevices) {
    CAPTURE(static_cast<int>(device));
    Pulls page;
    const double steps = page.undoSteps();
    page.tap(page.middle(), device);
    REQUIRE(page.pulls().size() == 1);
    CHECK(page.undoSteps() == steps + 1);
    CHECK(page.chosen() == 0);
    CHECK(*page.pulls()[0].number("points") == 1);
    const double height = *page.pulls()[0].number("height");
    CHECK(height > 5);
    // Seen end on, upwards is out.
    const auto at = page.knob(0);
    page.drag(at, {at.x, at.y - 40}, device);
    CHECK(page.undoSteps() == steps + 2);
    CHECK(*page.pulls()[0].number("height") > height + 20);
    CHECK(page.works("undo"));
    CHECK(*page.pulls()[0].number("height") == height);
    CHECK(page.works("undo"));
    CHECK(page.pulls().empty());
  }
}

TEST_CASE("a line on the solid is pulled as a whole, and a gesture that is given up leaves nothing") {
  Pulls page;
  const auto at = page.middle();
  page.drag({at.x - 60, at.y}, {at.x + 60, at.y});
  REQUIRE(page.pulls().size() == 1);
  CHECK(*page.pulls()[0].number("points") > 5);
  CHECK(page.works("undo"));
  page.pointer(platform::PointerKind::Down, at.x, at.y);
  page.pointer(platform::PointerKind::Move, at.x + 50, at.y);
  page.key("Escape", "Escape");
  page.pointer(platform::PointerKind::Up, at.x + 50, at.y);
  page.settle();
  CHECK(page.pulls().empty());
}

TEST_CASE("a ring on the solid makes a bump, whose knob is its height: mouse, finger, pen") {
  for (const platform::Device device : kDevices) {
    CAPTURE(static_cast<int>(device));
    Pulls page;
    const double steps = page.undoSteps();
    page.drawRing(page.middle(), 60, device);
    REQUIRE(page.pulls().size() == 1);
    CHECK(page.undoSteps() == steps + 1);
    CHECK(page.chosen() == 0);
    CHECK(*page.pulls()[0].number("points") == 1);
    CHECK(*page.pulls()[0].number("ring") > 20);
    const double height = *page.pulls()[0].number("height");
    CHECK(height > 5);
    const auto at = page.knob(0);
    page.drag(at, {at.x, at.y - 40}, device);
    CHECK(*page.pulls()[0].number("height") > height + 20);
    CHECK(page.undoSteps() == steps + 2);
  }
}

TEST_CASE("a ring that is drawn beyond its beginning, or like a smile, is one with its top well within it") {
  Pulls page;
  page.drawRing(page.middle(), 60, {}, 46);
  const auto at = page.middle();
  std::vector<Vec2<platform::CanvasSpace>> smile;
  for (int i = 0; i <= 20; ++i) {
    const double a = 0.3 + (std::numbers::pi - 0.6) * i / 20;
    smile.push_back({at.x + 90 * std::cos(a), at.y + 90 * std::sin(a)});
  }
  for (int i = 20; i >= 0; --i) {
    const double a = 0.3 + (std::numbers::pi - 0.6) * i / 20;
    smile.push_back({at.x + 90 * std::cos(a), at.y + 55 * std::sin(a) - 5});
  }
  page.draw(smile);
  REQUIRE(page.pulls().size() == 2);
  for (const app::Json& pull : page.pulls()) {
    CHECK(*pull.number("ring") > 20);
    CHECK(*pull.number("share") == 1);
  }
  // The overlap is left out: the ring is as round as its circle.
  const pull::Pull round = page.shared().parts[0]->pulls.at(0);
  ModelPoint centre;
  for (const ModelPoint p : round.ring) centre += p / static_cast<double>(round.ring.size());
  for (const ModelPoint p : round.ring) CHECK(distance(p, centre) > 0.85 * distance(round.ring[0], centre));
}

TEST_CASE("hearts and five-pointed stars are rings, and the knob of a heart is in its middle") {
  for (const bool heart : {true, false}) {
    Pulls page;
    const auto at = page.middle();
    std::vector<Vec2<platform::CanvasSpace>> line;
    for (int i = 0; i <= 40; ++i) {
      const double t = 2 * std::numbers::pi * (i % 40) / 40;
      if (heart) {
        const double x = 16 * std::pow(std::sin(t), 3),
                     y = 13 * std::cos(t) - 5 * std::cos(2 * t) - 2 * std::cos(3 * t) - std::cos(4 * t);
        line.push_back({at.x + 4 * x, at.y - 4 * y});
      } else if (i % 4 == 0) {
        const double reach = i % 8 == 0 ? 70 : 27;
        line.push_back({at.x + reach * std::sin(t), at.y - reach * std::cos(t)});
      }
    }
    page.draw(line);
    REQUIRE(page.pulls().size() == 1);
    CHECK(*page.pulls()[0].number("ring") > 20);
    if (!heart) continue;
    const pull::Pull drawn = page.shared().parts[0]->pulls.at(0);
    double low = 1e9, high = -1e9;
    for (const ModelPoint p : drawn.ring) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
    }
    CHECK(drawn.line[0].x == doctest::Approx((low + high) / 2).epsilon(0.02));
  }
}

TEST_CASE("a tap that trembles makes a place, not a ring") {
  Pulls page;
  page.drawRing(page.middle(), 6, platform::Device::Touch);
  REQUIRE(page.pulls().size() == 1);
  CHECK(*page.pulls()[0].number("ring") == 0);
}

TEST_CASE("a line that does not come back, or crosses itself, or hardly leaves itself, is no ring") {
  Pulls page;
  const auto at = page.middle();
  page.draw({{at.x - 60, at.y - 50},
             {at.x + 60, at.y - 90},
             {at.x + 60, at.y - 50},
             {at.x - 30, at.y - 90},
             {at.x - 58, at.y - 53}});
  REQUIRE(page.pulls().size() == 1);
  CHECK(*page.pulls()[0].number("ring") == 0);
  CHECK(page.works("undo"));
  page.draw({{at.x - 60, at.y}, {at.x, at.y - 60}, {at.x + 60, at.y}});
  page.draw({{at.x - 60, at.y + 30}, {at.x + 60, at.y + 32}, {at.x - 55, at.y + 36}});
  REQUIRE(page.pulls().size() == 2);
  for (const app::Json& pull : page.pulls()) CHECK(*pull.number("ring") == 0);
}

TEST_CASE("keys make a bump in the middle of the view, make it wider, give it an edge, and take it away") {
  Pulls page;
  page.key("Enter", "Enter", platform::kShift);
  REQUIRE(page.pulls().size() == 1);
  const auto sizeNow = [&] {
    const pull::Pull pull = page.shared().parts[0]->pulls.at(0);
    double most = 0;
    for (const ModelPoint p : pull.ring) most = std::max(most, distance(p, pull.ring[0]));
    return most;
  };
  const double before = sizeNow();
  page.key("BracketRight", "]");
  CHECK(sizeNow() == doctest::Approx(1.25 * before).epsilon(0.02));
  page.key("BracketLeft", "[");
  CHECK(sizeNow() == doctest::Approx(before).epsilon(0.02));
  for (int i = 0; i < 12; ++i) page.key("BracketRight", "]");
  CHECK(sizeNow() < 500);  // the part is 400 wide
  page.key("KeyE", "e");
  CHECK(page.pulls()[0].flag("crease") == true);
  page.key("Delete", "Delete");
  CHECK(page.pulls().empty());
}

TEST_CASE("beside the solid a drag turns the view, and makes no pull") {
  Pulls page;
  const auto at = page.middle();
  const double yaw = *page.state().find("camera")->number("yaw");
  page.drag({at.x - 180, at.y + 200}, {at.x - 120, at.y + 200});
  CHECK(page.pulls().empty());
  CHECK(*page.state().find("camera")->number("yaw") != yaw);
}

TEST_CASE("a line from the outline to the outline is the outline that is seen then, from the front and turned") {
  for (const int turns : {0, 3}) {
    CAPTURE(turns);
    Pulls page;
    for (int i = 0; i < turns; ++i) CHECK(page.works("turn-left"));
    const auto top = page.topOfSolid();
    // An arch over the top: its middle is 60 pixels above the solid.
    const auto from = page.topOfSolid(-70), to = page.topOfSolid(70);
    page.draw({{from.x, from.y - 6},
               {top.x - 50, top.y - 40},
               {top.x, top.y - 60},
               {top.x + 50, top.y - 40},
               {to.x, to.y - 6}});
    REQUIRE(page.pulls().size() == 1);
    CHECK(*page.pulls()[0].number("to") > 5);
    CHECK(page.topOfSolid().y == doctest::Approx(top.y - 60).epsilon(0.01));
    // Its knob is where it was drawn, goes further out and back in, also past where the outline was.
    for (const auto& [key, way] : {std::pair{"ArrowUp", 1}, {"ArrowDown", -1}}) {
      const double before = page.topOfSolid().y;
      for (int i = 0; i < 3; ++i) page.key(key, key);
      CHECK((page.topOfSolid().y - before) * way < -1);
    }
    const app::Json now = page.state();
    CHECK((*now.find("pullKnobs")->array())[0].find("at")->array() != nullptr);
    while (!page.pulls().empty()) CHECK(page.works("undo"));
    CHECK(page.topOfSolid().y == doctest::Approx(top.y).epsilon(0.001));
  }
}

TEST_CASE("a line that leaves the outline and does not come back changes nothing and says so") {
  Pulls page;
  const auto top = page.topOfSolid();
  page.draw({{top.x - 40, top.y - 5}, {top.x - 20, top.y - 60}, {top.x + 10, top.y - 90}});
  CHECK(page.pulls().empty());
  CHECK(page.host.said("A new outline begins and ends at the old one"));
}

TEST_CASE("keys choose, raise, widen, sharpen and remove a pull") {
  Pulls page;
  CHECK(page.works("pull", R"({"line": [[420, 400]], "height": 20, "radius": 40})"));
  CHECK(page.works("pull", R"({"line": [[580, 400]], "height": 20, "radius": 40})"));
  REQUIRE(page.pulls().size() == 2);
  page.key("Period", ".");
  CHECK(page.chosen() == 0);
  page.key("Period", ".");
  CHECK(page.chosen() == 1);
  const double steps = page.undoSteps();
  page.key("ArrowUp", "ArrowUp");
  page.key("ArrowUp", "ArrowUp");
  CHECK(*page.pulls()[1].number("height") == doctest::Approx(28));
  CHECK(page.undoSteps() == steps + 1);
  page.key("BracketRight", "]");
  CHECK(*page.pulls()[1].number("radius") == doctest::Approx(50));
  page.key("KeyE", "e");
  CHECK(page.pulls()[1].flag("crease") == true);
  CHECK(page.state().find("options")->flag("pullSharp") == false);
  page.key("Delete", "Delete");
  REQUIRE(page.pulls().size() == 1);
  CHECK(page.parts() == 1);
  CHECK(page.chosen() == 0);
  CHECK(*page.pulls()[0].number("height") == 20);
  page.key("Delete", "Delete");
  CHECK(page.pulls().empty());
  CHECK(page.parts() == 1);
  page.key("Enter", "Enter");
  CHECK(page.pulls().size() == 1);
}

TEST_CASE("programs pull by numbers, and are told what is wrong") {
  Pulls page;
  CHECK(page.works("pull", R"({"line": [[400, 380], [600, 380]], "to": [[400, -380, 200], [600, -380, 200]]})"));
  CHECK(*page.pulls()[0].number("to") == 2);
  CHECK(page.works("set-pull", R"({"pull": 0, "radius": 30, "crease": true})"));
  CHECK(*page.pulls()[0].number("radius") == 30);
  CHECK(page.works("pull", R"({"ring": [[460, 360], [540, 360], [540, 440], [460, 440]], "height": 12})"));
  CHECK(*page.pulls()[1].number("ring") == 4);
  CHECK(*page.pulls()[1].number("height") == 12);
  CHECK(page.works("undo"));
  CHECK(page.fault("pull", R"({"ring": [[460, 360], [540, 360]]})") != "");
  CHECK(page.fault("pull", R"({"line": [[500, 400]], "across": [[500, 380], [500, 420]],
                               "acrossTo": [[500, 380], [500, 420]]})") != "");  // without `to`
  CHECK(page.fault("pull", R"({"line": [[10, 10]]})") != "");                    // beside the part
  CHECK(page.fault("pull", R"({"line": "across"})") != "");
  CHECK(page.fault("set-pull", R"({"pull": 3})") != "");
  CHECK(page.fault("set-pull", R"({"pull": 0, "radius": -1})") != "");
  CHECK(page.pulls().size() == 1);
  CHECK(page.works("set-pull", R"({"pull": 0, "remove": true})"));
  CHECK(page.pulls().empty());
}

TEST_CASE("the height of a pull is a slider for those who use no pointer, also of one that was told where to go") {
  Pulls page;
  CHECK(page.works("pull", R"({"line": [[400, 400]], "height": 20, "radius": 40})"));
  CHECK(page.works("pull", R"({"line": [[600, 400]], "to": [[600, -400, 180]], "radius": 40})"));
  const auto slider = [&](int number) {
    const app::Json now = page.state();
    for (const app::Json& control : *now.find("controls")->array()) {
      if (*control.text("words") == "Height of pull " + std::to_string(number) + " of 2") return control;
    }
    return app::Json();
  };
  for (const int number : {1, 2}) {
    CAPTURE(number);
    const app::Json before = slider(number);
    REQUIRE(before.find("slide") != nullptr);
    const double now = *before.find("slide")->number("value");
    page.app->workControl(static_cast<std::uint32_t>(*before.number("id")), now + 2);
    page.settle();
    CHECK(*slider(number).find("slide")->number("value") == doctest::Approx(now + 2).epsilon(0.02));
  }
}

TEST_CASE("a pull that would go through the part goes as far as it can, and no farther by more steps") {
  Pulls page;
  CHECK(page.works("pull", R"({"line": [[500, 400]], "height": -900, "radius": 60})"));
  const auto height = [&] { return *page.pulls()[0].number("height"); };
  const double kept = height();
  CHECK(kept < -60);
  CHECK(kept > -900);
  CHECK(*page.pulls()[0].number("share") == 1);
  CHECK(page.host.said("Any further, and it would go through itself"));
  page.key("Period", ".");
  for (int i = 0; i < 12; ++i) page.key("ArrowDown", "ArrowDown");
  CHECK(height() <= kept);
  CHECK(height() > 1.5 * kept);
  CHECK(*page.pulls()[0].number("share") == 1);
  CHECK(page.works("set-pull", R"({"pull": 0, "height": 10})"));
  CHECK(height() == 10);
}

TEST_CASE("a new pull says what to do with it") {
  Pulls page;
  page.tap(page.middle());
  CHECK(page.host.sent.size() > 1);
  bool last = false;
  for (const std::string& json : page.host.sent) {
    if (json.find("Done: Pull") != std::string::npos) last = false;
    if (json.find("Drag the knob out or in") != std::string::npos) last = true;
  }
  CHECK(last);
}

TEST_CASE("the outline of a piece with few corners is drawn anew from the middle of its edge") {
  Pulls page;
  CHECK(page.works("draw-sheet", R"({"contours": [[[200, 100], [800, 100], [800, 700], [200, 700]]]})"));
  CHECK(page.works("home-view"));
  CHECK(page.works("pull"));
  const auto from = page.topOfSolid(-60), top = page.topOfSolid(), to = page.topOfSolid(60);
  page.draw({{from.x, from.y - 6}, {top.x, top.y - 40}, {to.x, to.y - 6}});
  const app::Json now = page.state();
  REQUIRE(now.find("parts")->array()->back().find("pulls")->array()->size() == 1);
  CHECK(page.topOfSolid().y < top.y - 25);
}

TEST_CASE("the twin of a part with symmetry is pulled as the part itself") {
  Pulls page;
  CHECK(page.works("symmetry", R"({"axis": "x"})"));
  CHECK(page.works("home-view"));
  CHECK(page.works("pull"));
  const app::UiState& ui = page.app->ui();
  std::size_t taps = 0;
  // Both stand side by side: two taps on each.
  for (const double share : {0.3, 0.4, 0.6, 0.7}) {
    CAPTURE(share);
    page.tap({ui.layout.solid.x + share * ui.layout.solid.width, page.middle().y});
    CHECK(page.pulls().size() == ++taps);
  }
  for (const app::Json& pull : page.pulls()) CHECK(*pull.number("points") == 1);
}

TEST_CASE("a line on a part that is not in hand takes it and pulls there; a tap only takes it") {
  Pulls page;
  REQUIRE(page.works("draw-puff", R"({"contours": [[[60, 40], [200, 40], [200, 160], [60, 160]]]})"));
  page.settle();
  const double second = *page.state().number("selection");
  REQUIRE(page.works("home-view"));
  REQUIRE(page.works("pull"));
  page.settle();
  page.tap(page.middle());
  const double first = *page.state().number("selection");
  REQUIRE(first != second);
  CHECK(page.pulls().empty());
  REQUIRE(page.works("select-part", R"({"id":)" + std::to_string(static_cast<int>(second)) + "}"));
  page.settle();
  const auto at = page.middle();
  page.draw({at, {at.x + 30, at.y + 4}, {at.x + 60, at.y}});
  CHECK(*page.state().number("selection") == first);
  CHECK(page.pulls().size() == 1);
}
