#include <doctest/doctest.h>

#include <algorithm>

#include "engine/document/update.h"
#include "engine/inflate/inflate.h"
#include "engine/inflate/interior.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/derive.h"
#include "engine/shape/shape.h"
#include "engine/stack/stack.h"
#include "engine/vision/edges.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/random_documents.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::document;
using namespace spineloft::pipeline;
using spineloft::testing::ellipsePicture;

namespace {

Document ellipseDocument() {
  Document document = update({}, AddPicture{"e", ellipsePicture(192, 144)}).value();
  return update(document, DrawSpine{PictureId{1}, {{40, 72}, {96, 72}, {150, 72}}}).value();
}

}  // namespace

TEST_CASE("a part waits for the edges of its picture and appears when they are kept") {
  const Document document = ellipseDocument();
  Cache cache;
  Derived derived = derive(document, cache);
  REQUIRE(derived.parts.size() == 1);
  CHECK(derived.parts[0].waiting);
  CHECK(derived.parts[0].shape == nullptr);
  REQUIRE(derived.wantedEdges == std::vector{PictureId{1}});
  const PictureEntry& entry = document.pictures[0];
  auto edges = vision::detectEdges(*entry.picture, {}, {});
  REQUIRE(edges.ok());
  cache.keepEdges(entry.contentHash, std::make_shared<image::EdgeMap>(std::move(edges).value()));
  derived = derive(document, cache);
  CHECK(derived.wantedEdges.empty());
  CHECK_FALSE(derived.parts[0].waiting);
  REQUIRE(derived.parts[0].shape != nullptr);
  CHECK(mesh::inspect(derived.parts[0].shape->mesh).valid());
}

TEST_CASE("deriving again costs no new shape, and an undone change finds its old one") {
  const Document document = ellipseDocument();
  Cache cache;
  const auto first = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  CHECK(derive(document, cache).parts[0].shape == first);
  const Document changed = update(document, SetSection{PartId{1}, sections::SectionPreset::Square}).value();
  const auto second = derive(changed, cache).parts[0].shape;
  CHECK(second != first);
  CHECK(second->ribs == first->ribs);
  CHECK(derive(document, cache).parts[0].shape == first);
}

TEST_CASE("a look, a name or a height changes no shape") {
  const Document document = ellipseDocument();
  Cache cache;
  const auto shape = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  Document other = update(document, SetLook{PartId{1}, {false, {9, 9, 9}}}).value();
  other = update(other, RenamePart{PartId{1}, "Nose"}).value();
  other = update(other, SetHeight{{55}}).value();
  CHECK(derive(other, cache).parts[0].shape == shape);
}

TEST_CASE("dropping every cache changes nothing that is seen" * doctest::test_suite("slow")) {
  for (const std::uint64_t seed : testing::seeds(0, 12)) {
    Rng rng(seed);
    Document document;
    for (int step = 0; step < 25; ++step) {
      if (auto next = update(document, testing::randomAction(rng, document))) {
        document = std::move(next).value();
      }
    }
    Cache warm;
    const Derived first = deriveWithEdges(document, warm, {}).value();
    warm.clear();
    const Derived again = deriveWithEdges(document, warm, {}).value();
    REQUIRE(first.parts.size() == again.parts.size());
    for (std::size_t i = 0; i < first.parts.size(); ++i) {
      REQUIRE((first.parts[i].shape == nullptr) == (again.parts[i].shape == nullptr));
      REQUIRE(first.parts[i].failure == again.parts[i].failure);
      if (!first.parts[i].shape) continue;
      CHECK(first.parts[i].shape->ribs == again.parts[i].shape->ribs);
      CHECK(first.parts[i].shape->mesh == again.parts[i].shape->mesh);
      CHECK(mesh::inspect(first.parts[i].shape->mesh).valid());
    }
  }
}

