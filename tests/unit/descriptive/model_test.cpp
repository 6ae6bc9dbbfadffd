#include "engine/descriptive/model.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/base/rng.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"
#include "tests/unit/descriptive/drawings.h"
#include "tests/unit/descriptive/rays.h"

using namespace spineloft;
using namespace spineloft::descriptive;
using namespace spineloft::testing;

namespace {

Model modelled(const Drawing& drawing) {
  auto model = modelOf(drawing);
  REQUIRE(model.ok());
  for (const ModelPiece& one : model.value().solids) requireLawful(one.mesh);
  return std::move(model).value();
}
double flatness(const Model& model) { return std::ranges::max(model.solids, {}, &ModelPiece::planarity).planarity; }

}  // namespace

TEST_CASE("three bars in a cycle are flat, tilted, and in the drawn order at every ray") {
  for (const double turn : {0.0, 0.3, 1.1}) {
    for (const PieceKind kind : {PieceKind::Flat, PieceKind::Round}) {
      Drawing drawing = barsInACycle(turn);
      for (Piece& piece : drawing.pieces) piece.kind = kind;
      const Model model = modelled(drawing);
      CHECK(model.conflicts.empty());
      const Samples samples = lookAtOrders(drawing, model);
      CHECK(samples.all > 3000);
      CHECK(samples.wrong == 0);
      CHECK(flatness(model) < (kind == PieceKind::Flat ? 1e-6 : 1e-3));
    }
  }
}

TEST_CASE("a woven mat of 4 × 4 rods bends as it must, and is in the drawn order at every ray") {
  const Drawing drawing = wovenMat(4, PieceKind::Round);
  const Model model = modelled(drawing);
  CHECK(model.conflicts.empty());
  const Samples samples = lookAtOrders(drawing, model);
  CHECK(samples.all > 30000);
  CHECK(samples.wrong == 0);
  CHECK(flatness(model) < 0.08);
}

TEST_CASE("random drawings with an order at every overlap are in the drawn order at every ray") {
  std::size_t all = 0, wrong = 0, contradictory = 0, drawings = 0;
  for (const std::uint64_t seed : seeds(0, 50)) {
    ++drawings;
    const Drawing drawing = drawingOf(randomDiscs(seed));
    const Model model = modelled(drawing);
    const Samples samples = lookAtOrders(drawing, model);
    all += samples.all;
    wrong += samples.wrong;
    contradictory += !model.conflicts.empty();
  }
  CHECK(all > 100000);
  CHECK(wrong == 0);
  CHECK(contradictory <= drawings / 100);  // three pieces that would have to bend without end
}

TEST_CASE("sheets that cannot lie as drawn are named, and the others do") {
  // Flat rods cannot be woven; two discs beside them can lie on each other.
  Drawing drawing = wovenMat(4, PieceKind::Flat);
  const Drawing beside = drawn(
      {ellipse({930, 80}, 40, 40, 60), ellipse({960, 90}, 35, 35, 60)},
      [](std::uint32_t upper, std::uint32_t, PicturePoint) { return upper == 1; }, PieceKind::Flat);
  for (const Line& line : beside.lines) {
    drawing.lines.push_back(line);
    drawing.pieces.push_back(
        {"", PieceKind::Flat, {{{static_cast<std::uint32_t>(drawing.lines.size() - 1), 0, 1}}}, 1, 1, 1, 0});
  }
  const Model model = modelled(drawing);
  CHECK(model.solids.size() == 10);
  CHECK_FALSE(model.conflicts.empty());
  for (const auto& pair : model.conflicts) CHECK(std::max(pair[0], pair[1]) < 8);
}

TEST_CASE("a circle is a ball within half a percent, and thickness is what is asked for") {
  Drawing drawing =
      drawn({ellipse({500, 500}, 200, 200, 240)}, [](auto, auto, auto) { return false; }, PieceKind::Round);
  const Model ball = modelled(drawing);
  for (const auto& p : ball.solids[0].mesh.positions) {
    const double radius = std::hypot(p[0] - 500, p[1] + 500, p[2]);
    CHECK(std::abs(radius / 200 - 1) < 0.005);
  }
  drawing.pieces[0].front = 2;
  drawing.pieces[0].back = -0.5;
  const Model bowl = modelled(drawing);
  const auto bounds = mesh::boundsOf(bowl.solids[0].mesh);
  CHECK(bounds.high[2] == doctest::Approx(400).epsilon(0.005));
  const auto centre = Rays(bowl.solids[0].mesh).through({501, -502});
  REQUIRE(centre);
  CHECK(centre->back == doctest::Approx(100).epsilon(0.005));
  drawing.pieces[0].back = -2;
  const Model sheet = modelled(drawing);
  const auto thin = Rays(sheet.solids[0].mesh).through({501, -502});
  REQUIRE(thin);
  CHECK(thin->front - thin->back == doctest::Approx(kLeastThick * 400).epsilon(0.01));
}

