// Another language: what is asked of it and when, and words that are longer than the English ones.
#include "web/words/words.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/unit/web/longer_words.h"
#include "tests/unit/web/rig.h"
#include "tests/unit/web/shown.h"

using namespace spineloft;
using app::Json;
using app::Rect;
using spineloft::test::inSight;
using spineloft::test::LongerWords;
using spineloft::test::Rig;
using spineloft::test::Shown;
using spineloft::test::Speaking;

namespace {

/// Knows one text, and counts what it is asked.
class OneText final : public words::Source {
 public:
  std::string translated(std::string_view english, std::string_view args) override {
    asked.emplace_back(english, args);
    return english == "Part {n}" ? "Teil" : std::string();
  }
  std::string drawn(std::string_view text) override {
    ++drawings;
    return {text.rbegin(), text.rend()};
  }
  std::vector<std::pair<std::string, std::string>> asked;
  int drawings = 0;
};

/// Pairs of controls that lie on each other, by their words.
std::vector<std::pair<std::string, std::string>> meetings(const std::vector<Shown>& all) {
  std::vector<std::pair<std::string, std::string>> out;
  for (std::size_t i = 0; i < all.size(); ++i) {
    for (std::size_t k = i + 1; k < all.size(); ++k) {
      if (all[i].at.meets(all[k].at)) out.emplace_back(all[i].words, all[k].words);
    }
  }
  return out;
}

}  // namespace

TEST_CASE("English is the text of the code with its arguments put in, and without arguments that text itself") {
  const std::string_view plain = "Save";
  CHECK(words::tr(plain).data() == plain.data());
  CHECK(words::tr("Set on {n} parts.", {{"n", 3}}) == "Set on 3 parts.");
  CHECK(words::tr("{n} mm", {{"n", 12.5}}) == "12.5 mm");
  CHECK(words::tr("{a} and {b}", {{"b", "x"}, {"a", std::string("{b}")}}) == "{b} and x");
  CHECK(words::tr("an open { brace") == "an open { brace");
}

TEST_CASE("a text is asked for once for the same arguments, and is English where the language has no word for it") {
  OneText source;
  const Speaking speaking({"xx", false, &source});
  const std::string_view first = words::tr("Part {n}", {{"n", 2}});
  CHECK(first == "Teil");
  CHECK(words::tr("Part {n}", {{"n", 2}}).data() == first.data());
  CHECK(source.asked == std::vector<std::pair<std::string, std::string>>{{"Part {n}", R"({"n":2})"}});
  CHECK(words::tr("Part {n}", {{"n", 3}}) == "Teil");
  CHECK(source.asked.size() == 2);
  CHECK(words::tr("{a} is {b}", {{"a", "\"q\""}, {"b", 1}}) == "\"q\" is 1");
  CHECK(source.asked.back().second == R"({"a":"\"q\"","b":1})");
}

TEST_CASE("names that the engine gave are in the visitor's language, and what a visitor typed stays") {
  OneText source;
  const Speaking speaking({"xx", false, &source});
  CHECK(words::nameOf("Part 2") == "Teil");
  for (const std::string_view own : {"Part", "Part ", "Part 2b", "Part -2", "Partner 2", "My cat", ""}) {
    CHECK(words::nameOf(own) == own);
  }
}

TEST_CASE("only a language that is written from the right has its texts put in the order of sight") {
  OneText source;
  {
    const Speaking speaking({"xx", false, &source});
    CHECK(words::drawn("abc") == "abc");
  }
  CHECK(source.drawings == 0);
  const Speaking speaking({"yy", true, &source});
  CHECK(words::drawn("abc") == "cba");
  CHECK(words::drawn("abc") == "cba");
  CHECK(source.drawings == 1);
}

TEST_CASE("a page at rest asks its language for nothing, however often it is drawn") {
  Rig rig;
  rig.openBar();
  rig.drawBar();
  LongerWords source;
  const Speaking speaking({"xx", false, &source}, *rig.app);
  rig.settle();
  CHECK(source.asked > 20);
  const int before = source.asked;
  for (int i = 0; i < 5; ++i) rig.app->frame();
  CHECK(source.asked == before);
}

TEST_CASE("words 40 % longer bring no controls together that were apart, and leave none outside the page") {
  // As 1440 × 900, 1024 × 768 and 390 × 844 leave them below the bar of the page.
  for (const platform::CanvasSize& size : {platform::CanvasSize{1440, 844, 1}, {1024, 712, 1}, {390, 780, 2}}) {
    Rig rig(size);
    rig.openBar();
    rig.drawBar(size.width < 500 ? platform::Device::Touch : platform::Device::Mouse);
    for (const char* tool : {"draw", "ribs", "bone", "along", "move", "puff"}) {
      rig.run(tool);
      rig.settle();
      const auto apart = meetings(inSight(rig));
      LongerWords source;
      const Speaking speaking({"xx", false, &source}, *rig.app);
      rig.settle();
      const std::vector<Shown> all = inSight(rig);
      CAPTURE(size.width);
      CAPTURE(tool);
      REQUIRE(all.size() > 5);
      for (const Shown& one : all) {
        CAPTURE(one.words);
        CHECK(one.at.x >= -0.5);
        CHECK(one.at.right() <= size.width + 0.5);
      }
      for (const auto& pair : meetings(all)) {
        CAPTURE(pair.first);
        CAPTURE(pair.second);
        CHECK(std::ranges::count(apart, pair) > 0);
      }
    }
  }
}

TEST_CASE("the language is chosen by a command, by its id") {
  Rig rig;
  rig.run("language", R"({"language": "de"})");
  CHECK(rig.host.said(R"({"type":"language","id":"de"})"));
  CHECK(rig.run("language", R"({"language": "xx"})").find("error") != nullptr);
  CHECK(rig.run("language").find("error") != nullptr);
}
