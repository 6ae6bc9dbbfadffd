// What a first visit meets: few commands in a menu, settings that act on all that is chosen, parts that lie on what
// they are drawn over, sides that are guessed from the picture, and lines that miss their thing.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"
#include "tests/unit/web/two_bars.h"
#include "web/edit/depth_order.h"
#include "web/edit/placing.h"
#include "web/model/spoken_length.h"

using namespace spineloft;
using spineloft::test::Rig;
using spineloft::test::TwoBars;

namespace {

app::Json part(Rig& rig, std::size_t i) {
  const app::Json state = rig.state();
  return (*state.find("parts")->array())[i];
}

double steps(Rig& rig) { return *rig.state().number("undo"); }

/// What the last toast offers to run; empty: it offers nothing.
std::string offered(const Rig& rig) {
  for (auto sent = rig.host.sent.rbegin(); sent != rig.host.sent.rend(); ++sent) {
    const auto event = app::Json::parse(*sent);
    if (!event || *event->text("type") != "toast") continue;
    const app::Json* offer = event->find("offer");
    return offer ? *offer->text("command") : std::string();
  }
  return {};
}

/// A square of this half side about a point, as a line to draw.
std::string square(double x, double y, double half) {
  const auto n = [](double v) { return std::to_string(v); };
  const std::string l = n(x - half), r = n(x + half), t = n(y - half), b = n(y + half);
  return "[[" + l + "," + t + "],[" + r + "," + t + "],[" + r + "," + b + "],[" + l + "," + b + "],[" + l + "," + t +
         "]]";
}

}  // namespace

TEST_CASE("the menu offers few commands, each under a heading, and none that only programs can give") {
  std::size_t offered = 0;
  for (const app::Command& command : app::commandTable()) {
    if (command.menu.empty()) continue;
    ++offered;
    CAPTURE(std::string_view(command.id));
    CHECK((command.argument.key.empty() || command.argument.choices != nullptr));
  }
  CHECK(offered > 0);
  CHECK(offered <= app::kMostInMenu);
}

