// JSON as the page's contract needs it: a small value type with lenient readers, and a writer that builds no tree. The
// library reads and writes the texts.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace spineloft::app {

/// A JSON value.
class Json {
 public:
  using Array = std::vector<Json>;
  using Object = std::vector<std::pair<std::string, Json>>;

  Json() = default;
  Json(bool value) : value_(value) {}
  Json(double value) : value_(value) {}
  Json(int value) : value_(static_cast<double>(value)) {}
  Json(std::uint32_t value) : value_(static_cast<double>(value)) {}
  Json(std::string value) : value_(std::move(value)) {}
  Json(std::string_view value) : value_(std::string(value)) {}
  Json(const char* value) : value_(std::string(value)) {}
  Json(Array value) : value_(std::move(value)) {}
  Json(Object value) : value_(std::move(value)) {}
  bool operator==(const Json&) const;

  /// The value of a text; none for anything that is not exactly one JSON value (a number too large for a double is
  /// none), for nesting deeper than 32 and for texts longer than 16 MiB.
  static std::optional<Json> parse(std::string_view text);

  bool isNull() const { return value_.index() == 0; }
  const Array* array() const { return std::get_if<Array>(&value_); }
  const Object* object() const { return std::get_if<Object>(&value_); }
  std::optional<double> number() const;
  std::optional<bool> flag() const;
  const std::string* text() const { return std::get_if<std::string>(&value_); }

  /// A member of an object; null when there is none or this is no object.
  const Json* find(std::string_view key) const;
  std::optional<double> number(std::string_view key) const;
  std::optional<bool> flag(std::string_view key) const;
  const std::string* text(std::string_view key) const;

 private:
  std::variant<std::monostate, bool, double, std::string, Array, Object> value_;
};

/// A number as people type it: as in JSON, with zeros before it if they like. None for anything else.
std::optional<double> numberFrom(std::string_view typed);

/// Writes JSON into one growing text; commas are its business. Every number reads back exactly; those that are not
/// finite become null. Bytes that are no UTF-8 become U+FFFD.
class JsonWriter {
 public:
  JsonWriter& beginObject() { return open('{'); }
  JsonWriter& endObject() { return close('}'); }
  JsonWriter& beginArray() { return open('['); }
  JsonWriter& endArray() { return close(']'); }
  JsonWriter& key(std::string_view name);
  JsonWriter& text(std::string_view value);
  JsonWriter& number(double value);
  JsonWriter& flag(bool value);
  JsonWriter& null();
  JsonWriter& value(const Json& value);

  const std::string& json() const { return out_; }
  /// Forgets the text and keeps its memory.
  void clear();

 private:
  JsonWriter& open(char bracket);
  JsonWriter& close(char bracket);
  void separate();
  void quote(std::string_view text);
  std::string out_;
  bool needsComma_ = false;
};

}  // namespace spineloft::app
