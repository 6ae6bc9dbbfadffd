#include "engine/descriptive/wireframe.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/descriptive/model.h"
#include "engine/mesh/laws.h"
#include "engine/mesh/self_crossing.h"
#include "tests/unit/descriptive/drawings.h"
#include "tests/unit/descriptive/edge_drawings.h"

namespace spineloft::descriptive {
namespace {

using testing::KnownSolid;

/// The largest angle between neighbouring edges of a face that is not as in the original, degrees; 180 where the solid
/// is no mirror of it or has another number of corners. How far ends of lines are from corners, in shares of the size,
/// is added to `moved`.
double worstAngle(const KnownSolid& original, const Drawing& drawing, const mesh::TriMesh& mesh,
                  std::vector<double>& moved) {
  // Corners by where they were drawn: lines are in the order of edges.
  const auto edges = testing::edgesOf(original);
  std::vector<ModelPoint> made(original.corners.size());
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t k = 0; k < 2; ++k) {
      const PicturePoint p = drawing.lines[i].points[k];
      double least = 1e9;
      for (const auto& q : mesh.positions) {
        const double away = std::hypot(static_cast<double>(q[0]) - p.x, static_cast<double>(q[1]) + p.y);
        if (away >= least) continue;
        least = away;
        made[edges[i][k]] = {static_cast<double>(q[0]), static_cast<double>(q[1]), static_cast<double>(q[2])};
      }
      moved.push_back(least / sizeOf(drawing.lines));
    }
  }
  double worst = 0;
  for (const auto& face : original.faces) {
    const std::size_t n = face.size();
    for (std::size_t i = 0; i < n; ++i) {
      const auto angle = [&](const std::vector<ModelPoint>& corners) {
        const ModelPoint here = corners[face[i]];
        const ModelPoint in = corners[face[(i + n - 1) % n]] - here, out = corners[face[(i + 1) % n]] - here;
        return std::atan2(norm(cross(in, out)), dot(in, out)) * 180 / std::numbers::pi;
      };
      worst = std::max(worst, std::abs(angle(made) - angle(original.corners)));
    }
    // What is seen is in front.
    KnownSolid now{made, original.faces};
    if (testing::normalOfFace(now, face).z * testing::normalOfFace(original, face).z < 0) return 180;
  }
  return worst;
}

TEST_CASE("a box or a house is one solid of plane faces with its right angles, from the lines of its edges") {
  struct Case {
    const char* name;
    KnownSolid solid;
    double within;  ///< share of the views within 5° at a jitter of 1 %
  };
  const std::vector<Case> cases{{"cube", testing::boxSolid(1, 1, 1), 0.95},
                                {"box", testing::boxSolid(2, 1, 0.6), 0.95},
                                {"house", testing::houseSolid(1, 0.8, 1.3, 0.5), 0.75}};
  for (const Case& one : cases) {
    for (const double jitter : {0.0, 0.003, 0.01}) {
      CAPTURE(one.name);
      CAPTURE(jitter);
      Rng rng(71);
      int right = 0;
      std::vector<double> moved;
      const int views = 100;
      for (int i = 0; i < views; ++i) {
        const KnownSolid seen = testing::seenFromSomewhere(one.solid, rng);
        const Drawing drawing = testing::edgeDrawing(seen, jitter, rng);
        const Result<Model> model = modelOf(drawing);
        CAPTURE(i);
        REQUIRE(model.ok());
        if (model.value().pieces.size() != 1 || model.value().pieces[0].kind != PieceKind::Solid) continue;
        REQUIRE(model.value().solids.size() == 1);
        const ModelPiece& piece = model.value().solids[0];
        CHECK(model.value().pieces[0].outlines.size() == one.solid.faces.size());
        CHECK(piece.planarity < 1e-6);
        const mesh::MeshReport report = mesh::inspect(piece.mesh);
        CHECK(report.valid());
        CHECK(report.shells == 1);
        CHECK(report.genus == 0);
        CHECK_FALSE(mesh::selfCrossing(piece.mesh).has_value());
        if (const double off = worstAngle(seen, drawing, piece.mesh, moved); off <= 5) ++right;
      }
      CHECK(right >= (jitter < 0.005 ? views : one.within * views));
      std::ranges::sort(moved);
      const double most = moved[moved.size() * 95 / 100];
      INFO("corners moved ", most);
      CHECK(most <= 0.025);
    }
  }
}

std::vector<Line> missingOf(const Drawing& drawing) {
  const auto lines = meetingLines(drawing.lines);
  REQUIRE(lines.ok());
  return missingEdges(drawing.lines, lines.value(), nodesOf(lines.value(), sizeOf(drawing.lines)));
}

