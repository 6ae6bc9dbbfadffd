// Controls of the panels for those who use no pointer: told to the shell when they are at rest, and worked by their
// ids.
#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <string>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using app::Control;
using app::Json;
using test::Rig;

namespace {

const Control& controlOf(const Rig& rig, std::string_view words, Control::Kind kind = Control::Kind::Button) {
  for (const Control& one : rig.app->ui().controls) {
    if (one.words == words && one.kind == kind) return one;
  }
  FAIL("no control " << words);
  return rig.app->ui().controls.front();
}

void work(Rig& rig, std::uint32_t id, std::optional<double> value = {}) {
  rig.app->workControl(id, value);
  rig.settle();
}

/// What the shell was told last; null: nothing.
Json told(const Rig& rig) {
  for (auto sent = rig.host.sent.rbegin(); sent != rig.host.sent.rend(); ++sent) {
    if (sent->starts_with(R"({"type":"controls")")) return *Json::parse(*sent);
  }
  return {};
}

}  // namespace

TEST_CASE("a control is pressed by its id as by a pointer, also one that its panel has scrolled away") {
  Rig page({1200, 420, 1});
  page.openBar();
  page.drawBar();
  work(page, controlOf(page, "Puff").id);
  CHECK(*page.state().text("tool") == "puff");
  work(page, controlOf(page, "Line").id);
  CHECK(*page.state().text("tool") == "draw");
  // Below the foot of the panel, where a pointer does not come.
  const Control metal = controlOf(page, "Metal");
  REQUIRE_FALSE(metal.inSight);
  work(page, metal.id);
  CHECK(*(*page.state().find("parts")->array())[0].text("paint") == "metal");
  CHECK(controlOf(page, "Metal").inSight);
  // What is not there any more is not pressed.
  const double undo = *page.state().number("undo");
  work(page, 12345);
  CHECK(page.state().number("undo") == undo);
}

TEST_CASE("a slider gets a value by its id: it is set once, in one step, and read out in its unit") {
  Rig page;
  page.openBar();
  page.run("draw-puff", R"({"line": [[60,60],[140,60],[140,140],[60,140],[60,60]]})");
  page.settle();
  const auto slider =
      std::ranges::find_if(page.app->ui().controls, [](const Control& one) { return one.slide.has_value(); });
  REQUIRE(slider != page.app->ui().controls.end());
  const Control before = *slider;
  CHECK(before.slide->low < before.slide->high);
  CHECK(before.slide->value >= before.slide->low);
  const double undo = *page.state().number("undo");
  const double wanted = (before.slide->value + before.slide->high) / 2;
  work(page, before.id, wanted);
  CHECK(page.state().number("undo") == undo + 1);
  const Control after = controlOf(page, before.words, Control::Kind::Slider);
  CHECK(after.slide->value == doctest::Approx(wanted).epsilon(1e-3));
  CHECK(after.slide->text != before.slide->text);
  // No further than the slider goes.
  work(page, before.id, 1e9);
  CHECK(controlOf(page, before.words, Control::Kind::Slider).slide->value == doctest::Approx(before.slide->high));
}

namespace {

/// A puff beside whose controls there is more than the panel has room for.
struct TallPanel : Rig {
  explicit TallPanel(platform::Device device) : Rig(platform::CanvasSize{1440, 560, 1}) {
    openBar();
    run("draw-puff", R"({"line": [[60,60],[140,60],[140,140],[60,140],[60,60]]})");
    move(platform::PointerKind::Leave, 0, 0, device);  // the panel is as large as this one needs it
  }
  Control height() { return controlOf(*this, "Height", Control::Kind::Slider); }
  double undo() { return *state().number("undo"); }
  void move(platform::PointerKind kind, double x, double y, platform::Device device) {
    pointer(kind, x, y, device);
    settle();
  }
};

}  // namespace

TEST_CASE("a slider in a panel that scrolls follows the pointer until it is let go, in one step") {
  using platform::PointerKind;
  for (const platform::Device device : {platform::Device::Mouse, platform::Device::Pen, platform::Device::Touch}) {
    CAPTURE(static_cast<int>(device));
    TallPanel page(device);
    const Control before = page.height();
    const double undo = page.undo(), y = before.at.centre().y;
    const auto x = [&](double share) { return before.at.x + share * before.at.width; };
    page.move(PointerKind::Down, x(0.3), y, device);
    double last = 0;
    for (double share = 0.4; share < 0.85; share += 0.1) {
      page.move(PointerKind::Move, x(share), y + 20 * share, device);
      CHECK(page.height().slide->value > last);
      last = page.height().slide->value;
      CHECK(page.undo() == undo);
    }
    page.move(PointerKind::Up, x(0.8), y + 16, device);
    CHECK(page.undo() == undo + 1);
    CHECK(page.height().slide->value == doctest::Approx(last).epsilon(0.03));
    CHECK(page.height().at == before.at);
    page.run("undo");
    page.settle();
    CHECK(page.height().slide->value == before.slide->value);
  }
}

