#include "engine/surface/alpha_matting.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "engine/surface/edge_padding.h"
#include "tests/unit/surface/canvas.h"

using namespace spineloft;
using namespace spineloft::surface;

namespace {

constexpr Canvas kCanvas{160, 100};
constexpr double kMargin = 2, kReach = 10;
constexpr Rgb kGround{90, 180, 40}, kDark{20, 20, 20}, kLight{210, 210, 210};

bool isThing(int x, int y) { return x >= 20 && x < 140 && y >= 25 && y < 75; }
/// Grey, across its rings.
Rgb ringed(int x, int) { return x / 12 % 2 == 0 ? kDark : kLight; }

/// The thing, its upper and lower outlines mixed with the ground over so many pixels.
image::Image thing(double upper, double lower, const std::function<Rgb(int x, int y)>& own) {
  return kCanvas.picture([&](int x, int y) {
    if (x < 20 || x >= 140) return kGround;
    const double above = std::clamp((24.5 - y) / upper + 0.5, 0.0, 1.0),
                 below = std::clamp((y - 74.5) / lower + 0.5, 0.0, 1.0);
    Rgb out{};
    for (std::size_t c = 0; c < 3; ++c)
      out[c] = int(std::lround(own(x, y)[c] + (above + below) * (kGround[c] - own(x, y)[c])));
    return out;
  });
}

/// How green a pixel is; the thing is not.
int green(const image::Image& image, std::size_t i) {
  const std::uint8_t* p = &image.pixels[4 * i];
  return p[1] - std::max(p[0], p[2]);
}

}  // namespace

TEST_CASE("out of a soft rim the ground is taken, and its rings stay") {
  const image::Image before = thing(12, 12, ringed);
  image::Image shown = before;
  const image::Mask region = kCanvas.mask(isThing);
  image::Mask inner = trusted(region, kMargin);
  REQUIRE(RimUnmixing(shown, region, inner, kMargin, kReach).change());
  int greenBefore = 0, greenAfter = 0, believed = 0;
  double off = 0;
  for (int x = 32; x < 128; ++x) {
    for (int y = 25; y < 75; ++y) {
      const std::size_t i = kCanvas.at(x, y);
      if (x % 12 < 2 || x % 12 > 9) continue;  // between two rings
      greenBefore += green(before, i) > 16 ? 1 : 0;
      if (inner.pixels[i] == 0) continue;
      ++believed;
      greenAfter += green(shown, i) > 16 ? 1 : 0;
      off += std::abs(shown.pixels[4 * i] - ringed(x, y)[0]);
    }
  }
  CHECK(greenBefore > 300);
  CHECK(greenAfter < greenBefore / 10);
  CHECK(believed > 96 * 8 / 12 * 40);
  CHECK(off / believed < 8);
}

TEST_CASE("a crisp rim stays as it is, to the bit, also where the thing is shaded towards it") {
  const auto shaded = [](int x, int y) {
    const double depth = std::min({x - 20, 139 - x, y - 25, 74 - y}), light = std::clamp(0.55 + 0.04 * depth, 0.0, 1.0);
    return Rgb{int(220 * light), int(120 * light), int(60 * light)};
  };
  for (const bool rings : {true, false}) {
    const image::Image before = rings ? thing(1.5, 1.5, ringed) : thing(1.5, 1.5, shaded);
    image::Image shown = before;
    const image::Mask region = kCanvas.mask(isThing);
    image::Mask inner = trusted(region, kMargin);
    const image::Mask innerBefore = inner;
    CHECK_FALSE(RimUnmixing(shown, region, inner, kMargin, kReach).change());
    CHECK(shown == before);
    CHECK(inner == innerBefore);
  }
}

