#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <string>

#include "engine/base/rng.h"
#include "tests/unit/web/rig.h"
#include "web/model/json.h"

using namespace spineloft;
using app::Json;
using app::JsonWriter;

namespace {

void write(JsonWriter& out, const Json& value) {
  if (const auto* list = value.array()) {
    out.beginArray();
    for (const Json& entry : *list) write(out, entry);
    out.endArray();
  } else if (const auto* members = value.object()) {
    out.beginObject();
    for (const auto& [name, entry] : *members) {
      out.key(name);
      write(out, entry);
    }
    out.endObject();
  } else if (const auto* text = value.text()) {
    out.text(*text);
  } else if (value.number()) {
    out.number(*value.number());
  } else if (value.flag()) {
    out.flag(*value.flag());
  } else {
    out.null();
  }
}

std::string randomText(Rng& rng) {
  static const std::string pieces[] = {"a", "\"", "\\", "\n", "\x01", "é", "日", "😀", "/", " "};
  std::string text;
  for (std::uint32_t i = rng.below(8); i > 0; --i) text += pieces[rng.below(10)];
  return text;
}

Json randomValue(Rng& rng, int depth) {
  switch (rng.below(depth > 3 ? 4 : 6)) {
    case 0:
      return {};
    case 1:
      return Json(rng.below(2) == 1);
    case 2:
      return Json(static_cast<double>(rng.below(2000001)) - 1e6);
    case 3:
      return Json(randomText(rng));
    case 4: {
      Json::Array list;
      for (std::uint32_t i = rng.below(4); i > 0; --i) list.push_back(randomValue(rng, depth + 1));
      return list;
    }
    default: {
      std::map<std::string, Json> members;  // names of an object are in no order, and each counts once
      for (std::uint32_t i = rng.below(4); i > 0; --i) members[randomText(rng)] = randomValue(rng, depth + 1);
      return Json(Json::Object(members.begin(), members.end()));
    }
  }
}

}  // namespace

TEST_CASE("what the JSON writer writes the reader reads back") {
  Rng rng(7);
  for (int round = 0; round < 2000; ++round) {
    const Json value = randomValue(rng, 0);
    JsonWriter out;
    write(out, value);
    const std::optional<Json> read = Json::parse(out.json());
    REQUIRE(read.has_value());
    CHECK(*read == value);
  }
}

TEST_CASE("a JSON text that was cut short or has a byte changed is read or refused, never worse") {
  const std::string good = R"({"stroke":[[1.5,-2e1],[3,4]],"name":"a\u00e9\ud83d\ude00\n","on":true})";
  REQUIRE(Json::parse(good).has_value());
  for (std::size_t cut = 0; cut < good.size(); ++cut) {
    CHECK_FALSE(Json::parse(good.substr(0, cut)).has_value());
  }
  Rng rng(11);
  int refused = 0;
  for (int round = 0; round < 5000; ++round) {
    std::string bad = good;
    bad[rng.below(static_cast<std::uint32_t>(bad.size()))] = static_cast<char>(rng.below(256));
    refused += Json::parse(bad).has_value() ? 0 : 1;
  }
  CHECK(refused > 1000);
}

TEST_CASE("the JSON reader refuses what is not JSON") {
  for (const char* text : {"", " ", "nul", "truth", "[1,]", "[,1]", "{\"a\"}", "{a:1}", "01x", "1 2", "'a'", "NaN",
                           "Infinity", "-", "1.", "1e", "\"\\x\"", "\"\\u12\"", "[1"}) {
    CAPTURE(text);
    CHECK_FALSE(Json::parse(text).has_value());
  }
  CHECK_FALSE(Json::parse(std::string(100000, '[')).has_value());
}

namespace {

/// Any finite double: all its bits by chance.
double anyDouble(Rng& rng) {
  for (;;) {
    const std::uint64_t bits = (std::uint64_t{rng.below(0xffffffff)} << 32) | rng.below(0xffffffff);
    const auto value = std::bit_cast<double>(bits);
    if (std::isfinite(value)) return value;
  }
}

}  // namespace

TEST_CASE("every double that is written reads back as itself, bit by bit") {
  Rng rng(23);
  const auto check = [](double value) {
    JsonWriter out;
    out.number(value);
    const std::optional<Json> read = Json::parse(out.json());
    REQUIRE(read.has_value());
    REQUIRE(read->number().has_value());
    CAPTURE(out.json());
    CHECK(std::bit_cast<std::uint64_t>(*read->number()) == std::bit_cast<std::uint64_t>(value));
  };
  for (const double value : {0.0, -0.0, 1.0, -1.5, 0.1, 1e-7, 123456.789, 6.02e23, -2.5e-9, 5e-324,
                             1.7976931348623157e308, 9007199254740993.0, 1e15, 999999999999999.0}) {
    check(value);
  }
  for (int round = 0; round < 20000; ++round) check(anyDouble(rng));
  // Places on a picture, which have few digits before the point.
  for (int round = 0; round < 20000; ++round) check(rng.uniform(0, 4000));
  JsonWriter out;
  out.beginArray().number(std::numeric_limits<double>::quiet_NaN()).endArray();
  CHECK(out.json() == "[null]");
}

TEST_CASE("numbers that people type are read with zeros before them") {
  CHECK(app::numberFrom("007") == 7);
  CHECK(app::numberFrom("-00.5") == -0.5);
  CHECK(app::numberFrom("0") == 0);
  CHECK(app::numberFrom("12.25") == 12.25);
  for (const char* bad : {"", "-", "--1", "1 2", "0x10", "nan", "true", "1e999"}) {
    CAPTURE(bad);
    CHECK_FALSE(app::numberFrom(bad).has_value());
  }
}

TEST_CASE("a line that is read from the state is the line that was given, to the last bit") {
  test::Rig rig;
  rig.openBar();
  rig.drawBar();
  Rng rng(5);
  const auto write = [&](JsonWriter& json, const std::vector<PicturePoint>& line) {
    json.beginArray();
    for (const PicturePoint p : line) json.beginArray().number(p.x).number(p.y).endArray();
    json.endArray();
  };
  const auto same = [](const Json& read, const std::vector<PicturePoint>& line) {
    REQUIRE(read.array() != nullptr);
    REQUIRE(read.array()->size() == line.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
      const Json::Array& pair = *(*read.array())[i].array();
      CHECK(*pair[0].number() == line[i].x);
      CHECK(*pair[1].number() == line[i].y);
    }
  };
  for (int round = 0; round < 20; ++round) {
    std::vector<PicturePoint> line;
    for (int i = 0; i < 12; ++i) line.push_back({100 + rng.uniform(-20, 20), 30 + 11 * i + rng.uniform(0, 3)});
    JsonWriter args;
    args.beginObject().key("stroke");
    write(args, line);
    args.endObject();
    REQUIRE(rig.run("pose-spine", args.json()).flag("ok") == true);
    same(*(*rig.state().find("parts")->array())[0].find("pose")->find("stroke"), line);
  }
  std::vector<PicturePoint> round;
  for (int i = 0; i < 24; ++i) {
    const double turn = i * 0.26179938779914943, far = 30 + rng.uniform(0, 4);
    round.push_back({100 + far * std::cos(turn), 100 + far * std::sin(turn)});
  }
  JsonWriter args;
  args.beginObject().key("contours").beginArray();
  write(args, round);
  args.endArray().endObject();
  REQUIRE(rig.run("draw-puff", args.json()).flag("ok") == true);
  const Json state = rig.state();
  same((*state.find("parts")->array()->back().find("contours")->array())[0], round);
}
