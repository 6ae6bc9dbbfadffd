// Reliefs in the pipeline: keys, what is kept, what waits for a worker, and parts that change under their relief.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "engine/document/update.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/derive.h"
#include "tests/support/after.h"
#include "tests/support/mesh_laws.h"

using namespace spineloft;
using namespace spineloft::pipeline;
using namespace spineloft::document;
using relief::Mode;
using relief::Relief;
using testing::after;

namespace {

/// Paper of 300 × 200 with a cross of ink, and a puff over it; and a picture that is dark to the left.
Document drawnOn() {
  const auto stroke = [](PicturePoint from, PicturePoint to) { return image::SketchStroke{{from, to}, {}, 3}; };
  const Document paper =
      after({}, {AddSketch{"Paper", {300, 200}}, DrawOnSketch{PictureId{1}, stroke({100, 100}, {200, 100})},
                 DrawOnSketch{PictureId{1}, stroke({150, 60}, {150, 140})}, AddSketch{"Emblem", {100, 100}},
                 DrawOnSketch{PictureId{2}, stroke({20, 20}, {20, 80})}});
  return after(paper,
               {DrawRegion{{PictureId{1}, {{{60, 40}, {240, 40}, {240, 160}, {60, 160}}}}, inflate::InflateParams{}}});
}
Document withRelief(const Document& document, const std::optional<Relief>& relief) {
  return after(document, {SetRelief{PartId{1}, relief}});
}
Relief ink(double height = 0.02) { return {Mode::Ink, height, 0.1, {}, {}}; }

ShapeKey keyOf(const Document& document) { return shapeKey(*document.parts[0], *document.pictures[0], document); }

std::shared_ptr<const PartShape> shapeOf(const Document& document, Cache& cache, Finish finish = Finish::Now) {
  const Derived derived = derive(document, cache, {}, finish);
  REQUIRE(derived.parts.at(0).shape != nullptr);
  return derived.parts[0].shape;
}

}  // namespace

TEST_CASE("a part has the relief that it was given, and one that is refused changes nothing") {
  const Document document = drawnOn();
  CHECK(withRelief(document, ink()).parts[0]->relief == ink());
  CHECK(withRelief(withRelief(document, ink()), std::nullopt) == document);
  CHECK(update(document, SetRelief{PartId{1}, ink(std::nan(""))}).error() == Error::ValueOutOfRange);
  CHECK(update(document, SetRelief{PartId{7}, ink()}).error() == Error::NoSuchPart);
  Relief laid = ink();
  laid.laid = relief::Laid{PictureId{9}, {150, 100}};
  CHECK(update(document, SetRelief{PartId{1}, laid}).error() == Error::NoSuchPicture);
}

TEST_CASE("ink on a sketch is cut into its puff; more ink, more grooves; without relief the part is as it was") {
  Cache cache;
  const Document document = drawnOn();
  const auto plain = shapeOf(document, cache), cut = shapeOf(withRelief(document, ink()), cache);
  testing::requireLawful(cut->mesh);
  REQUIRE(cut->relief.has_value());
  CHECK((cut->relief->mode == Mode::Ink && cut->relief->seen && cut->relief->raises && cut->relief->share == 1));
  CHECK(cut->mesh.triangles.size() > plain->mesh.triangles.size());
  const auto volume = [](const PartShape& shape) { return mesh::inspect(shape.mesh).volume; };
  CHECK(volume(*cut) < volume(*plain) - 500);
  const Document more = after(withRelief(document, ink()),
                              {DrawOnSketch{PictureId{1}, image::SketchStroke{{{90, 70}, {210, 70}}, {}, 3}}});
  CHECK(volume(*shapeOf(more, cache)) < volume(*cut) - 300);
  CHECK(shapeOf(withRelief(more, std::nullopt), cache)->mesh == plain->mesh);
  CHECK(cut->textureKey != plain->textureKey);
}

