#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/unit/web/rig.h"
#include "web/commands/section_json.h"
#include "web/edit/section_editing.h"

using namespace spineloft;
using platform::Device;
using platform::PointerKind;
using spineloft::test::Rig;

namespace {

bool overlap(const app::Rect& a, const app::Rect& b) {
  return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// A page with one part, selected.
struct PartRig : Rig {
  explicit PartRig(platform::CanvasSize size = {1200, 700, 1}) : Rig(size) {
    openBar();
    drawBar();
  }
  app::Json part() { return (*state().find("parts")->array())[0]; }
  app::Json::Array sections() { return *part().find("slices")->array(); }
  bool ok(std::string_view id, std::string_view args = {}) {
    const bool done = run(id, args).flag("ok") == true;
    settle();
    return done;
  }
  app::Json board() { return *state().find("sliceBoard"); }
  std::size_t curves() { return board().find("curves")->array()->size(); }
  /// A place of the board's square on the canvas.
  app::ClientPoint onBoard(double x, double y) { return app::toCanvas(*app->ui().sections.board, {x, y}); }
  void drawRing(double radius, Device device = {}) {
    for (int i = 0; i <= 40; ++i) {
      const double angle = 6.2 * i / 40;
      const app::ClientPoint p = onBoard(radius * std::cos(angle), radius * std::sin(angle));
      pointer(i == 0 ? PointerKind::Down : PointerKind::Move, p.x, p.y, device);
      lastX = p.x;
      lastY = p.y;
    }
    lift(device);
    settle();
  }
};

}  // namespace

TEST_CASE("the board for a slice has its place to itself: no buttons of the tool in use lie on it") {
  for (const platform::CanvasSize size : {platform::CanvasSize{1200, 700, 1}, platform::CanvasSize{390, 700, 1}}) {
    PartRig rig(size);
    for (const char* tool : {"ribs", "shape", "bone", "ignore-edges", "puff", "sheet", "draw"}) {
      CAPTURE(tool);
      REQUIRE(rig.ok(tool));
      REQUIRE(rig.ok("edit-slice"));
      const app::UiState& ui = rig.app->ui();
      const auto onBoard =
          std::ranges::count_if(ui.overlays, [&](const app::Rect& card) { return overlap(card, ui.layout.picture); });
      CHECK(onBoard == 1);
      REQUIRE(rig.ok("slice-cancel"));
    }
  }
}

TEST_CASE("a slice drawn on the board is one step of the document, with its hole") {
  for (const Device device : {Device::Mouse, Device::Touch, Device::Pen}) {
    PartRig rig;
    REQUIRE(rig.ok("edit-slice"));
    const double before = *rig.state().number("undo");
    rig.drawRing(0.8, device);
    CHECK(rig.curves() == 1);
    rig.drawRing(0.4, device);
    CHECK(rig.curves() == 2);
    CHECK(rig.state().number("undo") == before);  // the document waits
    REQUIRE(rig.key("Enter", "Enter"));
    CHECK(rig.board().isNull());
    CHECK(rig.state().number("undo") == before + 1);
    CHECK(*rig.sections()[0].text("section") == "drawn");
    CHECK(rig.sections()[0].number("curves") == 1);
    CHECK(rig.sections()[0].number("holes") == 1);
    CHECK(rig.state().find("shelf")->array()->size() == 1);
    CHECK(rig.host.said("\"type\":\"shelf\""));
    CHECK(rig.ok("undo"));
    CHECK(*rig.sections()[0].text("section") == "circle");
  }
}

TEST_CASE("another tool uses the slice on the board, in one step; what is no slice is left, and can be traced") {
  PartRig rig;
  const double before = *rig.state().number("undo");
  REQUIRE(rig.ok("edit-slice"));
  rig.drawRing(0.8);
  REQUIRE(rig.ok("puff"));
  rig.settle();
  CHECK(rig.board().isNull());
  CHECK(rig.state().number("undo") == before + 1);
  CHECK(*rig.sections()[0].text("section") == "drawn");
  CHECK(*rig.state().text("tool") == "puff");
  REQUIRE(rig.ok("draw"));
  REQUIRE(rig.ok("edit-slice"));
  REQUIRE(rig.ok("slice-draw", R"({"corners":[[-0.5,-0.5],[0.5,0.5],[0.5,-0.5],[-0.5,0.5]]})"));
  const std::size_t traces = rig.app->ui().sections.traces.size();
  REQUIRE(rig.ok("select-part", R"({"id":null})"));
  rig.settle();
  CHECK(rig.board().isNull());
  CHECK(rig.state().find("selection")->isNull());
  CHECK(rig.state().number("undo") == before + 1);
  CHECK(rig.app->ui().sections.traces.size() > traces);
}

TEST_CASE("leaving the board changes nothing; its own undo goes back stroke by stroke") {
  PartRig rig;
  const app::Json before = rig.part();
  REQUIRE(rig.ok("edit-slice"));
  rig.drawRing(0.8);
  rig.drawRing(0.3);
  CHECK(rig.key("KeyZ", "z", platform::kControl));
  CHECK(rig.curves() == 1);
  CHECK(rig.key("KeyZ", "Z", platform::kControl | platform::kShift));
  CHECK(rig.curves() == 2);
  CHECK(rig.key("Escape", "Escape"));
  CHECK(rig.board().isNull());
  CHECK(*rig.part().find("slices") == *before.find("slices"));
  CHECK(rig.part().number("triangles") == before.number("triangles"));
}

TEST_CASE("a second finger takes a line on the board back, and Escape does") {
  PartRig rig({390, 760, 2});
  REQUIRE(rig.ok("edit-slice"));
  const app::ClientPoint a = rig.onBoard(-0.5, 0), b = rig.onBoard(0.5, 0.4);
  rig.pointer(PointerKind::Down, a.x, a.y, Device::Touch, 1);
  rig.pointer(PointerKind::Move, b.x, b.y, Device::Touch, 1);
  rig.pointer(PointerKind::Down, b.x, a.y, Device::Touch, 2);
  rig.pointer(PointerKind::Up, b.x, a.y, Device::Touch, 2);
  rig.pointer(PointerKind::Up, b.x, b.y, Device::Touch, 1);
  rig.settle();
  CHECK(rig.curves() == 0);
  rig.pointer(PointerKind::Down, a.x, a.y);
  rig.pointer(PointerKind::Move, b.x, b.y);
  CHECK(rig.key("Escape", "Escape"));
  rig.pointer(PointerKind::Up, b.x, b.y);
  rig.settle();
  CHECK_FALSE(rig.board().isNull());
  CHECK(rig.curves() == 0);
}

TEST_CASE("a curve that crosses itself stays on the board with a sentence") {
  PartRig rig;
  REQUIRE(rig.ok("edit-slice"));
  REQUIRE(rig.ok("slice-draw", R"({"corners":[[-0.5,-0.5],[0.5,0.5],[0.5,-0.5],[-0.5,0.5]]})"));
  CHECK(rig.curves() == 1);
  CHECK(rig.board().text("problem") != nullptr);
  const app::Json answer = rig.run("slice-done");
  CHECK(*answer.text("error") == "SectionInvalid");
  CHECK(answer.text("sentence")->find("crosses itself") != std::string::npos);
  CHECK(rig.curves() == 1);
}

TEST_CASE("a point dragged with the mouse moves, and its mirror image with it") {
  PartRig rig;
  REQUIRE(rig.ok("edit-slice"));
  REQUIRE(rig.ok("slice-symmetry", R"({"leftRight":true})"));
  REQUIRE(rig.ok("slice-start-from", R"({"section":"square"})"));
  const app::ClientPoint a = rig.onBoard(1, 1), b = rig.onBoard(0.6, 0.9);
  rig.pointer(PointerKind::Down, a.x, a.y);
  rig.pointer(PointerKind::Move, (a.x + b.x) / 2, (a.y + b.y) / 2);
  rig.pointer(PointerKind::Move, b.x, b.y);
  rig.pointer(PointerKind::Up, b.x, b.y);
  rig.settle();
  int moved = 0;
  const app::Json board = rig.board();
  for (const app::Json& p : *(*board.find("curves")->array())[0].array()) {
    const double x = *(*p.array())[0].number(), y = *(*p.array())[1].number();
    if (std::abs(y - 0.9) < 0.02 && std::abs(std::abs(x) - 0.6) < 0.02) ++moved;
  }
  CHECK(moved == 2);
}

TEST_CASE("slices are added, slid along the bone by their handle, and pulled off") {
  PartRig rig;
  REQUIRE(rig.ok("add-slice", R"({"at":1,"section":"star"})"));
  REQUIRE(rig.sections().size() == 2);
  CHECK(rig.sections()[0].number("at") == 0);
  CHECK(*rig.sections()[1].text("section") == "star");
  REQUIRE(rig.ok("add-slice", R"({"at":0.5,"section":"square"})"));
  REQUIRE(rig.sections().size() == 3);
  rig.press(100, 100, 100, 75);  // the handle in the middle of the spine, a fifth towards its start
  rig.lift();
  rig.settle();
  CHECK(*rig.sections()[1].number("at") == doctest::Approx(0.29).epsilon(0.12));
  const double at = *rig.sections()[1].number("at");
  rig.press(100, 40 + 120 * at, 180, 40 + 120 * at);
  rig.lift();
  rig.settle();
  CHECK(rig.sections().size() == 2);
  CHECK(rig.parts() == 1);  // none of it drew a part
  REQUIRE(rig.ok("set-blend", R"({"slice":0,"blend":"overshoot"})"));
  CHECK(*rig.sections()[0].text("blend") == "overshoot");
  CHECK(*rig.run("set-blend", R"({"slice":7,"blend":"ease"})").text("error") == "ValueOutOfRange");
}

TEST_CASE("sections are moved and removed by number, and undo brings one back") {
  PartRig rig;
  REQUIRE(rig.ok("add-slice", R"({"at":1,"section":"star"})"));
  REQUIRE(rig.ok("add-slice", R"({"at":0.5,"section":"square"})"));
  REQUIRE(rig.ok("move-slice", R"({"slice":1,"to":0.3})"));
  REQUIRE(rig.sections().size() == 3);
  CHECK(*rig.sections()[1].number("at") == doctest::Approx(0.3));
  CHECK(*rig.sections()[1].text("section") == "square");
  REQUIRE(rig.ok("remove-slice", R"({"slice":1})"));
  REQUIRE(rig.sections().size() == 2);
  CHECK(*rig.sections()[1].text("section") == "star");
  REQUIRE(rig.ok("undo"));
  CHECK(rig.sections().size() == 3);
}

TEST_CASE("a tap puts a slice on the bone while one waits for its place") {
  PartRig rig;
  REQUIRE(rig.ok("add-slice"));
  CHECK(rig.state().flag("placing") == true);
  const auto p = rig.at(100, 60);
  rig.click(p.x, p.y);
  CHECK(rig.sections().size() == 3);
  CHECK(rig.state().flag("placing") == false);
}

TEST_CASE("curves along the bone are set in the units that people see, and refused beyond them") {
  PartRig rig;
  REQUIRE(rig.ok("set-along", R"({"kind":"twist","points":[[0,0],[1,1.5]]})"));
  const app::Json twist = *rig.part().find("along")->find("twist");
  CHECK(*(*(*twist.array())[1].array())[1].number() == doctest::Approx(1.5));
  CHECK(*rig.run("set-along", R"({"kind":"squash","points":[[0,-3]]})").text("error") == "ValueOutOfRange");
  CHECK(*rig.run("set-along", R"({"kind":"taste","points":[]})").text("error") == "ArgumentMissing");
  for (const app::AlongShape& shape : app::alongShapes()) {
    const std::string name = std::string(app::alongInfo(shape.kind).key) + "/" + std::string(shape.key);
    CAPTURE(name);
    CHECK(rig.ok("along-shape", R"({"shape":")" + name + R"("})"));
  }
  CHECK(rig.ok("along-shape", R"({"shape":"twist/none"})"));
  CHECK(rig.part().find("along")->find("twist")->array()->empty());
}

TEST_CASE("a point of the graph in the panel is added by a press and dragged") {
  PartRig rig;
  REQUIRE(rig.ok("show-along", R"({"kind":"squash"})"));
  REQUIRE(rig.app->ui().sections.graphs.size() == 1);
  const app::Rect at = rig.app->ui().sections.graphs[0].at;
  const double x = at.x + at.width / 2;
  rig.pointer(PointerKind::Down, x, at.y + at.height / 2);
  rig.pointer(PointerKind::Move, x, at.y + at.height * 0.8);
  rig.pointer(PointerKind::Up, x, at.y + at.height * 0.8);
  rig.settle();
  const app::Json squash = *rig.part().find("along")->find("squash");
  REQUIRE(squash.array()->size() == 3);
  CHECK(*(*(*squash.array())[1].array())[1].number() < 0.6);
  rig.pointer(PointerKind::Down, x, at.y + at.height * 0.8);
  rig.pointer(PointerKind::Move, x, at.y + at.height * 0.2);
  CHECK(rig.key("Escape", "Escape"));
  rig.pointer(PointerKind::Up, x, at.y + at.height * 0.2);
  rig.settle();
  CHECK(*rig.part().find("along")->find("squash") == squash);
  CHECK(rig.ok("undo"));
  CHECK(rig.part().find("along")->find("squash")->array()->empty());
}

TEST_CASE("the shelf is read back as it was written, and nonsense is left out") {
  PartRig rig;
  REQUIRE(rig.ok("set-section", R"({"contours":[[[0,0],[4,0],[4,2],[0,2]],[[1,0.5],[3,0.5],[2,1.5]]]})"));
  CHECK(rig.sections()[0].number("holes") == 1);
  REQUIRE(rig.ok("keep-slice", R"({"name":"Frame"})"));
  app::SectionUi copy;
  const app::SectionUi& kept = rig.app->ui().sections;
  app::readShelf(copy, app::shelfJson(kept));
  REQUIRE(copy.shelf.size() == 1);
  CHECK(copy.shelf[0].name == "Frame");
  CHECK(copy.shelf[0].shape == kept.shelf[0].shape);
  const auto bad =
      app::Json::parse(R"([{"contours":[[[0,0],[1,1]]]},{"name":"x"},7,null,{"section":"star"},{"contours":"no"}])");
  app::readShelf(copy, *bad);
  CHECK(copy.shelf.empty());
  CHECK(rig.ok("rename-slice", R"({"id":1,"name":"Window"})"));
  CHECK(rig.ok("delete-slice", R"({"id":1})"));
  CHECK(*rig.run("delete-slice", R"({"id":1})").text("error") != "");
}
