#include "engine/geometry/polyline.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/base/rng.h"

using namespace spineloft;
using Points = std::vector<PicturePoint>;

namespace {

Points randomLine(Rng& rng, std::size_t count) {
  Points p(count);
  for (PicturePoint& x : p) x = {rng.uniform(0, 100), rng.uniform(0, 100)};
  return p;
}

// The functional that geometry::smooth minimises.
double roughness(const Points& x, const Points& p, double weight) {
  double sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) sum += dot(x[i] - p[i], x[i] - p[i]);
  for (std::size_t i = 1; i + 1 < x.size(); ++i) {
    const PicturePoint d = (x[i - 1] - x[i] * 2 + x[i + 1]) * weight;
    sum += dot(d, d);
  }
  return sum;
}

}  // namespace

TEST_CASE("smoothing finds the minimum: any small change of an inner point costs more") {
  Rng rng(1);
  for (std::size_t count : {3u, 4u, 5u, 40u}) {
    for (double weight : {0.3, 3.0, 100.0}) {
      const Points p = randomLine(rng, count);
      const Points x = geometry::smooth(p, weight);
      REQUIRE(x.size() == count);
      CHECK(x.front() == p.front());
      CHECK(x.back() == p.back());
      const double least = roughness(x, p, weight);
      for (std::size_t i = 1; i + 1 < count; ++i) {
        for (PicturePoint d : {PicturePoint{0.01, 0}, {-0.01, 0}, {0, 0.01}, {0, -0.01}}) {
          Points y = x;
          y[i] += d;
          CHECK(roughness(y, p, weight) > least);
        }
      }
    }
  }
}

TEST_CASE("smoothing keeps an evenly spaced straight line, and weight 0 keeps everything") {
  Points line;
  for (int i = 0; i < 30; ++i) line.push_back({3.0 * i, 100 - 2.0 * i});
  const Points x = geometry::smooth(line, 1000);
  for (std::size_t i = 0; i < line.size(); ++i) CHECK(distance(x[i], line[i]) < 1e-9);
  Rng rng(2);
  const Points p = randomLine(rng, 12);
  CHECK(geometry::smooth(p, 0) == p);
}

TEST_CASE("the first crossing lies on both of its segments") {
  const Points loop{{0, 0}, {10, 0}, {10, 10}, {5, 10}, {5, -5}};
  const auto crossing = geometry::findCrossing(loop);
  REQUIRE(crossing.has_value());
  CHECK(crossing->first == 0);
  CHECK(crossing->second == 3);
  CHECK(distance(crossing->at, PicturePoint{5, 0}) < 1e-12);
}

TEST_CASE("a polyline that only turns has no crossing, and three points never cross") {
  Points spiral;
  for (int i = 0; i < 200; ++i) {
    spiral.push_back({(5 + i) * std::cos(i * 0.2), (5 + i) * std::sin(i * 0.2)});
  }
  CHECK_FALSE(geometry::findCrossing(spiral).has_value());
  CHECK_FALSE(geometry::findCrossing(Points{{0, 0}, {5, 0}, {1, 0}}).has_value());
}
