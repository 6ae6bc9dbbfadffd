// Slices that go from a bone to a rail and back.
#include <doctest/doctest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "engine/geometry/polygon.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/part_shape.h"
#include "engine/pipeline/slices.h"
#include "engine/stack/stack.h"
#include "engine/stack/stand.h"
#include "tests/support/generators.h"
#include "tests/support/rounds.h"
#include "tests/support/stacks.h"

using namespace spineloft;
using namespace spineloft::testing;

namespace {

constexpr image::Size kPicture{400, 600};
constexpr double kLength = 400;

/// A part along an upright bone, drawn from the foot up.
struct Upright {
  document::LoftRecipe recipe;
  pipeline::PartShape shape;
};
Upright upright(const std::function<double(double)>& width) {
  Upright part;
  constexpr int kRibs = 81;
  const PicturePoint foot{200, 500}, head{200, 500 - kLength};
  part.shape.ribs = straightRibs(foot, head, kRibs, width);
  for (int i = 0; i < kRibs; ++i) {
    const double t = static_cast<double>(i) / (kRibs - 1);
    const PicturePoint p = foot + (head - foot) * t;
    part.shape.spine.points.push_back(p);
    part.shape.centreLine.push_back({p.x, -p.y, 0});
  }
  part.recipe.loft.startCap = part.recipe.loft.endCap = sections::CapStyle::Flat;
  part.recipe.loft.sectionPoints = 128;
  return part;
}

mesh::TriMesh lofted(const Upright& part) {
  auto made = loft::loftRibs(part.shape.ribs, kPicture, part.recipe.loft);
  REQUIRE(made.ok());
  return made.value();
}

/// The slices on a rail where the bone is.
mesh::TriMesh stacked(const pipeline::Slices& slices) {
  stack::StackParams params;
  params.patterns = slices.patterns;
  const auto made = stack::stackPlanes({slices.onRail, slices.rail, params}, kPicture);
  REQUIRE(made.ok());
  return made.value().mesh;
}

struct Extents {
  double left = 1e9, right = -1e9, back = 1e9, front = -1e9;
};
Extents extentsOf(const mesh::TriMesh& mesh) {
  Extents e;
  for (const auto& p : mesh.positions) {
    e.left = std::min<double>(e.left, p[0]);
    e.right = std::max<double>(e.right, p[0]);
    e.back = std::min<double>(e.back, p[2]);
    e.front = std::max<double>(e.front, p[2]);
  }
  return e;
}

}  // namespace

TEST_CASE("slices of a bone stand on a rail as wide, deep and turned as the part is") {
  std::mt19937 random(24);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int round = 0; round < testing::rounds(20); ++round) {
    const double base = 40 + 60 * unit(random), swing = 0.4 * unit(random), waves = 1 + 2 * unit(random);
    Upright part = upright([&](double t) { return base * (1 + swing * std::sin(waves * std::numbers::pi * t)); });
    loft::LoftParams& loft = part.recipe.loft;
    loft.sections.front().shape = static_cast<sections::SectionPreset>(round % 10);
    if (round % 2 == 1) loft.squash.points = {{0, 0.5 + unit(random)}, {1, 0.5 + unit(random)}};
    if (round % 3 == 1) loft.twist.points = {{0, 0}, {1, 2 * unit(random) - 1}};
    if (round % 4 == 1) loft.bulge.points = {{0, 0.8 * unit(random)}, {1, -0.8 * unit(random)}};
    const auto slices = pipeline::slicesOf(part.recipe, part.shape);
    REQUIRE(slices.ok());
    CAPTURE(round);
    CHECK(slices.value().onBone.value() == loft.sections);
    CHECK(stack::lengthOf(slices.value().rail) == doctest::Approx(kLength));
    CHECK(slices.value().onRail.size() <= pipeline::kMostCopied + 2);
    const mesh::TriMesh bone = lofted(part), rail = stacked(slices.value());
    const mesh::MeshReport laws = mesh::inspect(rail);
    CHECK(laws.valid());
    // Both ways across are within kSliceTolerance.
    CHECK(laws.volume == doctest::Approx(mesh::inspect(bone).volume).epsilon(2 * pipeline::kSliceTolerance));
    const Extents a = extentsOf(bone), b = extentsOf(rail);
    const double close = 0.04 * base;
    CHECK(std::abs(a.left - b.left) < close);
    CHECK(std::abs(a.right - b.right) < close);
    CHECK(std::abs(a.back - b.back) < close);
    CHECK(std::abs(a.front - b.front) < close);
  }
}

