#include "engine/loft/section_track.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "engine/loft/loft.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::loft;
using namespace spineloft::sections;
using namespace spineloft::testing;

namespace {

using Curve = std::vector<SectionPoint>;

SectionShape drawn(std::vector<Curve> curves) {
  SectionShape shape;
  shape.contours = std::move(curves);
  return shape;
}

/// Every section on the way is sound and touches both rib ends.
void requireSoundWay(const SectionShape& a, const SectionShape& b, BlendKind kind) {
  const std::vector<SectionKey> keys = {{0, a, {kind, {}}}, {1, b, {kind, {}}}};
  REQUIRE(checkSectionKeys(keys).ok());
  const auto track = SectionTrack::along(keys, 48, false);
  REQUIRE(track.ok());
  for (int i = 0; i <= 30; ++i) {
    CAPTURE(i);
    Curve points;
    track.value().appendShape(i / 30.0, points);
    points.pop_back();
    REQUIRE(points.size() == track.value().count());
    CHECK(geometry::areSimple(points, track.value().sizes()));
    const auto [low, high] = std::ranges::minmax_element(points, {}, &SectionPoint::x);
    CHECK(low->x == -1);
    CHECK(high->x == 1);
  }
}

/// A polygon that its middle does not see whole: a thick, wobbling, bent bar.
Curve bentBar(Rng& rng) {
  Curve outer, inner;
  const double turn = rng.uniform(2, 4.5), start = rng.uniform(0, 6);
  for (int i = 0; i <= 24; ++i) {
    const double angle = start + turn * i / 24, thick = rng.uniform(0.1, 0.25);
    outer.push_back({(0.7 + thick) * std::cos(angle), (0.7 + thick) * std::sin(angle)});
    inner.push_back({(0.7 - thick) * std::cos(angle), (0.7 - thick) * std::sin(angle)});
  }
  outer.insert(outer.end(), inner.rbegin(), inner.rend());
  return outer;
}

Curve radial(Rng& rng, int corners) {
  Curve curve;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners, radius = rng.uniform(0.4, 1);
    curve.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return curve;
}

}  // namespace

TEST_CASE("between any two presets every section is simple and touches both rib ends") {
  for (const SectionName& a : sectionNames()) {
    for (const SectionName& b : sectionNames()) {
      CAPTURE(std::string(a.key));
      CAPTURE(std::string(b.key));
      requireSoundWay(a.preset, b.preset, BlendKind::Linear);
    }
  }
}

TEST_CASE("drawn sections too, whatever their points and their direction, and beyond their keys") {
  Rng rng(4);
  for (int round = 0; round < 60; ++round) {
    CAPTURE(round);
    Curve a = round % 2 ? bentBar(rng) : radial(rng, 3 + static_cast<int>(rng.below(60)));
    Curve b = round % 3 ? bentBar(rng) : radial(rng, 3 + static_cast<int>(rng.below(60)));
    if (round % 5 == 0) std::ranges::reverse(b);
    requireSoundWay(drawn({a}), drawn({b}), static_cast<BlendKind>(round % 5));
    requireSoundWay(SectionPreset::Star, drawn({b}), BlendKind::Overshoot);
  }
}

TEST_CASE("5000 points become 4, and the direction of drawing does not matter") {
  Curve circle;
  for (int i = 0; i < 5000; ++i) {
    const double angle = 2 * std::numbers::pi * i / 5000;
    circle.push_back({std::cos(angle), std::sin(angle)});
  }
  const Curve square = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};
  requireSoundWay(drawn({circle}), drawn({square}), BlendKind::Ease);
  Curve back = circle;
  std::ranges::reverse(back);
  const auto area = [&](const Curve& c) {
    const std::vector<SectionKey> keys = {{0, drawn({c}), {}}, {1, drawn({square}), {}}};
    Curve points;
    SectionTrack::along(keys, 48, false).value().appendShape(0.5, points);
    points.pop_back();
    return geometry::signedArea(std::span<const SectionPoint>(points));
  };
  CHECK(area(circle) > 3.1);
  CHECK(area(back) == doctest::Approx(area(circle)).epsilon(2e-3));
}

