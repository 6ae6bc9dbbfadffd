#include "engine/base/hash.h"

#include <cstring>

namespace spineloft {
namespace {

std::uint64_t avalanche(std::uint64_t x) {
  // The finaliser of splitmix64: every input bit reaches every output bit.
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9ull;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebull;
  return x ^ (x >> 31);
}

}  // namespace

void Hasher::mix(std::uint64_t word) {
  state_ = std::rotl(state_ ^ (word * 0x9fb21c651e98df25ull), 29) * 0xd6e8feb86659fd93ull;
}

Hasher& Hasher::bytes(std::span<const std::byte> bytes) {
  mix(bytes.size());
  std::size_t at = 0;
  for (; at + 8 <= bytes.size(); at += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, 8);
    mix(word);
  }
  if (at < bytes.size()) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, bytes.size() - at);
    mix(word);
  }
  return *this;
}

std::uint64_t Hasher::value() const { return avalanche(state_); }

}  // namespace spineloft
