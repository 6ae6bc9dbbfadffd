#include "tests/support/unzip.h"

#include <doctest/doctest.h>

#include <cstdlib>

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_NO_THREAD_LOCALS  // CMakeLists.txt, add_program
#include <stb/stb_image.h>

namespace spineloft::testing {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::uint32_t number(const Bytes& from, std::size_t at, int bytes) {
  REQUIRE(at + std::size_t(bytes) <= from.size());
  std::uint32_t value = 0;
  for (int i = bytes; i-- > 0;) value = value << 8 | from[at + std::size_t(i)];
  return value;
}

/// Bit by bit, so that nothing is shared with the writer's table.
std::uint32_t checksum(const Bytes& bytes) {
  std::uint32_t crc = ~0u;
  for (const std::uint8_t byte : bytes) {
    crc ^= byte;
    for (int k = 0; k < 8; ++k) crc = crc >> 1 ^ ((crc & 1) ? 0xedb88320u : 0u);
  }
  return ~crc;
}

}  // namespace

std::map<std::string, Bytes> unzipped(const Bytes& zip) {
  std::map<std::string, Bytes> out;
  REQUIRE(zip.size() >= 22);
  const std::size_t end = zip.size() - 22;
  REQUIRE(number(zip, end, 4) == 0x06054b50);
  const std::uint32_t count = number(zip, end + 10, 2);
  std::size_t at = number(zip, end + 16, 4);
  CHECK(at + number(zip, end + 12, 4) == end);
  for (std::uint32_t i = 0; i < count; ++i) {
    REQUIRE(number(zip, at, 4) == 0x02014b50);
    const std::uint32_t method = number(zip, at + 10, 2), crc = number(zip, at + 16, 4);
    const std::uint32_t stored = number(zip, at + 20, 4), whole = number(zip, at + 24, 4);
    const std::uint32_t nameLength = number(zip, at + 28, 2), local = number(zip, at + 42, 4);
    const std::string name(zip.begin() + std::ptrdiff_t(at) + 46, zip.begin() + std::ptrdiff_t(at) + 46 + nameLength);
    CAPTURE(name);
    REQUIRE(number(zip, local, 4) == 0x04034b50);
    CHECK(number(zip, local + 8, 2) == method);
    CHECK(number(zip, local + 14, 4) == crc);
    CHECK(number(zip, local + 18, 4) == stored);
    CHECK(number(zip, local + 22, 4) == whole);
    CHECK(number(zip, local + 26, 2) == nameLength);
    const std::size_t data = local + 30 + nameLength + number(zip, local + 28, 2);
    REQUIRE(data + stored <= zip.size());
    Bytes bytes(zip.begin() + std::ptrdiff_t(data), zip.begin() + std::ptrdiff_t(data + stored));
    if (method == 8) {
      int length = 0;
      char* plain =
          stbi_zlib_decode_noheader_malloc(reinterpret_cast<const char*>(bytes.data()), int(bytes.size()), &length);
      REQUIRE(plain != nullptr);
      bytes.assign(plain, plain + length);
      std::free(plain);
    } else {
      CHECK(method == 0);
    }
    CHECK(bytes.size() == whole);
    CHECK(checksum(bytes) == crc);
    out[name] = std::move(bytes);
    at += 46 + nameLength + number(zip, at + 30, 2) + number(zip, at + 32, 2);
  }
  return out;
}

std::vector<std::string> attributes(const std::string& xml, const std::string& element, const std::string& attribute) {
  std::vector<std::string> out;
  const std::string open = "<" + element + " ", key = " " + attribute + "=\"";
  for (std::size_t at = xml.find(open); at != std::string::npos; at = xml.find(open, at + 1)) {
    const std::size_t from = xml.find(key, at), end = xml.find('>', at);
    if (from == std::string::npos || from > end) continue;
    const std::size_t first = from + key.size();
    out.push_back(xml.substr(first, xml.find('"', first) - first));
  }
  return out;
}

}  // namespace spineloft::testing
