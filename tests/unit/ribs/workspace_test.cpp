#include "engine/ribs/search/workspace.h"

#include <doctest/doctest.h>

#include <cmath>

#include "engine/ribs/search/ribs.h"
#include "tests/support/scarce_memory.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr image::Size kPicture{400, 300};

Spine spineOf(double to, int ribs) {
  fixtures::Points stroke;
  for (double x = 70; x <= to; x += 4) stroke.push_back({x, 150 + 10 * std::sin(0.02 * x)});
  return cleanSpine(stroke, kPicture, {.ribs = ribs}).value();
}

}  // namespace

TEST_CASE("a stroke that was traced before asks for no memory but its result's") {
  const image::EdgeMap map =
      fixtures::mapOf(kPicture, [](PicturePoint p) { return p.x > 50 && p.x < 350 && std::abs(p.y - 150) < 40; });
  RibWorkspace memory;
  const auto trace = [&](const Spine& spine) {
    const std::size_t before = testing::allocatedBytes();
    const RibSet set = traceRibs(spine, {map, kPicture}, {}, Progress(), memory).value();
    const std::size_t result =
        set.ribs.size() * sizeof(Rib) + (set.startFan.points.size() + set.endFan.points.size()) * sizeof(PicturePoint);
    return static_cast<double>(testing::allocatedBytes() - before) / static_cast<double>(result);
  };
  // A growing stroke, drawn twice: what its lengths needed once is there.
  for (double to = 90; to <= 330; to += 15) trace(spineOf(to, 100));
  for (double to = 90; to <= 330; to += 15) {
    CAPTURE(to);
    CHECK(trace(spineOf(to, 100)) < 1.05);
  }
}

TEST_CASE("a growing stroke traced in the same memory gives what it gives from scratch") {
  const image::EdgeMap map = fixtures::mapOf(
      kPicture, [](PicturePoint p) { return p.x > 50 && p.x < 350 && std::abs(p.y - 150) < 30 + 0.05 * p.x; });
  RibWorkspace memory;
  for (double to = 85; to <= 335; to += 25) {
    for (const int ribs : {100, 31}) {
      const Spine spine = spineOf(to, ribs);
      CHECK(traceRibs(spine, {map, kPicture}, {}, Progress(), memory).value() ==
            traceRibs(spine, {map, kPicture}, {}, Progress()).value());
    }
  }
}