TEST_CASE("every authored value of a recipe and its picture is part of the shape's key") {
  const Document document = ellipseDocument();
  const LoftRecipe recipe = *document::loftOf(*document.parts[0]);
  const PictureEntry entry = document.pictures[0];
  const ShapeKey key = shapeKey(recipe, entry);
  CHECK(shapeKey(recipe, entry) == key);
  PictureEntry elsewhere = entry;
  elsewhere.contentHash ^= 1;
  CHECK(shapeKey(recipe, elsewhere) != key);
  elsewhere = entry;
  elsewhere.ignored = {{{{1, 2}}, 3}};
  CHECK(shapeKey(recipe, elsewhere) != key);
  const auto changes = [&](void (*change)(LoftRecipe&)) {
    LoftRecipe other = recipe;
    change(other);
    return shapeKey(other, entry) != key;
  };
  CHECK(changes([](LoftRecipe& r) { r.stroke[1].y += 1e-9; }));
  CHECK(changes([](LoftRecipe& r) { r.ribs.levels = 64; }));
  CHECK(changes([](LoftRecipe& r) { r.spine.ribs = 50; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.endCap = sections::CapStyle::Open; }));
  CHECK(changes([](LoftRecipe& r) { r.edits.ends.push_back({}); }));
  CHECK(changes([](LoftRecipe& r) { r.edits.added.push_back(0.5); }));
  CHECK(changes([](LoftRecipe& r) { r.ignored.push_back({{{1, 2}}, 3}); }));
  CHECK(changes([](LoftRecipe& r) { r.pose.depth.points = {{0, 1}}; }));
  CHECK(changes([](LoftRecipe& r) { r.pose.closed = true; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.twist.points = {{0, 1}}; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.squash.points = {{0, 1}}; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.sections[0].blend.kind = sections::BlendKind::Root; }));
  CHECK(changes([](LoftRecipe& r) { r.loft.sections[0].shape.contours = {{{1, 0}}}; }));
}

TEST_CASE("the key of a shape follows everything that it is made of, and its shape comes from its outlines and views") {
  const Outline front{PictureId{1}, {{{96, 20}, {140, 80}, {96, 130}, {50, 80}}}};
  const Outline seen{PictureId{2}, {{{96, 20}, {120, 80}, {96, 130}, {70, 80}}}};
  const PictureView right{PictureId{1}, {geometry::ViewFrom::Right, 96, 1, 0}};
  const auto with = [&](const PictureView& view, const ShapeRecipe& recipe) {
    Document document = update(ellipseDocument(), AddSketch{"side", {192, 144}}).value();
    document = update(document, SetView{PictureId{2}, view}).value();
    return update(document, DrawShape{recipe.picture, recipe.shape, recipe.outlines}).value();
  };
  const auto keyOf = [](const Document& document) {
    return shapeKey(*document.parts.back(), *document.pictures.front(), document);
  };
  const ShapeRecipe recipe{PictureId{1}, {}, {front, seen}};
  const Document document = with(right, recipe);
  const ShapeKey key = keyOf(document);
  CHECK(keyOf(with(right, recipe)) == key);
  const auto changes = [&](void (*change)(ShapeRecipe&)) {
    ShapeRecipe other = recipe;
    change(other);
    return keyOf(with(right, other)) != key;
  };
  CHECK(changes([](ShapeRecipe& r) { r.shape.primitive = shape::Primitive::Box; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.axis.to.x += 1; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.width += 1; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.depth.mode = shape::DepthMode::Kept; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.depth.ratio = 2; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.section = sections::SectionPreset::Star; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.caps.start = sections::CapStyle::Round; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.caps.end = sections::CapStyle::Round; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.levels = 32; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.sides = 32; }));
  CHECK(changes([](ShapeRecipe& r) { r.shape.capRings = 3; }));
  CHECK(changes([](ShapeRecipe& r) { r.outlines.pop_back(); }));
  CHECK(changes([](ShapeRecipe& r) { r.outlines[1].lines[0][1].x += 1e-9; }));
  for (double geometry::View::* member : {&geometry::View::middle, &geometry::View::scale, &geometry::View::shift}) {
    PictureView other = right;
    other.view.*member += 0.5;
    CHECK(keyOf(with(other, recipe)) != key);
  }
  PictureView left = right;
  left.view.from = geometry::ViewFrom::Left;
  CHECK(keyOf(with(left, recipe)) != key);

  Cache cache;
  const auto derived = deriveWithEdges(document, cache, Progress());
  REQUIRE(derived.ok());
  const auto& shaped = derived.value().parts.back().shape;
  REQUIRE(shaped != nullptr);
  testing::requireLawful(shaped->mesh);
  const std::vector<shape::SeenOutline> outlines{{std::nullopt, front.lines}, {right.view, seen.lines}};
  CHECK(shaped->mesh == shape::makeShape({}, outlines, {192, 144}).value().mesh);
}

