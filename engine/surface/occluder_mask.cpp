#include "engine/surface/occluder_mask.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/surface/edge_padding.h"
#include "engine/surface/palette.h"

namespace spineloft::surface {
namespace {

/// A share of the part's pixels below which a colour is not its own.
constexpr double kNowhere = 2e-5;

/// The colours beside the stretch, of the part and around it elsewhere.
class Colours {
 public:
  explicit Colours(const OccludedStretch& e) {
    for (std::size_t i = 0; i < e.covered.pixels.size(); ++i) {
      const std::uint8_t* pixel = &e.shown.pixels[4 * i];
      if (e.covered.pixels[i] == 0) {
        (e.outside.pixels[i] != 0 ? beside_ : around_).add(pixel);
      } else if (e.own.pixels[i] != 0 && e.reach.pixels[i] == 0) {
        own_.add(pixel);
      }
    }
    beside_.close();
    own_.close();
    around_.close();
  }
  /// Whether a pixel's colour is common beside the stretch, and not so on the part nor elsewhere around it.
  bool comesIn(const std::uint8_t* pixel) const {
    // So many times more common, and by at least that share.
    constexpr double kTimesOwn = 4, kTimesAround = 2, kLeast = 3e-4;
    const double beside = beside_.share(pixel);
    return beside > kTimesOwn * own_.share(pixel) + kLeast && beside > kTimesAround * around_.share(pixel);
  }
  /// Whether the part has the colour anywhere.
  bool isOwn(const std::uint8_t* pixel) const { return own_.share(pixel) >= kNowhere; }
  /// Those of the part, each speaking for all that are somewhat like it.
  Palette aboutOwn() const {
    constexpr int kWider = 3;
    Palette about = own_;
    for (int k = 0; k < kWider; ++k) about.close();
    return about;
  }

 private:
  Palette beside_, own_, around_;
};

/// Whether most of the threshold is of what comes in.
bool isCrossed(const OccludedStretch& e, const Colours& colours) {
  std::size_t threshold = 0, crossed = 0;
  for (std::size_t i = 0; i < e.covered.pixels.size(); ++i) {
    if ((e.threshold.pixels[i] & e.covered.pixels[i]) == 0) continue;
    ++threshold;
    crossed += colours.comesIn(&e.shown.pixels[4 * i]) ? 1 : 0;
  }
  return 2 * crossed > threshold;
}

/// 255 where a pixel may be the occluder's.
image::Mask likely(const OccludedStretch& e, const Colours& colours) {
  const Palette about = colours.aboutOwn();
  image::Mask out = e.reach;
  for (std::size_t i = 0; i < out.pixels.size(); ++i) {
    const std::uint8_t* pixel = &e.shown.pixels[4 * i];
    const bool within = e.covered.pixels[i] != 0;
    const bool is = within ? e.reach.pixels[i] != 0 && (about.share(pixel) < kNowhere || colours.comesIn(pixel))
                           : e.outside.pixels[i] != 0 && colours.comesIn(pixel);
    out.pixels[i] = is ? 255 : 0;
  }
  return out;
}

/// Those of the pixels that are joined to one outside what is covered.
image::Mask joined(const image::Mask& free, const image::Mask& covered) {
  image::Mask found = free;
  std::ranges::fill(found.pixels, std::uint8_t{0});
  std::vector<std::size_t> reached;
  const auto width = static_cast<std::size_t>(free.width);
  const auto take = [&](std::size_t at) {
    if (free.pixels[at] == 0 || found.pixels[at] != 0) return;
    found.pixels[at] = 255;
    reached.push_back(at);
  };
  for (std::size_t i = 0; i < free.pixels.size(); ++i) {
    if (covered.pixels[i] == 0) take(i);
  }
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const std::size_t at = reached[k], x = at % width;
    if (x > 0) take(at - 1);
    if (x + 1 < width) take(at + 1);
    if (at >= width) take(at - width);
    if (at + width < free.pixels.size()) take(at + width);
  }
  return found;
}

/// With gaps and holes up to twice `radius` (px) wide closed.
image::Mask closed(const image::Mask& mask, double radius) {
  return inset(opposite(inset(opposite(mask), radius)), radius);
}

}  // namespace

image::Mask occluderMask(const OccludedStretch& e) {
  // Of the occluder that is in no colour of the part, and of the part.
  constexpr double kUnlike = 0.8, kMost = 0.35;
  constexpr double kGap = 6;
  const Colours colours(e);
  if (!isCrossed(e, colours)) return {};
  image::Mask found = closed(joined(likely(e, colours), e.covered), kGap);
  std::size_t hidden = 0, unlike = 0, covered = 0;
  for (std::size_t i = 0; i < found.pixels.size(); ++i) {
    if (e.covered.pixels[i] == 0) continue;
    ++covered;
    if (found.pixels[i] == 0) continue;
    ++hidden;
    unlike += colours.isOwn(&e.shown.pixels[4 * i]) ? 0 : 1;
  }
  const auto isMore = [](std::size_t count, double share, std::size_t of) {
    return static_cast<double>(count) > share * static_cast<double>(of);
  };
  return isMore(unlike, kUnlike, hidden) && !isMore(hidden, kMost, covered) ? found : image::Mask{};
}

}  // namespace spineloft::surface
