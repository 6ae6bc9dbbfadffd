#include "engine/inflate/thin_rings.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "engine/inflate/interior.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/named_shapes.h"
#include "tests/support/puffs.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;

namespace {

constexpr double kLeast = kLeastRing * 400;  // pixels of the picture of named shapes

/// A box beside the bone and its mirror image for each of some spans of s, half a half width high.
InflateParams boxes(std::initializer_list<std::pair<double, double>> spans) {
  InflateParams params;
  params.points = 4000;
  sections::SectionShape shape;
  for (const auto& [from, to] : spans) {
    shape.contours.push_back({{from, -0.25}, {to, -0.25}, {to, 0.25}, {from, 0.25}});
    shape.contours.push_back({{-to, -0.25}, {-from, -0.25}, {-from, 0.25}, {-to, 0.25}});
  }
  params.profile.slices = {{shape}};
  return params;
}

int thinRingsOf(const char* shape, const InflateParams& params) {
  const auto interior = interiorOf(namedShape(shape).contours, params.bones, params.profile.slices, params.points);
  REQUIRE(interior.ok());
  return thinRings(interior.value().bones, {400, 400}, params);
}

}  // namespace

TEST_CASE("a ring thinner than 0.002 of the picture is drawn that thick") {
  const InflateParams params = boxes({{0.5, 0.501}});
  CHECK(thinRingsOf("disc", params) == 1);  // of radius 120: 0.12 pixels
  const Puffed tube = puffed(namedShape("disc").contours, params);
  CHECK(!mesh::selfCrossing(tube.mesh));
  CHECK(tube.report.shells == 1);
  CHECK(tube.report.genus == 1);
  const double high = 60 + kLeast - 0.12;
  CHECK(tube.report.volume == doctest::Approx(2 * std::numbers::pi * 60.06 * kLeast * high).epsilon(0.02));
}

TEST_CASE("a ring that is thick enough is drawn as it is") {
  const InflateParams params = boxes({{0.5, 0.51}});
  CHECK(thinRingsOf("disc", params) == 0);
  const Puffed tube = puffed(namedShape("disc").contours, params);
  CHECK(tube.report.volume == doctest::Approx(2 * std::numbers::pi * 60.6 * 1.2 * 60).epsilon(0.02));
}

TEST_CASE("a thin ring at the outline grows inwards") {
  const InflateParams params = boxes({{0.9995, 1}});
  CHECK(thinRingsOf("disc", params) == 1);
  const Puffed tube = puffed(namedShape("disc").contours, params);
  for (const auto& [x, y, z] : tube.mesh.positions) CHECK(std::hypot(x - 200, y + 200) < 120.01);
}

TEST_CASE("a thin ring of a puff of one side stays on that side") {
  InflateParams params = boxes({{0.5, 0.501}});
  for (const InflateSides side : {InflateSides::Front, InflateSides::Back}) {
    params.sides = side;
    CHECK(thinRingsOf("disc", params) == 1);
    const Puffed tube = puffed(namedShape("disc").contours, params);
    for (const auto& [x, y, z] : tube.mesh.positions) CHECK((side == InflateSides::Front ? z : -z) > -1e-6f);
  }
}

TEST_CASE("thin rings next to each other stay as they were drawn, lawful and apart") {
  const InflateParams params = boxes({{0.5, 0.501}, {0.503, 0.504}});
  CHECK(thinRingsOf("disc", params) == 0);
  const Puffed tubes = puffed(namedShape("disc").contours, params);
  CHECK(tubes.report.shells == 2);
  CHECK(!mesh::selfCrossing(tubes.mesh));
}

TEST_CASE("a thin ring on bent and forked regions is lawful") {
  for (const char* shape : {"hand", "ring", "star", "eight", "leaf"}) {
    CAPTURE(shape);
    const InflateParams params = boxes({{0.6, 0.6005}});
    CHECK(thinRingsOf(shape, params) == 1);
    CHECK(!mesh::selfCrossing(puffed(namedShape(shape).contours, params).mesh));
  }
}
