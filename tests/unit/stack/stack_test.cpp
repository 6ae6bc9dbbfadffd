#include "engine/stack/stack.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/self_crossing.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/plane_cut.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::stack;
using namespace spineloft::testing;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kPaper{400, 400};
constexpr sections::Blend kStraight{sections::BlendKind::Linear, {}};

Curve circle(double radius, SectionPoint centre = {}, double start = 0, double way = 1) {
  Curve curve;
  for (int i = 0; i < 8; ++i) {
    const double angle = start + way * 2 * kPi * i / 8;
    curve.through.push_back(centre + SectionPoint{radius * std::cos(angle), radius * std::sin(angle)});
  }
  return curve;
}

Curve square(double half, double turned = 0) {
  Curve curve;
  curve.corners.all = true;
  for (int i = 0; i < 4; ++i) {
    const double angle = turned + kPi / 4 + kPi / 2 * i, reach = half * std::sqrt(2);
    curve.through.push_back({reach * std::cos(angle), reach * std::sin(angle)});
  }
  return curve;
}

Plane onRail(double at, std::vector<Curve> curves, sections::Blend blend = kStraight) {
  Plane plane;
  plane.at = at;
  plane.curves = std::move(curves);
  plane.blend = std::move(blend);
  return plane;
}
Plane inSpace(ModelPoint origin, std::vector<Curve> curves, sections::Blend blend = kStraight) {
  Plane plane = onRail(0, std::move(curves), std::move(blend));
  plane.origin = origin;
  return plane;
}

/// Up the y axis by `height`.
Rail up(double height) { return {{{200, -300, 0}, {200, -300 + height, 0}}, false}; }

Rail ring(double radius) {
  Rail rail{{}, true};
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * kPi * i / 12;
    rail.points.push_back({200 + radius * std::cos(angle), -200 + radius * std::sin(angle), 0});
  }
  return rail;
}

mesh::TriMesh made(const std::vector<Plane>& planes, const Rail& rail = {}, const StackParams& params = {}) {
  const Result<Stacked> stacked = stackPlanes({planes, rail, params}, kPaper);
  REQUIRE_MESSAGE(stacked.ok(), failureSentence(stacked.ok() ? Failure{} : stacked.failure()));
  return stacked.value().mesh;
}

std::string refused(const std::vector<Plane>& planes, const Rail& rail = {}) {
  const Result<Stacked> stacked = stackPlanes({planes, rail, {}}, kPaper);
  REQUIRE(!stacked.ok());
  return failureSentence(stacked.failure());
}

/// The farthest that a vertex of one mesh is from the nearest of the other.
double apart(const mesh::TriMesh& a, const mesh::TriMesh& b) {
  double most = 0;
  for (const auto& p : a.positions) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& q : b.positions) {
      least = std::min<double>(least, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
    }
    most = std::max(most, least);
  }
  return most;
}

bool drawnHolds(const std::vector<std::vector<SectionPoint>>& outlines, SectionPoint p) {
  bool inside = false;
  for (const auto& outline : outlines) inside ^= geometry::holds(std::span<const SectionPoint>(outline), p);
  return inside;
}

/// A smooth blob, star-shaped about its centre.
Curve blob(Rng& rng, double size) {
  Curve curve;
  const int points = 6 + static_cast<int>(rng.below(7));
  const double phase = rng.uniform(0, 6), way = rng.below(2) == 0 ? 1 : -1;
  for (int i = 0; i < points; ++i) {
    const double angle = phase + way * 2 * kPi * i / points, radius = size * rng.uniform(0.75, 1.25);
    curve.through.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  if (rng.below(3) == 0) curve.corners.at = {0, 2};
  return curve;
}

}  // namespace

