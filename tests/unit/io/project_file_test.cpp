#include "engine/io/project_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

#include "engine/base/limits.h"
#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "engine/io/document_json.h"
#include "engine/io/glb_container.h"
#include "engine/io/picture_file.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"
#include "tests/support/sessions.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

/// The document as a file without a model.
Bytes projectOf(const Document& document) {
  std::vector<Bytes> encoded;
  std::vector<ProjectPhoto> photos;
  encoded.reserve(document.pictures.size());
  for (const PictureEntry& entry : document.pictures) {
    if (entry.isSketch()) continue;
    encoded.push_back(writePhoto(*entry.picture).value());
    photos.push_back({entry.picture, encoded.back()});
  }
  const auto bytes = embedProject({}, document, photos);
  REQUIRE(bytes.ok());
  return bytes.value();
}

Document tail() {
  Document document = update({}, AddPicture{"cat", ellipsePicture(48, 36)}).value();
  return update(document, DrawSpine{PictureId{1}, {{10, 18}, {24, 17}, {38, 18}}}).value();
}

/// The file with its JSON changed; sizes are set right again.
template <class Change>
Bytes changed(const Bytes& glb, const Change& change) {
  const GlbChunks chunks = readGlbChunks(glb).value();
  Json root = Json::parse(chunks.json);
  change(root);
  return writeGlbChunks({root.dump(), chunks.binary}).value();
}

std::shared_ptr<const image::Picture> noise(Rng& rng, int width, int height, image::Size original) {
  auto picture = std::make_shared<image::Picture>();
  picture->width = original.width;
  picture->height = original.height;
  picture->working = {width, height, {}};
  for (int i = 0; i < 4 * width * height; ++i) {
    picture->working.pixels.push_back(static_cast<std::uint8_t>(rng.below(256)));
  }
  return picture;
}

}  // namespace

TEST_CASE("a project file gives back the document, its photos pixel by pixel") {
  for (const std::uint64_t seed : testing::seeds(500, 530)) {
    const Document document = randomSession(seed, 60).back();
    const Bytes file = projectOf(document);
    CHECK(file == projectOf(document));
    CHECK(holdsProject(file));
    ReadNotes notes;
    const auto read = readProject(file, &notes);
    REQUIRE(read.ok());
    CHECK(notes.clean());
    REQUIRE(read.value() == document);
    CHECK(writeDocument(read.value()) == writeDocument(document));
    for (std::size_t i = 0; i < document.pictures.size(); ++i) {
      if (document.pictures[i]->isSketch()) continue;
      CHECK(*read.value().pictures[i]->picture == *document.pictures[i]->picture);
    }
  }
}

TEST_CASE("photos keep their original size, their transparent pixels and the smallest of sizes") {
  Rng rng(3);
  Document document;
  for (const auto& [width, height, original] :
       std::vector<std::tuple<int, int, image::Size>>{{20, 30, {200, 300}}, {1, 1, {1, 1}}, {64, 16, {64, 16}}}) {
    document = update(document, AddPicture{"n", noise(rng, width, height, original)}).value();
  }
  const auto read = readProject(projectOf(document));
  REQUIRE(read.ok());
  REQUIRE(read.value() == document);
  for (std::size_t i = 0; i < document.pictures.size(); ++i) {
    CHECK(*read.value().pictures[i]->picture == *document.pictures[i]->picture);
  }
}

TEST_CASE("a photo that the GLB shows as a texture is not stored twice") {
  const Document document = tail();
  const Bytes png = writePhoto(*document.pictures[0]->picture).value();
  const Json root = {{"asset", {{"version", "2.0"}}},
                     {"buffers", {{{"byteLength", png.size()}}}},
                     {"bufferViews", {{{"buffer", 0}, {"byteLength", png.size()}}}},
                     {"images", {{{"bufferView", 0}, {"mimeType", "image/png"}}}}};
  const Bytes glb = writeGlbChunks({root.dump(), png}).value();
  const ProjectPhoto photo{document.pictures[0]->picture, png};
  const auto file = embedProject(glb, document, {&photo, 1});
  REQUIRE(file.ok());
  const GlbChunks chunks = readGlbChunks(file.value()).value();
  CHECK(chunks.binary.size() <= png.size() + 3);
  CHECK(readProject(file.value()).value() == document);
  CHECK(embedProject(glb, document, {}).error() == Error::NoSuchPicture);
  CHECK(embedProject(png, document, {&photo, 1}).error() == Error::ProjectInvalid);
}

TEST_CASE("a GLB of another program, a later project and other files are told apart") {
  const Bytes file = projectOf(tail());
  const Bytes foreign = changed(file, [](Json& root) {
    root.erase("extensions");
    root.erase("extensionsUsed");
  });
  CHECK_FALSE(holdsProject(foreign));
  CHECK(readProject(foreign).error() == Error::NoProjectInside);
  const Bytes mentioned = changed(file, [](Json& root) { root.erase("extensions"); });
  CHECK(readProject(mentioned).error() == Error::NoProjectInside);
  CHECK(readProject({}).error() == Error::NoProjectInside);
  CHECK(readProject(writePhoto(*ellipsePicture(20, 20)).value()).error() == Error::NoProjectInside);
  const auto project = [](Json& root) -> Json& { return root["extensions"]["SPINELOFT_project"]; };
  CHECK(readProject(changed(file, [&](Json& root) { project(root)["version"] = 99; })).error() == Error::ProjectTooNew);
  CHECK(readProject(changed(file, [&](Json& root) { project(root)["document"]["version"] = 99; })).error() ==
        Error::ProjectTooNew);
  CHECK(readProject(changed(file, [&](Json& root) { project(root).erase("document"); })).error() ==
        Error::ProjectInvalid);
}

