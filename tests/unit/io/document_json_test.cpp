#include <doctest/doctest.h>

#include <algorithm>

#include <cmath>
#include <limits>
#include <string>

#include "engine/base/rng.h"
#include "engine/document/checks.h"
#include "engine/document/params.h"
#include "engine/document/renumber.h"
#include "engine/document/update.h"
#include "engine/io/document_json.h"
#include "engine/io/project_file.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"
#include "tests/support/sessions.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::io;
using namespace spineloft::testing;

namespace {

const PictureSource kNoPhotos = [](std::uint64_t) { return nullptr; };

Document readBack(const Document& document, const std::string& text, ReadNotes* notes = nullptr) {
  const auto read = readDocument(text, photosOfAll({document}), notes);
  REQUIRE_MESSAGE(read.ok(), failureSentence(read.failure()));
  return read.value();
}

Document twoParts() {
  Document document = update({}, AddPicture{"cat", ellipsePicture(96, 72)}).value();
  for (const double y : {30.0, 40.0}) {
    document = update(document, DrawSpine{PictureId{1}, {{20, y}, {48, 36}, {76, y}}}).value();
  }
  return document;
}

/// The document's JSON after `change`, read again.
template <class Change>
Document mended(const Document& document, const Change& change, ReadNotes& notes) {
  Json json = Json::parse(writeDocument(document));
  change(json);
  return readBack(document, json.dump(), &notes);
}

/// Whether every part and picture passes the checks that `update` makes.
bool couldBeMade(const Document& document) {
  for (const PictureEntry& entry : document.pictures) {
    if (!document::isValid(entry.ignored) || entry.id.value == 0 || entry.id.value > document.lastPictureId) {
      return false;
    }
    if (tidyName(entry.name, "x") != entry.name) return false;
    if (entry.view && !checkView(document, entry.id, *entry.view)) return false;
  }
  for (const Drawing& drawing : document.drawings) {
    if (drawing.id.value == 0 || drawing.id.value > document.lastDrawingId) return false;
    if (drawing.lines.empty() || !checkDrawing(document, drawing)) return false;
  }
  for (const Part& part : document.parts) {
    if (!checkDrawn(document, part.recipe)) return false;
    if (const LoftRecipe* recipe = loftOf(part)) {
      if (!ribs::isValid(recipe->edits) || !ribs::inRange(recipe->ribs) || !document::isValid(recipe->ignored) ||
          !loft::isValid(recipe->pose) || !loft::checkParams(recipe->loft)) {
        return false;
      }
    }
    if (inflateOf(part) && !isValid(inflateOf(part)->inflate)) return false;
    if (extrudeOf(part) && !isValid(extrudeOf(part)->extrude)) return false;
    if (stackOf(part) && !isValid(stackOf(part)->stack)) return false;
    if (shapeOf(part) && !isValid(shapeOf(part)->shape)) return false;
    if (elementOf(part) && !checkElement(document, *elementOf(part))) return false;
    for (const ParamInfo& info : paramTable(kindOf(part))) {
      if (info.get(part.recipe) < info.low || info.get(part.recipe) > info.high) return false;
    }
    if (tidyName(part.name, "x") != part.name || part.id.value == 0 || part.id.value > document.lastPartId) {
      return false;
    }
  }
  return document.height.value >= kMinHeightMm && document.height.value <= kMaxHeightMm;
}

/// Every number, text, list and object of the JSON, each replaced once by something hostile.
void spoil(Json& json, Rng& rng, int& countdown) {
  if (countdown-- == 0) {
    const std::array<Json, 12> hostile = {
        Json(), -1, 0, 1e300, 4294967295u, "", "x", false, Json::array(), Json::object(), Json{1, "2"}, -0.5};
    json = hostile[rng.below(hostile.size())];
    return;
  }
  if (json.is_structured()) {
    for (Json& child : json) spoil(child, rng, countdown);
  }
}

}  // namespace