TEST_CASE("pins hold exactly, three of them tilt a piece, and a tilted round piece is as thick as wide") {
  // A rod of 400 × 40 to the right, pinned to rise by 45 degrees.
  Drawing drawing = drawn(
      {{{300, 480}, {700, 480}, {700, 520}, {300, 520}}}, [](auto, auto, auto) { return false; }, PieceKind::Round);
  const double whole = 880;
  drawing.pins = {{{0, 0}, 0}, {{0, 400 / whole}, 400}, {{0, 440 / whole}, 400}};
  const Model model = modelled(drawing);
  CHECK(flatness(model) < 1e-5);
  for (const auto& p : model.solids[0].mesh.positions) {
    if (std::abs(p[0] - 700) < 1e-3 && std::abs(p[1] + 480) < 1e-3) CHECK(std::abs(p[2] - 400) < 1e-3);
  }
  const auto cut = Rays(model.solids[0].mesh).through({500, -500});
  REQUIRE(cut);
  const double across = (cut->front - cut->back) / std::numbers::sqrt2;
  const Model level = modelled(drawn(
      {{{300, 480}, {700, 480}, {700, 520}, {300, 520}}}, [](auto, auto, auto) { return false; }, PieceKind::Round));
  const auto straight = Rays(level.solids[0].mesh).through({500, -500});
  REQUIRE(straight);
  CHECK(across == doctest::Approx(straight->front - straight->back).epsilon(0.05));
}

TEST_CASE("pins win over orders, and the pair is named") {
  Drawing drawing = drawn(
      {ellipse({400, 500}, 150, 150, 120), ellipse({550, 500}, 150, 150, 120)},
      [](std::uint32_t upper, std::uint32_t, PicturePoint) { return upper == 0; }, PieceKind::Flat);
  for (const double share : {0.0, 0.3, 0.6}) {
    drawing.pins.push_back({{0, share}, -100});
    drawing.pins.push_back({{1, share}, 100});
  }
  const Model model = modelled(drawing);
  REQUIRE(model.conflicts.size() == 1);
  CHECK(model.conflicts[0] == std::array<std::uint32_t, 2>{0, 1});
  const double middle =
      (mesh::boundsOf(model.solids[0].mesh).low[2] + mesh::boundsOf(model.solids[0].mesh).high[2]) / 2;
  CHECK(middle == doctest::Approx(-100).epsilon(1e-3));
  CHECK(model.depth.pinsHold);
  // More pins than a plane can hold: as well as it can.
  for (int i = 0; i < 6; ++i) drawing.pins.push_back({{0, 0.1 + 0.15 * i}, 30.0 * i});
  CHECK_FALSE(modelled(drawing).depth.pinsHold);
}

TEST_CASE("lines that touch bring pieces together, but by chance turn nothing that orders hold apart") {
  const auto discs = [](double middle, std::vector<testing::Outline> between) {
    std::vector<testing::Outline> outlines{ellipse({400, 500}, 100, 100, 200), ellipse({600, middle}, 100, 100, 200)};
    outlines.insert(outlines.end(), between.begin(), between.end());
    return drawn(
        outlines, [](std::uint32_t upper, std::uint32_t lower, PicturePoint) { return upper == 0 || lower == 1; },
        PieceKind::Round);
  };
  Drawing touching = discs(500, {});
  touching.pins = {{{0, 0}, 50}, {{0, 0.3}, 50}, {{0, 0.6}, 50}};
  const Model together = modelled(touching);
  REQUIRE(together.nodes.size() == 1);
  CHECK(together.nodes[0].kind == NodeKind::Touch);
  CHECK(mesh::boundsOf(together.solids[1].mesh).high[2] > 140);
  // One disc before a body, one behind it.
  const Model apart = modelled(discs(500, {ellipse({500, 440}, 150, 90, 200)}));
  CHECK(std::ranges::count(apart.nodes, NodeKind::Touch, &Node::kind) == 1);
  for (const ModelPiece& one : apart.solids) {
    const auto bounds = mesh::boundsOf(one.mesh);
    CHECK(bounds.high[2] - bounds.low[2] < 320);
  }
}

