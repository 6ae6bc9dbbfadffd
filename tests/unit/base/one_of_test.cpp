#include "engine/base/one_of.h"

#include <doctest/doctest.h>

#include <cstdint>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/base/one_of_members.h"

namespace one_of_test {  // of no file's own, so that its members count as used

struct Counted {
  std::vector<int> numbers;
  static inline int copies = 0;
  explicit Counted(std::vector<int> all) : numbers(std::move(all)) {}
  Counted(const Counted& other) : numbers(other.numbers) { ++copies; }
  Counted(Counted&&) noexcept = default;
  Counted& operator=(const Counted& other) = default;
  Counted& operator=(Counted&&) noexcept = default;
};
using Some = std::variant<std::uint8_t, Counted, std::shared_ptr<int>>;

}  // namespace one_of_test

using namespace one_of_test;

template struct spineloft::OneOf<Some>;
template struct spineloft::Movers<Some>;

using One = spineloft::OneOf<Some>;

TEST_CASE("one of several is the alternative that was put in, moved and not copied") {
  Counted::copies = 0;
  Counted counted({1, 2, 3});
  const int* numbers = counted.numbers.data();
  One one = std::move(counted);
  CHECK(one.index() == 1);
  REQUIRE(std::get_if<Counted>(&one));
  CHECK(std::get<Counted>(one).numbers.data() == numbers);
  One moved = std::move(one);
  CHECK(std::get<Counted>(moved).numbers.data() == numbers);
  CHECK(Counted::copies == 0);
  const One copied = moved;
  CHECK(Counted::copies == 1);
  CHECK(std::get<Counted>(copied).numbers == std::vector{1, 2, 3});
}

TEST_CASE("another alternative takes the place of the one before, which is destroyed") {
  const auto shared = std::make_shared<int>(7);
  One one = shared;
  CHECK(shared.use_count() == 2);
  one = std::uint8_t{3};
  CHECK(shared.use_count() == 1);
  CHECK(std::visit([](const auto& is) { return sizeof is; }, one) == 1);
  CHECK(One().index() == 0);
  // What is none of them makes none: 3 of another type would have to be converted.
  CHECK_FALSE(std::is_constructible_v<One, int>);
}
