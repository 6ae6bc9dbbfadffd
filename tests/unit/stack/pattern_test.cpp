#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "engine/geometry/value_noise.h"
#include "engine/mesh/self_crossing.h"
#include "engine/stack/stand.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"
#include "tests/support/stacks.h"

using namespace spineloft;
using namespace spineloft::stack;
using namespace spineloft::testing;
using sections::BlendKind;

namespace {

/// The same planes without patterns, written out by hand.
std::vector<Plane> byHand(const std::vector<Plane>& planes, const std::vector<Pattern>& patterns) {
  std::vector<Plane> out;
  for (std::uint32_t i = 0; i < planes.size(); ++i) {
    const auto inside = [&](const Pattern& p) { return p.first <= i && i <= p.last; };
    const auto pattern = std::ranges::find_if(patterns, inside);
    if (pattern == patterns.end()) {
      out.push_back(planes[i]);
    } else if (i == pattern->last) {
      for (std::uint32_t copy = 0; copy < pattern->times; ++copy) {
        for (std::uint32_t k = pattern->first; k <= pattern->last; ++k) {
          out.push_back(planes[k]);
          out.back().at = planes[k].at + copy * pattern->spacing;
        }
      }
    }
  }
  return out;
}

StackParams with(std::vector<Pattern> patterns) {
  StackParams params;
  params.patterns = std::move(patterns);
  return params;
}
StackParams with(const Rough& rough) {
  StackParams params;
  params.rough = rough;
  return params;
}

Curve blob(Rng& rng, double size, SectionPoint centre = {}) {
  Curve curve;
  const std::uint32_t points = 5 + rng.below(6);
  for (std::uint32_t i = 0; i < points; ++i) {
    const double angle = 2 * std::numbers::pi * i / points, radius = size * rng.uniform(0.8, 1.2);
    curve.through.push_back(centre + SectionPoint{radius * std::cos(angle), radius * std::sin(angle)});
  }
  curve.corners.all = rng.below(3) == 0;
  return curve;
}

}  // namespace

TEST_CASE("what holds stays as it is and changes just before the next sheet: a sum of prisms") {
  CHECK(sections::blendAt({BlendKind::Hold, {}}, 0.5) == 0);
  CHECK(sections::blendAt({BlendKind::Hold, {}}, sections::kHeld) == doctest::Approx(0));
  CHECK(sections::blendAt({BlendKind::Hold, {}}, 1) == 1);
  const auto tower = [](const Rail& rail) {
    return stacked({railPlane(0, {rectangle(40, 20)}, BlendKind::Hold),
                    railPlane(0.25, {circleCurve(12, {20, 10})}, BlendKind::Hold), railPlane(1, {rectangle(30, 60)})},
                   rail);
  };
  const double circle = std::numbers::pi * 144;
  CHECK(requireLawful(tower(railAhead(400))).volume == doctest::Approx(100 * 800 + 300 * circle).epsilon(0.005));
  // On a rail that bends about the middle of what stands on it: Pappus.
  Plane round = railPlane(0, {circleCurve(10)}, BlendKind::Hold), angular = round;
  angular.at = 0.5;
  angular.curves = {polygonCurve({{-8, -8}, {8, -8}, {8, 8}, {-8, 8}})};
  Rail ring{{}, true};
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * std::numbers::pi * i / 8;
    ring.points.push_back({100 * std::cos(angle), 100 * std::sin(angle), 0});
  }
  const mesh::MeshReport report = requireLawful(stacked({round, angular}, ring));
  CHECK(report.genus == 1);
  CHECK(report.volume == doctest::Approx(std::numbers::pi * 100 * (std::numbers::pi * 100 + 256)).epsilon(0.005));
}

TEST_CASE("a castle wall of four strokes that stand there twenty times is the sum of its prisms") {
  const std::vector<Curve> strokes{rectangle(16, 60),
                                   polygonCurve({{0, 0}, {16, 0}, {16, 60}, {11, 60}, {11, 48}, {0, 48}}),
                                   polygonCurve({{0, 0}, {24, 0}, {16, 48}, {0, 48}}), rectangle(16, 48)};
  std::vector<Plane> planes;
  double volume = 0;
  constexpr double kLength = 1200, kStep = 1.0 / 80;
  for (std::size_t i = 0; i < strokes.size(); ++i) {
    planes.push_back(railPlane(static_cast<double>(i) * kStep, {strokes[i]}, BlendKind::Hold));
    const std::vector<SectionPoint> outline = outlineOf(strokes[i]);
    const double area = geometry::signedArea(std::span<const SectionPoint>(outline));
    volume += area * kLength * kStep * (i < 3 ? 20 : 19);
  }
  const mesh::TriMesh wall = stacked(planes, railAhead(kLength), with({{0, 3, 20, 4 * kStep}}));
  const mesh::MeshReport report = requireLawful(wall);
  CHECK(report.volume == doctest::Approx(volume).epsilon(0.005));
  CHECK(report.genus == 0);
  CHECK(report.shells == 1);
  CHECK(!mesh::selfCrossing(wall));
}

