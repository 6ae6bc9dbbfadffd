// The tool Shapes: drawn by hand, changed by its handles, its outlines redrawn, also in a side picture.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/geometry/polygon.h"
#include "engine/io/json_fields.h"
#include "engine/shape/shape.h"
#include "tests/support/mesh_laws.h"
#include "tests/unit/web/rig.h"
#include "web/edit/shaping.h"

using namespace spineloft;
using test::Rig;

namespace {

constexpr std::array kDevices = {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen};

struct Shapes : Rig {
  explicit Shapes(platform::CanvasSize size = {1200, 700, 1}) : Rig(size) {
    CHECK(works("new-sketch", R"({"width": 400, "height": 300})"));
    CHECK(works("shapes"));
  }
  static PicturePoint pointFrom(const app::Json& p) { return {*(*p.array())[0].number(), *(*p.array())[1].number()}; }
  static std::vector<PicturePoint> lineFrom(const app::Json& line) {
    std::vector<PicturePoint> out;
    for (const app::Json& p : *line.array()) out.push_back(pointFrom(p));
    return out;
  }
  /// The last part, a shape.
  document::ShapeRecipe last() {
    const app::Json now = state();
    const app::Json& part = now.find("parts")->array()->back();
    const app::Json& shape = *part.find("shape");
    document::ShapeRecipe recipe;
    recipe.picture = PictureId{static_cast<std::uint32_t>(*part.number("picture"))};
    REQUIRE(io::fromKey(*shape.text("kind"), recipe.shape.primitive));
    const std::vector<PicturePoint> axis = lineFrom(*shape.find("axis"));
    recipe.shape.axis = {axis[0], axis[1]};
    recipe.shape.width = *shape.number("width");
    recipe.shape.depth.ratio = *shape.number("ratio");
    for (const app::Json& outline : *shape.find("outlines")->array()) {
      document::Outline& one = recipe.outlines.emplace_back();
      one.picture = PictureId{static_cast<std::uint32_t>(*outline.number("picture"))};
      for (const app::Json& line : *outline.find("lines")->array()) one.lines.push_back(lineFrom(line));
    }
    return recipe;
  }
  std::optional<geometry::View> viewOf(std::size_t picture) {
    const app::Json now = state();
    const app::Json& view = *(*now.find("pictureList")->array())[picture].find("view");
    if (view.isNull()) return std::nullopt;
    geometry::View out;
    REQUIRE(io::fromKey(*view.text("from"), out.from));
    out.middle = *view.number("middle");
    out.scale = *view.number("scale");
    out.shift = *view.number("shift");
    return out;
  }
  /// Its solid, which obeys the laws.
  mesh::TriMesh solid() {
    const document::ShapeRecipe recipe = last();
    std::vector<shape::SeenOutline> outlines;
    for (const document::Outline& outline : recipe.outlines) {
      outlines.push_back({viewOf(outline.picture.value - 1), outline.lines});
    }
    auto made = shape::makeShape(recipe.shape, outlines, {400, 300});
    REQUIRE(made.ok());
    testing::requireLawful(made.value().mesh);
    return made.value().mesh;
  }
  /// Along picture points, as a hand draws: with moves in between.
  void draw(const std::vector<PicturePoint>& line, platform::Device device = {}) {
    const auto first = at(line.front().x, line.front().y);
    pointer(platform::PointerKind::Down, first.x, first.y, device);
    auto p = first;
    for (std::size_t i = 1; i < line.size(); ++i) {
      for (int k = 1; k <= 4; ++k) {
        const PicturePoint q = lerp(line[i - 1], line[i], k / 4.0);
        p = at(q.x, q.y);
        pointer(platform::PointerKind::Move, p.x, p.y, device);
        settle(2);
      }
    }
    const app::Json now = state();
    middle = now.find("preview")->isNull() ? 0 : *now.find("preview")->number("triangles");
    pointer(platform::PointerKind::Up, p.x, p.y, device);
    settle();
  }
  void tap(PicturePoint p, platform::Device device = {}) {
    const auto c = at(p.x, p.y);
    pointer(platform::PointerKind::Down, c.x, c.y, device);
    pointer(platform::PointerKind::Up, c.x, c.y, device);
    settle();
  }
  void pull(std::string_view hold, PicturePoint by, platform::Device device = {}) {
    const PicturePoint from = handle(hold);
    draw({from, from + by}, device);
  }
  PicturePoint handle(std::string_view hold) {
    const app::Json now = state();
    const auto origin = at(0, 0), one = at(1, 0);
    for (const app::Json& handle : *now.find("shapeHandles")->array()) {
      if (*handle.text("hold") != hold) continue;
      const auto& at = *handle.find("at")->array();
      const double zoom = one.x - origin.x;
      return {(*at[0].number() - origin.x) / zoom, (*at[1].number() - origin.y) / zoom};
    }
    FAIL("no such handle");
    return {};
  }
  std::vector<PicturePoint> seen() {
    const app::Json now = state();
    return lineFrom(*now.find("shapeOutline"));
  }
  double middle = 0;  ///< triangles of the preview before the pointer was let go
};

/// From its left, where no handle is.
std::vector<PicturePoint> ellipse(PicturePoint middle, double a, double b, int n = 48) {
  std::vector<PicturePoint> line;
  for (int i = 0; i <= n; ++i) {
    const double t = 2 * std::numbers::pi * i / n;
    line.push_back({middle.x - a * std::cos(t), middle.y + b * std::sin(t)});
  }
  return line;
}

bool holds(const std::vector<PicturePoint>& line, PicturePoint p) {
  return geometry::holds(std::span<const PicturePoint>(line), p);
}

/// How much of the two areas is in both.
double overlap(const std::vector<PicturePoint>& a, const std::vector<PicturePoint>& b) {
  int both = 0, any = 0;
  for (int y = 0; y < 300; ++y) {
    for (int x = 0; x < 400; ++x) {
      const PicturePoint p{x + 0.013, y + 0.017};
      const bool in = holds(a, p), on = holds(b, p);
      both += in && on;
      any += in || on;
    }
  }
  return any > 0 ? static_cast<double>(both) / any : 0;
}

}  // namespace

