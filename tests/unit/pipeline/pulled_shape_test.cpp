// Pulls in the pipeline: keys, what is kept, and parts that change under their pulls.
#include <doctest/doctest.h>

#include <cmath>

#include "engine/document/update.h"
#include "engine/pipeline/derive.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::pipeline;
using namespace spineloft::document;

namespace {

Document puffDocument(std::vector<PicturePoint> outline = {{40, 40}, {160, 40}, {160, 110}, {40, 110}}) {
  const Document paper = update({}, AddSketch{"Paper", {200, 150}}).value();
  return update(paper, DrawRegion{{PictureId{1}, {std::move(outline)}}, inflate::InflateParams{}}).value();
}

Document pulled(const Document& document, std::vector<pull::Pull> pulls) {
  return update(document, SetPulls{PartId{1}, std::move(pulls)}).value();
}

ShapeKey keyOf(const Document& document) { return shapeKey(*document.parts[0], *document.pictures[0], document); }

std::shared_ptr<const PartShape> shapeOf(const Document& document, Cache& cache) {
  const Result<Derived> derived = deriveWithEdges(document, cache, Progress());
  REQUIRE(derived.ok());
  REQUIRE(derived.value().parts.at(0).shape != nullptr);
  return derived.value().parts[0].shape;
}

const pull::Pull kNose{{{100, -75, 40}}, 15, {}, 20, false};
const pull::Pull kBrow{{{80, -60, 30}, {120, -60, 30}}, 8, {}, 14, true};

}  // namespace

TEST_CASE("a part has the pulls that it was given, and one that is refused changes nothing") {
  const Document document = puffDocument();
  CHECK(pulled(document, {kNose, kBrow}).parts[0]->pulls == std::vector{kNose, kBrow});
  CHECK(pulled(pulled(document, {kNose}), {}) == document);
  pull::Pull bad = kNose;
  bad.radius = std::nan("");
  CHECK(update(document, SetPulls{PartId{1}, {bad}}).error() == Error::ValueOutOfRange);
  CHECK(update(document, SetPulls{PartId{7}, {kNose}}).error() == Error::NoSuchPart);
}

TEST_CASE("a part that is moved as a whole in its picture takes its pulls along, one that changes does not") {
  Document document = update({}, AddSketch{"Paper", {200, 150}}).value();
  shape::ShapeParams shape;
  shape.axis = {{100, 110}, {100, 40}};
  shape.width = 60;
  document = update(document, DrawShape{PictureId{1}, shape}).value();
  const pull::Pull dent{{{100, -75, 30}}, -5, {}, 12, false}, told{{{90, -75, 30}}, 0, {{90, -75, 50}}, 12, false};
  document = update(document, SetPulls{PartId{1}, {dent, told}}).value();
  shape.axis = {{120, 115}, {120, 45}};
  const Document moved = update(document, SetShape{PartId{1}, shape}).value();
  CHECK(moved.parts[0]->pulls[0].line[0] == ModelPoint{120, -80, 30});
  CHECK(moved.parts[0]->pulls[1].to[0] == ModelPoint{110, -80, 50});
  shape.axis.to.y -= 10;
  CHECK(update(moved, SetShape{PartId{1}, shape}).value().parts[0]->pulls == moved.parts[0]->pulls);
}

