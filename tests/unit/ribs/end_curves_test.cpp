#include "engine/ribs/edit/end_curves.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/rounds.h"
#include "tests/unit/ribs/fixtures.h"

using namespace spineloft;
using namespace spineloft::ribs;
using testing::seeds;

namespace {

constexpr image::Size kPicture{800, 800};

Spine wandering(Rng& rng) {
  for (;;) {
    auto spine = cleanSpine(fixtures::wander(rng, 60, 6), kPicture, {.ribs = 30});
    if (spine) return std::move(spine).value();
  }
}

Side sideOf(Rng& rng) { return rng.below(2) == 0 ? Side::Left : Side::Right; }

}  // namespace

TEST_CASE("an end on the gradient curve of its rib is told with nearly nothing beside it, and by the curve's length") {
  for (const std::uint64_t seed : seeds(0, 10)) {
    Rng rng(seed);
    const Spine spine = wandering(rng);
    const Ruler ruler(spine.points);
    const D2Field field(spine.points);
    GradientCurves curves;
    traceCurves(spine, field, makeLevels(90, 1, 90, field.length()), 3, kPicture, curves);
    const EndCurves ends(spine, kPicture);
    for (std::size_t rib = 3; rib + 3 < spine.points.size(); ++rib) {
      for (const Side side : {Side::Left, Side::Right}) {
        const int curve = curves.layout.sideOf(static_cast<int>(rib), side == Side::Left);
        const int last = curves.reached[static_cast<std::size_t>(curve)] - 1;
        EndEdit end{.at = ruler.placeOfPoint(rib), .side = side};
        ruler.toFrame(curves.point(curve, last), end);
        // Curves that lead back along the spine are followed straight on.
        if (end.out < 0.9 * curves.along[curves.at(curve, last)]) continue;
        const EndOnCurve told = ends.tell(rib, end, 1e-6);
        CHECK(std::abs(told.beside) < 0.25);
        CHECK(told.length == doctest::Approx(curves.along[curves.at(curve, last)]).epsilon(0.002));
      }
    }
  }
}

TEST_CASE(
    "every end, however far from its curve, comes back to within half a step, and is told again in the same words") {
  for (const std::uint64_t seed : seeds(0, 20)) {
    Rng rng(seed);
    const Spine spine = wandering(rng);
    const Ruler ruler(spine.points);
    const EndCurves ends(spine, kPicture);
    for (int i = 0; i < 200; ++i) {
      const std::size_t rib = rng.below(static_cast<std::uint32_t>(spine.points.size()));
      const double far = std::pow(10, rng.uniform(0, 6)), step = 0.5;
      const EndEdit end{.at = ruler.placeOfPoint(rib),
                        .side = sideOf(rng),
                        .along = rng.uniform(-far, far),
                        .out = rng.uniform(-far, far)};
      EndOnCurve told = ends.tell(rib, end, step);
      told.beside = std::round(told.beside / step) * step;
      EndEdit back = end;
      ends.put(rib, told, back);
      CHECK(std::abs(back.along - end.along) <= step / 2 + 1e-6);
      CHECK(std::abs(back.out - end.out) <= step / 2 + 1e-6);
      const EndOnCurve again = ends.tell(rib, back, step);
      CHECK(again.length == told.length);
      CHECK(std::round(again.beside / step) * step == told.beside);
    }
  }
}
