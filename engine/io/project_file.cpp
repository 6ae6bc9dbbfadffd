#include "engine/io/project_file.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <new>
#include <vector>

#include "engine/base/limits.h"
#include "engine/io/document_json.h"
#include "engine/io/glb_container.h"
#include "engine/io/picture_file.h"
#include "engine/io/png_model.h"

namespace spineloft::io {
namespace {

using document::Document;
using document::PictureEntry;

constexpr const char* kExtension = "SPINELOFT_project";
/// The same as it stands in the JSON chunk.
constexpr std::string_view kQuoted = "\"SPINELOFT_project\"";
/// Most pixels of all photos of a file together, so that a small file cannot claim all memory.
constexpr long long kMostPixels = 100 * kWorkingPixels;

// ---- writing ------------------------------------------------------------------------------------

/// What a GLB without anything to see begins with.
Json emptyScene() {
  return {{"asset", {{"version", "2.0"}, {"generator", "SpineLoft"}}},
          {"scene", 0},
          {"scenes", Json::array({Json::object()})}};
}

/// A GLB that grows.
struct Growing {
  Json root;
  Bytes binary;

  /// The view of an image with these very bytes, else a new view.
  std::size_t viewOf(std::span<const std::uint8_t> bytes) {
    for (const Json& image : root.value("images", Json::array())) {
      const std::size_t index = image.value("bufferView", std::size_t{0});
      const Json& view = root["bufferViews"][index];
      const std::size_t from = view.value("byteOffset", std::size_t{0});
      if (view.value("byteLength", std::size_t{0}) == bytes.size() &&
          std::equal(bytes.begin(), bytes.end(), binary.begin() + static_cast<std::ptrdiff_t>(from))) {
        return index;
      }
    }
    binary.resize((binary.size() + 3) / 4 * 4);
    root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", binary.size()}, {"byteLength", bytes.size()}});
    binary.insert(binary.end(), bytes.begin(), bytes.end());
    return root["bufferViews"].size() - 1;
  }
};

Result<Json> listPhotos(const Document& document, std::span<const ProjectPhoto> photos, Growing& glb) {
  Json list = Json::array();
  std::vector<std::uint64_t> listed;
  for (const PictureEntry& entry : document.pictures) {
    if (entry.isSketch() || std::ranges::count(listed, entry.contentHash) > 0) continue;
    const auto at = std::ranges::find(photos, entry.picture, &ProjectPhoto::picture);
    if (at == photos.end()) return {Error::NoSuchPicture, entry.name};
    listed.push_back(entry.contentHash);
    list.push_back(
        {{"hash", hashKey(entry.contentHash)}, {"size", toJson(entry.size)}, {"bufferView", glb.viewOf(at->bytes)}});
  }
  return list;
}

Result<Bytes> embed(std::span<const std::uint8_t> glb, const Document& document, std::span<const ProjectPhoto> photos) {
  Growing growing{emptyScene(), {}};
  if (!glb.empty()) {
    const std::optional<GlbChunks> chunks = readGlbChunks(glb);
    if (!chunks) return {Error::ProjectInvalid, "no GLB"};
    growing.root = Json::parse(chunks->json, nullptr, false);
    if (!growing.root.is_object()) return {Error::ProjectInvalid, "no GLB"};
    growing.binary.assign(chunks->binary.begin(), chunks->binary.end());
  }
  Result<Json> list = listPhotos(document, photos, growing);
  if (!list) return list.failure();
  Json& root = growing.root;
  root["extensionsUsed"].push_back(kExtension);
  root["extensions"][kExtension] = {
      {"version", kProjectVersion}, {"document", documentJson(document)}, {"photos", std::move(list).value()}};
  if (!growing.binary.empty()) {
    if (!root.contains("buffers")) root["buffers"] = Json::array({Json::object()});
    root["buffers"][0]["byteLength"] = growing.binary.size();
  }
  return writeGlbChunks({textOf(root), growing.binary});
}

// ---- reading ------------------------------------------------------------------------------------

const Json* memberOf(const Json* json, const char* key) {
  if (json == nullptr || !json->is_object()) return nullptr;
  const auto at = json->find(key);
  return at == json->end() ? nullptr : &*at;
}

bool getSize(const Json* from, std::size_t& to) {
  double value = 0;
  if (from == nullptr || !get(*from, value) || value != std::trunc(value) || value < 0 ||
      value > std::numeric_limits<std::uint32_t>::max()) {
    return false;
  }
  to = static_cast<std::size_t>(value);
  return true;
}

/// The bytes of a buffer view; empty when it does not lie in the binary chunk.
std::span<const std::uint8_t> bytesOfView(const Json& root, const Json* index, std::span<const std::uint8_t> binary) {
  const Json* views = memberOf(&root, "bufferViews");
  std::size_t place = 0, from = 0, length = 0, buffer = 0;
  if (views == nullptr || !views->is_array() || !getSize(index, place) || place >= views->size()) {
    return {};
  }
  const Json* view = &(*views)[place];
  const Json* offset = memberOf(view, "byteOffset");
  if (!getSize(memberOf(view, "buffer"), buffer) || buffer != 0 || !getSize(memberOf(view, "byteLength"), length) ||
      (offset && !getSize(offset, from)) || from > binary.size() || length > binary.size() - from) {
    return {};
  }
  return binary.subspan(from, length);
}

/// The photos of a file, decoded when they are asked for.
class Photos {
 public:
  Photos(const Json& root, const Json* list, std::span<const std::uint8_t> binary) {
    if (list == nullptr || !list->is_array()) return;
    for (const Json& photo : *list) {
      const Json* key = memberOf(&photo, "hash");
      const auto hash =
          key != nullptr && key->is_string() ? hashFromKey(key->get_ref<const std::string&>()) : std::nullopt;
      if (!hash || slots_.size() >= document::kMostPictures) continue;
      Slot slot{*hash, bytesOfView(root, memberOf(&photo, "bufferView"), binary), {}, {}, false};
      if (const Json* size = memberOf(&photo, "size")) get(*size, slot.original);
      slots_.push_back(std::move(slot));
    }
  }

