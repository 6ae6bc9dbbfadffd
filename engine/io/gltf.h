// GLB, the binary form of glTF 2.0 (Khronos).
#pragma once

#include <span>

#include "engine/base/result.h"
#include "engine/io/export_part.h"
#include "engine/mesh/shading.h"

namespace spineloft::io {

struct GlbOptions {
  /// Edges sharper than this stay sharp, radians 0…π; all of them on a part that is faceted.
  double creaseAngle = mesh::kCreaseAngle;
  bool operator==(const GlbOptions&) const = default;
};

/// One node, mesh and material a part, in metres (placements scale to metres), y up, front +z; one
/// scene. Normals always; texture coordinates and the picture as base colour where a part has one;
/// every picture that a part uses is stored once, as the bytes given. Seen from outside only. Equal input gives equal
/// bytes. Passes the Khronos validator without errors or warnings. Errors: those of checkParts, PictureUnreadable (a
/// used picture is neither PNG nor JPEG), ValueOutOfRange (options), OutOfMemory (over 4 GiB, which GLB cannot hold, or
/// no memory).
Result<Bytes> writeGlb(std::span<const ExportPart> parts, std::span<const ExportPicture> pictures,
                       const GlbOptions& options = {});

}  // namespace spineloft::io
