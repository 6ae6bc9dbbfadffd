// The network that says where a rib ends: a small U-net over the unwrapped image of both sides (method: "Where is the
// boundary?"). Its weights are trained on made scenes (tests/training) and compiled in from assets/ribs-net.bin.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/result.h"
#include "engine/ribs/learned/channels.h"
#include "engine/ribs/learned/layers.h"

namespace spineloft::ribs {

/// Memory of one run.
struct NetworkScratch {
  Planes fine, refined, coarse, deeper, joined;
  FloatPlanes sums, raised;
  std::vector<std::int32_t> columnSums;
};

class RibNetwork {
 public:
  /// Reads the weights file: "SLRN", version, then every layer's sizes, and of every layer a scale and a bias of each
  /// output and the weights as bytes; at the end the CRC-32 of all before. Little-endian. Errors: FileUnreadable, with
  /// a detail that says what is wrong.
  static Result<RibNetwork> read(std::span<const std::uint8_t> file);

  /// Scores of every row and level of both sides, rows × levels each: a softmax along a row gives the probability that
  /// its rib ends at a label. Swapping the sides of the input swaps the scores, exactly.
  void run(const StripChannels& channels, NetworkScratch& scratch, std::array<std::vector<float>, 2>& scores) const;

  enum Layer { Enter, Near, Down, Join, Deep, Deeper, Deepest, Rejoin, Last, Up, Refine, Out, kLayers };

 private:
  std::array<Convolution, kLayers> layers_;
};

/// The network of this build; null if its file is damaged (a test fails then), in which case parts are found without
/// it.
const RibNetwork* builtInNetwork();

/// assets/ribs-net.bin, as it is in this build.
std::span<const std::uint8_t> builtInWeights();

}  // namespace spineloft::ribs
