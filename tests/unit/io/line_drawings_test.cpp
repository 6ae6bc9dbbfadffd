// Line drawings in files, links and the journal.
#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/document/checks.h"
#include "engine/io/document_json.h"
#include "engine/io/journal.h"
#include "engine/io/share_text.h"
#include "engine/pipeline/derive.h"
#include "tests/support/after.h"
#include "tests/support/line_creature.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

const PictureSource kNoPhotos = [](std::uint64_t) { return nullptr; };

std::vector<Action> gestures() {
  std::vector<Action> actions{AddSketch{"paper", {1000, 800}}};
  for (const Action& action : creature(PictureId{1})) actions.push_back(action);
  actions.push_back(OrderPieces{PartId{2}, PartId{1}, {395, 530}});
  actions.push_back(PinDepth{DrawingId{1}, LineId{6}, 0.25, 20.0});
  actions.push_back(ShapePiece{PartId{4}, descriptive::PieceKind::Flat});
  return actions;
}

/// Reads the document after a change of its JSON.
template <class Change>
Document mended(const Document& document, const Change& change, ReadNotes& notes) {
  Json json = Json::parse(writeDocument(document));
  change(json);
  const auto read = readDocument(json.dump(), kNoPhotos, &notes);
  REQUIRE(read.ok());
  for (const Drawing& drawing : read.value().drawings) CHECK(checkDrawing(read.value(), drawing).ok());
  for (const Part& part : read.value().parts) CHECK(checkElement(read.value(), *elementOf(part)).ok());
  return read.value();
}

}  // namespace

TEST_CASE("a link holds a line drawing in some hundred characters, and its pieces are lawful solids again") {
  const Document document = after({}, gestures());
  const auto text = writeShareText(document);
  REQUIRE(text.ok());
  CHECK(text.value().size() < 900);
  ReadNotes notes;
  const auto read = readShareText(text.value(), &notes);
  REQUIRE(read.ok());
  CHECK(notes.clean());
  CHECK(read.value() == shareable(document));
  CHECK(writeShareText(read.value()).value() == text.value());
  pipeline::Cache cache;
  const pipeline::Derived before = derive(document, cache), now = derive(read.value(), cache);
  REQUIRE(now.parts.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    REQUIRE(now.parts[i].shape);
    requireLawful(now.parts[i].shape->mesh);
  }
  // Who is in front of whom is as it was.
  const auto &was = before.drawings[0].shape->model.orders.orders, &is = now.drawings[0].shape->model.orders.orders;
  REQUIRE(was.size() == is.size());
  for (std::size_t k = 0; k < was.size(); ++k) CHECK(was[k] == is[k]);
}

TEST_CASE("the journal plays every gesture of a line drawing back, undone and redone, to the byte") {
  DocumentHistory history;
  const std::string base = writeHistory(history);
  std::vector<std::string> records;
  for (const Action& action : gestures()) {
    const Document before = history.present();
    history.commit(update(before, action).value());
    records.push_back(commitRecord(before, history.present()));
  }
  const std::string last = writeDocument(history.present());
  for (std::size_t i = 0; i < records.size() / 2; ++i) {
    REQUIRE(history.undo().ok());
    records.push_back(undoRecord());
  }
  const std::string middle = writeDocument(history.present());
  const auto half = readHistory(base, records, kNoPhotos);
  REQUIRE(half.ok());
  CHECK(half.value().dropped == 0);
  CHECK(writeDocument(half.value().history.present()) == middle);
  while (history.redo().ok()) records.push_back(redoRecord());
  auto whole = readHistory(base, records, kNoPhotos);
  REQUIRE(whole.ok());
  CHECK(whole.value().dropped == 0);
  CHECK(writeDocument(whole.value().history.present()) == last);
  while (whole.value().history.undo().ok()) continue;
  CHECK(writeDocument(whole.value().history.present()) == writeDocument(Document{}));
  // A whole history is the same again.
  const auto again = readHistory(writeHistory(history), {}, kNoPhotos);
  REQUIRE(again.ok());
  CHECK(writeHistory(again.value().history) == writeHistory(history));
}

TEST_CASE("what is wrong in a file goes, and the rest of the drawing stays") {
  const Document document = after({}, gestures());
  ReadNotes notes;
  CHECK(mended(document, [](Json&) {}, notes) == document);
  CHECK(notes.clean());
  const auto drawing = [](Json& json) -> Json& { return json["drawings"][0]; };
  // A line without length, twice the same id, stretches out of order: with the pieces that have such a line.
  Document read = mended(document, [&](Json& j) { drawing(j)["lines"][5]["points"] = {1, 1, 1, 1}; }, notes);
  CHECK(read.parts.size() == 3);
  CHECK(read.drawings[0]->lines.size() == 5);
  CHECK(read.drawings[0]->pins.empty());
  CHECK_FALSE(notes.clean());
  read = mended(document, [&](Json& j) { drawing(j)["lines"][1]["id"] = 1; }, notes);
  CHECK(read.drawings[0]->lines.size() == 5);
  read = mended(document, [&](Json& j) { drawing(j)["lines"][2]["hidden"] = {{0.5, 0.25}}; }, notes);
  CHECK(read.drawings[0]->lines.size() == 5);
  read = mended(document, [&](Json& j) { drawing(j)["orders"][0]["under"] = 77; }, notes);
  CHECK(read.drawings[0]->orders.empty());
  CHECK(read.parts.size() == 4);
  read = mended(document, [&](Json& j) { drawing(j)["picture"] = 9; }, notes);
  CHECK(read.drawings.empty());
  CHECK(read.parts.empty());
  read = mended(document, [&](Json& j) { j["parts"][0]["recipe"]["drawing"] = 9; }, notes);
  CHECK(read.parts.size() == 3);
  read = mended(document, [&](Json& j) { j["parts"][0]["recipe"]["outlines"] = Json::array(); }, notes);
  CHECK(read.parts.size() == 3);
  read = mended(document, [&](Json& j) { j["parts"][0]["recipe"]["front"] = 99; }, notes);
  CHECK(elementOf(*read.parts[0])->front == 1);
  read = mended(document, [&](Json& j) { drawing(j)["lastLineId"] = 2; }, notes);
  CHECK(read.drawings[0]->lastLineId == 6);
  read = mended(document, [&](Json& j) { drawing(j).erase("lines"); }, notes);
  CHECK(read.drawings.empty());
}
