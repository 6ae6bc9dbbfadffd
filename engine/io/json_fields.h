// Every value of the document as JSON, both ways. Internal to io/.
//
// Structs are JSON objects: each is taken apart by one structured binding that both directions share,
// so that a field added later does not compile until it is saved. Values that equal the default are
// not written. Small structs that stand in long lists are JSON arrays ("tuples"). Reading takes out of
// the JSON what it knows; what stays in it is what this program does not know.
#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/document/document.h"
#include "engine/io/json_members.h"
#include "engine/io/project_file.h"

namespace spineloft::io {

using Json = nlohmann::json;

/// Stands for any visitor where only the type of what is visited is asked for.
struct NoVisitor {};
template <class T>
concept Struct = requires(NoVisitor v, T value) { members(v, value); };

// ---- enums by their keys ------------------------------------------------------------------------

std::string_view keyOf(sections::SectionPreset value);
std::string_view keyOf(sections::CapStyle value);
std::string_view keyOf(sections::BlendKind value);
std::string_view keyOf(stack::CurveUse value);
std::string_view keyOf(ribs::Side value);
std::string_view keyOf(document::StepKind value);
std::string_view keyOf(document::OpeningSide value);
std::string_view keyOf(inflate::InflateSides value);
std::string_view keyOf(inflate::Across value);
std::string_view keyOf(extrude::EdgeKind value);
std::string_view keyOf(surface::Paint value);
std::string_view keyOf(shape::Primitive value);
std::string_view keyOf(shape::DepthMode value);
std::string_view keyOf(geometry::ViewFrom value);
std::string_view keyOf(relief::Mode value);
std::string_view keyOf(descriptive::PieceKind value);
std::string_view keyOf(descriptive::SeenFrom value);
bool fromKey(std::string_view key, sections::SectionPreset& value);
bool fromKey(std::string_view key, sections::CapStyle& value);
bool fromKey(std::string_view key, sections::BlendKind& value);
bool fromKey(std::string_view key, stack::CurveUse& value);
bool fromKey(std::string_view key, ribs::Side& value);
bool fromKey(std::string_view key, document::StepKind& value);
bool fromKey(std::string_view key, document::OpeningSide& value);
bool fromKey(std::string_view key, inflate::InflateSides& value);
bool fromKey(std::string_view key, inflate::Across& value);
bool fromKey(std::string_view key, extrude::EdgeKind& value);
bool fromKey(std::string_view key, surface::Paint& value);
bool fromKey(std::string_view key, shape::Primitive& value);
bool fromKey(std::string_view key, shape::DepthMode& value);
bool fromKey(std::string_view key, geometry::ViewFrom& value);
bool fromKey(std::string_view key, relief::Mode& value);
bool fromKey(std::string_view key, descriptive::PieceKind& value);
bool fromKey(std::string_view key, descriptive::SeenFrom& value);
template <class T>
concept Keyed = requires(T value) { keyOf(value); };

// ---- writing ------------------------------------------------------------------------------------

/// Whole numbers without a point, −0 as 0; every finite double comes back exactly.
Json toJson(double value);
/// With the fewest digits that give back the same float.
Json toJson(float value);
inline Json toJson(bool value) { return value; }
inline Json toJson(int value) { return value; }
inline Json toJson(std::uint32_t value) { return value; }
inline Json toJson(const std::string& value) { return value; }
inline Json toJson(Millimetres value) { return toJson(value.value); }
inline Json toJson(image::Size size) { return Json::array({size.width, size.height}); }
template <class Tag>
Json toJson(Id<Tag> id) {
  return id.value;
}
template <Keyed T>
Json toJson(T value) {
  return std::string(keyOf(value));
}
Json toJson(const std::array<std::uint8_t, 3>& colour);          ///< "#rrggbb"
Json toJson(const geometry::AlongCurve& curve);                  ///< [at, value, at, value, …]
Json toJson(const ribs::EndEdit& edit);                          ///< [side, at, along, out, reach, locked]
Json toJson(const ribs::IgnoreMark& mark);                       ///< [radius, [x, y, …]], and true if it covers
Json toJson(const geometry::Turn& turn);                         ///< [w, x, y, z]
Json toJson(const std::optional<double>& number);                ///< or null
Json toJson(const std::optional<document::MirrorPlane>& plane);  ///< null, or point and normal in one list
Json toJson(const image::SketchStroke& stroke);                  ///< [radius, erase, colour, [x, y, …], [pressure, …]]
Json toJson(const stack::Corners& corners);                      ///< "all", or the indices
Json toJson(const shape::Axis& axis);                            ///< [[x, y], [x, y]]
Json toJson(const descriptive::Stretch& stretch);                ///< [from, to]
template <Struct T>
Json toJson(const T& value);
template <Struct T>
Json toJson(const std::optional<T>& value) {  // or null
  return value ? toJson(*value) : Json();
}
template <class Space>
Json toJson(Vec3<Space> p) {
  return Json::array({toJson(p.x), toJson(p.y), toJson(p.z)});
}
template <class Space>
Json toJson(const std::optional<Vec3<Space>>& p) {  // or null
  return p ? toJson(*p) : Json();
}
template <class Space>
Json toJson(const std::vector<Vec3<Space>>& points) {  // [x, y, z, x, y, z, …]
  Json out = Json::array();
  for (const Vec3<Space>& p : points) {
    for (const double value : {p.x, p.y, p.z}) out.push_back(toJson(value));
  }
  return out;
}
template <class Space>
Json toJson(Vec2<Space> p) {
  return Json::array({toJson(p.x), toJson(p.y)});
}
template <class Space>
Json toJson(const std::optional<Vec2<Space>>& p) {  // or null
  return p ? toJson(*p) : Json();
}
template <class Space>
Json toJson(const std::vector<Vec2<Space>>& points) {  // [x, y, x, y, …]
  Json out = Json::array();
  out.get_ref<Json::array_t&>().reserve(2 * points.size());
  for (const Vec2<Space>& p : points) {
    out.push_back(toJson(p.x));
    out.push_back(toJson(p.y));
  }
  return out;
}
template <class T>
Json toJson(const Box<T>& box) {
  return toJson(box.get());
}
template <class T>
Json toJson(const std::vector<T>& values) {
  Json out = Json::array();
  for (const T& value : values) out.push_back(toJson(value));
  return out;
}
std::string hashKey(std::uint64_t hash);  ///< 16 hexadecimal digits
std::optional<std::uint64_t> hashFromKey(std::string_view key);

/// Puts what a file said beyond what we know (text of a leftover, see takeRest) back into `out`.
void putBack(Json& out, const std::string& extra);

/// Writes members that differ from those of `plain`, a default value's, where it is given.
class WriteMembers {
 public:
  WriteMembers(Json& out, const Json* plain) : out_(out), plain_(plain) {}
  template <class T>
  void operator()(const char* key, const T& value) {
    Json json = toJson(value);
    if (plain_ != nullptr && plain_->at(key) == json) return;
    out_[key] = std::move(json);
  }
  template <class T>
  void always(const char* key, const T& value) {
    out_[key] = toJson(value);
  }
  /// One of several kinds; the kind of a loft is not written, as in the files of version 1.
  void recipe(const char* kindKey, const char* key, const document::Recipe& value);
  void photo(const char* key, const std::shared_ptr<const image::Picture>& picture, std::uint64_t contentHash) {
    if (picture) out_[key] = hashKey(contentHash);
  }
  template <class T>
  void elements(const char* key, const std::vector<Box<T>>& values) {
    if (withElements) always(key, values);
  }
  template <class T>
  void elementsIfAny(const char* key, const std::vector<Box<T>>& values) {
    if (!values.empty()) elements(key, values);
  }
  /// A key that earlier versions wrote.
  void retired(const char*) {}
  void beyond(const std::string& extra) {
    if (!extra.empty()) putBack(out_, extra);
  }
  bool withElements = true;  ///< the pictures and parts of a document

