// The tool Bone on a puff with a slice: bones left out, drawn, moved, made thicker, and slices at places.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/mesh/laws.h"
#include "tests/support/mesh_laws.h"
#include "tests/unit/web/rig.h"
#include "web/edit/puff_bones.h"

using namespace spineloft;
using test::Rig;

namespace {

constexpr std::string_view kT =
    R"({"contours":[[[60,60],[340,60],[340,120],[230,120],[230,260],[170,260],[170,120],[60,120]]]})";

/// A T on paper as a puff with a round slice, and the tool in hand.
struct Boned : Rig {
  explicit Boned(platform::CanvasSize size = {1200, 700, 1}, std::string_view contours = kT) : Rig(size) {
    CHECK(works("new-sketch", R"({"width": 400, "height": 300})"));
    CHECK(works("draw-puff", contours));
    CHECK(works("puff-slice", R"({"slice":"round"})"));
    CHECK(works("bone"));
  }
  app::Json bones() { return *state().find("parts")->array()->back().find("bones"); }
  double number(std::string_view key) { return *bones().number(key); }
  std::size_t count(std::string_view key) { return bones().find(key)->array()->size(); }
  inflate::InflateParams params() { return document::inflateOf(*shared().parts.back())->inflate; }
  /// Places on the canvas of the handles of one kind.
  std::vector<app::ClientPoint> holds(std::string_view hold) {
    std::vector<app::ClientPoint> out;
    const app::Json now = state();
    for (const app::Json& handle : *now.find("boneHandles")->array()) {
      if (*handle.text("hold") != hold) continue;
      const app::Json::Array& at = *handle.find("at")->array();
      out.push_back({*at[0].number(), *at[1].number()});
    }
    return out;
  }
  app::ClientPoint nearest(std::string_view hold, double x, double y) {
    const auto to = at(x, y);
    const app::ClientPoint p{to.x, to.y};
    const std::vector<app::ClientPoint> all = holds(hold);
    REQUIRE_FALSE(all.empty());
    return *std::ranges::min_element(all, {}, [&](app::ClientPoint q) { return distance(p, q); });
  }
  void drag(app::ClientPoint from, app::ClientPoint to, platform::Device device = {}) {
    pointer(platform::PointerKind::Down, from.x, from.y, device);
    for (int i = 1; i <= 10; ++i) {
      const app::ClientPoint p = lerp(from, to, i / 10.0);
      pointer(platform::PointerKind::Move, p.x, p.y, device);
      settle(3);
    }
    middle = state().find("preview")->isNull() ? 0 : *state().find("preview")->number("triangles");
    pointer(platform::PointerKind::Up, to.x, to.y, device);
    settle();
  }
  app::ClientPoint on(double x, double y) {
    const auto p = at(x, y);
    return {p.x, p.y};
  }
  double middle = 0;  ///< triangles of the preview before the pointer was let go
};

}  // namespace

TEST_CASE("a soft puff has no bones and says so; with a slice it has those of its outline") {
  Rig rig;
  rig.run("new-sketch", R"({"width": 400, "height": 300})");
  rig.run("draw-puff", kT);
  rig.settle();
  rig.run("bone");
  CHECK(rig.host.said("A soft puff has no bones"));
  CHECK(rig.state().find("parts")->array()->back().find("bones")->isNull());
  CHECK(*rig.run("add-bone", R"({"line":[[200,90],[100,90]]})").text("error") == "NotNow");
  rig.run("puff-slice", R"({"slice":"round"})");
  rig.settle();
  const app::Json bones = *rig.state().find("parts")->array()->back().find("bones");
  CHECK(*bones.number("ends") == 3);
  CHECK(*bones.number("forks") == 1);
  CHECK(bones.find("branches")->array()->size() == 3);
}

TEST_CASE("a tap leaves a bone out, a tap where it was takes it back, each one step of undo") {
  for (const platform::Device device : {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen}) {
    Boned rig;
    const double undo = rig.undoSteps();
    const auto tap = [&](app::ClientPoint p) {
      rig.pointer(platform::PointerKind::Down, p.x, p.y, device);
      rig.pointer(platform::PointerKind::Up, p.x, p.y, device);
      rig.settle();
    };
    tap(rig.nearest("bone", 200, 200));
    CHECK(rig.count("branches") == 1);
    CHECK(rig.count("gone") == 1);
    CHECK(rig.undoSteps() == undo + 1);
    tap(rig.nearest("gone", 200, 200));
    CHECK(rig.count("branches") == 3);
    CHECK(rig.count("gone") == 0);
    CHECK(rig.undoSteps() == undo + 2);
    rig.run("undo");
    rig.settle();
    CHECK(rig.count("gone") == 1);
  }
}

