#include "engine/io/picture_probe.h"

#include <array>
#include <nlohmann/json.hpp>

#include "engine/base/limits.h"
#include "engine/io/picture_header.h"

namespace spineloft::io {
namespace {

constexpr std::array<const char*, 7> kFormats{"png", "jpeg", "bmp", "gif", "webp", "avif", "heic"};

Result<PictureInfo> accepted(ByteView file) {
  const Result<PictureInfo> info = probePicture(file);
  if (!info.ok()) return info;
  const bool isHidden = !isDecoded(info.value().format) && info.value().size == image::Size{};
  if (!isHidden) {
    if (const Status size = checkPictureSize(info.value().size); !size.ok()) return size.failure();
  }
  if (!pictureDataComplete(file, info.value())) return Error::PictureTruncated;
  return info;
}

}  // namespace

std::string probeJson(ByteView file) {
  const Result<PictureInfo> info = accepted(file);
  if (!info.ok()) return nlohmann::json{{"error", errorName(info.error())}}.dump();
  return nlohmann::json{{"format", kFormats[static_cast<std::size_t>(info.value().format)]},
                        {"minSide", kMinPictureSide},
                        {"maxSide", kMaxPictureSide},
                        {"mostPixels", kMaxPicturePixels},
                        {"workingPixels", kWorkingPixels}}
      .dump();
}

}  // namespace spineloft::io
