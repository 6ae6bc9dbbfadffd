#include "engine/publish/publish.h"

#include <algorithm>
#include <deque>
#include <memory>
#include <new>
#include <span>
#include <utility>

#include "engine/io/gltf.h"
#include "engine/io/obj.h"
#include "engine/io/picture_file.h"
#include "engine/io/project_file.h"
#include "engine/io/stl.h"

namespace spineloft::publish {
namespace {

/// Quality of a texture's JPEG: no visible blocks, a fifth of the size of a PNG.
constexpr int kTextureQuality = 92;

bool isOpaque(const image::Image& image) {
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) {
    if (image.pixels[i] != 255) return false;
  }
  return true;
}

/// The working copy, encoded anew, so that nothing of the original file (place, camera) goes along.
Result<Bytes> encodeTexture(const image::Picture& picture) {
  return isOpaque(picture.working) ? io::encodeJpeg(picture.working, kTextureQuality)
                                   : io::encodePng(picture.working);
}

/// Where the world's `base` goes to the file's origin, and file units per world unit.
struct Export {
  WorldPoint base;
  double scale = 1;
};

/// Standing on the ground, centred, and as tall as the document says.
Export standing(const WorldBounds& bounds, double height) {
  const WorldPoint base{(bounds.low.x + bounds.high.x) / 2, bounds.low.y,
                        (bounds.low.z + bounds.high.z) / 2};
  return {base, height / (bounds.high.y - bounds.low.y)};
}

/// For a mesh in ModelSpace, or one that is turned about the origin of `toWorld` already.
io::Placement placementOf(const pipeline::ToWorld& toWorld, bool isTurned, const Export& target) {
  const ModelPoint origin = isTurned ? ModelPoint{} : toWorld.origin;
  const WorldPoint from = (target.base - toWorld.shift) / toWorld.scale;
  return {{origin.x + from.x, origin.y + from.y, origin.z + from.z}, toWorld.scale * target.scale};
}

/// Turned and mirrored as in the world, still as large as in ModelSpace: floats keep their precision.
mesh::TriMesh turnedMesh(const mesh::TriMesh& mesh, pipeline::ToWorld toWorld) {
  for (double& m : toWorld.linear) m /= toWorld.scale;
  toWorld.shift = {};
  return pipeline::worldMesh(mesh, toWorld);
}

/// Every picture of the document that the file needs, encoded once; photos without loss when the
/// project goes along, so that the same bytes serve as texture and as photo.
class Encoded {
 public:
  explicit Encoded(bool lossless) : lossless_(lossless) {}

  Result<std::span<const std::uint8_t>> of(const document::PictureEntry& entry,
                                           const image::Picture& picture) {
    for (const Item& item : items_) {
      if (item.contentHash == entry.contentHash) return std::span<const std::uint8_t>(*item.bytes);
    }
    Result<Bytes> bytes =
        lossless_ && !entry.isSketch() ? io::writePhoto(picture) : encodeTexture(picture);
    if (!bytes) return bytes.failure();
    items_.push_back({entry.contentHash, std::make_unique<Bytes>(std::move(bytes).value())});
    return std::span<const std::uint8_t>(*items_.back().bytes);
  }

