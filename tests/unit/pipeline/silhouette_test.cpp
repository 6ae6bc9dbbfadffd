#include "engine/pipeline/silhouette.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/loft/loft.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::testing;

namespace {

long covered(const image::Mask& mask) { return std::count(mask.pixels.begin(), mask.pixels.end(), std::uint8_t{255}); }

/// The box between two picture points as a mesh in ModelSpace.
mesh::TriMesh pictureBox(float x0, float y0, float x1, float y1) {
  mesh::TriMesh mesh = box(x1 - x0, y1 - y0, 5);
  for (auto& p : mesh.positions) p = {p[0] + x0, p[1] - y1, p[2]};
  requireLawful(mesh);
  return mesh;
}

}  // namespace

TEST_CASE("a box covers exactly the pixel centres inside it, the left and top edge included") {
  const auto at = [](const image::Mask& mask, int x, int y) {
    return mask.pixels[static_cast<std::size_t>(y * mask.width + x)];
  };
  const image::Mask mask = pipeline::rasteriseSilhouette(pictureBox(3, 2, 7, 5), {20, 10});
  CHECK(mask.width == 20);
  CHECK(mask.height == 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) {
      CHECK(at(mask, x, y) == (x >= 3 && x < 7 && y >= 2 && y < 5 ? 255 : 0));
    }
  }
  CHECK(covered(pipeline::rasteriseSilhouette(pictureBox(2.6f, 1.6f, 7.4f, 5.4f), {20, 10})) == 20);
}

TEST_CASE("what lies outside the picture is cut off, and nothing covers an empty one") {
  CHECK(covered(pipeline::rasteriseSilhouette(pictureBox(-50, -50, 100, 100), {20, 10})) == 200);
  CHECK(covered(pipeline::rasteriseSilhouette(pictureBox(30, 0, 40, 10), {20, 10})) == 0);
  CHECK(covered(pipeline::rasteriseSilhouette(pictureBox(0, 20, 10, 30), {20, 10})) == 0);
  CHECK(covered(pipeline::rasteriseSilhouette(pictureBox(0, -30, 10, -20), {20, 10})) == 0);
  CHECK(covered(pipeline::rasteriseSilhouette(pictureBox(-30, 0, -20, 10), {20, 10})) == 0);
  CHECK(pipeline::rasteriseSilhouette(pictureBox(0, 0, 5, 5), {0, 10}).pixels.empty());
}

TEST_CASE("a loft covers the polygon through its rib ends and no gap is left between triangles") {
  Rng rng(5);
  for (int round = 0; round < testing::rounds(30); ++round) {
    const double angle = rng.uniform(0, 6.28), width = rng.uniform(8, 60);
    const PicturePoint middle{160 + rng.uniform(), 120 + rng.uniform()};
    const PicturePoint along = PicturePoint{std::cos(angle), std::sin(angle)} * 50;
    const auto set = straightRibs(middle - along, middle + along, 2 + static_cast<int>(rng.below(60)),
                                  [&](double) { return width; });
    loft::LoftParams params;
    params.startCap = params.endCap = sections::CapStyle::Flat;
    const auto mesh = loft::loftRibs(set, {320, 240}, params);
    REQUIRE(mesh.ok());
    requireLawful(mesh.value());
    const image::Mask mask = pipeline::rasteriseSilhouette(mesh.value(), {320, 240});
    const PicturePoint unit = along / 50.0;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        const PicturePoint p = PicturePoint{1.0 * x, 1.0 * y} - middle;
        const double outside = std::max(std::abs(dot(p, unit)) - 50, std::abs(cross(p, unit)) - width / 2);
        if (std::abs(outside) < 1e-3) continue;  // on the edge, but for rounding
        CHECK_MESSAGE((mask.pixels[static_cast<std::size_t>(y * 320 + x)] == 255) == (outside < 0), "pixel ", x, ", ",
                      y, " of round ", round);
      }
    }
  }
}
