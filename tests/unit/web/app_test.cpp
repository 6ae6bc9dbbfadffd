#include <doctest/doctest.h>

#include <algorithm>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"
#include "tests/unit/web/rig.h"

using namespace spineloft;
using platform::Device;
using platform::PointerKind;
using spineloft::test::Rig;

TEST_CASE("a page that nobody touches asks for no frames") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  CHECK(rig.app->idle());
  const auto frames = rig.state().number("frames");
  for (int i = 0; i < 100; ++i) {
    rig.host.clockMs += 1000;
    CHECK_FALSE(rig.host.frameAsked);
  }
  CHECK(rig.state().number("frames") == frames);
}

TEST_CASE("one stroke on the picture becomes a selected part with ribs on both sides of the bar" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    Rig rig({1200, 700, 1}, threads);
    rig.openBar();
    rig.drawBar();
    const app::Json state = rig.state();
    REQUIRE(rig.parts() == 1);
    CHECK(state.number("selection") == 1);
    const app::Json& part = (*state.find("parts")->array())[0];
    CHECK(part.number("triangles") > 100);
    const app::Json::Array& ribs = *part.find("ribs")->array();
    REQUIRE(ribs.size() > 20);
    const app::Json& middle = ribs[ribs.size() / 2];
    CHECK(*(*middle.find("left")->array())[0].number() == doctest::Approx(120.5).epsilon(0.03));
    CHECK(*(*middle.find("right")->array())[0].number() == doctest::Approx(79.5).epsilon(0.03));
    CHECK(rig.gl->last.meshes.size() == 1);
  }
}

TEST_CASE("ribs and solid grow while the pen moves") {
  Rig rig;
  rig.openBar();
  rig.press(100, 40, 100, 90);
  rig.settle();
  const app::Json first = rig.state();
  REQUIRE_FALSE(first.find("preview")->isNull());
  CHECK(first.find("preview")->number("ribs") > 5);
  CHECK(rig.gl->last.meshes.size() == 1);
  CHECK(rig.parts() == 0);
  CHECK(first.number("undo") == 1);
  for (double y = 90; y <= 160; y += 2) {
    const auto p = rig.at(100, y);
    rig.pointer(PointerKind::Move, p.x, p.y);
  }
  rig.settle();
  CHECK(rig.state().find("preview")->number("ribs") > first.find("preview")->number("ribs"));
  const auto end = rig.at(100, 160);
  rig.pointer(PointerKind::Up, end.x, end.y);
  rig.settle();
  CHECK(rig.parts() == 1);
  CHECK(rig.state().number("undo") == 2);
}

TEST_CASE("Escape, undo, the right button, a second finger and the system take the stroke back, and no step") {
  using Way = void (*)(Rig&);
  const Way ways[] = {
      [](Rig& rig) {
        rig.press(100, 40, 100, 120);
        CHECK(rig.key("Escape", "Escape"));
        rig.lift();
      },
      [](Rig& rig) {
        rig.press(100, 40, 100, 120);
        CHECK(rig.key("KeyZ", "z", platform::kControl));
        rig.lift();
      },
      [](Rig& rig) {
        rig.press(100, 40, 100, 120);
        rig.pointer(PointerKind::Down, rig.lastX, rig.lastY, Device::Mouse, 1, 2);
        rig.lift();
      },
      [](Rig& rig) {
        rig.press(100, 40, 100, 120, Device::Touch, 5);
        rig.pointer(PointerKind::Down, 60, 60, Device::Touch, 6);
        CHECK(rig.state().find("preview")->isNull());
        rig.lift(Device::Touch, 5);
        rig.pointer(PointerKind::Up, 60, 60, Device::Touch, 6);
      },
      [](Rig& rig) {
        rig.press(100, 40, 100, 120);
        rig.pointer(PointerKind::Cancel, rig.lastX, rig.lastY);
      },
      [](Rig& rig) {
        rig.press(100, 40, 100, 120);
        rig.run("cancel");
        rig.lift();
      },
  };
  for (const Way way : ways) {
    Rig rig;
    rig.openBar();
    way(rig);
    rig.settle();
    CHECK(rig.parts() == 0);
    CHECK(rig.state().number("undo") == 1);
    CHECK(rig.state().find("preview")->isNull());
    rig.drawBar();
    CHECK(rig.parts() == 1);
  }
}

