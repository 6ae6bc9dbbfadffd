#include "engine/loft/posed.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/loft/loft.h"
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

ribs::Spine straightSpine(int count = 101) {
  ribs::Spine spine;
  for (int i = 0; i < count; ++i) spine.points.push_back({100 + 600.0 * i / (count - 1), 400});
  return spine;
}
ribs::RibSet straightTube(double width, int count = 101) {
  return straightRibs({100, 400}, {700, 400}, count, [=](double) { return width; });
}
LoftParams flat(int points = 48) {
  LoftParams params;
  params.startCap = params.endCap = CapStyle::Flat;
  params.sectionPoints = points;
  return params;
}
mesh::TriMesh posedMesh(const ribs::RibSet& set, const PosedSpine& spine, const LoftParams& params) {
  const auto mesh = loftRibs(set, kPicture, params, spine);
  REQUIRE_MESSAGE(mesh.ok(), (mesh.ok() ? "" : failureSentence(mesh.failure())));
  return mesh.value();
}
double lengthOf(const std::vector<ModelPoint>& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

}  // namespace

TEST_CASE("a part at rest is the same with and without its spine") {
  Rng rng(3);
  for (int round = 0; round < 20; ++round) {
    const ribs::RibSet set = randomRibs(rng);
    ribs::Spine spine;
    for (const ribs::Rib& rib : set.ribs) spine.points.push_back(rib.center);
    const auto posed = poseSpine(spine, {}).value();
    CHECK(posedMesh(set, posed, {}) == loftRibs(set, kPicture, {}).value());
    CHECK(poseRibs(posed, set) == set);
  }
}

TEST_CASE("a spine posed in memory that was used for others is the one from scratch") {
  Rng rng(31);
  PoseMemory memory;
  PosedSpine spine;
  for (int round = 0; round < 60; ++round) {
    ribs::Spine rest;
    const int points = 2 + static_cast<int>(rng.below(150));
    for (int i = 0; i < points; ++i) rest.points.push_back({100 + 4.0 * i, 400 + 30 * std::sin(0.05 * i)});
    Pose pose;
    if (round % 2 == 0) pose.stroke = {{100, 300}, {300, rng.uniform(200, 500)}, {700, 400}};
    if (round % 3 == 0) pose.depth.points = {{0, 0}, {1, rng.uniform(10, 90)}};
    if (round % 5 == 0) pose.coilTurns = 2, pose.coilRadius = 20;
    pose.closed = round % 7 == 0;
    const auto fresh = poseSpine(rest, pose);
    const Status status = poseSpine(rest, pose, memory, spine);
    REQUIRE(status.ok() == fresh.ok());
    if (!status.ok()) continue;
    CHECK(spine.rest == fresh.value().rest);
    CHECK(spine.posed == fresh.value().posed);
    CHECK(spine.scale == fresh.value().scale);
    CHECK(spine.moved == fresh.value().moved);
    CHECK(spine.closed == fresh.value().closed);
    // A failure in between leaves nothing behind.
    if (round % 4 == 0) CHECK_FALSE(poseSpine({{{1, 1}}}, pose, memory, spine).ok());
  }
}

TEST_CASE("a pose on the traced line itself moves nothing") {
  ribs::Spine spine;
  for (int i = 0; i < 101; ++i) spine.points.push_back({100 + 6.0 * i, 400 + 0.0 * i});
  Pose pose;
  pose.stroke = {{100, 400}, {300, 400}, {700, 400}};
  const auto posed = poseSpine(spine, pose).value();
  const auto a = posedMesh(straightTube(60), posed, {});
  const auto b = loftRibs(straightTube(60), kPicture, {}).value();
  requireLawful(a);
  REQUIRE(a.positions.size() == b.positions.size());
  for (std::size_t i = 0; i < a.positions.size(); ++i) {
    for (std::size_t k = 0; k < 3; ++k) CHECK(std::abs(a.positions[i][k] - b.positions[i][k]) < 1e-3);
  }
  CHECK(a.uv == b.uv);
}

TEST_CASE("a stroke twice as long makes a part twice as thick") {
  Pose pose;
  pose.stroke = {{100, 100}, {1300, 100}};
  const auto posed = poseSpine(straightSpine(), pose).value();
  CHECK(posed.scale == doctest::Approx(2));
  const auto one = requireLawful(loftRibs(straightTube(60), kPicture, flat()).value());
  const auto two = requireLawful(posedMesh(straightTube(60), posed, flat()));
  CHECK(two.volume == doctest::Approx(8 * one.volume).epsilon(1e-4));
}

