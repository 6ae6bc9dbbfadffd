#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tests/unit/web/rig.h"

using namespace spineloft;
using platform::Device;
using platform::PointerKind;
using spineloft::test::Rig;

namespace {

/// The bar as a part, with a tool in hand.
struct Editor : Rig {
  explicit Editor(std::string_view tool) {
    openBar();
    drawBar();
    run("set-parameter", R"({"part":1,"key":"ribs","value":30})");
    CHECK(run(tool).flag("ok") == true);
    settle();
    steps = undo();
  }
  app::Json part() { return (*state().find("parts")->array())[0]; }
  const app::Json::Array ribs() { return *part().find("ribs")->array(); }
  PicturePoint end(std::size_t rib, const char* side) {
    const app::Json::Array ribsNow = ribs();
    const app::Json::Array& p = *ribsNow[rib].find(side)->array();
    return {*p[0].number(), *p[1].number()};
  }
  PicturePoint handle(std::size_t i) {
    const app::Json now = part();
    const app::Json::Array& p = *(*now.find("bone")->array())[i].array();
    return {*p[0].number(), *p[1].number()};
  }
  std::size_t poseStroke() { return part().find("pose")->find("stroke")->array()->size(); }
  double undo() { return *state().number("undo"); }
  void drag(PicturePoint from, PicturePoint to, Device device = {}, int id = 1) {
    press(from.x, from.y, to.x, to.y, device, id);
    settle();
  }
  void drop(Device device = {}, int id = 1) {
    lift(device, id);
    settle();
  }
  void hover(double x, double y) {
    pointer(PointerKind::Move, x, y);
    settle();
  }
  std::string recipe() {
    const app::Json now = part();
    std::string text;
    for (const app::Json& rib : *now.find("ribs")->array()) text += *rib.text("leftState");
    return text + std::to_string(poseStroke()) + std::to_string(undo());
  }
  double steps = 0;
};

double gap(PicturePoint a, PicturePoint b) { return distance(a, b); }

}  // namespace

TEST_CASE("a rib end goes where it is dragged, its neighbours follow softly, in one step of undo") {
  for (const Device device : {Device::Mouse, Device::Touch, Device::Pen}) {
    Editor rig("ribs");
    rig.run("set-parameter", R"({"part":1,"key":"ribs","value":30})");
    const std::size_t rib = rig.ribs().size() / 2;
    const PicturePoint from = rig.end(rib, "left"), beside = rig.end(rib + 1, "left");
    const PicturePoint far = rig.end(2, "left"), across = rig.end(rib, "right");
    const PicturePoint to = from + PicturePoint{12, 0};
    const double steps = rig.undo();
    rig.drag(from, to, device);
    const app::Json during = rig.state();
    CHECK(during.find("preview")->number("part") == 1);
    CHECK(during.find("preview")->flag("fresh") == true);
    CHECK(during.number("undo") == steps);
    rig.drop(device);
    CHECK(gap(rig.end(rib, "left"), to) < 0.5);
    const double followed = rig.end(rib + 1, "left").x - beside.x;
    CHECK(followed > 1);
    CHECK(followed < 12);
    CHECK(gap(rig.end(2, "left"), far) < 1e-6);
    CHECK(gap(rig.end(rib, "right"), across) < 1e-6);
    CHECK(*rig.ribs()[rib].text("leftState") == "edited");
    CHECK(rig.undo() == steps + 1);
    rig.run("undo");
    CHECK(gap(rig.end(rib, "left"), from) < 1e-6);
  }
}

