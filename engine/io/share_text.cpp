#include "engine/io/share_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "engine/base/crc32.h"
#include "engine/io/document_json.h"
#include "engine/io/packed_json.h"
#include "engine/io/picture_file.h"
#include "engine/io/share_digits.h"
#include "engine/io/share_ends.h"
#include "engine/io/share_grid.h"
#include "engine/io/share_slices.h"

namespace spineloft::io {
namespace {

using document::Document;

// ---- what is kept -------------------------------------------------------------------------------

/// Longest side of the white picture that stands for a photo, pixels of its working copy.
constexpr int kBlankSide = 64;

std::shared_ptr<const image::Picture> blankPicture(image::Size size) {
  image::Picture blank;
  blank.width = size.width;
  blank.height = size.height;
  const image::Size small = image::fitSize(size, kBlankSide * kBlankSide, kBlankSide);
  blank.working.width = small.width;
  blank.working.height = small.height;
  blank.working.pixels.assign(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height), 255);
  return std::make_shared<const image::Picture>(std::move(blank));
}

constexpr const char* kPhotoKey = "photo";

/// The id of a picture of the document's JSON; none where it has no usable one.
PictureId idOf(const Json& picture) {
  PictureId id;
  if (picture.is_object()) get(picture.value("id", Json()), id.value);
  return id;
}

/// The document's JSON with rounded numbers; of a photo its copy, or that there is one.
Json keptJson(const Document& document, const PhotoCopies& copies = {}) {
  Json json = documentJson(onGrids(document));
  roundNumbers(json);
  shortenSlices(json);
  if (Json* pictures = listOf(json, kPicturesKey)) {
    for (Json& picture : *pictures) {
      if (!picture.contains(kPhotoKey)) continue;
      const auto copy = copies.find(idOf(picture));
      picture[kPhotoKey] = copy == copies.end() ? Json(true) : Json(copy->second);
    }
  }
  return json;
}

/// The photo as one of a picture of this size; null where it is of another shape.
std::shared_ptr<const image::Picture> sizedPhoto(const CopiedPhotos& photos, PictureId id, image::Size size) {
  const auto at = photos.find(id);
  if (at == photos.end()) return nullptr;
  image::Picture photo = *at->second;
  const double off =
      static_cast<double>(photo.working.width) * size.height - static_cast<double>(photo.working.height) * size.width;
  if (std::abs(off) > std::max(size.width, size.height)) return nullptr;
  photo.width = size.width;
  photo.height = size.height;
  return std::make_shared<const image::Picture>(std::move(photo));
}

/// The photos that are there, and white pictures in place of the others.
Result<Document> documentOf(Json json, int version, ReadNotes* notes, const CopiedPhotos& copied = {}) {
  std::map<std::uint64_t, std::shared_ptr<const image::Picture>> shown;
  std::set<PictureId> missing;
  if (Json* pictures = listOf(json, kPicturesKey)) {
    for (Json& picture : *pictures) {
      if (!picture.is_object() || !picture.contains(kPhotoKey)) continue;
      image::Size size;
      const auto at = picture.find("size");
      if (at == picture.end() || !get(*at, size) || size.width < 1 || size.height < 1) continue;
      auto photo = sizedPhoto(copied, idOf(picture), size);
      if (photo == nullptr) {
        if (picture[kPhotoKey].is_string()) missing.insert(idOf(picture));
        photo = blankPicture(size);
      }
      const std::uint64_t hash = document::contentHash(*photo);
      picture[kPhotoKey] = hashKey(hash);
      shown[hash] = std::move(photo);
    }
  }
  findEnds(json, version);
  if (version >= kFirstShortSlices) restoreSlices(json);
  const PictureSource photos = [&](std::uint64_t hash) -> std::shared_ptr<const image::Picture> {
    const auto found = shown.find(hash);
    return found == shown.end() ? nullptr : found->second;
  };
  ReadNotes ours;
  Result<Document> read = documentFrom(std::move(json), {notes != nullptr ? *notes : ours, photos}, MissingPhoto::Drop);
  if (!read.ok()) return read;
  for (Box<document::Part>& box : read.value().parts) {
    if (!missing.contains(document::pictureOf(box.get()))) continue;
    document::Part part = box.get();
    part.look.textured = false;
    box = std::move(part);
  }
  makeRoomForIds(read.value(), notes != nullptr ? *notes : ours);
  return read;
}

// ---- the text -----------------------------------------------------------------------------------

/// Bytes of the checksum: of crc32 the last ones. A text changed by chance passes once in 16 million times.
constexpr std::size_t kSumBytes = 3;
constexpr std::uint32_t kSumMask = 0xFFFFFF;

/// Five bits a character, lowest first; all but the last are above 31.
void appendNumber(std::string& text, std::size_t value) {
  for (; value >= 32; value /= 32) text += kDigits64[32 + value % 32];
  text += kDigits64[value];
}

/// Takes the number from the front; none when it is not there whole.
std::optional<std::size_t> takeNumber(std::string_view& text) {
  std::size_t value = 0;
  for (int shift = 0; shift < 30 && !text.empty(); shift += 5) {
    const int digit = digitOf(text.front());
    if (digit < 0) return std::nullopt;
    text.remove_prefix(1);
    value |= static_cast<std::size_t>(digit % 32) << shift;
    if (digit < 32) return value;
  }
  return std::nullopt;
}

int versionOf(std::string_view text) { return text.front() - '0'; }

/// The last one knows most of traced parts, the one before of all other kinds. Their documents are the same.
constexpr std::array<int, 2> kWrittenVersions{kShareVersion, kShareVersion - 1};

std::uint32_t takeSum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = 0;
  for (const std::uint8_t byte : bytes) sum = sum << 8 | byte;
  return sum;
}

