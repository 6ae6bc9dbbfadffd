#include "engine/shape/side_fit.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "engine/base/rng.h"
#include "engine/inflate/inflate.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/loft/loft.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/outline_match.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::shape;
using namespace spineloft::testing;
using geometry::Contours;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kPaper{400, 400};
/// As large as the front picture; z = 0 at x = 200.
constexpr geometry::View kRight{geometry::ViewFrom::Right, 200, 1, 0}, kLeft{geometry::ViewFrom::Left, 200, 1, 0};

mesh::TriMesh puffed(const Contours& region, const inflate::InflateParams& params = {}) {
  const auto clean = geometry::cleanRegion(region, 0, {400, 400});
  REQUIRE(clean.ok());
  Result<mesh::TriMesh> mesh = inflate::inflateRegion(clean.value(), kPaper, params);
  REQUIRE(mesh.ok());
  return std::move(mesh).value();
}

/// A side outline over the rows that a mesh covers: bent, of varying depth, round at the ends or blunt.
Contours sideOver(Rng& rng, const mesh::TriMesh& mesh, double blunt = 0) {
  const mesh::Bounds bounds = mesh::boundsOf(mesh);
  const double top = -bounds.high[1], height = bounds.high[1] - bounds.low[1];
  const double sway = rng.uniform(0, 0.12) * height, waves = rng.uniform(1, 5), phase = rng.uniform(0, 6);
  const double wide = rng.uniform(0.08, 0.3) * height, wave = rng.uniform(0, 6);
  Contours outline(1);
  const auto add = [&](double t, double sign) {
    const double round = blunt + (1 - blunt) * 2 * std::sqrt(t * (1 - t));
    const double half = wide * round * (1 + 0.25 * std::sin(6 * t + wave));
    outline[0].push_back({200 + sway * std::sin(waves * t + phase) + sign * half, top + height * t});
  };
  constexpr int kPoints = 80;
  for (int i = 0; i <= kPoints; ++i) add((1 - std::cos(kPi * i / kPoints)) / 2, 1);
  for (int i = kPoints - (blunt > 0 ? 0 : 1); i > (blunt > 0 ? -1 : 0); --i) {
    add((1 - std::cos(kPi * i / kPoints)) / 2, -1);
  }
  return outline;
}

SideFit fitted(const SideTask& task) {
  Result<SideFit> fit = fitToSide(task);
  REQUIRE_MESSAGE(fit.ok(), failureSentence(fit.ok() ? Failure{} : fit.failure()));
  return std::move(fit).value();
}

/// The mesh in that depth: lawful, and from the front what it was.
mesh::TriMesh deep(const SideTask& task) {
  mesh::TriMesh out = task.mesh;
  fitted(task).apply(out);
  requireLawful(out);
  for (std::size_t i = 0; i < out.positions.size(); ++i) {
    REQUIRE(out.positions[i][0] == task.mesh.positions[i][0]);
    REQUIRE(out.positions[i][1] == task.mesh.positions[i][1]);
  }
  CHECK(out.uv == task.mesh.uv);
  CHECK(out.triangles == task.mesh.triangles);
  return out;
}

/// The line of a part whose ribs these are.
std::vector<ModelPoint> spineOf(const ribs::RibSet& set) {
  std::vector<ModelPoint> spine;
  for (const ribs::Rib& rib : set.ribs) {
    const PicturePoint middle = (rib.left + rib.right) / 2;
    spine.push_back({middle.x, -middle.y, 0});
  }
  return spine;
}

/// Ribs square to a line that goes upward and sways.
ribs::RibSet bentRibs(Rng& rng, double sway) {
  const double waves = rng.uniform(1, 5), phase = rng.uniform(0, 6), wide = rng.uniform(15, 40),
               wave = rng.uniform(0, 6);
  const auto at = [&](double t) { return PicturePoint{200 + sway * std::sin(waves * t + phase), 350 - 300 * t}; };
  ribs::RibSet set;
  constexpr int kRibs = 60;
  for (int i = 0; i < kRibs; ++i) {
    const double t = i / (kRibs - 1.0);
    const PicturePoint along = normalized(at(t + 1e-4) - at(t - 1e-4)), middle = at(t);
    const PicturePoint half = PicturePoint{-along.y, along.x} * (wide * (1 + 0.2 * std::sin(7 * t + wave)));
    ribs::Rib rib;
    rib.left = middle - half;
    rib.right = middle + half;
    set.ribs.push_back(rib);
  }
  return set;
}

mesh::TriMesh lofted(const ribs::RibSet& set, const loft::LoftParams& params = {}) {
  Result<mesh::TriMesh> mesh = loft::loftRibs(set, kPaper, params);
  REQUIRE(mesh.ok());
  return std::move(mesh).value();
}

}  // namespace

