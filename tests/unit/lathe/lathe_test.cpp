#include "engine/lathe/lathe.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

#include "engine/base/rng.h"
#include "engine/lathe/rounded.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::testing;
using geometry::Contours, lathe::LatheParams;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kSize{400, 400};
/// An axis that stands on the middle of the picture's lower part: r goes right, h up.
constexpr PicturePoint kFoot{200, 350}, kHead{200, 50};

LatheParams upright() {
  LatheParams params;
  params.axisFrom = kFoot;
  params.axisTo = kHead;
  return params;
}

/// r and h as picture points beside the upright axis.
Outline beside(const std::vector<std::pair<double, double>>& points, double shift = 0) {
  Outline line;
  for (const auto& [r, h] : points) line.push_back({kFoot.x + r + shift, kFoot.y - h});
  return line;
}

const std::vector<std::pair<double, double>> kGlass{{0, 0},    {60, 0},   {60, 6},   {8, 14},   {6, 110},  {40, 140},
                                                    {50, 200}, {46, 260}, {43, 260}, {47, 200}, {36, 144}, {0, 120}};

Result<lathe::Spun> spin(const Contours& lines, bool open, const LatheParams& params, double ribbon = 0) {
  return lathe::spinRegion({lines, ribbon, open}, kSize, params);
}
mesh::MeshReport spun(const Contours& lines, bool open, const LatheParams& params, double ribbon = 0) {
  const Result<lathe::Spun> made = spin(lines, open, params, ribbon);
  REQUIRE_MESSAGE(made.ok(), errorName(made.ok() ? Error::kCount : made.error()));
  return requireLawful(made.value().mesh);
}
Error errorOf(const Contours& lines, bool open, const LatheParams& params) {
  const Result<lathe::Spun> made = spin(lines, open, params);
  return made.ok() ? Error::kCount : made.error();
}

/// Volume of a prism of n sides over that of its round.
double ofSides(int n) { return std::sin(2 * kPi / n) / (2 * kPi / n); }

/// 2π ∫ r dA over a closed polygon beside the upright axis (Pappus).
double roundVolume(const Outline& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const PicturePoint a = polygon[i] - kFoot, b = polygon[(i + 1) % polygon.size()] - kFoot;
    sum += (a.x + b.x) * cross(a, b) / 6;
  }
  return 2 * kPi * std::abs(sum);
}

}  // namespace

TEST_CASE("a wine glass has the volume that its profile sweeps, one shell, and no two corners at one place") {
  const Contours glass{beside(kGlass)};
  const Result<lathe::Spun> made = spin(glass, true, upright());
  REQUIRE(made.ok());
  const mesh::TriMesh& mesh = made.value().mesh;
  const mesh::MeshReport report = requireLawful(mesh);
  CHECK(report.volume == doctest::Approx(274914).epsilon(1e-3));
  CHECK(report.volume == doctest::Approx(roundVolume(glass[0]) * ofSides(128)).epsilon(1e-6));
  CHECK(report.genus == 0);
  CHECK(report.shells == 1);
  CHECK(std::set(mesh.positions.begin(), mesh.positions.end()).size() == mesh.positions.size());
  CHECK_FALSE(mesh::selfCrossing(mesh).has_value());
  // Both ends lie on the axis: closed by it or by themselves is the same.
  CHECK(spin(glass, false, upright()).value().mesh == mesh);

  LatheParams params = upright();
  params.sides = 6;
  CHECK(spun(glass, true, params).volume == doctest::Approx(274914 * 0.82699).epsilon(1e-5));
  params = upright();
  params.turn = 180;
  CHECK(spun(glass, true, params).volume == doctest::Approx(274914 / 2.0).epsilon(1e-3));
  params.squash = 0.5;
  CHECK(spun(glass, true, params).volume == doctest::Approx(274914 / 4.0).epsilon(1e-3));
}

