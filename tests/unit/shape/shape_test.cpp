#include "engine/shape/shape.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>

#include "engine/base/rng.h"
#include "engine/geometry/polygon.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/outline_match.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::shape;
using namespace spineloft::testing;
using geometry::Contours;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kPaper{400, 400};
/// As large as the front picture; z = 0 at x = 200.
constexpr geometry::View kSide{geometry::ViewFrom::Right, 200, 1, 0}, kTop{geometry::ViewFrom::Top, 200, 1, 0};
const std::optional<geometry::View> kFront;

ShapeParams upright(Primitive primitive = Primitive::Ball, double width = 160) {
  ShapeParams params;
  params.primitive = primitive;
  params.axis = {{200, 300}, {200, 100}};
  params.width = width;
  return params;
}

Shaped made(const ShapeParams& params, const std::vector<SeenOutline>& outlines = {}) {
  Result<Shaped> shaped = makeShape(params, outlines, kPaper);
  REQUIRE_MESSAGE(shaped.ok(), failureSentence(shaped.ok() ? Failure{} : shaped.failure()));
  requireLawful(shaped.value().mesh);
  return std::move(shaped).value();
}
double volumeOf(const Shaped& shaped) { return mesh::inspect(shaped.mesh).volume; }

Failure failureOf(const ShapeParams& params, const std::vector<SeenOutline>& outlines) {
  const Result<Shaped> shaped = makeShape(params, outlines, kPaper);
  REQUIRE_FALSE(shaped.ok());
  return shaped.failure();
}

/// A closed outline between two sides x(t), t from the top (y = 100) to the bottom (y = 300), close at both ends.
Contours between(const std::function<double(double)>& low, const std::function<double(double)>& high, int points) {
  Contours outline(1);
  const auto at = [&](int i) { return (1 - std::cos(kPi * i / points)) / 2; };
  for (int i = 0; i <= points; ++i) outline[0].push_back({high(at(i)), 100 + 200 * at(i)});
  for (int i = points - 1; i > 0; --i) outline[0].push_back({low(at(i)), 100 + 200 * at(i)});
  return outline;
}
/// A bent thing of varying width.
Contours bent(Rng& rng, int points) {
  const double sway = rng.uniform(0, 40), waves = rng.uniform(1, 5), phase = rng.uniform(0, 6),
               wide = rng.uniform(25, 60);
  const double left = rng.uniform(0, 6), right = rng.uniform(0, 6);
  const auto side = [=](double sign, double wave) {
    return [=](double t) {
      const double half = wide * 2 * std::sqrt(t * (1 - t)) * (1 + 0.25 * std::sin(6 * t + wave));
      return 200 + sway * std::sin(waves * t + phase) + sign * half;
    };
  };
  return between(side(-1, left), side(1, right), points);
}

void requireMatch(const Shaped& shaped, const std::optional<geometry::View>& view, const Contours& outline) {
  const auto match = pipeline::matchOutline(shaped.mesh, view, outline);
  CHECK(match.iou >= 0.99);
  CHECK(match.largest <= 0.01);
  CHECK(match.mean <= 0.0015);
}

}  // namespace

TEST_CASE("primitives have the volumes of their solids") {
  const double r = 80, h = 200;
  const auto volume = [&](Primitive primitive, double width = 160) {
    return volumeOf(made(upright(primitive, width)));
  };
  CHECK(volume(Primitive::Ball, h) == doctest::Approx(kPi * h * h * h / 6).epsilon(5e-3));
  CHECK(volume(Primitive::Box) == doctest::Approx(4 * r * r * h).epsilon(1e-6));
  CHECK(volume(Primitive::Cylinder) == doctest::Approx(kPi * r * r * h).epsilon(2e-3));
  CHECK(volume(Primitive::Cone) == doctest::Approx(kPi * r * r * h / 3).epsilon(2e-3));
  CHECK(volume(Primitive::Pyramid) == doctest::Approx(4 * r * r * h / 3).epsilon(1e-3));
  CHECK(volume(Primitive::HalfBall) == doctest::Approx(kPi * r * r * h * 2 / 3).epsilon(5e-3));
  CHECK(volume(Primitive::Capsule) ==
        doctest::Approx(kPi * r * r * (h - 2 * r) + kPi * r * r * r * 4 / 3).epsilon(5e-3));
  // ∫ (1 − x²)/(1 + 2dx + d²) dx over −1…1 with d = ¼, by Simpson.
  double egg = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double x = -1 + i / 500.0, d = 0.25;
    egg += (i == 0 || i == 1000 ? 1 : i % 2 == 1 ? 4 : 2) * (1 - x * x) / (1 + 2 * d * x + d * d) / 1500;
  }
  CHECK(volume(Primitive::Egg) == doctest::Approx(egg * kPi * r * r * h / 2).epsilon(5e-3));
}