TEST_CASE("a drag makes the chosen shape from one end of its axis to the other, in one step; the solid follows") {
  for (const platform::Device device : kDevices) {
    for (const shape::ReadyShape& name : shape::readyShapes()) {
      CAPTURE(name.label);
      Shapes rig;
      REQUIRE(rig.works("shape-kind", R"({"kind": ")" + std::string(io::keyOf(name.primitive)) + "\"}"));
      const double undo = rig.undoSteps();
      rig.draw({{200, 240}, {200, 150}, {201, 60}}, device);
      CHECK(rig.middle > 100);
      CHECK(rig.undoSteps() == undo + 1);
      const document::ShapeRecipe made = rig.last();
      CHECK(made.shape.primitive == name.primitive);
      CHECK(distance(made.shape.axis.from, {200, 240}) < 1);
      CHECK(distance(made.shape.axis.to, {200, 60}) < 1);  // upright where it nearly is
      CHECK(made.shape.width == doctest::Approx(180 * name.width).epsilon(0.02));
      rig.solid();
      REQUIRE(rig.works("undo"));
      CHECK(rig.parts() == 0);
    }
  }
}

TEST_CASE("both ends, the middle and the width are dragged, each in one step, with the solid") {
  Shapes rig;
  REQUIRE(rig.works("shape-kind", R"({"kind": "cylinder"})"));
  rig.draw({{200, 240}, {200, 60}});
  const double undo = rig.undoSteps();
  rig.pull("to", {0, 40});
  CHECK(rig.middle > 100);
  CHECK(distance(rig.last().shape.axis.to, {200, 100}) < 1);
  rig.pull("from", {60, -10});
  CHECK(distance(rig.last().shape.axis.from, {260, 230}) < 1);
  const shape::Axis before = rig.last().shape.axis;
  const PicturePoint middle = rig.handle("middle");
  rig.draw({middle, middle + PicturePoint{-40, 10}});
  CHECK(distance(rig.last().shape.axis.from, before.from + PicturePoint{-40, 10}) < 1);
  CHECK(distance(rig.last().shape.axis.to, before.to + PicturePoint{-40, 10}) < 1);
  const double width = rig.last().shape.width;
  const shape::Axis axis = rig.last().shape.axis;
  const PicturePoint hold = rig.handle("width"), along = normalized(axis.to - axis.from);
  const PicturePoint out = hold + PicturePoint{-along.y, along.x} * 15;
  rig.draw({hold, out});
  CHECK(rig.last().shape.width == doctest::Approx(width + 30).epsilon(0.03));
  CHECK(rig.undoSteps() == undo + 4);
  // An end cannot come upon the other one.
  rig.pull("to", rig.last().shape.axis.from - rig.last().shape.axis.to);
  CHECK(distance(rig.last().shape.axis.to, rig.last().shape.axis.from) >= 4);
}

