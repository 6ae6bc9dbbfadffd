#include "engine/descriptive/lines.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/rng.h"
#include "engine/descriptive/outlines.h"
#include "engine/geometry/polygon.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::descriptive;
using namespace spineloft::testing;

namespace {

std::vector<MeasuredLine> meeting(const std::vector<Line>& lines) {
  auto met = meetingLines(lines);
  REQUIRE(met.ok());
  return std::move(met).value();
}
std::size_t countOf(const std::vector<Node>& nodes, NodeKind kind) {
  return static_cast<std::size_t>(std::ranges::count(nodes, kind, &Node::kind));
}
double areaOf(const std::vector<PicturePoint>& points) {
  return std::abs(geometry::signedArea(std::span<const PicturePoint>(points)));
}

struct Ellipse {
  PicturePoint centre;
  double rx, ry;
  double level(PicturePoint p) const {
    const double x = (p.x - centre.x) / rx, y = (p.y - centre.y) / ry;
    return x * x + y * y - 1;
  }
  /// Square to the ellipse that has this level at p, unit.
  PicturePoint normalAt(PicturePoint p) const {
    const PicturePoint n{(p.x - centre.x) / (rx * rx), (p.y - centre.y) / (ry * ry)};
    return n / norm(n);
  }
  PicturePoint at(double turn) const { return {centre.x + rx * std::cos(turn), centre.y + ry * std::sin(turn)}; }
};

/// Crossings of two ellipses, counted on their formulas; −1 where they are nearly tangent somewhere: a hand that draws
/// one line along another means a touch.
int crossingsOf(const Ellipse& one, const Ellipse& other) {
  const int steps = 20000;
  std::vector<double> levels;
  for (int i = 0; i < steps; ++i) levels.push_back(other.level(one.at(2 * std::numbers::pi * i / steps)));
  int count = 0;
  for (int i = 0; i < steps; ++i) {
    const double before = levels[(i + steps - 1) % steps], here = levels[i], after = levels[(i + 1) % steps];
    if ((here > 0) != (after > 0)) {
      constexpr double kShallow = 0.15;  // radians
      const PicturePoint p = one.at(2 * std::numbers::pi * i / steps);
      if (std::abs(cross(one.normalAt(p), other.normalAt(p))) < kShallow) return -1;
      ++count;
    }
    const bool isExtreme = (here >= before && here >= after) || (here <= before && here <= after);
    if (isExtreme && std::abs(here) < 0.15) return -1;
  }
  return count;
}

/// The pieces of a closed outline, cut at random, drawn in a random order and direction by a hand that is off by `off`.
std::vector<Line> cutUp(const testing::Outline& closed, int cuts, double off, Rng& rng) {
  std::vector<std::size_t> at;
  while (at.size() < static_cast<std::size_t>(cuts)) {
    const std::size_t place = rng.below(static_cast<std::uint32_t>(closed.size()));
    const auto apart = [&](std::size_t other) {
      const std::size_t d = place > other ? place - other : other - place;
      return std::min(d, closed.size() - d) > closed.size() / 10;
    };
    if (std::ranges::all_of(at, apart)) at.push_back(place);
  }
  std::ranges::sort(at);
  std::vector<Line> lines;
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::size_t from = at[k], to = at[(k + 1) % at.size()];
    Line line;
    for (std::size_t i = from;; i = (i + 1) % closed.size()) {
      line.points.push_back(closed[i]);
      if (i == to) break;
    }
    for (PicturePoint* end : {&line.points.front(), &line.points.back()}) {
      *end += {rng.uniform(-off, off), rng.uniform(-off, off)};
    }
    if (rng.uniform() < 0.5) std::ranges::reverse(line.points);
    lines.push_back(std::move(line));
  }
  for (std::size_t k = lines.size(); k > 1; --k)
    std::swap(lines[k - 1], lines[rng.below(static_cast<std::uint32_t>(k))]);
  return lines;
}

}  // namespace

