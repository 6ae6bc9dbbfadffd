#include <doctest/doctest.h>

#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/io/bit_coder.h"
#include "engine/io/packed_json.h"
#include "engine/io/share_text.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

using Json = nlohmann::json;

double randomNumber(Rng& rng) {
  switch (rng.below(6)) {
    case 0:
      return rng.uniform(-1, 1);
    case 1:
      return static_cast<double>(rng.below(4000)) / 4;
    case 2:
      return static_cast<double>(rng.below(100000)) / 1000 - 50;
    case 3:
      return rng.uniform() * 1e300;
    case 4:
      return -5e-324;
    default:
      return -0.0;
  }
}

Json randomScalar(Rng& rng) {
  switch (rng.below(7)) {
    case 0:
      return nullptr;
    case 1:
      return rng.below(2) == 0;
    case 2:
      return static_cast<std::int64_t>(rng.next() >> rng.below(63)) / 2;
    case 3:
      return rng.next();
    case 4:
      return rng.below(2) == 0 ? "circle" : "Große 卵";
    case 5:
      return std::string(rng.below(20), static_cast<char>('a' + rng.below(26)));
    default:
      return randomNumber(rng);
  }
}

Json randomJson(Rng& rng, int depth) {
  const std::uint32_t count = rng.below(8);
  Json out;
  switch (depth > 0 ? rng.below(5) : 0) {
    case 1:
      out = Json::array();
      for (std::uint32_t i = 0; i < count; ++i) out.push_back(randomNumber(rng));
      return out;
    case 2:
      out = Json::array();
      for (std::uint32_t i = 0; i < count; ++i) {
        out.push_back(Json::array({randomNumber(rng), rng.below(2) == 0 ? Json("left") : Json("right"), i}));
      }
      return out;
    case 3:
      out = Json::array();
      for (std::uint32_t i = 0; i < count; ++i) out.push_back(randomJson(rng, depth - 1));
      return out;
    case 4:
      out = Json::object();
      for (std::uint32_t i = 0; i < count; ++i) {
        out[rng.below(2) == 0 ? "stroke" : "key " + std::to_string(rng.below(9))] = randomJson(rng, depth - 1);
      }
      return out;
    default:
      return randomScalar(rng);
  }
}

}  // namespace

TEST_CASE("every JSON comes back from its packed form with equal keys, texts and numbers") {
  for (const std::uint64_t seed : seeds(0, 600)) {
    Rng rng(seed);
    const Json value = randomJson(rng, 4);
    const auto packed = packJson(value);
    REQUIRE(packed.ok());
    const auto read = unpackJson(packed.value());
    REQUIRE(read.ok());
    CHECK_MESSAGE(read.value() == value, seed);
  }
}

TEST_CASE("numbers that are not finite become null") {
  const double huge = std::numeric_limits<double>::infinity();
  const Json value = {{"ends", {1, huge, std::numeric_limits<double>::quiet_NaN()}}, {"height", -huge}};
  const auto packed = packJson(value);
  REQUIRE(packed.ok());
  CHECK(unpackJson(packed.value()).value() == Json{{"ends", {1, nullptr, nullptr}}, {"height", nullptr}});
}

TEST_CASE("a line of even steps takes one bit and a half a number at most, whatever its first number is") {
  Json line = Json::array();
  for (int i = 0; i < 1000; ++i) line.push_back(7000 + 13 * i);
  CHECK(packJson(line).value().size() < 190);
}

TEST_CASE("what nests too deep or holds millions of values is neither packed nor unpacked") {
  Json deep;
  for (int i = 0; i < 2 * kMostPackedDepth; ++i) deep = Json::array({deep});
  const Json longList = std::vector<int>(kMostPacked + 1, 7);
  const Json longText = std::string(kMostPacked + 1, 'a');
  for (const Json& much : {deep, longList, longText}) {
    CHECK_FALSE(packJson(much).ok());
    const auto hostile = packJson(much, {.values = 4 * kMostPacked, .depth = 4 * kMostPackedDepth});
    REQUIRE(hostile.ok());
    CHECK(hostile.value().size() < 20'000);
    CHECK(unpackJson(hostile.value()).error() == Error::ProjectInvalid);
    CHECK_FALSE(readShareText(sealShareText(hostile.value())).ok());
  }
}

TEST_CASE("any bytes unpack to some JSON that packs again, or to an error") {
  int read = 0, refused = 0;
  for (const std::uint64_t seed : seeds(0, 1000)) {
    Rng rng(seed);
    std::vector<std::uint8_t> bytes(rng.below(60));
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(rng.next() & rng.next());
    const auto value = unpackJson(bytes);
    ++(value.ok() ? read : refused);
    if (!value.ok()) continue;
    const auto again = packJson(value.value());
    REQUIRE(again.ok());
    CHECK(unpackJson(again.value()).value() == value.value());
  }
  CHECK(read > 0);
  CHECK(refused > 0);
}

TEST_CASE("the extremes of whole numbers are coded, beside chances that have been learned to be certain") {
  const std::vector<std::int64_t> values = {
      0, 0, 0, std::numeric_limits<std::int64_t>::max() - 1, -1, -std::numeric_limits<std::int64_t>::max() + 1, 1, 0};
  BitWriter writer;
  for (int i = 0; i < 5000; ++i) writer.bit(1, false);
  for (const std::int64_t value : values) writer.integer(2, value);
  writer.bit(1, true);
  const auto bytes = writer.finish();
  BitReader reader(bytes, {});
  for (int i = 0; i < 5000; ++i) REQUIRE_FALSE(reader.bit(1, false));
  for (const std::int64_t value : values) CHECK(reader.integer(2, 0) == value);
  CHECK(reader.bit(1, false));
  CHECK(bytes.size() < 60);
}
