// Which of many things belong together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace spineloft {

/// A union-find forest over 0 … count − 1, each by itself at first. A group goes by its least member.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0u); }
  /// The group of `i` (< count): its least member. Paths are halved on the way, so that many calls are
  /// nearly linear.
  std::uint32_t of(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t x = of(a), y = of(b);
    (x < y ? parent_[y] : parent_[x]) = x < y ? x : y;
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace spineloft
