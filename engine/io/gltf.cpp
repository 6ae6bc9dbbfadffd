#include "engine/io/gltf.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <numbers>
#include <sstream>
#include <string>

#define TINYGLTF_IMPLEMENTATION
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#include <tiny_gltf.h>

namespace spineloft::io {
namespace {

/// glTF's base colour is linear, ours sRGB (IEC 61966-2-1).
double linear(float srgb) {
  const double c = static_cast<double>(srgb);
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// "image/png", "image/jpeg", or empty.
std::string mimeOf(std::span<const std::uint8_t> bytes) {
  constexpr std::uint8_t kPng[] = {0x89, 'P', 'N', 'G', 0x0d, 0x0a, 0x1a, 0x0a};
  constexpr std::uint8_t kJpeg[] = {0xff, 0xd8, 0xff};
  const auto begins = [&](std::span<const std::uint8_t> with) {
    return bytes.size() > with.size() && std::equal(with.begin(), with.end(), bytes.begin());
  };
  return begins(kPng) ? "image/png" : begins(kJpeg) ? "image/jpeg" : "";
}

/// Collects the file's one buffer and everything that points into it.
class Writer {
 public:
  Writer() {
    model_.asset.version = "2.0";
    model_.asset.generator = "SpineLoft";
    model_.buffers.emplace_back();
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
  }

  void addPart(const ExportPart& part, int texture, const GlbOptions& options) {
    mesh::ShadedMesh shaded = mesh::shade(*part.mesh, part.faceted ? 0 : options.creaseAngle);
    for (auto& p : shaded.positions) {
      const std::array<double, 3> at = placed(part.placement, p);
      p = {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
    }
    const std::string name = cleanName(part.name);
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.attributes["POSITION"] = positions(shaded.positions);
    primitive.attributes["NORMAL"] = attribute(shaded.normals, TINYGLTF_TYPE_VEC3);
    if (texture >= 0) primitive.attributes["TEXCOORD_0"] = attribute(shaded.uv, TINYGLTF_TYPE_VEC2);
    primitive.indices = indices(shaded);
    primitive.material = material(part, name, texture);
    if (part.joins && !model_.meshes.empty()) {
      model_.meshes.back().primitives.push_back(std::move(primitive));
      return;
    }
    tinygltf::Mesh mesh;
    mesh.name = name;
    mesh.primitives.push_back(std::move(primitive));
    model_.meshes.push_back(std::move(mesh));
    tinygltf::Node node;
    node.name = name;
    node.mesh = static_cast<int>(model_.meshes.size() - 1);
    model_.nodes.push_back(std::move(node));
    model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size() - 1));
  }

  /// Returns the texture's index.
  int addPicture(const ExportPicture& picture, const std::string& mime) {
    if (model_.samplers.empty()) {
      tinygltf::Sampler sampler;
      sampler.magFilter = TINYGLTF_TEXTURE_FILTER_LINEAR;
      sampler.minFilter = TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR;
      sampler.wrapS = sampler.wrapT = TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE;
      model_.samplers.push_back(sampler);
    }
    tinygltf::Image image;
    image.name = cleanName(picture.name);
    image.mimeType = mime;
    image.bufferView = view(picture.bytes.data(), picture.bytes.size(), 0);
    model_.images.push_back(std::move(image));
    tinygltf::Texture texture;
    texture.sampler = 0;
    texture.source = static_cast<int>(model_.images.size() - 1);
    model_.textures.push_back(texture);
    return static_cast<int>(model_.textures.size() - 1);
  }

  std::size_t size() const { return model_.buffers[0].data.size(); }

  Bytes write() const {
    std::ostringstream stream(std::ios::binary);
    tinygltf::TinyGLTF gltf;
    if (!gltf.WriteGltfSceneToStream(&model_, stream, false, true)) return {};
    const std::string text = std::move(stream).str();
    return Bytes(text.begin(), text.end());
  }

 private:
  /// Appends bytes to the buffer, aligned to 4 as glTF asks of every accessor here.
  int view(const void* bytes, std::size_t size, int target) {
    std::vector<unsigned char>& data = model_.buffers[0].data;
    data.resize((data.size() + 3) / 4 * 4);
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = data.size();
    view.byteLength = size;
    view.target = target;
    const auto* first = static_cast<const unsigned char*>(bytes);
    data.insert(data.end(), first, first + size);
    model_.bufferViews.push_back(std::move(view));
    return static_cast<int>(model_.bufferViews.size() - 1);
  }

  int accessor(int bufferView, int component, int type, std::size_t count) {
    tinygltf::Accessor accessor;
    accessor.bufferView = bufferView;
    accessor.componentType = component;
    accessor.type = type;
    accessor.count = count;
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size() - 1);
  }