TEST_CASE(
    "of a crisp rim hardly a pixel is trusted into which the ground is mixed, also where the outline is a little off, "
    "and all further in are") {
  constexpr int kOff = 2, kDeepest = 2 * int(kMargin) + 1;
  for (const bool rings : {true, false}) {
    const std::function<Rgb(int, int)> plain = [](int, int) { return kLight; };
    const image::Image before = thing(4, 4, rings ? std::function<Rgb(int, int)>(ringed) : plain);
    image::Image shown = before;
    const image::Mask region =
        kCanvas.mask([](int x, int y) { return x >= 20 && x < 140 && y >= 25 - kOff && y < 75 + kOff; });
    image::Mask inner = trusted(region, kMargin);
    const image::Mask innerBefore = inner;
    REQUIRE(RimUnmixing(shown, region, inner, kMargin, kReach).change());
    CHECK(shown == before);
    int greenBefore = 0, greenAfter = 0, lost = 0;
    for (int x = 32; x < 128; ++x) {
      for (int y = 0; y < kCanvas.height; ++y) {
        const std::size_t i = kCanvas.at(x, y);
        if (x % 12 < 2 || x % 12 > 9) continue;  // between two rings
        greenBefore += innerBefore.pixels[i] != 0 && green(before, i) > 16 ? 1 : 0;
        greenAfter += inner.pixels[i] != 0 && green(before, i) > 16 ? 1 : 0;
        const int depth = std::min(y - 25 + kOff, 74 + kOff - y);
        lost += depth >= kDeepest && inner.pixels[i] == 0 ? 1 : 0;
      }
    }
    CHECK(greenBefore > 100);
    CHECK(greenAfter < greenBefore / 20);
    CHECK(lost == 0);
  }
}

TEST_CASE("where one side of a thing is soft the other keeps its pixels") {
  const image::Image before = thing(12, 1.5, ringed);
  image::Image shown = before;
  const image::Mask region = kCanvas.mask(isThing);
  image::Mask inner = trusted(region, kMargin);
  REQUIRE(RimUnmixing(shown, region, inner, kMargin, kReach).change());
  const auto middle = std::ptrdiff_t(4 * kCanvas.at(0, 50));
  CHECK_FALSE(std::equal(shown.pixels.begin(), shown.pixels.begin() + middle, before.pixels.begin()));
  CHECK(std::equal(shown.pixels.begin() + middle, shown.pixels.end(), before.pixels.begin() + middle));
}

TEST_CASE("where the ground looks like the thing, or there is none, nothing is unmixed") {
  image::Image shown = kCanvas.picture([](int x, int y) { return isThing(x, y) ? Rgb{100, 160, 50} : kGround; });
  const image::Image before = shown;
  const image::Mask region = kCanvas.mask(isThing), all = kCanvas.mask([](int, int) { return true; });
  image::Mask inner = trusted(region, kMargin);
  CHECK_FALSE(RimUnmixing(shown, region, inner, kMargin, kReach).change());
  inner = all;
  CHECK_FALSE(RimUnmixing(shown, all, inner, kMargin, kReach).change());
  image::Mask none = kCanvas.mask([](int, int) { return false; });
  CHECK_FALSE(RimUnmixing(shown, none, none, kMargin, kReach).change());
  CHECK(shown == before);
}

TEST_CASE("a line that the outline follows between two like colours is the part's, and nothing there is ground") {
  constexpr Rgb kPaper{250, 250, 250}, kInk{30, 30, 30}, kSky{120, 170, 250};
  const image::Mask region = kCanvas.mask(isThing);
  // Drawn on paper, six pixels wide with the outline in its middle; to the right the paper ends.
  const auto isLine = [](int x, int y) {
    const int out = std::max({20 - x, x - 139, 25 - y, y - 74});
    return out >= -2 && out <= 3;
  };
  for (const bool whole : {true, false}) {
    CAPTURE(whole);
    image::Image shown = kCanvas.picture([&](int x, int y) {
      return isLine(x, y) ? kInk : whole || x < 80 || isThing(x, y) ? kPaper : kSky;
    });
    image::Mask inner = trusted(region, kMargin);
    RimUnmixing unmixing(shown, region, inner, kMargin, kReach);
    unmixing.change();
    const Untold untold = unmixing.untold();
    for (int y = 25; y < 75; ++y) {
      for (int x = 20; x < 140; ++x) {
        const std::size_t i = kCanvas.at(x, y);
        if (!whole && x > 50 && x < 110) continue;  // one goes over into the other
        const bool onPaper = whole || x <= 50, rim = isLine(x, y);
        if (rim) CHECK((untold.alike.pixels[i] != 0) == onPaper);
        CHECK((untold.drawn.pixels[i] != 0) == (rim && onPaper));
      }
    }
  }
}
