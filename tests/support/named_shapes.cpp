#include "tests/support/named_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/rng.h"
#include "engine/geometry/polyline.h"
#include "tests/support/outlines.h"

namespace spineloft::testing {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr PicturePoint kMiddle{200, 200};

PicturePoint polar(PicturePoint centre, double radius, double angle) {
  return centre + PicturePoint{radius * std::cos(angle), radius * std::sin(angle)};
}

void addArc(Outline& outline, PicturePoint centre, double radius, double from, double to, int steps) {
  for (int i = 0; i <= steps; ++i) outline.push_back(polar(centre, radius, from + (to - from) * i / steps));
}

Outline stadium(double half, double radius) {
  Outline outline;
  addArc(outline, kMiddle + PicturePoint{half, 0}, radius, -kPi / 2, kPi / 2, 60);
  addArc(outline, kMiddle - PicturePoint{half, 0}, radius, kPi / 2, 3 * kPi / 2, 60);
  return outline;
}

/// Between two equal arcs through (200 ± half, 200), `high` above and below the middle.
Outline lens(double half, double high) {
  const double radius = (half * half + high * high) / (2 * high), down = radius - high;
  const double wide = std::asin(half / radius);
  Outline outline;
  addArc(outline, kMiddle + PicturePoint{0, down}, radius, -kPi / 2 - wide, -kPi / 2 + wide, 100);
  addArc(outline, kMiddle - PicturePoint{0, down}, radius, kPi / 2 - wide, kPi / 2 + wide, 100);
  return outline;
}

Outline star() {
  Outline outline;
  for (int i = 0; i < 10; ++i) outline.push_back(polar(kMiddle, i % 2 == 0 ? 180 : 80, -kPi / 2 + i * kPi / 5));
  return outline;
}

/// A round palm with five fingers that end round.
Outline hand() {
  constexpr double kPalm = 80, kFinger = 17, kLength = 165;
  const PicturePoint palm{200, 255};
  const double half = std::asin(kFinger / kPalm);
  Outline outline;
  const std::vector<double> fingers{-2.9, -2.15, -1.65, -1.15, -0.65};
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    const double at = fingers[i];
    const double next = i + 1 < fingers.size() ? fingers[i + 1] : fingers[0] + 2 * kPi;
    outline.push_back(polar(palm, kPalm, at - half));
    addArc(outline, polar(palm, kLength - kFinger, at), kFinger, at - kPi / 2, at + kPi / 2, 16);
    addArc(outline, palm, kPalm, at + half, next - half, std::max(2, static_cast<int>((next - at) * 12)));
    outline.pop_back();
  }
  return outline;
}

/// Round at its stalk, pointed at its tip.
Outline leaf() {
  Outline outline;
  for (int i = 0; i < 200; ++i) {
    const double a = 2 * kPi * i / 200, x = std::cos(a);
    outline.push_back(kMiddle + PicturePoint{160 * x, 80 * std::sin(a) * (0.62 - 0.38 * x)});
  }
  return outline;
}

/// A ring with a gap at the right, a bar in it.
Outline letterG() {
  Outline outline;
  addArc(outline, kMiddle, 150, -0.7, -2 * kPi + 0.35, 90);
  outline.push_back({340, 180});
  outline.push_back({230, 180});
  outline.push_back({230, 230});
  outline.push_back({280, 230});
  addArc(outline, kMiddle, 90, -2 * kPi + 0.42, -0.7, 70);
  return outline;
}

NamedShape shape(const char* name, geometry::Contours drawn, int ends, int rings) {
  const Result<geometry::Contours> clean = geometry::cleanRegion(drawn, 0, {400, 400});
  return {name, clean.value(), ends, rings};
}

