// The picture along the gradient curves, and the log-odds of its colours against the object (method: "Where is the
// boundary?").
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/image/edge_map.h"
#include "engine/ribs/base/picture_evidence.h"
#include "engine/ribs/base/rib_params.h"
#include "engine/ribs/evidence/ignored.h"
#include "engine/ribs/field/curves.h"

namespace spineloft::ribs {

/// What sampling a strip needs on the way.
struct UnwrapScratch {
  std::vector<float> mapX, mapY;  ///< the curves' points in map coordinates
  std::vector<float> steps;       ///< samples between a curve and the next one, on either's half
};

/// The picture along the gradient curves: row = curve, column = level. All planes have
/// curves × levels entries; those a curve does not reach are 0.
struct UnwrappedImage {
  int curves = 0, levels = 0;
  double pixel = 1;              ///< picture pixels per map pixel
  std::vector<float> proximity;  ///< nearness to a Canny edge, 0…1
  /// CIE Lab and an unused fourth value, interleaved.
  std::vector<std::array<float, 4>> lab;
  /// 1 where the person marked the picture as ignored, else 0; empty: nowhere. Ignored entries are near no edge, have
  /// no contrast, are left out of the colours, and do not enter any normalisation.
  std::vector<std::uint8_t> ignored;
  UnwrapScratch scratch;
  bool isIgnored(std::size_t at) const { return !ignored.empty() && ignored[at] != 0; }
};

/// Samples `edges` (not empty) at every point of `curves`, bilinearly, and takes the mean along the
/// level set half-way to either neighbouring curve: a rib stands for all of the picture up to the next
/// ones, and noise averages out. What is ignored does not count; `ignored` may be null or empty.
/// Replaces `strip`, reusing its memory.
void unwrapImage(const GradientCurves& curves, const image::EdgeMap& edges, const IgnoredEdges* ignored,
                 UnwrappedImage& strip);

/// Cells of every Lab channel; the cell of a colour is (lightness · bins + a) · bins + b.
inline constexpr int kColourBins = 12;
/// Colours in a few cells, and how they spread over them.
struct ColourTables {
  std::vector<std::uint16_t> cells;                       ///< of every entry of a strip
  std::vector<float> all;                                 ///< shares of the cells in the whole strip, smoothed
  std::vector<float> spine, stretches, blurred, logOdds;  ///< memory of spineLogOdds
  std::vector<float> around, aroundStretches;             ///< the same
  std::vector<float> values;                              ///< memory of sortColours
};

/// Sorts the colours of a strip into cells; what spineLogOdds is asked about.
void sortColours(const GradientCurves& curves, const UnwrappedImage& strip, ColourTables& colours);

/// What is known of the object before its colours are looked at: arc lengths of every curve, picture
/// pixels.
struct KnownReach {
  /// Up to here the object reaches surely; empty: a few pixels from the spine.
  std::vector<float> inside;
  /// From here on is surely what is around it; empty: that is not known. Infinite where it is not known
  /// of one curve.
  std::vector<float> outside;
};

/// The log-odds of every colour of the unwrapped image: log(share around the object / share in it), within ± 2, from
/// smoothed Lab histograms. The object's histogram mixes that of the whole known object with that of the stretch (an
/// eighth of the spine) that the curve belongs to: 30 %, or 50 % where it is known where the object ends. In the
/// latter case the surroundings are sampled up to three and a half times as far, mostly of the stretch. Otherwise the
/// share of the whole unwrapped image is used, and the log-odds are multiplied by the distance of the two
/// distributions, so that ink on paper, where both are paper, gives 0.
void spineLogOdds(const GradientCurves& curves, const UnwrappedImage& strip, const KnownReach& known,
                  ColourTables& colours, std::vector<float>& logOdds);

}  // namespace spineloft::ribs
