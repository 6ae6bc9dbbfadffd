#include "engine/extrude/extrude.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include "engine/mesh/shading.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using extrude::EdgeKind, extrude::ExtrudeParams;
using namespace spineloft::testing;

namespace {

constexpr image::Size kSize{500, 400};

mesh::MeshReport sheeted(const geometry::Contours& drawn, const ExtrudeParams& params, double ribbon = 0) {
  const auto clean = geometry::cleanRegion(drawn, ribbon, {500, 400});
  REQUIRE(clean.ok());
  const Result<mesh::TriMesh> solid = extrude::extrudeRegion(clean.value(), kSize, params);
  REQUIRE(solid.ok());
  const double half = params.thickness * 250, middle = params.depth * 500;
  for (const auto& p : solid.value().positions) {
    CHECK(std::abs(static_cast<double>(p[2]) - middle) <= half * (1 + 1e-5));
  }
  return requireLawful(solid.value());
}

}  // namespace

TEST_CASE("a sharp piece has the volume and the area of a plate") {
  const mesh::MeshReport report = sheeted({rectangle(100, 100, 300, 250)}, {0.04, EdgeKind::Sharp, 0.5, 0.1});
  CHECK(report.volume == doctest::Approx(200 * 150 * 20));
  CHECK(report.area == doctest::Approx(2 * 200 * 150 + 2 * (200 + 150) * 20));
  CHECK(report.genus == 0);
}

TEST_CASE("a bevel takes a frustum's edge off, a rounding a quarter of a torus") {
  const double r = 120, half = 10, thickness = 0.04;
  const geometry::Contours disc{ellipse({200, 200}, r, r, 720)};
  for (const double share : {0.3, 1.0}) {
    const double e = share * half;
    // Pappus: what is cut off is turned round the axis at its centroid.
    const double triangle = 2 * std::numbers::pi * (r - e / 3) * e * e / 2;
    const double corner = (1 - std::numbers::pi / 4) * e * e;
    const double plate = std::numbers::pi * r * r * 2 * half;
    CHECK(sheeted({disc}, {thickness, EdgeKind::Bevel, share, 0}).volume ==
          doctest::Approx(plate - 2 * triangle).epsilon(2e-3));
    // The corner outside a quarter circle has its centroid (10 − 3π)/(12 − 3π) of e from the edge.
    const double pi = std::numbers::pi, inset = (10 - 3 * pi) / (12 - 3 * pi) * e;
    const double round = 2 * pi * (r - inset) * corner;
    CHECK(sheeted({disc}, {thickness, EdgeKind::Round, share, 0}).volume ==
          doctest::Approx(plate - 2 * round).epsilon(3e-3));
  }
}

TEST_CASE("a bevel wider than the piece makes a hip roof on either side, its ridges straight") {
  for (const auto& [a, b] : {std::pair{300.0, 60.0}, {200.0, 40.0}, {90.0, 90.0}}) {
    const mesh::MeshReport report = sheeted({rectangle(100, 100, 100 + a, 100 + b)}, {0.2, EdgeKind::Bevel, 1, 0});
    CHECK(report.volume == doctest::Approx(2 * b * b * (3 * a - b) / 12).epsilon(1e-3));
    CHECK(report.area == doctest::Approx(2 * a * b * std::sqrt(2.0)).epsilon(2e-3));
  }
}

TEST_CASE("holes are handles, pieces shells, and open lines ribbons") {
  const geometry::Contours letters{rectangle(50, 50, 200, 350), rectangle(90, 90, 160, 180),
                                   rectangle(90, 220, 160, 310), ellipse({350, 200}, 80, 80, 90)};
  for (const EdgeKind edge : {EdgeKind::Sharp, EdgeKind::Bevel, EdgeKind::Round}) {
    const mesh::MeshReport report = sheeted(letters, {0.04, edge, 0.5, 0});
    CHECK(report.genus == 2);
    CHECK(report.shells == 2);
    const mesh::MeshReport ring = sheeted({{{100, 100}, {300, 100}, {200, 300}, {100, 100}}}, {0.04, edge, 0.5, 0}, 20);
    CHECK(ring.genus == 1);
  }
}

TEST_CASE("an edge larger than the piece is wide meets itself in a ridge and stays lawful") {
  for (const EdgeKind edge : {EdgeKind::Bevel, EdgeKind::Round}) {
    sheeted({rectangle(50, 200, 450, 206)}, {0.2, edge, 1, 0});
    sheeted({{{20, 200}, {480, 190}, {480, 210}}}, {0.1, edge, 1, 0});
    sheeted({ellipse({100, 100}, 3, 3, 20)}, {0.5, edge, 1, 0});
    Rng rng(9);
    for (int round = 0; round < testing::rounds(3); ++round) {
      Outline scribble;
      for (int i = 0; i < 8; ++i) scribble.push_back({rng.uniform(20, 480), rng.uniform(20, 380)});
      sheeted({scribble}, {rng.uniform(0.01, 0.3), edge, rng.uniform(0, 1), 0});
    }
  }
}

