// Rib lengths: the energy of SpineLoft 3.3.2 over labels, and its exact minimum (method: "Rib
// lengths: the optimum, not a sample").
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "engine/ribs/base/rib_set.h"

namespace spineloft::ribs {

/// Cost of a label that a curve never reaches.
inline constexpr float kUnreachable = std::numeric_limits<float>::infinity();

/// One side of the spine. Tables have ribs × levels entries, rib after rib.
struct SideCosts {
  /// Distance term of every label; kUnreachable where there is no such point.
  /// At least one label of every rib is finite.
  std::vector<float> unary;
  /// Where a label stands on its curve, in the unit in which neighbours are compared (d2 in the
  /// paper, arc length here): strictly increasing along a rib. Also set where unreachable.
  std::vector<float> place;
  /// Distance on the hull between neighbouring ribs, ribs − 1 entries, same unit, > 0.
  std::vector<float> spacing;
};

/// The chain of (left, right) label pairs. Energy of labels l, r:
///   Σ unary_left(i, l_i) + unary_right(i, r_i)
/// + Σ over neighbours of one side min(cap, weight · max(0, |Δplace| / spacing − freedom))
/// + Σ opposite(l_i, r_i).
struct LengthProblem {
  int ribs = 0, levels = 0;
  SideCosts left, right;
  float neighbourWeight = 3, neighbourFreedom = 0.25f;
  /// Most that a jump may cost: a bottle's shoulder is a step, not a series of errors.
  float neighbourCap = std::numeric_limits<float>::infinity();
  /// levels × levels costs, row = left label; empty where opposite sides are independent.
  std::vector<float> opposite;
  /// Opposite ends compared by place instead, for a stroke whose medial offset m is known (see medial_offset.h): a cost
  /// of min(medialOffsetCap, medialOffsetScale_i · |(1 − m) left − (1 + m) right|) per rib, on top of the table.
  /// −1 < m < 1. medialOffsetScale is empty, or has `ribs` entries.
  float medialOffset = 0;
  std::vector<float> medialOffsetScale;
  float medialOffsetCap = std::numeric_limits<float>::infinity();
  bool paired() const { return !opposite.empty() || !medialOffsetScale.empty(); }
};

/// Labels of both sides, `ribs` entries each.
struct LengthLabels {
  std::vector<int> left, right;
  bool operator==(const LengthLabels&) const = default;
};

/// SpineLoft's opposite penalty weight · |a − b| / a, made symmetric: 2 |a − b| / (a + b), so that
/// swapping the sides changes nothing. `values` are the labels' d2 (or radii), increasing from ≥ 0.
std::vector<float> oppositeTable(const std::vector<double>& values, double weight);

/// The cost between two neighbouring labels standing at places a and b.
inline float neighbourCost(const LengthProblem& problem, float a, float b, float spacing) {
  const float apart = a - b, over = (apart < 0 ? -apart : apart) - problem.neighbourFreedom * spacing;
  const float cost = problem.neighbourWeight / spacing * over;
  const float held = cost < problem.neighbourCap ? cost : problem.neighbourCap;
  return over <= 0 ? 0.f : held;
}

/// The energy of any labels by term; the unary table counts as `distance`.
EnergyTerms energyOf(const LengthProblem& problem, const LengthLabels& labels);

/// Labels [low, high) of one end; never empty.
struct LabelRun {
  int low = 0, high = 0;
  int size() const { return high - low; }
};

/// What is known about the least energy of a paired problem before the search (label_bounds.h).
struct LabelBounds {
  double lower = 0;                   ///< no labels have less, but for rounding
  double upper = 0;                   ///< `best` have this
  LengthLabels best;                  ///< good labels, mostly the optimum
  std::vector<LabelRun> left, right;  ///< of every rib: all labels that energies ≤ upper can use
  bool hopeless = false;              ///< `lower` reached the limit: nothing else is set
  double cells() const;               ///< pairs of labels left, over all ribs
};

/// Memory of one step along a chain (min_plus_step.h).
struct StepScratch {
  std::vector<int> low, high;  ///< of the windows of labels that are free of charge
  std::vector<float> running, tables;
};

/// Which labels are free of charge in every step along one side, one way (chain_line.h). A search
/// steps along the same side many times.
struct StepPlan {
  /// Of one label: as many of the labels of the rib before lie below its window, and up to the
  /// window's end; and where in a line's tables the two overlapping runs are that make the window.
  struct Window {
    std::uint16_t low, high, first, second;
  };
  std::vector<Window> windows;          ///< of every rib but the first one stepped from × levels
  std::vector<std::uint8_t> doublings;  ///< most of a window of each of these ribs
  /// What the windows depend on.
  std::vector<float> place, spacing;
  float freedom = 0;
};

/// Memory of the chains over widths (medial_offset.h).
struct WidthTables {
  /// Costs from a place to the next: base + slope · (at − place).
  struct Line {
    float place, next, base, slope;
  };
  std::vector<Line> left, right;
  std::vector<float> widths, unary, energies;
  std::vector<std::int32_t> begin;
  std::vector<int> labels;
  LengthProblem chain;
};

/// Memory of the chain round an end (end_fan.h).
struct EndTables {
  LengthProblem chain;
  std::vector<int> labels;
};

/// Memory that the optimiser reuses from call to call, and what it last found out about a problem.
struct LengthWorkspace {
  LabelBounds bounds;
  /// One side's chain while bounds are sought.
  struct Chain {
    std::vector<float> moved;              ///< what opposite costs add to the unary ones
    std::vector<float> forward, backward;  ///< least energies up to a rib's label, own cost not in
    std::vector<float> row, held, next;    ///< one rib each
  };
  Chain chains[2];
  LengthLabels trial;
  StepScratch step;
  StepPlan forwards[2], backwards[2];  // of the left and the right side
  WidthTables widths;
  EndTables end;
  std::vector<float> table, first, second, columns, rowCosts, columnCosts, unary;
  std::vector<std::size_t> starts;
  /// At least `size` floats, not cleared.
  float* pairTable(std::size_t size) {
    if (size > pairSize) {
      pairs = std::make_unique_for_overwrite<float[]>(size);
      pairSize = size;
    }
    return pairs.get();
  }
  std::unique_ptr<float[]> pairs;
  std::size_t pairSize = 0;
};

/// The labels of least energy, exactly: dynamic programming along the chain, each step one
/// min-convolution per side. O(ribs · levels) where the sides are independent, else labels that
/// cannot be in the optimum are dropped first (label_bounds.h) and the pairs of what is left are
/// searched: at worst O(ribs · levels²). Equal energies are resolved towards smaller labels.
LengthLabels optimalLabels(const LengthProblem& problem, LengthWorkspace& workspace);

/// The same into `labels`, reusing memory; gives up and returns false as soon as it is certain that
/// no labels have an energy below `limit`. It may also find labels of a higher energy than that.
bool findLabels(const LengthProblem& problem, double limit, LengthWorkspace& workspace, LengthLabels& labels);

/// The labels of least energy of one side with other unary costs (ribs × levels), into `labels`.
void optimalChain(const LengthProblem& problem, const SideCosts& side, const std::vector<float>& unary,
                  LengthWorkspace& workspace, std::vector<int>& labels);

/// The same for one side on its own, whatever the opposite costs: O(ribs · levels). `side` has
/// problem.ribs × problem.levels entries and need not belong to the problem.
std::vector<int> optimalSide(const LengthProblem& problem, const SideCosts& side, LengthWorkspace& workspace);

/// Chains that differ in their unary costs only, side by side: `unary` has problem.ribs ×
/// problem.levels × columns entries.
struct MinPlusColumns {
  const std::vector<float>& unary;
  int columns = 0;
};
/// The least energy of each, into `least`; places and spacings are `side`'s.
void leastEnergies(const LengthProblem& problem, const SideCosts& side, const MinPlusColumns& chains,
                   LengthWorkspace& workspace, std::vector<float>& least);

/// Unary and neighbour energy of one side's labels.
double sideEnergy(const LengthProblem& problem, const SideCosts& side, const std::vector<int>& labels);

/// Min-marginals of one side with the other side's labels held: for every rib and label the least
/// energy of that side's chain through it (ribs × levels), into `marginals`. Confidence is read from these.
void sideMarginals(const LengthProblem& problem, const LengthLabels& labels, bool leftSide, LengthWorkspace& workspace,
                   std::vector<float>& marginals);

}  // namespace spineloft::ribs
