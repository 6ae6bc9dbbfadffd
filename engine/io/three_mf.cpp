#include "engine/io/three_mf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/picture_file.h"
#include "engine/io/text_file.h"
#include "engine/io/zip.h"

namespace spineloft::io {
namespace {

constexpr std::string_view kHead = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
constexpr std::size_t kMaterials = 1, kFirstFree = 2;

using Point = std::array<double, 3>;

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : cleanName(text)) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

std::string hexOf(const std::array<float, 3>& colour) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string out = "#";
  for (const float c : colour) {
    const auto value = static_cast<std::size_t>(std::lround(std::clamp(c, 0.f, 1.f) * 255.f));
    out += kDigits[value >> 4];
    out += kDigits[value & 15];
  }
  return out;
}

/// A picture of the package.
struct Texture {
  std::string path, type;
  std::span<const std::uint8_t> bytes;
};

/// The model's own XML, from resources to build.
class Model {
 public:
  Model(std::span<const ExportPart> parts, std::span<const Texture> textures)
      : parts_(parts), textures_(textures), text_(expected(parts)) {}

  Bytes write() {
    text_.add(kHead).add(
        "<model unit=\"millimeter\" xml:lang=\"en-US\" "
        "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" "
        "xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\">\n"
        " <metadata name=\"Application\">SpineLoft</metadata>\n <resources>\n");
    materials();
    for (std::size_t i = 0; i < textures_.size(); ++i) texture(textures_[i], kFirstFree + i);
    std::size_t next = kFirstFree + textures_.size();
    const Point low = lowest();
    std::vector<std::size_t> objects;
    for (std::size_t i = 0; i < parts_.size(); ++i) {
      std::optional<std::size_t> group;
      if (parts_[i].picture) {
        group = next++;
        coordinates(parts_[i], *group);
      }
      objects.push_back(next);
      object(i, next++, group, low);
    }
    text_.add("  <object id=\"").add(next).add("\" type=\"model\">\n   <components>\n");
    for (const std::size_t id : objects) text_.add("    <component objectid=\"").add(id).add("\"/>\n");
    text_.add("   </components>\n  </object>\n </resources>\n <build>\n  <item objectid=\"");
    text_.add(next).add("\"/>\n </build>\n</model>\n");
    return text_.take();
  }

 private:
  static std::size_t expected(std::span<const ExportPart> parts) {
    std::size_t bytes = 2048;
    for (const ExportPart& part : parts) {
      bytes += part.mesh->positions.size() * 110 + part.mesh->triangles.size() * 80;
    }
    return bytes;
  }

  static Point standing(const ExportPart& part, const std::array<float, 3>& position) {
    const Point p = placed(part.placement, position);
    return {p[0], -p[2], p[1]};
  }

  Point lowest() const {
    constexpr double kFar = std::numeric_limits<double>::infinity();
    Point low{kFar, kFar, kFar};
    for (const ExportPart& part : parts_) {
      for (const auto& position : part.mesh->positions) {
        const Point p = standing(part, position);
        for (std::size_t i = 0; i < 3; ++i) low[i] = std::min(low[i], p[i]);
      }
    }
    return low;
  }

  void materials() {
    text_.add("  <basematerials id=\"").add(kMaterials).add("\">\n");
    for (const ExportPart& part : parts_) {
      text_.add("   <base name=\"").add(escaped(part.name)).add("\" displaycolor=\"");
      text_.add(hexOf(part.colour)).add("\"/>\n");
    }
    text_.add("  </basematerials>\n");
  }

  void texture(const Texture& texture, std::size_t id) {
    text_.add("  <m:texture2d id=\"").add(id).add("\" path=\"/").add(texture.path);
    text_.add("\" contenttype=\"").add(texture.type);
    text_.add("\" tilestyleu=\"clamp\" tilestylev=\"clamp\"/>\n");
  }

  void coordinates(const ExportPart& part, std::size_t id) {
    text_.add("  <m:texture2dgroup id=\"").add(id).add("\" texid=\"");
    text_.add(kFirstFree + *part.picture).add("\">\n");
    for (const auto& uv : part.mesh->uv) {
      text_.add("   <m:tex2coord u=\"").add(static_cast<double>(uv[0])).add("\" v=\"");
      text_.add(1.0 - static_cast<double>(uv[1])).add("\"/>\n");
    }
    text_.add("  </m:texture2dgroup>\n");
  }

