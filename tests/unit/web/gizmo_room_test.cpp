// The handles that place parts: round the parts and not over them, and all of them in sight.
#include <doctest/doctest.h>

#include <algorithm>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"
#include "tests/unit/web/shown.h"
#include "web/edit/gizmo.h"

using namespace spineloft;
using namespace spineloft::app;

namespace {

UiState uiOf(double width, double height, bool touch) {
  UiState ui;
  ui.layout.solid = {300, 40, width, height};
  ui.camera = homeCamera({{-0.4, -0.4, -0.25}, {0.4, 0.4, 0.25}}, ui.layout.solid);
  ui.touch = touch;
  return ui;
}

}  // namespace

TEST_CASE("every handle is in the room that bars leave and can be pressed, wherever the parts are") {
  Rng rng(12);
  for (int round = 0; round < testing::rounds(300); ++round) {
    UiState ui = uiOf(rng.uniform(240, 900), rng.uniform(240, 800), rng.below(2) == 0);
    ui.camera.yaw = rng.uniform(-3, 3);
    ui.camera.pitch = rng.uniform(-1.2, 1.2);
    const Rect& view = ui.layout.solid;
    ui.solidRoom = {view.x, view.y + 50, view.width, view.height - 50};
    const WorldPoint pivot{rng.uniform(-0.6, 0.6), rng.uniform(-0.6, 0.6), rng.uniform(-0.3, 0.3)};
    const double reach = rng.uniform(0, 500);
    const std::optional<Gizmo> gizmo = gizmoAt(ui, pivot, reach);
    REQUIRE(gizmo);
    const double knob = knobRadius(ui);
    for (const Gizmo::Knob& one : gizmo->knobs) {
      CHECK(one.at.x - knob >= ui.solidRoom.x);
      CHECK(one.at.y - knob >= ui.solidRoom.y);
      CHECK(one.at.x + knob <= ui.solidRoom.right());
      CHECK(one.at.y + knob <= ui.solidRoom.bottom());
      CHECK(handleAt(*gizmo, one.at, ui.touch) == one.handle);
    }
    // What they turn about is the parts' own place, wherever the handles are.
    CHECK(distance(gizmo->pivot, pivot) == 0);
    GizmoDrag drag{*gizmo, ui.camera, view, GizmoHandle::TurnZ, gizmo->at + ClientPoint{gizmo->radius, 0}};
    CHECK(distance(motionOf(drag, gizmo->at + ClientPoint{0, gizmo->radius}, false).centre, pivot) == 0);
  }
}

TEST_CASE("the rings go round the parts where there is room, and never become smaller by that") {
  const UiState ui = uiOf(800, 800, false);
  const double least = gizmoAt(ui, {})->radius;
  for (const double reach : {0., 40., 120., 200., 280.}) {
    const double radius = gizmoAt(ui, {}, reach)->radius;
    CHECK(radius >= least);
    CHECK(radius >= reach);
  }
}

TEST_CASE("what is left beside bars meets none of them and is the larger of the sides") {
  Rng rng(5);
  for (int round = 0; round < testing::rounds(300); ++round) {
    const Rect view{rng.uniform(0, 50), rng.uniform(0, 50), rng.uniform(200, 900), rng.uniform(200, 900)};
    std::vector<Rect> bars;
    for (std::size_t i = rng.below(4); i > 0; --i) {
      bars.push_back({rng.uniform(0, 900), rng.uniform(0, 900), rng.uniform(20, 300), rng.uniform(20, 80)});
    }
    const Rect room = roomBeside(view, bars);
    for (const Rect& bar : bars) CHECK_FALSE((room.width > 0 && room.height > 0 && room.inset(1e-6).meets(bar)));
    CHECK(room.x >= view.x);
    CHECK(room.y >= view.y);
    CHECK(room.right() <= view.right() + 1e-9);
    CHECK(room.bottom() <= view.bottom() + 1e-9);
    if (bars.size() == 1) CHECK(room.width * room.height >= 0.25 * view.width * view.height - 300 * 80);
    bars.push_back({0, 0, 2000, 2000});
    CHECK(roomBeside(view, bars) == room);
  }
}

TEST_CASE("on the page no handle lies under a bar, at every size and with parts anywhere") {
  for (const platform::CanvasSize size : {platform::CanvasSize{1440, 800, 1}, {1024, 700, 1}, {390, 740, 2}}) {
    test::Rig page(size);
    page.openBar();
    page.drawBar();
    page.run("move");
    for (const char* place : {R"({"part": 1, "x": 0, "y": 0})", R"({"part": 1, "x": 60, "y": 50})",
                              R"({"part": 1, "x": -70, "y": -60, "z": 20})"}) {
      page.run("set-place", place);
      page.settle();
      page.app->frame();
      CAPTURE(size.width);
      const app::Json state = page.state();
      const app::Json* gizmo = state.find("gizmo");
      REQUIRE_FALSE(gizmo->isNull());
      for (const app::Json& knob : *gizmo->find("knobs")->array()) {
        const auto& at = *knob.find("at")->array();
        const ClientPoint p{*at[0].number(), *at[1].number()};
        CHECK(page.app->ui().layout.solid.contains(p));
        for (const Rect& bar : page.app->ui().overlays) CHECK_FALSE(bar.contains(p));
      }
    }
  }
}