TEST_CASE("the side of a puff is part of its key, and removing it gives the same mesh again") {
  Document document = update(ellipseDocument(), AddSketch{"side", {192, 144}}).value();
  document =
      update(document, SetView{PictureId{2}, PictureView{PictureId{1}, {geometry::ViewFrom::Right, 96, 1, 0}}}).value();
  const Region region{PictureId{1}, {{{96, 20}, {140, 80}, {96, 130}, {50, 80}}}};
  document = update(document, DrawRegion{region, inflate::InflateParams{}}).value();
  const PartId id = document.parts.back()->id;
  const Outline drawn{PictureId{2}, {{{96, 20}, {106, 80}, {96, 130}, {66, 80}}}};
  const Document sided = update(document, SetSide{id, drawn}).value();
  const auto keyOf = [](const Document& d) { return shapeKey(*d.parts.back(), *d.pictures.front(), d); };
  CHECK(keyOf(sided) != keyOf(document));
  CHECK(keyOf(update(sided, SetSide{id, std::nullopt}).value()) == keyOf(document));
  Outline other = drawn;
  other.lines[0][1].x += 1e-9;
  CHECK(keyOf(update(sided, SetSide{id, other}).value()) != keyOf(sided));
  const PictureView left{PictureId{1}, {geometry::ViewFrom::Left, 96, 1, 0}};
  CHECK(keyOf(update(sided, SetView{PictureId{2}, left}).value()) != keyOf(sided));

  const auto made = [](const Document& d) {
    Cache cache;
    const auto derived = deriveWithEdges(d, cache, Progress());
    REQUIRE(derived.ok());
    const auto& shape = derived.value().parts.back().shape;
    REQUIRE(shape != nullptr);
    testing::requireLawful(shape->mesh);
    return shape->mesh;
  };
  const mesh::TriMesh plain = made(document), deep = made(sided);
  CHECK_FALSE(deep == plain);
  CHECK(made(update(sided, SetSide{id, std::nullopt}).value()) == plain);
  CHECK(mesh::boundsOf(deep).high[2] == doctest::Approx(30).epsilon(0.02));
  CHECK(mesh::boundsOf(deep).low[2] == doctest::Approx(-10).epsilon(0.02));
  // An outline of another height leaves a part without a shape, and says why.
  Outline tall = drawn;
  tall.lines[0][2].y = 142;
  tall.lines[0][0].y = 0;
  Cache cache;
  const auto failed = deriveWithEdges(update(sided, SetSide{id, tall}).value(), cache, Progress());
  REQUIRE(failed.ok());
  REQUIRE(failed.value().parts.back().failure);
  CHECK(failed.value().parts.back().failure->error == Error::ShapeInvalid);
}

