#include "engine/ribs/rib_lengths.h"

#include <algorithm>
#include <cmath>

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

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

// out = min(a, b + offset), and the like, over a row of columns.
void keepLess(float* row, const float* other, float offset, std::size_t width) {
  for (std::size_t j = 0; j < width; ++j) row[j] = std::min(row[j], other[j] + offset);
}

// The labels [low, high) of the previous rib that are free of charge for a label standing at `to`;
// low and high only ever move up as `to` does.
void moveWindow(const Transition& t, int levels, float to, int& low, int& high) {
  while (low < levels && t.from[low] < to - t.free) ++low;
  while (high < levels && t.from[high] <= to + t.free) ++high;
}

// out(k, ·) = min over k' of in(k', ·) + min(cap, slope · max(0, |to_k − from_k'| − free)), for
// `width` columns at once. The cost is flat in a window and linear outside, so the minimum is the
// least of a window minimum, a running minimum from either side, and the overall minimum plus cap.
void convolveRows(const Transition& t, int levels, int width, const float* in, float* out,
                  std::vector<float>& scratch) {
  const std::size_t w = index(width);
  scratch.assign(2 * w, kUnreachable);
  float* best = scratch.data();
  float* running = best + w;
  for (std::size_t k = 0; k < index(levels); ++k) keepLess(best, in + k * w, 0, w);
  for (std::size_t j = 0; j < w; ++j) best[j] += t.cap;
  int low = 0, high = 0, taken = 0;
  for (int k = 0; k < levels; ++k) {
    moveWindow(t, levels, t.to[k], low, high);
    for (; taken < low; ++taken)
      keepLess(running, in + index(taken) * w, -t.slope * t.from[taken], w);
    float* row = out + index(k) * w;
    const float offset = t.slope * (t.to[k] - t.free);
    if (high == low + 1) {
      const float* source = in + index(low) * w;
      for (std::size_t j = 0; j < w; ++j) {
        row[j] = std::min(std::min(best[j], running[j] + offset), source[j]);
      }
      continue;
    }
    for (std::size_t j = 0; j < w; ++j) row[j] = std::min(best[j], running[j] + offset);
    for (int q = low; q < high; ++q) keepLess(row, in + index(q) * w, 0, w);
  }
  std::fill(running, running + w, kUnreachable);
  taken = levels;
  for (int k = levels; k-- > 0;) {
    while (taken > 0 && t.from[taken - 1] > t.to[k] + t.free) {
      --taken;
      keepLess(running, in + index(taken) * w, t.slope * t.from[taken], w);
    }
    keepLess(out + index(k) * w, running, -t.slope * (t.to[k] + t.free), w);
  }
}

// The same for one column.
void convolveLine(const Transition& t, int levels, const float* in, float* out) {
  const float best = *std::min_element(in, in + levels) + t.cap;
  float running = kUnreachable;
  int low = 0, high = 0, taken = 0;
  for (int k = 0; k < levels; ++k) {
    moveWindow(t, levels, t.to[k], low, high);
    for (; taken < low; ++taken) running = std::min(running, in[taken] - t.slope * t.from[taken]);
    out[k] = std::min(best, running + t.slope * (t.to[k] - t.free));
    for (int q = low; q < high; ++q) out[k] = std::min(out[k], in[q]);
  }
  running = kUnreachable;
  taken = levels;
  for (int k = levels; k-- > 0;) {
    while (taken > 0 && t.from[taken - 1] > t.to[k] + t.free) {
      --taken;
      running = std::min(running, in[taken] + t.slope * t.from[taken]);
    }
    out[k] = std::min(out[k], running - t.slope * (t.to[k] + t.free));
  }
}

