#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "engine/io/picture_file.h"
#include "engine/io/png_model.h"
#include "engine/io/project_file.h"
#include "tests/support/random_documents.h"

using namespace spineloft;
using namespace spineloft::io;
using spineloft::testing::ellipsePicture;

namespace {

document::Document onPaper() {
  document::Document document = document::update({}, document::AddSketch{"Sketch 1", {400, 300}}).value();
  return document::update(document, document::DrawSpine{PictureId{1}, {{100, 150}, {200, 150}, {300, 150}}}).value();
}

Bytes picture() { return encodePng(ellipsePicture(60, 40)->working).value(); }
Bytes project() { return embedProject({}, onPaper(), {}).value(); }
Bytes both() { return withModel(picture(), project()).value(); }

}  // namespace

TEST_CASE("a PNG with a model inside shows the same picture and opens as the model") {
  const Bytes file = both();
  CHECK(decodeImage(file, 100'000).value() == decodeImage(picture(), 100'000).value());
  CHECK(readProject(file).value() == onPaper());
  CHECK(std::ranges::equal(modelInPng(file).value(), project()));
  // A second model takes the place of the first.
  const Bytes other = {1, 2, 3};
  const Bytes again = withModel(file, other).value();
  CHECK(std::ranges::equal(modelInPng(again).value(), other));
  CHECK(again.size() == file.size() - project().size() + other.size());
}

TEST_CASE("a picture whose model was taken out, changed or cut off says which of these") {
  CHECK(readProject(picture()).error() == Error::NoProjectInside);
  const Bytes file = both();
  const std::size_t from = static_cast<std::size_t>(modelInPng(file).value().data() - file.data());
  const std::size_t to = from + project().size();
  Rng rng(11);
  for (int i = 0; i < 200; ++i) {
    Bytes changed = file;
    changed[from + rng.below(static_cast<std::uint32_t>(to - from + 4))] ^=
        static_cast<std::uint8_t>(1 + rng.below(255));
    CHECK(readProject(changed).error() == Error::ProjectInvalid);
  }
  for (std::size_t length = 0; length < to + 4; ++length) {
    const Error error = readProject(std::span(file).first(length)).error();
    CHECK(error == (length < from ? Error::NoProjectInside : Error::ProjectInvalid));
  }
  CHECK(readProject(std::span(file).first(to + 4)).value() == onPaper());
}

TEST_CASE("a PNG in a PNG is no model, and what is no PNG takes none") {
  const Bytes nested = withModel(picture(), both()).value();
  CHECK(readProject(nested).error() == Error::ProjectInvalid);
  CHECK(withModel(project(), project()).error() == Error::PictureUnreadable);
  const Bytes whole = picture();
  CHECK(withModel(std::span(whole).first(40), project()).error() == Error::PictureTruncated);
}

TEST_CASE("a PNG with any bits flipped gives a model, a picture without one, or a reason") {
  const Bytes file = both();
  Rng rng(12);
  for (int i = 0; i < 10000; ++i) {
    Bytes changed = file;
    for (std::uint32_t n = rng.below(3) + 1; n > 0; --n)
      changed[rng.below(static_cast<std::uint32_t>(changed.size()))] ^= static_cast<std::uint8_t>(1 << rng.below(8));
    const auto read = readProject(changed);
    if (read.ok()) CHECK(read.value() == onPaper());
  }
}
