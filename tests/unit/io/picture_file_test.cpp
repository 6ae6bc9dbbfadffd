#include "engine/io/picture_file.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string_view>

#include "engine/base/limits.h"
#include "engine/base/rng.h"

using namespace spineloft;
using namespace spineloft::io;

namespace {

image::Image smoothImage(int width, int height) {
  image::Image image{width, height, {}};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (const int v : {255 * x / width, 255 * y / height, 128, 255}) {
        image.pixels.push_back(static_cast<std::uint8_t>(v));
      }
    }
  }
  return image;
}

image::Image noisyImage(int width, int height, std::uint64_t seed) {
  image::Image image = smoothImage(width, height);
  Rng rng(seed);
  for (auto& value : image.pixels) value = static_cast<std::uint8_t>(rng.below(256));
  return image;
}

void put(Bytes& out, std::string_view text) {
  for (const char c : text) out.push_back(static_cast<std::uint8_t>(c));
}
void putBig(Bytes& out, std::uint32_t value, int count) {
  while (count-- > 0) out.push_back(static_cast<std::uint8_t>(value >> (8 * count)));
}
void putLittle(Bytes& out, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) out.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

Bytes pngHeader(std::uint32_t width, std::uint32_t height) {
  Bytes out;
  put(out, std::string_view("\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR", 16));
  putBig(out, width, 4);
  putBig(out, height, 4);
  put(out, std::string_view("\x08\x06\0\0\0\x12\x34\x56\x78", 9));
  return out;
}

Bytes jpegHeader(std::uint32_t width, std::uint32_t height) {
  Bytes out;
  put(out, std::string_view("\xff\xd8\xff\xc0\0\x11\x08", 7));
  putBig(out, height, 2);
  putBig(out, width, 2);
  put(out, std::string_view("\x03\x01\x22\0\x02\x11\x01\x03\x11\x01", 10));
  return out;
}

Bytes bmpFile(const image::Image& image, bool topDown) {
  const int row = (3 * image.width + 3) / 4 * 4;
  Bytes out;
  put(out, "BM");
  putLittle(out, static_cast<std::uint32_t>(54 + row * image.height), 4);
  putLittle(out, 0, 4);
  putLittle(out, 54, 4);
  putLittle(out, 40, 4);
  putLittle(out, static_cast<std::uint32_t>(image.width), 4);
  putLittle(out, static_cast<std::uint32_t>(topDown ? -image.height : image.height), 4);
  putLittle(out, 1, 2);
  putLittle(out, 24, 2);
  for (int i = 0; i < 6; ++i) putLittle(out, 0, 4);
  for (int y = 0; y < image.height; ++y) {
    const int from = topDown ? y : image.height - 1 - y;
    for (int x = 0; x < image.width; ++x) {
      const std::size_t at = 4 * static_cast<std::size_t>(from * image.width + x);
      for (const std::size_t c : {2, 1, 0}) out.push_back(image.pixels[at + c]);
    }
    for (int pad = 3 * image.width; pad < row; ++pad) out.push_back(0);
  }
  return out;
}

/// A GIF of `frames` plain frames, colour index = frame number; codes stay 8 bits wide by clearing.
Bytes gifFile(int width, int height, int frames) {
  Bytes out;
  put(out, "GIF89a");
  putLittle(out, static_cast<std::uint32_t>(width), 2);
  putLittle(out, static_cast<std::uint32_t>(height), 2);
  put(out, std::string_view("\xf6\0\0", 3));
  for (int i = 0; i < 128; ++i) {
    for (const int v : {i, 2 * i, 255 - i}) out.push_back(static_cast<std::uint8_t>(v));
  }
  for (int frame = 0; frame < frames; ++frame) {
    put(out, std::string_view("\x21\xf9\x04\0\x05\0\0\0", 8));
    out.push_back(0x2c);
    for (const int v : {0, 0, width, height}) putLittle(out, static_cast<std::uint32_t>(v), 2);
    out.push_back(0);
    out.push_back(7);
    Bytes codes;
    for (int i = 0; i < width * height; ++i) {
      if (i % 100 == 0) codes.push_back(128);
      codes.push_back(static_cast<std::uint8_t>(frame + 5));
    }
    codes.push_back(129);
    for (std::size_t at = 0; at < codes.size(); at += 200) {
      const std::size_t count = std::min<std::size_t>(200, codes.size() - at);
      out.push_back(static_cast<std::uint8_t>(count));
      for (std::size_t i = 0; i < count; ++i) out.push_back(codes[at + i]);
    }
    out.push_back(0);
  }
  out.push_back(0x3b);
  return out;
}

