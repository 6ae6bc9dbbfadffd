// Bridges in documents: they stand on other parts, and follow them.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "engine/document/renumber.h"
#include "engine/document/update.h"
#include "engine/io/project_file.h"
#include "engine/io/share_text.h"
#include "engine/mesh/surface_places.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/world.h"
#include "tests/support/after.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::pipeline;
using namespace spineloft::document;
using testing::after;
using testing::errorOf;

namespace {

constexpr PictureId kPaper{1};
constexpr PartId kLeft{1}, kRight{2}, kBridge{3};

std::vector<ModelPoint> circle(ModelPoint middle, double radius) {  // square to x
  std::vector<ModelPoint> points;
  for (int i = 0; i < 12; ++i) {
    const double a = 2 * std::numbers::pi * i / 12;
    points.push_back(middle + ModelPoint{0, radius * std::cos(a), radius * std::sin(a)});
  }
  return points;
}

DrawShape ball(PicturePoint middle, double size) {
  shape::ShapeParams params;
  params.axis = {{middle.x, middle.y + size / 2}, {middle.x, middle.y - size / 2}};
  params.width = size;
  return {kPaper, params};
}
const BridgeEnd kFrom{kLeft, circle({140, -100, 0}, 18)}, kTo{kRight, circle({260, -100, 0}, 18)};

/// Two balls with a gap of 120 pixels, and a bridge between them.
Document twoBalls() {
  return after({},
               {AddSketch{"Paper", {400, 200}}, ball({100, 100}, 90), ball({300, 100}, 90), DrawBridge{kFrom, kTo}});
}

Derived derived(const Document& document) {
  Cache cache;
  Result<Derived> made = deriveWithEdges(document, cache, Progress());
  REQUIRE(made.ok());
  return std::move(made).value();
}
const PartShape& shapeOf(const Derived& derived, PartId id) {
  const auto at = std::ranges::find(derived.parts, id, &DerivedPart::id);
  REQUIRE(at != derived.parts.end());
  REQUIRE(at->shape != nullptr);
  return *at->shape;
}

/// How far the rims of the bridge are from the surfaces of their parts, as these stand in the world; at most.
double offHosts(const Document& document, PartId bridge) {
  const Derived made = derived(document);
  const Part& part = *findPart(document, bridge);
  const auto inWorld = [&](PartId id) {
    const Part& host = *findPart(document, id);
    return *copiesInWorld(host, findPicture(document, pictureOf(host))->size).begin();
  };
  const PartShape& shape = shapeOf(made, bridge);
  testing::requireLawful(shape.mesh);
  REQUIRE(shape.rims.size() == 2);
  double most = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const PartId id = (i == 0 ? bridgeOf(part)->from : bridgeOf(part)->to).part;
    const ToWorld host = inWorld(id);
    const mesh::SurfacePlaces places(shapeOf(made, id).mesh);
    for (const ModelPoint p : shape.rims[i].points) {
      const ModelPoint there = host.toModel(inWorld(bridge)(p));
      most = std::max(most, distance(places.nearest(there)->at, there));
    }
  }
  return most;
}

geometry::Turn aboutZ(double angle) { return geometry::turnAbout(WorldPoint{0, 0, 1}, angle); }

}  // namespace

TEST_CASE("a bridge stands on its parts, also when they are moved, turned, scaled and mirrored") {
  constexpr double kOff = 0.003 * 18;
  const Document document = twoBalls();
  CHECK(offHosts(document, kBridge) < kOff);
  Placement placement;
  placement.pivot = {0.25, 0, 0};
  placement.move = {0.05, 0.1, -0.05};
  placement.turn = aboutZ(std::numbers::pi / 6);
  placement.scale = 1.2;
  const Document moved = after(document, {PlaceParts{{{kRight, placement, {}}}}});
  CHECK(offHosts(moved, kBridge) < kOff);
  CHECK_FALSE(shapeOf(derived(moved), kBridge).mesh == shapeOf(derived(document), kBridge).mesh);
  placement.mirrored = true;  // and turned, so that what was at the left is there again
  placement.turn = aboutZ(std::numbers::pi);
  CHECK(offHosts(after(document, {PlaceParts{{{kRight, placement, {}}}}}), kBridge) < kOff);
}