TEST_CASE("the key of a stack follows everything that it is made of, and its shape comes from the planes alone") {
  stack::Plane foot;
  foot.curves = {{{{20, 0}, {0, 20}, {-20, 0}, {0, -20}}, {}}};
  stack::Plane top = foot;
  top.at = 1;
  const StackRecipe recipe{PictureId{1}, {foot, top}, {{{96, -120, 0}, {96, -20, 0}}, false}, {}};
  const Document document = update(ellipseDocument(), DrawStack{PictureId{1}, recipe.planes, recipe.rail}).value();
  const PictureEntry& entry = document.pictures[0];
  const ShapeKey key = shapeKey(recipe, entry);
  CHECK(shapeKey(document.parts.back()->recipe, entry, document) == key);
  const auto changes = [&](void (*change)(StackRecipe&)) {
    StackRecipe other = recipe;
    change(other);
    return shapeKey(other, entry) != key;
  };
  CHECK(changes([](StackRecipe& r) { r.planes.pop_back(); }));
  CHECK(changes([](StackRecipe& r) { r.planes[0].at = 0.1; }));
  CHECK(changes([](StackRecipe& r) { r.planes[0].origin = ModelPoint{}; }));
  CHECK(changes([](StackRecipe& r) { r.planes[0].turn = {0, 1, 0, 0}; }));
  CHECK(changes([](StackRecipe& r) { r.planes[0].blend.kind = sections::BlendKind::Linear; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].through[2].y += 1e-9; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].corners.all = true; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].corners.at = {1}; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].open = true; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].as = stack::CurveUse::Ground; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].width = 1; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].base = 1; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].forkAt = 0; }));
  CHECK(changes([](StackRecipe& r) { r.planes[1].curves[0].joinAt = 0; }));
  CHECK(changes([](StackRecipe& r) { r.planes[0].links = {{0, 0, true}}; }));
  CHECK(changes([](StackRecipe& r) { r.stack.patterns = {{0, 0, 1, 0}}; }));
  CHECK(changes([](StackRecipe& r) { r.stack.melt = 1; }));
  CHECK(changes([](StackRecipe& r) { r.stack.rough.amount = 1; }));
  CHECK(changes([](StackRecipe& r) { r.stack.rough.size = 1; }));
  CHECK(changes([](StackRecipe& r) { r.stack.rough.seed = 1; }));
  CHECK(changes([](StackRecipe& r) { r.stack.rough.keepDrawn = true; }));
  CHECK(changes([](StackRecipe& r) { r.rail.closed = true; }));
  CHECK(changes([](StackRecipe& r) { r.rail.points[1].z = 1; }));
  CHECK(changes([](StackRecipe& r) { r.stack.startCap = sections::CapStyle::Round; }));
  CHECK(changes([](StackRecipe& r) { r.stack.endCap = sections::CapStyle::Round; }));
  CHECK(changes([](StackRecipe& r) { r.stack.sides = 64; }));
  CHECK(changes([](StackRecipe& r) { r.stack.capRings = 5; }));
  CHECK_FALSE(changes([](StackRecipe& r) { r.picture = PictureId{9}; }));
  Cache cache;  // which knows no edges
  const auto shape = derive(document, cache).parts.back().shape;
  REQUIRE(shape);
  CHECK(shape->mesh == stack::stackPlanes({recipe.planes, recipe.rail, recipe.stack}, entry.size).value().mesh);
}

TEST_CASE("under a hand a fork is sharp and has fewer points, and is round when the hand rests") {
  StackRecipe recipe{PictureId{1}, {}, {{{96, -120, 0}, {96, -20, 0}}, false}, {}};
  recipe.planes.resize(2);
  recipe.planes[0].curves = {{{{20, 0}, {0, 20}, {-20, 0}, {0, -20}}, {}}};
  recipe.planes[1].at = 1;
  for (const double x : {-30.0, 30.0}) {
    recipe.planes[1].curves.push_back({{{x + 15, 0}, {x, 15}, {x - 15, 0}, {x, -15}}, {}});
  }
  StackRecipe melted = recipe;
  melted.stack.melt = 0.5;
  const Document document = ellipseDocument();
  Cache cache;
  const auto live = liveShape(document, melted, cache), rested = previewShape(document, melted, cache);
  REQUIRE(live.ok());
  REQUIRE(rested.ok());
  CHECK(live.value().mesh == liveShape(document, recipe, cache).value().mesh);
  CHECK(2 * live.value().mesh.triangles.size() < previewShape(document, recipe, cache).value().mesh.triangles.size());
  CHECK(live.value().quality == TraceQuality::Live);  // a better one is to come
  CHECK(rested.value().quality == TraceQuality::Final);
  CHECK(rested.value().mesh.triangles.size() > live.value().mesh.triangles.size());
  StackRecipe coarse = recipe;
  coarse.stack.sides = 24;
  CHECK(liveShape(document, coarse, cache).value().quality == TraceQuality::Final);  // nothing waits
}

