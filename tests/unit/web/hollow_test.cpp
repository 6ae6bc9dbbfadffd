// *Scoop out* shows what it would make hollow and where that opens, before it does it.
#include <doctest/doctest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "tests/unit/web/rig.h"
#include "tests/unit/web/shown.h"
#include "tests/unit/web/two_bars.h"
#include "web/commands/commands.h"
#include "web/edit/hollowing.h"

using namespace spineloft;
using app::Json;
using test::Rig;

namespace {

/// A bar, and on it a small puff that was drawn after it and is in hand.
struct BarAndHandle : Rig {
  BarAndHandle() {
    openBar();
    drawBar();
    run("draw-puff", R"({"line": [[40,90],[60,90],[60,110],[40,110],[40,90]]})");
    settle();
    REQUIRE(parts() == 2);
    REQUIRE(state().number("selection") == 2);
  }
  /// What is shown: a part's id; 0: nothing is.
  double shown() {
    const Json all = state();
    const Json* hollow = all.find("hollow");
    if (hollow->isNull()) return 0;
    return hollow->find("what")->array()->front().number("part").value_or(-1);
  }
  std::string opening() { return *state().find("hollow")->text("opening"); }
  std::size_t solids() { return state().find("steps")->array()->size(); }
  /// Nobody solves here, so that a page with a solid would never rest: two frames bring in what was done.
  void draw() {
    app->frame();
    app->frame();
  }
  bool well(const char* id, const char* args = "{}") {
    const bool done = *run(id, args).flag("ok");
    draw();
    return done;
  }
  bool press(std::string_view key) {
    const bool used = app->key({key, key, true, 0});
    draw();
    return used;
  }
};

/// The same without panels, where the functions behind them can be asked.
struct Desk {
  test::FakeHost host;
  app::Studio studio{host, 0};
  app::UiState ui;
  app::CommandEnv env{studio, ui, host};

  Desk() {
    REQUIRE(studio.act(document::AddPicture{"bar", std::make_shared<const image::Picture>(test::barPicture())}).ok());
    ui.picture = studio.document().pictures.back()->id;
    run("draw-spine", R"({"stroke":[[100,40],[100,160]]})");
    do {
      studio.pump();
      studio.derived();
    } while (studio.busy());
  }
  void run(std::string_view id, std::string_view args) { REQUIRE(app::runCommand(env, id, *Json::parse(args)).ok()); }
  std::optional<app::Mouth> mouth(document::OpeningSide side, double depth = 0, PartId part = PartId{1}) {
    document::CombineParts draft = app::hollowOf(env, {part, {}});
    draft.opening = {side, depth};
    return app::mouthOf(studio.document(), studio.derived(), draft);
  }
};

double nearest(const app::Mouth& mouth) {
  double out = std::numeric_limits<double>::infinity();
  for (const auto& segment : mouth.rim) out = std::min(out, distance(segment[0], mouth.at));
  return out;
}

}  // namespace

TEST_CASE(
    "what is scooped out is shown first and changes nothing; a handle that was only just drawn is not the likely one") {
  BarAndHandle page;
  const double undo = *page.state().number("undo");
  CHECK(page.well("hollow-show"));
  CHECK(page.shown() == 1);
  CHECK(page.solids() == 0);
  CHECK(page.state().number("undo") == undo);
  CHECK(page.state().number("selection") == 2);
  // What the visitor chose is the likely one.
  CHECK(page.well("hollow-cancel"));
  CHECK(page.shown() == 0);
  CHECK(page.well("select-part", R"({"id": 2})"));
  CHECK(page.well("hollow-show"));
  CHECK(page.shown() == 2);
  CHECK(page.well("hollow-next"));
  CHECK(page.shown() == 1);
  CHECK(page.well("hollow-next"));
  CHECK(page.shown() == 2);
}

