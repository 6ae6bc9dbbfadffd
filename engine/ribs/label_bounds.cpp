#include "engine/ribs/label_bounds.h"

#include <algorithm>
#include <cmath>

#include "engine/ribs/chain_line.h"
#include "engine/ribs/chain_step.h"

namespace spineloft::ribs {
namespace {

// Share of a rib's excess that it hands on; at the end of the chain all of it.
constexpr float kHandedOn = 0.1f;
constexpr int kMostRounds = 3;
// A round costs about as much as this many pairs of labels for every label.
constexpr double kPairsPerLabel = 8;

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
        onwards_{{p, p.left, StepWay::Forwards, workspace},
                 {p, p.right, StepWay::Forwards, workspace}},
        back_{{p, p.left, StepWay::Backwards, workspace},
              {p, p.right, StepWay::Backwards, workspace}} {
    for (LengthWorkspace::Chain& side : workspace_.chains) {
      side.moved.assign(index(p.ribs) * n_, 0.f);
      side.forward.resize(side.moved.size());
      side.backward.resize(side.moved.size());
      for (auto* row : {&side.row, &side.held, &side.next}) row->resize(n_);
    }
  }

  // Hands the excess of one side's labels on to the other side, rib after rib.
  void handOn(bool left) {
    LengthWorkspace::Chain &own = workspace_.chains[left ? 0 : 1],
                           &other = workspace_.chains[left ? 1 : 0];
    const SideCosts& costs = left ? p_.left : p_.right;
    sweepBackward(left);
    std::fill(own.forward.begin(), own.forward.begin() + p_.levels, 0.f);
    for (int i = 0; i < p_.ribs; ++i) {
      const std::size_t at = index(i) * n_;
      float least = kUnreachable;
      for (std::size_t k = 0; k < n_; ++k) {
        own.row[k] =
            own.forward[at + k] + costs.unary[at + k] + own.moved[at + k] + own.backward[at + k];
        least = std::min(least, own.row[k]);
      }
      const float share = std::max(kHandedOn, 1.f / static_cast<float>(p_.ribs - i));
      for (std::size_t k = 0; k < n_; ++k) {
        const bool exists = own.row[k] < kUnreachable;
        if (exists) own.moved[at + k] -= share * (own.row[k] - least);
        own.held[k] = exists ? -own.moved[at + k] : kUnreachable;
      }
      // All that is left of the opposite costs goes to the other side.
      leastOpposite(p_, i, !left, own.held.data(), &other.moved[at]);
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
      for (std::size_t k = 0; k < n_; ++k)
        own.next[k] = own.backward[at + k] + costs.unary[at + k] + own.moved[at + k];
      back_[left ? 0 : 1].step(i, {own.next.data(), &own.backward[at - n_]});
    }
  }

  // Least energy of one side's chain through label k of rib i; both halves must be swept.
  float through(bool left, std::size_t at) const {
    const LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    return own.forward[at] + (left ? p_.left : p_.right).unary[at] + own.moved[at] +
           own.backward[at];
  }
  float least(bool left) const {
    float best = kUnreachable;
    for (std::size_t k = 0; k < n_; ++k) best = std::min(best, through(left, k));
    return best;
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
      labels.right[index(i)] =
          likeliest(false, i, i > 0 ? labels.right[index(i - 1)] : -1, labels.left[index(i)]);
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
    std::vector<LabelRun>& runs = left ? b_.left : b_.right;
    runs.resize(index(p_.ribs));
    for (int i = 0; i < p_.ribs; ++i) {
      const int chosen = (left ? b_.best.left : b_.best.right)[index(i)];
      LabelRun& run = runs[index(i)];
      run = {chosen, chosen + 1};
      for (int k = 0; k < p_.levels; ++k) {
        if (!(through(left, index(i) * n_ + index(k)) + rest <= most)) continue;
        run.low = std::min(run.low, k);
        run.high = std::max(run.high, k + 1);
      }
    }
  }

 private:
  int likeliest(bool left, int i, int before, int opposite) const {
    const SideCosts& costs = left ? p_.left : p_.right;
    const LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    const std::size_t at = index(i) * n_;
    int best = 0;
    float least = kUnreachable;
    for (int k = 0; k < p_.levels; ++k) {
      float cost = costs.unary[at + index(k)] + own.backward[at + index(k)];
      cost += opposite < 0 ? own.moved[at + index(k)]
                           : (left ? oppositeCost(p_, i, index(k), index(opposite))
                                   : oppositeCost(p_, i, index(opposite), index(k)));
      if (before >= 0)
        cost += neighbourCost(p_, costs.place[at - n_ + index(before)], costs.place[at + index(k)],
                              costs.spacing[index(i - 1)]);
      if (cost < least) {
        least = cost;
        best = k;
      }
    }
    return best;
  }

  // The best labels of one side against the other's.
  void answer(bool left, LengthLabels& labels) {
    const SideCosts& own = left ? p_.left : p_.right;
    std::vector<float>& unary = workspace_.unary;
    unary.resize(own.unary.size());
    for (int i = 0; i < p_.ribs; ++i) {
      const std::size_t other = index((left ? labels.right : labels.left)[index(i)]);
      for (std::size_t k = 0; k < n_; ++k) {
        unary[index(i) * n_ + k] =
            own.unary[index(i) * n_ + k] +
            (left ? oppositeCost(p_, i, k, other) : oppositeCost(p_, i, other, k));
      }
    }
    optimalChain(p_, own, unary, workspace_, left ? labels.left : labels.right);
  }

  void stepForward(bool left, int i) {
    if (i + 1 == p_.ribs) return;
    LengthWorkspace::Chain& own = workspace_.chains[left ? 0 : 1];
    const SideCosts& costs = left ? p_.left : p_.right;
    const std::size_t at = index(i) * n_;
    for (std::size_t k = 0; k < n_; ++k)
      own.next[k] = own.forward[at + k] + costs.unary[at + k] + own.moved[at + k];
    onwards_[left ? 0 : 1].step(i + 1, {own.next.data(), &own.forward[at + n_]});
  }

  const LengthProblem& p_;
  LengthWorkspace& workspace_;
  LabelBounds& b_;
  std::size_t n_;
  ChainLine onwards_[2], back_[2];  // of the left and the right side
};

}  // namespace

double LabelBounds::cells() const {
  double sum = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    sum += static_cast<double>(left[i].size()) * right[i].size();
  return sum;
}

void boundLabels(const LengthProblem& p, double limit, LengthWorkspace& workspace, LabelBounds& b) {
  b.hopeless = false;
  Ascent ascent(p, workspace, b);
  for (int round = 0; round < kMostRounds; ++round) {
    ascent.handOn(true);
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
