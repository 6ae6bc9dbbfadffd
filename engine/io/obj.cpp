#include "engine/io/obj.h"

#include <limits>
#include <new>
#include <string>
#include <vector>

#include "engine/io/picture_file.h"
#include "engine/io/text_file.h"
#include "engine/io/zip.h"

namespace spineloft::io {
namespace {

/// Name of a part's material.
std::string materialOf(std::size_t part) { return std::string("part-").append(std::to_string(part + 1)); }

/// `materials`: the name of the file that holds them, or empty.
Bytes write(std::span<const ExportPart> parts, ObjSpace space, const std::string& materials) {
  const bool image = space == ObjSpace::Image;
  std::size_t expected = 256;
  for (const ExportPart& part : parts) {
    expected += part.mesh->positions.size() * 64 + part.mesh->triangles.size() * 48;
  }
  TextFile text(expected);
  text.add("# SpineLoft\n");
  text.add(image ? "# x right, y down, z to the viewer: picture pixels\n" : "# x right, y up, z to the viewer\n");
  if (!materials.empty()) text.add("mtllib ").add(materials).add("\n");
  std::size_t firstVertex = 1, firstUv = 1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ExportPart& part = parts[i];
    const mesh::TriMesh& mesh = *part.mesh;
    text.add("o ").add(cleanName(part.name)).add("\n");
    if (!materials.empty()) text.add("usemtl ").add(materialOf(i)).add("\n");
    for (const auto& position : mesh.positions) {
      const std::array<double, 3> p = placed(part.placement, position);
      text.add("v ").add(p[0]).add(" ").add(image ? -p[1] : p[1]).add(" ").add(p[2]).add("\n");
    }
    for (const auto& uv : mesh.uv) {
      text.add("vt ").add(static_cast<double>(uv[0])).add(" ");
      text.add(1.0 - static_cast<double>(uv[1])).add("\n");
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

Bytes materialsOf(std::span<const ExportPart> parts, const std::vector<std::string>& pictures) {
  TextFile text;
  text.add("# SpineLoft\n");
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ExportPart& part = parts[i];
    text.add("newmtl ").add(materialOf(i)).add("\nKd");
    for (const float c : part.colour) text.add(" ").add(part.picture ? 1.0 : static_cast<double>(c));
    // Blinn and Phong's exponent of a rough surface, as the usual converters take it.
    text.add("\nKs 0.04 0.04 0.04\nNs ").add(1000 * (1 - part.roughness) * (1 - part.roughness));
    text.add("\nPr ").add(part.roughness).add("\nPm ").add(part.metallic).add("\nillum 2\n");
    if (part.picture) text.add("map_Kd ").add(pictures[*part.picture]).add("\n");
  }
  return text.take();
}

Result<Bytes> writeZipped(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures,
                          const std::string& name) {
  std::vector<std::string> files;
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const Result<PictureInfo> info = probePicture(pictures[i].bytes);
    if (!info || !isDecoded(info.value().format)) return {Error::PictureUnreadable, cleanName(pictures[i].name)};
    const std::string number = pictures.size() > 1 ? std::string("-").append(std::to_string(i + 1)) : "";
    files.push_back(name + number + (info.value().format == PictureFormat::Png ? ".png" : ".jpg"));
  }
  const Bytes model = write(parts, ObjSpace::World, name + ".mtl");
  const Bytes materials = materialsOf(parts, files);
  std::vector<ZipEntry> entries = {{name + ".obj", model}, {name + ".mtl", materials}};
  for (std::size_t i = 0; i < pictures.size(); ++i) entries.push_back({files[i], pictures[i].bytes, false});
  return writeZip(entries);
}

}  // namespace

Result<Bytes> writeObj(std::span<const ExportPart> parts, ObjSpace space) {
  const Status status = checkParts(parts, std::numeric_limits<std::size_t>::max());
  if (!status.ok()) return status.failure();
  try {
    return write(parts, space, {});
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<Bytes> writeObjZip(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures,
                          const std::string& name) {
  const Status status = checkParts(parts, pictures.size());
  if (!status.ok()) return status.failure();
  try {
    return writeZipped(parts, pictures, name);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
