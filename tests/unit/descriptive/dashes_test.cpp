// Dashes drawn by hand are one hidden line; hatching and short details stay what they are.
#include "engine/descriptive/dashes.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "engine/base/rng.h"
#include "engine/descriptive/lines.h"
#include "engine/geometry/polyline.h"

namespace spineloft::descriptive {
namespace {

constexpr double kBoard = 800;

/// Something large beside what is tested, as a drawing has.
Line body(Rng& rng) {
  Line line{{}, {}, true};
  const double a = rng.uniform(250, 400), b = rng.uniform(200, 400);
  for (int i = 0; i < 60; ++i) {
    const double t = 2 * std::numbers::pi * i / 60;
    line.points.push_back({500 + a * std::cos(t), 500 + b * std::sin(t)});
  }
  return line;
}

/// A smooth line: straight, an arc, or one that swings once.
std::vector<PicturePoint> smoothLine(Rng& rng) {
  const double length = rng.uniform(0.25, 0.9) * kBoard, swing = rng.uniform(-0.25, 0.25) * length;
  const double twice = rng.below(2) == 0 ? 1 : 2, turn = rng.uniform(0, 2 * std::numbers::pi);
  const PicturePoint along{std::cos(turn), std::sin(turn)}, side{-along.y, along.x};
  std::vector<PicturePoint> line;
  for (int i = 0; i <= 400; ++i) {
    const double t = i / 400.0;
    line.push_back(PicturePoint{500, 500} + along * ((t - 0.5) * length) +
                   side * (swing * std::sin(std::numbers::pi * twice * t) / twice));
  }
  return line;
}

/// A stroke by hand from a to b along `line`.
Line stroke(const std::vector<PicturePoint>& line, const std::vector<double>& s, double from, double to, double tremor,
            Rng& rng) {
  Line out{{}, {}, false};
  const int n = std::max(2, static_cast<int>((to - from) / 4));
  for (int i = 0; i <= n; ++i) {
    const PicturePoint p =
        geometry::pointAt(std::span<const PicturePoint>(line), std::span<const double>(s), from + (to - from) * i / n);
    out.points.push_back(p + PicturePoint{rng.uniform(-tremor, tremor), rng.uniform(-tremor, tremor)});
  }
  return out;
}

/// A dashed line and the seen line whose ends it joins, or none where it goes round.
struct Dashed {
  std::vector<Line> dashes;
  std::vector<Line> seen;
};

/// Dashes of a rhythm that varies, each off the line by a little; every fourth time some are drawn backwards. The first
/// and the last end up to a gap away from the ends of the seen line.
Dashed dashed(Rng& rng, bool round) {
  std::vector<PicturePoint> line = smoothLine(rng);
  if (round) {
    const double a = rng.uniform(100, 180), b = rng.uniform(100, 180);
    line.clear();
    for (int i = 0; i <= 400; ++i) {
      const double t = 2 * std::numbers::pi * i / 400;
      line.push_back({500 + a * std::cos(t), 500 + b * std::sin(t)});
    }
  }
  std::vector<double> s;
  geometry::arcLengths(std::span<const PicturePoint>(line), s);
  const double dash = rng.uniform(0.015, 0.03) * kBoard, gap = dash * rng.uniform(0.4, 1.3);
  const bool toAndFro = rng.below(4) == 0;
  // Gaps and dashes in turns, scaled to the line; round, the last gap is one like the others.
  const int count = std::max(3, static_cast<int>(s.back() / (dash + gap)));
  std::vector<double> steps{round ? 0 : gap * rng.uniform(0, 0.9)};
  for (int k = 0; k < count; ++k) {
    steps.push_back(dash * rng.uniform(0.7, 1.3));
    steps.push_back(gap * (k + 1 < count || round ? rng.uniform(0.7, 1.3) : rng.uniform(0, 0.9)));
  }
  const double scale = s.back() / std::accumulate(steps.begin(), steps.end(), 0.0);
  Dashed out;
  double at = 0;
  for (std::size_t k = 0; k < steps.size(); ++k) {
    const double to = at + steps[k] * scale;
    if (k % 2 == 1) {
      out.dashes.push_back(stroke(line, s, at, to, 0.001 * kBoard, rng));
      if (toAndFro && rng.below(2) == 0) std::ranges::reverse(out.dashes.back().points);
    }
    at = to;
  }
  if (!round) {
    const PicturePoint middle = lerp(line.front(), line.back(), 0.5), way = line.back() - line.front();
    out.seen.push_back({{line.front(), middle + PicturePoint{-way.y, way.x}, line.back()}, {}, false});
  }
  return out;
}

/// Strokes side by side, drawn one way or to and fro.
std::vector<Line> hatching(Rng& rng) {
  const double turn = rng.uniform(0, 2 * std::numbers::pi), length = rng.uniform(0.02, 0.08) * kBoard;
  const double apart = length * rng.uniform(0.2, 0.8), slant = rng.uniform(-0.5, 0.5);
  const PicturePoint along{std::cos(turn), std::sin(turn)}, side{-along.y, along.x};
  const bool toAndFro = rng.below(2) == 0;
  std::vector<Line> out;
  for (int k = 0; k < 4 + static_cast<int>(rng.below(6)); ++k) {
    const PicturePoint from = PicturePoint{450, 450} + side * (apart * k) + along * (slant * apart * k);
    const std::vector<PicturePoint> line{from, from + along * (length * rng.uniform(0.8, 1.2))};
    out.push_back({line, {}, false});
    if (toAndFro && k % 2 == 1) std::ranges::reverse(out.back().points);
  }
  return out;
}

/// Eyelashes, whiskers, grass, a zigzag: short strokes at places and in directions of their own.
std::vector<Line> details(Rng& rng) {
  std::vector<Line> out;
  PicturePoint at{rng.uniform(400, 600), rng.uniform(400, 600)};
  const int kind = static_cast<int>(rng.below(3));
  for (int k = 0; k < 3 + static_cast<int>(rng.below(5)); ++k) {
    const double length = rng.uniform(0.02, 0.08) * kBoard;
    double turn = rng.uniform(0, 2 * std::numbers::pi);
    PicturePoint from = at;
    if (kind == 0) {  // whiskers from one place
      turn = 0.35 * k;
    } else if (kind == 1) {  // a zigzag
      turn = k % 2 == 0 ? 1.1 : -1.1;
    } else {  // grass
      turn = 1.57 + rng.uniform(-0.3, 0.3);
      from = at + PicturePoint{rng.uniform(10, 30) * k, 0};
    }
    const PicturePoint to = from + PicturePoint{std::cos(turn), -std::sin(turn)} * length;
    out.push_back({{from, lerp(from, to, 0.5), to}, {}, false});
    if (kind == 1) at = to;
  }
  return out;
}

int hiddenIn(const std::vector<Line>& lines) {
  return static_cast<int>(std::ranges::count_if(lines, [](const Line& line) { return !line.hidden.empty(); }));
}

/// Body, seen line and strokes; sometimes the seen line comes last.
std::vector<Line> drawing(const std::vector<Line>& strokes, const std::vector<Line>& seen, Rng& rng) {
  std::vector<Line> lines{body(rng)};
  const bool first = rng.below(2) == 0;
  if (first) lines.insert(lines.end(), seen.begin(), seen.end());
  lines.insert(lines.end(), strokes.begin(), strokes.end());
  if (!first) lines.insert(lines.end(), seen.begin(), seen.end());
  return lines;
}

TEST_CASE("dashes by hand between two ends, or round, become one hidden line, in 98 of 100 drawings") {
  Rng rng(11);
  for (const bool round : {false, true}) {
    CAPTURE(round);
    int right = 0;
    for (int k = 0; k < 200; ++k) {
      const Dashed one = dashed(rng, round);
      const std::vector<Line> joined = withoutDashes(drawing(one.dashes, one.seen, rng));
      if (joined.size() != (round ? 2u : 3u) || hiddenIn(joined) != 1) continue;
      const Line& line = *std::ranges::find_if(joined, [](const Line& some) { return !some.hidden.empty(); });
      REQUIRE(line.closed == round);
      if (!round) {
        // It ends where the seen line does.
        const auto& ends = one.seen[0].points;
        const bool isForward = line.points.front() == ends.front() && line.points.back() == ends.back();
        const bool isBackward = line.points.front() == ends.back() && line.points.back() == ends.front();
        REQUIRE((isForward || isBackward));
      }
      std::size_t points = round ? 0 : 2;
      for (const Line& dash : one.dashes) points += dash.points.size();
      REQUIRE(line.points.size() == points);
      ++right;
    }
    CHECK(right >= 196);
  }
}

TEST_CASE("hatching and short details stay strokes, also between two ends, in 98 of 100 drawings") {
  for (const auto& make : {hatching, details}) {
    Rng rng(12);
    int wrong = 0;
    for (int k = 0; k < 200; ++k) {
      const std::vector<Line> strokes = make(rng);
      const Line seen{{strokes.front().points.front(), {90, 90}, strokes.back().points.back()}, {}, false};
      wrong += hiddenIn(withoutDashes(drawing(strokes, {seen}, rng))) > 0 ? 1 : 0;
    }
    CHECK(wrong <= 4);
  }
}

TEST_CASE("dashes that lead nowhere stay strokes, and so does a list without any") {
  Rng rng(13);
  const Dashed one = dashed(rng, false);
  std::vector<Line> lines{body(rng)};
  lines.insert(lines.end(), one.dashes.begin(), one.dashes.end());
  CHECK(withoutDashes(lines) == lines);
  CHECK(withoutDashes({}).empty());
}

}  // namespace
}  // namespace spineloft::descriptive
