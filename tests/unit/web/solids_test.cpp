// Solids on the page, with a solver that does as it is told: what is asked of it, what becomes of its answers.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "tests/unit/web/two_bars.h"

using namespace spineloft;
using app::Json;
using test::Stuck;
using test::TwoBars;

TEST_CASE("what is stuck together is asked for once, and the answer becomes the solid") {
  Stuck rig;
  REQUIRE(rig.asked() == 1);
  const Json request = rig.lastAsked();
  CHECK(request.find("meshes")->array()->size() == 2);
  REQUIRE(rig.host.given.size() == 2);
  for (const platform::SolverMesh& mesh : rig.host.given) {
    CHECK(mesh.vertices > 0);
    CHECK(*std::max_element(mesh.corners, mesh.corners + 3 * mesh.triangles) == mesh.vertices - 1);
    CHECK(std::all_of(mesh.positions, mesh.positions + 3 * mesh.vertices, [](float x) { return std::isfinite(x); }));
    CHECK(std::all_of(mesh.uv, mesh.uv + 2 * mesh.vertices, [](float x) { return x >= 0 && x <= 1; }));
  }
  CHECK(rig.status() == "waiting");
  CHECK(rig.state().flag("busy").value_or(false));
  rig.answer(request);
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
  CHECK(rig.step().number("triangles") == 4);
  CHECK(rig.asked() == 1);
  // One mesh for the faces from each part, none for the parts themselves.
  CHECK(rig.gl->last.meshes.size() == 2);
  const auto stl = rig.app->exportModel("stl");
  CHECK(std::vector<std::uint8_t>(stl.begin(), stl.end()).size() == 84 + 4 * 50);
}

TEST_CASE("a solid one of whose parts changes is made again; the last one stands meanwhile") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  CHECK(rig.run("set-parameter", R"({"part": 2, "key": "ribs", "value": 40})").flag("ok") == true);
  rig.app->wake();
  CHECK(rig.asked() == 2);
  CHECK(rig.step().number("triangles") == 4);
  rig.answer(rig.lastAsked());
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
}

TEST_CASE("undo takes the solid apart, redo has it again without asking") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  rig.run("undo");
  CHECK(rig.state().find("steps")->array()->empty());
  rig.run("redo");
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
  CHECK(rig.asked() == 1);
}

TEST_CASE("a newer request replaces an older one, whose answer comes too late and harms nothing") {
  Stuck rig;
  const Json first = rig.lastAsked();
  rig.run("set-section", R"({"part": 1, "section": "square"})");
  rig.state();
  REQUIRE(rig.asked() == 2);
  const Json second = rig.lastAsked();
  CHECK(first.number("id") != second.number("id"));
  rig.answer(first);
  CHECK(rig.status() == "waiting");
  rig.answer(second, 2);
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
}

TEST_CASE("a part that is deleted while it is put together leaves the other one, and no solid") {
  Stuck rig;
  const Json request = rig.lastAsked();
  rig.run("select-part", R"({"id": 2})");
  rig.run("delete-part");
  CHECK(rig.state().find("steps")->array()->empty());
  rig.answer(request);
  CHECK(rig.settle());
  CHECK(rig.parts() == 1);
  CHECK_FALSE(rig.state().flag("busy").value_or(true));
  CHECK(rig.host.said("Solid 1 needed it: what is left of it stands by itself. Undo brings it back."));
  rig.run("undo");
  rig.settle();
  CHECK(rig.parts() == 2);
  CHECK(rig.state().find("steps")->array()->size() == 1);
}

TEST_CASE("of parts that were stuck together and do not touch it is said that they do not, once; of others nothing") {
  for (const std::uint32_t apart : {1u, 3u}) {
    TwoBars rig;
    rig.stick(R"({"parts": [1, 2]})");
    rig.answer(rig.lastAsked(), 1, false, apart);
    rig.settle();
    CHECK(rig.host.said("Solid 1 is in 3 pieces that do not touch.") == (apart == 3));
    rig.host.sent.clear();
    rig.settle();
    CHECK_FALSE(rig.host.said("pieces that do not touch"));
  }
}

