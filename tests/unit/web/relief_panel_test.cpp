// Reliefs on the page: the panel, the command, what is said, and what a worker still looks for.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using app::Control;
using app::Json;
using test::Rig;

namespace {

/// A puff on paper with two strokes on it, in hand, and its panel of reliefs.
struct Reliefs : Rig {
  explicit Reliefs(int threads = 0) : Rig({1200, 900, 1}, threads) {
    CHECK(works("new-sketch", R"({"width": 400, "height": 300})"));
    CHECK(works("draw-puff", R"({"contours": [[[100,60],[300,60],[300,240],[100,240]]]})"));
    CHECK(works("draw-on-sketch", R"({"stroke": [[150,150],[250,150]], "radius": 4})"));
    CHECK(works("draw-on-sketch", R"({"stroke": [[200,100],[200,200]], "radius": 4})"));
    CHECK(works("select-part", R"({"id": 1})"));
    press("Relief", Control::Kind::Section);
  }
  const Control* find(std::string_view words, Control::Kind kind) {
    const auto& controls = app->ui().controls;
    const auto at =
        std::ranges::find_if(controls, [&](const Control& one) { return one.words == words && one.kind == kind; });
    return at == controls.end() ? nullptr : &*at;
  }
  void press(std::string_view words, Control::Kind kind = Control::Kind::Button, std::optional<double> value = {}) {
    const Control* control = find(words, kind);
    REQUIRE_MESSAGE(control != nullptr, words);
    app->workControl(control->id, value);
    settle();
  }
  Json relief(std::size_t part = 0) { return *state().find("parts")->array()->at(part).find("relief"); }
};

}  // namespace

TEST_CASE("the panel gives a part a relief and takes it away, each one step; its sliders show what they will do") {
  Reliefs page;
  const double undo = page.undoSteps();
  CHECK(page.relief().isNull());
  CHECK(page.find("Height of the relief", Control::Kind::Slider) == nullptr);
  page.press("Strokes");
  REQUIRE_FALSE(page.relief().isNull());
  CHECK(*page.relief().text("mode") == "ink");
  CHECK(*page.relief().find("made")->text("mode") == "ink");
  CHECK(page.undoSteps() == undo + 1);
  // To the right is out of the part; ink goes in at first.
  CHECK(page.find("Height of the relief", Control::Kind::Slider)->slide->value == doctest::Approx(-2));
  page.press("Height of the relief", Control::Kind::Slider, -5);
  CHECK(*page.relief().number("height") == doctest::Approx(0.05).epsilon(1e-3));
  CHECK(page.undoSteps() == undo + 2);
  page.press("Smoothness of the relief", Control::Kind::Slider, 80);
  CHECK(*page.relief().number("smooth") == doctest::Approx(0.8).epsilon(1e-3));
  page.press("Bright");
  CHECK(*page.relief().text("mode") == "bright");
  CHECK(page.find("Height of the relief", Control::Kind::Slider)->slide->value == doctest::Approx(5).epsilon(1e-3));
  page.press("None");
  CHECK(page.relief().isNull());
  CHECK(page.undoSteps() == undo + 5);
}

TEST_CASE("a relief is set on all parts in hand, in one step") {
  Reliefs page;
  CHECK(page.works("draw-puff", R"({"contours": [[[20,20],[90,20],[90,90],[20,90]]]})"));
  CHECK(page.works("select-all"));
  const double undo = page.undoSteps();
  page.press("Strokes");
  CHECK(page.undoSteps() == undo + 1);
  for (const std::size_t part : {0, 1}) CHECK(*page.relief(part).text("mode") == "ink");
  page.press("Height of the relief", Control::Kind::Slider, 4);
  for (const std::size_t part : {0, 1}) {
    CHECK(*page.relief(part).number("height") == doctest::Approx(-0.04).epsilon(1e-3));
  }
  // What goes in of one stands out of the other: the hand means the same of both.
  CHECK(page.works("relief", R"({"mode": "bright", "part": 2})"));
  page.press("Height of the relief", Control::Kind::Slider, 3);
  const double first = *page.relief(0).number("height"), second = *page.relief(1).number("height");
  CHECK(std::abs(first) == doctest::Approx(0.03).epsilon(1e-3));
  CHECK(first == -second);
  // Without a word it is that of the part that is meant which is taken away or made.
  CHECK(page.works("relief", R"({"part": 1, "mode": "none"})"));
  CHECK(page.works("relief", R"({"part": 1})"));
  CHECK_FALSE(page.relief(0).isNull());
}

