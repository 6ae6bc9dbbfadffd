// Tables and chairs that nobody pinned.
#include "engine/descriptive/right_angles.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "engine/base/rng.h"
#include "engine/descriptive/model.h"
#include "tests/support/mesh_laws.h"
#include "tests/unit/descriptive/drawings.h"
#include "tests/unit/descriptive/rays.h"

namespace spineloft::descriptive {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

constexpr double kScale = 380;  // pixels

/// Turned round the upright axis, then tilted towards the viewer, who looks down on it. Or an oblique projection: the
/// front as it is, what goes back drawn `back` times as long, slanted by 45° to the right (−1: to the left).
struct View {
  double round = 0, down = 0, back = 0, side = 1;
  PicturePoint of(ModelPoint p) const {
    const ModelPoint q = turned(p);
    return {500 + kScale * q.x, 620 - kScale * q.y};
  }
  ModelPoint turned(ModelPoint p) const {
    if (back > 0) return {p.x - side * p.z * back * std::sqrt(0.5), p.y - p.z * back * std::sqrt(0.5), p.z};
    const double x = p.x * std::cos(round) + p.z * std::sin(round), z = p.z * std::cos(round) - p.x * std::sin(round);
    return {x, p.y * std::cos(down) - z * std::sin(down), p.y * std::sin(down) + z * std::cos(down)};
  }
};

/// What a person draws of a table (back = 0) or of a chair: piece 0 is its top, the last one the back, between them are
/// legs.
struct Furniture {
  Drawing drawing;
  double height = 0;  ///< of the legs, pixels
  bool isChair = false;
};

Furniture furniture(const View& view, double back, double jitter, Rng& rng) {
  const double wide = rng.uniform(0.8, 1.3), deep = rng.uniform(0.6, 1.0), high = rng.uniform(0.5, 0.9);
  const auto corner = [&](double x, double z) { return ModelPoint{x * wide / 2, high / 2, z * deep / 2}; };
  std::vector<std::vector<PicturePoint>> outlines{
      {view.of(corner(-1, -1)), view.of(corner(1, -1)), view.of(corner(1, 1)), view.of(corner(-1, 1))}};
  std::vector<double> depths{0};
  for (const auto& [x, z] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    ModelPoint top = corner(x * 0.86, z * 0.86), foot = top;
    top.y -= 0.01;
    foot.y = -high / 2;
    outlines.push_back(testing::strip(view.of(top), view.of(foot), 30));
    depths.push_back(view.turned(foot).z);
  }
  if (back > 0) {
    // It stands behind all of it.
    const ModelPoint left = corner(-1, -1), right = corner(1, -1), up{0, back, 0};
    outlines.push_back({view.of(left), view.of(left + up), view.of(right + up), view.of(right)});
    depths.push_back(0);
  }
  const double off = 700 * jitter;
  for (auto& outline : outlines) {
    for (PicturePoint& p : outline) {
      const double angle = rng.uniform(0, 2 * std::numbers::pi), away = off * std::sqrt(rng.uniform(0, 1));
      p += PicturePoint{std::cos(angle), std::sin(angle)} * away;
    }
  }
  // The back begins and ends on the top's edge.
  if (back > 0) {
    outlines.back().front() = outlines[0][0];
    outlines.back().back() = outlines[0][1];
  }
  const std::size_t legsEnd = 5;
  Furniture out{testing::drawn(
                    outlines,
                    [&](std::uint32_t upper, std::uint32_t lower, PicturePoint) {
                      if (lower == 0 || upper >= legsEnd) return false;
                      if (upper == 0 || lower >= legsEnd) return true;
                      return depths[upper] > depths[lower];
                    },
                    PieceKind::Round),
                kScale * high, back > 0};
  out.drawing.pieces[0].kind = PieceKind::Flat;
  if (back > 0) {
    Line& line = out.drawing.lines.back();
    line.closed = false;
    line.hidden.clear();
    const double sides = distance(outlines[0][0], outlines[0][1]) + distance(outlines[0][1], outlines[0][2]) +
                         distance(outlines[0][2], outlines[0][3]) + distance(outlines[0][3], outlines[0][0]);
    const double edge = distance(outlines[0][0], outlines[0][1]) / sides;
    out.drawing.pieces.back() = {"Back", PieceKind::Flat, {{{5, 0, 1}, {0, edge, 0}}}, 1, 1, 1, 0};
  }
  return out;
}

/// The middles of the upper and the lower sixth of a leg.
std::array<ModelPoint, 2> endsOf(const mesh::TriMesh& mesh) {
  double low = 1e30, high = -1e30;
  for (const auto& p : mesh.positions) {
    low = std::min<double>(low, p[1]);
    high = std::max<double>(high, p[1]);
  }
  std::array<ModelPoint, 2> sums{};
  std::array<double, 2> counts{};
  for (const auto& p : mesh.positions) {
    const double share = (p[1] - low) / (high - low);
    if (share > 1.0 / 6 && share < 5.0 / 6) continue;
    const std::size_t end = share > 0.5 ? 0 : 1;
    sums[end] += ModelPoint{p[0], p[1], p[2]};
    ++counts[end];
  }
  return {sums[0] / counts[0], sums[1] / counts[1]};
}

/// The normal of the largest triangle that is seen.
ModelPoint normalOf(const mesh::TriMesh& mesh) {
  ModelPoint best{};
  for (const auto& t : mesh.triangles) {
    const auto at = [&](int k) {
      const auto& p = mesh.positions[t[static_cast<std::size_t>(k)]];
      return ModelPoint{p[0], p[1], p[2]};
    };
    const ModelPoint normal = cross(at(1) - at(0), at(2) - at(0));
    if (normal.z > 0 && norm(normal) > norm(best)) best = normal;
  }
  return normalized(best);
}

/// Whether the solids are inside each other somewhere, on a fine grid of rays.
bool areJoined(const mesh::TriMesh& one, const mesh::TriMesh& other) {
  constexpr int kAcross = 250;
  const testing::Rays a(one), b(other);
  SectionPoint low{1e30, 1e30}, high{-1e30, -1e30};
  for (const auto& p : one.positions) {
    low = {std::min<double>(low.x, p[0]), std::min<double>(low.y, p[1])};
    high = {std::max<double>(high.x, p[0]), std::max<double>(high.y, p[1])};
  }
  for (int i = 0; i < kAcross * kAcross; ++i) {
    const SectionPoint at{low.x + (high.x - low.x) * (i % kAcross + 0.5) / kAcross,
                          low.y + (high.y - low.y) * (i / kAcross + 0.5) / kAcross};
    const auto first = a.through(at), second = b.through(at);
    if (first && second && first->front > second->back && second->front > first->back) return true;
  }
  return false;
}

struct Measured {
  std::vector<double> lean, unlevel;  ///< degrees; shares of the height
  std::vector<double> upright, axis;  ///< degrees from the normal of the top: up, and the most upright axis
  std::size_t apart = 0, wrong = 0;
  double backLean = 0;
};

void measure(const Furniture& furniture, Measured& all) {
  const auto made = modelOf(furniture.drawing);
  REQUIRE(made.ok());
  const Model& model = made.value();
  REQUIRE(model.solids.size() == furniture.drawing.pieces.size());
  const ModelPoint up = normalOf(model.solids[0].mesh);
  REQUIRE(model.up.has_value());
  all.upright.push_back(std::acos(std::min(1.0, dot(*model.up, up))) * kDegrees);
  const RightAngles angles = rightAnglesOf(testing::sheetsOf(furniture.drawing), furniture.drawing.pieces, model.size);
  REQUIRE(angles.up.has_value());
  all.axis.push_back(std::acos(std::min(1.0, dot(*angles.up, up))) * kDegrees);
  double low = 1e30, high = -1e30;
  for (std::size_t leg = 1; leg < 5; ++leg) {
    const mesh::TriMesh& mesh = model.solids[leg].mesh;
    testing::requireLawful(mesh);
    const auto [top, foot] = endsOf(mesh);
    all.lean.push_back(std::acos(std::min(1.0, dot(normalized(top - foot), up))) * kDegrees);
    low = std::min(low, dot(foot, up));
    high = std::max(high, dot(foot, up));
    if (!areJoined(mesh, model.solids[0].mesh)) ++all.apart;
  }
  all.unlevel.push_back((high - low) / furniture.height);
  all.wrong += testing::lookAtOrders(furniture.drawing, model).wrong;
  if (!furniture.isChair) return;
  if (!areJoined(model.solids[5].mesh, model.solids[0].mesh)) ++all.apart;
  const double between = std::acos(std::abs(dot(normalOf(model.solids[5].mesh), up))) * kDegrees;
  all.backLean = std::max(all.backLean, std::abs(between - 90));
}

double share95(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() * 95 / 100];
}