TEST_CASE("every gesture of every tool is taken back without a trace, in every way") {
  using Way = void (*)(Editor&);
  const Way ways[] = {
      [](Editor& rig) { CHECK(rig.key("Escape", "Escape")); },
      [](Editor& rig) { rig.pointer(PointerKind::Down, rig.lastX, rig.lastY, Device::Mouse, 1, 2); },
      [](Editor& rig) {  // as browsers tell of a second button
        rig.app->pointer({PointerKind::Move, 1, Device::Mouse, 2, 3, rig.lastX, rig.lastY, 0, 0, 0});
      },
      [](Editor& rig) { rig.pointer(PointerKind::Cancel, rig.lastX, rig.lastY); },
      [](Editor& rig) { rig.run("cancel"); },
  };
  for (const char* tool : {"ribs", "shape", "bone", "ignore-edges"}) {
    for (const Way way : ways) {
      Editor rig(tool);
      const std::string before = rig.recipe();
      const PicturePoint from = std::string_view(tool) == "bone" ? rig.handle(3) : rig.end(15, "left");
      rig.drag(from, from + PicturePoint{15, 18});
      CAPTURE(tool);
      CHECK_FALSE(rig.state().find("preview")->isNull());
      way(rig);
      rig.lift();
      rig.settle();
      CHECK(rig.recipe() == before);
      CHECK(rig.state().find("preview")->isNull());
      CHECK(rig.state().find("touched")->array()->empty());
    }
    Editor rig(tool);
    const std::string before = rig.recipe();
    const PicturePoint from = std::string_view(tool) == "bone" ? rig.handle(3) : rig.end(15, "left");
    rig.drag(from, from + PicturePoint{15, 18}, Device::Touch, 5);
    rig.pointer(PointerKind::Down, 60, 300, Device::Touch, 6);
    CHECK(rig.state().find("preview")->isNull());
    rig.lift(Device::Touch, 5);
    rig.pointer(PointerKind::Up, 60, 300, Device::Touch, 6);
    rig.settle();
    CHECK(rig.recipe() == before);
  }
}

TEST_CASE("a tapped end is chosen: arrows move it by one pixel, with shift by ten, as one step") {
  Editor rig("ribs");
  const PicturePoint from = rig.end(10, "right");
  const auto at = rig.at(from.x, from.y);
  rig.click(at.x, at.y);
  CHECK(rig.state().find("chosen")->find("end")->number("rib") == 10);
  CHECK(*rig.state().find("chosen")->find("end")->text("side") == "right");
  CHECK(rig.host.said("Rib 11 of"));
  CHECK(rig.host.said("right end"));
  for (int i = 0; i < 4; ++i) CHECK(rig.key("ArrowLeft", "ArrowLeft"));
  CHECK(gap(rig.end(10, "right"), from + PicturePoint{-4, 0}) < 1e-6);
  CHECK(rig.undo() == rig.steps + 1);
  rig.host.clockMs += 5000;
  CHECK(rig.key("ArrowDown", "ArrowDown", platform::kShift));
  CHECK(gap(rig.end(10, "right"), from + PicturePoint{-4, 10}) < 1e-6);
  CHECK(rig.undo() == rig.steps + 2);
  rig.run("undo");
  rig.run("undo");
  CHECK(gap(rig.end(10, "right"), from) < 1e-6);
}

TEST_CASE("with keys alone a rib is chosen, locked, deleted and added again; the part stays") {
  Editor rig("draw");
  CHECK(rig.key("KeyG", "g"));
  CHECK(*rig.state().text("tool") == "ribs");
  const std::size_t count = rig.ribs().size();
  for (int i = 0; i < 6; ++i) CHECK(rig.key("Period", "."));
  CHECK(rig.key("KeyX", "x"));
  CHECK(rig.key("KeyL", "l"));
  CHECK(*rig.ribs()[5].text("leftState") == "locked");
  CHECK(*rig.ribs()[5].text("rightState") == "locked");
  CHECK(rig.key("KeyL", "l"));
  CHECK(*rig.ribs()[5].text("rightState") == "edited");
  CHECK(rig.key("Delete", "Delete"));
  CHECK(rig.parts() == 1);
  CHECK(rig.ribs().size() == count - 1);
  CHECK(rig.key("KeyA", "a"));
  CHECK(rig.ribs().size() == count);
  CHECK(rig.key("Escape", "Escape"));
  CHECK(rig.state().find("chosen")->find("end")->isNull());
  CHECK(rig.key("Delete", "Delete"));
  CHECK(rig.parts() == 0);
}

