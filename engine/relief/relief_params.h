// What a relief is.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/ids.h"
#include "engine/base/result.h"
#include "engine/base/vec.h"

namespace spineloft::relief {

/// What of a picture becomes heights.
enum class Mode : std::uint8_t {
  Ink,     ///< dark strokes are grooves
  Bright,  ///< what is brighter than its surroundings stands out
  Shade,   ///< what light and shadow show
  kCount
};

/// "ink", "bright", "shade": in files and in the API.
std::string_view modeKey(Mode mode);
/// Error: none of them: kCount.
Mode modeFromKey(std::string_view key);

/// A picture that is laid on a part which another one shows.
struct Laid {
  PictureId picture;
  PicturePoint at;    ///< where its middle lies, pixels of the part's picture
  double width = 40;  ///< pixels of the part's picture that its width covers, kLeastWidth … kMostWidth
  double turn = 0;    ///< radians, clockwise, −kMostTurn … kMostTurn
  bool operator==(const Laid&) const = default;
};

/// Detail that a picture gives to the front of a part.
struct Relief {
  Mode mode = Mode::Ink;
  double height = 0.02;  ///< of the longer side of what is seen of the part, ±kMostHeight; < 0: turned about
  double smooth = 0.2;   ///< 0 … 1: how much of the finest detail goes
  std::vector<std::vector<PicturePoint>> region;  ///< closed lines, pixels of the part's picture: where, by even-odd;
                                                  ///< none: all that is seen
  std::optional<Laid> laid;                       ///< none: what the part's own picture shows
  bool operator==(const Relief&) const = default;
};

/// Calls `f` with every place that a relief has in the part's picture.
template <class F>
void eachPlace(Relief& relief, const F& f) {
  for (std::vector<PicturePoint>& line : relief.region) {
    for (PicturePoint& p : line) f(p);
  }
  if (relief.laid) f(relief.laid->at);
}

inline constexpr double kMostHeight = 0.1, kMostTurn = 3.1416, kLeastWidth = 4, kMostWidth = 20000;
inline constexpr std::size_t kMostLines = 50, kMostPoints = 5000;  ///< of a region, in all

/// Error: ValueOutOfRange, with what.
Status checkRelief(const Relief& relief);

}  // namespace spineloft::relief
