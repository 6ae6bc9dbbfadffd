#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "engine/base/hash.h"
#include "engine/base/rng.h"
#include "engine/document/update.h"
#include "engine/image/sketch.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/silhouette.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::image;

namespace {

using Strokes = std::vector<Box<SketchStroke>>;

SketchStroke line(std::vector<PicturePoint> points, double radius = 3) {
  SketchStroke stroke;
  stroke.points = std::move(points);
  stroke.radius = radius;
  return stroke;
}

SketchStroke randomStroke(Rng& rng, Size size) {
  SketchStroke stroke;
  PicturePoint at{rng.uniform(-20, size.width + 20), rng.uniform(-20, size.height + 20)};
  for (std::uint32_t i = 1 + rng.below(40); i > 0; --i) {
    at += PicturePoint{rng.uniform(-25, 25), rng.uniform(-25, 25)};
    stroke.points.push_back(at);
  }
  stroke.radius = rng.uniform(0.5, 12);
  stroke.erase = rng.below(4) == 0;
  if (rng.below(2) == 0) {
    for (std::size_t i = 0; i < stroke.points.size(); ++i) {
      stroke.pressure.push_back(static_cast<float>(rng.uniform(0, 1)));
    }
  }
  for (std::uint8_t& channel : stroke.colour) channel = static_cast<std::uint8_t>(rng.below(256));
  return stroke;
}

Strokes randomStrokes(Rng& rng, Size size, std::uint32_t count) {
  Strokes strokes;
  for (std::uint32_t i = 0; i < count; ++i) strokes.push_back(randomStroke(rng, size));
  return strokes;
}

Picture drawn(Size size, const Strokes& strokes) {
  Result<Picture> picture = drawSketch(size, strokes);
  REQUIRE(picture.ok());
  return std::move(picture).value();
}

std::array<int, 4> pixel(const Picture& picture, int x, int y) {
  const auto at =
      4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
  const auto& p = picture.working.pixels;
  return {p[at], p[at + 1], p[at + 2], p[at + 3]};
}

/// How much ink is on the paper, in pixels of black ink: 1 a pixel that is all ink.
double inked(const Picture& picture) {
  double sum = 0;
  for (std::size_t i = 0; i < picture.working.pixels.size(); i += 4) {
    sum += 255 - picture.working.pixels[i];
  }
  return sum / 255;
}

SketchStroke black(SketchStroke stroke) {
  stroke.colour = {0, 0, 0};
  return stroke;
}

constexpr double kPi = 3.14159265358979323846;

}  // namespace

TEST_CASE("equal strokes make equal pixels, the same numbers on every platform") {
  Rng rng(11);
  const Size size{320, 240};
  const Strokes strokes = randomStrokes(rng, size, 40);
  const Picture picture = drawn(size, strokes);
  CHECK(picture == drawn(size, strokes));
  // What this was where it was written; another processor or compiler has to find the same.
  Hasher hasher;
  hasher.bytes(std::as_bytes(std::span(picture.working.pixels)));
  CHECK(hasher.value() == 5951022768842337376ull);
}

TEST_CASE("a sketch without strokes is white paper of its size") {
  const Picture paper = drawn({100, 64}, {});
  CHECK(paper.width == 100);
  CHECK(paper.height == 64);
  CHECK(paper.working.width == 100);
  CHECK(paper.working.height == 64);
  CHECK(paper.working.pixels == std::vector<std::uint8_t>(4 * 100 * 64, 255));
}

TEST_CASE("strokes added to a drawn sketch give what drawing all of them from blank paper gives") {
  Rng rng(12);
  for (int round = 0; round < testing::rounds(20); ++round) {
    const Size size{64 + static_cast<int>(rng.below(200)), 64 + static_cast<int>(rng.below(200))};
    const Strokes strokes = randomStrokes(rng, size, 1 + rng.below(12));
    const std::size_t first = rng.below(static_cast<std::uint32_t>(strokes.size() + 1));
    Picture part = drawn(size, {strokes.begin(), strokes.begin() + static_cast<long>(first)});
    const Result<Picture> whole = drawMore(std::move(part), std::span(strokes).subspan(first));
    REQUIRE(whole.ok());
    CHECK(whole.value() == drawn(size, strokes));
  }
}