TEST_CASE("a straight part becomes few slices, one whose section changes has each of its sections") {
  const Upright plain = upright([](double t) { return 80 - 40 * t; });
  const auto few = pipeline::slicesOf(plain.recipe, plain.shape);
  REQUIRE(few.ok());
  CHECK(few.value().onRail.size() == 2);
  Upright part = upright([](double) { return 80.0; });
  using sections::SectionPreset;
  const sections::Blend straight{sections::BlendKind::Linear, {}};
  part.recipe.loft.sections = {
      {0, SectionPreset::Square, straight}, {0.4, SectionPreset::Circle, straight}, {1, SectionPreset::Star, {}}};
  const auto slices = pipeline::slicesOf(part.recipe, part.shape);
  REQUIRE(slices.ok());
  REQUIRE(slices.value().onRail.size() == 3);
  CHECK(slices.value().onRail[0].curves[0].corners.all);
  CHECK_FALSE(slices.value().onRail[1].curves[0].corners.all);
  CHECK(slices.value().onRail[1].at == doctest::Approx(0.4));
  CHECK(mesh::inspect(stacked(slices.value())).valid());
}

TEST_CASE("a bottle keeps its shoulder, also beside its middle line: half way between slices nothing bulges") {
  Upright part = upright([](double t) { return t < 0.6 ? 160.0 : t < 0.65 ? 160 - 120 * (t - 0.6) / 0.05 : 40.0; });
  for (ribs::Rib& rib : part.shape.ribs.ribs) {
    rib.left.x += 7;
    rib.right.x += 7;
  }
  const auto slices = pipeline::slicesOf(part.recipe, part.shape);
  REQUIRE(slices.ok());
  const mesh::TriMesh rail = stacked(slices.value());
  CHECK(mesh::inspect(rail).volume == doctest::Approx(mesh::inspect(lofted(part)).volume).epsilon(0.02));
  const Extents e = extentsOf(rail);
  CHECK(e.right == doctest::Approx(287).epsilon(0.005));
  CHECK(e.left == doctest::Approx(127).epsilon(0.005));
}

TEST_CASE("sections that hold until the next one, or change in their own way, do so on a rail") {
  Upright part = upright([](double) { return 100.0; });
  using sections::SectionPreset, sections::BlendKind;
  for (const BlendKind kind : {BlendKind::Hold, BlendKind::Ease, BlendKind::Square, BlendKind::Linear}) {
    part.recipe.loft.sections = {{0, SectionPreset::Square, {kind, {}}}, {1, SectionPreset::Circle, {}}};
    const auto slices = pipeline::slicesOf(part.recipe, part.shape);
    REQUIRE(slices.ok());
    CAPTURE(kind);
    CHECK(mesh::inspect(stacked(slices.value())).volume ==
          doctest::Approx(mesh::inspect(lofted(part)).volume).epsilon(0.01));
  }
}