TEST_CASE("a finger that goes across a slider scrolls the panel and leaves the slider as it was; a tap sets it") {
  using platform::PointerKind;
  TallPanel page(platform::Device::Touch);
  const Control before = page.height();
  const double undo = page.undo(), x = before.at.x + 0.2 * before.at.width, y = before.at.centre().y;
  page.move(PointerKind::Down, x, y, platform::Device::Touch);
  for (int i = 1; i <= 8; ++i) page.move(PointerKind::Move, x + i, y - 10 * i, platform::Device::Touch);
  page.move(PointerKind::Up, x + 8, y - 80, platform::Device::Touch);
  const Control after = page.height();
  CHECK(after.slide->value == before.slide->value);
  CHECK(after.at.y < before.at.y - 40);
  CHECK(page.undo() == undo);
  page.move(PointerKind::Down, x, after.at.centre().y, platform::Device::Touch);
  page.move(PointerKind::Up, x, after.at.centre().y, platform::Device::Touch);
  CHECK(page.height().slide->value < before.slide->value);
  CHECK(page.undo() == undo + 1);
}

TEST_CASE("ids tell controls apart, at every size and with every tool") {
  for (const platform::CanvasSize size : {platform::CanvasSize{1440, 800, 1}, {1024, 700, 1}, {390, 740, 2}}) {
    Rig page(size);
    page.openBar();
    page.drawBar();
    page.run("draw-puff", R"({"line": [[20,60],[50,60],[50,90],[20,90],[20,60]]})");
    for (const char* tool : {"draw", "puff", "ribs", "bone", "move"}) {
      page.run(tool);
      page.settle();
      std::map<std::uint32_t, std::string> known;
      for (const Control& one : page.app->ui().controls) {
        if (one.kind == Control::Kind::Words) continue;
        CAPTURE(size.width);
        CAPTURE(one.words);
        CAPTURE(known[one.id]);
        CHECK(one.id != 0);
        CHECK(known[one.id].empty());
        known[one.id] = one.words;
        if (!one.command.empty()) CHECK(app::findCommand(one.command) != nullptr);
      }
    }
  }
}

TEST_CASE("the shell is told the controls when they are at rest and differ; with the ribs while these are in hand") {
  Rig page;
  page.openBar();
  page.host.sent.clear();
  page.press(100, 40, 100, 160);
  page.app->frame();
  CHECK(told(page).isNull());
  page.lift();
  page.settle();
  CHECK_FALSE(told(page).isNull());
  page.host.sent.clear();
  page.app->frame();
  page.settle();
  CHECK(told(page).isNull());
  page.run("ribs");
  page.settle();
  const Json all = told(page);
  REQUIRE_FALSE(all.isNull());
  std::size_t ends = 0;
  for (const Json& one : *all.find("controls")->array()) {
    if (*one.text("kind") != "rib") continue;
    ++ends;
    CHECK(one.text("words")->starts_with("Rib "));
  }
  const Json state = page.state();
  CHECK(ends == 2 * (*state.find("parts")->array())[0].find("ribs")->array()->size());
}

TEST_CASE(
    "points of a graph have a number each for those who use no pointer: set, taken away and added, one step each") {
  Rig page;
  page.openBar();
  page.drawBar();
  page.run("show-along", R"({"kind":"twist"})");
  page.run("set-along", R"({"kind":"twist","points":[[0,0],[0.4,1],[1,0]]})");
  page.settle();
  const auto points = [&] {
    const Json state = page.state();
    return *(*state.find("parts")->array())[0].find("along")->find("twist")->array();
  };
  const auto number = [](const Json& point, std::size_t i) { return *(*point.array())[i].number(); };
  REQUIRE(points().size() == 3);
  const Control value = controlOf(page, "Twist, point 2 of 3: value", Control::Kind::Slider);
  CHECK(value.slide->value == doctest::Approx(1));
  CHECK(value.slide->text == "1 turns");
  const Control place = controlOf(page, "Twist, point 2 of 3: place", Control::Kind::Slider);
  CHECK(place.slide->text == "40 %");
  const double undo = *page.state().number("undo");
  work(page, value.id, 0.5);
  CHECK(number(points()[1], 1) == doctest::Approx(0.5));
  work(page, place.id, 60);
  CHECK(number(points()[1], 0) == doctest::Approx(0.6));
  // No further than the next point.
  work(page, place.id, 1000);
  CHECK(number(points()[1], 0) < 1);
  work(page, controlOf(page, "Twist: add a point").id);
  CHECK(points().size() == 4);
  work(page, controlOf(page, "Twist, point 1 of 4: take it away").id);
  CHECK(points().size() == 3);
  CHECK(page.state().number("undo") == undo + 5);
  CHECK(page.host.said("Done: Twist and depth"));
}