/// The checksum of what packJson wrote. From version 5 on it is also of the version: a text whose first character was
/// changed is none of another version.
std::uint32_t sumOf(std::vector<std::uint8_t> packed, int version) {
  constexpr int kFirstOfVersion = 5;
  if (version >= kFirstOfVersion) packed.push_back(static_cast<std::uint8_t>(version));
  return crc32(packed) & kSumMask;
}

/// Three bytes of the checksum, then what packJson wrote, without the zeros at its end.
std::optional<std::vector<std::uint8_t>> packedIn(std::string_view body, int version) {
  if (body.ends_with(kDigits64[0])) return std::nullopt;
  std::string whole(body);
  while (whole.size() % 4 != 0 || whole.size() < 4 * kSumBytes) whole += kDigits64[0];
  auto bytes = toBytes(whole);
  if (!bytes) return std::nullopt;
  const std::uint32_t sum = takeSum(std::span(*bytes).first(kSumBytes));
  bytes->erase(bytes->begin(), bytes->begin() + kSumBytes);
  while (!bytes->empty() && bytes->back() == 0) bytes->pop_back();
  return sumOf(*bytes, version) == sum ? bytes : std::nullopt;
}

/// Of versions 1 and 2: all of what packJson wrote, then four bytes.
std::optional<std::vector<std::uint8_t>> packedFirst(std::string_view body) {
  constexpr std::size_t kSum = 4;
  auto bytes = toBytes(body);
  if (!bytes || bytes->size() < kSum) return std::nullopt;
  const std::uint32_t sum = takeSum(std::span(*bytes).last(kSum));
  bytes->resize(bytes->size() - kSum);
  return crc32(*bytes) == sum ? bytes : std::nullopt;
}

Result<Json> jsonOf(std::string_view text) {
  if (!isShareText(text)) return Error::LinkForeign;
  const int version = versionOf(text);
  if (version > kShareVersion) return Error::ProjectTooNew;
  if (text.size() > kMostShareText) return Error::OutOfMemory;
  text.remove_prefix(1);
  const auto length = takeNumber(text);
  if (!length) return text.empty() ? Error::LinkCut : Error::LinkAltered;
  if (text.size() < *length && *length <= kMostShareText)
    return {Error::LinkCut, std::to_string(*length - text.size()) + " characters are missing"};
  if (text.size() != *length) return Error::LinkAltered;
  const auto packed = version < kFirstOnCurves ? packedFirst(text) : packedIn(text, version);
  if (!packed) return Error::LinkAltered;
  return unpackJson(*packed, version);
}