Bytes withOrientation(const Bytes& jpeg, int orientation, bool little) {
  Bytes exif;
  put(exif, std::string_view("Exif\0\0", 6));
  const auto number = [&](std::uint32_t value, int count) {
    little ? putLittle(exif, value, count) : putBig(exif, value, count);
  };
  put(exif, little ? "II" : "MM");
  number(42, 2);
  number(8, 4);
  number(2, 2);
  number(0x010f, 2), number(2, 2), number(4, 4), number(0x41414141, 4);  // maker, to be skipped
  number(0x0112, 2), number(3, 2), number(1, 4);
  number(static_cast<std::uint32_t>(orientation), 2), number(0, 2);
  number(0, 4);
  Bytes out(jpeg.begin(), jpeg.begin() + 2);
  put(out, "\xff\xe1");
  putBig(out, static_cast<std::uint32_t>(exif.size() + 2), 2);
  out.insert(out.end(), exif.begin(), exif.end());
  out.insert(out.end(), jpeg.begin() + 2, jpeg.end());
  return out;
}

Bytes encoded(Result<Bytes> result) {
  REQUIRE(result.ok());
  return result.value();
}
image::Picture decoded(const Bytes& file) {
  const auto picture = decodePicture(file, Progress());
  REQUIRE(picture.ok());
  return picture.value();
}
Error errorOf(const Bytes& file) {
  const auto picture = decodePicture(file, Progress());
  REQUIRE_FALSE(picture.ok());
  return picture.error();
}
double largestDifference(const image::Image& a, const image::Image& b) {
  REQUIRE(a.width == b.width);
  REQUIRE(a.height == b.height);
  double largest = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, std::abs(1.0 * a.pixels[i] - b.pixels[i]));
  }
  return largest;
}

}  // namespace

TEST_CASE("a PNG that was written reads back bit for bit, with and without transparency") {
  const image::Image rough = noisyImage(37, 29, 1), opaque = smoothImage(37, 29);
  const image::Picture a = decoded(encoded(encodePng(opaque)));
  CHECK(a.working == opaque);
  CHECK(a.width == 37);
  CHECK(a.height == 29);
  CHECK(decoded(encoded(encodePng(rough))).working == rough);
  const auto info = probePicture(encoded(encodePng(rough)));
  REQUIRE(info.ok());
  CHECK(info.value() == PictureInfo{PictureFormat::Png, {37, 29}, 1});
}

TEST_CASE("a JPEG that was written reads back nearly, nearer with more quality") {
  const image::Image image = smoothImage(64, 48);
  const double good = largestDifference(decoded(encoded(encodeJpeg(image, 95))).working, image);
  CHECK(good < 12);
  CHECK(encoded(encodeJpeg(image, 20)).size() < encoded(encodeJpeg(image, 95)).size());
  CHECK(encodeJpeg(image, 0).error() == Error::ValueOutOfRange);
  CHECK(encodeJpeg(image, 101).error() == Error::ValueOutOfRange);
  CHECK(encodeJpeg({}, 90).error() == Error::PictureEmpty);
  CHECK(encodePng({3, 3, {1}}).error() == Error::PictureEmpty);
  CHECK(encodeMaskPng({}).error() == Error::PictureEmpty);
}