TEST_CASE("two circles make a cone, however they are drawn and wherever the second one stands") {
  const double cone = kPi * 100 / 3 * (40 * 40 + 40 * 20 + 20 * 20);
  const mesh::TriMesh straight = made({onRail(0, {circle(40)}), onRail(1, {circle(20)})}, up(100));
  const mesh::MeshReport report = requireLawful(straight);
  CHECK(report.volume == doctest::Approx(cone).epsilon(0.002));
  CHECK(report.genus == 0);
  CHECK(report.shells == 1);
  const auto same = [&](const std::vector<Plane>& planes) {
    const mesh::TriMesh other = made(planes, up(100));
    requireLawful(other);
    CHECK(apart(straight, other) < 1e-6 * 130);
    CHECK(apart(other, straight) < 1e-6 * 130);
  };
  SUBCASE("off the axis") {
    const auto aside = made({onRail(0, {circle(40)}), onRail(1, {circle(20, {70, 25})})}, up(100));
    CHECK(requireLawful(aside).volume == doctest::Approx(cone).epsilon(0.002));
  }
  SUBCASE("the other way round") { same({onRail(0, {circle(40, {}, 0, -1)}), onRail(1, {circle(20)})}); }
  SUBCASE("begun elsewhere") { same({onRail(0, {circle(40)}), onRail(1, {circle(20, {}, kPi / 4 * 3)})}); }
  SUBCASE("on a plane seen from behind") {
    Plane turned = onRail(1, {circle(20)});
    turned.turn = geometry::turnAbout(ModelPoint{1, 0, 0}, kPi);
    same({onRail(0, {circle(40)}), turned});
  }
  SUBCASE("without a rail") {
    const auto planes = std::vector{inSpace({200, -300, 0}, {circle(40)}), inSpace({200, -300, 100}, {circle(20)})};
    CHECK(requireLawful(made(planes)).volume == doctest::Approx(report.volume).epsilon(1e-6));
  }
}

TEST_CASE("where sections flow nine circles make a vase, and nothing is left of the places where they stand") {
  const auto radius = [](double z) { return 30 * (1 + 0.3 * std::sin(2 * kPi * z) + 0.1 * z); };
  double volume = 0;
  constexpr int kSlices = 20000;
  for (int i = 0; i < kSlices; ++i) volume += kPi * std::pow(radius((i + 0.5) / kSlices), 2) * 200 / kSlices;
  const auto vase = [&](sections::BlendKind kind) {
    std::vector<Plane> planes;
    for (int i = 0; i <= 8; ++i) planes.push_back(onRail(i / 8.0, {circle(radius(i / 8.0))}, {kind, {}}));
    return made(planes, up(200));
  };
  const mesh::TriMesh flowing = vase(sections::BlendKind::Flow);
  CHECK(requireLawful(flowing).volume == doctest::Approx(volume).epsilon(0.001));
  const double off = std::abs(requireLawful(vase(sections::BlendKind::Linear)).volume - volume);
  CHECK(off > 0.002 * volume);
  // How the outline's slope jumps at a sheet, from cuts close by.
  const auto radiusAt = [&](const mesh::TriMesh& mesh, double z) {
    return std::sqrt(cutBy(mesh, {{200, -300 + 200 * z, 0}, {1, 0, 0}, {0, 0, -1}}).area() / kPi);
  };
  const auto jump = [&](const mesh::TriMesh& mesh) {
    double most = 0;
    for (int i = 1; i < 8; ++i) {
      const double z = i / 8.0, h = 0.008;
      const double before = (radiusAt(mesh, z - 1e-5) - radiusAt(mesh, z - h)) / (200 * h);
      const double after = (radiusAt(mesh, z + h) - radiusAt(mesh, z + 1e-5)) / (200 * h);
      most = std::max(most, std::abs(after - before));
    }
    return most;
  };
  CHECK(jump(flowing) < 0.1);
  CHECK(jump(vase(sections::BlendKind::Linear)) > 0.15);
}

TEST_CASE("a turned square turns without getting thinner, and a square over a circle does not turn") {
  const double halfway = -300 + 50 + 1e-3;
  const CutPlane middle{{200, halfway, 0}, {1, 0, 0}, {0, 0, -1}};
  for (const sections::BlendKind kind : {sections::BlendKind::Linear, sections::BlendKind::Flow}) {
    const auto turned = made({onRail(0, {square(30)}, {kind, {}}), onRail(1, {square(30, kPi / 6)})}, up(100));
    requireLawful(turned);
    CHECK(cutBy(turned, middle).area() >= 0.995 * 3600);
    CHECK(cutBy(turned, middle).area() <= 1.0001 * 3600);
  }
  const auto round = made({onRail(0, {square(30)}), onRail(1, {circle(30)})}, up(100));
  requireLawful(round);
  // Mirrored in x it is the same.
  const PlaneCut cut = cutBy(round, middle);
  CHECK(overlapShare(cut, [&](SectionPoint p) { return cut.holds({-p.x, p.y}); }, {-50, -50}, {50, 50}) > 0.995);
}