std::vector<NamedShape> makeShapes() {
  const Outline square = rectangle(80, 80, 320, 320), bar = rectangle(40, 140, 360, 260);
  const Outline triangle{{200, 50}, {360, 330}, {40, 330}};
  const Outline t{{40, 60}, {360, 60}, {360, 120}, {230, 120}, {230, 350}, {170, 350}, {170, 120}, {40, 120}};
  const Outline e{{60, 40},   {320, 40},  {320, 100}, {120, 100}, {120, 170}, {320, 170},
                  {320, 230}, {120, 230}, {120, 300}, {320, 300}, {320, 360}, {60, 360}};
  const Outline x{{40, 75},   {75, 40},   {200, 165}, {325, 40}, {360, 75}, {235, 200},
                  {360, 325}, {325, 360}, {200, 235}, {75, 360}, {40, 325}, {165, 200}};
  const Outline h{{60, 40},   {130, 40},  {130, 165}, {270, 165}, {270, 40},  {340, 40},
                  {340, 360}, {270, 360}, {270, 235}, {130, 235}, {130, 360}, {60, 360}};
  const Outline a{{200, 20}, {350, 370}, {285, 370}, {255, 300}, {145, 300}, {115, 370}, {50, 370}};
  const Outline insideA{{200, 160}, {236, 250}, {164, 250}};
  return {shape("disc", {ellipse(kMiddle, 120, 120, 240)}, 0, 0),
          shape("square", {square}, 0, 0),
          shape("ellipse", {ellipse(kMiddle, 170, 80, 240)}, 2, 0),
          shape("stadium", {stadium(120, 60)}, 2, 0),
          shape("rectangle", {bar}, 2, 0),
          shape("lens", {lens(160, 50)}, 2, 0),
          shape("triangle", {triangle}, 3, 0),
          shape("T", {t}, 3, 0),
          shape("E", {e}, 3, 0),
          shape("X", {x}, 4, 0),
          shape("H", {h}, 4, 0),
          shape("star", {star()}, 5, 0),
          shape("hand", {hand()}, 5, 0),
          shape("leaf", {leaf()}, 2, 0),
          shape("ring", {ellipse(kMiddle, 150, 150, 240), ellipse(kMiddle, 70, 70, 120)}, 0, 1),
          shape("eight",
                {ellipse(kMiddle, 120, 185, 260), ellipse({200, 110}, 45, 45, 100), ellipse({200, 285}, 50, 50, 100)},
                0, 2),
          shape("A", {a, insideA}, 3, 1),
          shape("G", {letterG()}, 2, 0)};
}

std::vector<double> randomKnots(Rng& rng, std::size_t count) {
  std::vector<double> knots(count);
  for (double& knot : knots) knot = rng.uniform(-1, 1);
  return knots;
}

}  // namespace

const std::vector<NamedShape>& namedShapes() {
  static const std::vector<NamedShape> kShapes = makeShapes();
  return kShapes;
}

const NamedShape& namedShape(const std::string& name) {
  return *std::ranges::find(namedShapes(), name, &NamedShape::name);
}

geometry::Contours trembling(const geometry::Contours& contours, double most, double wave, std::uint64_t seed,
                             double spacing) {
  Rng rng(seed);
  geometry::Contours out = geometry::sampleRegion(contours, spacing);
  for (Outline& outline : out) {
    const Outline was = outline;
    const std::size_t n = was.size();
    double length = 0;
    for (std::size_t i = 0; i < n; ++i) length += distance(was[i], was[(i + 1) % n]);
    const std::vector<double> knots =
        randomKnots(rng, std::max<std::size_t>(3, static_cast<std::size_t>(length / wave)));
    double s = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double at = s / length * static_cast<double>(knots.size());
      const auto k = static_cast<std::size_t>(at) % knots.size();
      const double share = (1 - std::cos(kPi * (at - std::floor(at)))) / 2;
      const double off = most * (knots[k] + (knots[(k + 1) % knots.size()] - knots[k]) * share);
      const PicturePoint along = normalized(was[(i + 1) % n] - was[(i + n - 1) % n]);
      outline[i] = was[i] + PicturePoint{-along.y, along.x} * off;
      s += distance(was[i], was[(i + 1) % n]);
    }
  }
  return geometry::cleanRegion(out, 0, {400, 400}).value();
}

geometry::Contours turnedAndScaled(const geometry::Contours& contours, double angle, double scale) {
  geometry::Contours out = contours;
  const double c = std::cos(angle) * scale, s = std::sin(angle) * scale;
  for (Outline& outline : out) {
    for (PicturePoint& p : outline) {
      const PicturePoint d = p - kMiddle;
      p = kMiddle + PicturePoint{c * d.x - s * d.y, s * d.x + c * d.y};
    }
  }
  return out;
}

}  // namespace spineloft::testing
