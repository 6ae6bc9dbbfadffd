// The rail of layers drawn by hand or through their middles, sheets that lean, and lines that are ground.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "engine/geometry/polygon.h"
#include "engine/mesh/laws.h"
#include "engine/mesh/surface_places.h"
#include "engine/stack/centre_rail.h"
#include "tests/unit/web/layer_paper.h"
#include "web/edit/layers.h"
#include "web/edit/placing.h"

using namespace spineloft;
using test::layersOf;
using test::Paper;

namespace {

using platform::PointerKind;

/// A drag through points of the canvas.
void drag(Paper& rig, const std::vector<app::ClientPoint>& path, platform::Device device = {}, bool lifts = true) {
  for (std::size_t i = 0; i < path.size(); ++i) {
    rig.pointer(i == 0 ? PointerKind::Down : PointerKind::Move, path[i].x, path[i].y, device);
    rig.lastX = path[i].x;
    rig.lastY = path[i].y;
  }
  if (lifts) rig.lift(device);
  rig.settle();
}

/// Half a wave across the solid view, about the sheet's middle.
std::vector<app::ClientPoint> wave(Paper& rig, double width = 200, double height = 80) {
  const app::ClientPoint middle = rig.onCanvas(0, 0);
  std::vector<app::ClientPoint> path;
  for (int i = 0; i <= 40; ++i) {
    const double t = i / 40.0;
    path.push_back(middle + app::ClientPoint{(t - 0.5) * width, -height * std::sin(2 * std::numbers::pi * t)});
  }
  return path;
}

app::ClientPoint place(const app::Json& at) { return {*(*at.array())[0].number(), *(*at.array())[1].number()}; }

bool makesSolid(Paper& rig, const document::StackRecipe& recipe) {
  const document::Document document = rig.shared();
  const auto made = pipeline::stackStage(recipe, document.pictures.front()->size);
  return made && mesh::inspect(made.value().mesh).valid();
}

}  // namespace

TEST_CASE("a line drawn across the view is the rail, by each pointer: one step, the solid follows the pen") {
  for (const auto device : {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen}) {
    Paper rig;
    rig.circle(0, 0, 0.15);
    const document::StackRecipe before = layersOf(rig);
    const double steps = rig.undoSteps();
    REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
    CHECK(rig.sheet().flag("drawsRail") == true);
    CHECK(rig.undoSteps() == steps);
    const auto path = wave(rig);
    drag(rig, path, device, false);
    CHECK(rig.state().find("preview")->number("triangles").value_or(0) > 100);
    CHECK(rig.undoSteps() == steps);
    rig.lift(device);
    rig.settle();
    CHECK(rig.undoSteps() == steps + 1);
    CHECK(rig.sheet().flag("drawsRail") == false);
    const document::StackRecipe after = layersOf(rig);
    CHECK(after.planes.size() == before.planes.size());
    CHECK(norm(*stack::centreOf(after.planes[0])) < 0.01);
    REQUIRE(after.rail.points.size() > 3);
    CHECK_FALSE(after.rail.closed);
    CHECK(makesSolid(rig, after));
    // Its ends are where the line's ends were: the sheet stands there when it is taken there.
    for (const auto& [at, end] : {std::pair{"0", path.front()}, {"1", path.back()}}) {
      REQUIRE(rig.works("layer-sheet", std::string(R"({"at": )") + at + "}"));
      CHECK(distance(rig.onCanvas(0, 0), end) < 3);
    }
    REQUIRE(rig.works("undo"));
    CHECK(layersOf(rig) == before);
  }
}

TEST_CASE("a line that comes back to its start is a closed rail, a straight one stays one that grows") {
  Paper rig;
  rig.circle(0, 0, 0.1);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  const app::ClientPoint middle = rig.onCanvas(0, 0);
  std::vector<app::ClientPoint> round, straight;
  for (int i = 0; i <= 60; ++i) {
    const double angle = 2 * std::numbers::pi * i / 60;
    round.push_back(middle + app::ClientPoint{90 * std::cos(angle), 90 * std::sin(angle)});
    straight.push_back(middle + app::ClientPoint{3.0 * i - 90, 1.0 * i - 30});
  }
  drag(rig, round);
  CHECK(layersOf(rig).rail.closed);
  CHECK(makesSolid(rig, layersOf(rig)));
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  drag(rig, straight);
  CHECK(layersOf(rig).rail.points.size() == 2);
  REQUIRE(rig.works("layer-sheet", R"({"at": 1.5})"));
  CHECK(rig.sheetAt() == 1.5);
}