 private:
  Json& out_;
  const Json* plain_;
};

template <Struct T>
Json toJson(const T& value) {
  Json plain = Json::object(), out = Json::object();
  const T standard{};
  WriteMembers writePlain(plain, nullptr);
  members(writePlain, standard);
  WriteMembers write(out, &plain);
  members(write, value);
  return out;
}

// ---- reading ------------------------------------------------------------------------------------

/// What is read from `from` is taken out of it: null or an empty object stays when all was known.
/// Values of the wrong type leave `to` as it is and are counted.
struct Reading {
  ReadNotes& notes;
  const PictureSource& photos;
};

/// False when it is of the wrong type or not representable.
bool get(const Json& from, double& to);
bool get(const Json& from, float& to);
bool get(const Json& from, bool& to);
bool get(const Json& from, int& to);
bool get(const Json& from, std::uint32_t& to);
bool get(const Json& from, std::string& to);
bool get(const Json& from, Millimetres& to);
bool get(const Json& from, image::Size& to);
bool get(const Json& from, std::array<std::uint8_t, 3>& to);
bool get(const Json& from, geometry::AlongCurve& to);
bool get(const Json& from, ribs::EndEdit& to);
bool get(const Json& from, ribs::IgnoreMark& to);
bool get(const Json& from, geometry::Turn& to);
bool get(const Json& from, std::optional<double>& to);
bool get(const Json& from, std::optional<document::MirrorPlane>& to);
bool get(const Json& from, image::SketchStroke& to);
bool get(const Json& from, stack::Corners& to);
bool get(const Json& from, shape::Axis& to);
bool get(const Json& from, descriptive::Stretch& to);
template <class Space>
bool get(const Json& from, Vec2<Space>& to) {
  Vec2<Space> p;
  const bool two = from.is_array() && from.size() == 2 && get(from[0], p.x) && get(from[1], p.y);
  if (two) to = p;
  return two;
}
template <class Space>
bool get(const Json& from, std::optional<Vec2<Space>>& to) {
  Vec2<Space> p;
  if (!from.is_null() && !get(from, p)) return false;
  to = from.is_null() ? std::nullopt : std::optional(p);
  return true;
}
template <class Space>
bool get(const Json& from, Vec3<Space>& to) {
  Vec3<Space> p;
  const bool three = from.is_array() && from.size() == 3 && get(from[0], p.x) && get(from[1], p.y) && get(from[2], p.z);
  if (three) to = p;
  return three;
}
template <class Space>
bool get(const Json& from, std::optional<Vec3<Space>>& to) {
  Vec3<Space> p;
  if (!from.is_null() && !get(from, p)) return false;
  to = from.is_null() ? std::nullopt : std::optional(p);
  return true;
}
template <class Space>
bool get(const Json& from, std::vector<Vec3<Space>>& to) {
  if (!from.is_array() || from.size() % 3 != 0) return false;
  std::vector<Vec3<Space>> points(from.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!get(from[3 * i], points[i].x) || !get(from[3 * i + 1], points[i].y) || !get(from[3 * i + 2], points[i].z)) {
      return false;
    }
  }
  to = std::move(points);
  return true;
}
template <class Tag>
bool get(const Json& from, Id<Tag>& to) {
  return get(from, to.value);
}
template <Keyed T>
bool get(const Json& from, T& to) {
  return from.is_string() && fromKey(from.get_ref<const std::string&>(), to);
}
template <class Space>
bool get(const Json& from, std::vector<Vec2<Space>>& to) {
  if (!from.is_array() || from.size() % 2 != 0) return false;
  std::vector<Vec2<Space>> points(from.size() / 2);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!get(from[2 * i], points[i].x) || !get(from[2 * i + 1], points[i].y)) return false;
  }
  to = std::move(points);
  return true;
}