  std::shared_ptr<const image::Picture> find(std::uint64_t hash) {
    const auto slot = std::ranges::find(slots_, hash, &Slot::hash);
    if (slot == slots_.end()) return nullptr;
    if (!slot->tried) decode(*slot);
    slot->tried = true;
    return slot->picture;
  }
  bool outOfMemory() const { return outOfMemory_; }

 private:
  struct Slot {
    std::uint64_t hash = 0;
    std::span<const std::uint8_t> bytes;
    image::Size original;
    std::shared_ptr<const image::Picture> picture;
    bool tried = false;
  };

  void decode(Slot& slot) {
    Result<image::Image> pixels = decodeImage(slot.bytes, std::min(kWorkingPixels, left_));
    if (!pixels) {
      outOfMemory_ |= pixels.error() == Error::OutOfMemory;
      return;
    }
    image::Picture picture;
    picture.working = std::move(pixels).value();
    const auto [width, height] = image::Size{picture.working.width, picture.working.height};
    left_ -= static_cast<long long>(width) * height;
    const auto [originalWidth, originalHeight] = slot.original;
    const bool believable = originalWidth >= width && originalHeight >= height &&
                            std::max(originalWidth, originalHeight) <= kMaxPictureSide &&
                            static_cast<long long>(originalWidth) * originalHeight <= kMaxPicturePixels;
    picture.width = believable ? originalWidth : width;
    picture.height = believable ? originalHeight : height;
    slot.picture = std::make_shared<const image::Picture>(std::move(picture));
  }

  std::vector<Slot> slots_;
  long long left_ = kMostPixels;
  bool outOfMemory_ = false;
};

/// Photos whose pixels are not the ones that the file named are told apart from those by their hash.
void nameByContent(Document& document, ReadNotes& notes) {
  for (Box<PictureEntry>& box : document.pictures) {
    if (box->isSketch()) continue;
    const std::uint64_t hash = document::contentHash(*box->picture);
    if (hash == box->contentHash) continue;
    PictureEntry entry = box;
    entry.contentHash = hash;
    box = std::move(entry);
    ++notes.repaired;
  }
}

Result<Document> read(const GlbChunks& chunks, ReadNotes& notes) {
  Result<Json> parsed = parseJson(chunks.json);
  if (!parsed) return parsed.failure();
  const Json& root = parsed.value();
  const Json* project = memberOf(memberOf(&root, "extensions"), kExtension);
  if (project == nullptr) return Error::NoProjectInside;
  const Json* stated = memberOf(project, "version");
  int version = 0;
  if (stated == nullptr || !get(*stated, version) || version < 1) {
    return {Error::ProjectInvalid, "no version"};
  }
  if (version > kProjectVersion) return Error::ProjectTooNew;
  Photos photos(root, memberOf(project, "photos"), chunks.binary);
  const PictureSource source = [&](std::uint64_t hash) { return photos.find(hash); };
  const Json* json = memberOf(project, "document");
  if (json == nullptr) return {Error::ProjectInvalid, "no document"};
  Json copy = *json;
  const Json* pictures = memberOf(&copy, "pictures");
  const bool hadPictures = pictures != nullptr && !pictures->empty();
  Result<Document> document = documentFrom(std::move(copy), {notes, source}, MissingPhoto::Drop);
  if (!document) return document;
  if (photos.outOfMemory()) return Error::OutOfMemory;
  if (hadPictures && document.value().pictures.empty()) return Error::PictureUnreadable;
  nameByContent(document.value(), notes);
  makeRoomForIds(document.value(), notes);
  return document;
}

}  // namespace

Result<Bytes> writePhoto(const image::Picture& picture) { return encodePng(picture.working); }

Result<Bytes> embedProject(std::span<const std::uint8_t> glb, const Document& document,
                           std::span<const ProjectPhoto> photos) {
  try {
    return embed(glb, document, photos);
  } catch (const std::exception&) {  // the JSON library and the standard one only throw for memory
    return Error::OutOfMemory;
  }
}

bool holdsProject(std::span<const std::uint8_t> glb) { return jsonOfGlb(glb).find(kQuoted) != std::string_view::npos; }

Result<Document> readProject(std::span<const std::uint8_t> file, ReadNotes* notes) {
  std::span<const std::uint8_t> glb = file;
  if (isPng(file)) {
    const auto inside = modelInPng(file);
    if (!inside) return inside.failure();
    glb = inside.value();
    if (!holdsProject(glb)) return {Error::ProjectInvalid, "in a picture"};
  }
  // A file that ends early may end before it says whose it is.
  if (isCutOff(glb)) return {Error::ProjectInvalid, "cut off"};
  if (!holdsProject(glb)) return Error::NoProjectInside;
  const std::optional<GlbChunks> chunks = readGlbChunks(glb);
  if (!chunks) return {Error::ProjectInvalid, "cut off"};
  ReadNotes found;
  try {
    Result<Document> document = read(*chunks, found);
    if (notes != nullptr) *notes = found;
    return document;
  } catch (const std::exception&) {  // the JSON library and the standard one only throw for memory
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
