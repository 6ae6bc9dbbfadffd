#include "engine/pipeline/outline_ink.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/document/update.h"
#include "engine/pipeline/derive.h"

using namespace spineloft;
using namespace spineloft::document;

namespace {

constexpr PicturePoint kMiddle{200, 200};
constexpr double kRadius = 120, kPen = 3;

std::vector<PicturePoint> arc(double radius, double from, double to) {
  std::vector<PicturePoint> out;
  for (int i = 0; i <= 120; ++i) {
    const double angle = from + (to - from) * i / 120;
    out.push_back(kMiddle + PicturePoint{std::cos(angle), std::sin(angle)} * radius);
  }
  return out;
}
std::vector<PicturePoint> ring(double radius) { return arc(radius, 0, 2 * std::numbers::pi); }

/// Paper with these lines of the pen, and a puff with an outline of this radius.
Document drawn(const std::vector<std::vector<PicturePoint>>& lines, double radius) {
  Document document = update({}, AddSketch{"", {400, 400}}).value();
  for (const auto& line : lines) {
    image::SketchStroke stroke;
    stroke.points = line;
    stroke.radius = kPen;
    document = update(document, DrawOnSketch{PictureId{1}, stroke}).value();
  }
  Region region;
  region.picture = PictureId{1};
  region.contours = {ring(radius)};
  return update(document, DrawRegion{region, inflate::InflateParams{}, {}}).value();
}

std::shared_ptr<const pipeline::PartShape> shapeOf(const Document& document) {
  pipeline::Cache cache;
  return pipeline::deriveWithEdges(document, cache, {}).value().parts[0].shape;
}

/// The darkest pixel of the texture, 0…255.
int darkest(const pipeline::PartShape& shape) {
  REQUIRE(shape.texture);
  const std::vector<std::uint8_t>& pixels = shape.texture->pixels.pixels;
  int out = 255;
  for (std::size_t i = 0; i + 3 < pixels.size(); i += 4) {
    out = std::min<int>(out, std::max({pixels[i], pixels[i + 1], pixels[i + 2]}));
  }
  return out;
}

}  // namespace

TEST_CASE("the ink of a part's outline is not on it, wherever in the line the outline runs") {
  for (const double radius : {kRadius - kPen, kRadius, kRadius + kPen}) {
    CAPTURE(radius);
    const Document document = drawn({ring(kRadius)}, radius);
    CHECK(darkest(*shapeOf(document)) > 200);
  }
}

TEST_CASE("the ink of another part's outline is on no part, whichever was made first") {
  const PicturePoint beside = kMiddle + PicturePoint{kRadius, 0};
  const auto around = [&](double radius) {
    std::vector<PicturePoint> line = ring(radius);
    for (PicturePoint& p : line) p = p + (beside - kMiddle);
    return line;
  };
  const Document alone = drawn({ring(kRadius), around(60)}, kRadius);
  CHECK(darkest(*shapeOf(alone)) < 80);
  Region region;
  region.picture = PictureId{1};
  region.contours = {around(60)};
  const Document both = update(alone, DrawRegion{region, inflate::InflateParams{}, {}}).value();
  pipeline::Cache cache;
  const auto parts = pipeline::deriveWithEdges(both, cache, {}).value().parts;
  for (const pipeline::DerivedPart& part : parts) CHECK(darkest(*part.shape) > 200);

  // One that was known takes its own back when the other goes.
  const auto left = pipeline::derive(update(both, DeletePart{PartId{2}}).value(), cache).parts;
  CHECK(*left[0].shape->texture == *shapeOf(alone)->texture);
  CHECK(left[0].shape->key == parts[0].shape->key);
}

TEST_CASE("what another part is beside its outline, and how it looks, asks for no new texture") {
  Document document = drawn({ring(kRadius), ring(kRadius / 3)}, kRadius);
  Region region;
  region.picture = PictureId{1};
  region.contours = {ring(kRadius / 3)};
  document = update(document, DrawRegion{region, inflate::InflateParams{}, {}}).value();
  pipeline::Cache cache;
  const auto before = pipeline::deriveWithEdges(document, cache, {}).value().parts;
  document = update(document, SetParameter{PartId{2}, "height", 0.5}).value();
  const auto after = pipeline::derive(document, cache, {}, pipeline::Finish::Later);
  CHECK(after.parts[1].shape->key != before[1].shape->key);
  CHECK(after.parts[0].shape == before[0].shape);
  CHECK(after.wantedTextures == std::vector{PartId{2}});
}

