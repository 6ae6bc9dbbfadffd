#include "engine/io/picture_header.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <string_view>

namespace spineloft::io {
namespace {

/// Bounds-checked reading at any offset.
class Reader {
 public:
  explicit Reader(ByteView bytes) : bytes_(bytes) {}
  std::size_t size() const { return bytes_.size(); }
  bool has(std::size_t at, std::size_t count) const { return at <= bytes_.size() && count <= bytes_.size() - at; }
  std::uint8_t byte(std::size_t at) const { return has(at, 1) ? bytes_[at] : std::uint8_t{0}; }
  std::uint32_t little(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = count; i-- > 0;) value = value << 8 | byte(at + i);
    return value;
  }
  std::uint32_t big(std::size_t at, std::size_t count) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | byte(at + i);
    return value;
  }
  bool startsWith(std::size_t at, std::string_view text) const {
    if (!has(at, text.size())) return false;
    for (std::size_t i = 0; i < text.size(); ++i) {
      if (bytes_[at + i] != static_cast<std::uint8_t>(text[i])) return false;
    }
    return true;
  }
  /// The next such byte, or the end.
  std::size_t find(std::uint8_t byte, std::size_t from) const {
    const auto rest = bytes_.subspan(std::min(from, bytes_.size()));
    const void* found = rest.empty() ? nullptr : std::memchr(rest.data(), byte, rest.size());
    return found == nullptr ? bytes_.size()
                            : static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - bytes_.data());
  }
  ByteView part(std::size_t at, std::size_t count) const {
    return has(at, count) ? bytes_.subspan(at, count) : ByteView{};
  }

 private:
  ByteView bytes_;
};

constexpr std::string_view kPngSignature = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kExif{"Exif\0\0", 6};

/// A declared side: anything that does not fit an int is as large as can be said.
int sideOf(std::uint32_t declared) { return static_cast<int>(std::min<std::uint32_t>(declared, 0x7fffffff)); }

// ---- PNG
// ------------------------------------------------------------------------------------------

Result<PictureInfo> probePng(const Reader& file) {
  if (!file.has(0, 33) || !file.startsWith(12, "IHDR")) return Error::PictureTruncated;
  return PictureInfo{PictureFormat::Png, {sideOf(file.big(16, 4)), sideOf(file.big(20, 4))}, 1};
}

/// Most bytes that the compressed pixels can honestly take: 8 bytes a pixel, twice for
/// interlacing's short rows, and room for headers. More is a file made to fill the memory when it
/// is inflated.
std::uint64_t mostPixelData(image::Size size) {
  const std::uint64_t row = 8 * static_cast<std::uint64_t>(size.width) + 1;
  return 2 * row * static_cast<std::uint64_t>(size.height) + 65536;
}

bool pngComplete(const Reader& file, image::Size size) {
  std::uint64_t pixelData = 0;
  for (std::size_t at = kPngSignature.size(); file.has(at, 12);) {
    const std::size_t length = file.big(at, 4);
    if (!file.has(at + 8, length + 4)) return false;
    if (file.startsWith(at + 4, "IDAT")) pixelData += length;
    if (file.startsWith(at + 4, "IEND")) return pixelData > 0 && pixelData <= mostPixelData(size);
    at += 12 + length;
  }
  return false;
}

// ---- JPEG
// -----------------------------------------------------------------------------------------

/// One marker segment: FF `code`, and unless it stands alone a length and `payload`.
struct Segment {
  int code = 0;
  std::size_t begin = 0, end = 0;  ///< payload, without the length
};

/// Walks from marker to marker, over entropy-coded data too.
class JpegMarkers {
 public:
  explicit JpegMarkers(const Reader& file) : file_(file) {}
  std::optional<Segment> next() {
    // Entropy-coded data hold FF only as FF 00 or as restart markers D0…D7.
    while (file_.has(at_, 2)) {
      const int code = file_.byte(at_ + 1);
      if (file_.byte(at_) != 0xff || code == 0x00 || code == 0xff || (code >= 0xd0 && code <= 0xd7)) {
        at_ = file_.find(0xff, at_ + 1);  // 0xff twice: a fill byte
        continue;
      }
      at_ += 2;
      if (code == 0xd8 || code == 0xd9 || code == 0x01) return Segment{code, at_, at_};
      const std::size_t length = file_.big(at_, 2);
      if (length < 2 || !file_.has(at_, length)) return std::nullopt;
      const Segment segment{code, at_ + 2, at_ + length};
      at_ += length;
      return segment;
    }
    return std::nullopt;
  }

 private:
  const Reader& file_;
  std::size_t at_ = 0;
};

bool isFrameHeader(int code) { return code >= 0xc0 && code <= 0xcf && code != 0xc4 && code != 0xc8 && code != 0xcc; }

