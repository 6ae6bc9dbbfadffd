#include "engine/loft/loft.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::loft;
using namespace spineloft::sections;
using namespace spineloft::testing;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kPicture{1000, 800};

LoftParams withCaps(CapStyle start, CapStyle end, int points = 48) {
  LoftParams params;
  params.startCap = start;
  params.endCap = end;
  params.sectionPoints = points;
  return params;
}

mesh::TriMesh lofted(const ribs::RibSet& set, const LoftParams& params) {
  const Result<mesh::TriMesh> mesh = loftRibs(set, kPicture, params);
  REQUIRE_MESSAGE(mesh.ok(), (mesh.ok() ? "" : failureSentence(mesh.failure())));
  return mesh.value();
}

/// Whether a vertex of the mesh lies at the picture point, seen from the front.
double nearestVertex(const mesh::TriMesh& mesh, PicturePoint p) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& v : mesh.positions) best = std::min(best, std::hypot(v[0] - p.x, -v[1] - p.y));
  return best;
}

ribs::RibSet cylinderRibs(int count = 11) {
  return straightRibs({100, 400}, {500, 400}, count, [](double) { return 80.0; });
}

}  // namespace

TEST_CASE("a straight spine with equal ribs and a circle is a cylinder, second order in the points") {
  const double radius = 40, length = 400;
  double lastError = 0;
  for (const int points : {24, 48, 96, 192}) {
    const auto report = requireLawful(lofted(cylinderRibs(), withCaps(CapStyle::Flat, CapStyle::Flat, points)));
    const double error = kPi * radius * radius * length - report.volume;
    CHECK(error > 0);
    // An inscribed n-gon lacks (2π²/3)/n² of the circle's area.
    CHECK(error / report.volume == doctest::Approx(2 * kPi * kPi / 3 / points / points).epsilon(0.05));
    if (lastError > 0) CHECK(lastError / error == doctest::Approx(4).epsilon(0.05));
    lastError = error;
    CHECK(report.genus == 0);
    CHECK(report.shells == 1);
    CHECK(report.area == doctest::Approx(2 * kPi * radius * (length + radius)).epsilon(0.02));
  }
}

TEST_CASE("a rib set that runs out to zero width is a cone with a tip") {
  const auto set = straightRibs({100, 400}, {400, 400}, 13, [](double t) { return 120 * (1 - t); });
  const auto mesh = lofted(set, withCaps(CapStyle::Flat, CapStyle::Round, 192));
  const auto report = requireLawful(mesh);
  CHECK(report.volume == doctest::Approx(kPi * 60 * 60 * 300 / 3).epsilon(1e-3));
  CHECK(nearestVertex(mesh, {400, 400}) < 1e-3);
  // One ring a rib, the tip and the hub of the lid.
  CHECK(mesh.positions.size() == 12 * 192 + 2);
}

TEST_CASE("a round cap without a fan is half an ellipsoid, a pointed one a cone") {
  const auto body = requireLawful(lofted(cylinderRibs(), withCaps(CapStyle::Flat, CapStyle::Flat, 192)));
  LoftParams round = withCaps(CapStyle::Flat, CapStyle::Round, 192);
  round.capRings = 32;
  const auto domed = requireLawful(lofted(cylinderRibs(), round));
  CHECK(domed.volume - body.volume == doctest::Approx(2.0 / 3 * kPi * 40 * 40 * 40 * kDomeHeight).epsilon(5e-3));
  const auto pointed = requireLawful(lofted(cylinderRibs(), withCaps(CapStyle::Pointed, CapStyle::Flat, 192)));
  CHECK(pointed.volume - body.volume == doctest::Approx(kPi * 40 * 40 * 40 * kPointLength / 3).epsilon(5e-3));
}

TEST_CASE("a bent tube is a piece of a torus of constant depth") {
  const double radius = 200, width = 60;
  const auto set = arcRibs({400, 400}, radius, width, 0.3, 2.8, 101);
  const auto mesh = lofted(set, withCaps(CapStyle::Flat, CapStyle::Flat, 96));
  const auto report = requireLawful(mesh);
  CHECK(report.volume == doctest::Approx(kPi * 30 * 30 * radius * 2.5).epsilon(2e-3));
  for (std::size_t ring = 0; ring < 101; ++ring) {
    float depth = 0;
    for (std::size_t k = 0; k < 96; ++k) depth = std::max(depth, mesh.positions[ring * 96 + k][2]);
    CHECK(depth == doctest::Approx(30).epsilon(2e-3));
  }
}

