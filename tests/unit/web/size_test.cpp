// How tall: typed, picked from things, and seen beside the solid.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "tests/unit/web/longer_words.h"
#include "tests/unit/web/rig.h"
#include "web/model/print_report.h"
#include "web/model/thickening.h"
#include "web/ui/sizing.h"

using namespace spineloft;
using spineloft::test::Rig;
using spineloft::test::Speaking;

TEST_CASE("what people type about a height is understood, and what they read can be typed again") {
  CHECK(app::millimetresFrom("4") == 40.0);
  CHECK(app::millimetresFrom("4 cm") == 40.0);
  CHECK(app::millimetresFrom("40mm") == 40.0);
  CHECK(app::millimetresFrom("1,5 m") == 1500.0);
  for (const char* nonsense : {"", "cm", "tall", "4 inches", "nan", "1e999", "4 5"}) {
    CHECK_FALSE(app::millimetresFrom(nonsense));
  }
  CHECK(app::spokenLength(40) == "4 cm");
  CHECK(app::spokenLength(8) == "8 mm");
  CHECK(app::spokenLength(1200) == "1.2 m");
  for (double mm = 1.02; mm < 10000; mm *= 1.37) {
    const auto again = app::millimetresFrom(app::spokenLength(mm));
    REQUIRE(again);
    CHECK(std::abs(*again - mm) <= std::max(0.005, mm * 1e-4));
  }
}

namespace {

/// Says centimetres in Arabic, and nothing else.
class ArabicLengths final : public words::Source {
 public:
  std::string translated(std::string_view english, std::string_view) override {
    return english == "{n} cm" ? "1 سم" : std::string();
  }
  std::string drawn(std::string_view text) override { return std::string(text); }
};

}  // namespace

TEST_CASE("a unit is understood as the page says it and in Latin letters") {
  ArabicLengths arabic;
  const Speaking speaking({"ar", true, &arabic});
  CHECK(app::millimetresFrom("12,5 سم") == 125.0);
  CHECK(app::millimetresFrom("12.5cm") == 125.0);
  CHECK(app::millimetresFrom("8 mm") == 8.0);
  CHECK_FALSE(app::millimetresFrom("8 مم"));
}

TEST_CASE("every thing is drawn as tall and as wide as it is") {
  for (std::size_t i = 0; i < app::things().size(); ++i) {
    const app::Thing& thing = app::things()[i];
    double low = 1, high = 0, left = 0, right = 0;
    for (const auto& line : app::thingLines(i)) {
      for (const app::ThingPoint p : line) {
        low = std::min(low, p.y), high = std::max(high, p.y);
        left = std::min(left, p.x), right = std::max(right, p.x);
      }
    }
    CHECK(low == doctest::Approx(0));
    CHECK(high == doctest::Approx(1).epsilon(0.02));
    CHECK(right - left == doctest::Approx(thing.width).epsilon(0.06));
  }
}

TEST_CASE("a thing stands beside the solid on its ground, in true proportion, from wherever one looks") {
  const pipeline::WorldBounds bounds{{-0.2, -0.1, -0.4}, {0.3, 0.5, 0.1}};
  for (const double yaw : {0.0, 0.7, 1.6, 3.0, -2.0}) {
    app::Camera camera;
    camera.yaw = yaw;
    camera.pitch = 0.3;
    for (const app::Thing& thing : app::things()) {
      const app::ThingPlace place = app::placeBeside(thing, bounds, 120, camera);
      CHECK(place.at({0, 0}).y == doctest::Approx(bounds.low.y));
      CHECK(place.at({0, 1}).y - bounds.low.y == doctest::Approx(0.6 * thing.mm / 120));
      // Its right side lies left of every corner of the model.
      const double edge = dot(place.at({thing.width / 2, 0}), place.right);
      for (const double x : {bounds.low.x, bounds.high.x}) {
        for (const double z : {bounds.low.z, bounds.high.z}) {
          CHECK(edge < dot(WorldPoint{x, bounds.low.y, z}, place.right));
        }
      }
    }
  }
}

TEST_CASE("a height that no model can have is refused with those that it can have") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  for (const char* bad : {R"({"typed":"0"})", R"({"typed":"-4 cm"})", R"({"typed":"0.5 mm"})", R"({"mm":11000})"}) {
    const app::Json answer = rig.run("set-height", bad);
    CHECK_MESSAGE(*answer.text("error") == "ValueOutOfRange", bad);
    CHECK(answer.text("sentence")->find("from 1 mm to 10 m") != std::string::npos);
  }
}

TEST_CASE("the check for printing says how small a small model is") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  rig.run("set-height", R"({"mm":1})");
  rig.run("check-print");
  const app::Json state = rig.state();
  const auto& lines = *state.find("print")->find("lines")->array();
  const std::string& size = *lines[1].text("text");
  CHECK_MESSAGE(size.find("× 1 mm") != std::string::npos, size);
  CHECK_MESSAGE(size.find(" 0 ") == std::string::npos, size);
  const std::string& thin = *lines[2].text("text");
  CHECK_MESSAGE(thin.find("0.8 mm;") == std::string::npos, thin);
}

