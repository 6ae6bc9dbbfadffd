#include "engine/ribs/search/ensemble.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "engine/ribs/ends/outline_crossing.h"
#include "engine/ribs/search/perturbed_strokes.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kPicture{400, 300};
constexpr double kHalf = 26;

double middleAt(double x) { return 150 + 30 * std::sin(0.015 * x); }

/// A bent thing, dark on light.
const image::EdgeMap& thing() {
  static const image::EdgeMap kMap = fixtures::mapOf(kPicture, [](PicturePoint p) {
    const double away = p.y - middleAt(p.x);
    return p.x > 40 && p.x < 360 && std::abs(away) < kHalf;
  });
  return kMap;
}

Spine spineAside(double aside, double from = 60, double to = 340) {
  fixtures::Points stroke;
  for (double x = from; x <= to; x += 4) stroke.push_back({x, middleAt(x) + aside});
  return cleanSpine(stroke, kPicture, {.ribs = 60}).value();
}

RibSet agreed(const Spine& spine, const image::EdgeMap& map) {
  RibWorkspace memory;
  return ensembleRibs(spine, {map, kPicture}, {}, Progress(), memory).value();
}

/// A straight part along y = 100 from x = 50 to 250, 40 wide, with nothing at its ends.
RibSet plank() {
  RibSet part;
  for (int i = 0; i <= 40; ++i) {
    const double x = 50 + 5 * i;
    part.ribs.push_back({.center = {x, 100}, .left = {x, 80}, .right = {x, 120}});
  }
  return part;
}

}  // namespace

TEST_CASE("another hand draws beside the stroke by a share of the width, on the side that is meant") {
  for (const double aside : {-0.2, -0.1, 0.1, 0.2}) {
    const auto stroke = strokeOf({aside, 0}, plank());
    REQUIRE(stroke.size() == plank().ribs.size());
    for (std::size_t i = 0; i < stroke.size(); ++i) {
      CHECK(stroke[i].x == doctest::Approx(plank().ribs[i].center.x));
      CHECK(stroke[i].y == doctest::Approx(100 - 40 * aside));  // left of a stroke to the right is up
    }
  }
}

TEST_CASE("another hand stops farther on, or earlier by a share of the width, but leaves most of a short stroke") {
  const auto longer = strokeOf({0, 0.2}, plank()), shorter = strokeOf({0, -0.3}, plank());
  CHECK(longer.front().x == doctest::Approx(42));
  CHECK(longer.back().x == doctest::Approx(258));
  CHECK(shorter.front().x == doctest::Approx(62));
  CHECK(shorter.back().x == doctest::Approx(238));
  RibSet broad = plank();
  for (Rib& rib : broad.ribs) rib.left.y = -200, rib.right.y = 400;
  const auto kept = strokeOf({0, -0.3}, broad);
  CHECK(kept.front().x == doctest::Approx(80));
  CHECK(kept.back().x == doctest::Approx(220));
}

TEST_CASE("one rib that reaches far does not throw another hand off the thing") {
  RibSet part = plank();
  part.ribs[20].left.y = -900;
  for (const PicturePoint& p : strokeOf({0.2, 0}, part)) CHECK(std::abs(p.y - 92) < 2);
}