TEST_CASE("over another part the line lies on its surface, so that the two have a common inside") {
  Paper rig;
  rig.circle(0, 0, 0.6);  // a wide pot
  REQUIRE(rig.works("new-part"));
  REQUIRE(rig.works("layers"));
  rig.circle(0.85, 0.85, 0.08);  // beside the pot
  REQUIRE(rig.parts() == 2);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  const app::ClientPoint middle = rig.onCanvas(0, 0);
  std::vector<app::ClientPoint> path;
  for (int i = 0; i <= 30; ++i) path.push_back(middle + app::ClientPoint{i * 1.6 - 24, 10 * std::sin(i * 0.2)});
  drag(rig, path);
  const document::StackRecipe vine = layersOf(rig);
  const document::Document document = rig.shared();
  const document::StackRecipe pot = *document::stackOf(*document.parts.front());
  const auto solid = pipeline::stackStage(pot, document.pictures.front()->size);
  REQUIRE(solid.ok());
  const auto outline = stack::outlineOf(vine.planes.at(0).curves.at(0));
  const double area = std::abs(geometry::signedArea(std::span<const SectionPoint>(outline)));
  const double radius = std::sqrt(area / std::numbers::pi);
  REQUIRE(vine.rail.points.size() > 3);
  const mesh::SurfacePlaces places(solid.value().mesh);
  for (const ModelPoint p : vine.rail.points) {
    const double away = distance(places.nearest(p)->at, p);
    CHECK(away > 0.75 * radius);
    CHECK(away < 0.81 * radius);
  }
  CHECK(makesSolid(rig, vine));
}

TEST_CASE(
    "a line that bends more tightly than the layers are wide becomes wider, with its ends where they were drawn") {
  Paper rig;
  rig.circle(0, 0, 0.3);
  const auto outline = stack::outlineOf(layersOf(rig).planes.at(0).curves.at(0));
  const double radius = std::sqrt(std::abs(geometry::signedArea(std::span<const SectionPoint>(outline))) / 3.1416);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  const auto path = wave(rig, 300, 160);
  drag(rig, path);
  const stack::Rail rail = layersOf(rig).rail;
  REQUIRE(rail.points.size() > 4);
  double tightest = 1e300;
  for (std::size_t i = 1; i + 1 < rail.points.size(); ++i) {
    const ModelPoint a = rail.points[i - 1], b = rail.points[i], c = rail.points[i + 1];
    const double bend = norm(cross(b - a, c - b));
    if (bend > 0) tightest = std::min(tightest, distance(a, b) * distance(b, c) * distance(c, a) / (2 * bend));
  }
  CHECK(tightest > 1.15 * radius);
  REQUIRE(rig.works("layer-sheet", R"({"at": 0})"));
  CHECK(distance(rig.onCanvas(0, 0), path.front()) < 3);
}

TEST_CASE("a closed line that is too small for its layers is as large as they need, and not a point") {
  Paper rig;
  rig.circle(0, 0, 0.5);
  const double half = *rig.sheet().number("half");
  for (const double pixels : {25.0, 60.0}) {
    REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
    const app::ClientPoint middle = rig.onCanvas(0, 0);
    std::vector<app::ClientPoint> round;
    for (int i = 0; i <= 60; ++i) {
      const double angle = 2 * std::numbers::pi * i / 60;
      round.push_back(middle + app::ClientPoint{pixels * std::cos(angle), pixels * std::sin(angle)});
    }
    drag(rig, round);
    const stack::Rail rail = layersOf(rig).rail;
    REQUIRE(rail.closed);
    const ModelPoint across = rail.points[rail.points.size() / 2] - rail.points[0];
    CHECK(norm(across) > 2 * 0.45 * half);
    CHECK(makesSolid(rig, layersOf(rig)));
    REQUIRE(rig.works("undo"));
  }
}

