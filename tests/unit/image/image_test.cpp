#include "engine/image/image.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "engine/base/limits.h"
#include "engine/base/rng.h"
#include "engine/image/edge_map.h"
#include "engine/image/lab.h"

using namespace spineloft;
using namespace spineloft::image;

namespace {

Image randomImage(int width, int height, std::uint64_t seed) {
  Rng rng(seed);
  Image image{width, height, {}};
  image.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (auto& value : image.pixels) value = static_cast<std::uint8_t>(rng.below(256));
  return image;
}

Image plain(int width, int height, std::array<std::uint8_t, 4> colour) {
  Image image{width, height, {}};
  image.pixels.resize(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = colour[i % 4];
  return image;
}

const std::uint8_t* at(const Image& image, int x, int y) {
  return image.pixels.data() +
         4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) + static_cast<std::size_t>(x));
}

/// The definition, pixel by pixel with exact overlaps.
std::array<double, 4> averageOf(const Image& image, double x0, double x1, double y0, double y1) {
  std::array<double, 4> sum{};
  double area = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double w = std::max(0.0, std::min(x1, x + 1.0) - std::max(x0, 1.0 * x)) *
                       std::max(0.0, std::min(y1, y + 1.0) - std::max(y0, 1.0 * y));
      const std::uint8_t* p = at(image, x, y);
      for (std::size_t c = 0; c < 3; ++c) sum[c] += w * p[3] * p[c];
      sum[3] += w * p[3];
      area += w;
    }
  }
  for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[3] > 0 ? sum[c] / sum[3] : 0;
  sum[3] /= area;
  return sum;
}

}  // namespace

TEST_CASE("shrinking averages areas, weighted by alpha, as the definition says") {
  for (const auto& [w, h, tw, th] : {std::array{17, 23, 5, 7}, std::array{32, 16, 8, 4}, std::array{9, 9, 9, 4},
                                     std::array{31, 3, 30, 2}, std::array{40, 25, 1, 1}}) {
    const Image source = randomImage(w, h, static_cast<std::uint64_t>(w * h));
    const Image small = shrink(source, tw, th);
    REQUIRE(small.width == tw);
    REQUIRE(small.height == th);
    for (int y = 0; y < th; ++y) {
      for (int x = 0; x < tw; ++x) {
        const auto wanted =
            averageOf(source, 1.0 * x * w / tw, 1.0 * (x + 1) * w / tw, 1.0 * y * h / th, 1.0 * (y + 1) * h / th);
        for (std::size_t c = 0; c < 4; ++c) {
          REQUIRE(std::abs(at(small, x, y)[c] - wanted[c]) <= 0.500001);
        }
      }
    }
  }
}

TEST_CASE("shrinking to the same size keeps every byte, and one colour stays that colour") {
  const Image source = randomImage(13, 9, 4);
  CHECK(shrink(source, 13, 9) == source);
  const std::array<std::uint8_t, 4> colour{12, 200, 77, 91};
  CHECK(shrink(plain(50, 37, colour), 11, 6) == plain(11, 6, colour));
}

TEST_CASE("transparent pixels do not bleed their colour") {
  Image source = plain(2, 1, {255, 0, 0, 255});
  source.pixels[4] = 0, source.pixels[5] = 255, source.pixels[7] = 0;
  const Image one = shrink(source, 1, 1);
  CHECK(one.pixels == std::vector<std::uint8_t>{255, 0, 0, 128});
}

TEST_CASE("shrinking refuses sizes it cannot make and sources without their pixels") {
  const Image source = randomImage(8, 8, 1);
  CHECK(shrink(source, 9, 8).empty());
  CHECK(shrink(source, 8, 0).empty());
  CHECK(shrink(Image{}, 1, 1).empty());
  CHECK(shrink(Image{8, 8, {1, 2, 3}}, 4, 4).empty());
}

TEST_CASE("a fitted size obeys both limits, never grows, keeps the shape and turns with its original") {
  Rng rng(11);
  for (int i = 0; i < 20000; ++i) {
    const Size size{1 + static_cast<int>(rng.below(32768)), 1 + static_cast<int>(rng.below(32768))};
    const long long pixels = 1 + rng.below(5'000'000);
    const int side = 1 + static_cast<int>(rng.below(5000));
    const Size fit = fitSize(size, pixels, side);
    REQUIRE(fit.width >= 1);
    REQUIRE(fit.height >= 1);
    REQUIRE(fit.width <= std::min(size.width, side));
    REQUIRE(fit.height <= std::min(size.height, side));
    REQUIRE(static_cast<long long>(fit.width) * fit.height <= pixels);
    const Size turned = fitSize({size.height, size.width}, pixels, side);
    REQUIRE(turned == Size{fit.height, fit.width});
    if (std::min(fit.width, fit.height) > 1) {
      // Rounding moves a side by half a pixel, or by one where rounding up would break the limit.
      const double scale = std::min({1.0, 1.0 * side / std::max(size.width, size.height),
                                     std::sqrt(static_cast<double>(pixels) / size.width / size.height)});
      REQUIRE(std::abs(fit.width - scale * size.width) <= 1.0);
      REQUIRE(std::abs(fit.height - scale * size.height) <= 1.0);
    }
  }
  CHECK(fitSize({4000, 3000}, 4'000'000, 32768) == Size{2309, 1732});
  CHECK(fitSize({800, 600}, 4'000'000, 1024) == Size{800, 600});
  CHECK(fitSize({20000, 20}, 4'000'000, 1024) == Size{1024, 1});
  CHECK(fitSize({0, 5}, 100, 100) == Size{0, 0});
}

