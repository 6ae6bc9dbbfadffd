#include <doctest/doctest.h>

#include "engine/document/update.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/derive.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::pipeline;
using spineloft::testing::ellipsePicture;

namespace {

Document ellipseDocument() {
  Document document = update({}, AddPicture{"e", ellipsePicture(192, 144)}).value();
  return update(document, DrawSpine{PictureId{1}, {{40, 72}, {96, 72}, {150, 72}}}).value();
}

}  // namespace

TEST_CASE("a part waits for the edges of its picture and appears when they are kept") {
  const Document document = ellipseDocument();
  Cache cache;
  Derived derived = derive(document, cache);
  REQUIRE(derived.parts.size() == 1);
  CHECK(derived.parts[0].waiting);
  CHECK(derived.parts[0].shape == nullptr);
  REQUIRE(derived.wantedEdges == std::vector{PictureId{1}});
  const PictureEntry& entry = document.pictures[0];
  auto edges = vision::detectEdges(*entry.picture, {}, {});
  REQUIRE(edges.ok());
  cache.keepEdges(entry.contentHash, std::make_shared<image::EdgeMap>(std::move(edges).value()));
  derived = derive(document, cache);
  CHECK(derived.wantedEdges.empty());
  CHECK_FALSE(derived.parts[0].waiting);
  REQUIRE(derived.parts[0].shape != nullptr);
  CHECK(mesh::inspect(derived.parts[0].shape->mesh).lawful());
}

TEST_CASE("deriving again costs no new shape, and an undone change finds its old one") {
  const Document document = ellipseDocument();
  Cache cache;
  const auto first = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  CHECK(derive(document, cache).parts[0].shape == first);
  const Document changed =
      update(document, SetSection{PartId{1}, loft::SectionPreset::Square}).value();
  const auto second = derive(changed, cache).parts[0].shape;
  CHECK(second != first);
  CHECK(second->ribs == first->ribs);
  CHECK(derive(document, cache).parts[0].shape == first);
}

TEST_CASE("a look, a name or a height changes no shape") {
  const Document document = ellipseDocument();
  Cache cache;
  const auto shape = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  Document other = update(document, SetLook{PartId{1}, {false, {9, 9, 9}}}).value();
  other = update(other, RenamePart{PartId{1}, "Nose"}).value();
  other = update(other, SetHeight{{55}}).value();
  CHECK(derive(other, cache).parts[0].shape == shape);
}

TEST_CASE("dropping every cache changes nothing that is seen") {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    Rng rng(seed);
    Document document;
    for (int step = 0; step < 25; ++step) {
      if (auto next = update(document, testing::randomAction(rng, document))) {
        document = std::move(next).value();
      }
    }
    Cache warm;
    const Derived first = deriveWithEdges(document, warm, {}).value();
    warm.clear();
    const Derived again = deriveWithEdges(document, warm, {}).value();
    REQUIRE(first.parts.size() == again.parts.size());
    for (std::size_t i = 0; i < first.parts.size(); ++i) {
      REQUIRE((first.parts[i].shape == nullptr) == (again.parts[i].shape == nullptr));
      REQUIRE(first.parts[i].failure == again.parts[i].failure);
      if (!first.parts[i].shape) continue;
      CHECK(first.parts[i].shape->ribs == again.parts[i].shape->ribs);
      CHECK(first.parts[i].shape->mesh == again.parts[i].shape->mesh);
      CHECK(mesh::inspect(first.parts[i].shape->mesh).lawful());
    }
  }
}

TEST_CASE("every authored value of a recipe is part of the shape's key") {
  const LoftRecipe recipe = ellipseDocument().parts[0].recipe;
  const std::uint64_t key = shapeKey(recipe, 5);
  CHECK(shapeKey(recipe, 5) == key);
  CHECK(shapeKey(recipe, 6) != key);
  LoftRecipe other = recipe;
  other.stroke[1].y += 1e-9;
  CHECK(shapeKey(other, 5) != key);
  other = recipe;
  other.ribs.levels = 64;
  CHECK(shapeKey(other, 5) != key);
  other = recipe;
  other.spine.ribs = 50;
  CHECK(shapeKey(other, 5) != key);
  other = recipe;
  other.loft.endCap = loft::CapStyle::Open;
  CHECK(shapeKey(other, 5) != key);
}

TEST_CASE("cancelled work says so and keeps nothing") {
  const Document document = ellipseDocument();
  Cache cache;
  const Progress progress;
  progress.cancel();
  const auto derived = deriveWithEdges(document, cache, progress);
  REQUIRE_FALSE(derived.ok());
  CHECK(derived.error() == Error::Cancelled);
  CHECK(cache.edges(document.pictures[0].contentHash) == nullptr);
}
