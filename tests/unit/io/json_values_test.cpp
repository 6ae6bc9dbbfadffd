#include "engine/io/json_values.h"

#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <string>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::io;

namespace {

std::vector<PicturePoint> strokeOf(std::string_view json, std::string_view name = {}) {
  const auto stroke = readStroke(json, name);
  REQUIRE(stroke.ok());
  return stroke.value();
}
Failure failureOf(std::string_view json, std::string_view name = {}) {
  const auto stroke = readStroke(json, name);
  REQUIRE_FALSE(stroke.ok());
  return stroke.failure();
}

}  // namespace

TEST_CASE("a stroke is read from a list, from points, and by name") {
  const std::vector<PicturePoint> wanted{{1, 2}, {3.5, -4e2}};
  CHECK(strokeOf("[[1,2],[3.5,-4e2]]") == wanted);
  CHECK(strokeOf(" {\"points\": [[1, 2, 0.7], [3.5, -400, 1]], \"id\": 3} ") == wanted);
  const std::string named = R"({"spines": {"sloppy": [[1,2],[3.5,-400]], "careful": [[9,9],[8,8]]}})";
  CHECK(strokeOf(named) == wanted);
  CHECK(strokeOf(named, "sloppy") == wanted);
  CHECK(strokeOf(named, "careful") == std::vector<PicturePoint>{{9, 9}, {8, 8}});
}

TEST_CASE("every stroke that is not one is refused with its reason") {
  for (const char* text :
       {"", "{", "nonsense", "12", "\"line\"", "{}", "{\"points\": 3}", "[1, 2]", "[[1, 2], [3]]", "[[1, 2], 3]",
        "[[1, 2], [\"3\", 4]]", "[[1, 2], [true, 4]]", "[[1, 2], [3, 4]", "{\"spines\": 1}", "{\"spines\": {}}",
        "{\"spines\": {\"a\": 1}}", "[[NaN, 1]]", "[[1, 2]] tail"}) {
    CAPTURE(text);
    const Failure failure = failureOf(text);
    CHECK((failure.error == Error::JsonInvalid));
    CHECK_FALSE(failure.detail.empty());
  }
  CHECK((failureOf("[]").error == Error::StrokeTooShort));
  CHECK((failureOf("[[1, 2], [null, 2]]").error == Error::StrokeNotFinite));
  CHECK_FALSE(readStroke("[[1, 2], [1e999, 2]]", {}).ok());
  CHECK((failureOf("[[1, 2], [3, 4]]", "careful").error == Error::JsonInvalid));
  CHECK(failureOf(R"({"spines": {"a": [[1, 2]], "b": [[1, 2]]}})", "c").detail.find("a, b") != std::string::npos);
}

TEST_CASE("hostile JSON of any shape is survived") {
  CHECK_FALSE(readStroke(std::string(200000, '['), {}).ok());
  std::string deep;
  for (int i = 0; i < 50000; ++i) deep += "{\"spines\":";
  CHECK_FALSE(readStroke(deep, {}).ok());
  std::string nested(100000, '[');
  nested += std::string(100000, ']');
  CHECK_FALSE(readStroke(nested, {}).ok());
  Rng rng(7);
  const std::string_view letters = "[]{}\",:.0123456789eE+-ntfas pointsie";
  for (int i = 0; i < 5000; ++i) {
    std::string text;
    for (std::uint32_t k = rng.below(60); k > 0; --k)
      text += letters[rng.below(static_cast<std::uint32_t>(letters.size()))];
    const auto stroke = readStroke(text, {});
    if (stroke.ok()) REQUIRE_FALSE(stroke.value().empty());
    REQUIRE_FALSE(readBenchCase(text).ok());
  }
}

TEST_CASE("ribs are written as they are, and their ends read back as a stroke") {
  ribs::RibSet ribs;
  ribs.ribs.push_back({{10.1, 20.2}, {5, 20}, {15.5, 1.0 / 3}, ribs::RibState::Edge, ribs::RibState::Bridged});
  ribs.ribs.push_back({{11, 21}, {6, 20}, {16, 20}, ribs::RibState::Guessed, ribs::RibState::Guessed});
  const std::string text = writeRibs(ribs);
  CHECK(text ==
        "{\"ribs\":[{\"center\":[10.1,20.2],\"left\":[5.0,20.0],\"right\":[15.5,0.3333333333333333],"
        "\"leftState\":\"edge\",\"rightState\":\"bridged\"},{\"center\":[11.0,21.0],\"left\":[6.0,20."
        "0],"
        "\"right\":[16.0,20.0],\"leftState\":\"guessed\",\"rightState\":\"guessed\"}]}\n");
}