TEST_CASE("every primitive is one piece without a handle, whatever stands about it") {
  Rng rng(1);
  for (const PrimitiveName& name : primitiveNames()) {
    for (int round = 0; round < rounds(6); ++round) {
      CAPTURE(name.key);
      ShapeParams params = upright(name.primitive, rng.uniform(20, 200));
      params.axis = {{rng.uniform(50, 350), rng.uniform(50, 350)}, {rng.uniform(50, 350), rng.uniform(50, 350)}};
      params.depth = {rng.below(2) == 0 ? DepthMode::Round : DepthMode::Kept, rng.uniform(0.2, 3)};
      const auto report = requireLawful(made(params).mesh);
      CHECK(report.genus == 0);
      CHECK(report.shells == 1);
    }
  }
}

TEST_CASE("two circles make a ball, two ellipses an ellipsoid") {
  struct Case {
    double x, y, z;
  };
  for (const auto& [x, y, z] : {Case{80, 80, 80}, Case{50, 80, 30}}) {
    const Contours front{ellipse({200, 200}, x, y, 180)}, side{ellipse({200, 200}, z, y, 180)};
    const Shaped shaped = made(upright(), {{kFront, front}, {kSide, side}});
    double most = 0;
    for (const auto& p : shaped.mesh.positions) {
      const double off = std::hypot((p[0] - 200) / x, (p[1] + 200) / y, p[2] / z);
      most = std::max(most, std::abs(off - 1));
    }
    CHECK(most <= 1e-3);
    CHECK(volumeOf(shaped) == doctest::Approx(kPi * 4 / 3 * x * y * z).epsilon(5e-3));
    CHECK_FALSE(mesh::selfCrossing(shaped.mesh));
  }
}

TEST_CASE("the drawn lines are the silhouettes in both views") {
  Rng rng(2);
  for (int round = 0; round < rounds(24); ++round) {
    CAPTURE(round);
    const Contours front = bent(rng, 64), side = bent(rng, 80);
    const Shaped shaped = made(upright(), {{kFront, front}, {kSide, side}});
    requireMatch(shaped, kFront, front);
    requireMatch(shaped, kSide, side);
    CHECK_FALSE(mesh::selfCrossing(shaped.mesh));
  }
}

TEST_CASE("where a hand trembles the shape stays near the clean outline") {
  Rng rng(3);
  int views = 0, farther = 0;
  for (int round = 0; round < rounds(12); ++round) {
    CAPTURE(round);
    const Contours front = bent(rng, 200), side = bent(rng, 200);
    Contours drawn = front, drawnSide = side;
    bool isLine = true;
    for (Contours* outline : {&drawn, &drawnSide}) {  // every point by up to 1 of 200 each way
      for (PicturePoint& p : outline->front()) p += PicturePoint{rng.uniform(-1, 1), rng.uniform(-1, 1)};
      std::vector<SectionPoint> points;
      for (const PicturePoint& p : outline->front()) points.push_back({p.x, p.y});
      isLine = isLine && geometry::areSimple(points, std::array{points.size()});
    }
    const std::vector<SeenOutline> seen{{kFront, drawn}, {kSide, drawnSide}};
    if (!makeShape(upright(), seen, kPaper).ok()) {
      CHECK_FALSE(isLine);  // a narrow one may cross itself then
      continue;
    }
    const Shaped shaped = made(upright(), seen);
    for (const double share : {pipeline::matchOutline(shaped.mesh, kFront, front).iou,
                               pipeline::matchOutline(shaped.mesh, kSide, side).iou}) {
      CHECK(share >= 0.98);
      farther += share < 0.985;
      ++views;
    }
  }
  CHECK(farther <= views / 100);
}

TEST_CASE("an outline that steps back along the axis is still the silhouette") {
  // A mushroom: under its cap the line comes back up by 14 of 200.
  Contours mushroom{{{200, 100},
                     {240, 108},
                     {270, 130},
                     {280, 160},
                     {262, 152},
                     {230, 146},
                     {222, 200},
                     {225, 300},
                     {175, 300},
                     {178, 200},
                     {170, 146},
                     {138, 152},
                     {120, 160},
                     {130, 130},
                     {160, 108}}};
  const Contours side{ellipse({200, 200}, 60, 100, 120)};
  for (const bool both : {false, true}) {
    std::vector<SeenOutline> outlines{{kFront, mushroom}};
    if (both) outlines.push_back({kSide, side});
    const auto match = pipeline::matchOutline(made(upright(), outlines).mesh, kFront, mushroom);
    CHECK(match.iou >= 0.98);
    CHECK(match.largest <= 0.02);
  }
}

