#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "engine/io/picture_file.h"
#include "engine/io/share_text.h"
#include "tests/support/complete_document.h"
#include "tests/support/photo_copies.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"
#include "tests/support/sessions.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

std::string textOf(const Document& document) {
  const auto text = writeShareText(document);
  REQUIRE(text.ok());
  return text.value();
}

/// Paper with one drawn line and a part on it.
Document onPaper(image::Size size, const std::vector<PicturePoint>& line) {
  Document document = update({}, AddSketch{"Sketch 1", size}).value();
  document = update(document, DrawOnSketch{PictureId{1}, {.points = line, .pressure = {}}}).value();
  return update(document, DrawSpine{PictureId{1}, line}).value();
}

std::vector<PicturePoint> wave(image::Size size, int points) {
  std::vector<PicturePoint> line;
  for (int i = 0; i < points; ++i) {
    const double t = i / (points - 1.0);
    line.push_back({size.width * (0.1 + 0.8 * t), size.height * (0.5 + 0.3 * std::sin(6 * t))});
  }
  return line;
}

double farthestFromLine(const std::vector<PicturePoint>& points, const std::vector<PicturePoint>& line) {
  double most = 0;
  for (const PicturePoint p : points) {
    double least = 1e9;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const PicturePoint along = line[i] - line[i - 1];
      const double t = std::clamp(dot(p - line[i - 1], along) / dot(along, along), 0.0, 1.0);
      least = std::min(least, distance(p, line[i - 1] + along * t));
    }
    most = std::max(most, least);
  }
  return most;
}

}  // namespace

TEST_CASE("every document comes back from its text as what the text keeps of it, and gives the same text again") {
  int parts = 0;
  for (const std::uint64_t seed : seeds(0, 30)) {
    const Document document = randomSession(seed, 40).back();
    const std::string text = textOf(document);
    ReadNotes notes;
    const auto read = readShareText(text, &notes);
    REQUIRE_MESSAGE(read.ok(), seed);
    CHECK_MESSAGE(notes.clean(), seed);
    CHECK_MESSAGE(read.value() == shareable(document), seed);
    CHECK_MESSAGE((textOf(read.value()) == text), seed);
    REQUIRE(read.value().parts.size() == document.parts.size());
    CHECK(read.value().steps.size() == document.steps.size());
    parts += static_cast<int>(document.parts.size());
  }
  CHECK(parts > 30);
  const Document complete = completeDocument();
  CHECK(readShareText(textOf(complete)).value() == shareable(complete));
}

TEST_CASE(
    "no place on a picture of up to 1024 pixels is off by more than a quarter of a pixel, on larger ones in "
    "proportion") {
  for (const int side : {300, 1024, 2000}) {
    const image::Size size{side, side * 3 / 4};
    const std::vector<PicturePoint> line = wave(size, 400);
    const Document read = readShareText(textOf(onPaper(size, line))).value();
    const double most = 0.25 * std::max(1.0, side / 1024.0);
    // Both lines in a bit more than half a character a point.
    CHECK(textOf(onPaper(size, line)).size() < 500);
    for (const std::vector<PicturePoint>& kept :
         {read.pictures[0]->sketch[0]->points, loftOf(read.parts[0].get())->stroke}) {
      CHECK(farthestFromLine(line, kept) <= most);
      CHECK(farthestFromLine(kept, line) <= most);
    }
  }
}

TEST_CASE("a document of more ribs than a text has curves for comes back too, and gives the same text again" *
          doctest::test_suite("slow")) {
  Document document = update({}, AddSketch{"Sketch 1", {1000, 700}}).value();
  for (int i = 0; i < 52; ++i) {
    document = update(document, DrawSpine{PictureId{1}, wave({1000, 700}, 60)}).value();
    Part part = document.parts.back().get();
    loftOf(part)->spine = {.ribs = 400, .minSpacing = 0.1};
    loftOf(part)->edits.ends = {{.at = 0.5, .along = 3.3, .out = 70.2}, {.at = 1, .along = -4.6, .out = 33.3}};
    document.parts.back() = part;
  }
  const Document read = readShareText(textOf(document)).value();
  CHECK(read == shareable(document));
  CHECK((textOf(read) == textOf(document)));
  for (const Box<Part>& part : read.parts) {
    for (const ribs::EndEdit& end : loftOf(part.get())->edits.ends) {
      CHECK(std::abs(end.along - (end.at < 1 ? 3.3 : -4.6)) <= 0.25);
      CHECK(std::abs(end.out - (end.at < 1 ? 70.2 : 33.3)) <= 0.25);
    }
  }
}

TEST_CASE("a text that is cut off anywhere says how many characters are missing") {
  const std::string text = textOf(onPaper({640, 480}, wave({640, 480}, 60)));
  for (std::size_t length = 0; length < text.size(); ++length) {
    const auto read = readShareText(std::string_view(text).substr(0, length));
    REQUIRE_FALSE(read.ok());
    if (length < 2) {
      CHECK(read.error() == Error::LinkForeign);
      continue;
    }
    REQUIRE(read.error() == Error::LinkCut);
    if (length > 3) CHECK(read.failure().detail == std::to_string(text.size() - length) + " characters are missing");
  }
}