TEST_CASE("two fingers shift and zoom the picture") {
  Rig rig;
  rig.openBar();
  const auto a = rig.at(80, 100), b = rig.at(120, 100);
  rig.pointer(PointerKind::Down, a.x, a.y, Device::Touch, 5);
  rig.pointer(PointerKind::Down, b.x, b.y, Device::Touch, 6);
  const double spread = b.x - a.x;
  rig.pointer(PointerKind::Move, a.x - spread / 2, a.y, Device::Touch, 5);
  rig.pointer(PointerKind::Move, b.x + spread / 2, b.y, Device::Touch, 6);
  rig.settle();
  const auto a2 = rig.at(80, 100), b2 = rig.at(120, 100);
  CHECK(b2.x - a2.x == doctest::Approx(2 * spread).epsilon(0.01));
  CHECK(a2.x == doctest::Approx(a.x - spread / 2).epsilon(0.01));
  CHECK(rig.parts() == 0);
}

TEST_CASE("a finger that stays on a tool is told its name and does not take it; a tap takes it") {
  Rig rig;
  rig.openBar();
  rig.pointer(PointerKind::Move, 5, 5, Device::Touch, 5);
  rig.settle();
  const auto middle = [&] {
    const app::Json state = rig.state();
    for (const app::Json& control : *state.find("controls")->array()) {
      if (*control.text("words") != "Puff" || *control.text("kind") != "button") continue;
      const auto& at = *control.find("at")->array();
      return Vec2<platform::CanvasSpace>{*at[0].number() + *at[2].number() / 2, *at[1].number() + *at[3].number() / 2};
    }
    FAIL("no such tool");
    return Vec2<platform::CanvasSpace>{};
  };
  const auto touch = [&](double ms) {
    const auto p = middle();
    rig.pointer(PointerKind::Down, p.x, p.y, Device::Touch, 5);
    rig.settle();
    rig.host.clockMs += ms;
    rig.app->wake();
    rig.settle();
    rig.pointer(PointerKind::Up, p.x, p.y, Device::Touch, 5);
    rig.settle();
    return *rig.state().text("tool");
  };
  CHECK(touch(700) == "draw");
  CHECK(touch(0) == "puff");
}

TEST_CASE("once a pen was seen a finger moves the picture instead of drawing") {
  Rig rig;
  rig.openBar();
  rig.drawBar(Device::Pen);
  CHECK(rig.parts() == 1);
  const auto before = rig.at(100, 100);
  rig.press(60, 40, 60, 120, Device::Touch, 9);
  rig.lift(Device::Touch, 9);
  rig.settle();
  CHECK(rig.parts() == 1);
  CHECK(rig.at(100, 100).y != doctest::Approx(before.y));
}

