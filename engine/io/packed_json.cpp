#include "engine/io/packed_json.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "engine/base/text.h"
#include "engine/io/bit_coder.h"
#include "engine/io/foretold.h"
#include "engine/io/packed_dialect.h"

namespace spineloft::io {
namespace {

using Json = nlohmann::json;

/// What a value is written as.
enum class Kind : std::uint8_t {
  Null,
  False,
  True,
  Whole,
  Fraction,
  Unsigned,
  Text,
  Numbers,
  Table,
  List,
  Object,
  Colour,  ///< "#rrggbb"; from version 2
};
constexpr int kKindBits = 4;

/// Contexts, above the key that a value stands at.
enum class Place : std::uint64_t { Kind, Key, Word, Length, Byte, Divisor, Mode, First, Rest, Column, Count };

/// A number is a whole number divided by one of these, or else its 64 bits.
constexpr std::array<std::int64_t, 31> kDivisors = {
    1,      2,      4,       8,       10,       16,       32,        64,        100,       128,   256,
    500,    512,    1000,    1024,    2048,     4096,     8192,      10000,     16384,     32768, 65536,
    100000, 131072, 1000000, 1048576, 10000000, 16777216, 100000000, 268435456, 1000000000};
constexpr std::uint32_t kBits = kDivisors.size();  ///< stands for: the bits themselves
constexpr std::uint32_t kOther = kBits + 1;        ///< stands for: another whole number, which follows; from version 2
constexpr std::int64_t kMostOther = 1023;
/// Whole numbers up to here are differences without overflow, and exact as doubles.
constexpr double kMostWhole = 1125899906842624;  // 2⁵⁰
/// Largest power of two that numbers of a list are known to be multiples of.
constexpr std::uint64_t kMostSpread = 50;

constexpr std::string_view kHexDigits = "0123456789abcdef";

std::optional<std::int64_t> wholeTimes(double value, std::int64_t divisor) {
  const auto by = static_cast<double>(divisor);
  const double scaled = value * by;
  if (!(std::abs(scaled) <= kMostWhole)) return std::nullopt;
  const double whole = std::round(scaled);
  if (whole / by != value || (whole == 0 && std::signbit(value))) return std::nullopt;
  return static_cast<std::int64_t>(whole);
}

bool makesWhole(std::span<const double> values, std::int64_t divisor) {
  return std::ranges::all_of(values, [&](double v) { return wholeTimes(v, divisor).has_value(); });
}

/// What a list of numbers is divided by, and how that is written. `by` is 0 for the bits themselves.
struct Divisor {
  std::uint32_t symbol = kBits;
  std::int64_t by = 0;
};
/// The first divisor that makes all of them whole.
Divisor divisorOf(std::span<const double> values, const Dialect& dialect) {
  for (std::uint32_t d = 0; d < kDivisors.size(); ++d) {
    if (makesWhole(values, kDivisors[d])) return {d, kDivisors[d]};
  }
  for (std::int64_t by = 2; dialect.later && by <= kMostOther; ++by) {
    if (makesWhole(values, by)) return {kOther, by};
  }
  return {};
}

/// The three bytes of "#rrggbb"; none of any other text.
std::optional<std::uint32_t> colourOf(const std::string& text) {
  if (text.size() != 7 || text[0] != '#') return std::nullopt;
  std::uint32_t colour = 0;
  for (const char c : std::string_view(text).substr(1)) {
    const std::size_t digit = kHexDigits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    colour = colour * 16 + static_cast<std::uint32_t>(digit);
  }
  return colour;
}
/// A channel of 8 bits of one of 5.
std::int64_t fullColour(std::int64_t channel) { return channel * 8 + channel / 4; }
std::string textOfColour(std::uint32_t colour) {
  std::string text = "#";
  for (int shift = 20; shift >= 0; shift -= 4) text += kHexDigits[colour >> shift & 15];
  return text;
}

/// A double that the number is exactly, where there is one.
std::optional<double> doubleOf(const Json& value) {
  if (!value.is_number()) return std::nullopt;
  const double out = value.get<double>();
  if (!std::isfinite(out)) return std::nullopt;
  if (!value.is_number_float() && std::abs(out) > kMostWhole) return std::nullopt;
  return out;
}
bool isDouble(const Json& value) { return doubleOf(value).has_value(); }
bool isScalar(const Json& value) { return !value.is_structured(); }

bool isNumbers(const Json& list) { return !list.empty() && std::ranges::all_of(list, isDouble); }
/// At least two lists of as many scalars.
bool isTable(const Json& list) {
  if (list.size() < 2 || !list[0].is_array() || list[0].empty()) return false;
  return std::ranges::all_of(list, [&](const Json& row) {
    return row.is_array() && row.size() == list[0].size() && std::ranges::all_of(row, isScalar);
  });
}

Kind kindOf(const Json& value, const Dialect& dialect) {
  switch (value.type()) {
    case Json::value_t::boolean:
      return value.get<bool>() ? Kind::True : Kind::False;
    case Json::value_t::string:
      return dialect.later && colourOf(value.get_ref<const std::string&>()) ? Kind::Colour : Kind::Text;
    case Json::value_t::object:
      return Kind::Object;
    case Json::value_t::array:
      return isNumbers(value) ? Kind::Numbers : isTable(value) ? Kind::Table : Kind::List;
    case Json::value_t::number_float: {
      const auto number = doubleOf(value);
      return number ? Kind::Fraction : Kind::Null;
    }
    case Json::value_t::number_integer:
      return Kind::Whole;
    case Json::value_t::number_unsigned:
      return value.get<std::uint64_t>() <= std::uint64_t{1} << 62 ? Kind::Whole : Kind::Unsigned;
    default:
      return Kind::Null;
  }
}

constexpr int kWordBits = 9;
constexpr std::uint32_t kEnd = 0, kSpelled = 1, kFirstWord = 2;

/// Writes with a BitWriter and reads with a BitReader. Where it reads, the values handed in are not looked at.
class Packer {
 public:
  enum class Direction : std::uint8_t { Writes, Reads };
  Packer(BitCoder& coder, Direction direction, int version, const PackBounds& bounds = {})
      : coder_(coder),
        reads_(direction == Direction::Reads),
        dialect_(dialectOf(version)),
        words_(exampleOf(version).words),
        left_(bounds.values),
        deepest_(bounds.depth) {}