TEST_CASE(
    "slices stand where they stood along a bone that comes to the front, and sections of any units fit its ribs") {
  Upright part = upright([](double) { return 80.0; });
  for (std::size_t i = 0; i < part.shape.centreLine.size(); ++i) {  // steep in its first quarter, then flat
    const double t = static_cast<double>(i) / static_cast<double>(part.shape.centreLine.size() - 1);
    part.shape.centreLine[i].z = t < 0.25 ? 1200 * t : 300;
  }
  sections::SectionShape small;
  small.contours = {{{-0.2, -0.3}, {0.3, -0.3}, {0.3, 0.2}, {-0.2, 0.2}}};
  const sections::Blend straight{sections::BlendKind::Linear, {}};
  part.recipe.loft.sections = {{0, small, straight}, {0.25, small, straight}, {1, small, straight}};
  const auto slices = pipeline::slicesOf(part.recipe, part.shape);
  REQUIRE(slices.ok());
  const stack::Plane& bend = slices.value().onRail[1];
  const auto stand = stack::standOf(bend, slices.value().rail);
  CHECK(distance(stand.value().origin, ModelPoint{200, -400, 300}) < 5);
  double left = 1e9, right = -1e9;
  for (const SectionPoint p : bend.curves.front().through) {
    left = std::min(left, p.x);
    right = std::max(right, p.x);
  }
  CHECK(left == doctest::Approx(-40));
  CHECK(right == doctest::Approx(40));
}

TEST_CASE("slices of layers on a bone are of their shape, at their shares, as many as a bone can have") {
  document::StackRecipe recipe;
  recipe.rail = {{{0, 0, 0}, {0, 300, 0}}, false};
  for (int i = 0; i < 50; ++i) {
    stack::Plane plane;
    plane.at = i / 49.0;
    plane.curves = {i % 2 == 0 ? circleCurve(20 + i, {}) : circleCurve(20, {5, 0})};
    recipe.planes.push_back(plane);
  }
  const auto slices = pipeline::slicesOf(recipe);
  REQUIRE(slices.ok());
  CHECK(slices.value().onRail == recipe.planes);
  CHECK(slices.value().rail == recipe.rail);
  REQUIRE(slices.value().onBone.value().size() == loft::kMostSectionKeys);
  CHECK(loft::checkSectionKeys(slices.value().onBone.value()).ok());
  CHECK(slices.value().onBone.value().front().at == 0);
  CHECK(slices.value().onBone.value().back().at == 1);
  for (const loft::SectionKey& key : slices.value().onBone.value()) {
    CHECK(std::abs(geometry::signedArea(std::span<const SectionPoint>(key.shape.contours[0]))) ==
          doctest::Approx(std::numbers::pi).epsilon(0.01));
  }
  // Lofted along straight ribs they are what they were on the rail, but for their sizes, which ribs give.
  Upright part = upright([](double) { return 60.0; });
  part.recipe.loft.sections = slices.value().onBone.value();
  CHECK(mesh::inspect(lofted(part)).volume == doctest::Approx(std::numbers::pi * 900 * kLength).epsilon(0.01));
}

TEST_CASE("layers that fork are copied, and are no slices of a bone") {
  document::StackRecipe recipe;
  recipe.rail = {{{0, 0, 0}, {0, 300, 0}}, false};
  recipe.planes.resize(2);
  recipe.planes[0].curves = {circleCurve(50, {})};
  recipe.planes[1].at = 1;
  recipe.planes[1].curves = {circleCurve(20, {-40, 0}), circleCurve(20, {40, 0})};
  const auto slices = pipeline::slicesOf(recipe);
  REQUIRE(slices.ok());
  CHECK(slices.value().onRail == recipe.planes);
  CHECK(slices.value().onBone.failure().error == Error::SectionInvalid);
}

TEST_CASE("slices of layers off the rail stand on the rail through their middles") {
  document::StackRecipe recipe;
  for (int i = 0; i < 4; ++i) {
    stack::Plane plane;
    plane.origin = ModelPoint{0, 50.0 * i, 0};
    plane.turn = geometry::turnTo(ModelPoint{0, 0, 1}, ModelPoint{0, 1, 0});
    plane.curves = {circleCurve(30, {})};
    recipe.planes.push_back(plane);
  }
  const auto slices = pipeline::slicesOf(recipe);
  REQUIRE(slices.ok());
  CHECK(stack::lengthOf(slices.value().rail) == doctest::Approx(150));
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK_FALSE(slices.value().onRail[i].origin);
    CHECK(slices.value().onRail[i].at == doctest::Approx(static_cast<double>(i) / 3));
  }
  recipe.planes.resize(1);
  CHECK(pipeline::slicesOf(recipe).failure().error == Error::StackInvalid);
}
