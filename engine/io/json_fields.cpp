#include "engine/io/json_fields.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/io/decimal.h"

namespace spineloft::io {
namespace {

/// Doubles up to here that are whole are written as whole numbers.
constexpr double kMostWhole = 9007199254740992;  // 2⁵³

/// Longest text of unknown keys that one picture, part or document carries along, bytes.
constexpr std::size_t kMostExtra = 1 << 18;

constexpr std::array<std::string_view, static_cast<std::size_t>(inflate::InflateSides::kCount)> kSidesKeys = {
    "both", "front", "back"};
constexpr std::array<std::string_view, static_cast<std::size_t>(extrude::EdgeKind::kCount)> kEdgeKeys = {
    "sharp", "bevel", "round"};

constexpr std::string_view kHexDigits = "0123456789abcdef";

void mergeBack(Json& out, Json& rest);

void mergeList(Json& list, Json& rest) {
  if (rest[kLengthKey] != list.size()) return;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto element = rest.find(std::to_string(i));
    if (element != rest.end() && element->is_object() && list[i].is_object()) {
      mergeBack(list[i], *element);
    }
  }
}

void mergeBack(Json& out, Json& rest) {
  for (auto& [key, value] : rest.items()) {
    const auto at = out.find(key);
    if (!value.is_object()) {
      if (at == out.end()) out[key] = std::move(value);
    } else if (value.contains(kLengthKey)) {
      // A list that is not written is the usual one: the sections, of which there is one.
      if (at == out.end()) out[key] = Json::array({Json::object()});
      if (out[key].is_array()) mergeList(out[key], value);
    } else if (at == out.end()) {
      mergeBack(out[key] = Json::object(), value);
    } else if (at->is_object()) {
      mergeBack(*at, value);
    }
  }
}

bool getPoints(const Json& from, std::vector<PicturePoint>& to) { return get(from, to); }

}  // namespace

std::string_view keyOf(sections::SectionPreset value) { return sections::sectionKey(value); }
std::string_view keyOf(sections::CapStyle value) { return sections::capKey(value); }
std::string_view keyOf(sections::BlendKind value) {
  const auto names = sections::blendNames();
  const auto at = std::ranges::find(names, value, &sections::BlendName::kind);
  return at == names.end() ? std::string_view() : at->key;
}
std::string_view keyOf(stack::CurveUse value) {
  const auto names = stack::curveUseNames();
  const auto at = std::ranges::find(names, value, &stack::CurveUseName::use);
  return at == names.end() ? std::string_view() : at->key;
}
std::string_view keyOf(ribs::Side value) { return value == ribs::Side::Left ? "left" : "right"; }
std::string_view keyOf(surface::Paint value) { return surface::finishOf(value).key; }

std::string_view keyOf(inflate::InflateSides value) {
  const auto at = static_cast<std::size_t>(value);
  return at < kSidesKeys.size() ? kSidesKeys[at] : std::string_view();
}
std::string_view keyOf(extrude::EdgeKind value) {
  const auto at = static_cast<std::size_t>(value);
  return at < kEdgeKeys.size() ? kEdgeKeys[at] : std::string_view();
}
bool fromKey(std::string_view key, inflate::InflateSides& value) {
  const auto at = std::ranges::find(kSidesKeys, key);
  if (at != kSidesKeys.end()) value = static_cast<inflate::InflateSides>(at - kSidesKeys.begin());
  return at != kSidesKeys.end();
}
bool fromKey(std::string_view key, extrude::EdgeKind& value) {
  const auto at = std::ranges::find(kEdgeKeys, key);
  if (at != kEdgeKeys.end()) value = static_cast<extrude::EdgeKind>(at - kEdgeKeys.begin());
  return at != kEdgeKeys.end();
}

template <class T>
bool keep(const std::optional<T>& found, T& value) {
  if (found) value = *found;
  return found.has_value();
}
std::string_view keyOf(document::StepKind value) { return document::stepKindKey(value); }
std::string_view keyOf(document::OpeningSide value) { return document::openingKey(value); }