TEST_CASE("a bridge stays on a part that becomes another one, and goes along with one that is moved in its picture") {
  const Document document = twoBalls();
  Action larger = SetShape{kLeft, ball({100, 100}, 108).shape};
  CHECK(offHosts(after(document, {larger}), kBridge) < 0.003 * 18);
  const Document moved = after(document, {SetShape{kLeft, ball({90, 120}, 90).shape}});
  CHECK(bridgeOf(*moved.parts[2])->from.rim[0] == kFrom.rim[0] + ModelPoint{-10, -20, 0});
  CHECK(bridgeOf(*moved.parts[2])->to == kTo);
  CHECK(offHosts(moved, kBridge) < 0.003 * 18);
}

TEST_CASE("a bridge itself stands where its parts do: it is not placed, and copied with them only") {
  const Document document = twoBalls();
  Placement away;
  away.move = {1, 0, 0};
  CHECK(after(document, {PlaceParts{{{kBridge, away, {}}}}}).parts == document.parts);
  CHECK(errorOf(document, DuplicateParts{{kBridge}, {0.1, 0, 0}}) == Error::BridgeFollows);
  CHECK(after(document, {DuplicateParts{{kLeft, kBridge}, {0.1, 0, 0}}}).parts.size() == 4);
  const Document twice = after(document, {DuplicateParts{{kLeft, kRight, kBridge}, {0, 0.5, 0}}});
  REQUIRE(twice.parts.size() == 6);
  const auto copy =
      std::ranges::find_if(twice.parts, [](const Part& part) { return bridgeOf(part) && part.id != kBridge; });
  CHECK(bridgeOf(**copy)->from.part != kLeft);
  CHECK(bridgeOf(**copy)->to.part != kRight);
  CHECK(offHosts(twice, (*copy)->id) < 0.1);
  const MirrorPlane plane{{0, 0, 0}, {0, 1, 0}};
  const Document mirrored = after(document, {DuplicateParts{{kLeft, kRight, kBridge}, {0, 0.6, 0}, plane}});
  const auto other =
      std::ranges::find_if(mirrored.parts, [](const Part& part) { return bridgeOf(part) && part.id != kBridge; });
  CHECK(offHosts(mirrored, (*other)->id) < 0.1);
}

TEST_CASE("a part that goes takes its bridges with it, and its solid stays as far as it can") {
  const Document document =
      after(twoBalls(), {CombineParts{StepKind::Join, {{kLeft, {}}, {kRight, {}}, {kBridge, {}}}, Step{}.wall, {}}});
  const Document left = after(document, {DeletePart{kRight}});
  REQUIRE(left.parts.size() == 1);
  CHECK(left.parts[0]->id == kLeft);
  CHECK(left.steps.empty());
  CHECK(after(document, {DeletePart{kBridge}}).steps.size() == 1);
  CHECK(after(document, {DeleteStep{document.steps[0]->id}}).parts.empty());
  const Document beside =
      after(twoBalls(), {CombineParts{StepKind::Join, {{kLeft, {}}, {kRight, {}}}, Step{}.wall, {}}});
  CHECK(after(beside, {DeleteStep{beside.steps[0]->id}}).parts.empty());
}

