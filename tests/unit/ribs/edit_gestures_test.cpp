#include "engine/ribs/edit/edit_gestures.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/rounds.h"
#include "tests/unit/ribs/edited_ribs.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Band;
using fixtures::bandOf;
using fixtures::endOf;
using fixtures::stateOf;

namespace {

// A part under edits, as a tool sees it.
struct Work {
  Band band;
  RibEdits edits;
  RibSet seen;
  explicit Work(Band b) : band(std::move(b)), seen(band.ribs) {}
  EditScene scene() const { return {band.spine, seen, edits}; }
  void set(RibEdits next) {
    REQUIRE(isValid(next));
    edits = std::move(next);
    seen = band.edited(edits);
  }
};

// Gives every rib of a side another place `by` farther out, over a stretch of ribs.
void offer(Work& work, std::size_t from, std::size_t to, double by) {
  for (std::size_t i = from; i < to; ++i) {
    Rib& rib = work.band.ribs.ribs[i];
    rib.leftOthers.at[0] = rib.center + (rib.left - rib.center) * 0.2;
    rib.leftOthers.at[1] = rib.left + normalized(rib.left - rib.center) * by;
    rib.leftOthers.count = 2;
  }
  work.seen = work.band.ribs;
}

}  // namespace

TEST_CASE("the nearest end and the nearest rib are found within reach only") {
  const Band band = bandOf(50);
  for (std::size_t i = 0; i < 50; i += 7) {
    const Rib& rib = band.ribs.ribs[i];
    CHECK(nearestEnd(band.ribs, rib.left + PicturePoint{1, 1}, 5) == EndRef{i, Side::Left});
    CHECK(nearestEnd(band.ribs, rib.right + PicturePoint{1, 1}, 5) == EndRef{i, Side::Right});
    CHECK(nearestRib(band.ribs, lerp(rib.center, rib.left, 0.7), 3) == i);
  }
  CHECK_FALSE(nearestEnd(band.ribs, {5, 5}, 20));
  CHECK_FALSE(nearestRib(band.ribs, {5, 5}, 20));
  CHECK_FALSE(nearestEnd({}, {5, 5}, 1e9));
}

TEST_CASE("a place on the spine is the share of its length") {
  const Band band = bandOf(101);
  CHECK(placeOf(band.spine, band.spine.points[25]) == doctest::Approx(fixtures::placeOfRib(band, 25)).epsilon(1e-9));
  CHECK(placeOf(EditScene{band.spine, band.ribs, {}}, 75) ==
        doctest::Approx(fixtures::placeOfRib(band, 75)).epsilon(1e-9));
  CHECK(placeOf(band.spine, {-1e4, 0}) == 0);
}

TEST_CASE("dragging twice is dragging once to the last place") {
  for (const double reach : {0.0, 0.02, 0.2}) {
    Work steps(bandOf(80)), once(bandOf(80));
    const EndRef end{33, Side::Right};
    const PicturePoint from = steps.seen.ribs[33].right;
    for (int i = 1; i <= 20; ++i) {
      steps.set(dragEnd(steps.scene(), end, from + PicturePoint{0.3 * i, 1.5 * i}, reach));
    }
    once.set(dragEnd(once.scene(), end, from + PicturePoint{6, 30}, reach));
    CHECK(steps.edits.ends.size() == 1);
    CHECK(steps.edits == once.edits);
    CHECK(steps.seen == once.seen);
    CHECK(distance(steps.seen.ribs[33].right, from + PicturePoint{6, 30}) < 1e-9);
  }
}

TEST_CASE("a later drag of the same end keeps one edit, but not across edits that overlap it") {
  Work work(bandOf(80));
  work.set(dragEnd(work.scene(), {20, Side::Left}, {250, 200}, 0.1));
  work.set(dragEnd(work.scene(), {60, Side::Left}, {550, 200}, 0.1));
  work.set(dragEnd(work.scene(), {20, Side::Right}, {250, 400}, 0.1));
  work.set(dragEnd(work.scene(), {20, Side::Left}, {250, 210}, 0.1));
  CHECK(work.edits.ends.size() == 3);
  work.set(dragEnd(work.scene(), {24, Side::Left}, {270, 190}, 0.1));
  const RibSet before = work.seen;
  work.set(dragEnd(work.scene(), {20, Side::Left}, {250, 205}, 0.1));
  CHECK(work.edits.ends.size() == 5);
  CHECK(distance(work.seen.ribs[20].left, {250, 205}) < 1e-9);
  CHECK(distance(work.seen.ribs[24].left, before.ribs[24].left) <
        distance(work.seen.ribs[20].left, before.ribs[20].left));
}

