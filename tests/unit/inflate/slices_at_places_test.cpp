// Puffs with several slices: each at its place, blended along the skeleton.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "engine/base/rng.h"
#include "engine/geometry/pieces.h"
#include "engine/inflate/inflate.h"
#include "engine/inflate/interior.h"
#include "engine/inflate/profile.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/named_shapes.h"
#include "tests/support/outlines.h"
#include "tests/support/puffs.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;
using sections::SectionShape;

namespace {

SectionShape ready(const char* key) { return readyProfile(key)->slices.front().shape; }
const char* const kBodies[] = {"round", "roof", "block", "step", "bowl"};

InflateParams puffOf(std::vector<ProfileSlice> slices, int points = 3000) {
  InflateParams params;
  params.points = points;
  params.profile.slices = std::move(slices);
  return params;
}

/// The largest z of the corners within `reach` of a place.
double topNear(const mesh::TriMesh& mesh, double x, double y, double reach) {
  double top = 0;
  for (const auto& p : mesh.positions) {
    if (std::hypot(static_cast<double>(p[0]) - x, static_cast<double>(p[1]) + y) < reach)
      top = std::max(top, static_cast<double>(p[2]));
  }
  return top;
}
/// How far corners near the plane x are off the curve |y| / w + |z| / w = 1 of a roof, or off the circle.
double offAt(const mesh::TriMesh& mesh, double x, bool roof) {
  double most = 0;
  for (const auto& p : mesh.positions) {
    if (std::abs(static_cast<double>(p[0]) - x) > 4) continue;
    const double y = std::abs(static_cast<double>(p[1]) + 200) / 60, z = std::abs(static_cast<double>(p[2])) / 60;
    most = std::max(most, std::abs((roof ? y + z : std::hypot(y, z)) - 1));
  }
  return most;
}

}  // namespace

TEST_CASE("slices of the same look at any places make the puff of one of them") {
  for (const char* name : {"stadium", "T", "ring", "hand"}) {
    CAPTURE(std::string(name));
    const geometry::Contours& region = namedShape(name).contours;
    const Puffed one = puffed(region, puffOf({{ready("round")}}));
    const Puffed two = puffed(region, puffOf({{ready("round")}, {ready("round"), PicturePoint{120, 200}}}));
    CHECK(two.report.volume == doctest::Approx(one.report.volume).epsilon(2e-3));
    CHECK(two.report.genus == one.report.genus);
  }
}

TEST_CASE("each slice is what the puff is at its place, and between two places it passes from one to the other") {
  // A stadium of half width 60 from x = 80 to 320.
  const geometry::Contours& region = namedShape("stadium").contours;
  const InflateParams both =
      puffOf({{ready("round"), PicturePoint{100, 200}}, {ready("roof"), PicturePoint{300, 200}}}, 6000);
  const Puffed made = puffed(region, both);
  CHECK(!mesh::selfCrossing(made.mesh));
  CHECK(offAt(made.mesh, 100, false) < 0.06);
  CHECK(offAt(made.mesh, 300, true) < 0.06);
  // Half way each has its half: on the way at y = 30 the circle is 0.866 high, the roof 0.5.
  const double between = topNear(made.mesh, 200, 170, 6) / 60;
  CHECK(between > 0.57);
  CHECK(between < 0.8);
}

TEST_CASE("a slice beside one without a place is local: it fades along the skeleton") {
  const geometry::Contours& region = namedShape("stadium").contours;
  SectionShape low = ready("block");
  for (auto& p : low.contours[0]) p.y *= 0.5;
  const Puffed made = puffed(region, puffOf({{ready("block")}, {low, PicturePoint{100, 200}}}, 5000));
  CHECK(topNear(made.mesh, 100, 200, 8) == doctest::Approx(0.2 * 60).epsilon(0.12));
  const double far = topNear(made.mesh, 320, 200, 12);
  CHECK(far > 0.3 * 60);
  CHECK(far <= 0.4 * 60 * 1.001);
}

