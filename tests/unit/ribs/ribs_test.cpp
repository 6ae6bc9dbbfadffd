#include "engine/ribs/search/ribs.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/vision/edges.h"
#include "tests/support/scarce_memory.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Points;

namespace {

constexpr image::Size kPicture{400, 300};

Spine spineOf(const Points& stroke) { return cleanSpine(stroke, kPicture, {.ribs = 60}).value(); }

// The ribs of both ends fan out towards the corners; laws about sides hold between them.
std::vector<Rib> inner(const RibSet& set) { return {set.ribs.begin() + 4, set.ribs.end() - 4}; }

RibSet trace(const Points& stroke, const image::EdgeMap& map) {
  const auto ribs = traceRibs(spineOf(stroke), map, kPicture, {}, Progress{});
  REQUIRE(ribs.ok());
  return ribs.value();
}

const image::EdgeMap& barMap() {
  static const image::EdgeMap map =
      fixtures::mapOf(kPicture, [](PicturePoint p) { return p.x > 50 && p.x < 350 && std::abs(p.y - 150) < 30; });
  return map;
}

}  // namespace

TEST_CASE("ribs of a bar end on its sides, on edges, with its width") {
  const RibSet set = trace({{75, 150}, {325, 150}}, barMap());
  REQUIRE(set.ribs.size() == 60);
  int edges = 0;
  for (const Rib& rib : inner(set)) {
    CHECK(std::abs(rib.left.y - 120) < 2.5);
    CHECK(std::abs(rib.right.y - 180) < 2.5);
    edges += (rib.leftState == RibState::Edge ? 1 : 0) + (rib.rightState == RibState::Edge ? 1 : 0);
    CHECK(rib.leftConfidence > 0.2);
    CHECK(rib.leftLevel > 0);
  }
  CHECK(edges >= 100);  // of 104
}

TEST_CASE("a stroke that is off the middle by a quarter of the width finds the same sides") {
  const RibSet set = trace({{75, 135}, {325, 135}}, barMap());
  int good = 0;
  for (const Rib& rib : inner(set)) {
    good += std::abs(rib.left.y - 120) < 2.5 && std::abs(rib.right.y - 180) < 2.5 ? 1 : 0;
  }
  CHECK(good == 52);
}

// A known gap: the network takes the line (assets/docs/accuracy.md, "Failures").
TEST_CASE("an inner line that mirrors the near side of a stroke off the middle is not the far side" *
          doctest::should_fail()) {
  const image::EdgeMap map = fixtures::mapOf(kPicture, [](PicturePoint p) {
    const double y = std::abs(p.y - 150);
    return p.x > 40 && p.x < 360 && y < 60 && y > 1.2;
  });
  const RibSet set = trace({{85, 120}, {315, 120}}, map);
  int good = 0;
  for (const Rib& rib : inner(set)) {
    good += std::abs(rib.left.y - 90) < 3 && std::abs(rib.right.y - 210) < 3 ? 1 : 0;
  }
  CHECK(good >= 48);  // of 52
}

TEST_CASE("a bottle has both its sides under a stroke that crosses its middle aslant") {
  for (const double neck : {14., 20.}) {
    const auto half = [&](double x) { return neck + (60 - neck) * std::clamp((x - 140) / 25, 0., 1.); };
    const image::EdgeMap map = fixtures::mapOf(
        kPicture, [&](PicturePoint p) { return p.x > 40 && p.x < 340 && std::abs(p.y - 150) < half(p.x); });
    for (const double from : {-0.5, 0.5}) {  // half widths: a quarter of the width
      CAPTURE(neck);
      CAPTURE(from);
      Points stroke;
      for (double x = 60; x <= 310; x += 5) stroke.push_back({x, 150 + from * (1 - (x - 60) / 125) * half(x)});
      int good = 0, all = 0;
      for (const Rib& rib : inner(trace(stroke, map))) {
        if (std::abs(rib.center.x - 155) < 40) continue;  // the shoulder
        const double out = half(rib.center.x);
        good += std::abs(rib.left.y - (150 - out)) < 6 && std::abs(rib.right.y - (150 + out)) < 6 ? 1 : 0;
        ++all;
      }
      CHECK(good >= 0.9 * all);
    }
  }
}