TEST_CASE("a report says everything, and what is not finite becomes null") {
  LoftReport report;
  report.picture = {640, 480};
  report.ribs = 100;
  report.energy = {1, 2, 3.5};
  report.mesh.closed = true;
  report.mesh.volume = std::numeric_limits<double>::quiet_NaN();
  report.milliseconds = {{"edges", 12.5}, {"ribs", 3}};
  const std::string text = writeReport(report);
  for (const char* part : {"\"width\": 640", "\"ribs\": 100", "\"total\": 6.5", "\"closed\": true", "\"lawful\": false",
                           "\"volume\": null", "\"edges\": 12.5", "\"ribs\": 3"}) {
    CAPTURE(part);
    CHECK(text.find(part) != std::string::npos);
  }
}

TEST_CASE("what makes a case hard is read with it, what is left out of that is 0, and what is no number too") {
  const auto read = readBenchCase(R"({"id": "cup", "image": "i.png", "mask": "m.png", "axis": [[1, 2, 3], [4, 5, 6]],
    "spines": {"sloppy": [[1, 1], [2, 2]]},
    "difficulty": {"occlusion_pct": 12.5, "missing_boundary_pct": 25, "no_edge_pct": "much", "tags": ["shine"]}})");
  REQUIRE(read.ok());
  REQUIRE(read.value().difficulty.has_value());
  const BenchDifficulty& hard = *read.value().difficulty;
  CHECK(hard.hiddenPct == 12.5);
  CHECK(hard.missingOutlinePct == 25);
  CHECK(hard.faintOutlinePct == 0);
  CHECK(hard.noise == 0);
  CHECK(hard.innerEdges == 0);
}

TEST_CASE("a case of a data folder is read with its strokes in order") {
  const std::string text = R"({"id": "cup", "category": "photo", "image": "i.png", "mask": "m.png",
    "boundary_tolerance_px": 2.5, "axis": [[1, 2, 3], [4, 5, 6]],
    "spines": {"sloppy": [[1, 1], [2, 2]], "careful": [[3, 3]]}})";
  const auto read = readBenchCase(text);
  REQUIRE(read.ok());
  const BenchCase& one = read.value();
  CHECK(one.id == "cup");
  CHECK(one.category == "photo");
  CHECK(one.boundaryTolerance == 2.5);
  CHECK(one.axis == std::vector<std::array<double, 3>>{{1, 2, 3}, {4, 5, 6}});
  REQUIRE(one.strokes.size() == 2);
  CHECK(one.strokes[0].first == "sloppy");
  CHECK(one.strokes[1].second == std::vector<PicturePoint>{{3, 3}});
  CHECK_FALSE(one.difficulty.has_value());
  for (const char* key : {"\"id\"", "\"image\"", "\"mask\"", "\"axis\"", "\"spines\""}) {
    std::string broken = text;
    broken[broken.find(key) + 1] = '?';
    CHECK(readBenchCase(broken).error() == Error::JsonInvalid);
  }
}

TEST_CASE("a benchmark is written group by group and row by row; counts have no fraction") {
  BenchReport report;
  report.summary = {{"all careful", {{"cases", 2}, {"iou", 0.875}}}};
  report.rows = {{"cup", "photo", "careful", {{"iou", 0.875}}, "", {}},
                 {"cat", "photo", "careful", {{"iou", 0}}, "StrokeLoops", {"noise"}}};
  std::string text = writeBench(report);
  std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
  CHECK(text ==
        "{\"summary\":[{\"name\":\"allcareful\",\"cases\":2,\"iou\":0.875}],\"cases\":["
        "{\"name\":\"cupcareful\",\"id\":\"cup\",\"category\":\"photo\",\"stroke\":\"careful\","
        "\"difficulty\":[],\"iou\":0.875},{\"name\":\"catcareful\",\"id\":\"cat\",\"category\":\"photo\","
        "\"stroke\":\"careful\",\"difficulty\":[\"noise\"],\"failure\":\"StrokeLoops\",\"iou\":0}]}");
  CHECK(writeNumbers({{"a", 1}, {"b", std::numeric_limits<double>::infinity()}}) == "{\n \"a\": 1,\n \"b\": null\n}\n");
}
