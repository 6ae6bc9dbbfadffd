#include "tests/support/complete_document.h"

#include <memory>

#include "tests/support/random_documents.h"

namespace spineloft::testing {
namespace {

using namespace document;

PictureEntry photo() {
  image::Picture picture = *ellipsePicture(96, 72, 7);
  // Halved, as a large photo is, with one pixel that is not opaque.
  picture.width = 192;
  picture.height = 144;
  picture.working.pixels[3] = 128;
  PictureEntry entry;
  entry.id = PictureId{2};
  entry.name = "Katze \xf0\x9f\x90\x88";
  entry.size = {192, 144};
  entry.contentHash = contentHash(picture);
  entry.picture = std::make_shared<const image::Picture>(std::move(picture));
  entry.ignored = {{{{10, 10}, {12.5, 30.25}}, 4}};
  entry.extra = R"({"mood":{"calm":true}})";
  return entry;
}

PictureEntry sketch() {
  PictureEntry entry;
  entry.id = PictureId{5};
  entry.name = "Sketch 5";
  entry.size = {120, 80};
  entry.sketch.push_back(image::SketchStroke{{{20, 40}, {60, 38.5}, {100, 40}}, {0.25f, 1, 0.1f}, 3, false, {1, 2, 3}});
  entry.sketch.push_back(image::SketchStroke{{{60, 10}}, {}, 7.5, true, {255, 0, 128}});
  entry.contentHash = contentHash(entry.size, entry.sketch);
  return entry;
}

LoftRecipe fullRecipe() {
  LoftRecipe recipe;
  recipe.picture = PictureId{2};
  recipe.stroke = {{40, 72}, {70.125, 70}, {96, 1.0 / 3 + 72}, {150, 72}};
  recipe.spine = {24, 3.5, 0.05};
  recipe.ribs = {64, 0.4, 0.8, 0.2, 4, 0.5, 0.2, {}, {4, 0.01, 0.3, 0.25}};
  recipe.ribs.evidence = {1, 2, 0.2, 0.25};
  recipe.edits.ends = {{0.25, ribs::Side::Left, 0.5, 20, 0.1, true},
                       {0.75, ribs::Side::Right, -1.5, 17.25, 0.3, false}};
  recipe.edits.added = {0.5, 0.625};
  recipe.edits.removed = {0.1};
  recipe.ignored = {{{{80, 60}}, 12}, {{{90, 60}, {91, 61}}, 2}};
  recipe.pose.stroke = {{40, 100}, {90, 90}, {150, 110}};
  recipe.pose.depth.points = {{0, 0}, {0.5, 12}, {1, -3}};
  recipe.pose.coilTurns = -1.5;
  recipe.pose.coilRadius = 9;
  recipe.pose.closed = true;
  return recipe;
}

loft::LoftParams fullLoft() {
  loft::LoftParams params;
  loft::SectionKey drawn{0.125, {}, {sections::BlendKind::Custom, {{{0, 0}, {0.5, 0.7}, {1, 1}}}}};
  drawn.shape.contours = {{{1, 0}, {0, 1}, {-1, 0}, {0, -0.5}}};
  params.sections = {drawn, {0.75, sections::SectionPreset::Star, {sections::BlendKind::Overshoot, {}}}};
  params.twist.points = {{0, 0}, {1, 3.25}};
  params.squash.points = {{0.5, 0.5}};
  params.tilt.points = {{0, 0.1}, {1, -0.1}};
  params.bulge.points = {{0.25, 0.5}};
  params.startCap = sections::CapStyle::Flat;
  params.endCap = sections::CapStyle::Pointed;
  params.sectionPoints = 36;
  params.capRings = 4;
  params.centring = 1.5;
  return params;
}

}  // namespace

Document completeDocument() {
  Document document;
  document.name = "Golden swan";
  document.pictures.push_back(photo());
  document.pictures.push_back(sketch());
  Part full;
  full.id = PartId{3};
  full.name = "Tail";
  LoftRecipe recipe = fullRecipe();
  recipe.loft = fullLoft();
  full.recipe = recipe;
  full.look = {false, {10, 200, 30}};
  full.visible = false;
  full.extra = R"({"bones":[1,2],"recipe":{"loft":{"sections":{"#length":2,"1":{"glow":3}}}}})";
  Part plain;
  plain.id = PartId{4};
  plain.name = "Part 4";
  LoftRecipe small;
  small.picture = PictureId{2};
  small.stroke = {{30, 72}, {160, 70}};
  small.spine.ribs = 8;  // few triangles: the golden file stays small
  small.loft.sectionPoints = 12;
  small.loft.capRings = 2;
  plain.recipe = small;
  Part drawn = plain;
  drawn.id = PartId{7};
  drawn.name = "Part 7";
  small.picture = PictureId{5};
  small.stroke = {{20, 40}, {100, 40}};
  drawn.recipe = small;
  for (const Part& part : {full, plain, drawn}) document.parts.push_back(part);
  document.height = {87.5};
  document.lastPictureId = 6;
  document.lastPartId = 9;
  document.extra = R"({"sky":"blue"})";
  return document;
}

}  // namespace spineloft::testing
