// What the shell was told last is what the command table and the page say now, whatever was done.
#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"
#include "tests/support/scarce_memory.h"
#include "tests/unit/web/two_bars.h"
#include "web/commands/shell_view.h"

using namespace spineloft;
using spineloft::test::Rig;
using spineloft::test::TwoBars;

namespace {

constexpr std::string_view kChanged = R"({"type":"changed")";

std::size_t timesTold(const Rig& rig) {
  return static_cast<std::size_t>(
      std::ranges::count_if(rig.host.sent, [](const std::string& json) { return json.starts_with(kChanged); }));
}

app::Json lastTold(const Rig& rig) {
  for (std::size_t i = rig.host.sent.size(); i > 0; --i) {
    if (rig.host.sent[i - 1].starts_with(kChanged)) return *app::Json::parse(rig.host.sent[i - 1])->find("view");
  }
  FAIL("the shell was told nothing");
  return {};
}

std::size_t sizeOf(const app::Json& json, std::string_view key) { return json.find(key)->array()->size(); }

/// A sign for each row of the table, as it is now.
std::string signs(const app::Json& commands, std::string_view key) {
  std::string all;
  for (const app::Json& command : *commands.array()) {
    const std::optional<bool> flag = command.flag(key);
    all += !flag ? '-' : *flag ? '1' : '0';
  }
  return all;
}

void checkPicture(Rig& rig, const app::Json& told, const app::Json& now) {
  REQUIRE(told.isNull() == now.isNull());
  if (now.isNull()) return;
  for (const char* key : {"width", "height", "strokes"}) CHECK(told.number(key) == now.number(key));
  for (const char* key : {"sketch", "finished"}) CHECK(told.flag(key) == now.flag(key));
  const double width = *now.number("width"), height = *now.number("height");
  const auto first = rig.at(-0.5, -0.5), last = rig.at(width - 0.5, height - 0.5);
  CHECK(*told.find("topLeft")->number("x") == doctest::Approx(first.x));
  CHECK(*told.find("topLeft")->number("y") == doctest::Approx(first.y));
  CHECK(*told.find("bottomRight")->number("x") == doctest::Approx(last.x));
  CHECK(*told.find("bottomRight")->number("y") == doctest::Approx(last.y));
}

void checkSelected(const app::Json& told, const app::Json& state) {
  REQUIRE(told.isNull() == state.find("selection")->isNull());
  if (told.isNull()) return;
  CHECK(told.number("id") == state.number("selection"));
  for (const app::Json& part : *state.find("parts")->array()) {
    if (part.number("id") != told.number("id")) continue;
    CHECK(*told.text("name") == *part.text("name"));
    CHECK(*told.text("kind") == *part.text("kind"));
    CHECK(*told.number("ribs") == sizeOf(part, "ribs"));
  }
}

/// The law.
void checkTold(Rig& rig) {
  const app::Json told = lastTold(rig), state = rig.state(), commands = *app::Json::parse(rig.app->commands());
  CHECK(*told.text("enabled") == signs(commands, "enabled"));
  CHECK(*told.text("toggled") == signs(commands, "toggled"));
  for (const char* key : {"documentName", "tool"}) CHECK(*told.text(key) == *state.text(key));
  for (const char* key : {"pictures", "undo", "redo"}) CHECK(told.number(key) == state.number(key));
  for (const char* key : {"parts", "picked"}) CHECK(*told.number(key) == sizeOf(state, key));
  for (const char* key : {"bytes", "budget"}) {
    CHECK(told.find("history")->number(key) == state.find("history")->number(key));
  }
  CHECK(told.flag("unsaved") == state.flag("unsaved"));
  CHECK(told.flag("penMenu") == state.find("pen")->flag("menu"));
  checkPicture(rig, *told.find("picture"), *state.find("picture"));
  checkSelected(*told.find("selected"), state);
  const app::Json &activity = *told.find("activity"), &going = *state.find("activity");
  REQUIRE(activity.isNull() == going.isNull());
  if (going.isNull()) return;
  CHECK(*activity.text("label") == *going.text("label"));
  CHECK(std::abs(*activity.number("done") - *going.number("done")) <= 0.05);
}

/// Frames and wakes as they are asked for, for a while: the solver of these tests never answers.
void goOn(Rig& rig) {
  for (int i = 0; i < 24; ++i) {
    rig.host.clockMs += 16;
    if (std::exchange(rig.host.wakesAsked, 0) > 0) rig.app->wake();
    if (std::exchange(rig.host.frameAsked, false)) {
      rig.app->frame();
    } else if (rig.app->idle()) {
      return;
    }
  }
}

/// Whether the command is enabled (or toggled) as far as the shell was told.
bool isTold(const Rig& rig, std::string_view key, std::string_view id) {
  const std::string signs = *lastTold(rig).text(key);
  const auto at = static_cast<std::size_t>(app::findCommand(id) - app::commandTable().data());
  return signs.at(at) == '1';
}

struct Call {
  const char *id, *args;
};
/// Commands that programs give their arguments, and what leads to states that others need.
constexpr Call kCalls[] = {
    {"draw-spine", R"({"stroke":[[100,40],[100,160]]})"},
    {"draw-spine", R"({"stroke":[[110,50],[112,100],[110,150]]})"},
    {"draw-puff", R"({"contours":[[[40,40],[90,45],[80,120],[35,100]]]})"},
    {"select-part", R"({"id":1})"},
    {"select-part", R"({"id":2})"},
    {"select-all", "{}"},
    {"group", "{}"},
    {"pick", R"({"part":1})"},
    {"pick", R"({"part":2})"},
    {"stick-together", R"({"operands":[{"part":1},{"part":2}]})"},
    {"select-step", R"({"id":1})"},
    {"scoop-out", "{}"},
    {"point-opening", "{}"},
    {"new-sketch", "{}"},
    {"draw-on-sketch", R"({"stroke":[[20,20],[180,30],[170,180],[25,160],[21,24]]})"},
    {"ribs", "{}"},
    {"bone", "{}"},
    {"move", "{}"},
    {"snap-to-surface", "{}"},
    {"edit-slice", "{}"},
    {"undo", "{}"},
    {"rename-model", R"({"name":"A swan that has a long name"})"},
    {"set-section", R"({"section":"gear"})"},
    {"delete-part", "{}"},
};

}  // namespace

