// Which colours a piece of a picture has, and how often.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace spineloft::surface {

/// A histogram over red, green and blue, 32 steps each, smoothed so that a colour also counts for its neighbours. Call
/// `add` for all pixels, then `close`, then read.
class Palette {
 public:
  Palette();
  /// Counts one RGBA pixel, whatever its alpha.
  void add(const std::uint8_t* pixel);
  /// Smooths the counts, by one step in each direction, and makes shares of them.
  void close();
  /// Share of the pixels (0…1) that are about as this one; 0 everywhere when none were added.
  double share(const std::uint8_t* pixel) const;

 private:
  std::vector<float> cells_;
  double count_ = 0;
};

}  // namespace spineloft::surface
