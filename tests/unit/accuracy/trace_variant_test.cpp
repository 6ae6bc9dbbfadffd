#include "tests/bench/accuracy/trace_variant.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/ribs/search/ribs.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::accuracy;
using namespace spineloft::ribs;

TEST_CASE("with nothing exchanged a variant is the product, and each exchange is what it says") {
  constexpr image::Size kPicture{400, 300};
  const auto inBar = [](PicturePoint p) { return p.x >= 60 && p.x <= 300 && std::abs(p.y - 150) <= 30; };
  const auto map = fixtures::mapOf(kPicture, inBar);
  const PictureEvidence picture{map, kPicture};
  for (const double slope : {0.0, 0.05}) {
    const fixtures::Points stroke{{90, 150 - 90 * slope}, {270, 150 + 90 * slope}};
    const Spine spine = cleanSpine(stroke, kPicture, {.ribs = 60}).value();
    const auto variant = [&](const TraceVariant& of) { return variantRibs(spine, picture, {}, of).value(); };
    const RibSet single = traceRibs(spine, picture, {}, Progress()).value();
    CHECK(variant({}) == single);
    CHECK(variant({.sampled = true}).energy.total() >= single.energy.total() - 1e-3);
    const RibSet straight = variant({.euclidean = true});
    CHECK(straight.ribs.size() == single.ribs.size());
    if (slope > 0) continue;
    // Along a straight stroke the normals of d∞ stay upright.
    for (const Rib& rib : straight.ribs) CHECK(std::abs(rib.left.x - rib.center.x) < 1e-3);
  }
}

TEST_CASE("the first spine that cannot be traced is the variant's failure") {
  constexpr image::Size kPicture{200, 200};
  const auto map = fixtures::mapOf(kPicture, [](PicturePoint p) { return p.x < 100; });
  CHECK(variantRibs(Spine{}, {map, kPicture}, {}, {}).error() == Error::StrokeTooShort);
}