TEST_CASE("drawn backwards, left and right are swapped and the order is reversed") {
  const RibSet there = trace({{75, 147}, {200, 151}, {325, 150}}, barMap());
  const RibSet back = trace({{325, 150}, {200, 151}, {75, 147}}, barMap());
  REQUIRE(there.ribs.size() == back.ribs.size());
  for (std::size_t i = 0; i < there.ribs.size(); ++i) {
    const Rib& a = there.ribs[i];
    const Rib& b = back.ribs[back.ribs.size() - 1 - i];
    // The last ribs go with the shape of the end, which is one of a few.
    const bool isLast = i < 2 || i + 2 >= there.ribs.size();
    CHECK(distance(a.left, b.right) < (isLast ? 4 : 0.5));
    CHECK(distance(a.right, b.left) < (isLast ? 4 : 0.5));
  }
}

TEST_CASE("a piece of outline that is missing is bridged") {
  image::EdgeMap map =
      fixtures::mapOf(kPicture, [](PicturePoint p) { return p.x > 50 && p.x < 350 && std::abs(p.y - 150) < 30; });
  for (int y = 0; y < map.height; ++y) {
    for (int x = 160; x < 240; ++x) {
      const auto i = static_cast<std::size_t>(y * map.width + x);
      if (y > 150) continue;
      map.edges[i] = 0;
      map.gradientX[i] = map.gradientY[i] = 0;
      map.look[i] = {};
      map.look[i].set(0, 60);
    }
  }
  const RibSet set = trace({{75, 150}, {325, 150}}, map);
  for (const Rib& rib : inner(set)) CHECK(std::abs(rib.left.y - 120) < 4);
}

TEST_CASE("without a picture, and on blank paper, every end is guessed, a tenth of the length away on both sides") {
  const Points stroke{{75, 150}, {325, 150}};
  constexpr double half = 25;
  image::Image paper{kPicture.width, kPicture.height, {}};
  paper.pixels.assign(std::size_t{4} * kPicture.width * kPicture.height, 255);
  const auto blank = vision::detectEdges({std::move(paper), kPicture.width, kPicture.height}, {}, Progress());
  REQUIRE(blank.ok());
  for (const image::EdgeMap& map : {image::EdgeMap{}, blank.value()}) {
    const RibSet set = trace(stroke, map);
    CHECK(distance(set.ribs[30].center, set.ribs[30].left) == doctest::Approx(half).epsilon(0.1));
    for (const Rib& rib : set.ribs) {
      CHECK(rib.leftState == RibState::Guessed);
      CHECK(rib.rightState == RibState::Guessed);
      CHECK(distance(rib.center, rib.left) == doctest::Approx(distance(rib.center, rib.right)).epsilon(0.02));
    }
  }
}

TEST_CASE("a little ink far from a line on paper does not say how wide the part is") {
  constexpr double half = 25;
  for (const PicturePoint ink : {PicturePoint{200, 50}, {90, 255}, {320, 60}, {30, 40}}) {
    CAPTURE(ink.x);
    const image::EdgeMap map = fixtures::mapOf(
        kPicture, [&](PicturePoint p) { return std::max(std::abs(p.x - ink.x), std::abs(p.y - ink.y)) < 7; });
    const RibSet set = trace({{75, 150}, {325, 150}}, map);
    std::vector<double> wide;
    for (const Rib& rib : inner(set)) {
      for (const PicturePoint end : {rib.left, rib.right}) wide.push_back(distance(rib.center, end));
    }
    std::ranges::sort(wide);
    CHECK(wide[wide.size() / 2] == doctest::Approx(half).epsilon(0.1));
    CHECK(wide.back() < 2 * half);
  }
}

TEST_CASE("the end fan goes round from the left rib to the right one, about half a width out") {
  const RibSet set = trace({{75, 150}, {325, 150}}, barMap());
  REQUIRE(set.endFan.points.size() >= 3);
  double out = 0;
  for (PicturePoint p : set.endFan.points) out = std::max(out, p.x);
  CHECK(out > 335);
  CHECK(out < 370);
  CHECK(set.endFan.points.front().y < set.endFan.points.back().y);
  CHECK(set.startFan.points.front().y < set.startFan.points.back().y);
  for (PicturePoint p : set.startFan.points) CHECK(p.x < 80);
}

