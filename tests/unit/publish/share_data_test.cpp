// Links of several parts, each traced in a real picture of its own.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "engine/document/update.h"
#include "engine/io/json_values.h"
#include "engine/io/picture_file.h"
#include "engine/pipeline/derive.h"
#include "engine/publish/share_model.h"
#include "tests/support/test_files.h"

using namespace spineloft;
using namespace spineloft::document;
namespace fs = std::filesystem;

namespace {

std::vector<fs::path> realCases() {
  std::vector<fs::path> cases;
  for (const fs::directory_entry& entry : fs::directory_iterator(testing::dataFolder())) {
    if (fs::exists(entry.path() / "case.json")) cases.push_back(entry.path());
  }
  std::ranges::sort(cases);
  return cases;
}

Document withPart(Document document, const fs::path& folder, int ribs) {
  const fs::path png = folder / "image.png";
  auto picture = io::decodePicture(testing::bytesOf(fs::exists(png) ? png : folder / "image.jpg"), Progress());
  REQUIRE(picture.ok());
  const std::vector<std::uint8_t> told = testing::bytesOf(folder / "case.json");
  const auto stroke = io::readStroke({reinterpret_cast<const char*>(told.data()), told.size()}, "careful");
  REQUIRE(stroke.ok());
  auto shown = std::make_shared<const image::Picture>(std::move(picture).value());
  document = update(document, AddPicture{folder.filename().string(), std::move(shown)}).value();
  document = update(document, DrawSpine{document.pictures.back()->id, stroke.value()}).value();
  Part part = document.parts.back().get();
  loftOf(part)->spine.ribs = ribs;
  document.parts.back() = std::move(part);
  return document;
}

}  // namespace

TEST_CASE("seven parts of real pictures are a link of 1,000 characters, twelve of 60 ribs one of 1,900" *
          doctest::test_suite("data")) {
  struct Model {
    std::size_t parts;
    int ribs;
    std::size_t characters;
  };
  const std::vector<fs::path> cases = realCases();
  for (const auto& [parts, ribs, characters] : std::array<Model, 2>{{{7, 40, 1000}, {12, 60, 1900}}}) {
    for (std::size_t from = 0; from + parts <= cases.size(); from += parts) {
      CAPTURE(parts);
      CAPTURE(from);
      Document document;
      for (std::size_t i = 0; i < parts; ++i) document = withPart(std::move(document), cases[from + i], ribs);
      pipeline::Cache cache;
      const auto derived = pipeline::deriveWithEdges(document, cache, {});
      REQUIRE(derived.ok());
      const auto shared = publish::shareModel(document, derived.value());
      REQUIRE(shared.ok());
      CHECK(shared.value().text.size() <= characters);
    }
  }
}
