// Parts in no step that go through themselves: what the solver is asked when a file or a check is wanted, and what
// becomes of its answers.
#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "tests/unit/web/two_bars.h"

using namespace spineloft;
using app::Json;
using test::TwoBars;

namespace {

constexpr std::size_t kFourTriangles = 84 + 4 * 50;

/// The first bar is coiled so that it goes through itself; the second is as it was.
struct Coiled : TwoBars {
  Coiled() {
    run("coil", R"({"part": 1, "turns": 6, "radius": 12})");
    settle();
  }
  Json part(std::size_t i = 0) { return (*state().find("parts")->array())[i]; }
  bool isMended() { return *part().flag("mended"); }
  bool isMarked() { return part().find("crossesAt")->array() != nullptr; }
  std::size_t stl() { return app->exportModel("stl").size(); }
};

}  // namespace

TEST_CASE("while nobody wants a file the solver is not asked about parts in no step") {
  Coiled rig;
  const std::size_t before = rig.asked();
  for (int i = 0; i < 10; ++i) rig.app->frame();
  CHECK(rig.settle());
  CHECK(rig.asked() == before);
}

TEST_CASE("parts that do not go through themselves are saved and checked at once, without a solver") {
  TwoBars straight;
  const std::size_t size = straight.app->exportModel("stl").size();
  straight.run("save-stl");
  CHECK(straight.settle());
  CHECK(straight.asked() == 0);
  REQUIRE(straight.host.files.size() == 1);
  CHECK(straight.host.files[0].second == size);
  straight.run("check-print");
  CHECK(straight.asked() == 0);
  CHECK_FALSE(straight.state().find("print")->isNull());
}

TEST_CASE(
    "a file waits for the one part that goes through itself, and holds what it was united to; once for each shape") {
  Coiled rig;
  const std::size_t whole = rig.stl(), before = rig.asked();
  rig.run("save-stl");
  REQUIRE(rig.asked() == before + 1);
  CHECK(rig.busy());
  CHECK(rig.host.files.empty());
  const Json request = rig.lastAsked();
  REQUIRE(request.find("nodes")->array()->size() == 1);
  const Json node = request.find("nodes")->array()->front();
  CHECK(*node.text("kind") == "join");
  REQUIRE(node.find("operands")->array()->size() == 1);
  CHECK(node.find("operands")->array()->front().number("part") == 1);
  rig.answer(request, 1, true);
  CHECK(rig.settle());
  CHECK(rig.isMended());
  CHECK_FALSE(rig.isMarked());
  CHECK_FALSE(*rig.part(1).flag("mended"));
  REQUIRE(rig.host.files.size() == 1);
  CHECK(rig.host.files[0].second < whole);
  CHECK(rig.host.files[0].second > kFourTriangles);
  CHECK_FALSE(rig.host.said("goes through itself"));
  // It lies where the part does, whatever is done to the part: it is known.
  rig.run("show-part", R"({"part": 2, "visible": false})");
  CHECK(rig.stl() == kFourTriangles);
  rig.run("select-part", R"({"id": 1})");
  rig.run("set-place", R"({"lean": 30})");
  for (const char* format : {"save-stl", "save-glb"}) rig.run(format);
  CHECK(rig.settle());
  CHECK(rig.host.files.size() == 3);
  CHECK(rig.asked() == before + 1);
  // Nothing of it is shown: the part looks the same as it is, and is edited so.
  CHECK(*rig.part().number("triangles") > 100);
  // Another shape is another question.
  rig.run("coil", R"({"part": 1, "turns": 7, "radius": 12})");
  rig.settle();
  CHECK_FALSE(rig.isMended());
  rig.run("save-stl");
  CHECK(rig.asked() == before + 2);
}

