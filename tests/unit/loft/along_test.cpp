// What the curves along the spine and poses do to a solid, against closed forms.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/loft/loft.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::loft;
using namespace spineloft::sections;
using namespace spineloft::testing;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kPicture{1000, 800};
constexpr double kHalf = 40, kLength = 400;

/// A bar from (100, 400) to (500, 400), kHalf to either side; its ribs are a pixel apart.
ribs::RibSet bar() {
  return straightRibs({100, 400}, {500, 400}, 401, [](double) { return 2 * kHalf; });
}
LoftParams flat(SectionPreset preset = SectionPreset::Circle) {
  LoftParams params;
  params.startCap = params.endCap = CapStyle::Flat;
  params.sections.front().shape.preset = preset;
  return params;
}
mesh::TriMesh lofted(const LoftParams& params) {
  const auto mesh = loftRibs(bar(), kPicture, params);
  REQUIRE(mesh.ok());
  return mesh.value();
}
geometry::AlongCurve randomCurve(Rng& rng, double low, double high) {
  geometry::AlongCurve curve;
  const std::uint32_t n = 2 + rng.below(4);
  for (std::uint32_t i = 0; i < n; ++i) {
    curve.points.push_back({(i + rng.uniform(0, 0.9)) / n, rng.uniform(low, high)});
  }
  return curve;
}
/// Share of the bar's length, and place in the section plane in half widths.
struct Local {
  double at, y, z;
};
std::vector<Local> localsOf(const mesh::TriMesh& mesh) {
  std::vector<Local> out;
  for (const auto& v : mesh.positions) out.push_back({(v[0] - 100) / kLength, (v[1] + 400) / kHalf, v[2] / kHalf});
  return out;
}

ribs::Spine spineOf(const ribs::RibSet& set) {
  ribs::Spine spine;
  for (const ribs::Rib& rib : set.ribs) spine.points.push_back(rib.center);
  return spine;
}
mesh::TriMesh posedMesh(const ribs::RibSet& set, const Pose& pose, const LoftParams& params) {
  const auto posed = poseSpine(spineOf(set), pose);
  REQUIRE(posed.ok());
  const auto mesh = loftRibs(set, kPicture, params, posed.value());
  REQUIRE(mesh.ok());
  return mesh.value();
}
double lengthOf(const std::vector<ModelPoint>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

}  // namespace

TEST_CASE("a twist leaves the volume and turns the section at every place by the curve's angle") {
  Rng rng(5);
  const double still = requireLawful(lofted(flat(SectionPreset::Square))).volume;
  for (int round = 0; round < 8; ++round) {
    LoftParams params = flat(SectionPreset::Square);
    params.twist = randomCurve(rng, -5, 5);
    const auto mesh = lofted(params);
    CHECK(requireLawful(mesh).volume == doctest::Approx(still).epsilon(4e-3));
    double off[2] = {0, 0};
    for (const Local& p : localsOf(mesh)) {
      if (std::hypot(p.y, p.z) < 0.5) continue;  // the hubs of the lids
      for (const int sense : {0, 1}) {
        const double angle = (sense == 0 ? 1 : -1) * geometry::valueAt(params.twist, p.at, 0);
        const double y = p.y * std::cos(angle) - p.z * std::sin(angle);
        const double z = p.y * std::sin(angle) + p.z * std::cos(angle);
        off[sense] = std::max(off[sense], std::abs(std::max(std::abs(y), std::abs(z)) - 1));
      }
    }
    CHECK(std::min(off[0], off[1]) < 2e-3);
    CHECK(std::max(off[0], off[1]) > 0.1);
  }
}

TEST_CASE("squash scales the volume by the mean of its curve and leaves the outline") {
  Rng rng(6);
  for (const SectionPreset preset : {SectionPreset::Circle, SectionPreset::Star, SectionPreset::Heart}) {
    const double whole = requireLawful(lofted(flat(preset))).volume;
    for (int round = 0; round < 4; ++round) {
      LoftParams params = flat(preset);
      params.squash = randomCurve(rng, 0.1, 3);
      const auto mesh = lofted(params);
      double mean = 0;
      for (int i = 0; i < 4000; ++i) mean += geometry::valueAt(params.squash, (i + 0.5) / 4000, 1) / 4000;
      CHECK(requireLawful(mesh).volume == doctest::Approx(whole * mean).epsilon(2e-3));
      const mesh::Bounds bounds = mesh::boundsOf(mesh);
      CHECK(bounds.low[1] == doctest::Approx(-400 - kHalf));
      CHECK(bounds.high[1] == doctest::Approx(-400 + kHalf));
    }
  }
}

