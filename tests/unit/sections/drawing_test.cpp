#include "engine/sections/drawing.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/base/rng.h"
#include "engine/geometry/line_distance.h"
#include "engine/geometry/polygon.h"
#include "engine/sections/open_line.h"

using namespace spineloft;
using namespace spineloft::sections;

namespace {

constexpr double kPi = std::numbers::pi;
using Line = std::vector<SectionPoint>;
using View = std::span<const SectionPoint>;

/// A line round the middle from one angle to another, its radius by the angle.
template <class Radius>
Line around(double from, double to, const Radius& radius, int count = 240) {
  Line line;
  for (int i = 0; i < count; ++i) {
    const double angle = from + (to - from) * i / (count - 1);
    line.push_back({radius(angle) * std::cos(angle), radius(angle) * std::sin(angle)});
  }
  return line;
}
double one(double) { return 0.8; }

/// A wandering closed line round the middle that never crosses itself: a sum of few waves.
Line blob(Rng& rng, double from = 0, double to = 2 * kPi * 0.985) {
  std::array<double, 5> size{}, phase{};
  for (std::size_t k = 0; k < size.size(); ++k) {
    size[k] = rng.uniform(0, 0.3) / static_cast<double>(k + 1);
    phase[k] = rng.uniform(0, 2 * kPi);
  }
  return around(from, to, [&](double angle) {
    double r = 0.6;
    for (std::size_t k = 0; k < size.size(); ++k) r += size[k] * std::sin(double(k + 1) * angle + phase[k]) * 0.5;
    return r;
  });
}

Line shaky(Line line, Rng& rng, double by) {
  for (SectionPoint& p : line) p += SectionPoint{rng.uniform(-by, by), rng.uniform(-by, by)};
  return line;
}

bool sameSets(const Line& a, const Line& b, double tolerance) {
  if (a.size() != b.size()) return false;
  return std::ranges::all_of(a, [&](SectionPoint p) {
    return std::ranges::any_of(b, [&](SectionPoint q) { return distance(p, q) <= tolerance; });
  });
}

Line all(const Drawing& drawing) {
  Line out;
  for (const DrawnCurve& curve : drawing) {
    const Line line = outlineOf(curve);
    out.insert(out.end(), line.begin(), line.end());
  }
  return out;
}

void checkSection(const SectionShape& shape) {
  double low = 1e9, high = -1e9;
  REQUIRE(shape.drawn());
  for (const Line& contour : shape.contours) {
    CHECK(geometry::isSimple(View(contour)));
    for (const SectionPoint p : contour) {
      low = std::min(low, p.x);
      high = std::max(high, p.x);
      CHECK(std::abs(p.x) <= 1);
      CHECK(std::abs(p.y) <= 1);
    }
  }
  CHECK(low == -1);
  CHECK(high == 1);
}

double areaOf(const Line& line) { return geometry::signedArea(View(line)); }

}  // namespace

TEST_CASE("a drawn circle becomes a circle of few points, however the hand trembles") {
  Rng rng(11);
  for (const double tremble : {0.0, 0.004, 0.01}) {
    CAPTURE(tremble);
    const Line line = shaky(around(0.3, 0.3 + 2 * kPi * 0.97, one), rng, tremble);
    const Drawing drawing = drawFreehand(line, {}).value();
    REQUIRE(drawing.size() == 1);
    CHECK(drawing[0].points.size() <= 24);
    for (const DrawnPoint& p : drawing[0].points) CHECK_FALSE(p.corner);
    for (const SectionPoint p : outlineOf(drawing[0])) CHECK(norm(p) == doctest::Approx(0.8).epsilon(0.035));
    CHECK(std::abs(areaOf(outlineOf(drawing[0]))) == doctest::Approx(kPi * 0.64).epsilon(0.03));
  }
}

