#include "engine/ribs/rib_lengths.h"

#include <algorithm>
#include <cmath>

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// For labels at places `to` the ranges of labels at places `from` (both increasing) that are free
// of charge: [low[k], high[k]) within `free` of to[k].
struct FreeWindow {
  std::vector<int> low, high;
};

void freeWindow(const float* to, const float* from, int levels, float free, FreeWindow& window) {
  window.low.resize(index(levels));
  window.high.resize(index(levels));
  int low = 0, high = 0;
  for (int k = 0; k < levels; ++k) {
    while (low < levels && from[low] < to[k] - free) ++low;
    while (high < levels && from[high] <= to[k] + free) ++high;
    window.low[index(k)] = low;
    window.high[index(k)] = high;
  }
}

// What one step along the chain needs to know about one side.
struct Transition {
  const float* to;    // places of this rib's labels
  const float* from;  // places of the previous rib's labels
  float slope;        // weight / spacing
  float free;         // freedom · spacing
  float cap;
};

Transition transitionOf(const LengthProblem& p, const SideCosts& side, int rib) {
  const float s = side.spacing[index(rib - 1)];
  const std::size_t row = index(rib) * index(p.levels);
  return {&side.place[row], &side.place[row - index(p.levels)], p.neighbourWeight / s,
          p.neighbourFreedom * s, p.neighbourCap};
}

// out(k, ·) = min over k' of in(k', ·) + min(cap, slope · max(0, |to_k − from_k'| − free)), for
// `width` columns at once. The cost is flat in a window and linear outside, so the minimum is the
// least of a window minimum, a running minimum from either side, and the overall minimum plus cap.
void convolveRows(const Transition& t, int levels, int width, const float* in, float* out,
                  std::vector<float>& scratch) {
  static_assert(sizeof(float) == 4);
  FreeWindow window;
  freeWindow(t.to, t.from, levels, t.free, window);
  const std::size_t w = index(width);
  scratch.assign(2 * w, kUnreachable);
  float* best = scratch.data();
  float* running = best + w;
  for (std::size_t k = 0; k < index(levels); ++k) {
    for (std::size_t j = 0; j < w; ++j) best[j] = std::min(best[j], in[k * w + j]);
  }
  for (std::size_t j = 0; j < w; ++j) best[j] += t.cap;
  int taken = 0;
  for (int k = 0; k < levels; ++k) {
    float* row = out + index(k) * w;
    for (; taken < window.low[index(k)]; ++taken) {
      const float offset = t.slope * t.from[taken];
      const float* source = in + index(taken) * w;
      for (std::size_t j = 0; j < w; ++j) running[j] = std::min(running[j], source[j] - offset);
    }
    const float offset = t.slope * (t.to[k] - t.free);
    for (std::size_t j = 0; j < w; ++j) row[j] = std::min(best[j], running[j] + offset);
    for (int q = window.low[index(k)]; q < window.high[index(k)]; ++q) {
      const float* source = in + index(q) * w;
      for (std::size_t j = 0; j < w; ++j) row[j] = std::min(row[j], source[j]);
    }
  }
  std::fill(running, running + w, kUnreachable);
  taken = levels;
  for (int k = levels; k-- > 0;) {
    for (; taken > window.high[index(k)]; --taken) {
      const float offset = t.slope * t.from[taken - 1];
      const float* source = in + index(taken - 1) * w;
      for (std::size_t j = 0; j < w; ++j) running[j] = std::min(running[j], source[j] + offset);
    }
    const float offset = t.slope * (t.to[k] + t.free);
    float* row = out + index(k) * w;
    for (std::size_t j = 0; j < w; ++j) row[j] = std::min(row[j], running[j] - offset);
  }
}

void transpose(const float* in, int levels, float* out) {
  const std::size_t n = index(levels);
  constexpr std::size_t kBlock = 16;
  for (std::size_t i0 = 0; i0 < n; i0 += kBlock) {
    for (std::size_t j0 = 0; j0 < n; j0 += kBlock) {
      for (std::size_t i = i0; i < std::min(n, i0 + kBlock); ++i) {
        for (std::size_t j = j0; j < std::min(n, j0 + kBlock); ++j) out[j * n + i] = in[i * n + j];
      }
    }
  }
}

// The label of the previous rib through which `reached` (a value of convolveRows) came.
int cameFrom(const LengthProblem& p, const SideCosts& side, int rib, int label,
             const float* before) {
  const std::size_t row = index(rib) * index(p.levels);
  const float s = side.spacing[index(rib - 1)];
  int best = 0;
  float least = kUnreachable;
  for (int k = 0; k < p.levels; ++k) {
    const float cost = before[k] + neighbourCost(p, side.place[row - index(p.levels) + index(k)],
                                                 side.place[row + index(label)], s);
    if (cost < least) {
      least = cost;
      best = k;
    }
  }
  return best;
}