TEST_CASE("ellipses cross as often as their formulas say, and at places that lie on both") {
  std::size_t found = 0;
  for (const std::uint64_t seed : seeds(0, 200)) {
    CAPTURE(seed);
    Rng rng(seed);
    std::vector<Ellipse> ellipses;
    std::vector<Line> lines;
    for (std::uint32_t k = 0; k < 2 + seed % 4; ++k) {
      ellipses.push_back({{rng.uniform(150, 450), rng.uniform(150, 450)}, rng.uniform(50, 140), rng.uniform(50, 140)});
      lines.push_back({ellipse(ellipses[k].centre, ellipses[k].rx, ellipses[k].ry, 180), {}, true});
    }
    std::size_t expected = 0;
    bool tangent = false;
    for (std::size_t a = 0; a < ellipses.size(); ++a) {
      for (std::size_t b = a + 1; b < ellipses.size(); ++b) {
        const int count = crossingsOf(ellipses[a], ellipses[b]);
        tangent = tangent || count < 0;
        expected += static_cast<std::size_t>(std::max(count, 0));
      }
    }
    if (tangent) continue;
    const auto nodes = nodesOf(meeting(lines), sizeOf(lines));
    CHECK(countOf(nodes, NodeKind::Crossing) == expected);
    CHECK(nodes.size() == expected);
    for (const Node& node : nodes) {
      REQUIRE(node.places.size() == 2);
      for (const Place& place : node.places) CHECK(std::abs(ellipses[place.line].level(node.at)) < 0.02);
    }
    found += expected;
  }
  CHECK(found > 100);
}

TEST_CASE("circles that touch from outside and from inside have one touch and no crossing") {
  for (const std::uint64_t seed : seeds(0, 40)) {
    Rng rng(seed);
    const double r = rng.uniform(40, 120), q = rng.uniform(20, 100), turn = rng.uniform(0, 6.28);
    for (const double apart : {r + q, r > 2.5 * q ? r - q : r + q}) {
      const PicturePoint other{300 + apart * std::cos(turn), 300 + apart * std::sin(turn)};
      const std::vector<Line> lines{{ellipse({300, 300}, r, r, 400), {}, true}, {ellipse(other, q, q, 400), {}, true}};
      const auto nodes = nodesOf(meeting(lines), sizeOf(lines));
      CHECK(countOf(nodes, NodeKind::Touch) == 1);
      CHECK(countOf(nodes, NodeKind::Crossing) == 0);
    }
  }
}

TEST_CASE("an outline drawn in several strokes, in any order and direction, is one outline again") {
  for (const std::uint64_t seed : seeds(0, 200)) {
    Rng rng(seed);
    const testing::Outline drawn = blob(rng, {300, 300}, 150, 200);
    const auto lines = cutUp(drawn, 2 + static_cast<int>(seed % 4), 1.2, rng);
    const auto met = meeting(lines);
    const auto outlines = proposeOutlines(met, nodesOf(met, sizeOf(lines)));
    REQUIRE(outlines.size() == 1);
    CHECK(outlines[0].size() == lines.size());
    const auto path = pathOf(met, outlines[0]);
    REQUIRE(path.ok());
    CHECK(areaOf(path.value().points) == doctest::Approx(areaOf(drawn)).epsilon(0.02));
  }
}