TEST_CASE("a drawn square keeps its four corners and straight sides") {
  Rng rng(5);
  Line line;
  const std::array<SectionPoint, 5> corners{{{-0.7, -0.7}, {0.7, -0.7}, {0.7, 0.7}, {-0.7, 0.7}, {-0.7, -0.68}}};
  for (std::size_t k = 0; k + 1 < corners.size(); ++k) {
    for (int i = 0; i < 40; ++i) line.push_back(lerp(corners[k], corners[k + 1], i / 40.0));
  }
  const Drawing drawing = drawFreehand(shaky(line, rng, 0.004), {}).value();
  REQUIRE(drawing.size() == 1);
  int sharp = 0;
  for (const DrawnPoint& p : drawing[0].points) {
    if (!p.corner) continue;
    ++sharp;
    CHECK(std::abs(p.at.x) == doctest::Approx(0.7).epsilon(0.04));
    CHECK(std::abs(p.at.y) == doctest::Approx(0.7).epsilon(0.04));
  }
  CHECK(sharp == 4);
  CHECK(std::abs(areaOf(outlineOf(drawing[0]))) == doctest::Approx(1.96).epsilon(0.03));
}

TEST_CASE("ends that run past each other are cut off where they cross") {
  Line line = around(0.1, 2 * kPi, one);
  line.insert(line.begin(), {1.0, -0.05});  // comes in from the right …
  line.push_back({0.95, 0.1});              // … and leaves to the right, across its beginning
  const Drawing drawing = drawFreehand(line, {}).value();
  REQUIRE(drawing.size() == 1);
  CHECK_FALSE(problemOf(drawing));
  for (const SectionPoint p : outlineOf(drawing[0])) CHECK(norm(p) == doctest::Approx(0.84).epsilon(0.06));
}

TEST_CASE("points on a circle give that circle, two corners a straight line") {
  for (const int count : {3, 5, 12}) {
    DrawnCurve curve;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * kPi * i / count + 0.2;
      curve.points.push_back({{0.3 + 0.5 * std::cos(angle), 0.5 * std::sin(angle)}, false});
    }
    const double off = count == 3 ? 0.01 : 0.0015;
    for (const SectionPoint p : outlineOf(curve)) {
      CHECK(std::abs(distance(p, {0.3, 0}) - 0.5) < off);
    }
  }
  const Line box = outlineOf(boxCurve({0.5, -1}, {-0.25, 0.5}));
  CHECK(box.size() == 4);
  CHECK(areaOf(box) == doctest::Approx(0.75 * 1.5));
}

TEST_CASE("what is drawn with mirrors is symmetric to the last bit") {
  Rng rng(77);
  for (int trial = 0; trial < 60; ++trial) {
    CAPTURE(trial);
    Symmetry symmetry;
    symmetry.leftRight = trial % 3 != 1;
    symmetry.frontBack = trial % 3 != 0;
    const double start = rng.uniform(0, 2 * kPi);
    const Line line = shaky(blob(rng, start, start + rng.uniform(1.2, 6.2)), rng, 0.004);
    const Result<Drawing> drawing = drawFreehand(line, symmetry);
    REQUIRE(drawing.ok());
    Line outline = all(drawing.value());
    for (const bool leftRight : {true, false}) {
      if (leftRight ? !symmetry.leftRight : !symmetry.frontBack) continue;
      Line mirrored = outline;
      for (SectionPoint& p : mirrored) (leftRight ? p.x : p.y) *= -1;
      CHECK(sameSets(outline, mirrored, 0));
    }
  }
}

TEST_CASE("what is drawn with turns comes out the same after a turn") {
  Rng rng(78);
  for (int fold = 2; fold <= kMostFold; ++fold) {
    for (int trial = 0; trial < 8; ++trial) {
      CAPTURE(fold);
      CAPTURE(trial);
      Symmetry symmetry;
      symmetry.fold = fold;
      symmetry.leftRight = trial % 2 == 1;
      const double start = rng.uniform(0, 2 * kPi), sweep = rng.uniform(0.8, 1.4) * 2 * kPi / fold;
      const Line line = shaky(blob(rng, start, start + sweep), rng, 0.003);
      const Drawing drawing = drawFreehand(line, symmetry).value();
      const Line outline = all(drawing);
      const double angle = 2 * kPi / fold, c = std::cos(angle), s = std::sin(angle);
      Line after = outline;
      for (SectionPoint& p : after) p = {c * p.x - s * p.y, s * p.x + c * p.y};
      CHECK(sameSets(outline, after, 1e-9));
    }
  }
}

