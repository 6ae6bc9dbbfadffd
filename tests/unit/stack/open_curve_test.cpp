#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/laws.h"
#include "engine/stack/stand.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/plane_cut.h"
#include "tests/support/rounds.h"
#include "tests/support/stacks.h"

using namespace spineloft;
using namespace spineloft::stack;
using namespace spineloft::testing;

namespace {

double volumeOf(const Curve& curve) {
  const mesh::TriMesh mesh = stacked({railPlane(0, {curve}), railPlane(1, {curve})}, railAhead(100));
  const mesh::MeshReport report = requireLawful(mesh);
  CHECK(report.genus == 0);
  CHECK(report.shells == 1);
  return report.volume;
}

/// From left to right, higher than `base`.
std::vector<SectionPoint> hills(Rng& rng, double base) {
  std::vector<SectionPoint> line;
  const std::uint32_t count = 2 + rng.below(9);
  double x = rng.uniform(-60, -40);
  for (std::uint32_t i = 0; i < count; ++i) {
    line.push_back({x, base + rng.uniform(16, 30)});
    x += rng.uniform(16, 24);
  }
  return line;
}

}  // namespace

TEST_CASE("a ribbon is as large as its line is long times its width") {
  CHECK(volumeOf(ribbon({{-30, 5}, {20, 5}}, 6)) == doctest::Approx(50 * 6 * 100).epsilon(1e-6));
  // What a mitre adds outside a corner it takes away inside.
  CHECK(volumeOf(ribbon({{-30, 0}, {20, 0}, {20, 40}}, 8)) == doctest::Approx(90 * 8 * 100).epsilon(1e-6));
  std::vector<SectionPoint> arc;
  constexpr double kAngle = 4;
  for (int i = 0; i <= 6; ++i) arc.push_back({50 * std::cos(kAngle * i / 6), 50 * std::sin(kAngle * i / 6)});
  CHECK(volumeOf(ribbon(arc, 10, false)) == doctest::Approx(50 * kAngle * 10 * 100).epsilon(1e-3));
  // A corner so sharp that its mitre would be too long is blunt: half its width beyond the point.
  const mesh::TriMesh sharp = stacked({railPlane(0, {ribbon({{-40, -4}, {0, 0}, {-40, 4}}, 2)})}, railAhead(100));
  requireLawful(sharp);
  CHECK(mesh::boundsOf(sharp).high[0] < 100 + 1.01);
}

TEST_CASE("ground is the sum of its trapezoids, and its underside is even") {
  const std::vector<SectionPoint> low{{-50, 10}, {-20, 30}, {10, 14}, {50, 22}};
  const std::vector<SectionPoint> high{{-50, 26}, {-20, 12}, {10, 50}, {50, 6}};
  const auto areaOf = [](const std::vector<SectionPoint>& line, double base) {
    double area = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      area += (line[i].x - line[i - 1].x) * ((line[i].y + line[i - 1].y) / 2 - base);
    }
    return area;
  };
  CHECK(volumeOf(ground(low, -5)) == doctest::Approx(100 * areaOf(low, -5)).epsilon(1e-3));
  // The first point and the last one may stand on the ground.
  CHECK(volumeOf(ground({{-40, 2}, {0, 30}, {40, 2}}, 2)) == doctest::Approx(100 * 40 * 28).epsilon(1e-3));
  for (const sections::BlendKind blend : {sections::BlendKind::Linear, sections::BlendKind::Flow}) {
    const mesh::TriMesh mesh =
        stacked({railPlane(0, {ground(low, -5)}, blend), railPlane(1, {ground(high, -5)})}, railAhead(100));
    CHECK(requireLawful(mesh).volume == doctest::Approx(50 * (areaOf(low, -5) + areaOf(high, -5))).epsilon(4e-3));
    CHECK(mesh::boundsOf(mesh).low[1] == doctest::Approx(-105).epsilon(1e-6));
    const PlaneCut cut = cutBy(mesh, {{100, -100, -50}, {1, 0, 0}, {0, 1, 0}});
    for (double x = -49; x < 50; x += 1) CHECK(cut.holds({x, -4.99}));
  }
  // It is filled down to the line, whichever way it was drawn.
  std::vector<SectionPoint> back(low.rbegin(), low.rend());
  CHECK(volumeOf(ground(back, -5)) == doctest::Approx(volumeOf(ground(low, -5))).epsilon(1e-6));
}

