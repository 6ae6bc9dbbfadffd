#include "engine/printing/print_check.h"

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::printing;
using spineloft::testing::requireLawful;

namespace {

mesh::TriMesh movedBox(std::array<float, 3> size, std::array<float, 3> by) {
  mesh::TriMesh mesh = testing::box(size[0], size[1], size[2]);
  for (auto& p : mesh.positions) {
    for (std::size_t i = 0; i < 3; ++i) p[i] += by[i];
  }
  requireLawful(mesh);
  return mesh;
}

/// Each triangle cut in four, so that rays start in many places.
mesh::TriMesh finer(const mesh::TriMesh& from) {
  mesh::TriMesh out = from;
  out.uv.clear();
  out.triangles.clear();
  std::vector<std::pair<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t>> known;
  const auto middle = [&](std::uint32_t a, std::uint32_t b) {
    const auto key = std::minmax(a, b);
    for (const auto& [pair, v] : known) {
      if (pair.first == key.first && pair.second == key.second) return v;
    }
    std::array<float, 3> p{};
    for (std::size_t i = 0; i < 3; ++i) p[i] = (out.positions[a][i] + out.positions[b][i]) / 2;
    out.positions.push_back(p);
    known.push_back({key, std::uint32_t(out.positions.size() - 1)});
    return known.back().second;
  };
  for (const auto& [a, b, c] : from.triangles) {
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    out.triangles.insert(out.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
  }
  return out;
}

}  // namespace

TEST_CASE("a plate is as thin as it is, whichever way it lies") {
  for (const std::array<float, 3> size : {std::array<float, 3>{40, 1.5f, 30}, {40, 30, 1.5f}, {1.5f, 40, 30}}) {
    const mesh::TriMesh plate = finer(finer(movedBox(size, {7, -3, 2})));
    const PrintCheck check = checkPrint({&plate, 1});
    CHECK(check.closed);
    CHECK(check.thinnest == doctest::Approx(1.5).epsilon(1e-4));
    CHECK(check.thick());
    CHECK(check.size[0] == doctest::Approx(size[0]));
    CHECK(check.size[1] == doctest::Approx(size[2]));
    CHECK(check.size[2] == doctest::Approx(size[1]));
    CHECK(check.volume == doctest::Approx(40 * 30 * 1.5).epsilon(1e-4));
  }
}

TEST_CASE("twice the size is twice the thickness, and the thin part is named") {
  const std::array parts = {finer(finer(movedBox({20, 20, 20}, {0, 0, 0}))),
                            finer(finer(movedBox({20, 20, 0.5f}, {30, 0, 0})))};
  const PrintCheck one = checkPrint(parts);
  CHECK(one.thinPart == 1);
  CHECK_FALSE(one.thick());
  std::array twice = parts;
  for (mesh::TriMesh& mesh : twice) {
    for (auto& p : mesh.positions) p = {2 * p[0], 2 * p[1], 2 * p[2]};
  }
  CHECK(checkPrint(twice).thinnest == doctest::Approx(2 * one.thinnest).epsilon(1e-4));
  CHECK(checkPrint(twice).thick());
}

namespace {

/// A prism over a convex or concave outline that is seen whole from the origin, in sections so that rays start all
/// along it.
mesh::TriMesh prism(const std::vector<std::array<double, 2>>& outline, double height, int sections) {
  mesh::TriMesh mesh;
  const auto n = static_cast<std::uint32_t>(outline.size());
  const auto add = [&](double x, double y, double z) {
    mesh.positions.push_back({static_cast<float>(x), static_cast<float>(z), static_cast<float>(-y)});
  };
  for (int k = 0; k <= sections; ++k) {
    for (const auto& [x, y] : outline) add(x, y, height * k / sections);
  }
  add(0, 0, 0);
  add(0, 0, height);
  const auto below = static_cast<std::uint32_t>(mesh.positions.size()) - 2;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t j = (i + 1) % n, top = static_cast<std::uint32_t>(sections) * n;
    for (std::uint32_t k = 0; k < top; k += n) {
      mesh.triangles.push_back({k + i, k + j, k + n + j});
      mesh.triangles.push_back({k + i, k + n + j, k + n + i});
    }
    mesh.triangles.push_back({below, j, i});
    mesh.triangles.push_back({below + 1, top + i, top + j});
  }
  requireLawful(mesh);
  return mesh;
}

/// The outline of circles of radius r about (-d, 0) and (d, 0): of both together (d < r), or of what they share.
std::vector<std::array<double, 2>> twoCircles(double r, double d, bool shared) {
  const double turn = std::acos(d / r);  // of a meeting point, from the middle between the centres
  const double half = shared ? turn : std::numbers::pi - turn;
  constexpr int kSteps = 60;
  std::vector<std::array<double, 2>> outline;
  for (const double side : {1., -1.}) {
    const double centre = shared ? -side * d : side * d, middle = side > 0 ? 0 : std::numbers::pi;
    for (int i = 0; i < kSteps; ++i) {
      const double a = middle - half + 2 * half * i / kSteps;
      outline.push_back({centre + r * std::cos(a), r * std::sin(a)});
    }
  }
  return outline;
}

double thinnestOf(const mesh::TriMesh& mesh) { return checkPrint({&mesh, 1}).thinnest; }

}  // namespace

