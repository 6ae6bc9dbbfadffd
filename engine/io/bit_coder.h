// Arithmetic coding of bits whose chances are learned while they are coded (Rissanen 1976, as a range coder with
// carries, Martin 1979). Internal to io/.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

namespace spineloft::io {

/// How quickly is learned.
struct Pace {
  std::uint32_t firstWeight = 8;  ///< of Chance, > 4, in quarters: the less, the more a first bit tells
  std::uint32_t slowest = 32;     ///< of Chance
  std::int32_t mixing = 512;      ///< weights of mixtures change by odds · error / this
  int bits = 2;                   ///< so many bits of a number behind its first one
};

/// How likely the next bit of a context is 0, from the bits seen there: after n bits a new one weighs
/// 1 / (n + firstWeight / 4), and never less than 1 / slowest.
class Chance {
 public:
  /// Of a zero, in 1/65536, away from certainty.
  std::uint32_t ofZero() const { return zero_; }
  void learn(bool bit, const Pace& pace);

 private:
  std::uint16_t zero_ = 1U << 15;
  std::uint16_t seen_ = 0;
};

/// How much each of several contexts of a bit weighs, in 1/65536.
inline constexpr std::size_t kMostMixed = 3;
using Weights = std::array<std::int32_t, kMostMixed>;

/// What has been learned: a chance for every context, and weights for every mixture of them.
struct Chances {
  std::unordered_map<std::uint64_t, Chance> of;
  std::unordered_map<std::uint64_t, Weights> weights;
  Pace pace = {};
};

/// Writes or reads the same calls in the same order: `bit` returns the bit that was handed in, or the one that was
/// written there. What encodes and decodes is then one function. A context is any number; each has a chance of its own.
class BitCoder {
 public:
  virtual ~BitCoder() = default;
  BitCoder() = default;
  /// With what has been learned before.
  explicit BitCoder(Chances known) : chances_(std::move(known)) {}
  BitCoder(const BitCoder&) = delete;
  BitCoder& operator=(const BitCoder&) = delete;

  bool bit(std::uint64_t context, bool value);
  /// The lowest `count` bits (0…64) of `value`, highest first; not learned.
  std::uint64_t plain(int count, std::uint64_t value);
  /// A number below 2^count, each of its bits in the context of those before it. count 1…12.
  std::uint32_t symbol(std::uint64_t context, int count, std::uint32_t value);
  /// Any number; small ones take few bits (Elias gamma of value + 1 with a learned length).
  std::uint64_t natural(std::uint64_t context, std::uint64_t value) { return natural(Mixed{context}, value); }
  /// Size and sign; any value but the least of 64 bits.
  std::int64_t integer(std::uint64_t context, std::int64_t value);

  /// 1 … kMostMixed contexts that each know something of a bit. Their chances are mixed as log-odds, by weights that
  /// are learned (Mahoney 2005, in whole numbers: all machines mix alike).
  class Mixed {
   public:
    Mixed(std::initializer_list<std::uint64_t> contexts);
    /// The same contexts at a place within them.
    Mixed at(std::uint64_t place) const;
    std::span<const std::uint64_t> contexts() const { return {contexts_.data(), count_}; }
    std::uint64_t weights = 0;  ///< which weights are learned

   private:
    std::array<std::uint64_t, kMostMixed> contexts_{};
    std::size_t count_ = 0;
  };
  std::int64_t integer(const Mixed& size, const Mixed& sign, std::int64_t value);
  const Chances& chances() const { return chances_; }

 protected:
  /// With this chance of 0, in 1/65536, 1…65535.
  virtual bool code(std::uint32_t ofZero, bool value) = 0;

 private:
  bool bit(const Mixed& contexts, bool value);
  std::uint64_t natural(const Mixed& contexts, std::uint64_t value);
  Chances chances_;
};

/// Only learns.
class BitLearner final : public BitCoder {
 public:
  using BitCoder::BitCoder;

 protected:
  bool code(std::uint32_t, bool value) override { return value; }
};

class BitWriter final : public BitCoder {
 public:
  using BitCoder::BitCoder;
  /// What was written, without the zero bytes at its end. The writer is of no use afterwards.
  std::vector<std::uint8_t> finish();

 protected:
  bool code(std::uint32_t ofZero, bool value) override;

 private:
  void shift();
  std::uint64_t low_ = 0;
  std::uint32_t range_ = 0xFFFFFFFF;
  std::uint8_t held_ = 0;       ///< the last byte, which a carry may still change
  std::uint64_t heldOnes_ = 0;  ///< bytes of 255 after it, which a carry would make 0
  bool holds_ = false;
  std::vector<std::uint8_t> bytes_;
};

class BitReader final : public BitCoder {
 public:
  /// Behind the end zeros are read. The bytes must outlive the reader.
  BitReader(std::span<const std::uint8_t> bytes, Chances known);

 protected:
  bool code(std::uint32_t ofZero, bool value) override;

 private:
  std::uint8_t next();
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
  std::uint32_t range_ = 0xFFFFFFFF, code_ = 0;
};

}  // namespace spineloft::io
