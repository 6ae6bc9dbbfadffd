#include "engine/ribs/labels/label_bounds.h"

#include <algorithm>
#include <cmath>

#include "engine/base/lanes.h"
#include "engine/ribs/labels/min_plus_line.h"
#include "engine/ribs/labels/min_plus_step.h"

namespace spineloft::ribs {
namespace {

// Share of a rib's excess that it hands on; at the end of the chain all of it.
constexpr float kHandedOn = 0.1f;
constexpr int kMostRounds = 3;
// A round costs about as much as this many pairs of labels for every label.
constexpr double kPairsPerLabel = 24;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// What single precision may lose along a chain of energies about as large as `energy`.
double slackOf(double energy) { return 2e-3 + 1e-4 * std::abs(energy); }

class Ascent {
 public:
  Ascent(const LengthProblem& p, LengthWorkspace& workspace, LabelBounds& b)
      : p_(p),
        workspace_(workspace),
        b_(b),
        n_(index(p.levels)),
        onwards_{{p, p.left, StepWay::Forwards, workspace}, {p, p.right, StepWay::Forwards, workspace}},
        back_{{p, p.left, StepWay::Backwards, workspace}, {p, p.right, StepWay::Backwards, workspace}} {
    for (LengthWorkspace::Chain& side : workspace_.chains) {
      side.moved.assign(index(p.ribs) * n_, 0.f);
      side.forward.resize(side.moved.size());
      side.backward.resize(side.moved.size());
      for (auto* row : {&side.row, &side.held, &side.next}) row->resize(n_);
    }
  }

  // Hands the excess of one side's labels on to the other side, rib after rib; that side must be swept
  // backward.
  void handOn(bool left) {
    LengthWorkspace::Chain &own = workspace_.chains[left ? 0 : 1], &other = workspace_.chains[left ? 1 : 0];
    std::fill(own.forward.begin(), own.forward.begin() + p_.levels, 0.f);
    for (int i = 0; i < p_.ribs; ++i) {
      const std::size_t at = index(i) * n_;
      fillThrough(left, at, own.row.data());
      const float* row = own.row.data();
      float *moved = &own.moved[at], *held = own.held.data();
      const float least = leastOf(row, n_);
      const float share = std::max(kHandedOn, 1.f / static_cast<float>(p_.ribs - i));
      for (std::size_t k = 0; k < n_; ++k) {
        const bool exists = row[k] < kUnreachable;
        const float kept = moved[k] - share * (row[k] - least);
        moved[k] = exists ? kept : moved[k];
        held[k] = exists ? -kept : kUnreachable;
      }
      // All that is left of the opposite costs goes to the other side.
      leastOpposite(p_, i, !left, {held, &other.moved[at]}, workspace_.step);
      stepForward(left, i);
    }
  }

  // Min-marginals' two halves of one side as its costs stand now.
  void sweepForward(bool left) {
    auto& forward = workspace_.chains[left ? 0 : 1].forward;
    std::fill(forward.begin(), forward.begin() + p_.levels, 0.f);
    for (int i = 0; i < p_.ribs; ++i) stepForward(left, i);
  }
  void sweepBackward(bool left) {
    LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    const SideCosts& costs = left ? p_.left : p_.right;
    std::fill(own.backward.end() - p_.levels, own.backward.end(), 0.f);
    for (int i = p_.ribs - 1; i > 0; --i) {
      const std::size_t at = index(i) * n_;
      for (std::size_t k = 0; k < n_; ++k) own.next[k] = own.backward[at + k] + costs.unary[at + k] + own.moved[at + k];
      back_[left ? 0 : 1].step(i, {own.next.data(), &own.backward[at - n_]});
    }
  }

  // Least energies of one side's chain through every label of a rib, whose first one is at `at`; both
  // halves must be swept.
  void fillThrough(bool left, std::size_t at, float* __restrict row) const {
    const LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    const float *forward = &own.forward[at], *backward = &own.backward[at], *moved = &own.moved[at],
                *unary = &(left ? p_.left : p_.right).unary[at];
    for (std::size_t k = 0; k < n_; ++k) row[k] = forward[k] + unary[k] + moved[k] + backward[k];
  }
  // The same for a side that is swept backward only, from the labels of its first rib.
  float leastAhead(bool left) const {
    const LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    const SideCosts& costs = left ? p_.left : p_.right;
    float best = kUnreachable;
    for (std::size_t k = 0; k < n_; ++k) best = lesser(costs.unary[k] + own.moved[k] + own.backward[k], best);
    return best;
  }
  // Least energy of one side's chain; both halves must be swept.
  float least(bool left) {
    std::vector<float>& row = workspace_.chains[left ? 0 : 1].row;
    fillThrough(left, 0, row.data());
    return leastOf(row.data(), n_);
  }

