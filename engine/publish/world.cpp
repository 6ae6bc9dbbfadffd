#include <cctype>
#include <cmath>

#include "engine/publish/publish.h"

namespace spineloft::publish {

std::optional<Format> formatFromKey(std::string_view key) {
  for (const Format format :
       {Format::Glb, Format::Obj, Format::Stl, Format::Project, Format::ObjZip, Format::ThreeMf}) {
    if (key == formatKey(format)) return format;
  }
  return std::nullopt;
}

std::string_view formatKey(Format format) {
  switch (format) {
    case Format::Glb:
      return "glb";
    case Format::Obj:
      return "obj";
    case Format::Stl:
      return "stl";
    case Format::Project:
      return "spineloft";
    case Format::ObjZip:
      return "zip";
    case Format::ThreeMf:
      return "3mf";
  }
  return {};
}

bool holdsDocument(Format format) { return format == Format::Glb || format == Format::Project; }

std::string_view mediaType(Format format) {
  switch (format) {
    case Format::Glb:
      return "model/gltf-binary";
    case Format::Obj:
      return "model/obj";
    case Format::Stl:
      return "model/stl";
    // A GLB, but no browser should give it a GLB's ending.
    case Format::Project:
      return "application/octet-stream";
    case Format::ObjZip:
      return "application/zip";
    case Format::ThreeMf:
      return "model/3mf";
  }
  return {};
}

std::string plainName(const document::Document& document) {
  // Letters and digits stay, everything else becomes single hyphens; other scripts' letters are kept
  // as they are, for every file system of today stores UTF-8.
  std::string name;
  for (const char c : document.name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte)) {
      name += static_cast<char>(byte < 0x80 ? std::tolower(byte) : byte);
    } else if (!name.empty() && name.back() != '-') {
      name += '-';
    }
  }
  while (!name.empty() && name.back() == '-') name.pop_back();
  return name.empty() ? "model" : name;
}

std::string fileName(const document::Document& document, Format format) {
  std::string name = plainName(document);
  if (format == Format::Project) return name + '.' + std::string(formatKey(format));
  // Tenths of a millimetre are as fine as a printer gets.
  const long long tenths = std::llround(document.height.value * 10);
  name += '-' + std::to_string(tenths / 10);
  if (tenths % 10 != 0) name += '.' + std::to_string(tenths % 10);
  return name + (format == Format::ObjZip ? "mm-obj." : "mm.") + std::string(formatKey(format));
}

}  // namespace spineloft::publish
