#include "engine/mesh/laws.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/mesh/angles.h"
#include "engine/mesh/shading.h"
#include "engine/mesh/topology.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::mesh;
using namespace spineloft::testing;

namespace {

/// A ring of square cross-section round the z axis: genus 1.
TriMesh squareRing() {
  TriMesh mesh;
  constexpr std::uint32_t kSides = 8;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * 3.14159265358979 * i / kSides;
    for (const auto& [r, z] : {std::pair{2.0, -1.0}, {4.0, -1.0}, {4.0, 1.0}, {2.0, 1.0}}) {
      mesh.positions.push_back(
          {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle)), static_cast<float>(z)});
    }
  }
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const std::uint32_t a = i * 4, b = (i + 1) % kSides * 4;
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t l = (k + 1) % 4;
      mesh.triangles.push_back({a + k, b + k, b + l});
      mesh.triangles.push_back({a + k, b + l, a + l});
    }
  }
  return mesh;
}

void append(TriMesh& mesh, const TriMesh& other, float shift) {
  const std::uint32_t base = static_cast<std::uint32_t>(mesh.positions.size());
  for (auto p : other.positions) mesh.positions.push_back({p[0] + shift, p[1], p[2]});
  for (const auto& t : other.triangles) {
    mesh.triangles.push_back({base + t[0], base + t[1], base + t[2]});
  }
}

}  // namespace

TEST_CASE("a box has its volume, area and no hole; a ring has genus 1; two shells are counted") {
  const MeshReport report = requireLawful(box(2, 3, 4));
  CHECK(report.volume == doctest::Approx(24));
  CHECK(report.area == doctest::Approx(52));
  CHECK(report.genus == 0);
  CHECK(report.shells == 1);

  const MeshReport ring = requireLawful(squareRing());
  CHECK(ring.genus == 1);

  TriMesh two = box(1, 1, 1);
  append(two, squareRing(), 10);
  const MeshReport both = requireLawful(two);
  CHECK(both.shells == 2);
  CHECK(both.genus == 1);
  CHECK(both.volume == doctest::Approx(1 + ring.volume));
}

TEST_CASE("every law that is broken is named") {
  const auto broken = [](auto change) {
    TriMesh mesh = box(2, 3, 4);
    change(mesh);
    const MeshReport report = inspect(mesh);
    CHECK_FALSE(report.valid());
    return brokenLaw(report);
  };
  CHECK(brokenLaw(inspect(box(1, 1, 1))).empty());
  CHECK_FALSE(broken([](TriMesh& m) { m = {}; }).empty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  CHECK(broken([&](TriMesh& m) { m.positions[3][1] = nan; }).find("finite") != std::string::npos);
  CHECK(broken([](TriMesh& m) { m.triangles[0][0] = 8; }).find("index") != std::string::npos);
  CHECK(broken([](TriMesh& m) { m.positions.push_back({0, 0, 0}); }).find("not used") != std::string::npos);
  CHECK(broken([](TriMesh& m) { m.triangles.pop_back(); }).find("edge") != std::string::npos);
  CHECK(broken([](TriMesh& m) { std::swap(m.triangles[4][0], m.triangles[4][1]); }).find("edge") != std::string::npos);
  CHECK(broken([](TriMesh& m) {
          for (auto& t : m.triangles) std::swap(t[0], t[1]);
        }).find("inwards") != std::string::npos);
  CHECK(broken([](TriMesh& m) { m.uv.resize(3); }).find("texture") != std::string::npos);
  CHECK(broken([](TriMesh& m) { m.uv.assign(8, {0.5f, 1.5f}); }).find("texture") != std::string::npos);
  CHECK(broken([](TriMesh& m) {
          for (auto& p : m.positions) p[0] = p[2] = 0;
        }).find("area") != std::string::npos);
  // Two boxes that share one vertex: every edge is sound, the vertex is not.
  CHECK(broken([](TriMesh& m) {
          append(m, box(2, 3, 4), -2);
          for (auto& t : m.triangles) {
            for (auto& v : t) v = v == 9 ? 0 : v;
          }
          m.positions.erase(m.positions.begin() + 9);
          for (auto& t : m.triangles) {
            for (auto& v : t) v = v > 9 ? v - 1 : v;
          }
        }).find("fan") != std::string::npos);
}

TEST_CASE("twins run the other way along the same edge") {
  const TriMesh mesh = squareRing();
  const Twins twins = findTwins(mesh);
  CHECK(twins.closed);
  CHECK(twins.edges == mesh.triangles.size() * 3 / 2);
  for (std::uint32_t h = 0; h < twins.of.size(); ++h) {
    REQUIRE(twins.of[h] != kNone);
    CHECK(twins.of[twins.of[h]] == h);
    CHECK(cornerVertex(mesh, h) == cornerVertex(mesh, nextHalfEdge(twins.of[h])));
  }
}

TEST_CASE("the normals of a box's corners are its diagonals, whatever the triangles") {
  const TriMesh mesh = box(2, 3, 4);
  const auto normals = vertexNormals(mesh);
  REQUIRE(normals.size() == 8);
  for (std::size_t v = 0; v < 8; ++v) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const float sign = mesh.positions[v][axis] > 0 ? 1.0f : -1.0f;
      CHECK(normals[v][axis] == doctest::Approx(sign / std::sqrt(3.0)));
    }
  }
  TriMesh lone;
  lone.positions = {{1, 2, 3}};
  CHECK(vertexNormals(lone)[0] == std::array<float, 3>{0, 0, 1});
}

