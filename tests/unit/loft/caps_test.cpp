// Round caps keep to what their fans say and to the way the sides run: no knob on a broad end.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/loft/loft.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::loft;
using namespace spineloft::sections;
using namespace spineloft::testing;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kPicture{1000, 800};

mesh::TriMesh capped(const ribs::RibSet& set, CapStyle end) {
  LoftParams params;
  params.startCap = CapStyle::Flat;
  params.endCap = end;
  params.sectionPoints = 96;
  const auto mesh = loftRibs(set, kPicture, params);
  REQUIRE(mesh.ok());
  requireLawful(mesh.value());
  return mesh.value();
}

/// A half circle of `radius` about the end of the spine at (500, 400), from the left to the right.
ribs::EndFan halfCircle(double radius, double ahead) {
  ribs::EndFan fan;
  for (int i = 1; i <= 11; ++i) {
    const double angle = kPi * i / 12;
    fan.points.push_back({500 + ahead + radius * std::sin(angle), 400 - radius * std::cos(angle)});
  }
  return fan;
}

/// Straight to (440, 400), then closing by `slope` a side and pixel up to (500, 400).
ribs::RibSet closing(double slope) {
  return straightRibs({100, 400}, {500, 400}, 81,
                      [=](double t) { return 200 - 2 * slope * std::max(0.0, 400 * t - 340); });
}

}  // namespace

TEST_CASE("an end whose fan lies behind its last rib is cut off there, not domed") {
  ribs::RibSet set = straightRibs({100, 400}, {500, 400}, 41, [](double) { return 80.0; });
  set.endFan = halfCircle(40, -60);
  CHECK(capped(set, CapStyle::Round) == capped(set, CapStyle::Flat));
  set.endFan = {};
  CHECK(mesh::boundsOf(capped(set, CapStyle::Round)).high[0] == doctest::Approx(500 + kDomeHeight * 40));
}

TEST_CASE("a fan broader than an end that closes makes no knob: the cap stays between the sides") {
  for (const double slope : {0.7, 1.0, 1.4}) {
    const double half = 100 - slope * 60;
    ribs::RibSet set = closing(slope);
    set.endFan = halfCircle(half, 0);
    const auto mesh = capped(set, CapStyle::Round);
    const double beyond = mesh::boundsOf(mesh).high[0] - 500;
    CHECK(beyond > 0.3 * std::min(half, half / slope));
    for (const auto& v : mesh.positions) {
      if (v[0] <= 500) continue;
      const double side = half - slope * (v[0] - 500);
      CHECK(std::abs(v[1] + 400) <= side + 0.02 * half);
    }
  }
}

TEST_CASE("a fan far broader than an end that closes leaves it round, on the arc that meets both sides smoothly") {
  for (const double slope : {0.7, 1.0, 1.4}) {
    const double half = 100 - slope * 60, radius = half * std::hypot(1, slope);
    const PicturePoint centre{500 - half * slope, 400};
    ribs::RibSet set = closing(slope);
    set.endFan = halfCircle(2 * half, 0);
    const auto mesh = capped(set, CapStyle::Round);
    CHECK(mesh::boundsOf(mesh).high[0] == doctest::Approx(centre.x + radius).epsilon(0.002));
    // Of what is seen from the front the outermost is on the arc.
    double widest = 0;
    for (const auto& v : mesh.positions) {
      if (v[0] <= 501) continue;
      const double away = std::hypot(v[0] - centre.x, v[1] + 400);
      CHECK(away < 1.01 * radius);
      const double share = (v[0] - 500) / (centre.x + radius - 500);
      if (share > 0.8 && share < 0.9) widest = std::max(widest, std::abs(v[1] + 400) / half);
    }
    CHECK(widest > 0.3);
  }
}

TEST_CASE("a pointed end that the picture shows stays pointed") {
  for (const double slope : {0.7, 1.0, 1.4}) {
    const double half = 100 - slope * 60, length = half / slope;
    ribs::RibSet set = closing(slope);
    for (int i = 1; i <= 11; ++i) {
      const double t = 1 - std::abs(i - 6) / 6.0;
      set.endFan.points.push_back({500 + length * t, 400 + (i < 6 ? -1 : 1) * half * (1 - t)});
    }
    CHECK(mesh::boundsOf(capped(set, CapStyle::Round)).high[0] == doctest::Approx(500 + length).epsilon(0.01));
  }
}

