#include "engine/io/zip.h"

#include <cstdlib>
#include <limits>
#include <memory>
#include <new>

#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

#include "engine/base/crc32.h"

namespace spineloft::io {
namespace {

constexpr std::size_t kLargest = std::size_t{1} << 31;
/// As hard as stb tries by default.
constexpr int kEffort = 8;
constexpr std::uint16_t kVersion = 20;        ///< 2.0: DEFLATE and folders
constexpr std::uint16_t kUtf8 = 1u << 11;     ///< names are UTF-8
constexpr std::uint16_t kDate = 1u << 5 | 1;  ///< 1 January 1980

struct FreeBytes {
  void operator()(std::uint8_t* bytes) const { std::free(bytes); }
};

void put16(Bytes& out, std::uint32_t value) {
  out.push_back(static_cast<std::uint8_t>(value & 0xff));
  out.push_back(static_cast<std::uint8_t>(value >> 8 & 0xff));
}
void put32(Bytes& out, std::uint32_t value) {
  put16(out, value & 0xffff);
  put16(out, value >> 16);
}

/// Raw DEFLATE; empty when it would not be smaller.
Bytes deflated(std::span<const std::uint8_t> bytes) {
  int length = 0;
  // stb reads only, but says otherwise.
  auto* data = const_cast<unsigned char*>(bytes.data());
  const std::unique_ptr<std::uint8_t, FreeBytes> zlib(
      stbi_zlib_compress(data, static_cast<int>(bytes.size()), &length, kEffort));
  if (!zlib) throw std::bad_alloc();
  constexpr int kHead = 2, kTail = 4;  // of zlib's own wrapping
  const auto size = static_cast<std::size_t>(length - kHead - kTail);
  if (length <= kHead + kTail || size >= bytes.size()) return {};
  return Bytes(zlib.get() + kHead, zlib.get() + kHead + size);
}

/// What the local header and the directory say alike.
struct Member {
  std::uint32_t crc, stored, whole, offset;
  std::uint16_t method;
  const std::string* name;
};

void putFields(Bytes& out, const Member& member) {
  put16(out, kVersion);
  put16(out, kUtf8);
  put16(out, member.method);
  put16(out, 0);  // midnight
  put16(out, kDate);
  put32(out, member.crc);
  put32(out, member.stored);
  put32(out, member.whole);
  put16(out, static_cast<std::uint32_t>(member.name->size()));
  put16(out, 0);  // no extra fields
}

void append(Bytes& out, const std::string& text) { out.insert(out.end(), text.begin(), text.end()); }

Bytes write(std::span<const ZipEntry> files) {
  Bytes out;
  std::vector<Member> members;
  for (const ZipEntry& file : files) {
    const Bytes squeezed = file.squeeze ? deflated(file.bytes) : Bytes{};
    const std::span<const std::uint8_t> stored = squeezed.empty() ? file.bytes : squeezed;
    const Member member{crc32(file.bytes),
                        static_cast<std::uint32_t>(stored.size()),
                        static_cast<std::uint32_t>(file.bytes.size()),
                        static_cast<std::uint32_t>(out.size()),
                        static_cast<std::uint16_t>(squeezed.empty() ? 0 : 8),
                        &file.name};
    put32(out, 0x04034b50);
    putFields(out, member);
    append(out, file.name);
    out.insert(out.end(), stored.begin(), stored.end());
    members.push_back(member);
  }
  const std::size_t directory = out.size();
  for (const Member& member : members) {
    put32(out, 0x02014b50);
    put16(out, kVersion);
    putFields(out, member);
    put16(out, 0);  // no comment
    put16(out, 0);  // first disk
    put16(out, 0);
    put32(out, 0);
    put32(out, member.offset);
    append(out, *member.name);
  }
  const auto length = static_cast<std::uint32_t>(out.size() - directory);
  const auto count = static_cast<std::uint32_t>(members.size());
  put32(out, 0x06054b50);
  put32(out, 0);
  put16(out, count);
  put16(out, count);
  put32(out, length);
  put32(out, static_cast<std::uint32_t>(directory));
  put16(out, 0);
  return out;
}

}  // namespace

Result<Bytes> writeZip(std::span<const ZipEntry> files) {
  std::size_t total = 0;
  for (const ZipEntry& file : files) {
    if (file.name.size() > 0xffff || file.bytes.size() > kLargest - 1) return Error::OutOfMemory;
    total += file.bytes.size() + 2 * file.name.size() + 128;
    if (total > kLargest) return {Error::OutOfMemory, "over 2 GiB"};
  }
  if (files.size() > 0xffff) return Error::OutOfMemory;
  try {
    return write(files);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
