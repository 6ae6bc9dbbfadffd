#include "engine/printing/stand.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::printing;

namespace {

/// A ball of radius r that touches the ground at its lowest point.
mesh::TriMesh ball(double r, int rings = 48) {
  mesh::TriMesh mesh;
  const int around = 2 * rings;
  mesh.positions.push_back({0, 0, 0});
  for (int i = 1; i < rings; ++i) {
    const double a = std::numbers::pi * i / rings;
    for (int k = 0; k < around; ++k) {
      const double b = 2 * std::numbers::pi * k / around;
      mesh.positions.push_back(
          {float(r * std::sin(a) * std::cos(b)), float(r - r * std::cos(a)), float(r * std::sin(a) * std::sin(b))});
    }
  }
  mesh.positions.push_back({0, float(2 * r), 0});
  const auto at = [&](int ring, int k) { return std::uint32_t(1 + (ring - 1) * around + k % around); };
  for (int k = 0; k < around; ++k) {
    mesh.triangles.push_back({0, at(1, k), at(1, k + 1)});
    for (int i = 1; i + 1 < rings; ++i) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i + 1, k + 1)});
      mesh.triangles.push_back({at(i, k), at(i + 1, k + 1), at(i, k + 1)});
    }
    mesh.triangles.push_back({std::uint32_t(mesh.positions.size() - 1), at(rings - 1, k + 1), at(rings - 1, k)});
  }
  return mesh;
}

/// An upright box, sheared sideways by `lean` at its top.
mesh::TriMesh box(double side, double height, double lean) {
  mesh::TriMesh mesh;
  for (int i = 0; i < 8; ++i) {
    const bool up = i & 4;
    mesh.positions.push_back(
        {float((i & 1 ? side : 0) + (up ? lean : 0)), float(up ? height : 0), float(i & 2 ? side : 0)});
  }
  mesh.triangles = {{0, 1, 2}, {2, 1, 3}, {4, 6, 5}, {6, 7, 5}, {0, 4, 1}, {1, 4, 5},
                    {2, 3, 6}, {3, 7, 6}, {0, 2, 4}, {2, 6, 4}, {1, 5, 3}, {3, 5, 7}};
  return mesh;
}

}  // namespace

TEST_CASE("the lean of something is the angle between its weight and the nearest edge of its foot") {
  const std::vector<GroundPoint> square{{0, 0}, {10, 0}, {10, 10}, {0, 10}, {5, 5}};
  CHECK(tippingAngleOf(square, {5, 5}, 5) == doctest::Approx(std::numbers::pi / 4));
  CHECK(tippingAngleOf(square, {2, 5}, 20) == doctest::Approx(std::atan(0.1)));
  CHECK(tippingAngleOf(square, {12, 5}, 20) == doctest::Approx(-std::atan(0.1)));
  CHECK(tippingAngleOf({{1, 1}, {2, 2}}, {1.5, 1.5}, 3) <= 0);
}

TEST_CASE("a ball stands on the least flat foot whose rim is far enough from its weight") {
  const double r = 50;
  const mesh::TriMesh mesh = ball(r);
  testing::requireLawful(mesh);
  const auto foot = flatFoot({&mesh, 1});
  REQUIRE(foot);
  // A cap of height h and radius √(h (2r − h)); the centre of the rest is not far above the ball's own.
  const auto lean = [&](double h) { return std::atan(std::sqrt(h * (2 * r - h)) / (r - h)); };
  CHECK(*foot == doctest::Approx(1).epsilon(1e-3));  // a hundredth of the height is enough
  CHECK(lean(*foot) > kGoodTippingAngle);
}

TEST_CASE("what leans needs a higher foot the more it leans, and at last none helps") {
  double before = 0;
  int found = 0;
  for (const double lean : {18.0, 24.0, 28.0, 31.0}) {
    mesh::TriMesh mesh = box(20, 100, lean);
    if (mesh::inspect(mesh).volume < 0) {
      for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
    }
    testing::requireLawful(mesh);
    const auto foot = flatFoot({&mesh, 1});
    if (!foot) break;
    CHECK(*foot >= before);
    before = *foot;
    ++found;
  }
  CHECK(found >= 1);
  mesh::TriMesh tower = box(20, 100, 120);
  if (mesh::inspect(tower).volume < 0) {
    for (auto& t : tower.triangles) std::swap(t[1], t[2]);
  }
  CHECK_FALSE(flatFoot({&tower, 1}));
  CHECK_FALSE(flatFoot({}));
}

TEST_CASE("no part is cut away for a foot") {
  // A small ball at the ground beside a tall leaning box: what makes the box stand would take the ball.
  mesh::TriMesh tower = box(20, 100, 31);
  if (mesh::inspect(tower).volume < 0) {
    for (auto& t : tower.triangles) std::swap(t[1], t[2]);
  }
  const auto alone = flatFoot({&tower, 1});
  const std::vector<mesh::TriMesh> both{tower, ball(1)};
  const auto together = flatFoot(both);
  if (together) CHECK(*together <= 1.4);
  CHECK((!alone || *alone >= 1));
}