 private:
  struct Item {
    std::uint64_t contentHash;
    std::unique_ptr<Bytes> bytes;  ///< stays where it is: spans point to it
  };
  bool lossless_;
  std::vector<Item> items_;
};

/// Parts and encoded pictures as the writers want them.
struct Shelf {
  std::vector<io::ExportPart> parts;
  std::vector<io::ExportPicture> pictures;
  std::vector<PictureId> ids;
  std::deque<mesh::TriMesh> turned;  ///< meshes of parts that are turned; where they are, they stay
};

/// Index of the picture on the shelf.
Result<std::size_t> shelve(Shelf& shelf, Encoded& encoded, const document::PictureEntry& entry,
                           const image::Picture& picture) {
  const auto known = std::ranges::find(shelf.ids, entry.id);
  if (known != shelf.ids.end()) return static_cast<std::size_t>(known - shelf.ids.begin());
  const Result<std::span<const std::uint8_t>> bytes = encoded.of(entry, picture);
  if (!bytes) return bytes.failure();
  shelf.ids.push_back(entry.id);
  shelf.pictures.push_back({entry.name, bytes.value()});
  return shelf.ids.size() - 1;
}

/// Takes the parts' pictures from `encoded`; parts have no pictures without it.
Result<Shelf> gather(const document::Document& document, const pipeline::Derived& derived,
                     const Export& target, Encoded* encoded, const Progress& progress) {
  Shelf shelf;
  for (const pipeline::DerivedPart& shown : derived.parts) {
    if (!progress.advance(0.5 * static_cast<double>(shelf.parts.size()) /
                          static_cast<double>(derived.parts.size()))) {
      return Error::Cancelled;
    }
    const document::Part* part = document::findPart(document, shown.id);
    if (part == nullptr || !part->visible || !shown.shape) continue;
    const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
    if (entry == nullptr) continue;
    io::ExportPart out;
    for (std::size_t c = 0; c < 3; ++c) {
      out.colour[c] = static_cast<float>(part->look.colour[c]) / 255.0f;
    }
    const image::Picture* pixels = pipeline::pixelsOf(document, derived, entry->id);
    if (encoded != nullptr && part->look.textured && pixels != nullptr) {
      const Result<std::size_t> index = shelve(shelf, *encoded, *entry, *pixels);
      if (!index) return index.failure();
      out.picture = index.value();
    }
    for (const pipeline::ToWorld& toWorld : pipeline::copiesInWorld(*part, entry->size)) {
      const bool turned = !toWorld.isStraight();
      if (turned) shelf.turned.push_back(turnedMesh(shown.shape->mesh, toWorld));
      out.name = out.mesh == nullptr ? part->name : part->name + " mirrored";
      out.mesh = turned ? &shelf.turned.back() : &shown.shape->mesh;
      out.placement = placementOf(toWorld, turned, target);
      shelf.parts.push_back(out);
    }
  }
  return shelf;
}

Result<Bytes> writeModel(const document::Document& document, const pipeline::Derived& derived,
                         Format format, Encoded& encoded, const Progress& progress) {
  const std::optional<WorldBounds> bounds = worldBounds(document, derived);
  if (!bounds) return Error::NothingToExport;
  constexpr double kMetresPerMm = 1e-3;
  const bool isGlb = format == Format::Glb || format == Format::Project;
  Export target;
  if (isGlb) target = standing(*bounds, document.height.value * kMetresPerMm);
  if (format == Format::Stl) target = standing(*bounds, document.height.value);
  Result<Shelf> shelf = gather(document, derived, target, isGlb ? &encoded : nullptr, progress);
  if (!shelf) return shelf.failure();
  std::vector<io::ExportPart>& parts = shelf.value().parts;
  const std::span<const io::ExportPicture> pictures = shelf.value().pictures;
  if (format == Format::Obj) return io::writeObj(parts);
  if (format == Format::Stl) return io::writeStl(parts);
  if (format == Format::Project) {
    // What cannot be shown must not keep the work from being saved.
    std::erase_if(parts, [&](const io::ExportPart& part) {
      return !io::checkParts({&part, 1}, pictures.size());
    });
  }
  return io::writeGlb(parts, pictures);
}

Result<Bytes> addProject(std::span<const std::uint8_t> glb, const document::Document& document,
                         Encoded& encoded, const Progress& progress) {
  std::vector<io::ProjectPhoto> photos;
  for (const document::PictureEntry& entry : document.pictures) {
    if (!progress.advance(0.5 + 0.4 * static_cast<double>(photos.size()) /
                                    static_cast<double>(document.pictures.size()))) {
      return Error::Cancelled;
    }
    if (entry.isSketch()) continue;
    const Result<std::span<const std::uint8_t>> bytes = encoded.of(entry, *entry.picture);
    if (!bytes) return bytes.failure();
    photos.push_back({entry.picture, bytes.value()});
  }
  return io::embedProject(glb, document, photos);
}

Result<Bytes> write(const document::Document& document, const pipeline::Derived& derived,
                    Format format, const Progress& progress, const Options& options) {
  const bool withProject =
      format == Format::Project || (format == Format::Glb && options.withProject);
  Encoded encoded(withProject);
  Result<Bytes> bytes = writeModel(document, derived, format, encoded, progress);
  if (format == Format::Project && !bytes && bytes.error() == Error::NothingToExport) {
    bytes = Bytes{};
  }
  if (bytes && withProject) bytes = addProject(bytes.value(), document, encoded, progress);
  if (!progress.advance(1)) return Error::Cancelled;
  return bytes;
}

}  // namespace

Result<Bytes> publish(const document::Document& document, const pipeline::Derived& derived,
                      Format format, const Progress& progress, const Options& options) {
  try {
    return write(document, derived, format, progress, options);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::publish
