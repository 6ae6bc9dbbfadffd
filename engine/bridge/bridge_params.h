// How a bridge is made between its two rims.
#pragma once

#include <cstddef>

namespace spineloft::bridge {

struct BridgeParams {
  double waist = 0.6;  ///< how thick it is in its middle, as a share of its rims, kLeastWaist … kMostWaist
  double bow = 1;      ///< how far out of the parts it goes, kLeastBow … kMostBow; 1: as the arc of a circle
  bool operator==(const BridgeParams&) const = default;
};

inline constexpr double kLeastWaist = 0.1, kMostWaist = 1, kLeastBow = 0.2, kMostBow = 4;
inline constexpr std::size_t kLeastRimPoints = 3, kMostRimPoints = 200;

inline bool isValid(const BridgeParams& params) {
  return params.waist >= kLeastWaist && params.waist <= kMostWaist && params.bow >= kLeastBow && params.bow <= kMostBow;
}

}  // namespace spineloft::bridge