TEST_CASE("a line along a side is the outline there, on both sides and round all; the axis goes from end to end") {
  for (const platform::Device device : kDevices) {
    Shapes rig;
    rig.draw({{200, 240}, {200, 60}}, device);
    const double undo = rig.undoSteps();
    rig.draw({{205, 62}, {300, 80}, {320, 150}, {300, 220}, {205, 238}}, device);
    CHECK(rig.middle > 100);
    CHECK(rig.undoSteps() == undo + 1);
    CHECK(rig.parts() == 1);
    REQUIRE(rig.last().outlines.size() == 1);
    std::vector<PicturePoint> seen = rig.seen();
    CHECK(holds(seen, PicturePoint{300, 150}));
    CHECK(holds(seen, PicturePoint{115, 150}));
    CHECK_FALSE(holds(seen, PicturePoint{105, 150}));
    const std::vector<PicturePoint> round = ellipse({200, 160}, 50, 120);
    rig.draw(round, device);
    CHECK(overlap(rig.seen(), round) >= 0.985);
    CHECK(rig.last().shape.axis.from.y == doctest::Approx(280).epsilon(0.02));
    CHECK(rig.last().shape.axis.to.y == doctest::Approx(40).epsilon(0.05));
    CHECK(rig.undoSteps() == undo + 2);
    REQUIRE(rig.works("plain-outline"));
    CHECK(rig.last().outlines.empty());
  }
}

TEST_CASE("a line that begins away from the outline is a new shape, unless it goes round the one in hand") {
  Shapes rig;
  rig.draw({{200, 240}, {200, 60}});
  const std::vector<PicturePoint> wide = ellipse({200, 150}, 180, 140);
  rig.draw(wide);
  CHECK(rig.parts() == 1);
  CHECK(overlap(rig.seen(), wide) >= 0.985);
  REQUIRE(rig.works("undo"));
  rig.draw({{240, 180}, {270, 160}});
  CHECK(rig.parts() == 2);
}

TEST_CASE("a drawn outline goes along with the handles") {
  Shapes rig;
  rig.draw({{200, 240}, {200, 60}});
  std::vector<PicturePoint> round = ellipse({200, 150}, 50, 90);
  rig.draw(round);
  const PicturePoint middle = rig.handle("middle");
  rig.draw({middle, middle + PicturePoint{60, 0}});
  for (PicturePoint& p : round) p.x += 60;
  CHECK(overlap(rig.seen(), round) >= 0.98);
  rig.pull("width", {30, 0});
  for (PicturePoint& p : round) p.x = 260 + (p.x - 260) * 80 / 50;
  CHECK(overlap(rig.seen(), round) >= 0.97);
}