template <class T>
concept Plain = requires(const Json& from, T& to) { get(from, to); };

/// The keys of a struct, in words.
struct NameMembers {
  std::string text;
  template <class T>
  void operator()(const char* key, const T&) {
    text += (text.empty() ? "" : ", ") + std::string(key);
  }
  template <class T>
  void always(const char* key, const T& value) {
    (*this)(key, value);
  }
  void recipe(const char* kindKey, const char* key, const document::Recipe& value) {
    (*this)(kindKey, value);
    (*this)(key, value);
  }
  template <class T>
  void photo(const char* key, const T& picture, std::uint64_t) {
    (*this)(key, picture);
  }
  template <class T>
  void elements(const char* key, const T& values) {
    (*this)(key, values);
  }
  template <class T>
  void elementsIfAny(const char* key, const T& values) {
    (*this)(key, values);
  }
  void retired(const char*) {}
  void beyond(const std::string&) {}
};

// What a value must be, in words, for what is of another type.
inline std::string wanted(const double&) { return "a number"; }
inline std::string wanted(const float&) { return "a number"; }
inline std::string wanted(const Millimetres&) { return "a number"; }
inline std::string wanted(const bool&) { return "true or false"; }
inline std::string wanted(const int&) { return "a whole number"; }
inline std::string wanted(const std::uint32_t&) { return "a whole number, not below 0"; }
inline std::string wanted(const std::string&) { return "a text"; }
inline std::string wanted(const image::Size&) { return "a list of two whole numbers: width and height"; }
inline std::string wanted(const std::array<std::uint8_t, 3>&) { return "a colour such as \"#ff8800\""; }
inline std::string wanted(const geometry::AlongCurve&) { return "a list of places and values: at, value, at, value …"; }
inline std::string wanted(const ribs::EndEdit&) { return "a list: side, at, along, out, reach, locked"; }
inline std::string wanted(const ribs::IgnoreMark&) { return "a list: radius, [x, y, x, y …]"; }
inline std::string wanted(const geometry::Turn&) { return "a list of four numbers: w, x, y, z"; }
inline std::string wanted(const std::optional<double>&) { return "null, or a number"; }
inline std::string wanted(const std::optional<document::MirrorPlane>&) {
  return "null, or a list of six numbers: a point and a direction";
}
inline std::string wanted(const image::SketchStroke&) {
  return "a list: radius, whether it erases, colour, [x, y, x, y …], [pressure, …]";
}
inline std::string wanted(const stack::Corners&) { return "\"all\", or a list of whole numbers"; }
inline std::string wanted(const shape::Axis&) { return "a list of two places: [[x, y], [x, y]]"; }
inline std::string wanted(const descriptive::Stretch&) { return "a list of two numbers: from, to"; }
template <class Tag>
std::string wanted(const Id<Tag>&) {
  return "a whole number, not below 0";
}
template <class Space>
std::string wanted(const Vec2<Space>&) {
  return "a list of two numbers: x, y";
}
template <class Space>
std::string wanted(const std::optional<Vec2<Space>>&) {
  return "null, or a list of two numbers: x, y";
}
template <class Space>
std::string wanted(const Vec3<Space>&) {
  return "a list of three numbers: x, y, z";
}
template <class Space>
std::string wanted(const std::optional<Vec3<Space>>&) {
  return "null, or a list of three numbers: x, y, z";
}
template <class Space>
std::string wanted(const std::vector<Vec2<Space>>&) {
  return "one list x, y, x, y … of numbers, not of pairs";
}
template <class Space>
std::string wanted(const std::vector<Vec3<Space>>&) {
  return "one list x, y, z, x, y, z … of numbers";
}
/// Of an enum without kCount.
template <Keyed T>
std::string wanted(const T&) {
  return "one of those that are known";
}
/// `keyOf` of each from 0 on, but those without a name.
template <class KeyOf>
std::string oneOf(int count, const KeyOf& keyOf) {
  std::string all;
  for (int i = 0; i < count; ++i) {
    const std::string_view key = keyOf(i);
    if (!key.empty()) all += (all.empty() ? "\"" : ", \"") + std::string(key) + '"';
  }
  return "one of " + all;
}
/// The names that it knows.
template <Keyed T>
  requires requires { T::kCount; }