TEST_CASE("after every command of a random sequence the shell was told what the table and the state say") {
  const std::span<const app::Command> table = app::commandTable();
  REQUIRE(table.size() <= app::ShellView::kMostCommands);
  for (const std::uint64_t seed : testing::seeds(1, 5)) {
    CAPTURE(seed);
    Rng rng(seed);
    Rig rig;
    rig.openBar();
    checkTold(rig);
    for (int i = 0; i < 120; ++i) {
      const Call given = kCalls[rng.below(std::size(kCalls))];
      const bool isGiven = rng.below(2) == 0;
      const std::string id(isGiven ? std::string_view(given.id)
                                   : table[rng.below(static_cast<std::uint32_t>(table.size()))].id);
      CAPTURE(i);
      CAPTURE(id);
      rig.run(id, isGiven ? given.args : "{}");
      if (rng.below(4) > 0) goOn(rig);
      checkTold(rig);
    }
  }
}

TEST_CASE("a switch, one more selected part and a tapped opening reach the menus of the shell at once") {
  TwoBars rig;
  REQUIRE_FALSE(isTold(rig, "toggled", "snap-to-surface"));
  rig.run("snap-to-surface");
  CHECK(isTold(rig, "toggled", "snap-to-surface"));
  rig.run("select-part", R"({"id":1})");
  rig.settle();
  REQUIRE_FALSE(isTold(rig, "enabled", "group"));
  rig.run("select-all");
  rig.settle();
  CHECK(isTold(rig, "enabled", "group"));
  rig.run("select-part", R"({"id":1})");
  rig.run("scoop-out");
  REQUIRE_FALSE(isTold(rig, "toggled", "point-opening"));
  rig.run("point-opening");
  CHECK(isTold(rig, "toggled", "point-opening"));
  rig.run("cancel");
  CHECK_FALSE(isTold(rig, "toggled", "point-opening"));
}

TEST_CASE("what is told once is not told again, and keys and pointers tell what they change") {
  TwoBars rig;
  const std::size_t times = timesTold(rig);
  for (int i = 0; i < 10; ++i) rig.app->frame();
  CHECK(timesTold(rig) == times);
  rig.key("KeyG", "2");
  CHECK(*lastTold(rig).text("tool") == "hand");
  CHECK(timesTold(rig) > times);
  checkTold(rig);
  rig.click(20, 680);
  checkTold(rig);
}

TEST_CASE("a page whose graphics are lost goes on telling the shell, and rests") {
  Rig rig;
  rig.openBar();
  rig.app->contextLost();
  rig.run("draw-spine", R"({"stroke":[[100,40],[100,160]]})");
  rig.settle();
  CHECK(*lastTold(rig).number("parts") == 1);
  CHECK(lastTold(rig).flag("unsaved") == true);
  CHECK(rig.app->idle());
}

TEST_CASE("a view like the one before asks for no memory") {
  test::FakeHost host;
  app::Studio studio{host, 0};
  app::UiState ui;
  const app::CommandEnv env{studio, ui, host};
  const auto picture = std::make_shared<const image::Picture>(test::barPicture());
  REQUIRE(studio.act(document::AddPicture{"a bar with a long name", picture}).ok());
  ui.picture = studio.document().pictures.back()->id;
  REQUIRE(app::runCommand(env, "draw-spine", *app::Json::parse(R"({"stroke":[[100,40],[100,160]]})")).ok());
  REQUIRE(studio.document().parts.size() == 1);
  ui.selection = studio.document().parts.back()->id;
  studio.derived();
  while (studio.busy()) {
    studio.pump();
    studio.derived();
  }
  app::ShellView view;
  app::viewOf(env, view);
  const app::ShellView first = view;
  CHECK(first.selected);
  const std::size_t had = testing::allocatedBytes();
  app::viewOf(env, view);
  CHECK(testing::allocatedBytes() == had);
  CHECK(view == first);
}