TEST_CASE("tables and chairs without pins: legs upright, feet level, orders as drawn, and joined") {
  for (const double back : {0.0, 0.9}) {
    CAPTURE(back);
    Rng rng(5);
    Measured all;
    std::size_t flat = 0;
    for (int view = 0; view < 40; ++view) {
      const double side = rng.below(2) == 0 ? -1 : 1;
      const View from{side * rng.uniform(0.35, 0.95), rng.uniform(0.35, 0.8)};
      const std::size_t apart = all.apart;
      measure(furniture(from, back, 0.005, rng), all);
      if (from.down < 27 / kDegrees) flat += std::exchange(all.apart, apart) - apart;
    }
    // Seen flatter a leg may end before it is under the top.
    CHECK(flat <= 1);
    CHECK(share95(all.lean) <= 1.5);
    CHECK(share95(all.unlevel) <= 0.05);
    CHECK(share95(all.upright) <= 0.5);
    CHECK(share95(all.axis) <= 1.5);
    CHECK(all.backLean <= 1);
    CHECK(all.apart == 0);
    CHECK(all.wrong == 0);
  }
}

TEST_CASE("a table with its front drawn square, as children draw it, stands on upright legs") {
  Rng rng(12);
  Measured all;
  for (const double back : {0.5, 0.7, 1.0}) {
    for (const double side : {1.0, -1.0}) {
      for (int i = 0; i < 6; ++i) measure(furniture({0, 0, back, side}, 0, i % 2 == 0 ? 0 : 0.005, rng), all);
    }
  }
  // No view looks like that: what is at right angles in the picture is not quite in space.
  CHECK(share95(all.lean) <= 10);
  // Up is off the top, which is what things are put on.
  CHECK(share95(all.upright) <= 0.5);
  CHECK(share95(all.axis) <= 10);
  CHECK(share95(all.unlevel) <= 0.09);
  CHECK(all.apart <= 3);  // of 144
  CHECK(all.wrong == 0);
}