TEST_CASE("layers keep their shares of an open line, and a ring whose last layer is linked with the first opens") {
  Paper rig;
  rig.circle(0, 0, 0.15);
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  rig.circle(-0.4, 0, 0.1);
  rig.circle(0.4, 0, 0.1);
  const document::StackRecipe before = layersOf(rig);
  REQUIRE(before.planes.size() == 2);
  for (const char* points : {"[[0, 0, 0], [0, 300, 0]]", "[[0, 0, 0], [60, 150, 0], [0, 300, 20]]"}) {
    REQUIRE(rig.works("layer-rail", std::string(R"({"points": )") + points + "}"));
    CHECK(layersOf(rig).planes == before.planes);
    CHECK(layersOf(rig).rail.points.back().y == 300);
  }
  REQUIRE(rig.works("layer-rail", R"({"rail": "ring"})"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  std::size_t last = 0;
  const app::Json sheet = rig.sheet();
  const app::Json::Array& links = *sheet.find("links")->array();
  for (std::size_t i = 0; i < links.size(); ++i) {
    if (*(*links[i].find("of")->array())[0].number() == 1) last = i;
  }
  REQUIRE(rig.works("layer-link", R"({"on": false, "link": )" + std::to_string(last) + "}"));
  REQUIRE_FALSE(layersOf(rig).planes[1].links.empty());
  CHECK(rig.works("layer-rail", R"({"rail": "up"})"));
  CHECK(layersOf(rig).planes[1].links.empty());
}

TEST_CASE("the drawing of a rail is for one part: another one that is taken in hand ends it") {
  Paper rig;
  rig.circle(0, 0, 0.2);
  REQUIRE(rig.works("new-part"));
  REQUIRE(rig.works("layers"));
  rig.circle(0.5, 0, 0.1);
  REQUIRE(rig.parts() == 2);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  REQUIRE(rig.works("select-part", R"({"id": 1})"));
  CHECK(rig.sheet().flag("drawsRail") == false);
  REQUIRE(rig.works("layer-up"));
  CHECK(rig.sheet().flag("drawsRail") == false);
  REQUIRE(rig.works("select-part", R"({"id": 2})"));
  CHECK(rig.sheet().flag("drawsRail") == false);
  REQUIRE(rig.works("show-part", R"({"part": 2, "visible": false})"));
  CHECK(rig.fault("layer-rail", R"({"rail": "draw"})") == "StackInvalid");
}

TEST_CASE("a sheet goes on leaning past a level layer, and that of the next part has a lean of its own") {
  Paper rig;
  rig.circle(0, 0, 0.3);
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.6})"));
  REQUIRE(rig.works("layer-lean", R"({"side": 20})"));
  const auto side = [&] { return *rig.sheet().find("lean")->number("side"); };
  REQUIRE(rig.works("layer-sheet", R"({"at": 0})"));
  CHECK(side() == doctest::Approx(0));  // as its layer
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.8})"));
  CHECK(side() == doctest::Approx(20));
  REQUIRE(rig.works("draw-layer", R"({"at": 1, "through": [[40, 0], [0, 40], [-40, 0], [0, -40]]})"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0})"));  // on a level layer, a leaning one is drawn elsewhere by command
  REQUIRE(rig.works("draw-layer", R"({"at": 0.5, "through": [[40, 0], [0, 40], [-40, 0], [0, -40]]})"));
  CHECK(side() == doctest::Approx(20));
  REQUIRE(rig.works("select-part", R"({"id": null})"));  // the sheet of the next part
  CHECK(side() == doctest::Approx(0));
  REQUIRE(rig.works("layer-lean", R"({"front": 10})"));
  CHECK(*rig.sheet().find("lean")->number("front") == doctest::Approx(10));
}

TEST_CASE("layers follow a line with their middle, wherever on the sheet they were drawn") {
  Paper rig;
  rig.circle(0.6, -0.5, 0.1);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  const auto path = wave(rig);
  drag(rig, path);
  const document::StackRecipe recipe = layersOf(rig);
  const app::UiState& ui = rig.app->ui();
  const document::Document document = rig.shared();
  const pipeline::ToWorld toWorld = *app::shownCopies(ui, *document.parts[0], document.pictures[0]->size).begin();
  for (const auto& [at, end] : {std::pair{0.0, path.front()}, {1.0, path.back()}}) {
    stack::Plane plane = recipe.planes.at(0);
    plane.at = at;
    const stack::Stand stand = stack::standOf(plane, recipe.rail).value();
    const auto seen = app::pointOnCanvas(ui.camera, ui.layout.solid, toWorld(stand.at(*stack::centreOf(plane))));
    REQUIRE(seen);
    CHECK(distance(*seen, end) < 3);
  }
}

