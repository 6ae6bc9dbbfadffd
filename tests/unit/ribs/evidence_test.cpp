#include "engine/ribs/evidence/evidence.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/ribs/labels/medial_offset.h"
#include "engine/ribs/learned/likelihood.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;
using fixtures::Points;

namespace {

constexpr image::Size kPicture{400, 300};
// A straight spine along y = 150: left curves run up, arc length is the distance to the spine.
struct Scene {
  Spine spine = cleanSpine(Points{{75, 150}, {325, 150}}, kPicture, {.ribs = 60}).value();
  GradientCurves curves;
  UnwrappedImage strip;
  mutable ColourTables colours;  // memory of what is asked about them
  explicit Scene(const image::EdgeMap& map) {
    const D2Field field(spine.points);
    traceCurves(spine, field, makeLevels(100, 1, 120, field.length()), 7, kPicture, curves);
    unwrapImage(curves, map, nullptr, strip);
    sortColours(curves, strip, colours);
  }
  // The level of the left curve in the middle that is nearest to this far from the spine.
  int level(double away) const {
    int best = 1;
    for (int k = 1; k < curves.reached[30]; ++k) {
      const auto off = [&](int q) { return std::abs(static_cast<double>(curves.along[curves.at(30, q)]) - away); };
      if (off(k) < off(best)) best = k;
    }
    return best;
  }
  float at(const std::vector<float>& plane, double away) const { return plane[curves.at(30, level(away))]; }
};

bool inBar(PicturePoint p) { return p.x > 50 && p.x < 350 && std::abs(p.y - 150) < 30; }

// Paints one lightness over part of a map, without touching edges.
void paint(image::EdgeMap& map, const std::function<bool(PicturePoint)>& where, float light, float a) {
  for (int y = 0; y < map.height; ++y) {
    for (int x = 0; x < map.width; ++x) {
      if (!where({static_cast<double>(x), static_cast<double>(y)})) continue;
      auto& lab = map.look[static_cast<std::size_t>(y * map.width + x)];
      lab.set(0, light);
      lab.set(1, a);
    }
  }
}

}  // namespace

TEST_CASE("colours that the spine never sees are novel, its own are not") {
  image::EdgeMap map = fixtures::mapOf(kPicture, inBar);
  paint(map, [](PicturePoint p) { return p.y < 80; }, 90, 50);
  const Scene scene(map);
  std::vector<float> logOdds;
  spineLogOdds(scene.curves, scene.strip, {}, scene.colours, logOdds);
  CHECK(scene.at(logOdds, 15) < 0);
  CHECK(scene.at(logOdds, 50) > 0.5);
  CHECK(scene.at(logOdds, 90) > 0.5);
}

TEST_CASE("a colour inside the part that is known is not foreign any more") {
  image::EdgeMap map = fixtures::mapOf(kPicture, inBar);
  // A sleeve of another colour between 10 and 20 pixels from the spine.
  const auto sleeve = [](PicturePoint p) { return std::abs(p.y - 150) > 10 && std::abs(p.y - 150) < 20; };
  paint(map, sleeve, 50, 60);
  const Scene scene(map);
  std::vector<float> first, second;
  spineLogOdds(scene.curves, scene.strip, {}, scene.colours, first);
  const std::vector<float> known(static_cast<std::size_t>(scene.curves.layout.total()), 25.f);
  spineLogOdds(scene.curves, scene.strip, {known, {}}, scene.colours, second);
  CHECK(scene.at(first, 15) > 0.3);
  CHECK(scene.at(second, 15) < 0);
  CHECK(scene.at(second, 60) > 0.3);
}