// Least energy of the chain's beginning for every label of every rib of one independent side.
void forwardChain(const LengthProblem& p, const SideCosts& side, const std::vector<float>& unary,
                  std::vector<float>& table) {
  const std::size_t n = index(p.levels);
  table.resize(index(p.ribs) * n);
  std::copy(unary.begin(), unary.begin() + p.levels, table.begin());
  std::vector<float> scratch;
  for (int i = 1; i < p.ribs; ++i) {
    float* row = &table[index(i) * n];
    convolveRows(transitionOf(p, side, i), p.levels, 1, row - n, row, scratch);
    for (std::size_t k = 0; k < n; ++k) row[k] += unary[index(i) * n + k];
  }
}

// Opposite cost of one pair of labels of rib i.
float oppositeCost(const LengthProblem& p, int rib, std::size_t l, std::size_t r) {
  const std::size_t n = index(p.levels), row = index(rib) * n;
  float cost = p.opposite.empty() ? 0.f : p.opposite[l * n + r];
  if (!p.leanScale.empty()) {
    cost += p.leanScale[index(rib)] *
            std::abs((1 - p.lean) * p.left.place[row + l] - (1 + p.lean) * p.right.place[row + r]);
  }
  return cost;
}

// Adds both sides' unary costs and the opposite cost of rib i to a table of pairs.
void addPairCosts(const LengthProblem& p, int rib, float* table) {
  const std::size_t n = index(p.levels), at = index(rib) * n;
  const float* right = &p.right.unary[at];
  const float* rightPlace = &p.right.place[at];
  const float scale = p.leanScale.empty() ? 0.f : p.leanScale[index(rib)];
  for (std::size_t l = 0; l < n; ++l) {
    float* row = table + l * n;
    const float left = p.left.unary[at + l];
    if (!p.opposite.empty()) {
      const float* opposite = &p.opposite[l * n];
      for (std::size_t r = 0; r < n; ++r) row[r] += opposite[r];
    }
    const float ours = scale * (1 - p.lean) * p.left.place[at + l], theirs = scale * (1 + p.lean);
    for (std::size_t r = 0; r < n; ++r) {
      row[r] += left + right[r] + std::abs(ours - theirs * rightPlace[r]);
    }
  }
}

LengthLabels optimalPairs(const LengthProblem& p, LengthWorkspace& w) {
  const std::size_t n = index(p.levels), area = n * n;
  w.table.resize(index(p.ribs) * area);
  w.first.resize(area);
  w.second.resize(area);
  std::fill(w.table.begin(), w.table.begin() + static_cast<std::ptrdiff_t>(area), 0.f);
  addPairCosts(p, 0, w.table.data());
  for (int i = 1; i < p.ribs; ++i) {
    float* now = &w.table[index(i) * area];
    transpose(now - area, p.levels, w.first.data());
    convolveRows(transitionOf(p, p.right, i), p.levels, p.levels, w.first.data(), w.second.data(),
                 w.columns);
    transpose(w.second.data(), p.levels, w.first.data());
    convolveRows(transitionOf(p, p.left, i), p.levels, p.levels, w.first.data(), now, w.columns);
    addPairCosts(p, i, now);
  }
  LengthLabels labels;
  labels.left.resize(index(p.ribs));
  labels.right.resize(index(p.ribs));
  const float* last = &w.table[index(p.ribs - 1) * area];
  std::size_t best = static_cast<std::size_t>(std::min_element(last, last + area) - last);
  std::vector<float> column(n);
  for (int i = p.ribs - 1;; --i) {
    const int l = static_cast<int>(best / n), r = static_cast<int>(best % n);
    labels.left[index(i)] = l;
    labels.right[index(i)] = r;
    if (i == 0) break;
    // Undo the two convolutions one after the other, right side last.
    const float* before = &w.table[index(i - 1) * area];
    const float s = p.right.spacing[index(i - 1)];
    const std::size_t rowAt = index(i) * n;
    for (std::size_t k = 0; k < n; ++k) {
      w.first[k] =
          neighbourCost(p, p.right.place[rowAt - n + k], p.right.place[rowAt + index(r)], s);
    }
    for (std::size_t k = 0; k < n; ++k) {
      float least = kUnreachable;
      for (std::size_t q = 0; q < n; ++q) least = std::min(least, before[k * n + q] + w.first[q]);
      column[k] = least;
    }
    const int l0 = cameFrom(p, p.left, i, l, column.data());
    const int r0 = cameFrom(p, p.right, i, r, before + index(l0) * n);
    best = index(l0) * n + index(r0);
  }
  return labels;
}

}  // namespace