TEST_CASE("a slice at a place that the outline lacks sleeps; of two pieces each has what is on it") {
  const geometry::Contours& region = namedShape("stadium").contours;
  const InflateParams away = puffOf({{ready("round")}, {ready("roof"), PicturePoint{200, 20}}});
  const auto interior = interiorOf(region, {}, away.profile.slices, away.points);
  REQUIRE(interior.ok());
  CHECK(asleep(interior.value().bones) == 1);
  const Puffed made = puffed(region, away), plain = puffed(region, puffOf({{ready("round")}}));
  CHECK(made.report.volume == doctest::Approx(plain.report.volume).epsilon(2e-3));

  const geometry::Contours pair{ellipse({100, 200}, 60, 60, 80), ellipse({300, 200}, 60, 60, 80)};
  const auto clean = geometry::cleanRegion(pair, 0, {400, 400});
  REQUIRE(clean.ok());
  const Puffed discs = puffed(
      clean.value(), puffOf({{ready("round"), PicturePoint{100, 200}}, {ready("roof"), PicturePoint{300, 200}}}));
  CHECK(topNear(discs.mesh, 100, 230, 6) / 60 == doctest::Approx(0.866).epsilon(0.03));
  CHECK(topNear(discs.mesh, 300, 230, 6) / 60 < 0.6);
}

TEST_CASE("slices that do not match are refused with what is wrong") {
  const auto why = [](std::vector<ProfileSlice> slices) {
    const auto curves = matchedCurves(slices, InflateSides::Both);
    REQUIRE_FALSE(curves.ok());
    CHECK(curves.error() == Error::SectionInvalid);
    return curves.failure().detail;
  };
  const PicturePoint there{100, 200};
  CHECK(why({{ready("round")}, {ready("ring"), there}}).find("as many") != std::string::npos);
  CHECK(why({{ready("ring")}, {ready("two-rings"), there}}).find("as many") != std::string::npos);
  CHECK(why({{ready("round")}, {ready("roof")}}).find("no place") != std::string::npos);
  // A body below the plane and one above, whose blend would be flat in the middle, still is no crossing; a hole that
  // would leave its body is.
  SectionShape wide, narrow;
  wide.contours = {{{-1, -0.9}, {1, -0.9}, {1, 0.9}, {-1, 0.9}}, {{-0.5, 0.5}, {0.5, 0.5}, {0.5, 0.8}, {-0.5, 0.8}}};
  narrow.contours = {{{-1, -0.9}, {1, -0.9}, {1, 0.1}, {-1, 0.1}},
                     {{-0.5, -0.8}, {0.5, -0.8}, {0.5, -0.5}, {-0.5, -0.5}}};
  CHECK(matchedCurves(std::vector<ProfileSlice>{{wide}, {narrow, there}}, InflateSides::Both).ok());
  InflateParams many = puffOf({});
  for (std::size_t i = 0; i <= kMostSlices; ++i)
    many.profile.slices.push_back({ready("round"), PicturePoint{100, 200}});
  CHECK_FALSE(isValid(many));
  many.profile.slices.resize(1);
  many.profile.slices[0].at = PicturePoint{std::nan(""), 0};
  CHECK_FALSE(isValid(many));
}

TEST_CASE("random shapes with several ready slices at random places are lawful and do not cross themselves") {
  int crossing = 0;
  for (const std::uint64_t seed : testing::seeds(1, 24)) {
    CAPTURE(seed);
    Rng rng(seed);
    const NamedShape& shape = namedShapes()[rng.below(namedShapes().size())];
    CAPTURE(shape.name);
    std::vector<ProfileSlice> slices;
    const auto sides = static_cast<InflateSides>(rng.below(3));
    const std::uint32_t bodies = sides == InflateSides::Both ? 5 : 4;  // half a bowl is a ring
    if (rng.below(2) == 0) slices.push_back({ready(kBodies[rng.below(bodies)])});
    const std::size_t count = 2 + rng.below(3);
    while (slices.size() < count)
      slices.push_back({ready(kBodies[rng.below(bodies)]), PicturePoint{rng.uniform(40, 360), rng.uniform(40, 360)}});
    InflateParams params = puffOf(slices, 1500);
    params.sides = sides;
    params.profile.follow = rng.uniform(0, 1);
    const Puffed made = puffed(shape.contours, params);
    CHECK(made.report.genus == shape.rings);
    crossing += mesh::selfCrossing(made.mesh) ? 1 : 0;
  }
  CHECK(crossing == 0);
}