TEST_CASE("a line of which no shape comes is refused in a sentence and changes nothing") {
  Shapes rig;
  rig.draw({{200, 240}, {200, 60}});
  const std::string before = rig.app->history();
  rig.host.sent.clear();
  rig.draw({{200, 240}, {120, 60}, {280, 60}, {120, 240}, {280, 240}, {200, 60}, {100, 200}, {201, 240}});
  CHECK(rig.host.said("No shape comes of this line"));
  CHECK(rig.app->history() == before);
  // A gesture that is taken back leaves nothing.
  const auto p = rig.at(50, 50), q = rig.at(90, 90);
  rig.pointer(platform::PointerKind::Down, p.x, p.y);
  rig.pointer(platform::PointerKind::Move, q.x, q.y);
  rig.settle(3);
  REQUIRE(rig.key("Escape", "Escape"));
  CHECK(rig.state().find("preview")->isNull());
  rig.pointer(platform::PointerKind::Up, q.x, q.y);
  rig.settle();
  CHECK(rig.app->history() == before);
}

TEST_CASE("a tap on a thing fits the shape to it, in one step") {
  Rig rig;
  rig.openBar();
  REQUIRE(rig.run("shapes").flag("ok") == true);
  REQUIRE(rig.run("shape-kind", R"({"kind": "cylinder"})").flag("ok") == true);
  rig.settle();
  const double undo = *rig.state().number("undo");
  const auto p = rig.at(100, 100);
  rig.click(p.x, p.y);
  REQUIRE(rig.parts() == 1);
  CHECK(*rig.state().number("undo") == undo + 1);
  const app::Json shape = *rig.state().find("parts")->array()->back().find("shape");
  CHECK(*shape.text("kind") == "cylinder");
  CHECK(*shape.number("width") == doctest::Approx(41).epsilon(0.06));
  const auto& axis = *shape.find("axis")->array();
  CHECK(*(*axis[0].array())[0].number() == doctest::Approx(100).epsilon(0.02));
  CHECK(*(*axis[0].array())[1].number() == doctest::Approx(170).epsilon(0.02));
  CHECK(*(*axis[1].array())[1].number() == doctest::Approx(30).epsilon(0.06));
  CHECK(shape.find("outlines")->array()->size() == 1);
  // A tap on the shape takes it in hand; a tile with another tool in hand makes it another one.
  REQUIRE(rig.run("shape-kind", R"({"kind": "box", "part": 1})").flag("ok") == true);
  rig.settle();
  CHECK(*rig.state().find("parts")->array()->back().find("shape")->text("kind") == "box");
}

TEST_CASE("a line round a puff or a loft in its side picture is its side, and aligns the picture") {
  for (const char* part :
       {R"({"line": [[150, 60], [250, 60], [250, 240], [150, 240], [150, 60]]})", R"([[200, 60], [200, 240]])"}) {
    const bool puff = part[0] == '{';
    Shapes rig;
    REQUIRE(rig.works(puff ? "draw-puff" : "draw-spine", puff ? part : "{\"stroke\": " + std::string(part) + "}"));
    REQUIRE(rig.works("new-sketch", R"({"width": 200, "height": 200})"));
    REQUIRE(rig.works("select-picture", R"({"picture": 1})"));
    REQUIRE(rig.works("select-part", R"({"id": 1})"));
    REQUIRE(rig.works("shapes"));
    REQUIRE(rig.works("select-picture", R"({"picture": 2})"));
    REQUIRE(rig.works("side-picture", R"({"from": "right"})"));
    const auto side = [&] { return *rig.state().find("parts")->array()->back().find("side"); };
    CHECK(side().isNull());
    const double undo = rig.undoSteps();
    rig.draw(ellipse({120, 110}, 20, 45));
    CHECK(rig.parts() == 1);
    CHECK(rig.undoSteps() == undo + 1);
    REQUIRE_FALSE(side().isNull());
    CHECK(*side().number("picture") == 2);
    const geometry::View view = *rig.viewOf(1);
    CHECK(view.middle == doctest::Approx(120).epsilon(0.02));
    if (puff) CHECK(view.scale == doctest::Approx(2).epsilon(0.02));
    const auto left = [&] {
      double least = 200;
      for (const PicturePoint p : Shapes::lineFrom((*side().find("lines")->array())[0])) least = std::min(least, p.x);
      return least;
    };
    CHECK(left() == doctest::Approx(100).epsilon(0.01));
    // One more line at it takes the place of the stretch beside it.
    rig.draw({{120, 66}, {90, 110}, {120, 154}});
    CHECK(rig.undoSteps() == undo + 2);
    CHECK(left() == doctest::Approx(90).epsilon(0.01));
    REQUIRE(rig.works("plain-side"));
    CHECK(side().isNull());
  }
}