TEST_CASE("a flat piece that is too thin is set thicker and the model as tall as it was; then it can be printed") {
  Rig rig;
  rig.openBar();
  rig.run("draw-sheet", R"({"contours":[[[4,4],[196,4],[196,196],[4,196]]]})");
  rig.run("set-parameter", R"({"part":1,"key":"thickness","value":0.002})");
  rig.settle();
  rig.run("check-print");
  const app::Json before = rig.state();
  const app::Json& line = (*before.find("print")->find("lines")->array())[2];
  CHECK(line.flag("good") == false);
  CHECK_MESSAGE(line.text("text")->find("gives 1 mm to Part 1.") != std::string::npos, *line.text("text"));
  CHECK(rig.run("thicken").flag("ok") == true);
  rig.settle();
  CHECK(rig.state().number("heightMm") == before.number("heightMm"));
  rig.run("check-print");
  // Thicknesses have whole steps: the next one above a millimetre.
  const double thinnest = rig.state().find("print")->number("thinnest").value_or(0);
  CHECK(thinnest > 0.999);
  CHECK(thinnest < 1.25);
  CHECK((*rig.state().find("print")->find("lines")->array())[2].flag("good") == true);
  rig.run("undo");
  CHECK(rig.state().number("heightMm") == before.number("heightMm"));
}

TEST_CASE("a flat piece that cuts a slit is as thin as the slit and stays so; hidden ones are nobody's matter") {
  document::Document document;
  document::Part part;
  document::ExtrudeRecipe recipe;
  recipe.extrude.thickness = 0.004;
  part.recipe = recipe;
  for (const std::uint32_t id : {1u, 2u}) {
    part.id = PartId{id};
    part.name = "Part " + std::to_string(id);
    document.parts.push_back(part);
  }
  const auto thin = [&] { return app::spokenList(app::thickenings(document, 100)); };
  CHECK(thin() == "Part 1 and Part 2");
  CHECK(app::thickenings(document, 1000).empty());
  part.visible = false;
  document.parts[1] = part;
  CHECK(thin() == "Part 1");
  document::Step step;
  step.id = StepId{1};
  step.kind = document::StepKind::Cut;
  step.operands = {{PartId{2}, {}}, {PartId{1}, {}}};
  document.steps.push_back(step);
  CHECK(thin() == "Part 2");  // in a solid it shows as the whole does
  step.visible = false;
  document.steps[0] = step;
  CHECK(thin().empty());
}

TEST_CASE("what no printer would take when it is made thick enough is not made larger, and it is said what to do") {
  printing::PrintCheck check;
  check.thinnest = 0.1;
  const auto wall = [&] { return app::printLines({check, {}})[2]; };
  CHECK(wall().fix.empty());
  CHECK_MESSAGE(wall().text.find("fits no common printer") != std::string::npos, wall().text);
  check.enlargingHelps = true;
  CHECK(wall().fix == "thicken");
}

TEST_CASE("a thing that is picked gives its height, stands beside the solid, and goes again") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  CHECK(rig.run("size-like", R"({"thing":"cupcake"})").flag("ok") == true);
  rig.settle();
  CHECK(rig.state().number("heightMm") == 70);
  CHECK(*rig.state().text("beside") == "cupcake");
  rig.run("set-height", R"({"mm":300})");
  rig.settle();
  CHECK(*rig.state().text("beside") == "cupcake");
  CHECK(rig.run("show-beside", R"({"thing":"none"})").flag("ok") == true);
  CHECK(rig.state().text("beside") == nullptr);
  CHECK(*rig.run("show-beside", R"({"thing":"whale"})").text("error") == "ValueOutOfRange");
  CHECK(*rig.run("size-like").text("error") == "ArgumentMissing");
  rig.run("undo");
  rig.run("undo");
  CHECK(rig.state().number("heightMm") == 100);
}

TEST_CASE("a flat foot is a live cut with a block, one step, and refused where it makes no sense") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  const double undo = *rig.state().number("undo");
  CHECK(rig.run("flat-foot", R"({"mm":4})").flag("ok") == true);
  rig.settle();
  const app::Json state = rig.state();
  REQUIRE(rig.parts() == 2);
  CHECK(*state.find("parts")->array()->back().text("name") == "Foot");
  CHECK(*state.find("parts")->array()->back().text("kind") == "sheet");
  CHECK(state.number("undo") == undo + 1);
  // Its upper side is 4 mm above the ground: its middle lies half its thickness lower.
  const app::Json& foot = state.find("parts")->array()->back();
  const app::Json& place = *foot.find("placement");
  const double scale = *place.number("scale");
  const double top =
      *(*place.find("move")->array())[1].number() + scale * *foot.find("parameters")->number("thickness") / 2;
  CHECK(top > -0.5);
  CHECK(top < 0);  // the bar reaches from about −0.36 to 0.35 of the picture's side
  CHECK(top == doctest::Approx(-0.35 + 0.71 * 0.04).epsilon(0.1));
  rig.run("undo");
  CHECK(rig.parts() == 1);
  for (const char* bad : {R"({"mm":0})", R"({"mm":-2})", R"({"mm":90})"}) {
    CHECK(*rig.run("flat-foot", bad).text("error") == "ValueOutOfRange");
  }
  CHECK(rig.parts() == 1);
}
