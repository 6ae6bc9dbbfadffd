// Thin triangles go, the surface and its creases stay.
#include "engine/mesh/thin_triangles.h"

#include <doctest/doctest.h>

#include <cmath>

#include "tests/support/mesh_angles.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;

namespace {

/// A box of 40 × 10 × 20 whose sides and caps are strips of `count` quads along its length, with points that lie very
/// near one another at its beginning.
mesh::TriMesh box(int count) {
  mesh::TriMesh out;
  for (int i = 0; i <= count; ++i) {
    const auto x = static_cast<float>(40 * std::pow(static_cast<double>(i) / count, 3.0));
    for (const auto& [y, z] : {std::pair{0.f, 0.f}, {10.f, 0.f}, {10.f, 20.f}, {0.f, 20.f}}) {
      out.positions.push_back({x, y, z});
      out.uv.push_back({x / 40, y / 10});
    }
  }
  const auto quad = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    out.triangles.push_back({a, b, c});
    out.triangles.push_back({a, c, d});
  };
  quad(0, 3, 2, 1);
  for (int i = 0; i < count; ++i) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const auto row = static_cast<std::uint32_t>(4 * i);
      const std::uint32_t next = (k + 1) % 4;
      quad(row + k, row + next, row + 4 + next, row + 4 + k);
    }
  }
  const auto last = static_cast<std::uint32_t>(4 * count);
  quad(last, last + 1, last + 2, last + 3);
  return out;
}

}  // namespace

TEST_CASE("a box keeps its faces, edges and volume while its thin triangles go") {
  mesh::TriMesh mesh = box(24);
  const std::size_t before = mesh.triangles.size();
  const double thinnest = testing::anglesOf(mesh).front();
  const mesh::MeshReport was = testing::requireLawful(mesh);
  mesh::removeThinTriangles(mesh, {.off = 1e-4});
  const mesh::MeshReport is = testing::requireLawful(mesh);
  CHECK(is.volume == doctest::Approx(was.volume).epsilon(1e-6));
  CHECK(is.area == doctest::Approx(was.area).epsilon(1e-6));
  CHECK(is.genus == 0);
  CHECK(mesh.triangles.size() < before);
  CHECK(mesh.uv.size() == mesh.positions.size());
  CHECK(testing::anglesOf(mesh).front() > 5 * thinnest);
  mesh::TriMesh again = box(24);
  mesh::removeThinTriangles(again, {.off = 1e-4});
  CHECK(again == mesh);
}

TEST_CASE("a mesh without thin triangles stays as it is") {
  mesh::TriMesh mesh = box(1);
  const mesh::TriMesh was = mesh;
  mesh::removeThinTriangles(mesh, {.off = 1});
  CHECK(mesh == was);
}
