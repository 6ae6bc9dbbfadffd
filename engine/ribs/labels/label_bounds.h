// Which labels can be in the optimum at all: bounds from the Lagrangian dual of the pair search.
#pragma once

#include "engine/ribs/labels/rib_lengths.h"

namespace spineloft::ribs {

/// The two sides are chains, joined by the opposite costs of every rib. Any part of those may be
/// moved to the unary costs of either side as long as what is left is nowhere below 0: then the
/// least energies of both chains alone bound the least energy of all from below, and a chain's
/// least energy through a label (its min-marginal) bounds what labels can cost that use it. The
/// parts are chosen by dual ascent along the chains (min-sum diffusion): each rib of a chain in
/// turn hands on a share of what its labels cost more than the best one. Labels that are good on
/// one side, then best on the other, give the upper bound. O(ribs · levels) a round, some rounds at
/// most; `problem.paired()`. Gives up with `hopeless` as soon as the lower bound is not below
/// `limit`. Replaces `bounds`.
void boundLabels(const LengthProblem& problem, double limit, LengthWorkspace& workspace, LabelBounds& bounds);

}  // namespace spineloft::ribs