TEST_CASE("ribs that wobble by a pixel wobble less in depth, and steady tapers stay as they are") {
  Rng rng(8);
  std::vector<double> widths;
  for (int i = 0; i < 60; ++i) widths.push_back(80 + rng.uniform(-2, 2));
  const auto wobble = straightRibs({100, 400}, {500, 400}, 60,
                                   [&](double t) { return widths[static_cast<std::size_t>(std::lround(t * 59))]; });
  const auto taper = straightRibs({100, 400}, {500, 400}, 60, [](double t) { return 90 - 50 * t; });
  const auto roughness = [](const ribs::RibSet& set, double centring) {
    LoftParams params = withCaps(CapStyle::Flat, CapStyle::Flat);
    params.centring = centring;
    const auto mesh = lofted(set, params);
    requireLawful(mesh);
    std::vector<double> depths;
    for (std::size_t ring = 0; ring < 60; ++ring) {
      double depth = 0;
      for (std::size_t k = 0; k < 48; ++k) {
        depth = std::max<double>(depth, mesh.positions[ring * 48 + k][2]);
      }
      depths.push_back(depth);
    }
    double sum = 0;
    for (std::size_t i = 1; i + 1 < 60; ++i) {
      sum += std::abs(depths[i - 1] - 2 * depths[i] + depths[i + 1]);
    }
    return sum;
  };
  CHECK(roughness(wobble, 1) < 0.4 * roughness(wobble, 0));
  CHECK(roughness(wobble, 4) < 0.2 * roughness(wobble, 0));
  CHECK(roughness(taper, 4) < 1e-3);
}

TEST_CASE("slanted ribs across a straight bar give the bar its true depth") {
  for (const double slant : {0.2, -0.6, 0.9}) {
    ribs::RibSet set = cylinderRibs(41);
    for (ribs::Rib& rib : set.ribs) {
      rib.left.x -= 40 * std::tan(slant);
      rib.right.x += 40 * std::tan(slant);
    }
    const auto mesh = lofted(set, withCaps(CapStyle::Flat, CapStyle::Flat, 96));
    const auto report = requireLawful(mesh);
    const mesh::Bounds bounds = mesh::boundsOf(mesh);
    CHECK(bounds.high[2] == doctest::Approx(40).epsilon(1e-6));
    CHECK(report.volume == doctest::Approx(kPi * 40 * 40 * 400).epsilon(2e-3));
  }
}

TEST_CASE("seen from the front the outline passes through every rib end of well-formed ribs" *
          doctest::test_suite("slow")) {
  Rng rng(7);
  for (int round = 0; round < testing::rounds(15); ++round) {
    const ribs::RibSet set = randomRibs(rng);
    for (const SectionName& name : sectionNames()) {
      LoftParams params;
      params.sections.front().shape.preset = name.preset;
      const auto mesh = lofted(set, params);
      for (const ribs::Rib& rib : set.ribs) {
        CHECK(nearestVertex(mesh, rib.left) < 2e-3);
        CHECK(nearestVertex(mesh, rib.right) < 2e-3);
      }
    }
  }
}

TEST_CASE("a round cap passes through every point of its fan") {
  for (const int points : {1, 2, 3, 4, 7, 16, 33}) {
    ribs::RibSet set = cylinderRibs();
    // A lopsided egg beyond the end, and half a circle beyond the start.
    for (int i = 1; i <= points; ++i) {
      const double angle = kPi * i / (points + 1);
      set.endFan.points.push_back(
          {500 + 70 * std::sin(angle) * (1 + 0.3 * std::cos(angle)), 400 - 40 * std::cos(angle)});
      set.startFan.points.push_back({100 - 40 * std::sin(angle), 400 - 40 * std::cos(angle)});
    }
    for (const int rings : {1, 6, 40}) {
      LoftParams params;
      params.capRings = rings;
      const auto mesh = lofted(set, params);
      requireLawful(mesh);
      const std::size_t half = set.endFan.points.size() / 2;
      for (std::size_t i = 0; i < set.endFan.points.size(); ++i) {
        // The middle of an even fan is a stretch of outline, not a point.
        if (set.endFan.points.size() == 2 * half && rings == 1) continue;
        CHECK(nearestVertex(mesh, set.endFan.points[i]) < 2e-3);
        CHECK(nearestVertex(mesh, set.startFan.points[i]) < 2e-3);
      }
    }
  }
}

