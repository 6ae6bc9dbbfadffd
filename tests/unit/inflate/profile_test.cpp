#include "engine/inflate/profile.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "engine/geometry/pieces.h"
#include "engine/inflate/inflate.h"
#include "engine/inflate/interior.h"
#include "engine/inflate/poisson_height.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/mesh_angles.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/named_shapes.h"
#include "tests/support/outlines.h"
#include "tests/support/puffs.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;
using sections::SectionPreset;
using sections::SectionShape;

namespace {

constexpr double kPi = std::numbers::pi;

SectionShape drawn(std::vector<std::vector<SectionPoint>> contours) {
  SectionShape shape;
  shape.contours = std::move(contours);
  return shape;
}
std::vector<SectionPoint> box(double left, double low, double right, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}
/// With its mirror image.
std::vector<std::vector<SectionPoint>> twice(std::vector<std::vector<SectionPoint>> right) {
  const auto half = right;
  for (auto curve : half) {
    for (SectionPoint& p : curve) p.x = -p.x;
    right.push_back(std::move(curve));
  }
  return right;
}
const SectionShape kCircle{SectionPreset::Circle}, kSquare{SectionPreset::Square};
const SectionShape kRoof = drawn({{{-1, 0}, {0, -1}, {1, 0}, {0, 1}}});
const SectionShape kRing = drawn(twice({box(0.4, -0.3, 0.8, 0.3)}));
const SectionShape kRingsWithHoles = drawn(twice(
    {box(0.15, -0.3, 0.45, 0.3), box(0.25, -0.1, 0.35, 0.1), box(0.6, -0.3, 0.95, 0.3), box(0.7, -0.1, 0.85, 0.1)}));
const SectionShape kCavity =
    drawn({{{-1, 0}, {-0.7, -0.7}, {0, -1}, {0.7, -0.7}, {1, 0}, {0.7, 0.7}, {0, 1}, {-0.7, 0.7}},
           box(-0.4, -0.4, 0.4, 0.4)});
const SectionShape kMushroom =
    drawn({{{-0.3, -1}, {0.3, -1}, {0.3, 0.2}, {1, 0.1}, {0.8, 0.6}, {0, 1}, {-0.8, 0.6}, {-1, 0.1}, {-0.3, 0.2}}});
const SectionShape kBodyAndRing =
    drawn({{{-0.4, -0.5}, {0.4, -0.5}, {0.4, 0.5}, {-0.4, 0.5}}, box(0.6, -0.3, 0.9, 0.3), box(-0.9, -0.3, -0.6, 0.3)});

InflateParams paramsOf(const SectionShape& shape, int points = 3000, double follow = 1) {
  InflateParams params;
  params.points = points;
  params.profile.slices = {{shape}};
  params.profile.follow = follow;
  return params;
}

/// It does not go through itself either.
Puffed whole(const geometry::Contours& contours, const InflateParams& params) {
  Puffed made = puffed(contours, params);
  CHECK(!mesh::selfCrossing(made.mesh));
  return made;
}
Puffed whole(const char* name, const InflateParams& params) { return whole(namedShape(name).contours, params); }

/// RMS and largest of `off(p)` over the corners of a mesh, weighted by the areas round them.
template <class Off>
std::pair<double, double> offOver(const mesh::TriMesh& mesh, const Off& off) {
  double sum = 0, area = 0, most = 0;
  for (const auto& t : mesh.triangles) {
    const auto at = [&](std::size_t c) {
      const auto& p = mesh.positions[t[c]];
      return ModelPoint{p[0], p[1], p[2]};
    };
    const double own = norm(cross(at(1) - at(0), at(2) - at(0)));
    for (std::size_t c = 0; c < 3; ++c) {
      const double away = std::abs(off(at(c)));
      sum += own * away * away;
      area += own;
      most = std::max(most, away);
    }
  }
  return {std::sqrt(sum / area), most};
}

}  // namespace

