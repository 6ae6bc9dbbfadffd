#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "engine/io/document_json.h"
#include "engine/io/project_file.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"
#include "tests/support/sessions.h"
#include "tests/support/step_documents.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::testing;

namespace {

/// A picture with parts 1 … count.
Document withParts(std::uint32_t count) {
  Document document = update({}, AddPicture{"cat", ellipsePicture(96, 72)}).value();
  for (std::uint32_t i = 0; i < count; ++i) {
    document = update(document, DrawSpine{PictureId{1}, {{20, 36}, {48, 36}, {76, 36}}}).value();
  }
  return document;
}

}  // namespace

TEST_CASE("parts become a solid, the solid a part of another, and each has one place") {
  Document document = after(withParts(3), combine(StepKind::Join, {part(1), part(2)}));
  document = after(document, combine(StepKind::Hollow, {step(1)}));
  CHECK(document.steps.size() == 2);
  CHECK(document.steps[0]->name == "Solid 1");
  CHECK(rootOf(document, part(2))->id == StepId{2});
  CHECK(rootOf(document, part(3)) == nullptr);
  CHECK(partsIn(document, step(2)) == std::vector{PartId{1}, PartId{2}});
  CHECK(update(document, combine(StepKind::Cut, {part(1), part(3)})).error() == Error::AlreadyUsed);
  CHECK(update(document, combine(StepKind::Cut, {part(3), part(3)})).error() == Error::ValueOutOfRange);
  CHECK(update(document, combine(StepKind::Cut, {part(3)})).error() == Error::ValueOutOfRange);
  CHECK(update(document, combine(StepKind::Cut, {part(3), part(9)})).error() == Error::NoSuchPart);
  CHECK(update(document, combine(StepKind::Cut, {part(3), step(9)})).error() == Error::NoSuchStep);
}

TEST_CASE("what is combined within a solid stays within it") {
  Document document = after(withParts(3), combine(StepKind::Join, {part(1), part(2), part(3)}));
  document = after(document, combine(StepKind::Hollow, {part(2)}));
  CHECK(document.steps[0]->operands == std::vector{part(1), step(2), part(3)});
  document = after(document, combine(StepKind::Cut, {part(1), step(2)}));
  CHECK(document.steps[0]->operands == std::vector{step(3), part(3)});
  // Of all that is left: the outer solid would have one part, so that it goes.
  document = after(document, combine(StepKind::Intersection, {step(3), part(3)}));
  CHECK(findStep(document, StepId{1}) == nullptr);
  CHECK(isForest(document));
}

TEST_CASE("a part that goes leaves its solid, and a solid with too few parts dissolves") {
  Document document = after(withParts(4), combine(StepKind::Join, {part(1), part(2)}));
  document = after(document, combine(StepKind::Cut, {step(1), part(3), part(4)}));
  document = after(document, DeletePart{PartId{1}});
  CHECK(document.steps.size() == 1);
  CHECK(findStep(document, StepId{2})->operands == std::vector{part(2), part(3), part(4)});
  document = after(document, RemovePicture{PictureId{1}});
  CHECK(document.steps.empty());
  CHECK(document.parts.empty());
  CHECK(document.lastStepId == 2);
}

TEST_CASE("breaking apart gives back what was put together, and deleting takes all of it") {
  const Document joined = after(withParts(3), combine(StepKind::Join, {part(1), part(2)}));
  const Document both = after(joined, combine(StepKind::Cut, {step(1), part(3)}));
  CHECK(after(both, ReleaseStep{StepId{2}}).steps == joined.steps);
  const Document inner = after(both, ReleaseStep{StepId{1}});
  CHECK(inner.steps[0]->operands == std::vector{part(1), part(2), part(3)});
  CHECK(after(both, DeleteStep{StepId{2}}).parts.empty());
  CHECK(after(joined, DeleteStep{StepId{1}}).parts.size() == 1);
  const Document hollow = after(joined, combine(StepKind::Hollow, {step(1)}));
  CHECK(after(hollow, ReleaseStep{StepId{1}}).steps.empty());
  const Document twice = after(hollow, combine(StepKind::Hollow, {step(2)}));
  CHECK(after(twice, ReleaseStep{StepId{1}}).steps.empty());
}

