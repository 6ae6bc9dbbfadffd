#include "engine/geometry/region.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numbers>
#include <tuple>

#include "engine/geometry/polygon.h"
#include "engine/geometry/refine.h"
#include "tests/support/outlines.h"

using namespace spineloft;
using namespace spineloft::geometry;
using namespace spineloft::testing;

namespace {

constexpr PictureFrame kFrame{500, 400};

Contours cleaned(const Contours& drawn, double ribbon = 0) {
  const Result<Contours> clean = cleanRegion(drawn, ribbon, kFrame);
  REQUIRE(clean.ok());
  const PlaneRegion region = planeRegion(clean.value());
  CHECK(areSimple(region.points, region.sizes));
  return clean.value();
}

Error errorOf(const Contours& drawn, double ribbon = 0) {
  const Result<Contours> clean = cleanRegion(drawn, ribbon, kFrame);
  REQUIRE_FALSE(clean.ok());
  return clean.error();
}

}  // namespace

TEST_CASE("a simple outline comes back as it is, whichever way it was drawn") {
  Outline round = ellipse({200, 200}, 90, 60, 50);
  const Contours clean = cleaned({round});
  std::reverse(round.begin(), round.end());
  const Contours other = cleaned({round});
  REQUIRE(clean.size() == 1);
  REQUIRE(other.size() == 1);
  CHECK(clean[0].size() == 50);
  CHECK(areaOf(clean) == doctest::Approx(areaOf(other)));
  CHECK(areaOf(clean) > 0);
}

TEST_CASE("an outline within another is a hole, and one within that an island") {
  const Contours clean =
      cleaned({ellipse({200, 200}, 20, 20, 30), ellipse({200, 200}, 150, 150, 80), ellipse({200, 200}, 80, 80, 60)});
  CHECK(clean.size() == 3);
  double want = 0;
  using Ring = std::tuple<double, int, int>;
  for (const auto& [r, n, sign] : {Ring{150, 80, 1}, Ring{80, 60, -1}, Ring{20, 30, 1}}) {
    want += sign * 0.5 * n * r * r * std::sin(2 * std::numbers::pi / n);
  }
  CHECK(areaOf(clean) == doctest::Approx(want));
}

TEST_CASE("a figure of eight becomes two pieces, a pentagram loses its middle") {
  const Contours eight = cleaned({{{50, 50}, {250, 250}, {250, 50}, {50, 250}}});
  CHECK(eight.size() == 2);
  CHECK(areaOf(eight) == doctest::Approx(2 * 0.5 * 200 * 100).epsilon(0.01));
  Outline star;
  for (int i = 0; i < 5; ++i) {
    const double a = 2 * std::numbers::pi * (2 * i % 5) / 5;
    star.push_back({200 + 150 * std::sin(a), 200 - 150 * std::cos(a)});
  }
  bool middle = false;
  for (const Outline& piece : cleaned({star})) {
    const std::span<const PicturePoint> outline(piece);
    middle = middle != holds(outline, PicturePoint{200, 200});
  }
  CHECK_FALSE(middle);
}

TEST_CASE("random scribbles become simple outlines with the area that counting points gives") {
  Rng rng(11);
  for (int round = 0; round < 12; ++round) {
    Outline scribble;
    for (int i = 0; i < 9; ++i) scribble.push_back({rng.uniform(20, 480), rng.uniform(20, 380)});
    const Contours clean = cleaned({scribble});
    double inside = 0;
    for (int y = 0; y < 400; y += 2) {
      for (int x = 0; x < 500; x += 2) {
        inside += 4 * holds(std::span<const PicturePoint>(scribble), PicturePoint{x + 0.3, y + 0.4});
      }
    }
    CHECK(areaOf(clean) == doctest::Approx(inside).epsilon(0.03));
  }
}