TEST_CASE("a section with a hole makes a tube, one of two pieces two shells") {
  const auto set = straightRibs({100, 400}, {500, 400}, 11, [](double) { return 80.0; });
  LoftParams params;
  const Curve outer = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}, hole = {{-.5, -.5}, {.5, -.5}, {.5, .5}, {-.5, .5}};
  params.sections = {{0.5, drawn({outer, hole}), {}}};
  const auto tube = loftRibs(set, {1000, 800}, params);
  REQUIRE(tube.ok());
  const auto report = requireLawful(tube.value());
  CHECK(report.genus == 1);
  CHECK(report.shells == 1);
  CHECK(report.volume == doctest::Approx(400 * 40 * 40 * 3.0).epsilon(1e-5));
  params.sections = {
      {0.5, drawn({{{-1, -.4}, {-.2, -.4}, {-.2, .4}, {-1, .4}}, {{.2, -.4}, {1, -.4}, {1, .4}, {.2, .4}}}), {}}};
  const auto strands = loftRibs(set, {1000, 800}, params);
  REQUIRE(strands.ok());
  CHECK(requireLawful(strands.value()).shells == 2);
}

TEST_CASE("sections that cannot be are refused with the reason") {
  const Curve square = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  const auto refused = [](std::vector<Curve> curves) {
    return checkShape(drawn(std::move(curves))).error() == Error::SectionInvalid;
  };
  CHECK(checkShape(drawn({square})).ok());
  CHECK(checkShape(drawn({{{-1, -1}, {-1, 1}, {1, 1}, {1, -1}, {-1, -1}}})).ok());
  CHECK(refused({{{-1, -1}, {1, 1}, {1, -1}, {-1, 1}}}));
  CHECK(refused({{{-1, 0}, {1, 0}}}));
  CHECK(refused({square, {{0, 0}, {2, 0}, {2, 0.5}}}));
  const auto scaled = [](Curve c, double by) {
    for (SectionPoint& p : c) p = p * by;
    return c;
  };
  CHECK(checkShape(drawn({square, scaled(square, 0.5)})).ok());
  CHECK(checkShape(drawn({square, scaled(square, 0.5), scaled(square, 0.2)})).ok());
  const std::vector<SectionKey> keys = {{0, drawn({square, scaled(square, 0.5)}), {}}, {1, SectionPreset::Circle, {}}};
  CHECK(checkSectionKeys(keys).error() == Error::SectionInvalid);
}

TEST_CASE("flowing sections go through every key without a kink, also where the way closes") {
  const auto rhombus = [](double height) { return drawn({{{1, 0}, {0, height}, {-1, 0}, {0, -height}}}); };
  const auto heightAt = [](const SectionTrack& track, double share) {
    Curve points;
    track.appendShape(share, points);
    return std::ranges::max_element(points, {}, &SectionPoint::y)->y;
  };
  const Blend flow{BlendKind::Flow, {}};
  // The slopes of parabolas through neighbours give a parabola back.
  const auto parabola = [](double t) { return 0.4 + 0.9 * t - 0.5 * t * t; };
  std::vector<SectionKey> keys;
  for (const double at : {0.0, 0.3, 0.6, 1.0}) keys.push_back({at, rhombus(parabola(at)), flow});
  const auto open = SectionTrack::along(keys, 48, false);
  REQUIRE(open.ok());
  for (int i = 0; i <= 100; ++i) {
    CHECK(heightAt(open.value(), i / 100.0) == doctest::Approx(parabola(i / 100.0)).epsilon(1e-6));
  }
  const std::vector<SectionKey> round = {
      {0.1, rhombus(0.5), flow}, {0.4, rhombus(0.9), flow}, {0.7, rhombus(0.6), flow}};
  const auto closed = SectionTrack::along(round, 48, true);
  REQUIRE(closed.ok());
  constexpr double kStep = 1e-4;
  for (const SectionKey& key : round) {
    const double before = heightAt(closed.value(), key.at - kStep), here = heightAt(closed.value(), key.at);
    CHECK((here - before) / kStep ==
          doctest::Approx((heightAt(closed.value(), key.at + kStep) - here) / kStep).epsilon(0.02));
  }
  CHECK(heightAt(closed.value(), 0) == doctest::Approx(heightAt(closed.value(), 1)));
  for (const double at : {0.0, 0.3, 0.6, 1.0}) {
    const auto straight = std::vector<SectionKey>{{0, rhombus(0.4), {BlendKind::Linear, {}}}, {1, rhombus(0.8), flow}};
    CHECK(heightAt(SectionTrack::along(straight, 48, false).value(), at) == doctest::Approx(0.4 + 0.4 * at));
  }
}

TEST_CASE("flowing sections on the way are sound between any two slices") {
  for (const SectionName& a : sectionNames()) {
    for (const SectionName& b : sectionNames()) requireSoundWay(a.preset, b.preset, BlendKind::Flow);
  }
}