TEST_CASE("a pattern is the same as its planes written out, to the last bit") {
  for (const std::uint64_t seed : seeds(0, 12)) {
    CAPTURE(seed);
    Rng rng(seed);
    std::vector<Plane> planes;
    std::vector<Pattern> patterns;
    double at = 0;
    for (std::uint32_t run = 0; run < 2; ++run) {
      const auto first = static_cast<std::uint32_t>(planes.size());
      const std::uint32_t length = 1 + rng.below(3), times = 1 + rng.below(4);
      const double begin = at;
      for (std::uint32_t i = 0; i < length; ++i, at += rng.uniform(0.01, 0.03)) {
        planes.push_back(railPlane(at, {blob(rng, 20)}, rng.below(2) == 0 ? BlendKind::Hold : BlendKind::Flow));
        if (rng.below(2) == 0) planes.back().curves.push_back(blob(rng, 8, {60, 0}));
      }
      patterns.push_back({first, first + length - 1, times, at - begin});
      at = begin + times * (at - begin) + 0.02;
    }
    planes.push_back(railPlane(1, {blob(rng, 20)}));
    if (rng.below(2) == 0) std::ranges::reverse(patterns);
    const mesh::TriMesh mesh = stacked(planes, railAhead(500), with(patterns));
    requireLawful(mesh);
    CHECK(mesh == stacked(byHand(planes, patterns), railAhead(500)));
  }
}

TEST_CASE("patterns that cannot stand are refused in a sentence that counts patterns and sheets from 1") {
  const std::vector<Plane> planes{railPlane(0, {circleCurve(10)}), railPlane(0.1, {circleCurve(12)}),
                                  railPlane(0.9, {circleCurve(9)})};
  const auto refused = [&](std::vector<Pattern> patterns, const std::string& words) {
    requireRefused(planes, railAhead(100), with(std::move(patterns)), words);
  };
  refused({{0, 3, 2, 0.5}}, "pattern 1 ends with sheet 4, but there are 3");
  refused({{0, 0xffffffff, 2, 0.5}}, "pattern 1 ends with sheet 4294967296, but there are 3");
  refused({{0, 0, 1, 0}, {2, 1, 2, 0.5}}, "pattern 2 goes from sheet 3 back to sheet 2");
  refused({{0, 1, 2, 0.2}, {1, 2, 1, 0}}, "pattern 2 repeats sheet 2, as pattern 1 does");
  refused({{0, 1, 3, 0.1}}, "pattern 1 stands in its own way");
  refused({{1, 1, 2, 0}}, "pattern 1 has no spacing");
  refused({{0, 1, 9, 0.2}}, "pattern 1 goes beyond the end of the rail");
  refused({{0, 1, 5, 0.2}}, "sheet 2 in repeat 5 and sheet 3 stand at one place");
  std::vector<Plane> many = planes;
  many[0].curves.clear();
  for (int i = 0; i < 16; ++i) many[0].curves.push_back(circleCurve(2, {6.0 * i, 0}));
  requireRefused(many, railAhead(100), with({{0, 0, 100, 0.001}}), "1602 curves");
  std::vector<Plane> beside = planes;
  beside[1].origin = ModelPoint{0, 0, 50};
  requireRefused(beside, railAhead(100), with({{0, 1, 2, 0.2}}),
                 "pattern 1 repeats sheet 2, which stands beside the rail");
  for (const Pattern& wrong : {Pattern{0, 0, 0, 0.1}, Pattern{0, 0, kMostTimes + 1, 0.1}, Pattern{0, 0, 2, -0.1},
                               Pattern{0, 0, 2, std::nan("")}}) {
    CHECK(!isValid(with({wrong})));
  }
  CHECK(!isValid(with(std::vector<Pattern>(kMostPatterns + 1))));
}