std::string wanted(const T&) {
  return oneOf(static_cast<int>(T::kCount), [](int i) { return keyOf(static_cast<T>(i)); });
}
inline std::string wanted(const document::PartKind&) {
  return oneOf(static_cast<int>(document::PartKind::kCount),
               [](int i) { return document::kindKey(static_cast<document::PartKind>(i)); });
}
template <Struct T>
std::string wanted(const T& value) {
  NameMembers names;
  members(names, value);
  return "an object with some of the keys " + names.text;
}
template <class T>
std::string wanted(const std::vector<T>&) {
  return "a list, each member " + wanted(T{});
}
template <class T>
std::string wanted(const std::vector<Box<T>>&) {
  return "a list, each member " + wanted(T{});
}

inline constexpr const char* kEach = "each member of the list must be ";

/// Counts a value of the wrong type, and says what it must be.
template <class T>
void countWrong(const T& to, const Reading& reading) {
  ++reading.notes.repaired;
  reading.notes.say("it must be " + wanted(to));
}

template <Plain T>
void read(Json& from, T& to, const Reading& reading) {
  if (!get(from, to)) countWrong(to, reading);
  from = nullptr;
}
template <Struct T>
void read(Json& from, T& to, const Reading& reading);
template <Struct T>
void read(Json& from, std::optional<T>& to, const Reading& reading) {
  to.reset();
  if (!from.is_null()) read(from, to.emplace(), reading);
}
/// A line is one value.
template <class Space>
void read(Json& from, std::vector<Vec2<Space>>& to, const Reading& reading) {
  if (!get(from, to)) countWrong(to, reading);
  from = nullptr;
}
template <class Space>
void read(Json& from, std::vector<Vec3<Space>>& to, const Reading& reading) {
  if (!get(from, to)) countWrong(to, reading);
  from = nullptr;
}
/// A list of plain values: bad ones are left out and counted.
template <Plain T>
void read(Json& from, std::vector<T>& to, const Reading& reading) {
  to.clear();
  if (!from.is_array()) countWrong(to, reading);
  for (const Json& element : from.is_array() ? from : Json::array()) {
    T value{};
    if (get(element, value)) {
      to.push_back(std::move(value));
    } else {
      ++reading.notes.repaired;
      reading.notes.say(kEach + wanted(value));
    }
  }
  from = nullptr;
}
template <Plain T>
void read(Json& from, std::vector<Box<T>>& to, const Reading& reading) {
  std::vector<T> values;
  read(from, values, reading);
  to.assign(std::make_move_iterator(values.begin()), std::make_move_iterator(values.end()));
}
/// Key under which a list's leftover keeps the list's length; its other keys are places in the list.
inline constexpr const char* kLengthKey = "#length";
template <Struct T>
void read(Json& from, std::vector<T>& to, const Reading& reading) {
  to.clear();
  if (!from.is_array()) {
    countWrong(to, reading);
    from = nullptr;
    return;
  }
  Json rest = Json::object();
  for (std::size_t i = 0; i < from.size(); ++i) {
    T value{};
    if (!from[i].is_object()) reading.notes.say(kEach + wanted(value));
    read(from[i], value, reading);
    to.push_back(std::move(value));
    if (!from[i].empty()) rest[std::to_string(i)] = std::move(from[i]);
  }
  if (!rest.empty()) rest[kLengthKey] = to.size();
  from = std::move(rest);
}

