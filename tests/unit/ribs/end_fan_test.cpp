#include "engine/ribs/ends/end_fan.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/ribs/search/ribs.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kPicture{400, 300};
constexpr double kHalf = 30, kEnd = 300;  // of the bar, and where it ends beyond the last rib
constexpr double kLast = 270;             // where the stroke ends

// A bar along y = 150 from x = 60 whose right end has the given shape: `over` is how far beyond its
// last full section a point lies, as a share of what the shape adds.
using Ending = bool (*)(double across, double over);
bool inBar(PicturePoint p, Ending ending) {
  const double across = std::abs(p.y - 150) / kHalf;
  if (p.x < 60 || across > 1) return false;
  return p.x <= kLast || (p.x <= kEnd && ending(across, (p.x - kLast) / (kEnd - kLast)));
}
bool flat(double, double) { return true; }
bool round(double across, double over) { return across * across + over * over <= 1; }
bool pointed(double across, double over) { return across + over <= 1; }

RibSet traced(Ending ending) {
  const auto map = fixtures::mapOf(kPicture, [&](PicturePoint p) { return inBar(p, ending); });
  const Spine spine = cleanSpine(fixtures::Points{{90, 150}, {kLast, 150}}, kPicture, {.ribs = 60}).value();
  return traceRibs(spine, map, kPicture, {}, Progress()).value();
}

double farthest(const RibSet& set) {
  double x = 0;
  for (const PicturePoint& p : set.endFan.points) x = std::max(x, p.x);
  for (const Rib& rib : set.ribs) x = std::max({x, rib.left.x, rib.right.x});
  return x;
}

// A site on a made-up field of costs: cheap on the outline of a shape, dear elsewhere.
struct MadeUp {
  Spine spine;
  GradientCurves curves;
  std::vector<float> costs;
  PicturePoint left{kLast, 150 - kHalf}, right{kLast, 150 + kHalf};
  explicit MadeUp(Ending ending, double extent) {
    spine = cleanSpine(fixtures::Points{{90, 150}, {kLast, 150}}, kPicture, {.ribs = 20}).value();
    const D2Field field(spine.points);
    traceCurves(spine, field, makeLevels(100, 1, 120, field.length()), 11, kPicture, curves);
    costs.assign(curves.x.size(), 1.f);
    for (int c = 0; c < curves.layout.total(); ++c) {
      for (int k = 1; k < curves.reached[static_cast<std::size_t>(c)]; ++k) {
        const auto inside = [&](PicturePoint p) {
          const double across = std::abs(p.y - 150) / kHalf, over = (p.x - kLast) / extent;
          return across <= 1 && (over <= 0 || (over <= 1 && ending(across, over)));
        };
        if (inside(curves.point(c, k - 1)) && !inside(curves.point(c, k))) {
          costs[curves.at(c, k)] = -1;
        }
      }
    }
  }
  EndSite site() const {
    return {.curves = curves,
            .costs = costs,
            .left = left,
            .right = right,
            .leftLabel = 1,
            .rightLabel = 1,
            .halfWidth = kHalf};
  }
  EndGuess guess() const { return guessEnd(site()); }
};

}  // namespace

TEST_CASE("where nothing is to be seen an end is round and as long as half its width") {
  MadeUp site(round, 30);
  std::fill(site.costs.begin(), site.costs.end(), 0.f);
  const EndGuess guess = site.guess();
  CHECK(guess.shape == EndShape::Round);
  CHECK(guess.extent > 0.9);
  CHECK(guess.extent < 1.1);
}

TEST_CASE("a part goes on to the object's end beyond the stroke, whatever its shape, and no farther") {
  for (const Ending ending : {flat, round, pointed}) {
    const double x = farthest(traced(ending));
    CHECK(x > kEnd - 6);
    CHECK(x < kEnd + 6);
  }
}
