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

TEST_CASE("every authored value of a recipe and its picture is part of the shape's key") {
  const Document document = ellipseDocument();
  const LoftRecipe recipe = document.parts[0]->recipe;
  const PictureEntry entry = document.pictures[0];
  const std::uint64_t key = shapeKey(recipe, entry);
  CHECK(shapeKey(recipe, entry) == key);
  PictureEntry elsewhere = entry;
  elsewhere.contentHash ^= 1;
  CHECK(shapeKey(recipe, elsewhere) != key);
  elsewhere = entry;
  elsewhere.ignored = {{{{1, 2}}, 3}};
  CHECK(shapeKey(recipe, elsewhere) != key);
  const auto changes = [&](void (*change)(LoftRecipe&)) {
    LoftRecipe other = recipe;
    change(other);
    return shapeKey(other, entry) != key;
  };
  CHECK(changes([](LoftRecipe& r) { r.stroke[1].y += 1e-9; }));
  CHECK(changes([](LoftRecipe& r) { r.ribs.levels = 64; }));
  CHECK(changes([](LoftRecipe& r) { r.spine.ribs = 50; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.endCap = loft::CapStyle::Open; }));
  CHECK(changes([](LoftRecipe& r) { r.edits.ends.push_back({}); }));
  CHECK(changes([](LoftRecipe& r) { r.edits.added.push_back(0.5); }));
  CHECK(changes([](LoftRecipe& r) { r.ignored.push_back({{{1, 2}}, 3}); }));
  CHECK(changes([](LoftRecipe& r) { r.pose.depth.points = {{0, 1}}; }));
  CHECK(changes([](LoftRecipe& r) { r.pose.closed = true; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.twist.points = {{0, 1}}; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.squash.points = {{0, 1}}; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.sections[0].blend.kind = loft::BlendKind::Root; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.sections[0].shape.contours = {{{1, 0}}}; }));
}

TEST_CASE("cancelled work says so and keeps nothing") {
  const Document document = ellipseDocument();
  Cache cache;
  const Progress progress;
  progress.cancel();
  const auto derived = deriveWithEdges(document, cache, progress);
  REQUIRE_FALSE(derived.ok());
  CHECK(derived.error() == Error::Cancelled);
  CHECK(cache.edges(document.pictures[0]->contentHash) == nullptr);
}
