#include "engine/publish/publish.h"

#include <new>

#include "engine/io/gltf.h"
#include "engine/io/obj.h"
#include "engine/io/picture_file.h"
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

io::Placement placementOf(image::Size picture, const Export& target) {
  const WorldFrame frame = worldFrame(picture);
  return {{frame.centre.x + target.base.x / frame.scale, frame.centre.y + target.base.y / frame.scale,
           frame.centre.z + target.base.z / frame.scale},
          frame.scale * target.scale};
}

/// Parts and encoded pictures as the writers want them.
struct Shelf {
  std::vector<io::ExportPart> parts;
  std::vector<io::ExportPicture> pictures;
  std::vector<Bytes> encoded;  ///< reserved up front: `pictures` point into it
  std::vector<PictureId> ids;
};

Result<std::size_t> shelve(Shelf& shelf, const document::PictureEntry& entry,
                           const image::Picture& picture) {
  for (std::size_t i = 0; i < shelf.ids.size(); ++i) {
    if (shelf.ids[i] == entry.id) return i;
  }
  Result<Bytes> bytes = encodeTexture(picture);
  if (!bytes) return bytes.failure();
  shelf.encoded.push_back(std::move(bytes).value());
  shelf.ids.push_back(entry.id);
  shelf.pictures.push_back({entry.name, shelf.encoded.back()});
  return shelf.ids.size() - 1;
}

Result<Shelf> gather(const document::Document& document, const pipeline::Derived& derived,
                     const Export& target, bool withPictures, const Progress& progress) {
  Shelf shelf;
  shelf.encoded.reserve(document.pictures.size());
  for (const pipeline::DerivedPart& shown : derived.parts) {
    if (!progress.advance(0.8 * static_cast<double>(shelf.parts.size()) /
                          static_cast<double>(derived.parts.size()))) {
      return Error::Cancelled;
    }
    const document::Part* part = document::findPart(document, shown.id);
    if (part == nullptr || !part->visible || !shown.shape) continue;
    const document::PictureEntry* entry = document::findPicture(document, part->recipe.picture);
    if (entry == nullptr) continue;
    io::ExportPart out;
    out.name = part->name;
    out.mesh = &shown.shape->mesh;
    out.placement = placementOf(entry->size, target);
    for (std::size_t c = 0; c < 3; ++c) {
      out.colour[c] = static_cast<float>(part->look.colour[c]) / 255.0f;
    }
    const image::Picture* pixels = pipeline::pixelsOf(document, derived, entry->id);
    if (withPictures && part->look.textured && pixels != nullptr) {
      const Result<std::size_t> index = shelve(shelf, *entry, *pixels);
      if (!index) return index.failure();
      out.picture = index.value();
    }
    shelf.parts.push_back(std::move(out));
  }
  return shelf;
}

Result<Bytes> write(const document::Document& document, const pipeline::Derived& derived,
                    Format format, const Progress& progress) {
  const std::optional<WorldBounds> bounds = worldBounds(document, derived);
  if (!bounds) return Error::NothingToExport;
  constexpr double kMetresPerMm = 1e-3;
  Export target;
  if (format == Format::Glb) target = standing(*bounds, document.height.value * kMetresPerMm);
  if (format == Format::Stl) target = standing(*bounds, document.height.value);
  const Result<Shelf> shelf =
      gather(document, derived, target, format == Format::Glb, progress);
  if (!shelf) return shelf.failure();
  const std::span<const io::ExportPart> parts = shelf.value().parts;
  Result<Bytes> bytes = format == Format::Glb   ? io::writeGlb(parts, shelf.value().pictures)
                        : format == Format::Stl ? io::writeStl(parts)
                                                : io::writeObj(parts);
  if (!progress.advance(1)) return Error::Cancelled;
  return bytes;
}

}  // namespace

Result<Bytes> publish(const document::Document& document, const pipeline::Derived& derived,
                      Format format, const Progress& progress) {
  try {
    return write(document, derived, format, progress);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::publish