TEST_CASE("a straight part that is closed is a torus: genus 1, volume 2 pi^2 R r^2, nothing twisted") {
  Pose pose;
  pose.closed = true;
  const auto posed = poseSpine(straightSpine(), pose).value();
  CHECK(posed.posed.front() == posed.posed.back());
  const double radius = 600 / (2 * kPi), thick = 20;
  const auto mesh = posedMesh(straightTube(2 * thick), posed, flat(96));
  const auto report = requireLawful(mesh);
  CHECK(report.genus == 1);
  CHECK(report.shells == 1);
  CHECK(report.volume == doctest::Approx(2 * kPi * kPi * radius * thick * thick).epsilon(5e-3));
}

TEST_CASE("a coil of three turns is a tube of even thickness: volume pi r^2 L") {
  Pose pose;
  pose.coilTurns = 3;
  pose.coilRadius = 60;
  const auto posed = poseSpine(straightSpine(), pose).value();
  const auto mesh = posedMesh(straightTube(30), posed, flat(96));
  const auto report = requireLawful(mesh);
  CHECK(report.genus == 0);
  const double length = lengthOf(centreLine(posed, 4000));
  CHECK(length > 3 * 2 * kPi * 60 * 0.7);
  CHECK(report.volume == doctest::Approx(kPi * 15 * 15 * length).epsilon(1e-2));
  // Frames turn about the tangent as little as can be: neighbours differ only by the bend.
  for (std::size_t i = 1; i < posed.posed.size(); ++i) {
    const auto &a = posed.posed[i - 1], &b = posed.posed[i];
    const double bend = distance(a.tangent, b.tangent);
    CHECK(distance(a.across, b.across) < bend + 1e-3);
  }
  // It begins and ends on the line.
  CHECK(distance(posed.posed.front().at, ModelPoint{100, -400, 0}) < 1e-6);
  CHECK(distance(posed.posed.back().at, ModelPoint{700, -400, 0}) < 1e-6);
}

TEST_CASE("what is seen in a pose can be brought back to where it was traced") {
  Rng rng(9);
  Pose pose;
  pose.stroke = {{100, 100}, {300, 180}, {500, 120}, {700, 400}};
  pose.depth.points = {{0, 0}, {0.5, 80}, {1, -20}};
  const auto posed = poseSpine(straightSpine(), pose).value();
  for (int round = 0; round < 100; ++round) {
    const double at = rng.uniform();
    const PicturePoint p{100 + 600 * at + rng.uniform(-5, 5), 400 + rng.uniform(-60, 60)};
    const ModelPoint q = carried(posed, at, p);
    const auto back = atRest(posed, at, {q.x, -q.y});
    REQUIRE(back.has_value());
    CHECK(distance(*back, p) < 1e-6);
  }
}

TEST_CASE("parts are lawful in any pose with any sections and curves") {
  Rng rng(77);
  const auto curve = [&](double low, double high) {
    geometry::AlongCurve c;
    for (std::uint32_t i = 0, n = rng.below(5); i < n; ++i) {
      c.points.push_back({(i + rng.uniform(0, 0.9)) / n, rng.uniform(low, high)});
    }
    return c;
  };
  int refused = 0;
  for (int round = 0; round < testing::rounds(120); ++round) {
    CAPTURE(round);
    const ribs::RibSet set = round % 4 == 3 ? hostileRibs(rng) : randomRibs(rng);
    ribs::Spine spine;
    for (const ribs::Rib& rib : set.ribs) spine.points.push_back(rib.center);
    LoftParams params;
    params.sections.resize(1 + rng.below(3));
    for (std::size_t i = 0; i < params.sections.size(); ++i) {
      params.sections[i].at =
          (static_cast<double>(i) + rng.uniform(0, 0.9)) / static_cast<double>(params.sections.size());
      params.sections[i].shape.preset = static_cast<SectionPreset>(rng.below(12));
      params.sections[i].blend.kind = static_cast<BlendKind>(rng.below(5));
    }
    params.twist = curve(-6, 6);
    params.squash = curve(kLeastSquash, 3);
    params.tilt = curve(-kMostTilt, kMostTilt);
    params.bulge = curve(-1, 1);
    params.startCap = static_cast<CapStyle>(rng.below(4));
    params.endCap = static_cast<CapStyle>(rng.below(4));
    Pose pose;
    if (rng.below(2) == 0) pose.stroke = randomStroke(rng, 40, 900, 700);
    pose.depth = curve(-60, 60);
    if (rng.below(2) == 0) pose.coilTurns = rng.uniform(-5, 5);
    pose.coilRadius = rng.uniform(0, 90);
    pose.closed = rng.below(4) == 0;
    const auto posed = poseSpine(spine, pose);
    REQUIRE(posed.ok());
    const auto mesh = loftRibs(set, kPicture, params, posed.value());
    if (!mesh.ok()) {
      ++refused;
      CHECK(mesh.error() == Error::SectionInvalid);
      continue;
    }
    requireLawful(mesh.value());
  }
  CHECK(100 * refused <= testing::rounds(120));
}