TEST_CASE("half a line between the mirror's ends becomes one whole curve") {
  Symmetry symmetry;
  symmetry.leftRight = true;
  // From near the top down the right side to near the bottom.
  const Line half = around(kPi / 2 - 0.05, -kPi / 2 + 0.04, one);
  const Drawing drawing = drawFreehand(half, symmetry).value();
  REQUIRE(drawing.size() == 1);
  CHECK_FALSE(problemOf(drawing));
  CHECK(std::abs(areaOf(outlineOf(drawing[0]))) == doctest::Approx(kPi * 0.64).epsilon(0.03));
  const SectionShape shape = sectionOf(drawing).value();
  checkSection(shape);
}

TEST_CASE("a small ring beside the mirror becomes two, in a wheel of six as many as it has images") {
  Line ring;
  for (const SectionPoint p : around(0, 2 * kPi * 0.98, [](double) { return 0.12; })) {
    ring.push_back(p + SectionPoint{0.55, 0.16});
  }
  CHECK(drawFreehand(ring, {true, false, 1}).value().size() == 2);
  CHECK(drawFreehand(ring, {true, true, 1}).value().size() == 4);
  CHECK(drawFreehand(ring, {false, false, 6}).value().size() == 6);
  CHECK(drawFreehand(ring, {true, false, 6}).value().size() == 12);
}

TEST_CASE("making a symmetric drawing symmetric changes it by less than the fit") {
  Rng rng(79);
  for (int trial = 0; trial < 20; ++trial) {
    CAPTURE(trial);
    const Symmetry symmetry{true, false, trial % 2 == 0 ? 1 : 3};
    const Drawing once = drawFreehand(blob(rng), symmetry).value();
    if (problemOf(once)) continue;
    const Drawing twice = symmetric(once, symmetry);
    REQUIRE(twice.size() == once.size());
    CHECK(symmetric(once, {}) == once);
    double before = 0, after = 0;
    for (const DrawnCurve& curve : once) before += std::abs(areaOf(outlineOf(curve)));
    for (const DrawnCurve& curve : twice) after += std::abs(areaOf(outlineOf(curve)));
    CHECK(after == doctest::Approx(before).epsilon(0.03));
  }
}

TEST_CASE("every preset can be changed by its points, and looks as before") {
  for (const SectionName& name : sectionNames()) {
    CAPTURE(std::string(name.key));
    const Drawing drawing = drawingOf(name.preset).value();
    REQUIRE(drawing.size() == 1);
    CHECK(drawing[0].points.size() <= 48);
    const SectionShape shape = sectionOf(drawing).value();
    checkSection(shape);
    const Line preset = presetSection(name.preset, 512).value().points;
    CHECK(areaOf(shape.contours[0]) == doctest::Approx(areaOf(preset)).epsilon(0.012));
  }
}