TEST_CASE("an eraser over all that was drawn leaves nothing but paper") {
  Rng rng(13);
  for (int round = 0; round < testing::rounds(20); ++round) {
    const Size size{200, 150};
    SketchStroke stroke = randomStroke(rng, size);
    stroke.erase = false;
    SketchStroke eraser = stroke;
    eraser.erase = true;
    eraser.pressure.clear();
    eraser.radius = stroke.radius + 2;
    CHECK(drawn(size, {stroke, eraser}) == drawn(size, {}));
  }
}

TEST_CASE("a straight line covers its length times its width and two half discs") {
  Rng rng(14);
  for (int round = 0; round < testing::rounds(40); ++round) {
    const double radius = rng.uniform(0.8, 14), angle = rng.uniform(0, 2 * kPi);
    const double length = rng.uniform(0, 80);
    const PicturePoint from{rng.uniform(95, 105), rng.uniform(95, 105)};
    const PicturePoint to = from + PicturePoint{std::cos(angle), std::sin(angle)} * length;
    const double area = 2 * radius * distance(from, to) + kPi * radius * radius;
    const double found = inked(drawn({200, 200}, {black(line({from, to}, radius))}));
    CHECK(std::abs(found - area) < 0.02 * area + 0.4);
  }
}

TEST_CASE("a stroke touches no pixel beyond its radius and fills every pixel within it" * doctest::test_suite("slow")) {
  Rng rng(15);
  for (int round = 0; round < testing::rounds(3); ++round) {
    const Size size{160, 120};
    SketchStroke stroke = black(randomStroke(rng, size));
    stroke.erase = false;
    const Picture picture = drawn(size, {stroke});
    const std::vector<InkPoint> ink = inkLine(stroke);
    // Of all discs along each stretch the one that reaches farthest: distance less radius is convex along it.
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        double depth = -1e9;  // how far inside of the nearest disc
        for (std::size_t i = 0; i < ink.size(); ++i) {
          const InkPoint a = ink[i], b = ink[std::min(i + 1, ink.size() - 1)];
          const auto depthAt = [&](double t) {
            const double u = double{kInkUnit};
            const double px = (a.x + (b.x - a.x) * t) / u - x, py = (a.y + (b.y - a.y) * t) / u - y;
            return (a.radius + (b.radius - a.radius) * t) / u - std::hypot(px, py);
          };
          double low = 0, high = 1;
          for (int k = 0; k < 24; ++k) {
            const double third = (high - low) / 3;
            if (depthAt(low + third) < depthAt(high - third)) {
              low += third;
            } else {
              high -= third;
            }
          }
          depth = std::max({depth, depthAt(0), depthAt(1), depthAt((low + high) / 2)});
        }
        const int value = pixel(picture, x, y)[0];
        if (depth < -0.56) CHECK(value == 255);
        if (depth > 1) CHECK(value == 0);
      }
    }
  }
}

TEST_CASE("a sketch mirrored is the mirror's sketch") {
  Rng rng(16);
  const Size size{128, 96};
  for (int round = 0; round < testing::rounds(10); ++round) {
    SketchStroke stroke = randomStroke(rng, size);
    for (PicturePoint& p : stroke.points) p = {std::round(p.x * 4) / 4, std::round(p.y * 4) / 4};
    SketchStroke mirrored = stroke;
    for (PicturePoint& p : mirrored.points) p.x = size.width - 1 - p.x;
    const Picture a = drawn(size, {stroke}), b = drawn(size, {mirrored});
    int worst = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x) {
        const auto p = pixel(a, x, y), q = pixel(b, size.width - 1 - x, y);
        for (std::size_t k = 0; k < 4; ++k) worst = std::max(worst, std::abs(p[k] - q[k]));
      }
    }
    CHECK(worst <= 3);  // of 255: whole numbers are rounded to one side
  }
}