TEST_CASE("what a bridge cannot stand on is refused by name, and one without its part says so") {
  const Document document = twoBalls();
  CHECK(errorOf(document, DrawBridge{{PartId{9}, kFrom.rim}, kTo}) == Error::NoSuchPart);
  CHECK(errorOf(document, DrawBridge{{kBridge, kFrom.rim}, kTo}) == Error::HostIsBridge);
  CHECK(errorOf(document, SetBridgeEnds{kBridge, kFrom, {kBridge, kTo.rim}}) == Error::HostIsBridge);
  CHECK(errorOf(document, SetBridgeEnds{kLeft, kFrom, kTo}) == Error::NotABridge);
  CHECK(errorOf(document, DrawBridge{{kLeft, {{1, 2, 3}}}, kTo}) == Error::ValueOutOfRange);
  CHECK(errorOf(document, DrawBridge{{kLeft, {{1, 2, 3}, {4, std::nan(""), 6}, {7, 8, 9}}}, kTo}) ==
        Error::ValueOutOfRange);
  CHECK(errorOf(document, DrawBridge{kFrom, kTo, {0.05, 1}}) == Error::ValueOutOfRange);
  Document broken = document;
  broken.parts.erase(broken.parts.begin());
  CHECK(derived(broken).parts[1].failure->error == Error::HostGone);
  Document twice = document;  // as no action makes it
  Part bridge = twice.parts[2];
  bridge.id = PartId{4};
  bridgeOf(bridge)->to.part = kBridge;
  twice.parts.push_back(bridge);
  CHECK(derived(twice).parts[3].failure->error == Error::HostGone);
  bridgeOf(bridge)->to.part = PartId{4};
  twice.parts[3] = bridge;
  CHECK(derived(twice).parts[3].failure->error == Error::HostGone);
}

TEST_CASE("the key of a bridge follows its rims, its measures, its parts and their places, and nothing else") {
  const Document document = twoBalls();
  const auto keyOf = [](const Document& d) { return shapeKey(*findPart(d, kBridge), *d.pictures[0], d); };
  const ShapeKey key = keyOf(document);
  const auto changed = [&](const Action& action) { return keyOf(after(document, {action})) != key; };
  BridgeEnd end = kFrom;
  end.rim[3].z += 1e-9;
  Placement placement;
  placement.move.x = 1e-9;
  CHECK(changed(SetBridgeEnds{kBridge, end, kTo}));
  CHECK(changed(SetBridgeEnds{kBridge, kTo, kFrom}));
  CHECK(changed(SetParameter{kBridge, "waist", 0.7}));
  CHECK(changed(SetParameter{kBridge, "bow", 1.1}));
  CHECK(changed(SetShape{kRight, ball({300, 100}, 91).shape}));
  CHECK(changed(SetPulls{kRight, {{{{300, -100, 45}}, 5, {}, 12, false}}}));
  CHECK(changed(PlaceParts{{{kLeft, placement, {}}}}));
  CHECK_FALSE(changed(RenamePart{kLeft, "Other"}));
  CHECK_FALSE(changed(PlaceParts{{{kBridge, placement, {}}}}));
}

TEST_CASE("a bridge read without its part stands on none, so that no later part is taken for it") {
  Document broken = twoBalls();
  broken.parts.erase(broken.parts.begin() + 1);
  broken.lastPartId = 3;
  const auto read = io::readDocument(io::writeDocument(broken), {});
  REQUIRE(read.ok());
  CHECK(bridgeOf(*read.value().parts[1])->to.part == PartId{});
  CHECK(bridgeOf(*read.value().parts[1])->from.part == kLeft);
}

TEST_CASE("a bridge comes back from files and links, with the new ids of its parts") {
  const Document document = twoBalls();
  Document others =
      after(document, {DrawBridge{{kLeft, kFrom.rim}, {kLeft, circle({60, -100, 0}, 9)}}, DeletePart{kRight}});
  REQUIRE(others.parts.size() == 2);
  renumber(others);
  CHECK(others.parts[1]->id == PartId{2});
  CHECK(bridgeOf(*others.parts[1])->to.part == kLeft);
  io::ReadNotes notes;
  const auto shared = io::readShareText(io::writeShareText(document).value(), &notes);
  REQUIRE(shared.ok());
  CHECK(notes.clean());
  const auto host = bridgeOf(*shared.value().parts[2])->from.part;
  CHECK(host == kLeft);
  CHECK(offHosts(shared.value(), kBridge) < 0.1);
}