TEST_CASE(
    "where two sides run together in an edge there is no thin wall: a wedge, two cylinders together, what they share") {
  for (const double degrees : {25., 40., 60.}) {
    // A wedge, its edge along the height; wherever it is looked at it is as thick as it is far from there.
    const double far = 30, high = far * std::tan(degrees / 360 * std::numbers::pi);
    std::vector<std::array<double, 2>> outline;
    const std::array<std::array<double, 2>, 3> corners = {{{-20, 0}, {10, -high}, {10, high}}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (int k = 0; k < 60; ++k) {
        const auto &a = corners[i], &b = corners[(i + 1) % 3];
        outline.push_back({a[0] + (b[0] - a[0]) * k / 60, a[1] + (b[1] - a[1]) * k / 60});
      }
    }
    CHECK_MESSAGE(thinnestOf(prism(outline, 20, 20)) > 5, degrees);
  }
  for (const double d : {3., 7., 9.5}) {
    CHECK_MESSAGE(thinnestOf(prism(twoCircles(10, d, false), 20, 20)) == doctest::Approx(20).epsilon(0.01), d);
  }
  // What two cylinders share has two edges; it is as thick as a lens is in its middle.
  for (const double d : {3., 7.}) CHECK_MESSAGE(thinnestOf(prism(twoCircles(10, d, true), 20, 20)) > 1.8 * (10 - d), d);
}

TEST_CASE("a fin on a thick body is found, as thin as it is, and so is a plate of any thickness") {
  for (const double fin : {0.3, 0.5, 0.7}) {
    // A disc of radius 10, and a fin of 6 that stands out of it.
    std::vector<std::array<double, 2>> outline;
    const double root = std::asin(fin / 2 / 10);
    for (int i = 0; i <= 120; ++i) {
      const double a = root + (2 * std::numbers::pi - 2 * root) * i / 120;
      outline.push_back({10 * std::cos(a), 10 * std::sin(a)});
    }
    for (int i = 1; i <= 12; ++i) outline.push_back({10 + i / 2., -fin / 2});
    for (int i = 12; i >= 1; --i) outline.push_back({10 + i / 2., fin / 2});
    CHECK_MESSAGE(thinnestOf(prism(outline, 20, 20)) == doctest::Approx(fin).epsilon(0.01), fin);
  }
  for (const double t : {0.2, 0.8, 3., 9.}) {
    const mesh::TriMesh plate = finer(finer(movedBox({40, static_cast<float>(t), 30}, {})));
    CHECK(thinnestOf(plate) == doctest::Approx(t).epsilon(0.01));
  }
}

