#include "engine/publish/publish.h"

#include <algorithm>
#include <deque>
#include <new>
#include <span>
#include <utility>

#include "engine/io/gltf.h"
#include "engine/io/obj.h"
#include "engine/io/picture_file.h"
#include "engine/io/project_file.h"
#include "engine/io/stl.h"
#include "engine/io/three_mf.h"
#include "engine/printing/stand.h"
#include "engine/publish/texture_assignment.h"

namespace spineloft::publish {
namespace {

/// Quality of a texture's JPEG: what it costs is far below what a part differs from its picture anyway, at a third
/// of the size of a PNG. (At 92 it was a sixth, and cost textures that differ hardly 2 to 25 dB.)
constexpr int kTextureQuality = 98;

struct Model {
  const document::Document& document;
  const pipeline::Derived& derived;
};

/// Where the world's `base` goes to the file's origin, and file units per world unit.
struct Export {
  WorldPoint base;
  double scale = 1;
};

/// Standing on the ground, centred, and as tall as the document says.
Export standing(const WorldBounds& bounds, double height) {
  const WorldPoint base{(bounds.low.x + bounds.high.x) / 2, bounds.low.y, (bounds.low.z + bounds.high.z) / 2};
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

/// Parts as the writers want them, and what they point to.
struct ExportBatch {
  std::vector<io::ExportPart> parts;
  std::deque<mesh::TriMesh> turned;  ///< meshes of parts that are turned; where they are, they stay
  TextureAssignment textures;
  Bytes atlas;  ///< encoded
  std::vector<io::ExportPicture> pictures;
};

/// Whether a format shows pictures at all.
bool showsPictures(Format format) { return format != Format::Obj && format != Format::Stl; }

/// Encoded from pixels, so that nothing of the original files (place, camera) goes along.
Status encodeAtlas(ExportBatch& batch, Format format) {
  if (!batch.textures.atlas) return Done{};
  Result<Bytes> bytes = format == Format::ObjZip ? io::encodePng(*batch.textures.atlas)
                                                 : io::encodeJpeg(*batch.textures.atlas, kTextureQuality);
  if (!bytes) return bytes.failure();
  batch.atlas = std::move(bytes).value();
  batch.pictures.push_back({"texture", batch.atlas});
  return Done{};
}

/// The faces of a solid, one export part for each part of the document that they come from; all at once
/// where the format knows no colours.
void gatherSolid(const Model& model, const document::Step& step, const Export& target, Format format,
                 ExportBatch& batch, std::vector<UntexturedPart>& untextured) {
  const pipeline::DerivedStep* shown = shownSolid(model.document, model.derived, step);
  if (shown == nullptr) return;
  io::ExportPart out;
  out.name = step.name;
  out.placement = {{target.base.x, target.base.y, target.base.z}, target.scale};
  out.ofSolid = true;  // closed; but the solver may leave triangles that are thinner than ours
  if (!showsPictures(format)) {
    batch.parts.push_back(out);
    untextured.push_back({&step.look, &shown->solid->mesh, nullptr, nullptr});
    return;
  }
  for (const pipeline::SolidPiece& piece : shown->solid->pieces) {
    const document::Part* part = document::findPart(model.document, piece.part);
    const auto at = std::ranges::find(model.derived.parts, piece.part, &pipeline::DerivedPart::id);
    const document::Look& look = part == nullptr || step.ownLook ? step.look : part->look;
    batch.parts.push_back(out);
    untextured.push_back({&look, &piece.mesh, at == model.derived.parts.end() ? nullptr : at->shape.get(), nullptr});
    out.joins = true;
  }
}

/// What is written of a part that shows itself; with UV where the format shows pictures.
const mesh::TriMesh& meshOf(const pipeline::DerivedPart& part, Format format) {
  if (!part.mended) return part.shape->mesh;
  if (!showsPictures(format)) return part.mended->mesh;
  // All of its faces are of this part.
  return part.mended->pieces.size() == 1 ? part.mended->pieces.front().mesh : part.shape->mesh;
}

Status gather(const Model& model, const Export& target, Format format, ExportBatch& batch) {
  std::vector<UntexturedPart> untextured;
  for (const pipeline::DerivedPart& shown : model.derived.parts) {
    const document::Part* part = document::findPart(model.document, shown.id);
    if (part == nullptr || !showsItself(model.document, model.derived, *part) || !shown.shape) continue;
    const document::PictureEntry* entry = document::findPicture(model.document, document::pictureOf(*part));
    if (entry == nullptr) continue;
    bool first = true;
    const mesh::TriMesh& mesh = meshOf(shown, format);
    for (const pipeline::ToWorld& toWorld : pipeline::copiesInWorld(*part, entry->size)) {
      const bool turned = !toWorld.isStraight();
      if (turned) batch.turned.push_back(turnedMesh(mesh, toWorld));
      io::ExportPart out;
      out.name = first ? part->name : part->name + " mirrored";
      out.placement = placementOf(toWorld, turned, target);
      out.ofSolid = &mesh != &shown.shape->mesh;
      batch.parts.push_back(std::move(out));
      untextured.push_back({&part->look, turned ? &batch.turned.back() : &mesh, shown.shape.get(), nullptr, &mesh});
      first = false;
    }
  }
  for (const document::Step& step : model.document.steps) {
    gatherSolid(model, step, target, format, batch, untextured);
  }
  for (std::size_t i = 0; i < untextured.size(); ++i) untextured[i].part = &batch.parts[i];
  batch.textures = assignTextures(untextured, showsPictures(format));
  return encodeAtlas(batch, format);
}

Result<Bytes> writeModel(const Model& model, Format format, const Progress& progress) {
  const std::optional<WorldBounds> bounds = worldBounds(model.document, model.derived);
  if (!bounds) return Error::NothingToExport;
  constexpr double kMetresPerMm = 1e-3;
  const bool isGlb = format == Format::Glb || format == Format::Project;
  const Export target = standing(*bounds, model.document.height.value * (isGlb ? kMetresPerMm : 1));
  ExportBatch batch;
  if (const Status status = gather(model, target, format, batch); !status) return status.failure();
  if (!progress.advance(0.4)) return Error::Cancelled;
  std::vector<io::ExportPart>& parts = batch.parts;
  switch (format) {
    case Format::Obj:
      return io::writeObj(parts);
    case Format::Stl:
      return io::writeStl(parts);
    case Format::ObjZip:
      return io::writeObjZip(parts, batch.pictures, plainName(model.document));
    case Format::ThreeMf:
      return io::write3mf(parts, batch.pictures);
    case Format::Project:
      // What cannot be shown must not keep the work from being saved.
      std::erase_if(parts,
                    [&](const io::ExportPart& part) { return !io::checkParts({&part, 1}, batch.pictures.size()); });
      break;
    case Format::Glb:
      break;
  }
  return io::writeGlb(parts, batch.pictures);
}

Result<Bytes> addProject(std::span<const std::uint8_t> glb, const document::Document& document,
                         const Progress& progress) {
  std::deque<Bytes> kept;
  std::vector<io::ProjectPhoto> photos;
  for (const document::PictureEntry& entry : document.pictures) {
    if (!progress.advance(0.5 +
                          0.4 * static_cast<double>(photos.size()) / static_cast<double>(document.pictures.size()))) {
      return Error::Cancelled;
    }
    const bool known =
        std::ranges::any_of(photos, [&](const io::ProjectPhoto& photo) { return photo.picture == entry.picture; });
    if (entry.isSketch() || known) continue;
    Result<Bytes> bytes = io::writePhoto(*entry.picture);
    if (!bytes) return bytes.failure();
    kept.push_back(std::move(bytes).value());
    photos.push_back({entry.picture, kept.back()});
  }
  return io::embedProject(glb, document, photos);
}

Result<Bytes> write(const Model& model, Format format, const Progress& progress, const Options& options) {
  const bool withProject = format == Format::Project || (format == Format::Glb && options.withProject);
  Result<Bytes> bytes = writeModel(model, format, progress);
  if (format == Format::Project && !bytes && bytes.error() == Error::NothingToExport) {
    bytes = Bytes{};
  }
  if (bytes && withProject) bytes = addProject(bytes.value(), model.document, progress);
  if (!progress.advance(1)) return Error::Cancelled;
  return bytes;
}

std::vector<mesh::TriMesh> millimetres(const Model& model) {
  std::vector<mesh::TriMesh> out;
  const std::optional<WorldBounds> bounds = worldBounds(model.document, model.derived);
  ExportBatch batch;
  if (!bounds || !gather(model, standing(*bounds, model.document.height.value), Format::Stl, batch)) return out;
  for (const io::ExportPart& part : batch.parts) {
    out.push_back(*part.mesh);
    for (auto& p : out.back().positions) {
      const std::array<double, 3> at = io::placed(part.placement, p);
      p = {static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2])};
    }
  }
  return out;
}

}  // namespace

Result<printing::PrintCheck> checkPrint(const document::Document& document, const pipeline::Derived& derived) {
  try {
    const std::vector<mesh::TriMesh> parts = millimetres({document, derived});
    if (parts.empty()) return Error::NothingToExport;
    return printing::checkPrint(parts);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<std::optional<double>> flatFoot(const document::Document& document, const pipeline::Derived& derived) {
  try {
    const std::vector<mesh::TriMesh> parts = millimetres({document, derived});
    if (parts.empty()) return Error::NothingToExport;
    return printing::flatFoot(parts);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<Bytes> publish(const document::Document& document, const pipeline::Derived& derived, Format format,
                      const Progress& progress, const Options& options) {
  try {
    return write({document, derived}, format, progress, options);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::publish
