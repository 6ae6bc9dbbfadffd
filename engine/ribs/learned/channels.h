// What the network sees of a picture: planes over the unwrapped image, of both sides of a stroke (method: "Where is the
// boundary?").
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/field/curves.h"
#include "engine/ribs/learned/layers.h"

namespace spineloft::ribs {

/// Planes of the network's input, in this order. All lie within ±1 and are 0 where a curve does not reach or the
/// picture is ignored.
enum class Channel : std::uint8_t {
  Lightness,    ///< CIE L less the median close to the stretch of the spine, d / (|d| + 25)
  Red,          ///< the same of a
  Blue,         ///< the same of b
  Across,       ///< Lab difference over ± 1 label, relative to the strong ones of the strip
  AcrossWide,   ///< over ± 3 labels
  AcrossUnits,  ///< logarithm of the difference over ± 1 label, Lab units
  Along,        ///< Lab difference between the rows on either side, relative like Across
  Near,         ///< nearness to a Canny edge
  LogOdds,      ///< log-odds of the colour against those close to the spine (spineLogOdds)
  Inside,       ///< mean of that between the spine and here
  Outside,      ///< mean of it from here to three tenths farther
  Step,         ///< difference of the mean colours between the spine and here, and from here to three tenths farther
  Distance,     ///< logarithm of the arc length over the spine's length
  Slope,        ///< logarithm of the distance to the next label over that to the next row
  Reached,      ///< 1 where there is a picture
  Fan,          ///< 1 on rows around the ends of the stroke
};
inline constexpr int kChannels = 16;

/// A row of the network's input: between two curves of one side.
struct StripRow {
  int first = 0, second = 0;  ///< curves
  float share = 0;            ///< of the second one, 0…1
  bool fan = false;
};

/// The input of one stroke. Each side is a picture of its own, rows × levels: from the middle of one end's fan along
/// the ribs to the middle of the other's. Its direction depends on the picture alone, not on that of the stroke, so
/// that the reversed stroke gives the same numbers.
struct StripChannels {
  int rows = 0, levels = 0;                      ///< rows even; levels a multiple of 4, beyond those of the curves 0
  bool reversed = false;                         ///< rows run against the stroke
  std::array<std::vector<StripRow>, 2> sources;  ///< of either side's rows: left, right
  Planes planes;                                 ///< rows × levels × kChannels
};

/// Memory of fillChannels: planes of every row and label of a side.
struct ChannelScratch {
  struct Side {
    std::vector<std::array<float, 4>> colours;  ///< Lab and log-odds
    std::vector<float> lightness, red, blue, near;
    std::vector<float> along, x, y;
    std::vector<float> across, acrossWide, beside;  ///< Lab differences along and across the rows
    std::vector<int> reached;                       ///< labels of every row that exist
  };
  struct Row {
    std::vector<float> channels;             ///< one after the other
    std::vector<std::array<float, 4>> sums;  ///< of colour and log-odds along it
  };
  std::array<Side, 2> sides;
  std::array<Row, 2> rows;  ///< by LoopShare::who
  std::vector<float> samples;
  std::vector<std::array<float, 3>> own;  ///< median Lab close to the spine, of every row
};

/// Rows along the ribs of a stroke with that many ribs, whose curves have that many levels.
int stripRows(int ribs, int levels);

/// Fills `channels` from a strip sampled along `curves`. `colours` are sorted (sortColours); their tables are used on
/// the way. O(curves · levels).
void fillChannels(const GradientCurves& curves, const UnwrappedImage& strip, ColourTables& colours,
                  std::vector<float>& logOdds, ChannelScratch& scratch, StripChannels& channels);

}  // namespace spineloft::ribs
