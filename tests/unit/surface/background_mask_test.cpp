#include "engine/surface/background_mask.h"

#include <doctest/doctest.h>

#include <array>
#include <cstdlib>
#include <functional>

#include "engine/surface/edge_padding.h"
#include "engine/surface/palette.h"
#include "tests/unit/surface/canvas.h"

using namespace spineloft;
using namespace spineloft::surface;

namespace {

constexpr Canvas kCanvas{140, 90};
constexpr Rgb kGround{60, 70, 200}, kThing{200, 60, 50}, kLabel{230, 220, 90};

bool isCovered(int x, int y) { return x >= 30 && x < 110 && y >= 30 && y < 60; }
bool isSure(int x, int y) { return isCovered(x, y) && x < 70; }

/// Which covered pixels are believed.
image::Mask judged(const image::Image& shown, const std::function<bool(int x, int y)>& sureAt) {
  const image::Mask covered = kCanvas.mask(isCovered), sure = kCanvas.mask(sureAt), own = inset(sure, 2);
  const ColourPyramid in(shown, own);
  REQUIRE(!in.empty());
  return ownPixels({shown, covered, sure, own, in}, clearanceOf(meanDepth(covered)));
}

}  // namespace

TEST_CASE("ground that goes on within an outline is foreign, the thing itself is not") {
  const auto isThing = [](int x, int y) { return isCovered(x, y) && x < 96; };
  const auto shown = kCanvas.picture([&](int x, int y) { return isThing(x, y) ? kThing : kGround; });
  const image::Mask found = judged(shown, isSure);
  for (int y = 30; y < 60; ++y) {
    for (int x = 30; x < 110; ++x) {
      CAPTURE(x);
      CAPTURE(y);
      REQUIRE((found.pixels[kCanvas.at(x, y)] != 0) == isThing(x, y));
    }
  }
}

TEST_CASE("where a part is sure nothing is foreign") {
  const auto shown = kCanvas.picture([&](int x, int y) { return isCovered(x, y) && x < 96 ? kThing : kGround; });
  const image::Mask found = judged(shown, isCovered);
  for (int y = 30; y < 60; ++y) {
    for (int x = 30; x < 110; ++x) REQUIRE(found.pixels[kCanvas.at(x, y)] != 0);
  }
}

TEST_CASE("what stands before a part and reaches beyond it is foreign") {
  const auto isPost = [](int x, int y) { return x >= 80 && x < 92 && y >= 45; };
  const auto shown = kCanvas.picture([&](int x, int y) {
    return isPost(x, y) ? kLabel : isCovered(x, y) ? kThing : kGround;
  });
  const image::Mask found = judged(shown, isSure);
  for (int y = 30; y < 60; ++y) {
    for (int x = 30; x < 110; ++x) REQUIRE((found.pixels[kCanvas.at(x, y)] != 0) == !isPost(x, y));
  }
}

TEST_CASE("a label, a spot and an end of another colour are the part's, ground or not") {
  // The end has a colour of its own; within the thing there is a spot that looks like the ground.
  const auto shown = kCanvas.picture([&](int x, int y) {
    if (!isCovered(x, y)) return kGround;
    if (std::abs(x - 85) < 5 && std::abs(y - 45) < 5) return kGround;
    return x >= 98 ? kLabel : kThing;
  });
  const image::Mask found = judged(shown, isSure);
  for (int y = 30; y < 60; ++y) {
    for (int x = 30; x < 110; ++x) REQUIRE(found.pixels[kCanvas.at(x, y)] != 0);
  }
}

TEST_CASE("a rim pixel is kept when little of what is behind is mixed into it") {
  // The left half is the thing, the right half the ground; between them a column of every mixture.
  const auto mixed = [](const Rgb& a, const Rgb& b, int y) {
    Rgb out{};
    for (std::size_t c = 0; c < 3; ++c) out[c] = a[c] + (b[c] - a[c]) * y / kCanvas.height;
    return out;
  };
  image::Image shown{kCanvas.width, kCanvas.height, {}};
  for (int y = 0; y < kCanvas.height; ++y) {
    for (int x = 0; x < kCanvas.width; ++x) {
      for (const int c : x < 70 ? kThing : x > 70 ? kGround : mixed(kThing, kGround, y))
        shown.pixels.push_back(std::uint8_t(c));
      shown.pixels.push_back(255);
    }
  }
  const image::Mask kept = kCanvas.mask([](int x, int) { return x < 70; }),
                    behind = kCanvas.mask([](int x, int) { return x > 70; });
  const image::Mask rim = kCanvas.mask([](int x, int) { return x <= 70; });
  const ColourPyramid in(shown, kept), out(shown, behind);
  const image::Mask clean = withCleanRim(shown, kept, rim, in, out);
  for (int y = 0; y < kCanvas.height; ++y) {
    const double share = double(y) / kCanvas.height;
    CAPTURE(share);
    if (share < 0.05) CHECK(clean.pixels[kCanvas.at(70, y)] != 0);
    if (share > 0.09) CHECK(clean.pixels[kCanvas.at(70, y)] == 0);
    CHECK(clean.pixels[kCanvas.at(69, y)] != 0);
    CHECK(clean.pixels[kCanvas.at(71, y)] == 0);
  }
  // Where both look alike it does not matter, and all of the rim is kept.
  const ColourPyramid same(shown, kept);
  CHECK(withCleanRim(shown, kept, rim, in, same) == rim);
}

TEST_CASE("a palette's shares are those of the colours that it was given") {
  Palette palette;
  const std::array<std::uint8_t, 4> red{200, 20, 20, 255}, blue{20, 20, 200, 255}, green{20, 200, 20, 255};
  CHECK(palette.share(red.data()) == 0);
  for (int i = 0; i < 300; ++i) palette.add(i % 3 == 0 ? blue.data() : red.data());
  palette.close();
  CHECK(palette.share(red.data()) == doctest::Approx(2 * palette.share(blue.data())));
  CHECK(palette.share(red.data()) > 0.05);
  CHECK(palette.share(green.data()) == 0);
  // The next shade counts too, but less.
  const std::array<std::uint8_t, 4> shade{208, 20, 20, 255};
  CHECK(palette.share(shade.data()) > 0);
  CHECK(palette.share(shade.data()) < palette.share(red.data()));
}

TEST_CASE("the mean depth of a band is a quarter of its width") {
  for (const int width : {8, 20, 60}) {
    const image::Mask band = kCanvas.mask([&](int, int y) { return y >= 10 && y < 10 + width; });
    CHECK(meanDepth(band) == doctest::Approx(width / 4.0).epsilon(0.2));
  }
  CHECK(meanDepth(kCanvas.mask([](int, int) { return false; })) == 0);
}
