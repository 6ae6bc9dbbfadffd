#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <string>

#include "engine/document/update.h"
#include "engine/io/project_file.h"
#include "engine/publish/publish.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::publish;
using spineloft::testing::ellipsePicture;

namespace {

Document twoParts() {
  Document document = update({}, AddPicture{"e", ellipsePicture(192, 144)}).value();
  document = update(document, DrawSpine{PictureId{1}, {{40, 72}, {96, 72}, {150, 72}}}).value();
  document = update(document, AddPicture{"f", ellipsePicture(100, 180)}).value();
  document = update(document, DrawSpine{PictureId{2}, {{50, 60}, {50, 90}, {50, 120}}}).value();
  return update(document, SetHeight{{40}}).value();
}

pipeline::Derived derivedOf(const Document& document) {
  pipeline::Cache cache;
  return pipeline::deriveWithEdges(document, cache, {}).value();
}

int timesFound(const Bytes& bytes, std::initializer_list<std::uint8_t> what) {
  int found = 0;
  for (auto at = bytes.begin();; ++at, ++found) {
    at = std::search(at, bytes.end(), what.begin(), what.end());
    if (at == bytes.end()) return found;
  }
}

struct StlBox {
  std::array<float, 3> low{1e9f, 1e9f, 1e9f}, high{-1e9f, -1e9f, -1e9f};
};

StlBox boxOfStl(const Bytes& stl) {
  StlBox box;
  for (std::size_t at = 84; at + 50 <= stl.size(); at += 50) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      std::array<float, 3> p{};
      std::memcpy(p.data(), stl.data() + at + 12 + corner * 12, 12);
      for (std::size_t k = 0; k < 3; ++k) {
        box.low[k] = std::min(box.low[k], p[k]);
        box.high[k] = std::max(box.high[k], p[k]);
      }
    }
  }
  return box;
}

}  // namespace

TEST_CASE("the picture's longer side spans 1 in the world and its centre is the origin") {
  const WorldFrame frame = worldFrame({200, 100});
  const WorldPoint left = frame.toWorld({-0.5, -49.5, 0}), right = frame.toWorld({199.5, -49.5, 0});
  CHECK(right.x - left.x == doctest::Approx(1));
  CHECK(right.x == doctest::Approx(0.5));
  CHECK(left.y == doctest::Approx(0));
}

TEST_CASE("a model of 40 mm is 40.00 mm tall in an STL and stands on the ground") {
  const Document document = twoParts();
  const auto stl = publish::publish(document, derivedOf(document), Format::Stl, {});
  REQUIRE(stl.ok());
  const StlBox box = boxOfStl(stl.value());
  CHECK(box.low[2] == doctest::Approx(0).epsilon(1e-4));
  CHECK(box.high[2] == doctest::Approx(40).epsilon(1e-5));
  CHECK(box.low[0] + box.high[0] == doctest::Approx(0).epsilon(1e-3));
}

TEST_CASE("hidden parts are not exported, and without a visible part there is nothing to export") {
  Document document = twoParts();
  const pipeline::Derived derived = derivedOf(document);
  const std::size_t both = publish::publish(document, derived, Format::Obj, {}).value().size();
  document = update(document, ShowPart{PartId{1}, false}).value();
  const Bytes one = publish::publish(document, derived, Format::Obj, {}).value();
  CHECK(one.size() < both);
  const std::string text(one.begin(), one.end());
  CHECK(text.find("Part 1") == std::string::npos);
  CHECK(text.find("Part 2") != std::string::npos);
  document = update(document, ShowPart{PartId{2}, false}).value();
  for (const Format format : {Format::Glb, Format::Obj, Format::Stl, Format::ObjZip, Format::ThreeMf}) {
    const auto none = publish::publish(document, derived, format, {});
    REQUIRE_FALSE(none.ok());
    CHECK(none.error() == Error::NothingToExport);
  }
}

TEST_CASE("a GLB holds one texture for all parts that show a picture, and none when none does") {
  Document document = twoParts();
  const auto jpegs = [&] {
    const Bytes glb = publish::publish(document, derivedOf(document), Format::Glb, {}, {.withProject = false}).value();
    CHECK(timesFound(glb, {0x89, 'P', 'N', 'G'}) == 0);
    return timesFound(glb, {0xff, 0xd8, 0xff});
  };
  CHECK(jpegs() == 1);
  document = update(document, SetLook{PartId{1}, {false, {200, 10, 10}}}).value();
  CHECK(jpegs() == 1);
  document = update(document, SetLook{PartId{2}, {false, {200, 10, 10}}}).value();
  CHECK(jpegs() == 0);
}

