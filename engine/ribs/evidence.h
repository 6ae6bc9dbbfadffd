// What a picture says about where a gradient curve leaves the object (SpineLoft 3.3.2; method:
// "Where is the boundary?"). Every term is a function of the unwrapped picture alone.
#pragma once

#include <array>
#include <vector>

#include "engine/image/edge_map.h"
#include "engine/ribs/curves.h"
#include "engine/ribs/ribs.h"

namespace spineloft::ribs {

/// The picture along the gradient curves: row = curve, column = level. All planes have
/// curves × levels entries; those a curve does not reach are 0.
struct Strip {
  int curves = 0, levels = 0;
  std::vector<float> proximity;           ///< nearness to a Canny edge, 0…1
  std::array<std::vector<float>, 3> lab;  ///< CIE Lab
};

/// Samples `edges` (not empty) at every point of `curves`, bilinearly. Replaces `strip`, reusing
/// its memory.
void sampleStrip(const GradientCurves& curves, const image::EdgeMap& edges, Strip& strip);

/// How strongly the colour changes *across* the level sets and *along with the neighbours*: the Lab
/// difference over ± `reach` (picture pixels of arc length along the curve), averaged as a vector
/// over `neighbours` curves to either side, under a few slants of the contour of which the
/// strongest counts. An edge seen end-on, short hatching and noise average out; a contour stays.
/// Lab units.
struct ContrastParams {
  double reach = 2;
  int neighbours = 2;
  double slant = 0.15;  ///< step between the five slants tried, rise over run
};
void contourContrast(const GradientCurves& curves, const Strip& strip, const ContrastParams& params,
                     std::vector<float>& contrast);

/// Costs 0…1 of all curves and levels: proximityWeight · (1 − proximity) — the paper's distance
/// penalty — plus contrastWeight · (1 − contrast / scale), where scale is a share of the median of
/// the curves' own strongest contrasts, so that faint pictures and strong ones cost alike.
void edgeCosts(const GradientCurves& curves, const Strip& strip, const EvidenceParams& params,
               double mapScale, std::vector<float>& costs);

}  // namespace spineloft::ribs