TEST_CASE("two outlines that cross, both cut where they cross, are followed straight on") {
  std::size_t right = 0, all = 0;
  for (const std::uint64_t seed : seeds(0, 100)) {
    Rng rng(seed);
    // Two circles in four arcs: all four ends of each crossing are at one place.
    const double r = rng.uniform(80, 140), apart = rng.uniform(0.7, 1.3) * r, turn = rng.uniform(0, 6.28);
    const PicturePoint shift{apart * std::cos(turn), apart * std::sin(turn)};
    const double half = std::acos(apart / (2 * r));
    std::vector<Line> lines;
    for (const double side : {1.0, -1.0}) {
      const PicturePoint centre = PicturePoint{300, 300} + shift * ((1 - side) / 2);
      const double towards = turn + (side > 0 ? 0 : std::numbers::pi);
      for (const auto& [from, to] : {std::pair{-half, half}, {half, 2 * std::numbers::pi - half}}) {
        Line arc;
        for (int i = 0; i <= 100; ++i) {
          const double angle = towards + from + (to - from) * i / 100;
          arc.points.push_back({centre.x + r * std::cos(angle) + rng.uniform(-0.2, 0.2),
                                centre.y + r * std::sin(angle) + rng.uniform(-0.2, 0.2)});
        }
        lines.push_back(std::move(arc));
      }
    }
    const auto met = meeting(lines);
    const auto outlines = proposeOutlines(met, nodesOf(met, sizeOf(lines)));
    ++all;
    const bool paired =
        outlines.size() == 2 && std::ranges::all_of(outlines, [&](const descriptive::Outline& outline) {
          const auto path = pathOf(met, outline);
          return path.ok() && std::abs(areaOf(path.value().points) / (std::numbers::pi * r * r) - 1) < 0.03;
        });
    right += paired;
  }
  CHECK(right == all);
}

TEST_CASE("a stroke whose ends lie on a closed line and lead away from it is closed by the shorter way along it") {
  // A body and a pocket: from the body's lower side up and back.
  const std::vector<Line> lines{{ellipse({300, 300}, 100, 100, 200), {}, true},
                                {{{360, 379}, {360, 280}, {330, 280}, {330, 394}}, {}, false}};
  const auto met = meeting(lines);
  const auto nodes = nodesOf(met, sizeOf(lines));
  CHECK(countOf(nodes, NodeKind::Branch) == 2);
  const auto outlines = proposeOutlines(met, nodes);
  REQUIRE(outlines.size() == 2);
  const auto pocket = pathOf(met, outlines[1]);
  REQUIRE(pocket.ok());
  CHECK(pocket.value().completed.empty());
  double strip = 0;
  for (int i = 0; i < 3000; ++i) {
    const double x = 30 + (i + 0.5) / 100;
    strip += (20 + std::sqrt(1e4 - x * x)) / 100;
  }
  CHECK(areaOf(pocket.value().points) == doctest::Approx(strip).epsilon(0.03));
}

TEST_CASE("ends are welded, closed and cut as far as a hand misses, and no farther") {
  const double size = 400;
  for (const std::uint64_t seed : seeds(0, 50)) {
    Rng rng(seed);
    const double turn = rng.uniform(0, 6.28);
    const PicturePoint off = PicturePoint{std::cos(turn), std::sin(turn)} * (0.015 * size);
    const std::vector<Line> near{{{{100, 100}, {300, 100}, {500, 100}}, {}, false},
                                 {{PicturePoint{500, 100} + off, {500, 300}, {400, 350}}, {}, false},
                                 {{{250, 100 + off.y}, {250, 300}, {300, 320}}, {}, false}};
    const auto met = meeting(near);
    const auto nodes = nodesOf(met, sizeOf(near));
    CHECK(countOf(nodes, NodeKind::Corner) == 1);
    CHECK(countOf(nodes, NodeKind::Branch) == 1);
    CHECK(countOf(nodes, NodeKind::Crossing) == 0);
    CHECK(met[2].points.front().y == doctest::Approx(100).epsilon(1e-6));
  }
  std::vector<Line> far{{{{100, 100}, {300, 100}, {500, 100}}, {}, false},
                        {{{500, 100 + 0.04 * size}, {500, 300}, {400, 350}}, {}, false}};
  CHECK(countOf(nodesOf(meeting(far), sizeOf(far)), NodeKind::Corner) == 0);
  testing::Outline ring = ellipse({300, 300}, 200, 200, 100);
  CHECK(meeting({{ring, {}, false}})[0].closed);
  ring.resize(80);
  CHECK_FALSE(meeting({{ring, {}, false}})[0].closed);
}

