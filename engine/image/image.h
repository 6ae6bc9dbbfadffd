// Pictures as plain values. No codec and no OpenCV here.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::image {

/// RGBA, 8 bits a channel, sRGB, alpha not premultiplied; rows top to bottom without padding:
/// `pixels.size() == 4 * width * height`.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  bool operator==(const Image&) const = default;
  bool empty() const { return width <= 0 || height <= 0; }
};

/// Pixels that someone else owns, laid out as in Image.
struct ImageView {
  int width = 0, height = 0;
  std::span<const std::uint8_t> pixels;
  ImageView(int viewWidth, int viewHeight, std::span<const std::uint8_t> viewPixels)
      : width(viewWidth), height(viewHeight), pixels(viewPixels) {}
  ImageView(const Image& image) : width(image.width), height(image.height), pixels(image.pixels) {}
};

/// One byte a pixel, rows top to bottom: 255 inside, 0 outside.
struct Mask {
  int width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  bool operator==(const Mask&) const = default;
};

/// A picture as the document keeps it. `working` holds at most kWorkingPixels; `width` and `height`
/// are the original's. Pixel (x, y) of the original is at ((x + ½) / scale − ½) in the working
/// copy, where scale = original / working, in each direction.
struct Picture {
  Image working;
  int width = 0, height = 0;  ///< original pixels, after EXIF orientation
  bool operator==(const Picture&) const = default;
};

/// Area-averaged copy with the given size (both ≥ 1, at most the source's; equal size returns the
/// same pixels). Colours are weighted by alpha, so that transparent pixels do not bleed; where all
/// is transparent the colour is black. Averages are of the stored sRGB values. An empty source or a
/// size out of range gives an empty image.
Image shrink(ImageView source, int width, int height);

/// Sizes ≤ `maxPixels` and with long side ≤ `maxSide` that keep the shape of width × height as well
/// as whole pixels allow; never larger than the original, at least 1 × 1. An original without
/// pixels gives {0, 0}. Turning the original by 90° turns the result.
struct Size {
  int width = 0, height = 0;
  bool operator==(const Size&) const = default;
};
Size fitSize(Size original, long long maxPixels, int maxSide);

/// The image as it should be seen, given the EXIF orientation (1…8; anything else counts as 1) that
/// came with its stored pixels: 2–4 mirror or turn by 180°, 5–8 also swap width and height.
Image orient(Image stored, int exifOrientation);

/// Picture of the document from decoded pixels: shrinks to kWorkingPixels where needed, then turns
/// it by its EXIF orientation. An image without pixels gives an empty picture.
Picture makePicture(Image decoded);
Picture makePicture(ImageView decoded, int exifOrientation);

}  // namespace spineloft::image
