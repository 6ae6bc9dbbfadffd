#include "engine/ribs/labels/rib_lengths.h"

#include <algorithm>
#include <cmath>

#include "engine/base/lanes.h"
#include "engine/ribs/labels/label_bounds.h"
#include "engine/ribs/labels/min_plus_line.h"
#include "engine/ribs/labels/min_plus_step.h"
#include "engine/ribs/labels/pair_search.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The label of the previous rib through which `reached` (a value of convolveRows) came.
int cameFrom(const LengthProblem& p, const SideCosts& side, int rib, int label, const float* before,
             std::vector<float>& costs) {
  const std::size_t row = index(rib) * index(p.levels);
  const float s = side.spacing[index(rib - 1)];
  const float* from = &side.place[row - index(p.levels)];
  const float to = side.place[row + index(label)];
  costs.resize(index(p.levels));
  for (std::size_t k = 0; k < costs.size(); ++k) costs[k] = before[k] + neighbourCost(p, from[k], to, s);
  const float least = leastOf(costs.data(), costs.size());
  if (!(least < kUnreachable)) return 0;
  return static_cast<int>(std::find(costs.begin(), costs.end(), least) - costs.begin());
}

// Least energy of the chain's beginning for every label of every rib of one independent side.
void forwardChain(const LengthProblem& p, const SideCosts& side, const std::vector<float>& unary,
                  LengthWorkspace& workspace, std::vector<float>& table) {
  const std::size_t n = index(p.levels);
  table.resize(index(p.ribs) * n);
  std::copy(unary.begin(), unary.begin() + p.levels, table.begin());
  const MinPlusLine line(p, side, StepWay::Forwards, workspace);
  for (int i = 1; i < p.ribs; ++i) {
    float* row = &table[index(i) * n];
    line.step(i, {row - n, row});
    for (std::size_t k = 0; k < n; ++k) row[k] += unary[index(i) * n + k];
  }
}

}  // namespace

std::vector<float> oppositeTable(const std::vector<double>& values, double weight) {
  const std::size_t n = values.size();
  std::vector<float> table(n * n, 0.f);
  for (std::size_t a = 0; a < n; ++a) {
    for (std::size_t b = 0; b < n; ++b) {
      const double sum = values[a] + values[b];
      table[a * n + b] = sum > 0 ? static_cast<float>(weight * 2 * std::abs(values[a] - values[b]) / sum) : 0.f;
    }
  }
  return table;
}

