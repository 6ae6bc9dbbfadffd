// What the numbers of a list are expected to be from those before them. Internal to io/ and to
// who writes for it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace spineloft::io {

/// A number is expected from numbers that are `stride` places apart: none, the one before, or the line through two of
/// them that are `reach` steps apart (rounding shakes a long line less). With `halves` the second half of the list is
/// expected by the steps of the first one, of order 3 only the first two numbers of it. Order 3: a step changes from
/// the one before by `bend` quarters of the last change. With `turns` the numbers are x, y, x, y …, and each step of
/// the line is expected to be as long as the one before, and turned from it as that one is from the one before it.
/// `even`: as EvenLine has it, which turns by `bend` quarters of the last turn.
struct Mode {
  std::size_t order = 0, stride = 1, reach = 1;
  bool halves = false, turns = false;
  std::int64_t bend = 0;
  bool even = false;
};
inline constexpr std::array<Mode, 14> kModes{{{0, 1},
                                              {1, 1},
                                              {2, 1},
                                              {1, 2},
                                              {2, 2},
                                              {2, 1, 4},
                                              {2, 2, 4},
                                              {2, 1, 1, true},
                                              {.order = 2, .stride = 2, .turns = true},
                                              {.order = 3, .halves = true, .bend = 1},
                                              {.order = 3, .halves = true, .bend = 3},
                                              {.order = 2, .stride = 2, .bend = 0, .even = true},
                                              {.order = 2, .stride = 2, .bend = 2, .even = true},
                                              {.order = 2, .stride = 2, .bend = 4, .even = true}}};
/// Of kModes those for x, y, x, y … of a line that is drawn anew.
inline constexpr std::array<std::size_t, 3> kLineModes{11, 12, 13};

/// A line of points of which each step is expected to be as long as all others. Of a point the number comes first that
/// says where the step leads to; the other one follows from the length.
class EvenLine {
 public:
  /// `length` of a step in 1 / kLengthParts.
  EvenLine(std::int64_t length, std::int64_t bend) : length_(length), bend_(bend) {}
  static constexpr std::int64_t kLengthParts = 16, kMostLength = std::int64_t{1} << 20;
  /// The mean step of x, y, x, y …
  static std::int64_t lengthOf(std::span<const std::int64_t> numbers);
  /// Of the next point the number that is told next: 0 for x, 1 for y.
  std::size_t axis() const { return halfTold_ ? 1 - first_ : first_; }
  std::int64_t expected() const { return halfTold_ ? expectedAfter(told_) : expected_[first_]; }
  /// The point's other number if its first one is this.
  std::int64_t expectedAfter(std::int64_t first) const;
  void take(std::int64_t value);
  void takePoint(std::int64_t x, std::int64_t y);
  /// x, y, x, y … up to the last whole point.
  std::span<const std::int64_t> numbers() const { return numbers_; }

 private:
  void expectPoint();

  std::int64_t length_, bend_;
  std::vector<std::int64_t> numbers_;
  std::size_t first_ = 0;
  bool halfTold_ = false;
  std::int64_t told_ = 0;
  std::array<std::int64_t, 2> expected_{};  ///< the next point, before any of it is told
};

/// The number behind `before`, of `count` in all. Numbers are at most 2⁵⁰, and equal on all machines.
std::int64_t foretold(const Mode& mode, std::span<const std::int64_t> before, std::size_t count);

/// Each number of a list less what it is expected to be, in the order in which they are told. Lists of an even mode
/// have an even count.
std::vector<std::int64_t> offs(const Mode& mode, std::span<const std::int64_t> values);

/// About so many quarters of a bit a number takes that is off by this from the expected one.
std::size_t offCost(std::int64_t off);

/// Of the first `modes` of kModes the one that leaves the smallest differences.
std::uint32_t bestMode(std::span<const std::int64_t> values, std::size_t modes);

}  // namespace spineloft::io
