#include "engine/io/stl.h"

#include <algorithm>
#include <bit>
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

void putPoint(Bytes& bytes, Point p) {
  for (const double c : {p.x, p.y, p.z}) {
    putNumber(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(c)));
  }
}

Bytes write(std::span<const ExportPart> parts, std::size_t triangles) {
  Bytes bytes;
  bytes.reserve(kHeaderBytes + 4 + triangles * kTriangleBytes);
  bytes.assign(kHeader.begin(), kHeader.end());
  bytes.resize(kHeaderBytes, 0);
  putNumber(bytes, static_cast<std::uint32_t>(triangles));
  for (const ExportPart& part : parts) {
    const auto at = [&](std::uint32_t v) {
      const std::array<double, 3> p = placed(part.placement, part.mesh->positions[v]);
      return Point{p[0], -p[2], p[1]};
    };
    for (const auto& t : part.mesh->triangles) {
      const Point a = at(t[0]), b = at(t[1]), c = at(t[2]);
      putPoint(bytes, normalized(cross(b - a, c - a)));
      putPoint(bytes, a);
      putPoint(bytes, b);
      putPoint(bytes, c);
      bytes.push_back(0);
      bytes.push_back(0);
    }
  }
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
