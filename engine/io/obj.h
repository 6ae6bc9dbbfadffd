// Wavefront OBJ: text that every 3D program reads.
#pragma once

#include <span>
#include <string>

#include "engine/base/result.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

/// The axes of the file.
enum class ObjSpace {
  World,  ///< y up, z to the viewer, right-handed
  Image,  ///< y down, z to the viewer: with placement {} and a mesh in ModelSpace, x and y are
          ///< picture pixels. Left-handed, so the corners of each triangle run the other way round,
          ///< which keeps the signed volume positive.
};

/// One object a part (`o`), vertices shared as in the mesh, texture coordinates (v up, as OBJ has
/// it) where the mesh has them. No materials: a part's picture and colour are not written. Numbers
/// in plain decimals, the fewest digits that give back the same float; lines end in \n. Errors:
/// those of checkParts (pictures are not looked at), OutOfMemory.
Result<Bytes> writeObj(std::span<const ExportPart> parts, ObjSpace space = ObjSpace::World);

/// An archive of NAME.obj (ObjSpace::World), NAME.mtl with one material a part, and the pictures as
/// NAME.png or NAME.jpg. `name` in characters that file names and OBJ's lines may have: no spaces.
/// Errors: those of checkParts, PictureUnreadable, OutOfMemory.
Result<Bytes> writeObjZip(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures,
                          const std::string& name);

}  // namespace spineloft::io
