#include "engine/io/json_diff.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

namespace spineloft::io {
namespace {

using Json = nlohmann::json;

Json replaced(const Json& value) { return Json::array({"=", value}); }

Json objectDifference(const Json& before, const Json& after) {
  Json changes = Json::object();
  for (const auto& [key, value] : before.items()) {
    const auto now = after.find(key);
    if (now == after.end()) {
      changes[key] = Json::array({"-"});
    } else if (value != *now) {
      changes[key] = difference(value, *now);
    }
  }
  for (const auto& [key, value] : after.items()) {
    if (!before.contains(key)) changes[key] = replaced(value);
  }
  return Json::array({"~", std::move(changes)});
}

Json listDifference(const Json& before, const Json& after) {
  const std::size_t most = std::min(before.size(), after.size());
  std::size_t head = 0, tail = 0;
  while (head < most && before[head] == after[head]) ++head;
  while (tail < most - head && before[before.size() - 1 - tail] == after[after.size() - 1 - tail]) {
    ++tail;
  }
  const bool one = before.size() == after.size() && head + tail + 1 == after.size();
  if (one && before[head].is_structured() && after[head].is_structured()) {
    return Json::array({"@", head, difference(before[head], after[head])});
  }
  if (head + tail == 0) return replaced(after);
  const Json::array_t& all = after.get_ref<const Json::array_t&>();
  Json::array_t middle(all.begin() + static_cast<std::ptrdiff_t>(head), all.end() - static_cast<std::ptrdiff_t>(tail));
  return Json::array({"+", head, tail, std::move(middle)});
}

bool applyToObject(Json& value, const Json& changes) {
  if (!value.is_object() || !changes.is_object()) return false;
  for (const auto& [key, change] : changes.items()) {
    if (change.is_array() && change.size() == 1 && change[0] == "-") {
      if (value.erase(key) == 0) return false;
      continue;
    }
    const auto at = value.find(key);
    if (at == value.end()) {
      // Nothing is there yet: it can only be put there.
      if (!change.is_array() || change.size() != 2 || change[0] != "=") return false;
      value[key] = change[1];
    } else if (!applyDifference(*at, change)) {
      return false;
    }
  }
  return true;
}

bool splice(Json& value, const Json& change) {
  if (!value.is_array() || !change[1].is_number_unsigned() || !change[2].is_number_unsigned() ||
      !change[3].is_array()) {
    return false;
  }
  auto& list = value.get_ref<Json::array_t&>();
  const auto head = change[1].get<std::uint64_t>(), tail = change[2].get<std::uint64_t>();
  if (head > list.size() || tail > list.size() - head) return false;
  const auto from = list.begin() + static_cast<std::ptrdiff_t>(head);
  const auto to = list.end() - static_cast<std::ptrdiff_t>(tail);
  const auto at = list.erase(from, to);
  const auto& middle = change[3].get_ref<const Json::array_t&>();
  list.insert(at, middle.begin(), middle.end());
  return true;
}

}  // namespace

Json difference(const Json& before, const Json& after) {
  if (before == after) return nullptr;
  if (before.is_object() && after.is_object()) return objectDifference(before, after);
  if (before.is_array() && after.is_array()) return listDifference(before, after);
  return replaced(after);
}

bool applyDifference(Json& value, const Json& change) {
  if (!change.is_array() || change.size() < 2 || !change[0].is_string()) return false;
  const std::string& kind = change[0].get_ref<const std::string&>();
  if (kind == "=" && change.size() == 2) {
    value = change[1];
    return true;
  }
  if (kind == "~" && change.size() == 2) return applyToObject(value, change[1]);
  if (kind == "+" && change.size() == 4) return splice(value, change);
  if (kind == "@" && change.size() == 3) {
    if (!value.is_array() || !change[1].is_number_unsigned()) return false;
    const auto place = change[1].get<std::uint64_t>();
    return place < value.size() && applyDifference(value[static_cast<std::size_t>(place)], change[2]);
  }
  return false;
}

}  // namespace spineloft::io
