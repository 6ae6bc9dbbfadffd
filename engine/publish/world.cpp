#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "engine/publish/publish.h"

namespace spineloft::publish {

WorldFrame worldFrame(image::Size picture) {
  // Pixel centres are at integers, so that the picture spans −½ … size − ½.
  const double width = std::max(1, picture.width), height = std::max(1, picture.height);
  return {1 / std::max(width, height), {(width - 1) / 2, -(height - 1) / 2, 0}};
}

std::optional<WorldBounds> worldBounds(const document::Document& document,
                                       const pipeline::Derived& derived) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  WorldBounds bounds{{kFar, kFar, kFar}, {-kFar, -kFar, -kFar}};
  bool any = false;
  for (const pipeline::DerivedPart& shown : derived.parts) {
    const document::Part* part = document::findPart(document, shown.id);
    if (part == nullptr || !part->visible || !shown.shape) continue;
    const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
    if (entry == nullptr) continue;
    const WorldFrame frame = worldFrame(entry->size);
    for (const auto& p : shown.shape->mesh.positions) {
      const WorldPoint w = frame.toWorld({p[0], p[1], p[2]});
      bounds.low = {std::min(bounds.low.x, w.x), std::min(bounds.low.y, w.y),
                    std::min(bounds.low.z, w.z)};
      bounds.high = {std::max(bounds.high.x, w.x), std::max(bounds.high.y, w.y),
                     std::max(bounds.high.z, w.z)};
      any = true;
    }
  }
  if (!any) return std::nullopt;
  return bounds;
}

std::optional<Format> formatFromKey(std::string_view key) {
  for (const Format format : {Format::Glb, Format::Obj, Format::Stl, Format::Project}) {
    if (key == formatKey(format)) return format;
  }
  return std::nullopt;
}

std::string_view formatKey(Format format) {
  switch (format) {
    case Format::Glb: return "glb";
    case Format::Obj: return "obj";
    case Format::Stl: return "stl";
    case Format::Project: return "spineloft";
  }
  return {};
}

std::string_view mediaType(Format format) {
  switch (format) {
    case Format::Glb: return "model/gltf-binary";
    case Format::Obj: return "model/obj";
    case Format::Stl: return "model/stl";
    // A GLB, but no browser should give it a GLB's ending.
    case Format::Project: return "application/octet-stream";
  }
  return {};
}

std::string fileName(const document::Document& document, Format format) {
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
  if (name.empty()) name = "model";
  if (format == Format::Project) return name + '.' + std::string(formatKey(format));
  // Tenths of a millimetre are as fine as a printer gets.
  const long long tenths = std::llround(document.height.value * 10);
  name += '-' + std::to_string(tenths / 10);
  if (tenths % 10 != 0) name += '.' + std::to_string(tenths % 10);
  return name + "mm." + std::string(formatKey(format));
}

}  // namespace spineloft::publish
