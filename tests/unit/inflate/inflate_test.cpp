#include "engine/inflate/inflate.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/mesh_angles.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;

namespace {

constexpr image::Size kSize{500, 400};

mesh::TriMesh puffed(const geometry::Contours& drawn, const InflateParams& params = {}, double ribbon = 0) {
  const auto clean = geometry::cleanRegion(drawn, ribbon, {500, 400});
  REQUIRE(clean.ok());
  Result<mesh::TriMesh> solid = inflateRegion(clean.value(), kSize, params);
  REQUIRE(solid.ok());
  requireLawful(solid.value());
  return std::move(solid).value();
}

double highest(const mesh::TriMesh& mesh) {
  float high = 0;
  for (const auto& p : mesh.positions) high = std::max(high, p[2]);
  return static_cast<double>(high);
}

/// The least distance from a point to a triangle: inside of it along its normal, else to one of its edges.
double distanceTo(const ModelPoint& p, const std::array<ModelPoint, 3>& corners) {
  const ModelPoint normal = cross(corners[1] - corners[0], corners[2] - corners[0]);
  bool over = true;
  double least = 1e300;
  for (std::size_t k = 0; k < 3; ++k) {
    const ModelPoint edge = corners[(k + 1) % 3] - corners[k], off = p - corners[k];
    over = over && dot(cross(edge, off), normal) >= 0;
    const double along = std::clamp(dot(off, edge) / dot(edge, edge), 0.0, 1.0);
    least = std::min(least, norm(off - edge * along));
  }
  return over ? std::min(least, std::abs(dot(p - corners[0], normal)) / norm(normal)) : least;
}

/// The greatest distance from a corner of one surface to the other surface; `kCell` where it is more than that.
double farthest(const mesh::TriMesh& from, const mesh::TriMesh& to) {
  constexpr double kCell = 8;
  constexpr int kColumns = 80, kRows = 70;
  const auto cellOf = [](double x, int cells) { return std::clamp(static_cast<int>(x / kCell) + 4, 1, cells - 2); };
  const auto pointOf = [](const auto& p) { return ModelPoint{p[0], p[1], p[2]}; };
  std::vector<std::vector<std::array<ModelPoint, 3>>> cells(kColumns * kRows);
  for (const auto& t : to.triangles) {
    const std::array corners{pointOf(to.positions[t[0]]), pointOf(to.positions[t[1]]), pointOf(to.positions[t[2]])};
    const auto [left, right] = std::minmax({corners[0].x, corners[1].x, corners[2].x});
    const auto [low, high] = std::minmax({-corners[0].y, -corners[1].y, -corners[2].y});
    for (int row = cellOf(low, kRows) - 1; row <= cellOf(high, kRows) + 1; ++row) {
      for (int column = cellOf(left, kColumns) - 1; column <= cellOf(right, kColumns) + 1; ++column) {
        cells[static_cast<std::size_t>(row * kColumns + column)].push_back(corners);
      }
    }
  }
  double most = 0;
  for (const auto& position : from.positions) {
    const ModelPoint p = pointOf(position);
    double least = kCell;
    for (const auto& corners :
         cells[static_cast<std::size_t>(cellOf(-p.y, kRows) * kColumns + cellOf(p.x, kColumns))]) {
      least = std::min(least, distanceTo(p, corners));
    }
    most = std::max(most, least);
  }
  return most;
}

}  // namespace

TEST_CASE("a circle becomes a ball to 1 % in height, volume and area, better with more points") {
  const double r = 150, ball = 4 * std::numbers::pi / 3 * r * r * r;
  double before = 1;
  for (const int points : {500, 2000, 4000}) {
    const mesh::TriMesh mesh = puffed({ellipse({200, 200}, r, r, 600)}, {1, InflateSides::Both, points});
    const mesh::MeshReport report = mesh::inspect(mesh);
    const double off = std::abs(report.volume / ball - 1);
    CHECK(off < before);
    before = off;
    if (points < 2000) continue;
    CHECK(off < 0.01);
    CHECK(highest(mesh) == doctest::Approx(r).epsilon(0.01));
    CHECK(report.area == doctest::Approx(4 * std::numbers::pi * r * r).epsilon(0.01));
    CHECK(mesh.positions.size() < 1.3 * points);
    CHECK(anglesOf(mesh).front() > 20);
  }
}

TEST_CASE("an ellipse becomes an ellipsoid") {
  // −Δu = 4 has u = 2 a² b² / (a² + b²) · (1 − x²/a² − y²/b²), so that √u is an ellipsoid.
  const double a = 180, b = 70;
  const mesh::TriMesh mesh = puffed({ellipse({240, 200}, a, b, 500)});
  const double c = a * b * std::sqrt(2 / (a * a + b * b));
  CHECK(highest(mesh) == doctest::Approx(c).epsilon(0.01));
  CHECK(mesh::inspect(mesh).volume == doctest::Approx(4 * std::numbers::pi / 3 * a * b * c).epsilon(0.01));
  for (const auto& p : mesh.positions) {
    const double x = (static_cast<double>(p[0]) - 240) / a, y = (static_cast<double>(p[1]) + 200) / b;
    const double z = static_cast<double>(p[2]) / c;
    CHECK(x * x + y * y + z * z == doctest::Approx(1).epsilon(0.03));
  }
}