TEST_CASE("what is known to lie around the object is foreign to it, ink and paper alike") {
  // Paper inside and outside, and a line between: all of the strip hardly differs from the spine.
  const auto line = [](PicturePoint p) { return std::abs(std::abs(p.y - 150) - 30) < 2; };
  image::EdgeMap map = fixtures::mapOf(kPicture, line);
  // The paper outside is a little darker.
  paint(map, [](PicturePoint p) { return std::abs(p.y - 150) > 32; }, 84, 0);
  const Scene scene(map);
  std::vector<float> alone, both;
  spineLogOdds(scene.curves, scene.strip, {}, scene.colours, alone);
  const std::vector<float> ends(static_cast<std::size_t>(scene.curves.layout.total()), 30.f);
  spineLogOdds(scene.curves, scene.strip, {ends, ends}, scene.colours, both);
  CHECK(scene.at(both, 60) > 0.3);
  CHECK(scene.at(both, 60) > scene.at(alone, 60));
  CHECK(scene.at(both, 15) < -0.5);
}

TEST_CASE("where the spine sees what there is everywhere, colour says nothing") {
  const Scene scene(fixtures::mapOf(kPicture, [](PicturePoint) { return false; }));
  std::vector<float> logOdds;
  spineLogOdds(scene.curves, scene.strip, {}, scene.colours, logOdds);
  for (float v : logOdds) CHECK(std::abs(v) < 0.05f);
}

TEST_CASE("a rib stands for the picture up to its neighbours: noise averages out along the contour") {
  image::EdgeMap map = fixtures::mapOf(kPicture, inBar);
  Rng rng(5);
  for (auto& look : map.look) {
    for (std::size_t c = 0; c < 3; ++c) look.set(c, look[c] + static_cast<float>(rng.uniform(-10, 10)));
  }
  const auto spread = [&](int ribs) {
    const Spine spine = cleanSpine(Points{{75, 150}, {325, 150}}, kPicture, {.ribs = ribs}).value();
    const D2Field field(spine.points);
    GradientCurves curves;
    UnwrappedImage strip;
    traceCurves(spine, field, makeLevels(100, 1, 120, field.length()), 7, kPicture, curves);
    unwrapImage(curves, map, nullptr, strip);
    double sum = 0;
    int count = 0;
    for (int c = 1; c + 1 < ribs; ++c) {
      for (int k = 5; k < 20; ++k, ++count) sum += std::pow(strip.lab[curves.at(c, k)][0] - 30, 2);
    }
    return std::sqrt(sum / count);
  };
  CHECK(spread(10) < 0.5 * spread(200));
}

TEST_CASE("the likeliest place of a curve is the outline, for the network and for nearness to an edge alone") {
  const Scene scene(fixtures::mapOf(kPicture, inBar));
  for (const RibNetwork* network : {builtInNetwork(), static_cast<const RibNetwork*>(nullptr)}) {
    Boundary boundary;
    findBoundary(scene.curves, scene.strip, network, {}, boundary);
    int good = 0;
    for (int c = 10; c < 50; ++c) {
      const float* row = &boundary.costs[scene.curves.at(c, 0)];
      const float* best = std::min_element(row + 1, row + scene.curves.reached[static_cast<std::size_t>(c)]);
      good += std::abs(scene.curves.along[scene.curves.at(c, static_cast<int>(best - row))] - 30) < 3 ? 1 : 0;
    }
    CHECK(good >= 36);  // of 40: noise has edges too
  }
}

TEST_CASE("chances of a curve sum to one, support is their sum close by, and doubt bounds what a curve can cost") {
  const Scene scene(fixtures::mapOf(kPicture, inBar));
  Boundary boundary;
  const EvidenceParams params;
  findBoundary(scene.curves, scene.strip, builtInNetwork(), params, boundary);
  for (int c = 0; c < scene.strip.curves; ++c) {
    const float* chance = &boundary.chance[scene.curves.at(c, 0)];
    const int reached = scene.curves.reached[static_cast<std::size_t>(c)];
    double sum = 0;
    for (int k = 0; k < scene.strip.levels; ++k) {
      sum += static_cast<double>(chance[k]);
      double close = 0;  // within two of a hundred labels
      for (int q = std::max(1, k - 2); k > 0 && q <= std::min(reached - 1, k + 2); ++q)
        close += static_cast<double>(chance[q]);
      if (k < reached && boundary.support[scene.curves.at(c, k)] > 0)
        CHECK(static_cast<double>(boundary.support[scene.curves.at(c, k)]) == doctest::Approx(close).epsilon(1e-3));
    }
    CHECK(sum == doctest::Approx(1).epsilon(1e-4));
  }
  for (float cost : boundary.costs) {
    CHECK(cost <= -std::log(params.doubt) + 1e-4);
    CHECK(cost >= -std::log(3 * scene.strip.levels / 16.0 + params.doubt) - 1e-4);
  }
}