TEST_CASE("every document of random sessions comes back equal from its JSON") {
  ActionCounts succeeded{};
  for (const std::uint64_t seed : testing::seeds(0, 60)) {
    const std::vector<Document> documents = randomSession(seed, 130, &succeeded);
    for (std::size_t i = seed % 7; i < documents.size(); i += 7) {
      ReadNotes notes;
      const std::string text = writeDocument(documents[i]);
      const Document read = readBack(documents[i], text, &notes);
      REQUIRE(read == documents[i]);
      REQUIRE(writeDocument(read) == text);
      REQUIRE(notes == ReadNotes{});
      REQUIRE(couldBeMade(read));
    }
  }
  for (std::size_t i = 0; i < succeeded.size(); ++i) {
    CHECK_MESSAGE(succeeded[i] > 0, "no action of alternative " << i << " ever succeeded");
  }
}

TEST_CASE("numbers come back exactly, the smallest and the largest, and −0 is 0") {
  Document document = twoParts();
  Part part = document.parts[0];
  const double tiny = std::numeric_limits<double>::denorm_min(), third = 1.0 / 3;
  loftOf(part)->edits.ends = {{third, ribs::Side::Left, tiny, -99999.999999999985, 1, true},
                              {0.1, ribs::Side::Right, 1e5, 12345.678901234567, 0.3, false}};
  loftOf(part)->pose.coilTurns = -0.0;
  document.parts[0] = part;
  const Document read = readBack(document, writeDocument(document));
  CHECK(read == document);
  CHECK_FALSE(std::signbit(loftOf(*read.parts[0])->pose.coilTurns));
  Rng rng(4);
  for (int i = 0; i < 2000; ++i) {
    const float value = static_cast<float>(std::ldexp(rng.uniform(), -static_cast<int>(rng.below(60))));
    float back = -1;
    REQUIRE(get(Json::parse(toJson(value).dump()), back));
    REQUIRE(back == value);
  }
}

TEST_CASE("what is as usual is not written") {
  const Document document = twoParts();
  Part named;
  named.name = std::string("x");
  CHECK(toJson(named) == Json{{"name", "x"}});
  CHECK(toJson(document.parts[0].get()).dump().size() < 160);
}

TEST_CASE("keys that nobody knows come back as they were, through any number of readings") {
  const Document document = twoParts();
  Json json = Json::parse(writeDocument(document));
  json["future"] = {{"deep", {1, 2.5, "x"}}};
  json["pictures"][0]["mood"] = "happy";
  json["parts"][1]["bones"] = {{"wave", true}};
  json["parts"][1]["recipe"]["magic"] = nullptr;
  json["parts"][0]["recipe"]["loft"]["glow"] = {1, {{"a", "b"}}};
  json["parts"][0]["recipe"]["loft"]["sections"][0]["shape"] = {{"shade", 7}};
  json["parts"][0]["recipe"]["pose"]["beat"] = 3;
  Document read = readBack(document, json.dump());
  CHECK(Json::parse(writeDocument(read)) == json);
  // They stay through edits of what they stand beside.
  read = update(read, RenamePart{PartId{2}, "Tail"}).value();
  read = update(read, SetHeight{{70}}).value();
  json["parts"][1]["name"] = "Tail";
  json["height"] = 70;
  CHECK(Json::parse(writeDocument(readBack(document, writeDocument(read)))) == json);
}

TEST_CASE("what unknown keys say of a list is dropped when the list has another length") {
  const Document document = twoParts();
  Json json = Json::parse(writeDocument(document));
  json["parts"][0]["recipe"]["loft"]["sections"][0]["new"] = 1;
  Document read = readBack(document, json.dump());
  const std::vector<loft::SectionKey> keys = {{0, sections::SectionPreset::Star, {}},
                                              {1, sections::SectionPreset::Gear, {}}};
  read = update(read, SetSections{PartId{1}, keys}).value();
  CHECK(writeDocument(read).find("\"new\"") == std::string::npos);
  ReadNotes notes;
  CHECK(loftOf(*readBack(document, writeDocument(read), &notes).parts[0])->loft.sections == keys);
  CHECK(notes.clean());
}