TEST_CASE("of a deleted part it is said what becomes of its solid, unless all of the solid goes") {
  TwoBars rig;
  rig.run("draw-spine", R"({"stroke": [[60, 50], [62, 100], [60, 150]]})");
  rig.run("delete-part");
  CHECK_FALSE(rig.host.said("Undo brings it back."));
  rig.run("undo");
  rig.stick(R"({"parts": [1, 2, 3]})");
  rig.run("delete-part", R"({"id": 3})");
  CHECK(rig.host.said("Solid 1 is made of the rest now. Undo brings it back."));
  rig.host.sent.clear();
  rig.run("select-step", R"({"step": 1})");
  rig.run("delete-step");
  CHECK_FALSE(rig.host.said("Undo brings it back."));
}

TEST_CASE("a file in which a solid is not as it should be is saved with a word about it; a model file needs none") {
  Stuck rig;
  const auto told = [&](const char* format) {
    rig.host.sent.clear();
    CHECK(rig.app->exportModel(format).size() > 0);
    return rig.host.said(R"("level":"warning","text":"In the file, Solid 1 )");
  };
  rig.fail(rig.lastAsked(), *Json::parse(R"({"error":"PartCrossesItself","part":2})"));
  rig.settle();
  REQUIRE(rig.status() == "failed");
  CHECK(told("stl"));
  CHECK(rig.host.said("is there as its parts alone: "));
  CHECK(rig.host.said("Part 2"));
  CHECK_FALSE(told("spineloft"));
  rig.run("check-print");
  CHECK(rig.host.said("Solid 1 is there as its parts alone: "));
  CHECK_FALSE((*rig.state().find("print")->find("lines")->array())[0].flag("good").value_or(true));
  rig.run("solve-again");
  rig.state();
  rig.answer(rig.lastAsked());
  rig.settle();
  CHECK_FALSE(told("stl"));
  rig.run("set-section", R"({"part": 1, "section": "square"})");
  rig.state();
  rig.lost();
  rig.settle();
  CHECK(told("glb"));
  CHECK(rig.host.said("Solid 1 is as it was before: "));
}

TEST_CASE("a wall that was set too thin is set thicker, as tall as the model was, in one step of undo") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  rig.run("scoop-out", R"({"step": 1})");
  rig.state();
  const auto wall = [&] { return *rig.step(1).number("wall"); };
  rig.run("set-step", R"({"step": 2, "wall": 0.002})");
  rig.state();
  REQUIRE(wall() == doctest::Approx(0.002));
  rig.answer(rig.lastAsked(), 0.004f);
  rig.settle();
  rig.run("set-height", R"({"mm": 1})");
  rig.settle();
  rig.run("check-print");
  const Json before = rig.state();
  CHECK(rig.host.said("gives 1 mm to the wall of Solid 2."));
  CHECK(rig.run("thicken").flag("ok") == true);
  CHECK(wall() > 0.002);
  CHECK(rig.state().number("heightMm") == before.number("heightMm"));
  rig.run("undo");
  CHECK(wall() == doctest::Approx(0.002));
}

TEST_CASE("a solver that could not be loaded is told apart from one that died, and one can try again") {
  Stuck rig;
  rig.lost(false);
  CHECK(rig.settle());
  CHECK(*rig.step().text("failure") == "SolverUnreachable");
  CHECK(rig.host.said("could not be loaded. Nothing is lost"));
  rig.run("solve-again");
  rig.state();
  rig.answer(rig.lastAsked());
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
}

TEST_CASE("when the solver dies it is said, the last good solid stays, and one can try again") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  rig.run("set-section", R"({"part": 1, "section": "square"})");
  rig.state();
  rig.lost();
  CHECK(rig.settle());
  CHECK(rig.status() == "failed");
  CHECK(*rig.step().text("failure") == "SolverStopped");
  CHECK(rig.host.said("was interrupted. Nothing is lost"));
  CHECK(rig.step().number("triangles") == 4);
  CHECK(rig.gl->last.meshes.size() == 2);
  const std::size_t before = rig.asked();
  rig.run("solve-again");
  rig.state();
  CHECK(rig.asked() == before + 1);
  rig.answer(rig.lastAsked());
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
}

