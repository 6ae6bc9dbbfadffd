// What goes along a bone or a rail: slices that are copied from part to part, and the view.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/stack/stand.h"
#include "tests/unit/web/layer_paper.h"

using namespace spineloft;
using test::layersOf;
using test::Paper;
using test::Rig;

namespace {

/// Two round layers, the upper one smaller.
void cone(Paper& rig) {
  rig.circle(0, 0, 0.4);
  REQUIRE(rig.works("layer-sheet", R"({"at": 1})"));
  rig.circle(0, 0, 0.2);
}

std::vector<loft::SectionKey> sectionsOf(Rig& rig, std::size_t part) {
  const document::Document document = rig.shared();
  REQUIRE(document.parts.size() > part);
  return document::loftIn(*document.parts[part]).loft.sections;
}

bool offers(Rig& rig, std::string_view id) {
  const app::Json commands = *app::Json::parse(rig.app->commands());
  for (const app::Json& command : *commands.array()) {
    if (*command.text("id") == id) return command.flag("enabled") == true;
  }
  return false;
}

}  // namespace

TEST_CASE("copied layers begin a part of their own, beside the one they are of: one step") {
  Paper rig;
  cone(rig);
  const document::StackRecipe from = layersOf(rig);
  CHECK_FALSE(offers(rig, "paste-slices"));
  REQUIRE(rig.works("copy-slices"));
  CHECK(rig.host.said("Slices copied"));
  REQUIRE(rig.works("new-part"));
  REQUIRE(rig.works("layers"));
  REQUIRE(offers(rig, "paste-slices"));
  const double steps = rig.undoSteps();
  REQUIRE(rig.works("paste-slices"));
  CHECK(rig.undoSteps() == steps + 1);
  REQUIRE(rig.parts() == 2);
  const document::StackRecipe made = layersOf(rig);
  CHECK(made.planes == from.planes);
  REQUIRE(made.rail.points.size() == from.rail.points.size());
  const ModelPoint beside = made.rail.points[0] - from.rail.points[0];
  CHECK(beside.x > 60);
  CHECK(distance(made.rail.points[1] - from.rail.points[1], beside) < 1e-6);
  REQUIRE(rig.works("undo"));
  CHECK(rig.parts() == 1);
}

TEST_CASE("a traced part becomes layers, and layers the slices of a traced part") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  REQUIRE(rig.works("copy-slices"));
  REQUIRE(rig.works("layers"));
  REQUIRE(rig.works("paste-slices"));
  REQUIRE(rig.parts() == 2);
  const document::StackRecipe bar = layersOf(rig);
  REQUIRE(bar.planes.size() >= 2);
  // The bar is 41 pixels wide, and its bone goes along most of its 141.
  double most = 0;
  for (const SectionPoint p : stack::outlineOf(bar.planes[bar.planes.size() / 2].curves.front())) {
    most = std::max(most, std::abs(p.x));
  }
  CHECK(most == doctest::Approx(20.5).epsilon(0.1));
  CHECK(stack::lengthOf(bar.rail) > 90);
  CHECK(stack::lengthOf(bar.rail) < 150);

  REQUIRE(
      rig.works("draw-layer", R"({"at": 0.5, "through": [[-20, -8], [20, -8], [20, 8], [-20, 8]], "corners": true})"));
  const std::size_t layers = layersOf(rig).planes.size();
  REQUIRE(rig.works("copy-slices"));
  const std::string bone = std::to_string(*(*rig.state().find("parts")->array())[0].number("id"));
  REQUIRE(rig.works("paste-slices", R"({"part": )" + bone.substr(0, bone.find('.')) + "}"));
  const auto keys = sectionsOf(rig, 0);
  CHECK(keys.size() == layers);
  CHECK(std::ranges::is_sorted(keys, {}, &loft::SectionKey::at));
  REQUIRE(rig.works("undo"));
  CHECK(sectionsOf(rig, 0).size() == 1);
}

TEST_CASE("slices go from bone to bone as they are, and nowhere where there is no bone and no rail") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  REQUIRE(rig.works("set-slices",
                    R"({"slices": [{"at": 0.2, "slice": "square"}, {"at": 0.9, "slice": "star", "blend": "ease"}]})"));
  const auto from = sectionsOf(rig, 0);
  REQUIRE(from.size() == 2);
  REQUIRE(rig.works("copy-slices"));
  REQUIRE(rig.works("new-part"));
  CHECK_FALSE(offers(rig, "paste-slices"));
  CHECK(rig.fault("paste-slices", "{}") == "NotNow");
  rig.press(95, 45, 95, 150);
  rig.lift();
  rig.settle();
  REQUIRE(rig.works("paste-slices"));
  CHECK(sectionsOf(rig, 1) == from);
}

TEST_CASE("the view flies along a part in six seconds and comes back; a press ends it, less motion forbids it") {
  Paper rig;
  cone(rig);
  const auto yaw = [&] { return *rig.state().find("camera")->number("yaw"); };
  const double before = yaw();
  REQUIRE(rig.run("fly-along").flag("ok") == true);
  double farthest = 0;
  const double start = rig.host.clockMs;
  while (!rig.app->idle() && rig.host.clockMs < start + 10000) {
    rig.host.clockMs += 50;
    rig.app->frame();
    farthest = std::max(farthest, std::abs(yaw() - before));
  }
  CHECK(rig.host.clockMs - start > 5900);
  CHECK(rig.host.clockMs - start < 6500);
  CHECK(farthest > 0.2);
  CHECK(yaw() == before);

  const auto fliesOn = [&] {
    REQUIRE(rig.run("fly-along").flag("ok") == true);
    for (int i = 0; i < 40; ++i) {
      rig.host.clockMs += 50;
      rig.app->frame();
    }
    return std::abs(yaw() - before) > 0.2;
  };
  CHECK(fliesOn());
  REQUIRE(rig.works("fly-along"));  // once more: it ends where it began
  CHECK(yaw() == before);
  CHECK(fliesOn());
  const double selected = *rig.state().number("selection");
  rig.click(750, 420);
  CHECK(rig.app->idle());
  CHECK(*rig.state().number("selection") == selected);

  rig.host.reduced = true;
  const double now = yaw();
  CHECK(rig.fault("fly-along", "{}") == "NotNow");
  CHECK(yaw() == now);
}

