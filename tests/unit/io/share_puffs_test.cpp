// How many characters the slices of puffs take in a link.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/document/update.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/io/share_slices.h"
#include "engine/io/share_text.h"

using namespace spineloft;
using namespace spineloft::document;

namespace {

/// A puff of a pear on paper.
Document pear(const inflate::ProfileParams& profile) {
  Document document = update({}, AddSketch{"Sketch 1", {800, 600}}).value();
  InflateRecipe recipe;
  recipe.region.picture = PictureId{1};
  recipe.region.contours.emplace_back();
  for (int i = 0; i < 60; ++i) {
    const double a = 6.283185307179586 * i / 60, r = 150 + 40 * std::sin(a) + 12 * std::cos(2 * a);
    recipe.region.contours[0].push_back({400 + r * std::cos(a), 300 + r * std::sin(a)});
  }
  recipe.inflate.profile = profile;
  return update(document, DrawRegion{recipe.region, recipe.inflate}).value();
}

int charactersOf(const inflate::ProfileParams& profile) {
  const auto soft = io::writeShareText(pear({})), sliced = io::writeShareText(pear(profile));
  REQUIRE(soft.ok());
  REQUIRE(sliced.ok());
  const auto read = io::readShareText(sliced.value());
  REQUIRE(read.ok());
  CHECK(std::get<InflateRecipe>(read.value().parts[0]->recipe).inflate.profile == profile);
  return static_cast<int>(sliced.value().size()) - static_cast<int>(soft.value().size());
}

}  // namespace

TEST_CASE("a preset and a ready slice take at most 20 characters more in a link, 24 points of one's own at most 60") {
  using sections::SectionPreset;
  for (const SectionPreset preset : {SectionPreset::Circle, SectionPreset::Square, SectionPreset::Hexagon}) {
    const int characters = charactersOf({.slices = {{sections::SectionShape{preset}}}});
    MESSAGE(std::string(sections::sectionKey(preset)) << ": " << characters << " characters");
    CHECK(characters <= 20);
  }
  for (const inflate::ReadyProfile& ready : inflate::readyProfiles()) {
    CAPTURE(std::string(ready.key));
    const int characters = charactersOf(*inflate::readyProfile(ready.key));
    MESSAGE(std::string(ready.key) << ": " << characters << " characters");
    CHECK(characters <= 20);
  }
  sections::SectionShape own;
  own.contours.emplace_back();
  for (int i = 0; i < 24; ++i) {
    const double a = 6.283185307179586 * i / 24, r = 0.8 + 0.1 * std::cos(4 * a);
    own.contours[0].push_back({std::round(1000 * r * std::cos(a)) / 1000, std::round(1000 * r * std::sin(a)) / 1000});
  }
  const int characters = charactersOf({.slices = {{own}}});
  MESSAGE("24 points of one's own: " << characters << " characters");
  CHECK(characters <= 60);
}

TEST_CASE("slices come back from a link point for point, whichever of their points are on the axis") {
  using Curve = std::vector<SectionPoint>;
  const Curve box{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, diamond{{1, 0}, {0, 1}, {-1, 0}, {0, -1}},
      triangle{{-0.5, -0.5}, {0.5, -0.5}, {0, 0.75}}, right{{0.6, -0.25}, {0.9, -0.25}, {0.75, 0.25}},
      left{{-0.6, -0.25}, {-0.75, 0.25}, {-0.9, -0.25}};
  for (Curve curve : {box, diamond, triangle}) {
    for (std::size_t turn = 0; turn < curve.size(); ++turn) {
      std::ranges::rotate(curve, curve.begin() + 1);
      sections::SectionShape shape;
      shape.contours = {curve};
      CHECK(charactersOf({.slices = {{shape}}, .follow = 0.25}) > 0);
      std::ranges::reverse(curve);
    }
  }
  for (Curve other = left; const std::size_t turn : {0, 1, 2}) {
    CAPTURE(turn);
    std::ranges::rotate(other, other.begin() + 1);
    sections::SectionShape shape;
    shape.contours = {right, other};
    CHECK(charactersOf({.slices = {{shape}}}) > 0);
    shape.contours = {other, right, {{-0.25, -0.5}, {0.25, -0.5}, {0.25, 0.5}, {-0.25, 0.5}}};
    CHECK(charactersOf({.slices = {{shape}}, .across = inflate::Across::Length, .reach = 0.05}) > 0);
  }
  inflate::ProfileParams places = *inflate::readyProfile("ring");
  places.slices.push_back(places.slices.front());
  places.slices.back().at = PicturePoint{400, 300};
  for (auto& curve : places.slices.back().shape.contours) {
    for (SectionPoint& p : curve) p.y *= 0.5;
  }
  CHECK(charactersOf(places) > 0);
}

TEST_CASE("slices in short that nobody wrote are read as they are, or left out") {
  const auto restored = [](const char* shape) {
    nlohmann::json document = {{"parts", {{{"kind", "puff"}, {"recipe", {{"shape", nlohmann::json::parse(shape)}}}}}}};
    io::restoreSlices(document);
    return document["parts"][0]["recipe"]["profile"]["slices"][0]["shape"];
  };
  CHECK(restored(R"("hexagon")")["preset"] == "hexagon");
  for (const char* wrong :
       {R"("unknown")", "7", "null", "[]", R"({"contours":7,"mirror":[1]})", R"({"contours":[[0,1,1,0]],"mirror":[]})",
        R"({"contours":[[0,1,1,0]],"mirror":["a"]})", R"({"contours":[[0,1,1,0]],"mirror":[99]})",
        R"({"contours":[[0,1]],"mirror":[1]})", R"({"contours":[[]],"mirror":[1]})",
        R"({"contours":[[0,1,1,0]],"mirror":[-3]})", R"({"contours":[[0,1,1,0]],"mirror":[-9223372036854775807]})"}) {
    CAPTURE(std::string(wrong));
    CHECK(restored(wrong) == nlohmann::json::parse(wrong));
  }
}