TEST_CASE("cancelling stops the solver and says so; nothing is asked again by itself") {
  Stuck rig;
  rig.app->cancelWork();
  CHECK(rig.settle());
  CHECK(rig.host.said("stopSolving"));
  CHECK(*rig.step().text("failure") == "Cancelled");
  CHECK(rig.asked() == 1);
  // The parts are all still there, and shown.
  CHECK(rig.gl->last.meshes.size() == 2);
  CHECK(rig.parts() == 2);
}

TEST_CASE("a failure names the part and the place, and every kind of it has a sentence") {
  for (const char* error : {"SolidEmpty", "WallTooThick", "PartCrossesItself", "SolidFailed", "OutOfMemory"}) {
    CAPTURE(error);
    Stuck rig;
    rig.fail(rig.lastAsked(), Json::Object{{"error", error}, {"part", 2}, {"at", Json::Array{0.1, -0.2, 0.3}}});
    CHECK(rig.settle());
    const Json step = rig.step();
    CHECK(*step.text("failure") == error);
    CHECK(step.text("sentence")->size() > 20);
    CHECK(step.number("faulty") == 2);
    REQUIRE(step.find("at")->array()->size() == 3);
    CHECK((*step.find("at")->array())[1].number() == -0.2);
    CHECK(rig.host.said("\"error\""));
    CHECK(rig.asked() == 1);
  }
}

TEST_CASE("a wall that is too thick is told the thickest that fits, in millimetres of the model as it is sized") {
  const auto sentence = [](double thickest, double height) {
    Stuck rig;
    rig.run("set-height", R"({"mm": )" + std::to_string(height) + "}");
    rig.fail(rig.lastAsked(), Json::Object{{"error", "WallTooThick"}, {"part", 1}, {"thickest", thickest}});
    CHECK(rig.settle());
    return *rig.step().text("sentence");
  };
  const auto told = [](const std::string& text) {
    const std::size_t at = text.find("that fits is ");
    return at == std::string::npos ? -1 : std::stod(text.substr(at + 13));
  };
  const double small = told(sentence(0.05, 9)), large = told(sentence(0.05, 90));
  CHECK(small > 0);
  // Rounded down, never to more than fits.
  CHECK(large <= 10 * (small + 0.01));
  CHECK(large > 10 * small - 0.11);
  CHECK(sentence(0, 90).find("No wall fits") != std::string::npos);
}

TEST_CASE("a wall beyond all limits is refused with both of them") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  for (const char* wall : {R"({"wallMm": 5000})", R"({"wallMm": 0.0001})"}) {
    const Json answer = rig.run("set-step", wall);
    CHECK(*answer.text("error") == "ValueOutOfRange");
    CHECK(answer.text("sentence")->find("thick at this size") != std::string::npos);
  }
}

TEST_CASE("while a part that is only stuck together is in hand, it shows itself: the hand waits for no solver") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  rig.run("select-part", R"({"id": 1})");
  rig.run("ribs");
  rig.settle();
  const Json part = (*rig.state().find("parts")->array())[0];
  const Json::Array& ribs = *part.find("ribs")->array();
  const Json::Array& end = *ribs[ribs.size() / 2].find("left")->array();
  const std::size_t before = rig.asked();
  rig.press(*end[0].number(), *end[1].number(), *end[0].number() - 15, *end[1].number());
  for (int i = 0; i < 20; ++i) {
    rig.host.clockMs += 16;
    rig.app->frame();
  }
  CHECK(rig.asked() == before);
  CHECK(rig.gl->last.meshes.size() == 2);
  CHECK(rig.gl->last.meshes[0].mesh->triangles.size() > 100);
  rig.lift();
  rig.state();
  REQUIRE(rig.asked() == before + 1);
  rig.answer(rig.lastAsked());
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
}

