// Length problems that the tests of label searches share.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/base/rng.h"
#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::fixtures {

inline void fillSide(ribs::SideCosts& side, int ribs, int levels, Rng& rng) {
  side.unary.clear();
  side.place.clear();
  side.spacing.clear();
  for (int i = 0; i < ribs; ++i) {
    const int reached = 1 + static_cast<int>(rng.below(static_cast<std::uint32_t>(levels)));
    double place = rng.uniform(0, 1);
    for (int k = 0; k < levels; ++k) {
      const bool exists = k < reached || rng.uniform() < 0.7;
      side.unary.push_back(exists ? static_cast<float>(rng.uniform()) : ribs::kUnreachable);
      side.place.push_back(static_cast<float>(place));
      place += rng.uniform(0.2, 3);
    }
    if (i > 0) side.spacing.push_back(static_cast<float>(rng.uniform(0.5, 4)));
  }
}

/// Random costs, spacings and weights; some labels do not exist.
inline ribs::LengthProblem randomProblem(int ribs, int levels, bool opposite, Rng& rng) {
  ribs::LengthProblem p;
  p.ribs = ribs;
  p.levels = levels;
  fillSide(p.left, ribs, levels, rng);
  fillSide(p.right, ribs, levels, rng);
  p.neighbourWeight = static_cast<float>(rng.uniform(0, 4));
  p.neighbourFreedom = static_cast<float>(rng.uniform(0, 1));
  if (rng.uniform() < 0.5) p.neighbourCap = static_cast<float>(rng.uniform(0.2, 2));
  if (opposite) {
    std::vector<double> values;
    for (int k = 0; k < levels; ++k) values.push_back(k + 0.5);
    if (rng.uniform() < 0.7) p.opposite = ribs::oppositeTable(values, rng.uniform(0, 2));
    if (p.opposite.empty() || rng.uniform() < 0.5) {
      p.medialOffset = static_cast<float>(rng.uniform(-0.6, 0.6));
      for (int i = 0; i < ribs; ++i) p.medialOffsetScale.push_back(static_cast<float>(rng.uniform(0, 1)));
      if (rng.uniform() < 0.5) p.medialOffsetCap = static_cast<float>(rng.uniform(0.1, 3));
    }
  }
  return p;
}

/// A problem like a picture's: two noisy boundaries that follow a wave, clutter, and gaps.
inline ribs::LengthProblem pictureLikeProblem(int ribs, int levels, Rng& rng) {
  ribs::LengthProblem p = randomProblem(ribs, levels, true, rng);
  p.neighbourWeight = 3;
  p.neighbourFreedom = 0.25f;
  for (ribs::SideCosts* side : {&p.left, &p.right}) {
    for (int i = 0; i < ribs; ++i) {
      const double truth = levels * (0.5 + 0.2 * std::sin(i * 0.3));
      const bool gap = rng.uniform() < 0.3;
      for (int k = 0; k < levels; ++k) {
        const std::size_t at = static_cast<std::size_t>(i * levels + k);
        const double near = gap ? 0 : std::max(0.0, 1 - std::abs(k - truth) / 3);
        side->unary[at] = static_cast<float>(std::min(1 - near, rng.uniform() < 0.05 ? 0.2 : 1.0));
        side->place[at] = static_cast<float>(k);
      }
    }
    std::ranges::fill(side->spacing, 4.f);
  }
  return p;
}

}  // namespace spineloft::fixtures
