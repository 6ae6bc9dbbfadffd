#include "engine/io/foretold.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>

namespace spineloft::io {
namespace {

/// Steps up to here have exact products in double precision.
constexpr std::int64_t kMostTurned = 1 << 16;

struct Pair {
  std::int64_t x, y;
};

/// The step that comes after `earlier` and `last`. With both as complex numbers that is last² · conj(earlier), as long
/// as the last one. None where a step is 0 or too long.
std::optional<Pair> turned(Pair earlier, Pair last) {
  const auto most = std::max({std::abs(earlier.x), std::abs(earlier.y), std::abs(last.x), std::abs(last.y)});
  if (most > kMostTurned) return std::nullopt;
  const std::int64_t a = last.x * last.x + last.y * last.y;
  const std::int64_t b = earlier.x * earlier.x + earlier.y * earlier.y;
  if (a == 0 || b == 0) return std::nullopt;
  const Pair square{last.x * last.x - last.y * last.y, 2 * last.x * last.y};
  const std::int64_t x = square.x * earlier.x + square.y * earlier.y;
  const std::int64_t y = square.y * earlier.x - square.x * earlier.y;
  const double lengths = std::sqrt(static_cast<double>(a) * static_cast<double>(b));
  return Pair{std::llround(static_cast<double>(x) / lengths), std::llround(static_cast<double>(y) / lengths)};
}

/// By the turn of the line of points; none before its third step.
std::optional<std::int64_t> byTurn(std::span<const std::int64_t> before) {
  const std::size_t i = before.size(), point = i - i % 2;
  if (point < 6) return std::nullopt;
  const auto step = [&](std::size_t to) { return Pair{before[to] - before[to - 2], before[to + 1] - before[to - 1]}; };
  const auto next = turned(step(point - 4), step(point - 2));
  if (!next) return std::nullopt;
  return before[i - 2] + (i % 2 == 0 ? next->x : next->y);
}

/// The nearest whole number, away from 0 in the middle. `by` is even.
std::int64_t rounded(std::int64_t value, std::int64_t by) { return (value + (value < 0 ? -by / 2 : by / 2)) / by; }

}  // namespace

std::int64_t foretold(const Mode& mode, std::span<const std::int64_t> before, std::size_t count) {
  const std::size_t i = before.size(), s = mode.stride;
  if (mode.halves && i >= count - count / 2) {
    const std::size_t like = i - (count - count / 2);
    if (like == 0) return before[0];
    if (mode.order < 3 || like == 1) return before[i - 1] + before[like] - before[like - 1];
    return foretold({.order = mode.order, .bend = mode.bend}, before.last(like), count);
  }
  if (mode.order == 0 || i < s) return 0;
  if (mode.order == 1 || i < 2 * s) return before[i - s];
  if (mode.turns) {
    if (const auto next = byTurn(before)) return *next;
  }
  const auto reach = static_cast<std::int64_t>(std::min(mode.reach, i / s - 1));
  const std::int64_t last = before[i - s], change = last - before[i - s - static_cast<std::size_t>(reach) * s];
  const std::int64_t next = last + rounded(2 * change, 2 * reach);
  if (mode.order < 3 || i < 3 * s) return next;
  return next + rounded(mode.bend * (change - (before[i - 2 * s] - before[i - 3 * s])), 4);
}

std::size_t offCost(std::int64_t off) {
  return off == 0 ? 4 : 8 + 5 * static_cast<std::size_t>(std::bit_width(static_cast<std::uint64_t>(std::abs(off))));
}

std::int64_t EvenLine::lengthOf(std::span<const std::int64_t> numbers) {
  double sum = 0;
  for (std::size_t i = 2; i + 1 < numbers.size(); i += 2) {
    const auto x = static_cast<double>(numbers[i] - numbers[i - 2]);
    const auto y = static_cast<double>(numbers[i + 1] - numbers[i - 1]);
    sum += std::sqrt(x * x + y * y);
  }
  const auto steps = static_cast<double>(std::max<std::size_t>(2, numbers.size() / 2) - 1);
  return std::llround(std::min(sum / steps * kLengthParts, double{kMostLength}));
}

std::int64_t EvenLine::expectedAfter(std::int64_t first) const {
  const std::size_t i = numbers_.size(), other = 1 - first_;
  if (i < 4) return expected_[other];
  const std::int64_t from = numbers_[i - 2 + other], across = first - numbers_[i - 2 + first_];
  if (std::abs(across) > kMostTurned) return from;
  const std::int64_t left = length_ * length_ - kLengthParts * kLengthParts * across * across;
  if (left <= 0) return from;
  const std::int64_t along = std::llround(std::sqrt(static_cast<double>(left)) / kLengthParts);
  return expected_[other] < from ? from - along : from + along;
}

void EvenLine::take(std::int64_t value) {
  if (!halfTold_) {
    told_ = value;
    halfTold_ = true;
    return;
  }
  halfTold_ = false;
  takePoint(first_ == 0 ? told_ : value, first_ == 0 ? value : told_);
}

void EvenLine::takePoint(std::int64_t x, std::int64_t y) {
  numbers_.insert(numbers_.end(), {x, y});
  expectPoint();
}

void EvenLine::expectPoint() {
  const std::size_t i = numbers_.size();
  expected_ = {numbers_[i - 2], numbers_[i - 1]};
  first_ = 0;
  if (i < 4) return;
  const auto step = [&](std::size_t to) {
    return Pair{numbers_[to] - numbers_[to - 2], numbers_[to + 1] - numbers_[to - 1]};
  };
  Pair next = step(i - 2);
  if (std::max(std::abs(next.x), std::abs(next.y)) > kMostTurned) return;
  if (i >= 6) {
    const Pair straight = next;
    if (const auto turn = turned(step(i - 4), straight)) {
      next.x += rounded(bend_ * (turn->x - straight.x), 4);
      next.y += rounded(bend_ * (turn->y - straight.y), 4);
    }
  }
  const double size = std::sqrt(static_cast<double>(next.x * next.x + next.y * next.y)) * kLengthParts;
  if (size > 0) {
    next.x = std::llround(static_cast<double>(next.x * length_) / size);
    next.y = std::llround(static_cast<double>(next.y * length_) / size);
  }
  expected_[0] += next.x;
  expected_[1] += next.y;
  first_ = std::abs(next.x) >= std::abs(next.y) ? 1 : 0;
}

std::vector<std::int64_t> offs(const Mode& mode, std::span<const std::int64_t> values) {
  std::vector<std::int64_t> out;
  if (mode.even) {
    EvenLine line(EvenLine::lengthOf(values), mode.bend);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::int64_t value = values[i - i % 2 + line.axis()];
      out.push_back(value - line.expected());
      line.take(value);
    }
    return out;
  }
  for (std::size_t i = 0; i < values.size(); ++i)
    out.push_back(values[i] - foretold(mode, values.first(i), values.size()));
  return out;
}

std::uint32_t bestMode(std::span<const std::int64_t> values, std::size_t modes) {
  std::uint32_t best = 0;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (std::uint32_t m = 0; m < modes; ++m) {
    if (kModes[m].even && values.size() % 2 != 0) continue;
    std::uint64_t bits = kModes[m].even ? 12 : 0;
    for (const std::int64_t off : offs(kModes[m], values))
      bits += 2 * static_cast<std::uint64_t>(std::bit_width(static_cast<std::uint64_t>(std::abs(off))));
    if (bits < least) {
      least = bits;
      best = m;
    }
  }
  return best;
}

}  // namespace spineloft::io
