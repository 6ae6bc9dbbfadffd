// Recipes of every kind of part after somebody changed them in a text editor.
#include <doctest/doctest.h>

#include <array>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/io/recipe_file.h"
#include "engine/pipeline/derive.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"
#include "tests/support/test_files.h"

using namespace spineloft;
using Json = nlohmann::json;

namespace {

/// A value anywhere in it, and what holds it: null for the whole.
struct Place {
  Json* holder = nullptr;
  Json* value = nullptr;
  std::string key;
  std::size_t index = 0;
};
void collect(Json& value, Json* holder, const std::string& key, std::size_t index, std::vector<Place>& out) {
  if (holder) out.push_back({holder, &value, key, index});
  if (value.is_object()) {
    for (auto& [name, member] : value.items()) collect(member, &value, name, 0, out);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i) collect(value[i], &value, {}, i, out);
  }
}

double changedNumber(double number, Rng& rng) {
  if (rng.below(4) != 0) return number * rng.uniform(0.8, 1.25) + rng.uniform(-2, 2);
  const std::array wild{0.0, -number, number * 1e6, 1e300, number + 1};
  return wild[rng.below(wild.size())];
}

/// One change that a hand, or a program with a mistake, could make: mostly of a number.
void change(Json& recipe, Rng& rng) {
  std::vector<Place> places;
  collect(recipe, nullptr, {}, 0, places);
  if (places.empty()) return;
  const auto draw = [&] { return places[rng.below(static_cast<std::uint32_t>(places.size()))]; };
  const Place place = draw();
  if (place.value->is_number() && rng.below(12) != 0) {
    *place.value = changedNumber(place.value->get<double>(), rng);
  } else if (place.value->is_number() || rng.below(3) != 0) {
    return;
  } else if (rng.below(3) == 0) {
    const Json other = *draw().value;
    *place.value = other;
  } else if (place.holder->is_array()) {
    const auto at = place.holder->begin() + static_cast<std::ptrdiff_t>(place.index);
    const Json value = *place.value;
    if (rng.below(2) == 0) {
      place.holder->erase(at);
    } else {
      place.holder->insert(at, value);
    }
  } else {
    place.holder->erase(place.key);
  }
}

}  // namespace

TEST_CASE("a changed recipe makes lawful meshes, or is refused, or its part is, by name" *
          doctest::test_suite("slow")) {
  const auto recipes = testing::testFiles("../assets/docs/recipes");
  int meshes = 0, refused = 0, failures = 0;
  for (int round = 0; round < testing::rounds(200); ++round) {
    CAPTURE(round);
    Rng rng(static_cast<std::uint64_t>(round));
    const auto& [name, bytes] = recipes[static_cast<std::size_t>(round) % recipes.size()];
    CAPTURE(name);
    Json recipe = Json::parse(bytes.begin(), bytes.end());
    for (std::uint32_t i = 0, changes = 1 + rng.below(3); i < changes; ++i) change(recipe, rng);
    const auto read = io::readRecipe(recipe.dump(), {});
    if (!read) {
      CHECK(read.error() != Error::Cancelled);
      ++refused;
      continue;
    }
    pipeline::Cache cache;
    const auto derived = pipeline::deriveWithEdges(read.value(), cache, {});
    REQUIRE(derived.ok());
    for (const pipeline::DerivedPart& part : derived.value().parts) {
      if (part.failure) {
        CHECK(part.failure->error != Error::Cancelled);
        ++failures;
      } else {
        REQUIRE(part.shape);
        testing::requireLawful(part.shape->mesh);
        ++meshes;
      }
    }
  }
  CHECK(meshes > refused);
  CHECK(refused > 0);
  CHECK(failures > 0);
}
