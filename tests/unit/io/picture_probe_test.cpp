#include "engine/io/picture_probe.h"

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::io;

namespace {

using Json = nlohmann::json;

Json probed(const Bytes& file) { return Json::parse(probeJson(file)); }

image::Image grey(int width, int height) {
  return {width, height, Bytes(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 200)};
}

void put(Bytes& out, std::size_t at, std::string_view text) {
  for (const char c : text) out[at++] = static_cast<std::uint8_t>(c);
}
void putLittle(Bytes& out, std::size_t at, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) out[at++] = static_cast<std::uint8_t>(value >> (8 * i));
}
void putBig(Bytes& out, std::size_t at, std::uint32_t value) {
  for (int i = 3; i >= 0; --i) out[at++] = static_cast<std::uint8_t>(value >> (8 * i));
}

Bytes webp(std::string_view kind) {
  Bytes out(60);
  put(out, 0, "RIFF");
  putLittle(out, 4, 52, 4);
  put(out, 8, "WEBP");
  put(out, 12, kind);
  return out;
}

Bytes isoMedia(std::string_view brand, int boxes) {
  Bytes out(200);
  put(out, 4, "ftyp");
  put(out, 8, brand);
  for (int i = 0; i < boxes; ++i) {
    const auto at = static_cast<std::size_t>(40 + 20 * i);
    put(out, at, "ispe");
    putBig(out, at + 8, static_cast<std::uint32_t>(400 * (i + 1)));
    putBig(out, at + 12, static_cast<std::uint32_t>(300 * (i + 1)));
  }
  return out;
}

}  // namespace

TEST_CASE("whole pictures are probed as their format, with the limits of the engine") {
  const Json png = probed(encodePng(grey(64, 48)).value());
  CHECK(png == Json{{"format", "png"},
                    {"minSide", 16},
                    {"maxSide", 32768},
                    {"mostPixels", 120000000},
                    {"workingPixels", 4000000}});
  CHECK(probed(encodeJpeg(grey(64, 48), 80).value())["format"] == "jpeg");
}

TEST_CASE("a picture cut off anywhere is refused") {
  for (const Bytes& file : {encodePng(grey(64, 48)).value(), encodeJpeg(grey(64, 48), 80).value()}) {
    for (std::size_t length = 0; length < file.size(); length += 1 + length / 40) {
      const Json part = probed(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length)));
      CHECK(part.contains("error"));
      CHECK_FALSE(part.contains("format"));
    }
  }
}

TEST_CASE("WebP, AVIF and HEIC tell their size to the probe, and nothing here decodes them") {
  Bytes extended = webp("VP8X");
  putLittle(extended, 24, 1999, 3);
  putLittle(extended, 27, 999, 3);
  CHECK(probePicture(extended).value() == PictureInfo{PictureFormat::Webp, {2000, 1000}, 1});
  Bytes lossless = webp("VP8L");
  putLittle(lossless, 21, 299 | 199 << 14, 4);
  CHECK(probePicture(lossless).value().size == image::Size{300, 200});
  Bytes lossy = webp("VP8 ");
  putLittle(lossy, 26, 0x4000 | 320, 2);
  putLittle(lossy, 28, 240, 2);
  CHECK(probePicture(lossy).value().size == image::Size{320, 240});
  CHECK(probePicture(isoMedia("avif", 2)).value() == PictureInfo{PictureFormat::Avif, {800, 600}, 1});
  CHECK(probePicture(isoMedia("heic", 1)).value() == PictureInfo{PictureFormat::Heic, {400, 300}, 1});
  CHECK(probePicture(isoMedia("isom", 1)).error() == Error::PictureUnreadable);
  for (const Bytes& file : {extended, lossless, lossy, isoMedia("avif", 2), isoMedia("heic", 0)}) {
    CHECK(probed(file).contains("format"));
    CHECK(decodePicture(file, Progress()).error() == Error::PictureUnreadable);
    CHECK(decodeImage(file, 100000000).error() == Error::PictureUnreadable);
    CHECK(decodeMask(file).error() == Error::PictureUnreadable);
  }
  putLittle(lossy, 4, 5000, 4);
  CHECK(probed(lossy)["error"] == "PictureTruncated");
}

TEST_CASE("sizes that are not accepted are refused from the header") {
  Bytes large = webp("VP8X"), small = webp("VP8 ");
  putLittle(large, 24, 32768, 3);
  putLittle(large, 27, 99, 3);
  putLittle(small, 26, 15, 2);
  putLittle(small, 28, 100, 2);
  CHECK(probed(large)["error"] == "PictureTooLarge");
  CHECK(probed(small)["error"] == "PictureTooSmall");
  CHECK(probed(webp("VP8 "))["error"] == "PictureEmpty");
  CHECK(probed({})["error"] == "PictureEmpty");
  CHECK(probed(Bytes(100, 'a'))["error"] == "PictureUnreadable");
}

TEST_CASE("a compressed BMP is as long as it says") {
  Bytes bmp(120);
  put(bmp, 0, "BM");
  putLittle(bmp, 2, 120, 4);
  putLittle(bmp, 10, 54, 4);
  putLittle(bmp, 14, 40, 4);
  putLittle(bmp, 18, 300, 4);
  putLittle(bmp, 22, static_cast<std::uint32_t>(-200), 4);
  putLittle(bmp, 28, 8, 2);
  CHECK(probed(bmp)["error"] == "PictureTruncated");
  putLittle(bmp, 30, 1, 4);
  CHECK(probed(bmp)["format"] == "bmp");
  putLittle(bmp, 2, 121, 4);
  CHECK(probed(bmp)["error"] == "PictureTruncated");
}

TEST_CASE("random bytes behind every signature are probed without harm") {
  constexpr std::array<std::string_view, 8> kHeads{std::string_view("\x89PNG\r\n\x1a\n", 8),
                                                   "\xff\xd8\xff\xe0",
                                                   "GIF89a",
                                                   std::string_view("RIFF\0\0\0\0WEBPVP8X", 16),
                                                   std::string_view("RIFF\0\0\0\0WEBPVP8L", 16),
                                                   "BM",
                                                   std::string_view("\0\0\0\x18"
                                                                    "ftypavif",
                                                                    12),
                                                   std::string_view("\0\0\0\x18"
                                                                    "ftypheic",
                                                                    12)};
  Rng rng(7);
  for (std::size_t round = 0; round < 2000; ++round) {
    const std::string_view head = kHeads[round % kHeads.size()];
    Bytes file(head.begin(), head.end());
    for (std::uint32_t i = rng.below(80); i > 0; --i) file.push_back(static_cast<std::uint8_t>(rng.below(256)));
    const Json answer = probed(file);
    CHECK(answer.contains("error") != answer.contains("format"));
  }
}
