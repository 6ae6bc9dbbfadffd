// The tool Layers: a sheet in the solid view, and parts drawn on it layer by layer.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/geometry/polygon.h"
#include "engine/mesh/laws.h"
#include "tests/unit/web/layer_paper.h"
#include "web/edit/layers.h"

using namespace spineloft;
using test::layersOf;
using test::Paper;

TEST_CASE("one closed line on the sheet is a solid along the whole rail, of the size that was drawn") {
  Paper rig;
  rig.circle(0, 0, 0.5);
  REQUIRE(rig.parts() == 1);
  const document::StackRecipe recipe = layersOf(rig);
  REQUIRE(recipe.planes.size() == 1);
  CHECK(recipe.planes[0].at == 0);
  const double half = *rig.sheet().number("half");
  const auto outline = stack::outlineOf(recipe.planes[0].curves.at(0));
  for (const SectionPoint p : outline) CHECK(norm(p) == doctest::Approx(half / 2).epsilon(0.04));
  REQUIRE(rig.works("undo"));
  CHECK(rig.parts() == 0);
  REQUIRE(rig.works("redo"));
  CHECK(layersOf(rig) == recipe);
}

TEST_CASE("the solid follows the pen, and no step is kept until it lifts") {
  Paper rig;
  const double steps = *rig.state().number("undo");
  std::vector<double> triangles;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 1.8 * std::numbers::pi * i / 40;
    const app::ClientPoint at = rig.onCanvas(0.5 * std::cos(angle), 0.5 * std::sin(angle));
    rig.pointer(i == 0 ? platform::PointerKind::Down : platform::PointerKind::Move, at.x, at.y);
    rig.settle();
    if (i == 20 || i == 40) triangles.push_back(rig.state().find("preview")->number("triangles").value_or(0));
    CHECK(*rig.state().number("undo") == steps);
  }
  for (const double count : triangles) CHECK(count > 100);
  CHECK(rig.parts() == 0);
}

TEST_CASE("a Y takes four gestures: a circle, the sheet lifted, two circles beside each other") {
  for (const auto device : {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen}) {
    Paper rig;
    rig.circle(0, 0, 0.4, device);
    REQUIRE(rig.parts() == 1);
    const app::Json::Array knob = *rig.sheet().find("knob")->array();
    const double x = *knob[0].number(), y = *knob[1].number();
    rig.pointer(platform::PointerKind::Down, x, y, device);
    for (int i = 1; i <= 10; ++i) rig.pointer(platform::PointerKind::Move, x, y - 16 * i, device);
    rig.pointer(platform::PointerKind::Up, x, y - 160, device);
    rig.settle();
    CHECK(rig.sheetAt() > 0.3);
    CHECK(layersOf(rig).planes.size() == 1);  // the sheet is no layer
    rig.circle(-0.5, 0, 0.25, device);
    rig.circle(0.5, 0, 0.25, device);
    const document::StackRecipe recipe = layersOf(rig);
    REQUIRE(recipe.planes.size() == 2);
    CHECK(recipe.planes[1].curves.size() == 2);
    CHECK(rig.parts() == 1);
    const auto made = pipeline::stackStage(recipe, {400, 300});
    REQUIRE(made.ok());
    CHECK(mesh::inspect(made.value().mesh).valid());
  }
}

TEST_CASE("the wheel above the sheet moves it, beside the sheet it zooms; a drag beside it turns the view") {
  Paper rig;
  rig.circle(0, 0, 0.5);
  const app::ClientPoint middle = rig.onCanvas(0, 0);
  const double before = rig.sheetAt();
  rig.app->wheel({middle.x, middle.y, 0, -300, 0});
  rig.settle();
  CHECK(rig.sheetAt() > before + 0.05);
  // In the corner of the solid view, above its buttons.
  const double x = rig.onCanvas(0, 0).x, y = 690;
  const double at = rig.sheetAt();
  rig.app->wheel({x, y, 0, -300, 0});
  rig.settle();
  CHECK(rig.sheetAt() == at);
  CHECK(layersOf(rig).planes.size() == 1);
}