namespace {

/// The enumerator with this key.
template <class T>
bool fromKeys(std::string_view key, T& value) {
  for (int i = 0; i < static_cast<int>(T::kCount); ++i) {
    if (keyOf(static_cast<T>(i)) != key) continue;
    value = static_cast<T>(i);
    return true;
  }
  return false;
}

}  // namespace

std::string_view keyOf(shape::Primitive value) {
  const auto names = shape::primitiveNames();
  const auto at = std::ranges::find(names, value, &shape::PrimitiveName::primitive);
  return at == names.end() ? std::string_view() : at->key;
}
std::string_view keyOf(inflate::Across value) { return value == inflate::Across::Length ? "length" : "share"; }
std::string_view keyOf(shape::DepthMode value) { return value == shape::DepthMode::Kept ? "kept" : "round"; }
std::string_view keyOf(geometry::ViewFrom value) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(geometry::ViewFrom::kCount)> kKeys = {
      "right", "left", "back", "top"};
  const auto at = static_cast<std::size_t>(value);
  return at < kKeys.size() ? kKeys[at] : std::string_view();
}
std::string_view keyOf(relief::Mode value) { return relief::modeKey(value); }
std::string_view keyOf(descriptive::PieceKind value) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(descriptive::PieceKind::kCount)> kKeys = {
      "round", "flat", "solid"};
  const auto at = static_cast<std::size_t>(value);
  return at < kKeys.size() ? kKeys[at] : std::string_view();
}
std::string_view keyOf(descriptive::SeenFrom value) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(descriptive::SeenFrom::kCount)> kKeys = {
      "above", "below", "unknown"};
  const auto at = static_cast<std::size_t>(value);
  return at < kKeys.size() ? kKeys[at] : std::string_view();
}
bool fromKey(std::string_view key, stack::CurveUse& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, descriptive::PieceKind& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, descriptive::SeenFrom& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, shape::Primitive& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, inflate::Across& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, shape::DepthMode& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, geometry::ViewFrom& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, relief::Mode& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, document::StepKind& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, document::OpeningSide& value) { return fromKeys(key, value); }
bool fromKey(std::string_view key, sections::SectionPreset& value) {
  return keep(sections::sectionFromKey(key), value);
}
bool fromKey(std::string_view key, sections::CapStyle& value) { return keep(sections::capFromKey(key), value); }
bool fromKey(std::string_view key, sections::BlendKind& value) { return keep(sections::blendFromKey(key), value); }
bool fromKey(std::string_view key, surface::Paint& value) { return keep(surface::paintFromKey(key), value); }
bool fromKey(std::string_view key, ribs::Side& value) {
  if (key != "left" && key != "right") return false;
  value = key == "left" ? ribs::Side::Left : ribs::Side::Right;
  return true;
}

