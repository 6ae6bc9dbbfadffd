// What the numbers of a list are expected to be from those before them. Internal to io/ and to
// who writes for it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace spineloft::io {

/// A number is expected from numbers that are `stride` places apart: none, the one before, or the line through two of
/// them that are `reach` steps apart (rounding shakes a long line less). With `halves` the second half of the list is
/// expected by the steps of the first one, of order 3 only the first two numbers of it. Order 3: a step changes from
/// the one before by `bend` quarters of the last change. With `turns` the numbers are x, y, x, y …, and each step of
/// the line is expected to be as long as the one before, and turned from it as that one is from the one before it.
struct Mode {
  std::size_t order = 0, stride = 1, reach = 1;
  bool halves = false, turns = false;
  std::int64_t bend = 0;
};
inline constexpr std::array<Mode, 11> kModes{{{0, 1},
                                              {1, 1},
                                              {2, 1},
                                              {1, 2},
                                              {2, 2},
                                              {2, 1, 4},
                                              {2, 2, 4},
                                              {2, 1, 1, true},
                                              {.order = 2, .stride = 2, .turns = true},
                                              {.order = 3, .halves = true, .bend = 1},
                                              {.order = 3, .halves = true, .bend = 3}}};
/// Of kModes those for x, y, x, y … of a line: as long a step as before, in its direction or turned.
inline constexpr std::array<std::size_t, 2> kLineModes{4, 8};

/// The number behind `before`, of `count` in all. Numbers are at most 2⁵⁰, and equal on all machines.
std::int64_t foretold(const Mode& mode, std::span<const std::int64_t> before, std::size_t count);

/// About so many quarters of a bit a number takes that is off by this from the expected one.
std::size_t offCost(std::int64_t off);

/// Of the first `modes` of kModes the one that leaves the smallest differences.
std::uint32_t bestMode(std::span<const std::int64_t> values, std::size_t modes);

}  // namespace spineloft::io
