// What is hidden and not drawn: where it goes on, and what is in front of it.
#include "engine/descriptive/completion.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "engine/base/rng.h"
#include "engine/descriptive/model.h"
#include "engine/geometry/line_distance.h"
#include "engine/geometry/polygon.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"
#include "tests/support/rounds.h"
#include "tests/unit/descriptive/drawings.h"
#include "tests/unit/descriptive/rays.h"

namespace spineloft::descriptive {
namespace {

using testing::ellipse;
using testing::seeds;

constexpr double kTwoPi = 2 * std::numbers::pi;

TEST_CASE("between the ends of an arc of a circle, the way is the rest of the circle") {
  for (const std::uint64_t seed : seeds(0, 100)) {
    Rng rng(seed);
    const PicturePoint middle{rng.uniform(-50, 50), rng.uniform(-50, 50)};
    const double r = rng.uniform(20, 200), from = rng.uniform(0, kTwoPi), missing = rng.uniform(0.1, std::numbers::pi);
    MeasuredLine arc;
    for (int i = 0; i <= 300; ++i) {
      const double angle = from + (kTwoPi - missing) * i / 300;
      arc.points.push_back(middle + PicturePoint{std::cos(angle), std::sin(angle)} * r);
    }
    geometry::arcLengths(std::span<const PicturePoint>(arc.points), arc.s);
    const LineEnd last = endOf({&arc, 1}, 0, true), first = endOf({&arc, 1}, 0, false);
    const HiddenWay way = hiddenWay(last, first);
    // It goes on turning to the same side, and back from the other end to the other one.
    CHECK(last.bend == doctest::Approx(1 / r).epsilon(0.03));
    CHECK(first.bend == doctest::Approx(-1 / r).epsilon(0.03));
    CHECK(way.turn == doctest::Approx(missing).epsilon(0.05));
    CHECK(way.points.front() == arc.points.back());
    CHECK(way.points.back() == arc.points.front());
    for (const PicturePoint p : way.points) CHECK(std::abs(distance(p, middle) / r - 1) < 0.03);
  }
}

/// Ellipses one behind the other, of each the arcs that nothing is in front of.
struct Stack {
  std::vector<std::vector<PicturePoint>> outlines;  ///< the first is in front
  Drawing seen;
  std::vector<std::uint32_t> of;  ///< the ellipse of each line
};

/// None where less than half of an ellipse is seen, or a stretch of less than kWelding of the drawing.
std::optional<Stack> stackOf(Rng& rng) {
  Stack out;
  const std::uint32_t count = 2 + rng.below(4);
  for (std::uint32_t i = 0; i < count; ++i) {
    const PicturePoint middle{rng.uniform(250, 750), rng.uniform(250, 750)};
    const double turn = rng.uniform(0, kTwoPi), a = rng.uniform(80, 220), b = rng.uniform(80, 220);
    std::vector<PicturePoint> outline;
    for (const PicturePoint p : ellipse({0, 0}, a, b, 400)) {
      outline.push_back(middle + PicturePoint{p.x * std::cos(turn) - p.y * std::sin(turn),
                                              p.x * std::sin(turn) + p.y * std::cos(turn)});
    }
    out.outlines.push_back(std::move(outline));
  }
  out.seen.size = {1000, 1000};
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto& outline = out.outlines[i];
    const std::size_t n = outline.size();
    std::vector<bool> isSeen(n);
    for (std::size_t k = 0; k < n; ++k) {
      isSeen[k] = std::none_of(out.outlines.begin(), out.outlines.begin() + i, [&](const auto& other) {
        return geometry::holds(std::span<const PicturePoint>(other), outline[k]);
      });
    }
    const auto seen = std::ranges::count(isSeen, true);
    if (2 * seen < static_cast<std::ptrdiff_t>(n)) return std::nullopt;
    if (seen == static_cast<std::ptrdiff_t>(n)) {
      out.seen.lines.push_back({outline, {}, true});
      out.of.push_back(i);
      continue;
    }
    const auto first = static_cast<std::size_t>(std::ranges::find(isSeen, false) - isSeen.begin());
    Line line;
    for (std::size_t k = 0; k <= n; ++k) {
      const std::size_t at = (first + k) % n;
      if (isSeen[at] && k < n) {
        line.points.push_back(outline[at]);
      } else if (!line.points.empty()) {
        if (line.points.size() < 12) return std::nullopt;
        out.seen.lines.push_back(std::move(line));
        out.of.push_back(i);
        line = {};
      }
    }
  }
  return out;
}

TEST_CASE("ellipses of which only what is seen is drawn are whole again, and in their order") {
  std::vector<double> off;
  std::size_t pieces = 0, overlaps = 0, guessed = 0, wrong = 0, samples = 0, wrongSamples = 0, drawings = 0;
  for (std::uint64_t seed = 1000; drawings < 50; ++seed) {
    Rng rng(seed);
    const std::optional<Stack> stack = stackOf(rng);
    if (!stack || std::ranges::all_of(stack->seen.lines, &Line::closed)) continue;
    ++drawings;
    CAPTURE(seed);
    const Result<Model> made = modelOf(stack->seen);
    REQUIRE(made.ok());
    const Model& model = made.value();
    pieces += stack->outlines.size();
    std::vector<std::optional<std::uint32_t>> ellipseOf;
    for (const ModelPiece& solid : model.solids) {
      testing::requireLawful(solid.mesh);
      const Outline& outline = model.pieces[solid.piece].outlines[0];
      const std::uint32_t own = stack->of[outline[0].line];
      const auto all = static_cast<std::size_t>(std::ranges::count(stack->of, own));
      const bool isWhole = outline.size() == all && std::ranges::all_of(outline, [&](const Run& run) {
                             return stack->of[run.line] == own && std::abs(run.to - run.from) == 1;
                           });
      ellipseOf.push_back(isWhole ? std::optional(own) : std::nullopt);
      if (!isWhole) continue;
      double most = 0;
      for (const auto& contour : solid.region) {
        for (const PicturePoint p : contour) {
          most = std::max(most, geometry::distanceToLine(p, std::span<const PicturePoint>(stack->outlines[own]), true));
        }
      }
      off.push_back(most / model.size);
    }
    for (const Order& order : model.orders.orders) {
      const auto over = ellipseOf[order.over], under = ellipseOf[order.under];
      if (!over || !under) continue;
      ++overlaps;
      if (order.from == OrderFrom::Guessed) ++guessed;
      if (order.from != OrderFrom::Guessed && *over > *under) ++wrong;
    }
    Drawing found = stack->seen;
    found.pieces = model.pieces;
    const testing::Samples looked = testing::lookAtOrders(found, model);
    samples += looked.all;
    wrongSamples += looked.wrong;
  }
  const auto close = std::ranges::count_if(off, [](double one) { return one <= 0.05; });
  // Some are open: two arcs that lead under the same thing could be of one ellipse as well.
  CHECK(10 * static_cast<std::size_t>(close) >= 9 * pieces);
  CHECK(20 * guessed <= overlaps);
  CHECK(overlaps > 80);
  CHECK(wrong == 0);
  CHECK(samples > 50000);
  CHECK(wrongSamples == 0);
}

struct Made {
  Model model;
  std::vector<std::size_t> linesOf;  ///< of every piece
};
Made madeOf(const std::vector<Line>& lines) {
  Drawing drawing;
  drawing.size = {1000, 1000};
  drawing.lines = lines;
  auto model = modelOf(drawing);
  REQUIRE(model.ok());
  Made out{std::move(model).value(), {}};
  for (const Piece& piece : out.model.pieces) out.linesOf.push_back(piece.outlines[0].size());
  return out;
}
Line open(std::vector<PicturePoint> points) { return {std::move(points), {}, false}; }
Line ball(PicturePoint middle, double radius) { return {ellipse(middle, radius, radius, 200), {}, true}; }

TEST_CASE("legs that end at a body go on behind it, each for itself") {
  const Made made = madeOf({ball({500, 400}, 200), open({{400, 573}, {400, 800}, {440, 800}, {440, 591}}),
                            open({{560, 591}, {560, 800}, {600, 800}, {600, 573}})});
  REQUIRE(made.model.pieces.size() == 3);
  CHECK(made.linesOf == std::vector<std::size_t>{1, 1, 1});
  CHECK(made.model.completed.size() == 2);
  for (const auto& way : made.model.completed) {
    for (std::size_t i = 1; i + 1 < way.size(); ++i) CHECK(distance(way[i], PicturePoint{500, 400}) < 200.5);
  }
  REQUIRE(made.model.orders.orders.size() == 2);
  for (const Order& order : made.model.orders.orders) {
    CHECK(order.over == 0);
    CHECK(order.from == OrderFrom::Drawn);
  }
  CHECK(made.model.orders.contradictions.empty());
  CHECK(made.model.orders.unexplained.empty());
}

TEST_CASE("a limb goes on behind the body however narrow it is") {
  for (const double width : {12.0, 18.0, 25.0, 35.0, 60.0}) {
    const double left = 500 - width / 2, right = 500 + width / 2;
    const Made made = madeOf({ball({500, 300}, 200), open({{left, 499}, {left, 850}, {right, 850}, {right, 499}})});
    CAPTURE(width);
    CHECK(made.linesOf == std::vector<std::size_t>{1, 1});
    CHECK(made.model.completed.size() == 1);
    REQUIRE(made.model.orders.orders.size() == 1);
    CHECK(made.model.orders.orders[0].over == 0);
  }
}

TEST_CASE("a bar that comes out on the other side is one piece; a bar between two balls ends in both") {
  const Made through = madeOf({ball({500, 500}, 120), open({{381, 480}, {200, 480}, {200, 520}, {381, 520}}),
                               open({{619, 480}, {800, 480}, {800, 520}, {619, 520}})});
  CHECK(through.linesOf == std::vector<std::size_t>{1, 2});
  const Made between = madeOf(
      {ball({250, 500}, 100), ball({750, 500}, 100), open({{349, 485}, {651, 485}}), open({{349, 515}, {651, 515}})});
  CHECK(between.linesOf == std::vector<std::size_t>{1, 1, 2});
  CHECK(between.model.completed.size() == 2);
}

TEST_CASE("the handle of a mug is a bent bar behind it, and a band in front of a body stays one") {
  const Made mug = madeOf({{testing::rectangle(300, 300, 600, 700), {}, true},
                           open({{600, 380}, {700, 380}, {760, 440}, {760, 560}, {700, 620}, {600, 620}}),
                           open({{600, 430}, {680, 430}, {710, 460}, {710, 540}, {680, 570}, {600, 570}})});
  CHECK(mug.linesOf == std::vector<std::size_t>{1, 2});
  // Ends that lead out of what they lie on are not hidden by it.
  const Made band = madeOf({ball({500, 500}, 200), open({{310, 440}, {500, 470}, {690, 440}})});
  CHECK(band.model.completed.empty());
  CHECK(band.model.pieces.size() == 2);
}

TEST_CASE("a leaf of two strokes whose root lies on another line is a piece, on an open stem and on a closed trunk") {
  const std::vector<PicturePoint> stem{{100, 900}, {350, 600}, {600, 300}};
  const Made open_ =
      madeOf({open(stem), open({{350, 600}, {480, 610}, {600, 560}}), open({{350, 600}, {500, 520}, {600, 560}})});
  REQUIRE(open_.model.pieces.size() == 1);
  CHECK(open_.linesOf == std::vector<std::size_t>{2});
  for (int k = 0; k < 12; ++k) {
    // Also where rounding puts the root on either side of the edge.
    const double angle = kTwoPi * (k + 0.37) / 200;
    const PicturePoint way{std::cos(angle), std::sin(angle)}, side{-way.y, way.x};
    const PicturePoint root = PicturePoint{400, 500} + way * (200 * std::cos(kTwoPi / 400));
    const Made trunk = madeOf({ball({400, 500}, 200), open({root, root + way * 130 + side * 50, root + way * 250}),
                               open({root, root + way * 130 - side * 50, root + way * 250})});
    CAPTURE(k);
    CHECK(trunk.linesOf == std::vector<std::size_t>{1, 2});
  }
}

TEST_CASE("a gap between ends that lead out of what they lie on is closed straight") {
  Drawing drawing{{1000, 1000},
                  {ball({300, 300}, 100), open({{360, 379}, {360, 280}, {330, 280}, {330, 394}})},
                  {{"Pocket", PieceKind::Flat, {{{1, 0, 1}}}, 1, 1, 1, 0}},
                  {},
                  {},
                  {}};
  const auto made = modelOf(drawing);
  REQUIRE(made.ok());
  CHECK(made.value().completed.empty());
  for (const auto& contour : made.value().solids[0].region) {
    for (const PicturePoint p : contour) CHECK(p.y <= 396);
  }
}

TEST_CASE("a free end, and one that ends inside something, hide nothing") {
  CHECK(madeOf({ball({500, 500}, 150), open({{500, 640}, {480, 800}, {560, 900}})}).model.pieces.size() == 1);
  CHECK(
      madeOf({ball({500, 500}, 150), open({{460, 560}, {480, 800}, {560, 800}, {540, 560}})}).model.completed.empty());
}

}  // namespace
}  // namespace spineloft::descriptive