TEST_CASE("a closed rail makes a ring, from one curve or from several") {
  const auto torus = made({onRail(0, {circle(20)})}, ring(100));
  const mesh::MeshReport report = requireLawful(torus);
  CHECK(report.volume == doctest::Approx(2 * kPi * kPi * 100 * 400).epsilon(0.003));
  CHECK(report.genus == 1);
  CHECK(report.shells == 1);
  for (const sections::BlendKind kind : {sections::BlendKind::Linear, sections::BlendKind::Flow}) {
    const sections::Blend blend{kind, {}};
    const auto four = made({onRail(0, {circle(20)}, blend), onRail(0.25, {square(22, 0.3)}, blend),
                            onRail(0.5, {circle(12, {6, 3})}, blend), onRail(0.75, {square(15, -0.5)}, blend)},
                           ring(100));
    const mesh::MeshReport mixed = requireLawful(four);
    CHECK(mixed.genus == 1);
    CHECK(mixed.shells == 1);
    CHECK(!mesh::selfCrossing(four));
  }
}

TEST_CASE("a single curve on an open rail goes along it from end to end") {
  CHECK(requireLawful(made({onRail(0.3, {square(10)})}, up(100))).volume == doctest::Approx(40000).epsilon(1e-4));
}

TEST_CASE("what was drawn is there: every sheet cuts the solid in its curves") {
  for (const std::uint64_t seed : seeds(0, 10)) {
    CAPTURE(seed);
    Rng rng(seed);
    std::vector<Plane> planes;
    const int count = 2 + static_cast<int>(rng.below(5));
    const bool free = rng.below(2) == 0;
    for (int i = 0; i < count; ++i) {
      const auto kind = static_cast<sections::BlendKind>(rng.below(2) == 0 ? 0 : 6);
      Curve curve = blob(rng, rng.uniform(20, 50));
      const SectionPoint aside{rng.uniform(-15, 15), rng.uniform(-15, 15)};
      for (SectionPoint& p : curve.through) p = p + aside;
      Plane plane = onRail(static_cast<double>(i) / (count - 1), {curve}, {kind, {}});
      if (free) plane.origin = ModelPoint{100 + rng.uniform(-20, 20), -100 + rng.uniform(-20, 20), 140.0 * i};
      plane.turn = geometry::turnAbout(normalized(ModelPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), 0.1}),
                                       rng.uniform(-0.4, 0.4));
      planes.push_back(plane);
    }
    const Rail rail{{{0, 0, 0}, {30, 180.0 * count / 2, 40}, {0, 180.0 * count, 0}}, false};
    const mesh::TriMesh mesh = made(planes, free ? Rail{} : rail);
    const mesh::MeshReport report = requireLawful(mesh);
    CHECK(report.genus == 0);
    CHECK(report.shells == 1);
    if (!free) continue;
    for (int i = 0; i < count; ++i) {
      CAPTURE(i);
      const Plane& plane = planes[static_cast<std::size_t>(i)];
      const ModelPoint x = geometry::turned(plane.turn, ModelPoint{1, 0, 0});
      const ModelPoint y = geometry::turned(plane.turn, ModelPoint{0, 1, 0});
      const ModelPoint inwards = cross(x, y) * (i + 1 < count ? 0.01 : -0.01);
      const PlaneCut cut = cutBy(mesh, {*plane.origin + inwards, x, y});
      sections::DrawnCurve drawn;
      for (std::size_t k = 0; k < plane.curves[0].through.size(); ++k) {
        const auto& at = plane.curves[0].corners.at;
        const bool corner = std::ranges::find(at, static_cast<std::uint32_t>(k)) != at.end();
        drawn.points.push_back({plane.curves[0].through[k], corner});
      }
      const auto outline = sections::outlineOf(drawn);
      CHECK(overlapShare(cut, [&](SectionPoint p) { return drawnHolds({outline}, p); }, {-100, -100}, {100, 100}) >=
            0.995);
    }
  }
}