TEST_CASE("a round slice makes a ball of a disc, a capsule of a stadium, a torus of a ring") {
  const Puffed ball = whole("disc", paramsOf(kCircle, 4000));
  const auto [ballMean, ballMost] =
      offOver(ball.mesh, [](ModelPoint p) { return norm(p - ModelPoint{200, -200, 0}) / 120 - 1; });
  CHECK(ballMean < 0.005);
  const Puffed capsule = whole("stadium", paramsOf(kCircle, 4000));
  const auto [capsuleMean, capsuleMost] = offOver(
      capsule.mesh, [](ModelPoint p) { return norm(p - ModelPoint{std::clamp(p.x, 80.0, 320.0), -200, 0}) / 60 - 1; });
  CHECK(capsuleMean < 0.01);
  CHECK(capsuleMost < 0.03);
  const Puffed torus = whole("ring", paramsOf(kCircle, 4000));
  const auto [torusMean, torusMost] = offOver(
      torus.mesh, [](ModelPoint p) { return std::hypot(std::hypot(p.x - 200, p.y + 200) - 110, p.z) / 40 - 1; });
  CHECK(torusMean < 0.01);
  CHECK(torus.report.genus == 1);
  MESSAGE("off in %: ball " << 100 * ballMean << " RMS, capsule " << 100 * capsuleMean << " RMS " << 100 * capsuleMost
                            << " most, torus " << 100 * torusMean << " RMS");
}

TEST_CASE("a square slice of the same thickness makes a prism") {
  for (const char* name : {"disc", "T", "star", "ring", "A"}) {
    CAPTURE(name);
    const Puffed made = whole(name, paramsOf(kSquare, 3000, 0));
    double high = 0;
    for (const auto& p : made.mesh.positions) high = std::max(high, static_cast<double>(p[2]));
    const double prism = 2 * high * geometry::areaOf(namedShape(name).contours);
    CHECK(made.report.volume == doctest::Approx(prism).epsilon(0.002));
    for (const auto& p : made.mesh.positions) CHECK(std::abs(p[2]) <= high * 1.0001);
    for (const auto& t : made.mesh.triangles) {
      const auto at = [&](std::size_t c) {
        const auto& p = made.mesh.positions[t[c]];
        return ModelPoint{p[0], p[1], p[2]};
      };
      const ModelPoint normal = normalized(cross(at(1) - at(0), at(2) - at(0)));
      CHECK(std::min(std::abs(normal.z), std::hypot(normal.x, normal.y)) < std::sin(0.5 * kPi / 180));
    }
  }
}

TEST_CASE("a roof makes a double cone of a disc and a ridge of 90 degrees along a stadium") {
  const Puffed cone = whole("disc", paramsOf(kRoof, 4000));
  CHECK(cone.report.volume == doctest::Approx(2 * kPi * 120 * 120 * 120 / 3).epsilon(0.01));
  const Puffed ridge = whole("stadium", paramsOf(kRoof, 4000));
  int edges = 0;
  eachDihedral(ridge.mesh, [&](ModelPoint a, ModelPoint b, double angle) {
    // One half width off its ends, where the strip passes into the round end.
    const bool onRidge = a.z > 59 && b.z > 59 && std::max(std::abs(a.x - 200), std::abs(b.x - 200)) < 65;
    if (!onRidge) return;
    CHECK(std::abs(angle - 90) < 3);
    ++edges;
  });
  CHECK(edges > 10);
}

TEST_CASE("a round slice is smooth off the outline and off the narrowest tips") {
  for (const char* name : {"hand", "X", "T", "eight", "leaf", "star"}) {
    CAPTURE(std::string(name));
    const geometry::Contours& region = namedShape(name).contours;
    const Puffed made = whole(region, paramsOf(kCircle, 6000));
    const auto interior = interiorOf(region, {}, {}, 6000);
    REQUIRE(interior.ok());
    const Fields& fields = interior.value().fields.front();
    const double widest = std::ranges::max(fields.half);
    std::vector<double> angles;
    eachDihedral(made.mesh, [&](ModelPoint a, ModelPoint b, double angle) {
      constexpr double kOffRim = 0.8, kTip = 0.2;  // s; of the largest half width
      const SectionPoint p{a.x, a.y}, q{b.x, b.y};
      if (!fields.mesh.find(p) || !fields.mesh.find(q)) return;
      if (std::max(valueAt(fields.mesh, fields.s, p), valueAt(fields.mesh, fields.s, q)) > kOffRim) return;
      if (valueAt(fields.mesh, fields.half, p) > kTip * widest) angles.push_back(angle);
    });
    REQUIRE(angles.size() > 1000);
    std::ranges::sort(angles);
    const double best = angles[angles.size() * 99 / 100];
    MESSAGE(std::string(name) << ": 99 % turn by up to " << best << ", all by up to " << angles.back() << " degrees");
    CHECK(best <= 15);
    CHECK(angles.back() <= 30);
  }
}