TEST_CASE("sampling the same outline differently changes the solid by less than 1 %" * doctest::test_suite("slow")) {
  constexpr double kRadius = 110;
  double worst = 180, farthestOff = 0;
  for (const std::uint64_t seed : testing::seeds(100, 112)) {
    const auto sampled = [&](int points) {
      Rng rng(seed);
      return blob(rng, {250, 200}, kRadius, points);
    };
    // A hand that is quick on one side and slow on the other.
    Outline uneven;
    const Outline fine = sampled(1800);
    for (std::size_t i = 0; i < fine.size(); i += i < fine.size() / 2 ? 15 : 2) uneven.push_back(fine[i]);
    const mesh::TriMesh dense = puffed({sampled(900)});
    worst = std::min(worst, anglesOf(dense).front());
    for (const Outline& other : {sampled(131), sampled(317), uneven}) {
      const mesh::TriMesh solid = puffed({other});
      CHECK(mesh::inspect(dense).volume == doctest::Approx(mesh::inspect(solid).volume).epsilon(0.01));
      CHECK(highest(dense) == doctest::Approx(highest(solid)).epsilon(0.01));
      const double off = std::max(farthest(dense, solid), farthest(solid, dense)) / (2 * kRadius);
      CHECK(off < 0.01);
      farthestOff = std::max(farthestOff, off);
      worst = std::min(worst, anglesOf(solid).front());
    }
  }
  MESSAGE("48 blobs: worst angle " << worst << " degrees, at most " << 100 * farthestOff << " % of the size off");
  CHECK(worst > 20);
}

TEST_CASE("one-sided puffs are half of the whole one, flat in the picture's plane") {
  const geometry::Contours drawn{ellipse({200, 200}, 120, 90, 300)};
  const double whole = mesh::inspect(puffed(drawn)).volume;
  for (const InflateSides sides : {InflateSides::Front, InflateSides::Back}) {
    const mesh::TriMesh mesh = puffed(drawn, {1, sides, 2000});
    CHECK(mesh::inspect(mesh).volume == doctest::Approx(whole / 2).epsilon(1e-3));
    for (const auto& p : mesh.positions) CHECK((sides == InflateSides::Front ? p[2] >= 0 : p[2] <= 0));
  }
}

TEST_CASE("the height scales what stands out of the picture, the size everything") {
  Rng rng(8), same(8);
  const Outline small = blob(rng, {120, 120}, 50, 200);
  Outline large = blob(same, {0, 0}, 50, 200);
  for (PicturePoint& p : large) p = p * 2 + PicturePoint{200, 200};
  const double volume = mesh::inspect(puffed({small})).volume;
  CHECK(mesh::inspect(puffed({small}, {0.5, InflateSides::Both, 2000})).volume ==
        doctest::Approx(volume / 2).epsilon(0.01));
  CHECK(mesh::inspect(puffed({small}, {2, InflateSides::Both, 2000})).volume ==
        doctest::Approx(volume * 2).epsilon(0.01));
  CHECK(mesh::inspect(puffed({large})).volume == doctest::Approx(volume * 8).epsilon(0.01));
}

TEST_CASE("every hole is a handle and every piece a shell") {
  const geometry::Contours drawn{ellipse({120, 200}, 100, 100, 200), ellipse({90, 200}, 25, 25, 60),
                                 ellipse({160, 200}, 25, 25, 60), ellipse({380, 200}, 80, 80, 150)};
  const mesh::MeshReport report = mesh::inspect(puffed(drawn));
  CHECK(report.genus == 2);
  CHECK(report.shells == 2);
  CHECK(mesh::inspect(puffed({{{100, 100}, {300, 100}, {200, 300}, {100, 100}}}, {}, 20)).genus == 1);
}

TEST_CASE("triangles are well shaped on hard outlines too, but for corners that are sharper themselves") {
  Outline comb, star;
  for (int i = 0; i < 20; ++i) {
    const double x = 40 + 20 * i;
    comb.insert(comb.end(), {{x, 50}, {x + 3, 50}, {x + 3, 330}, {x + 18, 330}});
  }
  comb.insert(comb.end(), {{440, 350}, {40, 350}});
  for (int i = 0; i < 10; ++i) {
    const double r = i % 2 ? 180 : 70, a = 2 * std::numbers::pi * i / 10;
    star.push_back({250 + r * std::cos(a), 200 + r * std::sin(a)});
  }
  for (const auto& [drawn, least] : {std::pair{comb, 15.0},
                                     {star, 15.0},
                                     {rectangle(20, 100, 480, 103), 20.0},
                                     {Outline{{20, 100}, {480, 100}, {480, 300}}, 15.0}}) {
    const double worst = anglesOf(puffed({drawn})).front();
    MESSAGE("worst angle: " << worst << " degrees");
    CHECK(worst > least);
  }
}

TEST_CASE("thin, sharp, tiny, tangled and full-picture regions are lawful too") {
  puffed({rectangle(20, 100, 480, 103)});
  puffed({{{20, 200}, {480, 195}, {480, 205}}});
  puffed({ellipse({100, 100}, 2.5, 2.5, 20)});
  puffed({rectangle(-50, -50, 900, 900)});
  puffed({{{50, 50}, {250, 250}, {250, 50}, {50, 250}}});
  Outline comb;
  for (int i = 0; i < 20; ++i) {
    const double x = 40 + 20 * i;
    comb.insert(comb.end(), {{x, 50}, {x + 3, 50}, {x + 3, 330}, {x + 18, 330}});
  }
  comb.insert(comb.end(), {{440, 350}, {40, 350}});
  puffed({comb});
  Rng rng(21);
  for (int round = 0; round < testing::rounds(10); ++round) {
    Outline scribble;
    for (int i = 0; i < 8; ++i) scribble.push_back({rng.uniform(20, 480), rng.uniform(20, 380)});
    puffed({scribble}, {rng.uniform(0.1, 3), InflateSides::Both, 600});
  }
}