TEST_CASE("Enter makes hollow what is shown, as it is shown, in one step; Escape leaves everything as it was") {
  BarAndHandle page;
  page.well("hollow-show");
  CHECK(page.press("Escape"));
  CHECK(page.shown() == 0);
  CHECK(page.solids() == 0);
  page.well("hollow-show");
  CHECK(page.well("hollow-open", R"({"opening": "left"})"));
  const double undo = *page.state().number("undo");
  CHECK(page.press("Enter"));
  CHECK(page.shown() == 0);
  REQUIRE(page.solids() == 1);
  CHECK(page.state().number("undo") == undo + 1);
  const Json state = page.state();
  const Json& step = state.find("steps")->array()->front();
  CHECK(*step.text("kind") == "hollow");
  CHECK(*step.text("opening") == "left");
  CHECK(step.find("operands")->array()->front().number("part") == 1);
  // What is hollow is not offered again; the other part is.
  page.well("hollow-show");
  CHECK(page.shown() == 2);
  CHECK(page.well("hollow-use"));
  CHECK_FALSE(page.well("hollow-show"));
}

TEST_CASE("a tap on the solid says where it opens, and a tap on another part that this becomes hollow") {
  BarAndHandle page;
  page.well("hollow-show");
  page.run("home-view");
  page.settle();
  REQUIRE(page.opening() != "front");
  // Straight from the front, a tap meets a side that looks there.
  for (int i = 0; i < 40 && *page.state().find("camera")->number("yaw") > 0.05; ++i) page.run("turn-left");
  const app::Rect view = page.app->ui().layout.solid;
  const auto tap = [&](double x, double y) {
    page.click(view.x + view.width * x, view.y + view.height * y);
    return page.shown();
  };
  // The bar is right of the middle, for the handle is left of it.
  double other = 0;
  for (double x = 0.1; x < 0.95 && other != 2; x += 0.02) other = tap(x, 0.5);
  CHECK(other == 2);
  double bar = 0;
  for (double x = 0.95; x > 0.1 && bar != 1; x -= 0.02) bar = tap(x, 0.5);
  REQUIRE(bar == 1);
  // What is beside everything stays unheard.
  CHECK(tap(0.02, 0.02) == 1);
  CHECK(page.solids() == 0);
  CHECK(page.state().number("selection") == 2);
}

TEST_CASE("what is shown goes with its part, and with what takes the part into a solid") {
  BarAndHandle page;
  page.well("hollow-show");
  REQUIRE(page.shown() == 1);
  CHECK(page.well("delete-part", R"({"id": 1})"));
  CHECK(page.shown() == 0);
  CHECK(page.well("undo"));
  page.well("hollow-show", R"({"part": 1})");
  REQUIRE(page.shown() == 1);
  CHECK(page.well("stick-together", R"({"parts": [1, 2]})"));
  CHECK(page.shown() == 0);
  // Of a part in a solid the whole is meant.
  CHECK(page.well("hollow-show", R"({"part": 1})"));
  CHECK(page.state().find("hollow")->find("what")->array()->front().number("step") == 1);
}

TEST_CASE("a part opens at the ends of its line only where it has one") {
  for (const char* part : {"draw-spine", "draw-shape"}) {
    Rig page({1440, 1100, 1});
    page.openBar();
    const bool line = std::string_view(part) == "draw-spine";
    const char* args =
        line ? R"({"stroke": [[100, 40], [100, 160]]})" : R"({"kind": "ball", "axis": [[100, 40], [100, 160]]})";
    REQUIRE(page.run(part, args).flag("ok") == true);
    page.settle();
    REQUIRE(page.run("hollow-show").flag("ok") == true);
    page.settle();
    const std::vector<test::Shown> all = test::inSight(page);
    CHECK(std::ranges::count(all, "Top", &test::Shown::words) == 1);
    CHECK(std::ranges::count(all, "Line's start", &test::Shown::words) == (line ? 1 : 0));
    CHECK(std::ranges::count(all, "Line's end", &test::Shown::words) == (line ? 1 : 0));
  }
}