TEST_CASE("a setting acts on all parts in hand as one step and says on how many; a part that is named stands alone") {
  struct Setting {
    const char *id, *args, *key, *value;
  };
  constexpr Setting kSettings[] = {
      {"set-colour", R"({"colour": "#3355aa"})", "colour", "#3355aa"},
      {"set-paint", R"({"paint": "glaze"})", "paint", "glaze"},
      {"set-section", R"({"section": "star"})", "section", "star"},
  };
  for (const Setting& setting : kSettings) {
    CAPTURE(setting.id);
    TwoBars page;
    page.run("select-all");
    const double before = steps(page);
    CHECK(page.run(setting.id, setting.args).flag("ok") == true);
    CHECK(steps(page) == before + 1);
    for (std::size_t i = 0; i < 2; ++i) CHECK(*part(page, i).text(setting.key) == setting.value);
    CHECK(page.host.said("Set on 2 parts."));
    page.run("undo");
    for (std::size_t i = 0; i < 2; ++i) CHECK(*part(page, i).text(setting.key) != setting.value);
    page.run("select-all");
    std::string named(setting.args);
    named.insert(1, R"("part": 1, )");
    CHECK(page.run(setting.id, named).flag("ok") == true);
    CHECK(*part(page, 0).text(setting.key) == setting.value);
    CHECK(*part(page, 1).text(setting.key) != setting.value);
  }
}

TEST_CASE("ends that are set on several parts keep what was not set, each its own") {
  TwoBars page;
  page.run("set-caps", R"({"part": 1, "start": "flat"})");
  page.run("set-caps", R"({"part": 2, "start": "pointed"})");
  page.run("select-all");
  CHECK(page.run("set-caps", R"({"end": "open"})").flag("ok") == true);
  CHECK(*part(page, 0).find("caps")->text("start") == "flat");
  CHECK(*part(page, 1).find("caps")->text("start") == "pointed");
  for (std::size_t i = 0; i < 2; ++i) CHECK(*part(page, i).find("caps")->text("end") == "open");
}

TEST_CASE("settings of lofts leave a puff beside them as it is, and those of puffs a loft") {
  Rig page;
  page.openBar();
  page.drawBar();
  page.run("draw-puff", R"({"line": )" + square(40, 100, 20) + "}");
  page.settle();
  page.run("select-all");
  CHECK(page.run("set-section", R"({"section": "gear"})").flag("ok") == true);
  CHECK(*part(page, 0).text("section") == "gear");
  CHECK(*part(page, 1).text("kind") == "puff");
  page.run("select-part", R"({"id": 2})");
  page.run("select-part", R"({"id": 1, "add": true})");
  CHECK(page.run("puff-front").flag("ok") == true);
  CHECK(*part(page, 0).text("kind") == "loft");
}

TEST_CASE("a new model starts from the defaults, whatever the last one was made of") {
  Rig page;
  page.openBar();
  page.drawBar();
  const app::Json first = part(page, 0);
  page.run("set-paint", R"({"paint": "glaze"})");
  page.run("set-caps", R"({"both": "flat"})");
  page.run("set-section", R"({"section": "star"})");
  page.run("new-part");
  CHECK(app::Json::parse(page.app->restore("", "[]"))->flag("ok") == true);
  page.openBar();
  page.drawBar();
  const app::Json next = part(page, 0);
  for (const char* key : {"section", "paint", "colour"}) CHECK(*next.text(key) == *first.text(key));
  CHECK(next.flag("textured") == first.flag("textured"));
  CHECK(*next.find("caps")->text("start") == *first.find("caps")->text("start"));
}

TEST_CASE("what would disappear in the part that it is drawn over lies on it, and can lie inside or behind it") {
  Rig page;
  page.openBar();
  CHECK(page.run("draw-puff", R"({"line": )" + square(100, 100, 60) + "}").flag("ok") == true);
  page.settle();
  CHECK(page.run("draw-puff", R"({"lie": true, "line": )" + square(110, 95, 15) + "}").flag("ok") == true);
  page.settle();
  const auto depth = [&] { return *(*part(page, 1).find("placement")->find("move")->array())[2].number(); };
  const auto isOn = [&](const char* id) {
    const app::Json table = *app::Json::parse(page.app->commands());
    for (const app::Json& row : *table.array()) {
      if (*row.text("id") == id) return *row.flag("toggled");
    }
    return false;
  };
  const double front = depth();
  CHECK(front > 0);
  CHECK(isOn("in-front"));
  // Drawn as deep as everything else, it does not move.
  CHECK(page.run("inside").flag("ok") == true);
  page.settle();
  CHECK(depth() == doctest::Approx(0).epsilon(1e-9));
  CHECK(isOn("inside"));
  CHECK(page.run("behind").flag("ok") == true);
  page.settle();
  CHECK(depth() == doctest::Approx(-front).epsilon(0.02));  // both puffs are alike in front and behind
  CHECK(page.run("in-front").flag("ok") == true);
  page.settle();
  CHECK(depth() == doctest::Approx(front).epsilon(1e-6));
  // It is new for as long as nothing else was done.
  page.run("set-colour", R"({"colour": "#3355aa"})");
  page.settle();
  CHECK_FALSE(isOn("in-front"));
}

TEST_CASE("a part that stands beside the others, or reaches out of them, stays as deep as it was drawn") {
  Rig page;
  page.openBar();
  page.run("draw-puff", R"({"line": )" + square(60, 100, 40) + "}");
  page.settle();
  for (const double x : {160.0, 110.0}) {
    CHECK(page.run("draw-puff", R"({"lie": true, "line": )" + square(x, 100, 20) + "}").flag("ok") == true);
    page.settle();
    const std::size_t last = page.parts() - 1;
    CHECK(*(*part(page, last).find("placement")->find("move")->array())[2].number() == 0);
  }
}

TEST_CASE("the other side is left and right of what is alike there, and front and back of what lies on a thing") {
  const auto axisOf = [](double x, double y, double half, bool lies) {
    Rig page;
    page.openBar();
    page.run("draw-puff", R"({"line": )" + square(100, 100, 50) + "}");
    page.settle();
    page.run("draw-puff",
             std::string(R"({"lie": )") + (lies ? "true" : "false") + R"(, "line": )" + square(x, y, half) + "}");
    page.settle();
    CHECK(page.run("symmetry").flag("ok") == true);
    page.settle();
    const app::Json plane = *part(page, 1).find("mirror");
    const app::Json::Array& numbers = *plane.array();
    return std::abs(*numbers[3].number()) > 0.5 ? 'x' : std::abs(*numbers[5].number()) > 0.5 ? 'z' : 'y';
  };
  CHECK(axisOf(40, 50, 12, false) == 'x');   // an ear
  CHECK(axisOf(160, 50, 12, false) == 'x');  // the other one
  CHECK(axisOf(100, 100, 20, true) == 'z');  // a wing, drawn on the middle
}

TEST_CASE("a pen that closes an outline hands over to the line tool; two open lines do not") {
  const auto toolAfter = [](double turn) {
    Rig page;
    page.run("new-sketch");
    page.settle();
    for (int i = 0; i <= 40; ++i) {
      const double angle = turn * i / 40;
      const auto p = page.at(380 + 180 * std::cos(angle), 400 + 180 * std::sin(angle));
      page.pointer(i == 0 ? platform::PointerKind::Down : platform::PointerKind::Move, p.x, p.y);
      page.lastX = p.x;
      page.lastY = p.y;
    }
    page.lift();
    page.settle();
    return *page.state().text("tool");
  };
  CHECK(toolAfter(2 * std::numbers::pi) == "draw");
  CHECK(toolAfter(std::numbers::pi) == "pen");
}

TEST_CASE("a line of which many ends are guesses says so and offers another try; one on a thing does not") {
  Rig page;
  page.openBar();
  page.drawBar();
  CHECK(offered(page).empty());
  page.run("draw-spine", R"({"stroke": [[20, 40], [20, 100], [20, 160]]})");  // beside the bar
  page.settle();
  CHECK(offered(page) == "redraw");
}

TEST_CASE("a length at a glance has at most one digit behind the point below a metre, and is off by half of it") {
  Rng random(7);
  for (int i = 0; i < testing::rounds(200); ++i) {
    const double mm = random.uniform(10, 990);
    const std::string text = app::roundLength(mm);
    const std::size_t point = text.find('.');
    if (point != std::string::npos) CHECK(text.find(' ') - point == 2);
    CHECK(std::abs(std::stod(text) * 10 - mm) <= 0.5 + 1e-9);
  }
}
