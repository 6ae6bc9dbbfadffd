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
#include "engine/io/foretold.h"
#include "engine/io/packed_example.h"
#include "engine/io/packed_parts.h"
#include "engine/io/packed_traces.h"

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

/// What the versions of the text differ in.
struct Dialect {
  std::size_t modes;  ///< so many of kModes
  int modeBits;       ///< of the number of a mode
  int divisorBits;    ///< of the number of a divisor
  /// kOther, Kind::Colour, a bit for what is as in the row above, lists of multiples of a power of two, words that were
  /// spelled before, and a difference is coded after what the two before tell.
  bool later;
  bool near;                                 ///< and after how far the two numbers before are from the expected one
  std::uint32_t firstWeight;                 ///< Chances::firstWeight
  std::array<std::string_view, 8> examples;  ///< what both sides know beforehand, what is most usual last
  bool traced;                               ///< and then tracedModels(), whose words are spelled
  bool halved;                               ///< a row in the middle of a table may begin anew
};
constexpr std::array<Dialect, 4> kDialects{{
    {5, 3, 5, false, false, 8, {kPackedExample}, false, false},
    {8,
     3,
     6,
     true,
     false,
     8,
     {kPackedExample, kPackedPart1, kPackedPart2, kPackedPart3, kPackedPart4, kPackedPart5, kPackedPart6, kPackedPart7},
     false,
     false},
    {9, 4, 6, true, true, 5, {kPackedExample}, true, false},
    {11, 4, 6, true, true, 5, {kPackedExample}, true, true},
}};

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

void collectWords(const Json& value, std::set<std::string>& words) {
  if (value.is_string()) words.insert(value.get<std::string>());
  if (!value.is_structured()) return;
  for (const auto& [key, element] : value.items()) {
    if (value.is_object()) words.insert(key);
    collectWords(element, words);
  }
}

/// The examples, and the words in them: a word is coded by its number, others by their letters.
struct Example {
  std::vector<Json> documents;
  std::vector<std::string> words;
};
template <int version>
const Example& exampleOnce() {
  static const Example made = [] {
    Example out;
    std::set<std::string> words;
    for (const std::string_view text : kDialects[version - 1].examples) {
      if (text.empty()) continue;
      out.documents.push_back(Json::parse(text, nullptr, false));
      collectWords(out.documents.back(), words);
    }
    out.words.assign(words.begin(), words.end());
    if (kDialects[version - 1].traced) std::ranges::move(tracedModels(), std::back_inserter(out.documents));
    return out;
  }();
  return made;
}
const Example& exampleOf(int version) {
  return version == 1   ? exampleOnce<1>()
         : version == 2 ? exampleOnce<2>()
         : version == 3 ? exampleOnce<3>()
                        : exampleOnce<4>();
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
        dialect_(kDialects[static_cast<std::size_t>(version - 1)]),
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
  double fraction(double in, std::uint64_t key);
  std::vector<double> numbers(std::span<const double> in, std::size_t count, std::uint64_t key);
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
  const Mode& mode = kModes[coded];
  std::vector<std::int64_t> known;
  std::array<std::int64_t, 2> before{};  // the differences
  for (std::size_t i = 0; i < count; ++i) {
    const std::int64_t guess = foretold(mode, known, count);
    const bool first = mode.order > 0 && i < mode.stride;
    const std::int64_t difference = reads_ ? 0 : whole[i] - guess;
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
    // Only numbers that were not written can grow so large.
    if (std::abs(static_cast<double>(guess) + static_cast<double>(off)) * static_cast<double>(unit) > kMostWhole) {
      failed_ = true;
      return {};
    }
    known.push_back(guess + off);
    out.push_back(static_cast<double>(known.back() * unit) / static_cast<double>(by));
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
    case Kind::Colour: {
      const std::uint32_t known = reads_ ? 0 : colourOf(in.get_ref<const std::string&>()).value_or(0);
      return textOfColour(static_cast<std::uint32_t>(coder_.plain(24, known)));
    }
  }
  failed_ = true;
  return {};
}

/// What is learned from the example: text and numbers of a usual document.
template <int version>
const Chances& learnedOnce() {
  static const Chances made = [] {
    BitLearner learner(Chances{{}, {}, kDialects[version - 1].firstWeight});
    if (kDialects[version - 1].later) {
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
  return version == 1   ? learnedOnce<1>()
         : version == 2 ? learnedOnce<2>()
         : version == 3 ? learnedOnce<3>()
                        : learnedOnce<4>();
}

}  // namespace

bool isPackedWord(std::string_view text) {
  return std::ranges::binary_search(exampleOf(kPackedVersion).words, text, std::less<>());
}

Result<std::vector<std::uint8_t>> packJson(const Json& value, const PackBounds& bounds) {
  BitWriter writer(learned(kPackedVersion));
  Packer packer(writer, Packer::Direction::Writes, kPackedVersion, bounds);
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