TEST_CASE("two open lines are the sides of a limb, in any order and direction, with ends that slant") {
  const Contours limb{{{150, 100}, {160, 200}, {170, 300}}, {{250, 112}, {230, 200}, {220, 290}}};
  const Shaped shaped = made(upright(), {{kFront, limb}});
  const auto match = pipeline::matchOutline(shaped.mesh, kFront, limb);
  CHECK(match.iou >= 0.985);
  CHECK(match.largest <= 0.01);
  Contours other{limb[1], limb[0]};
  std::ranges::reverse(other[0]);
  CHECK(made(upright(), {{kFront, other}}).mesh == shaped.mesh);
}

TEST_CASE("levels stand on the corners of an outline") {
  const Contours house{{{200, 100}, {260, 171}, {240, 171}, {240, 300}, {160, 300}, {160, 171}, {140, 171}}};
  const auto match = pipeline::matchOutline(made(upright(), {{kFront, house}}).mesh, kFront, house);
  CHECK(match.iou >= 0.99);
  CHECK(match.largest <= 0.01);
  const Contours box{rectangle(150, 100, 250, 300)};
  const Shaped shaped = made(upright(Primitive::Box), {{kFront, box}});
  CHECK(volumeOf(shaped) == doctest::Approx(100 * 100 * 200).epsilon(1e-6));
}

TEST_CASE("depth is as round as the outline, or the primitive's own") {
  // The rubber ring of the paper: 3 cm wide, drawn to 3.6.
  const Contours wide{rectangle(200 - 90, 100, 200 + 90, 300)};
  ShapeParams params = upright(Primitive::Cylinder, 150);
  const auto depthOf = [&] {
    const mesh::Bounds bounds = mesh::boundsOf(made(params, {{kFront, wide}}).mesh);
    return bounds.high[2] - bounds.low[2];
  };
  params.depth.mode = DepthMode::Kept;
  CHECK(depthOf() == doctest::Approx(150));
  params.depth.mode = DepthMode::Round;
  CHECK(depthOf() == doctest::Approx(180));
  params.depth.ratio = 0.5;
  CHECK(depthOf() == doctest::Approx(90));
}

TEST_CASE("an outline seen along the axis is the section") {
  Rng rng(4);
  const Contours front = bent(rng, 64);
  Contours heart{{{200, 230}, {150, 200}, {140, 170}, {165, 155}, {200, 175}, {240, 150}, {265, 175}, {250, 205}}};
  ShapeParams cylinder = upright(Primitive::Cylinder, 125);
  const Shaped shaped = made(cylinder, {{kTop, heart}});
  const mesh::Bounds bounds = mesh::boundsOf(shaped.mesh);
  CHECK(bounds.high[2] - bounds.low[2] == doctest::Approx(80));
  CHECK(bounds.high[0] - bounds.low[0] == doctest::Approx(125));
  const Contours side = bent(rng, 64);
  const Shaped three = made(upright(), {{kFront, front}, {kSide, side}, {kTop, heart}});
  requireMatch(three, kFront, front);
  requireMatch(three, kSide, side);
}

TEST_CASE("a level axis takes its depth from the top, and a slanted one from the side") {
  const Contours front{ellipse({200, 200}, 90, 50, 120)}, top{ellipse({200, 200}, 90, 30, 120)};
  ShapeParams level = upright();
  level.axis = {{110, 200}, {290, 200}};
  const Shaped shaped = made(level, {{kFront, front}, {kTop, top}});
  requireMatch(shaped, kFront, front);
  requireMatch(shaped, kTop, top);
  Rng rng(5);
  const Contours tall = bent(rng, 64), side = bent(rng, 64);
  ShapeParams slanted = upright();
  slanted.axis = {{160, 300}, {240, 100}};
  const Shaped second = made(slanted, {{kFront, tall}, {kSide, side}});
  requireMatch(second, kFront, tall);
  requireMatch(second, kSide, side);
}

