#include "engine/io/bit_coder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace spineloft::io {
namespace {

/// Below this the range is widened by a byte.
constexpr std::uint32_t kLeastRange = 1U << 24;
constexpr std::uint64_t within(std::uint64_t context, std::uint64_t place) { return context * 4096 + place; }

/// Weights stay below this.
constexpr std::int32_t kMostWeight = 65536 * 4;

/// 4096 / (1 + exp(−odds / 256)), by straight lines between 33 places.
std::int32_t chanceOf(std::int32_t odds) {
  constexpr std::array<std::int32_t, 33> kAt = {1,    2,    3,    6,    10,   16,   27,   45,   73,   120,  194,
                                                310,  488,  747,  1101, 1546, 2047, 2549, 2994, 3348, 3607, 3785,
                                                3901, 3975, 4024, 4050, 4068, 4079, 4085, 4089, 4092, 4093, 4094};
  const std::int32_t from = odds + 2048;
  const auto place = static_cast<std::size_t>(from / 128);
  return (kAt[place] * (128 - from % 128) + kAt[place + 1] * (from % 128) + 64) / 128;
}

/// The inverse of chanceOf, of a chance in 1/65536.
std::int32_t logOdds(std::uint32_t chance) {
  static const std::array<std::int16_t, 4096> made = [] {
    std::array<std::int16_t, 4096> out{};
    std::size_t next = 0;
    for (std::int32_t odds = -2047; odds <= 2047; ++odds) {
      for (const auto most = static_cast<std::size_t>(chanceOf(odds)); next <= most; ++next) {
        out[next] = static_cast<std::int16_t>(odds);
      }
    }
    for (; next < out.size(); ++next) out[next] = 2047;
    return out;
  }();
  return made[chance / 16];
}

}  // namespace

void Chance::learn(bool bit, const Pace& pace) {
  constexpr std::uint32_t kLeast = 64, kMost = 65536 - kLeast;
  const std::uint32_t weight = 4U * seen_ + pace.firstWeight;
  const std::uint32_t now = zero_;
  const std::uint32_t next = bit ? now - 4 * now / weight : now + 4 * (65536 - now) / weight;
  zero_ = static_cast<std::uint16_t>(next < kLeast ? kLeast : next > kMost ? kMost : next);
  if (weight < 4 * pace.slowest) ++seen_;
}

BitCoder::Mixed::Mixed(std::initializer_list<std::uint64_t> contexts) : count_(contexts.size()) {
  std::ranges::copy(contexts, contexts_.begin());
}

BitCoder::Mixed BitCoder::Mixed::at(std::uint64_t place) const {
  Mixed out = *this;
  for (std::uint64_t& context : out.contexts_) context = within(context, place);
  out.weights = weights * 8 + std::min<std::uint64_t>(place, 7);
  return out;
}

bool BitCoder::bit(std::uint64_t context, bool value) { return bit(Mixed{context}, value); }

bool BitCoder::bit(const Mixed& mixed, bool value) {
  const std::span<const std::uint64_t> contexts = mixed.contexts();
  if (contexts.size() == 1) {
    Chance& chance = chances_.of[contexts[0]];
    const bool coded = code(chance.ofZero(), value);
    chance.learn(coded, chances_.pace);
    return coded;
  }
  constexpr std::int32_t kFirstWeight = 65536 * 4 / 10;
  const auto found = chances_.weights.try_emplace(mixed.weights, Weights{kFirstWeight, kFirstWeight, kFirstWeight});
  Weights& weights = found.first->second;
  std::array<std::int32_t, kMostMixed> odds{};
  std::int64_t sum = 0;
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    odds[i] = logOdds(chances_.of[contexts[i]].ofZero());
    sum += std::int64_t{weights[i]} * odds[i];
  }
  const std::int32_t ofZero = chanceOf(static_cast<std::int32_t>(std::clamp<std::int64_t>(sum / 65536, -2047, 2047)));
  const bool coded = code(static_cast<std::uint32_t>(ofZero) * 16, value);
  const std::int32_t error = (coded ? 0 : 4096) - ofZero;
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    weights[i] = std::clamp(weights[i] + odds[i] * error / chances_.pace.mixing, -kMostWeight, kMostWeight);
    chances_.of[contexts[i]].learn(coded, chances_.pace);
  }
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

std::uint64_t BitCoder::natural(const Mixed& contexts, std::uint64_t value) {
  // The length of value + 1 without its first bit; the greatest value would overflow and is not needed.
  const int wanted = static_cast<int>(std::bit_width(value + 1)) - 1;
  int length = 0;
  while (length < 63 && bit(contexts.at(static_cast<std::uint64_t>(length)), wanted > length)) ++length;
  const int learned = std::min(length, chances_.pace.bits);
  const int rest = length - learned;
  std::uint64_t out = 1;
  const std::uint64_t known = value + 1;
  for (int i = length - 1; i >= rest; --i) {
    const std::uint64_t place = 64 + static_cast<std::uint64_t>(length) * 8 + (out & 7);
    out = out << 1 | (bit(contexts.at(place), (known >> i & 1) != 0) ? 1U : 0U);
  }
  if (rest > 0) out = out << rest | plain(rest, known & ((std::uint64_t{1} << rest) - 1));
  return out - 1;
}

std::int64_t BitCoder::integer(std::uint64_t context, std::int64_t value) {
  return integer(Mixed{context}, Mixed{within(context, 4095)}, value);
}

std::int64_t BitCoder::integer(const Mixed& sizes, const Mixed& sign, std::int64_t value) {
  const bool below = value < 0;
  const auto size = below ? std::uint64_t{0} - static_cast<std::uint64_t>(value) : static_cast<std::uint64_t>(value);
  const std::uint64_t coded = natural(sizes, size);
  if (coded == 0) return 0;
  const bool minus = bit(sign, below);
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
