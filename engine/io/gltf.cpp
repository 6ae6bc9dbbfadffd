#include "engine/io/gltf.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <exception>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/image/srgb.h"
#include "engine/io/document_json.h"
#include "engine/io/glb_container.h"

namespace spineloft::io {
namespace {

/// glTF's base colour is linear, ours sRGB (IEC 61966-2-1).
double linear(float srgb) { return image::linearOfSrgb(static_cast<double>(srgb)); }

/// "image/png", "image/jpeg", or empty.
std::string mimeOf(std::span<const std::uint8_t> bytes) {
  constexpr std::uint8_t kPng[] = {0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};
  constexpr std::uint8_t kJpeg[] = {0xff, 0xd8, 0xff};
  const auto begins = [&](std::span<const std::uint8_t> with) {
    return bytes.size() > with.size() && std::equal(with.begin(), with.end(), bytes.begin());
  };
  return begins(kPng) ? "image/png" : begins(kJpeg) ? "image/jpeg" : "";
}

/// Constants of glTF 2.0.
enum Gltf : int {
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
  kArrayBuffer = 34962,
  kElementArrayBuffer = 34963,
  kLinear = 9729,
  kLinearMipmapLinear = 9987,
  kClampToEdge = 33071
};

/// Collects the file's one buffer and everything that points into it.
class Writer {
 public:
  void addPart(const ExportPart& part, std::optional<std::size_t> texture, const GlbOptions& options) {
    mesh::ShadedMesh shaded = mesh::shade(*part.mesh, part.faceted ? 0 : options.creaseAngle);
    for (auto& p : shaded.positions) {
      const std::array<double, 3> at = placed(part.placement, p);
      p = {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
    }
    const std::string name = cleanName(part.name);
    Json attributes = {{"POSITION", positions(shaded.positions)}, {"NORMAL", attribute(shaded.normals, "VEC3")}};
    if (texture) attributes["TEXCOORD_0"] = attribute(shaded.uv, "VEC2");
    Json primitive = {{"attributes", std::move(attributes)},
                      {"indices", indices(shaded)},
                      {"material", material(part, name, texture)}};
    if (part.joins && !root_["meshes"].empty()) {
      root_["meshes"].back()["primitives"].push_back(std::move(primitive));
      return;
    }
    const std::size_t mesh = add("meshes", {{"name", name}, {"primitives", Json::array({std::move(primitive)})}});
    nodes_.push_back(add("nodes", {{"name", name}, {"mesh", mesh}}));
  }

  /// Returns the texture's index.
  std::size_t addPicture(const ExportPicture& picture, const std::string& mime) {
    if (root_["samplers"].empty())
      add("samplers", {{"magFilter", kLinear},
                       {"minFilter", kLinearMipmapLinear},
                       {"wrapS", kClampToEdge},
                       {"wrapT", kClampToEdge}});
    const std::size_t bytes = view(picture.bytes.data(), picture.bytes.size());
    const std::size_t image =
        add("images", {{"name", cleanName(picture.name)}, {"mimeType", mime}, {"bufferView", bytes}});
    return add("textures", {{"sampler", 0}, {"source", image}});
  }

  Result<Bytes> write() {
    root_["asset"] = {{"version", "2.0"}, {"generator", "SpineLoft"}};
    root_["scene"] = 0;
    root_["scenes"] = Json::array({{{"nodes", nodes_}}});
    root_["buffers"] = Json::array({{{"byteLength", binary_.size()}}});
    for (const char* list : {"samplers", "textures", "images"})
      if (root_[list].empty()) root_.erase(list);
    return writeGlbChunks({textOf(root_), binary_});
  }

 private:
  /// Returns the index in the list.
  std::size_t add(const char* list, Json item) {
    root_[list].push_back(std::move(item));
    return root_[list].size() - 1;
  }

  /// Appends bytes to the buffer, aligned to 4 as glTF asks of every accessor here.
  std::size_t view(const void* bytes, std::size_t size, std::optional<Gltf> target = {}) {
    binary_.resize((binary_.size() + 3) / 4 * 4);
    Json view = {{"buffer", 0}, {"byteOffset", binary_.size()}, {"byteLength", size}};
    if (target) view["target"] = *target;
    const auto* first = static_cast<const std::uint8_t*>(bytes);
    binary_.insert(binary_.end(), first, first + size);
    return add("bufferViews", std::move(view));
  }

  template <class T>
  std::size_t attribute(const std::vector<T>& values, const char* type) {
    static_assert(sizeof(T) % 4 == 0);
    const std::size_t bytes = view(values.data(), values.size() * sizeof(T), kArrayBuffer);
    return add("accessors",
               {{"bufferView", bytes}, {"componentType", kFloat}, {"type", type}, {"count", values.size()}});
  }

  std::size_t positions(const std::vector<std::array<float, 3>>& values) {
    const std::size_t index = attribute(values, "VEC3");
    Json& accessor = root_["accessors"][index];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(values.begin(), values.end(),
                                                   [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      accessor["min"].push_back((*low)[axis]);
      accessor["max"].push_back((*high)[axis]);
    }
    return index;
  }

  template <class Index>
  std::size_t indices(const mesh::ShadedMesh& shaded, Gltf component) {
    std::vector<Index> corners;
    corners.reserve(shaded.triangles.size() * 3);
    for (const auto& t : shaded.triangles) {
      for (const std::uint32_t v : t) corners.push_back(static_cast<Index>(v));
    }
    const std::size_t bytes = view(corners.data(), corners.size() * sizeof(Index), kElementArrayBuffer);
    return add("accessors",
               {{"bufferView", bytes}, {"componentType", component}, {"type", "SCALAR"}, {"count", corners.size()}});
  }

  std::size_t indices(const mesh::ShadedMesh& shaded) {
    // 65535 restarts a primitive, so that many vertices still fit.
    return shaded.positions.size() > 65535 ? indices<std::uint32_t>(shaded, kUnsignedInt)
                                           : indices<std::uint16_t>(shaded, kUnsignedShort);
  }

  std::size_t material(const ExportPart& part, const std::string& name, std::optional<std::size_t> texture) {
    Json surface = {{"metallicFactor", part.metallic}, {"roughnessFactor", part.roughness}};
    if (texture) {
      surface["baseColorTexture"] = {{"index", *texture}};
    } else {
      surface["baseColorFactor"] = {linear(part.colour[0]), linear(part.colour[1]), linear(part.colour[2]), 1};
    }
    return add("materials", {{"name", name}, {"pbrMetallicRoughness", std::move(surface)}});
  }

  Json root_;
  std::vector<std::size_t> nodes_;
  Bytes binary_;
};

Result<Bytes> write(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures,
                    const GlbOptions& options) {
  Writer writer;
  std::vector<std::optional<std::size_t>> textures(pictures.size());
  for (const ExportPart& part : parts) {
    std::optional<std::size_t> texture;
    if (part.picture) {
      const ExportPicture& picture = pictures[*part.picture];
      const std::string mime = mimeOf(picture.bytes);
      if (mime.empty()) return {Error::PictureUnreadable, cleanName(picture.name)};
      std::optional<std::size_t>& known = textures[*part.picture];
      if (!known) known = writer.addPicture(picture, mime);
      texture = known;
    }
    writer.addPart(part, texture, options);
  }
  return writer.write();
}

}  // namespace

Result<Bytes> writeGlb(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures,
                       const GlbOptions& options) {
  if (const Status status = checkParts(parts, pictures.size()); !status.ok()) {
    return status.failure();
  }
  if (!(options.creaseAngle >= 0 && options.creaseAngle <= std::numbers::pi)) {
    return {Error::ValueOutOfRange, "crease angle"};
  }
  try {
    return write(parts, pictures, options);
  } catch (const std::exception&) {  // the JSON library and the standard one only throw for memory
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