TEST_CASE("BMPs are read whichever way their rows run, and the first frame of a GIF is read") {
  const image::Image image = smoothImage(33, 21);
  CHECK(decoded(bmpFile(image, false)).working == image);
  CHECK(decoded(bmpFile(image, true)).working == image);
  const image::Picture first = decoded(gifFile(40, 20, 3));
  CHECK(first.width == 40);
  CHECK(first.height == 20);
  for (std::size_t i = 0; i < first.working.pixels.size(); i += 4) {
    REQUIRE(first.working.pixels[i] == 5);
    REQUIRE(first.working.pixels[i + 1] == 10);
    REQUIRE(first.working.pixels[i + 2] == 250);
  }
}

TEST_CASE("a mask reads back with its own values") {
  image::Mask mask{30, 20, Bytes(600)};
  for (std::size_t i = 0; i < 600; ++i) mask.pixels[i] = static_cast<std::uint8_t>(i % 3 * 127);
  const auto again = decodeMask(encoded(encodeMaskPng(mask)));
  REQUIRE(again.ok());
  CHECK(again.value() == mask);
}

TEST_CASE("a JPEG is shown the way its EXIF orientation says, in both byte orders") {
  const image::Image image = smoothImage(48, 32);
  const Bytes plain = encoded(encodeJpeg(image, 95));
  const image::Image stored = decoded(plain).working;
  for (int orientation = 1; orientation <= 8; ++orientation) {
    for (const bool little : {false, true}) {
      const Bytes file = withOrientation(plain, orientation, little);
      const auto info = probePicture(file);
      REQUIRE(info.ok());
      CHECK(info.value() == PictureInfo{PictureFormat::Jpeg, {48, 32}, orientation});
      const image::Picture picture = decoded(file);
      CHECK(picture.working == image::orient(stored, orientation));
      CHECK(picture.width == (orientation >= 5 ? 32 : 48));
    }
  }
  for (const int senseless : {0, 9, 65535}) {
    CHECK(decoded(withOrientation(plain, senseless, true)).working == stored);
  }
}

TEST_CASE("a large picture is decoded to a working copy that remembers its size") {
  const image::Picture picture = decoded(encoded(encodeJpeg(smoothImage(2600, 2000), 80)));
  CHECK(picture.width == 2600);
  CHECK(picture.height == 2000);
  CHECK(static_cast<long long>(picture.working.width) * picture.working.height <= kWorkingPixels);
}

TEST_CASE("sizes are refused from the header alone") {
  CHECK(errorOf(pngHeader(64250, 64250)) == Error::PictureTooLarge);
  CHECK(errorOf(jpegHeader(64250, 64250)) == Error::PictureTooLarge);
  CHECK(errorOf(pngHeader(0xffffffff, 0xffffffff)) == Error::PictureTooLarge);
  CHECK(errorOf(pngHeader(30000, 30000)) == Error::PictureTooLarge);
  CHECK(errorOf(pngHeader(1, 1)) == Error::PictureTooSmall);
  CHECK(errorOf(pngHeader(20000, 1)) == Error::PictureTooSmall);
  CHECK(errorOf(pngHeader(15, 16)) == Error::PictureTooSmall);
  CHECK(errorOf(pngHeader(0, 16)) == Error::PictureEmpty);
  CHECK(errorOf(encoded(encodePng(smoothImage(1, 1)))) == Error::PictureTooSmall);
  CHECK(errorOf(encoded(encodePng(smoothImage(20000, 1)))) == Error::PictureTooSmall);
  Bytes bmp = bmpFile(smoothImage(16, 16), false);
  for (const std::size_t at : {18, 22}) bmp[at] = 0xfa, bmp[at + 1] = 0xfa, bmp[at + 2] = 0;
  CHECK(errorOf(bmp) == Error::PictureTooLarge);
  CHECK(checkPictureSize({kMinPictureSide, kMinPictureSide}).ok());
  CHECK(checkPictureSize({kMaxPictureSide, 3000}).ok());
  CHECK(checkPictureSize({kMaxPictureSide + 1, 100}).error() == Error::PictureTooLarge);
}