Json toJson(double value) {
  if (std::abs(value) <= kMostWhole && value == std::trunc(value)) {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

Json toJson(float value) {
  if (!std::isfinite(value)) return static_cast<double>(value);
  // Not from_chars: libc++ 19 lacks it for double.
  const double shortest = Json::parse(Decimal(value).text(), nullptr, false).get<double>();
  // Rounding twice could miss the float by one.
  return toJson(static_cast<float>(shortest) == value ? shortest : static_cast<double>(value));
}

Json toJson(const std::array<std::uint8_t, 3>& colour) {
  std::string text = "#";
  for (const std::uint8_t channel : colour) {
    text += kHexDigits[channel >> 4];
    text += kHexDigits[channel & 15];
  }
  return text;
}

Json toJson(const geometry::AlongCurve& curve) {
  Json out = Json::array();
  for (const auto& [at, value] : curve.points) {
    out.push_back(toJson(at));
    out.push_back(toJson(value));
  }
  return out;
}

Json toJson(const ribs::EndEdit& edit) {
  const auto& [at, side, along, out, reach, locked] = edit;
  return Json::array({toJson(side), toJson(at), toJson(along), toJson(out), toJson(reach), locked});
}

Json toJson(const ribs::IgnoreMark& mark) {
  const auto& [stroke, radius, covers] = mark;
  Json out = Json::array({toJson(radius), toJson(stroke)});
  if (covers) out.push_back(true);
  return out;
}

Json toJson(const geometry::Turn& turn) {
  const auto& [w, x, y, z] = turn;
  return Json::array({toJson(w), toJson(x), toJson(y), toJson(z)});
}

Json toJson(const std::optional<double>& number) { return number ? toJson(*number) : Json(); }

Json toJson(const std::optional<document::MirrorPlane>& plane) {
  if (!plane) return nullptr;
  const auto& [point, normal] = *plane;
  return Json::array(
      {toJson(point.x), toJson(point.y), toJson(point.z), toJson(normal.x), toJson(normal.y), toJson(normal.z)});
}

Json toJson(const stack::Corners& corners) {
  const auto& [all, at] = corners;
  return all ? Json("all") : Json(at);
}

Json toJson(const shape::Axis& axis) {
  const auto& [start, end] = axis;
  return Json::array({toJson(start), toJson(end)});
}

Json toJson(const descriptive::Stretch& stretch) {
  const auto& [start, end] = stretch;
  return Json::array({toJson(start), toJson(end)});
}

Json toJson(const image::SketchStroke& stroke) {
  const auto& [points, pressure, radius, erase, colour] = stroke;
  return Json::array({toJson(radius), erase, toJson(colour), toJson(points), toJson(pressure)});
}

std::string hashKey(std::uint64_t hash) {
  std::string text;
  for (int shift = 60; shift >= 0; shift -= 4) text += kHexDigits[(hash >> shift) & 15];
  return text;
}

std::optional<std::uint64_t> hashFromKey(std::string_view key) {
  std::uint64_t hash = 0;
  const auto [end, problem] = std::from_chars(key.data(), key.data() + key.size(), hash, 16);
  if (key.size() != 16 || problem != std::errc() || end != key.data() + key.size()) {
    return std::nullopt;
  }
  return hash;
}

void putBack(Json& out, const std::string& extra) {
  Json rest = Json::parse(extra, nullptr, false);
  if (rest.is_object()) mergeBack(out, rest);
}

bool get(const Json& from, double& to) {
  if (!from.is_number()) return false;
  const double value = from.get<double>();
  if (!std::isfinite(value)) return false;
  to = value;
  return true;
}

bool get(const Json& from, float& to) {
  double value = 0;
  if (!get(from, value) || std::abs(value) > std::numeric_limits<float>::max()) return false;
  to = static_cast<float>(value);
  return true;
}

bool get(const Json& from, bool& to) {
  if (!from.is_boolean()) return false;
  to = from.get<bool>();
  return true;
}

bool get(const Json& from, int& to) {
  double value = 0;
  if (!get(from, value) || value != std::trunc(value) || std::abs(value) > std::numeric_limits<int>::max()) {
    return false;
  }
  to = static_cast<int>(value);
  return true;
}

bool get(const Json& from, std::uint32_t& to) {
  double value = 0;
  if (!get(from, value) || value != std::trunc(value) || value < 0 ||
      value > std::numeric_limits<std::uint32_t>::max()) {
    return false;
  }
  to = static_cast<std::uint32_t>(value);
  return true;
}

bool get(const Json& from, std::string& to) {
  if (!from.is_string()) return false;
  to = from.get_ref<const std::string&>();
  return true;
}

bool get(const Json& from, Millimetres& to) { return get(from, to.value); }

bool get(const Json& from, image::Size& to) {
  image::Size size;
  if (!from.is_array() || from.size() != 2) return false;
  if (!get(from[0], size.width) || !get(from[1], size.height)) return false;
  to = size;
  return true;
}

bool get(const Json& from, std::array<std::uint8_t, 3>& to) {
  if (!from.is_string()) return false;
  const std::string& text = from.get_ref<const std::string&>();
  std::uint32_t rgb = 0;
  if (text.size() != 7 || text[0] != '#') return false;
  const auto [end, problem] = std::from_chars(text.data() + 1, text.data() + 7, rgb, 16);
  if (problem != std::errc() || end != text.data() + 7) return false;
  to = {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8), static_cast<std::uint8_t>(rgb)};
  return true;
}

bool get(const Json& from, geometry::AlongCurve& to) {
  if (!from.is_array() || from.size() % 2 != 0) return false;
  geometry::AlongCurve curve;
  curve.points.resize(from.size() / 2);
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    auto& [at, value] = curve.points[i];
    if (!get(from[2 * i], at) || !get(from[2 * i + 1], value)) return false;
  }
  to = std::move(curve);
  return true;
}