TEST_CASE("by keys and buttons alone: a circle, the sheet up, a square, a copy above it, and one layer less") {
  Paper rig;
  REQUIRE(rig.works("layer-circle"));
  for (int i = 0; i < 5; ++i) REQUIRE(rig.key("ArrowUp", "ArrowUp"));
  CHECK(rig.sheetAt() == doctest::Approx(0.5));
  REQUIRE(rig.key("ArrowDown", "ArrowDown", platform::kShift));
  CHECK(rig.sheetAt() == doctest::Approx(0.48));
  REQUIRE(rig.works("layer-square"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 1})"));
  REQUIRE(rig.works("layer-copy"));
  document::StackRecipe recipe = layersOf(rig);
  REQUIRE(recipe.planes.size() == 3);
  CHECK(recipe.planes[2].curves == recipe.planes[1].curves);
  CHECK(recipe.planes[1].curves[0].corners.all);
  // A circle and a square hold the same.
  const auto area = [](const stack::Curve& curve) {
    const auto outline = stack::outlineOf(curve);
    return std::abs(geometry::signedArea(std::span<const SectionPoint>(outline)));
  };
  CHECK(area(recipe.planes[1].curves[0]) == doctest::Approx(area(recipe.planes[0].curves[0])).epsilon(0.01));
  REQUIRE(rig.works("layer-remove"));
  recipe = layersOf(rig);
  CHECK(recipe.planes.size() == 2);
  // With its last layer the part goes.
  REQUIRE(rig.works("layer-sheet", R"({"at": 0})"));
  REQUIRE(rig.works("layer-remove"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.48})"));
  REQUIRE(rig.works("layer-remove"));
  CHECK(rig.parts() == 0);
}

TEST_CASE("a line that crosses a curve of its layer takes its place; one within it is a hole, one beside it a branch") {
  Paper rig;
  rig.circle(0, 0, 0.5);
  rig.circle(0.1, 0, 0.5);
  CHECK(layersOf(rig).planes[0].curves.size() == 1);
  rig.circle(0.1, 0, 0.2);
  CHECK(layersOf(rig).planes[0].curves.size() == 2);
  rig.circle(-0.75, -0.75, 0.15);
  CHECK(layersOf(rig).planes[0].curves.size() == 3);
}