TEST_CASE("a part that cannot be mended is named and marked, and saved all the same; the mark goes with the shape") {
  Coiled rig;
  const std::size_t whole = rig.stl();
  rig.run("rename-part", R"({"part": 1, "name": "Tail"})");
  rig.run("save-stl");
  rig.fail(rig.lastAsked(),
           Json::Object{{"error", "PartCrossesItself"}, {"part", 1}, {"at", Json::Array{100, -60, 3}}});
  CHECK(rig.settle());
  CHECK(rig.host.said("goes through itself"));
  CHECK(rig.host.said("(Tail)"));
  CHECK_FALSE(rig.isMended());
  REQUIRE(rig.isMarked());
  // It was told in the part's own space, where the picture's middle is the world's.
  const Json part = rig.part();
  const Json::Array& at = *part.find("crossesAt")->array();
  CHECK(*at[0].number() == doctest::Approx(0).epsilon(0.01));
  CHECK(*at[1].number() == doctest::Approx(0.2).epsilon(0.02));
  REQUIRE(rig.host.files.size() == 1);
  CHECK(rig.host.files[0].second == whole);
  rig.run("undo");
  rig.run("undo");
  rig.settle();
  CHECK_FALSE(rig.isMarked());
}

TEST_CASE(
    "whoever takes the model out is told which part goes through itself: by the button, the menu or the API; not in "
    "work in progress") {
  Coiled rig;
  rig.run("rename-part", R"({"part": 1, "name": "Tail"})");
  rig.run("check-print");
  rig.fail(rig.lastAsked(),
           Json::Object{{"error", "PartCrossesItself"}, {"part", 1}, {"at", Json::Array{100, -60, 3}}});
  CHECK(rig.settle());
  for (const char* format : {"glb", "obj", "zip", "stl", "3mf", "spineloft"}) {
    rig.host.sent.clear();
    CHECK_FALSE(rig.app->exportModel(format).empty());
    CHECK(rig.host.said("(Tail)") == (std::string_view(format) != "spineloft"));
  }
  for (const char* button : {"save-glb", "save-stl", "save-project"}) {
    rig.host.sent.clear();
    rig.run(button);
    CHECK(rig.settle());
    CHECK(rig.host.said("(Tail)") == (std::string_view(button) != "save-project"));
  }
}

TEST_CASE("a solver that dies keeps no file back, and is asked again for the next one") {
  Coiled rig;
  rig.run("save-stl");
  const std::size_t before = rig.asked();
  rig.lost();
  CHECK(rig.settle());
  CHECK(rig.asked() == before);
  CHECK(rig.host.files.size() == 1);
  CHECK(rig.host.said("goes through itself"));
  rig.run("save-stl");
  REQUIRE(rig.asked() == before + 1);
  rig.answer(rig.lastAsked(), 1, true);
  CHECK(rig.settle());
  CHECK(rig.isMended());
  CHECK(rig.host.files.size() == 2);
}

TEST_CASE("who cancels gets no file, no mark and no further question") {
  Coiled rig;
  rig.run("save-stl");
  const std::size_t before = rig.asked();
  rig.app->cancelWork();
  CHECK(rig.settle());
  CHECK(rig.host.files.empty());
  CHECK_FALSE(rig.isMarked());
  CHECK(rig.asked() == before);
}

TEST_CASE("work in progress is kept at once") {
  Coiled rig;
  const std::size_t before = rig.asked();
  rig.run("save-project");
  CHECK(rig.settle());
  CHECK(rig.host.files.size() == 1);
  CHECK(rig.asked() == before);
}

TEST_CASE("the check for printing waits for parts that go through themselves, and tells which it still does") {
  Coiled rig;
  CHECK(*rig.run("check-print").flag("ok"));
  CHECK(rig.state().find("print")->isNull());
  CHECK(*rig.run("thicken").text("error") == "NotReady");
  rig.fail(rig.lastAsked(),
           Json::Object{{"error", "PartCrossesItself"}, {"part", 1}, {"at", Json::Array{100, -60, 3}}});
  CHECK(rig.settle());
  const Json state = rig.state();
  REQUIRE_FALSE(state.find("print")->isNull());
  bool isTold = false;
  for (const Json& line : *state.find("print")->find("lines")->array()) {
    isTold = isTold || line.text("text")->find("goes through itself") != std::string::npos;
  }
  CHECK(isTold);
}