TEST_CASE("how far curves lie within an outline is where small steps along them first leave it") {
  Rng rng(5);
  for (int round = 0; round < 12; ++round) {
    const Spine spine{fixtures::wander(rng, 24, 8)};
    D2Field field;
    field.assign(spine.points);
    GradientCurves curves;
    traceCurves(spine, field, makeLevels(48, 1, 90, field.length()), 7, {800, 800}, curves);
    // A star round a point near the spine, which leaves out part of it.
    std::vector<PicturePoint> outline;
    const PicturePoint about = spine.points[8] + PicturePoint{rng.uniform(-20, 20), rng.uniform(-20, 20)};
    for (int i = 0; i < 40; ++i) {
      const double angle = 2 * 3.14159265358979 * i / 40, r = rng.uniform(25, 80);
      outline.push_back(about + PicturePoint{std::cos(angle), std::sin(angle)} * r);
    }
    const auto inStar = [&](PicturePoint p) {
      bool in = false;  // even-odd: the same as winding for a star
      for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
        const PicturePoint a = outline[i], b = outline[j];
        if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) in = !in;
      }
      return in;
    };
    const std::vector<float> lengths = lengthsWithin(outline, curves);
    REQUIRE(lengths.size() == static_cast<std::size_t>(curves.layout.total()));
    for (int c = 0; c < curves.layout.total(); ++c) {
      const double whole = curves.along[curves.at(c, curves.reached[static_cast<std::size_t>(c)] - 1)];
      double walked = 0;
      while (walked < whole && inStar(curves.pointAlong(c, walked))) walked += 0.02;
      CHECK(std::abs(static_cast<double>(lengths[static_cast<std::size_t>(c)]) - std::min(walked, whole)) < 0.05);
    }
  }
}

TEST_CASE("where everything is clear, other hands change nothing") {
  const Spine spine = spineAside(3);
  RibWorkspace memory;
  const RibSet own = traceRibs(spine, {thing(), kPicture}, {}, Progress(), memory).value();
  const RibSet all = agreed(spine, thing());
  REQUIRE(own.ribs.size() == all.ribs.size());
  for (std::size_t i = 3; i + 3 < own.ribs.size(); ++i) {
    CHECK(distance(own.ribs[i].left, all.ribs[i].left) < 1);
    CHECK(distance(own.ribs[i].right, all.ribs[i].right) < 1);
    CHECK(all.ribs[i].leftState == RibState::Edge);
  }
}

TEST_CASE("strokes of two hands through one thing get parts that are more alike when others are asked") {
  // A line inside the thing runs near to where a stroke off the middle would stand.
  const image::EdgeMap map = fixtures::mapOf(kPicture, [](PicturePoint p) {
    const double away = p.y - middleAt(p.x);
    const bool stripe = away > 11 && away < 14 && p.x > 120 && p.x < 300 && std::fmod(p.x, 40) < 31;
    return p.x > 40 && p.x < 360 && std::abs(away) < kHalf && !stripe;
  });
  RibWorkspace memory;
  double alone = 0, asked = 0;
  for (const double aside : {-9.0, -5.0, 4.0, 8.0}) {
    const Spine spine = spineAside(aside);
    const RibSet own = traceRibs(spine, {map, kPicture}, {}, Progress(), memory).value();
    const RibSet all = agreed(spine, map);
    const auto off = [](const RibSet& set) {
      double sum = 0;
      for (const Rib& rib : set.ribs) {
        sum += std::abs(std::abs(rib.left.y - middleAt(rib.left.x)) - kHalf);
        sum += std::abs(std::abs(rib.right.y - middleAt(rib.right.x)) - kHalf);
      }
      return sum / (2 * static_cast<double>(set.ribs.size()));
    };
    alone += off(own);
    asked += off(all);
  }
  MESSAGE("off by " << alone / 4 << " px alone, " << asked / 4 << " px asked");
  CHECK(asked <= alone);
}

TEST_CASE("drawn backwards, the agreed ribs are the same ones to a pixel") {
  Spine spine = spineAside(6);
  const RibSet forwards = agreed(spine, thing());
  std::ranges::reverse(spine.points);
  const RibSet backwards = agreed(spine, thing());
  const std::size_t count = forwards.ribs.size();
  for (std::size_t i = 0; i < count; ++i) {
    CHECK(distance(forwards.ribs[i].left, backwards.ribs[count - 1 - i].right) < 1);
    CHECK(distance(forwards.ribs[i].right, backwards.ribs[count - 1 - i].left) < 1);
  }
}

TEST_CASE("memory that has seen other strokes changes no agreed rib and none of a single stroke") {
  RibWorkspace used, fresh;
  const PictureEvidence picture{thing(), kPicture};
  (void)ensembleRibs(spineAside(-12, 100, 200), picture, {}, Progress(), used);
  const Spine spine = spineAside(7);
  CHECK(ensembleRibs(spine, picture, {}, Progress(), used).value() ==
        ensembleRibs(spine, picture, {}, Progress(), fresh).value());
  CHECK(traceRibs(spine, picture, {}, Progress(), used).value() ==
        traceRibs(spine, picture, {}, Progress(), fresh).value());
}