TEST_CASE("while the slice of a puff is dragged its skeleton and fields are those that are known") {
  Document document = ellipseDocument();
  const Region region{PictureId{1}, {{{40, 40}, {150, 40}, {150, 100}, {40, 100}}}, 0};
  InflateRecipe puff{region, {}, {}};
  puff.inflate.points = 2500;
  sections::SectionShape slice;
  slice.contours = {{{-1, 0}, {0, -0.6}, {1, 0}, {0, 0.6}}};
  puff.inflate.profile.slices = {{slice}, {slice, PicturePoint{60, 70}}};
  const PictureEntry& entry = document.pictures[0];
  const InteriorKey key = interiorKey(puff, entry);
  const auto changes = [&](void (*change)(InflateRecipe&)) {
    InflateRecipe other = puff;
    change(other);
    return interiorKey(other, entry) != key;
  };
  CHECK_FALSE(changes([](InflateRecipe& r) { r.inflate.profile.slices[0].shape.contours[0][1].y = -0.3; }));
  CHECK_FALSE(changes([](InflateRecipe& r) { r.inflate.profile.slices[1].shape = sections::SectionPreset::Circle; }));
  CHECK_FALSE(changes([](InflateRecipe& r) { r.inflate.profile.follow = 0; }));
  CHECK_FALSE(changes([](InflateRecipe& r) { r.inflate.height = 2; }));
  CHECK_FALSE(changes([](InflateRecipe& r) { r.inflate.sides = inflate::InflateSides::Front; }));
  CHECK_FALSE(changes([](InflateRecipe& r) { r.inflate.points = 4000; }));
  CHECK(changes([](InflateRecipe& r) { r.inflate.points = 900; }));
  CHECK(changes([](InflateRecipe& r) { r.inflate.profile.slices[1].at->x += 1; }));
  CHECK(changes([](InflateRecipe& r) { r.inflate.profile.slices.pop_back(); }));
  CHECK(changes([](InflateRecipe& r) { r.inflate.bones.detail = 0.7; }));
  CHECK(changes([](InflateRecipe& r) { r.inflate.bones.heights = {{{60, 70}, 2}}; }));
  CHECK(changes([](InflateRecipe& r) { r.region.contours[0][0].x += 1; }));
  Cache cache;
  REQUIRE(previewShape(document, puff, cache).ok());
  const KnownInterior known = cache.interior(key);
  REQUIRE(known);
  puff.inflate.profile.slices[0].shape.contours[0][1].y = -0.3;
  const auto dragged = previewShape(document, puff, cache);
  REQUIRE(dragged.ok());
  CHECK(cache.interior(key) == known);
  CHECK(dragged.value().mesh == inflate::inflateAlong(*known, entry.size, puff.inflate).value());
  CHECK(dragged.value().bones.size() == 1);
}

namespace {

// Makes the evidence of every picture vanish, so that only ribs traced before can stand on edges.
void forgetEdges(Cache& cache, const Document& document) {
  for (const PictureEntry& entry : document.pictures)
    cache.keepEdges(entry.contentHash, std::make_shared<const image::EdgeMap>());
}

}  // namespace

TEST_CASE("edits, slices, ends and pose use the ribs that were traced; stroke and marks do not") {
  const Document document = ellipseDocument();
  Cache cache;
  const auto first = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  forgetEdges(cache, document);
  const auto reuses = [&](const Action& action) {
    const Document changed = update(document, action).value();
    return derive(changed, cache).parts.at(0).shape->generated == first->generated;
  };
  const ribs::RibEdits edits{{{.at = 0.5, .out = 50, .reach = 0.1}}, {}, {0.2}};
  CHECK(reuses(EditRibs{PartId{1}, edits}));
  CHECK(reuses(SetSection{PartId{1}, sections::SectionPreset::Square}));
  CHECK(reuses(SetCaps{PartId{1}, sections::CapStyle::Flat, sections::CapStyle::Open}));
  loft::Pose pose;
  pose.coilTurns = 2;
  pose.coilRadius = 30;
  CHECK(reuses(PoseSpine{PartId{1}, pose}));
  CHECK_FALSE(reuses(RedrawSpine{PartId{1}, {{40, 70}, {96, 74}, {150, 72}}}));
  CHECK_FALSE(reuses(IgnoreForPart{PartId{1}, {{{{10, 10}}, 4}}}));
  CHECK_FALSE(reuses(IgnoreForPicture{PictureId{1}, {{{{10, 10}}, 4}}}));
}