TEST_CASE("the cut through a stack of ribbons and ground is what was drawn, with whatever they become") {
  std::size_t cuts = 0, coarse = 0;
  for (const std::uint64_t seed : seeds(0, 30)) {
    CAPTURE(seed);
    Rng rng(seed);
    std::vector<Plane> planes;
    const std::uint32_t count = 2 + rng.below(4);
    for (std::uint32_t i = 0; i < count; ++i) {
      const bool corners = rng.below(2) == 0;
      Curve curve = ground(hills(rng, -20), -20, corners);
      if (rng.below(3) == 0) curve = ribbon(curve.through, rng.uniform(4, 6), corners);
      if (rng.below(4) == 0) curve = circleCurve(rng.uniform(15, 30));
      planes.push_back(railPlane(static_cast<double>(i) / (count - 1), {curve},
                                 rng.below(2) == 0 ? sections::BlendKind::Flow : sections::BlendKind::Hold));
    }
    const mesh::TriMesh mesh = stacked(planes, railAhead(300));
    const mesh::MeshReport report = requireLawful(mesh);
    CHECK(report.genus == 0);
    CHECK(report.shells == 1);
    for (std::uint32_t i = 0; i < count; ++i) {
      CAPTURE(i);
      const double at = -300.0 * i / (count - 1) + (i == 0 ? -0.01 : 0.0001);
      const std::vector<SectionPoint> outline = outlineOf(planes[i].curves[0]);
      const PlaneCut cut = cutBy(mesh, {{100, -100, at}, {1, 0, 0}, {0, 1, 0}});
      const auto drawn = [&](SectionPoint p) { return geometry::holds(std::span<const SectionPoint>(outline), p); };
      // Points round a long ribbon are half its width apart, and those of low hills a good part of their height.
      const double share = overlapShare(cut, drawn, {-80, -30}, {200, 40});
      CHECK(share >= 0.94);
      ++cuts;
      coarse += planes[i].curves[0].width == 0 && share < 0.98;
    }
  }
  CHECK(coarse <= cuts / 100);
}

TEST_CASE("open curves that make no section are refused in a sentence that names curve and sheet") {
  const Plane end = railPlane(1, {circleCurve(10)});
  const auto refused = [&](const Curve& curve, const std::string& words) {
    requireRefused({railPlane(0, {circleCurve(3, {200, 0}), curve}), end}, railAhead(100), {}, words);
  };
  Curve bare = ribbon({{0, 0}, {30, 0}}, 2);
  bare.as = CurveUse::Closed;
  refused(bare, "curve 2 on sheet 1 is open: make it a ribbon or ground");
  refused(ribbon({{0, 0}, {30, 0}}, 0), "curve 2 on sheet 1 is a ribbon without a width");
  Curve closed = circleCurve(10);
  closed.as = CurveUse::Ground;
  refused(closed, "curve 2 on sheet 1 is closed");
  refused(ribbon({{0, 0}, {10, 8}, {20, 0}}, 60), "bends tighter than its width");
  refused(ribbon({{0, 0}, {30, 0}}, 1e-5), "too thin");
  refused(ground({{0, 10}, {10, -1}, {20, 10}}, 0), "curve 2 on sheet 1 goes below its base: lower the base");
  refused(ground({{0, 10}, {10, 0}, {20, 10}}, 0), "crosses itself or the way down");
  refused(ground({{0, 0}, {20, 0}}, 0), "encloses nothing");
  refused(ground({{5, 5}, {5, 5}}, 0), "has no size");
  Curve wild = ribbon({{0, 0}, {30, 0}}, std::numeric_limits<double>::quiet_NaN());
  refused(wild, "curve 2 on sheet 1");
  wild.width = 2;
  wild.base = std::numeric_limits<double>::infinity();
  refused(wild, "curve 2 on sheet 1");
}