TEST_CASE("every number of a relief is part of the key, and so is the picture that gives it") {
  const Document document = drawnOn();
  Relief laid = ink();
  laid.laid = relief::Laid{PictureId{2}, {150, 100}, 60, 0.5};
  std::vector<Relief> all{ink(), ink(0.03), laid};
  const auto add = [&](const auto& change) {
    Relief other = laid;
    change(other);
    all.push_back(other);
  };
  add([](Relief& relief) { relief.mode = Mode::Bright; });
  add([](Relief& relief) { relief.smooth = 0.5; });
  add([](Relief& relief) { relief.region = {{{70, 60}, {200, 60}, {200, 150}}}; });
  add([](Relief& relief) { relief.laid->at.x = 140; });
  add([](Relief& relief) { relief.laid->at.y = 90; });
  add([](Relief& relief) { relief.laid->width = 61; });
  add([](Relief& relief) { relief.laid->turn = -0.5; });
  add([](Relief& relief) { relief.laid->picture = PictureId{1}; });
  std::vector<ShapeKey> keys{keyOf(document)};
  for (const Relief& relief : all) {
    keys.push_back(keyOf(withRelief(document, relief)));
    Cache used, anew;
    shapeOf(withRelief(document, ink()), used);
    CHECK(shapeOf(withRelief(document, relief), used)->mesh == shapeOf(withRelief(document, relief), anew)->mesh);
  }
  for (std::size_t i = 0; i < keys.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) CHECK(keys[i] != keys[k]);
  }
  const Document more =
      after(withRelief(document, laid), {DrawOnSketch{PictureId{2}, image::SketchStroke{{{80, 20}, {80, 80}}, {}, 3}}});
  CHECK(keyOf(more) != keyOf(withRelief(document, laid)));
}

namespace {

/// Does all that is wanted, as a worker would.
void work(const Document& document, const Derived& derived, Cache& cache) {
  for (const PartId id : derived.wantedReliefs) {
    const auto job = makeRelief(document, derived, id);
    REQUIRE(job != nullptr);
    while (job->step()) {
    }
    CHECK(job->keepIn(cache));
  }
}

}  // namespace

TEST_CASE("where the page derives a relief is left to a worker, and then as if found at once") {
  for (const Mode mode : {Mode::Ink, Mode::Bright, Mode::Shade}) {
    CAPTURE(static_cast<int>(mode));
    const Document document = withRelief(drawnOn(), Relief{mode, 0.02, 0.1, {}, {}});
    Cache now, later;
    const auto whole = shapeOf(document, now);
    REQUIRE(whole->relief.has_value());
    // Of a drawing light explains next to nothing.
    CHECK(whole->relief->mode == (mode == Mode::Shade ? Mode::Ink : mode));
    CHECK(whole->relief->explained < 0.2);
    CHECK(derive(drawnOn(), later, {}, Finish::Later).wantedReliefs.empty());  // known without it
    const Derived waiting = derive(document, later, {}, Finish::Later);
    CHECK(waiting.wantedReliefs == std::vector{PartId{1}});
    CHECK_FALSE(waiting.parts[0].shape->relief.has_value());
    CHECK(waiting.parts[0].shape->mesh == shapeOf(drawnOn(), later, Finish::Later)->mesh);
    CHECK(derive(document, later, {}, Finish::Later).parts[0].shape == waiting.parts[0].shape);
    CHECK(derive(drawnOn(), later, {}, Finish::Later).wantedReliefs.empty());
    work(document, waiting, later);
    const Derived made = derive(document, later, {}, Finish::Later);
    CHECK(made.wantedReliefs.empty());
    CHECK(made.parts[0].shape->mesh == whole->mesh);
    CHECK(*made.parts[0].shape->smooth == waiting.parts[0].shape->mesh);
    CHECK(makeRelief(document, made, PartId{1}) == nullptr);
    CHECK(makeRelief(document, waiting, PartId{7}) == nullptr);
    // Another smoothness needs no other search, but a mesh.
    Document smoother = document;
    smoother = withRelief(document, Relief{mode, 0.02, 0.6, {}, {}});
    const Derived next = derive(smoother, later, {}, Finish::Later);
    REQUIRE(next.parts[0].wantedRelief.has_value());
    CHECK(next.parts[0].wantedRelief->known != nullptr);
    work(smoother, next, later);
    CHECK(derive(smoother, later, {}, Finish::Later).parts[0].shape->mesh == shapeOf(smoother, now)->mesh);
  }
}

TEST_CASE("under a moving hand a relief is coarser; while the part itself changes it shows itself without") {
  const Document document = withRelief(drawnOn(), ink());
  const Recipe& recipe = document.parts[0]->recipe;
  Cache cache;
  const Relief higher = ink(0.04);
  const auto plain = previewShape(document, recipe, cache);
  const auto first = liveShape(document, recipe, cache, {}, {{}, &higher});
  CHECK(first.value().mesh == plain.value().mesh);
  CHECK(first.value().quality == TraceQuality::Live);
  const auto live = liveShape(document, recipe, cache, {}, {{}, &higher});
  testing::requireLawful(live.value().mesh);
  CHECK(live.value().relief->raises);
  // What the hand leaves behind is not taken for the part.
  Cache anew;
  CHECK(shapeOf(withRelief(document, higher), cache)->mesh == shapeOf(withRelief(document, higher), anew)->mesh);
  // What is known already is shown whole.
  const Relief lower = ink(0.01);
  CHECK(liveShape(document, recipe, cache, {}, {{}, &lower}).value().mesh ==
        shapeOf(withRelief(document, lower), anew)->mesh);
}