  Json value(const Json& in, std::uint64_t key, int depth);
  /// A text by its letters, each in the context of the one before.
  std::string letters(const std::string& in);
  bool failed() const { return failed_; }

 private:
  /// The place of a number in a list.
  struct Spot {
    std::uint64_t key;
    std::uint32_t mode;
    std::size_t at, count;
    std::array<std::int64_t, 2> away;  ///< the numbers one and two strides before, from the expected one
    std::size_t fromEnd() const { return std::min({at, count - 1 - at, std::size_t{4}}); }
  };
  static std::uint64_t context(std::uint64_t key, Place place, std::uint64_t more = 0) {
    return (key * 16 + static_cast<std::uint64_t>(place)) * 1024 + more;
  }
  /// Counts what is made; after too much of it everything is empty.
  std::size_t allowed(std::uint64_t count) {
    if (count > left_) failed_ = true;
    if (failed_) return 0;
    left_ -= static_cast<std::size_t>(count);
    return static_cast<std::size_t>(count);
  }
  std::uint32_t wordOf(const std::string& text) const;
  /// `coded` is the number of a word, or kSpelled.
  std::string word(const std::string& in, std::uint32_t coded);
  /// The power of two that all of them are multiples of.
  int spread(std::span<const std::int64_t> in, std::uint64_t context);
  double raw(double in) { return std::bit_cast<double>(coder_.plain(64, std::bit_cast<std::uint64_t>(in))); }
  /// What these numbers are divided by; 0: nothing makes them whole.
  std::int64_t divisor(std::span<const double> in, std::uint64_t context);
  BitCoder::Mixed signsAfter(const std::array<std::int64_t, 2>& before, const Spot& spot) const;
  BitCoder::Mixed sizesAfter(const std::array<std::int64_t, 2>& before, const Spot& spot) const;
  std::uint32_t colour(std::uint32_t in, std::uint64_t key);
  double fraction(double in, std::uint64_t key);
  std::vector<double> numbers(std::span<const double> in, std::size_t count, std::uint64_t key);
  bool isTooLarge(std::int64_t guess, std::int64_t off, std::int64_t unit);
  /// In multiples of `unit`, by a mode of kModes that is even or not.
  std::vector<std::int64_t> wholeOnes(std::span<const std::int64_t> in, std::size_t count, std::int64_t unit,
                                      std::uint64_t key, std::uint32_t mode);
  std::vector<std::int64_t> evenOnes(std::span<const std::int64_t> in, std::size_t count, std::int64_t unit,
                                     std::uint64_t key, std::uint32_t mode);
  Json list(const Json& in, std::uint64_t key, int depth);
  Json table(const Json& in, std::uint64_t key, int depth);
  Json object(const Json& in, std::uint64_t key, int depth);