TEST_CASE("what lies outside the picture is cut off at its edge") {
  const Contours clean = cleaned({ellipse({0, 200}, 100, 100, 200)});
  CHECK(areaOf(clean) == doctest::Approx(std::numbers::pi * 5000 + 100).epsilon(0.01));
  const Contours whole = cleaned({rectangle(-900, -900, 900, 900)});
  CHECK(areaOf(whole) == doctest::Approx(500 * 400).epsilon(0.01));
  for (const PicturePoint p : whole[0]) CHECK((p.x >= -0.5 && p.x <= 499.5 && p.y >= -0.5 && p.y <= 399.5));
}

TEST_CASE("an open line becomes a ribbon of its width with round ends; crossing lines leave a hole") {
  const Contours line = cleaned({{{100, 100}, {300, 100}}}, 20);
  CHECK(line.size() == 1);
  CHECK(areaOf(line) == doctest::Approx(200 * 20 + std::numbers::pi * 100).epsilon(0.01));
  const Contours loop = cleaned({{{100, 100}, {300, 100}, {300, 250}, {100, 250}, {100, 100}}}, 12);
  CHECK(loop.size() == 2);
  CHECK(cleaned({{{100, 100}, {300, 300}, {300, 100}, {100, 300}}}, 12).size() == 2);
}

TEST_CASE("nothing, a line there and back, a pixel and a speck are no regions") {
  CHECK(errorOf({}) == Error::RegionEmpty);
  CHECK(errorOf({{}}) == Error::RegionEmpty);
  CHECK(errorOf({{{5, 5}}}) == Error::RegionEmpty);
  CHECK(errorOf({{{5, 5}, {80, 90}, {5, 5}, {80, 90}}}) == Error::RegionEmpty);
  CHECK(errorOf({rectangle(10, 10, 11, 11)}) == Error::RegionEmpty);
  CHECK(errorOf({ellipse({900, 900}, 20, 20, 20)}) == Error::RegionEmpty);
}

TEST_CASE("sampling keeps corners and area, and stays simple where outlines are near each other") {
  const Contours square = {cleaned({rectangle(50, 50, 250, 250)})};
  const Contours sampled = sampleRegion(square, 13);
  for (const PicturePoint corner : square[0]) {
    CHECK(std::ranges::any_of(sampled[0], [&](PicturePoint p) { return distance(p, corner) < 1e-6; }));
  }
  CHECK(areaOf(sampled) == doctest::Approx(areaOf(square)));
  const Contours thin = cleaned({ellipse({200, 200}, 150, 150, 400), ellipse({200, 200}, 148, 148, 400)});
  const Contours coarse = sampleRegion(thin, 60);
  const PlaneRegion region = planeRegion(coarse);
  CHECK(areSimple(region.points, region.sizes));
}

TEST_CASE("points that are inserted keep the area and the rim, and every triangle its way round") {
  Rng rng(5);
  for (int round = 0; round < 5; ++round) {
    const Contours contours = cleaned({blob(rng, {200, 200}, 120, 70), ellipse({200, 200}, 30, 30, 20)});
    const PlaneRegion region = planeRegion(contours);
    PlaneMesh mesh(region.points, region.sizes);
    REQUIRE_FALSE(mesh.empty());
    for (int i = 0; i < 400; ++i) mesh.insert({rng.uniform(0, 400), -rng.uniform(0, 400)});
    mesh.splitChords();
    double area = 0;
    bool inner = true;
    for (const auto& t : mesh.triangles()) {
      const double twice = cross(mesh.points()[t[1]] - mesh.points()[t[0]], mesh.points()[t[2]] - mesh.points()[t[0]]);
      CHECK(twice > 0);
      area += twice / 2;
      inner = inner && (t[0] >= mesh.rim() || t[1] >= mesh.rim() || t[2] >= mesh.rim());
    }
    CHECK(area == doctest::Approx(areaOf(contours)));
    CHECK(inner);
    // Euler: a ring has V − E + F = 0, and each edge but those of the rim two triangles.
    const auto v = mesh.points().size(), f = mesh.triangles().size();
    CHECK(2 * v == f + mesh.rim());
  }
}
