// Picture files: bytes in, pixels out, and back. The only users of stb_image and stb_image_write.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/image/image.h"

namespace spineloft::io {

using Bytes = std::vector<std::uint8_t>;
using ByteView = std::span<const std::uint8_t>;

/// Of the last three only headers are read: a browser may decode them, we do not.
enum class PictureFormat : std::uint8_t { Png, Jpeg, Bmp, Gif, Webp, Avif, Heic };
inline bool isDecoded(PictureFormat format) { return format <= PictureFormat::Gif; }

/// What a picture file says about itself.
struct PictureInfo {
  PictureFormat format = PictureFormat::Png;
  image::Size size;     ///< as stored, before the orientation is applied; 0 × 0 where WebP, AVIF or HEIC hide it
  int orientation = 1;  ///< EXIF orientation, 1…8; 1 where there is none
  bool operator==(const PictureInfo&) const = default;
};

/// Reads the header only; any byte sequence is safe. Says what is declared, not whether we accept
/// it. Errors: PictureEmpty (no bytes), PictureUnreadable (begins like none of the formats),
/// PictureTruncated (ends before it says its size).
Result<PictureInfo> probePicture(ByteView file);

/// Whether a picture of that size is accepted: at least kMinPictureSide and at most kMaxPictureSide
/// on a side, at most kMaxPicturePixels. Errors: PictureEmpty (0 pixels), PictureTooLarge,
/// PictureTooSmall.
Status checkPictureSize(image::Size size);

/// Decodes PNG, JPEG, BMP and the first frame of a GIF to the document's picture, EXIF orientation
/// applied. The declared size is checked before anything is decoded. A file whose picture data are
/// cut off is refused, also where the beginning could be shown: half a picture gives a wrong part.
/// Errors: those of probePicture and checkPictureSize, PictureTruncated (cut off or damaged data),
/// PictureUnreadable (a variant of the format that we do not know), Cancelled, OutOfMemory.
Result<image::Picture> decodePicture(ByteView file, const Progress& progress);

/// The pixels as they are stored, whatever their size and orientation, as long as there are at most
/// `mostPixels`. Errors: as decodePicture without PictureTooSmall and Cancelled.
Result<image::Image> decodeImage(ByteView file, long long mostPixels);

/// The picture as one grey byte a pixel, at its stored size and orientation: a truth mask or a mask
/// that was edited elsewhere. Errors: as decodePicture.
Result<image::Mask> decodeMask(ByteView file);

/// PNG with alpha where the image has any transparent pixel. Errors: PictureEmpty, OutOfMemory.
Result<Bytes> encodePng(const image::Image& image);
/// JPEG; transparent pixels are mixed with white paper. `quality` 1…100.
/// Errors: PictureEmpty, ValueOutOfRange, OutOfMemory.
Result<Bytes> encodeJpeg(const image::Image& image, int quality);
/// Eight-bit grey PNG with the mask's values. Errors: PictureEmpty, OutOfMemory.
Result<Bytes> encodeMaskPng(const image::Mask& mask);

}  // namespace spineloft::io