/// The leftover of an object as text; empty when nothing is left or it is too long to be carried.
std::string takeRest(Json& object, const Reading& reading);

class ReadMembers {
 public:
  ReadMembers(Json& object, const Reading& reading) : object_(object), reading_(reading) {}
  /// Known, and without a meaning.
  void retired(const char* key) { object_.erase(key); }
  template <class T>
  void operator()(const char* key, T& value) {
    const auto at = object_.find(key);
    if (at == object_.end()) return;
    read(*at, value, reading_);
    if (at->empty()) object_.erase(at);
  }
  template <class T>
  void always(const char* key, T& value) {
    (*this)(key, value);
  }
  /// An unknown kind leaves an empty loft, which no document holds.
  void recipe(const char* kindKey, const char* key, document::Recipe& value);
  /// A photo that is not there leaves `picture` empty and the hash set.
  void photo(const char* key, std::shared_ptr<const image::Picture>& picture, std::uint64_t& hash);
  /// The pictures and parts of a document are read one by one (document_json.cpp).
  template <class T>
  void elements(const char*, std::vector<Box<T>>&) {}
  template <class T>
  void elementsIfAny(const char*, std::vector<Box<T>>&) {}
  void beyond(std::string& extra) { extra = takeRest(object_, reading_); }

 private:
  Json& object_;
  const Reading& reading_;
};

template <Struct T>
void read(Json& from, T& to, const Reading& reading) {
  if (!from.is_object()) {
    countWrong(to, reading);
    from = nullptr;
    return;
  }
  ReadMembers visitor(from, reading);
  members(visitor, to);
}

}  // namespace spineloft::io
