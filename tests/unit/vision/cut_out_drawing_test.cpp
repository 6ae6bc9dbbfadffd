// Cutting things out of line drawings: the thing has the colour of its paper, and a line says where it ends.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "engine/image/sketch.h"
#include "engine/io/picture_file.h"
#include "engine/vision/cut_out.h"
#include "tests/support/test_files.h"

using namespace spineloft;
using namespace spineloft::vision;

namespace {

constexpr image::Size kSheet{900, 700};

/// Part of a ring, in turns.
std::vector<PicturePoint> ring(PicturePoint centre, double radius, double from = 0, double to = 1) {
  std::vector<PicturePoint> out;
  for (int i = 0; i <= 90; ++i) {
    const double angle = 2 * std::numbers::pi * (from + (to - from) * i / 90);
    out.push_back(centre + PicturePoint{radius * std::cos(angle), radius * std::sin(angle)});
  }
  return out;
}

image::Picture drawn(const std::vector<std::vector<PicturePoint>>& lines, double pen) {
  std::vector<Box<image::SketchStroke>> strokes;
  for (const auto& line : lines) {
    image::SketchStroke stroke;
    stroke.points = line;
    stroke.radius = pen;
    strokes.emplace_back(stroke);
  }
  return image::drawSketch(kSheet, strokes).value();
}

/// As a camera sees it: light falls off to one corner, and there is grain.
image::Picture photographed(image::Picture picture) {
  Rng rng(5);
  auto& pixels = picture.working.pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const std::size_t pixel = i / 4, width = static_cast<std::size_t>(kSheet.width);
    const double light =
        0.92 - 0.0003 * static_cast<double>(pixel % width) - 0.0002 * static_cast<double>(pixel / width);
    pixels[i] = static_cast<std::uint8_t>(std::clamp(light * pixels[i] + rng.uniform(-10, 10), 0.0, 255.0));
  }
  return picture;
}

double areaOf(const std::vector<PicturePoint>& outline) {
  double twice = 0;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) twice += cross(outline[j], outline[i]);
  return std::abs(twice) / 2;
}

Result<CutContours> tapped(const image::Picture& picture, PicturePoint at) {
  CutHints tap;
  tap.inside = {at};
  return cutOut(picture, tap);
}

constexpr PicturePoint kMiddle{420, 340};

}  // namespace

TEST_CASE("a tap in a closed line gives what the middle of the line surrounds, with thin and thick pens and gaps" *
          doctest::test_suite("slow")) {
  for (const double pen : {1.5, 4.0, 12.0}) {
    for (const double gap : {0.0, 0.02, 0.06}) {  // of the way round; the last one is a fifth of the width
      for (const bool photo : {false, true}) {
        CAPTURE(pen);
        CAPTURE(gap);
        CAPTURE(photo);
        image::Picture picture = drawn({ring(kMiddle, 200, gap, 1)}, pen);
        if (photo) picture = photographed(std::move(picture));
        const auto middle = tapped(picture, kMiddle);
        REQUIRE(middle.ok());
        REQUIRE(middle.value().size() == 1);
        CHECK(areaOf(middle.value()[0]) == doctest::Approx(std::numbers::pi * 200 * 200).epsilon(0.03));
        for (const PicturePoint p : middle.value()[0]) CHECK(std::abs(distance(p, kMiddle) - 200) < 5 + 250 * gap);
        // Wherever inside it is tapped.
        CHECK(tapped(picture, kMiddle + PicturePoint{-130, 100}).value() == middle.value());
        CHECK(tapped(picture, kMiddle + PicturePoint{0, -175}).value() == middle.value());
        CHECK(tapped(picture, kMiddle + PicturePoint{-200, 0}).value() == middle.value());  // the line itself
      }
    }
  }
}

TEST_CASE("what is drawn within a closed line belongs to it, and a line that runs past it does not") {
  const std::vector<PicturePoint> body = ring(kMiddle, 200), eye = ring({480, 250}, 22),
                                  wing = ring({400, 370}, 90, 0.1, 0.9);
  const std::vector<PicturePoint> across{{420, 140}, {430, 350}, {420, 540}};
  const auto plain = tapped(drawn({body}, 4), kMiddle);
  REQUIRE(plain.ok());
  const double area = areaOf(plain.value()[0]);
  for (const PicturePoint at : {kMiddle, PicturePoint{480, 250}, PicturePoint{400, 370}, PicturePoint{280, 300}}) {
    const auto bird = tapped(drawn({body, eye, wing, across}, 4), at);
    REQUIRE(bird.ok());
    REQUIRE(bird.value().size() == 1);
    CHECK(areaOf(bird.value()[0]) == doctest::Approx(area).epsilon(0.005));
  }
  const auto past = tapped(drawn({body, {{420, 141}, {480, 130}, {560, 60}}}, 4), kMiddle);
  REQUIRE(past.ok());
  CHECK(areaOf(past.value()[0]) == doctest::Approx(area).epsilon(0.005));
}

TEST_CASE("a tap on paper beside every line is refused, and one in an open bay") {
  const auto circle = drawn({ring(kMiddle, 200)}, 4);
  for (const PicturePoint at : {PicturePoint{60, 60}, PicturePoint{640, 600}, PicturePoint{830, 340}}) {
    CHECK(tapped(circle, at).error() == Error::NothingCutOut);
  }
  const auto bay = drawn({ring(kMiddle, 200, 0, 0.6), ring({100, 100}, 40)}, 4);
  CHECK(tapped(bay, kMiddle).error() == Error::NothingCutOut);
}

TEST_CASE("of several things a tap gives one, a scribble those it goes through, a box those within it") {
  const PicturePoint left{220, 300}, right{640, 300};
  const auto picture = drawn({ring(left, 120), ring(right, 150)}, 3);
  CHECK(areaOf(tapped(picture, left).value()[0]) == doctest::Approx(std::numbers::pi * 120 * 120).epsilon(0.03));
  CHECK(areaOf(tapped(picture, right).value()[0]) == doctest::Approx(std::numbers::pi * 150 * 150).epsilon(0.03));
  CutHints both, box, marked;
  both.inside = {left, right};
  CHECK(cutOut(picture, both).value().size() == 2);
  box.box = {{450, 100}, {850, 500}};
  const auto boxed = cutOut(picture, box);
  REQUIRE(boxed.ok());
  REQUIRE(boxed.value().size() == 1);
  CHECK(areaOf(boxed.value()[0]) == doctest::Approx(std::numbers::pi * 150 * 150).epsilon(0.03));
  // Marks correct it as they correct what was cut out of a photo.
  marked.inside = {left};
  marked.marks = {{{right}, 8, true}, {{left}, 20, false}};
  const auto corrected = cutOut(picture, marked);
  REQUIRE(corrected.ok());
  CHECK(corrected.value().size() == 3);  // two outlines and a hole
}

TEST_CASE("a frame round a drawing is no thing") {
  const std::vector<PicturePoint> frame{{20, 20}, {880, 20}, {880, 680}, {20, 680}, {20, 20}};
  const auto found = tapped(drawn({frame, ring(kMiddle, 200)}, 4), kMiddle);
  REQUIRE(found.ok());
  CHECK(areaOf(found.value()[0]) == doctest::Approx(std::numbers::pi * 200 * 200).epsilon(0.03));
}