TEST_CASE("under the pen, with coarser skeleton and fields, a puff is nearly what it is with full ones") {
  double most = 0;
  for (const NamedShape& shape : namedShapes()) {
    for (const ReadyProfile& ready : readyProfiles()) {
      CAPTURE(shape.name);
      CAPTURE(std::string(ready.key));
      const InflateParams params{.points = 900, .profile = *readyProfile(ready.key)};
      if (params.profile.isSoft()) continue;
      const Puffed coarse = puffed(shape.contours, params);
      const auto interior = interiorOf(shape.contours, {}, {}, 4000);
      REQUIRE(interior.ok());
      const auto full = inflateAlong(interior.value(), kPuffPicture, params);
      REQUIRE(full.ok());
      const mesh::MeshReport report = requireLawful(full.value());
      CHECK(coarse.report.shells == report.shells);
      CHECK(coarse.report.genus == report.genus);
      most = std::max(most, std::abs(coarse.report.volume / report.volume - 1));
    }
  }
  MESSAGE("the volume differs by up to " << 100 * most << " %");
  CHECK(most < 0.03);
}

TEST_CASE("a puff of few points has about as many, however narrow it is, and nearly the volume of a fine one") {
  double most = 0;
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    constexpr int kFew = 900;
    const Puffed coarse = whole(shape.contours, paramsOf(kCircle, kFew));
    CHECK(coarse.mesh.positions.size() < 1.75 * kFew);
    const Puffed fine = puffed(shape.contours, paramsOf(kCircle, 4000));
    most = std::max(most, std::abs(coarse.report.volume / fine.report.volume - 1));
  }
  MESSAGE("the volume differs by up to " << 100 * most << " %");
  CHECK(most < 0.05);
}

TEST_CASE("shells and handles follow from the curves of the slice and the holes of the region") {
  const std::pair<const char*, const SectionShape*> slices[] = {
      {"circle", &kCircle}, {"ring", &kRing},         {"rings with holes", &kRingsWithHoles},
      {"cavity", &kCavity}, {"mushroom", &kMushroom}, {"body and ring", &kBodyAndRing}};
  for (const char* name : {"disc", "ring", "eight", "A", "G", "star", "hand"}) {
    for (const auto& [slice, shape] : slices) {
      CAPTURE(std::string(name));
      CAPTURE(std::string(slice));
      const Puffed made = whole(name, paramsOf(*shape, 4000));
      const auto curves = profileCurves(*shape, InflateSides::Both);
      REQUIRE(curves.ok());
      const Topology expected = topologyOf(curves.value(), namedShape(name).rings);
      CHECK(made.report.shells == expected.shells);
      CHECK(made.report.genus == expected.genus);
    }
  }
  CHECK(whole("eight", paramsOf(kCircle)).report.genus == 2);
  CHECK(whole("G", paramsOf(kRingsWithHoles)).report.genus == 4);
}

TEST_CASE("every shape with every slice is lawful, does not cross itself, and has good triangles") {
  double worst = 90;
  std::uint64_t count = 0;
  for (const NamedShape& shape : namedShapes()) {
    std::vector<InflateParams> all = {paramsOf(kMushroom)};
    for (const ReadyProfile& ready : readyProfiles())
      all.push_back({.points = 3000, .profile = *readyProfile(ready.key)});
    for (const InflateParams& params : all) {
      if (!testing::takes(++count)) continue;
      CAPTURE(shape.name);
      CAPTURE(std::string(profileKey(params.profile)));
      const Puffed made = whole(shape.contours, params);
      const std::vector<double> angles = anglesOf(made.mesh);
      worst = std::min(worst, angles[angles.size() / 100]);
    }
  }
  MESSAGE("the smallest angle of the best 99 % is " << worst << " degrees");
  CHECK(worst > 15);
}

TEST_CASE("a ready profile is known by its slice, cut or not, and has the shells and handles of its curves") {
  CHECK_FALSE(readyProfile("pyramid"));
  CHECK(profileKey(paramsOf(kMushroom).profile) == "own");
  ProfileParams older = *readyProfile("ring");  // not on the grid
  for (auto& curve : older.slices[0].shape.contours) {
    for (SectionPoint& p : curve) p.x += 4e-4;
  }
  CHECK(profileKey(older) == "ring");
  for (const ReadyProfile& ready : readyProfiles()) {
    CAPTURE(std::string(ready.key));
    const ProfileParams profile = *readyProfile(ready.key);
    CHECK(profileKey(profile) == ready.key);
    if (profile.isSoft()) continue;
    for (const InflateSides sides : {InflateSides::Both, InflateSides::Front, InflateSides::Back}) {
      const auto curves = profileCurves(profile.slices.front().shape, sides);
      REQUIRE(curves.ok());
      const InflateParams params{.sides = sides, .points = 3000, .profile = profile};
      for (const auto& [name, holes] : {std::pair{"stadium", 0}, {"ring", 1}, {"eight", 2}}) {
        CAPTURE(std::string(name));
        const Topology expected = topologyOf(curves.value(), holes);
        const Puffed made = whole(name, params);
        CHECK(made.report.shells == expected.shells);
        CHECK(made.report.genus == expected.genus);
      }
    }
  }
}