TEST_CASE("a text with wrong characters is refused, whichever they are") {
  const std::string text = textOf(onPaper({640, 480}, wave({640, 480}, 60)));
  Rng rng(7);
  for (int i = 0; i < 10000; ++i) {
    std::string wrong = text;
    for (std::uint32_t n = rng.below(3) + 1; n > 0; --n) {
      char& c = wrong[rng.below(static_cast<std::uint32_t>(wrong.size()))];
      c = static_cast<char>(c ^ (1 << rng.below(8)));
    }
    const auto read = readShareText(wrong);
    if (wrong == text) continue;
    REQUIRE_FALSE(read.ok());
    const Error error = read.error();
    CHECK((error == Error::LinkAltered || error == Error::LinkForeign || error == Error::LinkCut ||
           error == Error::ProjectTooNew));
  }
  CHECK(readShareText(text + "A").error() == Error::LinkAltered);
}

TEST_CASE("foreign, future and endless texts are told apart") {
  CHECK(readShareText("https://example.org").error() == Error::LinkForeign);
  CHECK(readShareText("").error() == Error::LinkForeign);
  CHECK(readShareText(std::to_string(kShareVersion + 1) + "abcdef").error() == Error::ProjectTooNew);
  CHECK(readShareText("1" + std::string(kMostShareText, 'A')).error() == Error::OutOfMemory);
}

TEST_CASE("a photo comes back as a white picture of its size, with the parts that were on it") {
  Document document = update({}, AddPicture{"cat", ellipsePicture(96, 72)}).value();
  document = update(document, DrawSpine{PictureId{1}, {{20, 30}, {48, 36}, {76, 30}}}).value();
  const Document read = readShareText(textOf(document)).value();
  REQUIRE(read.pictures.size() == 1);
  const PictureEntry& blank = read.pictures[0].get();
  CHECK_FALSE(blank.isSketch());
  CHECK(blank.size == image::Size{96, 72});
  CHECK(std::ranges::all_of(blank.picture->working.pixels, [](std::uint8_t v) { return v == 255; }));
  REQUIRE(read.parts.size() == 1);
  CHECK(pictureOf(read.parts[0].get()) == blank.id);
}

TEST_CASE(
    "a text may carry small copies of photos: they come back byte for byte, and only small WebP and JPEG files do") {
  Document document = update({}, AddPicture{"cat", ellipsePicture(1000, 700)}).value();
  document = update(document, AddPicture{"dog", ellipsePicture(96, 72)}).value();
  const auto carried = [&](const PhotoCopies& copies) {
    const auto text = writeShareText(document, copies);
    REQUIRE(text.ok());
    const auto read = photosInShareText(text.value());
    REQUIRE(read.ok());
    CHECK(readShareText(text.value()).ok());
    return read.value();
  };
  const PhotoCopies both = {{PictureId{1}, jpegCopy(512, 358)}, {PictureId{2}, jpegCopy(96, 72)}};
  CHECK(carried(both) == both);
  CHECK(carried({}).empty());
  // 10 × 20 by its header, which is all that is looked at; the second is as large as a browser decodes.
  const auto webp = [](int width, int height) {
    std::string file = "RIFF????WEBPVP8X";
    file += std::string("\x0a\0\0\0\0\0\0\0", 8);
    for (const int side : {width - 1, height - 1}) {
      for (int shift = 0; shift < 24; shift += 8) file += static_cast<char>(side >> shift & 255);
    }
    file.resize(64);
    return base64url(Bytes(file.begin(), file.end()));
  };
  CHECK(carried({{PictureId{1}, webp(10, 20)}}).size() == 1);
  const image::Image small = ellipsePicture(40, 30)->working;
  for (const std::string& other : {webp(16383, 16383), jpegCopy(513, 300), base64url(encodePng(small).value()),
                                   std::string("no base64 !"), std::string(), std::string("AAAA")}) {
    CHECK_MESSAGE(carried({{PictureId{1}, other}}).empty(), other.substr(0, 20));
  }
  CHECK(photosInShareText("hello").error() == Error::LinkForeign);
  const std::string text = writeShareText(document, both).value();
  CHECK(photosInShareText(std::string_view(text).substr(0, text.size() - 9)).error() == Error::LinkCut);
}

TEST_CASE(
    "a picture shows the photo that was made of its copy, if it has its shape; without one its parts have one colour") {
  Document document = update({}, AddPicture{"cat", ellipsePicture(1000, 700)}).value();
  document = update(document, DrawSpine{PictureId{1}, {{200, 350}, {500, 360}, {800, 350}}}).value();
  const std::string text = writeShareText(document, {{PictureId{1}, jpegCopy(512, 358)}}).value();
  const auto photoOf = [&](int width, int height) {
    return readShareText(text, nullptr, {{PictureId{1}, ellipsePicture(width, height)}}).value();
  };
  const Document with = photoOf(512, 358);
  CHECK(with.pictures[0]->size == image::Size{1000, 700});
  CHECK(with.pictures[0]->picture->width == 1000);
  CHECK(with.pictures[0]->picture->working == ellipsePicture(512, 358)->working);
  CHECK(with.parts[0]->look.textured);
  for (const Document& without : {readShareText(text).value(), photoOf(358, 512)}) {
    CHECK(without.pictures[0]->size == image::Size{1000, 700});
    CHECK_FALSE(without.parts[0]->look.textured);
    CHECK(std::ranges::all_of(without.pictures[0]->picture->working.pixels, [](std::uint8_t v) { return v == 255; }));
  }
}
