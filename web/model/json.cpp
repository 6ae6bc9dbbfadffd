#include "web/model/json.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>

namespace spineloft::app {
namespace {

constexpr std::size_t kMaxText = std::size_t{16} << 20;
constexpr int kMaxDepth = 32;

void appendUtf8(std::string& out, std::uint32_t code) {
  if (code >= 0xd800 && code <= 0xdfff) code = 0xfffd;
  if (code < 0x80) {
    out += static_cast<char>(code);
  } else if (code < 0x800) {
    out += static_cast<char>(0xc0 | (code >> 6));
    out += static_cast<char>(0x80 | (code & 0x3f));
  } else if (code < 0x10000) {
    out += static_cast<char>(0xe0 | (code >> 12));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    out += static_cast<char>(0x80 | (code & 0x3f));
  } else {
    out += static_cast<char>(0xf0 | (code >> 18));
    out += static_cast<char>(0x80 | ((code >> 12) & 0x3f));
    out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
    out += static_cast<char>(0x80 | (code & 0x3f));
  }
}

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  std::optional<Json> document() {
    std::optional<Json> value = read(0);
    skipSpace();
    if (!value || at_ != text_.size()) return std::nullopt;
    return value;
  }

 private:
  void skipSpace() {
    while (at_ < text_.size() &&
           (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n' || text_[at_] == '\r')) {
      ++at_;
    }
  }
  bool take(char c) {
    skipSpace();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  bool takeWord(std::string_view word) {
    if (text_.substr(at_, word.size()) != word) return false;
    at_ += word.size();
    return true;
  }

  std::optional<Json> read(int depth) {
    skipSpace();
    if (depth > kMaxDepth || at_ >= text_.size()) return std::nullopt;
    switch (text_[at_]) {
      case '{':
        return readObject(depth);
      case '[':
        return readArray(depth);
      case '"': {
        std::optional<std::string> text = readText();
        if (!text) return std::nullopt;
        return Json(std::move(*text));
      }
      case 't':
        return takeWord("true") ? std::optional<Json>(Json(true)) : std::nullopt;
      case 'f':
        return takeWord("false") ? std::optional<Json>(Json(false)) : std::nullopt;
      case 'n':
        return takeWord("null") ? std::optional<Json>(Json()) : std::nullopt;
      default:
        return readNumber();
    }
  }

  std::optional<Json> readArray(int depth) {
    Json::Array values;
    ++at_;
    if (take(']')) return Json(std::move(values));
    do {
      std::optional<Json> value = read(depth + 1);
      if (!value) return std::nullopt;
      values.push_back(std::move(*value));
    } while (take(','));
    if (!take(']')) return std::nullopt;
    return Json(std::move(values));
  }

  std::optional<Json> readObject(int depth) {
    Json::Object members;
    ++at_;
    if (take('}')) return Json(std::move(members));
    do {
      skipSpace();
      std::optional<std::string> name = readText();
      if (!name || !take(':')) return std::nullopt;
      std::optional<Json> value = read(depth + 1);
      if (!value) return std::nullopt;
      members.emplace_back(std::move(*name), std::move(*value));
    } while (take(','));
    if (!take('}')) return std::nullopt;
    return Json(std::move(members));
  }

  std::optional<Json> readNumber() {
    const char first = text_[at_];
    if (first != '-' && (first < '0' || first > '9')) return std::nullopt;  // no "inf", no "+1"
    double value = 0;
    const char* begin = text_.data() + at_;
    const char* end = text_.data() + text_.size();
    // strtod-free and locale-free; libc++ 19 lacks from_chars for double, so digits are read here.
    const char* p = begin;
    const bool negative = *p == '-';
    if (negative) ++p;
    if (p == end || *p < '0' || *p > '9') return std::nullopt;
    int exponent = 0;
    while (p < end && *p >= '0' && *p <= '9') value = value * 10 + (*p++ - '0');
    if (p < end && *p == '.') {
      const char* fraction = ++p;
      while (p < end && *p >= '0' && *p <= '9') {
        value = value * 10 + (*p++ - '0');
        --exponent;
      }
      if (p == fraction) return std::nullopt;
    }
    if (p < end && (*p == 'e' || *p == 'E')) {
      ++p;
      if (p < end && *p == '+') ++p;
      int power = 0;
      const auto parsed = std::from_chars(p, end, power);
      if (parsed.ec == std::errc::invalid_argument) return std::nullopt;
      if (parsed.ec == std::errc::result_out_of_range) power = *p == '-' ? -100000 : 100000;
      p = parsed.ptr;
      exponent += power;
    }
    // Dividing by an exact power of ten rounds once; multiplying by its reciprocal would twice.
    if (value != 0 && exponent < 0) value /= std::pow(10.0, -exponent);
    if (value != 0 && exponent > 0) value *= std::pow(10.0, exponent);
    at_ += static_cast<std::size_t>(p - begin);
    return Json(negative ? -value : value);
  }

  std::optional<std::uint32_t> readHex4() {
    std::uint32_t code = 0;
    if (text_.size() - at_ < 4) return std::nullopt;
    const auto parsed = std::from_chars(text_.data() + at_, text_.data() + at_ + 4, code, 16);
    if (parsed.ptr != text_.data() + at_ + 4) return std::nullopt;
    at_ += 4;
    return code;
  }

  bool readEscape(std::string& out) {
    if (at_ >= text_.size()) return false;
    static constexpr std::string_view kFrom = "\"\\/bfnrt", kTo = "\"\\/\b\f\n\r\t";
    const char c = text_[at_++];
    if (const std::size_t i = kFrom.find(c); i != std::string_view::npos) {
      out += kTo[i];
      return true;
    }
    if (c != 'u') return false;
    std::optional<std::uint32_t> code = readHex4();
    if (!code) return false;
    if (*code >= 0xd800 && *code < 0xdc00 && takeWord("\\u")) {
      const std::optional<std::uint32_t> low = readHex4();
      if (!low) return false;
      if (*low >= 0xdc00 && *low < 0xe000) {
        code = 0x10000 + ((*code - 0xd800) << 10) + (*low - 0xdc00);
      } else {
        appendUtf8(out, 0xfffd);
        code = low;
      }
    }
    appendUtf8(out, *code);
    return true;
  }

  std::optional<std::string> readText() {
    if (at_ >= text_.size() || text_[at_] != '"') return std::nullopt;
    ++at_;
    std::string out;
    while (at_ < text_.size()) {
      const char c = text_[at_++];
      if (c == '"') return out;
      if (static_cast<unsigned char>(c) < 0x20) return std::nullopt;
      if (c != '\\') {
        out += c;
      } else if (!readEscape(out)) {
        return std::nullopt;
      }
    }
    return std::nullopt;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

bool Json::operator==(const Json& other) const { return value_ == other.value_; }

std::optional<Json> Json::parse(std::string_view text) {
  if (text.size() > kMaxText) return std::nullopt;
  return Reader(text).document();
}

std::optional<double> Json::number() const {
  const double* value = std::get_if<double>(&value_);
  return value ? std::optional(*value) : std::nullopt;
}
std::optional<bool> Json::flag() const {
  const bool* value = std::get_if<bool>(&value_);
  return value ? std::optional(*value) : std::nullopt;
}

const Json* Json::find(std::string_view key) const {
  if (const Object* members = object()) {
    for (const auto& [name, value] : *members) {
      if (name == key) return &value;
    }
  }
  return nullptr;
}
std::optional<double> Json::number(std::string_view key) const {
  const Json* value = find(key);
  return value ? value->number() : std::nullopt;
}
std::optional<bool> Json::flag(std::string_view key) const {
  const Json* value = find(key);
  return value ? value->flag() : std::nullopt;
}
const std::string* Json::text(std::string_view key) const {
  const Json* value = find(key);
  return value ? value->text() : nullptr;
}

void JsonWriter::separate() {
  if (needsComma_) out_ += ',';
  needsComma_ = true;
}
JsonWriter& JsonWriter::open(char bracket) {
  separate();
  out_ += bracket;
  needsComma_ = false;
  return *this;
}
JsonWriter& JsonWriter::close(char bracket) {
  out_ += bracket;
  needsComma_ = true;
  return *this;
}
JsonWriter& JsonWriter::key(std::string_view name) {
  separate();
  quote(name);
  out_ += ':';
  needsComma_ = false;
  return *this;
}
JsonWriter& JsonWriter::text(std::string_view value) {
  separate();
  quote(value);
  return *this;
}
JsonWriter& JsonWriter::number(double value) {
  if (!std::isfinite(value)) return null();
  separate();
  char digits[40];
  const bool whole = value == std::floor(value) && std::fabs(value) < 1e15;
  const int length = std::snprintf(digits, sizeof digits, whole ? "%.0f" : "%.9g", value);
  out_.append(digits, static_cast<std::size_t>(length));
  return *this;
}
JsonWriter& JsonWriter::flag(bool value) {
  separate();
  out_ += value ? "true" : "false";
  return *this;
}
JsonWriter& JsonWriter::null() {
  separate();
  out_ += "null";
  return *this;
}
JsonWriter& JsonWriter::value(const Json& value) {
  if (const Json::Object* members = value.object()) {
    beginObject();
    for (const auto& [name, member] : *members) key(name).value(member);
    return endObject();
  }
  if (const Json::Array* entries = value.array()) {
    beginArray();
    for (const Json& entry : *entries) this->value(entry);
    return endArray();
  }
  if (const std::string* words = value.text()) return text(*words);
  if (const std::optional<bool> on = value.flag()) return flag(*on);
  if (const std::optional<double> n = value.number()) return number(*n);
  return null();
}

void JsonWriter::clear() {
  out_.clear();
  needsComma_ = false;
}

void JsonWriter::quote(std::string_view text) {
  out_ += '"';
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') {
      out_ += '\\';
      out_ += c;
    } else if (byte < 0x20) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", byte);
      out_ += escape;
    } else {
      out_ += c;
    }
  }
  out_ += '"';
}

}  // namespace spineloft::app