TEST_CASE("a puff of a circle or an ellipse and one from the side are a ball or an ellipsoid") {
  struct Case {
    double x, y, z;
  };
  for (const auto& [x, y, z] : {Case{80, 80, 80}, Case{50, 80, 30}, Case{120, 60, 150}}) {
    const Contours front{ellipse({200, 200}, x, y, 180)}, side{ellipse({200, 200}, z, y, 180)};
    const mesh::TriMesh puff = puffed(front);
    const mesh::TriMesh ball = deep({puff, {kRight, side}});
    double sum = 0;
    for (const auto& p : ball.positions) sum += std::abs(std::hypot((p[0] - 200) / x, (p[1] + 200) / y, p[2] / z) - 1);
    CHECK(sum / static_cast<double>(ball.positions.size()) <= 3e-3);
    CHECK(mesh::inspect(ball).volume == doctest::Approx(kPi * 4 / 3 * x * y * z).epsilon(1e-2));
  }
}

TEST_CASE("a puff has the outline that was drawn from the side") {
  Rng rng(1);
  double worst = 1;
  for (int round = 0; round < rounds(16); ++round) {
    CAPTURE(round);
    Contours region{blob(rng, {200, 200}, 110, 180)};
    const bool holed = rng.below(3) == 0;
    if (holed) region.push_back(ellipse({200 + rng.uniform(-20, 20), 200}, 25, 20, 60));
    inflate::InflateParams params;
    if (rng.below(3) == 0) {
      const auto ready = inflate::readyProfiles();
      params.profile = *inflate::readyProfile(ready[rng.below(static_cast<std::uint32_t>(ready.size()))].key);
    }
    const mesh::TriMesh puff = puffed(region, params);
    const Contours side = sideOver(rng, puff);
    const geometry::View view = rng.below(2) == 0 ? kRight : kLeft;
    const mesh::TriMesh made = deep({puff, {view, side}});
    const auto match = pipeline::matchOutline(made, view, side);
    // A wall of a slice that stands across the rows becomes a slope.
    const bool walled = inflate::profileKey(params.profile) == "step";
    CHECK(match.iou >= (walled ? 0.94 : 0.985));
    if (!walled) worst = std::min(worst, match.iou);
    CHECK(mesh::selfCrossing(made).has_value() == mesh::selfCrossing(puff).has_value());
  }
  MESSAGE("least share: ", worst);
}

TEST_CASE("a loft, straight or bent, has the outline that was drawn from the side") {
  Rng rng(2);
  double worst = 1, mean = 0;
  for (int round = 0; round < rounds(24); ++round) {
    CAPTURE(round);
    const ribs::RibSet set = bentRibs(rng, round % 3 == 0 ? 0 : rng.uniform(0, 60));
    loft::LoftParams params;
    const bool flat = rng.below(2) == 0;
    if (flat) params.startCap = params.endCap = sections::CapStyle::Flat;
    if (rng.below(3) == 0) params.squash.points = {{0, 0.5}, {1, 2}};
    const mesh::TriMesh plain = lofted(set, params);
    const Contours side = sideOver(rng, plain, flat ? 0.6 : 0);
    const std::vector<ModelPoint> spine = spineOf(set);
    const mesh::TriMesh made = deep({plain, {kRight, side}, FitSides::Both, spine});
    const auto match = pipeline::matchOutline(made, kRight, side);
    CHECK(match.iou >= 0.98);
    CHECK(match.mean <= 0.003);
    worst = std::min(worst, match.iou);
    mean = std::max(mean, match.mean);
    CHECK_FALSE(mesh::selfCrossing(made));
  }
  MESSAGE("least share: ", worst, ", largest mean distance: ", mean);
}