TEST_CASE("a change of type at a crossing is no dip, one away from all crossings is") {
  const std::vector<Line> bodyAndArm{{ellipse({300, 300}, 120, 120, 200), {}, true},
                                     {{{300, 280}, {600, 280}, {600, 320}, {300, 320}}, {}, true}};
  std::vector<Line> lines = bodyAndArm;
  // The arm's outline goes 300 right, 40 down, 300 back, 40 up; the circle is left at x = 418.3.
  const double whole = 680, out = 118.3;
  lines[1].hidden = {{0, out / whole}, {(640 - out) / whole, 1}};
  CHECK(countOf(nodesOf(meeting(lines), sizeOf(lines)), NodeKind::Dip) == 0);
  lines[1].hidden = {{0, (out + 8) / whole}, {(640 - out - 8) / whole, 1}};
  CHECK(countOf(nodesOf(meeting(lines), sizeOf(lines)), NodeKind::Dip) == 0);
  lines[1].hidden = {{0, 50 / whole}, {590 / whole, 1}};
  CHECK(countOf(nodesOf(meeting(lines), sizeOf(lines)), NodeKind::Dip) == 2);
}

TEST_CASE("hidden stretches stay at their places in an outline, whichever way it runs") {
  const std::vector<Line> lines{{{{100, 100}, {300, 100}, {300, 200}}, {{0.25, 0.5}}, false},
                                {{{300, 200}, {100, 200}, {100, 100}}, {}, false}};
  const auto met = meeting(lines);
  for (const descriptive::Outline& outline : {descriptive::Outline{{0, 0, 1}, {1, 0, 1}}, {{1, 1, 0}, {0, 1, 0}}}) {
    const auto path = pathOf(met, outline);
    REQUIRE(path.ok());
    double hidden = 0;
    for (std::size_t i = 0; i < path.value().points.size(); ++i) {
      const PicturePoint a = path.value().points[i], b = path.value().points[(i + 1) % path.value().points.size()];
      if (!path.value().hidden[i]) continue;
      hidden += distance(a, b);
      CHECK(std::min(a.x, b.x) >= 175 - 1e-9);
      CHECK(std::max(a.x, b.x) <= 250 + 1e-9);
    }
    CHECK(hidden == doctest::Approx(75));
  }
}

TEST_CASE("what is no drawing is refused, and odd lines are lived with") {
  CHECK(meetingLines(std::vector<Line>{{{{0, 0}, {NAN, 1}}, {}, false}}).error() == Error::StrokeNotFinite);
  CHECK(meetingLines(std::vector<Line>{{{{5, 5}, {5, 5}}, {}, false}}).error() == Error::StrokeTooShort);
  CHECK(meetingLines(std::vector<Line>{{{{0, 0}, {9, 9}}, {{0.5, 0.2}}, false}}).error() == Error::ValueOutOfRange);
  CHECK(meetingLines(std::vector<Line>(kMostLines + 1, Line{{{0, 0}, {9, 9}}, {}, false})).error() ==
        Error::ValueOutOfRange);
  CHECK(meeting({}).empty());
  CHECK(nodesOf({}, 0).empty());
  for (const std::uint64_t seed : seeds(0, 300)) {
    Rng rng(seed);
    std::vector<Line> lines(1 + rng.below(6));
    for (Line& line : lines) {
      const std::uint32_t points = 3 + rng.below(12);
      for (std::uint32_t i = 0; i < points; ++i) {
        line.points.push_back({std::round(rng.uniform(0, 9)), std::round(rng.uniform(0, 9))});
      }
      line.points.push_back({static_cast<double>(lines.size()), 20});
      line.closed = rng.uniform() < 0.5;
      if (rng.uniform() < 0.3) line.hidden = {{0.2, rng.uniform(0.3, 1)}};
    }
    const auto met = meetingLines(lines);
    REQUIRE(met.ok());
    const auto nodes = nodesOf(met.value(), sizeOf(lines));
    for (const Node& node : nodes) {
      CHECK(isFinite(node.at));
      for (const Place& place : node.places) CHECK((place.share >= 0 && place.share <= 1));
    }
    for (const auto& outline : proposeOutlines(met.value(), nodes)) {
      const auto path = pathOf(met.value(), outline);
      if (path.ok()) CHECK(path.value().points.size() == path.value().hidden.size());
    }
  }
}