TEST_CASE("a locked end stays while its neighbours are dragged") {
  Editor rig("ribs");
  rig.run("lock-rib", R"({"part":1,"rib":14})");
  const PicturePoint held = rig.end(14, "left");
  rig.run("move-rib-end", R"({"part":1,"rib":16,"side":"left","to":[150,100],"reach":0.4})");
  CHECK(gap(rig.end(14, "left"), held) < 1e-6);
  CHECK(*rig.ribs()[14].text("leftState") == "locked");
  CHECK(gap(rig.end(16, "left"), {150, 100}) < 1e-6);
}

TEST_CASE("the ends that a line moves are known before the pen goes up, and are those that move") {
  for (const bool both : {false, true}) {
    Editor rig("shape");
    if (both) rig.run("both-sides");
    std::vector<PicturePoint> before[2];
    for (std::size_t i = 0; i < rig.ribs().size(); ++i) {
      before[0].push_back(rig.end(i, "left"));
      before[1].push_back(rig.end(i, "right"));
    }
    rig.drag({140, 70}, {140, 130});
    const app::Json during = rig.state();
    const app::Json::Array& touched = *during.find("touched")->array();
    REQUIRE(touched.size() > 5);
    CHECK(during.find("preview")->flag("fresh") == true);
    std::vector<bool> moves[2] = {std::vector<bool>(before[0].size()), std::vector<bool>(before[0].size())};
    for (const app::Json& end : touched) {
      moves[*end.text("side") == "left" ? 0 : 1][static_cast<std::size_t>(*end.number("rib"))] = true;
    }
    rig.drop();
    for (std::size_t i = 0; i < before[0].size(); ++i) {
      CHECK(moves[0][i] == (gap(rig.end(i, "left"), before[0][i]) > 1e-9));
      CHECK(moves[1][i] == (gap(rig.end(i, "right"), before[1][i]) > 1e-9));
      if (moves[0][i]) CHECK(rig.end(i, "left").x == doctest::Approx(140).epsilon(0.01));
      if (!both) CHECK_FALSE(moves[1][i]);
    }
    CHECK(rig.undo() == rig.steps + 1);
  }
}

TEST_CASE("a bone that keeps its ribs is posed, one that does not is traced again") {
  for (const bool keep : {true, false}) {
    Editor rig("bone");
    rig.run(keep ? "keep-ribs" : "find-edges");
    const PicturePoint grip = rig.handle(3), left = rig.end(15, "left"), right = rig.end(15, "right");
    rig.drag(grip, grip + PicturePoint{9, 0});
    CHECK(rig.state().find("preview")->flag("fresh") == true);
    rig.drop();
    if (keep) CHECK(gap(rig.end(15, "left"), left) + gap(rig.end(15, "right"), right) == 0);
    CHECK(gap(rig.handle(3), grip + PicturePoint{9, 0}) < 2.5);
    CHECK((rig.poseStroke() > 0) == keep);
    CHECK(rig.undo() == rig.steps + 1);
    CHECK(rig.run("reset-pose").flag("ok") == keep);
    CHECK(rig.poseStroke() == 0);
    if (keep) CHECK(gap(rig.handle(3), grip) == 0);
  }
}

TEST_CASE("the line of a bone moves it, its end makes it longer, a stroke elsewhere replaces it") {
  Editor rig("bone");
  rig.run("keep-ribs");
  const PicturePoint between = (rig.handle(2) + rig.handle(3)) / 2;
  const PicturePoint first = rig.handle(0), last = rig.handle(6);
  rig.drag(between, between + PicturePoint{20, 5});
  rig.drop();
  CHECK(gap(rig.handle(0), first + PicturePoint{20, 5}) < 1e-6);
  CHECK(gap(rig.handle(6), last + PicturePoint{20, 5}) < 1e-6);
  const PicturePoint end = rig.handle(6), start = rig.handle(0);
  rig.drag(end, end + PicturePoint{0, 15});
  rig.drop();
  CHECK(rig.handle(6).y == doctest::Approx(end.y + 15).epsilon(0.02));
  CHECK(gap(rig.handle(0), start) < 1e-6);
  rig.drag({20, 180}, {180, 185});
  rig.drop();
  CHECK(gap(rig.handle(0), {20, 180}) < 1.5);
  CHECK(gap(rig.handle(6), {180, 185}) < 1.5);
  CHECK(rig.undo() == rig.steps + 3);
}

