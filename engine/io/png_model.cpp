#include "engine/io/png_model.h"

#include <algorithm>
#include <array>
#include <optional>

#include "engine/base/crc32.h"

namespace spineloft::io {
namespace {

using Span = std::span<const std::uint8_t>;

constexpr std::array<std::uint8_t, 8> kSignature = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n'};
/// Ancillary, private, safe to copy: its letters' cases say so.
constexpr std::array<std::uint8_t, 4> kModel = {'s', 'p', 'L', 'f'};
constexpr std::array<std::uint8_t, 4> kEnd = {'I', 'E', 'N', 'D'};
constexpr const char* kTakenOut = "some programs take the model out of a picture when they send it";
constexpr std::size_t kMostChunk = 0x7FFFFFFF;
constexpr std::size_t kWord = 4;

std::uint32_t wordAt(Span bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < kWord; ++i) word = word << 8 | bytes[at + i];
  return word;
}

void append(Bytes& out, std::uint32_t word) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::uint8_t>(word >> shift));
}

struct Chunk {
  Span all;   ///< with its length and its checksum; what is there of it
  Span type;  ///< four letters
  Span data;  ///< what is there of it
  bool whole = false;
  bool is(const std::array<std::uint8_t, 4>& letters) const { return std::ranges::equal(type, letters); }
};

/// The chunk at this place; none where no type is there whole.
std::optional<Chunk> chunkAt(Span png, std::size_t at) {
  if (png.size() < at + 2 * kWord) return std::nullopt;
  const std::size_t length = wordAt(png, at), there = png.size() - at - 2 * kWord;
  Chunk chunk;
  chunk.whole = length <= kMostChunk && there >= length + kWord;
  chunk.type = png.subspan(at + kWord, kWord);
  chunk.data = png.subspan(at + 2 * kWord, std::min(length, there));
  chunk.all = png.subspan(at, chunk.whole ? length + 3 * kWord : png.size() - at);
  return chunk;
}

}  // namespace

bool isPng(Span file) {
  return file.size() >= kSignature.size() && std::ranges::equal(file.first(kSignature.size()), kSignature);
}

Result<Bytes> withModel(Span png, Span model) {
  if (!isPng(png)) return Error::PictureUnreadable;
  if (model.size() > kMostChunk || png.size() > kMostChunk - model.size()) return Error::OutOfMemory;
  Bytes out(kSignature.begin(), kSignature.end());
  out.reserve(png.size() + model.size() + 3 * kWord);
  bool placed = false;
  for (std::size_t at = kSignature.size();;) {
    const std::optional<Chunk> chunk = chunkAt(png, at);
    if (!chunk || !chunk->whole) return Error::PictureTruncated;
    if (!chunk->is(kModel)) out.insert(out.end(), chunk->all.begin(), chunk->all.end());
    if (!placed) {
      append(out, static_cast<std::uint32_t>(model.size()));
      const std::size_t summed = out.size();
      out.insert(out.end(), kModel.begin(), kModel.end());
      out.insert(out.end(), model.begin(), model.end());
      append(out, crc32(Span(out).subspan(summed)));
      placed = true;
    }
    if (chunk->is(kEnd)) return out;
    at += chunk->all.size();
  }
}

Result<Span> modelInPng(Span png) {
  if (!isPng(png)) return {Error::NoProjectInside, kTakenOut};
  for (std::size_t at = kSignature.size();;) {
    const std::optional<Chunk> chunk = chunkAt(png, at);
    if (!chunk || chunk->is(kEnd)) return {Error::NoProjectInside, kTakenOut};
    if (chunk->is(kModel)) {
      if (!chunk->whole) return {Error::ProjectInvalid, "cut off"};
      const Span summed = chunk->all.subspan(kWord, chunk->all.size() - 2 * kWord);
      if (crc32(summed) != wordAt(chunk->all, chunk->all.size() - kWord))
        return {Error::ProjectInvalid, "changed on its way"};
      return chunk->data;
    }
    at += chunk->all.size();
  }
}

}  // namespace spineloft::io
