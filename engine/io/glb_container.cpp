#include "engine/io/glb_container.h"

#include <algorithm>
#include <cstddef>
#include <limits>

namespace spineloft::io {
namespace {

constexpr std::uint32_t kMagic = 0x46546c67;  // "glTF"
constexpr std::uint32_t kVersion = 2;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;    // "JSON"
constexpr std::uint32_t kBinaryChunk = 0x004e4942;  // "BIN\0"
constexpr std::size_t kHeader = 12, kChunkHeader = 8;

std::uint32_t wordAt(std::span<const std::uint8_t> bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 4; i > 0; --i) word = word << 8 | bytes[at + i - 1];
  return word;
}

void append(Bytes& out, std::uint32_t word) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<std::uint8_t>(word >> (8 * i)));
}

struct Chunk {
  std::uint32_t type = 0;
  std::span<const std::uint8_t> bytes;
};

/// Takes the first chunk off `rest`; none when it does not fit.
std::optional<Chunk> takeChunk(std::span<const std::uint8_t>& rest) {
  if (rest.size() < kChunkHeader) return std::nullopt;
  const std::size_t length = wordAt(rest, 0);
  if (length > rest.size() - kChunkHeader) return std::nullopt;
  const Chunk chunk{wordAt(rest, 4), rest.subspan(kChunkHeader, length)};
  rest = rest.subspan(kChunkHeader + length);
  return chunk;
}

constexpr std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

}  // namespace

std::optional<GlbChunks> readGlbChunks(std::span<const std::uint8_t> glb) {
  if (glb.size() < kHeader || wordAt(glb, 0) != kMagic || wordAt(glb, 4) != kVersion) {
    return std::nullopt;
  }
  const std::size_t length = wordAt(glb, 8);
  if (length < kHeader || length > glb.size()) return std::nullopt;
  std::span<const std::uint8_t> rest = glb.subspan(kHeader, length - kHeader);
  const std::optional<Chunk> json = takeChunk(rest);
  if (!json || json->type != kJsonChunk) return std::nullopt;
  GlbChunks chunks;
  chunks.json = {reinterpret_cast<const char*>(json->bytes.data()), json->bytes.size()};
  if (rest.empty()) return chunks;
  const std::optional<Chunk> binary = takeChunk(rest);
  if (!binary) return std::nullopt;
  if (binary->type == kBinaryChunk) chunks.binary = binary->bytes;
  return chunks;
}

bool isCutOff(std::span<const std::uint8_t> glb) {
  if (glb.size() < 4 || wordAt(glb, 0) != kMagic) return false;
  return glb.size() < kHeader || wordAt(glb, 8) > glb.size();
}

std::string_view jsonOfGlb(std::span<const std::uint8_t> glb) {
  constexpr std::size_t kFront = kHeader + kChunkHeader;
  if (glb.size() < kFront || wordAt(glb, 0) != kMagic || wordAt(glb, kHeader + 4) != kJsonChunk) {
    return {};
  }
  const std::size_t length = std::min<std::size_t>(wordAt(glb, kHeader), glb.size() - kFront);
  return {reinterpret_cast<const char*>(glb.data()) + kFront, length};
}

Result<Bytes> writeGlbChunks(const GlbChunks& chunks) {
  const std::size_t json = padded(chunks.json.size()), binary = padded(chunks.binary.size());
  const std::uint64_t total = std::uint64_t{kHeader} + kChunkHeader + json + (binary > 0 ? kChunkHeader + binary : 0);
  if (total > std::numeric_limits<std::uint32_t>::max()) {
    return {Error::OutOfMemory, "GLB over 4 GiB"};
  }
  Bytes out;
  out.reserve(static_cast<std::size_t>(total));
  for (const std::uint32_t word :
       {kMagic, kVersion, static_cast<std::uint32_t>(total), static_cast<std::uint32_t>(json), kJsonChunk}) {
    append(out, word);
  }
  out.insert(out.end(), chunks.json.begin(), chunks.json.end());
  out.resize(kHeader + kChunkHeader + json, ' ');
  if (binary == 0) return out;
  append(out, static_cast<std::uint32_t>(binary));
  append(out, kBinaryChunk);
  out.insert(out.end(), chunks.binary.begin(), chunks.binary.end());
  out.resize(static_cast<std::size_t>(total), 0);
  return out;
}

}  // namespace spineloft::io