TEST_CASE("a flat piece that comes nearer takes its pulls along, a profile that leaves its axis does not") {
  const Document paper = update({}, AddSketch{"Paper", {200, 150}}).value();
  const std::vector<PicturePoint> square{{100, 40}, {160, 40}, {160, 110}, {100, 110}};
  const Region region{PictureId{1}, {square}};
  const pull::Pull dent{{{130, -75, 5}}, 5, {}, 12, false};
  const auto pullsAfter = [&](const RegionSolid& solid, const Action& action) {
    const Document drawn = update(paper, DrawRegion{region, solid}).value();
    return update(update(drawn, SetPulls{PartId{1}, {dent}}).value(), action).value().parts[0]->pulls.at(0).line.at(0);
  };
  extrude::ExtrudeParams nearer;
  nearer.depth = 0.1;
  CHECK(pullsAfter(extrude::ExtrudeParams{}, ShapeRegion{PartId{1}, nearer}) == ModelPoint{130, -75, 25});
  lathe::LatheParams turned;
  turned.axisFrom = {80, 20};
  turned.axisTo = {80, 130};
  std::vector<PicturePoint> farther = square;
  for (PicturePoint& p : farther) p.x += 20;
  CHECK(pullsAfter(turned, RedrawRegion{PartId{1}, {PictureId{1}, {farther}}}) == ModelPoint{130, -75, 5});
}

TEST_CASE("the key of a shape follows every member of its pulls and their order") {
  const Document plain = puffDocument(), document = pulled(plain, {kNose, kBrow});
  const ShapeKey key = keyOf(document);
  CHECK(key != keyOf(plain));
  CHECK(keyOf(pulled(document, {kBrow, kNose})) != key);
  CHECK(keyOf(pulled(document, {})) == keyOf(plain));
  const auto changes = [&](const auto& change) {
    pull::Pull other = kNose;
    change(other);
    return keyOf(pulled(document, {other, kBrow})) != key;
  };
  CHECK(changes([](pull::Pull& pull) { pull.line[0].z += 1e-9; }));
  CHECK(changes([](pull::Pull& pull) { pull.height += 1e-9; }));
  CHECK(changes([](pull::Pull& pull) { pull.to = {{1, 2, 3}}; }));
  CHECK(changes([](pull::Pull& pull) { pull.radius += 1e-9; }));
  CHECK(changes([](pull::Pull& pull) { pull.crease = true; }));
  CHECK(changes([](pull::Pull& pull) { pull.ring = {{1, 2, 3}, {4, 5, 6}, {7, 8, 10}}; }));
  CHECK(changes([](pull::Pull& pull) { pull.across = {{1, 2, 3}}; }));
  pull::Pull first = kNose;
  first.to = first.across = first.acrossTo = {{1, 2, 3}};
  pull::Pull second = first;
  second.acrossTo[0].x += 1e-9;
  CHECK(keyOf(pulled(document, {first})) != keyOf(pulled(document, {second})));
}

TEST_CASE("what is kept of pulls changes nothing: a mesh made anew is the same") {
  const Document document = pulled(puffDocument(), {kNose, kBrow});
  Cache used;
  const PartShape first = *shapeOf(document, used);
  testing::requireLawful(first.mesh);
  REQUIRE(first.pulled.size() == 2);
  for (const double height : {4.0, -6.0, 15.0}) {
    CAPTURE(height);
    pull::Pull nose = kNose;
    nose.height = height;
    const Document other = pulled(document, {nose, kBrow});
    Cache fresh;
    CHECK(shapeOf(other, used)->mesh == shapeOf(other, fresh)->mesh);
    const auto preview = previewShape(document, document.parts[0]->recipe, used, {}, {other.parts[0]->pulls});
    REQUIRE(preview.ok());
    CHECK(preview.value().mesh == shapeOf(other, fresh)->mesh);
  }
  pull::Pull deep = kNose;
  deep.height = -300;
  const std::vector<pull::Pull> pulls{deep};
  // What a moving hand leaves behind does not get into what stays: the first pull stops, and another one follows it.
  const std::vector<pull::Pull> both{deep, kBrow};
  Cache anew;
  REQUIRE(liveShape(document, document.parts[0]->recipe, used, {}, {both}).ok());
  CHECK(previewShape(document, document.parts[0]->recipe, used, {}, {both}).value().mesh ==
        previewShape(document, document.parts[0]->recipe, anew, {}, {both}).value().mesh);
  const auto live = liveShape(document, document.parts[0]->recipe, used, {}, {pulls});
  const auto rested = previewShape(document, document.parts[0]->recipe, used, {}, {pulls});
  CHECK(live.value().quality == TraceQuality::Live);
  CHECK(live.value().pulled[0].share == 1);
  CHECK(rested.value().quality == TraceQuality::Final);
  CHECK(rested.value().pulled[0].share < 1);
  const auto without = previewShape(document, document.parts[0]->recipe, used);
  CHECK(without.value().mesh == shapeOf(puffDocument(), used)->mesh);
  CHECK(without.value().pulled.empty());
}