TEST_CASE("what has no axes at right angles stays as it was: bars, a mat, ellipses, a triangle with legs") {
  const auto risesIn = [](const Drawing& drawing) {
    return rightAnglesOf(testing::sheetsOf(drawing), drawing.pieces, sizeOf(drawing.lines)).rises.size();
  };
  CHECK(risesIn(testing::barsInACycle()) == 0);
  CHECK_FALSE(modelOf(testing::barsInACycle()).value().up.has_value());
  CHECK(risesIn(testing::wovenMat(4, PieceKind::Round)) == 0);
  for (std::uint64_t seed = 0; seed < 20; ++seed) CHECK(risesIn(testing::drawingOf(testing::randomDiscs(seed))) == 0);
  const auto never = [](std::uint32_t, std::uint32_t, PicturePoint) { return false; };
  const std::vector<std::vector<PicturePoint>> legs{testing::strip({300, 500}, {250, 800}, 40),
                                                    testing::strip({600, 500}, {680, 800}, 40)};
  std::vector<std::vector<PicturePoint>> outlines = legs;
  outlines.push_back({{200, 450}, {480, 150}, {760, 520}});
  CHECK(risesIn(testing::drawn(outlines, never, PieceKind::Round)) == 0);
  // A body seen from the front with slanted arms.
  outlines = {{{350, 300}, {650, 300}, {650, 700}, {350, 700}},
              testing::strip({360, 400}, {160, 600}, 40),
              testing::strip({200, 240}, {360, 400}, 40)};
  CHECK(risesIn(testing::drawn(outlines, never, PieceKind::Round)) == 0);
  outlines = legs;
  outlines.emplace_back();
  // A parallelogram with these legs would be a table.
  outlines.back() = {{200, 450}, {480, 380}, {760, 470}, {480, 540}};
  CHECK(risesIn(testing::drawn(outlines, never, PieceKind::Round)) > 0);
}

TEST_CASE("seen from below, what is nearer is farther and up is up; unknown, there are no right angles") {
  Rng rng(9);
  const Furniture table = furniture({0.6, 0.6}, 0, 0, rng);
  const std::vector<Sheet> sheets = testing::sheetsOf(table.drawing);
  const double size = sizeOf(table.drawing.lines);
  const auto seen = [&](SeenFrom from) { return rightAnglesOf(sheets, table.drawing.pieces, size, from); };
  const RightAngles above = seen(SeenFrom::Above), below = seen(SeenFrom::Below);
  REQUIRE(above.rises.size() == below.rises.size());
  for (std::size_t i = 0; i < above.rises.size(); ++i) CHECK(above.rises[i].nearer == -below.rises[i].nearer);
  REQUIRE(above.up.has_value());
  CHECK(norm(*above.up) == doctest::Approx(1));
  CHECK(above.up->z > 0.1);
  CHECK(*below.up == ModelPoint{above.up->x, above.up->y, -above.up->z});
  CHECK(seen(SeenFrom::Unknown).rises.empty());
  CHECK_FALSE(seen(SeenFrom::Unknown).up.has_value());
}

TEST_CASE("a table is the same whichever line was drawn first") {
  Rng rng(8);
  const Furniture table = furniture({0.6, 0.6}, 0, 0, rng);
  const auto first = modelOf(table.drawing);
  REQUIRE(first.ok());
  Drawing other = table.drawing;
  std::ranges::reverse(other.lines);
  std::ranges::reverse(other.pieces);
  for (std::uint32_t i = 0; i < other.pieces.size(); ++i) other.pieces[i].outlines = {{{i, 0, 1}}};
  const auto second = modelOf(other);
  REQUIRE(second.ok());
  const std::size_t n = other.pieces.size();
  for (std::size_t i = 0; i < n; ++i) {
    const ModelPoint a = normalOf(first.value().solids[i].mesh), b = normalOf(second.value().solids[n - 1 - i].mesh);
    if (i == 0) CHECK(norm(a - b) < 1e-3);
    const auto ends = endsOf(first.value().solids[i].mesh), others = endsOf(second.value().solids[n - 1 - i].mesh);
    if (i > 0) CHECK(norm((ends[0] - ends[1]) - (others[0] - others[1])) < 1);
  }
}

}  // namespace
}  // namespace spineloft::descriptive