TEST_CASE("a half-circle fan makes half a ball") {
  ribs::RibSet set = cylinderRibs();
  for (int i = 1; i < 32; ++i) {
    const double angle = kPi * i / 32;
    set.endFan.points.push_back({500 + 40 * std::sin(angle), 400 - 40 * std::cos(angle)});
  }
  const auto flat = requireLawful(lofted(set, withCaps(CapStyle::Flat, CapStyle::Flat, 192)));
  const auto round = requireLawful(lofted(set, withCaps(CapStyle::Flat, CapStyle::Round, 192)));
  CHECK(round.volume - flat.volume == doctest::Approx(2.0 / 3 * kPi * 64000).epsilon(5e-3));
}

TEST_CASE("open ends leave a wall: one open end is a cup, two are a tube of genus 1") {
  const double full = kPi * 40 * 40 * 400;
  const double bore = kPi * 32 * 32;
  const auto cup = requireLawful(lofted(cylinderRibs(), withCaps(CapStyle::Flat, CapStyle::Open, 192)));
  CHECK(cup.genus == 0);
  CHECK(cup.volume == doctest::Approx(full - bore * 400 * kMouthDepth).epsilon(2e-3));
  const auto other = requireLawful(lofted(cylinderRibs(), withCaps(CapStyle::Open, CapStyle::Flat, 192)));
  CHECK(other.volume == doctest::Approx(cup.volume).epsilon(1e-6));
  const auto tube = requireLawful(lofted(cylinderRibs(), withCaps(CapStyle::Open, CapStyle::Open, 192)));
  CHECK(tube.genus == 1);
  CHECK(tube.shells == 1);
  CHECK(tube.volume == doctest::Approx(full - bore * 400).epsilon(2e-3));
}

TEST_CASE("a thousand random and hostile rib sets are lawful with every section and cap") {
  Rng rng(2025);
  const auto names = sectionNames();
  const auto caps = capNames();
  int combination = 0;
  for (int round = 0; round < testing::rounds(1000); ++round) {
    const bool hostile = round % 2 == 1;
    const ribs::RibSet set = hostile ? hostileRibs(rng) : randomRibs(rng);
    LoftParams params;
    params.sections.front().shape.preset = names[static_cast<std::size_t>(combination) % names.size()].preset;
    params.startCap = caps[static_cast<std::size_t>(combination) / 12 % 4].style;
    params.endCap = caps[static_cast<std::size_t>(combination) / 48 % 4].style;
    ++combination;
    params.sectionPoints = 12 + static_cast<int>(rng.below(round % 50 == 0 ? 501 : 60));
    params.capRings = 1 + static_cast<int>(rng.below(round % 10 == 0 ? 64 : 12));
    params.centring = rng.uniform(0, 10);
    CAPTURE(round);
    const auto mesh = lofted(set, params);
    const auto report = requireLawful(mesh);
    CHECK(report.shells == 1);
    const bool tube = params.startCap == CapStyle::Open && params.endCap == CapStyle::Open;
    if (!tube) CHECK(report.genus == 0);
    if (tube && !hostile) CHECK(report.genus == 1);
  }
}

TEST_CASE("ribs that follow each other are not moved, crossing ones change nothing far away") {
  ribs::RibSet set = cylinderRibs(41);
  std::swap(set.ribs[20].left.x, set.ribs[24].left.x);  // two ends dragged across four neighbours
  const auto mesh = lofted(set, withCaps(CapStyle::Flat, CapStyle::Flat));
  requireLawful(mesh);
  for (std::size_t i = 0; i < set.ribs.size(); ++i) {
    CHECK(nearestVertex(mesh, set.ribs[i].right) < 1e-3);
    if (i < 20 || i > 24) CHECK(nearestVertex(mesh, set.ribs[i].left) < 1e-3);
  }
  const mesh::Bounds bounds = mesh::boundsOf(mesh);
  CHECK(bounds.low[0] == doctest::Approx(100));
  CHECK(bounds.high[0] == doctest::Approx(500));
}