TEST_CASE("an end follows the pen with the solid, as one step, and a second drag goes on with the same change") {
  Boned rig;
  const double undo = rig.undoSteps();
  rig.drag(rig.nearest("node", 330, 90), rig.on(290, 80));
  CHECK(rig.middle > 100);
  CHECK(rig.undoSteps() == undo + 1);
  CHECK(rig.params().bones.move.size() == 1);
  const app::ClientPoint end = rig.nearest("node", 290, 80);
  CHECK(distance(end, rig.on(290, 80)) < 20);
  rig.drag(end, end + app::ClientPoint{10, 10});
  CHECK(rig.params().bones.move.size() == 1);
  CHECK(rig.undoSteps() == undo + 2);
  CHECK(rig.number("asleep") == 0);
  // Out of the shape it stays where it last could be.
  rig.drag(rig.nearest("node", 290, 80), rig.on(290, 10));
  CHECK(rig.number("asleep") == 0);
}

TEST_CASE("a line from a bone is a new one, and a tap takes it away again; a line elsewhere is refused") {
  Boned rig({1200, 700, 1}, R"({"contours":[[[60,60],[340,60],[340,240],[60,240]]]})");
  const double ends = rig.number("ends"), undo = rig.undoSteps();
  const app::ClientPoint bone = rig.nearest("bone", 200, 150);
  rig.drag(bone + app::ClientPoint{25, 0}, bone + app::ClientPoint{25, -80});
  CHECK(rig.middle > 100);
  CHECK(rig.number("ends") == ends + 1);
  CHECK(rig.undoSteps() == undo + 1);
  CHECK(rig.params().bones.add.size() == 1);
  const app::ClientPoint drawn = rig.nearest("bone", 215, 90);
  rig.pointer(platform::PointerKind::Down, drawn.x, drawn.y);
  rig.pointer(platform::PointerKind::Up, drawn.x, drawn.y);
  rig.settle();
  CHECK(rig.params().bones.add.empty());
  CHECK(rig.params().bones.drop.empty());
  CHECK(rig.number("ends") == ends);
  rig.host.sent.clear();
  rig.drag(rig.on(10, 10), rig.on(30, 30));
  CHECK(rig.params().bones.add.empty());
  CHECK(rig.host.said("A new bone begins on a bone"));
}

TEST_CASE("a knob that is pulled up makes the puff thicker there; pulled again it is the same knob") {
  Boned rig;
  const auto thickest = [&] {
    const app::Json bones = rig.bones();
    double most = 0;
    for (const app::Json& knob : *bones.find("knobs")->array()) most = std::max(most, *(*knob.array())[2].number());
    return most;
  };
  CHECK(thickest() == 1);
  const app::ClientPoint knob = rig.nearest("knob", 200, 200);
  rig.drag(knob, knob - app::ClientPoint{0, 20});
  CHECK(rig.middle > 100);
  CHECK(thickest() == doctest::Approx(app::pulledFactor(1, 20)).epsilon(0.01));
  REQUIRE(rig.params().bones.heights.size() == 1);
  const app::ClientPoint now = rig.nearest("knob", 200, 200);
  CHECK(now.y < knob.y - 15);
  rig.drag(now, now - app::ClientPoint{0, 10});
  REQUIRE(rig.params().bones.heights.size() == 1);
  CHECK(rig.params().bones.heights[0].factor == doctest::Approx(app::pulledFactor(1, 30)).epsilon(0.02));
  rig.run("reset-bones");
  rig.settle();
  CHECK(thickest() == 1);
}

TEST_CASE("bones by keys: chosen one after the other, moved, made thicker, left out and taken back") {
  Boned rig;
  const double undo = rig.undoSteps();
  CHECK(rig.key("Period", "."));
  CHECK(*rig.state().find("chosen")->number("boneHandle") == 0);
  CHECK(rig.host.said("End or fork 1 of 4"));
  CHECK(rig.key("ArrowLeft", "ArrowLeft"));
  CHECK(rig.key("ArrowLeft", "ArrowLeft"));
  CHECK(rig.params().bones.move.size() == 1);
  CHECK(rig.undoSteps() == undo + 1);
  const auto choose = [&](std::string_view hold) {
    for (int i = 0; i < 40; ++i) {
      rig.key("Period", ".");
      const app::Json now = rig.state();
      const auto at = static_cast<std::size_t>(*now.find("chosen")->number("boneHandle"));
      if (*(*now.find("boneHandles")->array())[at].text("hold") == hold) return true;
    }
    return false;
  };
  REQUIRE(choose("knob"));
  CHECK(rig.key("ArrowUp", "ArrowUp", platform::kShift));
  REQUIRE(rig.params().bones.heights.size() == 1);
  CHECK(rig.params().bones.heights[0].factor == doctest::Approx(1.25));
  REQUIRE(choose("bone"));
  CHECK(rig.key("Delete", "Delete"));
  CHECK(rig.count("gone") == 1);
  CHECK(rig.parts() == 1);  // the bone, not the part
  REQUIRE(choose("gone"));
  CHECK(rig.key("Enter", "Enter"));
  CHECK(rig.count("gone") == 0);
  REQUIRE(choose("node"));
  rig.key("Delete", "Delete");
  CHECK(rig.host.said("An end cannot be taken away"));
}