  void object(std::size_t index, std::size_t id, std::optional<std::size_t> group, const Point& low) {
    const ExportPart& part = parts_[index];
    text_.add("  <object id=\"").add(id).add("\" name=\"").add(escaped(part.name));
    text_.add("\" type=\"model\" pid=\"").add(kMaterials).add("\" pindex=\"").add(index);
    text_.add("\">\n   <mesh>\n    <vertices>\n");
    for (const auto& position : part.mesh->positions) {
      const Point p = standing(part, position);
      text_.add("     <vertex x=\"").add(p[0] - low[0]).add("\" y=\"").add(p[1] - low[1]);
      text_.add("\" z=\"").add(p[2] - low[2]).add("\"/>\n");
    }
    text_.add("    </vertices>\n    <triangles>\n");
    for (const auto& [a, b, c] : part.mesh->triangles) {
      text_.add("     <triangle v1=\"").add(std::size_t{a}).add("\" v2=\"").add(std::size_t{b});
      text_.add("\" v3=\"").add(std::size_t{c});
      if (group) {
        text_.add("\" pid=\"").add(*group).add("\" p1=\"").add(std::size_t{a}).add("\" p2=\"");
        text_.add(std::size_t{b}).add("\" p3=\"").add(std::size_t{c});
      }
      text_.add("\"/>\n");
    }
    text_.add("    </triangles>\n   </mesh>\n  </object>\n");
  }

  std::span<const ExportPart> parts_;
  std::span<const Texture> textures_;
  TextFile text_;
};

Bytes bytesOf(const std::string& text) { return Bytes(text.begin(), text.end()); }

Bytes contentTypes() {
  return bytesOf(std::string(kHead) +
                 "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">\n"
                 " <Default Extension=\"rels\" "
                 "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>\n"
                 " <Default Extension=\"model\" "
                 "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>\n"
                 " <Default Extension=\"png\" ContentType=\"image/png\"/>\n"
                 " <Default Extension=\"jpg\" ContentType=\"image/jpeg\"/>\n</Types>\n");
}

Bytes relationships(std::string_view type, const std::vector<std::string>& targets) {
  std::string text = std::string(kHead) +
                     "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n";
  for (std::size_t i = 0; i < targets.size(); ++i) {
    text += " <Relationship Id=\"rel" + std::to_string(i + 1) + "\" Target=\"/" + targets[i] + "\" Type=\"" +
            std::string(type) + "\"/>\n";
  }
  return bytesOf(text + "</Relationships>\n");
}

Result<Bytes> write(std::span<const ExportPart> given, std::span<const ExportPicture> pictures) {
  // Only what is used goes in, numbered anew.
  std::vector<ExportPart> parts(given.begin(), given.end());
  std::vector<Texture> textures;
  std::vector<std::string> paths;
  std::vector<std::optional<std::size_t>> places(pictures.size());
  for (ExportPart& part : parts) {
    if (!part.picture) continue;
    std::optional<std::size_t>& place = places[*part.picture];
    if (!place) {
      const ExportPicture& picture = pictures[*part.picture];
      const Result<PictureInfo> info = probePicture(picture.bytes);
      const bool png = info && info.value().format == PictureFormat::Png;
      if (!png && !(info && info.value().format == PictureFormat::Jpeg)) {
        return {Error::PictureUnreadable, cleanName(picture.name)};
      }
      place = textures.size();
      paths.push_back("3D/Textures/" + std::to_string(textures.size() + 1) + (png ? ".png" : ".jpg"));
      textures.push_back({paths.back(), png ? "image/png" : "image/jpeg", picture.bytes});
    }
    part.picture = place;
  }
  const Bytes types = contentTypes(), model = Model(parts, textures).write();
  const Bytes toModel = relationships("http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel",
                                      {"3D/3dmodel.model"});
  const Bytes toTextures =
      relationships("http://schemas.microsoft.com/3dmanufacturing/2013/01/3dtexture", paths);
  std::vector<ZipEntry> files = {{"[Content_Types].xml", types},
                                 {"_rels/.rels", toModel},
                                 {"3D/3dmodel.model", model}};
  if (!textures.empty()) files.push_back({"3D/_rels/3dmodel.model.rels", toTextures});
  for (const Texture& texture : textures) files.push_back({texture.path, texture.bytes, false});
  return writeZip(files);
}

}  // namespace

Result<Bytes> write3mf(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures) {
  if (const Status status = checkParts(parts, pictures.size()); !status.ok()) return status.failure();
  try {
    return write(parts, pictures);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
