#include "engine/io/obj.h"

#include <charconv>
#include <limits>
#include <new>
#include <string>
#include <string_view>

namespace spineloft::io {
namespace {

class Text {
 public:
  explicit Text(std::size_t expected) { bytes_.reserve(expected); }
  Text& add(std::string_view text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }
  /// A space and the number; the same in every locale.
  Text& add(double value) {
    char digits[64];
    float number = static_cast<float>(value);
    if (number == 0) number = 0;  // not "-0"
    const auto end =
        std::to_chars(digits, digits + sizeof digits, number, std::chars_format::fixed);
    return add(" ").add(std::string_view(digits, static_cast<std::size_t>(end.ptr - digits)));
  }
  Text& add(std::size_t value) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    return add(std::string_view(digits, static_cast<std::size_t>(end.ptr - digits)));
  }
  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

Bytes write(std::span<const ExportPart> parts, ObjSpace space) {
  const bool image = space == ObjSpace::Image;
  std::size_t expected = 256;
  for (const ExportPart& part : parts) {
    expected += part.mesh->positions.size() * 64 + part.mesh->triangles.size() * 48;
  }
  Text text(expected);
  text.add("# SpineLoft\n");
  text.add(image ? "# x right, y down, z to the viewer: picture pixels\n"
                 : "# x right, y up, z to the viewer\n");
  std::size_t firstVertex = 1, firstUv = 1;
  for (const ExportPart& part : parts) {
    const mesh::TriMesh& mesh = *part.mesh;
    text.add("o ").add(cleanName(part.name)).add("\n");
    for (const auto& position : mesh.positions) {
      const std::array<double, 3> p = placed(part.placement, position);
      text.add("v").add(p[0]).add(image ? -p[1] : p[1]).add(p[2]).add("\n");
    }
    for (const auto& uv : mesh.uv) {
      text.add("vt")
          .add(static_cast<double>(uv[0]))
          .add(1.0 - static_cast<double>(uv[1]))
          .add("\n");
    }
    const auto corner = [&](std::uint32_t v) {
      text.add(" ").add(firstVertex + v);
      if (!mesh.uv.empty()) text.add("/").add(firstUv + v);
    };
    for (const auto& [a, b, c] : mesh.triangles) {
      text.add("f");
      corner(a);
      corner(image ? c : b);
      corner(image ? b : c);
      text.add("\n");
    }
    firstVertex += mesh.positions.size();
    firstUv += mesh.uv.size();
  }
  return text.take();
}

}  // namespace

Result<Bytes> writeObj(std::span<const ExportPart> parts, ObjSpace space) {
  const Status status = checkParts(parts, std::numeric_limits<std::size_t>::max());
  if (!status.ok()) return status.failure();
  try {
    return write(parts, space);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