TEST_CASE("any scribble is a drawing, and a sound section or a named problem") {
  Rng rng(2024);
  int sound = 0;
  for (int trial = 0; trial < 400; ++trial) {
    CAPTURE(trial);
    Line line;
    SectionPoint p{rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const int count = 2 + static_cast<int>(rng.below(60));
    for (int i = 0; i < count; ++i) {
      p += SectionPoint{rng.uniform(-0.3, 0.3), rng.uniform(-0.3, 0.3)};
      line.push_back(p);
    }
    const Symmetry symmetry{rng.below(2) == 1, rng.below(2) == 1, 1 + static_cast<int>(rng.below(8))};
    const Result<Drawing> drawing = drawFreehand(line, symmetry);
    if (!drawing) {
      CHECK(drawing.error() == Error::SectionInvalid);
      continue;
    }
    const auto problem = problemOf(drawing.value());
    const Result<SectionShape> shape = sectionOf(drawing.value());
    CHECK(shape.ok() == !problem);
    if (!shape.ok()) {
      CHECK(shape.error() == Error::SectionInvalid);
      CHECK_FALSE(shape.failure().detail.empty());
      continue;
    }
    ++sound;
    checkSection(shape.value());
  }
  CHECK(sound > 20);
}

TEST_CASE("lines that are no lines are refused by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(drawFreehand(Line{}, {}).error() == Error::SectionInvalid);
  CHECK(drawFreehand(Line{{0, 0}, {0, 0}, {0, 0}}, {}).error() == Error::SectionInvalid);
  CHECK(drawFreehand(Line{{0, 0}, {nan, 0}, {1, 1}, {0, 1}}, {}).error() == Error::StrokeNotFinite);
  CHECK(drawFreehand(Line{{0, 0}, {1e9, 0}, {1, 1}, {0, 1}}, {}).error() == Error::StrokeNotFinite);
}

TEST_CASE("a curve in a curve is a hole, one beside it a piece, one in the hole a piece again") {
  const Drawing drawing{ellipseCurve({-0.9, -0.9}, {0.3, 0.9}), ellipseCurve({-0.7, -0.6}, {0.1, 0.6}),
                        ellipseCurve({-0.5, -0.3}, {-0.1, 0.3}), boxCurve({0.5, -0.2}, {0.9, 0.2})};
  const SectionShape shape = sectionOf(drawing).value();
  checkSection(shape);
  REQUIRE(shape.contours.size() == 4);
  int holes = 0;
  for (const Line& contour : shape.contours) holes += areaOf(contour) < 0 ? 1 : 0;
  CHECK(holes == 1);
  CHECK(areaOf(shape.contours.back()) < 0);
}

TEST_CASE("a drawing that is no slice names its fault and its curve") {
  const auto faultOf = [](const Drawing& drawing) { return problemOf(drawing).value(); };
  CHECK(faultOf({}).fault == DrawingFault::Empty);
  const DrawnCurve big = ellipseCurve({-0.9, -0.9}, {0.9, 0.9});
  CHECK(faultOf({big, ellipseCurve({0, 0}, {0.01, 0.01})}) == DrawingProblem{DrawingFault::TooSmall, 1});
  const Line bow{{-0.5, -0.5}, {0.5, 0.5}, {0.5, -0.5}, {-0.5, 0.5}};
  CHECK(faultOf({big, polygonCurve(bow)}) == DrawingProblem{DrawingFault::CrossesItself, 1});
  CHECK(faultOf({big, boxCurve({0.5, 0.5}, {1, 1})}) == DrawingProblem{DrawingFault::CurvesCross, 1});
  Drawing many;
  for (int i = 0; i < 17; ++i) many.push_back(boxCurve({-1 + i * 0.11, -0.05}, {-0.92 + i * 0.11, 0.05}));
  CHECK(faultOf(many).fault == DrawingFault::TooMany);
  many.pop_back();
  CHECK_FALSE(problemOf(many));
}

TEST_CASE("a section touches the rib's ends; tall drawings are flattened, others stay in proportion") {
  const SectionShape wide = sectionOf({boxCurve({0.2, 0.1}, {0.6, 0.2})}).value();
  checkSection(wide);
  double low = 9, high = -9;
  for (const SectionPoint p : wide.contours[0]) low = std::min(low, p.y), high = std::max(high, p.y);
  CHECK(low == doctest::Approx(0.5));  // 0.1 / 0.2: the line of the rib stays where it was
  CHECK(high == doctest::Approx(1.0));
  const SectionShape tall = sectionOf({boxCurve({-0.1, -0.8}, {0.1, 0.9})}).value();
  checkSection(tall);
  CHECK(areaOf(tall.contours[0]) == doctest::Approx(4));
}

TEST_CASE("moving, adding and taking points keeps a symmetric drawing symmetric") {
  Rng rng(31);
  const Symmetry symmetry{true, true, 1};
  Drawing drawing = drawFreehand(blob(rng), symmetry).value();
  for (int step = 0; step < 60; ++step) {
    CAPTURE(step);
    if (drawing.empty()) break;
    PointRef ref;
    ref.curve = rng.below(static_cast<std::uint32_t>(drawing.size()));
    ref.point = rng.below(static_cast<std::uint32_t>(drawing[ref.curve].points.size()));
    const SectionPoint at = drawing[ref.curve].points[ref.point].at;
    const SectionPoint to = at + SectionPoint{rng.uniform(-0.05, 0.05), rng.uniform(-0.05, 0.05)};
    const std::size_t before = drawing[ref.curve].points.size();
    switch (rng.below(4)) {
      case 0: {
        const PointRef added = addPoint(drawing, ref, to, symmetry);
        CHECK(drawing[ref.curve].points.size() > before);
        const SectionPoint now = drawing[added.curve].points[added.point].at;
        CHECK((now == to || now.x == 0 || now.y == 0));
        break;
      }
      case 1:
        if (before > 8) removePoint(drawing, ref, symmetry);
        break;
      case 2:
        setCorner(drawing, ref, true, symmetry);
        break;
      default:
        movePoint(drawing, ref, to, symmetry);
    }
    Line points, mirrored;
    for (const DrawnCurve& curve : drawing) {
      for (const DrawnPoint& p : curve.points) {
        points.push_back(p.at);
        mirrored.push_back({-p.at.x, p.at.y});
      }
    }
    CHECK(sameSets(points, mirrored, 0));
  }
}

TEST_CASE("flips undo themselves, four quarter turns are none") {
  Rng rng(8);
  const Drawing drawing = drawFreehand(blob(rng), {}).value();
  CHECK(turned(turned(drawing, Turn::FlipLeftRight), Turn::FlipLeftRight) == drawing);
  CHECK(turned(turned(drawing, Turn::FlipFrontBack), Turn::FlipFrontBack) == drawing);
  Drawing round = drawing;
  for (int i = 0; i < 4; ++i) round = turned(round, Turn::QuarterTurn);
  CHECK(round == drawing);
}

TEST_CASE("every image of a point is an image of every other") {
  for (int fold = 1; fold <= kMostFold; ++fold) {
    const Symmetry symmetry{fold % 2 == 0, fold % 3 == 0, fold};
    const Line first = images({0.31, 0.72}, symmetry);
    for (const SectionPoint p : first) CHECK(sameSets(images(p, symmetry), first, 1e-9));
  }
}

TEST_CASE("an open line begins and ends where it was drawn, stays near it, and has few points") {
  Rng rng(17);
  for (int round = 0; round < 20; ++round) {
    const double from = rng.uniform(0, 2 * kPi);
    const Line line = blob(rng, from, from + rng.uniform(0.5, 3));
    const Result<DrawnCurve> curve = drawOpenLine(line);
    REQUIRE(curve.ok());
    const auto& points = curve.value().points;
    CHECK(points.size() <= 12);
    CHECK(points.front().corner);
    CHECK(points.back().corner);
    CHECK(distance(points.front().at, line.front()) < 1e-12);
    CHECK(distance(points.back().at, line.back()) < 1e-12);
    Line drawn;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      const Line stretch = openStretchOf(curve.value(), i);
      drawn.insert(drawn.end(), stretch.begin(), stretch.end());
    }
    for (const SectionPoint p : line) CHECK(geometry::distanceToLine(p, View(drawn)) < 2 * kFitTolerance);
  }
}

TEST_CASE("an open line keeps its corners, loses its tremor, and two points make none") {
  Rng rng(18);
  Line zigzag;
  const Line corners{{-0.8, 0}, {-0.3, 0.5}, {0.2, -0.3}, {0.8, 0.2}};
  for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
    for (int k = 0; k < 60; ++k) zigzag.push_back(lerp(corners[i], corners[i + 1], k / 60.0));
  }
  zigzag.push_back(corners.back());
  const Result<DrawnCurve> curve = drawOpenLine(shaky(zigzag, rng, 0.003));
  REQUIRE(curve.ok());
  Line kept;
  for (const DrawnPoint& point : curve.value().points) {
    if (point.corner) kept.push_back(point.at);
  }
  CHECK(sameSets(kept, corners, 0.03));
  CHECK_FALSE(drawOpenLine(Line{{0, 0}, {0.5, 0}}).ok());
  CHECK_FALSE(drawOpenLine(Line{{0, 0}, {0.5, std::nan("")}, {1, 1}}).ok());
}