TEST_CASE("more pressure never makes a line thinner, and none keeps it visible") {
  double before = 0;
  for (const float pressure : {0.f, 0.25f, 0.5f, 0.75f, 1.f}) {
    SketchStroke stroke = black(line({{40, 60}, {120, 60}}, 6));
    stroke.pressure = {pressure, pressure};
    const double ink = inked(drawn({160, 120}, {stroke}));
    CHECK(ink > before);
    before = ink;
  }
  CHECK(before == doctest::Approx(inked(drawn({160, 120}, {black(line({{40, 60}, {120, 60}}, 6))}))));
  SketchStroke faint = black(line({{40, 60}, {120, 60}}, 0.5));
  faint.pressure = {0, 0};
  CHECK(inked(drawn({160, 120}, {faint})) > 40);
}

TEST_CASE("the line keeps its sharp corners and rounds the gentle ones") {
  const auto nearest = [](const std::vector<InkPoint>& ink, PicturePoint p) {
    double best = 1e9;
    for (const InkPoint& q : ink) {
      best = std::min(best, distance(p, PicturePoint{q.x / double{kInkUnit}, q.y / double{kInkUnit}}));
    }
    return best;
  };
  CHECK(nearest(inkLine(line({{10, 10}, {90, 10}, {90, 90}})), {90, 10}) < 0.6);
  const std::vector<InkPoint> gentle = inkLine(line({{10, 10}, {90, 10}, {160, 40}}));
  CHECK(nearest(gentle, {90, 10}) > 2);
  CHECK(gentle.front().x == 10 * kInkUnit);
  CHECK(gentle.back().x == 160 * kInkUnit);
  CHECK(gentle.back().y == 40 * kInkUnit);
  // A circle through few points is round to half a pixel.
  std::vector<PicturePoint> circle;
  for (int i = 0; i <= 36; ++i) {
    circle.push_back({100 + 60 * std::cos(i * kPi / 18), 100 + 60 * std::sin(i * kPi / 18)});
  }
  for (const InkPoint& p : inkLine(line(circle))) {
    CHECK(std::abs(std::hypot(p.x / 256.0 - 100, p.y / 256.0 - 100) - 60) < 0.5);
  }
}

TEST_CASE("strokes that leave the paper, or are far beyond it, harm nothing") {
  for (const double far : {500., 1e5, 1e12, 1e300}) {
    const Picture picture = drawn(
        {96, 96}, {line({{48, 48}, {far, 48}}, 4), line({{-far, -far}, {far, far}}, 100), line({{far, far}}, 100)});
    CHECK(pixel(picture, 48, 48)[0] == 31);
  }
  const Picture away = drawn({96, 96}, {line({{1e300, 1e300}, {1e300, -1e300}}, 4)});
  CHECK(away == drawn({96, 96}, {}));
}

TEST_CASE("what is no stroke or no paper is refused") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const SketchStroke good = line({{10, 10}, {20, 20}});
  std::vector<SketchStroke> bad(9, good);
  bad[0].points.clear();
  bad[1].points[1].x = nan;
  bad[2].points[0].y = std::numeric_limits<double>::infinity();
  bad[3].radius = 0.4;
  bad[4].radius = nan;
  bad[5].radius = 101;
  bad[6].pressure = {0.5f};
  bad[7].pressure = {0.5f, 1.1f};
  bad[8].points.resize(kMostSketchPoints + 1, {5, 5});
  for (const SketchStroke& stroke : bad) {
    CHECK_FALSE(isValid(stroke));
    CHECK(inkLine(stroke).empty());
    const Result<Picture> refused = drawSketch({100, 100}, Strokes{good, stroke});
    REQUIRE_FALSE(refused.ok());
    CHECK(refused.failure().error == Error::ValueOutOfRange);
  }
  for (const Size size : {Size{63, 100}, Size{100, 2049}, Size{0, 0}, Size{-5, 100}}) {
    CHECK_FALSE(drawSketch(size, {}).ok());
  }
}

