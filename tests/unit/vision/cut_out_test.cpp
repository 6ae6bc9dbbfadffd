#include "engine/vision/cut_out.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::vision;

namespace {

/// A soft-edged disc of one colour on noisy ground of another.
image::Picture discPicture(int width, int height, PicturePoint centre, double radius) {
  Rng rng(7);
  image::Picture picture;
  picture.width = width;
  picture.height = height;
  picture.working = {width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double in = std::clamp(radius - std::hypot(x - centre.x, y - centre.y) + 0.5, 0.0, 1.0);
      const double noise = rng.uniform(-12, 12);
      const auto mix = [&](double ground, double disc) {
        return static_cast<std::uint8_t>(std::clamp(ground + in * (disc - ground) + noise, 0.0, 255.0));
      };
      picture.working.pixels.insert(picture.working.pixels.end(),
                                    {mix(120, 220), mix(160, 90), mix(110, 60), std::uint8_t{255}});
    }
  }
  return picture;
}

double areaOf(std::span<const PicturePoint> outline) {
  double twice = 0;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    twice += cross(outline[j], outline[i]);
  }
  return std::abs(twice) / 2;
}

}  // namespace

TEST_CASE("a tap or a box cuts a disc out to a pixel of the copy, the same every time") {
  for (const int scale : {1, 3}) {
    const double r = 60.0 * scale;
    const PicturePoint centre{130.0 * scale, 100.0 * scale};
    const image::Picture picture = discPicture(280 * scale, 200 * scale, centre, r);
    CutHints tap, box;
    tap.inside = {{centre.x + r / 2, centre.y}};
    box.box = {{centre.x - 1.2 * r, centre.y - 1.2 * r}, {centre.x + 1.2 * r, centre.y + 1.2 * r}};
    for (const CutHints& hints : {tap, box}) {
      const auto found = cutOut(picture, hints);
      REQUIRE(found.ok());
      REQUIRE(found.value().size() == 1);
      CHECK(areaOf(found.value()[0]) == doctest::Approx(std::numbers::pi * r * r).epsilon(0.04));
      const double pixel = std::max(1.0, 280.0 * scale / kCutSide);
      for (const PicturePoint p : found.value()[0]) {
        CHECK(std::abs(distance(p, centre) - r) < 2.5 * pixel);
      }
      CHECK(cutOut(picture, hints).value() == found.value());
    }
  }
}

namespace {

bool holds(const CutContours& contours, PicturePoint p) {
  bool in = false;
  for (const auto& contour : contours) {
    if (geometry::holds(std::span<const PicturePoint>(contour), p)) in = !in;
  }
  return in;
}

}  // namespace

TEST_CASE("more marks never lose a marked pixel: what was marked stays as the last mark over it says") {
  const PicturePoint centre{130, 100};
  const image::Picture picture = discPicture(280, 200, centre, 60);
  for (const std::uint64_t seed : testing::seeds(0, 4)) {
    CAPTURE(seed);
    Rng rng(seed);
    CutHints hints;
    if (seed / 2 % 2) {  // even and odd seeds have both
      hints.inside = {centre};
    } else {
      hints.box = {{60, 30}, {200, 170}};
    }
    for (int k = 0; k < 6; ++k) {
      CutMark mark{{{rng.uniform(5, 275), rng.uniform(5, 195)}}, rng.uniform(0, 9), rng.uniform() < 0.5};
      for (int i = 0; i < 4; ++i) {
        mark.line.push_back(mark.line.back() + PicturePoint{rng.uniform(-12, 12), rng.uniform(-12, 12)});
      }
      for (PicturePoint& p : mark.line) p = {std::clamp(p.x, 4.0, 276.0), std::clamp(p.y, 4.0, 196.0)};
      hints.marks.push_back(mark);
      const auto found = cutOut(picture, hints);
      if (!found.ok()) {
        // Only when marks have taken everything away.
        CHECK(found.error() == Error::NothingCutOut);
        CHECK(std::ranges::none_of(hints.marks, &CutMark::inside));
        continue;
      }
      for (std::size_t m = 0; m < hints.marks.size(); ++m) {
        for (const PicturePoint p : hints.marks[m].line) {
          const bool later =
              std::any_of(hints.marks.begin() + std::ptrdiff_t(m) + 1, hints.marks.end(), [&](const CutMark& other) {
                for (std::size_t i = 0; i < other.line.size(); ++i) {
                  const PicturePoint a = other.line[i], b = other.line[i + 1 < other.line.size() ? i + 1 : i];
                  const PicturePoint ab = b - a;
                  const double t = dot(ab, ab) > 0 ? std::clamp(dot(p - a, ab) / dot(ab, ab), 0.0, 1.0) : 0.0;
                  if (distance(p, a + ab * t) < std::max(other.radius, 2.0) + 3) return true;
                }
                return false;
              });
          if (!later) CHECK(holds(found.value(), p) == hints.marks[m].inside);
        }
      }
    }
  }
}

TEST_CASE("a mark reaches beyond the box, and what is marked away in the middle becomes a hole") {
  const image::Picture picture = discPicture(280, 200, {130, 100}, 60);
  CutHints hints;
  hints.box = {{60, 30}, {170, 170}};  // the right end of the disc is beyond
  const auto half = cutOut(picture, hints);
  REQUIRE(half.ok());
  CHECK(areaOf(half.value()[0]) < 0.95 * std::numbers::pi * 3600);
  hints.marks.push_back({{{165, 80}, {180, 110}}, 4, true});
  const auto more = cutOut(picture, hints);
  REQUIRE(more.ok());
  CHECK(areaOf(more.value()[0]) > areaOf(half.value()[0]) + 100);
  hints.marks.push_back({{{100, 100}}, 3, false});
  const auto holed = cutOut(picture, hints);
  REQUIRE(holed.ok());
  CHECK(holed.value().size() >= 2);
  CHECK_FALSE(holds(holed.value(), {100, 100}));
}

TEST_CASE("rounds one by one are the cut as a whole") {
  const image::Picture picture = discPicture(280, 200, {130, 100}, 60);
  CutHints tap;
  tap.inside = {{130, 100}};
  auto search = CutOutSearch::begin(picture, tap);
  REQUIRE(search.ok());
  double before = -1;
  int rounds = 0;
  do {
    CHECK(search.value().done() > before);
    before = search.value().done();
    ++rounds;
  } while (search.value().step());
  CHECK(rounds > 1);
  CHECK(search.value().done() == 1);
  CHECK_FALSE(search.value().step());
  CHECK(search.value().outlines().value() == cutOut(picture, tap).value());
}

TEST_CASE("a plain picture, no hint and hints beside the picture are refused") {
  image::Picture plain = discPicture(100, 80, {50, 40}, 0);
  for (std::uint8_t& v : plain.working.pixels) v = 255;
  CutHints tap;
  tap.inside = {{50, 40}};
  CHECK(cutOut(plain, tap).error() == Error::NothingCutOut);
  CHECK(cutOut(plain, {}).error() == Error::ValueOutOfRange);
  tap.inside = {{500, 40}};
  CHECK(cutOut(plain, tap).error() == Error::ValueOutOfRange);
  tap.inside = {{std::nan(""), 40}};
  CHECK(cutOut(plain, tap).error() == Error::ValueOutOfRange);
  CHECK(cutOut(image::Picture{}, tap).error() == Error::PictureEmpty);
}