TEST_CASE("the outline bends where a fold allows it") {
  Drawing drawing = drawn(
      {{{300, 400}, {700, 400}, {700, 600}, {300, 600}}}, [](auto, auto, auto) { return false; }, PieceKind::Round);
  const double whole = 1200;
  drawing.pins = {{{0, 0}, 0},           {{0, 200 / whole}, 100}, {{0, 400 / whole}, 0},
                  {{0, 600 / whole}, 0}, {{0, 800 / whole}, 100}, {{0, 1000 / whole}, 0}};
  // A roof: the height of the rim against the two planes, the most.
  const auto offRoof = [](const Model& model) {
    double most = 0;
    for (const auto& p : model.solids[0].mesh.positions) {
      if (std::abs(p[1] + 400) > 1e-3) continue;
      most = std::max(most, std::abs(p[2] - (100 - std::abs(p[0] - 500.0) / 2)));
    }
    return most;
  };
  const double without = offRoof(modelled(drawing));
  drawing.folds = {{0, 200 / whole}, {0, 800 / whole}};
  const double with = offRoof(modelled(drawing));
  CHECK(with < 1);
  CHECK(without > 4 * with);
}

TEST_CASE("a stiffer piece stays flatter") {
  Drawing drawing = wovenMat(3, PieceKind::Round);
  const Model before = modelled(drawing);
  drawing.pieces[1].stiffness = 10;
  const Model after = modelled(drawing);
  CHECK(after.solids[1].planarity < 0.8 * before.solids[1].planarity);
}

TEST_CASE("the same outline with more points makes the same surface") {
  const auto model = [](int parts) {
    std::vector<std::vector<PicturePoint>> outlines;
    for (const testing::Outline& corners :
         {ellipse({400, 500}, 200, 150, 64), ellipse({600, 500}, 150, 200, 64), ellipse({500, 400}, 160, 160, 64)}) {
      std::vector<PicturePoint> fine;
      for (std::size_t i = 0; i < corners.size(); ++i) {
        for (int k = 0; k < parts; ++k) fine.push_back(lerp(corners[i], corners[(i + 1) % 64], double(k) / parts));
      }
      outlines.push_back(std::move(fine));
    }
    return modelled(drawn(
        outlines, [](std::uint32_t upper, std::uint32_t lower, PicturePoint) { return upper > lower; },
        PieceKind::Round));
  };
  const Model coarse = model(1);
  for (const int parts : {4, 16}) {
    const Model other = model(parts);
    double most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rays one(coarse.solids[k].mesh), two(other.solids[k].mesh);
      for (int i = 1; i < 40; ++i) {
        for (int j = 1; j < 40; ++j) {
          const SectionPoint p{100 + 20.0 * i, -100 - 20.0 * j};
          const auto a = one.through(p), b = two.through(p);
          // At the rim both are upright.
          if (!a || !b || a->front - a->back < 120) continue;
          most = std::max({most, std::abs(a->front - b->front), std::abs(a->back - b->back)});
        }
      }
    }
    CHECK(most < 0.005 * coarse.size);
  }
}

TEST_CASE("what is no drawing is refused with a reason, and odd ones make lawful solids or none") {
  CHECK(modelOf(Drawing{}).error() == Error::ValueOutOfRange);
  Drawing drawing =
      drawn({ellipse({500, 500}, 200, 200, 40)}, [](auto, auto, auto) { return false; }, PieceKind::Round);
  drawing.pins = {{{7, 0}, 0}};
  CHECK(modelOf(drawing).error() == Error::ValueOutOfRange);
  drawing.pins.clear();
  drawing.pieces[0].stiffness = 0;
  CHECK(modelOf(drawing).error() == Error::ValueOutOfRange);
  std::size_t made = 0, tried = 0;
  for (const std::uint64_t seed : seeds(0, 60)) {
    ++tried;
    Rng rng(seed);
    Drawing odd;
    odd.size = {300, 300};
    const std::uint32_t lines = 1 + rng.below(4);
    for (std::uint32_t k = 0; k < lines; ++k) {
      Line line{{}, {}, rng.uniform() < 0.8};
      const std::uint32_t points = 3 + rng.below(8);
      for (std::uint32_t i = 0; i < points; ++i) line.points.push_back({rng.uniform(0, 300), rng.uniform(0, 300)});
      if (rng.uniform() < 0.5) line.hidden = {{rng.uniform(0, 0.4), rng.uniform(0.5, 1)}};
      odd.lines.push_back(std::move(line));
    }
    const auto model = modelOf(odd, {400});
    if (!model.ok()) {
      CHECK(model.error() == Error::RegionEmpty);
      continue;
    }
    for (const ModelPiece& one : model.value().solids) requireLawful(one.mesh);
    ++made;
  }
  CHECK(2 * made > tried);
}