TEST_CASE("marks of the picture and of the part reach the ribs alike, and are kept within a budget" *
          doctest::test_suite("slow")) {
  const Document document = ellipseDocument();
  Cache cache;
  const auto plain = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  const std::vector<ribs::IgnoreMark> marks{{{{96, 20}, {96, 60}}, 40}};
  const auto shapeWith = [&](const Action& action) {
    return derive(update(document, action).value(), cache).parts.at(0).shape;
  };
  const auto ofPart = shapeWith(IgnoreForPart{PartId{1}, marks});
  const auto ofPicture = shapeWith(IgnoreForPicture{PictureId{1}, marks});
  CHECK(ofPart->generated == ofPicture->generated);
  CHECK_FALSE(ofPart->generated == plain->generated);
  const std::vector<ribs::IgnoreMark> far{{{{-900, -900}}, 3}};
  CHECK(shapeWith(IgnoreForPart{PartId{1}, far})->generated == plain->generated);
  LoftRecipe recipe = *document::loftOf(*document.parts[0]);
  recipe.spine.ribs = 20;
  recipe.ribs.levels = 16;
  const std::size_t before = cache.bytes();
  for (int i = 0; i < 200; ++i) {
    recipe.ignored = {{{{20.0, 10.0 + 0.1 * i}}, 5}};
    REQUIRE(previewShape(document, recipe, cache).ok());
  }
  CHECK(cache.bytes() <= before + Cache::kPreviewBytes + Cache::kIgnoredBytes);
}

TEST_CASE("edited ribs lie over the generated ones, and both are there to be seen") {
  Document document = ellipseDocument();
  const ribs::RibEdits edits{{{.at = 0.5, .out = 60, .reach = 0.1, .locked = true}}, {0.33}, {}};
  document = update(document, EditRibs{PartId{1}, edits}).value();
  Cache cache;
  const auto shape = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  CHECK(shape->ribs == ribs::applyEdits(shape->spine, shape->generated, edits));
  CHECK(shape->ribs.ribs.size() == shape->generated.ribs.size() + 1);
  CHECK(std::ranges::count(shape->ribs.ribs, ribs::RibState::Locked, &ribs::Rib::leftState) == 1);
  testing::requireLawful(shape->mesh);
}

TEST_CASE("a preview is what the part becomes, and is traced only once") {
  const Document document = ellipseDocument();
  Cache cache;
  deriveWithEdges(document, cache, {}).value();
  const DrawSpine drawn{PictureId{1}, {{40, 70}, {96, 75}, {150, 72}}};
  const Document next = update(document, drawn).value();
  const LoftRecipe& recipe = *document::loftOf(*next.parts[1]);
  const auto preview = previewShape(document, recipe, cache);
  REQUIRE(preview.ok());
  CHECK(preview.value().quality == TraceQuality::Final);
  // Ribs that are known need no edges.
  forgetEdges(cache, document);
  const Derived later = derive(next, cache, {}, Finish::Later);
  REQUIRE(later.parts[1].shape);
  CHECK(later.parts[1].shape->ribs == preview.value().ribs);
  CHECK(later.parts[1].shape->mesh == preview.value().mesh);
  CHECK_FALSE(later.parts[1].waiting);
  testing::requireLawful(later.parts[1].shape->mesh);
  Cache anew;
  const auto whole = deriveWithEdges(next, anew, {}).value().parts[1].shape;
  CHECK(whole->ribs == preview.value().ribs);
  CHECK(whole->key == later.parts[1].shape->key);
}

TEST_CASE("what was traced to see whether a stroke runs past its thing is not traced again") {
  const Document document = ellipseDocument();
  const LoftRecipe& recipe = *document::loftOf(*document.parts[0]);
  Cache cache, fresh;
  const auto expected = deriveWithEdges(document, fresh, {}).value().parts[0].shape;
  cache.keepEdges(document.pictures[0]->contentHash, fresh.edges(document.pictures[0]->contentHash));
  REQUIRE(strokeOnThing(document, recipe, cache) == recipe.stroke);
  forgetEdges(cache, document);
  const auto shape = derive(document, cache).parts[0].shape;
  REQUIRE(shape != nullptr);
  CHECK(shape->spine == expected->spine);
  CHECK(shape->ribs == expected->ribs);
}

