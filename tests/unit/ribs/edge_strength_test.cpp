#include "engine/ribs/evidence/edge_strength.h"

#include <doctest/doctest.h>

#include <array>
#include <vector>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::ribs;

namespace {

constexpr int kRibs = 60, kLevels = 20;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Curves that are all there, and a colour difference at one label of each.
struct Scene {
  GradientCurves curves;
  std::vector<std::array<float, 4>> differences;
  std::vector<int> labels = std::vector<int>(kRibs, 8);

  Scene() {
    curves.layout = {kRibs, 3};
    curves.levels = kLevels;
    curves.reached.assign(index(curves.layout.total()), kLevels);
    differences.assign(index(curves.layout.total()) * (kLevels + 1), {});
  }
  void put(bool left, int rib, int label, std::array<float, 4> difference) {
    const int curve = left ? curves.layout.left(rib) : curves.layout.right(rib);
    differences[index(curve) * (kLevels + 1) + index(label)] = difference;
  }
  std::vector<float> strengths(bool left) const {
    EdgeStrengths memory;
    return edgeStrengths({curves, labels, left}, differences, memory);
  }
};

}  // namespace

TEST_CASE("an end on a fainter edge than the others near by is as strong as its share of theirs") {
  Scene scene;
  for (int i = 0; i < kRibs; ++i) {
    const bool faint = i >= 20 && i < 26;
    scene.put(true, i, 8, {faint ? -3.f : 0.f, 0, faint ? 0.f : 20.f, 0});
  }
  const std::vector<float> found = scene.strengths(true);
  REQUIRE(found.size() == kRibs);
  for (int i = 0; i < kRibs; ++i) {
    const bool faint = i >= 20 && i < 26;
    CHECK(found[index(i)] == doctest::Approx(faint ? 3 / (0.6 * 20) : 1));
  }
  // The other side sees nothing at all.
  for (const float strength : scene.strengths(false)) CHECK(strength == 0);
}

TEST_CASE("a stretch that is faint as a whole is measured against itself, and in no unit") {
  Scene scene;
  for (int i = 0; i < kRibs; ++i) scene.put(false, i, 8, {i < kRibs / 2 ? 40.f : 4.f, 0, 0, 0});
  const std::vector<float> found = scene.strengths(false);
  for (int i = 0; i < kRibs; ++i) {
    const bool apart = i < kRibs / 2 || i >= kRibs / 2 + kRibs / 5;
    if (apart) CHECK(found[index(i)] == 1);
  }
  Rng rng(7);
  Scene wild;
  for (int i = 0; i < kRibs; ++i)
    wild.put(true, i, 8, {static_cast<float>(rng.uniform(1, 9)), static_cast<float>(rng.uniform(1, 9)), 0, 0});
  const std::vector<float> before = wild.strengths(true);
  for (auto& difference : wild.differences) {
    for (float& value : difference) value *= 8;
  }
  CHECK(wild.strengths(true) == before);
}

TEST_CASE("an edge counts for the ends that stand within two labels of it, and no others") {
  Scene scene;
  for (int i = 0; i < kRibs; ++i) scene.put(true, i, 8 + i % 7 - 3, {10, 0, 0, 0});
  const std::vector<float> found = scene.strengths(true);
  for (int i = 0; i < kRibs; ++i) CHECK(found[index(i)] == (i % 7 == 0 || i % 7 == 6 ? 0.f : 1.f));
  // Labels at the first and the last place of a curve look nowhere else.
  scene.labels.assign(kRibs, kLevels - 1);
  for (const float strength : scene.strengths(true)) CHECK(strength == 0);
  scene.labels.assign(kRibs, 0);
  for (const float strength : scene.strengths(true)) CHECK(strength == 0);
}

TEST_CASE("where no colours were compared all ends are equally strong") {
  Scene scene;
  scene.differences.clear();
  CHECK(scene.strengths(true) == std::vector<float>(kRibs, 1.f));
}