TEST_CASE("on a bend tighter than half the width the inner ends gather and the outer ones stay") {
  // Ribs reach 30 beyond the centre of the bend: the inner ends run backwards.
  const auto set = arcRibs({400, 400}, 50, 160, 0.2, 2.9, 61);
  const auto mesh = lofted(set, withCaps(CapStyle::Flat, CapStyle::Flat));
  const auto report = requireLawful(mesh);
  CHECK(report.volume > 0);
  int kept = 0;
  for (const ribs::Rib& rib : set.ribs) kept += nearestVertex(mesh, rib.left) < 1e-3;
  CHECK(kept >= 55);
}

TEST_CASE("a part scales with its ribs") {
  Rng rng(11);
  for (int round = 0; round < 40; ++round) {
    ribs::RibSet set = randomRibs(rng), scaled = set;
    for (ribs::Rib& rib : scaled.ribs) {
      for (PicturePoint* p : {&rib.center, &rib.left, &rib.right}) *p = *p * 8.0;
    }
    const auto small = requireLawful(lofted(set, {}));
    const Result<mesh::TriMesh> big = loftRibs(scaled, {8000, 6400}, {});
    REQUIRE(big.ok());
    const auto large = requireLawful(big.value());
    CHECK(large.volume == doctest::Approx(512 * small.volume).epsilon(1e-4));
    CHECK(large.area == doctest::Approx(64 * small.area).epsilon(1e-4));
  }
}

TEST_CASE("mirrored ribs give the mirrored mesh, and travelling the other way the same solid") {
  Rng rng(12);
  for (int round = 0; round < 40; ++round) {
    const ribs::RibSet set = randomRibs(rng);
    const auto mesh = lofted(set, {});
    const auto one = requireLawful(mesh);
    const auto mirror = lofted(mirrored(set, 999), {});
    const auto two = requireLawful(mirror);
    CHECK(two.volume == doctest::Approx(one.volume).epsilon(1e-5));
    CHECK(two.area == doctest::Approx(one.area).epsilon(1e-5));
    const mesh::Bounds a = mesh::boundsOf(mesh), b = mesh::boundsOf(mirror);
    CHECK(999 - a.low[0] == doctest::Approx(b.high[0]).epsilon(1e-6));
    CHECK(a.low[1] == doctest::Approx(b.low[1]).epsilon(1e-6));
    CHECK(a.high[2] == doctest::Approx(b.high[2]).epsilon(1e-6));

    ribs::RibSet back = set;
    std::reverse(back.ribs.begin(), back.ribs.end());
    for (ribs::Rib& rib : back.ribs) std::swap(rib.left, rib.right);
    const auto three = requireLawful(lofted(back, {}));
    CHECK(three.volume == doctest::Approx(one.volume).epsilon(1e-5));
  }
}

TEST_CASE(
    "the front shows the picture where it stands; the back does in its middle, and draws no side out of the outline") {
  // A bar along x: ribs run along y, half width `half`.
  const auto mesh = lofted(cylinderRibs(), withCaps(CapStyle::Flat, CapStyle::Flat, 48));
  REQUIRE(mesh.uv.size() == mesh.positions.size());
  const mesh::Bounds bounds = mesh::boundsOf(mesh);
  const double middle = (bounds.low[1] + bounds.high[1]) / 2, level = (bounds.low[2] + bounds.high[2]) / 2;
  const double half = (bounds.high[1] - bounds.low[1]) / 2;
  int sides = 0;
  for (std::size_t v = 0; v < mesh.uv.size(); ++v) {
    CHECK(mesh.uv[v][0] == doctest::Approx((mesh.positions[v][0] + 0.5) / kPicture.width));
    const double across = (mesh.positions[v][1] - middle) / half, back = (level - mesh.positions[v][2]) / half;
    const double painted = (-mesh.uv[v][1] * kPicture.height + 0.5 - middle) / half;
    if (back < 1e-3) {
      CHECK(std::abs(painted - across) < 1e-4);
      continue;
    }
    CHECK(std::abs(painted) < std::abs(across) + 1e-4);
    CHECK(std::abs(painted - across) < (std::abs(across) < 0.2 ? 0.01 : 0.1));
    if (back < 0.1 || back > 0.3) continue;
    ++sides;
    CHECK(std::abs(painted) < 0.95);
  }
  CHECK(sides > 0);
}