bool get(const Json& from, shape::Axis& to) {
  shape::Axis axis;
  const bool two = from.is_array() && from.size() == 2 && get(from[0], axis.from) && get(from[1], axis.to);
  if (two) to = axis;
  return two;
}

bool get(const Json& from, descriptive::Stretch& to) {
  descriptive::Stretch stretch;
  const bool two = from.is_array() && from.size() == 2 && get(from[0], stretch.from) && get(from[1], stretch.to);
  if (two) to = stretch;
  return two;
}

bool get(const Json& from, ribs::EndEdit& to) {
  ribs::EndEdit edit;
  auto& [at, side, along, out, reach, locked] = edit;
  if (!from.is_array() || from.size() != 6) return false;
  if (!get(from[0], side) || !get(from[1], at) || !get(from[2], along) || !get(from[3], out) || !get(from[4], reach) ||
      !get(from[5], locked)) {
    return false;
  }
  to = edit;
  return true;
}

bool get(const Json& from, ribs::IgnoreMark& to) {
  ribs::IgnoreMark mark;
  auto& [stroke, radius, covers] = mark;
  if (!from.is_array() || from.size() < 2 || from.size() > 3) return false;
  if (!get(from[0], radius) || !getPoints(from[1], stroke)) return false;
  if (from.size() == 3 && !get(from[2], covers)) return false;
  to = std::move(mark);
  return true;
}

bool get(const Json& from, geometry::Turn& to) {
  geometry::Turn turn;
  const bool four = from.is_array() && from.size() == 4 && get(from[0], turn.w) && get(from[1], turn.x) &&
                    get(from[2], turn.y) && get(from[3], turn.z);
  if (four) to = turn;
  return four;
}

bool get(const Json& from, std::optional<double>& to) {
  double number = 0;
  if (!from.is_null() && !get(from, number)) return false;
  to = from.is_null() ? std::nullopt : std::optional(number);
  return true;
}

bool get(const Json& from, std::optional<document::MirrorPlane>& to) {
  if (from.is_null()) {
    to.reset();
    return true;
  }
  std::array<double, 6> numbers{};
  if (!from.is_array() || from.size() != numbers.size()) return false;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (!get(from[i], numbers[i])) return false;
  }
  to = document::MirrorPlane{{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]}};
  return true;
}

bool get(const Json& from, stack::Corners& to) {
  stack::Corners corners{from == "all", {}};
  if (!corners.all && !from.is_array()) return false;
  for (const Json& element : corners.all ? Json::array() : from) {
    if (!get(element, corners.at.emplace_back())) return false;
  }
  to = std::move(corners);
  return true;
}

bool get(const Json& from, image::SketchStroke& to) {
  image::SketchStroke stroke;
  auto& [points, pressure, radius, erase, colour] = stroke;
  if (!from.is_array() || from.size() != 5) return false;
  if (!get(from[0], radius) || !get(from[1], erase) || !get(from[2], colour) || !getPoints(from[3], points) ||
      !from[4].is_array()) {
    return false;
  }
  pressure.resize(from[4].size());
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (!get(from[4][i], pressure[i])) return false;
  }
  to = std::move(stroke);
  return true;
}

std::string takeRest(Json& object, const Reading& reading) {
  if (object.empty()) return {};
  std::string rest = object.dump();
  object = Json::object();
  if (rest.size() <= kMostExtra) return rest;
  ++reading.notes.dropped;
  return {};
}

void ReadMembers::photo(const char* key, std::shared_ptr<const image::Picture>& picture, std::uint64_t& hash) {
  const auto at = object_.find(key);
  if (at == object_.end()) return;
  if (at->is_string()) {
    hash = hashFromKey(at->get_ref<const std::string&>()).value_or(0);
    if (reading_.photos) picture = reading_.photos(hash);
  }
  object_.erase(at);
}

}  // namespace spineloft::io
