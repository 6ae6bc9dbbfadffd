#include "engine/io/foretold.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

constexpr std::uint32_t kTurns = 8, kBends = 10, kEven = 11;
static_assert(kModes[kTurns].turns && kModes[kBends].bend == 3 && kModes[kEven].even);

/// Points of a line of even steps that turns evenly.
std::vector<std::int64_t> arc(double step, double turn, int points) {
  std::vector<std::int64_t> numbers;
  double x = 0, y = 0;
  for (int i = 0; i < points; ++i) {
    numbers.push_back(std::llround(x));
    numbers.push_back(std::llround(y));
    x += step * std::cos(turn * i);
    y += step * std::sin(turn * i);
  }
  return numbers;
}

}  // namespace

TEST_CASE("points on circles are foretold by their turn to within what rounding does to three steps") {
  for (const double degrees : {0.0, 5.0, 30.0, 90.0, -60.0}) {
    const auto numbers = arc(200, degrees * std::numbers::pi / 180, 20);
    for (std::size_t i = 6; i < numbers.size(); ++i) {
      const std::int64_t next = foretold(kModes[kTurns], std::span(numbers).first(i), numbers.size());
      CHECK(std::abs(next - numbers[i]) <= 4);
    }
    if (std::abs(degrees) >= 5) CHECK(bestMode(numbers, kEven) == kTurns);
  }
}

TEST_CASE(
    "what has no turn is foretold as a line: repeated points, steps too long for exact products, a list's begin") {
  const Mode line{.order = 2, .stride = 2};
  const std::int64_t far = std::int64_t{1} << 50;
  for (const std::vector<std::int64_t>& numbers : {std::vector<std::int64_t>{},
                                                   {3},
                                                   {3, 4},
                                                   {3, 4, 5, 7, 9},
                                                   {3, 4, 3, 4, 3, 4, 3},
                                                   {0, 0, far, -far, -far, far, far}}) {
    for (std::size_t i = 0; i <= numbers.size(); ++i) {
      const auto before = std::span(numbers).first(i);
      CHECK(foretold(kModes[kTurns], before, 40) == foretold(line, before, 40));
    }
  }
}

TEST_CASE(
    "a step changes by a share of the last change, rounded, and the second half of a list begins as the first one") {
  // Steps 32, 48, 60, 69: each change is three quarters of the one before.
  const std::vector<std::int64_t> half = {7, 39, 87, 147, 216};
  std::vector<std::int64_t> numbers = half;
  for (const std::int64_t number : half) numbers.push_back(number);
  const auto at = [&](std::size_t i) { return foretold(kModes[kBends], std::span(numbers).first(i), numbers.size()); };
  for (const std::size_t i : {3U, 4U, 5U, 6U, 8U, 9U}) CHECK_MESSAGE(at(i) == numbers[i], i);
  CHECK(bestMode(numbers, kModes.size()) == kBends);
  // Versions before the fourth do without.
  CHECK(bestMode(numbers, 9) < 9);
  const std::vector<std::int64_t> odd = {0, 0, 1, 4, -1};
  // 4 + 3 + 3/4 of 2; and of changes below 0.
  CHECK(foretold(kModes[kBends], std::span(odd).first(4), 40) == 9);
  CHECK(foretold(kModes[kBends], odd, 40) == -1 - 5 - 6);
}

TEST_CASE("of a line of even steps only where each leads to is left to tell, in which direction it ever goes") {
  for (const double degrees : {0.0, 7.0, 20.0, -15.0}) {
    std::vector<std::int64_t> numbers;
    double x = 5000, y = -300, heading = 0.3;
    for (int i = 0; i < 30; ++i) {
      numbers.insert(numbers.end(), {std::llround(x), std::llround(y)});
      heading += degrees * std::numbers::pi / 180 * (i % 3);  // not as foretold
      x += 200 * std::cos(heading);
      y += 200 * std::sin(heading);
    }
    for (std::size_t mode = kEven; mode < kModes.size(); ++mode) {
      const auto off = offs(kModes[mode], numbers);
      REQUIRE(off.size() == numbers.size());
      // The other number of each point follows, to within what rounding does where the step runs along no axis.
      for (std::size_t i = 5; i < off.size(); i += 2) CHECK(std::abs(off[i]) <= 2);
      EvenLine line(EvenLine::lengthOf(numbers), kModes[mode].bend);
      for (const std::int64_t one : off) line.take(line.expected() + one);
      CHECK(std::ranges::equal(line.numbers(), numbers));
    }
  }
}

TEST_CASE("even steps are told of any numbers: repeated points, and steps too long for exact products") {
  const std::int64_t far = std::int64_t{1} << 50;
  for (const std::vector<std::int64_t>& numbers :
       {std::vector<std::int64_t>{}, {3, 4}, {3, 4, 3, 4, 3, 4, 3, 4}, {0, 0, far, -far, -far, far, far, far, 1, 2}}) {
    for (std::size_t mode = kEven; mode < kModes.size(); ++mode) {
      const auto off = offs(kModes[mode], numbers);
      for (const std::int64_t length : {EvenLine::lengthOf(numbers), std::int64_t{0}, EvenLine::kMostLength}) {
        EvenLine line(length, kModes[mode].bend), again(length, kModes[mode].bend);
        for (std::size_t i = 0; i < numbers.size(); ++i) {
          const std::int64_t number = numbers[i - i % 2 + line.axis()];
          const std::int64_t one = number - line.expected();
          line.take(number);
          again.take(again.expected() + one);
        }
        CHECK(std::ranges::equal(again.numbers(), numbers));
      }
    }
  }
}
