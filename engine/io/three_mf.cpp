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
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
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

/// Parts [first, last) that are one thing: faces of one solid, or a part of its own.
struct Thing {
  std::size_t first = 0, last = 0;
};

std::vector<Thing> thingsOf(std::span<const ExportPart> parts) {
  std::vector<Thing> things;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const bool goesOn = i > 0 && parts[i].joins && parts[i].placement == parts[i - 1].placement;
    if (goesOn)
      things.back().last = i + 1;
    else
      things.push_back({i, i + 1});
  }
  return things;
}

/// The vertices of a thing, each place once where its parts are closed only together: readers go by numbers.
struct Corners {
  std::vector<std::array<float, 3>> places;
  std::vector<std::vector<std::size_t>> numbers;  ///< of the vertices of each part
};

Corners cornersOf(std::span<const ExportPart> parts) {
  Corners out;
  const bool weld = parts.front().ofSolid;
  for (const ExportPart& part : parts) {
    out.places.insert(out.places.end(), part.mesh->positions.begin(), part.mesh->positions.end());
  }
  if (weld) {
    std::ranges::sort(out.places);
    const auto rest = std::ranges::unique(out.places);
    out.places.erase(rest.begin(), rest.end());
  }
  std::size_t next = 0;
  for (const ExportPart& part : parts) {
    std::vector<std::size_t>& numbers = out.numbers.emplace_back();
    for (const auto& position : part.mesh->positions) {
      const auto at = weld ? std::ranges::lower_bound(out.places, position) : out.places.begin();
      numbers.push_back(weld ? static_cast<std::size_t>(at - out.places.begin()) : next++);
    }
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
    groups_.resize(parts_.size());
    for (const Thing thing : thingsOf(parts_)) {
      for (std::size_t i = thing.first; i < thing.last; ++i) {
        if (!parts_[i].picture) continue;
        groups_[i] = next++;
        coordinates(parts_[i], *groups_[i]);
      }
      objects.push_back(next);
      object(thing, next++, low);
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

  void object(const Thing& thing, std::size_t id, const Point& low) {
    const ExportPart& part = parts_[thing.first];
    const Corners corners = cornersOf(parts_.subspan(thing.first, thing.last - thing.first));
    text_.add("  <object id=\"").add(id).add("\" name=\"").add(escaped(part.name));
    text_.add("\" type=\"model\" pid=\"").add(kMaterials).add("\" pindex=\"").add(thing.first);
    text_.add("\">\n   <mesh>\n    <vertices>\n");
    for (const auto& place : corners.places) {
      const Point p = standing(part, place);
      text_.add("     <vertex x=\"").add(p[0] - low[0]).add("\" y=\"").add(p[1] - low[1]);
      text_.add("\" z=\"").add(p[2] - low[2]).add("\"/>\n");
    }
    text_.add("    </vertices>\n    <triangles>\n");
    for (std::size_t i = thing.first; i < thing.last; ++i) {
      triangles(i, corners.numbers[i - thing.first], i > thing.first);
    }
    text_.add("    </triangles>\n   </mesh>\n  </object>\n");
  }

  /// `named`: they do not look as the object does by itself.
  void triangles(std::size_t index, std::span<const std::size_t> numbers, bool named) {
    for (const auto& corners : parts_[index].mesh->triangles) {
      const std::size_t a = numbers[corners[0]], b = numbers[corners[1]], c = numbers[corners[2]];
      // Of two corners in one place: what is beside it meets without it, and the format forbids it.
      if (a == b || b == c || c == a) continue;
      text_.add("     <triangle v1=\"").add(a).add("\" v2=\"").add(b).add("\" v3=\"").add(c);
      if (groups_[index]) {
        text_.add("\" pid=\"").add(*groups_[index]).add("\" p1=\"").add(std::size_t{corners[0]});
        text_.add("\" p2=\"").add(std::size_t{corners[1]}).add("\" p3=\"").add(std::size_t{corners[2]});
      } else if (named) {
        text_.add("\" pid=\"").add(kMaterials).add("\" p1=\"").add(index);
      }
      text_.add("\"/>\n");
    }
  }

  std::span<const ExportPart> parts_;
  std::span<const Texture> textures_;
  std::vector<std::optional<std::size_t>> groups_;  ///< of texture coordinates, of each part
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
  std::string text =
      std::string(kHead) + "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">\n";
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
  const Bytes toModel =
      relationships("http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel", {"3D/3dmodel.model"});
  const Bytes toTextures = relationships("http://schemas.microsoft.com/3dmanufacturing/2013/01/3dtexture", paths);
  std::vector<ZipEntry> files = {{"[Content_Types].xml", types}, {"_rels/.rels", toModel}, {"3D/3dmodel.model", model}};
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