TEST_CASE("bones are told as sliders and buttons to those who use no pointer, and do what they say") {
  Boned rig;
  const auto control = [&](std::string_view words) {
    const app::Json now = rig.state();
    for (const app::Json& one : *now.find("controls")->array()) {
      if (one.text("words") != nullptr && *one.text("words") == words) return *one.number("id");
    }
    return 0.0;
  };
  const double leave = control("Leave bone 1 out"), thick = control("Thickness at knob 1 of the bones");
  REQUIRE(leave != 0);
  REQUIRE(thick != 0);
  REQUIRE(control("End 1 of the bones: from the left") != 0);
  rig.app->workControl(static_cast<std::uint32_t>(thick), 150.0);
  rig.settle();
  REQUIRE(rig.params().bones.heights.size() == 1);
  CHECK(rig.params().bones.heights[0].factor == doctest::Approx(1.5));
  rig.app->workControl(static_cast<std::uint32_t>(leave), std::nullopt);
  rig.settle();
  CHECK(rig.count("gone") == 1);
  CHECK(control("Take bone 1 back") != 0);
}

TEST_CASE("a second slice stands at its place, is dragged along the bones, and takes another shape") {
  Boned rig;
  const double undo = rig.undoSteps();
  CHECK(rig.works("slice-here", R"({"at":[100,90]})"));
  REQUIRE(rig.params().profile.slices.size() == 2);
  CHECK_FALSE(rig.params().profile.slices[0].at);
  REQUIRE(rig.params().profile.slices[1].at);
  CHECK(rig.params().profile.slices[1].at->x == doctest::Approx(100).epsilon(0.1));
  REQUIRE(rig.holds("slice").size() == 1);
  CHECK(rig.works("puff-slice", R"({"slice":"roof","at":[100,90]})"));
  CHECK(*(*rig.bones().find("slices")->array())[1].text("slice") == "roof");
  CHECK(*(*rig.bones().find("slices")->array())[0].text("slice") == "round");
  const app::ClientPoint hold = rig.holds("slice")[0];
  rig.drag(hold, hold + app::ClientPoint{120, 0});
  CHECK(rig.middle > 100);
  CHECK(rig.params().profile.slices[1].at->x > 130);
  CHECK(rig.undoSteps() == undo + 3);
  // The other slice changes, this one stays.
  CHECK(rig.works("puff-slice", R"({"slice":"block"})"));
  CHECK(*(*rig.bones().find("slices")->array())[0].text("slice") == "block");
  CHECK(rig.params().profile.slices.size() == 2);
  // A slice of other pieces does not pass into it.
  CHECK_FALSE(rig.works("puff-slice", R"({"slice":"ring"})"));
  CHECK(rig.params().profile.slices.size() == 2);
  CHECK(rig.works("puff-slice", R"({"slice":"soft"})"));
  CHECK(rig.params().profile.isSoft());
}

TEST_CASE("on a phone the handles of bones are told apart by a finger") {
  Boned rig({390, 844, 1});
  CHECK(rig.works("focus-picture"));
  const auto tap = [&](app::ClientPoint p) {
    rig.pointer(platform::PointerKind::Down, p.x, p.y, platform::Device::Touch);
    rig.pointer(platform::PointerKind::Up, p.x, p.y, platform::Device::Touch);
    rig.settle();
  };
  for (const char* hold : {"node", "knob"}) {
    CAPTURE(std::string(hold));
    const std::vector<app::ClientPoint> all = rig.holds(hold);
    REQUIRE_FALSE(all.empty());
    for (const app::ClientPoint p : all) {
      tap(p);
      const app::Json now = rig.state();
      const double chosen = *now.find("chosen")->number("boneHandle");
      REQUIRE(chosen >= 0);
      const app::Json::Array& handles = *now.find("boneHandles")->array();
      const app::Json::Array& at = *handles[static_cast<std::size_t>(chosen)].find("at")->array();
      CHECK(*handles[static_cast<std::size_t>(chosen)].text("hold") == hold);
      CHECK(distance(app::ClientPoint{*at[0].number(), *at[1].number()}, p) < 2);
    }
  }
}

TEST_CASE("commands about bones by numbers say what is wrong and change nothing") {
  Boned rig;
  const double undo = rig.undoSteps();
  for (const auto& [id, args, word] : {std::tuple{"drop-bone", R"({"at":[5,5]})", "No bone that can be left out"},
                                       {"add-bone", R"({"line":[[5,5],[9,9]]})", "begins on a bone"},
                                       {"move-bone", R"({"from":[330,90],"to":[330,290]})", "stay in the shape"},
                                       {"bone-height", R"({"at":[5,5],"factor":2})", "No bone is there"},
                                       {"bone-height", R"({"at":[200,200],"factor":9})", ""},
                                       {"restore-bone", R"({"at":[200,200]})", "No bone is left out"},
                                       {"puff-slice", R"({"slice":"roof","at":"here"})", "a place on a bone"}}) {
    CAPTURE(std::string(id));
    const app::Json answer = rig.run(id, args);
    CHECK(answer.flag("ok") == false);
    CHECK(answer.text("sentence") != nullptr);
    if (answer.text("sentence")) CHECK(answer.text("sentence")->find(word) != std::string::npos);
  }
  CHECK(rig.undoSteps() == undo);
}