Result<PictureInfo> probeJpeg(const Reader& file) {
  PictureInfo info{PictureFormat::Jpeg, {}, 1};
  JpegMarkers markers(file);
  bool oriented = false;
  while (const std::optional<Segment> segment = markers.next()) {
    const std::size_t length = segment->end - segment->begin;
    if (segment->code == 0xe1 && !oriented && file.startsWith(segment->begin, kExif)) {
      info.orientation = exifOrientation(file.part(segment->begin + 6, length - 6));
      oriented = true;
    }
    if (isFrameHeader(segment->code)) {
      if (length < 6) return Error::PictureTruncated;
      info.size = {sideOf(file.big(segment->begin + 3, 2)), sideOf(file.big(segment->begin + 1, 2))};
      return info;
    }
    if (segment->code == 0xd9 || segment->code == 0xda) break;
  }
  return Error::PictureTruncated;
}

bool jpegComplete(const Reader& file) {
  JpegMarkers markers(file);
  bool scanned = false;
  while (const std::optional<Segment> segment = markers.next()) {
    if (segment->code == 0xda) scanned = true;
    if (segment->code == 0xd9) return scanned;
  }
  return false;
}

// ---- GIF
// ------------------------------------------------------------------------------------------

Result<PictureInfo> probeGif(const Reader& file) {
  if (!file.has(0, 13)) return Error::PictureTruncated;
  return PictureInfo{PictureFormat::Gif, {sideOf(file.little(6, 2)), sideOf(file.little(8, 2))}, 1};
}

/// Bytes of a colour table that the packed field announces.
std::size_t colourTable(int packed) { return packed & 0x80 ? std::size_t{3} << ((packed & 7) + 1) : 0; }

/// Behind the terminator of a chain of sub-blocks, or none if the chain is cut off.
std::optional<std::size_t> skipSubBlocks(const Reader& file, std::size_t at) {
  while (file.has(at, 1)) {
    const std::size_t length = file.byte(at);
    if (length == 0) return at + 1;
    at += 1 + length;
  }
  return std::nullopt;
}

bool gifFrameComplete(const Reader& file) {
  std::optional<std::size_t> at = 13 + colourTable(file.byte(10));
  while (at && file.has(*at, 2)) {
    if (file.byte(*at) == 0x21) {
      at = skipSubBlocks(file, *at + 2);
    } else if (file.byte(*at) == 0x2c && file.has(*at, 10)) {
      return skipSubBlocks(file, *at + 11 + colourTable(file.byte(*at + 9))).has_value();
    } else {
      return false;
    }
  }
  return false;
}

// ---- BMP
// ------------------------------------------------------------------------------------------

/// Sides of a BMP; a negative height says that rows run from top to bottom.
image::Size bmpSize(const Reader& file) {
  if (file.little(14, 4) == 12) return {sideOf(file.little(18, 2)), sideOf(file.little(20, 2))};
  const std::int64_t height = static_cast<std::int32_t>(file.little(22, 4));
  return {sideOf(file.little(18, 4)), sideOf(static_cast<std::uint32_t>(std::llabs(height)))};
}

Result<PictureInfo> probeBmp(const Reader& file) {
  if (!file.has(0, file.little(14, 4) == 12 ? 26 : 30)) return Error::PictureTruncated;
  return PictureInfo{PictureFormat::Bmp, bmpSize(file), 1};
}

bool bmpComplete(const Reader& file, image::Size size) {
  const bool old = file.little(14, 4) == 12;
  // Compressed rows (run lengths, JPEG or PNG) are as long as they are: only the file says its length.
  const std::uint32_t compression = old ? 0 : file.little(30, 4);
  if (compression != 0 && compression != 3 && compression != 6) return file.little(2, 4) <= file.size();
  const std::uint64_t bits = file.little(old ? 24 : 28, 2);
  const std::uint64_t row = (static_cast<std::uint64_t>(size.width) * bits + 31) / 32 * 4;
  return file.little(10, 4) + row * static_cast<std::uint64_t>(size.height) <= file.size();
}

// ---- WebP
// -----------------------------------------------------------------------------------------

bool webpSaysItsSize(const Reader& file) {
  constexpr std::array<std::string_view, 3> kKinds{"VP8X", "VP8L", "VP8 "};
  return file.has(0, 30) &&
         std::ranges::any_of(kKinds, [&](std::string_view kind) { return file.startsWith(12, kind); });
}

PictureInfo probeWebp(const Reader& file) {
  if (!webpSaysItsSize(file)) return PictureInfo{PictureFormat::Webp, {}, 1};
  if (file.startsWith(12, "VP8X"))
    return PictureInfo{PictureFormat::Webp, {sideOf(file.little(24, 3) + 1), sideOf(file.little(27, 3) + 1)}, 1};
  if (file.startsWith(12, "VP8L")) {
    const std::uint32_t packed = file.little(21, 4);
    return PictureInfo{PictureFormat::Webp, {sideOf((packed & 0x3fff) + 1), sideOf((packed >> 14 & 0x3fff) + 1)}, 1};
  }
  return PictureInfo{
      PictureFormat::Webp, {sideOf(file.little(26, 2) & 0x3fff), sideOf(file.little(28, 2) & 0x3fff)}, 1};
}

