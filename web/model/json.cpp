#include "web/model/json.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

namespace spineloft::app {
namespace {

using Library = nlohmann::json;

constexpr std::size_t kMaxText = std::size_t{16} << 20;
constexpr int kMaxDepth = 32;

std::optional<Json> from(const Library& read, int depth) {
  if (depth > kMaxDepth) return std::nullopt;
  switch (read.type()) {
    case Library::value_t::boolean:
      return Json(read.get<bool>());
    case Library::value_t::number_integer:
    case Library::value_t::number_unsigned:
    case Library::value_t::number_float:
      return Json(read.get<double>());
    case Library::value_t::string:
      return Json(read.get_ref<const std::string&>());
    case Library::value_t::array: {
      Json::Array values;
      values.reserve(read.size());
      for (const Library& each : read) {
        std::optional<Json> value = from(each, depth + 1);
        if (!value) return std::nullopt;
        values.push_back(std::move(*value));
      }
      return Json(std::move(values));
    }
    case Library::value_t::object: {
      Json::Object members;
      for (const auto& [name, each] : read.get_ref<const Library::object_t&>()) {
        std::optional<Json> value = from(each, depth + 1);
        if (!value) return std::nullopt;
        members.emplace_back(name, std::move(*value));
      }
      return Json(std::move(members));
    }
    case Library::value_t::null:
      return Json();
    case Library::value_t::binary:
    case Library::value_t::discarded:
      break;
  }
  return std::nullopt;
}

}  // namespace

bool Json::operator==(const Json& other) const { return value_ == other.value_; }

std::optional<Json> Json::parse(std::string_view text) {
  if (text.size() > kMaxText) return std::nullopt;
  return from(Library::parse(text.begin(), text.end(), nullptr, false), 0);
}

std::optional<double> numberFrom(std::string_view typed) {
  const bool negative = typed.starts_with('-');
  if (negative) typed.remove_prefix(1);
  while (typed.size() > 1 && typed[0] == '0' && typed[1] >= '0' && typed[1] <= '9') typed.remove_prefix(1);
  const std::optional<Json> value = typed.starts_with('-') ? std::nullopt : Json::parse(typed);
  if (!value || !value->number()) return std::nullopt;
  return negative ? -*value->number() : *value->number();
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
  const bool whole = value == std::floor(value) && std::fabs(value) < 1e15 && !(value == 0 && std::signbit(value));
  out_ += whole ? Library(static_cast<std::int64_t>(value)).dump() : Library(value).dump();
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
  out_ += Library(text).dump(-1, ' ', false, Library::error_handler_t::replace);
}

}  // namespace spineloft::app