  BitCoder& coder_;
  bool reads_;
  const Dialect& dialect_;
  const std::vector<std::string>& words_;
  bool failed_ = false;
  std::size_t left_;
  int deepest_;
  std::vector<std::string> spelled_;  ///< words by their letters, in the order in which they came
};

/// As toJson has numbers: whole ones without a point.
Json jsonOf(double value) {
  if (std::abs(value) <= kMostWhole && value == std::trunc(value) && !(value == 0 && std::signbit(value))) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

std::uint32_t Packer::wordOf(const std::string& text) const {
  const auto at = std::ranges::lower_bound(words_, text);
  if (at == words_.end() || *at != text) return kSpelled;
  return kFirstWord + static_cast<std::uint32_t>(at - words_.begin());
}

std::string Packer::letters(const std::string& in) {
  const std::size_t length = allowed(coder_.natural(context(0, Place::Length), in.size()));
  std::string out;
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < length; ++i) {
    const std::uint32_t letter = reads_ ? 0 : static_cast<std::uint8_t>(in[i]);
    const std::uint32_t coded = coder_.symbol(context(0, Place::Byte, before), 8, letter);
    out += static_cast<char>(coded);
    before = coded;
  }
  if (validUtf8(out) != out) failed_ = true;
  return out;
}

std::string Packer::word(const std::string& in, std::uint32_t coded) {
  if (coded == kSpelled) {
    if (dialect_.later) {
      const auto known = std::ranges::find(spelled_, in);
      const auto back = known == spelled_.end() ? 0 : static_cast<std::uint64_t>(spelled_.end() - known);
      const std::uint64_t at = coder_.natural(context(0, Place::Byte, 256), back);
      if (at > spelled_.size()) failed_ = true;
      if (failed_) return {};
      if (at > 0) return spelled_[spelled_.size() - static_cast<std::size_t>(at)];
    }
    spelled_.push_back(letters(in));
    return spelled_.back();
  }
  if (coded < kFirstWord || coded - kFirstWord >= words_.size()) {
    failed_ = true;
    return {};
  }
  return words_[coded - kFirstWord];
}

std::int64_t Packer::divisor(std::span<const double> in, std::uint64_t context) {
  const Divisor known = reads_ ? Divisor{} : divisorOf(in, dialect_);
  const std::uint32_t symbol = coder_.symbol(context, dialect_.divisorBits, known.symbol);
  if (symbol < kBits) return kDivisors[symbol];
  if (symbol == kBits) return 0;
  const std::uint64_t by = symbol == kOther ? coder_.natural(context, static_cast<std::uint64_t>(known.by)) : 0;
  if (by >= 1 && by <= kMostOther) return static_cast<std::int64_t>(by);
  failed_ = true;
  return 1;
}

std::uint32_t Packer::colour(std::uint32_t in, std::uint64_t key) {
  if (!dialect_.greyColours) return static_cast<std::uint32_t>(coder_.plain(24, in));
  const auto channel = [&](int shift) { return static_cast<std::int64_t>(in >> shift & 255); };
  const auto isCoarse = [](std::int64_t value) { return value == fullColour(value / 8); };
  const bool coarse =
      coder_.bit(context(key, Place::Mode, 512), isCoarse(channel(0)) && isCoarse(channel(8)) && isCoarse(channel(16)));
  const std::int64_t by = coarse ? 8 : 1;
  const std::int64_t green =
      static_cast<std::int64_t>(coder_.plain(coarse ? 5 : 8, static_cast<std::uint64_t>(channel(8) / by)));
  std::uint32_t out = 0;
  for (const int shift : {16, 8, 0}) {
    std::int64_t value = green;
    if (shift != 8)
      value += coder_.integer(context(key, Place::Mode, (coarse ? 516U : 514U) + (shift == 0 ? 1U : 0U)),
                              channel(shift) / by - channel(8) / by);
    if (value < 0 || value > 255 / by) failed_ = true;
    if (failed_) return 0;
    out |= static_cast<std::uint32_t>(coarse ? fullColour(value) : value) << shift;
  }
  return out;
}

double Packer::fraction(double in, std::uint64_t key) {
  const std::int64_t by = divisor({&in, 1}, context(key, Place::Divisor));
  if (by == 0) return raw(in);
  const std::int64_t whole = reads_ ? 0 : *wholeTimes(in, by);
  return static_cast<double>(coder_.integer(context(key, Place::First), whole)) / static_cast<double>(by);
}

int Packer::spread(std::span<const std::int64_t> in, std::uint64_t context) {
  if (!dialect_.later) return 0;
  std::uint64_t all = 0;
  for (const std::int64_t value : in) all |= static_cast<std::uint64_t>(value);
  const std::uint64_t coded = coder_.natural(context, all == 0 ? 0 : static_cast<std::uint64_t>(std::countr_zero(all)));
  if (coded > kMostSpread) failed_ = true;
  return failed_ ? 0 : static_cast<int>(coded);
}

/// 0…7, of the two differences before.
std::uint64_t sizeOf(const std::array<std::int64_t, 2>& before) {
  const double sum = std::abs(static_cast<double>(before[0])) + std::abs(static_cast<double>(before[1]));
  std::uint64_t size = 0;
  for (double most = 0; size < 7 && sum > most; most = 2 * most + 1) ++size;
  return size;
}

/// What is known of a sign from the two differences before: what was rounded up is rounded down next.
BitCoder::Mixed Packer::signsAfter(const std::array<std::int64_t, 2>& before, const Spot& spot) const {
  const auto within = [](std::int64_t value, std::int64_t most) {
    return static_cast<std::uint64_t>(std::clamp(value, -most, most) + most);
  };
  const std::uint64_t here =
      dialect_.near ? 320 + within(spot.away[0], 3) * 7 + within(spot.away[1], 3) : 144 + spot.mode;
  return {context(0, Place::Rest, 128 + within(before[0], 2) * 3 + within(before[1], 1)),
          context(spot.key, Place::Rest, here),
          context(0, Place::Rest, 160 + within(before[0], 1) * 8 + spot.fromEnd())};
}

/// And of a size.
BitCoder::Mixed Packer::sizesAfter(const std::array<std::int64_t, 2>& before, const Spot& spot) const {
  const Mode& mode = kModes[spot.mode];
  const std::uint64_t near =
      context(spot.key, Place::Rest, 256 + sizeOf({spot.away[0], 0}) * 8 + sizeOf({spot.away[1], 0}));
  const std::uint64_t after = context(0, Place::Rest, (mode.halves ? 3 : mode.order) * 8 + sizeOf(before));
  BitCoder::Mixed sizes = {dialect_.near ? near : after,
                           context(spot.key, Place::Rest, 32 + spot.mode * 2 + spot.at % mode.stride),
                           context(0, Place::Rest, 64 + spot.fromEnd() * 8 + sizeOf({before[0], 0}))};
  sizes.weights = 1;
  return sizes;
}

std::vector<double> Packer::numbers(std::span<const double> in, std::size_t count, std::uint64_t key) {
  const std::int64_t by = divisor(in, context(key, Place::Divisor, 1));
  std::vector<double> out;
  if (by == 0) {
    for (std::size_t i = 0; i < count; ++i) out.push_back(raw(reads_ ? 0 : in[i]));
    return out;
  }
  std::vector<std::int64_t> whole;
  for (std::size_t i = 0; i < in.size() && !reads_; ++i) whole.push_back(*wholeTimes(in[i], by));
  const std::int64_t unit = std::int64_t{1} << spread(whole, context(key, Place::Divisor, 2));
  for (std::int64_t& value : whole) value /= unit;
  const std::uint32_t coded =
      coder_.symbol(context(key, Place::Mode), dialect_.modeBits, reads_ ? 0 : bestMode(whole, dialect_.modes));
  if (coded >= dialect_.modes) {
    failed_ = true;
    return {};
  }
  for (const std::int64_t number :
       kModes[coded].even ? evenOnes(whole, count, unit, key, coded) : wholeOnes(whole, count, unit, key, coded)) {
    out.push_back(static_cast<double>(number * unit) / static_cast<double>(by));
  }
  return out;
}

/// Only numbers that were not written can grow so large.
bool Packer::isTooLarge(std::int64_t guess, std::int64_t off, std::int64_t unit) {
  if (std::abs(static_cast<double>(guess) + static_cast<double>(off)) * static_cast<double>(unit) > kMostWhole)
    failed_ = true;
  return failed_;
}

std::vector<std::int64_t> Packer::wholeOnes(std::span<const std::int64_t> in, std::size_t count, std::int64_t unit,
                                            std::uint64_t key, std::uint32_t coded) {
  const Mode& mode = kModes[coded];
  std::vector<std::int64_t> known;
  std::array<std::int64_t, 2> before{};  // the differences
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t guess = foretold(mode, known, count);
    const bool first = mode.order > 0 && i < mode.stride;
    const std::int64_t difference = reads_ ? 0 : in[i] - guess;
    const auto awayBy = [&](std::size_t back) { return i < back ? 0 : known[i - back] - guess; };
    const Spot spot{key, coded, i, count, {awayBy(mode.stride), awayBy(2 * mode.stride)}};
    std::int64_t off = 0;
    if (first) {
      off = coder_.integer(context(key, Place::First, 1 + i), difference);
    } else if (dialect_.later) {
      off = coder_.integer(sizesAfter(before, spot), signsAfter(before, spot), difference);
    } else {
      off = coder_.integer(context(key, Place::Rest, coded * 2 + i % mode.stride), difference);
    }
    if (!first) before = {off, before[0]};
    if (isTooLarge(guess, off, unit)) return {};
    known.push_back(guess + off);
  }
  return known;
}

std::vector<std::int64_t> Packer::evenOnes(std::span<const std::int64_t> in, std::size_t count, std::int64_t unit,
                                           std::uint64_t key, std::uint32_t coded) {
  const std::uint64_t length =
      coder_.natural(context(key, Place::Mode, 1), reads_ ? 0 : static_cast<std::uint64_t>(EvenLine::lengthOf(in)));
  if (count % 2 != 0 || length > std::uint64_t{EvenLine::kMostLength}) {
    failed_ = true;
    return {};
  }
  EvenLine line(static_cast<std::int64_t>(length), kModes[coded].bend);
  std::array<std::array<std::int64_t, 2>, 2> before{};  // the last differences of first numbers and of others
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t guess = line.expected();
    const std::int64_t difference = reads_ ? 0 : in[i - i % 2 + line.axis()] - guess;
    std::array<std::int64_t, 2>& last = before[i % 2];
    const Spot spot{key, coded, i, count, last};
    std::int64_t off = 0;
    if (i < 4) {
      off = coder_.integer(context(key, Place::First, 1 + i), difference);
    } else {
      off = coder_.integer(sizesAfter(last, spot), signsAfter(last, spot), difference);
      last = {off, last[0]};
    }
    if (isTooLarge(guess, off, unit)) return {};
    line.take(guess + off);
  }
  return {line.numbers().begin(), line.numbers().end()};
}

