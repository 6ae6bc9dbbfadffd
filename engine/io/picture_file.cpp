#include "engine/io/picture_file.h"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <memory>
#include <mutex>
#include <new>
#include <string_view>
#include <utility>

#include "engine/base/limits.h"
#include "engine/io/picture_header.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_GIF
#define STBI_NO_STDIO
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 32768
// What is kept per thread would be misplaced in WebAssembly without threads (CMakeLists.txt, add_program): one reason
// of failure for the program, and `decoding` held from the failure until it is read.
#define STBI_NO_THREAD_LOCALS
#include <stb/stb_image.h>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace spineloft::io {
namespace {

static_assert(STBI_MAX_DIMENSIONS == kMaxPictureSide, "the decoder must accept what we accept");

struct FreePixels {
  void operator()(std::uint8_t* pixels) const { std::free(pixels); }
};
/// Pixels of the decoder, as it stored them.
struct Decoded {
  std::unique_ptr<std::uint8_t, FreePixels> pixels;
  int width = 0, height = 0;
};

Failure decoderFailure() {
  const char* reason = stbi_failure_reason();
  const std::string_view why = reason ? reason : "";
  if (why == "outofmem") return {Error::OutOfMemory, {}};
  // Variants of the formats that the decoder does not know, as it names them.
  for (const std::string_view unknown :
       {"only 8-bit", "no header height", "BMP RLE", "BMP JPEG/PNG", "monochrome", "unknown BMP"}) {
    if (why == unknown) return {Error::PictureUnreadable, std::string(why)};
  }
  return {Error::PictureTruncated, {}};
}

/// Decodes with `channels` 1 (grey) or 4 (RGBA); the declared size is known to be acceptable.
/// probePicture, of formats that are decoded here.
Result<PictureInfo> probeDecoded(ByteView file) {
  Result<PictureInfo> info = probePicture(file);
  if (info.ok() && !isDecoded(info.value().format)) return Error::PictureUnreadable;
  return info;
}

Result<Decoded> decodePixels(ByteView file, const PictureInfo& info, int channels) {
  if (file.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return Error::PictureTooLarge;
  }
  if (!pictureDataComplete(file, info)) return Error::PictureTruncated;
  Decoded decoded;
  int stored = 0;
  static std::mutex decoding;
  const std::lock_guard<std::mutex> alone(decoding);
  decoded.pixels.reset(stbi_load_from_memory(file.data(), static_cast<int>(file.size()), &decoded.width,
                                             &decoded.height, &stored, channels));
  if (!decoded.pixels) return decoderFailure();
  if (image::Size{decoded.width, decoded.height} != info.size) return Error::PictureTruncated;
  return decoded;
}

void append(void* context, void* data, int size) {
  const std::uint8_t* bytes = static_cast<const std::uint8_t*>(data);
  Bytes& out = *static_cast<Bytes*>(context);
  out.insert(out.end(), bytes, bytes + size);
}

/// Pixels as an encoder takes them: rows top to bottom, `channels` bytes each.
struct Raster {
  int width = 0, height = 0, channels = 0;
  const std::uint8_t* pixels = nullptr;
};

Result<Bytes> writePng(const Raster& raster) {
  try {
    Bytes out;
    const int row = raster.width * raster.channels;
    if (stbi_write_png_to_func(append, &out, raster.width, raster.height, raster.channels, raster.pixels, row) == 0) {
      return Error::OutOfMemory;
    }
    return out;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

template <class Pixels>
bool hasPixels(const Pixels& image, std::size_t channels) {
  return image.width > 0 && image.height > 0 &&
         image.pixels.size() ==
             channels * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// The colours without alpha, mixed with white paper.
Bytes colours(const image::Image& image) {
  Bytes out;
  out.reserve(image.pixels.size() / 4 * 3);
  for (std::size_t i = 0; i < image.pixels.size(); i += 4) {
    const int alpha = image.pixels[i + 3];
    for (std::size_t c = 0; c < 3; ++c) {
      const int mixed = image.pixels[i + c] * alpha + 255 * (255 - alpha);
      out.push_back(static_cast<std::uint8_t>((mixed + 127) / 255));
    }
  }
  return out;
}

bool isOpaque(const image::Image& image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
    if (image.pixels[i] != 255) return false;
  }
  return true;
}

}  // namespace

Status checkPictureSize(image::Size size) {
  if (size.width <= 0 || size.height <= 0) return Error::PictureEmpty;
  if (std::max(size.width, size.height) > kMaxPictureSide ||
      static_cast<long long>(size.width) * size.height > kMaxPicturePixels) {
    return Error::PictureTooLarge;
  }
  if (std::min(size.width, size.height) < kMinPictureSide) return Error::PictureTooSmall;
  return Done{};
}

Result<image::Picture> decodePicture(ByteView file, const Progress& progress) {
  if (!progress.advance(0)) return Error::Cancelled;
  const Result<PictureInfo> info = probeDecoded(file);
  if (!info.ok()) return info.failure();
  if (const Status accepted = checkPictureSize(info.value().size); !accepted.ok()) {
    return accepted.failure();
  }
  try {
    const Result<Decoded> decoded = decodePixels(file, info.value(), 4);
    if (!decoded.ok()) return decoded.failure();
    if (!progress.advance(0.7)) return Error::Cancelled;
    const auto [width, height] = info.value().size;
    const std::size_t count = 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    image::Picture picture = image::makePicture(image::ImageView(width, height, {decoded.value().pixels.get(), count}),
                                                info.value().orientation);
    if (!progress.advance(1)) return Error::Cancelled;
    return picture;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<image::Image> decodeImage(ByteView file, long long mostPixels) {
  const Result<PictureInfo> info = probeDecoded(file);
  if (!info.ok()) return info.failure();
  const auto [width, height] = info.value().size;
  if (width <= 0 || height <= 0) return Error::PictureEmpty;
  if (std::max(width, height) > kMaxPictureSide || static_cast<long long>(width) * height > mostPixels) {
    return Error::PictureTooLarge;
  }
  try {
    const Result<Decoded> decoded = decodePixels(file, info.value(), 4);
    if (!decoded.ok()) return decoded.failure();
    const std::uint8_t* pixels = decoded.value().pixels.get();
    return image::Image{width, height, Bytes(pixels, pixels + 4 * static_cast<std::ptrdiff_t>(width) * height)};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<image::Mask> decodeMask(ByteView file) {
  const Result<PictureInfo> info = probeDecoded(file);
  if (!info.ok()) return info.failure();
  if (const Status accepted = checkPictureSize(info.value().size); !accepted.ok()) {
    return accepted.failure();
  }
  try {
    const Result<Decoded> decoded = decodePixels(file, info.value(), 1);
    if (!decoded.ok()) return decoded.failure();
    const auto [width, height] = info.value().size;
    const std::uint8_t* pixels = decoded.value().pixels.get();
    return image::Mask{width, height, Bytes(pixels, pixels + static_cast<std::ptrdiff_t>(width) * height)};
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<Bytes> encodePng(const image::Image& image) {
  if (!hasPixels(image, 4)) return Error::PictureEmpty;
  try {
    if (!isOpaque(image)) return writePng({image.width, image.height, 4, image.pixels.data()});
    const Bytes rgb = colours(image);
    return writePng({image.width, image.height, 3, rgb.data()});
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<Bytes> encodeJpeg(const image::Image& image, int quality) {
  if (!hasPixels(image, 4)) return Error::PictureEmpty;
  if (quality < 1 || quality > 100) return Error::ValueOutOfRange;
  try {
    Bytes out;
    const Bytes rgb = colours(image);
    if (stbi_write_jpg_to_func(append, &out, image.width, image.height, 3, rgb.data(), quality) == 0) {
      return Error::OutOfMemory;
    }
    return out;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<Bytes> encodeMaskPng(const image::Mask& mask) {
  if (!hasPixels(mask, 1)) return Error::PictureEmpty;
  return writePng({mask.width, mask.height, 1, mask.pixels.data()});
}

}  // namespace spineloft::io