bool webpComplete(const Reader& file) {
  return webpSaysItsSize(file) && std::uint64_t{file.little(4, 4)} + 8 <= file.size();
}

// ---- AVIF and HEIC
// --------------------------------------------------------------------------------

/// The size is the largest among the `ispe` boxes near the start: tiles and thumbnails have one too.
Result<PictureInfo> probeIsoMedia(const Reader& file) {
  constexpr std::size_t kBrandsEnd = 72, kBoxesEnd = 65536;
  constexpr std::array<std::string_view, 2> kAvif{"avif", "avis"};
  constexpr std::array<std::string_view, 7> kHeic{"heic", "heix", "heim", "heis", "hevc", "hevx", "mif1"};
  const auto hasBrand = [&](const auto& brands) {
    for (std::size_t at = 8; at < kBrandsEnd && file.has(at, 4); at += 4) {
      if (std::ranges::any_of(brands, [&](std::string_view brand) { return file.startsWith(at, brand); })) return true;
    }
    return false;
  };
  const bool avif = hasBrand(kAvif);
  if (!avif && !hasBrand(kHeic)) return Error::PictureUnreadable;
  PictureInfo info{avif ? PictureFormat::Avif : PictureFormat::Heic, {}, 1};
  for (std::size_t at = 8; at <= kBoxesEnd && file.has(at, 16); ++at) {
    if (!file.startsWith(at, "ispe")) continue;
    info.size.width = std::max(info.size.width, sideOf(file.big(at + 8, 4)));
    info.size.height = std::max(info.size.height, sideOf(file.big(at + 12, 4)));
  }
  if (info.size.width == 0 || info.size.height == 0) info.size = {};
  return info;
}

}  // namespace

int exifOrientation(ByteView tiff) {
  const Reader file(tiff);
  const bool little = file.startsWith(0, "II");
  if (!little && !file.startsWith(0, "MM")) return 1;
  const auto number = [&](std::size_t at, std::size_t count) {
    return little ? file.little(at, count) : file.big(at, count);
  };
  if (!file.has(0, 8) || number(2, 2) != 42) return 1;
  const std::size_t directory = number(4, 4);
  if (!file.has(directory, 2)) return 1;
  const std::size_t entries = number(directory, 2);
  for (std::size_t i = 0; i < entries; ++i) {
    const std::size_t at = directory + 2 + 12 * i;
    if (!file.has(at, 12)) return 1;
    if (number(at, 2) != 0x0112) continue;
    const std::uint32_t type = number(at + 2, 2), count = number(at + 4, 4);
    const std::uint32_t value = number(at + 8, 2);
    return type == 3 && count == 1 && value >= 1 && value <= 8 ? static_cast<int>(value) : 1;
  }
  return 1;
}

Result<PictureInfo> probePicture(ByteView bytes) {
  if (bytes.empty()) return Error::PictureEmpty;
  const Reader file(bytes);
  if (file.startsWith(0, kPngSignature)) return probePng(file);
  if (file.startsWith(0, "\xff\xd8\xff")) return probeJpeg(file);
  if (file.startsWith(0, "GIF87a") || file.startsWith(0, "GIF89a")) return probeGif(file);
  if (file.startsWith(0, "BM")) {
    // Two letters are little to go by: the header's own length must be one that exists.
    constexpr std::array<std::uint32_t, 6> kHeaders{12, 40, 52, 56, 108, 124};
    const bool known = std::find(kHeaders.begin(), kHeaders.end(), file.little(14, 4)) != kHeaders.end();
    if (known || !file.has(0, 18)) return probeBmp(file);
  }
  if (file.startsWith(0, "RIFF") && file.startsWith(8, "WEBP")) return probeWebp(file);
  if (file.startsWith(4, "ftyp")) return probeIsoMedia(file);
  return Error::PictureUnreadable;
}

bool pictureDataComplete(ByteView bytes, const PictureInfo& info) {
  const Reader file(bytes);
  switch (info.format) {
    case PictureFormat::Png:
      return pngComplete(file, info.size);
    case PictureFormat::Jpeg:
      return jpegComplete(file);
    case PictureFormat::Bmp:
      return bmpComplete(file, info.size);
    case PictureFormat::Gif:
      return gifFrameComplete(file);
    case PictureFormat::Webp:
      return webpComplete(file);
    case PictureFormat::Avif:
    case PictureFormat::Heic:
      return true;
  }
  return false;
}

}  // namespace spineloft::io