TEST_CASE("rows that the line of a part crosses more than once keep their depth") {
  // A hook: up on the left, over, and half of the way down on the right.
  std::vector<PicturePoint> line;
  for (double y = 350; y > 150; y -= 5) line.push_back({120, y});
  for (double angle = 0; angle <= kPi; angle += kPi / 24) {
    line.push_back({180 - 60 * std::cos(angle), 150 - 60 * std::sin(angle)});
  }
  for (double y = 155; y < 200; y += 5) line.push_back({240, y});
  ribs::RibSet set;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const PicturePoint along = normalized(line[std::min(i + 1, line.size() - 1)] - line[i > 0 ? i - 1 : 0]);
    ribs::Rib rib;
    rib.left = line[i] - PicturePoint{-along.y, along.x} * 20;
    rib.right = line[i] + PicturePoint{-along.y, along.x} * 20;
    set.ribs.push_back(rib);
  }
  const mesh::TriMesh plain = lofted(set);
  const mesh::Bounds bounds = mesh::boundsOf(plain);
  const double height = bounds.high[1] - bounds.low[1];
  const Contours side{{{150, -bounds.high[1]}, {250, -bounds.high[1]}, {250, -bounds.low[1]}, {150, -bounds.low[1]}}};
  const std::vector<ModelPoint> spine = spineOf(set);
  const mesh::TriMesh made = deep({plain, {kRight, side}, FitSides::Both, spine});
  float most = 0;
  for (std::size_t i = 0; i < made.positions.size(); ++i) {
    const auto& p = made.positions[i];
    // The end of the line on the right is at y = −195; what it goes on by a hundredth of the height does not count.
    if (p[1] > -195 + 0.02 * height) CHECK(p[2] == plain.positions[i][2]);
    if (p[1] < -200 - 0.1 * height) most = std::max(most, p[2]);
  }
  CHECK(most == doctest::Approx(50).epsilon(5e-3));

  std::vector<ModelPoint> ring;
  for (int i = 0; i <= 48; ++i) {
    ring.push_back({200 + 150 * std::cos(kPi * i / 24), -200 + 150 * std::sin(kPi * i / 24), 0});
  }
  const auto none = fitToSide({plain, {kRight, side}, FitSides::Both, ring});
  REQUIRE_FALSE(none.ok());
  CHECK(none.error() == Error::ShapeInvalid);
}

TEST_CASE("the flat side of a puff of one side stays flat") {
  Rng rng(3);
  for (const auto sides : {inflate::InflateSides::Front, inflate::InflateSides::Back}) {
    inflate::InflateParams params;
    params.sides = sides;
    const mesh::TriMesh puff = puffed({ellipse({200, 200}, 90, 120, 90)}, params);
    const bool front = sides == inflate::InflateSides::Front;
    const Contours side{ellipse({200, 200}, 50, 120, 180)};
    const mesh::TriMesh made = deep({puff, {kRight, side}, front ? FitSides::Front : FitSides::Back});
    for (std::size_t i = 0; i < made.positions.size(); ++i) {
      if (puff.positions[i][2] == 0) CHECK(made.positions[i][2] == 0);
    }
    const mesh::Bounds bounds = mesh::boundsOf(made);
    CHECK((front ? bounds.high[2] : -bounds.low[2]) == doctest::Approx(50).epsilon(5e-3));
  }
}

TEST_CASE("fitted again, a part stays as it is") {
  Rng rng(4);
  for (int round = 0; round < rounds(6); ++round) {
    const mesh::TriMesh puff = puffed({blob(rng, {200, 200}, 110, 180)});
    const Contours side = sideOver(rng, puff);
    const mesh::TriMesh once = deep({puff, {kRight, side}}), twice = deep({once, {kRight, side}});
    for (std::size_t i = 0; i < once.positions.size(); ++i) {
      CHECK(std::abs(once.positions[i][2] - twice.positions[i][2]) <= 0.5);
    }
  }
}

TEST_CASE("what is no side outline is refused in a sentence") {
  const mesh::TriMesh puff = puffed({ellipse({200, 200}, 80, 80, 90)});
  const auto failure = [&](const Contours& lines, const std::optional<geometry::View>& view = kRight,
                           FitSides sides = FitSides::Both) {
    const auto fit = fitToSide({puff, {view, lines}, sides});
    REQUIRE_FALSE(fit.ok());
    return fit.failure();
  };
  const Contours good{ellipse({200, 200}, 40, 80, 90)};
  CHECK(failure(good, std::nullopt).error == Error::ViewInvalid);
  CHECK(failure(good, geometry::View{geometry::ViewFrom::Top, 200, 1, 0}).error == Error::ViewInvalid);
  CHECK(failure({}).error == Error::ShapeInvalid);
  CHECK(failure({{{0, 0}, {1, 1}}}).error == Error::RegionEmpty);
  Contours wrong = good;
  wrong[0][7].x = std::numeric_limits<double>::quiet_NaN();
  CHECK(failure(wrong).error == Error::StrokeNotFinite);
  CHECK(failure({ellipse({200, 200}, 40, 120, 90)}).detail == "the side outline is 50 % longer than the front one");
  CHECK(failure({ellipse({200, 300}, 40, 80, 90)}).detail.find("align the side picture") != std::string::npos);
  CHECK(failure({{{160, 120}, {240, 280}, {160, 280}, {240, 120}}}).detail == "the side outline crosses itself");
  CHECK(failure({ellipse({320, 200}, 40, 80, 90)}, kRight, FitSides::Front).detail.find("flat side") !=
        std::string::npos);
  CHECK_FALSE(fitToSide({mesh::TriMesh{}, {kRight, good}}).ok());
}
