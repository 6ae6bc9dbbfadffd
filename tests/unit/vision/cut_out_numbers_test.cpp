#include "engine/vision/cut_out_numbers.h"

#include <doctest/doctest.h>

#include <limits>

#include "engine/base/rng.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::vision;

namespace {

/// Any double but NaN, which is equal to nothing.
double anyNumber(Rng& rng) {
  switch (rng.below(6)) {
    case 0:
      return std::numeric_limits<double>::infinity();
    case 1:
      return -std::numeric_limits<double>::denorm_min();
    case 2:
      return static_cast<double>(rng.below(5));
    default:
      return rng.uniform(-1e4, 1e4);
  }
}
std::vector<PicturePoint> anyLine(Rng& rng) {
  std::vector<PicturePoint> line(rng.below(5));
  for (PicturePoint& p : line) p = {anyNumber(rng), anyNumber(rng)};
  return line;
}
CutHints anyHints(Rng& rng) {
  CutHints hints{anyLine(rng), anyLine(rng), {}, {}};
  if (rng.below(2) == 0) hints.box = {{anyNumber(rng), anyNumber(rng)}, {anyNumber(rng), anyNumber(rng)}};
  hints.marks.resize(rng.below(4));
  for (CutMark& mark : hints.marks) mark = {anyLine(rng), anyNumber(rng), rng.below(2) == 0};
  return hints;
}

}  // namespace

TEST_CASE("hints come back from their numbers as they are") {
  Rng rng(1);
  for (int round = 0; round < testing::rounds(200); ++round) {
    const CutHints hints = anyHints(rng);
    const auto back = hintsFrom(numbersOf(hints));
    REQUIRE(back.has_value());
    CHECK(*back == hints);
  }
}

TEST_CASE("what was found comes back from its numbers: outlines, and every error with its detail") {
  Rng rng(2);
  for (int round = 0; round < testing::rounds(200); ++round) {
    CutContours contours(rng.below(4));
    for (auto& contour : contours) contour = anyLine(rng);
    const auto back = foundFrom(numbersOf(Result<CutContours>(contours)));
    REQUIRE(back.has_value());
    REQUIRE(back->ok());
    CHECK(back->value() == contours);
  }
  for (int i = 0; i < static_cast<int>(Error::kCount); ++i) {
    for (const char* detail : {"", "hint", "größer"}) {
      const Failure failure{static_cast<Error>(i), detail};
      const auto back = foundFrom(numbersOf(Result<CutContours>(failure)));
      REQUIRE(back.has_value());
      REQUIRE_FALSE(back->ok());
      CHECK(back->failure() == failure);
    }
  }
}

TEST_CASE("lists of other numbers are neither hints nor outlines") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinite = std::numeric_limits<double>::infinity();
  Rng rng(3);
  for (int round = 0; round < testing::rounds(50); ++round) {
    std::vector<double> numbers = numbersOf(anyHints(rng));
    numbers.push_back(0);
    CHECK_FALSE(hintsFrom(numbers).has_value());
    for (numbers.pop_back(); !numbers.empty();) {
      numbers.pop_back();
      CHECK_FALSE(hintsFrom(numbers).has_value());
    }
  }
  for (const double count : {-1.0, 0.5, 1.0, 1e300, infinite, nan}) {
    CHECK_FALSE(hintsFrom(std::vector{count, 0.0, 0.0, 0.0}).has_value());
    CHECK_FALSE(foundFrom(std::vector{0.0, count}).has_value());
  }
  for (const double kind : {-1.0, 0.5, 1.0 + static_cast<int>(Error::kCount), infinite, nan}) {
    CHECK_FALSE(foundFrom(std::vector{kind}).has_value());
  }
  CHECK_FALSE(foundFrom({}).has_value());
  CHECK_FALSE(foundFrom(std::vector{1.0, 256.0}).has_value());
}