TEST_CASE(
    "light and shadow that a drawing does not show are told, once they were looked for, and its lines are taken") {
  for (const int threads : {0, 2}) {
    CAPTURE(threads);
    Reliefs page(threads);
    page.press("Shade");
    CHECK(*page.relief().text("mode") == "shade");
    CHECK(*page.relief().find("made")->text("mode") == "ink");
    CHECK(page.host.said("no light and shadow here"));
    page.host.sent.clear();
    CHECK(page.works("set-parameter", R"({"key": "height", "value": 0.7})"));
    CHECK(page.relief().find("made")->flag("seen") == true);
    CHECK_FALSE(page.host.said("no light and shadow here"));
  }
}

TEST_CASE(
    "another picture is laid in the middle of a part, and moved by sliders; the part's own is none that is laid") {
  Reliefs page;
  CHECK(page.works("new-sketch", R"({"width": 100, "height": 100})"));
  CHECK(page.works("draw-on-sketch", R"({"stroke": [[20,50],[80,50]], "radius": 5})"));
  CHECK(page.works("select-part", R"({"id": 1})"));
  page.press("Strokes");
  CHECK(page.relief().find("laid")->isNull());
  page.press("Relief from Sketch 2");
  const Json laid = *page.relief().find("laid");
  CHECK(*laid.number("picture") == 2);
  CHECK(*(*laid.find("at")->array())[0].number() == doctest::Approx(200).epsilon(0.02));
  CHECK(*laid.number("width") == doctest::Approx(90).epsilon(0.05));
  page.press("Picture on the part: turn", Control::Kind::Slider, 90);
  CHECK(*page.relief().find("laid")->number("turn") == doctest::Approx(1.5708).epsilon(1e-3));
  page.press("Relief from Sketch 1");
  CHECK(page.relief().find("laid")->isNull());
  CHECK(page.works("relief", R"({"from": 2, "at": [150, 120], "width": 50})"));
  CHECK(*page.relief().find("laid")->number("width") == 50);
  CHECK(page.works("relief", R"({"turn": 1})"));
  CHECK(*page.relief().find("laid")->number("turn") == 1);
  CHECK(page.works("relief", R"({"from": null})"));
  CHECK(page.relief().find("laid")->isNull());
}

TEST_CASE("a picture with nothing on it is told") {
  Reliefs page;
  CHECK(page.works("new-sketch", R"({"width": 100, "height": 100})"));
  CHECK(page.works("select-part", R"({"id": 1})"));
  CHECK(page.works("relief", R"({"mode": "ink", "from": 2})"));
  CHECK_FALSE(*page.relief().find("made")->flag("raises"));
  CHECK(page.host.said("nothing here that could become a relief"));
}

TEST_CASE("what a program says wrong is refused with what is missing, and changes nothing") {
  Reliefs page;
  const double undo = page.undoSteps();
  CHECK_FALSE(page.works("relief", R"({"mode": "deep"})"));
  CHECK_FALSE(page.works("relief", R"({"mode": "ink", "height": 3})"));
  CHECK_FALSE(page.works("relief", R"({"mode": "ink", "region": [[1, 2]]})"));
  CHECK(page.fault("relief", R"({"mode": "ink", "from": 9})") == "NoSuchPicture");
  CHECK(page.undoSteps() == undo);
  CHECK(page.relief().isNull());
  CHECK(page.works("relief", R"({"mode": "ink", "region": [[[120,80],[280,80],[280,220],[120,220]]]})"));
  CHECK(*page.relief().number("region") == 1);
  CHECK(page.works("relief"));  // without a word: off again
  CHECK(page.relief().isNull());
}
