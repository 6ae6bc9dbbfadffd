#include "engine/surface/atlas.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <deque>

#include "engine/base/rng.h"
#include "tests/support/front_view.h"

using namespace spineloft;
using namespace spineloft::surface;

namespace {

image::Image plain(int width, int height, std::uint8_t colour) {
  image::Image out{width, height, {}};
  out.pixels.assign(std::size_t(4) * std::size_t(width) * std::size_t(height), colour);
  return out;
}

/// Pixel rectangle of a place: left, top, right, bottom.
std::array<long, 4> pixelsOf(const Atlas& atlas, const UvArea& a) {
  const double w = atlas.pixels.width, h = atlas.pixels.height;
  return {std::lround(a.left * w), std::lround(a.top * h), std::lround(a.right * w), std::lround(a.bottom * h)};
}

/// The next mip level: means of 2 × 2 pixels.
image::Image halved(const image::Image& fine) {
  image::Image out{std::max(1, fine.width / 2), std::max(1, fine.height / 2), {}};
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        int sum = 0;
        for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {0, 1}, {1, 1}}) {
          const int fx = std::min(2 * x + dx, fine.width - 1), fy = std::min(2 * y + dy, fine.height - 1);
          sum += fine.pixels[4 * (std::size_t(fy) * std::size_t(fine.width) + std::size_t(fx)) + c];
        }
        out.pixels.push_back(std::uint8_t((sum + 2) / 4));
      }
    }
  }
  return out;
}

}  // namespace

TEST_CASE("at the second mip level a picture of an atlas has still no colour of another") {
  Rng rng(29);
  for (int round = 0; round < 12; ++round) {
    std::deque<image::Image> images;
    std::vector<const image::Image*> given;
    const int count = 2 + int(rng.below(20));
    for (int i = 0; i < count; ++i) {
      images.push_back(
          plain(1 + int(rng.below(150)), 1 + int(rng.below(150)), std::uint8_t(i % 2 == 0 ? 10 + i : 250 - i)));
      given.push_back(&images.back());
    }
    const auto atlas = packAtlas(given);
    REQUIRE(atlas);
    CHECK(atlas->pixels.width % 4 == 0);
    CHECK(atlas->pixels.height % 4 == 0);
    const image::Image second = halved(halved(atlas->pixels));
    for (std::size_t i = 0; i < given.size(); ++i) {
      for (int k = 0; k < 200; ++k) {
        // Everywhere, and on its edges and corners.
        const auto place = [&] { return k % 3 == 0 ? rng.uniform() : double(rng.below(2)); };
        const auto [u, v] = inAtlas(atlas->places[i], place(), place());
        for (const double c : testing::sampled(second, double(u), double(v))) {
          REQUIRE(c == doctest::Approx(images[i].pixels[0]));
        }
      }
    }
  }
}

TEST_CASE("pictures of an atlas keep their pixels, lie apart and within it") {
  Rng rng(11);
  for (int round = 0; round < 20; ++round) {
    std::deque<image::Image> images;
    std::vector<const image::Image*> given;
    const int count = 1 + int(rng.below(30));
    for (int i = 0; i < count; ++i) {
      images.push_back(plain(1 + int(rng.below(90)), 1 + int(rng.below(90)), std::uint8_t(1 + i)));
      given.push_back(&images.back());
    }
    const auto atlas = packAtlas(given);
    REQUIRE(atlas);
    CHECK(atlas->pixels.width <= kAtlasSide);
    CHECK(atlas->pixels.height <= kAtlasSide);
    REQUIRE(atlas->places.size() == given.size());
    for (std::size_t i = 0; i < given.size(); ++i) {
      const auto [left, top, right, bottom] = pixelsOf(*atlas, atlas->places[i]);
      CHECK(right - left == given[i]->width);
      CHECK(bottom - top == given[i]->height);
      REQUIRE(left >= kAtlasPadding);
      REQUIRE(top >= kAtlasPadding);
      REQUIRE(right + kAtlasPadding <= atlas->pixels.width);
      REQUIRE(bottom + kAtlasPadding <= atlas->pixels.height);
      // Itself and its padding show its colour alone.
      int foreign = 0;
      for (long y = top - kAtlasPadding; y < bottom + kAtlasPadding; ++y) {
        for (long x = left - kAtlasPadding; x < right + kAtlasPadding; ++x) {
          foreign += atlas->pixels.pixels[4 * std::size_t(y * atlas->pixels.width + x)] == 1 + i ? 0 : 1;
        }
      }
      CHECK(foreign == 0);
    }
  }
}

TEST_CASE("what does not fit is shrunk alike until it does") {
  const image::Image a = plain(700, 500, 10), b = plain(350, 250, 20), c = plain(700, 900, 30);
  const std::array<const image::Image*, 3> given = {&a, &b, &c};
  const auto atlas = packAtlas(given, 512);
  REQUIRE(atlas);
  CHECK(atlas->pixels.width <= 512);
  CHECK(atlas->pixels.height <= 512);
  const auto widthOf = [&](std::size_t i) {
    const auto [left, top, right, bottom] = pixelsOf(*atlas, atlas->places[i]);
    return double(right - left);
  };
  CHECK(widthOf(0) == doctest::Approx(2 * widthOf(1)).epsilon(0.02));
  CHECK(widthOf(0) == doctest::Approx(widthOf(2)).epsilon(0.02));
  CHECK(widthOf(0) > 100);
}

TEST_CASE("the same picture lies in an atlas once") {
  const image::Image a = plain(100, 60, 1);
  const std::vector<const image::Image*> fifty(50, &a);
  const auto atlas = packAtlas(fifty);
  REQUIRE(atlas);
  CHECK(atlas->pixels.width * atlas->pixels.height < 2 * 110 * 70);
  for (const UvArea& place : atlas->places) CHECK(place == atlas->places[0]);
}

TEST_CASE("thousands of parts still share one atlas, and nothing makes none") {
  std::deque<image::Image> images;
  std::vector<const image::Image*> given;
  for (int i = 0; i < 3000; ++i) {
    images.push_back(plain(40, 40, std::uint8_t(i % 256)));
    given.push_back(&images.back());
  }
  const auto atlas = packAtlas(given, 1024);
  REQUIRE(atlas);
  CHECK(atlas->pixels.width <= 1024);
  CHECK(atlas->pixels.height <= 1024);
  CHECK_FALSE(packAtlas({}));
  const image::Image empty;
  const std::array<const image::Image*, 1> none = {&empty};
  CHECK_FALSE(packAtlas(none));
  CHECK_FALSE(packAtlas(given, 8));
}
