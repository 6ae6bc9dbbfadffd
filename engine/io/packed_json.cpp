#include "engine/io/packed_json.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "engine/base/text.h"
#include "engine/io/bit_coder.h"
#include "engine/io/packed_example.h"

namespace spineloft::io {
namespace {

using Json = nlohmann::json;

/// What a value is written as.
enum class Kind : std::uint8_t { Null, False, True, Whole, Fraction, Unsigned, Text, Numbers, Table, List, Object };
constexpr int kKindBits = 4;

/// Contexts, above the key that a value stands at.
enum class Place : std::uint64_t { Kind, Key, Word, Length, Byte, Divisor, Mode, First, Rest, Column, Count };

/// A number is a whole number divided by one of these, or else its 64 bits.
constexpr std::array<std::int64_t, 31> kDivisors = {
    1,      2,      4,       8,       10,       16,       32,        64,        100,       128,   256,
    500,    512,    1000,    1024,    2048,     4096,     8192,      10000,     16384,     32768, 65536,
    100000, 131072, 1000000, 1048576, 10000000, 16777216, 100000000, 268435456, 1000000000};
constexpr std::uint32_t kBits = kDivisors.size();  ///< stands for: the bits themselves
constexpr int kDivisorBits = 5;
/// Whole numbers up to here are differences without overflow, and exact as doubles.
constexpr double kMostWhole = 1125899906842624;  // 2⁵⁰

/// How a list of numbers is foretold: `order` numbers (0…2), `stride` places apart.
struct Mode {
  std::size_t order = 0, stride = 1;
};
constexpr std::array<Mode, 5> kModes{{{0, 1}, {1, 1}, {2, 1}, {1, 2}, {2, 2}}};
constexpr int kModeBits = 3;

std::int64_t foretold(const Mode& mode, std::span<const std::int64_t> before) {
  const std::size_t i = before.size(), s = mode.stride;
  if (mode.order == 0 || i < s) return 0;
  if (mode.order == 1 || i < 2 * s) return before[i - s];
  return 2 * before[i - s] - before[i - 2 * s];
}

std::optional<std::int64_t> wholeTimes(double value, std::int64_t divisor) {
  const auto by = static_cast<double>(divisor);
  const double scaled = value * by;
  if (!(std::abs(scaled) <= kMostWhole)) return std::nullopt;
  const double whole = std::round(scaled);
  if (whole / by != value || (whole == 0 && std::signbit(value))) return std::nullopt;
  return static_cast<std::int64_t>(whole);
}

/// The first divisor that makes all of them whole; kBits without one.
std::uint32_t divisorOf(std::span<const double> values) {
  for (std::uint32_t d = 0; d < kDivisors.size(); ++d) {
    if (std::ranges::all_of(values, [&](double v) { return wholeTimes(v, kDivisors[d]).has_value(); })) return d;
  }
  return kBits;
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

Kind kindOf(const Json& value) {
  switch (value.type()) {
    case Json::value_t::boolean:
      return value.get<bool>() ? Kind::True : Kind::False;
    case Json::value_t::string:
      return Kind::Text;
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

void collectWords(const Json& value, std::set<std::string>& words) {
  if (value.is_string()) words.insert(value.get<std::string>());
  if (!value.is_structured()) return;
  for (const auto& [key, element] : value.items()) {
    if (value.is_object()) words.insert(key);
    collectWords(element, words);
  }
}

/// The example, and the words in it: a word is coded by its number, others by their letters.
struct Example {
  Json json;
  std::vector<std::string> words;
};
const Example& example() {
  static const Example made = [] {
    Example out{Json::parse(kPackedExample, nullptr, false), {}};
    std::set<std::string> words;
    collectWords(out.json, words);
    out.words.assign(words.begin(), words.end());
    return out;
  }();
  return made;
}
constexpr int kWordBits = 9;
constexpr std::uint32_t kEnd = 0, kSpelled = 1, kFirstWord = 2;

/// Writes with a BitWriter and reads with a BitReader. Where it reads, the values handed in are not looked at.
class Packer {
 public:
  enum class Direction : std::uint8_t { Writes, Reads };
  Packer(BitCoder& coder, Direction direction) : coder_(coder), reads_(direction == Direction::Reads) {}

  Json value(const Json& in, std::uint64_t key, int depth);
  bool failed() const { return failed_; }

 private:
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
  std::string letters(const std::string& in);
  double raw(double in) { return std::bit_cast<double>(coder_.plain(64, std::bit_cast<std::uint64_t>(in))); }
  double fraction(double in, std::uint64_t key);
  std::vector<double> numbers(std::span<const double> in, std::size_t count, std::uint64_t key);
  Json list(const Json& in, std::uint64_t key, int depth);
  Json table(const Json& in, std::uint64_t key, int depth);
  Json object(const Json& in, std::uint64_t key, int depth);

  BitCoder& coder_;
  bool reads_;
  bool failed_ = false;
  std::size_t left_ = kMostPacked;
};

/// As toJson has numbers: whole ones without a point.
Json jsonOf(double value) {
  if (std::abs(value) <= kMostWhole && value == std::trunc(value) && !(value == 0 && std::signbit(value))) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

std::uint32_t Packer::wordOf(const std::string& text) const {
  const auto& words = example().words;
  const auto at = std::ranges::lower_bound(words, text);
  if (at == words.end() || *at != text) return kSpelled;
  return kFirstWord + static_cast<std::uint32_t>(at - words.begin());
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
  if (coded == kSpelled) return letters(in);
  const auto& words = example().words;
  if (coded < kFirstWord || coded - kFirstWord >= words.size()) {
    failed_ = true;
    return {};
  }
  return words[coded - kFirstWord];
}

double Packer::fraction(double in, std::uint64_t key) {
  const std::uint32_t divisor =
      coder_.symbol(context(key, Place::Divisor), kDivisorBits, reads_ ? 0 : divisorOf({&in, 1}));
  if (divisor == kBits) return raw(in);
  const std::int64_t whole = reads_ ? 0 : *wholeTimes(in, kDivisors[divisor]);
  return static_cast<double>(coder_.integer(context(key, Place::First), whole)) /
         static_cast<double>(kDivisors[divisor]);
}

std::uint32_t bestMode(std::span<const std::int64_t> values) {
  std::uint32_t best = 0;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (std::uint32_t m = 0; m < kModes.size(); ++m) {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const std::int64_t off = values[i] - foretold(kModes[m], values.first(i));
      bits += 2 * static_cast<std::uint64_t>(std::bit_width(static_cast<std::uint64_t>(std::abs(off))));
    }
    if (bits < least) {
      least = bits;
      best = m;
    }
  }
  return best;
}

std::vector<double> Packer::numbers(std::span<const double> in, std::size_t count, std::uint64_t key) {
  const std::uint32_t divisor =
      coder_.symbol(context(key, Place::Divisor, 1), kDivisorBits, reads_ ? 0 : divisorOf(in));
  std::vector<double> out;
  if (divisor == kBits) {
    for (std::size_t i = 0; i < count; ++i) out.push_back(raw(reads_ ? 0 : in[i]));
    return out;
  }
  const auto by = static_cast<double>(kDivisors[divisor]);
  std::vector<std::int64_t> whole;
  for (std::size_t i = 0; i < in.size() && !reads_; ++i) whole.push_back(*wholeTimes(in[i], kDivisors[divisor]));
  const std::uint32_t coded = coder_.symbol(context(key, Place::Mode), kModeBits, reads_ ? 0 : bestMode(whole));
  if (coded >= kModes.size()) {
    failed_ = true;
    return {};
  }
  const Mode& mode = kModes[coded];
  std::vector<std::int64_t> known;
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t guess = foretold(mode, known);
    const bool first = mode.order > 0 && i < mode.stride;
    const std::uint64_t where =
        first ? context(key, Place::First, 1 + i) : context(key, Place::Rest, coded * 2 + i % mode.stride);
    const std::int64_t off = coder_.integer(where, reads_ ? 0 : whole[i] - guess);
    // Only numbers that were not written can grow so large.
    if (std::abs(static_cast<double>(guess) + static_cast<double>(off)) > kMostWhole) {
      failed_ = true;
      return {};
    }
    known.push_back(guess + off);
    out.push_back(static_cast<double>(known.back()) / by);
  }
  return out;
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
      for (std::size_t r = 0; r < rows && !failed_; ++r) out[r][c] = value(reads_ ? Json() : in[r][c], below, depth);
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
  if (depth > kMostPackedDepth || allowed(1) == 0) {
    failed_ = true;
    return {};
  }
  const auto written = static_cast<std::uint32_t>(reads_ ? Kind::Null : kindOf(in));
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
  }
  failed_ = true;
  return {};
}

/// What is learned from the example: text and numbers of a usual document.
const Chances& learned() {
  static const Chances made = [] {
    BitLearner learner;
    Packer(learner, Packer::Direction::Writes).value(example().json, 0, 0);
    return learner.chances();
  }();
  return made;
}

}  // namespace

bool isPackedWord(std::string_view text) { return std::ranges::binary_search(example().words, text, std::less<>()); }

Result<std::vector<std::uint8_t>> packJson(const Json& value) {
  BitWriter writer(learned());
  Packer packer(writer, Packer::Direction::Writes);
  packer.value(value, 0, 0);
  if (packer.failed()) return Error::OutOfMemory;
  return writer.finish();
}

Result<Json> unpackJson(std::span<const std::uint8_t> bytes) {
  BitReader reader(bytes, learned());
  Packer packer(reader, Packer::Direction::Reads);
  Json value = packer.value({}, 0, 0);
  if (packer.failed()) return Error::ProjectInvalid;
  return value;
}

}  // namespace spineloft::io
