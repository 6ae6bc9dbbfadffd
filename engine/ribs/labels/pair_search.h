// The exact search over pairs of opposite labels, within bounds (see label_bounds.h).
#pragma once

#include "engine/ribs/labels/label_bounds.h"

namespace spineloft::ribs {

/// The labels of least energy among `bounds.left` × `bounds.right`, exactly: dynamic programming
/// along the ribs over pairs of labels, each step one min-convolution a side. O(bounds.cells())
/// time and memory. Equal energies are resolved towards smaller labels. Replaces `labels`.
void optimalPairs(const LengthProblem& problem, const LabelBounds& bounds, LengthWorkspace& workspace,
                  LengthLabels& labels);

}  // namespace spineloft::ribs
