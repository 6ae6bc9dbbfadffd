#include "engine/io/journal.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"
#include "tests/support/sessions.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

/// Same present, same undo and redo, down to the byte.
void requireSame(const DocumentHistory& a, const DocumentHistory& b) {
  REQUIRE(a.undoSteps() == b.undoSteps());
  REQUIRE(a.redoSteps() == b.redoSteps());
  for (std::size_t i = 0; i <= a.undoSteps() + a.redoSteps(); ++i) {
    REQUIRE(a.at(i) == b.at(i));
    REQUIRE(writeDocument(a.at(i)) == writeDocument(b.at(i)));
  }
}

/// A history that wanders back and forth through a session, with the record of every move.
struct Wandering {
  DocumentHistory history;
  std::vector<std::string> records;
  std::vector<DocumentHistory> after;  ///< the history after each record
  std::vector<Document> documents;

  explicit Wandering(std::uint64_t seed, int steps = 40) {
    Rng rng(seed * 31 + 7);
    documents.push_back(history.present());
    for (int step = 0; step < steps; ++step) {
      const std::uint32_t move = rng.below(8);
      if (move == 0 && history.undo().ok()) {
        keep(undoRecord());
      } else if (move == 1 && history.redo().ok()) {
        keep(redoRecord());
      } else {
        act(rng);
      }
    }
  }

 private:
  void act(Rng& rng) {
    const Document before = history.present();
    const Result<Document> next = update(before, randomAction(rng, before));
    if (!next) return;
    const Gesture gesture = rng.below(3) == 0 ? 5 : 0;
    documents.push_back(next.value());
    switch (history.commit(next.value(), gesture)) {
      case Committed::Nothing:
        return;
      case Committed::Step:
        return keep(commitRecord(before, history.present()));
      case Committed::Amended:
        return keep(amendRecord(before, history.present()));
    }
  }
  void keep(std::string record) {
    records.push_back(std::move(record));
    after.push_back(history);
  }
};

}  // namespace

TEST_CASE("a journal played back gives the same documents, undo and redo after every record") {
  for (const std::uint64_t seed : testing::seeds(0, 16)) {
    const Wandering session(seed);
    const auto photos = photosOfAll(session.documents);
    const std::string base = writeHistory(DocumentHistory());
    for (std::size_t count = 0; count < session.records.size(); count += 1 + seed % 3) {
      const auto read = readHistory(base, std::span(session.records).first(count + 1), photos);
      REQUIRE(read.ok());
      CHECK(read.value().dropped == 0);
      requireSame(read.value().history, session.after[count]);
    }
  }
}

TEST_CASE("a history written anew at any moment is the same history, and records go on from it") {
  for (const std::uint64_t seed : testing::seeds(100, 120)) {
    const Wandering session(seed);
    if (session.records.size() < 2) continue;
    const auto photos = photosOfAll(session.documents);
    const std::size_t cut = seed % session.records.size();
    const std::string base = writeHistory(session.after[cut]);
    const auto whole = readHistory(base, {}, photos);
    REQUIRE(whole.ok());
    requireSame(whole.value().history, session.after[cut]);
    CHECK(writeHistory(whole.value().history) == base);
    const auto rest = readHistory(base, std::span(session.records).subspan(cut + 1), photos);
    REQUIRE(rest.ok());
    CHECK(rest.value().dropped == 0);
    requireSame(rest.value().history, session.history);
  }
}

TEST_CASE("a damaged record ends the play with everything before it") {
  for (const std::uint64_t seed : testing::seeds(200, 230)) {
    const Wandering session(seed);
    if (session.records.empty()) continue;
    const auto photos = photosOfAll(session.documents);
    const std::string base = writeHistory(DocumentHistory());
    Rng rng(seed);
    const std::size_t bad = rng.below(static_cast<std::uint32_t>(session.records.size()));
    std::vector<std::string> records = session.records;
    std::string& record = records[bad];
    if (rng.below(2) == 0) {
      record.resize(rng.below(static_cast<std::uint32_t>(record.size())));
    } else {
      char& c = record[rng.below(static_cast<std::uint32_t>(record.size()))];
      c = static_cast<char>(c ^ (1 << rng.below(8)));
    }
    const auto read = readHistory(base, records, photos);
    REQUIRE(read.ok());
    CHECK(read.value().dropped == records.size() - bad);
    requireSame(read.value().history, bad == 0 ? DocumentHistory() : session.after[bad - 1]);
  }
}

TEST_CASE("records that do not belong to a history end its play without harm") {
  const Wandering one(301), other(302);
  std::vector<Document> all = one.documents;
  all.insert(all.end(), other.documents.begin(), other.documents.end());
  const auto photos = photosOfAll(all);
  for (std::size_t i = 0; i < other.records.size(); ++i) {
    const auto read = readHistory(writeHistory(one.history), std::span(other.records).subspan(i, 1), photos);
    REQUIRE(read.ok());
    for (const Part& part : read.value().history.present().parts) {
      CHECK(findPicture(read.value().history.present(), document::pictureOf(part)) != nullptr);
    }
  }
}