namespace {

/// Angle between the shading and the true normal, degrees: what a tenth of the front's area exceeds, and what a
/// hundredth does.
struct Shading {
  double tenth = 0, hundredth = 0;
};

/// The true normal of a rounded piece: how far a point is from the outline, and in which direction, by the
/// outline itself.
Shading shadingOf(const geometry::Contours& drawn, double thickness, double edgeSize) {
  const auto clean = geometry::cleanRegion(drawn, 0, {500, 400});
  REQUIRE(clean.ok());
  const auto solid = extrude::extrudeRegion(clean.value(), kSize, {thickness, EdgeKind::Round, edgeSize, 0});
  REQUIRE(solid.ok());
  requireLawful(solid.value());
  const double half = thickness * 250, edge = edgeSize * half;
  const auto nearest = [&](double x, double y) {
    std::pair<double, std::array<double, 2>> best{INFINITY, {}};
    for (const auto& contour : clean.value()) {
      for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
        const double ax = contour[j].x, ay = -contour[j].y, bx = contour[i].x, by = -contour[i].y;
        const double l2 = (bx - ax) * (bx - ax) + (by - ay) * (by - ay);
        const double t = std::clamp(((x - ax) * (bx - ax) + (y - ay) * (by - ay)) / l2, 0.0, 1.0);
        const double dx = ax + t * (bx - ax) - x, dy = ay + t * (by - ay) - y, d = std::hypot(dx, dy);
        if (d < best.first) best = {d, {dx / d, dy / d}};
      }
    }
    return best;
  };
  const mesh::ShadedMesh shaded = mesh::shade(solid.value());
  std::vector<std::pair<double, double>> angles;  // and areas
  double whole = 0;
  for (const auto& t : shaded.triangles) {
    std::array<std::array<double, 3>, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t c = 0; c < 3; ++c) p[k][c] = double(shaded.positions[t[k]][c]);
    }
    const double nz = (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) - (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    if (nz <= 1e-9) continue;  // the front alone
    for (std::size_t k = 0; k < 3; ++k) {
      // A little into the triangle, for on a ridge there are two.
      std::array<double, 2> q{};
      for (std::size_t c = 0; c < 2; ++c) q[c] = 0.9 * p[k][c] + 0.05 * (p[(k + 1) % 3][c] + p[(k + 2) % 3][c]);
      const auto [away, out] = nearest(q[0], q[1]);
      const double lean = std::clamp((edge - away) / edge, 0.0, 1.0), up = std::sqrt(1 - lean * lean);
      const auto& n = shaded.normals[t[k]];
      const double cosine = double(n[0]) * lean * out[0] + double(n[1]) * lean * out[1] + double(n[2]) * up;
      angles.push_back({std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi, nz});
      whole += nz;
    }
  }
  std::ranges::sort(angles, std::greater{});
  Shading out;
  double passed = 0;
  for (const auto& [angle, area] : angles) {
    passed += area;
    if (passed <= 0.1 * whole) out.tenth = angle;
    if (passed <= 0.01 * whole) out.hundredth = angle;
  }
  return out;
}

}  // namespace

TEST_CASE("light falls on rounded pieces as it does on the shape that they stand for") {
  Outline star, blob;
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 == 0 ? 160 : 70, a = i * std::numbers::pi / 5;
    star.push_back({250 + r * std::sin(a), 200 - r * std::cos(a)});
  }
  for (int i = 0; i < 120; ++i) {
    const double a = i * std::numbers::pi / 60, r = 130 + 28 * std::sin(3 * a) + 12 * std::sin(7 * a + 1);
    blob.push_back({250 + r * std::cos(a), 200 + r * std::sin(a)});
  }
  const Outline wing{{60, 200},  {120, 130}, {220, 150}, {300, 200}, {400, 190},
                     {440, 120}, {425, 210}, {370, 270}, {260, 260}, {100, 260}};
  const std::vector<geometry::Contours> shapes{{star},
                                               {blob},
                                               {wing},
                                               {ellipse({250, 200}, 180, 130, 200)},
                                               {rectangle(90, 60, 410, 340), rectangle(180, 140, 320, 260)}};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    for (const auto& [thickness, edge] : {std::pair{0.04, 0.5}, {0.1, 0.6}, {0.1, 1.0}}) {
      CAPTURE(i);
      CAPTURE(thickness);
      CAPTURE(edge);
      const Shading found = shadingOf(shapes[i], thickness, edge);
      // The rounding has five steps of 18 degrees, so that its last row is off by a quarter of one.
      CHECK(found.tenth <= 4.6);
      CHECK(found.hundredth <= (edge == 1.0 ? 16 : 9));
      if (edge == 0.5) CHECK(found.tenth <= 2);
    }
  }
}