TEST_CASE("measures, name, order and look of a solid are set, within their limits") {
  Document document = after(withParts(2), combine(StepKind::Join, {part(1), part(2)}));
  const StepId id{1};
  document = after(document, SetStep{id, StepKind::Cut, 0.05, 0.1, {OpeningSide::Front, 0.25}});
  document = after(document, OrderOperands{id, {part(2), part(1)}});
  document = after(document, RenameStep{id, "Mug"});
  document = after(document, ShowStep{id, false});
  document = after(document, SetStepLook{id, true, {false, {1, 2, 3}}});
  const Step& made = *document.steps[0];
  CHECK(made.kind == StepKind::Cut);
  CHECK(made.operands.front() == part(2));
  CHECK(made.name == "Mug");
  CHECK((made.ownLook && !made.visible));
  CHECK(update(document, SetStep{id, StepKind::Hollow, 0, 0.1, {}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, SetStep{id, StepKind::Join, 0.3, 0.1, {}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, SetStep{id, StepKind::Join, 0, 0.6, {}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, OrderOperands{id, {part(2)}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, ShowStep{StepId{7}, true}).error() == Error::NoSuchStep);
}

TEST_CASE("steps of random sessions are forests of sound steps") {
  std::size_t most = 0;
  for (const std::uint64_t seed : testing::seeds(0, 60)) {
    CAPTURE(seed);
    Document document = withParts(6);
    Rng rng(seed);
    for (int i = 0; i < 150; ++i) {
      CAPTURE(i);
      Action action = randomAction(rng, document);
      if (std::holds_alternative<RemovePicture>(action)) continue;
      if (Result<Document> next = update(document, action)) document = std::move(next).value();
      REQUIRE(isForest(document));
      for (const Step& each : document.steps) {
        CAPTURE(static_cast<int>(each.kind));
        CAPTURE(each.operands.size());
        REQUIRE(checkStep(each).ok());
      }
      most = std::max(most, document.steps.size());
    }
  }
  CHECK(most >= 3);
}

TEST_CASE("steps of a damaged file are mended to a forest, whatever they say") {
  const Document sound = after(after(withParts(4), combine(StepKind::Join, {part(1), part(2)})),
                               combine(StepKind::Cut, {step(1), part(3)}));
  const auto read = [&](const io::Json& steps) {
    io::Json json = io::Json::parse(io::writeDocument(sound));
    json["steps"] = steps;
    io::ReadNotes notes;
    const auto document = io::readDocument(json.dump(), photosOfAll({sound}), &notes);
    REQUIRE(document.ok());
    CHECK(!notes.clean());
    CHECK(isForest(document.value()));
    for (const Step& each : document.value().steps) CHECK(checkStep(each).ok());
    return document.value().steps.size();
  };
  const auto of = [](int id, io::Json operands) {
    return io::Json{{"id", id}, {"name", "s"}, {"operands", std::move(operands)}};
  };
  const io::Json one{{"part", 1}}, two{{"part", 2}}, three{{"part", 3}}, none{{"part", 77}};
  CHECK(read({of(1, {one, two}), of(2, {one, three})}) == 1);
  CHECK(read({of(1, {one, none})}) == 0);
  CHECK(read({of(1, {one, io::Json{{"step", 2}}}), of(2, {two, io::Json{{"step", 1}}})}) <= 2);
  CHECK(read({of(1, {one, io::Json{{"step", 1}}})}) == 0);
  CHECK(read({of(1, {one, two}), of(1, {three, io::Json{{"part", 4}}})}) == 2);
  CHECK(read({of(1, io::Json::array({one, io::Json{{"part", 2}, {"step", 1}}}))}) == 0);
  CHECK(read(5) == 0);
}

TEST_CASE("a document without solids is written as before there were any") {
  const std::string text = io::writeDocument(withParts(2));
  CHECK(text.find("tep") == std::string::npos);
}
