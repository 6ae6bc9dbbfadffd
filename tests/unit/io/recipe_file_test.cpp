#include "engine/io/recipe_file.h"

#include <doctest/doctest.h>

#include "engine/base/rng.h"
#include "engine/io/project_file.h"
#include "engine/pipeline/derive.h"
#include "tests/support/complete_document.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/test_files.h"

using namespace spineloft;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

std::string textOfFile(const std::string& name) {
  const auto bytes = testFile(name);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
const std::vector<std::string> kRecipes{"twisted-pasta", "toothpaste-tube", "helix"};
std::string recipeText(const std::string& name) { return textOfFile("../assets/docs/recipes/" + name + ".json"); }

}  // namespace

TEST_CASE("the recipes of the guide are documents whose parts are solids, and come back from their text") {
  for (const std::string& name : kRecipes) {
    CAPTURE(name);
    const auto read = readRecipe(recipeText(name), {});
    REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : failureSentence(read.failure())));
    CHECK(readRecipe(writeDocument(read.value()), {}).value() == read.value());
    pipeline::Cache cache;
    const auto derived = pipeline::deriveWithEdges(read.value(), cache, {});
    REQUIRE(derived.ok());
    for (const pipeline::DerivedPart& part : derived.value().parts) {
      REQUIRE(part.shape);
      CHECK(requireLawful(part.shape->mesh).genus == 0);
    }
  }
}

TEST_CASE("a recipe may leave out the last ids, of solids too") {
  const std::string text = R"({"pictures": [{"id": 1, "size": [200, 100]}],
    "parts": [{"id": 1, "kind": "shape", "recipe": {"picture": 1, "axis": [[50, 80], [50, 20]], "width": 60}},
              {"id": 2, "kind": "shape", "recipe": {"picture": 1, "axis": [[90, 80], [90, 20]], "width": 60}}],
    "steps": [{"id": 4, "name": "Both", "kind": "join", "operands": [{"part": 1}, {"part": 2}]}]})";
  const auto read = readRecipe(text, {});
  REQUIRE_MESSAGE(read.ok(), (read.ok() ? "" : failureSentence(read.failure())));
  CHECK(read.value().steps.size() == 1);
  CHECK(read.value().lastStepId == 4);
  CHECK(read.value().lastPartId == 2);
}

TEST_CASE("the golden document is no recipe: it stands on a photo, and on its own it says so") {
  const std::string text = textOfFile("golden/document-v1.json");
  const document::Document whole = completeDocument();
  RecipeInput input;
  CHECK(readRecipe(text, input).error() == Error::JsonInvalid);
  input.photo = whole.pictures.front()->picture;
  const auto unknown = readRecipe(text, input);  // in a recipe nothing is ignored, unlike in a file
  REQUIRE(!unknown.ok());
  CHECK(unknown.failure().detail == "there is nothing named sky");
  document::Document known = whole;
  known.extra.clear();
  const auto withoutExtra = [](auto& boxes) {
    for (auto& box : boxes) {
      auto value = box.get();
      value.extra.clear();
      box = std::move(value);
    }
  };
  withoutExtra(known.pictures);
  withoutExtra(known.parts);
  withoutExtra(known.steps);
  withoutExtra(known.drawings);
  const auto read = readRecipe(writeDocument(known), input);
  REQUIRE(read.ok());
  CHECK(read.value() == known);
}

TEST_CASE("a recipe that is cut off or damaged anywhere is refused in words or read as something sound") {
  Rng rng(41);
  for (const std::string& name : kRecipes) {
    const std::string whole = recipeText(name);
    for (std::size_t length = 0; length + 3 < whole.size(); length += 1 + rng.below(40)) {
      CHECK(readRecipe(whole.substr(0, length), {}).error() == Error::JsonInvalid);
    }
    for (int round = 0; round < 150; ++round) {
      std::string damaged = whole;
      for (std::uint32_t i = 0, n = 1 + rng.below(3); i < n; ++i) {
        const char put[] = {'9', '-', 'e', '"', '{', ']', '.', '\0'};
        damaged[rng.below(static_cast<std::uint32_t>(damaged.size()))] = put[rng.below(8)];
      }
      const auto read = readRecipe(damaged, {});
      if (read.ok()) {
        ReadNotes notes;
        CHECK(readDocument(writeDocument(read.value()), {}, &notes).value() == read.value());
        CHECK(notes.clean());
      } else {
        CHECK_FALSE(read.failure().detail.empty());
      }
    }
  }
}