TEST_CASE("quick angles are those of the arctangent") {
  Rng rng(6);
  for (int round = 0; round < 20000; ++round) {
    const double angle = rng.uniform(0, 3.14159), length = std::exp(rng.uniform(-20, 20));
    CHECK(std::abs(quickAngle(length * std::sin(angle), length * std::cos(angle)) - angle) < 1e-7);
  }
  CHECK(quickAngle(0, 1) == 0);
  CHECK(quickAngle(0, -1) == doctest::Approx(3.14159265358979));
  CHECK(quickAngle(1, 0) == doctest::Approx(3.14159265358979 / 2));
}

TEST_CASE("bounds hold all vertices and an empty mesh has none") {
  const Bounds bounds = boundsOf(box(2, 3, 4));
  CHECK(bounds.low == std::array<double, 3>{0, 0, 0});
  CHECK(bounds.high == std::array<double, 3>{2, 3, 4});
  CHECK(boundsOf({}) == Bounds{});
}

TEST_CASE("shading splits a box into flat faces, keeps a smooth ball whole, and moves nothing") {
  TriMesh mesh = box(2, 3, 4);
  mesh.uv.assign(8, {0.25f, 0.5f});
  const ShadedMesh sharp = shade(mesh);
  CHECK(sharp.positions.size() == 24);
  CHECK(sharp.uv.size() == 24);
  CHECK(sharp.triangles.size() == mesh.triangles.size());
  for (const auto& n : sharp.normals) {
    CHECK(std::abs(n[0]) + std::abs(n[1]) + std::abs(n[2]) == doctest::Approx(1));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      CHECK(sharp.positions[sharp.triangles[t][c]] == mesh.positions[mesh.triangles[t][c]]);
    }
  }
  const ShadedMesh smooth = shade(mesh, 3.0);
  CHECK(smooth.positions.size() == 8);
  const auto normals = vertexNormals(mesh);
  for (std::size_t v = 0; v < smooth.positions.size(); ++v) {
    for (std::size_t w = 0; w < 8; ++w) {
      if (mesh.positions[w] != smooth.positions[v]) continue;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        CHECK(smooth.normals[v][axis] == doctest::Approx(normals[w][axis]));
      }
    }
  }
}