Json Packer::table(const Json& in, std::uint64_t key, int depth) {
  const std::size_t rows = allowed(coder_.natural(context(key, Place::Count), reads_ ? 0 : in.size()));
  const std::size_t columns = allowed(coder_.natural(context(key, Place::Column), reads_ ? 0 : in[0].size()));
  if (allowed(static_cast<std::uint64_t>(rows) * columns) == 0) {
    failed_ = true;
    return {};
  }
  Json out(std::vector<Json>(rows, Json(std::vector<Json>(columns))));
  for (std::size_t c = 0; c < columns && !failed_; ++c) {
    const std::uint64_t below = key * 64 + 1 + std::min<std::size_t>(c, 62);
    std::vector<double> column;
    for (std::size_t r = 0; r < rows && !reads_ && isDouble(in[r][c]); ++r) column.push_back(in[r][c].get<double>());
    if (coder_.bit(context(below, Place::Column), column.size() == rows)) {
      column = numbers(column, rows, below);
      for (std::size_t r = 0; r < column.size(); ++r) out[r][c] = jsonOf(column[r]);
    } else {
      for (std::size_t r = 0; r < rows && !failed_; ++r) {
        const bool like = !reads_ && r > 0 && in[r][c] == in[r - 1][c];
        const std::uint64_t place = dialect_.halved && 2 * r == rows ? 2 : 1;
        if (dialect_.later && r > 0 && coder_.bit(context(below, Place::Column, place), like)) {
          out[r][c] = out[r - 1][c];
        } else {
          out[r][c] = value(reads_ ? Json() : in[r][c], below, depth);
        }
      }
    }
  }
  return out;
}