TEST_CASE("what is drawn within a ring does not belong to the ring, however many rings there are") {
  // Rings within rings, each 11 thick and 11 apart, that lean and shrink.
  const auto rings = [](int count, double share, double aside) {
    std::vector<Curve> curves;
    for (int i = 0; i < 2 * count; ++i) curves.push_back(circle((20 + 11 * i) * share, {aside, 0}));
    return curves;
  };
  for (const int count : {1, 2, 8}) {
    CAPTURE(count);
    const std::vector<Plane> planes{onRail(0, rings(count, 1, 0)), onRail(0.5, rings(count, 1, 3)),
                                    onRail(1, rings(count, 0.95, 6))};
    const mesh::TriMesh mesh = made(planes, up(200));
    const mesh::MeshReport report = requireLawful(mesh);
    CHECK(report.shells == count);
    CHECK(report.genus == count);
    CHECK_FALSE(mesh::selfCrossing(mesh));
  }
  // A wall thinner than the step: no ring overlaps with the next one, but there is no other.
  const mesh::TriMesh cone = made(
      {onRail(0, {circle(50), circle(47)}), onRail(0.5, {circle(40), circle(37)}), onRail(1, {circle(30), circle(27)})},
      up(200));
  const mesh::MeshReport report = requireLawful(cone);
  CHECK(report.shells == 1);
  CHECK(report.genus == 1);
}

TEST_CASE("random rings within rings, more or fewer from plane to plane, are lawful and do not cross") {
  for (const std::uint64_t seed : seeds(0, 40)) {
    CAPTURE(seed);
    Rng rng(seed);
    const int planes = 2 + static_cast<int>(rng.below(4)), usual = 1 + static_cast<int>(rng.below(4));
    std::vector<Plane> all;
    SectionPoint centre;
    for (int k = 0; k < planes; ++k) {
      const int rings = std::max(1, usual - 1 + static_cast<int>(rng.below(3)));
      const double step = 40 * rng.uniform(0.8, 1.2);
      std::vector<Curve> curves;
      for (int i = rings; i > 0; --i) {
        curves.push_back(circle(step * i, centre));
        const bool isDisc = i == 1 && rng.uniform() < 0.5;
        if (!isDisc)
          curves.push_back(circle(step * (i - rng.uniform(0.2, 0.8)), centre + SectionPoint{rng.uniform(-1, 1), 0}));
      }
      all.push_back(onRail(static_cast<double>(k) / (planes - 1), std::move(curves)));
      centre = centre + SectionPoint{rng.uniform(-8, 8), rng.uniform(-8, 8)};
    }
    const mesh::TriMesh mesh = made(all, up(120.0 * (planes - 1)));
    requireLawful(mesh);
    CHECK_FALSE(mesh::selfCrossing(mesh));
  }
}

TEST_CASE("holes go with the curve that they are in; one without a partner is a pocket") {
  const auto pipe =
      made({onRail(0, {circle(40), circle(20)}), onRail(1, {circle(30, {10, 0}), circle(10, {12, 2})})}, up(100));
  const mesh::MeshReport through = requireLawful(pipe);
  CHECK(through.genus == 1);
  CHECK(through.shells == 1);
  const double outer = kPi * 100 / 3 * (1600 + 1200 + 900), inner = kPi * 100 / 3 * (400 + 200 + 100);
  CHECK(through.volume == doctest::Approx(outer - inner).epsilon(0.002));
  const auto pot = made(
      {onRail(0, {circle(40)}), onRail(0.5, {circle(40), circle(20)}), onRail(1, {circle(40), circle(20)})}, up(100));
  const mesh::MeshReport pocket = requireLawful(pot);
  CHECK(pocket.genus == 0);
  CHECK(pocket.volume == doctest::Approx(kPi * (1600 * 100 - 400 * 50)).epsilon(0.002));
  const auto cave = made({onRail(0, {circle(40)}), onRail(0.3, {circle(40), circle(20)}),
                          onRail(0.6, {circle(40), circle(20)}), onRail(1, {circle(40)})},
                         up(100));
  CHECK(requireLawful(cave).shells == 2);
}