TEST_CASE(
    "a check for printing that is asked for while a part is still searched for is of what it becomes, and of what "
    "mends it") {
  TwoBars rig;
  const auto isChecked = [&] { return !rig.state().find("print")->isNull(); };
  rig.run("coil", R"({"part": 1, "turns": 6, "radius": 12})");
  CHECK(*rig.run("check-print").flag("ok"));
  CHECK_FALSE(isChecked());
  rig.settle();
  CHECK_FALSE(isChecked());
  rig.answer(rig.lastAsked(), 1, true);
  CHECK(rig.settle());
  CHECK(isChecked());
  CHECK_FALSE(rig.host.said("goes through itself"));
}

TEST_CASE("the check for printing is of what was mended, once it is") {
  Coiled mended;
  mended.run("check-print");
  mended.answer(mended.lastAsked(), 1, true);
  CHECK(mended.settle());
  REQUIRE_FALSE(mended.state().find("print")->isNull());
  CHECK_FALSE(mended.host.said("goes through itself"));
}

TEST_CASE("solids of steps and parts in none are asked for together, and a file waits for both") {
  Coiled rig;
  rig.run("draw-spine", R"({"stroke": [[150, 50], [152, 100], [150, 150]]})");
  rig.settle();
  rig.stick(R"({"parts": [2, 3]})");
  rig.run("save-stl");
  const Json request = rig.lastAsked();
  CHECK(request.find("wanted")->array()->size() == 2);
  rig.answer(request);
  CHECK(rig.host.files.empty());
  const Json rest = rig.lastAsked();
  REQUIRE(rest.find("wanted")->array()->size() == 1);
  rig.answer(rest, 1, true);
  CHECK(rig.settle());
  CHECK(rig.isMended());
  CHECK(rig.host.files.size() == 1);
}

TEST_CASE("a coil that is wound until it would go through itself stops before, and says so") {
  test::Rig rig;
  image::Picture thin = test::barPicture();
  for (std::size_t i = 0; i < thin.working.pixels.size(); i += 4) {
    const std::size_t x = i / 4 % 200;
    if (x < 97 || x >= 104) std::fill_n(&thin.working.pixels[i], 3, std::uint8_t{250});
  }
  rig.app->addPicture(std::move(thin), "thin.png");
  rig.settle();
  rig.drawBar();
  rig.run("coil", R"({"part": 1, "turns": 1, "radius": 20})");
  rig.run("bone");
  rig.settle();
  const auto find = [&](std::string_view words) -> std::optional<app::Rect> {
    for (const app::Control& control : rig.app->ui().controls) {
      if (control.words == words) return control.at;
    }
    return std::nullopt;
  };
  const std::optional<app::Rect> slider = find("Turns");
  REQUIRE(slider);
  const double y = slider->centre().y;
  const auto x = [&](double turns) { return slider->x + slider->width * (turns + 8) / 16; };
  rig.pointer(platform::PointerKind::Down, x(1), y);
  rig.settle();
  bool said = false;
  for (double turns = 1; turns <= 7.9; turns += 0.2) {
    rig.pointer(platform::PointerKind::Move, x(turns), y);
    rig.settle();
    said = said || find("Any further, and it would go through itself").has_value();
  }
  CHECK(said);
  rig.pointer(platform::PointerKind::Up, x(7.9), y);
  rig.settle();
  const Json part = (*rig.state().find("parts")->array())[0];
  const double turns = *part.find("pose")->number("turns");
  CHECK(turns > 1.2);
  CHECK(turns < 6);
  CHECK(part.find("crossesAt")->array() == nullptr);
}