Json Packer::list(const Json& in, std::uint64_t key, int depth) {
  const std::size_t count = allowed(coder_.natural(context(key, Place::Count, 1), in.size()));
  Json out = Json::array();
  for (std::size_t i = 0; i < count && !failed_; ++i) {
    out.push_back(value(reads_ ? Json() : in[i], key * 64 + 63, depth));
  }
  return out;
}

Json Packer::object(const Json& in, std::uint64_t key, int depth) {
  Json out = Json::object();
  auto member = in.begin();
  std::uint32_t before = kEnd;
  while (!failed_) {
    const bool more = !reads_ && member != in.end();
    const std::string name = more ? member.key() : std::string();
    const std::uint64_t where = context(key, Place::Key, before);
    const std::uint32_t coded = coder_.symbol(where, kWordBits, more ? wordOf(name) : kEnd);
    if (coded == kEnd) break;
    const std::string read = word(name, coded);
    if (allowed(1) == 0) break;
    out[read] = value(more ? *member : Json(), coded + 1, depth);
    if (more) ++member;
    before = coded;
  }
  return out;
}

Json Packer::value(const Json& in, std::uint64_t key, int depth) {
  if (depth > deepest_ || allowed(1) == 0) {
    failed_ = true;
    return {};
  }
  const auto written = static_cast<std::uint32_t>(reads_ ? Kind::Null : kindOf(in, dialect_));
  const auto kind = static_cast<Kind>(coder_.symbol(context(key, Place::Kind), kKindBits, written));
  switch (kind) {
    case Kind::Null:
      return {};
    case Kind::False:
      return false;
    case Kind::True:
      return true;
    case Kind::Whole:
      return coder_.integer(context(key, Place::First), reads_ ? 0 : in.get<std::int64_t>());
    case Kind::Fraction:
      return fraction(reads_ ? 0 : in.get<double>(), key);
    case Kind::Unsigned:
      return coder_.plain(64, reads_ ? 0 : in.get<std::uint64_t>());
    case Kind::Text: {
      const std::string text = reads_ ? std::string() : in.get<std::string>();
      return word(text, coder_.symbol(context(key, Place::Word), kWordBits, wordOf(text)));
    }
    case Kind::Numbers: {
      const std::size_t count = allowed(coder_.natural(context(key, Place::Length), in.size()));
      const std::vector<double> known = reads_ ? std::vector<double>() : in.get<std::vector<double>>();
      Json out = Json::array();
      for (const double number : numbers(known, count, key)) out.push_back(jsonOf(number));
      return out;
    }
    case Kind::Table:
      return table(in, key, depth + 1);
    case Kind::List:
      return list(in, key, depth + 1);
    case Kind::Object:
      return object(in, key, depth + 1);
    case Kind::Colour:
      return textOfColour(colour(reads_ ? 0 : colourOf(in.get_ref<const std::string&>()).value_or(0), key));
  }
  failed_ = true;
  return {};
}

