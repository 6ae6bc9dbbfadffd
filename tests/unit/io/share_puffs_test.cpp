// How many characters the slices of puffs take in a link.
#include <doctest/doctest.h>

#include <cmath>
#include <string>

#include "engine/document/update.h"
#include "engine/inflate/ready_profiles.h"
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

TEST_CASE(
    "a preset takes at most 24 characters more in a link, a ready slice at most 70 but for rings, 24 points of one's "
    "own at most "
    "100") {
  using sections::SectionPreset;
  for (const SectionPreset preset : {SectionPreset::Circle, SectionPreset::Square, SectionPreset::Hexagon}) {
    CHECK(charactersOf({.slices = {{sections::SectionShape{preset}}}}) <= 24);
  }
  for (const inflate::ReadyProfile& ready : inflate::readyProfiles()) {
    CAPTURE(std::string(ready.key));
    const int characters = charactersOf(*inflate::readyProfile(ready.key));
    MESSAGE(std::string(ready.key) << ": " << characters << " characters");
    // Two curves of 24 points a ring.
    const std::size_t curves = ready.key == "ring" ? 2 : ready.key == "two-rings" ? 4 : 0;
    CHECK(characters <= (curves > 0 ? 140 * static_cast<int>(curves) : 70));
  }
  sections::SectionShape own;
  own.contours.emplace_back();
  for (int i = 0; i < 24; ++i) {
    const double a = 6.283185307179586 * i / 24, r = 0.8 + 0.1 * std::cos(4 * a);
    own.contours[0].push_back({std::round(1000 * r * std::cos(a)) / 1000, std::round(1000 * r * std::sin(a)) / 1000});
  }
  const int characters = charactersOf({.slices = {{own}}});
  MESSAGE("24 points of one's own: " << characters << " characters");
  CHECK(characters <= 100);
}