TEST_CASE("enlarging is offered where what it makes still fits a printer, and then it is thick enough") {
  for (const float thickness : {0.9f, 0.5f, 0.2f, 0.05f}) {
    const std::array<float, 3> size{60, 40, thickness};
    mesh::TriMesh plate = movedBox(size, {0, 0, 0});
    const PrintCheck check = checkPrint({&plate, 1});
    // 350 mm is the largest printer's room.
    const double times = kMoreThanNeeded * kLeastWall / static_cast<double>(thickness);
    CHECK(check.enlargingHelps == (thickness < 0.8f && 60 * times <= 350));
    if (!check.enlargingHelps) continue;
    for (auto& p : plate.positions) {
      for (float& x : p) x *= static_cast<float>(times);
    }
    CHECK(checkPrint({&plate, 1}).thick());
    CHECK(checkPrint({&plate, 1}).printer < printers().size());
  }
}

TEST_CASE("a box leans until its centre is over its edge") {
  // 10 wide, 40 high, 20 deep: it falls over its narrow side at atan(5 / 20).
  const mesh::TriMesh box = movedBox({10, 40, 20}, {100, 3, -50});
  const PrintCheck check = checkPrint({&box, 1});
  CHECK(check.tippingAngle == doctest::Approx(std::atan2(5.0, 20.0)).epsilon(1e-4));
  CHECK(check.stands());
}

TEST_CASE("a flat foot is offered only where it helps") {
  const mesh::TriMesh leaning = movedBox({4, 40, 4}, {0, 0, 0});
  CHECK(checkPrint({&leaning, 1}).stands());
  CHECK_FALSE(checkPrint({&leaning, 1}).footHelps);
  mesh::TriMesh hangs = leaning;
  for (auto& p : hangs.positions) p[0] += 3 * p[1];
  requireLawful(hangs);
  CHECK_FALSE(checkPrint({&hangs, 1}).stands());
  CHECK_FALSE(checkPrint({&hangs, 1}).footHelps);
  mesh::TriMesh tip;
  tip.positions = {{0, 0, 0}, {10, 9, 6}, {-10, 9, 6}, {0, 9, -12}};
  tip.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  CHECK(checkPrint({&tip, 1}).footHelps);
}

TEST_CASE("what stands on a point falls, and so does what hangs out too far") {
  mesh::TriMesh tip;
  tip.positions = {{0, 0, 0}, {10, 20, 10}, {-10, 20, 10}, {0, 20, -10}};
  tip.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
  requireLawful(tip);
  CHECK_FALSE(checkPrint({&tip, 1}).stands());
  const std::array leaning = {movedBox({4, 10, 4}, {0, 5, 0}), movedBox({40, 4, 4}, {20, 12, 0})};
  CHECK_FALSE(checkPrint(leaning).stands());
  CHECK(checkPrint(leaning).tippingAngle < 0);
  const std::array even = {movedBox({40, 10, 40}, {0, 5, 0}), movedBox({40, 4, 4}, {20, 12, 0})};
  CHECK(checkPrint(even).stands());
}

TEST_CASE("printers are tried from small to large, turned where that helps") {
  const auto at = [](std::array<float, 3> size) {
    const mesh::TriMesh box = movedBox(size, {0, 0, 0});
    return checkPrint({&box, 1}).printer;
  };
  CHECK(at({100, 100, 100}) == 0);
  CHECK(at({130, 100, 100}) == 1);
  CHECK(at({200, 240, 200}) == 2);
  CHECK(at({340, 340, 340}) == 4);
  CHECK(at({1000, 10, 10}) == printers().size());
  std::size_t last = 0;
  for (float side = 10; side < 500; side += 10) {
    const std::size_t found = at({side, side, side});
    CHECK(found >= last);
    last = found;
  }
}

TEST_CASE("an open mesh is said to be open, and nothing at all stands nowhere") {
  mesh::TriMesh open = movedBox({10, 10, 10}, {0, 0, 0});
  open.triangles.pop_back();
  CHECK_FALSE(checkPrint({&open, 1}).closed);
  const PrintCheck none = checkPrint({});
  CHECK_FALSE(none.closed);
  CHECK_FALSE(none.stands());
  CHECK(none.thinnest == 0);
}