TEST_CASE("a picture that is opened may be the side of the shape in hand, which stays there; another part does not") {
  Shapes rig;
  rig.draw({{200, 240}, {200, 60}});
  rig.openBar();
  CHECK(*rig.state().number("selection") == 1);
  REQUIRE(rig.works("side-picture", R"({"from": "right"})"));
  rig.draw(ellipse({100, 100}, 30, 60));
  CHECK(rig.parts() == 1);
  CHECK(rig.last().outlines.size() == 1);
  REQUIRE(rig.works("draw"));
  REQUIRE(rig.works("select-picture", R"({"picture": 1})"));
  REQUIRE(rig.works("select-part", R"({"id": 1})"));
  rig.openBar();
  CHECK(rig.state().find("selection")->isNull());
}

TEST_CASE(
    "a picture that looks from elsewhere loses the outlines drawn in it, which is said and taken back as one step") {
  Shapes rig;
  rig.draw({{200, 240}, {200, 60}});
  rig.openBar();
  REQUIRE(rig.works("side-picture", R"({"from": "right"})"));
  rig.draw(ellipse({100, 100}, 30, 60));
  REQUIRE(rig.last().outlines.size() == 1);
  REQUIRE(rig.works("side-picture", R"({"from": "left"})"));
  CHECK(rig.last().outlines.size() == 1);
  CHECK_FALSE(rig.host.said("Undo brings them back"));
  REQUIRE(rig.works("side-picture", R"({"from": "top"})"));
  CHECK(rig.last().outlines.empty());
  CHECK(rig.host.said("Undo brings them back"));
  REQUIRE(rig.works("undo"));
  CHECK(rig.last().outlines.size() == 1);
  REQUIRE(rig.works("undo"));
  CHECK(rig.host.said("Undone: Side picture"));
}

TEST_CASE("a picture becomes the side, and the first outline drawn there aligns it") {
  for (const platform::Device device : kDevices) {
    Shapes rig;
    rig.draw({{200, 240}, {200, 60}}, device);
    REQUIRE(rig.works("new-sketch", R"({"width": 200, "height": 200})"));
    REQUIRE(rig.works("select-picture", R"({"picture": 1})"));
    REQUIRE(rig.works("select-part", R"({"id": 1})"));
    REQUIRE(rig.works("shapes"));
    REQUIRE(rig.works("select-picture", R"({"picture": 2})"));
    CHECK(*rig.state().number("selection") == 1);
    CHECK(rig.seen().empty());
    REQUIRE(rig.works("side-picture", R"({"from": "right"})"));
    REQUIRE(rig.viewOf(1));
    CHECK_FALSE(rig.seen().empty());
    const double undo = rig.undoSteps();
    // As high as half the shape in the front, and lower in its picture: both pictures show the same height then.
    const std::vector<PicturePoint> round = ellipse({120, 110}, 20, 45);
    rig.draw(round, device);
    CHECK(rig.middle > 100);
    CHECK(rig.undoSteps() == undo + 1);
    const geometry::View view = *rig.viewOf(1);
    CHECK(view.scale == doctest::Approx(2).epsilon(0.02));
    CHECK(view.middle == doctest::Approx(120).epsilon(0.02));
    CHECK(geometry::inModel(view, {120, 65}).y == doctest::Approx(-60).epsilon(0.03));
    CHECK(overlap(rig.seen(), round) >= 0.98);
    float deep = 0;
    for (const auto& p : rig.solid().positions) deep = std::max(deep, std::abs(p[2]));
    CHECK(deep == doctest::Approx(40).epsilon(0.03));
    REQUIRE(rig.works("undo"));
    CHECK(rig.last().outlines.empty());
    CHECK(rig.viewOf(1)->scale == doctest::Approx(1.5));
    REQUIRE(rig.works("redo"));
    // The depth by its handle, and a stretch of the side.
    const PicturePoint hold = rig.handle("depth");
    CHECK(hold.x < 100);  // held off the outline
    rig.draw({hold, hold - PicturePoint{10, 0}}, device);
    CHECK(rig.handle("depth").x == doctest::Approx(hold.x - 10).epsilon(0.02));
    // No more a side.
    REQUIRE(rig.works("side-picture", R"({"from": "none"})"));
    CHECK(rig.last().outlines.empty());
  }
}

