// spineloft bench with what only research asks: other variations of the method, other strokes, other pictures.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/cli/program.h"

namespace spineloft::accuracy {

struct AccuracyArguments : cli::BenchArguments {
  std::string variation = "product";  ///< which of variations.h the rows and overlays are of
  std::vector<std::string> set;       ///< KEY=VALUE: other values of parameters (variations.h)
  std::string ablation;               ///< Markdown of all variations; empty where not wanted
  std::string leaveOneOut;            ///< Markdown of leave_one_out.h; empty where not wanted
  std::string states;                 ///< Markdown of end_states.h; empty where not wanted
  int live = 0;          ///< moves in which every stroke is drawn once more (live_score.h), 10…1000; 0: none
  int redraw = 0;        ///< seed of strokes drawn anew (redrawn_strokes.h), 1…1,000,000; 0: the case's own
  double overshoot = 0;  ///< how far strokes go past the thing's ends (overshot_stroke.h), 0…3
  double erase = 0;      ///< share of every outline to blur away first (erased_outline.h), 0…1
};

/// As cli::runBench; an ablation and the leave-one-out become further tables of the report.
Status runAccuracy(const AccuracyArguments& arguments, std::ostream& out);

}  // namespace spineloft::accuracy