TEST_CASE(
    "a line where the picture shows nothing makes a part, and it is said that its width is a guess; through a thing it "
    "is no news") {
  Rig rig;
  rig.openBar();
  rig.run("draw-spine", R"({"stroke":[[100,40],[100,160]]})");
  rig.settle();
  CHECK_FALSE(rig.host.said("Nothing was found"));
  image::Picture blank = test::barPicture();
  std::ranges::fill(blank.working.pixels, std::uint8_t{250});
  rig.app->addPicture(std::move(blank), "blank.png");
  rig.settle();
  CHECK(rig.run("draw-spine", R"({"stroke":[[60,40],[90,160]]})").flag("ok") == true);
  CHECK(rig.parts() == 2);
  CHECK(rig.host.said(R"("level":"hint","text":"Nothing was found beside your line)"));
}

TEST_CASE("a line on blank paper, also beside a part, makes a part of the usual width: nothing is a guess") {
  Rig rig;
  rig.run("new-sketch");
  rig.settle();
  for (const char* stroke : {R"({"stroke":[[300,200],[300,500]]})", R"({"stroke":[[310,250],[450,300],[310,400]]})"}) {
    REQUIRE(rig.run("draw-spine", stroke).flag("ok") == true);
    rig.settle();
  }
  CHECK(rig.parts() == 2);
  CHECK_FALSE(rig.host.said("ends are guesses"));
  CHECK_FALSE(rig.host.said("Nothing was found"));
}

TEST_CASE("a tap where there is nothing to take is no mistake: nothing is said") {
  Rig rig;
  rig.openBar();
  for (const char* tool : {"draw", "hand", "ribs", "shape", "bone", "ignore-edges", "move"}) {
    rig.run(tool);
    for (const app::Rect& view : {rig.app->ui().layout.picture, rig.app->ui().layout.solid}) {
      const auto at = view.centre();
      for (const Device device : {Device::Mouse, Device::Touch}) {
        rig.pointer(PointerKind::Down, at.x, at.y, device);
        rig.pointer(PointerKind::Up, at.x, at.y, device);
        rig.settle();
      }
    }
  }
  CHECK_FALSE(rig.host.said("not possible"));
}

TEST_CASE("a click on a part in either view selects it, a click beside it selects none") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const auto away = rig.at(20, 100), on = rig.at(105, 100);
  rig.click(away.x, away.y);
  CHECK(rig.state().find("selection")->isNull());
  rig.click(on.x, on.y);
  CHECK(rig.state().number("selection") == 1);
  rig.run("select-part", R"({"id":null})");
  CHECK(rig.state().find("selection")->isNull());
  const app::Rect& solid = rig.app->ui().layout.solid;
  rig.click(solid.centre().x, solid.centre().y);
  CHECK(rig.state().number("selection") == 1);
  rig.click(solid.x + 12, solid.centre().y);
  CHECK(rig.state().find("selection")->isNull());
}

TEST_CASE("dragging in the solid view turns the camera, with shift it shifts, the wheel comes nearer") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const app::Rect solid = rig.app->ui().layout.solid;
  const app::Camera start = rig.app->ui().camera;
  const double x = solid.centre().x, y = solid.centre().y;
  rig.pointer(PointerKind::Down, x, y);
  rig.pointer(PointerKind::Move, x + 60, y + 30);
  rig.pointer(PointerKind::Up, x + 60, y + 30);
  rig.settle();
  const app::Camera turned = rig.app->ui().camera;
  CHECK(turned.yaw < start.yaw);
  CHECK(turned.pitch > start.pitch);
  CHECK(turned.target == start.target);
  rig.app->pointer({PointerKind::Down, 1, Device::Mouse, 0, 1, x, y, 0, 0, platform::kShift});
  rig.app->pointer({PointerKind::Move, 1, Device::Mouse, 0, 1, x + 40, y, 0, 0, platform::kShift});
  rig.app->pointer({PointerKind::Up, 1, Device::Mouse, 0, 0, x + 40, y, 0, 0, platform::kShift});
  CHECK_FALSE(rig.app->ui().camera.target == turned.target);
  rig.app->wheel({x, y, 0, -200, 0});
  CHECK(rig.app->ui().camera.distance < turned.distance);
  rig.run("home-view");
  rig.settle();
  CHECK(rig.app->ui().camera.yaw == doctest::Approx(start.yaw));
  CHECK(rig.parts() == 1);
}