TEST_CASE("value noise is smooth, from −1 to 1, and the same numbers everywhere") {
  Rng rng(7);
  double low = 1, high = -1;
  for (int i = 0; i < 2000; ++i) {
    const ModelPoint at{rng.uniform(-50, 50), rng.uniform(-50, 50), rng.uniform(-50, 50)};
    const double value = geometry::valueNoise(at, 3);
    low = std::min(low, value);
    high = std::max(high, value);
    CHECK(geometry::valueNoise(at, 3) == value);
    CHECK(geometry::valueNoise(at, 4) != value);
    // The slope across a whole coordinate: the same on both sides of it, namely 0.
    const ModelPoint side{std::floor(at.x), at.y, at.z};
    constexpr double kStep = 1e-5;
    for (const double way : {-kStep, kStep}) {
      const double beside = geometry::valueNoise(side + ModelPoint{way, 0, 0}, 3);
      CHECK(std::abs(beside - geometry::valueNoise(side, 3)) < 1e-8);
    }
  }
  CHECK(low < -0.6);
  CHECK(low >= -1);
  CHECK(high > 0.6);
  CHECK(high <= 1);
  // Computed from the definition by another program.
  CHECK(geometry::valueNoise({0.25, -3.5, 7.75}, 42) == 0x1.af9ed72aaf0b8p-4);
}

TEST_CASE("without an amount noise changes nothing") {
  const std::vector<Plane> planes{railPlane(0, {circleCurve(30)}), railPlane(1, {rectangle(40, 30)})};
  CHECK(stacked(planes, railAhead(100), with(Rough{0, 5, 9, true})) == stacked(planes, railAhead(100)));
}

TEST_CASE("a rough solid is lawful, the same for the same seed, and differs by at most its amount") {
  for (const std::uint64_t seed : seeds(0, 10)) {
    CAPTURE(seed);
    Rng rng(seed);
    std::vector<Plane> planes;
    for (int i = 0; i < 4; ++i) {
      planes.push_back(railPlane(i / 3.0, {blob(rng, 40)}));
      if (seed % 3 == 0) planes.back().curves.push_back(circleCurve(12));
    }
    StackParams params = with(Rough{rng.uniform(0.5, 6), rng.uniform(15, 60), static_cast<std::uint32_t>(seed), false});
    const auto caps = static_cast<sections::CapStyle>(rng.below(4));
    CAPTURE(params.rough.amount);
    CAPTURE(params.rough.size);
    CAPTURE(static_cast<int>(caps));
    params.startCap = caps;
    StackParams even = params;
    even.rough = {};
    const mesh::TriMesh mesh = stacked(planes, railAhead(300), params);
    const mesh::MeshReport report = requireLawful(mesh), smooth = requireLawful(stacked(planes, railAhead(300), even));
    CHECK(report.genus == smooth.genus);
    CHECK(report.shells == smooth.shells);
    CHECK(std::abs(report.volume - smooth.volume) < params.rough.amount * smooth.area);
    CHECK(mesh == stacked(planes, railAhead(300), params));
    CHECK(!mesh::selfCrossing(mesh));
    params.rough.seed += 1;
    CHECK(mesh != stacked(planes, railAhead(300), params));
  }
}

TEST_CASE("drawn curves stay where they are when asked to") {
  const std::vector<Plane> planes{railPlane(0, {circleCurve(30)}), railPlane(0.5, {rectangle(40, 30)}),
                                  railPlane(1, {circleCurve(20)})};
  const auto drawnOf = [](const mesh::TriMesh& mesh) {
    std::set<std::array<float, 3>> points;
    for (const auto& p : mesh.positions) {
      if (p[2] == 0 || p[2] == -100 || p[2] == -200) points.insert(p);
    }
    return points;
  };
  const auto smooth = drawnOf(stacked(planes, railAhead(200)));
  Rough rough{5, 20, 1, true};
  const mesh::TriMesh kept = stacked(planes, railAhead(200), with(rough));
  requireLawful(kept);
  CHECK(drawnOf(kept) == smooth);
  rough.keepDrawn = false;
  CHECK(drawnOf(stacked(planes, railAhead(200), with(rough))) != smooth);
}

TEST_CASE("what roughness would make cross itself is moved less far") {
  // A wall much thinner than its bumps are high, and a stack that ends in a point.
  const std::vector<Plane> wall{railPlane(0, {ribbon({{-50, 0}, {0, 10}, {50, 0}}, 3)}),
                                railPlane(1, {ribbon({{-50, 0}, {0, -10}, {50, 0}}, 3)})};
  const mesh::TriMesh thin = stacked(wall, railAhead(100), with(Rough{20, 15, 5, false}));
  CHECK(requireLawful(thin).volume > 0);
  const std::vector<Plane> spike{railPlane(0, {circleCurve(40)}), railPlane(1, {circleCurve(0.5)})};
  requireLawful(stacked(spike, railAhead(100), with(Rough{30, 10, 5, false})));
  for (const Rough& wrong : {Rough{-1, 10, 0, false}, Rough{1, 0, 0, false}, Rough{std::nan(""), 10, 0, false},
                             Rough{1, std::nan(""), 0, false}}) {
    CHECK(!isValid(with(wrong)));
  }
}
