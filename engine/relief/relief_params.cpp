#include "engine/relief/relief_params.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace spineloft::relief {
namespace {

constexpr double kFarthest = 1e6;  // picture pixels: beyond it is no place that a hand means

bool isPlace(PicturePoint p) { return isFinite(p) && std::abs(p.x) <= kFarthest && std::abs(p.y) <= kFarthest; }

constexpr std::array<std::string_view, static_cast<std::size_t>(Mode::kCount)> kKeys = {"ink", "bright", "shade"};

}  // namespace

std::string_view modeKey(Mode mode) {
  const auto at = static_cast<std::size_t>(mode);
  return at < kKeys.size() ? kKeys[at] : std::string_view();
}

Mode modeFromKey(std::string_view key) { return static_cast<Mode>(std::ranges::find(kKeys, key) - kKeys.begin()); }

Status checkRelief(const Relief& relief) {
  // Written so that NaN fails too.
  if (!(std::abs(relief.height) <= kMostHeight)) return {Error::ValueOutOfRange, "height of a relief: -0.1 … 0.1"};
  if (!(relief.smooth >= 0 && relief.smooth <= 1)) return {Error::ValueOutOfRange, "smoothness of a relief: 0 … 1"};
  if (relief.mode >= Mode::kCount) return {Error::ValueOutOfRange, "what becomes a relief: ink, bright, shade"};
  std::size_t points = 0;
  for (const std::vector<PicturePoint>& line : relief.region) {
    points += line.size();
    if (line.size() < 3 || !std::ranges::all_of(line, isPlace)) {
      return {Error::ValueOutOfRange, "the region of a relief has closed lines of 3 or more finite points x, y"};
    }
  }
  if (relief.region.size() > kMostLines || points > kMostPoints) {
    return {Error::ValueOutOfRange, "the region of a relief has at most 50 lines of 5000 points in all"};
  }
  if (!relief.laid) return Done{};
  const Laid& laid = *relief.laid;
  if (!laid.picture || !isPlace(laid.at))
    return {Error::ValueOutOfRange, "the picture that is laid on a part, and where"};
  if (!(laid.width >= kLeastWidth && laid.width <= kMostWidth)) {
    return {Error::ValueOutOfRange, "width of the picture that is laid on a part: 4 … 20000 pixels"};
  }
  if (!(std::abs(laid.turn) <= kMostTurn)) {
    return {Error::ValueOutOfRange, "turn of the picture that is laid on a part: -π … π"};
  }
  return Done{};
}

}  // namespace spineloft::relief