TEST_CASE("slices along a bone and the points of a drawn slice are moved without a pointer") {
  Rig page;
  page.openBar();
  page.drawBar();
  page.run("add-slice", R"({"at":0.5})");
  page.settle();
  const Control place = controlOf(page, "Slice 2: place", Control::Kind::Slider);
  const double before = place.slide->value;
  work(page, place.id, before - 20);
  CHECK(controlOf(page, "Slice 2: place", Control::Kind::Slider).slide->value == doctest::Approx(before - 20));
  page.run("edit-slice");
  page.run("slice-start-from", R"({"section":"star"})");
  page.run("slice-tool", R"({"tool":"points"})");
  page.settle();
  const auto wanted = [](const Control& one) { return one.words.ends_with(": to the right"); };
  const auto point = std::ranges::find_if(page.app->ui().controls, wanted);
  REQUIRE(point != page.app->ui().controls.end());
  const std::string words = point->words;
  const double to = point->slide->value / 2 + 10;
  work(page, point->id, to);
  CHECK(controlOf(page, words, Control::Kind::Slider).slide->value == doctest::Approx(to).epsilon(1e-3));
}

TEST_CASE("points of an outline and the depth of a bone are moved without a pointer, one step each") {
  Rig page;
  page.openBar();
  page.run("draw-puff", R"({"line": [[60,60],[140,60],[140,140],[60,140],[60,60]]})");
  page.run("puff");
  page.run("next-outline-point");
  page.settle();
  const std::string words = "Point 1 of ";
  const auto wanted = [&](const Control& one) {
    return one.words.starts_with(words) && one.words.ends_with("from the left");
  };
  const auto point = std::ranges::find_if(page.app->ui().controls, wanted);
  REQUIRE(point != page.app->ui().controls.end());
  const Control before = *point;
  double undo = *page.state().number("undo");
  work(page, before.id, before.slide->value - 10);
  CHECK(page.state().number("undo") == undo + 1);
  CHECK(controlOf(page, before.words, Control::Kind::Slider).slide->value == doctest::Approx(before.slide->value - 10));
  page.run("draw");
  page.drawBar();
  page.run("bone");
  page.settle();
  undo = *page.state().number("undo");
  const Control depth = controlOf(page, "Depth of the bone, 1 of 7", Control::Kind::Slider);
  CHECK(depth.slide->value == 0);
  CHECK(depth.slide->text == "0 mm");
  work(page, depth.id, 12.5);
  CHECK(page.state().number("undo") == undo + 1);
  const Control after = controlOf(page, "Depth of the bone, 1 of 7", Control::Kind::Slider);
  // The model is as high as before: what was set is measured anew.
  CHECK(after.slide->value > 6);
  page.run("draw");
  page.settle();
  for (const Control& one : page.app->ui().controls) CHECK_FALSE(one.words.starts_with("Depth of the bone"));
}

TEST_CASE("a point of a graph is held back without a pointer where a drag is: the part does not go through itself") {
  Rig page;
  page.openBar();
  page.drawBar();
  page.run("show-along", R"({"kind":"tilt"})");
  page.run("set-along", R"({"kind":"tilt","points":[[0,0],[0.4,0],[0.5,0],[0.6,0],[1,0]]})");
  page.settle();
  const auto crossing = [&] { return (*page.state().find("parts")->array())[0].find("crossesAt")->array() != nullptr; };
  bool said = false;
  for (int point = 2; point <= 4; ++point) {
    const std::string words = "Lean, point " + std::to_string(point) + " of 5: value";
    const Control value = controlOf(page, words, Control::Kind::Slider);
    work(page, value.id, point % 2 == 0 ? value.slide->high : value.slide->low);
    page.settle();
    CHECK_FALSE(crossing());
    said = said || page.host.said("Any further, and it would go through itself");
  }
  CHECK(said);
}