  template <class T>
  int attribute(const std::vector<T>& values, int type) {
    static_assert(sizeof(T) % 4 == 0);
    const int bytes = view(values.data(), values.size() * sizeof(T), TINYGLTF_TARGET_ARRAY_BUFFER);
    return accessor(bytes, TINYGLTF_COMPONENT_TYPE_FLOAT, type, values.size());
  }

  int positions(const std::vector<std::array<float, 3>>& values) {
    const int index = attribute(values, TINYGLTF_TYPE_VEC3);
    tinygltf::Accessor& accessor = model_.accessors[static_cast<std::size_t>(index)];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax_element(values.begin(), values.end(),
                                                   [&](const auto& a, const auto& b) { return a[axis] < b[axis]; });
      accessor.minValues.push_back(static_cast<double>((*low)[axis]));
      accessor.maxValues.push_back(static_cast<double>((*high)[axis]));
    }
    return index;
  }

  int indices(const mesh::ShadedMesh& shaded) {
    const std::size_t count = shaded.triangles.size() * 3;
    // 65535 restarts a primitive, so that many vertices still fit.
    if (shaded.positions.size() > 65535) {
      const int bytes =
          view(shaded.triangles.data(), count * sizeof(std::uint32_t), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
      return accessor(bytes, TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT, TINYGLTF_TYPE_SCALAR, count);
    }
    std::vector<std::uint16_t> small;
    small.reserve(count);
    for (const auto& t : shaded.triangles) {
      for (const std::uint32_t v : t) small.push_back(static_cast<std::uint16_t>(v));
    }
    const int bytes = view(small.data(), count * sizeof(std::uint16_t), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    return accessor(bytes, TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT, TINYGLTF_TYPE_SCALAR, count);
  }

  int material(const ExportPart& part, const std::string& name, int texture) {
    tinygltf::Material material;
    material.name = name;
    material.pbrMetallicRoughness.metallicFactor = part.metallic;
    material.pbrMetallicRoughness.roughnessFactor = part.roughness;
    if (texture >= 0) {
      material.pbrMetallicRoughness.baseColorTexture.index = texture;
    } else {
      material.pbrMetallicRoughness.baseColorFactor = {linear(part.colour[0]), linear(part.colour[1]),
                                                       linear(part.colour[2]), 1};
    }
    model_.materials.push_back(std::move(material));
    return static_cast<int>(model_.materials.size() - 1);
  }

  tinygltf::Model model_;
};

Result<Bytes> write(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures,
                    const GlbOptions& options) {
  Writer writer;
  std::vector<int> textures(pictures.size(), -1);
  for (const ExportPart& part : parts) {
    int texture = -1;
    if (part.picture) {
      const ExportPicture& picture = pictures[*part.picture];
      const std::string mime = mimeOf(picture.bytes);
      if (mime.empty()) return {Error::PictureUnreadable, cleanName(picture.name)};
      int& known = textures[*part.picture];
      if (known < 0) known = writer.addPicture(picture, mime);
      texture = known;
    }
    writer.addPart(part, texture, options);
  }
  constexpr std::size_t kLargest = std::numeric_limits<std::uint32_t>::max() - (1u << 24);
  if (writer.size() > kLargest) return {Error::OutOfMemory, "GLB over 4 GiB"};
  Bytes bytes = writer.write();
  if (bytes.empty()) return Error::OutOfMemory;
  return bytes;
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
