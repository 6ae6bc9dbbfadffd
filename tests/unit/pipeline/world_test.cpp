#include <doctest/doctest.h>

#include <algorithm>
#include <string>

#include "engine/document/update.h"
#include "engine/pipeline/world.h"
#include "engine/publish/publish.h"
#include "tests/support/generators.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::pipeline;
using namespace spineloft::testing;

namespace {

constexpr image::Size kSize{192, 144};

Document onePart() {
  Document document = update({}, AddPicture{"e", ellipsePicture(192, 144)}).value();
  return update(document, DrawSpine{PictureId{1}, {{40, 72}, {96, 72}, {150, 72}}}).value();
}

Derived derivedOf(const Document& document) {
  Cache cache;
  return deriveWithEdges(document, cache, {}).value();
}

MirrorPlane anyPlane(Rng& rng) {
  const WorldPoint n{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
  return {{rng.uniform(-1, 1), rng.uniform(-1, 1), 0.1}, normalized(n)};
}

/// The `v` lines of an OBJ.
std::vector<WorldPoint> verticesOf(const publish::Bytes& obj) {
  std::vector<WorldPoint> points;
  const std::string text(obj.begin(), obj.end());
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    if (text.compare(at, 2, "v ") == 0) {
      WorldPoint p;
      std::size_t used = 0, from = at + 2;
      for (double* value : {&p.x, &p.y, &p.z}) {
        *value = std::stod(text.substr(from, end - from), &used);
        from += used;
      }
      points.push_back(p);
    }
    at = end + 1;
  }
  return points;
}

}  // namespace

TEST_CASE("a part at rest comes to the world as its picture's frame says, and back again") {
  const WorldFrame frame = worldFrame(kSize);
  Rng rng(1);
  for (int i = 0; i < 200; ++i) {
    const Placement placement = i == 0 ? Placement{} : randomPlacement(rng);
    const std::optional<MirrorPlane> mirror = i % 2 ? std::optional(anyPlane(rng)) : std::nullopt;
    const Copies copies = copiesInWorld(placement, mirror, kSize);
    REQUIRE(copies.count == (mirror ? 2 : 1));
    const ModelPoint p{rng.uniform(0, 192), rng.uniform(-144, 0), rng.uniform(-50, 50)};
    const WorldPoint there = placement(frame.toWorld(p));
    CHECK(distance(copies.all[0](p), there) < 1e-12);
    if (mirror) CHECK(distance(copies.all[1](p), (*mirror)(there)) < 1e-12);
    for (const ToWorld& toWorld : copies) {
      CHECK(distance(toWorld.toModel(toWorld(p)), p) < 1e-9);
      CHECK(toWorld.isStraight() == (i == 0 && &toWorld == copies.begin()));
    }
  }
}

TEST_CASE("a box stays lawful and keeps its volume by the cube of the scale, however it is placed or mirrored") {
  const mesh::TriMesh box = testing::box(40, 30, 20);
  const double frame = worldFrame(kSize).scale;
  Rng rng(2);
  for (int i = 0; i < 100; ++i) {
    const Placement placement = randomPlacement(rng);
    for (const ToWorld& toWorld : copiesInWorld(placement, anyPlane(rng), kSize)) {
      const mesh::MeshReport report = requireLawful(worldMesh(box, toWorld));
      const double s = frame * placement.scale;
      CHECK(report.volume == doctest::Approx(40 * 30 * 20 * s * s * s).epsilon(1e-4));
    }
  }
}

TEST_CASE(
    "the file of a placed part holds the placed mesh, its twin and its mirrored copy: placing commutes with export") {
  const Document document = onePart();
  const Derived derived = derivedOf(document);
  const mesh::TriMesh& mesh = derived.parts[0].shape->mesh;
  Rng rng(3);
  for (int i = 0; i < 12; ++i) {
    const std::optional<MirrorPlane> mirror = i % 2 ? std::optional(anyPlane(rng)) : std::nullopt;
    const Placement placement = randomPlacement(rng);
    const Document placed = update(document, PlaceParts{{{PartId{1}, placement, mirror}}}).value();
    const auto obj = publish::publish(placed, derived, publish::Format::Obj, {});
    REQUIRE(obj.ok());
    // From millimetres back to the world: the file stands on the ground, centred, as tall as asked for.
    const std::optional<WorldBounds> shown = worldBounds(placed, derived);
    REQUIRE(shown);
    const double mm = placed.height.value / (shown->high.y - shown->low.y);
    const WorldPoint base{(shown->low.x + shown->high.x) / 2, shown->low.y, (shown->low.z + shown->high.z) / 2};
    std::vector<WorldPoint> written = verticesOf(obj.value());
    for (WorldPoint& p : written) p = p / mm + base;
    std::vector<WorldPoint> expected;
    for (const ToWorld& toWorld : copiesInWorld(*placed.parts[0], kSize)) {
      requireLawful(worldMesh(mesh, toWorld));
      for (const auto& p : mesh.positions) expected.push_back(toWorld(p));
    }
    REQUIRE(written.size() == expected.size());
    double worst = 0;
    for (std::size_t k = 0; k < written.size(); ++k) worst = std::max(worst, distance(written[k], expected[k]));
    CHECK(worst < 2e-6);
    // What the bounds say is what is written.
    std::optional<WorldBounds> bounds;
    for (const WorldPoint p : written) include(bounds, p);
    CHECK(distance(bounds->low, worldBounds(placed, derived)->low) < 2e-6);
    CHECK(distance(bounds->high, worldBounds(placed, derived)->high) < 2e-6);
    for (const publish::Format format : {publish::Format::Glb, publish::Format::Stl}) {
      CHECK(publish::publish(placed, derived, format, {}).ok());
    }
  }
}

TEST_CASE("the first part of a further picture stands to the right of what is there, on its ground") {
  Document document = onePart();
  CHECK(standBeside(document, derivedOf(document), PictureId{1}, derivedOf(document).parts[0].shape->mesh) ==
        Placement{});
  document = update(document, AddPicture{"f", ellipsePicture(100, 180)}).value();
  const Document drawn = update(document, DrawSpine{PictureId{2}, {{50, 60}, {50, 90}, {50, 120}}}).value();
  const Derived derived = derivedOf(drawn);
  const mesh::TriMesh& second = derived.parts[1].shape->mesh;
  const Placement beside = standBeside(document, derivedOf(document), PictureId{2}, second);
  const Document placed = update(drawn, PlaceParts{{{PartId{2}, beside, {}}}}).value();
  const PartId one[] = {PartId{1}}, two[] = {PartId{2}};
  const WorldBounds left = *boundsOf(placed, derived, one), right = *boundsOf(placed, derived, two);
  CHECK(right.low.x > left.high.x);
  CHECK(right.low.y == doctest::Approx(left.low.y));
  CHECK(*boundsWithout(placed, derived, one) == right);
  // What is traced on that picture afterwards stands as it was traced.
  const Placement third = standBeside(placed, derived, PictureId{2}, second);
  CHECK(third == beside);
  Rng rng(8);
  const Placement turned = randomPlacement(rng);
  const Document moved = update(placed, PlaceParts{{{PartId{2}, turned, {}}}}).value();
  const Placement follows = standBeside(moved, derived, PictureId{2}, second);
  const WorldPoint p{0.1, 0.2, 0.3};
  CHECK(distance(follows(p), turned(p)) < 1e-12);
}
