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
  CHECK(check.lean == doctest::Approx(std::atan2(5.0, 20.0)).epsilon(1e-4));
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
  CHECK(checkPrint(leaning).lean < 0);
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
