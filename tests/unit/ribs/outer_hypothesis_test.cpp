#include "engine/ribs/search/outer_hypothesis.h"

#include <doctest/doctest.h>

#include <vector>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr int kRibs = 40, kLevels = 80;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Curves a pixel from label to label, and a colour cell at every label.
struct Scene {
  GradientCurves curves;
  UnwrappedImage strip;
  ColourTables colours;
  LengthLabels ends{std::vector<int>(kRibs, 30), std::vector<int>(kRibs, 30)};

  Scene() {
    curves.layout = {kRibs, 3};
    curves.levels = kLevels;
    const std::size_t count = index(curves.layout.total()) * kLevels;
    curves.reached.assign(index(curves.layout.total()), kLevels);
    curves.x.assign(count, 0.f);
    for (std::size_t i = 0; i < count; ++i) curves.along.push_back(static_cast<float>(i % kLevels));
    strip.curves = curves.layout.total();
    strip.levels = kLevels;
    colours.cells.assign(count, 0);
  }
  void paint(int rib, bool left, int from, int to, int cell) {
    const int curve = left ? curves.layout.left(rib) : curves.layout.right(rib);
    for (int k = from; k < to; ++k) colours.cells[curves.at(curve, k)] = static_cast<std::uint16_t>(cell);
  }
  double apart() const { return coloursApart(curves, strip, colours, ends); }
};

constexpr int kOther = (6 * kColourBins + 6) * kColourBins + 6;

}  // namespace

TEST_CASE("colours inside and outside are all apart where the outline is, and less so within the thing") {
  Scene scene;
  CHECK(scene.apart() == doctest::Approx(0));
  for (int i = 0; i < kRibs; ++i) {
    for (const bool left : {true, false}) scene.paint(i, left, 30, kLevels, kOther);
  }
  CHECK(scene.apart() == doctest::Approx(1));
  double before = 1;
  for (const int label : {24, 20, 16}) {
    scene.ends = {std::vector<int>(kRibs, label), std::vector<int>(kRibs, label)};
    CHECK(scene.apart() < before);
    before = scene.apart();
  }
  scene.ends.left.assign(kRibs, 45);
  scene.ends.right.assign(kRibs, 45);
  CHECK(scene.apart() < 0.9);
}

TEST_CASE("colours are as far apart with the sides swapped, and do not see what is ignored") {
  Scene scene, swapped;
  Rng rng(5);
  for (int i = 0; i < kRibs; ++i) {
    for (const bool left : {true, false}) {
      const int label = 12 + static_cast<int>(rng.below(33));
      (left ? scene : swapped).ends.left[index(i)] = label;
      (left ? swapped : scene).ends.right[index(i)] = label;
      for (int k = 1; k < kLevels; ++k) {
        const int cell = static_cast<int>(rng.below(kOther));
        scene.paint(i, left, k, k + 1, cell);
        swapped.paint(i, !left, k, k + 1, cell);
      }
    }
  }
  CHECK(scene.apart() == doctest::Approx(swapped.apart()));
  CHECK(scene.apart() > 0);
  CHECK(scene.apart() < 1);
  scene.strip.ignored.assign(scene.colours.cells.size(), 0);
  const double open = scene.apart();
  CHECK(open == doctest::Approx(swapped.apart()));
  scene.strip.ignored.assign(scene.colours.cells.size(), 1);
  CHECK(scene.apart() == 0);
}

TEST_CASE("a steady taper is even; zigzags count by their share of the length, in no unit") {
  Scene scene;
  for (int i = 0; i < kRibs; ++i) scene.ends.left[index(i)] = 20 + i;
  CHECK(unevenness(scene.curves, scene.ends) == doctest::Approx(0));
  Rng rng(9);
  for (int i = 0; i < kRibs; ++i) scene.ends.right[index(i)] = 20 + static_cast<int>(rng.below(20));
  const double rough = unevenness(scene.curves, scene.ends);
  CHECK(rough > 0.1);
  for (float& along : scene.curves.along) along *= 7;
  CHECK(unevenness(scene.curves, scene.ends) == doctest::Approx(rough));
}