TEST_CASE("a sheet beyond the end makes the rail longer, and layers stay where they are") {
  Paper rig;
  REQUIRE(rig.works("layer-circle"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  REQUIRE(rig.works("layer-circle"));
  const stack::Rail before = layersOf(rig).rail;
  REQUIRE(rig.works("layer-sheet", R"({"at": 1.6})"));
  REQUIRE(rig.works("layer-circle"));
  const document::StackRecipe after = layersOf(rig);
  CHECK(stack::lengthOf(after.rail) == doctest::Approx(1.6 * stack::lengthOf(before)));
  REQUIRE(after.planes.size() == 3);
  CHECK(after.planes[1].at * stack::lengthOf(after.rail) ==
        doctest::Approx(0.5 * stack::lengthOf(before)).epsilon(1e-3));
  CHECK(after.planes[2].at == 1);
  CHECK(rig.sheetAt() == 1);
}

TEST_CASE("a layer is moved between its neighbours and never beyond them") {
  Paper rig;
  for (const char* at : {"0", "0.5", "1"}) {
    REQUIRE(rig.works("layer-sheet", std::string(R"({"at": )") + at + "}"));
    REQUIRE(rig.works("layer-circle"));
  }
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  REQUIRE(rig.works("layer-move", R"({"to": 0.7})"));
  CHECK(layersOf(rig).planes[1].at == doctest::Approx(0.7).epsilon(1e-3));
  CHECK(rig.sheetAt() == doctest::Approx(0.7).epsilon(1e-3));
  REQUIRE(rig.works("layer-move", R"({"to": 5})"));
  CHECK(layersOf(rig).planes[1].at < 1);
  CHECK(layersOf(rig).planes[2].at == 1);
}

TEST_CASE("ends of layers are finished as those of bones") {
  Paper rig;
  REQUIRE(rig.works("layer-circle"));
  REQUIRE(rig.works("set-caps", R"({"end": "round"})"));
  CHECK(layersOf(rig).stack.endCap == sections::CapStyle::Round);
  CHECK(layersOf(rig).stack.startCap == sections::CapStyle::Flat);
  REQUIRE(rig.works("undo"));
  CHECK(layersOf(rig).stack.endCap == sections::CapStyle::Flat);
}

TEST_CASE("what makes no layer is refused with a sentence and changes nothing") {
  Paper rig;
  REQUIRE(rig.works("layer-circle"));
  const std::string before = rig.app->history();
  CHECK_FALSE(rig.works("draw-layer", R"({"line": [[0, 0], [1, 1]]})"));
  CHECK_FALSE(rig.works("draw-layer", R"({"through": [[0, 0], [1, 1]]})"));
  CHECK_FALSE(rig.works("draw-layer", R"({"part": 9, "line": [[0, 0], [9, 0], [9, 9]]})"));
  CHECK_FALSE(rig.works("draw-layer", R"({"line": "round"})"));
  CHECK_FALSE(rig.works("layer-sheet", R"({"at": "up"})"));
  // A figure of eight.
  CHECK_FALSE(rig.works("draw-layer",
                        R"({"at": 0.5, "through": [[-40, -30], [40, 30], [40, -30], [-40, 30]], "corners": true})"));
  CHECK(rig.app->history() == before);
}

TEST_CASE("without the tool there is no sheet; a gesture that is cancelled leaves nothing") {
  Paper rig;
  const app::ClientPoint at = rig.onCanvas(0.4, 0), to = rig.onCanvas(0, 0.4);
  rig.pointer(platform::PointerKind::Down, at.x, at.y);
  for (int i = 1; i <= 10; ++i) {
    rig.pointer(platform::PointerKind::Move, at.x + (to.x - at.x) * i / 10, at.y + (to.y - at.y) * i / 10);
  }
  REQUIRE(rig.key("Escape", "Escape"));
  rig.pointer(platform::PointerKind::Up, to.x, to.y);
  rig.settle();
  CHECK(rig.parts() == 0);
  REQUIRE(rig.works("draw"));
  CHECK(rig.sheet().isNull());
  CHECK_FALSE(rig.works("layer-circle"));
}

TEST_CASE("a line whose ends stay apart is a wall along it, as wide as the others; nearly closed ones still close") {
  Paper rig;
  REQUIRE(rig.works("draw-layer", R"({"line": [[-60, -20], [-30, -5], [0, 0], [30, -5], [60, -20]]})"));
  document::StackRecipe recipe = layersOf(rig);
  const stack::Curve wall = recipe.planes.at(0).curves.at(0);
  CHECK(wall.open);
  CHECK(wall.as == stack::CurveUse::Ribbon);
  CHECK(distance(wall.through.front(), SectionPoint{-60, -20}) < 0.1);
  CHECK(distance(wall.through.back(), SectionPoint{60, -20}) < 0.1);
  const auto made = pipeline::stackStage(recipe, {400, 300});
  REQUIRE(made.ok());
  CHECK(mesh::inspect(made.value().mesh).valid());
  REQUIRE(rig.works("layer-wall", R"({"width": 9})"));
  CHECK(layersOf(rig).planes[0].curves[0].width == doctest::Approx(9));
  REQUIRE(rig.works("draw-layer", R"({"line": [[-60, 40], [0, 40], [60, 41]]})"));
  REQUIRE(layersOf(rig).planes[0].curves.size() == 2);
  CHECK(layersOf(rig).planes[0].curves[1].width == doctest::Approx(9));
  // Three quarters of a circle.
  std::string arc = "[60, 0]";
  for (int i = 1; i <= 30; ++i) {
    const double angle = 1.5 * std::numbers::pi * i / 30;
    arc += ", [" + std::to_string(60 * std::cos(angle)) + ", " + std::to_string(60 * std::sin(angle)) + "]";
  }
  REQUIRE(rig.works("draw-layer", R"({"at": 0.5, "line": [)" + arc + "]}"));
  CHECK_FALSE(layersOf(rig).planes.at(1).curves.at(0).open);
}

namespace {

/// Where every layer stands with its repeats, picture pixels along the rail.
std::vector<double> placesOf(const document::StackRecipe& recipe) {
  const double length = stack::lengthOf(recipe.rail);
  std::vector<double> places;
  const auto& patterns = recipe.stack.patterns;
  for (std::uint32_t copy = 0; copy < (patterns.empty() ? 1 : patterns[0].times); ++copy) {
    for (const stack::Plane& plane : recipe.planes) {
      places.push_back(length * (plane.at + (copy > 0 ? copy * patterns[0].spacing : 0)));
    }
  }
  return places;
}

Paper& withThreeLayers(Paper& rig) {
  for (const char* at : {"0", "0.3", "1"}) {
    REQUIRE(rig.works("layer-sheet", std::string(R"({"at": )") + at + "}"));
    REQUIRE(rig.works(at[0] == '0' && at[1] ? "layer-square" : "layer-circle"));
  }
  return rig;
}

}  // namespace

TEST_CASE("repeated layers stay where they are on a straight line, which grows by one run after the other") {
  Paper rig;
  withThreeLayers(rig);
  const document::StackRecipe once = layersOf(rig);
  const std::vector<double> before = placesOf(once);
  REQUIRE(rig.works("layer-repeat", R"({"times": 4})"));
  const document::StackRecipe repeated = layersOf(rig);
  REQUIRE(repeated.planes.size() == 3);
  const std::vector<double> places = placesOf(repeated);
  REQUIRE(places.size() == 12);
  for (std::size_t i = 0; i < 3; ++i) CHECK(places[i] == doctest::Approx(before[i]).epsilon(1e-3));
  const double period = places[3] - places[0];
  CHECK(period == doctest::Approx(1.5 * (before[2] - before[0])).epsilon(1e-3));
  CHECK(places.back() == doctest::Approx(stack::lengthOf(repeated.rail)).epsilon(1e-3));
  const auto made = pipeline::stackStage(repeated, {400, 300});
  REQUIRE(made.ok());
  CHECK(mesh::inspect(made.value().mesh).valid());
  REQUIRE(rig.works("layer-repeat", R"({"times": 1})"));
  const std::vector<double> again = placesOf(layersOf(rig));
  for (std::size_t i = 0; i < 3; ++i) CHECK(again.at(i) == doctest::Approx(before[i]).epsilon(1e-3));
  CHECK_FALSE(rig.works("layer-repeat", R"({"times": 0})"));
  CHECK_FALSE(rig.works("layer-repeat", R"({"times": 2.5})"));
}

TEST_CASE("among repeated layers a new one is repeated with them, and one that goes, goes everywhere") {
  Paper rig;
  withThreeLayers(rig);
  REQUIRE(rig.works("layer-repeat", R"({"times": 3})"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 9})"));
  CHECK(rig.sheetAt() == doctest::Approx(layersOf(rig).planes.back().at).epsilon(1e-3));  // the end of the first run
  const double between = (layersOf(rig).planes[1].at + layersOf(rig).planes[2].at) / 2;
  REQUIRE(rig.works("layer-sheet", R"({"at": )" + std::to_string(between) + "}"));
  REQUIRE(rig.works("layer-circle"));
  REQUIRE(layersOf(rig).planes.size() == 4);
  CHECK(layersOf(rig).stack.patterns.at(0).last == 3);
  CHECK(placesOf(layersOf(rig)).size() == 12);
  REQUIRE(rig.works("layer-remove"));
  CHECK(layersOf(rig).stack.patterns.at(0).last == 2);
  CHECK(placesOf(layersOf(rig)).size() == 9);
  REQUIRE(rig.works("undo"));
  REQUIRE(rig.works("undo"));
  CHECK(placesOf(layersOf(rig)).size() == 9);
}

TEST_CASE("a ring has its layers evenly all round, a spring along it, and both come back to a straight line") {
  Paper rig;
  REQUIRE(rig.works("layer-circle"));
  REQUIRE(rig.works("layer-rail", R"({"rail": "ring"})"));
  const auto torus = pipeline::stackStage(layersOf(rig), {400, 300});
  REQUIRE(torus.ok());
  CHECK(mesh::inspect(torus.value().mesh).genus == 1);
  REQUIRE(rig.works("undo"));
  REQUIRE(rig.works("layer-remove"));
  withThreeLayers(rig);
  for (const char* shape : {"ring", "spring", "across", "up"}) {
    REQUIRE(rig.works("layer-rail", std::string(R"({"rail": ")") + shape + "\"}"));
    REQUIRE(rig.works("layer-repeat", R"({"times": 2})"));
    const document::StackRecipe recipe = layersOf(rig);
    CHECK(recipe.rail.closed == (shape == std::string("ring")));
    const std::vector<double> places = placesOf(recipe);
    const double length = stack::lengthOf(recipe.rail);
    CHECK(places[3] - places[0] == doctest::Approx(recipe.rail.closed ? length / 2 : length * 0.6).epsilon(1e-3));
    const auto made = pipeline::stackStage(recipe, {400, 300});
    REQUIRE(made.ok());
    CHECK(mesh::inspect(made.value().mesh).valid());
    REQUIRE(rig.works("layer-repeat", R"({"times": 1})"));
  }
  CHECK_FALSE(rig.works("layer-rail", R"({"rail": "knot"})"));
}

TEST_CASE("blend and bumps are set for all layers, in one step each, and what is out of range is refused") {
  Paper rig;
  withThreeLayers(rig);
  const double steps = *rig.state().number("undo");
  REQUIRE(rig.works("layer-blend", R"({"blend": "hold"})"));
  for (const stack::Plane& plane : layersOf(rig).planes) CHECK(plane.blend.kind == sections::BlendKind::Hold);
  REQUIRE(rig.works("layer-bumps", R"({"amount": 3, "size": 20, "seed": 5})"));
  CHECK(layersOf(rig).stack.rough == stack::Rough{3, 20, 5, false});
  CHECK(*rig.state().number("undo") == steps + 2);
  const std::string before = rig.app->history();
  CHECK_FALSE(rig.works("layer-blend", R"({"blend": "custom"})"));
  CHECK_FALSE(rig.works("layer-bumps", R"({"amount": 5000})"));
  CHECK_FALSE(rig.works("layer-wall", R"({"width": 4})"));
  CHECK(rig.app->history() == before);
}

namespace {

/// A page with a Y: a circle, and two above it on a sheet that lies on them.
struct Forked : Paper {
  explicit Forked(platform::CanvasSize size = {1200, 700, 1}) : Paper(size) {
    circle(0, 0, 0.4);
    REQUIRE(works("layer-sheet", R"({"at": 0.8})"));
    circle(-0.5, 0, 0.25);
    circle(0.5, 0, 0.25);
  }
  app::Json::Array joints(std::string_view key) { return *sheet().find(key)->array(); }
  app::ClientPoint placeOf(const app::Json& joint, std::string_view key) {
    const app::Json::Array& place = *joint.find(key)->array();
    return {*place[0].number(), *place[1].number()};
  }
  std::vector<bool> linked() {
    std::vector<bool> on;
    for (const app::Json& link : joints("links")) on.push_back(link.flag("on") == true);
    return on;
  }
  double steps() { return *state().number("undo"); }
};

}  // namespace

TEST_CASE("a tap on the dot of a link parts two curves, another one joins them, and each is a step") {
  for (const auto device : {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen}) {
    Forked rig;
    REQUIRE(rig.linked() == std::vector{true, true});
    const app::ClientPoint dot = rig.placeOf(rig.joints("links")[1], "mark");
    const double before = rig.steps();
    const auto tap = [&] {
      rig.pointer(platform::PointerKind::Down, dot.x, dot.y, device);
      rig.pointer(platform::PointerKind::Up, dot.x, dot.y, device);
      rig.settle();
    };
    tap();
    CHECK(rig.linked() == std::vector{true, false});
    CHECK(rig.joints("forks").empty());
    CHECK(rig.steps() == before + 1);
    CHECK(layersOf(rig).planes[0].links == std::vector<stack::CurveLink>{{0, 1, false}});
    tap();
    CHECK(rig.linked() == std::vector{true, true});
    REQUIRE(rig.works("undo"));
    REQUIRE(rig.works("undo"));
    CHECK(layersOf(rig).planes[0].links.empty());
    CHECK(rig.joints("forks").size() == 1);
  }
}

TEST_CASE("the knob of a fork moves it, the solid follows, and no step is kept until it is let go") {
  Forked rig;
  const app::Json fork = rig.joints("forks").at(0);
  CHECK(fork.flag("up") == true);
  const double at = *fork.number("at"), before = rig.steps();
  const app::ClientPoint knob = rig.placeOf(fork, "knob");
  rig.pointer(platform::PointerKind::Down, knob.x, knob.y);
  for (int i = 1; i <= 10; ++i) rig.pointer(platform::PointerKind::Move, knob.x, knob.y - 2 * i);
  rig.settle();
  CHECK(rig.state().find("preview")->number("triangles").value_or(0) > 100);
  CHECK(rig.steps() == before);
  CHECK_FALSE(layersOf(rig).planes[0].curves[0].forkAt);
  rig.pointer(platform::PointerKind::Up, knob.x, knob.y - 20);
  rig.settle();
  CHECK(rig.steps() == before + 1);
  REQUIRE(layersOf(rig).planes[0].curves[0].forkAt);
  CHECK(*layersOf(rig).planes[0].curves[0].forkAt > at + 0.05);
  CHECK(*rig.joints("forks").at(0).number("at") == doctest::Approx(*layersOf(rig).planes[0].curves[0].forkAt));
  rig.pointer(platform::PointerKind::Down, knob.x, knob.y - 20);
  rig.pointer(platform::PointerKind::Move, knob.x, knob.y);
  rig.key("Escape", "Escape");
  CHECK(rig.steps() == before + 1);
}

TEST_CASE("a line may begin on a dot that lies over the sheet") {
  Forked rig;
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  const app::ClientPoint dot = rig.placeOf(rig.joints("links").at(0), "mark");
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * std::numbers::pi * i / 40;
    const app::ClientPoint at = dot + app::ClientPoint{30 * (1 - std::cos(angle)), 20 * std::sin(angle)};
    rig.pointer(i == 0 ? platform::PointerKind::Down : platform::PointerKind::Move, at.x, at.y);
  }
  rig.pointer(platform::PointerKind::Up, dot.x, dot.y);
  rig.settle();
  CHECK(layersOf(rig).planes.size() == 3);
}

TEST_CASE("what is said about links goes with the curves and layers that it is about") {
  Forked rig;
  REQUIRE(rig.works("layer-link", R"({"link": 0, "on": false})"));
  REQUIRE(layersOf(rig).planes[0].links.size() == 1);
  rig.circle(-0.55, 0, 0.25);  // over the first of the two
  const document::StackRecipe redrawn = layersOf(rig);
  REQUIRE(redrawn.planes[1].curves.size() == 2);
  CHECK(redrawn.planes[0].links.empty());
  REQUIRE(rig.works("layer-link", R"({"link": 1, "on": false})"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.4})"));
  rig.circle(0, 0, 0.4);
  REQUIRE(layersOf(rig).planes.size() == 3);
  CHECK(layersOf(rig).planes[0].links.empty());  // another layer follows it now
  REQUIRE(rig.works("layer-remove"));
  CHECK(layersOf(rig).planes.size() == 2);
}

TEST_CASE("links and forks by numbers: refusals say what to name") {
  Forked rig;
  const auto sentence = [&](std::string_view id, std::string_view args) { return *rig.run(id, args).text("sentence"); };
  CHECK(sentence("layer-link", R"({"link": 7})").find("the number of one of the sheet's") != std::string::npos);
  CHECK(sentence("layer-fork", R"({"at": 2})").find("0…1") != std::string::npos);
  REQUIRE(rig.works("layer-fork", R"({"at": 0.75})"));
  CHECK(layersOf(rig).planes[0].curves[0].forkAt == 0.75);
  REQUIRE(rig.works("layer-link", R"({"link": 0})"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0})"));
  CHECK_FALSE(rig.linked().empty());
  // Without any link there would be no solid: it stays as it is.
  CHECK_FALSE(rig.works("layer-link", R"({"link": 1, "on": false})"));
  CHECK(rig.parts() == 1);
}

TEST_CASE("a program makes a whole part of layers from its recipe; what is no such recipe is refused by name") {
  Paper page;
  const std::string recipe = R"({"kind":"stack","recipe":{"rail":{"points":[200,-250,0,200,-100,0]},"planes":[
    {"at":0,"curves":[{"through":[40,0,0,40,-40,0,0,-40]}]},
    {"at":1,"curves":[{"through":[20,0,0,20,-20,0,0,-20]}]}]}})";
  REQUIRE(page.works("draw-stack", R"({"recipe":)" + recipe + "}"));
  page.settle();
  CHECK(page.parts() == 1);
  CHECK(layersOf(page).planes.size() == 2);
  CHECK(layersOf(page).rail.points.size() == 2);
  REQUIRE(page.works("undo"));
  CHECK(page.parts() == 0);
  CHECK(page.fault("draw-stack", "{}") == "ArgumentMissing");
  CHECK(page.fault("draw-stack", R"({"recipe":{"kind":"stack","recipe":{"planes":[]}}})") != "");
  CHECK(page.fault("draw-stack", R"({"recipe":{"kind":"stack","recipe":{"planes":[{"at":7,"curves":
    [{"through":[40,0,0,40,-40,0,0,-40]}]}]}}})") != "");
  CHECK(page.fault("draw-stack", R"({"recipe":{"kind":"ball"}})") != "");
  CHECK(page.parts() == 0);
}