TEST_CASE("the medial offset of a stroke is found: the part is even although the stroke is not in its middle") {
  LengthWorkspace workspace;
  for (double offset : {-0.5, -0.25, 0.0, 0.4}) {
    LengthProblem p;
    p.ribs = 40;
    p.levels = 80;
    p.neighbourWeight = 0.7f;
    p.neighbourFreedom = 0.1f;
    p.neighbourCap = 8;
    Rng rng(61);
    for (SideCosts* side : {&p.left, &p.right}) {
      const double sign = side == &p.left ? 1 : -1;
      p.left.spacing.assign(39, 5.f);
      p.right.spacing = p.left.spacing;
      for (int i = 0; i < p.ribs; ++i) {
        const double width = 50 + 10 * std::sin(i * 0.2), truth = width * (1 + sign * offset) / 2;
        const bool gap = rng.uniform() < 0.4;
        for (int k = 0; k < p.levels; ++k) {
          const double near = gap ? 0 : std::max(0.0, 1 - std::abs(k - truth) / 3);
          side->unary.push_back(k == 0 ? kUnreachable : static_cast<float>(1 - near));
          side->place.push_back(static_cast<float>(k));
        }
      }
    }
    WidthHypotheses found;
    fitWidthHypotheses(p, 2, 0.1, workspace, found);
    const WidthHypothesis& part = found.all[0];
    CHECK(part.medialOffset == doctest::Approx(offset).epsilon(0.05).scale(1));
    REQUIRE(part.width.size() == 40);
    for (int i = 4; i < 36; ++i) {
      CHECK(part.width[static_cast<std::size_t>(i)] == doctest::Approx(50 + 10 * std::sin(i * 0.2)).epsilon(0.1));
    }
  }
}

TEST_CASE("a stroke off the middle beside an inner line keeps both parts in the running") {
  // Left: one outline, 12 away. Right: an inner line as far away, and the outline three times as far.
  LengthProblem p;
  p.ribs = 40;
  p.levels = 80;
  p.neighbourWeight = 0.7f;
  p.neighbourFreedom = 0.1f;
  p.neighbourCap = 8;
  for (SideCosts* side : {&p.left, &p.right}) {
    side->spacing.assign(39, 5.f);
    for (int i = 0; i < p.ribs; ++i) {
      for (int k = 0; k < p.levels; ++k) {
        const bool line = std::abs(k - 12) < 2;
        const bool outline = side == &p.right && std::abs(k - 36) < 2;
        side->unary.push_back(k == 0 ? kUnreachable : line ? 0.f : outline ? 0.05f : 1.f);
        side->place.push_back(static_cast<float>(k));
      }
    }
  }
  LengthWorkspace workspace;
  WidthHypotheses found;
  fitWidthHypotheses(p, 2, 0.1, workspace, found);
  const std::span<const WidthHypothesis> parts = found.span();
  REQUIRE(parts.size() >= 2);
  CHECK(std::abs(parts[0].medialOffset) < 0.1);
  CHECK(parts[0].width[20] == doctest::Approx(24).epsilon(0.15));
  CHECK(parts[1].medialOffset == doctest::Approx(-0.5).epsilon(0.1));
  CHECK(parts[1].width[20] == doctest::Approx(48).epsilon(0.15));
  CHECK(parts[0].energy <= parts[1].energy);
  CHECK(parts.size() <= kMostRunnersUp);
}