TEST_CASE("a GLB with its project holds every photo once") {
  Document document = twoParts();
  const auto pngs = [&] {
    const Bytes glb = publish::publish(document, derivedOf(document), Format::Glb, {}).value();
    return timesFound(glb, {0x89, 'P', 'N', 'G'});
  };
  CHECK(pngs() == 2);
  document = update(document, SetLook{PartId{2}, {false, {200, 10, 10}}}).value();
  CHECK(pngs() == 2);
  document = update(document, AddPicture{"again", document.pictures[0]->picture}).value();
  CHECK(pngs() == 2);
}

TEST_CASE("a saved model opens as the same document, and the same ribs and solids come of it") {
  const Document document = twoParts();
  const pipeline::Derived derived = derivedOf(document);
  const Bytes glb = publish::publish(document, derived, Format::Glb, {}).value();
  CHECK(glb == publish::publish(document, derived, Format::Project, {}).value());
  const auto read = io::readProject(glb);
  REQUIRE(read.ok());
  REQUIRE(read.value() == document);
  const pipeline::Derived again = derivedOf(read.value());
  REQUIRE(again.parts.size() == derived.parts.size());
  for (std::size_t i = 0; i < derived.parts.size(); ++i) {
    CHECK(again.parts[i].shape->ribs == derived.parts[i].shape->ribs);
    CHECK(again.parts[i].shape->mesh.positions == derived.parts[i].shape->mesh.positions);
    CHECK(again.parts[i].shape->mesh.triangles == derived.parts[i].shape->mesh.triangles);
  }
  CHECK(publish::publish(read.value(), again, Format::Project, {}).value() == glb);
}

TEST_CASE("a board without anything to show is saved as a project all the same") {
  for (Document document : {Document{}, update({}, AddSketch{"paper", {100, 80}}).value(),
                            update({}, AddPicture{"e", ellipsePicture(60, 40)}).value(),
                            update(twoParts(), ShowPart{PartId{1}, false}).value()}) {
    if (document.parts.size() == 2) document = update(document, ShowPart{PartId{2}, false}).value();
    const auto file = publish::publish(document, derivedOf(document), Format::Project, {});
    REQUIRE(file.ok());
    CHECK(io::readProject(file.value()).value() == document);
  }
}

TEST_CASE("a part that is no closed solid is left out of what is shown, and its work is saved") {
  const Document document = twoParts();
  pipeline::Derived derived = derivedOf(document);
  pipeline::PartShape open = *derived.parts[0].shape;
  open.mesh.triangles.pop_back();
  derived.parts[0].shape = std::make_shared<const pipeline::PartShape>(std::move(open));
  CHECK(publish::publish(document, derived, Format::Glb, {}).error() == Error::MeshInvalid);
  const auto file = publish::publish(document, derived, Format::Project, {});
  REQUIRE(file.ok());
  CHECK(io::readProject(file.value()).value() == document);
}

TEST_CASE("a cancelled export gives nothing, and equal models give equal bytes") {
  const Document document = twoParts();
  const pipeline::Derived derived = derivedOf(document);
  const Progress cancelled;
  cancelled.cancel();
  for (const Format format :
       {Format::Glb, Format::Obj, Format::Stl, Format::Project, Format::ObjZip, Format::ThreeMf}) {
    const auto none = publish::publish(document, derived, format, cancelled);
    REQUIRE_FALSE(none.ok());
    CHECK(none.error() == Error::Cancelled);
    CHECK(publish::publish(document, derived, format, {}).value() ==
          publish::publish(document, derived, format, {}).value());
    CHECK(formatFromKey(formatKey(format)) == format);
    CHECK(mediaType(format).find('/') != std::string_view::npos);
  }
  CHECK_FALSE(formatFromKey("fbx").has_value());
}

TEST_CASE("file names carry the model's name and size in portable characters") {
  Document document;
  document.name = "My  Dragon / v2!";
  document.height = {40};
  CHECK(fileName(document, Format::Glb) == "my-dragon-v2-40mm.glb");
  CHECK(fileName(document, Format::Project) == "my-dragon-v2.spineloft");
  document.name = "///";
  document.height = {12.54};
  CHECK(fileName(document, Format::Stl) == "model-12.5mm.stl");
  document.name =
      "K\xc3\xa4"
      "fer";
  CHECK(fileName(document, Format::ObjZip) ==
        "k\xc3\xa4"
        "fer-12.5mm-obj.zip");
  CHECK(fileName(document, Format::ThreeMf) ==
        "k\xc3\xa4"
        "fer-12.5mm.3mf");
  CHECK(fileName(document, Format::Obj) ==
        "k\xc3\xa4"
        "fer-12.5mm.obj");
}
