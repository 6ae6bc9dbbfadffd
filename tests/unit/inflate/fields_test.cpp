#include "engine/inflate/fields.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include "engine/geometry/pieces.h"
#include "engine/geometry/polyline.h"
#include "engine/inflate/interior.h"
#include "engine/inflate/poisson_height.h"
#include "tests/support/named_shapes.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::inflate;
using namespace spineloft::testing;

namespace {

Fields fieldsIn(const geometry::Contours& piece, double fineness = 1) {
  const Result<Skeleton> skeleton = skeletonOf(piece, kScale, fineness);
  REQUIRE(skeleton.ok());
  Result<Fields> fields = fieldsOf(piece, skeleton.value(), fineness);
  REQUIRE(fields.ok());
  return std::move(fields).value();
}

double largestHalf(const Fields& fields) { return std::ranges::max(fields.half); }

/// How many of 19 levels have not exactly one closed line for each outline.
int wrongLevels(const Fields& fields) {
  int wrong = 0;
  for (int k = 1; k < 20; ++k) {
    std::vector<int> lines(fields.sizes.size(), 0);
    const double level[] = {k / 20.0};
    for (const LevelLine& line : levelLines(fields, level)) ++lines[line.side];
    wrong += std::ranges::any_of(lines, [](int count) { return count != 1; });
  }
  return wrong;
}

/// The largest difference between s of the fields and a formula, off the rim.
template <class Formula>
double farthestOff(const Fields& fields, const Formula& s) {
  double most = 0;
  for (std::size_t i = 0; i < fields.s.size(); ++i)
    most = std::max(most, std::abs(fields.s[i] - s(fields.mesh.points()[i])));
  return most;
}

}  // namespace

TEST_CASE("every level between skeleton and outline is one closed line for every outline") {
  int levels = 0, wrong = 0;
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    const Fields calm = fieldsIn(shape.contours);
    const double width = largestHalf(calm);
    const auto count = [&](const Fields& fields) {
      const int found = wrongLevels(fields);
      CHECK(found == 0);
      wrong += found;
      levels += 19;
    };
    count(calm);
    for (const int points : {200, 900, 1500}) count(fieldsIn(shape.contours, finenessFor(points)));
    for (const std::uint64_t seed : testing::seeds(1, 4)) {
      count(fieldsIn(trembling(shape.contours, 0.02 * width, (seed % 2 ? 0.15 : 0.6) * width, seed)));
    }
  }
  MESSAGE(wrong << " wrong of " << levels << " level sets");
}

TEST_CASE("s and H of disc, stadium and ring are the closed forms") {
  const Fields disc = fieldsIn(namedShape("disc").contours);
  CHECK(farthestOff(disc, [](SectionPoint p) { return distance(p, {200, -200}) / 120; }) < 0.02);
  for (const double half : disc.half) CHECK(half == doctest::Approx(120).epsilon(0.01));

  const Fields stadium = fieldsIn(namedShape("stadium").contours);
  const SectionPoint left{80, -200}, right{320, -200};
  CHECK(farthestOff(stadium, [&](SectionPoint p) { return geometry::distanceToSegment(p, left, right) / 60; }) < 0.07);
  for (const double half : stadium.half) CHECK(half == doctest::Approx(60).epsilon(0.01));

  const Fields ring = fieldsIn(namedShape("ring").contours);
  CHECK(farthestOff(ring, [](SectionPoint p) { return std::abs(distance(p, {200, -200}) - 110) / 40; }) < 0.04);
  for (const double half : ring.half) CHECK(half == doctest::Approx(40).epsilon(0.02));
}

