#include "engine/inflate/skeleton.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "engine/geometry/pieces.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/spread.h"
#include "engine/inflate/interior.h"
#include "tests/support/named_shapes.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;

namespace {

/// The skeleton of a region of one piece, with the laws of a graph in it checked.
Skeleton skeletonIn(const geometry::Contours& contours, double sigma = kScale, double fineness = 1) {
  const auto pieces = geometry::piecesOf(contours);
  REQUIRE(pieces.size() == 1);
  Result<Skeleton> made = skeletonOf(pieces[0], sigma, fineness);
  REQUIRE(made.ok());
  const Skeleton& skeleton = made.value();
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  std::vector<int> degree(skeleton.points.size(), 0);
  for (const auto& branch : skeleton.branches) {
    REQUIRE(!branch.empty());
    for (std::size_t i = 1; i < branch.size(); ++i) {
      CHECK(branch[i] != branch[i - 1]);
      CHECK(edges.insert(std::minmax(branch[i], branch[i - 1])).second);
      ++degree[branch[i]], ++degree[branch[i - 1]];
    }
  }
  CHECK(std::ranges::count(degree, 1) == skeleton.ends);
  CHECK(static_cast<int>(edges.size()) - static_cast<int>(skeleton.points.size()) + 1 == skeleton.rings);
  CHECK(skeleton.rings == static_cast<int>(contours.size()) - 1);
  const geometry::PlaneRegion region = geometry::planeRegion(contours);
  const geometry::RimDistance rim(region.points, region.sizes);
  for (const SkeletonPoint& p : skeleton.points) {
    bool inside = false;
    for (const auto& contour : contours) {
      inside ^= geometry::holds(std::span<const PicturePoint>(contour), PicturePoint{p.at.x, -p.at.y});
    }
    constexpr double kCutOff = 0.2;  // pixels: even samples cut off the tip of a star
    CHECK((inside || p.radius < kCutOff));
    CHECK(p.radius == doctest::Approx(rim.to(p.at)));
  }
  return std::move(made).value();
}

double largestRadius(const Skeleton& skeleton) {
  return std::ranges::max_element(skeleton.points, {}, &SkeletonPoint::radius)->radius;
}

bool isAsNamed(const Skeleton& skeleton, const NamedShape& shape) {
  return skeleton.ends == shape.ends && skeleton.rings == shape.rings;
}

}  // namespace

TEST_CASE("the skeletons of named shapes have the ends and rings that a person would draw") {
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    const Skeleton skeleton = skeletonIn(shape.contours);
    CHECK(skeleton.ends == shape.ends);
    CHECK(skeleton.rings == shape.rings);
    for (const int points : {200, 900, 1500}) {
      CHECK(isAsNamed(skeletonIn(shape.contours, kScale, finenessFor(points)), shape));
    }
  }
}

TEST_CASE("tremor of 1 % and 2 % of the largest half width leaves ends and rings in at least 19 of 20 drawings" *
          doctest::test_suite("slow")) {
  std::map<std::string, int> wrong;
  int all = 0, sound = 0;
  for (const NamedShape& shape : namedShapes()) {
    const double width = largestRadius(skeletonIn(shape.contours));
    for (const double share : {0.01, 0.02}) {
      for (const double wave : {0.15, 0.6}) {
        int right = 0, drawings = 0;
        for (const std::uint64_t seed : testing::seeds(1, 21)) {
          CAPTURE(seed);
          right += isAsNamed(skeletonIn(trembling(shape.contours, share * width, wave * width, seed)), shape);
          ++drawings;
        }
        CAPTURE(shape.name);
        CAPTURE(share);
        CAPTURE(wave);
        CHECK(20 * right >= 19 * drawings);
        all += drawings;
        sound += right;
      }
    }
  }
  MESSAGE(sound << " of " << all << " trembling drawings have the ends and rings of the calm one");
}

TEST_CASE("turned, scaled or sampled otherwise, a shape keeps the ends, rings and length of its skeleton") {
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    const double length = lengthOf(skeletonIn(shape.contours)), size = largestRadius(skeletonIn(shape.contours));
    const auto check = [&](const geometry::Contours& contours, double scale) {
      const Skeleton skeleton = skeletonIn(contours);
      CHECK(skeleton.ends == shape.ends);
      CHECK(skeleton.rings == shape.rings);
      CHECK(std::abs(lengthOf(skeleton) / scale - length) <= 0.05 * length + 0.1 * size);
    };
    for (const double angle : {0.3, 1.1, 2.0, 4.4}) check(turnedAndScaled(shape.contours, angle, 1), 1);
    for (const double scale : {0.2, 7.0}) check(turnedAndScaled(shape.contours, 0.5, scale), scale);
    for (const double spacing : {1.0, 3.7, 9.0}) check(geometry::sampleRegion(shape.contours, spacing), 1);
  }
}

