// The page's side of the program that cuts out: one request at a time, what it answers, and its end.
#include <doctest/doctest.h>

#include <array>

#include "engine/vision/cut_out.h"
#include "tests/unit/web/rig.h"

using namespace spineloft;
using spineloft::test::Rig;
using Kind = platform::CutAnswer::Kind;

namespace {

constexpr const char* kTap = R"({"at":[100,100]})";

bool searches(Rig& rig) {
  const app::Json state = rig.state();
  const app::Json* cut = state.find("cut");
  return !cut->isNull() && cut->flag("searching") == true;
}
/// The page is told that the program ended.
void loseProgram(Rig& rig, Kind kind) {
  REQUIRE(rig.host.search);
  const std::uint32_t id = rig.host.search->id;
  rig.host.search.reset();
  rig.app->cutOutAnswered({id, kind, 0, {}});
  rig.settle();
}

}  // namespace

TEST_CASE("the outlines are those of the search in one piece, whatever the hints are") {
  test::FakeHost host;
  app::Studio studio(host, 0);
  const auto picture = std::make_shared<const image::Picture>(test::barPicture());
  REQUIRE(studio.act(document::AddPicture{"bar", picture}).ok());
  const PictureId id = studio.document().pictures.back()->id;
  const vision::CutMark more{{{100, 60}, {160, 60}}, 8, true}, less{{{85, 150}, {115, 150}}, 5, false};
  const std::array<vision::CutHints, 4> all = {
      vision::CutHints{{{100, 100}}, {}, {}, {}},
      vision::CutHints{{}, {}, {{{70, 20}, {132, 182}}}, {}},
      vision::CutHints{{}, {}, {{{70, 20}, {132, 182}}}, {more, less}},
      vision::CutHints{{{100, 50}, {100, 150}}, {{10, 10}}, {}, {less}},
  };
  for (const vision::CutHints& hints : all) {
    const auto expected = vision::cutOut(*picture, hints);
    REQUIRE(expected.ok());
    std::optional<Result<app::CutShape>> found;
    REQUIRE(studio.cutOut(id, hints, [&](Result<app::CutShape> shape) { found = std::move(shape); }).ok());
    CHECK(studio.busy());
    REQUIRE(host.search);
    REQUIRE(host.search->hints);
    CHECK(*host.search->hints == hints);
    CHECK(host.search->picture == *picture);
    const auto numbers = vision::numbersOf(vision::cutOut(host.search->picture, *host.search->hints));
    CHECK(studio.takeCutOut({host.search->id, Kind::Found, 1, numbers}));
    while (studio.pump()) {
    }
    REQUIRE(found.has_value());
    REQUIRE(found->ok());
    CHECK(found->value().contours == expected.value());
    CHECK(found->value().fill.size() > 10);
    CHECK_FALSE(studio.busy());
  }
  for (const std::string& key : host.pictureKeys) CHECK(key == host.pictureKeys.front());
  const auto other = std::make_shared<const image::Picture>(test::barPicture(210, 200));
  REQUIRE(studio.act(document::AddPicture{"other", other}).ok());
  REQUIRE(studio.cutOut(studio.document().pictures.back()->id, all[0], [](auto) {}).ok());
  CHECK(host.pictureKeys.back() != host.pictureKeys.front());
}

TEST_CASE("while a cut-out is looked for the page says so and how far it is; then it is at rest") {
  Rig rig;
  rig.openBar();
  CHECK(rig.run("cut-start", kTap).flag("ok") == true);
  CHECK(searches(rig));
  CHECK_FALSE(rig.app->idle());
  const auto shown = [&] { return *rig.state().find("activity"); };
  CHECK(*shown().text("label") == "Cutting it out");
  double before = -1;
  int rounds = 0;
  while (rig.host.search) {
    CHECK(*shown().number("done") > before);
    before = *shown().number("done");
    rig.host.cutOnce(*rig.app);
    ++rounds;
  }
  CHECK(rounds > 2);
  rig.settle();
  CHECK_FALSE(searches(rig));
  CHECK(rig.app->idle());
  CHECK(shown().isNull());
}

TEST_CASE("a newer search takes the place of the older one: what is said of that one changes nothing") {
  Rig rig;
  rig.openBar();
  rig.run("cut-start", kTap);
  const std::uint32_t old = rig.host.search->id;
  rig.run("cut-mark", R"({"line":[[100,60],[160,60]],"radius":8})");
  REQUIRE(rig.host.search->id != old);
  const app::Json before = rig.state();
  const auto numbers = vision::numbersOf(Result<vision::CutContours>({{{1, 1}, {50, 1}, {50, 50}}}));
  for (const Kind kind : {Kind::Progress, Kind::Found, Kind::Stopped, Kind::Unreachable}) {
    rig.app->cutOutAnswered({old, kind, 0.9, numbers});
    CHECK(rig.state() == before);
  }
  rig.settle();
  const app::Json state = rig.state();
  CHECK(state.find("cut")->number("marks") == 1);
  CHECK((*state.find("cut")->find("contours")->array())[0].array()->size() > 100);
  CHECK_FALSE(rig.host.said(R"("level":"error")"));
}

TEST_CASE("who leaves the cut-out waits for nothing, and the program hears of it") {
  Rig rig;
  rig.openBar();
  rig.run("cut-start", kTap);
  rig.run("cut-cancel");
  CHECK(rig.host.said(R"({"type":"stopCuttingOut"})"));
  CHECK(rig.state().find("activity")->isNull());
  rig.settle();
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.parts() == 0);
}

TEST_CASE("where the program ends or cannot be loaded a sentence says what to do, and the next search goes well") {
  Rig rig;
  rig.openBar();
  rig.run("cut-start", kTap);
  loseProgram(rig, Kind::Unreachable);
  CHECK(rig.host.said("What cuts things out could not be loaded. Nothing is lost: check the connection"));
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.app->idle());
  rig.run("cut-start", kTap);
  rig.settle();
  const app::Json whole = *rig.state().find("cut")->find("contours");
  CHECK_FALSE(whole.array()->empty());
  // What was shown before stays.
  rig.run("cut-mark", R"({"line":[[100,60],[160,60]],"radius":8})");
  loseProgram(rig, Kind::Stopped);
  CHECK(rig.host.said("Cutting out was interrupted. Nothing is lost: try it again."));
  CHECK(*rig.state().find("cut")->find("contours") == whole);
  CHECK(rig.state().find("cut")->number("marks") == 0);
  rig.run("cut-mark", R"({"line":[[100,60],[160,60]],"radius":8})");
  rig.settle();
  CHECK(rig.state().find("cut")->number("marks") == 1);
  CHECK(*rig.state().find("cut")->find("contours") != whole);
}

TEST_CASE("an answer that is none is as good as nothing found") {
  Rig rig;
  rig.openBar();
  rig.run("cut-start", kTap);
  const std::uint32_t id = rig.host.search->id;
  rig.host.search.reset();
  const double damaged[] = {0, 7, 1};
  rig.app->cutOutAnswered({id, Kind::Found, 1, damaged});
  rig.settle();
  CHECK(rig.state().find("cut")->isNull());
  CHECK(rig.host.said("I found no clear thing there."));
}