TEST_CASE("a pull stays on a part that becomes larger, at the same place of it, and goes as far out") {
  const Document small = puffDocument(), large = puffDocument({{30, 34}, {170, 34}, {170, 118}, {30, 118}});
  for (const Document& document : {small, large}) {
    Cache cache;
    const PartShape plain = *shapeOf(document, cache), shape = *shapeOf(pulled(document, {kNose}), cache);
    testing::requireLawful(shape.mesh);
    REQUIRE(shape.pulled.size() == 1);
    const ModelPoint top = shape.pulled[0].points.at(0);
    CHECK(shape.pulled[0].share == 1);
    CHECK(top.x == doctest::Approx(100).epsilon(0.02));
    CHECK(top.y == doctest::Approx(-75).epsilon(0.02));
    double height = 0;
    for (const auto& p : plain.mesh.positions) height = std::max<double>(height, p[2]);
    CHECK(top.z == doctest::Approx(height + 15).epsilon(0.02));
    CHECK(shape.pulled[0].out.z > 0.99);
  }
}

TEST_CASE("flat pieces and shapes are pulled too, and the picture stays on them") {
  Document document = update({}, AddSketch{"Paper", {200, 150}}).value();
  document = update(document, DrawRegion{{PictureId{1}, {{{40, 40}, {160, 40}, {160, 110}, {40, 110}}}},
                                         extrude::ExtrudeParams{}})
                 .value();
  document = update(document, DrawShape{PictureId{1}}).value();
  for (const PartId part : {PartId{1}, PartId{2}}) {
    const Document changed = update(document, SetPulls{part, {kNose}}).value();
    Cache cache;
    const Result<Derived> derived = deriveWithEdges(changed, cache, Progress());
    REQUIRE(derived.ok());
    const auto& shape = derived.value().parts.at(part.value - 1).shape;
    REQUIRE(shape);
    testing::requireLawful(shape->mesh);
    CHECK(shape->pulled.size() == 1);
    CHECK(shape->mesh.uv.size() == shape->mesh.positions.size());
  }
}

TEST_CASE("a part from one line is pulled in its pose, with guessed ribs as well as with those that are found") {
  Document document = update({}, AddSketch{"Paper", {200, 150}}).value();
  document = update(document, DrawSpine{PictureId{1}, {{100, 30}, {100, 75}, {100, 120}}}).value();
  loft::Pose pose;
  pose.stroke = {{60, 30}, {80, 75}, {60, 120}};
  document = update(document, PoseSpine{PartId{1}, pose}).value();
  document = update(document, SetPulls{PartId{1}, {{{{80, -75, 20}}, 12, {}, 15, false}}}).value();
  const auto& pulls = document.parts[0]->pulls;
  Cache cache;
  const auto guessed = previewShape(document, document.parts[0]->recipe, cache, {}, {pulls});
  REQUIRE(guessed.ok());
  testing::requireLawful(guessed.value().mesh);
  const PartShape found = *shapeOf(document, cache);
  testing::requireLawful(found.mesh);
  REQUIRE(found.pulled.size() == 1);
  CHECK(found.pulled[0].points[0].x == doctest::Approx(80).epsilon(0.1));
  const auto again = previewShape(document, document.parts[0]->recipe, cache, {}, {pulls});
  CHECK(again.value().mesh == found.mesh);
}