TEST_CASE("unknown keys of a list that mending shortens go with it, and the document reads back as it is") {
  const Document document = twoParts();
  ReadNotes notes;
  const Document read = mended(
      document,
      [&](Json& j) {
        j["parts"][0]["recipe"]["loft"]["sections"] = {{{"at", 7}, {"shape", {{"preset", "star"}}}},
                                                       {{"at", 0.5}, {"shape", {{"preset", "square"}}}, {"glow", 3}}};
        j["parts"][0]["bones"] = 2;
      },
      notes);
  CHECK(loftOf(*read.parts[0])->loft.sections.size() == 1);
  CHECK(notes.repaired > 0);
  CHECK(read.parts[0]->extra == R"({"bones":2})");
  CHECK(readBack(document, writeDocument(read), &notes) == read);
  CHECK(notes.clean());
}

TEST_CASE("a damaged value becomes a sound one, is counted, and the rest is as it was") {
  const Document document = twoParts();
  ReadNotes notes;
  const auto part = [](Json& json) -> Json& { return json["parts"][0]; };
  Document read = mended(document, [&](Json& j) { part(j)["recipe"]["spine"]["ribs"] = 1e9; }, notes);
  CHECK(read == document);
  CHECK(notes.dropped == 0);
  CHECK(notes.repaired == 1);
  read = mended(document, [&](Json& j) { part(j)["visible"] = "maybe"; }, notes);
  CHECK(read == document);
  CHECK(notes.dropped == 0);
  CHECK(notes.repaired == 1);
  read = mended(document, [&](Json& j) { part(j)["recipe"]["stroke"] = {5, 5}; }, notes);
  CHECK(read.parts.size() == 1);
  CHECK(read.parts[0] == document.parts[1]);
  CHECK(notes.dropped == 1);
  read = mended(document, [&](Json& j) { part(j)["recipe"]["picture"] = 77; }, notes);
  CHECK(read.parts.size() == 1);
  read = mended(document, [&](Json& j) { part(j)["id"] = 2; }, notes);
  CHECK(read.parts[0]->id == PartId{2});
  CHECK(read.parts[1]->id == PartId{3});
  CHECK(read.lastPartId == 3);
  read = mended(document, [&](Json& j) { j["lastPartId"] = 4294967295u; }, notes);
  CHECK(read == document);
  read = mended(document, [&](Json& j) { j["height"] = -3; }, notes);
  CHECK(read == document);
}

TEST_CASE("a document whose ids leave no room for more is numbered anew, with all that refers to them") {
  for (const std::uint64_t seed : testing::seeds(40, 60)) {
    CAPTURE(seed);
    Document document = randomSession(seed, 120).back();
    const auto photos = photosOfAll({document});
    Document large = document;
    const auto lift = [](auto& id) {
      if (id) id.value += kMostOpenedId;
    };
    const auto each = [](auto& boxes, const auto& change) {
      for (auto& box : boxes) {
        auto value = box.get();
        change(value);
        box = std::move(value);
      }
    };
    each(large.pictures, [&](PictureEntry& entry) {
      lift(entry.id);
      if (entry.view) lift(entry.view->of);
    });
    each(large.drawings, [&](Drawing& drawing) {
      lift(drawing.id);
      lift(drawing.picture);
      for (PieceOrder& order : drawing.orders) {
        lift(order.over);
        lift(order.under);
      }
    });
    each(large.parts, [&](Part& part) {
      lift(part.id);
      lift(part.group);
      if (ElementRecipe* element = elementOf(part)) lift(element->drawing);
      setPicture(part.recipe, PictureId{pictureOf(part).value + kMostOpenedId});
      for (Outline* outline : outlinesOf(part.recipe)) lift(outline->picture);
      if (part.relief && part.relief->laid) lift(part.relief->laid->picture);
      if (BridgeRecipe* bridge = bridgeOf(part)) {
        lift(bridge->from.part);
        lift(bridge->to.part);
      }
    });
    each(large.steps, [&](Step& step) {
      lift(step.id);
      for (Operand& operand : step.operands) {
        lift(operand.part);
        lift(operand.step);
      }
    });
    for (Group& group : large.groups) lift(group.id);
    for (std::uint32_t* last :
         {&large.lastPictureId, &large.lastPartId, &large.lastStepId, &large.lastGroupId, &large.lastDrawingId}) {
      *last += kMostOpenedId;
    }
    const auto read = readDocument(writeDocument(large), photos);
    REQUIRE(read.ok());
    renumber(document);
    CHECK(read.value() == document);
    CHECK(readDocument(writeDocument(document), photos).value() == document);
  }
}