TEST_CASE("views from right, left and back are each other's mirror images") {
  Rng rng(6);
  const Contours front = bent(rng, 64), side = bent(rng, 64);
  const auto flipped = [](const Contours& outline) {
    Contours out = outline;
    for (PicturePoint& p : out.front()) p.x = 400 - p.x;
    return out;
  };
  const Contours leftSide = flipped(side), behind = flipped(front);
  const geometry::View left{geometry::ViewFrom::Left, 200, 1, 0}, back{geometry::ViewFrom::Back, 0, 1, 400};
  const Shaped right = made(upright(), {{kFront, front}, {kSide, side}});
  requireMatch(made(upright(), {{kFront, front}, {left, leftSide}}), kSide, side);
  requireMatch(made(upright(), {{back, behind}, {kSide, side}}), kFront, front);
  CHECK(volumeOf(made(upright(), {{back, behind}, {left, leftSide}})) == doctest::Approx(volumeOf(right)));
}

TEST_CASE("a mirrored recipe makes the mirrored solid, a larger one the larger solid") {
  Rng rng(7);
  const Contours front = bent(rng, 64), side = bent(rng, 64);
  const Shaped shaped = made(upright(), {{kFront, front}, {kSide, side}});
  Contours mirrored = front;
  for (PicturePoint& p : mirrored.front()) p.x = 400 - p.x;
  const Shaped other = made(upright(), {{kFront, mirrored}, {kSide, side}});
  REQUIRE(other.mesh.positions.size() == shaped.mesh.positions.size());
  // Points in the order of the section, which goes the other way round.
  const auto sorted = [](const Shaped& s, float sign) {
    auto points = s.mesh.positions;
    for (auto& p : points) p[0] = sign * (p[0] - 200);
    std::ranges::sort(points, {}, [](const auto& p) { return std::array{std::round(p[1] * 50), p[0] + p[2]}; });
    return points;
  };
  double most = 0;
  const auto a = sorted(shaped, 1), b = sorted(other, -1);
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max({most, std::abs(a[i][0] - b[i][0]) + 0.0, std::abs(a[i][2] - b[i][2]) + 0.0});
  }
  CHECK(most <= 2e-4);  // 1e-6 of the size
  const double scale = 2.5;
  Contours large = front, largeSide = side;
  for (Contours* outline : {&large, &largeSide}) {
    for (PicturePoint& p : outline->front()) p = p * scale;
  }
  ShapeParams params = upright();
  params.axis = {params.axis.from * scale, params.axis.to * scale};
  params.width *= scale;
  geometry::View view = kSide;
  view.middle *= scale;
  const Shaped larger = made(params, {{kFront, large}, {view, largeSide}});
  double off = 0;
  for (std::size_t i = 0; i < larger.mesh.positions.size(); ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      off = std::max(off, std::abs(larger.mesh.positions[i][axis] / scale - shaped.mesh.positions[i][axis]) + 0.0);
    }
  }
  CHECK(off <= 1e-4 * 200);
}

TEST_CASE("how finely an outline was drawn changes little") {
  int farther = 0;
  const int all = rounds(6);
  for (int round = 0; round < all; ++round) {
    Rng first(round + 8), second(round + 8);
    const Contours dense = bent(first, 400), sparse = bent(second, 60);
    const Shaped a = made(upright(), {{kFront, dense}}), b = made(upright(), {{kFront, sparse}});
    CHECK(volumeOf(a) == doctest::Approx(volumeOf(b)).epsilon(1e-2));
    farther += volumeOf(a) != doctest::Approx(volumeOf(b)).epsilon(3e-3);
    CHECK(pipeline::matchOutline(b.mesh, kFront, dense).largest <= 0.01);
  }
  CHECK(farther <= all / 50);
}

TEST_CASE("ends with a width are flat, round, pointed or open") {
  ShapeParams params = upright(Primitive::Cylinder);
  const auto with = [&](sections::CapStyle start, sections::CapStyle end) {
    params.caps = {start, end};
    const Shaped shaped = made(params);
    CHECK_FALSE(mesh::selfCrossing(shaped.mesh));
    return mesh::inspect(shaped.mesh);
  };
  using enum sections::CapStyle;
  const double flat = with(Flat, Flat).volume;
  CHECK(with(Round, Flat).volume > flat * 1.1);
  CHECK(with(Flat, Round).volume == doctest::Approx(with(Round, Flat).volume).epsilon(1e-6));
  // A cone twice as long as the half width.
  CHECK(with(Flat, Pointed).volume == doctest::Approx(flat * (1 + 2 * 80.0 / 200 / 3)).epsilon(1e-3));
  CHECK(with(Open, Flat).volume < flat * 0.6);
  CHECK(with(Open, Open).genus == 1);
}