TEST_CASE("a round seam follows the hand as a coarse solid") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.run("set-step", R"({"step": 1, "blend": 0.02})");
  rig.state();
  rig.answer(rig.lastAsked());
  rig.settle();
  rig.run("select-part", R"({"id": 1})");
  rig.run("ribs");
  rig.settle();
  const Json part = (*rig.state().find("parts")->array())[0];
  const Json::Array& ribs = *part.find("ribs")->array();
  const Json::Array& end = *ribs[ribs.size() / 2].find("left")->array();
  rig.press(*end[0].number(), *end[1].number(), *end[0].number() - 15, *end[1].number());
  for (int i = 0; i < 20; ++i) {
    rig.host.clockMs += 16;
    rig.app->frame();
  }
  const Json request = rig.lastAsked();
  CHECK(request.find("nodes")->array()->back().flag("coarse").value_or(false));
  rig.answer(request, 0.5);
  rig.app->frame();
  CHECK(rig.gl->last.meshes[0].mesh->triangles.size() == 2);
  rig.lift();
  rig.state();
  const Json fine = rig.lastAsked();
  CHECK_FALSE(fine.find("nodes")->array()->back().flag("coarse").value_or(true));
  rig.answer(fine);
  CHECK(rig.settle());
}

TEST_CASE("a tap on the solid says where it is open, once; a drag, a miss and Esc say nothing") {
  using platform::PointerKind;
  Stuck rig;
  rig.run("delete-part", R"({"id": 2})");
  rig.run("select-part", R"({"id": 1})");
  rig.run("scoop-out", R"({"part": 1, "opening": "none"})");
  rig.settle();
  rig.run("move");
  rig.settle();
  const Json gizmo = *rig.state().find("gizmo");
  const double x = *(*gizmo.find("at")->array())[0].number(), y = *(*gizmo.find("at")->array())[1].number();
  rig.run("draw");
  rig.settle();
  const auto opening = [&] { return *rig.step().text("opening"); };
  const auto pointing = [&] { return rig.state().flag("pointing").value(); };
  REQUIRE(opening() == "none");
  rig.click(x, y);
  CHECK(opening() == "none");
  rig.run("select-step", R"({"id": 1})");

  rig.run("point-opening");
  REQUIRE(pointing());
  rig.key("Escape", "Escape");
  CHECK_FALSE(pointing());

  rig.run("point-opening");
  rig.pointer(PointerKind::Down, x, y);
  for (int i = 1; i <= 5; ++i) rig.pointer(PointerKind::Move, x + 0.1 * i, y + 12 * i);
  rig.pointer(PointerKind::Up, x, y + 60);
  rig.settle();
  CHECK(pointing());
  CHECK(opening() == "none");
  // Back to the front, and a place where nothing is.
  rig.pointer(PointerKind::Down, x, y + 60);
  for (int i = 1; i <= 5; ++i) rig.pointer(PointerKind::Move, x, y + 60 - 12 * i);
  rig.pointer(PointerKind::Up, x, y);
  rig.click(x, 690);
  CHECK(pointing());
  CHECK(opening() == "none");
  rig.click(x, y);
  CHECK_FALSE(pointing());
  CHECK(opening() == "front");

  // Seen from behind it is the back.
  const_cast<app::UiState&>(rig.app->ui()).camera.yaw += std::numbers::pi;
  rig.run("point-opening");
  rig.settle();
  rig.click(x, y);
  CHECK_FALSE(pointing());
  CHECK(opening() == "back");

  // Another solid, or none, is not asked for its opening.
  rig.run("point-opening");
  rig.run("select-step", R"({"id": null})");
  CHECK_FALSE(pointing());
  CHECK_FALSE(rig.run("point-opening").flag("ok").value_or(true));
}