TEST_CASE("where it is kept, the ink of a part's outline is on it") {
  const Document document = drawn({ring(kRadius)}, kRadius);
  Look look;
  look.inked = true;
  const auto inked = shapeOf(update(document, SetLook{document.parts.front()->id, look}).value());
  CHECK(darkest(*inked) < 80);
  CHECK(shapeOf(document)->key != inked->key);
}

TEST_CASE("what is drawn on the part stays on it") {
  const Document document = drawn({ring(kRadius), ring(kRadius / 3)}, kRadius);
  const auto shape = shapeOf(document);
  CHECK(darkest(*shape) < 80);
  for (const ribs::IgnoreMark& mark : pipeline::outlineInk(*shape, *document.pictures.front())) {
    for (const PicturePoint p : mark.stroke) CHECK(distance(p, kMiddle) > kRadius / 2);
  }
}

TEST_CASE("of a line that follows the outline and leaves it, only what follows it is ink of the outline") {
  std::vector<PicturePoint> line = arc(kRadius, 0, std::numbers::pi);
  const PicturePoint last = line.back();
  for (int i = 1; i <= 40; ++i) line.push_back(last + (kMiddle - last) * (i / 40.0));
  const Document document = drawn({line}, kRadius);
  const auto marks = pipeline::outlineInk(*shapeOf(document), *document.pictures.front());
  REQUIRE(marks.size() == 1);
  CHECK(marks[0].covers);
  CHECK(marks[0].radius > kPen);
  CHECK(marks[0].stroke.size() >= 121);
  CHECK(marks[0].stroke.size() < 121 + 10);
}

TEST_CASE("a photo has no ink") {
  PictureEntry photo;
  photo.size = {400, 400};
  CHECK(pipeline::outlineInk(*shapeOf(drawn({ring(kRadius)}, kRadius)), photo).empty());
}

TEST_CASE("the ink of a part's outline is no edge of a part beside it, and may be one of a part within") {
  const Document document = drawn({ring(kRadius)}, kRadius);
  pipeline::Cache cache;
  const pipeline::Derived derived = pipeline::deriveWithEdges(document, cache, {}).value();
  const auto inkFor = [&](const std::vector<PicturePoint>& line) {
    return pipeline::inkOfOthers(document, derived, PictureId{1}, line);
  };
  CHECK(inkFor({{200, 150}, {200, 200}, {200, 250}}).empty());
  CHECK(pipeline::inkOfOthers(document, derived, PictureId{2}, ring(kRadius + 40)).empty());
  // A handle, from the part and back to it.
  std::vector<PicturePoint> handle;
  for (int i = 0; i <= 40; ++i) {
    const double angle = std::numbers::pi * (i / 40.0 - 0.5);
    handle.push_back(kMiddle + PicturePoint{kRadius + 50 * std::cos(angle), 50 * std::sin(angle)});
  }
  const auto marks = inkFor(handle);
  REQUIRE(marks.size() == 1);
  CHECK_FALSE(marks[0].covers);
  CHECK(marks[0].stroke.size() < 60);
  for (const PicturePoint p : marks[0].stroke) CHECK(distance(p, kMiddle) == doctest::Approx(kRadius).epsilon(0.01));
  const auto widest = [&](const std::vector<ribs::IgnoreMark>& ignored) {
    Document with = update(document, DrawSpine{PictureId{1}, handle}).value();
    with = update(with, IgnoreForPart{PartId{2}, ignored}).value();
    const pipeline::Derived made = pipeline::deriveWithEdges(with, cache, {}).value();
    double out = 0;
    for (const ribs::Rib& rib : made.parts[1].shape->ribs.ribs) out = std::max(out, distance(rib.left, rib.right));
    return out;
  };
  CHECK(widest({}) > 60);
  CHECK(widest(marks) < 45);
}
