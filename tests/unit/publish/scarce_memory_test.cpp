#include <doctest/doctest.h>

#include "engine/document/update.h"
#include "engine/io/picture_file.h"
#include "engine/publish/publish.h"
#include "engine/vision/edges.h"
#include "tests/support/random_documents.h"
#include "tests/support/scarce_memory.h"

using namespace spineloft;

TEST_CASE("work that gets no memory says so, and works again when there is some") {
  const auto picture = testing::ellipsePicture(400, 300);
  const io::Bytes png = io::encodePng(picture->working).value();
  document::Document model = document::update({}, document::AddPicture{"e", picture}).value();
  model = document::update(model, document::DrawSpine{PictureId{1}, {{80, 150}, {200, 150}, {320, 150}}}).value();
  pipeline::Cache cache;
  const pipeline::Derived derived = pipeline::deriveWithEdges(model, cache, {}).value();

  constexpr std::size_t kLimit = 100'000;
  {
    const auto edges = cache.edges(model.pictures[0]->contentHash);
    const testing::ScarceMemory scarce(kLimit);
    const auto shape = pipeline::shapePart(*document::loftOf(*model.parts[0]), *edges, {400, 300}, {});
    REQUIRE_FALSE(shape.ok());
    CHECK(shape.error() == Error::OutOfMemory);
  }
  {
    const testing::ScarceMemory scarce(kLimit);
    const auto edges = vision::detectEdges(*picture, {}, {});
    REQUIRE_FALSE(edges.ok());
    CHECK(edges.error() == Error::OutOfMemory);
    const auto decoded = io::decodePicture(png, {});
    REQUIRE_FALSE(decoded.ok());
    CHECK(decoded.error() == Error::OutOfMemory);
    for (const auto format : {publish::Format::Glb, publish::Format::Obj, publish::Format::Stl}) {
      const auto bytes = publish::publish(model, derived, format, {});
      REQUIRE_FALSE(bytes.ok());
      CHECK(bytes.error() == Error::OutOfMemory);
    }
  }
  CHECK(vision::detectEdges(*picture, {}, {}).ok());
  CHECK(io::decodePicture(png, {}).ok());
  CHECK(publish::publish(model, derived, publish::Format::Glb, {}).ok());
}
