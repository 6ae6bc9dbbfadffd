#include "engine/sections/section.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include "engine/geometry/polygon.h"

using namespace spineloft;
using namespace spineloft::sections;

namespace {

std::span<const SectionPoint> pointsOf(const Section& section) { return section.points; }

}  // namespace

TEST_CASE("every section is simple, counter-clockwise, in the square, and touches both rib ends") {
  for (const SectionName& name : sectionNames()) {
    for (const int count : {12, 13, 48, 97, 512}) {
      CAPTURE(std::string(name.key));
      CAPTURE(count);
      const Section section = presetSection(name.preset, count).value();
      CHECK(geometry::isSimple(pointsOf(section)));
      CHECK(geometry::signedArea(pointsOf(section)) > 0);
      double low = 0, high = 0;
      for (const SectionPoint& p : section.points) {
        low = std::min(low, p.x);
        high = std::max(high, p.x);
        CHECK(std::abs(p.y) <= 1);
      }
      CHECK(low == -1);
      CHECK(high == 1);
      if (name.preset != SectionPreset::Gear || count >= 48) {
        CHECK(section.points.size() >= static_cast<std::size_t>(count) * 3 / 4);
        CHECK(section.points.size() <= static_cast<std::size_t>(count) * 5 / 4 + 4);
      }
    }
  }
}

TEST_CASE("sections do not depend on their resolution: corners and area stay") {
  for (const SectionName& name : sectionNames()) {
    CAPTURE(std::string(name.key));
    const Section fine = presetSection(name.preset, 512).value();
    const Section coarse = presetSection(name.preset, 48).value();
    CHECK(geometry::signedArea(pointsOf(coarse)) ==
          doctest::Approx(geometry::signedArea(pointsOf(fine))).epsilon(0.02));
    for (std::size_t i = 0; i < coarse.points.size(); ++i) {
      const std::size_t n = coarse.points.size();
      const SectionPoint a = coarse.points[i] - coarse.points[(i + n - 1) % n];
      const SectionPoint b = coarse.points[(i + 1) % n] - coarse.points[i];
      if (dot(a, b) > 0.7 * norm(a) * norm(b)) continue;  // not a corner
      double nearest = 10;
      for (const SectionPoint& p : fine.points) nearest = std::min(nearest, distance(p, coarse.points[i]));
      CHECK(nearest < 1e-9);
    }
  }
}

TEST_CASE("all sections but the D are mirror images of themselves") {
  for (const SectionName& name : sectionNames()) {
    if (name.preset == SectionPreset::D) continue;
    CAPTURE(std::string(name.key));
    const Section section = presetSection(name.preset, 64).value();
    for (const SectionPoint& p : section.points) {
      double nearest = 10;
      for (const SectionPoint& q : section.points) {
        nearest = std::min(nearest, distance(q, SectionPoint{-p.x, p.y}));
      }
      CHECK(nearest < 1e-9);
    }
  }
}

TEST_CASE("sections look as they are called") {
  const auto of = [](SectionPreset preset) { return presetSection(preset, 256).value(); };
  const auto area = [](const Section& s) { return geometry::signedArea(pointsOf(s)); };
  const double pi = 3.14159265358979;
  CHECK(area(of(SectionPreset::Circle)) == doctest::Approx(pi).epsilon(1e-3));
  CHECK(area(of(SectionPreset::Ellipse)) == doctest::Approx(pi / 2).epsilon(1e-3));
  CHECK(area(of(SectionPreset::Square)) == doctest::Approx(4));
  CHECK(area(of(SectionPreset::RoundedSquare)) == doctest::Approx(4 - 0.16 * (4 - pi)).epsilon(1e-3));
  CHECK(area(of(SectionPreset::Triangle)) == doctest::Approx(std::sqrt(3.0)));
  CHECK(area(of(SectionPreset::Hexagon)) == doctest::Approx(1.5 * std::sqrt(3.0)));
  CHECK(area(of(SectionPreset::HalfRound)) == doctest::Approx(pi / 2).epsilon(1e-3));
  CHECK(area(of(SectionPreset::D)) == doctest::Approx(pi).epsilon(1e-3));
  CHECK(area(of(SectionPreset::Plank)) < 0.75);
  // Half round: everything towards the viewer, flat at the back.
  for (const SectionPoint& p : of(SectionPreset::HalfRound).points) CHECK(p.y >= 0);
  // Heart: its dent on the axis is lower than the lobes and its tip is the lowest point.
  double dent = -2, lobes = -2, tip = 2;
  for (const SectionPoint& p : of(SectionPreset::Heart).points) {
    if (p.x == 0) dent = std::max(dent, p.y);
    lobes = std::max(lobes, p.y);
    tip = std::min(tip, p.y);
  }
  CHECK(lobes - dent > 0.2);
  CHECK(tip < -0.9);
  // Gear: ten teeth stick out beyond the mean radius.
  const Section gear = of(SectionPreset::Gear);
  int teeth = 0;
  for (std::size_t i = 0; i < gear.points.size(); ++i) {
    const SectionPoint a = gear.points[i], b = gear.points[(i + 1) % gear.points.size()];
    teeth += norm(a) < 0.87 && norm(b) >= 0.87;
  }
  CHECK(teeth == 10);
}

TEST_CASE("sections are found by their keys") {
  std::set<std::string> keys, labels;
  CHECK(sectionNames().size() == 12);
  for (const SectionName& name : sectionNames()) {
    CHECK(sectionFromKey(name.key) == name.preset);
    CHECK(sectionKey(name.preset) == name.key);
    CHECK(keys.insert(std::string(name.key)).second);
    CHECK(labels.insert(std::string(name.label)).second);
  }
  CHECK_FALSE(sectionFromKey("blob").has_value());
  CHECK(presetSection(SectionPreset::kCount, 48).error() == Error::ValueOutOfRange);
  CHECK(presetSection(SectionPreset::Circle, 11).error() == Error::ValueOutOfRange);
  CHECK(presetSection(SectionPreset::Circle, 513).error() == Error::ValueOutOfRange);
}
