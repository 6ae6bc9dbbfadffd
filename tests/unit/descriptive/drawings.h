// Drawings of known orders for tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "engine/base/rng.h"
#include "engine/descriptive/drawing.h"
#include "engine/descriptive/overlaps.h"
#include "engine/geometry/polygon.h"
#include "tests/support/outlines.h"

namespace spineloft::testing {

/// A strip of a width round the segment from a to b, its corners in order.
inline std::vector<PicturePoint> strip(PicturePoint a, PicturePoint b, double width) {
  const PicturePoint along = normalized(b - a), side = PicturePoint{-along.y, along.x} * (width / 2);
  return {a - side, b - side, b + side, a + side};
}

/// Closed lines, one a piece, seen and hidden as `isOver(upper, lower, p)` says of any two that both hold the place p.
inline descriptive::Drawing drawn(const std::vector<std::vector<PicturePoint>>& outlines,
                                  const std::function<bool(std::uint32_t, std::uint32_t, PicturePoint)>& isOver,
                                  descriptive::PieceKind kind) {
  descriptive::Drawing drawing;
  drawing.size = {1000, 1000};
  for (std::uint32_t i = 0; i < outlines.size(); ++i) {
    descriptive::Line line{outlines[i], {}, true};
    std::vector<PicturePoint> closed = outlines[i];
    closed.push_back(closed.front());
    double length = 0;
    for (std::size_t k = 0; k + 1 < closed.size(); ++k) length += distance(closed[k], closed[k + 1]);
    double s = 0;
    for (std::size_t k = 0; k + 1 < closed.size(); ++k) {
      const double side = distance(closed[k], closed[k + 1]);
      const int steps = static_cast<int>(std::ceil(side / 0.5));
      for (int t = 0; t < steps; ++t) {
        const PicturePoint p = lerp(closed[k], closed[k + 1], (t + 0.5) / steps);
        bool hidden = false;
        for (std::uint32_t j = 0; j < outlines.size(); ++j) {
          hidden =
              hidden || (j != i && geometry::holds(std::span<const PicturePoint>(outlines[j]), p) && isOver(j, i, p));
        }
        const double from = (s + side * t / steps) / length, to = std::min(1.0, (s + side * (t + 1) / steps) / length);
        if (!hidden) continue;
        if (!line.hidden.empty() && from - line.hidden.back().to < 1e-9) {
          line.hidden.back().to = to;
        } else {
          line.hidden.push_back({from, to});
        }
      }
      s += side;
    }
    drawing.lines.push_back(std::move(line));
    drawing.pieces.push_back({"", kind, {{{i, 0, 1}}}, 1, 1, 1, 0});
  }
  return drawing;
}

/// Three bars, each over the next one.
inline descriptive::Drawing barsInACycle(double turn = 0.3, double width = 60) {
  std::vector<std::vector<PicturePoint>> bars;
  for (int k = 0; k < 3; ++k) {
    const double angle = turn + 2.0943951023931953 * k;
    const PicturePoint along{std::cos(angle), std::sin(angle)}, out{-along.y, along.x};
    const PicturePoint middle = PicturePoint{500, 500} + out * 110;
    bars.push_back(strip(middle - along * 330, middle + along * 330, width));
  }
  return drawn(
      bars, [](std::uint32_t upper, std::uint32_t lower, PicturePoint) { return (upper + 1) % 3 == lower; },
      descriptive::PieceKind::Flat);
}

/// `n` rods across and `n` down, over and under in turns.
inline descriptive::Drawing wovenMat(int n, descriptive::PieceKind kind) {
  std::vector<std::vector<PicturePoint>> rods;
  const double step = 600.0 / (n - 1);
  for (int i = 0; i < n; ++i) rods.push_back(strip({120, 200 + step * i}, {880, 200 + step * i}, 0.4 * step));
  for (int i = 0; i < n; ++i) rods.push_back(strip({200 + step * i, 120}, {200 + step * i, 880}, 0.4 * step));
  const auto count = static_cast<std::uint32_t>(n);
  return drawn(
      rods,
      [count](std::uint32_t upper, std::uint32_t lower, PicturePoint) {
        const std::uint32_t across = std::min(upper, lower), down = std::max(upper, lower) - count;
        const bool acrossIsOver = (across + down) % 2 == 0;
        return acrossIsOver == (upper < lower);
      },
      kind);
}

inline std::vector<descriptive::Sheet> sheetsOf(const descriptive::Drawing& drawing) {
  std::vector<descriptive::Sheet> sheets;
  const auto lines = descriptive::meetingLines(drawing.lines);
  for (const descriptive::Piece& piece : drawing.pieces) {
    sheets.push_back(
        descriptive::sheetOf(lines.value(), piece, descriptive::sizeOf(drawing.lines), drawing.size).value());
  }
  return sheets;
}

/// Random discs whose overlaps have orders of their own, without a cycle in one place.
struct Discs {
  std::vector<Outline> outlines;
  descriptive::Overlaps overlaps;
  std::vector<bool> aIsOver;  ///< by overlap
};

inline bool hasCycle(const Discs& discs) {
  for (std::uint32_t cell = 0; cell < discs.overlaps.cells(); ++cell) {
    const auto in = discs.overlaps.in(cell);
    const auto over = [&](std::size_t i, std::size_t k) {
      const auto overlap = *discs.overlaps.at(in[i], in[k], discs.overlaps.middle(cell), 0);
      return bool(discs.aIsOver[overlap]) == (in[i] < in[k]);
    };
    for (std::size_t a = 0; a < in.size(); ++a) {
      for (std::size_t b = a + 1; b < in.size(); ++b) {
        for (std::size_t c = b + 1; c < in.size(); ++c) {
          if (over(a, b) == over(b, c) && over(b, c) == over(c, a)) return true;
        }
      }
    }
  }
  return false;
}

inline Discs randomDiscs(std::uint64_t seed) {
  Rng rng(seed);
  Discs discs;
  descriptive::Drawing plain;
  plain.size = {1000, 1000};
  const std::uint32_t count = 3 + rng.below(4);
  for (std::uint32_t i = 0; i < count; ++i) {
    discs.outlines.push_back(
        ellipse({rng.uniform(250, 750), rng.uniform(250, 750)}, rng.uniform(60, 200), rng.uniform(60, 200), 120));
    plain.lines.push_back({discs.outlines[i], {}, true});
    plain.pieces.push_back({"", descriptive::PieceKind::Round, {{{i, 0, 1}}}, 1, 1, 1, 0});
  }
  discs.overlaps = descriptive::Overlaps(sheetsOf(plain), descriptive::sizeOf(plain.lines));
  discs.aIsOver.assign(discs.overlaps.all().size(), true);
  for (int k = 0; k < 20 && !discs.aIsOver.empty(); ++k) {
    const std::size_t flip = rng.below(static_cast<std::uint32_t>(discs.aIsOver.size()));
    discs.aIsOver[flip] = !discs.aIsOver[flip];
    if (hasCycle(discs)) discs.aIsOver[flip] = !discs.aIsOver[flip];
  }
  return discs;
}

inline descriptive::Drawing drawingOf(const Discs& discs) {
  return drawn(
      discs.outlines,
      [&](std::uint32_t upper, std::uint32_t lower, PicturePoint p) {
        const auto overlap = discs.overlaps.at(upper, lower, p, 3);
        return overlap && bool(discs.aIsOver[*overlap]) == (upper < lower);
      },
      descriptive::PieceKind::Round);
}

}  // namespace spineloft::testing