TEST_CASE("a box of which only what is seen is drawn is the same box: its hidden edges are found") {
  Rng rng(5);
  for (int i = 0; i < 50; ++i) {
    CAPTURE(i);
    const KnownSolid seen = testing::seenFromSomewhere(testing::boxSolid(1, 0.7, 1.4), rng);
    const Drawing whole = testing::edgeDrawing(seen, 0, rng);
    Drawing front = whole;
    std::erase_if(front.lines, [](const Line& line) { return !line.hidden.empty(); });
    REQUIRE(front.lines.size() == 9);
    CHECK(missingOf(front).size() == 3);
    const Result<Model> one = modelOf(whole), other = modelOf(front);
    REQUIRE((one.ok() && other.ok()));
    REQUIRE(other.value().solids.size() == 1);
    CHECK(other.value().pieces[0].kind == PieceKind::Solid);
    const double volume = mesh::inspect(one.value().solids[0].mesh).volume;
    CHECK(mesh::inspect(other.value().solids[0].mesh).volume == doctest::Approx(volume).epsilon(1e-3));
    CHECK(missingOf(whole).empty());
  }
}

TEST_CASE("strokes over several edges make the same box as a line for each") {
  Rng rng(9);
  const KnownSolid seen = testing::seenFromSomewhere(testing::boxSolid(1, 1, 1), rng);
  const Drawing lines = testing::edgeDrawing(seen, 0, rng);
  const Result<Model> wanted = modelOf(lines);
  REQUIRE(wanted.ok());
  // One face as a closed line, from the middle of an edge; all other edges as they are.
  const auto edges = testing::edgesOf(seen);
  const auto front =
      std::ranges::find_if(seen.faces, [&](const auto& face) { return testing::normalOfFace(seen, face).z > 0; });
  Drawing strokes = lines;
  strokes.lines.clear();
  std::vector<PicturePoint> corners(8);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    for (std::size_t k = 0; k < 2; ++k) corners[edges[e][k]] = lines.lines[e].points[k];
    const bool isOn = std::ranges::find(*front, edges[e][0]) != front->end() &&
                      std::ranges::find(*front, edges[e][1]) != front->end();
    if (!isOn) strokes.lines.push_back(lines.lines[e]);
  }
  Line closed;
  closed.closed = true;
  closed.points.push_back(lerp(corners[(*front)[3]], corners[(*front)[0]], 0.5));
  for (const std::uint32_t corner : *front) closed.points.push_back(corners[corner]);
  strokes.lines.push_back(closed);
  const Result<Model> made = modelOf(strokes);
  REQUIRE(made.ok());
  REQUIRE(made.value().pieces.size() == 1);
  REQUIRE(made.value().pieces[0].kind == PieceKind::Solid);
  CHECK(made.value().pieces[0].outlines.size() == 6);
  const double volume = mesh::inspect(wanted.value().solids[0].mesh).volume;
  CHECK(mesh::inspect(made.value().solids[0].mesh).volume == doctest::Approx(volume).epsilon(1e-3));
}

TEST_CASE("what is no drawing of edges stays outlines") {
  const auto anySolid = [](const std::vector<Line>& lines) {
    Drawing drawing;
    drawing.size = {1000, 1000};
    drawing.lines = lines;
    const Result<Model> model = modelOf(drawing);
    REQUIRE(model.ok());
    return std::ranges::find(model.value().pieces, PieceKind::Solid, &Piece::kind) != model.value().pieces.end();
  };
  const Line square{{{200, 200}, {800, 200}, {800, 800}, {200, 800}}, {}, true};
  const auto line = [](std::vector<PicturePoint> points) { return Line{std::move(points), {}, false}; };
  CHECK_FALSE(anySolid({square}));
  // A window, an envelope, a tile with both diagonals.
  CHECK_FALSE(anySolid({square, line({{500, 200}, {500, 800}}), line({{200, 500}, {800, 500}})}));
  CHECK_FALSE(anySolid({square, line({{200, 200}, {500, 520}, {800, 200}})}));
  CHECK_FALSE(anySolid({square, line({{200, 200}, {800, 800}}), line({{800, 200}, {200, 800}})}));
  // A house, its door side, and a pencil, seen from the front.
  CHECK_FALSE(anySolid({square, line({{200, 200}, {500, 20}, {800, 200}})}));
  CHECK_FALSE(anySolid({square, line({{200, 200}, {350, 80}, {650, 80}, {800, 200}})}));
  CHECK_FALSE(anySolid({square, line({{800, 200}, {950, 500}, {800, 800}})}));
  // A curved line in place of an edge.
  Rng rng(3);
  Drawing box = testing::edgeDrawing(testing::seenFromSomewhere(testing::boxSolid(1, 1, 1), rng), 0, rng);
  const PicturePoint a = box.lines[5].points[0], b = box.lines[5].points[1];
  const PicturePoint side{(b - a).y, -(b - a).x};
  box.lines[5].points = {a, lerp(a, b, 0.25) + side * 0.2, lerp(a, b, 0.5) + side * 0.27, lerp(a, b, 0.75) + side * 0.2,
                         b};
  CHECK_FALSE(anySolid(box.lines));
}

