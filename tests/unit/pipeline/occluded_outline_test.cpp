#include "engine/pipeline/occluded_outline.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <functional>

#include "tests/unit/surface/canvas.h"

using namespace spineloft;
using namespace spineloft::pipeline;
using surface::Canvas;
using surface::Rgb;

namespace {

constexpr Canvas kCanvas{240, 120};
constexpr Rgb kGround{60, 70, 200}, kThing{200, 190, 50}, kMug{220, 120, 110}, kLabel{230, 230, 235};

bool isThing(int x, int y) { return x >= 20 && x < 220 && y >= 40 && y < 80; }
bool isMiddle(int x) { return x >= 100 && x < 140; }

/// Across the thing, all on edges; with the drawing direction to the right its upper side is its left.
ribs::RibSet acrossThing() {
  ribs::RibSet set;
  for (int x = 22; x < 218; x += 2) {
    ribs::Rib rib;
    rib.center = {double(x), 60}, rib.left = {double(x), 40}, rib.right = {double(x), 80};
    rib.leftState = rib.rightState = ribs::RibState::Edge;
    set.ribs.push_back(rib);
  }
  return set;
}

image::Picture pictureOf(const std::function<Rgb(int x, int y)>& colour) {
  return image::makePicture(kCanvas.picture(colour));
}

/// Flags of the ribs in the middle of the thing, and of the others.
struct Count {
  int middle = 0, elsewhere = 0;
};
Count countOf(const std::vector<bool>& passed, const ribs::RibSet& set) {
  Count out;
  for (std::size_t i = 0; i < passed.size(); ++i)
    (isMiddle(int(set.ribs[i].center.x)) ? out.middle : out.elsewhere) += passed[i] ? 1 : 0;
  return out;
}

Rgb plain(int x, int y) { return isThing(x, y) ? kThing : kGround; }

}  // namespace

TEST_CASE("where something passes over an outline its ribs are told from the others, on that side alone") {
  const ribs::RibSet set = acrossThing();
  const PassedEnds ends =
      passedEnds(set, pictureOf([](int x, int y) { return isMiddle(x) && y >= 50 ? kMug : plain(x, y); }));
  REQUIRE(ends.left.size() == set.ribs.size());
  REQUIRE(ends.right.size() == set.ribs.size());
  CHECK(countOf(ends.right, set).middle >= 18);
  CHECK(countOf(ends.right, set).elsewhere <= 2);
  CHECK(std::ranges::count(ends.left, true) == 0);
}

TEST_CASE("a label, a ring, a neighbour and the thing itself pass over nothing") {
  const ribs::RibSet set = acrossThing();
  const auto passed = [&](const std::function<Rgb(int x, int y)>& colour) {
    const PassedEnds ends = passedEnds(set, pictureOf(colour));
    return std::ranges::count(ends.left, true) + std::ranges::count(ends.right, true);
  };
  CHECK(passed(plain) == 0);
  SUBCASE("a label that reaches the outline") {
    CHECK(passed([](int x, int y) { return isMiddle(x) && isThing(x, y) ? kLabel : plain(x, y); }) == 0);
  }
  SUBCASE("a label of the ground's colour") {
    CHECK(passed([](int x, int y) { return isMiddle(x) && y >= 50 ? kGround : plain(x, y); }) == 0);
  }
  SUBCASE("something that ends at the outline") {
    CHECK(passed([](int x, int y) { return isMiddle(x) && y >= 80 ? kMug : plain(x, y); }) == 0);
  }
  SUBCASE("something of a colour that rings of the thing have") {
    CHECK(passed([](int x, int y) {
            return isThing(x, y) && x / 20 % 3 == 0 ? kMug : isMiddle(x) && y >= 80 ? kMug : plain(x, y);
          }) == 0);
  }
}

TEST_CASE("where a hand put a rib nothing passes over it, and without ribs or pixels nothing does") {
  ribs::RibSet set = acrossThing();
  const image::Picture picture = pictureOf([](int x, int y) { return isMiddle(x) && y >= 50 ? kMug : plain(x, y); });
  CHECK(occludedStretches(set, picture).size() == 1);
  CHECK(occludedStretches(set, {}).empty());
  for (ribs::Rib& rib : set.ribs) rib.rightState = ribs::RibState::Edited;
  CHECK(std::ranges::count(passedEnds(set, picture).right, true) == 0);
  CHECK(occludedStretches(set, picture).empty());
  CHECK(passedEnds({}, picture).left.empty());
  CHECK(occludedStretches({}, picture).empty());
}