TEST_CASE("ground on sheets one behind the other lies below its line") {
  Paper rig;
  REQUIRE(rig.works("draw-layer", R"({"at": 0, "line": [[-60, 0], [0, 30], [60, 0]]})"));
  REQUIRE(rig.works("layer-rail", R"({"rail": "deep"})"));
  REQUIRE(rig.works("layer-open-lines", R"({"as": "ground"})"));
  const document::StackRecipe recipe = layersOf(rig);
  const stack::Stand stand = stack::standOf(recipe.planes[0], recipe.rail).value();
  CHECK(stand.y.y == doctest::Approx(1));  // up
  CHECK(stand.x.x == doctest::Approx(1));
  CHECK(recipe.planes[0].curves[0].base < 0);
}

TEST_CASE("Escape and a second press give the drawing of a rail up, a dot is refused with a sentence") {
  Paper rig;
  rig.circle(0, 0, 0.2);
  const document::StackRecipe before = layersOf(rig);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  REQUIRE(rig.works("cancel"));
  CHECK(rig.sheet().flag("drawsRail") == false);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  CHECK(rig.sheet().flag("drawsRail") == false);
  REQUIRE(rig.works("layer-rail", R"({"rail": "draw"})"));
  const app::ClientPoint middle = rig.onCanvas(0, 0);
  drag(rig, {middle, middle + app::ClientPoint{8, 0}, middle + app::ClientPoint{12, 0}});
  CHECK(layersOf(rig) == before);
  CHECK(rig.host.said("draw it across the solid view"));
}

TEST_CASE("the first layer of a part brings all of the solid into the view where it runs out of it") {
  Paper rig({390, 844, 1});
  REQUIRE(rig.works("focus-solid"));
  for (int i = 0; i < 3; ++i) REQUIRE(rig.works("zoom-in"));
  rig.circle(0, 0, 0.2);
  REQUIRE(rig.parts() == 1);
  const app::UiState& ui = rig.app->ui();
  const document::Document document = rig.shared();
  const pipeline::ToWorld toWorld = *app::shownCopies(ui, *document.parts[0], document.pictures[0]->size).begin();
  const stack::Rail rail = layersOf(rig).rail;
  const auto head = app::pointOnCanvas(ui.camera, ui.layout.solid, toWorld(rail.points.back()));
  REQUIRE(head);
  CHECK(ui.solidRoom.contains(*head));
}

TEST_CASE("through the middles nothing that was drawn moves, and repeated layers say what to do first") {
  Paper rig;
  rig.circle(0, 0, 0.3);
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  rig.circle(0.5, 0, 0.3);
  REQUIRE(rig.works("layer-sheet", R"({"at": 1})"));
  rig.circle(0, 0.3, 0.3);
  const document::StackRecipe before = layersOf(rig);
  REQUIRE(before.planes.size() == 3);
  REQUIRE(rig.works("layer-rail", R"({"rail": "middles"})"));
  const document::StackRecipe after = layersOf(rig);
  REQUIRE(after.rail.points.size() == 3);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto was = stack::standOf(before.planes[i], before.rail), is = stack::standOf(after.planes[i], after.rail);
    const SectionPoint old = before.planes[i].curves[0].through[0], now = after.planes[i].curves[0].through[0];
    CHECK(distance(was.value().at(old), is.value().at(now)) < 0.02);  // as far as links round
  }
  CHECK(makesSolid(rig, after));
  REQUIRE(rig.works("undo"));
  REQUIRE(rig.works("layer-repeat", R"({"times": 3})"));
  CHECK(rig.fault("layer-rail", R"({"rail": "middles"})") == "StackInvalid");
}