TEST_CASE("the bar over the solid has what is needed to go on, at every size") {
  for (const platform::CanvasSize size : {platform::CanvasSize{1440, 800, 1}, {1024, 700, 1}, {390, 740, 2}}) {
    Rig page(size);
    page.openBar();
    page.drawBar();
    page.run("hollow-show");
    page.settle();
    std::vector<std::string> words;
    for (const test::Shown& one : test::inSight(page)) words.push_back(one.words);
    CAPTURE(size.width);
    for (const char* word : {"Make it hollow", "Not this", "Tap where it is to open"}) {
      CAPTURE(word);
      CHECK(std::ranges::count(words, word) > 0);
    }
  }
}

TEST_CASE("of a part with two peaks the opening is that of the larger one, not the place between them") {
  Desk desk;
  desk.run("draw-puff",
           R"({"line": [[20,40],[80,40],[80,140],[140,140],[140,40],[180,40],[180,180],[20,180],[20,40]]})");
  desk.studio.derived();
  const auto mouth = desk.mouth(document::OpeningSide::Up, 0.3, PartId{2});
  REQUIRE(mouth);
  double left = std::numeric_limits<double>::infinity(), right = -left, most = 0;
  for (const auto& segment : mouth->rim) {
    left = std::min(left, segment[0].x);
    right = std::max(right, segment[0].x);
    most = std::max(most, std::abs(segment[0].z));
  }
  // The left peak is three eighths of the width, the right one a quarter.
  CHECK(mouth->at.x == doctest::Approx(left + (right - left) * 3 / 16).epsilon(0.02));
  CHECK(nearest(*mouth) < 1.01 * most);
}

TEST_CASE("of a part that has a twin the opening is that of one of both, not the place between them") {
  Desk desk;
  const auto one = desk.mouth(document::OpeningSide::Up, 0.3);
  REQUIRE(one);
  desk.run("set-place", R"({"part": 1, "x": 60})");
  desk.run("symmetry", R"({"part": 1, "axis": "x"})");
  desk.studio.derived();
  const auto both = desk.mouth(document::OpeningSide::Up, 0.3);
  REQUIRE(both);
  CHECK(both->rim.size() == 2 * one->rim.size());
  CHECK(nearest(*both) == doctest::Approx(nearest(*one)).epsilon(0.01));
}

TEST_CASE(
    "the rim is where the surface meets a plane across the opening: closed, as deep as is cut off, and goes along") {
  Desk desk;
  using document::OpeningSide;
  CHECK_FALSE(desk.mouth(OpeningSide::None));
  for (const OpeningSide side : {OpeningSide::Up, OpeningSide::Down, OpeningSide::Start, OpeningSide::Left}) {
    for (const double depth : {0., 0.2, 0.5}) {
      const auto mouth = desk.mouth(side, depth);
      REQUIRE(mouth);
      REQUIRE(mouth->rim.size() >= 8);
      CHECK(norm(mouth->out) == doctest::Approx(1));
      const double level = dot(mouth->rim.front()[0], mouth->out);
      std::vector<WorldPoint> ends;
      for (const auto& segment : mouth->rim) {
        for (const WorldPoint& p : segment) {
          CHECK(dot(p, mouth->out) == doctest::Approx(level).epsilon(1e-9));
          ends.push_back(p);
        }
      }
      // Each end of a segment is one of another segment.
      for (std::size_t i = 0; i < ends.size(); i += 7) {
        const auto near = std::ranges::count_if(ends, [&](const WorldPoint& p) { return distance(p, ends[i]) < 1e-9; });
        CHECK(near % 2 == 0);
      }
      const auto deeper = desk.mouth(side, depth + 0.2);
      CHECK(dot(deeper->at, mouth->out) < dot(mouth->at, mouth->out));
    }
  }
  const auto before = desk.mouth(OpeningSide::Up, 0.3);
  desk.run("set-place", R"({"part": 1, "x": 20, "y": -10, "z": 30})");
  desk.studio.derived();
  const auto after = desk.mouth(OpeningSide::Up, 0.3);
  REQUIRE(after);
  REQUIRE(after->rim.size() == before->rim.size());
  const WorldPoint by = after->at - before->at;
  CHECK(norm(by) > 0.01);
  for (std::size_t i = 0; i < after->rim.size(); ++i) {
    CHECK(distance(after->rim[i][0], before->rim[i][0] + by) < 1e-6);
  }
}