TEST_CASE("depth is dragged in the side view and goes back with undo") {
  Editor rig("bone");
  CHECK(rig.run("side-view").flag("ok") == true);
  rig.settle();
  const app::UiState& ui = rig.app->ui();
  CHECK(std::abs(std::sin(ui.camera.yaw)) == doctest::Approx(1));
  // The middle handle of an upright bar stands in the middle of the view.
  const app::ClientPoint middle = ui.layout.solid.centre();
  rig.hover(middle.x, middle.y);
  CHECK(rig.state().find("hover")->number("depth") == 3);
  rig.pointer(PointerKind::Down, middle.x, middle.y);
  for (int i = 1; i <= 10; ++i) rig.pointer(PointerKind::Move, middle.x - 5 * i, middle.y);
  rig.settle();
  CHECK(rig.state().find("preview")->number("part") == 1);
  rig.pointer(PointerKind::Up, middle.x - 50, middle.y);
  rig.settle();
  const app::Json part = rig.part();
  const app::Json::Array& depth = *part.find("pose")->find("depth")->array();
  REQUIRE(depth.size() >= 3);
  double most = 0;
  for (const app::Json& point : depth) most = std::max(most, *(*point.array())[1].number());
  CHECK(most > 2);  // towards the viewer, which is left as seen from the right side
  CHECK(rig.undo() == rig.steps + 1);
  rig.run("undo");
  CHECK(rig.part().find("pose")->find("depth")->array()->empty());
}

TEST_CASE("scribbles count for the part or the picture, and a tap on one removes it") {
  Editor rig("ignore-edges");
  rig.drag({60, 60}, {60, 140});
  rig.drop();
  CHECK(rig.part().number("ignored") == 1);
  CHECK(rig.state().find("picture")->number("ignored") == 0);
  rig.run("ignore-whole-picture");
  rig.drag({160, 60}, {160, 140});
  rig.drop();
  CHECK(rig.state().find("picture")->number("ignored") == 1);
  for (const double x : {160., 60.}) {
    const auto on = rig.at(x, 100);
    rig.hover(on.x, on.y);
    CHECK(*rig.state().find("hover")->number("mark") >= 0);
    rig.click(on.x, on.y);
  }
  CHECK(rig.part().number("ignored") == 0);
  CHECK(rig.state().find("picture")->number("ignored") == 0);
  CHECK(rig.undo() == rig.steps + 4);
}

TEST_CASE("a scribble that paints over is one, until that is turned off") {
  Editor rig("ignore-edges");
  CHECK_FALSE(*rig.state().find("options")->flag("paintOver"));
  rig.run("paint-over");
  CHECK(*rig.state().find("options")->flag("paintOver"));
  rig.drag({60, 60}, {60, 140});
  rig.drop();
  rig.run("paint-over");
  rig.drag({100, 60}, {100, 140});
  rig.drop();
  CHECK(rig.part().number("ignored") == 2);
  CHECK(rig.part().number("paintedOver") == 1);
  rig.run("undo");
  rig.run("undo");
  CHECK(rig.part().number("paintedOver") == 0);
}

TEST_CASE("what lies under the mouse is lit and named, and draws a frame only when it changes") {
  Editor rig("ribs");
  const PicturePoint end = rig.end(12, "left");
  const auto at = rig.at(end.x, end.y);
  rig.hover(at.x + 1, at.y);
  CHECK(rig.state().find("hover")->find("end")->number("rib") == 12);
  CHECK(rig.host.said("Rib 13 of"));
  CHECK(rig.host.said(R"("css":"grab")"));
  const auto frames = rig.state().number("frames");
  for (int i = 0; i < 20; ++i) {
    rig.hover(at.x + 1 + 0.01 * i, at.y);
    CHECK(rig.state().number("frames") == frames);
  }
  const app::Rect solid = rig.app->ui().layout.solid;
  rig.run("draw");
  rig.hover(solid.centre().x, solid.centre().y);
  CHECK(rig.state().find("hover")->number("part") == 1);
  rig.hover(solid.x + 12, solid.centre().y);
  CHECK(rig.state().find("hover")->find("part")->isNull());
}