TEST_CASE("pulling the tip of a soft bulge alone leaves the rest of the bulge") {
  Work work(bandOf(100));
  work.set(dragEnd(work.scene(), {50, Side::Left}, work.seen.ribs[50].left + PicturePoint{0, -40}, 0.2));
  const RibSet bulge = work.seen;
  work.set(dragEnd(work.scene(), {50, Side::Left}, work.seen.ribs[50].left + PicturePoint{0, -5}, 0));
  for (std::size_t i = 0; i < 100; ++i) {
    if (i != 50) CHECK(work.seen.ribs[i].left == bulge.ribs[i].left);
  }
}

TEST_CASE("a stroke moves the ends it passes to where it crosses their ribs, and no others") {
  Work work(bandOf(100, 0));
  const std::vector<PicturePoint> stroke{{250, 245}, {350, 235}, {450, 248}};
  const StrokeDeform deform = deformByStroke(work.scene(), stroke, 40, false);
  work.set(deform.edits);
  REQUIRE(deform.touched.size() > 20);
  for (std::size_t i = 0; i < 100; ++i) {
    const Rib& rib = work.seen.ribs[i];
    const bool touched = std::ranges::count(deform.touched, EndRef{i, Side::Left}) > 0;
    CHECK((rib.center.x >= 250 && rib.center.x <= 450) == touched);
    CHECK((rib.leftState == RibState::Edited) == touched);
    CHECK(rib.right == work.band.ribs.ribs[i].right);
    if (!touched) {
      CHECK(rib == work.band.ribs.ribs[i]);
      continue;
    }
    const double x = rib.center.x;
    const double y = x < 350 ? 245 - (x - 250) * 0.1 : 235 + (x - 350) * 0.13;
    CHECK(std::abs(rib.left.x - x) < 0.01);
    CHECK(std::abs(rib.left.y - y) < 0.01);
  }
}

TEST_CASE("a stroke on both sides changes the opposite ends by the same ratio") {
  Work work(bandOf(100, 0));
  const StrokeDeform deform = deformByStroke(work.scene(), std::vector<PicturePoint>{{250, 240}, {450, 240}}, 60, true);
  work.set(deform.edits);
  CHECK(deform.touched.size() % 2 == 0);
  for (const EndRef& end : deform.touched) {
    const Rib &was = work.band.ribs.ribs[end.rib], &now = work.seen.ribs[end.rib];
    const double left = distance(now.left, now.center) / distance(was.left, was.center);
    const double right = distance(now.right, now.center) / distance(was.right, was.center);
    CHECK(left == doctest::Approx(right).epsilon(1e-6));
  }
}

TEST_CASE("a stroke far away, of one point, or through locked ends moves nothing") {
  Work work(bandOf(60, 0));
  const std::vector<PicturePoint> far{{100, 20}, {700, 20}}, dot{{300, 260}}, line{{100, 250}, {700, 250}};
  CHECK(deformByStroke(work.scene(), far, 40, true).touched.empty());
  CHECK(deformByStroke(work.scene(), dot, 40, true).touched.empty());
  for (std::size_t i = 0; i < 60; ++i) work.set(lockRib(work.scene(), i, true));
  const StrokeDeform deform = deformByStroke(work.scene(), line, 100, true);
  CHECK(deform.touched.empty());
  CHECK(deform.edits == work.edits);
}

TEST_CASE("a locked rib stays where it is, and frees again without a jump") {
  Work work(bandOf(70));
  work.set(dragEnd(work.scene(), {30, Side::Left}, {310, 190}, 0.1));
  work.set(lockRib(work.scene(), 32, true));
  const Rib held = work.seen.ribs[32];
  CHECK(held.leftState == RibState::Locked);
  CHECK(held.rightState == RibState::Locked);
  work.set(dragEnd(work.scene(), {34, Side::Left}, {350, 160}, 0.2));
  CHECK(work.seen.ribs[32].left == held.left);
  // A drag of the end itself moves it, alone, and it stays locked.
  const RibSet before = work.seen;
  work.set(dragEnd(work.scene(), {32, Side::Left}, {375, 230}, 0.2));
  CHECK(distance(work.seen.ribs[32].left, {375, 230}) < 1e-9);
  CHECK(work.seen.ribs[32].leftState == RibState::Locked);
  CHECK(work.seen.ribs[31] == before.ribs[31]);
  work.set(lockRib(work.scene(), 32, false));
  CHECK(distance(work.seen.ribs[32].left, {375, 230}) < 1e-9);
  CHECK(work.seen.ribs[32].leftState == RibState::Edited);
  work.set(dragEnd(work.scene(), {33, Side::Left}, {350, 150}, 0.2));
  CHECK(distance(work.seen.ribs[32].left, {375, 230}) > 5);
}

