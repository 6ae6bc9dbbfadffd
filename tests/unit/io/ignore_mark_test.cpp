#include <doctest/doctest.h>

#include "engine/io/json_fields.h"

using namespace spineloft;

TEST_CASE("a scribble that covers is read back as one, and one from before that could be said covers nothing") {
  const ribs::IgnoreMark plain{{{1, 2}, {3, 4}}, 5}, covers{{{1, 2}, {3, 4}}, 5, true};
  for (const ribs::IgnoreMark& mark : {plain, covers}) {
    ribs::IgnoreMark back;
    REQUIRE(io::get(io::toJson(mark), back));
    CHECK(back == mark);
  }
  ribs::IgnoreMark old;
  REQUIRE(io::get(io::Json::parse("[5, [1, 2, 3, 4]]"), old));
  CHECK(old == plain);
  for (const char* wrong : {"[5]", "[5, [1, 2], \"yes\"]", "[5, [1, 2], true, 1]", "{}"}) {
    CAPTURE(wrong);
    ribs::IgnoreMark kept = plain;
    CHECK_FALSE(io::get(io::Json::parse(wrong), kept));
    CHECK(kept == plain);
  }
}
