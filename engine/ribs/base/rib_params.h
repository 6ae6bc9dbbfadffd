// The parameters of the search for ribs.
#pragma once

namespace spineloft::ribs {

/// How fair the line is to be.
struct FairingParams {
  double stiffness = 5;       ///< weight of second differences, 0 (off) … 1000; a steady taper is free
  double leastTrust = 0.005;  ///< what an end without any edge still weighs, 0.0001…1
  /// Second differences above this share of the mean length are corners, which are kept (0.001…10).
  double corner = 0.2;
  /// An end that lies farther than this share of the mean length off the line hardly counts any more
  /// (0.001…10).
  double outlier = 0.32;
  bool operator==(const FairingParams&) const = default;
};

/// Which evidence counts how much (method: "Where is the boundary?").
struct EvidenceParams {
  double learnedWeight = 1;    ///< of the network's scores (learned/network.h), 0…10
  double proximityWeight = 1;  ///< of nearness to a Canny edge (the paper's only evidence), 0…10
  double doubt = 0.05;         ///< chance given to a curve being misled, 0.001…10
  double weight = 0.6;         ///< of all evidence against the shape terms, 0…10
  bool operator==(const EvidenceParams&) const = default;
};

/// Everything the search can be told; a RibSet depends on nothing else. Weights are as for 100 ribs:
/// with more of them each counts for less, so that the part does not depend on their number. The defaults are the ones
/// the benchmark measures.
struct RibParams {
  int levels = 120;               ///< K: labels of the dynamic programme, 16…512
  double maxLevelShare = 0.5;     ///< largest d2 level as a share of the picture's diagonal, 0.01…1
  double neighbourWeight = 0.7;   ///< SpineLoft 3.3.2: 3 (on d2; ours compares arc lengths), 0…100
  double neighbourFreedom = 0.1;  ///< free slope between neighbours, SpineLoft 3.3.2: ¼ (on d2), 0…10
  double neighbourCap = 8.0;      ///< most that one jump between neighbours costs, 0.01…1000
  /// Against unequal opposite ribs, once the medial offset of the stroke is known (medial_offset.h). SpineLoft 3.3.2:
  /// 0.25, without an offset. 0…100
  double oppositeWeight = 1.0;
  double medialOffsetCost = 0.1;  ///< of a stroke being off the middle, per rib, 0…10
  EvidenceParams evidence = {};
  FairingParams fairing = {};
  bool operator==(const RibParams&) const = default;
};

/// Every value finite and in its range.
bool inRange(const RibParams& params);

}  // namespace spineloft::ribs
