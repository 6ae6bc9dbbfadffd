#include "engine/io/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <limits>
#include <new>
#include <string_view>

#include "engine/base/vec.h"

namespace spineloft::io {
namespace {

/// Must not begin with "solid", which marks the text form.
constexpr std::string_view kHeader = "SpineLoft: binary STL, millimetres, z up";
constexpr std::size_t kHeaderBytes = 80, kTriangleBytes = 50;

using Point = Vec3<struct StlSpace>;

void putNumber(Bytes& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<std::uint8_t>(value >> shift & 0xff));
  }
}

/// As a reader gets it.
using Corner = std::array<float, 3>;

Corner rounded(Point p) { return {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)}; }

void putCorner(Bytes& bytes, const Corner& corner) {
  for (const float c : corner) putNumber(bytes, std::bit_cast<std::uint32_t>(c));
}

Bytes write(std::span<const ExportPart> parts, std::size_t atMost) {
  Bytes bytes;
  bytes.reserve(kHeaderBytes + 4 + atMost * kTriangleBytes);
  bytes.assign(kHeader.begin(), kHeader.end());
  bytes.resize(kHeaderBytes + 4, 0);
  std::uint32_t triangles = 0;
  for (const ExportPart& part : parts) {
    const auto at = [&](std::uint32_t v) {
      const std::array<double, 3> p = placed(part.placement, part.mesh->positions[v]);
      return Point{p[0], -p[2], p[1]};
    };
    for (const auto& t : part.mesh->triangles) {
      const Point a = at(t[0]), b = at(t[1]), c = at(t[2]);
      const Corner first = rounded(a), second = rounded(b), third = rounded(c);
      // Of two corners in one place: what is beside it meets without it.
      if (first == second || second == third || third == first) continue;
      putCorner(bytes, rounded(normalized(cross(b - a, c - a))));
      putCorner(bytes, first);
      putCorner(bytes, second);
      putCorner(bytes, third);
      bytes.push_back(0);
      bytes.push_back(0);
      ++triangles;
    }
  }
  Bytes count;
  putNumber(count, triangles);
  std::ranges::copy(count, bytes.begin() + static_cast<std::ptrdiff_t>(kHeaderBytes));
  return bytes;
}

}  // namespace

Result<Bytes> writeStl(std::span<const ExportPart> parts) {
  const Status status = checkParts(parts, std::numeric_limits<std::size_t>::max());
  if (!status.ok()) return status.failure();
  std::size_t triangles = 0;
  for (const ExportPart& part : parts) triangles += part.mesh->triangles.size();
  if (triangles > std::numeric_limits<std::uint32_t>::max()) {
    return {Error::OutOfMemory, "too many triangles for STL"};
  }
  try {
    return write(parts, triangles);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
