// How many pixels a frame has where a processor draws, and what is drawn before one is needed.
#include <doctest/doctest.h>

#include "tests/unit/web/rig.h"

namespace spineloft::test {
namespace {

using platform::PointerKind;

/// One move of a hand, and its frame.
void moveTo(Rig& rig, double x, double y) {
  rig.host.clockMs += 16;
  rig.pointer(PointerKind::Move, x, y);
  rig.app->frame();
}
/// One that turns the solid.
void turn(Rig& rig, double x) { moveTo(rig, x, 350); }

struct Turned {
  Rig rig;
  explicit Turned(bool slow) {
    rig.host.slow = slow;
    rig.openBar();
    rig.drawBar();
    rig.pointer(PointerKind::Down, 800, 350);
    for (int i = 1; i <= 2; ++i) turn(rig, 800 + 5 * i);
  }
};

TEST_CASE("where a processor draws, frames have fewer pixels while a hand moves, and all while it rests") {
  Turned turned(true);
  Rig& rig = turned.rig;
  CHECK(rig.gl->last.dpr == 2.0 / 3);
  CHECK(rig.host.canvas == platform::CanvasSize{1200, 700, 2.0 / 3});
  CHECK_FALSE(rig.app->idle());
  rig.settle();
  CHECK(rig.gl->last.dpr == 1);  // held, and looked at
  turn(rig, 840);
  CHECK(rig.gl->last.dpr == 2.0 / 3);
  rig.pointer(PointerKind::Up, 840, 350);
  rig.app->frame();
  CHECK(rig.gl->last.dpr == 1);
  CHECK_FALSE(rig.gl->last.still);  // a hand that goes on at once does not wait for smooth edges
  rig.settle();
  CHECK(rig.gl->last.still);
  CHECK(rig.host.canvas == platform::CanvasSize{1200, 700, 1});
  CHECK(rig.app->idle());
}

TEST_CASE("a press that moves nothing shows no coarser frame") {
  Rig rig;
  rig.host.slow = true;
  rig.openBar();
  rig.drawBar();
  rig.pointer(PointerKind::Down, 800, 350);
  rig.app->frame();
  CHECK(rig.gl->last.dpr == 1);
  turn(rig, 802);  // a finger is never quite still
  CHECK(rig.gl->last.dpr == 1);
  rig.pointer(PointerKind::Up, 802, 350);
  rig.app->frame();
  CHECK(rig.gl->last.dpr == 1);
}

TEST_CASE("a frame that a processor still draws is not shown, no other is begun, and the page is not idle") {
  Turned turned(true);
  Rig& rig = turned.rig;
  rig.pointer(PointerKind::Up, 810, 350);
  rig.gl->slow = true;
  const int draws = rig.gl->draws, shown = rig.gl->shown;
  rig.app->frame();
  rig.host.frameAsked = false;
  rig.app->frame();
  CHECK(rig.gl->draws == draws + 1);
  CHECK(rig.gl->shown == shown);
  CHECK(rig.host.canvas.dpr == 2.0 / 3);  // of the frame before: with other pixels it would be blank
  CHECK(rig.host.frameAsked);
  CHECK_FALSE(rig.app->idle());
  rig.gl->slow = false;
  rig.host.frameAsked = false;
  rig.app->frame();  // the canvas gets it, and is taken before another is begun
  CHECK(rig.gl->draws == draws + 1);
  CHECK(rig.gl->shown == shown + 1);
  CHECK(rig.host.frameAsked);
  rig.settle();
  CHECK(rig.gl->shown > shown);
  CHECK(rig.host.canvas.dpr == 1);
  CHECK(rig.app->idle());
}

TEST_CASE("ink does not wait for a frame that is still drawn: its own comes onto the canvas at once") {
  Turned turned(true);
  Rig& rig = turned.rig;
  rig.pointer(PointerKind::Up, 810, 350);
  rig.run("new-part");
  rig.gl->slow = true;
  rig.app->frame();
  const int draws = rig.gl->draws, shown = rig.gl->shown;
  const auto at = rig.at(100, 100);
  rig.pointer(PointerKind::Down, at.x, at.y);
  moveTo(rig, at.x + 20, at.y);
  CHECK(rig.gl->draws == draws + 1);
  CHECK(rig.gl->last.held);
  CHECK(rig.gl->shown == shown + 1);
}

TEST_CASE("where a hand turns the solids or pans the picture, frames are drawn beside the canvas, one at a time") {
  Turned turned(true);
  Rig& rig = turned.rig;
  rig.pointer(PointerKind::Up, 810, 350);
  rig.settle();
  const auto dragged = [&](double x, double y) {
    const auto move = [&](double by) { moveTo(rig, x + by, y); };
    rig.pointer(PointerKind::Down, x, y);
    rig.gl->slow = true;
    const int draws = rig.gl->draws;
    move(10);
    CHECK(rig.gl->draws == draws + 1);
    CHECK(rig.gl->last.hurried);
    CHECK_FALSE(rig.gl->last.held);
    move(20);
    CHECK(rig.gl->draws == draws + 1);
    rig.gl->slow = false;
    const int shown = rig.gl->shown;
    move(30);
    CHECK(rig.gl->shown == shown + 1);
    move(40);
    CHECK(rig.gl->draws == draws + 2);
    rig.pointer(PointerKind::Up, x + 40, y);
    rig.settle();
  };
  dragged(800, 350);
  rig.app->key({"Space", " ", true, 0});
  const auto picture = rig.at(100, 100);
  dragged(picture.x, picture.y);
}

TEST_CASE("before the first picture, frames of every kind are drawn in idle moments, and each once") {
  Rig rig;
  bool held = false, beside = false, still = false;
  for (int round = 0; round < 12; ++round) {
    rig.app->warmUp();
    rig.settle();
    held |= rig.gl->last.held;
    still |= rig.gl->last.still;
    beside |= !rig.gl->last.meshes.empty() && !rig.gl->last.held && !rig.gl->last.still;
  }
  CHECK(held);
  CHECK(beside);
  CHECK(still);
  const int draws = rig.gl->draws;
  rig.app->warmUp();
  CHECK(rig.gl->draws == draws);
  CHECK(rig.app->idle());
}

TEST_CASE("with a picture on the canvas nothing is drawn ahead over it") {
  Rig rig;
  rig.openBar();
  const int draws = rig.gl->draws;
  rig.app->warmUp();
  CHECK(rig.gl->draws == draws);
}

TEST_CASE("the first frame of a hand that changes a part is drawn beside the canvas, and the next waits for it") {
  Rig rig;
  rig.host.slow = true;
  rig.openBar();
  rig.drawBar();
  rig.run("ribs");
  rig.settle();
  const app::Json state = rig.state();
  const app::Json::Array& ribs = *(*state.find("parts")->array())[0].find("ribs")->array();
  const app::Json::Array& end = *ribs[ribs.size() / 2].find("left")->array();
  const auto at = rig.at(*end[0].number(), *end[1].number());
  const auto drag = [&](double by) { moveTo(rig, at.x + by, at.y); };
  rig.pointer(PointerKind::Down, at.x, at.y);
  rig.gl->slow = true;
  int draws = rig.gl->draws;
  drag(8);
  CHECK(rig.gl->draws == draws + 1);
  CHECK(rig.gl->last.hurried);
  CHECK_FALSE(rig.gl->last.held);
  drag(12);
  CHECK(rig.gl->draws == draws + 1);
  CHECK(rig.state().find("preview")->flag("fresh") == true);  // the engine follows the hand meanwhile
  rig.gl->slow = false;
  drag(16);  // it comes onto the canvas
  draws = rig.gl->draws;
  drag(20);
  CHECK(rig.gl->draws == draws + 1);
  CHECK(rig.gl->last.held);
  rig.pointer(PointerKind::Cancel, at.x, at.y);
}

TEST_CASE("under a part that grows while it is drawn the floor grows in a few steps, and fits when the hand rests") {
  Rig rig;
  rig.host.slow = true;
  rig.openBar();
  int steps = 0;
  double radius = 0;
  for (int i = 0; i <= 60; ++i) {
    const auto at = rig.at(100, 40 + 2 * i);
    rig.host.clockMs += 16;
    rig.pointer(i == 0 ? PointerKind::Down : PointerKind::Move, at.x, at.y);
    rig.app->frame();
    steps += rig.gl->last.floor.radius != radius;
    radius = rig.gl->last.floor.radius;
  }
  CHECK(rig.gl->last.hurried);
  CHECK(steps >= 2);
  CHECK(steps <= 8);
  rig.settle();
  const double fitting = rig.gl->last.floor.radius;
  CHECK(radius >= fitting / 1.6);
  CHECK(radius <= fitting * 2.1);
}

TEST_CASE("where a graphics card draws, frames have all their pixels, and the last one does not wait") {
  Turned turned(false);
  Rig& rig = turned.rig;
  CHECK(rig.gl->last.dpr == 1);
  rig.pointer(PointerKind::Up, 840, 350);
  while (std::exchange(rig.host.frameAsked, false)) rig.app->frame();
  CHECK(rig.gl->last.still);
}

}  // namespace
}  // namespace spineloft::test
