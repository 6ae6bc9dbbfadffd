// What picture_file.cpp needs to know of the formats besides their pixels: sizes, orientation and
// whether the data run to their end. Every read is bounds-checked.
#pragma once

#include "engine/io/picture_file.h"

namespace spineloft::io {

/// Whether the picture data end where the format says they do: PNG up to IEND, JPEG up to EOI, the
/// first GIF frame up to its terminator, all BMP rows, WebP as long as it declares; AVIF and HEIC are believed. Lenient
/// decoders fill what is missing with grey.
bool pictureDataComplete(ByteView file, const PictureInfo& info);

/// EXIF orientation from a TIFF block ("II*\0…" or "MM\0*…"); 1 where it is missing or damaged.
int exifOrientation(ByteView tiff);

}  // namespace spineloft::io
