// Boxes and tables as children draw them: the front square, all that goes back along one slanted direction.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/descriptive/model.h"
#include "engine/mesh/laws.h"
#include "tests/unit/descriptive/drawings.h"
#include "tests/unit/descriptive/edge_drawings.h"

namespace spineloft::descriptive {
namespace {

/// An oblique projection: depth is drawn `back` times as long at `angle` degrees, and what is upright leans by `lean`.
struct Oblique {
  double back = 0.5, angle = 45, lean = 0;
};

/// The lines of the edges of a solid 1 deep; those that are hidden only where `whole`.
Drawing drawingOf(testing::KnownSolid solid, const Oblique& oblique, bool whole, double jitter, Rng& rng) {
  // Sheared so that it looks as drawn: which faces are seen is as in any other view from that side.
  const double angle = oblique.angle * std::numbers::pi / 180;
  for (ModelPoint& p : solid.corners) {
    p.x += (1 - p.z) * oblique.back * std::cos(angle) + p.y * std::tan(oblique.lean * std::numbers::pi / 180);
    p.y += (1 - p.z) * oblique.back * std::sin(angle);
  }
  Drawing drawing = testing::edgeDrawing(solid, jitter, rng);
  if (!whole) std::erase_if(drawing.lines, [](const Line& line) { return !line.hidden.empty(); });
  return drawing;
}

/// Mean lengths of edges along x, y and z of the box.
std::array<double, 3> lengthsOf(const Drawing& whole, const mesh::TriMesh& mesh) {
  const auto edges = testing::edgesOf(testing::boxSolid(1, 1, 1));
  const auto at = [&](PicturePoint p) {
    const auto nearest = std::ranges::min_element(mesh.positions, {}, [&](const auto& q) {
      return std::hypot(static_cast<double>(q[0]) - p.x, static_cast<double>(q[1]) + p.y);
    });
    return ModelPoint{(*nearest)[0], (*nearest)[1], (*nearest)[2]};
  };
  std::array<double, 3> sums{};
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const std::uint32_t bit = edges[i][0] ^ edges[i][1];
    sums[bit / 2] += distance(at(whole.lines[i].points[0]), at(whole.lines[i].points[1])) / 4;
  }
  return sums;
}

TEST_CASE("a box with its front drawn square is about as deep as its front is wide and high, however it is slanted") {
  for (const double front : {0.7, 1.0, 1.5}) {
    const testing::KnownSolid box = testing::boxSolid(front, 1, 1);
    for (const double back : {0.35, 0.5, 1.0}) {
      for (const double angle : {30.0, 60.0, 135.0, -40.0, 215.0}) {
        for (const double lean : {-4.0, 0.0, 2.0, 6.0}) {
          CAPTURE(front);
          CAPTURE(back);
          CAPTURE(angle);
          CAPTURE(lean);
          const double jitter = lean == 0 ? 0 : 0.01;
          Rng rng(17), again(17);
          const Drawing whole = drawingOf(box, {back, angle, lean}, true, jitter, rng);
          const Drawing seen = drawingOf(box, {back, angle, lean}, false, jitter, again);
          for (const Drawing& drawing : {whole, seen}) {
            const Result<Model> model = modelOf(drawing);
            REQUIRE(model.ok());
            REQUIRE(model.value().pieces.size() == 1);
            REQUIRE(model.value().pieces[0].kind == PieceKind::Solid);
            const mesh::TriMesh& mesh = model.value().solids[0].mesh;
            CHECK(mesh::inspect(mesh).valid());
            const auto [x, y, z] = lengthsOf(whole, mesh);
            CHECK(x / y == doctest::Approx(front).epsilon(0.25));
            const double expected = std::clamp(std::sqrt(front), back, 2 * back), deep = z / std::sqrt(x * y);
            CHECK(deep > 0.7 * expected / std::sqrt(front));
            // Nobody sees how deep a box is whose edges are drawn in full.
            CHECK(deep < (back < 1 ? 2 : 2.8) * expected / std::sqrt(front));
          }
        }
      }
    }
  }
}

// Some roofs go almost along what goes back.
TEST_CASE("a house with its gable drawn as it is has seven plane faces, also where only what is seen is drawn") {
  for (const double back : {0.5, 0.8}) {
    for (const double angle : {25.0, 35.0, 45.0, 155.0}) {
      for (const double roof : {0.3, 0.65}) {
        for (const bool whole : {true, false}) {
          CAPTURE(back);
          CAPTURE(angle);
          CAPTURE(roof);
          CAPTURE(whole);
          Rng rng(4);
          const testing::KnownSolid house = testing::houseSolid(1, 0.8, 1, roof);
          const Result<Model> model = modelOf(drawingOf(house, {back, angle, 0}, whole, 0.005, rng));
          REQUIRE(model.ok());
          REQUIRE(model.value().pieces.size() == 1);
          REQUIRE(model.value().pieces[0].kind == PieceKind::Solid);
          CHECK(model.value().pieces[0].outlines.size() == 7);
          CHECK(mesh::inspect(model.value().solids[0].mesh).valid());
        }
      }
    }
  }
}

}  // namespace
}  // namespace spineloft::descriptive
