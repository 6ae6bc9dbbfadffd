// Solids that are made while nobody waits for them yet, with a solver that does as it is told.
#include <doctest/doctest.h>

#include "tests/unit/web/two_bars.h"

using namespace spineloft;
using app::Json;
using test::Stuck;
using test::TwoBars;

TEST_CASE("what is ticked is made while nobody waits for it: stuck together, it is there at once") {
  TwoBars rig;
  rig.tick(1);
  CHECK(rig.asked() == 0);
  rig.tick(2);
  REQUIRE(rig.asked() == 1);
  CHECK_FALSE(rig.busy());
  const Json request = rig.lastAsked();
  rig.say(TwoBars::answerTo(request, {{"progress", 0.5}}));
  rig.answer(request);
  CHECK(rig.state().find("steps")->array()->empty());
  CHECK(rig.settle());
  rig.stick();
  CHECK(rig.status() == "ready");
  CHECK(rig.step().number("triangles") == 4);
  CHECK(rig.asked() == 1);
  CHECK_FALSE(rig.busy());
}

TEST_CASE("what is on its way when it is stuck together is waited for, and not asked for again") {
  TwoBars rig;
  rig.tick(1);
  rig.tick(2);
  rig.stick();
  CHECK(rig.asked() == 1);
  CHECK(rig.status() == "waiting");
  CHECK(rig.busy());
  rig.answer(rig.lastAsked());
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
}

TEST_CASE("what was made ahead in vain is no trouble: other ticks, other parts, a failure, a solver that dies") {
  TwoBars rig;
  rig.tick(1);
  rig.tick(2);
  // In the other order it is another solid: the first one says what the whole looks like.
  rig.tick(1, false);
  rig.tick(1);
  CHECK(rig.asked() == 2);
  // Once only, however often the page looks.
  rig.lost(rig.lastAsked());
  rig.state();
  CHECK(rig.asked() == 2);
  CHECK_FALSE(rig.host.said("was interrupted"));
  // The part changes under the ticks.
  rig.run("set-section", R"({"part": 1, "section": "square"})");
  rig.state();
  REQUIRE(rig.asked() == 3);
  rig.fail(rig.lastAsked(), *Json::parse(R"({"error": "SolidEmpty"})"));
  CHECK(rig.state().find("steps")->array()->empty());
  CHECK(rig.settle());
  const auto said = rig.host.sent.size();
  rig.stick();
  CHECK(rig.asked() == 3);
  CHECK(rig.status() == "failed");
  CHECK(rig.host.sent.size() > said);
}

TEST_CASE("a solver that dies ahead of time is asked again when the solid is wanted") {
  TwoBars rig;
  rig.tick(1);
  rig.tick(2);
  rig.lost(rig.lastAsked());
  rig.stick();
  REQUIRE(rig.asked() == 2);
  rig.answer(rig.lastAsked());
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
}

TEST_CASE("what is made ahead never holds up what is wanted") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  rig.run("draw-spine", R"({"stroke": [[150, 50], [152, 100], [150, 150]]})");
  rig.settle();
  rig.run("pick", R"({"step": 1})");
  rig.tick(3);
  const std::size_t before = rig.asked();
  REQUIRE(before == 2);
  // An edit of the solid that is there comes first, its union with the third one when it is done.
  rig.run("set-section", R"({"part": 1, "section": "square"})");
  rig.state();
  REQUIRE(rig.asked() == before + 1);
  CHECK(rig.status() == "waiting");
  CHECK(rig.busy());
  rig.answer(rig.lastAsked(), 2);
  CHECK(rig.settle());
  CHECK(rig.status() == "ready");
  CHECK(rig.asked() == before + 2);
  CHECK_FALSE(rig.busy());
}

TEST_CASE("what is ahead and had to give way is taken up again") {
  Stuck rig;
  rig.answer(rig.lastAsked());
  for (const char* stroke :
       {R"({"stroke": [[150, 50], [152, 100], [150, 150]]})", R"({"stroke": [[130, 50], [132, 100], [130, 150]]})"}) {
    rig.run("draw-spine", stroke);
    rig.settle();
  }
  rig.tick(3);
  rig.tick(4);
  const Json given = rig.lastAsked();
  const std::size_t before = rig.asked();
  rig.run("set-section", R"({"part": 1, "section": "square"})");
  rig.state();
  REQUIRE(rig.asked() == before + 1);
  rig.done(given);
  CHECK(rig.busy());
  rig.answer(rig.lastAsked());
  CHECK(rig.settle());
  REQUIRE(rig.asked() == before + 2);
  CHECK(*rig.lastAsked().find("wanted")->array()->front().text() == *given.find("wanted")->array()->front().text());
}