Result<Document> readText(std::string_view text, ReadNotes* notes, const CopiedPhotos& photos) {
  Result<Json> json = jsonOf(text);
  if (!json.ok()) return json.failure();
  return documentOf(std::move(json).value(), versionOf(text), notes, photos);
}

/// A picture file that anybody may decode: its header says that it is small.
bool isSmallPhoto(const std::optional<std::vector<std::uint8_t>>& file) {
  if (!file) return false;
  const Result<PictureInfo> info = probePicture(*file);
  if (!info.ok()) return false;
  const auto [format, size, orientation] = info.value();
  return (format == PictureFormat::Webp || format == PictureFormat::Jpeg) && std::min(size.width, size.height) > 0 &&
         std::max(size.width, size.height) <= kMostSharedSide;
}

Result<PhotoCopies> copiesIn(std::string_view text) {
  Result<Json> json = jsonOf(text);
  if (!json.ok()) return json.failure();
  PhotoCopies copies;
  if (const Json* pictures = listOf(json.value(), kPicturesKey)) {
    for (const Json& picture : *pictures) {
      if (!picture.is_object() || !picture.contains(kPhotoKey) || !picture[kPhotoKey].is_string()) continue;
      auto copy = picture[kPhotoKey].get<std::string>();
      if (isSmallPhoto(toBytes(copy))) copies.emplace(idOf(picture), std::move(copy));
    }
  }
  return copies;
}

}  // namespace

document::Document shareable(const Document& document) {
  Result<Document> read = documentOf(keptJson(document), kShareVersion, nullptr);
  return read.ok() ? std::move(read).value() : Document{};
}

std::string sealShareText(std::vector<std::uint8_t> packed, int version) {
  while (!packed.empty() && packed.back() == 0) packed.pop_back();
  const std::uint32_t sum = sumOf(packed, version);
  for (std::size_t shift = 0; shift < 8 * kSumBytes; shift += 8)
    packed.insert(packed.begin(), static_cast<std::uint8_t>(sum >> shift));
  std::string body = toText(packed);
  while (body.ends_with(kDigits64[0])) body.pop_back();
  std::string text(1, static_cast<char>('0' + version));
  appendNumber(text, body.size());
  return text + body;
}

Result<std::string> writeShareText(const Document& document, const PhotoCopies& copies) {
  const Json json = keptJson(document, copies);
  std::string shortest;
  for (const int version : kWrittenVersions) {
    Result<std::vector<std::uint8_t>> packed = packJson(json, {}, version);
    if (!packed.ok()) return packed.failure();
    std::string text = sealShareText(std::move(packed).value(), version);
    if (shortest.empty() || text.size() < shortest.size()) shortest = std::move(text);
  }
  return shortest;
}

bool isShareText(std::string_view text) {
  return text.size() >= 2 && text.front() >= '1' && text.front() <= '9' &&
         std::ranges::all_of(text, [](char c) { return digitOf(c) >= 0; });
}

std::optional<std::string_view> textOfLink(std::string_view link) {
  const std::size_t mark = link.rfind(kLinkMark);
  if (mark != std::string_view::npos) {
    const std::string_view text = link.substr(mark + kLinkMark.size());
    return text.substr(0, text.find('&'));  // what follows is about its looks (a poster)
  }
  return isShareText(link) ? std::optional(link) : std::nullopt;
}

Result<Document> readShareText(std::string_view text, ReadNotes* notes, const CopiedPhotos& photos) {
  try {
    return readText(text, notes, photos);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<PhotoCopies> photosInShareText(std::string_view text) {
  try {
    return copiesIn(text);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