TEST_CASE("a chosen solid is in hand as a whole; who takes another part has left it") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  rig.run("draw-puff", R"({"line": [[20, 20], [60, 20], [60, 60], [20, 60], [20, 21]]})");
  rig.settle();
  const auto chosen = [&] { return rig.state().number("selectedStep"); };
  const auto held = [&] {
    std::vector<double> parts;
    const Json now = rig.state();
    for (const Json& part : *now.find("selected")->array()) parts.push_back(*part.number());
    return parts;
  };
  CHECK_FALSE(chosen());
  CHECK(held() == std::vector<double>{3});

  // What is done next is done to the part in hand, not to the solid that was made before.
  CHECK(rig.run("scoop-out").flag("ok") == true);
  CHECK(*(*rig.step(1).find("operands")->array())[0].number("part") == 3);
  rig.run("undo");

  rig.run("select-step", R"({"id": 1})");
  CHECK(chosen() == 1);
  CHECK(held() == std::vector<double>{1, 2});
  rig.run("move-parts", R"({"mm": [5, 0, 0]})");
  rig.settle();
  const Json state = rig.state();
  const auto& parts = *state.find("parts")->array();
  for (std::size_t i = 0; i < 3; ++i) {
    CHECK(*(*parts[i].find("placement")->find("mm")->array())[0].number() == doctest::Approx(i < 2 ? 5 : 0));
  }
  rig.run("duplicate");
  rig.state();
  CHECK(chosen() == 2);
  CHECK(held() == std::vector<double>{4, 5});
  rig.run("undo");
  rig.run("select-part", R"({"id": 2})");
  rig.run("select-step", R"({"id": 1})");
  rig.run("select-part", R"({"id": 2})");
  rig.state();
  CHECK(chosen() == 1);
  CHECK(held() == std::vector<double>{2});
  rig.run("select-part", R"({"id": 3})");
  rig.state();
  CHECK_FALSE(chosen());
}

TEST_CASE("a part of a solid shows and hides with it, in one step that is seen; what changes nothing is no step") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  const auto steps = [&] { return *rig.state().number("undo"); };
  const auto seen = [&](std::size_t i) { return *(*rig.state().find("parts")->array())[i].flag("visible"); };
  const double before = steps();
  for (const char* same : {R"({"part": 1, "visible": true})", R"({"part": 2, "visible": true})"}) {
    rig.run("show-part", same);
    CHECK(steps() == before);
  }
  rig.run("show-part", R"({"part": 1, "visible": false})");
  CHECK(steps() == before + 1);
  CHECK_FALSE(*rig.step().flag("visible"));
  CHECK_FALSE(seen(0));
  CHECK_FALSE(seen(1));
  rig.run("show-part", R"({"part": 2})");
  CHECK(*rig.step().flag("visible"));
  CHECK(seen(0));
  rig.run("undo");
  rig.run("undo");

  // What was hidden before it became part of the solid is there again in it, and can be taken by a tap.
  rig.run("release", R"({"step": 1})");
  rig.run("show-part", R"({"part": 2, "visible": false})");
  CHECK_FALSE(seen(1));
  rig.run("stick-together", R"({"parts": [1, 2]})");
  rig.settle();
  CHECK(seen(1));
  rig.run("draw");
  const auto p = rig.at(100, 100);
  rig.click(p.x, p.y);
  CHECK(*rig.state().number("selection") == 2);
}

TEST_CASE(
    "what is in hand is what is put together, the first taken first; ticks go before it, of one in hand the other is "
    "meant, and of nothing that is said all that is shown is stuck together") {
  const auto operands = [](TwoBars& rig) {
    std::vector<double> ids;
    const Json step = rig.step();
    for (const Json& one : *step.find("operands")->array()) ids.push_back(*one.number("part"));
    return ids;
  };
  TwoBars rig;
  rig.run("draw-spine", R"({"stroke": [[150, 50], [152, 100], [150, 150]]})");
  rig.settle();
  rig.run("select-part", R"({"id": 3})");
  CHECK(rig.run("cut").text("error") != nullptr);
  rig.run("stick-together");
  CHECK(operands(rig) == std::vector<double>{1, 2, 3});
  rig.run("undo");
  rig.run("select-part", R"({"id": 3})");
  rig.run("show-part", R"({"part": 2, "visible": false})");
  rig.run("stick-together");
  CHECK(operands(rig) == std::vector<double>{1, 3});
  rig.run("undo");
  rig.run("undo");
  rig.run("select-part", R"({"id": 3})");
  rig.tick(2);
  CHECK(rig.run("stick-together").text("error") != nullptr);
  rig.tick(2, false);
  rig.run("select-part", R"({"id": 3})");
  rig.run("select-part", R"({"id": 1, "add": true})");
  rig.run("cut");
  REQUIRE(rig.state().find("steps")->array()->size() == 1);
  CHECK(operands(rig) == std::vector<double>{3, 1});
  rig.run("undo");
  rig.run("select-all");
  rig.run("stick-together");
  CHECK(operands(rig).size() == 3);
  rig.run("undo");
  rig.tick(1);
  rig.tick(2);
  rig.run("select-all");
  rig.run("stick-together");
  CHECK(operands(rig) == std::vector<double>{1, 2});
  // The solid that was made is in hand as a whole: it is one thing, and the part beside it the other.
  rig.run("cut");
  CHECK(rig.step(1).find("operands")->array()->size() == 2);
}

