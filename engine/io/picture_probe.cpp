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
  const auto [format, size, orientation] = info.value();
  const bool whole = pictureDataComplete(file, info.value());
  // A browser finds the size that these hide.
  const bool isHidden = size == image::Size{} && (format == PictureFormat::Avif || format == PictureFormat::Heic);
  const bool isCut = size == image::Size{} && format == PictureFormat::Webp && !whole;
  if (!isHidden && !isCut) {
    if (const Status fits = checkPictureSize(size); !fits.ok()) return fits.failure();
  }
  if (!whole) return Error::PictureTruncated;
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
