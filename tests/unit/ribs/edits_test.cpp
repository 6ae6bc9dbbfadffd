#include "engine/ribs/edit/edits.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/loft/loft.h"
#include "engine/ribs/edit/places.h"
#include "engine/ribs/edit/rib_frame.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"
#include "tests/unit/ribs/edited_ribs.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Band;
using fixtures::bandOf;
using fixtures::endOf;
using fixtures::stateOf;

namespace {

constexpr Side kSides[] = {Side::Left, Side::Right};

EndEdit editTo(const Band& band, double at, Side side, PicturePoint to, double reach) {
  EndEdit edit{.at = at, .side = side, .reach = reach};
  Ruler(band.spine.points).toFrame(to, edit);
  return edit;
}

// Farthest that the line of one side lies from another's between two places.
double farthest(const Band& a, const Band& b, const RibEdits& edits, Side side, double from = 0, double to = 1) {
  const RibSet one = a.edited(edits), other = b.edited(edits);
  double most = 0;
  for (double at = from; at <= to; at += 0.005) {
    most = std::max(most, distance(fixtures::sideAt(a, one, side, at), fixtures::sideAt(b, other, side, at)));
  }
  return most;
}

int occludedStretches(const RibSet& set, Side side) {
  int count = 0;
  for (std::size_t i = 0; i + 1 < set.ribs.size(); ++i) {
    const PicturePoint a = set.ribs[i].center, b = endOf(set.ribs[i], side);
    const PicturePoint c = set.ribs[i + 1].center, d = endOf(set.ribs[i + 1], side);
    const bool ab = (cross(b - a, c - a) > 0) != (cross(b - a, d - a) > 0);
    const bool cd = (cross(d - c, a - c) > 0) != (cross(d - c, b - c) > 0);
    count += ab && cd ? 1 : 0;
  }
  return count;
}

}  // namespace

TEST_CASE("without edits the ribs come back bit for bit") {
  const Band band = bandOf(100);
  CHECK(band.edited({}) == band.ribs);
}

TEST_CASE("a dragged end goes where it was put, and ends beyond its reach stay bit for bit") {
  const Band band = bandOf(101);
  for (const double reach : {0.0, 0.004, 0.01, 0.1, 0.3}) {
    for (const Side side : kSides) {
      const PicturePoint to = endOf(band.ribs.ribs[40], side) + PicturePoint{4, -23};
      const double at = fixtures::placeOfRib(band, 40);
      const RibSet set = band.edited({{editTo(band, at, side, to, reach)}, {}, {}});
      CHECK(distance(endOf(set.ribs[40], side), to) < 1e-9);
      CHECK(stateOf(set.ribs[40], side) == RibState::Edited);
      for (std::size_t i = 0; i < set.ribs.size(); ++i) {
        const Side other = side == Side::Left ? Side::Right : Side::Left;
        CHECK(endOf(set.ribs[i], other) == endOf(band.ribs.ribs[i], other));
        const double away = std::abs(fixtures::placeOfRib(band, i) - at);
        if (i != 40 && away >= reach) CHECK(set.ribs[i] == band.ribs.ribs[i]);
      }
    }
  }
}

TEST_CASE("ends within reach follow less the farther away they are") {
  const Band band = bandOf(101, 0);
  const PicturePoint to = band.ribs.ribs[50].left + PicturePoint{0, -30};
  const RibSet set = band.edited({{editTo(band, 0.5, Side::Left, to, 0.2)}, {}, {}});
  double before = 30 + 1e-9;
  for (std::size_t i = 50; i < 72; ++i) {
    const PicturePoint by = set.ribs[i].left - band.ribs.ribs[i].left;
    CHECK(-by.y <= before);
    CHECK(-by.y >= 0);
    CHECK(std::abs(by.x) < 1e-9);
    before = -by.y;
  }
  CHECK(set.ribs[59].leftState == RibState::Edited);
  CHECK(set.ribs[61].leftState == RibState::Edge);
}