TEST_CASE("a sheet leans by its knobs, keeps leaning when it is lifted, and so does the layer drawn on it") {
  for (const auto device : {platform::Device::Mouse, platform::Device::Touch, platform::Device::Pen}) {
    Paper rig;
    rig.circle(0, 0, 0.3);
    REQUIRE(rig.works("layer-sheet", R"({"at": 0.8})"));
    const double steps = rig.undoSteps();
    const app::ClientPoint knob = place((*rig.sheet().find("leanKnobs")->array())[1]);
    std::vector<app::ClientPoint> up;
    for (int i = 0; i <= 12; ++i) up.push_back(knob - app::ClientPoint{0, 5.0 * i});
    drag(rig, up, device);
    const double side = *rig.sheet().find("lean")->number("side");
    CHECK(side < -8);  // its left edge is ahead
    CHECK(*rig.sheet().find("lean")->number("front") == doctest::Approx(0));
    CHECK(rig.undoSteps() == steps);  // it lies on no layer
    REQUIRE(rig.works("layer-sheet", R"({"at": 1})"));
    CHECK(*rig.sheet().find("lean")->number("side") == doctest::Approx(side));
    rig.circle(0, 0, 0.3);
    const document::StackRecipe leaning = layersOf(rig);
    REQUIRE(leaning.planes.size() == 2);
    CHECK_FALSE(leaning.planes[1].turn.isRest());
    CHECK(makesSolid(rig, leaning));
    // The layer that is there leans further, in one step.
    const double before = rig.undoSteps();
    REQUIRE(rig.works("layer-lean", R"({"side": 0, "front": 20})"));
    CHECK(rig.undoSteps() == before + 1);
    CHECK(*rig.sheet().find("lean")->number("front") == doctest::Approx(20));
    REQUIRE(rig.works("undo"));
    CHECK(layersOf(rig) == leaning);
    CHECK(rig.fault("layer-lean", R"({"side": 95})") == "ValueOutOfRange");
  }
}

TEST_CASE("the edge that a lean names is ahead along every ready rail") {
  for (const char* rail : {"up", "across", "deep", "ring", "spring"}) {
    Paper rig;
    rig.circle(0, 0, 0.1);
    REQUIRE(rig.works("layer-rail", std::string(R"({"rail": ")") + rail + R"("})"));
    const document::StackRecipe recipe = layersOf(rig);
    app::Sheet sheet = *app::sheetFor(rig.shared(), rig.shared().parts.front()->id, {}, 0.5);
    stack::Plane ahead;
    ahead.at = 0.51;
    const ModelPoint way = stack::standOf(ahead, recipe.rail).value().origin - sheet.stand.origin;
    for (const auto& [lean, edge] : {std::pair{app::Lean{30, 0}, SectionPoint{0, 1}}, {app::Lean{0, 30}, {1, 0}}}) {
      stack::Plane plane;
      plane.at = 0.5;
      plane.turn = app::turnFor(sheet, lean);
      const stack::Stand leant = stack::standOf(plane, recipe.rail).value();
      CHECK_MESSAGE(dot(leant.at(edge) - leant.origin, normalized(way)) > 0.4, rail);
      sheet.turn = plane.turn;
      CHECK(app::leanOf(sheet).front == doctest::Approx(lean.front));
      CHECK(app::leanOf(sheet).side == doctest::Approx(lean.side));
    }
  }
}

TEST_CASE("open lines become ground with one foot, new ones with them, and walls again") {
  Paper rig;
  const auto line = [&](double at, double height) {
    REQUIRE(rig.works("layer-sheet", R"({"at": )" + std::to_string(at) + "}"));
    REQUIRE(rig.works("draw-layer", R"({"line": [[-60, )" + std::to_string(height) + R"(], [0, )" +
                                        std::to_string(height + 20) + R"(], [60, )" + std::to_string(height) + "]]}"));
  };
  line(0, 0);
  CHECK(rig.fault("layer-open-lines", R"({"as": "sea"})") == "ValueOutOfRange");
  REQUIRE(rig.works("layer-rail", R"({"rail": "deep"})"));
  REQUIRE(rig.works("layer-open-lines", R"({"as": "ground"})"));
  line(0.5, 10);
  line(1, -300);  // below that foot
  const document::StackRecipe recipe = layersOf(rig);
  REQUIRE(recipe.planes.size() == 3);
  for (const stack::Plane& plane : recipe.planes) CHECK(plane.curves[0].as == stack::CurveUse::Ground);
  CHECK(recipe.planes[1].curves[0].base == doctest::Approx(recipe.planes[0].curves[0].base));
  CHECK(recipe.planes[2].curves[0].base < -300);
  CHECK(makesSolid(rig, recipe));
  REQUIRE(rig.works("layer-open-lines", R"({"as": "wall"})"));
  for (const stack::Plane& plane : layersOf(rig).planes) {
    CHECK(plane.curves[0].as == stack::CurveUse::Ribbon);
    CHECK(plane.curves[0].width > 0);
  }
}
