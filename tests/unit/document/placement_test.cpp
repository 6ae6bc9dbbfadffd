#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/document/update.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::testing;

namespace {

WorldPoint anyPoint(Rng& rng) { return {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)}; }

MirrorPlane anyPlane(Rng& rng) { return {anyPoint(rng), normalized(anyPoint(rng))}; }

Motion anyMotion(Rng& rng) {
  return {anyPoint(rng), anyPoint(rng), geometry::turnAbout(anyPoint(rng), rng.uniform(-3, 3)), rng.uniform(0.5, 2)};
}

Document threeParts() {
  Document document = update({}, AddPicture{"e", ellipsePicture(96, 72)}).value();
  for (int i = 0; i < 3; ++i) {
    document = update(document, DrawSpine{PictureId{1}, {{20, 36}, {48, 36}, {76, 36}}}).value();
  }
  return document;
}

std::vector<std::uint32_t> order(const Document& document) {
  std::vector<std::uint32_t> ids;
  for (const Part& part : document.parts) ids.push_back(part.id.value);
  return ids;
}

}  // namespace

TEST_CASE("turns: there and back, angles of any turn, and a turn keeps lengths") {
  Rng rng(3);
  for (int i = 0; i < 500; ++i) {
    const geometry::Turn turn = geometry::turnAbout(anyPoint(rng), rng.uniform(-7, 7));
    const WorldPoint p = anyPoint(rng), q = geometry::turned(turn, p);
    CHECK(norm(q) == doctest::Approx(norm(p)));
    CHECK(distance(geometry::turned(geometry::inverse(turn), q), p) < 1e-12);
    const geometry::Turn again = geometry::turnOf(geometry::anglesOf(turn));
    CHECK(distance(geometry::turned(again, p), q) < 1e-6);
  }
  // Straight up: turn and roll are one.
  const geometry::Turn up = geometry::turnOf({std::numbers::pi / 2, 0.4, 0.3});
  const WorldPoint p{0.3, -0.2, 0.9};
  CHECK(distance(geometry::turned(geometry::turnOf(geometry::anglesOf(up)), p), geometry::turned(up, p)) < 1e-6);
  // About y, what is in front goes to the right.
  const WorldPoint front{0, 0, 1};
  CHECK(distance(geometry::turned(geometry::turnOf({0, std::numbers::pi / 2, 0}), front), WorldPoint{1, 0, 0}) < 1e-12);
}

TEST_CASE("the least turn from one direction to another brings it there, and goes no other way round") {
  Rng rng(5);
  for (int i = 0; i < 500; ++i) {
    const WorldPoint from = normalized(anyPoint(rng));
    WorldPoint to = normalized(anyPoint(rng));
    if (i % 5 == 0) to = from * (i % 2 == 0 ? -1.0 : 1.0);
    const geometry::Turn turn = geometry::turnTo(from * 3.0, to * 0.5);
    CHECK(geometry::isValid(turn));
    CHECK(distance(geometry::turned(turn, from), to) < 1e-9);
    CHECK(2 * std::acos(std::min(1.0, turn.w)) == doctest::Approx(std::acos(std::clamp(dot(from, to), -1.0, 1.0))));
  }
}

TEST_CASE("a motion after a placement is one placement, and the motion between two placements is found") {
  Rng rng(4);
  for (int i = 0; i < 500; ++i) {
    const Placement placement = randomPlacement(rng);
    const Motion motion = anyMotion(rng);
    const Placement both = moved(placement, motion);
    REQUIRE(isValid(both));
    const WorldPoint p = anyPoint(rng);
    CHECK(distance(both(p), motion(placement(p))) < 1e-11);
    CHECK(distance(between(placement, both)(placement(p)), both(p)) < 1e-11);
    const Placement elsewhere = about(placement, anyPoint(rng));
    CHECK(distance(elsewhere(p), placement(p)) < 1e-11);
  }
}

TEST_CASE("mirrored twice over one plane is where it was, once is the plane's mirror") {
  Rng rng(5);
  for (int i = 0; i < 500; ++i) {
    const Placement placement = randomPlacement(rng);
    const MirrorPlane plane = anyPlane(rng);
    const Placement once = mirrored(placement, plane), twice = mirrored(once, plane);
    const WorldPoint p = anyPoint(rng);
    CHECK(once.mirrored != placement.mirrored);
    CHECK(distance(once(p), plane(placement(p))) < 1e-11);
    CHECK(distance(twice(p), placement(p)) < 1e-11);
    CHECK(twice.mirrored == placement.mirrored);
    // A plane that goes along mirrors what went along.
    const Motion motion = anyMotion(rng);
    CHECK(distance(moved(plane, motion)(motion(p)), motion(plane(p))) < 1e-10);
  }
}

TEST_CASE("a copy stands behind its original, mirrored over a plane if asked for") {
  Document document = threeParts();
  Rng rng(6);
  const Placement placement = randomPlacement(rng);
  document = update(document, PlaceParts{{{PartId{1}, placement, {}}}}).value();
  const MirrorPlane plane{{0.2, 0, 0}, {1, 0, 0}};
  const Document copied = update(document, DuplicateParts{{PartId{1}, PartId{3}}, {0.1, 0, 0}, plane}).value();
  CHECK(order(copied) == std::vector<std::uint32_t>{1, 4, 2, 3, 5});
  const WorldPoint p{0.1, 0.2, 0.3};
  CHECK(distance(copied.parts[1]->placement(p), plane(placement(p) + WorldPoint{0.1, 0, 0})) < 1e-12);
  CHECK(copied.parts[1]->recipe == document.parts[0]->recipe);
  CHECK(copied.parts[1]->name == "Part 1 copy");
  CHECK(copied.parts[0] == document.parts[0]);
}