/// What is learned from the example: text and numbers of a usual document.
template <int version>
const Chances& learnedOnce() {
  static const Chances made = [] {
    BitLearner learner(Chances{{}, {}, dialectOf(version).pace});
    if (dialectOf(version).later) {
      Packer packer(learner, Packer::Direction::Writes, version);
      for (const std::string& word : exampleOf(version).words) packer.letters(word);
    }
    for (const Json& document : exampleOf(version).documents) {
      Packer(learner, Packer::Direction::Writes, version).value(document, 0, 0);
    }
    return learner.chances();
  }();
  return made;
}
const Chances& learned(int version) {
  static constexpr std::array kOnce{learnedOnce<1>, learnedOnce<2>, learnedOnce<3>,
                                    learnedOnce<4>, learnedOnce<5>, learnedOnce<6>};
  static_assert(kOnce.size() == kPackedVersion);
  return kOnce[static_cast<std::size_t>(version - 1)]();
}

}  // namespace

bool isPackedWord(std::string_view text) {
  return std::ranges::binary_search(exampleOf(kPackedVersion).words, text, std::less<>());
}

Result<std::vector<std::uint8_t>> packJson(const Json& value, const PackBounds& bounds, int version) {
  BitWriter writer(learned(version));
  Packer packer(writer, Packer::Direction::Writes, version, bounds);
  packer.value(value, 0, 0);
  if (packer.failed()) return Error::OutOfMemory;
  return writer.finish();
}

Result<Json> unpackJson(std::span<const std::uint8_t> bytes, int version) {
  if (version < 1 || version > kPackedVersion) return Error::ProjectTooNew;
  BitReader reader(bytes, learned(version));
  Packer packer(reader, Packer::Direction::Reads, version);
  Json value = packer.value({}, 0, 0);
  if (packer.failed()) return Error::ProjectInvalid;
  return value;
}

}  // namespace spineloft::io
