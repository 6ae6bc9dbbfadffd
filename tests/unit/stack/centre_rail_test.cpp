// Rails through the middles of the sheets of a stack: nothing that was drawn moves.
#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/geometry/polygon.h"
#include "engine/stack/centre_rail.h"
#include "engine/stack/stand.h"
#include "tests/support/rounds.h"
#include "tests/support/stacks.h"

using namespace spineloft;
using namespace spineloft::testing;

namespace {

struct Drawn {
  std::vector<stack::Plane> planes;
  stack::Rail rail;
};

/// Sheets that stand apart, beside the rail and off it, turned, with one to three curves each.
Drawn randomStack(std::mt19937& random, int count, bool closed) {
  std::uniform_real_distribution<double> unit(-1, 1);
  Drawn drawn{{}, {{}, closed}};
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * std::numbers::pi * i / (closed ? 5 : 8);
    drawn.rail.points.push_back({150 * std::cos(angle), 150 * std::sin(angle), 30 * unit(random)});
  }
  for (int i = 0; i < count; ++i) {
    stack::Plane plane;
    plane.at = (i + 0.5 + 0.3 * unit(random)) / count;
    plane.turn = geometry::turnAbout(ModelPoint{unit(random), unit(random), 0.3}, 0.6 * unit(random));
    if (i % 3 == 2) plane.origin = ModelPoint{100 * unit(random), 100 * unit(random), 60.0 * i};
    for (int k = 0; k <= i % 3; ++k)
      plane.curves.push_back(circleCurve(8 + i, {30.0 * k + unit(random), unit(random)}));
    if (i == 1) plane.curves.push_back(ground({{-20, 5}, {0, 9}, {25, 4}}, -3));
    drawn.planes.push_back(plane);
  }
  return drawn;
}

}  // namespace

TEST_CASE("sheets that are put on the rail through their middles stay where they are, with every curve") {
  std::mt19937 random(24);
  for (int round = 0; round < testing::rounds(20); ++round) {
    const bool closed = round % 2 == 1;
    const auto [planes, rail] = randomStack(random, 3 + round % 5, closed);
    const auto on = stack::ontoCentres(planes, rail);
    REQUIRE(on.ok());
    CHECK(on.value().rail.closed == closed);
    REQUIRE(on.value().planes.size() == planes.size());
    double before = -1;
    for (std::size_t i = 0; i < planes.size(); ++i) {
      const stack::Plane& now = on.value().planes[i];
      CHECK_FALSE(now.origin);
      CHECK(now.at > before);
      before = now.at;
      REQUIRE(stack::isValid(now));
      const auto was = stack::standOf(planes[i], rail), is = stack::standOf(now, on.value().rail);
      REQUIRE((was.ok() && is.ok()));
      CHECK(distance(is.value().origin, on.value().rail.points[i]) < 1e-6);
      CHECK(dot(was.value().normal(), is.value().normal()) == doctest::Approx(1).epsilon(1e-9));
      for (std::size_t k = 0; k < planes[i].curves.size(); ++k) {
        const auto old = stack::outlineOf(planes[i].curves[k]), drawn = stack::outlineOf(now.curves[k]);
        REQUIRE(old.size() == drawn.size());
        for (std::size_t p = 0; p < old.size(); ++p) {
          CHECK(distance(was.value().at(old[p]), is.value().at(drawn[p])) < 1e-3);
        }
      }
    }
  }
}

TEST_CASE("the rail goes through the centres of area, and what was on it already stays as it was") {
  const stack::Rail rail = railAhead(100);
  const std::vector<stack::Plane> straight{railPlane(0, {circleCurve(20)}), railPlane(0.5, {circleCurve(30)}),
                                           railPlane(1, {circleCurve(10)})};
  const auto same = stack::ontoCentres(straight, rail);
  REQUIRE(same.ok());
  for (std::size_t i = 0; i < straight.size(); ++i) {
    CHECK(same.value().planes[i].at == doctest::Approx(straight[i].at));
    CHECK(distance(same.value().rail.points[i], rail.points[0] + ModelPoint{0, 0, -50.0 * static_cast<double>(i)}) <
          1e-3);
  }
  // Two curves: their middle by area, which is nearer to the larger one.
  const std::vector<stack::Plane> beside{railPlane(0, {rectangle(30, 30)}),
                                         railPlane(1, {circleCurve(20), circleCurve(10, {100, 0})})};
  const auto on = stack::ontoCentres(beside, rail);
  REQUIRE(on.ok());
  const auto stand = stack::standOf(beside[1], rail);
  CHECK(distance(on.value().rail.points[1], stand.value().at({20, 0})) < 0.1);
  CHECK(distance(on.value().rail.points[0], stack::standOf(beside[0], rail).value().at({15, 15})) < 1e-6);
}

TEST_CASE("sheets that make no rail are named, with what to do") {
  const auto refused = [](const std::vector<stack::Plane>& planes, const stack::Rail& rail, const std::string& words) {
    const auto on = stack::ontoCentres(planes, rail);
    REQUIRE_FALSE(on.ok());
    const std::string sentence = failureSentence(on.failure());
    CHECK_MESSAGE(sentence.find(words) != std::string::npos, sentence);
  };
  const stack::Rail rail = railAhead(100);
  stack::Rail round{{{100, 0, 0}, {0, 100, 0}, {-100, 0, 0}}, true};
  refused({}, rail, "two sheets");
  refused({railPlane(0, {circleCurve(20)})}, rail, "two sheets");
  refused({railPlane(0, {circleCurve(20)}), railPlane(0.5, {circleCurve(20)})}, round, "three sheets");
  refused({railPlane(0, {circleCurve(20)}), railPlane(1, {})}, rail, "sheet 2 has no curve");
  refused({railPlane(0.5, {circleCurve(20)}), railPlane(0.5, {circleCurve(10)})}, rail, "sheet 2");
  refused({railPlane(0, {circleCurve(20)}), railPlane(1, {circleCurve(20)})}, {}, "rail has no length");
}