TEST_CASE("a new part that is out of sight comes into view, and the solid stays turned as it was") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const app::UiState& ui = rig.app->ui();
  const auto solid = ui.layout.solid.centre();
  rig.pointer(PointerKind::Down, solid.x, solid.y + 150);
  rig.pointer(PointerKind::Move, solid.x + 90, solid.y + 180);
  rig.pointer(PointerKind::Up, solid.x + 90, solid.y + 180);
  rig.settle();
  const app::Camera turned = ui.camera;
  // Inside what is seen nothing moves.
  rig.run("draw-spine", R"({"stroke":[[95,80],[105,120]]})");
  rig.settle();
  CHECK(ui.camera == turned);
  for (int i = 0; i < 6; ++i) rig.run("zoom-in");
  rig.settle();
  const app::Camera near = ui.camera;
  REQUIRE(near.distance < 0.7 * turned.distance);
  rig.run("draw-spine", R"({"stroke":[[100,30],[100,170]]})");
  rig.settle();
  const app::Camera after = ui.camera;
  CHECK(after.yaw == doctest::Approx(turned.yaw));
  CHECK(after.pitch == doctest::Approx(turned.pitch));
  CHECK(after.distance > 1.3 * near.distance);
  rig.run("fit-view");
  rig.settle();
  CHECK(ui.camera == after);
}

TEST_CASE("a window that gets another size takes the stroke back") {
  Rig rig;
  rig.openBar();
  rig.press(100, 40, 100, 160);
  rig.app->resize({900, 700, 1});
  rig.lift();
  rig.settle();
  CHECK(rig.parts() == 0);
  rig.drawBar();
  CHECK(rig.parts() == 1);
}

TEST_CASE("arrow keys turn the solid, or move the picture while its view is chosen") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("focus-solid");
  const double yaw = rig.app->ui().camera.yaw;
  const auto before = rig.at(100, 100);
  CHECK(rig.key("ArrowRight", "ArrowRight"));
  CHECK(rig.app->ui().camera.yaw < yaw);
  CHECK(rig.at(100, 100).x == before.x);
  rig.run("focus-picture");
  CHECK(rig.key("ArrowRight", "ArrowRight"));
  CHECK(rig.at(100, 100).x == doctest::Approx(before.x + 40));
}

TEST_CASE("the next part is made like the one that was selected last") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("set-section", R"({"section":"heart"})");
  rig.run("draw-spine", R"({"stroke":[[100,60],[100,140]],"section":"gear"})");
  rig.run("select-part", R"({"id":1})");
  rig.run("draw-spine", R"({"stroke":[[100,50],[100,150]]})");
  const app::Json state = rig.state();
  CHECK(*(*state.find("parts")->array())[2].text("section") == "heart");
}

TEST_CASE("moving the mouse over the views draws no frames") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const auto frames = rig.state().number("frames");
  for (int i = 0; i < 50; ++i) rig.pointer(PointerKind::Move, 20 + i, 90 + i);
  rig.settle();
  CHECK(*rig.state().number("frames") <= *frames + 3);
}

TEST_CASE("with the space bar held a drag moves the picture and draws nothing") {
  Rig rig;
  rig.openBar();
  rig.app->key({"Space", " ", true, 0});
  rig.press(100, 40, 120, 60);
  rig.lift();
  rig.app->key({"Space", " ", false, 0});
  rig.settle();
  CHECK(rig.parts() == 0);
  CHECK_FALSE(rig.app->ui().pictureView.fitted);
}

TEST_CASE("a part is redrawn in place while redraw is on") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("set-section", R"({"section":"star"})");
  rig.run("redraw");
  rig.press(100, 60, 100, 140);
  rig.lift();
  rig.settle();
  CHECK(rig.parts() == 1);
  const app::Json state = rig.state();
  CHECK(*(*state.find("parts")->array())[0].text("section") == "star");
  CHECK(state.find("redraw")->isNull());
  CHECK(state.number("undo") == 4);
}

TEST_CASE("a lost context draws nothing, loses nothing and comes back") {
  Rig rig;
  rig.openBar();
  rig.app->contextLost();
  const int draws = rig.gl->draws;
  rig.run("draw-spine", R"({"stroke":[[100,40],[100,160]]})");
  rig.settle();
  CHECK(rig.gl->draws == draws);
  rig.app->contextRestored();
  rig.settle();
  CHECK(rig.gl->draws > draws);
  CHECK(rig.parts() == 1);
}