TEST_CASE("one side is the slice cut in the picture's plane") {
  for (const InflateSides sides : {InflateSides::Front, InflateSides::Back}) {
    for (const SectionShape& slice : {kCircle, kRing, kMushroom}) {
      InflateParams params = paramsOf(slice);
      params.sides = sides;
      const Puffed made = whole("stadium", params);
      for (const auto& p : made.mesh.positions) CHECK((sides == InflateSides::Front ? p[2] >= -1e-3 : p[2] <= 1e-3));
    }
  }
  InflateParams half = paramsOf(kCircle);
  half.sides = InflateSides::Front;
  CHECK(whole("disc", half).report.volume ==
        doctest::Approx(whole("disc", paramsOf(kCircle)).report.volume / 2).epsilon(0.02));
}

TEST_CASE("the height scales z, and thickness is that of the widest place where it does not follow") {
  InflateParams params = paramsOf(kCircle);
  const double volume = whole("hand", params).report.volume;
  params.height = 0.5;
  CHECK(whole("hand", params).report.volume == doctest::Approx(volume / 2).epsilon(1e-3));
  CHECK(whole("hand", paramsOf(kCircle, 3000, 0)).report.volume > 1.3 * volume);
}

TEST_CASE("a slice that is no profile is refused with what is wrong") {
  const auto why = [](const SectionShape& shape, InflateSides sides = InflateSides::Both) {
    const auto curves = profileCurves(shape, sides);
    REQUIRE(!curves.ok());
    CHECK(curves.error() == Error::SectionInvalid);
    return curves.failure().detail;
  };
  CHECK(why(SectionPreset::D).find("mirror") != std::string::npos);
  CHECK(why(drawn({box(0.2, -0.3, 0.6, 0.3)})).find("mirror") != std::string::npos);
  CHECK(why(drawn({box(-1.5, -1, 1.5, 1)})).find("beyond") != std::string::npos);
  CHECK(why(drawn({{{-1, 0}, {0, -0.5}, {1, 0}, {1, 1}, {0, 0}, {-1, 1}}}), InflateSides::Front).find("middle") !=
        std::string::npos);
  CHECK(why(drawn({box(-0.5, -1, 0.5, -0.2)}), InflateSides::Front).find("side") != std::string::npos);
  CHECK(!why(drawn({{{0, 0}, {0, 0.5}, {0, 1}}})).empty());
  CHECK(!why(drawn({{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}})).empty());
}

TEST_CASE("random regions with random slices make lawful solids") {
  for (const std::uint64_t seed : testing::seeds(1, 31)) {
    CAPTURE(seed);
    Rng rng(seed);
    geometry::Contours outlines{blob(rng, {200, 200}, rng.uniform(40, 120), 220)};
    if (seed % 3 == 0) outlines.push_back(ellipse({200, 200}, rng.uniform(5, 14), rng.uniform(5, 14), 50));
    if (seed % 4 == 0) outlines.push_back(ellipse({380, 20}, 15, 15, 50));
    const auto clean = geometry::cleanRegion(outlines, 0, {400, 400});
    REQUIRE(clean.ok());
    const SectionShape slices[] = {kCircle, kSquare, kRoof, kRing, kRingsWithHoles, kCavity, kMushroom, kBodyAndRing};
    InflateParams params = paramsOf(slices[rng.below(8)], static_cast<int>(rng.uniform(300, 5000)), rng.uniform(0, 1));
    params.sides = static_cast<InflateSides>(rng.below(3));
    params.height = rng.uniform(0.3, 2);
    const auto curves = profileCurves(params.profile.slices[0].shape, params.sides);
    REQUIRE(curves.ok());
    const Puffed made = whole(clean.value(), params);
    Topology expected;
    for (const auto& piece : geometry::piecesOf(clean.value())) {
      const Topology own = topologyOf(curves.value(), static_cast<int>(piece.size()) - 1);
      expected.shells += own.shells;
      expected.genus += own.genus;
    }
    CHECK(made.report.shells == expected.shells);
    CHECK(made.report.genus == expected.genus);
  }
}