TEST_CASE("a cache draws only what is new on a sketch, and draws it right") {
  using namespace spineloft::document;
  Rng rng(17);
  const Size size{200, 150};
  Document document = update({}, AddSketch{"paper", size}).value();
  std::vector<Document> states{document};
  for (int i = 0; i < 12; ++i) {
    document = update(document, DrawOnSketch{PictureId{1}, randomStroke(rng, size)}).value();
    states.push_back(document);
  }
  pipeline::Cache cache;
  for (int step = 0; step < 60; ++step) {  // there and back again, as undo and redo go
    const Document& now = states[rng.below(static_cast<std::uint32_t>(states.size()))];
    const pipeline::Derived derived = pipeline::derive(now, cache);
    REQUIRE(pixelsOf(now, derived, PictureId{1}) != nullptr);
    CHECK(*pixelsOf(now, derived, PictureId{1}) == drawn(size, now.pictures[0]->sketch));
  }
}

namespace {

/// Half the width of a bottle at height y, 60…420: a neck, a shoulder and a belly.
double bottleHalf(double y) {
  const double t = std::clamp((y - 150) / 90, 0.0, 1.0);
  return 28 + 62 * t * t * (3 - 2 * t);
}

constexpr double kBottleTop = 60, kBottleFoot = 420, kBottleMiddle = 250;

SketchStroke bottleSide(double sign) {
  SketchStroke stroke;
  for (double y = kBottleTop; y <= kBottleFoot; y += 6) {
    stroke.points.push_back({kBottleMiddle + sign * bottleHalf(y), y});
  }
  return stroke;
}

}  // namespace

TEST_CASE("two pen lines, open at both ends, loft to the bottle between them") {
  using namespace spineloft::document;
  Document document = update({}, AddSketch{"bottle", {500, 480}}).value();
  for (const double sign : {-1., 1.}) {
    document = update(document, DrawOnSketch{PictureId{1}, bottleSide(sign)}).value();
  }
  const std::vector<PicturePoint> spine{{248, 70}, {253, 180}, {249, 300}, {251, 412}};
  DrawSpine draw{PictureId{1}, spine};
  draw.startCap = draw.endCap = sections::CapStyle::Flat;
  document = update(document, draw).value();
  pipeline::Cache cache;
  const auto derived = pipeline::deriveWithEdges(document, cache, {});
  REQUIRE(derived.ok());
  REQUIRE(derived.value().parts[0].shape != nullptr);
  const pipeline::PartShape& shape = *derived.value().parts[0].shape;
  testing::requireLawful(shape.mesh);
  std::size_t onLine = 0;
  for (const ribs::Rib& rib : shape.ribs.ribs) {
    for (const PicturePoint end : {rib.left, rib.right}) {
      onLine += std::abs(std::abs(end.x - kBottleMiddle) - bottleHalf(end.y)) < 6 ? 1 : 0;
    }
  }
  CHECK(static_cast<double>(onLine) > 0.9 * 2 * static_cast<double>(shape.ribs.ribs.size()));
  const Mask mask = pipeline::rasteriseSilhouette(shape.mesh, {500, 480});
  double both = 0, either = 0;
  for (int y = 70; y < 412; ++y) {
    for (int x = 0; x < 500; ++x) {
      const bool truth = std::abs(x - kBottleMiddle) < bottleHalf(y);
      const bool found = mask.pixels[static_cast<std::size_t>(y * 500 + x)] != 0;
      both += truth && found ? 1 : 0;
      either += truth || found ? 1 : 0;
    }
  }
  CHECK(both / either > 0.9);
}