std::vector<float> oppositeTable(const std::vector<double>& values, double weight) {
  const std::size_t n = values.size();
  std::vector<float> table(n * n, 0.f);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const double sum = values[a] + values[b];
      table[a * n + b] =
          sum > 0 ? static_cast<float>(weight * 2 * std::abs(values[a] - values[b]) / sum) : 0.f;
    }
  }
  return table;
}

float neighbourCost(const LengthProblem& p, float a, float b, float spacing) {
  const float over = std::abs(a - b) - p.neighbourFreedom * spacing;
  return over <= 0 ? 0.f : std::min(p.neighbourCap, p.neighbourWeight / spacing * over);
}

namespace {

// Neighbour energy of one side's labels.
double sideSteps(const LengthProblem& p, const SideCosts& side, const std::vector<int>& labels) {
  double sum = 0;
  for (int i = 1; i < p.ribs; ++i) {
    const std::size_t row = index(i) * index(p.levels), before = row - index(p.levels);
    sum += static_cast<double>(neighbourCost(p, side.place[before + index(labels[index(i - 1)])],
                                             side.place[row + index(labels[index(i)])],
                                             side.spacing[index(i - 1)]));
  }
  return sum;
}

double sideUnary(const LengthProblem& p, const SideCosts& side, const std::vector<int>& labels) {
  double sum = 0;
  for (int i = 0; i < p.ribs; ++i) {
    sum += static_cast<double>(side.unary[index(i) * index(p.levels) + index(labels[index(i)])]);
  }
  return sum;
}

}  // namespace

double sideEnergy(const LengthProblem& p, const SideCosts& side, const std::vector<int>& labels) {
  return sideUnary(p, side, labels) + sideSteps(p, side, labels);
}

EnergyTerms energyOf(const LengthProblem& p, const LengthLabels& labels) {
  EnergyTerms terms;
  terms.distance = sideUnary(p, p.left, labels.left) + sideUnary(p, p.right, labels.right);
  terms.neighbour = sideSteps(p, p.left, labels.left) + sideSteps(p, p.right, labels.right);
  for (int i = 0; i < p.ribs; ++i) {
    terms.opposite += static_cast<double>(
        oppositeCost(p, i, index(labels.left[index(i)]), index(labels.right[index(i)])));
  }
  return terms;
}

std::vector<int> optimalSide(const LengthProblem& p, const SideCosts& side,
                             LengthWorkspace& workspace) {
  std::vector<float>& table = workspace.table;
  forwardChain(p, side, side.unary, table);
  const std::size_t n = index(p.levels);
  std::vector<int> labels(index(p.ribs));
  const float* last = &table[index(p.ribs - 1) * n];
  labels.back() = static_cast<int>(std::min_element(last, last + n) - last);
  for (int i = p.ribs - 1; i > 0; --i) {
    labels[index(i - 1)] = cameFrom(p, side, i, labels[index(i)], &table[index(i - 1) * n]);
  }
  return labels;
}

LengthLabels optimalLabels(const LengthProblem& p, LengthWorkspace& workspace) {
  if (p.paired()) return optimalPairs(p, workspace);
  LengthLabels labels;
  labels.left = optimalSide(p, p.left, workspace);
  labels.right = optimalSide(p, p.right, workspace);
  return labels;
}

std::vector<float> sideMarginals(const LengthProblem& p, const LengthLabels& labels,
                                 bool leftSide) {
  const SideCosts& side = leftSide ? p.left : p.right;
  const std::size_t n = index(p.levels);
  std::vector<float> unary = side.unary;
  if (p.paired()) {
    for (int i = 0; i < p.ribs; ++i) {
      const std::size_t other = index((leftSide ? labels.right : labels.left)[index(i)]);
      for (std::size_t k = 0; k < n; ++k) {
        unary[index(i) * n + k] +=
            leftSide ? oppositeCost(p, i, k, other) : oppositeCost(p, i, other, k);
      }
    }
  }
  std::vector<float> forward;
  forwardChain(p, side, unary, forward);
  // Backwards: the same convolution with the two ribs' parts exchanged.
  std::vector<float> ahead(n, 0.f), with(n), scratch;
  for (int i = p.ribs - 2; i >= 0; --i) {
    const std::size_t next = index(i + 1) * n;
    for (std::size_t k = 0; k < n; ++k) with[k] = ahead[k] + unary[next + k];
    Transition t = transitionOf(p, side, i + 1);
    std::swap(t.to, t.from);
    convolveRows(t, p.levels, 1, with.data(), ahead.data(), scratch);
    for (std::size_t k = 0; k < n; ++k) forward[index(i) * n + k] += ahead[k];
  }
  return forward;
}

}  // namespace spineloft::ribs