TEST_CASE(
    "bulge moves depth from the back to the front and leaves the volume of a section that is the same behind as "
    "before") {
  const double whole = requireLawful(lofted(flat())).volume;
  for (const double bulge : {-0.9, -0.3, 0.5, 0.95}) {
    LoftParams params = flat();
    params.bulge.points = {{0.5, bulge}};
    const auto mesh = lofted(params);
    CHECK(requireLawful(mesh).volume == doctest::Approx(whole).epsilon(1e-3));
    const mesh::Bounds bounds = mesh::boundsOf(mesh);
    CHECK(bounds.high[2] == doctest::Approx(kHalf * (1 + bulge)).epsilon(1e-3));
    CHECK(-bounds.low[2] == doctest::Approx(kHalf * (1 - bulge)).epsilon(1e-3));
  }
  Rng rng(7);
  LoftParams params = flat();
  params.bulge = randomCurve(rng, -0.9, 0.9);
  CHECK(requireLawful(lofted(params)).volume == doctest::Approx(whole).epsilon(2e-3));
}

TEST_CASE("tilt shears the front one way and the back the other, and leaves the volume") {
  Rng rng(8);
  const double whole = requireLawful(lofted(flat())).volume;
  for (int round = 0; round < 6; ++round) {
    LoftParams params = flat();
    params.tilt = randomCurve(rng, -0.5, 0.5);
    if (round < 2) params.tilt.points = {{0.5, round == 0 ? 0.6 : -kMostTilt}};
    const auto mesh = lofted(params);
    CHECK(requireLawful(mesh).volume == doctest::Approx(whole).epsilon(3e-3));
    if (round >= 2) continue;
    // A constant lean: every vertex has moved along by its height times the tangent.
    const double slope = std::tan(params.tilt.points.front().value);
    double least[2] = {0, 0};
    for (const Local& p : localsOf(mesh)) {
      for (const int sense : {0, 1}) {
        const double back = p.at - (sense == 0 ? 1 : -1) * slope * p.z * kHalf / kLength;
        least[sense] = std::max({least[sense], -back, back - 1});
      }
    }
    CHECK(std::min(least[0], least[1]) < 1e-5);
  }
}

TEST_CASE("rings of a helix are one pitch apart and its bar is everywhere as thick") {
  const double thick = 12, around = 70;
  const auto set = straightRibs({100, 400}, {700, 400}, 201, [=](double) { return 2 * thick; });
  for (const double turns : {3.0, -5.0}) {
    Pose pose;
    pose.coilTurns = turns;
    pose.coilRadius = around;
    const auto posed = poseSpine(spineOf(set), pose).value();
    const std::size_t n = 6001;
    const auto line = centreLine(posed, n);
    const auto whole = static_cast<std::size_t>(std::lround((n - 1) / std::abs(turns)));
    const auto ease = static_cast<std::size_t>(0.55 * static_cast<double>(whole));  // it grows out of the line
    for (std::size_t i = ease; i + whole + ease < n; i += 37) {
      const ModelPoint step = line[i + whole] - line[i];
      CHECK(step.x == doctest::Approx(600 / std::abs(turns)).epsilon(1e-3));
      CHECK(std::hypot(step.y, step.z) < 0.5);
      CHECK(std::hypot(line[i].y + 400, line[i].z) == doctest::Approx(around).epsilon(1e-3));
    }
    const auto mesh = posedMesh(set, pose, flat());
    CHECK(requireLawful(mesh).genus == 0);
    for (std::size_t v = 0; v < mesh.positions.size(); v += 23) {
      const ModelPoint p{mesh.positions[v][0], mesh.positions[v][1], mesh.positions[v][2]};
      double nearest = 1e9;
      std::size_t at = 0;
      for (std::size_t i = 0; i < n; ++i) {
        if (distance(p, line[i]) < nearest) nearest = distance(p, line[i]), at = i;
      }
      if (at < 60 || at > n - 60) continue;  // the lids
      CHECK(nearest == doctest::Approx(thick).epsilon(0.01));
    }
  }
}

TEST_CASE("a coil on a bent or a deep line winds round that line, square to it") {
  const auto arc = arcRibs({400, 400}, 250, 16, 0.4, 2.7, 161);
  const auto straight = straightRibs({100, 400}, {700, 400}, 161, [](double) { return 16.0; });
  for (const bool deep : {false, true}) {
    const auto& set = deep ? straight : arc;
    Pose base;
    if (deep) base.depth.points = {{0, 0}, {0.5, 200}, {1, -50}};
    Pose pose = base;
    pose.coilTurns = 6;
    pose.coilRadius = 30;
    const auto plain = poseSpine(spineOf(set), base).value(), coiled = poseSpine(spineOf(set), pose).value();
    const auto under = centreLine(plain, 2001), line = centreLine(coiled, 2001);
    for (std::size_t i = 300; i <= 1700; i += 20) {
      const ModelPoint off = line[i] - under[i], travel = normalized(under[i + 1] - under[i - 1]);
      CHECK(norm(off) == doctest::Approx(30).epsilon(0.01));
      CHECK(std::abs(dot(off, travel)) < 0.5);
    }
    const auto report = requireLawful(posedMesh(set, pose, flat()));
    CHECK(report.genus == 0);
    CHECK(report.volume == doctest::Approx(kPi * 8 * 8 * lengthOf(line)).epsilon(0.02));
  }
}