TEST_CASE("whatever the picture, ribs stay in the frame and those of one side never cross") {
  Rng rng(51);
  for (int round = 0; round < 12; ++round) {
    image::EdgeMap map = barMap();
    for (std::size_t i = 0; i < map.look.size(); ++i) {
      map.look[i].set(3, static_cast<float>(std::pow(rng.uniform(), 8)));
      map.look[i].set(0, static_cast<float>(rng.uniform(0, 100)));
      map.gradientX[i] = static_cast<float>(rng.uniform(-20, 20));
      map.gradientY[i] = static_cast<float>(rng.uniform(-20, 20));
    }
    Points stroke;
    const double bend = rng.uniform(-80, 80);
    for (int i = 0; i < 40; ++i) stroke.push_back({60 + 7.0 * i, 150 + bend * std::sin(i * 0.12)});
    const RibSet set = trace(stroke, map);
    for (std::size_t i = 0; i < set.ribs.size(); ++i) {
      const Rib& a = set.ribs[i];
      for (PicturePoint p : {a.left, a.right}) {
        CHECK((p.x >= -0.501 && p.y >= -0.501 && p.x <= 399.501 && p.y <= 299.501));
      }
      CHECK(std::isfinite(a.leftConfidence));
      CHECK(a.leftConfidence >= 0);
      CHECK(a.leftConfidence <= 1);
    }
  }
}

TEST_CASE("bad parameters, a spine of one point and cancelled work are refused by name") {
  const Spine spine = spineOf({{75, 150}, {325, 150}});
  const auto errorOf = [&](const Spine& s, const RibParams& params, const Progress& progress) {
    const auto ribs = traceRibs(s, barMap(), kPicture, params, progress);
    REQUIRE_FALSE(ribs.ok());
    return ribs.error();
  };
  CHECK(errorOf(spine, {.levels = 8}, {}) == Error::ValueOutOfRange);
  CHECK(errorOf(spine, {.maxLevelShare = 2}, {}) == Error::ValueOutOfRange);
  CHECK(errorOf({{{5, 5}}}, {}, {}) == Error::StrokeTooShort);
  Progress cancelled;
  cancelled.cancel();
  CHECK(errorOf(spine, {}, cancelled) == Error::Cancelled);
}

TEST_CASE("ribs do not depend on what their memory was used for before") {
  const image::EdgeMap map = barMap();
  RibWorkspace workspace;
  for (const auto& stroke :
       std::vector<fixtures::Points>{{{75, 150}, {325, 150}}, {{75, 135}, {325, 160}}, {{100, 150}, {200, 140}}}) {
    for (const image::EdgeMap& edges : {map, image::EdgeMap{}, map}) {
      for (const int levels : {128, 48}) {
        RibParams params;
        params.levels = levels;
        const auto fresh = traceRibs(spineOf(stroke), edges, kPicture, params, Progress());
        const auto again = traceRibs(spineOf(stroke), {edges, kPicture}, params, Progress(), workspace);
        REQUIRE(fresh.ok());
        REQUIRE(again.ok());
        CHECK(fresh.value() == again.value());
      }
    }
  }
}

TEST_CASE("from the second stroke on, tracing asks for little more than half the memory") {
  const image::EdgeMap map = barMap();
  const Spine spine = spineOf({{75, 150}, {325, 150}});
  const RibParams params;
  const Progress progress;
  RibWorkspace workspace;
  std::array<std::size_t, 3> bytes{};
  for (std::size_t& taken : bytes) {
    const std::size_t before = testing::allocatedBytes();
    REQUIRE(traceRibs(spine, {map, kPicture}, params, progress, workspace).ok());
    taken = testing::allocatedBytes() - before;
  }
  CHECK(bytes[1] * 5 < bytes[0] * 3);
  CHECK(bytes[2] == bytes[1]);
}
