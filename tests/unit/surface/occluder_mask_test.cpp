#include "engine/surface/occluder_mask.h"

#include <doctest/doctest.h>

#include <array>
#include <cmath>
#include <functional>

#include "engine/surface/edge_padding.h"
#include "tests/unit/surface/canvas.h"

using namespace spineloft;
using namespace spineloft::surface;

namespace {

constexpr Canvas kCanvas{160, 100};
constexpr Rgb kGround{60, 70, 200}, kThing{60, 150, 50}, kThumb{220, 160, 130}, kNail{250, 215, 205};

bool isThing(int x, int y) { return x >= 20 && x < 140 && y >= 30 && y < 60; }
/// From below, up to the middle of the thing and a little further.
bool isThumb(int x, int y) { return y >= 40 && std::abs(x - 80) < 12; }
/// Wider than the gaps that are closed.
bool isNail(int x, int y) { return std::hypot(x - 80, y - 49) < 8; }

/// What is found where the thing's lower outline could not be seen for x from 66 to 94.
image::Mask found(const image::Image& shown) {
  const auto beside = [](int x) { return x >= 66 && x < 94; };
  const image::Mask covered = kCanvas.mask(isThing), own = inset(covered, 2);
  const image::Mask outside = kCanvas.mask([&](int x, int y) { return beside(x) && y >= 60 && y < 70; });
  const image::Mask threshold = kCanvas.mask([&](int x, int y) { return beside(x) && y >= 57 && y < 60; });
  const image::Mask reach = kCanvas.mask([](int x, int y) { return x >= 46 && x < 114 && y >= 30 && y < 60; });
  return occluderMask({shown, covered, own, outside, threshold, reach});
}

}  // namespace

TEST_CASE("a thumb that comes in over an outline is found, to its nail, and nothing of the thing with it") {
  const image::Mask is = found(kCanvas.picture([](int x, int y) {
    if (isThumb(x, y)) return isNail(x, y) ? kNail : kThumb;
    return isThing(x, y) ? kThing : kGround;
  }));
  REQUIRE(!is.pixels.empty());
  for (int y = 30; y < 60; ++y) {
    for (int x = 20; x < 140; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      REQUIRE((is.pixels[kCanvas.at(x, y)] != 0) == isThumb(x, y));
    }
  }
}

TEST_CASE("where nothing crosses there is no intruder, whatever the thing shows there") {
  const auto plain = [](int x, int y) { return isThing(x, y) ? kThing : kGround; };
  CHECK(found(kCanvas.picture(plain)).pixels.empty());
  SUBCASE("a label of the ground's colour that reaches the outline") {
    CHECK(found(kCanvas.picture([&](int x, int y) { return isThumb(x, y) ? kGround : plain(x, y); })).pixels.empty());
  }
  SUBCASE("a label of a colour of its own that reaches the outline") {
    CHECK(found(kCanvas.picture([&](int x, int y) {
            return isThumb(x, y) && isThing(x, y) ? kThumb : plain(x, y);
          })).pixels.empty());
  }
  SUBCASE("something beside it that ends at the outline") {
    CHECK(found(kCanvas.picture([&](int x, int y) {
            return isThumb(x, y) && !isThing(x, y) ? kThumb : plain(x, y);
          })).pixels.empty());
  }
}

TEST_CASE("what has the thing's own colours, or would hide most of it, is not taken for an intruder") {
  CHECK(found(kCanvas.picture([](int x, int y) {
          return isThumb(x, y) || isThing(x, y) ? kThing : kGround;
        })).pixels.empty());
  const auto isWall = [](int x, int y) { return y >= 31 && std::abs(x - 80) < 34; };
  CHECK(found(kCanvas.picture([&](int x, int y) {
          return isWall(x, y) ? kThumb : isThing(x, y) ? kThing : kGround;
        })).pixels.empty());
  // A ring of the thumb's colour elsewhere on the thing, or a few specks: then a thumb may as well be paint.
  const auto isRing = [](int x, int y) { return isThing(x, y) && x >= 24 && x < 40; };
  const auto isSpeck = [](int x, int y) { return x % 8 == 0 && y % 8 == 0; };
  CHECK(found(kCanvas.picture([&](int x, int y) {
          return isThumb(x, y) || isRing(x, y) ? kThumb : isThing(x, y) ? kThing : kGround;
        })).pixels.empty());
  CHECK(found(kCanvas.picture([&](int x, int y) {
          return isThumb(x, y) || (isThing(x, y) && isSpeck(x, y)) ? kThumb : isThing(x, y) ? kThing : kGround;
        })).pixels.empty());
}
