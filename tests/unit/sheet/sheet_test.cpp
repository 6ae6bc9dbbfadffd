#include "engine/sheet/sheet.h"

#include <doctest/doctest.h>

#include <numbers>

#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"

using namespace spineloft;
using sheet::EdgeKind, sheet::SheetParams;
using namespace spineloft::testing;

namespace {

constexpr image::Size kSize{500, 400};

mesh::MeshReport sheeted(const geometry::Contours& drawn, const SheetParams& params,
                         double ribbon = 0) {
  const auto clean = geometry::cleanRegion(drawn, ribbon, {500, 400});
  REQUIRE(clean.ok());
  const Result<mesh::TriMesh> solid = sheet::sheet(clean.value(), kSize, params);
  REQUIRE(solid.ok());
  const double half = params.thickness * 250, middle = params.depth * 500;
  for (const auto& p : solid.value().positions) {
    CHECK(std::abs(static_cast<double>(p[2]) - middle) <= half * (1 + 1e-5));
  }
  return requireLawful(solid.value());
}

}  // namespace

TEST_CASE("a sharp piece has the volume and the area of a plate") {
  const mesh::MeshReport report =
      sheeted({rectangle(100, 100, 300, 250)}, {0.04, EdgeKind::Sharp, 0.5, 0.1});
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

TEST_CASE("holes are handles, pieces shells, and open lines ribbons") {
  const geometry::Contours letters{rectangle(50, 50, 200, 350), rectangle(90, 90, 160, 180),
                                   rectangle(90, 220, 160, 310), ellipse({350, 200}, 80, 80, 90)};
  for (const EdgeKind edge : {EdgeKind::Sharp, EdgeKind::Bevel, EdgeKind::Round}) {
    const mesh::MeshReport report = sheeted(letters, {0.04, edge, 0.5, 0});
    CHECK(report.genus == 2);
    CHECK(report.shells == 2);
    const mesh::MeshReport ring =
        sheeted({{{100, 100}, {300, 100}, {200, 300}, {100, 100}}}, {0.04, edge, 0.5, 0}, 20);
    CHECK(ring.genus == 1);
  }
}

TEST_CASE("an edge larger than the piece is wide meets itself in a ridge and stays lawful") {
  for (const EdgeKind edge : {EdgeKind::Bevel, EdgeKind::Round}) {
    sheeted({rectangle(50, 200, 450, 206)}, {0.2, edge, 1, 0});
    sheeted({{{20, 200}, {480, 190}, {480, 210}}}, {0.1, edge, 1, 0});
    sheeted({ellipse({100, 100}, 3, 3, 20)}, {0.5, edge, 1, 0});
    Rng rng(9);
    for (int round = 0; round < 8; ++round) {
      Outline scribble;
      for (int i = 0; i < 8; ++i) scribble.push_back({rng.uniform(20, 480), rng.uniform(20, 380)});
      sheeted({scribble}, {rng.uniform(0.01, 0.3), edge, rng.uniform(0, 1), 0});
    }
  }
}