TEST_CASE("seeded random edits: finite ends, the count of ribs, and two ribs that stay") {
  for (const std::uint64_t seed : testing::seeds(0, 300)) {
    Rng rng(seed);
    const int count = 2 + static_cast<int>(rng.below(seed % 10 == 0 ? 4 : 120));
    const Band band = bandOf(count);
    const RibEdits edits = fixtures::randomEdits(rng);
    REQUIRE(isValid(edits));
    const RibSet set = band.edited(edits);
    CHECK(set.ribs.size() >= 2);
    CHECK(set.ribs.size() <= band.ribs.ribs.size() + edits.added.size());
    CHECK(set.ribs.size() + edits.removed.size() >= band.ribs.ribs.size());
    for (const Rib& rib : set.ribs) {
      for (const PicturePoint p : {rib.center, rib.left, rib.right}) {
        CHECK(isFinite(p));
        CHECK(norm(p - rib.center) < 3 * kFarthestEdit);
      }
      CHECK(std::isfinite(rib.leftLevel));
      CHECK(std::isfinite(rib.rightLevel));
    }
    for (const PicturePoint p : set.startFan.points) CHECK(isFinite(p));
    for (const PicturePoint p : set.endFan.points) CHECK(isFinite(p));
  }
}

TEST_CASE("added and left-out ribs are counted exactly and lie between their neighbours") {
  const Band band = bandOf(51);
  const RibSet set = band.edited({{}, {0.313, 0.5, 0.5001, 0.77}, {0.1, 0.101, 0.9}});
  // 0.5 has a rib, 0.5001 is the same one; 0.1 and 0.101 mean the same rib.
  CHECK(set.ribs.size() == 51 + 2 - 2);
  const auto added = std::ranges::count(set.ribs, RibState::Bridged, &Rib::leftState);
  CHECK(added == 2);
  const Ruler ruler(band.spine.points);
  const std::vector<double> places = ribPlaces(ruler, band.spine, set);
  CHECK(std::ranges::is_sorted(places));
  for (std::size_t i = 0; i < set.ribs.size(); ++i) {
    if (set.ribs[i].leftState != RibState::Bridged) continue;
    CHECK(distance(set.ribs[i].left, fixtures::sideAt(band, band.ribs, Side::Left, places[i])) < 1e-9);
    CHECK(distance(set.ribs[i].right, fixtures::sideAt(band, band.ribs, Side::Right, places[i])) < 1e-9);
  }
  std::vector<double> all;
  for (int i = 0; i <= 50; ++i) all.push_back(i / 50.0);
  CHECK(band.edited({{}, {}, all}).ribs.size() == 2);
}

TEST_CASE("a locked rib end never moves, whatever is edited later") {
  for (const std::uint64_t seed : testing::seeds(0, 100)) {
    Rng rng(seed);
    const Band band = bandOf(80);
    RibEdits edits = fixtures::randomEdits(rng);
    edits.added.clear();
    edits.removed.clear();
    const std::size_t rib = rng.below(80);
    const Side side = rng.below(2) ? Side::Left : Side::Right;
    const double at = Ruler(band.spine.points).placeOfPoint(rib);
    EndEdit lock = editTo(band, at, side, {rng.uniform(0, 800), rng.uniform(0, 600)}, 0);
    lock.locked = true;
    edits.ends.insert(edits.ends.begin(), lock);
    const RibSet first = band.edited({{lock}, {}, {}}), set = band.edited(edits);
    CHECK(endOf(set.ribs[rib], side) == endOf(first.ribs[rib], side));
    CHECK(stateOf(set.ribs[rib], side) == RibState::Locked);
  }
}

TEST_CASE("the shape of an edit does not depend on the number of ribs" * doctest::test_suite("slow")) {
  // Soft edits, and a whole row of single ends as a stroke makes them at 100 ribs.
  for (const std::uint64_t seed : testing::seeds(0, 6)) {
    Rng rng(seed);
    RibEdits edits;
    const Band fine = bandOf(400);
    if (seed % 2 == 0) {
      for (int i = 0; i < 12; ++i) {
        const double at = rng.uniform(), reach = rng.uniform(0.12, 0.4);
        EndEdit edit{.at = at, .side = rng.below(2) ? Side::Left : Side::Right};
        edit.out = rng.uniform(15, 90);
        edit.reach = reach;
        edits.ends.push_back(edit);
      }
    } else {
      const double phase = rng.uniform(0, 6);
      for (int i = 20; i < 70; ++i) {
        EndEdit edit{.at = i / 99.0, .side = Side::Left, .reach = 1 / 99.0};
        edit.out = 60 + 25 * std::sin(phase + 0.1 * i);
        edits.ends.push_back(edit);
      }
    }
    for (const int count : {50, 77, 100, 200, 333}) {
      const Band band = bandOf(count);
      // Straight pieces between ribs cut the waves of the outline; a step at the end of a row takes
      // as long as the ribs are apart.
      if (seed % 2 == 0) {
        for (const Side side : kSides) CHECK(farthest(band, fine, edits, side) < 3);
      } else {
        CHECK(farthest(band, fine, edits, Side::Left, 22 / 99.0, 67 / 99.0) < 1.5);
      }
    }
  }
}

