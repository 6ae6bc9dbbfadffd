#include "engine/surface/background_mask.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "engine/surface/palette.h"

namespace spineloft::surface {
namespace {

int apartness(const std::uint8_t* a, const std::uint8_t* b) {
  int apart = 0;
  for (int c = 0; c < 3; ++c) apart = std::max(apart, std::abs(a[c] - b[c]));
  return apart;
}

/// A front of pixels that moves into a part, and the colour with which it set out at each.
class Front {
 public:
  Front(const Doubt& doubt, const Palette& inside, const Palette& around)
      : doubt_(doubt), inside_(inside), around_(around), came_(doubt.covered.pixels.size()) {}

  /// From the pixels of `beyond` until it meets what is not background. 0 where it was, else 255.
  image::Mask advance(const image::Mask& beyond) {
    image::Mask free = beyond;
    for (std::uint8_t& p : free.pixels) p = static_cast<std::uint8_t>(255 - p);
    std::size_t at = 0;
    for (int y = 0; y < beyond.height; ++y) {
      for (int x = 0; x < beyond.width; ++x, ++at) {
        if (beyond.pixels[at] == 0 || isWithin(beyond, at, {x, y})) continue;
        const std::uint8_t* p = pixel(at);
        came_[at] = {p[0], p[1], p[2]};
        forNeighbours(at, {x, y}, free, [&](std::size_t next) { step(at, next, free); });
      }
    }
    const auto width = static_cast<std::size_t>(free.width);
    for (std::size_t k = 0; k < reached_.size(); ++k) {
      const std::size_t from = reached_[k];
      const Place place{static_cast<int>(from % width), static_cast<int>(from / width)};
      forNeighbours(from, place, free, [&](std::size_t next) { step(from, next, free); });
    }
    return free;
  }

 private:
  const std::uint8_t* pixel(std::size_t at) const { return &doubt_.shown.pixels[4 * at]; }

  struct Place {
    int x, y;
  };
  // Whether its neighbours are of the mask, too: the front does not set out there.
  static bool isWithin(const image::Mask& mask, std::size_t at, Place place) {
    if (place.x == 0 || place.y == 0 || place.x + 1 >= mask.width || place.y + 1 >= mask.height) return false;
    const auto width = static_cast<std::size_t>(mask.width);
    const std::uint8_t* p = mask.pixels.data();
    return (p[at - 1] & p[at + 1] & p[at - width] & p[at + width]) != 0;
  }
  template <class Visit>
  static void forNeighbours(std::size_t at, Place place, const image::Mask& mask, const Visit& visit) {
    const auto width = static_cast<std::size_t>(mask.width);
    if (place.x > 0) visit(at - 1);
    if (place.x + 1 < mask.width) visit(at + 1);
    if (place.y > 0) visit(at - width);
    if (place.y + 1 < mask.height) visit(at + width);
  }

  void step(std::size_t from, std::size_t at, image::Mask& free) {
    if (free.pixels[at] == 0 || !isBackground(at, came_[from].data())) return;
    came_[at] = came_[from];
    free.pixels[at] = 0;
    reached_.push_back(at);
  }

  bool isBackground(std::size_t at, const std::uint8_t* came) const {
    constexpr int kAlike = 30, kUnlike = 40;  // of 255
    // So many times more common around, and by at least so large a share: what is seen nowhere
    // tells nothing.
    constexpr double kTimes = 2, kLeast = 3e-4;
    if (doubt_.sure.pixels[at] != 0) return false;
    const std::uint8_t* p = pixel(at);
    if (apartness(p, came) > kAlike) return false;
    if (doubt_.covered.pixels[at] == 0) return true;
    return around_.share(p) > kTimes * inside_.share(p) + kLeast && apartness(p, doubt_.in.at(at).data()) > kUnlike;
  }

  const Doubt& doubt_;
  const Palette &inside_, &around_;
  std::vector<Colour> came_;
  std::vector<std::size_t> reached_;
};

}  // namespace

double clearanceOf(double depth) {
  // Mean depth of a band is half of half its width.
  constexpr double kShare = 0.6;
  return std::clamp(2 * kShare * depth, 6.0, 64.0);
}

image::Mask ownPixels(const Doubt& doubt, double clearance) {
  image::Mask beyond = doubt.covered;
  for (std::uint8_t& p : beyond.pixels) p = static_cast<std::uint8_t>(255 - p);
  beyond = inset(beyond, clearance);
  Palette inside, around;
  for (std::size_t i = 0; i < beyond.pixels.size(); ++i) {
    if (doubt.own.pixels[i] != 0) inside.add(&doubt.shown.pixels[4 * i]);
    if (beyond.pixels[i] != 0) around.add(&doubt.shown.pixels[4 * i]);
  }
  inside.close();
  around.close();
  return Front(doubt, inside, around).advance(beyond);
}

image::Mask withCleanRim(const image::Image& shown, const image::Mask& kept, const image::Mask& rim,
                         const ColourPyramid& in, const ColourPyramid& out) {
  // Of the way from in to out, and the length of that way, of 255 a channel, below which it does
  // not show.
  constexpr double kMixed = 0.07, kAlike = 40;
  image::Mask clean = kept;
  for (std::size_t i = 0; i < clean.pixels.size(); ++i) {
    if (rim.pixels[i] == 0 || clean.pixels[i] != 0) continue;
    double way = 0, gone = 0;
    const Colour own = in.at(i), behind = out.at(i);
    for (std::size_t c = 0; c < 3; ++c) {
      const double step = behind[c] - own[c];
      way += step * step;
      gone += step * (shown.pixels[4 * i + c] - own[c]);
    }
    if (way <= kAlike * kAlike || gone <= kMixed * way) clean.pixels[i] = 255;
  }
  return clean;
}

}  // namespace spineloft::surface
