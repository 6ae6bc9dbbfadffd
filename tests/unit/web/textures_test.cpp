// Parts are on the screen before their textures are made.
#include <doctest/doctest.h>

#include <memory>
#include <thread>
#include <vector>

#include "tests/unit/web/rig.h"
#include "web/model/studio.h"

using namespace spineloft;
using namespace spineloft::test;

namespace {

/// A studio with a picture of a bar whose edges are known.
struct Desk {
  FakeHost host;
  app::Studio studio;
  explicit Desk(int threads) : studio(host, threads) {
    act(document::AddPicture{"bar", std::make_shared<const image::Picture>(barPicture())});
    rest();
  }
  void act(const document::Action& action) { REQUIRE(studio.act(action).ok()); }
  void draw(double from, double to) {
    std::vector<PicturePoint> stroke;
    for (double y = from; y <= to; y += 4) stroke.push_back({100, y});
    act(document::DrawSpine{PictureId{1}, stroke});
  }
  /// Until nothing is going on; how often something was done.
  int rest() {
    int rounds = 0;
    studio.derived();
    while (studio.busy()) {
      rounds += studio.pump() ? 1 : 0;
      studio.derived();
      std::this_thread::yield();
    }
    return rounds;
  }
  const pipeline::PartShape& shape(std::size_t part = 0) { return *studio.derived().parts[part].shape; }
};

/// The shape that the command line makes of it.
pipeline::PartShape whole(const document::Document& document, std::size_t part = 0) {
  pipeline::Cache cache;
  return *pipeline::deriveWithEdges(document, cache, {}).value().parts[part].shape;
}

}  // namespace

TEST_CASE("a part shows at once, and soon has the mesh and the texture that it is given when all is made in one go" *
          doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    CAPTURE(threads);
    Desk desk(threads);
    desk.draw(40, 160);
    CHECK(desk.shape().quality == pipeline::TraceQuality::Final);
    CHECK(desk.shape().mesh.triangles.size() > 1000);
    CHECK_FALSE(isTextureKnown(desk.shape()));
    CHECK(desk.shape().texture == nullptr);
    // Nobody needs to know.
    CHECK(desk.studio.busy());
    CHECK_FALSE(desk.studio.activity());
    const int rounds = desk.rest();
    if (threads == 0) CHECK(rounds > 4);
    const pipeline::PartShape made = whole(desk.studio.document());
    CHECK(isTextureKnown(desk.shape()));
    REQUIRE((made.texture && desk.shape().texture));
    CHECK(*desk.shape().texture == *made.texture);
    CHECK(desk.shape().mesh == made.mesh);
  }
}

TEST_CASE("a part that changes shows its earlier texture until the new one is made, and undo finds its own again") {
  Desk desk(0);
  desk.draw(40, 160);
  desk.rest();
  const auto first = desk.shape().texture;
  const ShapeKey key = desk.shape().key;
  const TextureKey textureKey = desk.shape().textureKey;
  desk.act(document::SetParameter{PartId{1}, "ribs", 20.0});
  CHECK(desk.shape().key != key);
  CHECK_FALSE(isTextureKnown(desk.shape()));
  CHECK(desk.shape().texture == first);
  CHECK(desk.shape().textureKey == textureKey);
  desk.act(document::SetParameter{PartId{1}, "ribs", 25.0});
  CHECK(desk.shape().texture == first);
  desk.rest();
  CHECK(isTextureKnown(desk.shape()));
  CHECK(*desk.shape().texture == *whole(desk.studio.document()).texture);
  REQUIRE(desk.studio.undo().ok());
  CHECK_FALSE(isTextureKnown(desk.shape()));
  REQUIRE(desk.studio.undo().ok());
  CHECK(isTextureKnown(desk.shape()));
  CHECK(desk.shape().texture == first);
  CHECK(desk.rest() <= 1);
}

TEST_CASE("a file holds every texture, whenever it is asked for") {
  Desk desk(0);
  desk.draw(40, 160);
  const auto early = desk.studio.publishNow(publish::Format::Glb);
  REQUIRE(early.ok());
  CHECK(isTextureKnown(desk.shape()));
  desk.rest();
  CHECK(desk.studio.publishNow(publish::Format::Glb).value() == early.value());
  desk.draw(50, 150);
  CHECK_FALSE(isTextureKnown(desk.shape(1)));
  REQUIRE(desk.studio.save(publish::Format::Glb).ok());
  desk.rest();
  REQUIRE(desk.host.files.size() == 1);
  CHECK(desk.host.files[0].second == desk.studio.publishNow(publish::Format::Glb).value().size());
}

TEST_CASE("parts of one shape share ribs and texture, and a part that is gone asks for none") {
  Desk desk(0);
  desk.draw(40, 160);
  desk.draw(40, 160);
  CHECK(desk.studio.derived().wantedTextures.size() == 1);
  desk.rest();
  CHECK(desk.shape(0).texture == desk.shape(1).texture);
  desk.draw(50, 120);
  CHECK(desk.studio.derived().wantedTextures == std::vector{PartId{3}});
  desk.act(document::DeletePart{PartId{3}});
  CHECK(desk.studio.derived().wantedTextures.empty());
  CHECK(desk.rest() <= 1);
}

TEST_CASE("another model may be opened while textures are made" * doctest::test_suite("threads")) {
  for (const int threads : {0, 2}) {
    Desk desk(threads);
    desk.draw(40, 160);
    desk.studio.derived();
    desk.studio.open(document::History(document::Document{}));
    desk.rest();
    CHECK(desk.studio.derived().parts.empty());
  }
}