TEST_CASE("what lies beyond the axis is cut off there, of closed outlines and of open lines") {
  const auto crossing = [](std::pair<double, double> a, std::pair<double, double> b) {
    return a.second + (b.second - a.second) * (20 - a.first) / (b.first - a.first);
  };
  const double foot = crossing(kGlass[2], kGlass[3]), bowl = crossing(kGlass[4], kGlass[5]);
  const double inside = crossing(kGlass[10], kGlass[11]);
  const Outline base = beside({{0, 0}, {40, 0}, {40, 6}, {0, foot}});
  const Outline cup =
      beside({{0, bowl}, {20, 140}, {30, 200}, {26, 260}, {23, 260}, {27, 200}, {16, 144}, {0, inside}});
  const double wanted = (roundVolume(base) + roundVolume(cup)) * ofSides(128);
  for (const bool open : {false, true}) {
    const mesh::MeshReport report = spun({beside(kGlass, -20)}, open, upright());
    CHECK(report.volume == doctest::Approx(wanted).epsilon(1e-5));
    CHECK(report.shells == 2);
    CHECK(report.genus == 0);
    LatheParams part = upright();
    part.turn = 90;
    CHECK(spun({beside(kGlass, -20)}, open, part).volume == doctest::Approx(wanted / 4).epsilon(1e-5));
  }
}

TEST_CASE("a circle away from its axis makes a ring, a part of a turn a bent bar, a circle in it a tunnel") {
  const Outline circle = ellipse({kFoot.x + 60, 200}, 20, 20, 180), inner = ellipse({kFoot.x + 60, 200}, 8, 8, 180);
  const double ring = 2 * kPi * 60 * kPi * 400, hole = 2 * kPi * 60 * kPi * 64;
  CHECK(ring == doctest::Approx(473741).epsilon(1e-5));
  LatheParams part = upright();
  part.turn = 180;
  const mesh::MeshReport full = spun({circle}, false, upright()), half = spun({circle}, false, part);
  CHECK(full.volume == doctest::Approx(ring).epsilon(1e-3));
  CHECK(full.genus == 1);
  CHECK(half.volume == doctest::Approx(ring / 2).epsilon(1e-3));
  CHECK(half.genus == 0);
  const mesh::MeshReport tube = spun({circle, inner}, false, upright()), bent = spun({circle, inner}, false, part);
  CHECK(tube.volume == doctest::Approx(ring - hole).epsilon(1e-3));
  CHECK(tube.genus == 2);
  CHECK(tube.shells == 2);
  CHECK(bent.volume == doctest::Approx((ring - hole) / 2).epsilon(1e-3));
  CHECK(bent.genus == 1);
  CHECK(bent.shells == 1);
}

TEST_CASE("an open line with a wall is a vessel: its outside as drawn, its lip half round") {
  const double r = 40, high = 100, wall = 3;
  LatheParams params = upright();
  params.wall = wall / 400;
  const double cup = kPi * (r * r * wall + (r * r - (r - wall) * (r - wall)) * (high - wall));
  const double pipe = kPi * (r * r - (r - wall) * (r - wall)) * high;
  // Beside the half disc of the lip two corners are missing.
  const double lip = (1 - kPi / 4) * wall * wall / 2 * 2 * kPi * (r - wall / 2);
  const Outline line = beside({{0, 0}, {r, 0}, {r, high}}), side = beside({{r, 0}, {r, high}});
  for (const bool back : {false, true}) {
    Outline way = line;
    if (back) std::ranges::reverse(way);
    const mesh::MeshReport report = spun({way}, true, params);
    CHECK(report.volume == doctest::Approx(cup).epsilon(5e-3));
    CHECK(report.volume == doctest::Approx(cup - lip).epsilon(2e-3));
    CHECK(report.genus == 0);
    CHECK(report.shells == 1);
  }
  const mesh::MeshReport open = spun({side}, true, params);
  CHECK(open.volume == doctest::Approx(pipe - 2 * lip).epsilon(2e-3));
  CHECK(open.genus == 1);
  // Closed at both ends it is hollow all through.
  const mesh::MeshReport shut = spun({beside({{0, 0}, {r, 0}, {r, high}, {0, high}})}, true, params);
  CHECK(shut.volume == doctest::Approx(kPi * (r * r * high - 37 * 37 * 94)).epsilon(2e-3));
  CHECK(shut.shells == 2);
  // Without a wall all is full.
  CHECK(spun({line}, true, upright()).volume == doctest::Approx(kPi * r * r * high * ofSides(128)).epsilon(1e-5));
  params.wall = 0.15;
  CHECK(errorOf({line}, true, params) == Error::WallTooThick);
}