TEST_CASE("a shape that was one with a relief and becomes another part keeps nothing of it") {
  const Document document = withRelief(drawnOn(), ink());
  LoftRecipe recipe;
  recipe.picture = PictureId{1};
  for (double x = 60; x <= 240; x += 6) recipe.stroke.push_back({x, 100});
  Cache cache;
  PartShape shape;
  for (int i = 0; i < 2; ++i) {
    const Worked worked{{}, &*document.parts[0]->relief};
    REQUIRE(liveShape(document, document.parts[0]->recipe, cache, shape, {}, worked).ok());
  }
  REQUIRE(shape.smooth != nullptr);
  REQUIRE(liveShape(document, recipe, cache, shape).ok());
  CHECK(shape.smooth == nullptr);
  CHECK_FALSE(shape.relief.has_value());
  CHECK(&smoothMesh(shape) == &shape.mesh);
}

TEST_CASE("a pull that is held back is not taken whole because a hand moved a relief over it") {
  // A dent through the part, and out again on the other side.
  const pull::Pull through{{{150, -100, 60}}, -300, {}, 30, false};
  const Document document = after(withRelief(drawnOn(), ink()), {SetPulls{PartId{1}, {through}}});
  Cache used, anew;
  const auto exact = shapeOf(document, anew);
  REQUIRE(exact->pulled.at(0).share < 1);
  const Relief rougher = ink(0.03);
  const Relief smoother{Mode::Ink, 0.02, 0.7, {}, {}};
  shapeOf(document, used);
  for (const Relief& relief : {rougher, smoother}) {
    for (int i = 0; i < 2; ++i) {
      REQUIRE(liveShape(document, document.parts[0]->recipe, used, {}, {document.parts[0]->pulls, &relief}).ok());
    }
    const Document changed = withRelief(document, relief);
    CHECK(shapeOf(changed, used)->mesh == shapeOf(changed, anew)->mesh);
    CHECK_FALSE(mesh::selfCrossing(shapeOf(changed, used)->mesh));
  }
}

TEST_CASE("a relief comes after pulls, and follows them") {
  const Document document = withRelief(drawnOn(), ink());
  const pull::Pull nose{{{150, -100, 60}}, 20, {}, 30, false};
  Cache cache;
  const auto pulled = shapeOf(after(drawnOn(), {SetPulls{PartId{1}, {nose}}}), cache);
  const auto both = shapeOf(after(document, {SetPulls{PartId{1}, {nose}}}), cache);
  testing::requireLawful(both->mesh);
  REQUIRE(both->relief.has_value());
  CHECK(both->relief->raises);
  CHECK(*both->smooth == pulled->mesh);
  CHECK(both->mesh != pulled->mesh);
  CHECK_FALSE(mesh::selfCrossing(both->mesh));
  const auto top = [](const PartShape& shape) { return mesh::boundsOf(shape.mesh).high[2]; };
  CHECK(top(*both) > top(*shapeOf(document, cache)) + 10);
  CHECK(top(*both) <= top(*pulled) + 1e-3);
}

TEST_CASE("a loft in a pose has the relief that it has at rest, as much larger as the pose") {
  const auto dot = [](double x) { return image::SketchStroke{{{x, 100}}, {}, 5}; };
  const Document paper = after({}, {AddSketch{"Paper", {300, 200}}, DrawOnSketch{PictureId{1}, dot(110)},
                                    DrawOnSketch{PictureId{1}, dot(150)}, DrawOnSketch{PictureId{1}, dot(190)}});
  std::vector<PicturePoint> stroke, longer;
  for (double x = 60; x <= 240; x += 6) stroke.push_back({x, 100});
  const Document drawn = withRelief(after(paper, {DrawSpine{PictureId{1}, stroke}}), ink(0.03));
  Cache cache;
  const auto volumeOut = [&](const Document& document) {
    const Result<Derived> derived = deriveWithEdges(document, cache, Progress());
    const auto shape = derived.value().parts.at(0).shape;
    REQUIRE(shape != nullptr);
    REQUIRE(shape->relief->raises);
    CHECK(shape->relief->share == 1);
    testing::requireLawful(shape->mesh);
    return mesh::inspect(*shape->smooth).volume - mesh::inspect(shape->mesh).volume;
  };
  const double rest = volumeOut(drawn);
  CHECK(rest > 0);
  for (const double scale : {0.5, 2.0, 3.0}) {
    CAPTURE(scale);
    loft::Pose pose;
    for (double x = 60; x <= 240; x += 6) pose.stroke.push_back({x * scale, 100});
    const Document posed = after(drawn, {PoseSpine{PartId{1}, pose}});
    CHECK(volumeOut(posed) == doctest::Approx(rest * scale * scale * scale).epsilon(0.1));
  }
}

