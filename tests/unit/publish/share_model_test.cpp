#include <doctest/doctest.h>

#include <algorithm>

#include "engine/document/update.h"
#include "engine/io/share_text.h"
#include "engine/publish/share_model.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::publish;
using spineloft::testing::ellipsePicture;

namespace {

pipeline::Derived derivedOf(const Document& document) {
  pipeline::Cache cache;
  return pipeline::deriveWithEdges(document, cache, {}).value();
}

Document onPhoto(int ribs) {
  Document document = update({}, AddPicture{"e", ellipsePicture(1000, 700)}).value();
  document = update(document, DrawSpine{PictureId{1}, {{200, 350}, {500, 360}, {800, 350}}}).value();
  Part part = document.parts[0].get();
  loftOf(part)->spine.ribs = ribs;
  document.parts[0] = part;
  return document;
}

}  // namespace

TEST_CASE("a part on a photo keeps its ribs to within half a pixel without the photo, and shows its mean colour") {
  const Document document = onPhoto(60);
  const pipeline::Derived before = derivedOf(document);
  const auto shared = shareModel(document, before);
  REQUIRE(shared.ok());
  CHECK(shared.value().photosLeft == 1);
  const Document read = io::readShareText(shared.value().text).value();
  const pipeline::Derived after = derivedOf(read);
  REQUIRE(after.parts[0].shape);
  testing::requireLawful(after.parts[0].shape->mesh);
  const auto& was = before.parts[0].shape->ribs.ribs;
  const auto& is = after.parts[0].shape->ribs.ribs;
  REQUIRE(is.size() == was.size());
  double most = 0;
  for (std::size_t i = 0; i < is.size(); ++i) {
    most = std::max({most, distance(is[i].left, was[i].left), distance(is[i].right, was[i].right)});
  }
  CHECK(most <= 0.5);
  const Look& look = read.parts[0]->look;
  CHECK_FALSE(look.textured);
  CHECK(look.colour != Look{}.colour);
}

TEST_CASE("a model without photos is shared as it is") {
  Document document = update({}, AddSketch{"Sketch 1", {400, 300}}).value();
  document = update(document, DrawSpine{PictureId{1}, {{100, 150}, {200, 150}, {300, 150}}}).value();
  const pipeline::Derived derived = derivedOf(document);
  CHECK(withoutPhotos(document, derived) == document);
  CHECK(shareModel(document, derived).value().photosLeft == 0);
}

TEST_CASE("a part with forty ribs on a photo takes at most 300 characters") {
  const Document document = onPhoto(40);
  const auto shared = shareModel(document, derivedOf(document));
  REQUIRE(shared.ok());
  CHECK(shared.value().text.size() <= 300);
}
