#include "engine/cli/command_line.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/cli/program.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::cli;

namespace {

Arguments parse(std::vector<std::string_view> words) { return parseArguments(words); }
std::string problemOf(std::vector<std::string_view> words) {
  const Arguments arguments = parseArguments(words);
  const auto* problem = std::get_if<UsageProblem>(&arguments);
  REQUIRE(problem != nullptr);
  return problem->sentence;
}

}  // namespace

TEST_CASE("a loft's words may stand in any order, with a blank or an equals sign") {
  for (const auto& words : std::vector<std::vector<std::string_view>>{
           {"loft", "a.png", "--stroke", "s.json", "--caps", "flat", "--height-mm", "12.5", "--out", "a.STL"},
           {"loft", "--out=a.STL", "--height-mm=12.5", "--caps=flat", "--stroke=s.json", "a.png"},
           {"loft", "--stroke", "s.json", "--out", "a.STL", "--caps", "flat", "--height-mm", "1.25e1", "--",
            "a.png"}}) {
    const Arguments arguments = parse(words);
    const auto* loft = std::get_if<LoftArguments>(&arguments);
    REQUIRE(loft != nullptr);
    CHECK(loft->image == "a.png");
    CHECK(loft->stroke == "s.json");
    CHECK(loft->strokeName.empty());
    CHECK(loft->caps == sections::CapStyle::Flat);
    CHECK(loft->section == sections::SectionPreset::Circle);
    CHECK(loft->heightMm == 12.5);
    CHECK(loft->format == publish::Format::Stl);
  }
}

TEST_CASE("after two dashes a file may be called like an option") {
  const Arguments arguments = parse({"edges", "--out", "e.png", "--", "--help"});
  const auto* edges = std::get_if<EdgesArguments>(&arguments);
  REQUIRE(edges != nullptr);
  CHECK(edges->image == "--help");
}

TEST_CASE("help is given wherever it is asked for, the version only alone") {
  CHECK(std::holds_alternative<HelpArguments>(parse({"--help"})));
  CHECK(std::holds_alternative<HelpArguments>(parse({"bench", "x", "-h"})));
  CHECK(std::holds_alternative<VersionArguments>(parse({"--version"})));
  CHECK(problemOf({"--version", "now"}).find("alone") != std::string::npos);
}

TEST_CASE("every section and cap of the engine can be asked for by its key") {
  for (const auto& name : sections::sectionNames()) {
    const Arguments arguments = parse({"loft", "a.png", "--stroke", "s.json", "--section", name.key});
    REQUIRE(std::holds_alternative<LoftArguments>(arguments));
    CHECK(std::get<LoftArguments>(arguments).section == name.preset);
  }
  for (const auto& name : sections::capNames()) {
    const Arguments arguments = parse({"loft", "a.png", "--stroke", "s.json", "--caps", name.key});
    REQUIRE(std::holds_alternative<LoftArguments>(arguments));
    CHECK(std::get<LoftArguments>(arguments).caps == name.style);
  }
}

TEST_CASE("outputs may not fall on an input or on one another, however their paths are written") {
  CHECK(problemOf({"loft", "a.png", "--stroke", "s.json", "--mask", "./b/../a.png"}).find("input") !=
        std::string::npos);
  CHECK(problemOf({"loft", "a.png", "--stroke", "s.json", "--ribs", "s.json"}).find("input") != std::string::npos);
  CHECK(problemOf({"loft", "a.png", "--stroke", "s.json", "--ribs", "r", "--report", "./r"}).find("same") !=
        std::string::npos);
}

TEST_CASE("any words are understood or refused in a sentence") {
  const std::vector<std::string_view> pool{"loft",           "edges", "bench",  "a.png",  "--stroke",
                                           "s.json",         "--out", "x.glb",  "--caps", "flat",
                                           "--section=gear", "--",    "-",      "--=",    "",
                                           "--height-mm",    "5",     "--jobs", "2",      "--mask=m",
                                           "--obj-space"};
  Rng rng(4);
  int understood = 0;
  for (int i = 0; i < testing::rounds(4000); ++i) {
    std::vector<std::string_view> words;
    for (std::uint32_t k = rng.below(8); k > 0; --k) {
      words.push_back(pool[rng.below(static_cast<std::uint32_t>(pool.size()))]);
    }
    const Arguments arguments = parseArguments(words);
    const auto* problem = std::get_if<UsageProblem>(&arguments);
    understood += problem == nullptr;
    if (problem) {
      REQUIRE(problem->sentence.size() > 5);
      REQUIRE(problem->sentence.back() == '.');
    }
  }
  CHECK(understood > 4);
}

TEST_CASE("a failure becomes one sentence whatever its detail") {
  for (int i = 0; i < static_cast<int>(Error::kCount); ++i) {
    for (const char* detail : {"", "cat.png", "two\nlines"}) {
      const std::string sentence = sentenceOf({static_cast<Error>(i), detail});
      CHECK(sentence.back() == '.');
      CHECK(sentence.find(". ") == std::string::npos);
      CHECK(sentence.find('\n') == std::string::npos);
      CHECK(sentence.find(".)") == std::string::npos);
    }
  }
}