TEST_CASE("by keys: points are chosen, moved as one step, and told to screen readers") {
  Shapes rig;
  rig.draw({{200, 240}, {200, 60}});
  const double undo = rig.undoSteps();
  CHECK(rig.key("Period", "."));
  CHECK(*rig.state().find("chosen")->number("shapeHandle") == 0);
  CHECK(rig.host.said("The end where the shape begins"));
  CHECK(rig.key("ArrowDown", "ArrowDown"));
  CHECK(rig.key("ArrowDown", "ArrowDown", platform::kShift));
  CHECK(rig.last().shape.axis.from.y == doctest::Approx(251).epsilon(0.01));
  CHECK(rig.undoSteps() == undo + 1);
  CHECK(rig.key("Comma", ","));
  CHECK(*rig.state().find("chosen")->number("shapeHandle") == 3);
  const double width = rig.last().shape.width;
  CHECK(rig.key("ArrowRight", "ArrowRight", platform::kShift));
  CHECK(rig.last().shape.width == doctest::Approx(width + 20).epsilon(0.02));
  CHECK(rig.key("Escape", "Escape"));
  CHECK(*rig.state().find("chosen")->number("shapeHandle") == -1);
  const app::Json now = rig.state();
  int told = 0;
  for (const app::Json& control : *now.find("controls")->array()) {
    const std::string& words = *control.text("words");
    told += words.find("of the shape: from") != std::string::npos;
  }
  CHECK(told == 7);
}

TEST_CASE("a tile of the tool lets go of the shape in hand and is for the next one") {
  Shapes rig;
  rig.draw({{100, 240}, {100, 60}});
  REQUIRE(rig.works("shape-kind", R"({"kind": "cone"})"));
  CHECK(rig.state().find("selection")->isNull());
  CHECK(rig.last().shape.primitive == shape::Primitive::Ball);
  rig.draw({{300, 240}, {300, 60}});
  CHECK(rig.last().shape.primitive == shape::Primitive::Cone);
  CHECK(rig.parts() == 2);
}

TEST_CASE("shapes and a side picture live through a reload") {
  std::string kept;
  {
    Shapes rig;
    rig.draw({{200, 240}, {200, 60}});
    rig.draw(ellipse({200, 150}, 50, 90));
    REQUIRE(rig.works("new-sketch", R"({"width": 200, "height": 200})"));
    REQUIRE(rig.works("select-picture", R"({"picture": 1})"));
    REQUIRE(rig.works("select-part", R"({"id": 1})"));
    REQUIRE(rig.works("shapes"));
    REQUIRE(rig.works("select-picture", R"({"picture": 2})"));
    REQUIRE(rig.works("side-picture", R"({"from": "left"})"));
    rig.draw(ellipse({100, 100}, 20, 60));
    REQUIRE(rig.last().outlines.size() == 2);
    kept = rig.app->history();
  }
  Rig again;
  REQUIRE(app::Json::parse(again.app->restore(kept, "[]"))->flag("ok") == true);
  again.settle();
  CHECK(again.app->history() == kept);
  CHECK(again.state().find("parts")->array()->back().find("shape")->find("outlines")->array()->size() == 2);
  CHECK(again.state().find("parts")->array()->back().find("failure")->isNull());
}
