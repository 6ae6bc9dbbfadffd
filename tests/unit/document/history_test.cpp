#include "engine/document/history.h"

#include <doctest/doctest.h>

#include <string>

#include "engine/document/update.h"
#include "engine/io/project_file.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"
#include "tests/support/sessions.h"

using namespace spineloft;
using namespace spineloft::document;

namespace {

/// A text that costs its length.
struct Text {
  std::string text;
  bool operator==(const Text&) const = default;
};
std::size_t bytesBeyond(const Text&, const Text& next) { return next.text.size(); }

}  // namespace

TEST_CASE("commits of one gesture are one step, and another gesture, undo or redo ends it") {
  History<int> history(0);
  CHECK(history.commit(1, 7) == Committed::Step);
  CHECK(history.commit(2, 7) == Committed::Amended);
  CHECK(history.commit(2, 7) == Committed::Nothing);
  CHECK(history.commit(3, 8) == Committed::Step);
  CHECK(history.commit(4) == Committed::Step);
  CHECK(history.commit(5) == Committed::Step);
  CHECK(history.undoSteps() == 4);
  CHECK(history.undo().ok());
  CHECK(history.undo().ok());
  CHECK(history.present() == 3);
  CHECK(history.commit(9, 8) == Committed::Step);
  CHECK(history.redoSteps() == 0);
  CHECK(history.undo().ok());
  CHECK(history.undo().ok());
  CHECK(history.present() == 2);
  CHECK(history.undo().ok());
  CHECK(history.present() == 0);
}

TEST_CASE("a gesture that comes back to where it began leaves no step") {
  History<int> history(5);
  history.commit(6, 1);
  history.commit(5, 1);
  CHECK(history.undoSteps() == 0);
  CHECK(history.present() == 5);
  CHECK(history.commit(6, 1) == Committed::Step);
}

TEST_CASE("over budget the oldest steps are forgotten, but never the last one") {
  History<Text> history({}, 100);
  for (int i = 0; i < 50; ++i) {
    history.commit({std::string(10, 'a') + std::to_string(i)});
    CHECK(history.bytes() <= 100);
  }
  CHECK(history.undoSteps() == 8);
  CHECK(history.at(0).text.ends_with("41"));
  CHECK(history.at(8) == history.present());
  history.commit({std::string(500, 'x')});
  history.commit({"y"});
  CHECK(history.undoSteps() == 1);
  CHECK(history.undo().ok());
  CHECK(history.present().text.size() == 500);
  CHECK(history.at(1).text == "y");
}

TEST_CASE("the bytes of a history are those of its steps, whichever way one went through it") {
  for (const std::uint64_t seed : testing::seeds(0, 40)) {
    const std::vector<Document> documents = testing::randomSession(seed, 40);
    History<Document> history(documents[0]);
    for (std::size_t i = 1; i < documents.size(); ++i) history.commit(documents[i]);
    std::size_t past = 0;
    for (std::size_t i = 0; i < history.undoSteps(); ++i) {
      past += document::bytesBeyond(history.at(i + 1), history.at(i));
    }
    CHECK(history.bytes() == past);
    while (history.undo().ok()) {
    }
    std::size_t future = 0;
    for (std::size_t i = 1; i <= history.redoSteps(); ++i) {
      future += document::bytesBeyond(history.at(i - 1), history.at(i));
    }
    CHECK(history.bytes() == future);
    while (history.redo().ok()) {
    }
    CHECK(history.bytes() == past);
  }
}

TEST_CASE("a step costs the part it changed, not the document and not its photos") {
  Document document = update({}, AddPicture{"e", testing::ellipsePicture(400, 300)}).value();
  for (int i = 0; i < 8; ++i) {
    document = update(document, DrawSpine{PictureId{1}, {{50, 150}, {200, 150}, {350, 150}}}).value();
  }
  const Document next = update(document, RenamePart{PartId{3}, "Tail"}).value();
  CHECK(document::bytesBeyond(document, next) < 4096);
  const Document without = update(document, RemovePicture{PictureId{1}}).value();
  CHECK(document::bytesBeyond(without, document) > 400 * 300 * 4);
  CHECK(document::bytesBeyond(document, without) < 1024);
}

TEST_CASE("undo all and redo all give the same bytes at every step") {
  for (const std::uint64_t seed : testing::seeds(300, 308)) {
    const std::vector<Document> documents = testing::randomSession(seed, 40);
    History<Document> history(documents[0]);
    std::vector<std::string> texts{io::writeDocument(documents[0])};
    for (std::size_t i = 1; i < documents.size(); ++i) {
      history.commit(documents[i]);
      texts.push_back(io::writeDocument(history.present()));
    }
    for (std::size_t i = texts.size() - 1; i > 0; --i) {
      REQUIRE(io::writeDocument(history.present()) == texts[i]);
      REQUIRE(history.undo().ok());
    }
    for (std::size_t i = 1; i < texts.size(); ++i) {
      REQUIRE(history.redo().ok());
      REQUIRE(io::writeDocument(history.present()) == texts[i]);
    }
  }
}