TEST_CASE("the same solid comes whichever way the line, the axis and the side are drawn") {
  Rng rng(5);
  for (int round = 0; round < rounds(20); ++round) {
    Outline line = beside({{0, 0}});
    for (double h = rng.uniform(0, 20); h < 200; h += rng.uniform(8, 30)) {
      line.push_back({kFoot.x + rng.uniform(5, 90), kFoot.y - h});
    }
    const double volume = spun({line}, true, upright()).volume;
    const auto same = [&](const Outline& other, const LatheParams& params, double factor = 1) {
      CHECK(spun({other}, true, params).volume == doctest::Approx(factor * volume).epsilon(1e-5));
    };
    Outline back(line.rbegin(), line.rend()), left = line, turned = line, large = line;
    for (PicturePoint& p : left) p.x = 2 * kFoot.x - p.x;
    same(back, upright());
    same(left, upright());
    LatheParams down = upright(), far = upright(), tilted = upright(), twice = upright();
    std::swap(down.axisFrom, down.axisTo);
    same(line, down);
    far.axisFrom.y += 3000;
    same(line, far);
    const double angle = rng.uniform(0, 2 * kPi), c = std::cos(angle), s = std::sin(angle);
    const auto turn = [&](PicturePoint p) {
      const PicturePoint q = p - PicturePoint{200, 200};
      return PicturePoint{200 + c * q.x - s * q.y, 200 + s * q.x + c * q.y};
    };
    for (PicturePoint& p : turned) p = turn(p);
    tilted.axisFrom = turn(kFoot);
    tilted.axisTo = turn(kHead);
    same(turned, tilted);
    for (PicturePoint& p : large) p = p * 2;
    twice.axisFrom = kFoot * 2;
    twice.axisTo = kHead * 2;
    same(large, twice, 8);
  }
}

TEST_CASE("parts of a turn of as many faces add up to the whole turn") {
  const Contours blob{ellipse({kFoot.x + 50, 200}, 50, 30, 60)};
  LatheParams params = upright();
  params.sides = 12;
  const double whole = spun(blob, false, params).volume;
  double sum = 0;
  for (const double turn : {30.0, 60.0, 120.0, 150.0}) {
    params.turn = turn;
    sum += spun(blob, false, params).volume;
  }
  CHECK(sum == doctest::Approx(whole).epsilon(1e-5));
}

TEST_CASE("random outlines and lines make solids without a crossing, as many handles as outlines that miss the axis") {
  Rng rng(23);
  for (int round = 0; round < rounds(60); ++round) {
    LatheParams params = upright();
    params.sides = static_cast<int>(3 + rng.below(30));
    params.squash = rng.uniform(0.3, 2);
    const bool full = rng.below(2) == 0;
    if (!full) params.turn = rng.uniform(10, 350);
    const double away = rng.uniform(-30, 120), radius = rng.uniform(15, 50);
    const Outline outline = blob(rng, {kFoot.x + away, 200}, radius, 40);
    const auto sides = std::ranges::minmax(outline, {}, &PicturePoint::x);
    const bool misses = sides.min.x > kFoot.x + 2 || sides.max.x < kFoot.x - 2;
    const bool meets = sides.min.x < kFoot.x - 2 && sides.max.x > kFoot.x + 2;
    const Result<lathe::Spun> made = spin({outline}, false, params);
    REQUIRE(made.ok());
    const mesh::MeshReport report = requireLawful(made.value().mesh);
    if (misses) CHECK(report.genus == (full ? 1 : 0));
    if (meets) CHECK(report.genus == 0);
    CHECK_FALSE(mesh::selfCrossing(made.value().mesh).has_value());

    Outline scribble;
    for (int i = 0; i < 12; ++i) scribble.push_back({rng.uniform(100, 300), rng.uniform(60, 340)});
    params.wall = rng.below(2) == 0 ? 0 : rng.uniform(0.001, 0.05);
    const Result<lathe::Spun> tangled = spin({scribble}, true, params, rng.below(4) == 0 ? 6 : 0);
    if (tangled.ok()) requireLawful(tangled.value().mesh);
    if (!tangled.ok()) CHECK((tangled.error() == Error::WallTooThick || tangled.error() == Error::RegionEmpty));
  }
}