TEST_CASE("a mirrored pose makes the mirrored solid, and travelling the other way the same one") {
  Rng rng(14);
  for (int round = 0; round < 12; ++round) {
    CAPTURE(round);
    // Frames begin in the picture's plane at the start: out of the plane a section that is not round
    // leans otherwise when it is met from the other end, and a coil begins beside its line.
    const bool deep = round % 3 == 1, coil = round % 3 == 2;
    const auto set = straightRibs({150, 300}, {650, 380}, 60, [&](double t) { return coil ? 14.0 : 50 - 20 * t; });
    Pose pose;
    pose.stroke = {{120, 500}, {300, 420 + rng.uniform(-60, 60)}, {520, 540}, {800, 450 + rng.uniform(-60, 60)}};
    if (coil) {
      pose.stroke = {{200, 500}, {800, 300}};
      pose.coilTurns = 3;
      pose.coilRadius = 60;
    } else if (deep) {
      pose.depth = randomCurve(rng, -80, 80);
    }
    LoftParams params = flat();
    if (!deep && !coil) params.squash = randomCurve(rng, 0.5, 2);
    const auto mesh = posedMesh(set, pose, params);
    const auto one = requireLawful(mesh);
    const mesh::Bounds a = mesh::boundsOf(mesh);

    Pose mirror = pose;
    for (PicturePoint& p : mirror.stroke) p.x = 999 - p.x;
    mirror.coilTurns = -pose.coilTurns;
    const auto seen = posedMesh(mirrored(set, 999), mirror, params);
    const auto two = requireLawful(seen);
    CHECK(two.volume == doctest::Approx(one.volume).epsilon(2e-3));
    CHECK(two.area == doctest::Approx(one.area).epsilon(2e-3));

    ribs::RibSet back = set;
    std::ranges::reverse(back.ribs);
    for (ribs::Rib& rib : back.ribs) std::swap(rib.left, rib.right);
    Pose turned = pose;
    std::ranges::reverse(turned.stroke);
    LoftParams other = params;
    for (geometry::AlongCurve* curve : {&turned.depth, &other.squash}) {
      std::ranges::reverse(curve->points);
      for (geometry::AlongPoint& p : curve->points) p.at = 1 - p.at;
    }
    const auto again = posedMesh(back, turned, other);
    const auto three = requireLawful(again);
    CHECK(three.volume == doctest::Approx(one.volume).epsilon(2e-3));
    CHECK(three.area == doctest::Approx(one.area).epsilon(2e-3));
    if (coil) continue;
    const mesh::Bounds b = mesh::boundsOf(seen), c = mesh::boundsOf(again);
    CHECK(std::abs(999 - a.low[0] - b.high[0]) < 0.5);
    for (const std::size_t axis : {0u, 1u, 2u}) {
      if (axis > 0) CHECK(std::abs(a.high[axis] - b.high[axis]) < 0.5);
      CHECK(std::abs(a.low[axis] - c.low[axis]) < 0.5);
      CHECK(std::abs(a.high[axis] - c.high[axis]) < 0.5);
    }
  }
}

TEST_CASE("a part posed on a line that is joined is a ring without a seam, whatever changes along it") {
  const auto set = straightRibs({100, 400}, {700, 400}, 121, [](double t) { return 40 - 20 * t; });
  std::vector<PicturePoint> circle;
  for (int i = 0; i <= 40; ++i) {
    const double angle = 2 * kPi * 0.95 * i / 40;
    circle.push_back({400 + 200 * std::cos(angle), 400 + 200 * std::sin(angle)});
  }
  for (const double turns : {0.0, 1.3, -2.6}) {
    Pose pose;
    pose.stroke = circle;
    pose.closed = true;
    LoftParams params = flat(SectionPreset::Square);
    params.squash.points = {{0, 1}, {1, 0.5}};
    if (turns != 0) params.twist.points = {{0, 0}, {1, 2 * kPi * turns}};
    const auto posed = poseSpine(spineOf(set), pose).value();
    CHECK(posed.posed.front() == posed.posed.back());
    const auto mesh = loftRibs(set, kPicture, params, posed);
    REQUIRE(mesh.ok());
    const auto report = requireLawful(mesh.value());
    CHECK(report.genus == 1);
    CHECK(report.shells == 1);
    // No edge is longer than the side of a section: nothing jumps at the seam.
    double longest = 0;
    const auto& positions = mesh.value().positions;
    for (const auto& triangle : mesh.value().triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto &p = positions[triangle[k]], &q = positions[triangle[(k + 1) % 3]];
        longest = std::max<double>(longest, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
      }
    }
    const double step = posed.scale * 600 / 120;
    CHECK(longest < 4 * step);
  }
}