namespace {

// Neighbour energy of one side's labels.
double sideSteps(const LengthProblem& p, const SideCosts& side, const std::vector<int>& labels) {
  double sum = 0;
  for (int i = 1; i < p.ribs; ++i) {
    const std::size_t row = index(i) * index(p.levels), before = row - index(p.levels);
    sum += static_cast<double>(neighbourCost(p, side.place[before + index(labels[index(i - 1)])],
                                             side.place[row + index(labels[index(i)])], side.spacing[index(i - 1)]));
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

void leastEnergies(const LengthProblem& p, const SideCosts& side, const MinPlusColumns& chains,
                   LengthWorkspace& workspace, std::vector<float>& least) {
  const std::vector<float>& unary = chains.unary;
  const int columns = chains.columns;
  const std::size_t row = index(p.levels) * index(columns);
  std::vector<float>&now = workspace.first, &next = workspace.second;
  now.assign(unary.begin(), unary.begin() + static_cast<std::ptrdiff_t>(row));
  next.resize(row);
  for (int i = 1; i < p.ribs; ++i) {
    convolveRows(stepTo(p, side, i), {p.levels, p.levels, columns}, now.data(), next.data(), workspace.step);
    for (std::size_t j = 0; j < row; ++j) next[j] += unary[index(i) * row + j];
    now.swap(next);
  }
  least.assign(index(columns), kUnreachable);
  for (std::size_t k = 0; k < row; k += index(columns)) {
    for (std::size_t q = 0; q < index(columns); ++q) least[q] = std::min(least[q], now[k + q]);
  }
}

double sideEnergy(const LengthProblem& p, const SideCosts& side, const std::vector<int>& labels) {
  return sideUnary(p, side, labels) + sideSteps(p, side, labels);
}

EnergyTerms energyOf(const LengthProblem& p, const LengthLabels& labels) {
  EnergyTerms terms;
  terms.distance = sideUnary(p, p.left, labels.left) + sideUnary(p, p.right, labels.right);
  terms.neighbour = sideSteps(p, p.left, labels.left) + sideSteps(p, p.right, labels.right);
  for (int i = 0; i < p.ribs; ++i) {
    terms.opposite +=
        static_cast<double>(oppositeCost(p, i, index(labels.left[index(i)]), index(labels.right[index(i)])));
  }
  return terms;
}

void optimalChain(const LengthProblem& p, const SideCosts& side, const std::vector<float>& unary,
                  LengthWorkspace& workspace, std::vector<int>& labels) {
  std::vector<float>& table = workspace.table;
  forwardChain(p, side, unary, workspace, table);
  const std::size_t n = index(p.levels);
  labels.resize(index(p.ribs));
  const float* last = &table[index(p.ribs - 1) * n];
  labels.back() = static_cast<int>(std::min_element(last, last + n) - last);
  for (int i = p.ribs - 1; i > 0; --i) {
    labels[index(i - 1)] = cameFrom(p, side, i, labels[index(i)], &table[index(i - 1) * n], workspace.rowCosts);
  }
}

std::vector<int> optimalSide(const LengthProblem& p, const SideCosts& side, LengthWorkspace& workspace) {
  std::vector<int> labels;
  optimalChain(p, side, side.unary, workspace, labels);
  return labels;
}

LengthLabels optimalLabels(const LengthProblem& p, LengthWorkspace& workspace) {
  LengthLabels labels;
  findLabels(p, std::numeric_limits<double>::infinity(), workspace, labels);
  return labels;
}

bool findLabels(const LengthProblem& p, double limit, LengthWorkspace& workspace, LengthLabels& labels) {
  if (p.paired()) {
    boundLabels(p, limit, workspace, workspace.bounds);
    if (workspace.bounds.hopeless) return false;
    optimalPairs(p, workspace.bounds, workspace, labels);
  } else {
    optimalChain(p, p.left, p.left.unary, workspace, labels.left);
    optimalChain(p, p.right, p.right.unary, workspace, labels.right);
  }
  return true;
}

void sideMarginals(const LengthProblem& p, const LengthLabels& labels, bool leftSide, LengthWorkspace& workspace,
                   std::vector<float>& marginals) {
  const SideCosts& side = leftSide ? p.left : p.right;
  const std::size_t n = index(p.levels);
  std::vector<float>& unary = workspace.unary;
  unary = side.unary;
  if (p.paired()) {
    for (int i = 0; i < p.ribs; ++i) {
      const std::size_t other = index((leftSide ? labels.right : labels.left)[index(i)]);
      addOpposite(p, i, leftSide, other, &unary[index(i) * n]);
    }
  }
  forwardChain(p, side, unary, workspace, marginals);
  // Backwards: the same convolution with the two ribs' parts exchanged.
  std::vector<float>&ahead = workspace.first, &with = workspace.second;
  ahead.assign(n, 0.f);
  with.resize(n);
  const MinPlusLine line(p, side, StepWay::Backwards, workspace);
  for (int i = p.ribs - 2; i >= 0; --i) {
    const std::size_t next = index(i + 1) * n;
    for (std::size_t k = 0; k < n; ++k) with[k] = ahead[k] + unary[next + k];
    line.step(i + 1, {with.data(), ahead.data()});
    for (std::size_t k = 0; k < n; ++k) marginals[index(i) * n + k] += ahead[k];
  }
}

}  // namespace spineloft::ribs