TEST_CASE("what a stroke showed under the pen is not what is kept of it") {
  const Document document = ellipseDocument();
  Cache cache, other;
  deriveWithEdges(document, cache, {}).value();
  deriveWithEdges(document, other, {}).value();
  LoftRecipe recipe;
  recipe.picture = PictureId{1};
  recipe.spine.minSpacing = 1;
  bool near = false;
  for (double x = 60; x <= 150; x += 3) {
    recipe.stroke = {{40, 70}, {50, 72}, {x, 72}};
    const auto live = liveShape(document, recipe, cache);
    REQUIRE(live.ok());
    testing::requireLawful(live.value().mesh);
    near = near || live.value().quality == TraceQuality::Live;
  }
  CHECK(near);
  const auto whole = previewShape(document, recipe, other);
  CHECK(whole.value().quality == TraceQuality::Final);
  CHECK(previewShape(document, recipe, cache).value().generated == whole.value().generated);
  // Ribs that are known are used, whatever is done to the shape.
  recipe.loft.sectionPoints = 32;
  const auto coarser = liveShape(document, recipe, cache);
  CHECK(coarser.value().quality == TraceQuality::Final);
  CHECK(coarser.value().generated == whole.value().generated);
}

TEST_CASE("a preview before the edges are known is guessed, and not kept") {
  const Document document = ellipseDocument();
  Cache cache;
  const LoftRecipe& recipe = *document::loftOf(*document.parts[0]);
  const auto guess = previewShape(document, recipe, cache);
  REQUIRE(guess.ok());
  CHECK(guess.value().ribs.ribs[3].leftState == ribs::RibState::Guessed);
  const auto shape = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  CHECK(shape->ribs.ribs[50].leftState == ribs::RibState::Edge);
  LoftRecipe elsewhere = recipe;
  elsewhere.picture = PictureId{77};
  CHECK(previewShape(document, elsewhere, cache).error() == Error::NoSuchPicture);
}

TEST_CASE("two hundred previews leave the cache small and the document's ribs in it" * doctest::test_suite("slow")) {
  const Document document = ellipseDocument();
  Cache cache;
  const auto first = deriveWithEdges(document, cache, {}).value().parts[0].shape;
  const std::size_t before = cache.bytes();
  LoftRecipe recipe = *document::loftOf(*document.parts[0]);
  recipe.spine.ribs = 40;
  recipe.ribs.levels = 16;
  for (int i = 0; i < 200; ++i) {
    recipe.stroke[1].y = 72 + 0.05 * i;
    REQUIRE(previewShape(document, recipe, cache).ok());
  }
  CHECK(cache.bytes() <= before + Cache::kPreviewBytes);
  forgetEdges(cache, document);
  const Document changed = update(document, SetSection{PartId{1}, sections::SectionPreset::Square}).value();
  CHECK(derive(changed, cache).parts[0].shape->generated == first->generated);
}

TEST_CASE("shapes that are not shown go when all of them take too much memory") {
  Document document = update({}, AddPicture{"e", ellipsePicture(900, 200)}).value();
  document = update(document, DrawSpine{PictureId{1}, {{30, 100}, {870, 100}}}).value();
  document = update(document, SetParameter{PartId{1}, "ribs", 400}).value();
  document = update(document, SetParameter{PartId{1}, "sides", 128}).value();
  Cache cache;
  deriveWithEdges(document, cache, {}).value();
  std::size_t most = 0, sum = 0;
  for (int i = 0; i < 30; ++i) {
    const ribs::RibEdits edits{{{.at = 0.5, .out = 50.0 + i, .reach = 0.1}}, {}, {}};
    document = update(document, EditRibs{PartId{1}, edits}).value();
    const auto shape = derive(document, cache).parts[0].shape;
    REQUIRE(shape != nullptr);
    sum += bytesOf(*shape);
    most = std::max(most, cache.bytes());
    CHECK(derive(document, cache).parts[0].shape == shape);
  }
  REQUIRE(sum > Cache::kShapeBytes);
  CHECK(most <= Cache::kShapeBytes + Cache::kTraceBytes);
}

TEST_CASE("cancelled work says so and keeps nothing") {
  const Document document = ellipseDocument();
  Cache cache;
  const Progress progress;
  progress.cancel();
  const auto derived = deriveWithEdges(document, cache, progress);
  REQUIRE_FALSE(derived.ok());
  CHECK(derived.error() == Error::Cancelled);
  CHECK(cache.edges(document.pictures[0]->contentHash) == nullptr);
}