TEST_CASE("the silhouette is the profile and its mirror image") {
  const Result<lathe::Spun> made = spin({beside({{10, 0}, {40, 0}, {40, 50}, {10, 50}})}, false, upright());
  REQUIRE(made.ok());
  REQUIRE(made.value().silhouette.size() == 2);
  double area = 0;
  for (const auto& outline : made.value().silhouette) {
    double own = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) own += cross(outline[i], outline[(i + 1) % outline.size()]) / 2;
    area += std::abs(own);
  }
  CHECK(area == doctest::Approx(2 * 30 * 50));
  for (const auto& p : made.value().mesh.positions) CHECK(std::hypot(p[0] - 200, p[2]) <= 40.001);
}

TEST_CASE("the silhouette of a solid of revolution gives its axis and its volume back, however it leans") {
  Rng rng(31);
  for (int round = 0; round < rounds(20); ++round) {
    // A smooth profile longer than wide.
    Outline line;
    const double wave = rng.uniform(0.01, 0.05), phase = rng.uniform(0, 6);
    for (double h = 0; h <= 280; h += 4) line.push_back({kFoot.x + 35 + 18 * std::sin(wave * h + phase), kFoot.y - h});
    const Result<lathe::Spun> made = spin({line}, true, upright());
    REQUIRE(made.ok());
    const double lean = rng.uniform(-0.5, 0.5), c = std::cos(lean), s = std::sin(lean);
    Contours seen = made.value().silhouette;
    for (auto& outline : seen) {
      for (PicturePoint& p : outline) {
        const PicturePoint q = p - PicturePoint{200, 200};
        p = {200 + c * q.x - s * q.y, 200 + s * q.x + c * q.y};
      }
    }
    const Result<lathe::Rounded> again = lathe::rounded(seen);
    REQUIRE(again.ok());
    LatheParams params;
    params.axisFrom = again.value().axisFrom;
    params.axisTo = again.value().axisTo;
    const PicturePoint along = normalized(params.axisTo - params.axisFrom);
    const double off = std::abs(cross(along, PicturePoint{s, -c}));
    CHECK(off < (std::abs(lean) < 0.06 ? 0.06 : 0.01));
    CHECK(spun({again.value().profile}, true, params).volume ==
          doctest::Approx(requireLawful(made.value().mesh).volume).epsilon(0.025));
  }
  CHECK(lathe::rounded({}).error() == Error::RegionEmpty);
  CHECK(lathe::rounded({beside({{0, 0}, {0, 10}, {0, 20}})}).error() == Error::RegionEmpty);
}

TEST_CASE("what cannot be turned is refused by name") {
  const Contours cup{beside({{0, 0}, {40, 0}, {40, 100}})};
  CHECK(errorOf({beside({{0, 0}, {0, 100}})}, true, upright()) == Error::ProfileOnAxis);
  CHECK(errorOf({beside({{0, 0}, {0.1, 50}, {0, 100}})}, false, upright()) == Error::RegionEmpty);
  CHECK(errorOf({}, true, upright()) == Error::RegionEmpty);
  CHECK(errorOf({{kFoot}}, true, upright()) == Error::RegionEmpty);
  LatheParams params = upright();
  params.axisTo = params.axisFrom;
  CHECK(errorOf(cup, true, params) == Error::ValueOutOfRange);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e9}) {
    for (int which = 0; which < 4; ++which) {
      params = upright();
      (which == 0 ? params.axisFrom.x : which == 1 ? params.turn : which == 2 ? params.wall : params.squash) = bad;
      CHECK(errorOf(cup, true, params) == Error::ValueOutOfRange);
    }
  }
  params = upright();
  params.sides = 2;
  CHECK(errorOf(cup, true, params) == Error::ValueOutOfRange);
  Outline zigzag, smooth;
  for (int i = 0; i < 5000; ++i) {
    zigzag.push_back({230.0 + (i * 7919) % 13, 350 - i * 0.06});
    smooth.push_back({240 + 10 * std::sin(i * 0.002), 350 - i * 0.06});
  }
  CHECK(errorOf({zigzag}, true, upright()) == Error::RegionTooFine);
  const mesh::MeshReport report = spun({smooth}, true, upright());
  smooth.insert(smooth.begin(), {200, 350});
  smooth.push_back({200, smooth.back().y});
  CHECK(report.volume == doctest::Approx(roundVolume(smooth)).epsilon(2e-3));
}