TEST_CASE("faces that do not close are no solid, and the sentence says so") {
  Rng rng(4);
  Drawing drawing = testing::edgeDrawing(testing::seenFromSomewhere(testing::boxSolid(1, 1, 1), rng), 0, rng);
  drawing.pieces = modelOf(drawing).value().pieces;
  REQUIRE(drawing.pieces.size() == 1);
  drawing.pieces[0].outlines.pop_back();
  const Result<Model> open = modelOf(drawing);
  REQUIRE_FALSE(open.ok());
  CHECK(open.failure().error == Error::ShapeInvalid);
  CHECK(open.failure().detail.find("two faces") != std::string::npos);
}

TEST_CASE("a ball drawn before a box stands before it at every point of its rim") {
  Rng rng(8);
  Drawing drawing = testing::edgeDrawing(testing::seenFromSomewhere(testing::boxSolid(1, 1, 1), rng), 0, rng);
  drawing.lines.push_back({testing::ellipse({500, 500}, 120, 120, 60), {}, true});
  const Result<Model> model = modelOf(drawing);
  REQUIRE(model.ok());
  REQUIRE(model.value().solids.size() == 2);
  REQUIRE(model.value().orders.orders.size() == 1);
  const Order& order = model.value().orders.orders[0];
  const mesh::TriMesh &ball = model.value().solids[order.over].mesh, &box = model.value().solids[order.under].mesh;
  REQUIRE(model.value().pieces[model.value().solids[order.under].piece].kind == PieceKind::Solid);
  const auto at = [](const mesh::TriMesh& mesh, std::uint32_t i) {
    const auto [x, y, z] = mesh.positions[i];
    return ModelPoint{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
  };
  int seen = 0;
  for (std::uint32_t i = 0; i < ball.positions.size(); ++i) {
    const ModelPoint p = at(ball, i);
    if (std::abs(std::hypot(p.x - 500, p.y + 500) - 120) > 0.5) continue;
    for (const auto& [i0, i1, i2] : box.triangles) {
      const ModelPoint a = at(box, i0), b = at(box, i1), c = at(box, i2);
      const auto area = [](ModelPoint u, ModelPoint v, ModelPoint w) {
        return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
      };
      const double one = area(b, c, p), other = area(c, a, p), last = area(a, b, p), whole = area(a, b, c);
      if (!(one * whole > 0 && other * whole > 0 && last * whole > 0)) continue;
      ++seen;
      CHECK(p.z > (one * a.z + other * b.z + last * c.z) / whole);
    }
  }
  CHECK(seen > 60);
}

TEST_CASE("a pin holds a corner of a box, on its silhouette and inside it, and the whole box with it") {
  Rng rng(8);
  const KnownSolid seen = testing::seenFromSomewhere(testing::boxSolid(1, 1, 1), rng);
  const Drawing plain = testing::edgeDrawing(seen, 0, rng);
  for (std::uint32_t line = 0; line < plain.lines.size(); ++line) {
    for (const double share : {0.0, 1.0}) {
      CAPTURE(line);
      CAPTURE(share);
      Drawing drawing = plain;
      drawing.pins.push_back({{line, share}, 37});
      const Result<Model> model = modelOf(drawing);
      REQUIRE(model.ok());
      const PicturePoint corner = plain.lines[line].points[share > 0.5 ? 1 : 0];
      double away = 1e9, z = 0;
      for (const auto& q : model.value().solids[0].mesh.positions) {
        const double now = std::hypot(static_cast<double>(q[0]) - corner.x, static_cast<double>(q[1]) + corner.y);
        if (now >= away) continue;
        away = now;
        z = static_cast<double>(q[2]);
      }
      CHECK(away < 1);
      CHECK(z == doctest::Approx(37).epsilon(1e-3));
    }
  }
}

}  // namespace
}  // namespace spineloft::descriptive
