#include "engine/surface/edge_padding.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::surface;

namespace {

std::size_t at(int width, int x, int y) { return std::size_t(y) * std::size_t(width) + std::size_t(x); }

image::Image noise(Rng& rng, int width, int height) {
  image::Image out{width, height, {}};
  for (int i = 0; i < width * height; ++i) {
    for (int c = 0; c < 3; ++c) out.pixels.push_back(std::uint8_t(rng.below(256)));
    out.pixels.push_back(255);
  }
  return out;
}

image::Mask maskOf(int width, int height, auto inside) {
  image::Mask mask{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) mask.pixels.push_back(inside(x, y) ? 255 : 0);
  }
  return mask;
}

}  // namespace

TEST_CASE("bleeding leaves what is known as it is and invents no colour") {
  Rng rng(7);
  for (int round = 0; round < 30; ++round) {
    const int width = 1 + int(rng.below(40)), height = 1 + int(rng.below(40));
    image::Image picture = noise(rng, width, height);
    image::Mask known = maskOf(width, height, [&](int, int) { return rng.below(6) == 0; });
    known.pixels[rng.below(std::uint32_t(known.pixels.size()))] = 255;
    const image::Image filled = padEdges(picture, known);
    REQUIRE(filled.pixels.size() == picture.pixels.size());
    int low[3] = {255, 255, 255}, high[3] = {0, 0, 0};
    for (std::size_t i = 0; i < known.pixels.size(); ++i) {
      if (known.pixels[i] == 0) continue;
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(filled.pixels[4 * i + c] == picture.pixels[4 * i + c]);
        low[c] = std::min<int>(low[c], picture.pixels[4 * i + c]);
        high[c] = std::max<int>(high[c], picture.pixels[4 * i + c]);
      }
    }
    for (std::size_t i = 0; i < known.pixels.size(); ++i) {
      CHECK(filled.pixels[4 * i + 3] == 255);
      for (std::size_t c = 0; c < 3; ++c) {
        CHECK(filled.pixels[4 * i + c] >= low[c] - 1);
        CHECK(filled.pixels[4 * i + c] <= high[c] + 1);
      }
    }
  }
}

TEST_CASE("one colour bleeds as that colour, whatever the unknown pixels say") {
  Rng rng(8);
  image::Image picture = noise(rng, 61, 47);
  const image::Mask known = maskOf(61, 47, [](int x, int y) { return x > 20 && x < 30 && y > 9 && y < 14; });
  for (std::size_t i = 0; i < known.pixels.size(); ++i) {
    if (known.pixels[i] == 0) continue;
    picture.pixels[4 * i] = 200, picture.pixels[4 * i + 1] = 30, picture.pixels[4 * i + 2] = 7;
  }
  const image::Image filled = padEdges(picture, known);
  for (std::size_t i = 0; i < known.pixels.size(); ++i) {
    CHECK(filled.pixels[4 * i] == 200);
    CHECK(filled.pixels[4 * i + 1] == 30);
    CHECK(filled.pixels[4 * i + 2] == 7);
  }
}

TEST_CASE("transparent pixels count as unknown, and with nothing known there is no picture") {
  image::Image picture{2, 1, {10, 20, 30, 255, 200, 200, 200, 0}};
  const image::Mask both{2, 1, {255, 255}}, none{2, 1, {0, 0}}, other{1, 1, {255}};
  CHECK(padEdges(picture, both).pixels == std::vector<std::uint8_t>{10, 20, 30, 255, 10, 20, 30, 255});
  CHECK(padEdges(picture, none).empty());
  CHECK(padEdges(picture, other).empty());
  CHECK(padEdges({}, {}).empty());
}

TEST_CASE("what is inset is without all that is nearer to the outside, whatever the margin") {
  Rng rng(12);
  for (const double margin : {1.0, 4.0 / 3, 2.0, 3.4, 6.0, 7.0, 9.0}) {
    CAPTURE(margin);
    const int width = 12 + int(rng.below(30)), height = 5 + int(rng.below(30)), units = int(std::lround(3 * margin));
    const image::Mask mask = maskOf(width, height, [&](int, int) { return rng.below(60) != 0; });
    const image::Mask found = inset(mask, margin);
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        int nearest = 1 << 20;  // units, straight steps 3 and slanted ones 4
        for (int oy = 0; oy < height; ++oy) {
          for (int ox = 0; ox < width; ++ox) {
            if (mask.pixels[at(width, ox, oy)] != 0) continue;
            const int dx = std::abs(ox - x), dy = std::abs(oy - y);
            nearest = std::min(nearest, 3 * std::max(dx, dy) + std::min(dx, dy));
          }
        }
        REQUIRE((found.pixels[at(width, x, y)] != 0) == (nearest > units));
      }
    }
  }
}

TEST_CASE("trusted pixels keep their distance from the outline where the thing is wide enough") {
  const double radius = 20, margin = 3;
  const auto inside = [&](int x, int y) { return std::hypot(x - 32, y - 32) < radius; };
  const image::Mask mask = trusted(maskOf(65, 65, inside), margin);
  CHECK(inset(maskOf(65, 65, inside), margin) == mask);
  for (int y = 0; y < 65; ++y) {
    for (int x = 0; x < 65; ++x) {
      const double depth = radius - std::hypot(x - 32, y - 32);
      if (depth < margin - 0.5) CHECK(mask.pixels[at(65, x, y)] == 0);
      if (depth > margin + 1.5) CHECK(mask.pixels[at(65, x, y)] == 255);
    }
  }
}

TEST_CASE("no piece loses all of its trusted pixels, however thin") {
  for (int thick = 1; thick < 12; ++thick) {
    const image::Mask bar = maskOf(80, 30, [&](int x, int y) { return x > 5 && x < 74 && y >= 9 && y < 9 + thick; });
    const image::Mask mask = trusted(bar, 4);
    for (int x = 12; x < 68; ++x) {
      int left = 0;
      for (int y = 0; y < 30; ++y) left += mask.pixels[at(80, x, y)] != 0 ? 1 : 0;
      CHECK(left > 0);
      if (thick >= 3) CHECK(left < thick);
    }
  }
}

TEST_CASE("a picture's own border is no outline") {
  const image::Mask all{9, 5, std::vector<std::uint8_t>(45, 255)};
  CHECK(trusted(all, 3) == all);
  CHECK(inset(all, 3) == all);
}