  // Better labels, if the bounds lead to any: rib after rib the label that is least on the left,
  // given the one before and what the rest of the chain can still cost, and then on the right,
  // given that one as well; then the best of either side for those of the other.
  void tryLabels(int round) {
    LengthLabels& labels = workspace_.trial;
    labels.left.resize(index(p_.ribs));
    labels.right.resize(index(p_.ribs));
    for (int i = 0; i < p_.ribs; ++i) {
      labels.left[index(i)] = likeliest(true, i, i > 0 ? labels.left[index(i - 1)] : -1, -1);
      labels.right[index(i)] = likeliest(false, i, i > 0 ? labels.right[index(i - 1)] : -1, labels.left[index(i)]);
    }
    answer(true, labels);
    answer(false, labels);
    const double energy = energyOf(p_, labels).total();
    if (round == 0 || energy < b_.upper) {
      b_.upper = energy;
      b_.best = labels;
    }
  }

  // Keeps the labels of one side whose bound is not above the upper one.
  void keepLabels(bool left) {
    const float rest = least(!left);
    const auto most = static_cast<float>(b_.upper + slackOf(b_.upper));
    float* row = workspace_.chains[left ? 0 : 1].row.data();
    std::vector<LabelRun>& runs = left ? b_.left : b_.right;
    runs.resize(index(p_.ribs));
    for (int i = 0; i < p_.ribs; ++i) {
      const int chosen = (left ? b_.best.left : b_.best.right)[index(i)];
      LabelRun& run = runs[index(i)];
      run = {chosen, chosen + 1};
      fillThrough(left, index(i) * n_, row);
      for (int k = 0; k < p_.levels; ++k) {
        if (!(row[k] + rest <= most)) continue;
        run.low = std::min(run.low, k);
        run.high = std::max(run.high, k + 1);
      }
    }
  }

 private:
  int likeliest(bool left, int i, int before, int opposite) {
    const SideCosts& costs = left ? p_.left : p_.right;
    LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    const std::size_t at = index(i) * n_;
    float* row = own.row.data();
    const float *unary = &costs.unary[at], *backward = &own.backward[at], *moved = &own.moved[at];
    for (std::size_t k = 0; k < n_; ++k) row[k] = unary[k] + backward[k];
    if (opposite < 0) {
      for (std::size_t k = 0; k < n_; ++k) row[k] += moved[k];
    } else {
      addOpposite(p_, i, left, index(opposite), row);
    }
    if (before >= 0) {
      const float from = costs.place[at - n_ + index(before)], spacing = costs.spacing[index(i - 1)];
      const float* place = &costs.place[at];
      for (std::size_t k = 0; k < n_; ++k) row[k] += neighbourCost(p_, from, place[k], spacing);
    }
    const float least = leastOf(row, n_);
    return least < kUnreachable ? static_cast<int>(std::find(row, row + n_, least) - row) : 0;
  }

  // The best labels of one side against the other's.
  void answer(bool left, LengthLabels& labels) {
    const SideCosts& own = left ? p_.left : p_.right;
    std::vector<float>& unary = workspace_.unary;
    unary = own.unary;
    for (int i = 0; i < p_.ribs; ++i) {
      const std::size_t other = index((left ? labels.right : labels.left)[index(i)]);
      addOpposite(p_, i, left, other, &unary[index(i) * n_]);
    }
    optimalChain(p_, own, unary, workspace_, left ? labels.left : labels.right);
  }

  void stepForward(bool left, int i) {
    if (i + 1 == p_.ribs) return;
    LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    const SideCosts& costs = left ? p_.left : p_.right;
    const std::size_t at = index(i) * n_;
    for (std::size_t k = 0; k < n_; ++k) own.next[k] = own.forward[at + k] + costs.unary[at + k] + own.moved[at + k];
    onwards_[left ? 0 : 1].step(i + 1, {own.next.data(), &own.forward[at + n_]});
  }

  const LengthProblem& p_;
  LengthWorkspace& workspace_;
  LabelBounds& b_;
  std::size_t n_;
  MinPlusLine onwards_[2], back_[2];  // of the left and the right side
};

}  // namespace

double LabelBounds::cells() const {
  double sum = 0;
  for (std::size_t i = 0; i < left.size(); ++i) sum += static_cast<double>(left[i].size()) * right[i].size();
  return sum;
}

void boundLabels(const LengthProblem& p, double limit, LengthWorkspace& workspace, LabelBounds& b) {
  b.hopeless = false;
  Ascent ascent(p, workspace, b);
  for (int round = 0; round < kMostRounds; ++round) {
    ascent.sweepBackward(true);
    const double ofLeft = ascent.leastAhead(true);
    ascent.handOn(true);
    // What was handed on was more than the least: that of the left side is as before. Often it is enough
    // to see that a rival has no chance.
    ascent.sweepBackward(false);
    b.lower = ofLeft + static_cast<double>(ascent.leastAhead(false));
    if (b.lower - slackOf(b.lower) >= limit) {
      b.hopeless = true;
      return;
    }
    ascent.handOn(false);
    ascent.sweepBackward(false);
    ascent.sweepForward(true);
    ascent.sweepBackward(true);
    b.lower = static_cast<double>(ascent.least(true)) + static_cast<double>(ascent.least(false));
    if (b.lower - slackOf(b.lower) >= limit) {
      b.hopeless = true;
      return;
    }
    ascent.tryLabels(round);
    ascent.keepLabels(true);
    ascent.keepLabels(false);
    if (b.cells() <= kPairsPerLabel * p.ribs * p.levels) return;
  }
}

}  // namespace spineloft::ribs