TEST_CASE("editing by numbers is refused by name and changes nothing") {
  Editor rig("ribs");
  const std::string before = rig.recipe();
  const std::pair<const char*, const char*> bad[][2] = {
      {{"move-rib-end", R"({"part":1,"rib":3,"side":"left"})"}, {"ArgumentMissing", ""}},
      {{"move-rib-end", R"({"part":1,"rib":900,"side":"left","to":[1,2]})"}, {"NoSuchRib", ""}},
      {{"move-rib-end", R"({"part":1,"rib":3,"side":"left","to":[null,2]})"}, {"ValueOutOfRange", ""}},
      {{"move-rib-end", R"({"part":7,"rib":3,"side":"left","to":[1,2]})"}, {"NoSuchPart", ""}},
      {{"shape-ribs", R"({"part":1,"stroke":[[1,1],[2,1]]})"}, {"NoRibThere", ""}},
      {{"ignore", R"({"part":1,"stroke":[[1,1]],"radius":-4})"}, {"ValueOutOfRange", ""}},
      {{"bend-spine", R"({"part":1,"at":2,"to":[1,1]})"}, {"ValueOutOfRange", ""}},
      {{"set-depth", R"({"part":1,"points":[[0.5,1],[0.2,1]]})"}, {"ValueOutOfRange", ""}},
      {{"coil", R"({"part":1,"turns":500})"}, {"ValueOutOfRange", ""}},
      {{"pose-spine", R"({"part":1,"stroke":[[1,1]]})"}, {"ValueOutOfRange", ""}},
  };
  for (const auto& row : bad) {
    CAPTURE(row[0].first);
    CAPTURE(row[0].second);
    const app::Json answer = rig.run(row[0].first, row[0].second);
    CHECK(answer.flag("ok") == false);
    if (answer.flag("ok") == false) CHECK(*answer.text("error") == row[1].first);
    CHECK(rig.recipe() == before);
  }
}

TEST_CASE("a pen's pressure becomes the depth of the bone when that is asked for") {
  Rig rig;
  rig.openBar();
  const auto draw = [&] {
    for (int i = 0; i <= 24; ++i) {
      const auto p = rig.at(100, 40 + 5 * i);
      const auto kind = i == 0 ? PointerKind::Down : PointerKind::Move;
      rig.app->pointer({kind, 3, Device::Pen, 0, 1, p.x, p.y, 0.2 + 0.6 * i / 24, 0, 0});
    }
    const auto p = rig.at(100, 160);
    rig.app->pointer({PointerKind::Up, 3, Device::Pen, 0, 0, p.x, p.y, 0, 0, 0});
    rig.settle();
  };
  CHECK(rig.run("depth-by-pressure").flag("ok") == false);  // no pen was seen yet
  draw();
  CHECK(rig.run("depth-by-pressure").flag("ok") == true);
  rig.run("new-part");
  draw();
  REQUIRE(rig.parts() == 2);
  const app::Json state = rig.state();
  const app::Json::Array& parts = *state.find("parts")->array();
  CHECK(parts[0].find("pose")->find("depth")->array()->empty());
  const app::Json::Array& depth = *parts[1].find("pose")->find("depth")->array();
  REQUIRE(depth.size() >= 8);
  CHECK(*(*depth.front().array())[1].number() < -10);
  CHECK(*(*depth.back().array())[1].number() > 10);
}

TEST_CASE("keys change how far neighbours follow while an end is dragged") {
  Editor rig("ribs");
  const PicturePoint from = rig.end(15, "left"), far = rig.end(20, "left");
  rig.drag(from, from + PicturePoint{20, 0});
  for (int i = 0; i < 6; ++i) CHECK(rig.key("BracketRight", "]"));
  rig.drop();
  CHECK(gap(rig.end(15, "left"), from + PicturePoint{20, 0}) < 0.5);
  CHECK(rig.end(20, "left").x > far.x + 5);
  CHECK(rig.undo() == rig.steps + 1);
}
