// The materials of a model in a file: one texture for all parts, or plain materials.
#pragma once

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "engine/document/document.h"
#include "engine/image/image.h"
#include "engine/io/export_part.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/pipeline/part_shape.h"
#include "engine/surface/part_texture.h"

namespace spineloft::publish {

/// A visible part on its way into a file. Pointers must outlive the dressing.
struct UntexturedPart {
  const document::Look* look = nullptr;
  const mesh::TriMesh* mesh = nullptr;  ///< to be written
  const pipeline::PartShape* shape =
      nullptr;  ///< of which `mesh` is a copy, turned or not; of faces of a solid their part; or null
  io::ExportPart* part = nullptr;          ///< gets material, mesh and picture
  const mesh::TriMesh* upright = nullptr;  ///< of a part, what `mesh` was before it was turned
};

/// Meshes and pixels that the textured parts point to; must outlive them.
struct TextureAssignment {
  std::deque<mesh::TriMesh> meshes;
  std::deque<image::Image> tiles;
  std::optional<image::Image> atlas;  ///< picture 0 of the parts that have one; none: none has
};

/// Gives every part its material. With `pictures`, parts that show the picture or two colours get UV in
/// one atlas (at most surface::kAtlasSide a side) that holds what they use and nothing else, and
/// ExportPart::picture 0; without, or where there is no picture, they are plain.
TextureAssignment assignTextures(std::span<const UntexturedPart> parts, bool pictures);

}  // namespace spineloft::publish
