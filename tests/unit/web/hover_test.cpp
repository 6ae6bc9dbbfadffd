// What the pointer shows while it rests, views that are remembered, and gestures out of a panel.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/support/scarce_memory.h"
#include "tests/unit/web/rig.h"
#include "web/edit/section_editing.h"
#include "web/panels/bar_menu.h"

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
  void tapWith(Device device, app::ClientPoint at) {
    using enum PointerKind;
    pointer(Move, at.x, at.y, device);
    pointer(Down, at.x, at.y, device);
    settle();
    pointer(Up, at.x, at.y, device);
    settle();
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
  ui.sections.pressed = ui.sections.carried = sections::SectionShape{sections::SectionPreset::Star};
  CHECK(rig.key("Escape", "Escape"));
  CHECK_FALSE(ui.sections.pressed.has_value());
  CHECK_FALSE(ui.sections.carried.has_value());
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
  const auto& graphs = rig.app->ui().sections.graphs;
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

TEST_CASE("on a phone no bar lies over the picture, and every bar is one row") {
  for (const platform::CanvasSize size : {platform::CanvasSize{390, 755, 2}, {360, 551, 2}, {320, 480, 2}}) {
    PartRig rig(size);
    const app::Rect canvas{0, 0, size.width, size.height};
    for (const char* tool : {"draw", "puff", "ribs", "shape", "bone", "ignore-edges", "hand"}) {
      REQUIRE(rig.ok(tool));
      rig.tapWith(Device::Touch, {size.width - 2, 2});
      const app::UiState& ui = rig.app->ui();
      const app::Rect shown = app::pictureRect(ui.pictureView, {200, 200}, ui.layout.picture);
      CAPTURE(size.width);
      CAPTURE(tool);
      REQUIRE(ui.pictureView.fitted);
      CHECK(shown.width * shown.height > 0.15 * ui.layout.picture.width * ui.layout.picture.height);
      for (const app::Rect& bar : ui.overlays) {
        CHECK(std::min(bar.width, bar.height) < 60);
        const bool apart =
            bar.x >= shown.right() || bar.right() <= shown.x || bar.y >= shown.bottom() || bar.bottom() <= shown.y;
        CHECK(apart);
        CHECK((canvas.contains({bar.x, bar.y}) && bar.right() <= canvas.width && bar.bottom() <= canvas.height));
      }
    }
    REQUIRE(rig.ok("draw"));
    CHECK(rig.app->ui().barHead == 0);
  }
}

TEST_CASE("what has no room in a bar waits in its menu: in order, the tool in use in sight") {
  constexpr app::CommandId kIds[] = {"bone", "draw", "fit", "hand", "puff", "ribs", "sheet"};
  for (std::size_t room = 1; room < 10; ++room) {
    for (const app::CommandId used : {app::CommandId(), kIds[0], kIds[2], kIds[6]}) {
      const std::size_t had = testing::allocatedBytes();
      const auto split = panels::splitBar(kIds, room, [&](app::CommandId id) { return id == used; });
      CHECK(testing::allocatedBytes() == had);  // bars are split in every frame
      CHECK(split.cells() <= room);
      CHECK(split.rest.empty() == (room >= 7));
      std::vector<app::CommandId> all(split.shown.begin(), split.shown.end());
      all.insert(all.end(), split.rest.begin(), split.rest.end());
      CHECK(std::ranges::is_permutation(all, kIds));
      if (room > 1 && !(used == app::CommandId())) CHECK(std::ranges::count(split.shown, used) == 1);
      // Only what is in use may stand before its turn.
      std::erase(all, used);
      CHECK(std::ranges::is_sorted(all, {}, [](std::string_view id) { return id; }));
    }
  }
}

TEST_CASE("the three dots open a menu: a tap on a word does it and closes, so do a tap elsewhere and Escape") {
  PartRig rig({320, 480, 2});
  const app::UiState& ui = rig.app->ui();
  REQUIRE(rig.ok("draw"));
  rig.tapWith(Device::Touch, {318, 2});
  const app::Rect bar = ui.overlays.front();  // a column: the dots are its last
  const app::ClientPoint dots{bar.centre().x, bar.bottom() - 26};
  const auto open = [&] { return ui.barMenu == app::BarMenu::Picture; };
  const std::size_t before = ui.overlays.size();
  rig.tapWith(Device::Touch, dots);
  REQUIRE(open());
  REQUIRE(ui.overlays.size() == before + 1);
  const app::Rect menu = ui.overlays[1];
  CHECK((menu.x >= 0 && menu.y >= 0 && menu.right() <= 320 && menu.bottom() <= 480));
  CHECK(menu.right() <= bar.x);
  rig.tapWith(Device::Touch, dots);
  CHECK_FALSE(open());
  rig.tapWith(Device::Touch, dots);
  CHECK(rig.key("Escape", "Escape"));
  CHECK_FALSE(open());
  CHECK(ui.tool == app::ToolKind::Draw);
  rig.tapWith(Device::Touch, dots);
  rig.tapWith(Device::Touch, {menu.x / 2, ui.layout.solid.centre().y});
  CHECK_FALSE(open());
  rig.tapWith(Device::Touch, dots);
  const auto hand = std::ranges::find(ui.controls, std::string_view("hand"), &app::Control::command);
  REQUIRE(hand != ui.controls.end());
  CHECK(menu.contains(hand->at.centre()));
  rig.tapWith(Device::Touch, hand->at.centre());
  CHECK_FALSE(open());
  CHECK(ui.tool == app::ToolKind::Hand);
}