TEST_CASE("the skeleton consists of edges of the mesh, and s is 0 there and nowhere else") {
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    const Fields fields = fieldsIn(shape.contours);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : fields.mesh.triangles()) {
      for (std::size_t c = 0; c < 3; ++c) edges.insert(std::minmax({t[c], t[(c + 1) % 3]}));
    }
    for (const auto& [a, b] : fields.bones) CHECK(edges.contains(std::minmax({a, b})));
    for (std::size_t i = 0; i < fields.s.size(); ++i) CHECK((fields.s[i] == 0) == (fields.onBone[i] != 0));
  }
}

TEST_CASE("off the skeleton and the outline no point has an extreme value") {
  for (const NamedShape& shape : namedShapes()) {
    const Fields fields = fieldsIn(shape.contours);
    std::vector<char> below(fields.s.size(), 0), above(fields.s.size(), 0);
    for (const auto& t : fields.mesh.triangles()) {
      for (std::size_t c = 0; c < 3; ++c) {
        const std::uint32_t a = t[c], b = t[(c + 1) % 3];
        (fields.s[a] < fields.s[b] ? below[b] : above[b]) = 1;
        (fields.s[b] < fields.s[a] ? below[a] : above[a]) = 1;
      }
    }
    for (std::size_t i = fields.mesh.rim(); i < fields.s.size(); ++i) {
      if (!fields.onBone[i]) CHECK((below[i] && above[i]));
    }
  }
}

TEST_CASE(
    "tremor of 1 % changes a round height by about 1 % RMS, by 8 % at most off the rim; another sampling by 1.5 %" *
    doctest::test_suite("slow")) {
  const auto height = [](const Fields& fields, SectionPoint p) {
    if (!fields.mesh.find(p)) return 0.0;
    std::vector<double> w(fields.s.size());
    std::ranges::transform(fields.s, w.begin(), [](double s) { return s * s; });
    return valueAt(fields.mesh, fields.half, p) * std::sqrt(std::max(0.0, 1 - valueAt(fields.mesh, w, p)));
  };
  const auto compare = [&](const Fields& one, const Fields& other) {
    double sum = 0, most = 0;
    int places = 0;
    for (double y = 5; y < 400; y += 6) {
      for (double x = 5; x < 400; x += 6) {
        const SectionPoint p{x, -y};
        if (!one.mesh.find(p) || !other.mesh.find(p)) continue;
        const double a = height(one, p), b = height(other, p), off = std::abs(a - b);
        sum += off * off;
        // At the rim itself a round height is vertical: there an outline that moves a little moves it much.
        constexpr double kOffRim = 0.44;  // of the half width: s < 0.9
        if (std::min(a, b) > kOffRim * valueAt(one.mesh, one.half, p)) most = std::max(most, off);
        ++places;
      }
    }
    return std::pair{std::sqrt(sum / places), most};
  };
  const bool few = testing::rounds(1) == 1;  // of forty drawings of a disc the mean is 1.04 %, and one has 1.4 %
  double worstMean = 0, worst = 0;
  for (const NamedShape& shape : namedShapes()) {
    CAPTURE(shape.name);
    const Fields calm = fieldsIn(shape.contours);
    const double width = largestHalf(calm);
    double sum = 0;
    int drawings = 0;
    for (const std::uint64_t seed : testing::seeds(1, 3)) {
      const Fields other = fieldsIn(trembling(shape.contours, 0.01 * width, 0.3 * width, seed));
      const auto [mean, most] = compare(calm, other);
      CHECK(mean <= (few ? 0.01 : 0.015) * width);
      CHECK(most <= (few ? 0.06 : 0.08) * width);
      sum += mean / width;
      ++drawings;
      worst = std::max(worst, most / width);
    }
    const double average = sum / drawings;
    CHECK(average <= (few ? 0.01 : 0.011));
    worstMean = std::max(worstMean, average);
    const auto [mean, most] = compare(calm, fieldsIn(geometry::sampleRegion(shape.contours, 5.3)));
    CHECK(mean <= 0.015 * width);
  }
  MESSAGE("tremor of 1 %: heights " << 100 * worstMean << " % RMS, " << 100 * worst << " % at most");
}
