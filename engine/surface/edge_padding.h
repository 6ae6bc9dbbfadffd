// Edge padding: the colours from well inside an outline, extended over the rim and beyond, without those of the
// background.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/image/image.h"

namespace spineloft::surface {

/// How far the colours of an outline's pixels are mixed with those behind: pixels nearer than this
/// to the outline are not trusted. In pixels of a picture whose longer side is `longSide`: 2 for
/// small pictures, more where the same blur covers more pixels.
double rimMargin(int longSide);

/// The part of `mask` (255 inside) that is more than `margin` pixels (0…64) from every pixel
/// outside. Same size. The border of the mask does not count as outside: the frame of a picture cuts objects off.
image::Mask inset(const image::Mask& mask, double margin);

/// 255 where `mask` is 0, and the other way round.
image::Mask opposite(image::Mask mask);

/// The part of `covered` (255 inside) whose pixels are trusted: at least `margin` pixels (≥ 0, at
/// most 64) from the nearest pixel outside. Where the object is too thin for that, half as far as it is wide, so that
/// every piece keeps some of its colours. As inset otherwise.
image::Mask trusted(const image::Mask& covered, double margin);

/// Mean distance of the pixels inside from the nearest one outside, pixels, each counted as at most
/// 128; 0 when nothing is inside. Half of half its width where `mask` is a band.
double meanDepth(const image::Mask& mask);

using Colour = std::array<std::uint8_t, 3>;

/// Colours of an image carried on from the pixels that are in `known` (255; same size) and not
/// mostly transparent to all others, from the nearest known ones: averages over ever larger
/// neighbourhoods (push and pull: Gortler and others, The Lumigraph, 1996, section 3.4). Linear.
/// Both must outlive it.
class ColourPyramid {
 public:
  ColourPyramid(const image::Image& image, const image::Mask& known);
  /// The sizes differ or nothing is known. Then nothing else may be asked.
  bool empty() const { return levels_.empty(); }
  /// Of pixel i of the rows; known ones have their own.
  Colour at(std::size_t i) const;

 private:
  struct Sample {
    std::array<std::uint16_t, 3> colour{};
    std::uint16_t known = 0;
  };
  struct Level {
    int width = 0, height = 0;
    std::vector<Sample> samples;
  };
  /// Half the size: the mean of those of each four that are known.
  template <class At>
  static Level average(int width, int height, const At& at);
  /// The samples of a level between which row y of the level below lies.
  struct Rows {
    const Sample *near, *far;
    int last;  ///< column
    Rows(const Level& coarse, int y);
    /// Of pixel x of the row.
    Sample between(int x) const;
  };
  static Colour colourOf(const Sample& sample);
  friend image::Image padEdges(const image::Image& image, const image::Mask& known);
  bool isKnown(std::size_t i) const;

  const image::Image& image_;
  const image::Mask& known_;
  std::vector<Level> levels_;  ///< the first has half the size of the image
};

/// The image with the colours carried on, opaque. Empty when Carried is.
image::Image padEdges(const image::Image& image, const image::Mask& known);

}  // namespace spineloft::surface
