#include "engine/cli/agreement.h"

#include <doctest/doctest.h>

#include <cmath>

using namespace spineloft;
using namespace spineloft::cli;

namespace {

/// 20 wide columns from `top` to below `bottom`, in 100 × 160 pixels.
image::Mask bar(int top, int bottom, int left = 40) {
  image::Mask mask{100, 160, std::vector<std::uint8_t>(16000)};
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < left + 20; ++x) mask.pixels[static_cast<std::size_t>(y * 100 + x)] = 255;
  }
  return mask;
}

Truth truthOf(image::Mask mask) {
  return Truth({std::move(mask), {{49.5, 20, 20}, {49.5, 80, 20}, {49.5, 139, 20}}, 1.0});
}

using Strokes = std::vector<std::pair<std::string, std::vector<PicturePoint>>>;
const Strokes kStrokes{{"long", {{49.5, 30}, {49.5, 130}}}, {"turned", {{49.5, 120}, {49.5, 40}}}};

}  // namespace

TEST_CASE("equal parts agree wholly, and so does one with itself") {
  const Truth truth = truthOf(bar(20, 140));
  for (const std::vector<image::Mask>& parts : {std::vector{bar(20, 140), bar(20, 140)}, std::vector{bar(20, 140)}}) {
    const Agreement found = agreementOf(truth, parts, kStrokes);
    CHECK(found.whole == 1);
    CHECK(found.body == 1);
  }
}

TEST_CASE(
    "parts that differ beyond the ends of the shorter stroke alone agree in the body, whichever way it was drawn") {
  const Agreement found = agreementOf(truthOf(bar(20, 140)), std::vector{bar(20, 140), bar(35, 125)}, kStrokes);
  CHECK(found.whole == doctest::Approx(90.0 / 120));
  CHECK(found.body == 1);
}

TEST_CASE("parts that differ between the strokes' ends disagree in both, by the share that they have in common") {
  const Agreement found = agreementOf(truthOf(bar(20, 140)), std::vector{bar(20, 140), bar(20, 140, 45)}, kStrokes);
  CHECK(found.whole == doctest::Approx(15.0 / 25));
  CHECK(found.body == doctest::Approx(15.0 / 25));
}

TEST_CASE("pixels of which the truth does not care count for the whole alone") {
  image::Mask mask = bar(20, 140);
  for (std::size_t i = 100 * 75; i < 100 * 85; ++i) mask.pixels[i] = 128;
  image::Mask dented = bar(20, 140);
  for (std::size_t i = 100 * 76; i < 100 * 84; ++i) dented.pixels[i] = 0;
  const Agreement found = agreementOf(truthOf(mask), std::vector{bar(20, 140), dented}, kStrokes);
  CHECK(found.whole == doctest::Approx(112.0 / 120));
  CHECK(found.body == 1);
}

TEST_CASE("no part has nothing in common with one; of three parts every pair counts") {
  const Truth truth = truthOf(bar(20, 140));
  const Agreement none = agreementOf(truth, std::vector{bar(20, 140), image::Mask{}}, kStrokes);
  CHECK(none.whole == 0);
  CHECK(none.body == 0);
  const Agreement two = agreementOf(truth, std::vector{bar(20, 140), bar(20, 140), image::Mask{}}, kStrokes);
  CHECK(two.whole == doctest::Approx(1.0 / 3));
}