TEST_CASE("the mouth that is shown follows side, depth and place as one that is found anew") {
  Desk desk;
  app::ShownMouth shown;
  document::CombineParts draft = app::hollowOf(desk.env, {PartId{1}, {}});
  const auto isSame = [&] {
    const auto& kept = shown.of(desk.studio.document(), desk.studio.derived(), draft);
    const auto fresh = app::mouthOf(desk.studio.document(), desk.studio.derived(), draft);
    REQUIRE(kept.has_value() == fresh.has_value());
    if (fresh) CHECK(distance(kept->at, fresh->at) == 0);
    if (fresh) CHECK(kept->rim.size() == fresh->rim.size());
  };
  isSame();
  draft.opening.depth = 0.4;
  isSame();
  draft.opening.side = document::OpeningSide::None;
  isSame();
  draft.opening.side = document::OpeningSide::Down;
  isSame();
  desk.run("set-place", R"({"part": 1, "x": 20, "y": -10, "z": 30})");
  isSame();
  desk.run("set-section", R"({"part": 1, "section": "square"})");
  isSame();
}

TEST_CASE("a round end is cut off where the opening is wide, a flat one stays whole, also where it leans") {
  Desk desk;
  const auto depthOf = [&](PartId part, document::OpeningSide side) {
    document::CombineParts draft = app::hollowOf(desk.env, {part, {}});
    draft.opening.side = side;
    return app::usualDepth(desk.env, draft);
  };
  const auto width = [&](PartId part, document::OpeningSide side, double depth) {
    const auto mouth = desk.mouth(side, depth, part);
    double round = 0;
    for (const auto& [a, b] : mouth->rim) round += distance(a, b);
    return round;
  };
  desk.run("draw-shape", R"({"kind":"ball","axis":[[150,80],[150,40]]})");
  desk.run("draw-shape", R"({"kind":"cylinder","axis":[[40,80],[40,40]]})");
  desk.studio.derived();
  for (const document::OpeningSide side : {document::OpeningSide::Up, document::OpeningSide::Front}) {
    const double depth = depthOf(PartId{2}, side);
    CHECK(depth > 0.05);
    CHECK(depth < 0.25);
    CHECK(width(PartId{2}, side, depth) > 0.5 * width(PartId{2}, side, 0.5));
  }
  CHECK(depthOf(PartId{3}, document::OpeningSide::Up) == 0);
  desk.run("set-place", R"({"part": 3, "z": 15})");
  desk.studio.derived();
  CHECK(depthOf(PartId{3}, document::OpeningSide::Up) == 0);
  CHECK(depthOf(PartId{3}, document::OpeningSide::None) == 0);
}

TEST_CASE("where a wall is too thick, the one that fits is a press away") {
  test::TwoBars rig;
  rig.run("scoop-out", R"({"part": 1})");
  rig.settle();
  rig.fail(rig.lastAsked(), Json::Object{{"error", "WallTooThick"}, {"part", 1}, {"thickest", 0.0083}});
  CHECK(rig.settle());
  REQUIRE(*rig.step().number("wall") > 0.0083);
  const auto& controls = rig.app->ui().controls;
  const auto button =
      std::ranges::find_if(controls, [](const app::Control& one) { return one.words.starts_with("Make the wall "); });
  REQUIRE(button != controls.end());
  const std::size_t asked = rig.asked();
  rig.click(button->at.centre().x, button->at.centre().y);
  rig.settle();
  CHECK(rig.step().number("wall") == doctest::Approx(0.0083));
  CHECK(rig.asked() == asked + 1);
}