TEST_CASE("a lone edit between few ribs is taken whole by the nearest end") {
  const Band band = bandOf(20);
  for (const double reach : {0.0, 0.002, 0.02}) {
    EndEdit edit{.at = 0.41, .side = Side::Right, .out = 90, .reach = reach};
    const RibSet set = band.edited({{edit}, {}, {}});
    const PicturePoint by =
        Ruler(band.spine.points).fromFrame(edit) - fixtures::sideAt(band, band.ribs, Side::Right, 0.41);
    CHECK(distance(set.ribs[8].right, band.ribs.ribs[8].right + by) < 1e-9);
    CHECK(set.ribs[8].rightState == RibState::Edited);
  }
}

TEST_CASE("when the spine is bent elsewhere, edits keep their place along it") {
  const Band band = bandOf(100, 0);
  EndEdit edit{.at = 0.3, .side = Side::Left, .along = 0, .out = 80, .reach = 0.05};
  for (const double bend : {0.0, 20.0, 60.0}) {
    const Band other = bandOf(100, bend);
    const RibSet set = other.edited({{edit}, {}, {}});
    std::size_t farthestRib = 0;
    double most = 0;
    for (std::size_t i = 0; i < 100; ++i) {
      const double moved = distance(set.ribs[i].left, other.ribs.ribs[i].left);
      if (moved > most) {
        most = moved;
        farthestRib = i;
      }
    }
    CHECK(std::abs(static_cast<double>(farthestRib) / 99 - 0.3) < 0.011);
    CHECK(distance(set.ribs[farthestRib].left, set.ribs[farthestRib].center) == doctest::Approx(80).epsilon(0.02));
  }
}

TEST_CASE("a mirrored part under mirrored edits is the mirrored result") {
  const double about = 900;
  const auto mirror = [&](PicturePoint p) { return PicturePoint{about - p.x, p.y}; };
  const Band band = bandOf(90), twin = bandOf(90, 40, about);
  for (const std::uint64_t seed : testing::seeds(0, 40)) {
    Rng rng(seed);
    const RibEdits edits = fixtures::randomEdits(rng, 1e-4);
    RibEdits swapped = edits;
    for (EndEdit& edit : swapped.ends) {
      edit.side = edit.side == Side::Left ? Side::Right : Side::Left;
    }
    const RibSet a = band.edited(edits), b = twin.edited(swapped);
    REQUIRE(a.ribs.size() == b.ribs.size());
    for (std::size_t i = 0; i < a.ribs.size(); ++i) {
      CHECK(distance(mirror(a.ribs[i].left), b.ribs[i].right) < 1e-6);
      CHECK(distance(mirror(a.ribs[i].right), b.ribs[i].left) < 1e-6);
      CHECK(a.ribs[i].leftState == b.ribs[i].rightState);
    }
  }
}

TEST_CASE("ends that follow a drag along the spine do not run across the dragged rib") {
  const Band band = bandOf(100, 0);
  for (const double along : {-60.0, -25.0, 25.0, 60.0}) {
    const PicturePoint to = band.ribs.ribs[50].left + PicturePoint{along, -10};
    const double at = Ruler(band.spine.points).placeOfPoint(50);
    // A reach as long as the drag: without making way the ends behind the bell fold over.
    const RibSet set = band.edited({{editTo(band, at, Side::Left, to, 0.12)}, {}, {}});
    CHECK(distance(set.ribs[50].left, to) < 1e-9);
    CHECK(occludedStretches(set, Side::Left) == 0);
  }
}

TEST_CASE("the fan of an end follows its rib by the same similarity") {
  const Band band = bandOf(60, 0);
  const Rib& first = band.ribs.ribs.front();
  // Twice as wide about the same centre.
  RibEdits edits;
  for (const Side side : kSides) {
    edits.ends.push_back(editTo(band, 0, side, first.center + (endOf(first, side) - first.center) * 2, 0));
  }
  const RibSet set = band.edited(edits);
  CHECK(set.endFan == band.ribs.endFan);
  for (std::size_t i = 0; i < set.startFan.points.size(); ++i) {
    const PicturePoint want = first.center + (band.ribs.startFan.points[i] - first.center) * 2;
    CHECK(distance(set.startFan.points[i], want) < 1e-6);
  }
}