TEST_CASE(
    "a curve or two of a fan that are decided otherwise than those beside them are no spikes; a step stays, and so do "
    "ribs") {
  const CurveLayout layout{5, 9};
  const auto curve = [](int c) { return static_cast<std::size_t>(c); };
  const std::vector<float> even(curve(layout.total()), 20.f);
  for (const int wide : {1, 2}) {
    for (int first = 0; first + wide <= layout.fan; ++first) {
      std::vector<float> atStart = even, atEnd = even;
      for (int i = first; i < first + wide; ++i)
        atStart[curve(layout.startFan(i))] = atEnd[curve(layout.endFan(i))] = 90;
      CHECK(withoutSpikes(atStart, layout) == even);
      CHECK(withoutSpikes(atEnd, layout) == even);
    }
  }
  std::vector<float> stepped = even, rib = even;
  for (int i = 4; i < layout.fan; ++i) stepped[curve(layout.endFan(i))] = 30;
  for (int i = 0; i < layout.ribs; ++i) stepped[curve(layout.right(i))] = 30;
  CHECK(withoutSpikes(stepped, layout) == stepped);
  rib[curve(layout.left(2))] = rib[curve(layout.right(2))] = 70;
  CHECK(withoutSpikes(rib, layout) == rib);
}

TEST_CASE("without a picture, or with three ribs, the stroke decides alone; bad input is refused as by itself") {
  RibWorkspace memory;
  const Spine spine = spineAside(0), brief{{{100, 150}, {150, 150}, {200, 150}}};
  const image::EdgeMap nothing;
  CHECK(ensembleRibs(spine, {nothing, kPicture}, {}, Progress(), memory).value() ==
        traceRibs(spine, {nothing, kPicture}, {}, Progress(), memory).value());
  CHECK(ensembleRibs(brief, {thing(), kPicture}, {}, Progress(), memory).value() ==
        traceRibs(brief, {thing(), kPicture}, {}, Progress(), memory).value());
  CHECK(ensembleRibs({{{1, 1}}}, {thing(), kPicture}, {}, Progress(), memory).error() == Error::StrokeTooShort);
  RibParams wrong;
  wrong.levels = 1;
  CHECK(ensembleRibs(spine, {thing(), kPicture}, wrong, Progress(), memory).error() == Error::ValueOutOfRange);
  const Progress progress;
  progress.cancel();
  CHECK(ensembleRibs(spine, {thing(), kPicture}, {}, progress, memory).error() == Error::Cancelled);
}

TEST_CASE("agreed ribs of random strokes, over a thing or beside it, are finite and in the picture") {
  Rng rng(31);
  RibWorkspace memory;
  for (int round = 0; round < 12; ++round) {
    fixtures::Points stroke;
    const double y = rng.uniform(20, 280), slope = rng.uniform(-0.4, 0.4), bend = rng.uniform(0, 25);
    for (double x = rng.uniform(2, 150); x < 395; x += 6)
      stroke.push_back({x, std::clamp(y + slope * (x - 200) + bend * std::sin(x / 20), 1.0, 298.0)});
    const auto spine = cleanSpine(stroke, kPicture, {.ribs = 50});
    if (!spine) continue;
    const RibSet set = ensembleRibs(spine.value(), {thing(), kPicture}, {}, Progress(), memory).value();
    REQUIRE(set.ribs.size() == spine.value().points.size());
    for (std::size_t i = 0; i < set.ribs.size(); ++i) {
      for (const PicturePoint p : {set.ribs[i].left, set.ribs[i].right}) {
        REQUIRE(isFinite(p));
        CHECK(p.x > -1.01);
        CHECK(p.x < kPicture.width + 0.01);
        CHECK(p.y > -1.01);
        CHECK(p.y < kPicture.height + 0.01);
      }
    }
  }
}