TEST_CASE("while the graphics are lost an edit is worked out, and saving and exporting give files" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    Rig rig({1200, 700, 1}, threads);
    rig.openBar();
    rig.drawBar();
    REQUIRE(rig.settle());
    rig.app->contextLost();
    rig.run("set-section", R"({"section":"gear"})");
    REQUIRE(rig.settle());
    CHECK(rig.app->idle());
    CHECK(rig.run("save-project").flag("ok") == true);
    REQUIRE(rig.settle());
    REQUIRE(rig.host.files.size() == 1);
    CHECK(rig.host.files[0].first.ends_with(".spineloft"));
    CHECK(rig.app->exportModel("glb").size() > 1000);
  }
}

TEST_CASE("saving works beside the page and hands over one file; until then the work counts as unsaved" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    Rig rig({1200, 700, 1}, threads);
    rig.openBar();
    CHECK(rig.state().flag("unsaved") == false);
    rig.drawBar();
    CHECK(rig.state().flag("unsaved") == true);
    CHECK(rig.run("save-glb").flag("ok") == true);
    REQUIRE(rig.settle());
    REQUIRE(rig.host.files.size() == 1);
    CHECK(rig.host.files[0].first.ends_with(".glb"));
    CHECK(rig.host.files[0].second > 1000);
    CHECK(rig.state().flag("unsaved") == false);
    rig.run("set-section", R"({"section":"gear"})");
    CHECK(rig.state().flag("unsaved") == true);
    rig.run("undo");
    CHECK(rig.state().flag("unsaved") == false);
  }
}

TEST_CASE(
    "only a file that holds the model as it is now makes it saved: not another format, not one of before an edit") {
  struct Save {
    const char* command;
    bool holdsDocument;
  };
  constexpr Save kSaves[] = {
      {"save-project", true}, {"save-glb", true}, {"save-obj", false}, {"save-stl", false}, {"save-3mf", false}};
  for (const int threads : {0, 2}) {
    for (const auto& [command, holdsDocument] : kSaves) {
      for (const bool edited : {false, true}) {
        CAPTURE(threads);
        CAPTURE(command);
        CAPTURE(edited);
        Rig rig({1200, 700, 1}, threads);
        rig.openBar();
        rig.drawBar();
        CHECK(rig.run(command).flag("ok") == true);
        CHECK(rig.host.files.empty());
        if (edited) rig.run("set-section", R"({"section":"gear"})");
        REQUIRE(rig.settle());
        REQUIRE(rig.host.files.size() == 1);
        CHECK(rig.state().flag("unsaved") == (edited || !holdsDocument));
        if (!edited) continue;
        rig.run("undo");
        CHECK(rig.state().flag("unsaved") == !holdsDocument);
      }
    }
  }
}

TEST_CASE("a drawing without a part is work as a part is: only a file of it as it is makes it saved") {
  for (const int threads : {0, 2}) {
    for (const bool edited : {false, true}) {
      CAPTURE(threads);
      CAPTURE(edited);
      Rig rig({1200, 700, 1}, threads);
      const auto draw = [&](double x) {
        rig.press(x, 40, x, 160);
        rig.lift();
      };
      rig.run("new-sketch", R"({"width":200,"height":200})");
      REQUIRE(rig.settle());
      CHECK(rig.state().flag("unsaved") == false);
      draw(60);
      REQUIRE(rig.settle());
      CHECK(rig.parts() == 0);
      CHECK(rig.state().flag("unsaved") == true);
      CHECK(rig.run("save-glb").flag("ok") == false);
      CHECK(rig.run("save-project").flag("ok") == true);
      if (edited) draw(140);
      REQUIRE(rig.settle());
      REQUIRE(rig.host.files.size() == 1);
      CHECK(rig.state().flag("unsaved") == edited);
      rig.run("undo");
      CHECK(rig.state().flag("unsaved") == false);
    }
  }
}

