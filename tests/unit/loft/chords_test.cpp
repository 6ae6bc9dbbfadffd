#include "engine/loft/chords.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/generators.h"

using namespace spineloft;
using namespace spineloft::loft;
using namespace spineloft::testing;

namespace {

constexpr ChordLimits kLimits{0.02, 0.1};

std::vector<Chord> chordsOf(const ribs::RibSet& set) {
  std::vector<Chord> chords;
  for (const ribs::Rib& rib : set.ribs) chords.push_back({rib.left, rib.right});
  return chords;
}

/// How far two chords reach through each other, at the shallower side; 0 when they do not cross.
double crossingDepth(const Chord& a, const Chord& b) {
  const auto offsets = [](const Chord& line, const Chord& other) {
    const PicturePoint along = normalized(line.across());
    return std::pair{cross(along, other.left - line.left), cross(along, other.right - line.left)};
  };
  const auto [bl, br] = offsets(a, b);
  const auto [al, ar] = offsets(b, a);
  if (bl * br >= 0 || al * ar >= 0) return 0;
  return std::min({std::abs(bl), std::abs(br), std::abs(al), std::abs(ar)});
}

double deepestCrossing(const std::vector<Chord>& chords) {
  double deepest = 0;
  for (std::size_t i = 0; i < chords.size(); ++i) {
    for (std::size_t k = 1; k <= 8 && i + k < chords.size(); ++k) {
      deepest = std::max(deepest, crossingDepth(chords[i], chords[i + k]));
    }
  }
  return deepest;
}

/// Every end pulled in or out and every chord turned at random, by up to `share`.
std::vector<Chord> shaken(std::vector<Chord> chords, Rng& rng, double share) {
  for (Chord& chord : chords) {
    const PicturePoint middle = chord.middle();
    const double angle = share * rng.uniform(-0.6, 0.6);
    const auto moved = [&](PicturePoint end) {
      const PicturePoint d = (end - middle) * (1 + share * rng.uniform(-1, 1));
      return middle +
             PicturePoint{d.x * std::cos(angle) - d.y * std::sin(angle), d.x * std::sin(angle) + d.y * std::cos(angle)};
    };
    chord = {moved(chord.left), moved(chord.right)};
  }
  return chords;
}

}  // namespace

TEST_CASE("chords in order come back unchanged") {
  for (const auto& set : {straightRibs({10, 20}, {300, 200}, 50, [](double t) { return 30 + 20 * std::sin(9 * t); }),
                          arcRibs({400, 400}, 100, 90, 0, 3, 40), arcRibs({400, 400}, 100, 90, 3, 0, 40)}) {
    CHECK(orderChords(chordsOf(set), kLimits) == chordsOf(set));
  }
}

TEST_CASE("after repair no two nearby chords reach through each other, and most are kept") {
  Rng rng(1);
  int crossed = 0;
  for (int round = 0; round < 1500; ++round) {
    const auto chords = shaken(chordsOf(randomRibs(rng)), rng, round % 4 * 0.25);
    crossed += deepestCrossing(chords) > 1;
    const auto ordered = orderChords(chords, kLimits);
    CHECK(deepestCrossing(ordered) < 4 * kLimits.spacing);
    for (std::size_t i = 1; i < ordered.size(); ++i) {
      CHECK(distance(ordered[i].left, ordered[i - 1].left) >= 0.99 * kLimits.spacing);
      CHECK(distance(ordered[i].right, ordered[i - 1].right) >= 0.99 * kLimits.spacing);
    }
    if (chords.size() > 20) CHECK(ordered.size() * 2 > chords.size());
  }
  CHECK(crossed > 300);
}

TEST_CASE("one stray end among many is moved and the others stay") {
  auto chords = chordsOf(straightRibs({0, 100}, {400, 100}, 41, [](double) { return 60.0; }));
  chords[20].left.x += 75;
  const auto ordered = orderChords(chords, kLimits);
  REQUIRE(ordered.size() == chords.size());
  for (std::size_t i = 0; i < chords.size(); ++i) {
    if (i != 20) CHECK(ordered[i] == chords[i]);
  }
  CHECK(ordered[20].right == chords[20].right);
  CHECK(ordered[20].left.x == doctest::Approx(200));
}

TEST_CASE("two long chords that cross beyond a short one between them are parted") {
  std::vector<Chord> chords;
  for (int i = 0; i < 9; ++i) chords.push_back({{10.0 * i, 50}, {10.0 * i, 150}});
  chords[4] = {{40, 98}, {40, 102}};
  chords[3].left.x = 45;
  chords[5].left.x = 35;
  REQUIRE(deepestCrossing(chords) > 3);
  const auto ordered = orderChords(chords, kLimits);
  CHECK(deepestCrossing(ordered) == 0);
  CHECK(ordered.size() >= 8);
}

TEST_CASE("narrow chords grow square to the line of middles, others stay") {
  std::vector<Chord> chords;
  for (int i = 0; i < 5; ++i) chords.push_back({{10.0 * i, 50}, {10.0 * i, 50}});
  chords[2] = {{20, 40}, {20, 60}};
  widenChords(chords, kLimits);
  CHECK(chords[2] == Chord{{20, 40}, {20, 60}});
  for (const Chord& chord : chords) {
    CHECK(chord.width() >= kLimits.width * 0.999);
    CHECK(chord.across().x == doctest::Approx(0));
    CHECK(chord.across().y > 0);
  }
}

TEST_CASE("spread chords are clearly ahead of each other on both sides") {
  Rng rng(2);
  for (int round = 0; round < 300; ++round) {
    const auto chords = orderChords(chordsOf(hostileRibs(rng)), kLimits);
    auto spread = chords;
    spreadChords(spread, kLimits);
    REQUIRE_FALSE(spread.empty());
    for (std::size_t i = 1; i < spread.size(); ++i) {
      for (const PicturePoint across : {spread[i].across(), spread[i - 1].across()}) {
        const PicturePoint forward = normalized(forwardOf(across));
        CHECK(dot(spread[i].left - spread[i - 1].left, forward) > 0.9 * kLimits.spacing);
        CHECK(dot(spread[i].right - spread[i - 1].right, forward) > 0.9 * kLimits.spacing);
      }
    }
  }
}