TEST_CASE("a picture that cannot be read goes with its parts; without any the file is refused") {
  Document document = tail();
  const Bytes alone = projectOf(document);
  document = update(document, AddPicture{"dog", ellipsePicture(50, 40, 3)}).value();
  document = update(document, DrawSpine{PictureId{2}, {{10, 20}, {40, 20}}}).value();
  const auto photos = [](Json& root) -> Json& { return root["extensions"]["SPINELOFT_project"]["photos"]; };
  for (const Json& view : {Json(77), Json(-1), Json("0"), Json(), Json(1e300), Json(0.5)}) {
    const auto lose = [&](Json& root) { photos(root)[0]["bufferView"] = view; };
    ReadNotes notes;
    const auto read = readProject(changed(projectOf(document), lose), &notes);
    REQUIRE(read.ok());
    CHECK(read.value().pictures.size() == 1);
    CHECK(read.value().parts.size() == 1);
    CHECK(read.value().parts[0] == document.parts[1]);
    CHECK(notes.dropped == 2);
    CHECK(readProject(changed(alone, lose)).error() == Error::PictureUnreadable);
  }
  // Views that reach beyond the binary chunk, also by overflow.
  for (const char* key : {"byteOffset", "byteLength"}) {
    for (const double value : {1e6, 4294967295.0, 1.8446744073709552e19}) {
      const Bytes bad = changed(alone, [&](Json& root) { root["bufferViews"][0][key] = value; });
      CHECK(readProject(bad).error() == Error::PictureUnreadable);
    }
  }
}

TEST_CASE("a photo whose pixels are not the named ones is kept under its own name") {
  const Document document = tail();
  const Bytes file = changed(projectOf(document), [](Json& root) {
    Json& project = root["extensions"]["SPINELOFT_project"];
    project["photos"][0]["hash"] = "0123456789abcdef";
    project["document"]["pictures"][0]["photo"] = "0123456789abcdef";
  });
  ReadNotes notes;
  const auto read = readProject(file, &notes);
  REQUIRE(read.ok());
  CHECK(read.value() == document);
  CHECK(notes.repaired == 1);
}

TEST_CASE("a picture that claims more pixels than a document may hold is not decoded") {
  const Document document = tail();
  image::Image large{2500, 1700, {}};
  large.pixels.assign(std::size_t{4} * 2500 * 1700, 0);
  REQUIRE(2500LL * 1700 > kWorkingPixels);
  const Bytes png = encodePng(large).value();
  const ProjectPhoto photo{document.pictures[0]->picture, png};
  CHECK(readProject(embedProject({}, document, {&photo, 1}).value()).error() == Error::PictureUnreadable);
}

TEST_CASE("a file cut anywhere is refused and nothing breaks") {
  const Bytes file = projectOf(tail());
  REQUIRE(readProject(file).ok());
  for (std::size_t length = 0; length < file.size(); ++length) {
    const auto read = readProject(std::span(file).first(length));
    REQUIRE_FALSE(read.ok());
    // Four bytes say that it is a GLB; what is less says nothing.
    REQUIRE(read.error() == (length < 4 ? Error::NoProjectInside : Error::ProjectInvalid));
  }
  Bytes longer = file;
  longer.push_back(7);
  CHECK(readProject(longer).value() == tail());
}

TEST_CASE("thousands of flipped bits give a sound document or a reason, and its file opens again") {
  const Document document = tail();
  const Bytes file = projectOf(document);
  Rng rng(2024);
  int opened = 0, refused = 0;
  for (int round = 0; round < testing::rounds(4000); ++round) {
    Bytes bad = file;
    for (std::uint32_t flips = 1 + rng.below(3); flips > 0; --flips) {
      bad[rng.below(static_cast<std::uint32_t>(bad.size()))] ^= static_cast<std::uint8_t>(1 << rng.below(8));
    }
    const auto read = readProject(bad);
    if (!read) {
      ++refused;
      continue;
    }
    ++opened;
    if (round % 10 == 0) REQUIRE(readProject(projectOf(read.value())).value() == read.value());
  }
  CHECK(opened > 400);
  CHECK(refused > 400);
}

TEST_CASE("keys that nobody knows survive the project file too") {
  const Document document = tail();
  const Bytes file = changed(projectOf(document), [](Json& root) {
    Json& json = root["extensions"]["SPINELOFT_project"]["document"];
    json["parts"][0]["bones"] = {1, 2, 3};
    json["sky"] = "blue";
  });
  const Document read = readProject(file).value();
  const Json json = Json::parse(writeDocument(readProject(projectOf(read)).value()));
  CHECK(json["parts"][0]["bones"] == Json{1, 2, 3});
  CHECK(json["sky"] == "blue");
}