TEST_CASE("curves side by side stay apart, and one without a partner ends at its sheet") {
  const auto two = made(
      {onRail(0, {circle(20, {-40, 0}), circle(25, {40, 0})}), onRail(1, {circle(25, {45, 0}), circle(20, {-45, 0})})},
      up(100));
  CHECK(requireLawful(two).shells == 2);
  CHECK(!mesh::selfCrossing(two));
  const auto step = made({onRail(0, {circle(20, {-240, 0}), circle(25, {40, 0})}),
                          onRail(0.5, {circle(25, {40, 0}), circle(20, {-240, 0})}), onRail(1, {circle(25, {40, 0})})},
                         up(100));
  CHECK(requireLawful(step).volume == doctest::Approx(kPi * (400 * 50 + 625 * 100)).epsilon(0.002));
}

TEST_CASE("ends are finished as those of lofts") {
  const auto with = [](sections::CapStyle start, sections::CapStyle end) {
    StackParams params;
    params.startCap = start;
    params.endCap = end;
    const auto mesh =
        made({onRail(0, {circle(20)}), onRail(0.5, {circle(20)}), onRail(1, {circle(20)})}, up(100), params);
    CHECK(!mesh::selfCrossing(mesh));
    return requireLawful(mesh);
  };
  using enum sections::CapStyle;
  const double bar = kPi * 400 * 100;
  CHECK(with(Flat, Flat).volume == doctest::Approx(bar).epsilon(0.002));
  CHECK(with(Pointed, Flat).volume == doctest::Approx(bar + kPi * 400 * 40 / 3).epsilon(0.002));
  CHECK(with(Flat, Pointed).volume == doctest::Approx(bar + kPi * 400 * 40 / 3).epsilon(0.002));
  CHECK(with(Round, Round).volume == doctest::Approx(bar + 4.0 / 3 * kPi * 400 * 12).epsilon(0.01));
  CHECK(with(Open, Flat).volume == doctest::Approx(bar - kPi * 256 * 90).epsilon(0.002));
  CHECK(with(Flat, Open).genus == 0);
  CHECK(with(Open, Open).genus == 1);
  CHECK(with(Open, Open).volume == doctest::Approx(bar - kPi * 256 * 100).epsilon(0.002));
}

TEST_CASE("what makes no solid is refused in a sentence that names it") {
  const auto says = [](const std::string& sentence, const std::string& part) {
    CHECK_MESSAGE(sentence.find(part) != std::string::npos, sentence);
  };
  says(refused({}), "no curve");
  says(refused({inSpace({}, {circle(10)})}), "one sheet alone");
  says(refused({onRail(0, {circle(10)}), onRail(1, {circle(10)})}), "sheet 1 has no origin");
  Curve eight{{{-20, -20}, {20, 20}, {20, -20}, {-20, 20}}, {true, {}}};
  says(refused({onRail(0, {circle(10)}), onRail(1, {circle(10, {60, 0}), eight})}, up(100)),
       "curve 2 on sheet 2 crosses");
  says(refused({onRail(0, {circle(10), circle(10, {15, 0})}), onRail(1, {circle(10)})}, up(100)),
       "curves on sheet 1 cross");
  Curve flat{{{0, 0}, {10, 0}, {20, 0}}, {true, {}}};
  says(refused({onRail(0, {flat}), onRail(1, {circle(10)})}, up(100)), "encloses nothing");
  Curve dot{{{5, 5}, {5, 5}, {5, 5}}, {}};
  says(refused({onRail(0, {dot}), onRail(1, {circle(10)})}, up(100)), "has no size");
  says(refused({onRail(0.5, {circle(10)}), onRail(0.5, {circle(10)})}, up(100)), "sheet 1 and sheet 2");
  Plane leaning = inSpace({0, 0, 10}, {circle(40)});
  leaning.turn = geometry::turnAbout(ModelPoint{1, 0, 0}, 0.6);
  says(refused({inSpace({0, 0, 0}, {circle(40)}), leaning}), "sheet 1 and sheet 2");
  says(refused({onRail(0, {circle(10)}), onRail(1, {circle(10)})}, Rail{{{0, 0, 0}, {0, 0, 0}}, false}), "no length");
  says(refused({onRail(0, {circle(10)})}, Rail{{{0, 0, 0}, {9, 0, 0}}, true}), "three different points");
  Plane wild = onRail(0, {circle(10)});
  wild.curves[0].through[3].x = std::numeric_limits<double>::quiet_NaN();
  CHECK(stackPlanes({{wild}, up(100), {}}, kPaper).error() == Error::ValueOutOfRange);
}
