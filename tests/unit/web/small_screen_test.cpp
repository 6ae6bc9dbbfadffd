// Bars of small screens: what they cover, and what they offer once.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/unit/web/rig.h"
#include "tests/unit/web/shown.h"

using namespace spineloft;
using spineloft::test::inSight;
using spineloft::test::Rig;
using spineloft::test::Shown;

namespace {

constexpr platform::CanvasSize kPhone{390, 740, 1}, kOnItsSide{844, 306, 1}, kDesk{1440, 820, 1};

}  // namespace

TEST_CASE(
    "what is scooped out is done by one bar, at the foot of the solid view: what opens at the head stays in sight") {
  for (const platform::CanvasSize size : {kPhone, kOnItsSide, kDesk}) {
    CAPTURE(size.width);
    Rig rig(size);
    rig.openBar();
    rig.drawBar();
    REQUIRE(rig.run("hollow-show").flag("ok") == true);
    rig.settle();
    const app::Rect& view = rig.app->ui().layout.solid;
    for (const char* words : {"Make it hollow", "Not this"}) {
      int times = 0;
      for (const Shown& one : inSight(rig)) {
        if (one.words != words) continue;
        ++times;
        CHECK(view.contains(one.at.centre()));
        CHECK(one.at.y > view.centre().y);
      }
      CHECK(times == 1);
    }
  }
}

TEST_CASE("on a phone no button lies on another while a part that lies on others is new") {
  Rig rig(kPhone);
  rig.openBar();
  rig.drawBar();
  rig.press(85, 100, 115, 100);
  rig.lift();
  rig.settle();
  const std::vector<Shown> all = inSight(rig);
  int lies = 0;
  for (const Shown& one : all) lies += one.words == "In front" || one.words == "Inside" || one.words == "Behind";
  REQUIRE(lies == 3);
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (all[i].kind != "button" || all[k].kind != "button") continue;
      CAPTURE(all[i].words);
      CAPTURE(all[k].words);
      CHECK_FALSE(all[i].at.meets(all[k].at));
    }
  }
}

TEST_CASE("where a view is high, its buttons have words, in as many rows as a quarter of it has room for") {
  constexpr platform::CanvasSize kTablet{1024, 680, 1};
  for (const platform::CanvasSize size : {kPhone, kOnItsSide, kTablet, kDesk}) {
    CAPTURE(size.width);
    Rig rig(size);
    rig.openBar();
    REQUIRE(rig.run("more-tools", R"({"on": true})").flag("ok") == true);
    rig.settle();
    const app::Rect& view = rig.app->ui().layout.picture;
    const bool high = size.width == kTablet.width || size.width == kDesk.width;
    std::vector<app::Rect> bar;
    for (const char* words :
         {"Line", "Puff", "Flat piece", "Shapes", "Lines", "Spin", "Layers", "Move picture", "Fit"}) {
      CAPTURE(words);
      for (const Shown& one : inSight(rig)) {
        if (one.kind == "button" && one.words == words && view.contains(one.at.centre())) bar.push_back(one.at);
      }
    }
    REQUIRE(bar.size() >= (size.width == kOnItsSide.width ? 4 : 9));
    for (const app::Rect& one : bar) {
      CHECK(view.contains({one.x, one.y}));
      CHECK(view.contains({one.right(), one.bottom()}));
      if (high) CHECK(one.height >= 48);
      if (high) CHECK(one.y >= view.bottom() - 10 - 0.25 * view.height);
      for (const app::Rect& other : bar) CHECK((&one == &other || !one.meets(other)));
    }
  }
}

TEST_CASE("a window of any size has its buttons, within their view, also beside the card of the pen") {
  Rig rig(kDesk);
  REQUIRE(rig.run("new-sketch").flag("ok") == true);
  REQUIRE(rig.run("more-tools", R"({"on": false})").flag("ok") == true);
  rig.press(700, 400, 720, 400, platform::Device::Touch);
  rig.lift(platform::Device::Touch);
  for (double width = 320; width <= 1480; width += 8) {
    for (const double height : {400., 900., 1300.}) {
      CAPTURE(width);
      CAPTURE(height);
      rig.app->resize({width, height, 1});
      rig.settle();
      const app::Rect& view = rig.app->ui().layout.picture;
      for (const Shown& one : inSight(rig)) {
        if (one.kind != "button" || one.words != "Fit") continue;
        CHECK(view.contains({one.at.x, one.at.y}));
        CHECK(view.contains({one.at.right(), one.at.bottom()}));
      }
    }
  }
}