TEST_CASE(
    "while lines are drawn a click takes a part in hand, with shift one more or one less, and beside them nothing "
    "changes") {
  TwoBars rig;
  rig.run("draw-spine", R"({"stroke": [[180, 50], [181, 100], [180, 150]]})");
  rig.settle();
  const auto click = [&](double x, double y, int modifiers) {
    using platform::PointerKind;
    const auto p = rig.at(x, y);
    for (const PointerKind kind : {PointerKind::Down, PointerKind::Up}) {
      rig.app->pointer({kind, 1, platform::Device::Mouse, 0, kind == PointerKind::Down ? 1 : 0, p.x, p.y, 0.5,
                        rig.host.clockMs, modifiers});
    }
    rig.settle();
    std::vector<double> ids;
    const Json state = rig.state();
    for (const Json& id : *state.find("selected")->array()) ids.push_back(*id.number());
    return ids;
  };
  CHECK(click(180.2, 60, 0) == std::vector<double>{3});
  const std::vector<double> both = click(100, 60, platform::kShift);
  CHECK(both.size() == 2);
  CHECK(both.back() == 3);
  CHECK(click(20, 60, platform::kShift) == both);
  CHECK(click(180.2, 60, platform::kShift).size() == 1);
  CHECK(click(180.2, 60, 0) == std::vector<double>{3});
}

TEST_CASE("commands about a part, a solid or parts may name what is not selected") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.settle();
  const auto well = [&](const char* id, const char* args) {
    rig.run("select-step", R"({"id": null})");
    rig.run("select-part", R"({"id": null})");
    rig.state();
    const Json answer = rig.run(id, args);
    CHECK_MESSAGE(answer.flag("ok") == true, id, args);
    rig.state();
  };
  rig.run("draw-puff", R"({"line": [[20, 20], [60, 20], [60, 60], [20, 60], [20, 21]]})");
  well("thicker", R"({"part": 3})");
  well("move-outline-point", R"({"part": 3, "point": 0, "to": [22, 22]})");
  well("make-sheet", R"({"part": 3})");
  well("set-step", R"({"step": 1, "blend": 0.01})");
  well("scoop-out", R"({"part": 3})");
  well("scoop-out", R"({"step": 1})");
  well("release", R"({"step": 3})");
  well("release", R"({"step": 2})");
  well("release", R"({"step": 1})");
  well("group", R"({"parts": [1, 2]})");
  well("rename-group", R"({"group": 1, "name": "Both"})");
  well("ungroup", R"({"part": 1})");
}

TEST_CASE("the solver hears which part of a solid is chosen, once, and when none is") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  const auto told = [&](std::string_view part) {
    const std::string json = R"({"type":"expectEdit","part":)" + std::string(part) + "}";
    return std::ranges::count(rig.host.sent, json);
  };
  const auto before = told("1");
  rig.run("select-part", R"({"id": 1})");
  rig.state();
  CHECK(told("1") == before + 1);
  rig.state();
  CHECK(told("1") == before + 1);
  rig.run("release");
  rig.state();
  CHECK(told("null") >= 1);
}