TEST_CASE("the copies of all parts of a solid are a solid like it, with what is within; of some parts they are none") {
  Document document = threeParts();
  document = update(document, CombineParts{StepKind::Join, {{PartId{1}, {}}, {PartId{3}, {}}}, 0.02, {}}).value();
  document =
      update(document, CombineParts{StepKind::Hollow, {{{}, StepId{1}}}, 0.03, {OpeningSide::Left, 0.1}}).value();
  const MirrorPlane plane{{0.2, 0, 0}, {1, 0, 0}};
  const Document copied = update(document, DuplicateParts{{PartId{1}, PartId{3}}, {}, plane}).value();
  REQUIRE(copied.steps.size() == 4);
  CHECK(isForest(copied));
  const Step& join = copied.steps[2];
  const Step& hollow = copied.steps[3];
  CHECK(join.kind == StepKind::Join);
  CHECK(join.operands == std::vector<Operand>{{PartId{4}, {}}, {PartId{5}, {}}});
  CHECK(hollow.kind == StepKind::Hollow);
  CHECK(hollow.operands == std::vector<Operand>{{{}, join.id}});
  CHECK(hollow.wall == 0.03);
  CHECK(hollow.opening == Opening{OpeningSide::Right, 0.1});
  CHECK(copied.steps[0] == document.steps[0]);
  CHECK(copied.steps[1] == document.steps[1]);
  CHECK(update(document, DuplicateParts{{PartId{1}, PartId{3}}, {}, {}}).value().steps[3]->opening.side ==
        OpeningSide::Left);
  CHECK(update(document, DuplicateParts{{PartId{1}, PartId{2}}, {}, {}}).value().steps == document.steps);
}

TEST_CASE("a group is one piece of the list, its copy a group of its own, and the last part takes it along") {
  Document document = threeParts();
  document = update(document, GroupParts{{PartId{3}, PartId{1}}, "Ears"}).value();
  CHECK(order(document) == std::vector<std::uint32_t>{1, 3, 2});
  CHECK(partsOfGroup(document, GroupId{1}) == std::vector<PartId>{PartId{1}, PartId{3}});
  const Document copied = update(document, DuplicateParts{{PartId{1}, PartId{3}}, {}, {}}).value();
  CHECK(order(copied) == std::vector<std::uint32_t>{1, 3, 4, 5, 2});
  CHECK(partsOfGroup(copied, GroupId{2}) == std::vector<PartId>{PartId{4}, PartId{5}});
  CHECK(findGroup(copied, GroupId{2})->name == "Ears copy");
  // A part dropped between two of a group joins it; one dropped away from it leaves.
  Document moved = update(document, MoveInList{{PartId{2}}, PartId{3}}).value();
  CHECK(order(moved) == std::vector<std::uint32_t>{1, 2, 3});
  CHECK(findPart(moved, PartId{2})->group == GroupId{1});
  moved = update(document, MoveInList{{PartId{1}}, {}}).value();
  CHECK(order(moved) == std::vector<std::uint32_t>{3, 2, 1});
  CHECK_FALSE(findPart(moved, PartId{1})->group);
  document = update(document, DeletePart{PartId{1}}).value();
  CHECK(document.groups.size() == 1);
  document = update(document, DeletePart{PartId{3}}).value();
  CHECK(document.groups.empty());
}

TEST_CASE("ungrouping leaves everything where it is") {
  const Document document = threeParts();
  const Document grouped = update(document, GroupParts{{PartId{1}, PartId{2}}, ""}).value();
  CHECK(grouped.groups.front().name == "Group 1");
  const Document back = update(grouped, Ungroup{GroupId{1}}).value();
  CHECK(back.parts == document.parts);
  CHECK(back.groups.empty());
}

TEST_CASE("what cannot be placed, grouped or moved is refused with its reason") {
  const Document document = threeParts();
  Placement bad;
  bad.scale = 0;
  CHECK(update(document, PlaceParts{{{PartId{1}, bad, {}}}}).error() == Error::ValueOutOfRange);
  bad = {};
  bad.turn.w = 2;
  CHECK(update(document, PlaceParts{{{PartId{1}, bad, {}}}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, PlaceParts{{{PartId{1}, {}, MirrorPlane{{}, {1, 1, 0}}}}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, PlaceParts{{{PartId{1}, {}, {}}, {PartId{1}, {}, {}}}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, PlaceParts{}).error() == Error::NoSuchPart);
  CHECK(update(document, GroupParts{{PartId{9}}, ""}).error() == Error::NoSuchPart);
  CHECK(update(document, Ungroup{GroupId{1}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, MoveInList{{PartId{1}}, PartId{7}}).error() == Error::NoSuchPart);
}

TEST_CASE("groups of random sessions have parts, and parts of groups have their group") {
  for (const std::uint64_t seed : testing::seeds(0, 60)) {
    Rng rng(seed);
    Document document;
    for (int i = 0; i < 120; ++i) {
      Result<Document> next = update(document, randomAction(rng, document));
      if (next) document = std::move(next).value();
      for (const Group& group : document.groups) {
        REQUIRE_FALSE(partsOfGroup(document, group.id).empty());
        REQUIRE(group.id.value <= document.lastGroupId);
      }
      for (const Part& part : document.parts) {
        REQUIRE((!part.group || findGroup(document, part.group) != nullptr));
        REQUIRE(isValid(part.placement));
        REQUIRE((!part.mirror || isValid(*part.mirror)));
      }
    }
  }
}
