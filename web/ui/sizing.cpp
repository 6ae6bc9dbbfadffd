#include "web/ui/sizing.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "web/model/json.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kGapShare = 0.15;  // between model and thing, of the model's height

constexpr std::array kThings = {
    Thing{"coin", "Coin", "As tall as a coin: {length}", "a coin, {length}", 23, 1},
    Thing{"cupcake", "Cupcake", "As tall as a cupcake: {length}", "a cupcake, {length}", 70, 0.92},
    Thing{"hand", "Hand", "As tall as a hand: {length}", "a hand, {length}", 180, 0.72}};

using Line = std::vector<ThingPoint>;

void arc(Line& line, ThingPoint centre, double radius, double from, double to) {
  const int steps = 2 + static_cast<int>(std::abs(to - from) * 8);
  for (int i = 0; i <= steps; ++i) {
    const double angle = from + (to - from) * i / steps;
    line.push_back({centre.x + radius * std::cos(angle), centre.y + radius * std::sin(angle)});
  }
}

std::vector<Line> coin() {
  std::vector<Line> lines(3);
  arc(lines[0], {0, 0.5}, 0.5, 0, 2 * kPi);
  arc(lines[1], {0, 0.5}, 0.4, 0, 2 * kPi);
  lines[2] = {{-0.1, 0.6}, {0.02, 0.7}, {0.02, 0.3}};
  return lines;
}

std::vector<Line> cupcake() {
  std::vector<Line> lines;
  lines.push_back({{-0.28, 0}, {0.28, 0}, {0.38, 0.42}, {-0.38, 0.42}, {-0.28, 0}});
  for (const double x : {-0.19, 0.0, 0.19}) lines.push_back({{x * 0.75, 0.03}, {x, 0.39}});
  Line frosting;
  arc(frosting, {0.36, 0.5}, 0.1, -kPi / 2, kPi / 2);
  arc(frosting, {0.25, 0.66}, 0.1, -0.2, kPi * 0.6);
  arc(frosting, {0, 0.71}, 0.15, kPi * 0.25, kPi * 0.75);
  arc(frosting, {-0.25, 0.66}, 0.1, kPi * 0.4, kPi * 1.2 - 0.2);
  arc(frosting, {-0.36, 0.5}, 0.1, kPi / 2, kPi * 1.5);
  lines.push_back(std::move(frosting));
  lines.emplace_back();
  arc(lines.back(), {0, 0.93}, 0.07, 0, 2 * kPi);
  return lines;
}

/// A curve through the points (Catmull and Rom 1974).
Line through(const Line& points) {
  constexpr int kSteps = 5;
  Line line;
  const std::size_t n = points.size();
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const ThingPoint a = points[i == 0 ? 0 : i - 1], b = points[i], c = points[i + 1],
                     d = points[std::min(i + 2, n - 1)];
    for (int k = 0; k < kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps;
      line.push_back(
          (b * 2 + (c - a) * t + (a * 2 - b * 5 + c * 4 - d) * (t * t) + (b * 3 - a - c * 3 + d) * (t * t * t)) / 2);
    }
  }
  line.push_back(points.back());
  return line;
}

std::vector<Line> hand() {
  return {through({{-0.14, 0},     {-0.15, 0.1},   {-0.23, 0.24},  {-0.34, 0.38}, {-0.4, 0.47},   {-0.39, 0.525},
                   {-0.33, 0.52},  {-0.26, 0.45},  {-0.205, 0.42}, {-0.2, 0.55},  {-0.235, 0.72}, {-0.25, 0.85},
                   {-0.215, 0.91}, {-0.17, 0.86},  {-0.135, 0.72}, {-0.1, 0.58},  {-0.095, 0.74}, {-0.095, 0.92},
                   {-0.05, 1.0},   {-0.005, 0.92}, {0.01, 0.74},   {0.02, 0.58},  {0.05, 0.72},   {0.07, 0.88},
                   {0.115, 0.945}, {0.15, 0.88},   {0.14, 0.71},   {0.125, 0.55}, {0.175, 0.64},  {0.215, 0.73},
                   {0.262, 0.765}, {0.285, 0.71},  {0.255, 0.59},  {0.23, 0.44},  {0.22, 0.28},   {0.16, 0.1},
                   {0.15, 0}})};
}

// The unit alone of a length as the page says it.
std::string_view unitOf(const char* length) {
  const std::string_view said = words::tr(length, {{"n", 1}});
  return said.substr(std::min(said.size(), said.find(' ') + 1));
}

}  // namespace

std::span<const Thing> things() { return kThings; }

std::optional<std::size_t> findThing(std::string_view key) {
  for (std::size_t i = 0; i < kThings.size(); ++i) {
    if (kThings[i].key == key) return i;
  }
  return std::nullopt;
}

std::vector<std::vector<ThingPoint>> thingLines(std::size_t thing) {
  switch (thing) {
    case 0:
      return coin();
    case 1:
      return cupcake();
    default:
      return hand();
  }
}

std::optional<double> millimetresFrom(std::string_view text) {
  std::string plain;
  for (const char c : text) {
    plain += c == ',' ? '.' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  constexpr const char* kSpace = " \t\n";
  const std::size_t first = plain.find_first_not_of(kSpace);
  const std::size_t unitAt =
      std::min(plain.size(), plain.find_first_not_of("+-.0123456789", std::min(first, plain.size())));
  if (first >= unitAt) return std::nullopt;
  const std::optional<double> value = numberFrom(std::string_view(plain).substr(first, unitAt - first));
  if (!value) return std::nullopt;
  std::string_view unit = std::string_view(plain).substr(unitAt);
  while (!unit.empty() && std::isspace(static_cast<unsigned char>(unit.front()))) unit.remove_prefix(1);
  while (!unit.empty() && std::isspace(static_cast<unsigned char>(unit.back()))) unit.remove_suffix(1);
  // In Latin letters, or as the page says it in its language.
  const auto is = [&](std::string_view latin, const char* length) { return unit == latin || unit == unitOf(length); };
  if (is("mm", "{n} mm")) return *value;
  if (unit.empty() || is("cm", "{n} cm")) return *value * 10;
  if (is("m", "{n} m")) return *value * 1000;
  return std::nullopt;
}

ThingPlace placeBeside(const Thing& thing, const pipeline::WorldBounds& bounds, double heightMm, const Camera& camera) {
  const WorldPoint size = bounds.high - bounds.low, centre = bounds.centre();
  ThingPlace place;
  place.right = camera.right();
  place.scale = size.y * thing.mm / heightMm;
  // Half as wide as the model is from there.
  const double half = (std::abs(place.right.x) * size.x + std::abs(place.right.z) * size.z) / 2;
  const double away = half + kGapShare * size.y + thing.width * place.scale / 2;
  place.foot = WorldPoint{centre.x, bounds.low.y, centre.z} - place.right * away;
  return place;
}

}  // namespace spineloft::app