TEST_CASE("two parts of one id where the largest one is taken: what is read is the same when it is read again") {
  for (const std::uint32_t last : {1u, 2u, kMostOpenedId - 1, kMostOpenedId, kMostId, 4294967295u}) {
    CAPTURE(last);
    ReadNotes notes;
    const Document read = mended(
        twoParts(),
        [&](Json& j) {
          j["lastPartId"] = j["parts"][0]["id"] = j["parts"][1]["id"] = last;
          j["lastPictureId"] = j["pictures"][0]["id"] = j["parts"][0]["recipe"]["picture"] =
              j["parts"][1]["recipe"]["picture"] = std::min(last, kMostId);
        },
        notes);
    REQUIRE(read.parts.size() == 2);
    CHECK(couldBeMade(read));
    CHECK(read.parts[0]->id != read.parts[1]->id);
    CHECK(readBack(read, writeDocument(read), &notes) == read);
    CHECK(notes.clean());
    // There is room for more, also in the journal.
    const Document next = update(read, DrawSpine{read.pictures[0]->id, {{20, 20}, {48, 30}, {76, 20}}}).value();
    CHECK(next.parts[2]->id.value <= kMostOpenedId + 1);
    CHECK(documentFrom(documentJson(next), {notes, photosOfAll({next})}, MissingPhoto::Fail).value() == next);
    CHECK(notes.clean());
  }
}

TEST_CASE("whatever one value of a file is replaced by, the document could have been made by hand") {
  const std::vector<Document> documents = randomSession(12, 200);
  const auto rich =
      std::find_if(documents.rbegin(), documents.rend(), [](const Document& d) { return d.parts.size() > 1; });
  REQUIRE(rich != documents.rend());
  const Document& document = *rich;
  const auto photos = photosOfAll(documents);
  const Json json = Json::parse(writeDocument(document));
  Rng rng(99);
  int opened = 0;
  // One place in so many, each time others; all of them where random tests run long.
  const int apart = testing::rounds(1) > 1 ? 1 : 6;
  for (int place = 1; place < 1500; place += apart) {
    Json spoilt = json;
    int countdown = place;
    spoil(spoilt, rng, countdown);
    const auto read = readDocument(spoilt.dump(), photos);
    if (!read) continue;
    ++opened;
    REQUIRE(couldBeMade(read.value()));
    const auto again = readDocument(writeDocument(read.value()), photos);
    REQUIRE(again.ok());
    REQUIRE(again.value() == read.value());
  }
  CHECK(opened > 1000 / apart);
}

TEST_CASE("what is no document is refused, however deep, long or new it is") {
  const auto errorOf = [](const std::string& text) {
    const auto read = readDocument(text, kNoPhotos);
    REQUIRE_FALSE(read.ok());
    return read.error();
  };
  for (const char* text : {"", "null", "[]", "7", "{", "{}", "{\"version\":0}", "{\"version\":-1}",
                           "{\"version\":\"1\"}", "{\"version\":1.5}", "\"\\ud800\"", "{\"version\":1}x"}) {
    CHECK(errorOf(text) == Error::ProjectInvalid);
  }
  CHECK(errorOf("{\"version\":" + std::to_string(kProjectVersion + 1) + "}") == Error::ProjectTooNew);
  CHECK(errorOf(std::string(5'000'000, '[')) == Error::ProjectInvalid);
  CHECK(errorOf("{\"version\":1,\"x\":" + std::string(100, '[') + std::string(100, ']') + "}") ==
        Error::ProjectInvalid);
  CHECK(errorOf(writeDocument(twoParts())) == Error::NoSuchPicture);
  CHECK(readDocument("{\"version\":1}", kNoPhotos).value() == Document{});
}

TEST_CASE("every version before this one has a migration, so that its files open for ever") {
  CHECK(migrations().size() == static_cast<std::size_t>(kProjectVersion) - 1);
}