TEST_CASE("a fan that is put on an end stands on its rib, wherever edits bring this") {
  const Band band = bandOf(60);
  for (const bool atStart : {true, false}) {
    CAPTURE(atStart);
    const EndFan& found = atStart ? band.ribs.startFan : band.ribs.endFan;
    const auto ribOf = [&](const RibSet& set) { return atStart ? set.ribs.front() : set.ribs.back(); };
    const auto frameOf = [&](const RibSet& set) { return RibFrame(ribOf(set).left, ribOf(set).right, atStart); };
    RibEdits edits;
    std::vector<RibPoint>& fan = atStart ? edits.startFan : edits.endFan;
    fan = frameOf(band.ribs).fromPicture(found.points);
    // From the left round to the right, outwards.
    CHECK(fan.front().y > 0);
    CHECK(fan.back().y < 0);
    CHECK(fan[fan.size() / 2].x > 0.5);
    const auto points = [&](const RibSet& set) { return atStart ? set.startFan.points : set.endFan.points; };
    // The one that was found, put there, is where it was; the other end and the ribs stay.
    const RibSet same = band.edited(edits);
    REQUIRE(points(same).size() == found.points.size());
    for (std::size_t i = 0; i < found.points.size(); ++i) CHECK(distance(points(same)[i], found.points[i]) < 1e-9);
    CHECK(same.ribs == band.ribs.ribs);
    CHECK((atStart ? same.endFan == band.ribs.endFan : same.startFan == band.ribs.startFan));
    // Another one is as it was put, and goes on to be so where the rib is another.
    fan = {{0.2, 0.9}, {1.5, 0.1}, {0.4, -1.1}};
    const std::size_t last = atStart ? 0 : band.ribs.ribs.size() - 1;
    edits.ends.push_back(editTo(band, last, Side::Left, ribOf(band.ribs).left + PicturePoint{7, -19}, 0));
    const RibSet moved = band.edited(edits);
    REQUIRE(points(moved).size() == 3);
    const std::vector<RibPoint> read = frameOf(moved).fromPicture(points(moved));
    for (std::size_t i = 0; i < 3; ++i) CHECK(distance(read[i], fan[i]) < 1e-9);
  }
}

TEST_CASE("fans of too many points, far off or of no number are no edits") {
  const std::vector<RibPoint> sound(kMostFanPoints, RibPoint{1, kFarthestFan});
  CHECK(isValid(RibEdits{.startFan = sound, .endFan = sound}));
  std::vector<RibPoint> long_ = sound, far = sound, none = sound;
  long_.push_back({1, 0});
  far[3].x = -1.01 * kFarthestFan;
  none[5].y = std::numeric_limits<double>::quiet_NaN();
  for (const auto& fan : {long_, far, none}) {
    CHECK_FALSE(isValid(RibEdits{.startFan = fan}));
    CHECK_FALSE(isValid(RibEdits{.endFan = fan}));
  }
}

TEST_CASE("lofts of edited ribs obey the mesh laws") {
  for (const std::uint64_t seed : testing::seeds(0, 150)) {
    Rng rng(seed);
    const Band band = bandOf(2 + static_cast<int>(rng.below(90)));
    const RibSet set = band.edited(fixtures::randomEdits(rng, seed % 3 ? 1e-4 : 1));
    loft::LoftParams params;
    params.sectionPoints = 16;
    const auto mesh = loft::loftRibs(set, {800, 600}, params);
    REQUIRE(mesh.ok());
    testing::requireLawful(mesh.value());
  }
}

TEST_CASE("edits that are not finite or out of range are invalid, and laid over ribs do no harm") {
  const Band band = bandOf(30);
  for (const EndEdit& edit :
       {EndEdit{.at = std::nan("")}, EndEdit{.at = 0.5, .along = std::nan("")}, EndEdit{.at = 0.5, .out = INFINITY},
        EndEdit{.at = 1.5}, EndEdit{.at = 0.5, .reach = -1}, EndEdit{.at = 0.5, .out = 2 * kFarthestEdit}}) {
    CHECK_FALSE(isValid({{edit}, {}, {}}));
    CHECK(band.edited({{edit}, {}, {}}) == band.ribs);
  }
  CHECK_FALSE(isValid({{}, {2}, {}}));
  CHECK_FALSE(isValid({{}, {}, {std::nan("")}}));
  CHECK(band.edited({{}, {-1}, {std::nan("")}}) == band.ribs);
}