TEST_CASE("no bytes, other formats and noise are named as such") {
  CHECK(errorOf({}) == Error::PictureEmpty);
  Bytes text;
  put(text, "This is a letter, not a picture.");
  CHECK(errorOf(text) == Error::PictureUnreadable);
  Bytes webp;
  put(webp, "RIFF....WEBPVP8 ");
  CHECK(errorOf(webp) == Error::PictureUnreadable);
  Bytes letter;
  put(letter, "BMW drives past the house, and nothing in it is a picture.");
  CHECK(errorOf(letter) == Error::PictureUnreadable);
  Rng rng(3);
  for (int i = 0; i < 2000; ++i) {
    Bytes noise(rng.below(300));
    for (auto& value : noise) value = static_cast<std::uint8_t>(rng.below(256));
    REQUIRE_FALSE(decodePicture(noise, Progress()).ok());
  }
}

TEST_CASE("a picture cut off anywhere is refused as damaged, never half shown") {
  for (const Bytes& file : {encoded(encodePng(noisyImage(24, 24, 2))), encoded(encodeJpeg(noisyImage(24, 24, 2), 90)),
                            bmpFile(noisyImage(24, 24, 2), false), gifFile(24, 24, 1)}) {
    REQUIRE(decodePicture(file, Progress()).ok());
    const bool gif = file[0] == 'G';  // a whole first frame needs no trailer
    for (std::size_t length = 8; length + (gif ? 1 : 0) < file.size(); ++length) {
      const Bytes part(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length));
      const auto picture = decodePicture(part, Progress());
      REQUIRE_FALSE(picture.ok());
      REQUIRE((picture.error() == Error::PictureTruncated));
    }
  }
}

TEST_CASE("damaged bytes never crash, and what is decoded has its declared size") {
  Rng rng(17);
  const Bytes jpeg = withOrientation(encoded(encodeJpeg(noisyImage(24, 20, 5), 70)), 6, true);
  for (const Bytes& file :
       {encoded(encodePng(noisyImage(24, 20, 2))), jpeg, bmpFile(noisyImage(24, 20, 2), true), gifFile(24, 20, 2)}) {
    for (int round = 0; round < 1500; ++round) {
      Bytes damaged = file;
      const std::uint32_t reach = round % 3 == 0 ? 64u : static_cast<std::uint32_t>(file.size());
      for (std::uint32_t i = 0; i <= rng.below(4); ++i) {
        damaged[rng.below(reach)] = static_cast<std::uint8_t>(rng.below(256));
      }
      const auto info = probePicture(damaged);
      // Keeps the test small: huge sizes that we accept are decoded elsewhere.
      if (info.ok() && 1LL * info.value().size.width * info.value().size.height > 4'000'000) continue;
      const auto picture = decodePicture(damaged, Progress());
      if (!picture.ok()) continue;
      const image::Picture& p = picture.value();
      REQUIRE(info.value().size.width * info.value().size.height == p.width * p.height);
      REQUIRE(p.working.pixels.size() ==
              4 * static_cast<std::size_t>(p.working.width) * static_cast<std::size_t>(p.working.height));
    }
  }
}

TEST_CASE("a small PNG with far too much compressed data is refused before it is inflated") {
  Bytes file = encoded(encodePng(smoothImage(16, 16)));
  const std::string_view end = "IEND";
  const auto tag = std::search(file.begin(), file.end(), end.begin(), end.end());
  REQUIRE(tag != file.end());
  Bytes bomb(file.begin(), tag - 4);
  putBig(bomb, 1'000'000, 4);
  put(bomb, "IDAT");
  bomb.resize(bomb.size() + 1'000'004, 0x55);
  bomb.insert(bomb.end(), tag - 4, file.end());
  CHECK(errorOf(bomb) == Error::PictureTruncated);
}

TEST_CASE("cancelled decoding gives nothing and says so") {
  const Progress progress;
  progress.cancel();
  const auto picture = decodePicture(encoded(encodePng(smoothImage(20, 20))), progress);
  REQUIRE_FALSE(picture.ok());
  CHECK(picture.error() == Error::Cancelled);
}