TEST_CASE("what makes no shape is refused with what is wrong") {
  const Contours circle{ellipse({200, 200}, 80, 80, 60)}, dot{ellipse({200, 200}, 1, 1, 20)};
  Contours eight{{{150, 100}, {250, 300}, {150, 300}, {250, 100}}}, broken = circle;
  broken[0][3].x = std::numeric_limits<double>::quiet_NaN();
  const Contours low{ellipse({200, 290}, 80, 80, 60)}, tall{ellipse({200, 200}, 80, 120, 60)};
  const Contours back{
      {{200, 100}, {260, 100}, {260, 300}, {240, 300}, {240, 150}, {160, 150}, {160, 300}, {140, 300}, {140, 100}}};
  CHECK(failureOf(upright(), {{kFront, broken}}).error == Error::StrokeNotFinite);
  CHECK(failureOf(upright(), {{kFront, dot}}).error == Error::RegionEmpty);
  CHECK(failureOf(upright(), {{kFront, eight}}).detail == "the outline crosses itself");
  CHECK(failureOf(upright(), {{kFront, circle}, {kSide, tall}}).detail ==
        "the side outline is 50 % longer than the front one");
  CHECK(failureOf(upright(), {{kFront, circle}, {kSide, low}}).detail.find("beside") != std::string::npos);
  CHECK(failureOf(upright(), {{kFront, circle}, {kFront, circle}}).detail.find("remove one") != std::string::npos);
  CHECK(failureOf(upright(), {{kFront, {}}}).error == Error::ShapeInvalid);
  const Contours crossing{{{150, 100}, {250, 300}}, {{250, 100}, {150, 300}}};
  CHECK(failureOf(upright(), {{kFront, crossing}}).detail.find("cross") != std::string::npos);
  Contours hook{{{200, 100}, {240, 300}, {260, 300}, {280, 150}, {270, 320}, {160, 310}}};
  CHECK(failureOf(upright(), {{kFront, hook}}).detail.find("turns back") != std::string::npos);
  ShapeParams wrong = upright();
  for (double* value : {&wrong.width, &wrong.depth.ratio, &wrong.axis.from.x}) {
    const double kept = *value;
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), 1e9, -1e9}) {
      *value = bad;
      CHECK(failureOf(wrong, {}).error == Error::ValueOutOfRange);
    }
    *value = kept;
  }
}

TEST_CASE("random recipes, a third of them broken, make a lawful solid or a named error") {
  Rng rng(9);
  int solids = 0, errors = 0;
  for (int round = 0; round < rounds(300); ++round) {
    CAPTURE(round);
    ShapeParams params = upright(static_cast<Primitive>(rng.below(8)), rng.uniform(1, 300));
    params.axis.to = {rng.uniform(0, 400), rng.uniform(0, 400)};
    params.depth = {static_cast<DepthMode>(rng.below(2)), rng.uniform(0.05, 8)};
    params.levels = 8 + static_cast<int>(rng.below(80));
    params.sides = 12 + static_cast<int>(rng.below(80));
    params.caps = {static_cast<sections::CapStyle>(rng.below(4)), static_cast<sections::CapStyle>(rng.below(4))};
    if (rng.below(3) == 0) {
      params.section =
          static_cast<sections::SectionPreset>(rng.below(static_cast<std::uint32_t>(sections::SectionPreset::kCount)));
    }
    std::vector<Contours> outlines;
    for (int i = 0; i < 3; ++i) {
      outlines.push_back(rng.below(2) == 0 ? bent(rng, 8 + static_cast<int>(rng.below(60)))
                                           : Contours{blob(rng, {200, 200}, rng.uniform(1, 100),
                                                           3 + static_cast<int>(rng.below(90)))});
      if (rng.below(6) == 0) std::swap(outlines[i][0].front(), outlines[i][0][outlines[i][0].size() / 2]);
      if (rng.below(12) == 0) outlines[i][0].front().y = rng.below(2) == 0 ? 1e9 : std::nan("");
      if (rng.below(8) == 0) outlines[i].push_back(outlines[i].front());
    }
    std::vector<SeenOutline> seen;
    if (rng.below(3) != 0) seen.push_back({kFront, outlines[0]});
    if (rng.below(3) != 0) seen.push_back({kSide, outlines[1]});
    if (rng.below(4) == 0) seen.push_back({kTop, outlines[2]});
    const Result<Shaped> shaped = makeShape(params, seen, kPaper);
    if (shaped.ok()) {
      requireLawful(shaped.value().mesh);
      ++solids;
    } else {
      CHECK(shaped.error() != Error::Cancelled);
      ++errors;
    }
  }
  CHECK(solids > errors / 4);
  CHECK(errors > 0);
}