TEST_CASE("ribs are added one at a time and left out one at a time, down to two") {
  Work work(bandOf(12));
  Rng rng(5);
  for (int i = 0; i < 40; ++i) {
    const std::size_t before = work.seen.ribs.size();
    work.set(addRib(work.scene(), {rng.uniform(50, 750), rng.uniform(200, 400)}));
    CHECK(work.seen.ribs.size() == before + 1);
  }
  while (work.seen.ribs.size() > 2) {
    const std::size_t before = work.seen.ribs.size();
    work.set(removeRib(work.scene(), rng.below(static_cast<std::uint32_t>(before))));
    CHECK(work.seen.ribs.size() == before - 1);
  }
  CHECK(removeRib(work.scene(), 0) == work.edits);
}

TEST_CASE("a rib that was left out and added again is the same rib; an added one leaves no trace") {
  Work work(bandOf(40));
  const PicturePoint there = work.seen.ribs[17].center;
  work.set(removeRib(work.scene(), 17));
  CHECK(work.seen.ribs.size() == 39);
  work.set(addRib(work.scene(), there));
  CHECK(work.seen == work.band.ribs);
  work.set(addRib(work.scene(), lerp(there, work.seen.ribs[18].center, 0.5)));
  work.set(dragEnd(work.scene(), {18, Side::Left}, {400, 200}, 0));
  work.set(removeRib(work.scene(), 18));
  CHECK(work.edits.empty());
}

TEST_CASE("resetting a rib takes back what was done to it and nothing else") {
  Work work(bandOf(60));
  work.set(dragEnd(work.scene(), {10, Side::Left}, {200, 200}, 0));
  const RibEdits kept = work.edits;
  work.set(dragEnd(work.scene(), {40, Side::Left}, {450, 200}, 0.1));
  work.set(dragEnd(work.scene(), {40, Side::Right}, {450, 420}, 0));
  work.set(lockRib(work.scene(), 40, true));
  work.set(resetRib(work.scene(), 40));
  CHECK(work.edits == kept);
}

TEST_CASE("another place is taken by the end alone, or with the neighbours that it is in line with") {
  Work work(bandOf(80, 0));
  offer(work, 20, 45, 22);
  work.set(takeOtherPlace(work.scene(), {30, Side::Left}, 1, false));
  CHECK(work.edits.ends.size() == 1);
  CHECK(distance(work.seen.ribs[30].left, work.band.ribs.ribs[30].leftOthers.at[1]) < 1e-9);
  work.set({});
  work.set(takeOtherPlace(work.scene(), {30, Side::Left}, 1, true));
  CHECK(work.edits.ends.size() == 25);
  for (std::size_t i = 0; i < 80; ++i) {
    const Rib &was = work.band.ribs.ribs[i], &now = work.seen.ribs[i];
    if (i >= 20 && i < 45) {
      CHECK(distance(now.left, was.leftOthers.at[1]) < 1e-9);
    } else {
      CHECK(now == was);
    }
  }
  CHECK(takeOtherPlace(work.scene(), {30, Side::Left}, 2, true) == work.edits);
  CHECK(takeOtherPlace(work.scene(), {70, Side::Left}, 0, true) == work.edits);
}

TEST_CASE("hundreds of random gestures keep the edits valid and every rib finite") {
  for (const std::uint64_t seed : testing::seeds(0, 12)) {
    Rng rng(seed);
    Work work(bandOf(20 + static_cast<int>(rng.below(60))));
    for (int step = 0; step < 60; ++step) {
      const auto count = static_cast<std::uint32_t>(work.seen.ribs.size());
      const std::size_t rib = rng.below(count + 2);  // sometimes out of range
      const EndRef end{rib, rng.below(2) ? Side::Left : Side::Right};
      const PicturePoint p{rng.uniform(-100, 900), rng.uniform(-100, 700)};
      const EditScene scene = work.scene();
      switch (rng.below(8)) {
        case 0:
          work.set(dragEnd(scene, end, p, 0));
          break;
        case 1:
          work.set(dragEnd(scene, end, p, rng.uniform()));
          break;
        case 2:
          work.set(lockRib(scene, rib, rng.below(2) == 0));
          break;
        case 3:
          work.set(addRib(scene, p));
          break;
        case 4:
          work.set(removeRib(scene, rib));
          break;
        case 5:
          work.set(resetRib(scene, rib));
          break;
        case 6:
          work.set(takeOtherPlace(scene, end, static_cast<int>(rng.below(4)), true));
          break;
        default: {
          std::vector<PicturePoint> stroke;
          for (std::uint32_t i = rng.below(9); i-- > 0;) stroke.push_back({rng.uniform(0, 800), rng.uniform(0, 600)});
          work.set(deformByStroke(scene, stroke, rng.uniform(1, 200), rng.below(2) == 0).edits);
        }
      }
      for (const Rib& r : work.seen.ribs) {
        REQUIRE(isFinite(r.left));
        REQUIRE(isFinite(r.right));
      }
    }
  }
}
