#include "tests/bench/accuracy/algorithm_one.h"

#include <algorithm>
#include <cmath>

#include "engine/base/rng.h"
#include "engine/ribs/labels/min_plus_step.h"

namespace spineloft::accuracy {
namespace {

using ribs::LengthLabels, ribs::LengthProblem, ribs::SideCosts;

// Ends are numbered left 0 … n−1, right n … 2n−1; −1 marks an end that is not in the set.
using Chosen = std::vector<int>;

struct Candidate {
  int end = 0, label = 0;
};

const SideCosts& sideOf(const LengthProblem& p, int end) { return end < p.ribs ? p.left : p.right; }

std::size_t at(const LengthProblem& p, int end, int label) {
  return static_cast<std::size_t>(end % p.ribs) * static_cast<std::size_t>(p.levels) + static_cast<std::size_t>(label);
}

std::vector<Candidate> localMinima(const LengthProblem& p) {
  std::vector<Candidate> found;
  for (int end = 0; end < 2 * p.ribs; ++end) {
    const auto& unary = sideOf(p, end).unary;
    for (int k = 0; k < p.levels; ++k) {
      const float here = unary[at(p, end, k)];
      if (!std::isfinite(here)) continue;
      const bool down = k == 0 || !(unary[at(p, end, k - 1)] < here);
      const bool up = k + 1 == p.levels || !(unary[at(p, end, k + 1)] < here);
      if (down && up) found.push_back({end, k});
    }
  }
  return found;
}

// Place at `end` interpolated between the nearest chosen ends of the same side; NaN when none is.
double placeAt(const LengthProblem& p, const Chosen& set, int end) {
  const int first = end < p.ribs ? 0 : p.ribs, last = first + p.ribs - 1;
  int before = end, after = end;
  while (before >= first && set[static_cast<std::size_t>(before)] < 0) --before;
  while (after <= last && set[static_cast<std::size_t>(after)] < 0) ++after;
  const auto place = [&](int e) {
    return static_cast<double>(sideOf(p, e).place[at(p, e, set[static_cast<std::size_t>(e)])]);
  };
  if (before < first && after > last) return std::nan("");
  if (before < first) return place(after);
  if (after > last || before == after) return place(before);
  const double share = static_cast<double>(end - before) / (after - before);
  return place(before) + (place(after) - place(before)) * share;
}

int labelAt(const LengthProblem& p, int end, double place) {
  const auto& side = sideOf(p, end);
  int best = -1;
  for (int k = 0; k < p.levels; ++k) {
    if (!std::isfinite(side.unary[at(p, end, k)])) continue;
    const auto away = [&](int q) { return std::abs(static_cast<double>(side.place[at(p, end, q)]) - place); };
    if (best < 0 || away(k) < away(best)) best = k;
  }
  return best;
}

// What adding `c` to the set costs: its own penalty, both neighbours, the opposite end.
double added(const LengthProblem& p, const Chosen& set, const Candidate& c) {
  const auto& side = sideOf(p, c.end);
  double sum = static_cast<double>(side.unary[at(p, c.end, c.label)]);
  const int first = c.end < p.ribs ? 0 : p.ribs, last = first + p.ribs - 1;
  const float here = side.place[at(p, c.end, c.label)];
  for (int step : {-1, 1}) {
    float spacing = 0;
    for (int e = c.end + step; e >= first && e <= last; e += step) {
      spacing += side.spacing[static_cast<std::size_t>(std::min(e, e - step) - first)];
      if (set[static_cast<std::size_t>(e)] < 0) continue;
      const float there = side.place[at(p, e, set[static_cast<std::size_t>(e)])];
      sum += static_cast<double>(ribs::neighbourCost(p, here, there, spacing));
      break;
    }
  }
  if (p.paired()) {
    const int other = c.end < p.ribs ? c.end + p.ribs : c.end - p.ribs;
    const double place = placeAt(p, set, other);
    if (!std::isnan(place)) {
      const int k = labelAt(p, other, place);
      const int l = c.end < p.ribs ? c.label : k, r = c.end < p.ribs ? k : c.label;
      sum += static_cast<double>(
          ribs::oppositeCost(p, c.end % p.ribs, static_cast<std::size_t>(l), static_cast<std::size_t>(r)));
    }
  }
  return sum;
}

LengthLabels complete(const LengthProblem& p, const Chosen& set) {
  LengthLabels labels;
  for (int end = 0; end < 2 * p.ribs; ++end) {
    const double place = placeAt(p, set, end);
    const int label = labelAt(p, end, std::isnan(place) ? 0.0 : place);
    (end < p.ribs ? labels.left : labels.right).push_back(label);
  }
  return labels;
}

void shuffle(std::vector<Candidate>& all, Rng& rng) {
  for (std::size_t i = all.size(); i > 1; --i) {
    std::swap(all[i - 1], all[rng.below(static_cast<std::uint32_t>(i))]);
  }
}

}  // namespace

LengthLabels algorithmOne(const LengthProblem& p, const AlgorithmOneParams& params) {
  Rng rng(params.seed);
  std::vector<Candidate> all = localMinima(p);
  const auto ends = static_cast<std::size_t>(2 * p.ribs);
  LengthLabels best, largest;
  double least = 0;
  std::size_t most = 0;
  for (int round = 0; round < params.iterations; ++round) {
    Chosen set(ends, -1);
    std::size_t size = 0;
    shuffle(all, rng);
    for (const Candidate& c : all) {
      int& slot = set[static_cast<std::size_t>(c.end)];
      if (slot >= 0) continue;
      const bool seed = static_cast<double>(size) < params.startShare * static_cast<double>(ends);
      if (!seed && !(added(p, set, c) < 1)) continue;
      slot = c.label;
      ++size;
    }
    if (size > most || largest.left.empty()) {
      most = size;
      largest = complete(p, set);
    }
    if (static_cast<double>(size) <= params.threshold * static_cast<double>(ends)) continue;
    LengthLabels labels = complete(p, set);
    const double energy = ribs::energyOf(p, labels).total();
    if (best.left.empty() || energy < least) {
      least = energy;
      best = std::move(labels);
    }
  }
  return best.left.empty() ? largest : best;
}

}  // namespace spineloft::accuracy
