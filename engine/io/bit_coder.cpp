#include "engine/io/bit_coder.h"

#include <bit>
#include <utility>

namespace spineloft::io {
namespace {

/// Below this the range is widened by a byte.
constexpr std::uint32_t kLeastRange = 1U << 24;
/// Bits of a natural number above this length are not learned.
constexpr int kLearnedBits = 2;

constexpr std::uint64_t within(std::uint64_t context, std::uint64_t place) { return context * 4096 + place; }

}  // namespace

void Chance::learn(bool bit) {
  constexpr std::uint32_t kLeast = 64, kMost = 65536 - kLeast;
  const std::uint32_t weight = seen_ + 2U;
  const std::uint32_t now = zero_;
  const std::uint32_t next = bit ? now - now / weight : now + (65536 - now) / weight;
  zero_ = static_cast<std::uint16_t>(next < kLeast ? kLeast : next > kMost ? kMost : next);
  if (weight < kSlowest) ++seen_;
}

bool BitCoder::bit(std::uint64_t context, bool value) {
  Chance& chance = chances_[context];
  const bool coded = code(chance.ofZero(), value);
  chance.learn(coded);
  return coded;
}

std::uint64_t BitCoder::plain(int count, std::uint64_t value) {
  std::uint64_t out = 0;
  for (int i = count - 1; i >= 0; --i) out = out << 1 | (code(1U << 15, (value >> i & 1) != 0) ? 1U : 0U);
  return out;
}

std::uint32_t BitCoder::symbol(std::uint64_t context, int count, std::uint32_t value) {
  std::uint32_t node = 1;
  for (int i = count - 1; i >= 0; --i) {
    node = node << 1 | (bit(within(context, node), (value >> i & 1) != 0) ? 1U : 0U);
  }
  return node - (1U << count);
}

std::uint64_t BitCoder::natural(std::uint64_t context, std::uint64_t value) {
  // The length of value + 1 without its first bit; the greatest value would overflow and is not needed.
  const int wanted = static_cast<int>(std::bit_width(value + 1)) - 1;
  int length = 0;
  while (length < 63 && bit(within(context, static_cast<std::uint64_t>(length)), wanted > length)) ++length;
  const int learned = length < kLearnedBits ? length : kLearnedBits;
  const int rest = length - learned;
  std::uint64_t out = 1;
  const std::uint64_t known = value + 1;
  for (int i = length - 1; i >= rest; --i) {
    const std::uint64_t place = 64 + static_cast<std::uint64_t>(length) * 8 + (out & 7);
    out = out << 1 | (bit(within(context, place), (known >> i & 1) != 0) ? 1U : 0U);
  }
  if (rest > 0) out = out << rest | plain(rest, known & ((std::uint64_t{1} << rest) - 1));
  return out - 1;
}

std::int64_t BitCoder::integer(std::uint64_t context, std::int64_t value) {
  const bool below = value < 0;
  const auto size = below ? std::uint64_t{0} - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  const std::uint64_t coded = natural(context, size);
  if (coded == 0) return 0;
  const bool minus = bit(within(context, 4095), below);
  return static_cast<std::int64_t>(minus ? std::uint64_t{0} - coded : coded);
}

bool BitWriter::code(std::uint32_t ofZero, bool value) {
  const std::uint32_t bound = (range_ >> 16) * ofZero;
  if (value) {
    low_ += bound;
    range_ -= bound;
  } else {
    range_ = bound;
  }
  while (range_ < kLeastRange) {
    range_ <<= 8;
    shift();
  }
  return value;
}

void BitWriter::shift() {
  const bool carry = low_ >> 32 != 0;
  const auto top = static_cast<std::uint8_t>(low_ >> 24);
  if (carry || top != 0xFF) {
    if (holds_) bytes_.push_back(static_cast<std::uint8_t>(held_ + (carry ? 1 : 0)));
    for (; heldOnes_ > 0; --heldOnes_) bytes_.push_back(carry ? 0 : 0xFF);
    held_ = top;
    holds_ = true;
  } else {
    ++heldOnes_;
  }
  low_ = (low_ & 0x00FFFFFF) << 8;
}

std::vector<std::uint8_t> BitWriter::finish() {
  // Of all numbers in the range the one with most zeros at its end.
  const std::uint64_t last = low_ + range_ - 1;
  for (int zeros = 32; zeros >= 0; --zeros) {
    const std::uint64_t value = last >> zeros << zeros;
    if (value < low_) continue;
    low_ = value;
    break;
  }
  for (int i = 0; i < 5; ++i) shift();
  while (!bytes_.empty() && bytes_.back() == 0) bytes_.pop_back();
  return std::move(bytes_);
}

BitReader::BitReader(std::span<const std::uint8_t> bytes, Chances known) : BitCoder(std::move(known)), bytes_(bytes) {
  for (int i = 0; i < 4; ++i) code_ = code_ << 8 | next();
}

std::uint8_t BitReader::next() { return at_ < bytes_.size() ? bytes_[at_++] : 0; }

bool BitReader::code(std::uint32_t ofZero, bool) {
  const std::uint32_t bound = (range_ >> 16) * ofZero;
  const bool value = code_ >= bound;
  if (value) {
    code_ -= bound;
    range_ -= bound;
  } else {
    range_ = bound;
  }
  while (range_ < kLeastRange) {
    range_ <<= 8;
    code_ = code_ << 8 | next();
  }
  return value;
}

}  // namespace spineloft::io
