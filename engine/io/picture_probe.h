// What the page must know of a picture file before its browser decodes it.
#pragma once

#include <string>

#include "engine/io/picture_file.h"

namespace spineloft::io {

/// {"format":"png"|"jpeg"|"bmp"|"gif"|"webp"|"avif"|"heic", "minSide","maxSide","mostPixels","workingPixels"} with the
/// engine's limits (limits.h), or {"error":name} where the file would be refused: errors of probePicture and
/// checkPictureSize, PictureTruncated. Only the header is read, and how far the data run.
std::string probeJson(ByteView file);

}  // namespace spineloft::io