TEST_CASE("a damaged step in the base shortens undo and redo and leaves the present as it is") {
  int shortened = 0;
  for (const std::uint64_t seed : testing::seeds(400, 440)) {
    const Wandering session(seed);
    const auto photos = photosOfAll(session.documents);
    std::string base = writeHistory(session.history);
    const std::size_t steps = base.find("\"past\":");
    if (steps == std::string::npos) continue;
    // The keys of the elements inside the steps, so that the JSON stays JSON.
    const std::size_t at = base.find("\"of\":", steps);
    if (at == std::string::npos) continue;
    base[at + 1] = 'x';
    const auto read = readHistory(base, {}, photos);
    REQUIRE(read.ok());
    CHECK(read.value().history.present() == session.history.present());
    CHECK(read.value().history.undoSteps() <= session.history.undoSteps());
    shortened += read.value().history.undoSteps() < session.history.undoSteps();
  }
  CHECK(shortened > 5);
}

TEST_CASE("a base without its photo, of a later version, or of anything else is refused with a reason") {
  Document document = update({}, AddPicture{"cat", ellipsePicture(96, 72)}).value();
  const DocumentHistory history(document);
  const std::string base = writeHistory(history);
  const PictureSource none = [](std::uint64_t) { return nullptr; };
  CHECK(readHistory(base, {}, none).error() == Error::NoSuchPicture);
  CHECK(readHistory(base, {}, {}).error() == Error::NoSuchPicture);
  CHECK(readHistory("", {}, none).error() == Error::ProjectInvalid);
  CHECK(readHistory("{}", {}, none).error() == Error::ProjectInvalid);
  CHECK(readHistory("[1,2", {}, none).error() == Error::ProjectInvalid);
  std::string later = base;
  const std::string version = "\"version\":" + std::to_string(kProjectVersion);
  later.replace(later.find(version), version.size(), "\"version\":9999");
  CHECK(readHistory(later, {}, none).error() == Error::ProjectTooNew);
}

TEST_CASE("a record whose photo is not there ends the play") {
  const Document empty;
  const Document one = update(empty, AddPicture{"a", ellipsePicture(96, 72)}).value();
  const std::vector<std::string> records = {commitRecord(empty, one)};
  const auto read = readHistory(writeHistory(DocumentHistory()), records, [](std::uint64_t) { return nullptr; });
  REQUIRE(read.ok());
  CHECK(read.value().dropped == 1);
  CHECK(read.value().history.present() == empty);
}

TEST_CASE("the photos of a history are those of any of its documents, each once") {
  DocumentHistory history;
  const auto cat = ellipsePicture(96, 72), dog = ellipsePicture(96, 72, 1);
  for (const Action& action :
       std::vector<Action>{AddPicture{"cat", cat}, AddPicture{"dog", dog}, AddSketch{"paper", {100, 100}},
                           RemovePicture{PictureId{1}}, AddPicture{"dog again", dog}}) {
    history.commit(update(history.present(), action).value());
  }
  CHECK(photosOf(history) == std::vector{contentHash(*cat), contentHash(*dog)});
  REQUIRE(history.undo().ok());
  CHECK(photosOf(history) == std::vector{contentHash(*cat), contentHash(*dog)});
}

TEST_CASE("a record holds what changed, not the document") {
  Document document = update({}, AddPicture{"cat", ellipsePicture(96, 72)}).value();
  Rng rng(1);
  for (int i = 0; i < 8; ++i) {
    DrawSpine draw;
    draw.picture = PictureId{1};
    draw.stroke = randomStroke(rng, 96, 72);
    document = update(document, draw).value();
  }
  const std::size_t whole = writeDocument(document).size();
  const auto bytes = [&](const Action& action) {
    return commitRecord(document, update(document, action).value()).size();
  };
  CHECK(bytes(RenamePart{PartId{3}, "Tail"}) < 100);
  CHECK(bytes(SetHeight{{40}}) < 100);
  CHECK(bytes(DeletePart{PartId{5}}) < 100);
  CHECK(bytes(SetCaps{PartId{2}, sections::CapStyle::Flat, sections::CapStyle::Flat}) < 200);
  EditRibs edit;
  edit.part = PartId{1};
  edit.edits.ends.assign(200, ribs::EndEdit{0.5, ribs::Side::Left, 1, 20, 0.1, false});
  document = update(document, edit).value();
  edit.edits.ends.push_back({0.25, ribs::Side::Right, 0.123456789, 17.25, 0.05, true});
  CHECK(bytes(edit) < 250);
  CHECK(whole > 2000);
}
