// Solids as children draw them: the front as it is, all that goes back along one slanted direction.
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

/// The corner of a solid that is nearest to a place of its drawing.
ModelPoint cornerAt(const mesh::TriMesh& mesh, PicturePoint p) {
  const auto nearest = std::ranges::min_element(mesh.positions, {}, [&](const auto& q) {
    return std::hypot(static_cast<double>(q[0]) - p.x, static_cast<double>(q[1]) + p.y);
  });
  return {(*nearest)[0], (*nearest)[1], (*nearest)[2]};
}

/// Mean lengths of edges along x, y and z of the box.
std::array<double, 3> lengthsOf(const Drawing& whole, const mesh::TriMesh& mesh) {
  const auto edges = testing::edgesOf(testing::boxSolid(1, 1, 1));
  const auto at = [&](PicturePoint p) { return cornerAt(mesh, p); };
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

/// A prism with base corners in the plane z = 1, counter-clockwise, and the other base at z = 0.
testing::KnownSolid prismSolid(const std::vector<SectionPoint>& base) {
  testing::KnownSolid out;
  const auto n = static_cast<std::uint32_t>(base.size());
  for (const double z : {1.0, 0.0}) {
    for (const SectionPoint p : base) out.corners.push_back({p.x, p.y, z});
  }
  std::vector<std::uint32_t> front, back;
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    front.push_back(i);
    back.insert(back.begin(), n + i);
    out.faces.push_back({i, n + i, n + next, next});
  }
  out.faces.push_back(front);
  out.faces.push_back(back);
  return out;
}

TEST_CASE("a tent, a ramp and a hexagonal bar keep the base that is drawn, and go back twice as far as drawn") {
  const std::vector<std::vector<SectionPoint>> bases{
      {{0, 0}, {1, 0}, {0.5, 0.9}},
      {{0, 0}, {1.4, 0}, {0.7, 0.9}},
      {{0, 0}, {1.2, 0}, {1.2, 0.6}},
      {{0.25, 0}, {0.75, 0}, {1, 0.43}, {0.75, 0.87}, {0.25, 0.87}, {0, 0.43}},
  };
  for (std::size_t i = 0; i < bases.size(); ++i) {
    for (const double back : {0.4, 0.7}) {
      for (const double angle : {25.0, 40.0, 150.0}) {
        for (const bool whole : {true, false}) {
          CAPTURE(i);
          CAPTURE(back);
          CAPTURE(angle);
          CAPTURE(whole);
          Rng rng(2);
          const Result<Model> model = modelOf(drawingOf(prismSolid(bases[i]), {back, angle, 0}, whole, 0, rng));
          REQUIRE(model.ok());
          REQUIRE(model.value().pieces.size() == 1);
          REQUIRE(model.value().pieces[0].kind == PieceKind::Solid);
          CHECK(model.value().pieces[0].outlines.size() == bases[i].size() + 2);
          const mesh::TriMesh& mesh = model.value().solids[0].mesh;
          const mesh::MeshReport report = mesh::inspect(mesh);
          CHECK(report.valid());
          CHECK(report.genus == 0);
          // The volume is that of the base as drawn, twice as deep as drawn.
          double area = 0;
          for (std::size_t k = 0; k < bases[i].size(); ++k)
            area += cross(bases[i][k], bases[i][(k + 1) % bases[i].size()]) / 2;
          const Drawing drawing = drawingOf(prismSolid(bases[i]), {back, angle, 0}, true, 0, rng);
          const double scale =
              distance(drawing.lines[0].points[0], drawing.lines[0].points[1]) / distance(bases[i][0], bases[i][1]);
          CHECK(report.volume == doctest::Approx(area * 2 * back * scale * scale * scale).epsilon(0.02));
        }
      }
    }
  }
}

TEST_CASE("a ramp that is drawn as seen from above a corner keeps its right angle") {
  testing::KnownSolid ramp = prismSolid({{0, 0}, {1.2, 0}, {0, 0.8}});
  for (ModelPoint& p : ramp.corners) {
    const double x = (p.x + p.z) * std::sqrt(0.5), z = (p.z - p.x) * std::sqrt(0.5), down = 0.6;
    p = {x, p.y * std::cos(down) - z * std::sin(down), p.y * std::sin(down) + z * std::cos(down)};
  }
  Rng rng(1);
  const Drawing drawing = testing::edgeDrawing(ramp, 0, rng);
  const Result<Model> model = modelOf(drawing);
  REQUIRE(model.ok());
  REQUIRE(model.value().pieces.size() == 1);
  REQUIRE(model.value().pieces[0].kind == PieceKind::Solid);
  // Lines are in the order of edges: 0–1 and 0–2 are those of the right angle.
  const auto at = [&](PicturePoint p) { return cornerAt(model.value().solids[0].mesh, p); };
  const ModelPoint corner = at(drawing.lines[0].points[0]);
  const ModelPoint one = at(drawing.lines[0].points[1]) - corner, other = at(drawing.lines[1].points[1]) - corner;
  CHECK(std::abs(dot(normalized(one), normalized(other))) < 0.02);
  CHECK(norm(one) / norm(other) == doctest::Approx(1.5).epsilon(0.1));
}

}  // namespace
}  // namespace spineloft::descriptive
