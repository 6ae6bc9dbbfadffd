#include "engine/surface/intruder.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>

#include "engine/base/rng.h"
#include "engine/surface/bleed.h"

using namespace spineloft;
using namespace spineloft::surface;

namespace {

constexpr int kWidth = 160, kHeight = 100;
using Rgb = std::array<int, 3>;
constexpr Rgb kGround{60, 70, 200}, kThing{60, 150, 50}, kThumb{220, 160, 130}, kNail{250, 215, 205};

std::size_t at(int x, int y) { return std::size_t(y) * kWidth + std::size_t(x); }

/// With the noise of a camera.
image::Image picture(const std::function<Rgb(int x, int y)>& colour) {
  Rng rng(7);
  image::Image out{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      for (const int c : colour(x, y)) out.pixels.push_back(std::uint8_t(c + int(8 * rng.uniform()) - 4));
      out.pixels.push_back(255);
    }
  }
  return out;
}

image::Mask mask(const std::function<bool(int x, int y)>& inside) {
  image::Mask out{kWidth, kHeight, {}};
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) out.pixels.push_back(inside(x, y) ? 255 : 0);
  }
  return out;
}

bool isThing(int x, int y) { return x >= 20 && x < 140 && y >= 30 && y < 60; }
/// From below, up to the middle of the thing and a little further.
bool isThumb(int x, int y) { return y >= 40 && std::abs(x - 80) < 12; }
/// Wider than the gaps that are closed.
bool isNail(int x, int y) { return std::hypot(x - 80, y - 49) < 8; }

/// What is found where the thing's lower outline could not be seen for x from 66 to 94.
image::Mask found(const image::Image& shown) {
  const auto beside = [](int x) { return x >= 66 && x < 94; };
  const image::Mask covered = mask(isThing), own = inset(covered, 2);
  const image::Mask outside = mask([&](int x, int y) { return beside(x) && y >= 60 && y < 70; });
  const image::Mask threshold = mask([&](int x, int y) { return beside(x) && y >= 57 && y < 60; });
  const image::Mask reach = mask([](int x, int y) { return x >= 46 && x < 114 && y >= 30 && y < 60; });
  return intruder({shown, covered, own, outside, threshold, reach});
}

}  // namespace

TEST_CASE("a thumb that comes in over an outline is found, to its nail, and nothing of the thing with it") {
  const image::Mask is = found(picture([](int x, int y) {
    if (isThumb(x, y)) return isNail(x, y) ? kNail : kThumb;
    return isThing(x, y) ? kThing : kGround;
  }));
  REQUIRE(!is.pixels.empty());
  for (int y = 30; y < 60; ++y) {
    for (int x = 20; x < 140; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      REQUIRE((is.pixels[at(x, y)] != 0) == isThumb(x, y));
    }
  }
}

TEST_CASE("where nothing crosses there is no intruder, whatever the thing shows there") {
  const auto plain = [](int x, int y) { return isThing(x, y) ? kThing : kGround; };
  CHECK(found(picture(plain)).pixels.empty());
  SUBCASE("a label of the ground's colour that reaches the outline") {
    CHECK(found(picture([&](int x, int y) { return isThumb(x, y) ? kGround : plain(x, y); })).pixels.empty());
  }
  SUBCASE("a label of a colour of its own that reaches the outline") {
    CHECK(found(picture([&](int x, int y) { return isThumb(x, y) && isThing(x, y) ? kThumb : plain(x, y); })).pixels.empty());
  }
  SUBCASE("something beside it that ends at the outline") {
    CHECK(found(picture([&](int x, int y) { return isThumb(x, y) && !isThing(x, y) ? kThumb : plain(x, y); })).pixels.empty());
  }
}

TEST_CASE("what has the thing's own colours, or would hide most of it, is not taken for an intruder") {
  CHECK(found(picture([](int x, int y) { return isThumb(x, y) || isThing(x, y) ? kThing : kGround; })).pixels.empty());
  const auto isWall = [](int x, int y) { return y >= 31 && std::abs(x - 80) < 34; };
  CHECK(found(picture([&](int x, int y) { return isWall(x, y) ? kThumb : isThing(x, y) ? kThing : kGround; })).pixels.empty());
  // A ring of the thumb's colour elsewhere on the thing, or a few specks: then a thumb may as well be paint.
  const auto isRing = [](int x, int y) { return isThing(x, y) && x >= 24 && x < 40; };
  const auto isSpeck = [](int x, int y) { return x % 8 == 0 && y % 8 == 0; };
  CHECK(found(picture([&](int x, int y) { return isThumb(x, y) || isRing(x, y) ? kThumb : isThing(x, y) ? kThing : kGround; })).pixels.empty());
  CHECK(found(picture([&](int x, int y) {
    return isThumb(x, y) || (isThing(x, y) && isSpeck(x, y)) ? kThumb : isThing(x, y) ? kThing : kGround;
  })).pixels.empty());
}