TEST_CASE("of a cup the wall that is seen is cut, not the one behind it, and not through") {
  const Document paper = after({}, {AddSketch{"Paper", {300, 300}},
                                    DrawOnSketch{PictureId{1}, image::SketchStroke{{{90, 150}, {210, 150}}, {}, 6}}});
  lathe::LatheParams params;
  params.axisFrom = {150, 60};
  params.axisTo = {150, 240};
  const Region profile{PictureId{1}, {{{150, 228}, {210, 228}, {210, 70}, {200, 70}, {200, 218}, {150, 218}}}};
  const Document cup = after(paper, {DrawRegion{profile, params}});
  Cache cache;
  const auto cut = shapeOf(withRelief(cup, ink(0.1)), cache);
  testing::requireLawful(cut->mesh);
  CHECK(cut->relief->raises);
  CHECK(cut->relief->share == 1);
  // Within, where the far wall is, all is as it was.
  const auto lowest = [](const mesh::TriMesh& mesh) {
    double least = 1e9;
    for (const auto& p : mesh.positions) least = std::min(least, std::hypot(p[0] - 150.0, static_cast<double>(p[2])));
    return least;
  };
  double moved = 0;
  for (const auto& p : cut->mesh.positions) {
    const double radius = std::hypot(p[0] - 150.0, static_cast<double>(p[2]));
    if (p[1] < -80 && p[1] > -210 && p[2] > 10) moved = std::max(moved, 60 - radius);
    if (p[1] < -80 && p[1] > -210 && p[2] < -10) CHECK((radius > 49.5 || radius < 1));
  }
  CHECK(moved > 3);
  CHECK(moved < 10.5);
  CHECK(lowest(cut->mesh) == doctest::Approx(lowest(*cut->smooth)));
}

TEST_CASE("what lies on a part that is moved as a whole in its picture goes along") {
  Relief relief = ink();
  relief.region = {{{100, 60}, {200, 60}, {150, 140}}};
  relief.laid = relief::Laid{PictureId{2}, {150, 100}};
  const Document document = withRelief(drawnOn(), relief);
  Region moved{PictureId{1}, {{{70, 45}, {250, 45}, {250, 165}, {70, 165}}}};
  const Document changed = after(document, {RedrawRegion{PartId{1}, moved}});
  CHECK(changed.parts[0]->relief->laid->at == PicturePoint{160, 105});
  CHECK(changed.parts[0]->relief->region[0][0] == PicturePoint{110, 65});
}

TEST_CASE("a picture that is taken away takes the relief that it gave along") {
  Relief relief = ink();
  relief.laid = relief::Laid{PictureId{2}, {150, 100}};
  const Document document = withRelief(drawnOn(), relief);
  CHECK_FALSE(after(document, {RemovePicture{PictureId{2}}}).parts[0]->relief.has_value());
  CHECK(after(withRelief(document, ink()), {RemovePicture{PictureId{2}}}).parts[0]->relief.has_value());
}

TEST_CASE("a bridge stands on the surface below a relief") {
  const image::SketchStroke across{{{190, 100}, {238, 100}}, {}, 3};  // over the rim
  const Document document =
      after(drawnOn(),
            {DrawOnSketch{PictureId{1}, across},
             DrawRegion{{PictureId{1}, {{{250, 60}, {290, 60}, {290, 140}, {250, 140}}}}, inflate::InflateParams{}}});
  const auto ring = [](double x) {
    std::vector<ModelPoint> rim;
    for (int i = 0; i < 12; ++i) rim.push_back({x, -100 + 12 * std::cos(i * 0.5236), 12 * std::sin(i * 0.5236)});
    return rim;
  };
  const Document bridged = after(document, {DrawBridge{{PartId{1}, ring(232)}, {PartId{2}, ring(256)}, {}, {}}});
  Cache with, without;
  const Derived smooth = derive(bridged, without), raised = derive(withRelief(bridged, ink()), with);
  REQUIRE(smooth.parts[2].shape != nullptr);
  REQUIRE(raised.parts[2].shape != nullptr);
  CHECK(raised.parts[2].shape->mesh == smooth.parts[2].shape->mesh);
  CHECK(shapeKey(*bridged.parts[2], *bridged.pictures[0], bridged) ==
        shapeKey(*bridged.parts[2], *bridged.pictures[0], withRelief(bridged, ink())));
}