TEST_CASE("the skeletons of disc, stadium, rectangle and ring lie where they must") {
  const Skeleton disc = skeletonIn(namedShape("disc").contours);
  REQUIRE(disc.points.size() >= 1);
  for (const SkeletonPoint& p : disc.points) {
    CHECK(distance(p.at, {200, -200}) < 2);
    CHECK(p.radius == doctest::Approx(120).epsilon(0.01));
  }
  const Skeleton stadium = skeletonIn(namedShape("stadium").contours);
  double left = 400, right = 0;
  for (const SkeletonPoint& p : stadium.points) {
    CHECK(std::abs(p.at.y + 200) < 0.5);
    CHECK(p.radius == doctest::Approx(60).epsilon(0.01));
    left = std::min(left, p.at.x);
    right = std::max(right, p.at.x);
  }
  CHECK(std::abs(left - 80) < 3);  // the centres of the round ends
  CHECK(std::abs(right - 320) < 3);
  const Skeleton bar = skeletonIn(namedShape("rectangle").contours);
  for (const SkeletonPoint& p : bar.points) {
    CHECK(std::abs(p.at.y + 200) < 1);
    CHECK(p.at.x > 95);
    CHECK(p.at.x < 305);
  }
  const Skeleton ring = skeletonIn(namedShape("ring").contours);
  for (const SkeletonPoint& p : ring.points) {
    CHECK(distance(p.at, {200, -200}) == doctest::Approx(110).epsilon(0.005));
    CHECK(p.radius == doctest::Approx(40).epsilon(0.01));
  }
  CHECK(lengthOf(ring) == doctest::Approx(2 * 3.14159265 * 110).epsilon(0.01));
}

TEST_CASE("a larger scale leaves fewer ends, and rings stay") {
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    int ends = 1000;
    for (const double sigma : {1.1, 1.5, 3.0}) {
      const int now = skeletonIn(shape.contours, sigma).ends;
      CHECK(now <= ends);
      ends = now;
    }
  }
  CHECK(skeletonIn(namedShape("rectangle").contours, 1.1).ends == 4);  // a branch into every corner
  CHECK(skeletonIn(namedShape("square").contours, 1.1).ends == 4);
  CHECK(skeletonIn(namedShape("triangle").contours, 3).ends < 3);
}

TEST_CASE("skeletons of thin, sharp, tiny and random regions are graphs inside of them") {
  for (const Outline& outline :
       {rectangle(20, 100, 380, 103), Outline{{20, 200}, {380, 195}, {380, 205}}, ellipse({100, 100}, 2.5, 2.5, 20),
        rectangle(0, 0, 399, 399), Outline{{10, 10}, {390, 12}, {12, 390}}}) {
    const auto clean = geometry::cleanRegion({outline}, 0, {400, 400});
    REQUIRE(clean.ok());
    skeletonIn(clean.value());
  }
  for (const std::uint64_t seed : testing::seeds(1, 41)) {
    Rng rng(seed);
    geometry::Contours drawn{blob(rng, {200, 200}, rng.uniform(20, 130), 200)};
    if (seed % 2) drawn.push_back(ellipse({200, 200}, rng.uniform(4, 12), rng.uniform(4, 12), 40));
    const auto clean = geometry::cleanRegion(drawn, 0, {400, 400});
    REQUIRE(clean.ok());
    for (const auto& piece : geometry::piecesOf(clean.value())) skeletonIn(piece, rng.uniform(1.1, 3));
  }
}

TEST_CASE("of a fork whose branches are all shorter than what makes forks one a point is left") {
  int forks = 0, points = 0;
  for (double bulge = 0; bulge < 30; bulge += 0.25) {
    Outline outline;
    for (int i = 0; i < 220; ++i) {
      const double a = 6.283185307179586 * i / 220, r = 100 + bulge * std::cos(3 * a);
      outline.push_back({200 + r * std::cos(a), 200 + r * std::sin(a)});
    }
    const auto clean = geometry::cleanRegion({outline}, 0, {400, 400});
    REQUIRE(clean.ok());
    const Skeleton skeleton = skeletonIn(clean.value(), 1.1);
    REQUIRE(!skeleton.points.empty());
    CHECK((skeleton.ends == 0 || skeleton.ends == 2 || skeleton.ends == 3));
    points += skeleton.points.size() == 1;
    forks += skeleton.forks;
  }
  CHECK(points > 5);
  CHECK(forks > 5);
}

TEST_CASE("pieces are outer outlines with their own holes") {
  const auto clean = geometry::cleanRegion(
      {ellipse({100, 200}, 90, 90, 100), ellipse({100, 200}, 60, 60, 80), ellipse({100, 200}, 40, 40, 80),
       ellipse({90, 200}, 8, 8, 30), ellipse({110, 200}, 8, 8, 30), ellipse({300, 200}, 50, 50, 60)},
      0, {400, 400});
  REQUIRE(clean.ok());
  const auto pieces = geometry::piecesOf(clean.value());
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0].size() == 2);
  CHECK(pieces[1].size() == 3);
  CHECK(pieces[2].size() == 1);
}
