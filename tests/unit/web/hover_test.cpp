// What the pointer shows while it rests, views that are remembered, and gestures out of a panel.
#include <doctest/doctest.h>

#include <cmath>

#include "tests/unit/web/rig.h"
#include "web/app/slice_editing.h"

using namespace spineloft;
using platform::Device;
using platform::PointerKind;
using spineloft::test::Rig;

namespace {

struct PartRig : Rig {
  explicit PartRig(platform::CanvasSize size = {1200, 700, 1}) : Rig(size) {
    openBar();
    drawBar();
  }
  bool ok(std::string_view id, std::string_view args = {}) {
    const bool done = run(id, args).flag("ok") == true;
    settle();
    return done;
  }
  /// The mouse comes to rest at a place of the picture.
  void rest(double x, double y) {
    const auto p = at(x, y);
    app->pointer({PointerKind::Move, 1, Device::Mouse, 0, 0, p.x, p.y, 0.5, host.clockMs, 0});
    settle();
  }
};

}  // namespace

TEST_CASE("every picture of the board is seen as it was last looked at, a new one whole") {
  Rig rig;
  rig.openBar();
  const PictureId first = rig.app->ui().picture;
  rig.run("zoom-in");
  rig.run("turn-right");
  rig.settle();
  const app::PictureView looked = rig.app->ui().pictureView;
  CHECK_FALSE(looked.fitted);
  rig.app->addPicture(spineloft::test::barPicture(300, 200), "other.png");
  rig.settle();
  const PictureId second = rig.app->ui().picture;
  CHECK(second != first);
  CHECK(rig.app->ui().pictureView.fitted);
  rig.run("previous-picture");
  rig.settle();
  CHECK(rig.app->ui().picture == first);
  CHECK(rig.app->ui().pictureView == looked);
  rig.run("next-picture");
  rig.settle();
  CHECK(rig.app->ui().pictureView.fitted);
  rig.run("previous-picture");
  rig.run("fit");
  rig.settle();
  CHECK(rig.app->ui().pictureView.fitted);
}

TEST_CASE("a slice on its way out of a panel goes back with Escape, and is no step") {
  PartRig rig;
  const double before = *rig.state().number("undo");
  app::UiState& ui = const_cast<app::UiState&>(rig.app->ui());
  ui.slices.pressed = ui.slices.carried = loft::SectionShape{loft::SectionPreset::Star};
  CHECK(rig.key("Escape", "Escape"));
  CHECK_FALSE(ui.slices.pressed.has_value());
  CHECK_FALSE(ui.slices.carried.has_value());
  const auto p = rig.at(100, 100);
  rig.pointer(PointerKind::Up, p.x, p.y);
  rig.settle();
  CHECK(rig.state().number("undo") == before);
}

TEST_CASE("a pointer at the bone is known as a place along it, and one in a graph as well") {
  PartRig rig;
  rig.rest(100, 100);
  REQUIRE(rig.app->ui().hover.along.has_value());
  CHECK(std::abs(*rig.app->ui().hover.along - 0.5) < 0.05);
  rig.rest(100, 60);
  CHECK(*rig.app->ui().hover.along < 0.3);
  rig.rest(20, 20);
  CHECK_FALSE(rig.app->ui().hover.along.has_value());
  REQUIRE(rig.ok("show-along", R"({"kind":"twist"})"));
  rig.settle();
  const auto& graphs = rig.app->ui().slices.graphs;
  REQUIRE(graphs.size() == 1);
  const app::GraphArea graph = graphs.front();
  rig.app->pointer({PointerKind::Move, 1, Device::Mouse, 0, 0, graph.at.x + 0.25 * graph.at.width,
                    graph.visible.centre().y, 0.5, rig.host.clockMs, 0});
  rig.settle();
  REQUIRE(rig.app->ui().hover.along.has_value());
  CHECK(*rig.app->ui().hover.along == doctest::Approx(0.25));
}

TEST_CASE("the eraser and the scribble show what they would cover, other tools do not") {
  PartRig rig;
  for (const auto& [tool, shows] : {std::pair{"draw", false}, {"ignore-edges", true}, {"hand", false}}) {
    REQUIRE(rig.ok(tool));
    rig.rest(100, 100);
    CHECK(rig.app->ui().hover.brush.has_value() == shows);
  }
}

TEST_CASE("on a phone the picture lies below the bar of the tool, whole") {
  PartRig rig({390, 844, 2});
  for (const char* tool : {"ribs", "bone", "ignore-edges"}) {
    REQUIRE(rig.ok(tool));
    const app::UiState& ui = rig.app->ui();
    CHECK(ui.barRoom.head > 40);
    const auto top = rig.at(0, 0), bottom = rig.at(199, 199);
    CHECK(top.y >= ui.layout.picture.y + ui.barRoom.head);
    CHECK(bottom.y <= ui.layout.picture.bottom() - ui.barRoom.foot);
  }
  REQUIRE(rig.ok("draw"));
  CHECK(rig.app->ui().barRoom.head == 0);
}
