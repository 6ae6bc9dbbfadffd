#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "engine/base/rng.h"
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
      Json::Object members;
      for (std::uint32_t i = rng.below(4); i > 0; --i) {
        members.emplace_back(randomText(rng), randomValue(rng, depth + 1));
      }
      return members;
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

TEST_CASE("JSON numbers keep their value to nine digits") {
  for (const double value : {0.0, 1.0, -1.5, 0.1, 1e-7, 123456.789, 6.02e23, -2.5e-9}) {
    JsonWriter out;
    out.number(value);
    CHECK(Json::parse(out.json())->number() == doctest::Approx(value).epsilon(1e-8));
  }
  JsonWriter out;
  out.beginArray().number(std::numeric_limits<double>::quiet_NaN()).endArray();
  CHECK(out.json() == "[null]");
  CHECK(std::isinf(*Json::parse("1e999")->number()));
}