TEST_CASE("parallel and opening sides leave the fan as it is") {
  for (const double slope : {0.0, 0.05, -0.4}) {
    ribs::RibSet set = closing(slope);
    set.endFan = halfCircle(100 - slope * 60, 0);
    const auto mesh = capped(set, CapStyle::Round);
    for (const PicturePoint p : set.endFan.points) {
      double nearest = 1e9;
      for (const auto& v : mesh.positions) nearest = std::min(nearest, std::hypot(v[0] - p.x, -v[1] - p.y));
      CHECK(nearest < 2e-3);
    }
  }
}

namespace {

/// Sides 200 apart up to x = 500 and half a circle beyond; the spine ends at (500, 400), but the ribs go
/// on round the end by `angle` on both sides, as the curves of a wide part do. `lean` holds one side back.
ribs::RibSet roundTheEnd(double angle, double lean = 0) {
  ribs::RibSet set;
  for (int i = 0; i <= 80; ++i) {
    const double t = i / 80.0;
    ribs::Rib rib;
    rib.center = {100 + 400 * t, 400};
    const auto outline = [&](double side, double far) {
      const double s = t * (400 + 100 * far);
      if (s <= 400) return PicturePoint{100 + s, 400 + side * 100};
      const double a = (s - 400) / 100;
      return PicturePoint{500 + 100 * std::sin(a), 400 + side * 100 * std::cos(a)};
    };
    rib.left = outline(-1, angle);
    rib.right = outline(1, angle * (1 - lean));
    set.ribs.push_back(rib);
  }
  return set;
}

/// Width across the spine of the part within `reach` of x = `at`.
double widthAt(const mesh::TriMesh& mesh, double at, double reach) {
  double low = 1e9, high = -1e9;
  for (const auto& v : mesh.positions) {
    if (std::abs(v[0] - at) > reach) continue;
    low = std::min<double>(low, v[1]);
    high = std::max<double>(high, v[1]);
  }
  return high - low;
}

}  // namespace

TEST_CASE("a flat or open end is cut square where the spine ends, although ribs bend round the end") {
  for (const double lean : {0.0, 0.5}) {
    const ribs::RibSet set = roundTheEnd(1.2, lean);
    for (const CapStyle style : {CapStyle::Flat, CapStyle::Open}) {
      const auto mesh = capped(set, style);
      CHECK(mesh::boundsOf(mesh).high[0] == doctest::Approx(500).epsilon(0.002));
      CHECK(widthAt(mesh, 500, 1) == doctest::Approx(200).epsilon(0.01));
    }
    CHECK(mesh::boundsOf(capped(set, CapStyle::Round)).high[0] > 580);
  }
}

TEST_CASE("ribs that reach only a little beyond the end of the spine are not cut") {
  const auto mesh = capped(roundTheEnd(0.2), CapStyle::Flat);
  CHECK(mesh::boundsOf(mesh).high[0] == doctest::Approx(500 + 100 * std::sin(0.2)).epsilon(0.001));
}

TEST_CASE("a cut end travels with the part: the start is cut as the end is") {
  ribs::RibSet set = roundTheEnd(1.2);
  std::reverse(set.ribs.begin(), set.ribs.end());
  for (ribs::Rib& rib : set.ribs) std::swap(rib.left, rib.right);
  LoftParams params;
  params.startCap = CapStyle::Flat;
  params.endCap = CapStyle::Flat;
  const auto mesh = loftRibs(set, kPicture, params);
  REQUIRE(mesh.ok());
  requireLawful(mesh.value());
  CHECK(mesh::boundsOf(mesh.value()).high[0] == doctest::Approx(500).epsilon(0.002));
  CHECK(mesh::boundsOf(mesh.value()).low[0] == doctest::Approx(100).epsilon(0.002));
}