// out = in transposed; in has `rows` × `columns` entries.
void transpose(const float* in, std::size_t rows, std::size_t columns, float* out) {
  constexpr std::size_t kBlock = 16;
  for (std::size_t i0 = 0; i0 < rows; i0 += kBlock) {
    const std::size_t i1 = std::min(rows, i0 + kBlock);
    for (std::size_t j0 = 0; j0 < columns; j0 += kBlock) {
      const std::size_t j1 = std::min(columns, j0 + kBlock);
      for (std::size_t j = j0; j < j1; ++j) {
        for (std::size_t i = i0; i < i1; ++i) out[j * rows + i] = in[i * columns + j];
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
  for (int i = 1; i < p.ribs; ++i) {
    float* row = &table[index(i) * n];
    convolveLine(transitionOf(p, side, i), p.levels, row - n, row);
    for (std::size_t k = 0; k < n; ++k) row[k] += unary[index(i) * n + k];
  }
}

// One more than the highest label that any rib of a side can take.
std::size_t usedLevels(const LengthProblem& p, const SideCosts& side) {
  const std::size_t n = index(p.levels);
  std::size_t used = 1;
  for (std::size_t row = 0; row < side.unary.size(); row += n) {
    for (std::size_t k = n; k > used; --k) {
      if (side.unary[row + k - 1] < kUnreachable) used = k;
    }
  }
  return used;
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

// The tables of the pair search alternate: rib i is stored with the left label as row where i is
// even, else with the right label, so that each step needs one transposition only.
struct PairTables {
  const LengthProblem& p;
  std::size_t lefts, rights;  // labels in use
  float* data;
  bool leftRows(int rib) const { return rib % 2 == 0; }
  float* of(int rib) const { return data + index(rib) * lefts * rights; }
};

// Adds both sides' unary costs and the opposite cost of a rib to its table.
void addPairCosts(const PairTables& tables, int rib) {
  const LengthProblem& p = tables.p;
  const std::size_t n = index(p.levels), at = index(rib) * n;
  const bool leftRows = tables.leftRows(rib);
  const SideCosts& rowSide = leftRows ? p.left : p.right;
  const SideCosts& columnSide = leftRows ? p.right : p.left;
  const std::size_t rows = leftRows ? tables.lefts : tables.rights;
  const std::size_t columns = leftRows ? tables.rights : tables.lefts;
  const float scale = p.leanScale.empty() ? 0.f : p.leanScale[index(rib)];
  const float rowScale = scale * (leftRows ? 1 - p.lean : 1 + p.lean);
  const float columnScale = scale * (leftRows ? 1 + p.lean : 1 - p.lean);
  for (std::size_t i = 0; i < rows; ++i) {
    float* row = tables.of(rib) + i * columns;
    const float own = rowSide.unary[at + i], place = rowScale * rowSide.place[at + i];
    const float* unary = &columnSide.unary[at];
    const float* places = &columnSide.place[at];
    for (std::size_t j = 0; j < columns; ++j) {
      row[j] += own + unary[j] + std::abs(place - columnScale * places[j]);
    }
    if (p.opposite.empty()) continue;
    for (std::size_t j = 0; j < columns; ++j) {
      row[j] += leftRows ? p.opposite[i * n + j] : p.opposite[j * n + i];
    }
  }
}

// Costs of coming to `label` of rib from every label of the rib before.
void stepCosts(const LengthProblem& p, const SideCosts& side, int rib, std::size_t label,
               std::vector<float>& costs) {
  const std::size_t row = index(rib) * index(p.levels), before = row - index(p.levels);
  for (std::size_t k = 0; k < costs.size(); ++k) {
    costs[k] = neighbourCost(p, side.place[before + k], side.place[row + label],
                             side.spacing[index(rib - 1)]);
  }
}

// The pair of labels at rib − 1 through which the pair (l, r) at `rib` was reached.
void stepBack(const PairTables& tables, int rib, std::size_t& l, std::size_t& r) {
  const bool leftRows = tables.leftRows(rib - 1);
  std::vector<float> left(tables.lefts), right(tables.rights);
  stepCosts(tables.p, tables.p.left, rib, l, left);
  stepCosts(tables.p, tables.p.right, rib, r, right);
  const std::vector<float>&rowCosts = leftRows ? left : right,
        &columnCosts = leftRows ? right : left;
  const std::size_t columns = columnCosts.size();
  const float* table = tables.of(rib - 1);
  std::vector<float> best(columns, kUnreachable);
  for (std::size_t i = 0; i < rowCosts.size(); ++i) {
    keepLess(best.data(), table + i * columns, rowCosts[i], columns);
  }
  std::size_t row = 0, column = 0;
  for (std::size_t j = 1; j < columns; ++j) {
    if (best[j] + columnCosts[j] < best[column] + columnCosts[column]) column = j;
  }
  for (std::size_t i = 1; i < rowCosts.size(); ++i) {
    if (table[i * columns + column] + rowCosts[i] < table[row * columns + column] + rowCosts[row])
      row = i;
  }
  l = leftRows ? row : column;
  r = leftRows ? column : row;
}

LengthLabels optimalPairs(const LengthProblem& p, LengthWorkspace& w) {
  const std::size_t lefts = usedLevels(p, p.left), rights = usedLevels(p, p.right);
  const std::size_t area = lefts * rights;
  const PairTables tables{p, lefts, rights, w.pairTable(index(p.ribs) * area)};
  w.first.resize(area);
  w.second.resize(area);
  std::fill(tables.of(0), tables.of(0) + area, 0.f);
  addPairCosts(tables, 0);
  for (int i = 1; i < p.ribs; ++i) {
    const bool leftRows = tables.leftRows(i - 1);
    const SideCosts& rowSide = leftRows ? p.left : p.right;
    const SideCosts& columnSide = leftRows ? p.right : p.left;
    const std::size_t rows = leftRows ? lefts : rights, columns = leftRows ? rights : lefts;
    convolveRows(transitionOf(p, rowSide, i), static_cast<int>(rows), static_cast<int>(columns),
                 tables.of(i - 1), w.first.data(), w.columns);
    transpose(w.first.data(), rows, columns, w.second.data());
    convolveRows(transitionOf(p, columnSide, i), static_cast<int>(columns), static_cast<int>(rows),
                 w.second.data(), tables.of(i), w.columns);
    addPairCosts(tables, i);
  }
  LengthLabels labels;
  labels.left.resize(index(p.ribs));
  labels.right.resize(index(p.ribs));
  const int last = p.ribs - 1;
  const auto best = static_cast<std::size_t>(
      std::min_element(tables.of(last), tables.of(last) + area) - tables.of(last));
  std::size_t l = tables.leftRows(last) ? best / rights : best % lefts;
  std::size_t r = tables.leftRows(last) ? best % rights : best / lefts;
  for (int i = last;; --i) {
    labels.left[index(i)] = static_cast<int>(l);
    labels.right[index(i)] = static_cast<int>(r);
    if (i == 0) break;
    stepBack(tables, i, l, r);
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

std::vector<float> leastEnergies(const LengthProblem& p, const SideCosts& side,
                                 const std::vector<float>& unary, int columns,
                                 LengthWorkspace& workspace) {
  const std::size_t row = index(p.levels) * index(columns);
  std::vector<float>&now = workspace.first, &next = workspace.second;
  now.assign(unary.begin(), unary.begin() + static_cast<std::ptrdiff_t>(row));
  next.resize(row);
  for (int i = 1; i < p.ribs; ++i) {
    convolveRows(transitionOf(p, side, i), p.levels, columns, now.data(), next.data(),
                 workspace.columns);
    for (std::size_t j = 0; j < row; ++j) next[j] += unary[index(i) * row + j];
    now.swap(next);
  }
  std::vector<float> least(index(columns), kUnreachable);
  for (std::size_t j = 0; j < row; ++j) {
    least[j % least.size()] = std::min(least[j % least.size()], now[j]);
  }
  return least;
}

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
  std::vector<float> ahead(n, 0.f), with(n);
  for (int i = p.ribs - 2; i >= 0; --i) {
    const std::size_t next = index(i + 1) * n;
    for (std::size_t k = 0; k < n; ++k) with[k] = ahead[k] + unary[next + k];
    Transition t = transitionOf(p, side, i + 1);
    std::swap(t.to, t.from);
    convolveLine(t, p.levels, with.data(), ahead.data());
    for (std::size_t k = 0; k < n; ++k) forward[index(i) * n + k] += ahead[k];
  }
  return forward;
}

}  // namespace spineloft::ribs