TEST_CASE("each EXIF orientation puts the scene's top left corner where it belongs") {
  // A 3 × 2 scene with a different value in every pixel, stored as a camera held that way stores
  // it.
  Image scene{3, 2, {}};
  for (int i = 0; i < 6; ++i) {
    const std::uint8_t v = static_cast<std::uint8_t>(i);
    scene.pixels.insert(scene.pixels.end(), {v, v, v, 255});
  }
  const std::array<std::vector<int>, 9> stored{{{},
                                                {0, 1, 2, 3, 4, 5},
                                                {2, 1, 0, 5, 4, 3},
                                                {5, 4, 3, 2, 1, 0},
                                                {3, 4, 5, 0, 1, 2},
                                                {0, 3, 1, 4, 2, 5},
                                                {2, 5, 1, 4, 0, 3},
                                                {5, 2, 4, 1, 3, 0},
                                                {3, 0, 4, 1, 5, 2}}};
  for (int orientation = 1; orientation <= 8; ++orientation) {
    CAPTURE(orientation);
    const bool swapped = orientation >= 5;
    Image image{swapped ? 2 : 3, swapped ? 3 : 2, {}};
    for (const int i : stored[static_cast<std::size_t>(orientation)]) {
      const std::uint8_t v = static_cast<std::uint8_t>(i);
      image.pixels.insert(image.pixels.end(), {v, v, v, 255});
    }
    CHECK(orient(image, orientation) == scene);
  }
  for (const int other : {0, 9, -1, 70000}) CHECK(orient(scene, other) == scene);
}

TEST_CASE("a large picture keeps its size in words and shrinks in pixels; a small one is kept as it is") {
  const Image small = randomImage(40, 30, 3);
  const Picture kept = makePicture(small);
  CHECK(kept.working == small);
  CHECK(kept.width == 40);
  CHECK(kept.height == 30);

  const Picture large = makePicture(plain(3000, 2000, {9, 8, 7, 255}));
  CHECK(large.width == 3000);
  CHECK(large.height == 2000);
  CHECK(static_cast<long long>(large.working.width) * large.working.height <= kWorkingPixels);
  CHECK(large.working.width > 2400);
  CHECK(large.working.pixels[0] == 9);
  CHECK(makePicture(Image{}).working.empty());

  const Picture turned = makePicture(ImageView(small), 6);
  CHECK(turned.width == 30);
  CHECK(turned.height == 40);
  CHECK(turned.working == orient(small, 6));
}

TEST_CASE("Lab of known colours is what CIE tables say") {
  const auto near = [](std::array<float, 3> lab, std::array<double, 3> wanted) {
    for (std::size_t i = 0; i < 3; ++i) CHECK(lab[i] == doctest::Approx(wanted[i]).epsilon(0.002));
  };
  const auto grey = labOf(119, 119, 119);
  CHECK(grey[0] == doctest::Approx(50.03).epsilon(0.002));
  CHECK(std::abs(grey[1]) < 0.02);
  CHECK(std::abs(grey[2]) < 0.02);
  CHECK(labOf(255, 255, 255)[0] == doctest::Approx(100).epsilon(1e-4));
  CHECK(std::abs(labOf(0, 0, 0)[0]) < 1e-3);
  near(labOf(255, 0, 0), {53.24, 80.09, 67.20});
  near(labOf(0, 255, 0), {87.73, -86.18, 83.18});
  near(labOf(0, 0, 255), {32.30, 79.19, -107.86});
}

TEST_CASE("transparent pixels are white paper to the eye") {
  const Image image = plain(2, 2, {10, 20, 30, 0});
  std::array<float, 4> l{}, a{}, b{};
  labRow(image.pixels, {l.data(), a.data(), b.data()});
  for (std::size_t i = 0; i < 4; ++i) {
    CHECK(l[i] == doctest::Approx(100).epsilon(1e-4));
    CHECK(std::abs(a[i]) < 0.01);
    CHECK(std::abs(b[i]) < 0.01);
  }
}

TEST_CASE("a row of pixels has the Lab of each of its colours, half transparent ones half white") {
  const Image image = randomImage(61, 1, 8);
  std::vector<float> l(61), a(61), b(61);
  labRow(image.pixels, {l.data(), a.data(), b.data()});
  for (std::size_t i = 0; i < 61; ++i) {
    const std::uint8_t* p = image.pixels.data() + 4 * i;
    const auto onPaper = [&](std::size_t c) {
      return static_cast<std::uint8_t>(std::lround((p[c] * p[3] + 255.0 * (255 - p[3])) / 255));
    };
    const auto wanted = labOf(onPaper(0), onPaper(1), onPaper(2));
    CHECK(std::array{l[i], a[i], b[i]} == wanted);
  }
}

TEST_CASE("a look gives back what was put in up to half a step, and holds what is beyond it") {
  PixelFeature look;
  for (const float value : {-108.f, -0.001f, 0.f, 0.3f, 53.2f, 100.f}) {
    for (std::size_t c = 0; c < 3; ++c) {
      look.set(c, value);
      CHECK(std::abs(look[c] - value) <= 0.5f / PixelFeature::kLab);
    }
  }
  for (const float near : {0.f, 1.f / 3, 0.9999f, 1.f}) {
    look.set(3, near);
    CHECK(std::abs(look[3] - near) <= 0.5f / PixelFeature::kNear);
  }
  look.set(0, 1e6f);
  look.set(1, -1e6f);
  look.set(3, 2);
  CHECK(look[0] == 127);
  CHECK(look[1] == -127);
  CHECK(look[3] == 1);
}