TEST_CASE("the model is written at once for programs, and an unknown format is refused by name") {
  Rig rig;
  rig.openBar();
  CHECK(rig.app->exportModel("glb").empty());
  CHECK(rig.app->lastError().find("NothingToExport") != std::string::npos);
  rig.drawBar();
  const auto glb = rig.app->exportModel("glb");
  REQUIRE(glb.size() > 20);
  CHECK(std::string(glb.begin(), glb.begin() + 4) == "glTF");
  CHECK(rig.app->exportModel("doc").empty());
  CHECK(rig.app->lastError().find("ValueOutOfRange") != std::string::npos);
}

TEST_CASE("pictures without pixels or too small are refused and leave the board as it was") {
  Rig rig;
  const app::Json empty = *app::Json::parse(rig.app->addPicture({}, "x.png"));
  CHECK(*empty.text("error") == "PictureEmpty");
  image::Picture tiny;
  tiny.working = {1, 1, {1, 2, 3, 255}};
  tiny.width = tiny.height = 1;
  const app::Json small = *app::Json::parse(rig.app->addPicture(tiny, "x.png"));
  CHECK(*small.text("error") == "PictureTooSmall");
  CHECK(rig.state().find("picture")->isNull());
  CHECK(rig.state().number("undo") == 0);
}

TEST_CASE("two pictures: each part belongs to the one it was drawn on") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.app->addPicture(test::barPicture(260, 200), "second.png");
  rig.settle();
  CHECK(rig.state().find("picture")->number("width") == 260);
  rig.drawBar();
  CHECK(rig.parts() == 2);
  CHECK(rig.gl->last.meshes.size() == 2);
  rig.run("select-part", R"({"id":1})");
  CHECK(rig.state().find("picture")->number("width") == 200);
  rig.run("remove-picture");
  rig.settle();
  CHECK(rig.parts() == 1);
  CHECK(rig.state().find("picture")->number("width") == 260);
}

TEST_CASE("whatever is clicked, dragged, typed and run, the page keeps its laws") {
  for (const std::uint64_t round : testing::seeds(0, 6)) {
    CAPTURE(round);
    Rng rng(2026 + round);
    const platform::CanvasSize sizes[] = {{1200, 700, 1}, {390, 760, 2}, {820, 600, 1.5}};
    Rig rig(sizes[round % 3]);
    rig.openBar();
    for (int step = 0; step < 160; ++step) {
      const double x = rng.uniform(-20, sizes[round % 3].width + 20);
      const double y = rng.uniform(-20, sizes[round % 3].height + 20);
      const auto device = static_cast<Device>(rng.below(3));
      const int id = static_cast<int>(rng.below(3));
      switch (rng.below(6)) {
        case 0:
          rig.pointer(PointerKind::Down, x, y, device, id, static_cast<int>(rng.below(3)));
          break;
        case 1:
          rig.pointer(PointerKind::Move, x, y, device, id);
          break;
        case 2:
          rig.pointer(static_cast<PointerKind>(2 + rng.below(3)), x, y, device, id);
          break;
        case 3:
          rig.app->wheel({x, y, rng.uniform(-90, 90), rng.uniform(-90, 90), 0});
          break;
        case 4: {
          const auto table = app::commandTable();
          const auto& command = table[rng.below(static_cast<std::uint32_t>(table.size()))];
          if (command.id != "clear") rig.app->run(command.id, "");
          break;
        }
        default:
          rig.run("draw-spine", R"({"stroke":[[100,40],[100,160]]})");
          break;
      }
      if (step % 8 == 0) rig.settle();
    }
    // Nobody solves here: what waits for a solid (a file of parts that go through themselves) is given up.
    rig.app->cancelWork();
    REQUIRE(rig.settle());
    const app::Json state = rig.state();
    const app::Json* selection = state.find("selection");
    bool known = selection->isNull();
    for (const app::Json& part : *state.find("parts")->array()) {
      known = known || part.number("id") == selection->number();
      CHECK(part.number("triangles") > 0);
    }
    CHECK(known);
    rig.run("slice-cancel");
    while (rig.run("undo").flag("ok") == true) continue;
    CHECK(rig.state().number("undo") == 0);
    CHECK(rig.parts() == 0);
  }
}