TEST_CASE("a layer off the line stands anywhere: moved by numbers and by its knob, leant right over, and put back") {
  Paper rig;
  cone(rig);
  REQUIRE(rig.works("layer-sheet", R"({"at": 1})"));
  const document::StackRecipe on = layersOf(rig);
  const double steps = rig.undoSteps();
  REQUIRE(rig.works("layer-free"));
  CHECK(rig.undoSteps() == steps + 1);
  CHECK(rig.sheet().flag("free") == true);
  // It stays where it was, in space.
  const document::StackRecipe freed = layersOf(rig);
  REQUIRE(freed.planes[1].origin);
  const auto before = stack::standOf(on.planes[1], on.rail), after = stack::standOf(freed.planes[1], freed.rail);
  CHECK(distance(before.value().origin, after.value().origin) < 1e-6);
  CHECK(distance(before.value().x, after.value().x) < 1e-6);
  CHECK(distance(before.value().y, after.value().y) < 1e-6);

  REQUIRE(rig.works("layer-free", R"({"side": 60, "ahead": -20})"));
  const ModelPoint moved = *layersOf(rig).planes[1].origin;
  CHECK(distance(moved, before.value().origin + ModelPoint{60, -20, 0}) < 1e-6);  // up is along the rail here
  REQUIRE(rig.works("layer-lean", R"({"side": -90})"));
  const auto leant = stack::standOf(layersOf(rig).planes[1], {});
  CHECK(distance(leant.value().origin, moved) < 1e-6);
  CHECK(std::abs(leant.value().normal().x) == doctest::Approx(1));
  CHECK(rig.fault("layer-lean", R"({"front": 95})") == "ValueOutOfRange");

  // Its knob takes it square to itself.
  const auto knob = [&] {
    const app::Json::Array at = *rig.sheet().find("knob")->array();
    return app::ClientPoint{*at[0].number(), *at[1].number()};
  };
  const app::ClientPoint from = knob();
  using platform::PointerKind;
  rig.pointer(PointerKind::Down, from.x, from.y);
  for (int i = 1; i <= 10; ++i) rig.pointer(PointerKind::Move, from.x + 4 * i, from.y);
  rig.lastX = from.x + 40;
  rig.lastY = from.y;
  CHECK(layersOf(rig).planes[1].origin == moved);
  rig.lift();
  rig.settle();
  const ModelPoint dragged = *layersOf(rig).planes[1].origin;
  CHECK(distance(dragged, moved) > 5);
  CHECK(norm(cross(dragged - moved, leant.value().normal())) < 1e-6);

  REQUIRE(rig.works("layer-free", R"({"on": false})"));
  CHECK_FALSE(layersOf(rig).planes[1].origin);
  CHECK(layersOf(rig).planes[1].at == on.planes[1].at);
  for (int i = 0; i < 5; ++i) REQUIRE(rig.works("undo"));
  CHECK(layersOf(rig) == on);
  CHECK(offers(rig, "layer-free"));
  REQUIRE(rig.works("layer-rail", R"({"rail": "ring"})"));
  CHECK(rig.fault("layer-free", "{}") == "NotNow");
}

TEST_CASE("a layer that leans and is turned comes back to the line as it was, and its lean stays its own") {
  Paper rig;
  cone(rig);
  REQUIRE(rig.works("layer-lean", R"({"front": 20, "side": -30})"));
  const document::StackRecipe on = layersOf(rig);
  REQUIRE(rig.works("layer-free"));
  REQUIRE(rig.works("layer-free"));
  const auto before = stack::standOf(on.planes[1], on.rail);
  const auto after = stack::standOf(layersOf(rig).planes[1], on.rail);
  CHECK(distance(before.value().x, after.value().x) < 1e-6);
  CHECK(distance(before.value().y, after.value().y) < 1e-6);

  REQUIRE(rig.works("layer-free"));
  REQUIRE(rig.works("layer-lean", R"({"side": 150})"));
  REQUIRE(rig.works("layer-sheet", R"({"at": 0.5})"));
  CHECK(std::abs(*rig.sheet().find("lean")->number("side")) <= 80);
  // Round a ring all layers stand on the line again.
  REQUIRE(rig.works("layer-rail", R"({"rail": "ring"})"));
  for (const stack::Plane& plane : layersOf(rig).planes) CHECK_FALSE(plane.origin);
}

TEST_CASE("repeated layers stay on their line") {
  Paper rig;
  cone(rig);
  REQUIRE(rig.works("layer-repeat", R"({"times": 3})"));
  CHECK_FALSE(offers(rig, "layer-free"));
  REQUIRE(rig.works("copy-slices"));
  const document::StackRecipe from = layersOf(rig);
  REQUIRE(rig.works("new-part"));
  REQUIRE(rig.works("layers"));
  REQUIRE(rig.works("paste-slices"));
  CHECK(layersOf(rig).planes == from.planes);
  CHECK(layersOf(rig).stack.patterns == from.stack.patterns);
}