TEST_CASE("a flat end takes the section's own outline, also where it is not convex") {
  for (const SectionName& name : sectionNames()) {
    const Section section = presetSection(name.preset, 96).value();
    double area = 0;
    for (std::size_t i = 0; i < section.points.size(); ++i) {
      area += cross(section.points[i], section.points[(i + 1) % section.points.size()]) / 2;
    }
    LoftParams params = withCaps(CapStyle::Flat, CapStyle::Flat, 96);
    params.sections.front().shape.preset = name.preset;
    const auto report = requireLawful(lofted(cylinderRibs(), params));
    CHECK(report.volume == doctest::Approx(area * 40 * 40 * 400).epsilon(1e-5));
  }
}

TEST_CASE("a section of one's own may be anything simple, and nothing else") {
  const auto with = [](std::vector<SectionPoint> points) {
    return loftSection(cylinderRibs(), kPicture, withCaps(CapStyle::Flat, CapStyle::Flat), {points});
  };
  // A spiral arm that no point sees whole.
  const auto spiral = with({{-1, -1},
                            {1, -1},
                            {1, 1},
                            {-0.6, 1},
                            {-0.6, -0.2},
                            {0.2, -0.2},
                            {0.2, 0.2},
                            {-0.2, 0.2},
                            {-0.2, 0.6},
                            {0.6, 0.6},
                            {0.6, -0.6},
                            {-1, -0.6}});
  REQUIRE(spiral.ok());
  CHECK(requireLawful(spiral.value()).genus == 0);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(with({{-1, 0}, {1, 0}}).error() == Error::SectionInvalid);
  CHECK(with({{-1, 0}, {1, 0}, {0, nan}}).error() == Error::SectionInvalid);
  CHECK(with({{-1, 0}, {1, 0}, {0, 5}}).error() == Error::SectionInvalid);
  CHECK(with({{-0.5, 0}, {0.5, 0}, {0, 1}}).error() == Error::SectionInvalid);
  CHECK(with({{-1, 0}, {0, 1}, {1, 0}}).error() == Error::SectionInvalid);
  CHECK(with({{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}).error() == Error::SectionInvalid);
}

TEST_CASE("what cannot be lofted says why") {
  ribs::RibSet one;
  one.ribs.push_back(cylinderRibs().ribs[0]);
  CHECK(loftRibs({}, kPicture, {}).error() == Error::TooFewRibs);
  CHECK(loftRibs(one, kPicture, {}).error() == Error::TooFewRibs);
  ribs::RibSet point;
  point.ribs.assign(5, ribs::Rib{});
  CHECK(loftRibs(point, kPicture, {}).error() == Error::TooFewRibs);
  ribs::RibSet broken = cylinderRibs(2);
  broken.ribs[0].left.x = std::numeric_limits<double>::infinity();
  CHECK(loftRibs(broken, kPicture, {}).error() == Error::TooFewRibs);

  const auto refused = [](auto change) {
    LoftParams params;
    change(params);
    const auto mesh = loftRibs(cylinderRibs(), kPicture, params);
    return !mesh.ok() && mesh.error() == Error::ValueOutOfRange;
  };
  CHECK(refused([](LoftParams& p) { p.sectionPoints = 11; }));
  CHECK(refused([](LoftParams& p) { p.sectionPoints = 513; }));
  CHECK(refused([](LoftParams& p) { p.capRings = 0; }));
  CHECK(refused([](LoftParams& p) { p.capRings = 65; }));
  CHECK(refused([](LoftParams& p) { p.centring = -1; }));
  CHECK(refused([](LoftParams& p) { p.centring = std::numeric_limits<double>::quiet_NaN(); }));
  CHECK(refused([](LoftParams& p) { p.sections.front().shape.preset = SectionPreset::kCount; }));
  CHECK(refused([](LoftParams& p) { p.endCap = CapStyle::kCount; }));
  CHECK(loftRibs(cylinderRibs(), {0, 10}, {}).error() == Error::ValueOutOfRange);
}

TEST_CASE("ribs that all coincide still give a solid") {
  ribs::RibSet set;
  set.ribs.assign(7, cylinderRibs().ribs[3]);
  for (const CapName& cap : capNames()) requireLawful(lofted(set, withCaps(cap.style, cap.style)));
}

TEST_CASE("caps are found by their keys") {
  for (const CapName& name : capNames()) {
    CHECK(capFromKey(name.key) == name.style);
    CHECK(capKey(name.style) == name.key);
    CHECK_FALSE(name.label.empty());
  }
  CHECK_FALSE(capFromKey("lid").has_value());
}
